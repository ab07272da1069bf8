//! Bytes of a file, unpacked within limits.
//!
//! A compressed file of a few kilobytes can hold gigabytes. What is unpacked is therefore limited by the size of what it is
//! unpacked from, and so is the memory that an xz stream asks for.

use std::cell::Cell;
use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;
use std::rc::Rc;

use flate2::bufread::MultiGzDecoder;
use liblzma::bufread::XzDecoder;
use liblzma::stream::{CONCATENATED, Stream};

/// Unpacked bytes that any compressed file may hold.
pub const FREE_BYTES: u64 = 64 << 20;
/// Further unpacked bytes for each compressed byte.
pub const RATIO: u64 = 400;
/// Most memory that an xz stream may ask for. The highest preset, `xz -9`, takes 65 MiB.
pub const MOST_XZ_MEMORY: u64 = 512 << 20;

/// How an xz stream begins.
pub const XZ_MAGIC: &[u8] = b"\xfd7zXZ\0";
/// How a gzip stream begins.
pub const GZIP_MAGIC: &[u8] = b"\x1f\x8b";
const BUFFER_BYTES: usize = 1 << 16;

/// A limit that a file exceeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// It holds more than [`FREE_BYTES`] and [`RATIO`] allow.
    Expands,
    /// Unpacking asks for more than [`MOST_XZ_MEMORY`].
    XzMemory,
    /// A line is longer than its reader takes.
    Line,
    /// There are more bytes than its reader takes.
    Bytes(u64),
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Expands => f.write_str("too large when unpacked"),
            Self::XzMemory => f.write_str("unpacking takes too much memory"),
            Self::Line => f.write_str("a line is too long"),
            Self::Bytes(most) => write!(f, "more than {most} bytes"),
        }
    }
}

impl std::error::Error for Limit {}

/// The first `most` bytes of `source`, or all if it has fewer, and `source` from its start. A pipe may give few bytes at a time.
///
/// # Errors
/// Those of `source`.
pub fn start<'a>(mut source: impl BufRead + 'a, most: usize) -> io::Result<(Vec<u8>, impl BufRead + 'a)> {
    let mut start = Vec::with_capacity(most);
    (&mut source).take(most as u64).read_to_end(&mut start)?;
    let again = io::Cursor::new(start.clone()).chain(source);
    Ok((start, again))
}

/// The unpacked bytes of `source`, whose compression is recognised by the content.
///
/// # Errors
/// Those of `source`.
pub fn unpacked<'a>(source: impl BufRead + 'a) -> io::Result<Box<dyn BufRead + 'a>> {
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

/// All bytes of `source`, if there are at most `most`. Memory grows with what is read, so that an endless source ends in an error.
///
/// # Errors
/// Those of `source`, and [`Limit::Bytes`].
pub fn at_most(source: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(io::Error::other(Limit::Bytes(most)));
    }
    Ok(bytes)
}

/// The file `path`, which a user gave to be read.
///
/// # Errors
/// Those of the system, and a [`Conflict`](crate::guard::Conflict) if the program is going to write the file.
pub fn open(path: &Path) -> io::Result<File> {
    let file = File::open(path)?;
    crate::guard::reads(path)?;
    Ok(file)
}

/// All bytes of the file `path`, which a user gave, if there are at most `most`.
///
/// # Errors
/// Those of [`open`], and [`Limit::Bytes`].
pub fn read_file(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    at_most(open(path)?, most)
}

/// The text of the file `path`, which a user gave, if it has at most `most` bytes.
///
/// # Errors
/// Those of [`read_file`], and `InvalidData` for what is not UTF-8.
pub fn read_text(path: &Path, most: u64) -> io::Result<String> {
    text(read_file(path, most)?)
}

/// The text of the file `path`, which the program itself wrote and may write again, if it has at most `most` bytes.
///
/// # Errors
/// As those of [`read_text`].
pub fn read_own(path: &Path, most: u64) -> io::Result<String> {
    text(at_most(File::open(path)?, most)?)
}

fn text(bytes: Vec<u8>) -> io::Result<String> {
    String::from_utf8(bytes).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error.utf8_error()))
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    fn limit(error: &io::Error) -> Option<Limit> {
        error.get_ref().and_then(|inner| inner.downcast_ref()).copied()
    }

    #[test]
    fn an_endless_source_ends_in_an_error() {
        assert_eq!(at_most(&b"abc"[..], 3).unwrap(), b"abc");
        assert_eq!(limit(&at_most(io::repeat(0), 1000).unwrap_err()), Some(Limit::Bytes(1000)));
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, b"\xff").unwrap();
        assert_eq!(read_text(&path, 1).unwrap_err().kind(), io::ErrorKind::InvalidData);
        assert_eq!(limit(&read_text(&path, 0).unwrap_err()), Some(Limit::Bytes(0)));
    }

    #[test]
    fn a_small_file_does_not_unpack_to_more_than_its_share() {
        let mut encoder = flate2::write::GzEncoder::new(vec![], flate2::Compression::best());
        let zeros = vec![0; 1 << 20];
        for _ in 0..=(FREE_BYTES + RATIO * (1 << 18)) >> 20 {
            encoder.write_all(&zeros).unwrap();
        }
        let packed = encoder.finish().unwrap();
        assert!(packed.len() < 1 << 18);
        let error = io::copy(&mut unpacked(&packed[..]).unwrap(), &mut io::sink()).unwrap_err();
        assert_eq!(limit(&error), Some(Limit::Expands));
    }
}
