//! What holds for all formats: the choice of the format, compression, limits, and no panic on any bytes.

use std::io::Write;

use flate2::write::GzEncoder;
use liblzma::write::XzEncoder;
use proptest::prelude::*;

use super::*;

mod gltf_files;
mod ply_files;
mod stl_files;

/// Two triangles that share a side.
pub(super) fn square() -> Mesh {
    Mesh {
        positions: vec![[0.0, 0.0, 0.5], [1.0, 0.0, 0.5], [1.0, 1.0, 0.5], [0.0, 1.0, 0.1]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    }
}

pub(super) fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), flate2::Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn xzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = XzEncoder::new(Vec::new(), 9);
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// Reads `bytes` as a file called `name`.
pub(super) fn named(bytes: &[u8], name: &str) -> Result<FileMesh, FormatError> {
    read(bytes, Path::new(name), None, None)
}

/// Asserts that the message of the error about `bytes` begins with the place and holds the words.
pub(super) fn assert_refused(bytes: &[u8], name: &str, start: &str, words: &[&str]) {
    let message = named(bytes, name).expect_err(start).to_string();
    assert!(message.starts_with(start), "`{message}` does not start with `{start}`");
    for word in words {
        assert!(message.contains(word), "no `{word}` in {message}");
    }
    assert!(message.contains("; "), "no remedy in: {message}");
    assert!(!message.contains('\n'), "{message}");
}

/// The square in each format, by the names of files that [`save`] writes.
fn written(name: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    save(&path, "square", &square(), false).unwrap();
    std::fs::read(path).unwrap()
}

#[test]
fn what_is_written_is_what_the_name_says() {
    for (format, start) in [("obj", &b"# 2"[..]), ("ply", b"ply\nformat binary"), ("stl", &[0; 80])] {
        let plain = written(&format!("a.{format}"));
        assert!(plain.starts_with(start), "{format}");
        assert_eq!(written(&format!("a.{}", format.to_uppercase())), plain);
        for (compression, magic) in [("gz", &b"\x1f\x8b"[..]), ("xz", b"\xfd7zXZ\0")] {
            let packed = written(&format!("a.{format}.{compression}"));
            assert!(packed.starts_with(magic), "{format}.{compression}");
            let mut unpacked = Vec::new();
            source::unpacked(&packed[..]).unwrap().read_to_end(&mut unpacked).unwrap();
            assert_eq!(unpacked, plain, "{format}.{compression}");
            // The content decides, whatever the name.
            for name in ["-", &*format!("b.{format}"), &*format!("b.{format}.gz")] {
                let given =
                    if name == "-" { Format::ALL.into_iter().find(|f| f.name() == format) } else { None };
                let file = read(&packed[..], Path::new(name), None, given).unwrap();
                assert_eq!(file.mesh, square(), "{format}.{compression} as {name}");
                assert_eq!(file.report.format.name(), format);
                assert_eq!(file.report.notes(), Vec::<String>::new());
            }
        }
    }
    for name in ["a.glb", "a.gltf", "a.fbx", "a", "a.xz", "a.obj.zip", ".obj"] {
        let message = written_format(Path::new(name)).unwrap_err().to_string();
        assert!(message.starts_with(name) && message.contains(".ply"), "{message}");
    }
}

#[test]
fn the_format_is_recognised_by_content_where_no_name_says_it() {
    for (name, format) in [("a.obj", Format::Obj), ("a.ply", Format::Ply)] {
        for nameless in ["standard input", "a.data"] {
            assert_eq!(named(&written(name), nameless).unwrap().report.format, format);
        }
    }
    // What is certain of the content wins over the name.
    assert_eq!(named(&written("a.ply"), "a.obj").unwrap().mesh, square());
    assert_refused(b"what is this", "a.data", "a.data: ", &["--format", "obj, ply, stl, gltf"]);
    let ply =
        read(&written("a.ply")[..], Path::new("a.ply"), None, Some(Format::Obj)).unwrap_err().to_string();
    assert!(ply.starts_with("a.ply: --format obj, but") && ply.contains("--format ply"), "{ply}");
    assert_refused(b"", "a.data", "a.data: ", &["--format"]);
    assert_refused(b"Kaydara FBX Binary  \0", "a.obj", "a.obj: FBX", &["not read", "ply"]);
    assert_refused(b"PK\x03\x04", "a.data", "a.data: zip", &["not read"]);
}

#[test]
fn formats_that_are_not_read_are_named() {
    let folder = tempfile::tempdir().unwrap();
    for (extension, format) in NOT_READ {
        for name in [format!("a.{extension}"), format!("a.{extension}.gz")] {
            let path = folder.path().join(name);
            std::fs::write(&path, "v 0 0 0").unwrap();
            let message = load(&path, None).unwrap_err().to_string();
            assert!(message.contains(&format!("{format} files are not read")), "{message}");
        }
    }
}

#[test]
fn small_files_cannot_hold_gigabytes() {
    let mut encoder = XzEncoder::new(Vec::new(), 1);
    encoder.write_all(&vec![b'\n'; 72 << 20]).unwrap();
    let packed = encoder.finish().unwrap();
    assert!(packed.len() < 12_000, "{}", packed.len());
    for name in ["a.obj", "a.ply"] {
        assert_refused(&packed, name, name, &["times its compressed size"]);
    }
    // An xz header that asks for a dictionary of 4 GiB less one byte; its block header has a checksum of its own.
    let mut bytes = xzipped(b"v 0 0 0\n");
    assert_eq!((bytes[14], bytes[15]), (0x21, 1), "the filter LZMA2 with one byte of properties");
    bytes[16] = 40;
    let checksum = crc32fast::hash(&bytes[12..20]).to_le_bytes();
    bytes[20..24].copy_from_slice(&checksum);
    assert_refused(&bytes, "a.obj", "a.obj", &["512 MiB of memory"]);
}

#[test]
fn a_pipe_may_give_one_byte_at_a_time() {
    struct Slow(Vec<u8>, usize);
    impl std::io::Read for Slow {
        fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
            let Some(&byte) = self.0.get(self.1) else { return Ok(0) };
            self.1 += 1;
            buffer[0] = byte;
            Ok(1)
        }
    }
    for name in ["a.obj.gz", "a.ply.xz", "a.ply"] {
        let slow = BufReader::with_capacity(1, Slow(written(name), 0));
        assert_eq!(read(slow, Path::new("standard input"), None, None).unwrap().mesh, square(), "{name}");
    }
}

#[test]
fn names_without_extensions() {
    for (name, expected) in [
        ("d/my.model.obj.xz", "my.model"),
        ("a.GLB", "a"),
        ("a.b.gz", "a.b"),
        ("a.view", "a.view"),
        ("a", "a"),
    ] {
        assert_eq!(stem(Path::new(name)), Path::new(expected), "{name}");
    }
}

#[test]
fn the_list_has_each_format_once() {
    for format in Format::ALL {
        assert_eq!(FORMATS.iter().filter(|entry| entry.format == format).count(), 1);
        assert_eq!(Format::of_path(Path::new(&format!("a.{}", format.name()))), Some(format));
    }
}

proptest! {
    #[test]
    fn any_bytes_give_a_valid_mesh_or_an_error(
        seed in prop::sample::select(vec!["a.obj", "a.ply", "a.stl", "t.ply", "t.stl", "t.gltf", "t.glb"]),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        length in any::<prop::sample::Index>(),
        cut in any::<bool>(),
    ) {
        let mut bytes = match seed {
            "t.ply" => ply_files::TEXT.as_bytes().to_vec(),
            "t.stl" => stl_files::TEXT.as_bytes().to_vec(),
            "t.gltf" => gltf_files::json().into_bytes(),
            "t.glb" => gltf_files::glb(),
            name => written(name),
        };
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        if cut {
            bytes.truncate(length.index(bytes.len()));
        }
        if let Ok(FileMesh { mesh, .. }) = named(&bytes, seed) {
            prop_assert!(!mesh.triangles.is_empty());
            prop_assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()));
            prop_assert!(mesh.positions.iter().flatten().all(|x| x.abs() <= crate::MAX_COORDINATE));
        }
    }

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), format in prop::sample::select(Format::ALL.to_vec())) {
        let start: &[u8] = match format {
            Format::Obj => b"v 0 0 0\n",
            Format::Ply => b"ply\nformat binary_little_endian 1.0\n",
            Format::Stl => b"solid\n",
            Format::Gltf => b"glTF\x02\0\0\0",
        };
        let _ = read(&bytes[..], Path::new("random"), None, Some(format));
        let _ = read(&[start, &bytes].concat()[..], Path::new("random"), None, Some(format));
    }
}
