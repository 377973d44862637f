//! Tests of pages that are read: made by hand, so that each number can be seen.

use super::*;
use crate::units::MmPoint;
use crate::{PageOptions, RenderOptions};

/// A page with these lines, and other elements beside its figure.
fn page(lines: &str, beside: &str) -> String {
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='210mm' height='297mm' viewBox='0 0 210 297'>\
         <style>.none {{ display: none }}</style><g id='figure' data-box='20 20 160 200'>\
         <g id='lines' fill='none' stroke='#000' stroke-width='1'>{lines}</g></g>{beside}</svg>"
    )
}

fn reading(lines: &str, beside: &str) -> Reading {
    read(page(lines, beside).as_bytes()).expect("it is a page")
}

/// What texts say, and where they stand.
fn places(read: &Reading) -> Vec<(&str, f32, f32)> {
    let round = |mm: f32| (100.0 * mm).round() / 100.0;
    read.texts.iter().map(|text| (text.string.as_str(), round(text.at.x), round(text.at.y))).collect()
}

fn told(notes: &[Note]) -> String {
    notes.iter().map(|note| format!("{note}\n")).collect()
}

#[test]
fn elements_of_one_id_are_as_many_things() {
    let texts = "<g id='labels-text'><text id='t' x='30' y='40'>one</text><text id='t' x='150' y='60'>two</text></g>";
    assert_eq!(places(&reading("", texts)), [("one", 30.0, 40.0), ("two", 150.0, 60.0)]);
    let lines = "<path d='M30,30h40' id='line-1'/><path style='filter:url(#a)' id='line-1' d='M30,60h50'/>";
    let read = reading(lines, "");
    assert_eq!(read.names.lines, ["line 1 (\"line-1\")", "line 1 (copy 2, with the same id)"]);
    let ends: Vec<f32> = read.page.figure.lines.iter().map(|line| line.runs[0].points[1].x).collect();
    assert_eq!(ends, [70.0, 80.0]);
}

#[test]
fn texts_that_clones_show_are_read() {
    let clone = "<defs><text id='tt' x='50' y='50'>\u{2813}</text></defs><use href='#tt' x='10' y='5'/>";
    assert_eq!(places(&reading("", clone)), [("\u{2813}", 60.0, 55.0)]);
    let group = "<g id='g' transform='translate(1 2)'><text x='40' y='40'>\u{2813}</text></g>\
                 <use href='#g' transform='translate(0 100)' x='20'/><use href='#g' opacity='0'/>";
    let read = reading("", group);
    assert_eq!(places(&read), [("\u{2813}", 41.0, 42.0), ("\u{2813}", 61.0, 142.0)]);
    assert_eq!((read.page.figure.lines.len(), told(&read.notes).as_str()), (0, ""), "its mark is no mark");
    // clones of one another have no end
    assert!(super::read(page("", "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>").as_bytes()).is_err());
}

#[test]
fn a_hidden_text_is_hidden_to_all() {
    let text = |how: &str| format!("<g id='labels-text'><text x='50' y='50' {how}>Hat</text></g>");
    let letters = |svg: &str| {
        let checked = crate::check(svg, &PageOptions::new()).expect("it is a page");
        checked.findings.iter().filter(|finding| finding.rule.id == "letters").count()
    };
    for how in ["class='none'", "opacity='0'", "visibility='hidden'", "style='display: none'", "style='opacity:0'"] {
        let read = reading("", &text(how));
        assert_eq!((places(&read), read.letters.len(), told(&read.notes)), (vec![], 0, String::new()), "{how}");
        assert_eq!(letters(&page("", &text(how))), 0, "{how}");
    }
    for how in ["", "style='fill:none;filter:url(#gone)'", "visibility='visible'"] {
        assert_eq!(places(&reading("", &text(how))), [("Hat", 50.0, 50.0)], "{how}");
        assert_eq!(letters(&page("", &text(how))), 1, "{how}");
    }
    let around = format!("<g visibility='hidden'>{}</g>", text("visibility='visible'"));
    assert_eq!(reading("", &around).letters.len(), 1);
}

/// Each of two texts that say the same has its own place and line among the findings.
#[test]
fn findings_of_equal_texts_have_their_own_places() {
    let texts = "<text x='50' y='50'>Hat</text>\n<text x='90' y='70' transform='translate(1)'>Hat</text>";
    let checked = crate::check(page("", texts), &PageOptions::new()).expect("it is a page");
    let letters = checked.findings.iter().filter(|finding| finding.rule.id == "letters");
    let found: Vec<_> = letters.map(|finding| (finding.at.expect("a place"), finding.line)).collect();
    assert_eq!(found, [(MmPoint::new(50.0, 50.0), Some(1)), (MmPoint::new(91.0, 70.0), Some(2))]);
}

#[test]
fn braille_stands_at_its_anchor() {
    let dots = |anchor: &str| {
        let word = "\u{283f}".repeat(8);
        let text = format!("<text x='100' y='120' style='text-anchor:{anchor}'>{word}</text>");
        let made = crate::render(page("", &text), &RenderOptions::new()).expect("it is a page").page;
        made.braille[0].dots.bounds().expect("it has dots")
    };
    let [start, middle, end] = ["start", "middle", "end"].map(dots);
    let near = |a: f32, b: f32| (a - b).abs() < 2.5;
    assert!(near(start.min.x, 100.0) && near(middle.center().x, 100.0) && near(end.max.x, 100.0), "{middle:?}");
    assert!((start.min.x - middle.min.x - (middle.min.x - end.min.x)).abs() < 0.1 && start.width() > 40.0);
}

/// Braille is wider than print: a word typed around its middle names the box that is there, and not one where its
/// braille would begin.
#[test]
fn a_typed_word_names_the_box_in_which_it_stands() {
    let boxes = "<path d='M50,80h40v12h-40z'/><path d='M110,80h40v12h-40z'/>";
    let word = "<g id='labels-text'><text x='130' y='87' style='text-anchor:middle'>Caterpillar</text></g>";
    let made = crate::render(page(boxes, word), &RenderOptions::new()).expect("it is a page");
    let label = &made.page.braille[0];
    let points = &label.leader.as_ref().expect("no box has room for it").points;
    let tip = points[points.len() - 1];
    assert!((110.0..150.0).contains(&tip.x) && (80.0..92.0).contains(&tip.y), "{points:?}");
    let told = told(&made.notes);
    assert!(told.contains("written in braille beside its place, with a leader line to it"), "{told}");
}

const SHAPE: &str = "<path d='M80,240h6v4l-2,2h-4z' stroke='none' fill='#000'/>";

#[test]
fn a_filled_shape_becomes_a_line_of_its_layer() {
    let overview = format!("<g id='overview' data-box='60 230 40 50'>{SHAPE}</g>");
    let page = reading("", &overview).page;
    let overview = page.overview.as_ref().expect("it has one");
    assert_eq!((page.figure.lines.len(), overview.lines.len()), (0, 1));
    assert!(overview.lines[0].runs[0].closed && overview.lines[0].runs[0].points.len() == 5);
    assert_eq!(reading(SHAPE, "").page.figure.lines.len(), 1);
}

#[test]
fn a_line_around_a_shape_is_as_wide_as_most_lines() {
    let width =
        |lines: &str| reading(&format!("{lines}{SHAPE}"), "").page.figure.lines.last().map(|of| of.runs[0].width);
    let line = |length: u32, width: f32| format!("<path d='M30,{length}h{length}' stroke-width='{width}'/>");
    assert_eq!(width(""), Some(1.0));
    assert_eq!(width(&line(60, 1.5)), Some(1.5));
    assert_eq!(width(&(line(60, 0.8) + &line(50, 0.8) + &line(90, 2.0))), Some(0.8));
}

#[test]
fn areas_without_a_texture_are_told_by_their_reasons() {
    let areas = "<rect x='60' y='60' width='6' height='6' fill='#00f'/>\
                 <rect x='185' y='260' width='20' height='20' fill='#f00'/>\
                 <rect x='90' y='60' width='6' height='6' fill='#00f'/>";
    let notes = crate::render(page("", areas), &RenderOptions::new()).expect("it is a page").notes;
    let told = told(&notes);
    assert!(told.contains("2 drawn areas (the first at 63, 63 mm), too small for a texture"), "{told}");
    assert!(told.contains("1 drawn area (the first at 195, 270 mm), outside the figure"), "{told}");
}

#[test]
fn the_orientation_mark_is_the_one_in_the_corner() {
    let (own, other) = ("<path d='M190,10l10,10'/>", "<path d='M100,30h10'/>");
    for marks in [[own, other], [other, own]] {
        let marks = format!("<g id='orientation-mark' stroke='#000' fill='none'>{}</g>", marks.concat());
        let Reading { page, notes, .. } = reading("", &marks);
        let mark = page.orientation_mark.as_ref().expect("it has one");
        assert_eq!(mark.points, [MmPoint::new(190.0, 10.0), MmPoint::new(200.0, 20.0)]);
        assert_eq!((page.figure.lines.len(), page.registration.len()), (1, 0));
        assert_eq!(page.figure.lines[0].runs[0].points[0], MmPoint::new(100.0, 30.0));
        let told = told(&notes);
        assert!(told.contains("1 more mark (the first at 100, 30 mm) in the layer of the orientation mark"), "{told}");
        assert!(!told.contains("outside of the layers"), "{told}");
    }
}

/// What the check finds on a page with these lines, by rule.
fn found(lines: &str, beside: &str, rule: &str) -> Vec<String> {
    let checked = crate::check(page(lines, beside), &PageOptions::new()).expect("it is a page");
    checked.findings.iter().filter(|finding| finding.rule.id == rule).map(|finding| finding.what.clone()).collect()
}

#[test]
fn two_ends_are_a_broken_line_whichever_comes_first() {
    let (broad, thin) = ("<path d='M30,60h40' stroke-width='4'/>", "<path d='M78.6,60h40' stroke-width='0.8'/>");
    for lines in [[broad, thin], [thin, broad]] {
        let found = found(&lines.concat(), "", "broken-line");
        assert!(found.len() == 1 && found[0].contains("6.2 mm before one another"), "{found:?}");
    }
}

#[test]
fn a_broad_black_stroke_is_a_block() {
    let found = |width: &str| found(&format!("<path d='M60,60h90' stroke-width='{width}'/>"), "", "filled").len();
    assert_eq!([found("25"), found("7.5"), found("5")], [1, 1, 0]);
    // and one of an element that is scaled
    let scaled = "<path d='M6,6h9' transform='scale(10)' stroke-width='2.5'/>";
    assert_eq!(self::found(scaled, "", "filled").len(), 1);
}

#[test]
fn what_the_overview_lacks_is_named_once() {
    let lines = "<path id='a' d='M30,30h100M30,60h40'/><path id='b' d='M30,90h70'/>";
    let overview = "<g id='overview' data-box='60 230 40 50' fill='none' stroke='#000'><path d='M70,270h25'/></g>";
    let found = found(lines, overview, "overview-lacks");
    assert_eq!(found, ["the overview lacks 100 % of the lines of the figure: line \"a\", line \"b\""]);
}

#[test]
fn what_leaves_the_sheet_is_told_as_render_makes_it() {
    let found = |element: &str| found(element, "", "margin").into_iter().find(|what| what.contains("sheet"));
    let ends = |element: &str, end: &str| found(element).is_some_and(|what| what.ends_with(end));
    assert!(ends("<path d='M-20,60h80'/>", "render cuts it off at the edge"));
    assert!(ends("<path d='M-40,60h20'/>", "render leaves it out"));
}

/// What `render` takes as white or black is so for the check, too.
#[test]
fn render_and_check_know_one_black_and_one_white() {
    for (channels, lines, coloured) in [("f8f8f8", 0, 0), ("f7f7f7", 1, 1), ("101010", 1, 0), ("111111", 1, 1)] {
        let line = format!("<path d='M30,60h60' stroke='#{channels}'/>");
        assert_eq!(reading(&line, "").page.figure.lines.len(), lines, "{channels}");
        assert_eq!(found(&line, "", "black-only").len(), coloured, "{channels}");
    }
}

/// Tools that make files small leave out the metadata, and those for the web the size of the sheet.
#[test]
fn a_page_that_says_neither_how_it_was_made_nor_its_size_is_told() {
    const MADE: &str = "<metadata>profile = swell-a4\npage.width = 210\npage.height = 297\n</metadata>";
    const LINE: &str = "<path d='M30,30h40'/>";
    const SIZED: &str = "width='210mm' height='297mm' viewBox='0 0 210 297'";
    let ours = |root: &str, metadata: &str, marks: &str| {
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' {root}>{metadata}<g id='figure' data-box='20 20 160 200' \
             data-source='320 400'><g id='lines' fill='none' stroke='#000'>{marks}</g></g></svg>"
        );
        read(svg.as_bytes()).expect("it is a page")
    };
    let told = |root: &str, metadata: &str, marks: &str| told(&ours(root, metadata, marks).notes);
    assert_eq!(told(SIZED, MADE, LINE), "");
    let gone = told(SIZED, "", LINE);
    assert!(gone.contains("metadata are gone") && !gone.contains("all its marks are dots"), "{gone}");
    let dots = told(SIZED, "", "<circle cx='40' cy='40' r='0.75' fill='#000' stroke='none'/>");
    assert!(dots.contains("it looks like a page for an embosser"), "{dots}");
    for (root, metadata) in [
        ("viewBox='0 0 210 297'", MADE),
        ("width='100%' height='100%' viewBox='0 0 210 297'", MADE),
        ("viewBox='0 0 210 297'", ""),
        ("height='297mm' viewBox='0,0,210,297'", ""),
        // in points
        ("viewBox='0 0 595.28 841.89'", MADE),
    ] {
        assert_eq!(
            ours(root, metadata, LINE).page.sheet.map(f32::to_bits),
            [210.0_f32, 297.0].map(f32::to_bits),
            "{root}"
        );
        assert!(told(root, metadata, LINE).contains("taken as 210 x 297 mm"), "{root}");
    }
    let across = ours("viewBox='0 0 297 210'", MADE, "");
    assert_eq!(across.page.sheet.map(f32::to_bits), [297.0_f32, 210.0].map(f32::to_bits), "as the sheet lies");
    let checked = |profile: Option<&str>| {
        let named = profile.map(|name| crate::Profile::named(name).expect("it is built in"));
        let options = named.map_or_else(PageOptions::new, |profile| PageOptions::new().profile(profile));
        let svg = page(LINE, "").replace("data-box", "data-source='320 400' data-box");
        crate::check(svg, &options).expect("it is a page").notes
    };
    assert!(self::told(&checked(None)).contains("metadata are gone"));
    assert!(!self::told(&checked(Some("swell-a3"))).contains("metadata are gone"), "a profile is asked for");
}
