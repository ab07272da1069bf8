//! What every other crate stands on.
//!
//! | module | what it holds |
//! |---|---|
//! | [`split_mix`] | random bits that are the same on every machine |
//! | [`input`] | the bytes of files, unpacked, within limits |
//! | [`output`] | files that appear whole or not at all |
//! | [`toml_text`] | TOML of users, within limits |
//! | [`guard`] | no file is both read and written |
//!
//! ```
//! use base::{output::write_file, split_mix};
//!
//! let mut counter = 7;
//! assert_eq!(split_mix::next(&mut counter), split_mix::hash(7));
//!
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("numbers.txt");
//! write_file(&path, false, |out| writeln!(out, "1 2 3"))?;
//! assert_eq!(std::fs::read_to_string(&path)?, "1 2 3\n");
//! // Without `force`, an existing file stays as it is.
//! assert!(write_file(&path, false, |out| writeln!(out, "4")).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod guard;
pub mod input;
pub mod output;
pub mod split_mix;
pub mod toml_text;
