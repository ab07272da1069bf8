//! Values that are one of a few words.

use serde::Deserializer;
use serde::de::{Error, Visitor};
use std::fmt;

/// Reads one of `words`. The error for anything else names them all.
///
/// # Errors
/// The value is no such word.
pub fn one_of<'de, D: Deserializer<'de>, T: Copy>(
    deserializer: D,
    words: &'static [(&'static str, T)],
) -> Result<T, D::Error> {
    deserializer.deserialize_str(Word(words))
}

struct Word<T: 'static>(&'static [(&'static str, T)]);

impl<T: Copy> Visitor<'_> for Word<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<String> = self.0.iter().map(|(name, _)| format!("`{name}`")).collect();
        f.write_str(&names.join(" or "))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        let found = self.0.iter().find(|(name, _)| *name == text);
        found.map(|(_, value)| *value).ok_or_else(|| {
            E::custom(format!("unknown variant `{text}`, expected {}", &self as &dyn serde::de::Expected))
        })
    }
}
