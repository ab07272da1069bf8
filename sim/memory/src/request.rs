//! What clients ask, and what they are answered.

use crate::outstanding::UNKNOWN;

/// Who asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Client {
    /// The port that it asks through.
    pub port: u16,
    /// A number that it chooses. What is given back or announced to it carries the number.
    pub number: u16,
}

/// What is done with the words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// They are read.
    Load,
    /// They are written, around the caches.
    Store,
}

/// What a client asks: words of one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Request {
    /// When it asks.
    pub cycle: u32,
    /// Who asks.
    pub client: Client,
    /// What for.
    pub access: Access,
    /// The first word, counted in words of 32 bits.
    pub address: u32,
}

/// What the memory answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The words can be used from this cycle on. Of a store, the client goes on then.
    At(u32),
    /// The line is on its way, and it is not known yet when it arrives.
    Later,
    /// A bank or all miss registers are taken, or the queue for writes is full. The client asks again in the next cycle.
    Refused,
    /// The queue for reads is full. The memory gives the request back when there is room.
    Kept,
}

impl Answer {
    /// The answer to a load whose words can be used from cycle `ready` on, or from one that is not known yet.
    pub(crate) fn of(ready: u32) -> Self {
        if ready == UNKNOWN { Self::Later } else { Self::At(ready) }
    }
}
