//! The buffers of a glTF document: in the binary file, in the document, or in files beside it.

use std::collections::HashMap;
use std::io::Read;
use std::path::{Component, Path};
use std::rc::Rc;

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use gltf::Buffer;
use gltf::buffer::{Source, View};
use percent_encoding::percent_decode_str;

use super::{Fault, fault};
use crate::formats::error::FormatErrorKind;

const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// Gives the bytes of buffers, and reads each when it is first asked for.
pub(super) struct Buffers<'a> {
    blob: Option<Rc<[u8]>>,
    folder: Option<&'a Path>,
    loaded: HashMap<usize, Rc<[u8]>>,
    /// Bytes of the file and of all buffers that were read from other files.
    pub(super) read_bytes: u64,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(blob: Option<Rc<[u8]>>, folder: Option<&'a Path>, file_bytes: u64) -> Self {
        Self { blob, folder, loaded: HashMap::new(), read_bytes: file_bytes }
    }

    /// The buffer of `view`, and the range of the view in it.
    pub(super) fn view(&mut self, view: &View<'_>) -> Result<(Rc<[u8]>, std::ops::Range<usize>), Fault> {
        let bytes = self.buffer(&view.buffer())?;
        let end = view.offset().checked_add(view.length()).filter(|&end| end <= bytes.len());
        let Some(end) = end else {
            let what = format!("it ends beyond its buffer, which has {} bytes", bytes.len());
            return Err(fault(format!("buffer view {}", view.index()), FormatErrorKind::Invalid(what)));
        };
        Ok((bytes, view.offset()..end))
    }

    fn buffer(&mut self, buffer: &Buffer<'_>) -> Result<Rc<[u8]>, Fault> {
        if let Some(bytes) = self.loaded.get(&buffer.index()) {
            return Ok(Rc::clone(bytes));
        }
        let fault = |kind| fault(format!("buffer {}", buffer.index()), kind);
        let bytes: Rc<[u8]> = match buffer.source() {
            Source::Bin => self.blob.clone().ok_or_else(|| {
                fault(FormatErrorKind::Invalid(
                    "the file has no binary chunk, and the buffer no URI".to_owned(),
                ))
            })?,
            Source::Uri(uri) => match uri.strip_prefix("data:") {
                Some(data) => decoded(data).map_err(fault)?.into(),
                None => {
                    let bytes = self.file(uri, buffer.length()).map_err(fault)?;
                    self.read_bytes += bytes.len() as u64;
                    bytes.into()
                }
            },
        };
        if bytes.len() < buffer.length() {
            let what = format!("it declares {} bytes and has {}", buffer.length(), bytes.len());
            return Err(fault(FormatErrorKind::Truncated(what)));
        }
        self.loaded.insert(buffer.index(), Rc::clone(&bytes));
        Ok(bytes)
    }

    /// The first `length` bytes of the file that `uri` names.
    fn file(&self, uri: &str, length: usize) -> Result<Vec<u8>, FormatErrorKind> {
        if uri.contains("://") {
            return Err(FormatErrorKind::Unsupported(format!("the buffer is elsewhere, at `{uri}`")));
        }
        let Some(folder) = self.folder else {
            return Err(FormatErrorKind::Unsupported(format!(
                "the buffer is in another file, `{uri}`, without a folder"
            )));
        };
        let named = |e: std::io::Error| std::io::Error::new(e.kind(), format!("`{uri}`: {e}"));
        let name = percent_decode_str(uri).decode_utf8_lossy();
        // A scene from elsewhere must not read any file of the host.
        if Path::new(&*name)
            .components()
            .any(|part| !matches!(part, Component::Normal(_) | Component::CurDir))
        {
            return Err(FormatErrorKind::Unsupported(format!(
                "the buffer `{uri}` is not beside the file or in a folder there"
            )));
        }
        let path = folder.join(&*name);
        let file = base::input::open(&path).map_err(|e| FormatErrorKind::Open(named(e)))?;
        let metadata = file.metadata().map_err(|e| FormatErrorKind::Read(named(e)))?;
        if !metadata.is_file() || metadata.len() < length as u64 {
            let what = format!("`{uri}` has {} bytes instead of {length}", metadata.len());
            return Err(FormatErrorKind::Truncated(what));
        }
        let mut bytes = Vec::new();
        file.take(length as u64).read_to_end(&mut bytes).map_err(|e| FormatErrorKind::Read(named(e)))?;
        Ok(bytes)
    }
}

/// The bytes of a data URI without its scheme.
fn decoded(data: &str) -> Result<Vec<u8>, FormatErrorKind> {
    let text = data.split_once(',').filter(|(kind, _)| kind.ends_with(";base64")).map(|(_, text)| text);
    let invalid = |what: String| FormatErrorKind::Invalid(format!("its data URI is not in base 64{what}"));
    BASE64.decode(text.ok_or_else(|| invalid(String::new()))?).map_err(|e| invalid(format!(" ({e})")))
}
