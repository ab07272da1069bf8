//! The bytes of a file of rays or hits, in the order in which they stand.

use super::{RayFileErrorKind, WAVES_MAGIC, class_of_code};
use crate::{RayClass, Wave};
use std::io::{self, BufRead};

/// Elements that are read at once, so that a damaged count does not ask for all memory.
const CHUNK: usize = 1 << 16;

/// A source that knows its place.
pub struct Input {
    source: Box<dyn BufRead>,
    offset: u64,
}

impl Input {
    pub fn new(source: Box<dyn BufRead>) -> Self {
        Self { source, offset: 0 }
    }

    /// Fills as much of `buffer` as there is left and returns how much.
    fn fill(&mut self, buffer: &mut [u8]) -> Result<usize, RayFileErrorKind> {
        let mut filled = 0;
        while filled < buffer.len() {
            match self.source.read(&mut buffer[filled..]) {
                Ok(0) => break,
                Ok(n) => filled += n,
                Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                // A compressed stream that is cut off; the offset is that of the uncompressed file.
                Err(e) if e.kind() == io::ErrorKind::UnexpectedEof => {
                    let offset = self.offset + filled as u64;
                    return Err(RayFileErrorKind::Truncated {
                        offset,
                        part: "its compressed stream".to_owned(),
                    });
                }
                Err(source) => {
                    return Err(RayFileErrorKind::Read { offset: self.offset + filled as u64, source });
                }
            }
        }
        self.offset += filled as u64;
        Ok(filled)
    }

    pub fn magic(&mut self, magic: &[u8; 8], expected: &'static str) -> Result<(), RayFileErrorKind> {
        let mut found = [0; 8];
        let length = self.fill(&mut found)?;
        if length == found.len() && found == *magic {
            return Ok(());
        }
        let found = String::from_utf8_lossy(&found[..length]).into_owned();
        Err(RayFileErrorKind::Magic { found, expected })
    }

    pub fn u32(&mut self, part: &str) -> Result<u32, RayFileErrorKind> {
        let mut bytes = [0; 4];
        if self.fill(&mut bytes)? < bytes.len() {
            return Err(RayFileErrorKind::Truncated { offset: self.offset, part: part.to_owned() });
        }
        Ok(u32::from_le_bytes(bytes))
    }

    /// Reads `count` elements of `N` words each.
    pub fn elements<W: FromWord, const N: usize>(
        &mut self,
        count: u32,
        name: &str,
        mut each: impl FnMut([W; N]),
    ) -> Result<(), RayFileErrorKind> {
        let size = 4 * N;
        let mut buffer = vec![0; size * CHUNK.min(count as usize)];
        let mut done = 0;
        while done < count as usize {
            let wanted = CHUNK.min(count as usize - done);
            let bytes = self.fill(&mut buffer[..wanted * size])?;
            if bytes < wanted * size {
                let part = format!("{name} {} of {count}", done + bytes / size);
                return Err(RayFileErrorKind::Truncated { offset: self.offset, part });
            }
            for element in buffer[..bytes].chunks_exact(size) {
                let (words, _) = element.as_chunks::<4>();
                each(std::array::from_fn(|i| W::from_word(words[i])));
            }
            done += wanted;
        }
        Ok(())
    }

    /// The optional classes of `rays` rays, and the end of the file.
    pub fn waves(&mut self, rays: u32, primary: u32) -> Result<Vec<Wave>, RayFileErrorKind> {
        let start = self.offset;
        let mut magic = [0; 8];
        match self.fill(&mut magic)? {
            0 => {
                let unknown = Wave { class: RayClass::Secondary, rays: rays - primary };
                let waves = [Wave { class: RayClass::Primary, rays: primary }, unknown];
                return Ok(waves.into_iter().filter(|wave| wave.rays > 0).collect());
            }
            n if n == magic.len() && magic == *WAVES_MAGIC => {}
            _ => return Err(RayFileErrorKind::TrailingBytes { offset: start }),
        }
        let mut waves = vec![];
        let mut sum = 0u64;
        for _ in 0..self.u32("the table of classes")? {
            let offset = self.offset;
            let [code, count] = [self.u32("the table of classes")?, self.u32("the table of classes")?];
            let class = class_of_code(code).ok_or_else(|| RayFileErrorKind::Classes {
                offset,
                what: format!("has the unknown class {code:#x}"),
            })?;
            sum += u64::from(count);
            waves.push(Wave { class, rays: count });
        }
        let leading = waves.iter().take_while(|wave| wave.class == RayClass::Primary);
        let leading: u64 = leading.map(|wave| u64::from(wave.rays)).sum();
        let all = waves.iter().filter(|wave| wave.class == RayClass::Primary);
        let all: u64 = all.map(|wave| u64::from(wave.rays)).sum();
        let classes = |what| RayFileErrorKind::Classes { offset: start, what };
        if sum != u64::from(rays) {
            return Err(classes(format!("counts {sum} rays instead of {rays}")));
        }
        if leading != u64::from(primary) || all != leading {
            return Err(classes(format!("does not begin with exactly the {primary} primary rays")));
        }
        self.end()?;
        Ok(waves)
    }

    pub fn end(&mut self) -> Result<(), RayFileErrorKind> {
        let offset = self.offset;
        match self.fill(&mut [0])? {
            0 => Ok(()),
            _ => Err(RayFileErrorKind::TrailingBytes { offset }),
        }
    }
}

pub trait FromWord {
    fn from_word(bytes: [u8; 4]) -> Self;
}

impl FromWord for u32 {
    fn from_word(bytes: [u8; 4]) -> Self {
        u32::from_le_bytes(bytes)
    }
}

impl FromWord for f32 {
    fn from_word(bytes: [u8; 4]) -> Self {
        f32::from_le_bytes(bytes)
    }
}
