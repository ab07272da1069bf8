//! Values and their ranges.

/// A value out of range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{key} = {value}: {rule}")]
pub struct OutOfRange {
    /// The key, with its section.
    pub key: String,
    /// Its value.
    pub value: String,
    /// What values it takes.
    pub rule: String,
}

impl OutOfRange {
    /// `key` has the value `value`, against `rule`.
    pub fn new(key: impl Into<String>, value: impl ToString, rule: impl Into<String>) -> Self {
        Self { key: key.into(), value: value.to_string(), rule: rule.into() }
    }
}

/// Most cycles of a latency that can be chosen.
pub const MAX_LATENCY: u32 = 200;

/// Checks that `key` is from `least` to `most`.
///
/// # Errors
/// If it is not.
pub fn within(key: &str, value: u32, least: u32, most: u32) -> Result<(), OutOfRange> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(OutOfRange::new(key, value, format!("from {least} to {most}")))
}

/// The largest amount of energy, area, current or voltage, in whatever unit: sums of amounts and their products with counts stay
/// finite.
const MAX_AMOUNT: f64 = 1e6;

/// Checks that `key` is an amount.
///
/// # Errors
/// If it is below 0, too large or no number.
pub fn amount(key: &str, value: f64) -> Result<(), OutOfRange> {
    if (0.0..=MAX_AMOUNT).contains(&value) {
        return Ok(());
    }
    Err(OutOfRange::new(key, in_short(value), format!("from 0 to {MAX_AMOUNT}")))
}

/// `value` without a row of zeros: 1e-300 has 300 of them.
#[must_use]
pub fn in_short(value: f64) -> String {
    let text = value.to_string();
    if text.len() > 12 { format!("{value:e}") } else { text }
}

/// Checks that `key` is a power of two from 1 to `most`.
///
/// # Errors
/// If it is not.
pub fn power_of_two(key: &str, value: u32, most: u32) -> Result<(), OutOfRange> {
    if value.is_power_of_two() && value <= most {
        return Ok(());
    }
    Err(OutOfRange::new(key, value, format!("a power of two from 1 to {most}")))
}
