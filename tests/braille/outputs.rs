//! Braille in each output: its measures to 0.05 mm as the file has them, its words as text, and what `check` says.

use super::{percent, reading};
use crate::common::samples;
use crate::dots::reading as dots;
use crate::pdf::reader::{Mark, Reader};
use std::collections::BTreeSet;
use tactograph::internals::braille::CellSize;
use tactograph::internals::page::cells::CellGrid;
use tactograph::marks::TextRole;
use tactograph::medium::{DotArea, Medium};
use tactograph::{
    Checked, DotFormat, Drawing, Fonts, KeySheets, Label, MmPoint, Options, Page, PageOptions, Profile, check, convert,
    write_dots,
};

const TITLE: &str = "Trees, 12 of them";

fn drawn(profile: &str, settings: &[(&str, &str)]) -> Drawing {
    let mut profile = Profile::named(profile).expect("it is built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("a setting"));
    let at = |x, y, text: &str| Label { x: percent(x), y: percent(y), text: text.to_owned() };
    let labels = vec![at(80.0, 60.0, "fir tree"), at(50.0, 87.0, "pond")];
    let options = Options::new(profile).fonts(Fonts::system()).title(TITLE).labels(labels);
    convert(&samples::read("landscape.svg"), &options.key(KeySheets::Always).page_number(12)).expect("a page")
}

/// Dots that a file has for a text, nearest to where the page has them, all of them and none off by more than 0.05 mm.
fn found(page: &Page, in_file: &[MmPoint], size: CellSize, name: &str) {
    for text in &page.braille {
        let near = |at: &MmPoint| {
            let off = |dot: &&MmPoint| (**dot - *at).length();
            *in_file.iter().min_by(|a, b| off(a).total_cmp(&off(b))).expect("dots")
        };
        let dots: Vec<MmPoint> = text.dots.at.iter().map(near).collect();
        let off = dots.iter().zip(&text.dots.at).map(|(a, b)| (*a - *b).length()).fold(0.0, f32::max);
        assert!(off < 0.05, "{name}: a dot of \"{}\" lies {off} mm off", text.text);
        let lines = reading::lines(&dots, size);
        let written: Vec<&str> = text.lines.iter().map(|line| line.trim_start_matches('\u{2800}')).collect();
        assert_eq!(lines, written, "{name}: {}", text.text);
    }
}

/// The measures that a page of dots has in place of the usual ones.
fn size_on(page: &Page) -> CellSize {
    CellGrid::of(&page.medium, CellSize::MARBURG).size()
}

/// The sheets of a drawing with their words: the figure and the key.
fn sheets(drawing: &Drawing) -> impl Iterator<Item = &Page> {
    std::iter::once(&drawing.page).chain(&drawing.key)
}

/// The centres of the discs in the layers of braille of a PDF of one sheet.
fn discs_of_pdf(reader: &Reader) -> Vec<MmPoint> {
    let mut centres = Vec::new();
    for mark in reader.marks(reader.only("/Type/Page/")) {
        let is_braille = mark.layer().starts_with("Braille");
        if let Mark::Fill { subpaths, .. } = mark
            && is_braille
        {
            centres.extend(subpaths.iter().map(|disc| {
                let middle = |axis: usize| {
                    let (least, most) = (disc.iter().map(|p| p[axis]).min(), disc.iter().map(|p| p[axis]).max());
                    (least.expect("points") + most.expect("points")) as f32 / 200.0
                };
                MmPoint::new(middle(0), middle(1))
            }));
        }
    }
    centres
}

/// The centres of the discs in the groups of braille of an SVG.
fn discs_of_svg(svg: &str) -> Vec<MmPoint> {
    let document = roxmltree::Document::parse(svg).expect("a page is well-formed");
    let groups = document.descendants().filter(|node| node.has_attribute("data-braille"));
    let paths = groups.flat_map(|group| group.descendants()).filter_map(|node| node.attribute("d"));
    let number = |text: &str| text.parse::<f32>().expect("a number");
    // each disc is M left,middle a radius ...; a leader line has no arc
    let discs = paths.flat_map(|path| path.split('M').skip(1)).filter_map(|disc| disc.split_once('a'));
    let centre = |(start, arc): (&str, &str)| {
        let (x, y) = start.split_once(',').expect("a point");
        let radius = number(arc.split(' ').next().expect("a radius"));
        MmPoint::new(number(x) + radius, number(y))
    };
    discs.map(centre).collect()
}

/// Title, labels, key and page numbers have the measures that are asked for, in the SVG and in the PDF: discs in their
/// layers, hundredths of a millimetre. The PDF has the words as well.
#[test]
fn files_have_standard_cells_and_their_words() {
    for size in CellSize::ALL {
        let drawing = drawn("swell-a4", &[("braille.cell", size.name)]);
        let roles: BTreeSet<TextRole> = sheets(&drawing).flat_map(|page| &page.braille).map(|text| text.role).collect();
        assert_eq!(roles, BTreeSet::from(TextRole::ALL), "{}", size.name);
        for page in sheets(&drawing) {
            found(page, &discs_of_svg(&page.to_svg()), size, &format!("SVG, {}", size.name));
            let reader = Reader::new(&page.to_pdf());
            found(page, &discs_of_pdf(&reader), size, &format!("PDF, {}", size.name));
            let words = reader.words(reader.only("/Type/Page/"));
            for text in &page.braille {
                assert!(words.contains(&text.spoken()), "{}: {} is not in the PDF: {words:?}", size.name, text.text);
            }
        }
    }
}

/// In the file for a grid of dots, each cell stands on whole dots, where the page has it.
#[test]
fn a_file_of_dots_has_the_cells_of_its_grid() {
    for profile in ["index-basic-d", "viewplus-columbia"] {
        let drawing = drawn(profile, &[]);
        for page in sheets(&drawing) {
            let Medium::Dots(medium) = &page.medium else { panic!("{profile} is printed") };
            let DotArea::Grid(grid) = &medium.area else { panic!("{profile} has no grid") };
            let file = String::from_utf8(page.to_dots(DotFormat::Ubrl).expect("its format")).expect("Unicode");
            let matrix = dots::ubrl(&file).remove(0);
            let all = (0..grid.rows.len()).flat_map(|y| (0..grid.columns.len()).map(move |x| (x, y)));
            let raised = all.filter(|&(x, y)| matrix.is_raised(x, y));
            let in_file: Vec<MmPoint> = raised.map(|(x, y)| MmPoint::new(grid.columns[x], grid.rows[y])).collect();
            found(page, &in_file, size_on(page), profile);
        }
    }
}

/// On a machine that takes dots anywhere, its G-code has them where the page has them.
#[test]
fn gcode_has_standard_cells() {
    let page = drawn("braillerap", &[]).page;
    let gcode = String::from_utf8(page.to_dots(DotFormat::Gcode).expect("its format")).expect("ASCII");
    // a move and then the needle goes down
    let moves = gcode.lines().zip(gcode.lines().skip(1)).filter(|(_, next)| next.starts_with("M3 S1"));
    let all: Vec<MmPoint> = moves
        .filter_map(|(line, _)| {
            let (x, y) = line.strip_prefix("G1 X")?.trim_end().trim_end_matches(';').split_once(" Y")?;
            Some(MmPoint::new(x.parse().ok()?, y.parse().ok()?))
        })
        .collect();
    // the machine counts from a corner of its own
    let shift = tactograph::MmRect::from_points(&all).min - page_dots(&page).min;
    let moved: Vec<MmPoint> = all.iter().map(|at| *at - shift).collect();
    found(&page, &moved, size_on(&page), "braillerap");
}

/// The box around all dots of a page.
fn page_dots(page: &Page) -> tactograph::MmRect {
    let dots = tactograph::internals::output::dots::dots(page);
    tactograph::MmRect::from_points(dots.into_iter().map(|(at, _)| at))
}

/// Text cells: a BRF file has the title, the page numbers and all of the key as text.
#[test]
fn a_file_of_cells_has_title_and_key_as_text() {
    let drawing = drawn("braille-cells", &[("figure.textures", "true")]);
    let pages: Vec<Page> = std::iter::once(drawing.page).chain(drawing.overview).chain(drawing.key).collect();
    assert!(pages.len() > 1);
    let files = write_dots(TITLE, &pages, DotFormat::Brf, Default::default()).expect("its format");
    let text: String = files.into_iter().map(|file| unicode_of_brf(&String::from_utf8(file).expect("ASCII"))).collect();
    for said in pages.iter().flat_map(|page| &page.braille) {
        for line in &said.lines {
            assert!(text.contains(line.trim_matches('\u{2800}')), "{} is missing", said.text);
        }
    }
}

/// Among cells the page number has a blank one before the orientation mark, whose dots are cells too.
#[test]
fn a_page_number_among_cells_keeps_off_the_mark() {
    let drawing = drawn("braille-cells", &[]);
    let files = write_dots(TITLE, &[drawing.page], DotFormat::Brf, Default::default()).expect("its format");
    let text = unicode_of_brf(&String::from_utf8(files[0].clone()).expect("ASCII"));
    let first = text.lines().next().expect("a line").trim_end_matches('\u{2800}');
    let words: Vec<&str> = first.split('\u{2800}').filter(|word| !word.is_empty()).collect();
    let number = words.iter().rposition(|word| word.starts_with('\u{283c}')).expect("the sign of a number");
    assert_eq!(number + 2, words.len(), "the mark stands by itself behind it: {first}");
}

fn unicode_of_brf(file: &str) -> String {
    let mut text = String::new();
    for matrix in dots::brf(file) {
        for y in 0..matrix.rows() / 3 {
            let cell = |x: usize| char::from_u32(0x2800 + u32::from(matrix.cell6(x, y))).expect("a cell");
            text.extend((0..matrix.columns() / 2).map(cell));
            text.push('\n');
        }
    }
    text
}

fn has(checked: &Checked, rule: &str, words: &str) -> bool {
    checked.findings.iter().any(|finding| finding.rule.id == rule && finding.to_string().contains(words))
}

/// What somebody may do to braille in an editor is found: a label moved on to a line, another size, a dot lost.
#[test]
fn faults_of_braille_are_found() {
    let drawing = drawn("swell-a4", &[]);
    let svg = drawing.page.to_svg();
    let good = check(&svg, &PageOptions::new()).expect("it can be read");
    for rule in ["braille-gap", "braille-cell"] {
        assert!(!has(&good, rule, ""), "{good}");
    }
    let with = |id: &str, transform: &str| {
        let changed = svg.replacen(&format!("id=\"{id}\""), &format!("id=\"{id}\" transform=\"{transform}\""), 1);
        assert_ne!(svg, changed, "{id}");
        check(changed, &PageOptions::new()).expect("it can be read")
    };
    let label = drawing.page.braille.iter().find(|text| text.text == "pond").expect("a label");
    let (at, line) = (label.dots.at[0], &drawing.page.figure.lines[0].runs[0].points);
    let onto = line[line.len() / 2] - at;
    let number =
        1 + drawing.page.braille.iter().filter(|text| text.lines != label.lines && text.role == label.role).count();
    let id = format!("braille-labels-{number}");
    let moved = with(&id, &format!("translate({},{})", onto.x, onto.y));
    assert!(has(&moved, "braille-gap", "\"pond\""), "{moved}");
    for scale in ["scale(1.1)", "scale(0.93,1)"] {
        assert!(has(&with("braille-title-1", scale), "braille-cell", "the title"), "{scale}");
    }
    let onto_title = with("braille-page-number-1", "translate(-40,0)");
    assert!(has(&onto_title, "braille-gap", "page number"), "{onto_title}");
    // a dot less
    let title = svg.find("braille-title-1").expect("the title");
    let dot = title + svg[title..].find(" d=\"M").expect("its dots") + 4;
    let end = dot + svg[dot + 1..].find('M').expect("a second dot") + 1;
    let lost = check([&svg[..dot], &svg[end..]].concat(), &PageOptions::new()).expect("it can be read");
    assert!(has(&lost, "braille-cell", "the title has"), "{lost}");
}

/// Page numbers stand at the top on the right, apart from the title and the mark, and go on from sheet to sheet.
#[test]
fn sheets_have_their_numbers() {
    for profile in ["swell-a4", "index-basic-d", "viewplus-columbia", "braille-cells", "pins-120x60", "braillerap"] {
        let drawing = drawn(profile, &[]);
        let sheets: Vec<&Page> = std::iter::once(&drawing.page).chain(&drawing.overview).chain(&drawing.key).collect();
        assert!(sheets.len() > 1, "{profile}");
        for (number, page) in (12..).zip(sheets) {
            let text = page.braille.iter().find(|text| text.role == TextRole::Number);
            let text = text.unwrap_or_else(|| panic!("{profile}: sheet {number} has no number"));
            assert_eq!(text.text, number.to_string());
            let size = size_on(page);
            let read = reading::lines(&text.dots.at, size);
            assert_eq!(read, text.lines, "{profile}");
            assert_eq!(super::back::english(&read[0]), number.to_string(), "{profile}");
            let place = tactograph::MmRect::from_points(&text.dots.at);
            for other in page.braille.iter().filter(|other| other.role != text.role) {
                let right = other.dots.at.iter().map(|at| at.x).fold(0.0, f32::max);
                let top = other.dots.at.iter().map(|at| at.y).fold(f32::MAX, f32::min);
                let is_beside = top < place.max.y + 1.0;
                assert!(!is_beside || right + 3.0 * size.cell < place.min.x, "{profile}: {} is too near", other.text);
                assert!(top > place.min.y - 2.0 * size.dot - 0.1, "{profile}: {} is above the number", other.text);
            }
            for mark in page.orientation_mark.iter().flat_map(|mark| &mark.points) {
                let near = (*mark - mark.clamp(place.min, place.max)).length();
                assert!(near > 3.0, "{profile}: the mark is {near} mm from the number");
            }
        }
    }
    // a number alone, without a title
    let options = Options::new(Profile::named("swell-a4").expect("built in")).page_number(7);
    let page = convert(&samples::read("bars.svg"), &options).expect("a page").page;
    assert_eq!(page.braille.iter().map(|text| text.text.as_str()).collect::<Vec<_>>(), ["7"]);
    assert!(check(page.to_svg(), &PageOptions::new()).expect("read").errors() == 0);
}

/// A title that has no room in the middle of a row beside the page number begins on the left.
#[test]
fn a_title_has_room_beside_the_page_number_of_a_display() {
    let profile = Profile::named("dot-pad").expect("it is built in");
    let options = Options::new(profile).title("Animal cell").page_number(12);
    let drawing = convert(&samples::read("cell.svg"), &options).expect("a page");
    let written = |role: TextRole| drawing.page.braille.iter().find(|text| text.role == role);
    let title = written(TextRole::Title).unwrap_or_else(|| panic!("no title: {:?}", drawing.notes));
    let number = written(TextRole::Number).expect("a number");
    assert_eq!((title.lines.len(), number.text.as_str()), (1, "12"));
    let side = |dots: &[MmPoint], of: fn(f32, f32) -> f32| dots.iter().map(|at| at.x).reduce(of).expect("dots");
    let between = side(&number.dots.at, f32::min) - side(&title.dots.at, f32::max);
    assert!(between > 3.0 * CellSize::MARBURG.cell, "{between} mm");
    assert_eq!(check(drawing.page.to_svg(), &PageOptions::new()).expect("read").errors(), 0);
}

/// In PEF title and key stand in front of the pages of dots as text, as wide as these at most.
#[test]
fn a_pef_has_title_and_key_as_text() {
    let drawing = drawn("index-basic-d", &[]);
    let pages: Vec<Page> = [&drawing.page].into_iter().chain(&drawing.overview).chain(&drawing.key).cloned().collect();
    let files = write_dots("Trees", &pages, DotFormat::Pef, Default::default()).expect("a PEF");
    let text = String::from_utf8(files[0].clone()).expect("XML");
    let document = roxmltree::Document::parse(&text).expect("XML");
    let sections: Vec<_> = document.descendants().filter(|node| node.has_tag_name("section")).collect();
    assert_eq!(sections.len(), 2);
    let rows_in = |section: &roxmltree::Node<'_, '_>| -> Vec<String> {
        let rows = section.descendants().filter(|node| node.has_tag_name("row"));
        rows.map(|row| row.text().unwrap_or_default().to_owned()).collect()
    };
    let of = |section: usize| sections[section].children().filter(|node| node.has_tag_name("page")).count();
    assert_eq!(of(1), pages.len());
    let written = rows_in(&sections[0]);
    let title = pages[0].braille.iter().find(|text| text.text == TITLE).expect("a title");
    assert_eq!(written[..title.lines.len()], title.lines);
    let key = drawing.key.iter().flat_map(|page| &page.braille).filter(|text| text.role == TextRole::Key);
    let key: Vec<String> = key.flat_map(|text| text.lines.clone()).collect();
    assert!(key.len() > 2 && written[title.lines.len()].is_empty(), "{written:?}");
    let trimmed: Vec<&str> = key.iter().map(|line| line.trim_end_matches('\u{2800}')).collect();
    assert_eq!(written[title.lines.len() + 1..], trimmed);
    // without words there is no such section
    let plain =
        convert(&samples::read("landscape.svg"), &Options::new(Profile::named("index-basic-d").expect("built in")));
    let plain = plain.expect("a page").page.to_dots(DotFormat::Pef).expect("a PEF");
    let plain = String::from_utf8(plain).expect("XML");
    assert_eq!(plain.matches("<section>").count(), 1);
}
