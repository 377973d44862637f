//! A picture on several sheets: laid by their ticks they show one picture, and each can be told by touch.

use std::sync::Arc;

use crate::common::samples;
use tactograph::internals::geom::nearest_on_segment;
use tactograph::internals::page::spread::SheetGrid;
use tactograph::internals::page::{Page, Run};
use tactograph::internals::pipeline::sheets::{Sheets, convert};
use tactograph::internals::pipeline::{Event, Fit, Request, Stage, Watch};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::units::{MmPoint, MmRect, MmVector};
use tactograph::{Error, Note};

/// The profile's own.
const OVERLAP: f32 = 15.0;
const ROUNDING: f32 = 1e-3;

fn sheets_of(
    name: &str,
    grid: &str,
    settings: &[(&str, &str)],
    fit: Fit,
    watch: &mut Watch<'_>,
) -> Result<Sheets, Error> {
    let bytes = samples::read(name);
    let mut profile = Profile::named("swell-a4").expect("built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("the test sets what there is"));
    let plan = Plan::new(&profile).expect("the settings make sense together");
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request {
        plan: &plan,
        limits: Default::default(),
        fonts: &fonts,
        title: name,
        language: "en",
        fit,
        cancelled: &|| false,
    };
    let grid: Option<SheetGrid> = (grid != "fewest").then(|| grid.parse().expect("a grid"));
    convert(&bytes, &Default::default(), &Default::default(), grid, &request, watch)
}

#[test]
fn a_width_larger_than_the_sheet_takes_the_fewest_sheets() {
    let wide = |width| Fit { width: Some(width), ..Fit::default() };
    let no_overview = [("overview", "false")];
    let number = |width| {
        sheets_of("landscape.svg", "fewest", &no_overview, wide(width), &mut |_| ()).expect("there is room").pages.len()
    };
    let (small, large) = (number(250.0), number(700.0));
    assert!((2..=4).contains(&small) && small < large, "{small} and {large} sheets");
    // with one sheet less in any arrangement there is no room
    for grid in SheetGrid::by_number().filter(|grid| grid.sheets().count() < large) {
        let refused = sheets_of("landscape.svg", &grid.to_string(), &no_overview, wide(700.0), &mut |_| ());
        assert!(matches!(refused, Err(Error::TooWide { .. } | Error::NoRoomOnSheets { .. })), "{grid} has room");
    }
    let refused = sheets_of("landscape.svg", "fewest", &no_overview, wide(1e6), &mut |_| ());
    assert!(matches!(refused, Err(Error::TooWide { .. })), "81 sheets have no room for a kilometre");
}

fn sheets(name: &str, grid: &str, settings: &[(&str, &str)]) -> Sheets {
    sheets_of(name, grid, settings, Fit::default(), &mut |_| ()).expect("there is room")
}

fn stands(tick: &&Run) -> bool {
    (tick.points[0].x - tick.points[1].x).abs() < ROUNDING
}

/// How the second sheet has to be moved so that the ticks of both meet: those at the right of the first and at the left
/// of the second, or at the bottom and at the top. Gives the way and the middle of the overlap on the first.
fn laid(first: &Page, second: &Page, beside: bool) -> (MmVector, f32) {
    let along = |at: MmPoint| if beside { at.x } else { at.y };
    let ticks = |page: &Page, last: bool| -> Vec<Vec<MmPoint>> {
        let of_side = page.registration.iter().filter(|tick| stands(tick) == beside);
        let all: Vec<&Run> = of_side.collect();
        let wanted = all.iter().map(|tick| along(tick.points[0])).fold(None, |best: Option<f32>, at| {
            Some(best.map_or(at, |best| if last { best.max(at) } else { best.min(at) }))
        });
        let wanted = wanted.expect("there are ticks");
        let chosen = all.iter().filter(|tick| (along(tick.points[0]) - wanted).abs() < ROUNDING);
        chosen.map(|tick| tick.points.clone()).collect()
    };
    let (here, there) = (ticks(first, true), ticks(second, false));
    assert_eq!((here.len(), there.len()), (2, 2), "a tick on both sides of the picture");
    let way = here[0][0] - there[0][0];
    for (here, there) in here.iter().flatten().zip(there.iter().flatten()) {
        assert!((*here - (*there + way)).length() < ROUNDING, "ticks do not meet: {here:?} {there:?}");
    }
    (way, along(here[0][0]))
}

/// Everything on a page as small pieces: places that must be on the other sheet as well.
struct Ink {
    dots: Vec<MmPoint>,
    lines: Vec<(MmPoint, MmPoint, f32)>,
}

fn ink(page: &Page, way: MmVector) -> Ink {
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs).map(|glyph| glyph.at);
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
    Ink {
        dots: glyphs.chain(page.frame.at.iter().copied()).map(|at| at + way).collect(),
        lines: runs.flat_map(|run| run.polyline().segments().map(|(a, b)| (*a + way, *b + way, run.width))).collect(),
    }
}

/// Checks that what `one` has between two places along an axis, `other` has too; gives how much there was.
fn covered(one: &Ink, other: &Ink, within: impl Fn(MmPoint) -> bool) -> (usize, usize) {
    let (mut dots, mut places) = (0, 0);
    for at in one.dots.iter().filter(|at| within(**at)) {
        dots += 1;
        assert!(
            other.dots.iter().any(|dot| (*dot - *at).length() < ROUNDING),
            "a glyph at {at:?} is on one sheet only"
        );
    }
    for &(a, b, width) in &one.lines {
        let steps = ((b - a).length() / 0.25).ceil().max(1.0) as u32;
        for at in (0..=steps).map(|k| a.lerp(b, k as f32 / steps as f32)).filter(|at| within(*at)) {
            places += 1;
            let near = other.lines.iter().filter(|line| (line.2 - width).abs() < ROUNDING);
            let distance = near.map(|line| nearest_on_segment(at, line.0, line.1).0).fold(f32::MAX, f32::min);
            assert!(distance < 0.01, "a line at {at:?} is {distance} mm from the same on the other sheet");
        }
    }
    (dots, places)
}

#[test]
fn sheets_laid_by_their_ticks_agree_in_the_overlap() {
    for (name, swell) in [("coffee.png", "0"), ("landscape.svg", "0.2")] {
        let drawn = sheets(name, "2x2", &[("print.swell", swell)]);
        assert!(drawn.overview.is_some(), "{name}: no overview");
        assert_eq!(drawn.pages.len(), 4, "{name}");
        let pages = &drawn.pages;
        for (first, second, beside) in [(0, 1, true), (2, 3, true), (0, 2, false), (1, 3, false)] {
            let (way, middle) = laid(&pages[first], &pages[second], beside);
            let (here, there) = (ink(&pages[first], MmVector::zero()), ink(&pages[second], way));
            // A mark that crosses the edge of a window is on one sheet only: at the edges of the overlap that is right.
            let half = 0.5 * OVERLAP - 2.0;
            // Ends of the overlap lie at the windows' other edges, beyond which each sheet has its own.
            let shown =
                |page: &Page, way: MmVector| MmRect::new(page.figure.place.min + way, page.figure.place.max + way);
            let both = shown(&pages[first], MmVector::zero()).union(&shown(&pages[second], way));
            let within = |at: MmPoint| {
                let (along, inside) = if beside {
                    (at.x, at.y > both.min.y + 2.0 && at.y < both.max.y - 2.0)
                } else {
                    (at.y, at.x > both.min.x + 2.0 && at.x < both.max.x - 2.0)
                };
                (along - middle).abs() < half && inside
            };
            let (dots, places) = covered(&here, &there, within);
            assert_eq!(covered(&there, &here, within).0, dots, "{name}");
            assert!(dots > 20 && places > 20, "{name}: nothing to compare: {dots} {places}");
        }
    }
}

/// Parts of a sheet stay within its margins and clear of one another, so that each can be told by touch.
#[test]
fn marks_keep_their_distance() {
    for (grid, settings) in [("2x2", &[][..]), ("3x1", &[("frame", "false")]), ("1x2", &[("mark", "false")])] {
        let drawn = sheets("coffee.png", grid, settings);
        for page in &drawn.pages {
            let [width, height] = page.sheet;
            let inner = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(width - 10.0, height - 10.0));
            let label = &page.labels[0];
            let mut marks: Vec<(String, Vec<MmPoint>, f32)> =
                vec![("label".into(), label.at.clone(), 0.5 * label.diameter)];
            marks.extend(page.orientation_mark.iter().map(|run| ("mark".into(), along(run), 0.5 * run.width)));
            let ticks = page.registration.iter().enumerate();
            marks.extend(ticks.map(|(i, run)| (format!("tick {i}"), along(run), 0.5 * run.width)));
            let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
            let mut picture: Vec<(MmPoint, f32)> =
                runs.flat_map(|run| run.points.iter().map(|&at| (at, 0.5 * run.width))).collect();
            picture.extend(page.frame.at.iter().map(|&at| (at, 0.5 * page.frame.diameter)));
            for (i, (name, places, radius)) in marks.iter().enumerate() {
                for at in places {
                    let inside = inner.inflate(ROUNDING - radius, ROUNDING - radius).contains_inclusive(*at);
                    assert!(inside, "{grid}: {name} leaves the margins at {at:?}");
                    let blank = |to: MmPoint, its: f32| (to - *at).length() - its - radius;
                    let near = picture.iter().map(|&(to, its)| blank(to, its)).fold(f32::MAX, f32::min);
                    assert!(near >= 3.2 - 0.01, "{grid}: {name} is {near} mm from the picture");
                    for (other, theirs, its) in &marks[..i] {
                        let near = theirs.iter().map(|&to| blank(to, *its)).fold(f32::MAX, f32::min);
                        assert!(near >= 3.2 - 0.01, "{grid}: {name} is {near} mm from {other}");
                    }
                }
            }
            for (at, radius) in picture {
                assert!(inner.inflate(ROUNDING - radius, ROUNDING - radius).contains_inclusive(at), "{grid}: {at:?}");
            }
        }
    }
}

fn along(run: &Run) -> Vec<MmPoint> {
    (0..=40).map(|k| run.points[0].lerp(run.points[1], k as f32 / 40.0)).collect()
}

/// Widths and gaps are those of the finger on every sheet; the picture is what grows.
#[test]
fn more_sheets_make_the_picture_larger_and_nothing_else() {
    let widest = |drawn: &Sheets| {
        let runs = drawn.pages.iter().flat_map(|page| &page.figure.lines).flat_map(|line| &line.runs);
        runs.map(|run| run.width).fold(0.0, f32::max)
    };
    let total = |drawn: &Sheets, columns: usize| {
        let row = &drawn.pages[..columns];
        let widths: f32 = row.iter().map(|page| page.figure.place.width()).sum();
        widths - OVERLAP * (columns - 1) as f32
    };
    let (two, three) = (sheets("coffee.png", "2x2", &[]), sheets("coffee.png", "3x3", &[]));
    assert!((widest(&two) - widest(&three)).abs() < ROUNDING);
    assert!(total(&three, 3) > 1.4 * total(&two, 2));
    let names: Vec<&str> = two.all().map(|page| page.title.as_str()).collect();
    let sheet = |name: &str| format!("coffee.png, sheet {name}");
    assert_eq!(names[0], "coffee.png, overview");
    assert_eq!(names[1..], [sheet("a1"), sheet("a2"), sheet("b1"), sheet("b2")]);
    // the labels differ and are read from left to right: the letter, the number sign, the digit
    let labels: Vec<_> = two.pages.iter().map(|page| page.labels[0].at.len()).collect();
    assert_eq!(labels, [1 + 4 + 1, 1 + 4 + 2, 2 + 4 + 1, 2 + 4 + 2]);
}

#[test]
fn what_the_sheets_do_not_need_is_not_done() {
    let mut skipped = Vec::new();
    let settings = [("overview", "false"), ("figure.textures", "false")];
    let drawn = sheets_of("portrait.svg", "2x1", &settings, Fit::default(), &mut |event| {
        if let Event::Skip(stage, _) = event {
            skipped.push(stage);
        }
    })
    .expect("there is room");
    assert_eq!(skipped, [Stage::Text, Stage::Regions, Stage::Overview, Stage::Classes, Stage::Textures]);
    assert_eq!((drawn.overview.is_some(), drawn.pages.len()), (false, 2));
    assert!(drawn.pages.iter().all(|page| page.figure.textures.is_empty() && page.overview.is_none()));
}

#[test]
fn widths_that_fit_are_kept_and_others_refused() {
    let wide = |width| Fit { width: Some(width), ..Fit::default() };
    let drawn = sheets_of("coffee.png", "2x2", &[], wide(280.0), &mut |_| ()).expect("there is room");
    let widths: f32 = drawn.pages[..2].iter().map(|page| page.figure.place.width()).sum();
    assert!((widths - OVERLAP - 280.0).abs() < 0.01, "{widths}");
    let fault = sheets_of("coffee.png", "2x2", &[], wide(900.0), &mut |_| ()).expect_err("too wide");
    assert!(matches!(fault, Error::TooWide { .. }), "{fault}");
    let narrow = [("page.margin", "80"), ("sheets.overlap", "60")];
    let fault = sheets_of("coffee.png", "2x2", &narrow, Fit::default(), &mut |_| ()).expect_err("no room");
    assert!(matches!(fault, Error::NoRoomOnSheets { .. }), "{fault}");
}

#[test]
fn an_empty_picture_is_told_once() {
    let drawn = sheets("empty.png", "2x2", &[]);
    assert_eq!(drawn.notes, [Note::EmptyPage]);
    assert!(!drawn.pages.is_empty() && drawn.all().all(Page::is_empty));
}

/// A square picture does not reach the outer two of four sheets in a row: the inner two have no ticks towards them.
#[test]
fn ticks_stand_where_there_is_a_sheet_to_lay_on() {
    let pages = sheets("bars.svg", "9x1", &[("overview", "false")]).pages;
    assert!(pages.len() < 9, "the picture reaches all nine sheets");
    let upright = |page: &Page| page.registration.iter().filter(stands).count();
    let (first, last) = (&pages[0], &pages[pages.len() - 1]);
    assert_eq!((upright(first), upright(last)), (2, 2), "one side only");
    assert!(pages[1..pages.len() - 1].iter().all(|page| upright(page) == 4), "both sides");
}
