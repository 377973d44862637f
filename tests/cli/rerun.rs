//! A page that a person corrected, given to a new conversion of its picture: the decisions stay.

use crate::cli::common::*;
use crate::cli::render::{done, read, reading, signs, with_page};
use crate::common::samples;
use tactograph::MmPoint;
use tactograph::internals::geom::nearest_on_segment;
use tactograph::internals::page::{Class, Page};
use tactograph::marks::{Line, Pen, Run};
use tactograph_tools::correction;

/// The page without the object of this id.
fn without(svg: &str, id: &str) -> String {
    let document = roxmltree::Document::parse(svg).expect("a page is well-formed");
    let object = document.descendants().find(|node| node.attribute("id") == Some(id)).expect("the object is there");
    format!("{}{}", &svg[..object.range().start], &svg[object.range().end..])
}

#[test]
fn an_area_that_was_deleted_stays_blank_and_the_others_stay_as_they_are() {
    let place = with_page("swell-a4");
    let before = read(&place, "cup.svg");
    place.put("edited.svg", without(&place.text("cup.svg"), "region-2").as_bytes());
    let edited = read(&place, "edited.svg").figure.textures.clone();
    let gone = before.figure.textures.iter().find(|texture| !edited.contains(texture)).expect("one less");
    let far = |axis: fn(&MmPoint) -> f32| {
        let places = || gone.glyphs.iter().map(move |glyph| axis(&glyph.at));
        [places().fold(f32::MAX, f32::min), places().fold(f32::MIN, f32::max)]
    };
    let ([left, right], [top, bottom]) = (far(|at| at.x), far(|at| at.y));
    let within = [left, top, right, bottom];
    // all signs of its class in its box are its own
    assert_eq!((signs(&before, gone.class, within), gone.glyphs.len() > 50), (gone.glyphs.len(), true));
    let again = |edited: &str, new: &str| {
        done(&place, &["convert", "cup.png", "--regions", edited, "--no-overview", "-o", new]);
        read(&place, new)
    };
    let (unchanged, after) = (again("cup.svg", "same.svg"), again("edited.svg", "new.svg"));
    assert_eq!(signs(&after, gone.class, within), 0);
    let sheet = [0.0, 0.0, 297.0, 297.0];
    for class in Class::ALL {
        let own = |page: &Page| if class == gone.class { signs(page, class, within) } else { 0 };
        let others = |page: &Page| signs(page, class, sheet) - own(page);
        let (was, same, is) = (others(&before), others(&unchanged), others(&after));
        assert!(same.abs_diff(is) as f32 <= 0.02 * same as f32, "{class:?}: {is} signs in place of {same}");
        // borders of two colours within an outline are smoother than those of the picture, and leave room for a few more
        assert!(was.abs_diff(is) as f32 <= 0.08 * was as f32, "{class:?}: {is} signs in place of {was} at first");
    }
}

/// How far a place is from the middle of the nearest stroke or dot of a line, mm.
fn off_lines(at: MmPoint, page: &Page) -> f32 {
    let of_run = |run: &Run| match run.pen {
        Pen::Stroke => {
            let segments = run.path().zip(run.path().skip(1));
            segments.map(|(a, b)| nearest_on_segment(at, a, b).0).fold(f32::MAX, f32::min)
        }
        // one row may have several pieces
        Pen::Dots(_) => run.points.iter().map(|dot| (*dot - at).length()).fold(f32::MAX, f32::min),
    };
    page.figure.lines.iter().flat_map(|line| &line.runs).map(of_run).fold(f32::MAX, f32::min)
}

/// The lines of a page that another one has not.
fn only_on<'a>(page: &'a Page, other: &Page) -> Vec<&'a Line> {
    page.figure.lines.iter().filter(|line| !other.figure.lines.contains(line)).collect()
}

/// All stages of the correction of the docs: with other numbers, and for an embosser.
#[test]
fn a_correction_survives_other_paper_other_detail_and_an_embosser() {
    let place = Place::new();
    place.put("coffee.png", &samples::read("coffee.png"));
    done(&place, &["convert", "coffee.png", "-o", "cup.svg"]);
    let stages = correction::stages(&place.text("cup.svg")).expect("it is the page of the sample");
    let [made, cleared, redrawn, .., last] = &stages[..] else { panic!("{} stages", stages.len()) };
    let [made, cleared, redrawn] = [made, cleared, redrawn].map(|stage| reading(&stage.svg));
    place.put("edited.svg", last.svg.as_bytes());
    let edited = reading(&last.svg);
    // of the clutter, what has no other line near it
    let points = |lines: Vec<&Line>| -> Vec<MmPoint> {
        lines.into_iter().flat_map(|line| &line.runs).flat_map(|run| run.points.iter().copied()).collect()
    };
    let mut clutter = points(only_on(&made, &cleared));
    clutter.retain(|at| off_lines(*at, &edited) > 4.0);
    let saucer = points(only_on(&redrawn, &cleared));
    assert!(clutter.len() > 10 && saucer.len() > 3, "{} and {} points", clutter.len(), saucer.len());
    for (options, most_off) in [
        (&["--profile", "swell-a3", "--detail", "0.9"][..], 1.0),
        (&["--profile", "swell-letter", "--detail", "0.2"], 1.0),
        (&["--profile", "index-basic-d"], 2.0),
    ] {
        let args = ["convert", "coffee.png", "--lines", "edited.svg", "--regions", "edited.svg", "--no-overview"];
        let told = done(&place, &[&args[..], options, &["--force", "-o", "new.svg"]].concat());
        let new = read(&place, "new.svg");
        let (from, to) = (edited.figure.place, new.figure.place);
        let there = |at: MmPoint| to.min + (at - from.min) * (to.width() / from.width());
        let is_there = |at: &MmPoint| off_lines(there(*at), &new) <= most_off;
        let come_back: Vec<&MmPoint> = clutter.iter().filter(|at| is_there(at)).collect();
        assert!(come_back.is_empty(), "{options:?}: {come_back:?} {told}");
        let drawn = saucer.iter().filter(|at| is_there(at)).count();
        assert!(drawn * 10 >= saucer.len() * 9, "{options:?}: {drawn} of {} points {told}", saucer.len());
        let in_box = |class, [left, top, right, bottom]: [f32; 4]| {
            let [low, high] = [there(MmPoint::new(left, top)), there(MmPoint::new(right, bottom))];
            signs(&new, class, [low.x, low.y, high.x, high.y])
        };
        // the table at the left, which was yellow, and the cloth on it
        let (table, cloth) = ([21.0, 84.0, 40.0, 118.0], [25.0, 130.0, 46.0, 146.0]);
        assert!(in_box(Class::Red, table) > 10 && in_box(Class::Yellow, table) == 0, "{options:?}: {told}");
        assert!(in_box(Class::Blue, cloth) > 5 && in_box(Class::Red, cloth) == 0, "{options:?}: {told}");
    }
}
