//! A thread: it goes from run to run, and waits for what is late.

use super::behind::{Behind, Cache};
use super::contention::Contention;
use super::items::Words;
use super::profile::{Access, LATER, Profile, Registers};
use crate::program::{Program, RunId};

/// What all threads need to go on.
pub struct Machine<'a> {
    pub program: &'a Program,
    pub profile: Profile,
    pub contention: Contention,
    pub behind: Behind,
}

/// What a thread executes next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// What comes before its first item.
    Start,
    /// An item.
    Item,
    /// What comes behind its last item.
    End,
    /// Nothing.
    Halted,
}

/// A thread.
#[derive(Clone, Debug)]
pub struct Thread {
    /// The cycle in which its run begins.
    pub time: f64,
    pub place: Place,
    tape: Words,
    /// Where in the tape its run stands.
    at: usize,
    /// The run before.
    before: Option<RunId>,
    /// Registers that a line brings for which it has not waited yet.
    late: Registers,
    /// The cycle in which the last of these lines arrives.
    arrives: u32,
}

/// The first operation of a run that waits for a line.
#[derive(Clone, Copy)]
struct Stall {
    /// Cycles from the start of the run, without any delay.
    at: u16,
    /// The cycle in which the line arrives.
    until: u32,
}

impl Stall {
    const NONE: Self = Self { at: LATER, until: 0 };

    /// Cycles for which the operation waits, in a run that begins in cycle `start` and is delayed already.
    #[inline(always)]
    fn cycles(self, start: u32, delay: u32) -> u32 {
        if self.at == LATER { 0 } else { self.until.saturating_sub(start + delay + u32::from(self.at)) }
    }

    /// The stall of an operation that waits for `self` and for `other`.
    fn with(self, other: Self) -> Self {
        Self { at: self.at.min(other.at), until: self.until.max(other.until) }
    }
}

impl Thread {
    /// A thread that executes `start` first.
    pub fn new(start: &Words) -> Self {
        Self {
            time: 0.0,
            place: Place::Start,
            tape: Words::clone(start),
            at: 0,
            before: None,
            late: 0,
            arrives: 0,
        }
    }

    /// Begins with another tape.
    pub fn resume(&mut self, place: Place, tape: Words) {
        (self.place, self.tape, self.at) = (place, tape, 0);
    }

    /// Goes on until a run ends in cycle `end` or later, or the tape does. Returns whether the tape has ended.
    #[inline]
    pub fn run(&mut self, machine: &mut Machine<'_>, l1: &mut Cache, l2: usize, end: f64) -> bool {
        while self.at < self.tape.len() {
            if self.time >= end {
                return false;
            }
            let run = self.tape[self.at];
            let profile = &machine.profile.runs[run as usize];
            let start = self.time + f64::from(machine.contention.waits[run as usize]);
            let first = start as u32;
            let mut delay = 0;
            let mut stall = Stall::NONE;
            if self.late != 0
                && let Some((_, at)) = profile.reads.iter().find(|(registers, _)| registers & self.late != 0)
            {
                stall = Stall { at: *at, until: self.arrives };
                self.late = 0;
            }
            for access in &profile.accesses {
                if access.issue >= stall.at {
                    delay += stall.cycles(first, delay);
                    stall = Stall::NONE;
                }
                let base = self.tape[self.at + 1 + usize::from(access.base)];
                let word = base.wrapping_add(access.offset.into());
                let now = first + delay + u32::from(access.issue);
                if access.stores {
                    delay += machine.behind.store(l1, l2, now, word);
                    continue;
                }
                let Access { words, used, .. } = *access;
                let (held_up, arrives) = machine.behind.load(l1, l2, now, word, words);
                delay += held_up;
                let Some(arrives) = arrives else {
                    continue;
                };
                if used != LATER {
                    stall = stall.with(Stall { at: used, until: arrives });
                } else {
                    self.arrives = if self.late == 0 { arrives } else { self.arrives.max(arrives) };
                    self.late |= access.registers;
                }
            }
            delay += stall.cycles(first, delay);
            self.at += 1 + profile.addresses as usize;
            machine.contention.executed[run as usize] += 1;
            let cycles = machine.profile.cycles(machine.program, self.before, run);
            self.time = start + f64::from(delay + cycles);
            self.before = Some(run);
        }
        true
    }
}
