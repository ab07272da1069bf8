//! Bytes of a file, unpacked within limits.
//!
//! A compressed file of a few kilobytes can hold gigabytes. What is unpacked is therefore limited by the size of what it is
//! unpacked from, and so is the memory that an xz stream asks for.

use std::cell::Cell;
use std::fmt;
use std::io::{self, BufRead, BufReader, Read};
use std::rc::Rc;

use flate2::bufread::MultiGzDecoder;
use liblzma::bufread::XzDecoder;
use liblzma::stream::{CONCATENATED, Stream};

/// Unpacked bytes that any compressed file may hold.
pub(super) const FREE_BYTES: u64 = 64 << 20;
/// Further unpacked bytes for each compressed byte.
pub(super) const RATIO: u64 = 400;
/// Most memory that an xz stream may ask for. The highest preset, `xz -9`, takes 65 MiB.
pub(super) const MOST_XZ_MEMORY: u64 = 512 << 20;

const XZ_MAGIC: &[u8] = b"\xfd7zXZ\0";
const GZIP_MAGIC: &[u8] = b"\x1f\x8b";
const BUFFER_BYTES: usize = 1 << 16;

/// A limit that a file exceeds.
#[derive(Debug)]
pub(super) enum Limit {
    Expands,
    XzMemory,
    Line,
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Expands => "too large when unpacked",
            Self::XzMemory => "unpacking takes too much memory",
            Self::Line => "a line is too long",
        })
    }
}

impl std::error::Error for Limit {}

/// The first `most` bytes of `source`, or all if it has fewer, and `source` from its start. A pipe may give few bytes at a time.
///
/// # Errors
/// Those of `source`.
pub(super) fn start<'a>(
    mut source: impl BufRead + 'a,
    most: usize,
) -> io::Result<(Vec<u8>, impl BufRead + 'a)> {
    let mut start = Vec::with_capacity(most);
    (&mut source).take(most as u64).read_to_end(&mut start)?;
    let again = io::Cursor::new(start.clone()).chain(source);
    Ok((start, again))
}

/// The unpacked bytes of `source`, whose compression is recognised by the content.
///
/// # Errors
/// Those of `source`.
pub(super) fn unpacked<'a>(source: impl BufRead + 'a) -> io::Result<Box<dyn BufRead + 'a>> {
    let (start, source) = start(source, XZ_MAGIC.len())?;
    let (xz, gzip) = (start.starts_with(XZ_MAGIC), start.starts_with(GZIP_MAGIC));
    if !xz && !gzip {
        return Ok(Box::new(source));
    }
    let taken = Rc::new(Cell::new(0));
    let counted = Counted { source, taken: Rc::clone(&taken) };
    let decoder: Box<dyn Read + 'a> = if xz {
        let stream = Stream::new_stream_decoder(MOST_XZ_MEMORY, CONCATENATED)?;
        Box::new(XzDecoder::new_stream(counted, stream))
    } else {
        Box::new(MultiGzDecoder::new(counted))
    };
    Ok(Box::new(BufReader::with_capacity(BUFFER_BYTES, Limited { decoder, taken, given: 0 })))
}

/// Reads all of `source`.
///
/// # Errors
/// Those of `source`.
pub(super) fn whole(source: &mut dyn BufRead) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Counts the bytes that are taken from `source`.
struct Counted<R> {
    source: R,
    taken: Rc<Cell<u64>>,
}

impl<R: BufRead> Read for Counted<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let bytes = self.source.read(buffer)?;
        self.taken.set(self.taken.get() + bytes as u64);
        Ok(bytes)
    }
}

impl<R: BufRead> BufRead for Counted<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.source.fill_buf()
    }

    fn consume(&mut self, amount: usize) {
        self.taken.set(self.taken.get() + amount as u64);
        self.source.consume(amount);
    }
}

/// Ends with an error when the decoder has given more than the compressed bytes allow.
struct Limited<'a> {
    decoder: Box<dyn Read + 'a>,
    taken: Rc<Cell<u64>>,
    given: u64,
}

impl Read for Limited<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let bytes = self.decoder.read(buffer).map_err(|error| {
            let memory = error
                .get_ref()
                .and_then(|inner| inner.downcast_ref::<liblzma::stream::Error>())
                .is_some_and(|inner| *inner == liblzma::stream::Error::MemLimit);
            if memory { io::Error::other(Limit::XzMemory) } else { error }
        })?;
        self.given += bytes as u64;
        if self.given > FREE_BYTES + RATIO.saturating_mul(self.taken.get()) {
            return Err(io::Error::other(Limit::Expands));
        }
        Ok(bytes)
    }
}
