//! Pages, layers and lists that somebody else wrote, and files of dots.

use tactograph::internals::output::dots::{DocumentWords, DotMatrix, brf, pef, text, ubrl};
use tactograph::{Error, Format, Label, Options, PageOptions, Picture, Position, Profile, RenderOptions};

use super::is_clear;
use crate::dot_reading as reading;

/// A picture of two colours, RGBA, 24 px a side.
const SIDE: u32 = 24;

fn square() -> Vec<u8> {
    let red = |i: u32| (6..18).contains(&(i % SIDE)) && (6..18).contains(&(i / SIDE));
    (0..SIDE * SIDE).flat_map(|i| if red(i) { [200, 20, 20, 255] } else { [255; 4] }).collect()
}

fn options() -> Options {
    Options::new(Profile::named("swell-a4").expect("it is built in"))
}

/// A page is read, and what is written of it is read again; what its file says of itself, too.
pub(super) fn page(bytes: &[u8]) {
    match tactograph::render(bytes, &RenderOptions::new()) {
        Ok(drawing) => {
            let svg = drawing.page.to_svg();
            let again = tactograph::render(&svg, &RenderOptions::new())
                .unwrap_or_else(|fault| panic!("what is written: {fault}"));
            assert!(again.page.to_svg() == svg, "a page changes when it is rendered twice");
            assert!(!drawing.page.to_pdf().is_empty());
            if let Err(fault) = tactograph::describe(bytes, &PageOptions::new()) {
                is_clear(&fault);
            }
        }
        Err(fault) => is_clear(&fault),
    }
    for name in ["svg", "pdf", "png", "pef", "gcode"] {
        let _ = Format::named(name).is_ok_and(|format| format.is_as_written(bytes).is_some());
    }
}

/// A page, or any drawing, is held against the rules.
pub(super) fn check(bytes: &[u8]) {
    match tactograph::check(bytes, &PageOptions::new()) {
        Ok(checked) => {
            let told = checked.to_string();
            let marked = checked.marked(bytes).unwrap_or_else(|fault| panic!("it was read before: {fault}"));
            assert!(!told.is_empty() && roxmltree_reads(&marked), "a marked page that is no XML");
            let is_json = |text: &str| serde_json::from_str::<serde_json::Value>(text).is_ok();
            // names of files are any bytes on most systems
            let name = String::from_utf8_lossy(bytes);
            assert!(is_json(&checked.to_json()) && is_json(&checked.to_sarif(&name)), "findings that are no JSON");
        }
        Err(fault) => is_clear(&fault),
    }
}

fn roxmltree_reads(text: &str) -> bool {
    let options = usvg::roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    usvg::roxmltree::Document::parse_with_options(text, options).is_ok()
}

/// Lines of a person for a picture, added and in place of those that are found; and areas.
pub(super) fn lines(bytes: &[u8]) {
    let square = square();
    type Give = fn(Options, &[u8]) -> Result<Options, tactograph::Error>;
    let given: [Give; 3] = [|to, bytes| to.lines(bytes), |to, bytes| to.add_lines(bytes), |to, bytes| to.areas(bytes)];
    for give in given {
        let drawn = give(options(), bytes).and_then(|options| {
            let picture = Picture::rgba8(SIDE, SIDE, &square)?;
            tactograph::convert(picture, &options)
        });
        if let Err(fault) = drawn {
            is_clear(&fault);
        }
    }
}

/// A list of labels; few of them are put on a page.
pub(super) fn labels(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Label::from_csv(text) {
        Ok(labels) => {
            let square = square();
            let few = labels.into_iter().take(8).collect();
            let picture = Picture::rgba8(SIDE, SIDE, &square).expect("so many bytes");
            if let Err(fault) = tactograph::convert(picture, &options().labels(few)) {
                is_clear(&fault);
            }
        }
        Err(Error::NotLabels(faults)) => {
            assert!(!faults.is_empty() && faults.iter().all(|fault| !fault.contains('\n')), "{faults:?}")
        }
        Err(other) => panic!("{other:?}"),
    }
}

/// Any words as title, description and label, in the language that the first byte says; the page is read again.
pub(super) fn words(bytes: &[u8]) {
    let Some((first, rest)) = bytes.split_first() else { return };
    let Ok(text) = std::str::from_utf8(rest) else { return };
    let languages: Vec<&str> = Options::languages().collect();
    let language = languages[usize::from(*first) % languages.len()];
    let middle = Position::percent(50.0).expect("a number of percent");
    let label = Label { x: middle, y: middle, text: text.to_owned() };
    let square = square();
    let picture = Picture::rgba8(SIDE, SIDE, &square).expect("so many bytes");
    let options = options().language(language).title(text).description(text).labels(vec![label]);
    match tactograph::convert(picture, &options) {
        Ok(drawing) => {
            for page in std::iter::once(&drawing.page).chain(&drawing.key) {
                let svg = page.to_svg();
                assert!(roxmltree_reads(&svg), "a page that is no XML");
                if let Err(fault) = tactograph::render(&svg, &RenderOptions::new()) {
                    panic!("a page is not read: {fault}");
                }
            }
            drawing.notes.iter().for_each(|note| assert!(!note.to_string().trim().is_empty(), "{note:?}"));
        }
        Err(fault) => is_clear(&fault),
    }
}

/// Pages of any dots, written in the formats that can be read back: two bytes say how large the first page is, each bit
/// after them is a dot, and what is left over is the next page.
pub(super) fn dots(bytes: &[u8]) {
    let mut pages = Vec::new();
    let mut rest = bytes;
    while let [columns, rows, dots @ ..] = rest {
        let (columns, rows) = (usize::from(columns % 48), usize::from(rows % 48));
        let mut page = reading::matrix(columns, rows);
        let is_raised = |i: usize| dots.get(i / 8).is_some_and(|byte| byte >> (i % 8) & 1 == 1);
        (0..columns * rows)
            .filter(|&i| is_raised(i))
            .for_each(|i| page.raise(i % columns, i / columns, 1 + (i % 3) as u8));
        rest = dots.get((columns * rows).div_ceil(8)..).unwrap_or_default();
        pages.push(page);
    }
    let raised = |page: &DotMatrix| -> Vec<(usize, usize)> {
        let all = (0..page.rows()).flat_map(|y| (0..page.columns()).map(move |x| (x, y)));
        all.filter(|&(x, y)| page.is_raised(x, y)).collect()
    };
    let want: Vec<_> = pages.iter().map(raised).collect();
    let drawn = text::write(&pages);
    for (name, back) in [
        ("ubrl", reading::ubrl(&ubrl::write(&pages))),
        ("brf", reading::brf(&brf::write(&pages))),
        ("txt", drawn.split_terminator('\u{c}').map(reading::drawn).collect()),
    ] {
        assert!(back.iter().map(raised).eq(want.iter().cloned()), "{name}: other dots come back");
    }
    let title = String::from_utf8_lossy(bytes);
    let words = DocumentWords { title: &title, description: &title, language: &title, ..DocumentWords::default() };
    assert!(roxmltree_reads(&pef::write(&pages, &words)), "PEF that is no XML");
}
