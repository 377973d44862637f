//! Braille as ASCII, which every embosser of text takes: cells of six dots in the North American table.
//!
//! A row of cells is three rows of dots and ends with CR LF, a page ends with FF. Blank cells at the end of a row are left
//! out, since a line that is as long as the page is wide makes some embossers begin another.
//!
//! The dots of such a file are no even grid: cells stand apart from each other. The grid of the device `braille-cells` knows.

use super::{FORM_FEED, Matrix, Reading};

/// The characters of the cells U+2800 to U+283F.
const TABLE: &[u8; 64] = br##" A1B'K2L@CIF/MSP"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\0Z7(_?W]#Y)="##;

/// The pages as ASCII braille.
pub fn write(pages: &[Matrix]) -> String {
    let mut text = String::new();
    for page in pages {
        for cy in 0..page.rows().div_ceil(3) {
            let row = (0..page.columns().div_ceil(2)).map(|cx| char::from(TABLE[usize::from(page.cell6(cx, cy))]));
            text.push_str(row.collect::<String>().trim_end_matches(' '));
            text.push_str("\r\n");
        }
        text.push(FORM_FEED);
    }
    text
}

/// The pages of a file of ASCII braille, every dot at the greatest height; lines may end with LF alone, letters may be small.
/// Columns come in twos and rows in threes.
///
/// # Errors
/// Names the first character that is in no such file.
pub fn read(text: &str) -> Result<Vec<Matrix>, String> {
    let cell = |c: char| {
        // Files in lower case are as common. Its other four signs are those 32 before them.
        let c = match c {
            '`' | '{' | '|' | '}' | '~' => char::from(u8::try_from(c).ok()? - 0x20),
            _ => c.to_ascii_uppercase(),
        };
        TABLE.iter().position(|&known| char::from(known) == c).and_then(|cell| u8::try_from(cell).ok())
    };
    super::read(text, &Reading { dots: 6, cell, wanted: "a character of ASCII braille" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_lose_their_blank_ends() {
        let page = Matrix::drawn("#.....\n......\n......\n......\n......\n......\n......\n...#..\n......\n");
        assert_eq!(write(&[page.clone(), page]), "A\r\n\r\n \"\r\n\u{c}".repeat(2));
    }

    #[test]
    fn what_others_write_is_read() {
        let drawn = |text: &str| read(text).expect("braille").iter().map(ToString::to_string).collect::<Vec<_>>();
        for text in ["=A\r\n\u{c}", "=a\n", "=A"] {
            assert_eq!(drawn(text), ["###.\n##..\n##..\n"], "{text:?}");
        }
        assert_eq!(drawn("`{|}~"), drawn("@[\\]^"));
        assert_eq!(read("A\n\u{7f}"), Err("line 2, character 1: '\\u{7f}' is not a character of ASCII braille".into()));
    }
}
