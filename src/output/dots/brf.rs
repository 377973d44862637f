//! Braille as ASCII, which every embosser of text takes: cells of six dots in the North American table.
//!
//! A row of cells is three rows of dots and ends with CR LF, a page ends with FF. Blank cells at the end of a row are
//! left out, since a line that is as long as the page is wide makes some embossers begin another.
//!
//! The dots of such a file are no even grid: cells stand apart from each other. The grid of the device
//! `braille-cells` knows.

use super::FORM_FEED;
use super::dot_matrix::DotMatrix;

/// The characters of the cells U+2800 to U+283F.
const TABLE: &[u8; 64] = br##" A1B'K2L@CIF/MSP"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\0Z7(_?W]#Y)="##;

/// The pages as ASCII braille.
pub fn write(pages: &[DotMatrix]) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_lose_their_blank_ends() {
        let page = DotMatrix::drawn("#.....\n......\n......\n......\n......\n......\n......\n...#..\n......\n");
        assert_eq!(write(&[page.clone(), page]), "A\r\n\r\n \"\r\n\u{c}".repeat(2));
    }
}
