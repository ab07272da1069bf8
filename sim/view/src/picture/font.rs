//! Text in pictures.

use super::Picture;
use font8x8::{BASIC_FONTS, UnicodeFonts};

/// Width and height of a character in pixels.
pub const CHARACTER: u32 = 8;

/// Draws `text` with its upper left corner at (`x`, `y`), without pixels outside the picture and characters beyond ASCII.
pub fn draw(picture: &mut Picture<u8>, x: u32, y: u32, text: &str, colour: [u8; 3]) {
    for (character, left) in text.chars().zip((x..).step_by(CHARACTER as usize)) {
        for (row, line) in (y..).zip(BASIC_FONTS.get(character).unwrap_or_default()) {
            for column in (0..CHARACTER).filter(|column| line >> column & 1 == 1) {
                picture.set(left + column, row, colour);
            }
        }
    }
}

/// Width of `text` in pixels.
#[must_use]
pub fn width(text: &str) -> u32 {
    text.chars().count() as u32 * CHARACTER
}
