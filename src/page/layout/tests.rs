//! Where figure, overview, frames and heading lie on sheets of all kinds.

use super::*;
use crate::braille::{CellSize, Code};
use crate::geom::nearest_on_segment;
use crate::page::Run;
use crate::page::heading::{Align, HeadingParams};
use crate::units::MmPoint;

fn params() -> Params {
    Params {
        sheet: [210.0, 297.0],
        orientation: Orientation::Portrait,
        margin: 10.0,
        frame: Some(FrameParams { width: 3.0, dot: 0.8, pitch: 1.6, gap: 5.0 }),
        overview: Some(OverviewParams { scale: 0.4, gap: 12.0 }),
        mark: Some(MarkParams { length: 12.0, width: 2.0, gap: 5.0 }),
        heading: None,
        medium: MediumParams::Print(Print::default()),
    }
}

const ASPECTS: [f32; 9] = [0.05, 0.3, 0.7, 1.0, 1.1, 1.5, 1.8, 4.0, 20.0];

/// All combinations of having or not having the parts of a page.
fn all_params() -> impl Iterator<Item = Params> {
    (0..16).map(|i| {
        let mut params = params();
        params.frame = params.frame.filter(|_| i & 1 == 0);
        params.overview = params.overview.filter(|_| i & 2 == 0);
        params.mark = params.mark.filter(|_| i & 4 == 0);
        params.orientation = if i & 8 == 0 { Orientation::Portrait } else { Orientation::Landscape };
        params
    })
}

/// The outer edges of the frames, that of the figure first.
fn boxes(layout: &Layout, params: &Params) -> Vec<MmRect> {
    let border = params.frame.map_or(0.0, |frame| frame.width + frame.gap);
    [Some(layout.figure), layout.overview].into_iter().flatten().map(|place| place.inflate(border, border)).collect()
}

#[test]
fn the_widest_figure_upright_is_that_of_a_low_picture() {
    assert!((params().widest_upright() - 174.0).abs() < 1e-6);
    for params in all_params() {
        let upright = Params { orientation: Orientation::Portrait, ..params };
        assert!((fit(20.0, f32::MAX, &upright).figure.width() - params.widest_upright()).abs() < 1e-3);
    }
}

#[test]
fn a_larger_overview_fills_what_is_left_below_the_figure() {
    let params = params();
    let overview = |aspect: f32, most: f32| {
        let layout = fit(aspect, f32::MAX, &Params { orientation: Orientation::Portrait, ..params });
        let larger = layout.largest_overview(most, &params)?;
        let border = params.frame.map_or(0.0, |frame| frame.width + frame.gap);
        assert!(larger.max.y + border <= layout.sheet[1] - params.margin + 1e-3);
        assert!((larger.min.y - layout.overview.expect("there is one").min.y).abs() < 1e-6);
        Some(larger.width() / layout.figure.width())
    };
    assert!((overview(2.0, 0.5).expect("there is room") - 0.5).abs() < 0.01);
    assert_eq!(overview(0.7, 0.5), None, "the figure takes all the height that there is");
    assert_eq!(overview(2.0, 0.2), None, "the own one is as large");
    // as large as there is room for, below the figure and then beside
    assert!(overview(1.5, 2.0).is_some_and(|share| (0.5..0.99).contains(&share)));
    assert!(overview(4.0, 2.0).is_some_and(|share| (0.98..1.01).contains(&share)));
}

#[test]
fn everything_keeps_inside_the_margins_at_any_shape() {
    for params in all_params() {
        for aspect in ASPECTS {
            let layout = fit(aspect, f32::MAX, &params);
            let [width, height] = layout.sheet;
            let inner = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(width - 10.0, height - 10.0));
            for place in boxes(&layout, &params) {
                assert!(inner.inflate(0.01, 0.01).contains_box(&place), "{aspect}: {layout:?}");
            }
            for at in layout.mark.iter().flat_map(|mark| &mark.points) {
                assert!(inner.inflate(-0.999, -0.999).contains_inclusive(*at), "{aspect}: {layout:?}");
            }
            assert!((layout.figure.width() / layout.figure.height() / aspect - 1.0).abs() < 1e-3);
            assert_eq!(width < height, params.orientation == Orientation::Portrait);
        }
    }
}

/// The mark keeps its distance from the frame, and no figure is smaller than that asks for.
#[test]
fn pictures_are_as_large_as_the_sheet_allows_beside_the_mark() {
    for params in all_params() {
        for aspect in ASPECTS {
            let layout = fit(aspect, f32::MAX, &params);
            let boxes = boxes(&layout, &params);
            let gap = layout.mark.as_ref().map_or(f32::MAX, |mark| blank(mark, boxes[0]));
            assert!(gap >= 5.0 - 1e-3, "{aspect}: {gap} mm to the mark");
            let bottom = boxes.iter().map(|place| place.max.y).fold(0.0, f32::max);
            let side_is_full = (boxes[0].min.x - 10.0).abs() < 0.01;
            let height_is_full = (bottom - (layout.sheet[1] - 10.0)).abs() < 0.01;
            assert!(side_is_full || height_is_full, "{aspect}: the picture could be larger: {layout:?}");
            if boxes[0].min.y > 10.01 {
                // at an end of the bar the distance is longer than straight across
                assert!(
                    gap < 5.0 * std::f32::consts::SQRT_2 + 1.5,
                    "{aspect}: further down than the mark needs: {gap}"
                );
            }
        }
    }
}

/// Blank between the mark and the top right corner of a box, which is what comes nearest to it.
fn blank(mark: &Run, place: MmRect) -> f32 {
    let corner = MmPoint::new(place.max.x, place.min.y);
    nearest_on_segment(corner, mark.points[0], mark.points[1]).0 - 0.5 * mark.width
}

#[test]
fn the_mark_is_as_long_as_asked() {
    let mark = fit(1.0, f32::MAX, &params()).mark.expect("there is one");
    let length = (mark.points[1] - mark.points[0]).length() + mark.width;
    assert!((length - 12.0).abs() < 1e-3 && (mark.width - 2.0).abs() < 1e-6);
    // it cuts the corner: from further left and up to further right and down
    assert!(mark.points[0].x < mark.points[1].x && mark.points[0].y < mark.points[1].y);
}

#[test]
fn the_sheet_is_turned_where_that_makes_the_picture_larger() {
    let with = |orientation, aspect, overview| {
        let mut params = Params { orientation, ..params() };
        params.overview = params.overview.filter(|_| overview);
        fit(aspect, f32::MAX, &params)
    };
    for overview in [true, false] {
        for aspect in ASPECTS {
            let widths = Orientation::ALL.map(|orientation| with(orientation, aspect, overview).figure.width());
            assert!((widths[0] - widths[1].max(widths[2])).abs() < 1e-6, "{aspect}");
        }
    }
    let lies_across = |aspect, overview| {
        let [width, height] = with(Orientation::Auto, aspect, overview).sheet;
        width > height
    };
    assert!(lies_across(1.5, false) && !lies_across(1.0, false) && !lies_across(0.7, true) && lies_across(2.5, true));
    // the sides of the sheet can be given in any order
    let mut turned = Params { orientation: Orientation::Auto, ..params() };
    turned.sheet.reverse();
    assert_eq!(fit(2.5, f32::MAX, &turned), with(Orientation::Auto, 2.5, true));
}

#[test]
fn a_width_that_is_asked_for_is_kept() {
    for aspect in [0.7, 1.0, 1.5] {
        let layout = fit(aspect, 80.0, &params());
        assert!((layout.figure.width() - 80.0).abs() < 1e-4);
        assert!((layout.figure.center().x - 105.0).abs() < 1e-4);
        let boxes = boxes(&layout, &params());
        assert!(blank(layout.mark.as_ref().expect("a mark"), boxes[0]) >= 5.0 - 1e-3);
    }
}

#[test]
fn below_a_title_everything_keeps_inside_the_margins() {
    let table = Code::of_language("en").and_then(Code::table).expect("a table");
    let heading = HeadingParams::of(&table.translate("a cup of coffee"), 0, CellSize::MARBURG, Align::Left);
    for params in all_params().map(|params| Params { heading, ..params }) {
        for aspect in ASPECTS {
            let layout = fit(aspect, f32::MAX, &params);
            let [width, height] = layout.sheet;
            let title = layout.heading.expect("there is room");
            let free = MmRect::new(MmPoint::new(10.0, title.place.max.y), MmPoint::new(width - 10.0, height - 10.0));
            for place in boxes(&layout, &params) {
                assert!(free.inflate(0.01, 0.01).contains_box(&place), "{aspect}: {layout:?}");
            }
        }
    }
}
