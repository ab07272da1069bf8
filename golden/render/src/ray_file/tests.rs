//! Round trips, and every way in which a file can be damaged.

use super::*;
use crate::Wave;
use base::input::XZ_MAGIC;

fn stream() -> RayStream {
    let ray = |i: u32| Ray {
        origin: [i as f32, -0.0, f32::MIN_POSITIVE],
        direction: [f32::from_bits(1), 2.5, -1.0 / 3.0],
        t_min: 0.0,
        t_max: if i.is_multiple_of(2) { f32::INFINITY } else { 1.0 },
    };
    let waves = [
        (RayClass::Primary, 3),
        (RayClass::Shadow { vertex: 0 }, 2),
        (RayClass::Diffuse { bounce: 5 }, 1),
        (RayClass::Secondary, 1),
    ];
    RayStream {
        rays: (0..7).map(ray).collect(),
        waves: waves.map(|(class, rays)| Wave { class, rays }).to_vec(),
    }
}

fn hits() -> Vec<Option<FileHit>> {
    vec![Some(FileHit { triangle: 7, t: 0.1 }), None, Some(FileHit { triangle: 0, t: 0.0 })]
}

/// The bytes of a file and a folder to put damaged ones in.
fn bytes_of(write: impl FnOnce(&Path)) -> (tempfile::TempDir, Vec<u8>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    write(&path);
    let bytes = std::fs::read(&path).unwrap();
    (folder, bytes)
}

#[test]
fn files_come_back_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.rays", "a.rays.xz"] {
        let path = folder.path().join(name);
        write_rays(&path, &stream(), false).unwrap();
        assert_eq!(read_rays(&path).unwrap(), stream());
        assert_eq!(std::fs::read(&path).unwrap().starts_with(XZ_MAGIC), name.ends_with("xz"));
        let hits_path = path.with_added_extension("hits.xz");
        write_hits(&hits_path, &hits(), false).unwrap();
        assert_eq!(read_hits(&hits_path).unwrap(), hits());
    }
}

#[test]
fn existing_files_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kept");
    std::fs::write(&path, "mine").unwrap();
    assert!(matches!(write_rays(&path, &stream(), false), Err(WriteError::Exists(_))));
    assert!(matches!(write_hits(&path, &hits(), false), Err(WriteError::Exists(_))));
    assert_eq!(std::fs::read(&path).unwrap(), b"mine");
    write_hits(&path, &hits(), true).unwrap();
    assert_eq!(read_hits(&path).unwrap(), hits());
}

/// The layout that other programs write: no classes.
#[test]
fn files_without_classes() {
    let (folder, bytes) = bytes_of(|path| write_rays(path, &stream(), false).unwrap());
    let path = folder.path().join("plain");
    std::fs::write(&path, &bytes[..16 + 7 * 32]).unwrap();
    let read = read_rays(&path).unwrap();
    assert_eq!(read.rays, stream().rays);
    let waves = [Wave { class: RayClass::Primary, rays: 3 }, Wave { class: RayClass::Secondary, rays: 4 }];
    assert_eq!(read.waves, waves);
    assert_eq!(&bytes[..16], b"DSTRAYS1\x07\0\0\0\x03\0\0\0");
    assert_eq!(bytes[28..32], 0f32.to_le_bytes(), "t_min stands between origin and direction");
}

#[test]
fn every_truncation_is_found() {
    let (folder, bytes) = bytes_of(|path| write_rays(path, &stream(), false).unwrap());
    let path = folder.path().join("cut");
    for length in (0..bytes.len()).filter(|&length| length != 16 + 7 * 32) {
        std::fs::write(&path, &bytes[..length]).unwrap();
        let error = read_rays(&path).unwrap_err();
        assert!(error.to_string().starts_with(path.to_str().unwrap()), "{error}");
        assert!(error.to_string().contains("offset"), "{error}");
    }
    let (folder, bytes) = bytes_of(|path| write_hits(path, &hits(), false).unwrap());
    let path = folder.path().join("cut");
    for length in 0..bytes.len() {
        std::fs::write(&path, &bytes[..length]).unwrap();
        assert!(read_hits(&path).is_err(), "{length}");
    }
}

#[test]
fn a_truncated_or_damaged_xz_stream_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.xz");
    write_rays(&path, &stream(), false).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    for length in XZ_MAGIC.len()..bytes.len() {
        std::fs::write(&path, &bytes[..length]).unwrap();
        assert!(read_rays(&path).is_err(), "{length} of {}", bytes.len());
    }
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x10;
        std::fs::write(&path, &damaged).unwrap();
        assert!(read_rays(&path).is_err(), "byte {at} of {}", bytes.len());
    }
}

#[test]
fn damaged_fields_are_named() {
    let (folder, bytes) = bytes_of(|path| write_rays(path, &stream(), false).unwrap());
    let path = folder.path().join("damaged");
    let table = 16 + 7 * 32;
    let with = |at: usize, value: u32| {
        let mut bytes = bytes.clone();
        bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        std::fs::write(&path, bytes).unwrap();
        read_rays(&path).unwrap_err().kind
    };
    assert!(matches!(with(0, 0), RayFileErrorKind::Magic { .. }));
    // A count beyond the file must not ask for 128 GiB of memory.
    assert!(matches!(with(8, u32::MAX), RayFileErrorKind::Truncated { .. }));
    assert!(matches!(with(8, 6), RayFileErrorKind::TrailingBytes { .. }));
    assert!(matches!(with(12, 8), RayFileErrorKind::Primary { primary: 8, rays: 7 }));
    assert!(matches!(with(12, 2), RayFileErrorKind::Classes { .. }));
    assert!(matches!(with(table, 0), RayFileErrorKind::TrailingBytes { .. }));
    assert!(matches!(with(table + 8, 3), RayFileErrorKind::Classes { .. }));
    assert!(matches!(with(table + 8, u32::MAX), RayFileErrorKind::Truncated { .. }));
    assert!(matches!(with(table + 12, 0x300), RayFileErrorKind::Classes { .. }));
    assert!(matches!(with(table + 16, 4), RayFileErrorKind::Classes { .. }));
    assert!(matches!(
        read_hits(folder.path().join("file")).unwrap_err().kind,
        RayFileErrorKind::Magic { .. }
    ));
    assert!(matches!(read_rays(folder.path().join("nothing")).unwrap_err().kind, RayFileErrorKind::Open(_)));
}

#[test]
fn class_codes_are_unique() {
    let classes = (0..RayClass::WAVES).map(RayClass::of_wave).chain([RayClass::Secondary]);
    for class in classes {
        assert_eq!(class_of_code(class_code(class)), Some(class));
    }
}
