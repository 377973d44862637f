//! Dots as plain text: the letter `o` for a dot, a space for none, a line a row.
//!
//! Made to be read with a braille display or a screen reader as well as with eyes. A space is blank under the finger,
//! where a full stop would be a dot in every empty place. Of the signs for a dot, a letter is one cell in every
//! braille table, where `#` is two in some and columns would shift; screen readers speak it, where they skip signs;
//! and no table shortens `o` beside itself or alone.
//!
//! Spaces at the end of a line are left out, and a page ends with FF.

use super::FORM_FEED;
use super::dot_matrix::DotMatrix;

/// The pages as text.
pub fn write(pages: &[DotMatrix]) -> String {
    let mut text = String::new();
    for page in pages {
        for y in 0..page.rows() {
            let row: String = page.row(y).iter().map(|&height| if height == 0 { ' ' } else { 'o' }).collect();
            text.push_str(row.trim_end_matches(' '));
            text.push('\n');
        }
        text.push(FORM_FEED);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_are_letters() {
        let page = DotMatrix::drawn(".#-.\n....\n+..#\n");
        assert_eq!(write(&[page.clone(), page]), " oo\n\no  o\n\u{c}".repeat(2));
    }
}
