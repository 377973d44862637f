//! The Portable Embosser Format, PEF 2008-1: XML with Unicode braille and words about the document.
//!
//! Cells of eight dots in rows without a gap (`rowgap="0"`) are rows of dots at even distances, whatever the
//! embosser's are; PEF says nothing of distances or paper. There is no date in it, so that the same pages give the
//! same bytes.
//!
//! Braille on such a page is made of dots wherever its cells can stand, and is no text to a program. So what is
//! written on the pages stands in front of them as text too, in a section of its own.

use svg::node::Text;

use super::dot_matrix::DotMatrix;
use super::{DocumentWords, ubrl};
use crate::output::seal;
use crate::output::text::plain;

/// The pages as PEF.
///
/// The document is identified by a number that follows from its dots and words. A language that is no language tag
/// (RFC 3066, as PEF asks for) is left out, and so is a description in another language than the title's, since a
/// document has one language. No pages make a document with an empty page, since PEF has none without.
pub fn write(pages: &[DotMatrix], words: &DocumentWords<'_>) -> String {
    let most = |of: fn(&DotMatrix) -> usize| pages.iter().map(of).max().unwrap_or(0).max(1);
    let (columns, rows) = (most(DotMatrix::columns).div_ceil(2), most(DotMatrix::rows).div_ceil(4));
    let mut meta = element("dc:title", words.title);
    if !words.description.is_empty() && words.description_language == words.language {
        meta += &element("dc:description", words.description);
    }
    if is_language(words.language) {
        meta += &element("dc:language", words.language);
    }
    let mut body = format!(r#"<volume cols="{columns}" rows="{rows}" rowgap="0" duplex="false">"#);
    let text: Vec<String> = words.text.iter().flat_map(|line| rows_of(line, columns)).collect();
    if !text.is_empty() {
        let pages = text.chunks(rows).map(|page| {
            let rows: String = page.iter().map(|row| format!("<row>{row}</row>\n")).collect();
            format!("\n<page>\n{rows}</page>")
        });
        body += &format!("<section>{}\n</section>", pages.collect::<String>());
    }
    body += "<section>";
    if pages.is_empty() {
        body += "\n<page/>";
    }
    for page in pages {
        body += "\n<page>\n";
        for cy in 0..page.rows().div_ceil(4) {
            let row: String = (0..page.columns().div_ceil(2)).map(|cx| ubrl::character(page.cell8(cx, cy))).collect();
            body += &format!("<row>{row}</row>\n");
        }
        body += "</page>";
    }
    body += "\n</section></volume>";
    let number = seal::of([meta.as_bytes(), body.as_bytes()].concat().as_slice());
    let document = format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<pef version="2008-1" xmlns="http://www.daisy.org/ns/2008/pef">
<head><meta xmlns:dc="http://purl.org/dc/elements/1.1/">
<dc:format>application/x-pef+xml</dc:format>
<dc:identifier>tactograph-{number}</dc:identifier>
{meta}</meta></head>
<body>
{body}
</body>
</pef>
"#
    );
    let seal = seal::comment(document.as_bytes());
    document + &seal
}

/// A line of braille in rows of so many cells, cut at its blanks where it can be.
fn rows_of(line: &str, columns: usize) -> Vec<String> {
    const BLANK: char = '\u{2800}';
    let mut rows = Vec::new();
    let mut rest: Vec<char> = line.trim_end_matches(BLANK).chars().collect();
    while rest.len() > columns {
        let end = rest[..=columns].iter().rposition(|&cell| cell == BLANK);
        let is_indent = |at: &usize| rest[..*at].iter().all(|&cell| cell == BLANK);
        let end = end.filter(|at| !is_indent(at)).unwrap_or(columns);
        rows.push(rest.drain(..end).collect());
        rest.drain(..rest.iter().take_while(|&&cell| cell == BLANK).count());
    }
    rows.push(rest.into_iter().collect());
    rows
}

/// Whether these bytes are a document as [`write()`] makes it, changed by nobody since.
pub fn is_as_written(bytes: &[u8]) -> bool {
    seal::is_commented(bytes)
}

/// An element of text, on a line of its own.
fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>\n", Text::new(plain(text)))
}

/// Whether XML takes this for a language: one to eight letters, then parts of one to eight letters or digits.
fn is_language(tag: &str) -> bool {
    tag.split('-').enumerate().all(|(i, part)| {
        let of_language = |byte: u8| byte.is_ascii_alphabetic() || i > 0 && byte.is_ascii_digit();
        (1..=8).contains(&part.len()) && part.bytes().all(of_language)
    })
}

#[cfg(test)]
mod tests;
