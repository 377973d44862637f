//! Contours as data: they lie where they are in the source picture, whatever size it was worked on.

use std::sync::Arc;

use crate::common::{page, samples};
use tactograph::internals::contours::{Polyline, Trace};
use tactograph::internals::note::Note;
use tactograph::internals::output::json;
use tactograph::internals::pipeline::Given;
use tactograph::internals::pipeline::trace::trace;
use tactograph::internals::pipeline::{Event, Request, Stage, Watch};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::decode::Limits;
use tactograph::internals::units::{PxPoint, Size};
use tactograph::internals::{lines, units};
use tactograph::{Error, Options, Position, Traced, Tracing};

/// Everything that can be traced.
fn all() -> [Tracing; 3] {
    [Tracing::contours(), Tracing::contours_at_full_resolution(), Tracing::lines()]
}

fn plan() -> Plan {
    Plan::new(&Profile::named("swell-a4").expect("built in")).expect("built-in profiles make sense")
}

fn try_trace(picture: &[u8], tracing: Tracing, limits: Limits, watch: &mut Watch<'_>) -> Result<Traced, Error> {
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request {
        plan: &plan(),
        limits,
        fonts: &fonts,
        title: "",
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    trace(picture, &tracing, &Given::default(), &request, watch)
}

fn traced(picture: &[u8], tracing: Tracing) -> Trace {
    try_trace(picture, tracing, Limits::default(), &mut |_| ()).expect("the picture can be traced").trace
}

/// A picture of one byte a pixel.
fn png(size: Size, value: impl Fn(u32, u32) -> u8) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.width, size.height);
    encoder.set_color(png::ColorType::Grayscale);
    let values = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y))).map(|(x, y)| value(x, y));
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&values.collect::<Vec<_>>()).expect("the pixels");
    writer.finish().expect("the end");
    bytes
}

/// A disc of grey 150 on grey 90, so near one another that the middle of a mixture is the middle of the step in lightness.
#[derive(Clone, Copy)]
struct Disc {
    size: Size,
    middle: [f64; 2],
    radius: f64,
}

impl Disc {
    /// Each pixel is mixed by how much of 16 x 16 places in it lies on the disc.
    fn png(self) -> Vec<u8> {
        let [cx, cy] = self.middle;
        png(self.size, |x, y| {
            let place = |pixel: u32, i: u32| f64::from(pixel) + (f64::from(i) + 0.5) / 16.0;
            let is_inside = |i: u32| (place(x, i % 16) - cx).hypot(place(y, i / 16) - cy) < self.radius;
            let from_rim = (place(x, 8) - cx).hypot(place(y, 8) - cy) - self.radius;
            let covered = match from_rim {
                2.0.. => 0,
                ..-2.0 => 256,
                _ => (0..256).filter(|&i| is_inside(i)).count(),
            };
            (90.0 + 60.0 * covered as f64 / 256.0).round() as u8
        })
    }

    /// How far a point lies from its rim.
    fn error(self, at: PxPoint) -> f64 {
        let [cx, cy] = self.middle;
        ((f64::from(at.x) - cx).hypot(f64::from(at.y) - cy) - self.radius).abs()
    }

    /// Its contour, when it is the only one, is closed and lies within `tolerance` px of its rim.
    #[track_caller]
    fn is_traced(self, trace: &Trace, tolerance: f64, spacing: f32) {
        assert_eq!(trace.size, self.size);
        let [polyline] = &trace.polylines[..] else { panic!("{} contours", trace.polylines.len()) };
        assert!(polyline.closed, "the contour is not closed");
        let (first, last) = (polyline.points[0], polyline.points[polyline.points.len() - 1]);
        assert!(first != last, "the first point is repeated");
        let steps = polyline.points.windows(2).map(|two| (two[1] - two[0]).length());
        let widest = steps.chain([(last - first).length()]).fold(0.0, f32::max);
        assert!(widest < spacing, "a gap of {widest} px");
        let worst = polyline.points.iter().map(|&at| self.error(at)).fold(0.0, f64::max);
        assert!(worst < tolerance, "{worst} px off");
    }
}

/// Smaller than the page's working picture.
const SMALL: Disc = Disc { size: Size::new(300, 200), middle: [150.3, 99.6], radius: 60.2 };
/// Worked on at little more than half its size, whose sides are rounded to whole pixels.
const LARGE: Disc = Disc { size: Size::new(1601, 1003), middle: [930.4, 450.7], radius: 307.3 };

#[test]
fn a_disc_is_traced_where_it_lies() {
    SMALL.is_traced(&traced(&SMALL.png(), Tracing::contours_at_full_resolution()), 0.1, 3.0);
    SMALL.is_traced(&traced(&SMALL.png(), Tracing::contours()), 0.1, 3.0);
    let large = LARGE.png();
    LARGE.is_traced(&traced(&large, Tracing::contours_at_full_resolution()), 0.1, 3.0);
    LARGE.is_traced(&traced(&large, Tracing::contours()), 0.5, 6.0);
}

#[test]
fn strength_is_the_height_of_the_step_at_either_resolution() {
    // CIELAB lightness of the two greys
    let height = 62.1 - 38.2;
    for (disc, subject) in [
        (SMALL, Tracing::contours_at_full_resolution()),
        (LARGE, Tracing::contours_at_full_resolution()),
        (LARGE, Tracing::contours()),
        (LARGE, Tracing::lines()),
    ] {
        let trace = traced(&disc.png(), subject);
        assert_eq!(trace.polylines.len(), 1);
        for polyline in &trace.polylines {
            assert_eq!(polyline.strength.len(), polyline.points.len());
            for &strength in &polyline.strength {
                assert!((strength - height).abs() < 0.08 * height, "{strength} for a step of {height}");
            }
        }
    }
}

/// The quarters red, green, blue and grey in pictures that were stored turned, as shown by the strength of the four arms of
/// the cross between them.
#[test]
fn a_picture_is_upright_before_it_is_traced() {
    let arms = |number: u32| {
        let file = format!("{}/tests/pictures/orient-{number}.jpg", env!("CARGO_MANIFEST_DIR"));
        let trace = traced(&std::fs::read(file).expect("a test picture"), Tracing::contours_at_full_resolution());
        assert_eq!(trace.size, Size::new(64, 32), "orientation {number}");
        let points = trace.polylines.iter().flat_map(|line| line.points.iter().zip(&line.strength));
        let points = points.collect::<Vec<_>>();
        for (at, _) in &points {
            // at the crossing itself the contour cuts the corner
            let off = (at.x - 32.0).abs().min((at.y - 16.0).abs());
            let from_middle = (at.x - 32.0).hypot(at.y - 16.0);
            assert!(off < 0.1 || from_middle < 4.0, "orientation {number}: {at:?} lies on no border");
        }
        [(32.0, 8.0), (32.0, 24.0), (16.0, 16.0), (48.0, 16.0)].map(|(x, y)| {
            let there = points.iter().filter(|(at, _)| (at.x - x).hypot(at.y - y) < 3.0).map(|(_, s)| **s);
            let there = there.collect::<Vec<_>>();
            assert!(there.len() > 3, "orientation {number}: no border at {x}, {y}");
            there.iter().sum::<f32>() / there.len() as f32
        })
    };
    let upright = arms(1);
    let [top, bottom, left, right] = upright;
    let apart = |a: f32, b: f32| (a / b - 1.0).abs() > 0.1;
    assert!(apart(top, bottom) && apart(left, right), "the arms would not show a turn: {upright:?}");
    for number in 2..=8 {
        for (turned, upright) in arms(number).iter().zip(upright) {
            assert!((turned / upright - 1.0).abs() < 0.02, "orientation {number}: {turned} instead of {upright}");
        }
    }
}

fn length(trace: &Trace) -> f32 {
    let steps = |line: &Polyline| line.points.windows(2).map(|two| (two[1] - two[0]).length()).sum::<f32>();
    trace.polylines.iter().map(steps).sum()
}

#[test]
fn higher_thresholds_leave_less() {
    let photo = samples::read("rocket.jpg");
    for subject in all() {
        let mut last = f32::INFINITY;
        for (low, high) in [(0.0, 0.0), (0.0, 6.0), (3.0, 6.0), (6.0, 6.0), (6.0, 20.0), (20.0, 40.0), (900.0, 900.0)] {
            let tracing = subject.thresholds(low, high).expect("they make sense");
            let Traced { trace, notes, .. } =
                try_trace(&photo, tracing, Limits::default(), &mut |_| ()).expect("a trace");
            let length = length(&trace);
            // What is nearer to its contour than to another takes its place, so lines may gain a little.
            let slack = if subject == Tracing::lines() { 1.1 } else { 1.0 };
            assert!(length <= last * slack, "{subject:?} {low},{high}: {length} px after {last} px");
            assert_eq!(notes.contains(&Note::NoContours), low > 100.0, "{subject:?} {low},{high}: {notes:?}");
            last = length;
        }
    }
}

#[test]
fn thresholds_that_make_no_sense_cannot_be_made() {
    let bad = [(3.0, 2.0), (-1.0, 2.0), (-2.0, -1.0), (f32::NAN, 1.0), (1.0, f32::NAN), (1.0, f32::INFINITY)];
    assert!(bad.iter().all(|&(low, high)| Tracing::contours().thresholds(low, high).is_err()));
}

#[test]
fn the_lines_are_those_of_the_page() {
    for name in ["coffee.png", "rocket.jpg", "bars.svg"] {
        let picture = samples::read(name);
        let figure = &page::of_sample(name, "swell-a4").page.figure;
        let trace = traced(&picture, Tracing::lines());
        assert_eq!(trace.size, figure.source);
        assert_eq!(trace.polylines.len(), figure.lines.len(), "{name}");
        assert!(!figure.lines.is_empty(), "{name}: nothing to compare");
        let to_mm = units::PageTransform::new(figure.source, figure.place);
        for (polyline, line) in trace.polylines.iter().zip(&figure.lines) {
            is_the_same_line(polyline, line, |at| to_mm.to_mm(at), name);
            let mean = polyline.strength.iter().sum::<f32>() / polyline.strength.len() as f32;
            assert!((0.5..2.0).contains(&(mean / line.strength)), "{name}: {mean} instead of {}", line.strength);
        }
    }
}

/// Walks a line of the page piece by piece: each must be in the polyline, at its place and with its width.
fn is_the_same_line(
    polyline: &Polyline,
    line: &lines::Line,
    to_mm: impl Fn(PxPoint) -> tactograph::internals::units::MmPoint,
    name: &str,
) {
    let (points, widths) = (&polyline.points, polyline.width_mm.as_ref().expect("lines have widths"));
    assert_eq!((points.len(), points.len()), (widths.len(), polyline.strength.len()));
    let mut from = 0;
    for run in &line.runs {
        for (i, at) in run.polyline().path().enumerate() {
            let there = to_mm(points[(from + i) % points.len()]);
            // Rounding of the working picture's shorter side, 0.5 px of 5 px in a mm.
            assert!((there - *at).length() < 0.11, "{name}: {there:?} instead of {at:?}");
        }
        from += run.polyline().segment_count();
        let pieces = &widths[from - run.polyline().segment_count()..from];
        assert!(pieces.iter().all(|width| width.to_bits() == run.width.to_bits()), "{name}: {pieces:?}");
    }
    assert_eq!(from + usize::from(!polyline.closed), points.len(), "{name}: not all of the line");
    let (first, last) = (line.runs.first().expect("a run"), line.runs.last().expect("a run"));
    assert_eq!(polyline.closed, first.closed || first.points.first() == last.points.last(), "{name}");
}

#[test]
fn only_what_is_needed_is_done() {
    let stages = |picture: &[u8], tracing: Tracing| {
        let (mut ran, mut skipped) = (Vec::new(), Vec::new());
        let watch = &mut |event| match event {
            Event::End(stage) => ran.push(stage),
            Event::Skip(stage, why) => skipped.push((stage, why)),
            _ => (),
        };
        let notes = try_trace(picture, tracing, Limits::default(), watch).expect("a trace").notes;
        (ran, skipped, notes)
    };
    let disc = SMALL.png();
    let of_drawing = vec![(Stage::Regions, "the picture is a drawing")];
    assert_eq!(
        stages(&disc, Tracing::contours_at_full_resolution()),
        (vec![Stage::Decode, Stage::Text, Stage::Edges], of_drawing.clone(), vec![])
    );
    let to_lines = vec![Stage::Decode, Stage::Text, Stage::Edges, Stage::Lines];
    assert_eq!(stages(&disc, Tracing::lines()), (to_lines, of_drawing, vec![]));
    let flat = png(Size::new(60, 40), |_, _| 90);
    for subject in all() {
        let (ran, skipped, notes) = stages(&flat, subject);
        assert_eq!((ran, notes), (vec![Stage::Decode], vec![Note::NoContours]));
        let of_one_colour =
            [Stage::Text, Stage::Edges, Stage::Regions].map(|stage| (stage, "the picture is of one colour"));
        assert_eq!(skipped[..3], of_one_colour);
        let no_lines = [(Stage::Lines, "there are no contours")];
        assert_eq!(skipped[3..], no_lines[..usize::from(subject == Tracing::lines())]);
        let Trace { size, polylines, .. } = traced(&flat, subject);
        assert_eq!((size, polylines), (Size::new(60, 40), vec![]));
    }
}

#[test]
fn limits_hold_at_full_resolution() {
    let fault = |picture: &[u8], limits| {
        try_trace(picture, Tracing::contours_at_full_resolution(), limits, &mut |_| ())
            .map(|traced| traced.trace)
            .expect_err("a fault")
    };
    let narrow = png(Size::new(300, 7), |x, _| x as u8);
    assert!(matches!(fault(&narrow, Limits::default()), Error::TooFewPixels { .. }));
    // Too narrow for a page, but not for its pixels.
    let stripe = png(Size::new(2000, 9), |x, _| if x < 1000 { 60 } else { 200 });
    assert_eq!(traced(&stripe, Tracing::contours_at_full_resolution()).polylines.len(), 1);
    assert!(try_trace(&stripe, Tracing::contours(), Limits::default(), &mut |_| ()).is_err());
    let large = png(Size::new(1200, 1000), |x, _| x as u8);
    assert!(matches!(fault(&large, Limits { megapixels: 1, ..Limits::default() }), Error::TooManyPixels { .. }));
    // The page's working picture would fit.
    let limits = Limits { memory_mb: 25, ..Limits::default() };
    assert!(matches!(fault(&large, limits), Error::TooMuchMemory { .. }));
    assert!(try_trace(&large, Tracing::contours(), limits, &mut |_| ()).is_ok());
    assert!(matches!(fault(b"", Limits::default()), Error::Empty));
}

#[test]
fn the_same_picture_gives_the_same_file() {
    let photo = samples::read("coffee.png");
    for subject in all() {
        let once = json::write(&traced(&photo, subject));
        assert!(once == json::write(&traced(&photo, subject)), "{subject:?}");
        assert!(once.is_ascii() && once.ends_with("]}\n"));
    }
}

#[test]
fn lines_are_those_of_the_page_around_its_subject() {
    let photo = samples::read("coffee.png");
    let at = |percent: f64| Position::percent(percent).expect("a number");
    let plain = Options::new(Profile::named("swell-a4").expect("built in"));
    let calm = plain.clone().subject(at(40.0), at(20.0)).calm_background(true);
    let lines = |options: &Options| tactograph::trace(&photo[..], &Tracing::lines(), options).expect("a trace");
    let on_page = tactograph::convert(&photo[..], &calm).expect("a page").page.figure.lines.len();
    let (plain, calm) = (lines(&plain), lines(&calm));
    assert_eq!(calm.trace.polylines.len(), on_page);
    assert!(on_page < plain.trace.polylines.len(), "{on_page} lines");
    assert!(calm.notes.iter().any(|note| matches!(note, Note::Subject { is_first: true, .. })), "{:?}", calm.notes);
}

/// Another program's reader finds in the file what the trace holds, to the last digit that is promised.
#[test]
fn the_file_can_be_read() {
    let trace = traced(&LARGE.png(), Tracing::lines());
    let read: serde_json::Value = serde_json::from_str(&json::write(&trace)).expect("JSON");
    assert_eq!(read["image"], serde_json::json!([1601, 1003]));
    let polylines = read["polylines"].as_array().expect("a list");
    assert_eq!(polylines.len(), trace.polylines.len());
    let near = |read: &serde_json::Value, value: f32, within: f64| {
        assert!((read.as_f64().expect("a number") - f64::from(value)).abs() <= within, "{read} for {value}");
    };
    for (read, polyline) in polylines.iter().zip(&trace.polylines) {
        assert_eq!(read["closed"], polyline.closed);
        let [points, strength, width] =
            ["points", "strength", "width_mm"].map(|name| read[name].as_array().expect("a list"));
        assert_eq!([points.len(), strength.len(), width.len()], [polyline.points.len(); 3]);
        for (i, at) in polyline.points.iter().enumerate() {
            near(&points[i][0], at.x, 0.000_500_1);
            near(&points[i][1], at.y, 0.000_500_1);
            near(&strength[i], polyline.strength[i], 0.005_001);
            near(&width[i], polyline.width_mm.as_ref().expect("widths")[i], 0.005_001);
        }
    }
}
