//! Reads that found the queue of their memory channel full.
//!
//! Nothing can happen to such a read before its channel has issued another one: its line is in no cache and not under way.
//! So it tries again when there is room, and not in every cycle, which would take most of the simulation's time.

use crate::dram::Dram;
use crate::request::Request;

/// Reads that wait for room, by channel, in the order in which they came.
#[derive(Clone, Debug)]
pub struct Blocked {
    channels: Vec<Vec<Read>>,
    number: usize,
}

#[derive(Clone, Copy, Debug)]
struct Read {
    line: u32,
    request: Request,
}

impl Blocked {
    pub fn new(channels: u32) -> Self {
        Self { channels: vec![vec![]; channels as usize], number: 0 }
    }

    /// Whether no read waits.
    pub fn is_empty(&self) -> bool {
        self.number == 0
    }

    /// `request` waits for room to read `line` through `channel`.
    pub fn add(&mut self, channel: usize, line: u32, request: Request) {
        self.channels[channel].push(Read { line, request });
        self.number += 1;
    }

    /// Whether a channel has room for a read that waits for it.
    pub fn could_go_on(&self, dram: &Dram) -> bool {
        let mut waits = self.channels.iter().enumerate().filter(|(_, reads)| !reads.is_empty());
        self.number > 0 && waits.any(|(channel, _)| dram.room(channel) > 0)
    }

    /// Passes as many reads as there is room for to `wake`, those of the ports of least `place` first, and with each those of the
    /// same line, which need no room.
    pub fn wake(&mut self, dram: &Dram, place: impl Fn(u16) -> usize, mut wake: impl FnMut(Request)) {
        for (channel, reads) in self.channels.iter_mut().enumerate() {
            if reads.is_empty() {
                continue;
            }
            for _ in 0..dram.room(channel) {
                let Some(first) = reads.iter().min_by_key(|read| place(read.request.client.port)) else {
                    break;
                };
                let line = first.line;
                let before = reads.len();
                reads.retain(|read| {
                    if read.line == line {
                        wake(read.request);
                    }
                    read.line != line
                });
                self.number -= before - reads.len();
            }
        }
    }
}
