//! Where things lie on the sheet.
//!
//! ```text
//!  +--------- sheet ----------+
//!  |  margin                \ |   The orientation mark cuts the top right corner of what can be printed.
//!  |   ::::::: frame :::::::  |   The frames hug the pictures, so that a finger on the frame knows the picture's shape.
//!  |   ::  gap             :: |
//!  |   ::    figure        :: |
//!  |   ::                  :: |
//!  |   :::::::::::::::::::::: |
//!  |      substantial gap     |
//!  |        ::::::::::::      |
//!  |        :: overview::     |
//!  |        ::::::::::::      |
//!  +--------------------------+
//! ```

use std::f32::consts::{FRAC_1_SQRT_2, SQRT_2};

use super::{Run, dot_layout};
use crate::devices::{Device, Room};
use crate::units::{MmPoint, MmRect, MmVector};

/// Which way up a sheet lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// The way in which the picture becomes larger; upright when there is no difference.
    #[default]
    Auto,
    /// The longer side up and down.
    Portrait,
    /// The longer side across.
    Landscape,
}

impl Orientation {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Auto, Self::Portrait, Self::Landscape];
    /// Their names, in the same order.
    pub const NAMES: [&str; 3] = ["auto", "portrait", "landscape"];

    /// Its name, as profiles have it.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

/// Measures of the sheet, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Both sides of the sheet, in any order.
    pub sheet: [f32; 2],
    /// Which of them is across.
    pub orientation: Orientation,
    /// Blank on all four sides.
    pub margin: f32,
    /// Frames, if there are any.
    pub frame: Option<FrameParams>,
    /// The overview, if there is one.
    pub overview: Option<OverviewParams>,
    /// The orientation mark, if there is one.
    pub mark: Option<MarkParams>,
    /// The device, if the page is one of dots.
    pub press: Option<PressParams>,
}

/// A device that presses a page as dots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressParams {
    /// The device.
    pub device: &'static Device,
    /// Distance of its dots, mm.
    pub pitch: f32,
    /// Diameter of a dot as it is felt, mm.
    pub diameter: f32,
}

/// Measures of a frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameParams {
    /// Width of the band of dots.
    pub width: f32,
    /// Diameter of a dot.
    pub dot: f32,
    /// Distance of dots.
    pub pitch: f32,
    /// Blank between the band and the picture.
    pub gap: f32,
}

/// Measures of the overview.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverviewParams {
    /// Its width and height as a share of the figure's.
    pub scale: f32,
    /// Blank between the two frames, mm.
    pub gap: f32,
}

/// Measures of the orientation mark, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkParams {
    /// Length of the bar from end to end, with its round ends.
    pub length: f32,
    /// Width of the bar.
    pub width: f32,
    /// Least blank between the bar and the frame (or the figure, where there is no frame).
    pub gap: f32,
}

/// Places on the sheet, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Width and height of the sheet as it lies.
    pub sheet: [f32; 2],
    /// The picture itself.
    pub figure: MmRect,
    /// The overview's picture; of a page of dots, on a sheet of its own.
    pub overview: Option<MmRect>,
    /// The orientation mark.
    pub mark: Option<Run>,
    /// Where dots can be, on a page of dots.
    pub room: Option<Room>,
}

/// Lays out a picture whose width is `aspect` times its height, as large as the sheet allows but not wider than `widest`,
/// centred from left to right and beginning at the top margin, or as far below it as the orientation mark needs.
pub fn fit(aspect: f32, widest: f32, params: &Params) -> Layout {
    let [short, long] = {
        let [a, b] = params.sheet;
        [a.min(b), a.max(b)]
    };
    if let Some(press) = &params.press {
        return fit_dots(aspect, widest, [short, long], params, press);
    }
    let (upright, across) = (Sheet::new([short, long], params), Sheet::new([long, short], params));
    let sheet = match params.orientation {
        Orientation::Portrait => upright,
        Orientation::Landscape => across,
        Orientation::Auto if across.figure_width(aspect) > upright.figure_width(aspect) => across,
        Orientation::Auto => upright,
    };
    sheet.lay_out(aspect, sheet.figure_width(aspect).min(widest))
}

/// The same for a page of dots. A sheet that the device does not take in any of the ways allowed has no room for a figure.
fn fit_dots(aspect: f32, widest: f32, [short, long]: [f32; 2], params: &Params, press: &PressParams) -> Layout {
    let ways = match params.orientation {
        Orientation::Portrait => &[[short, long]][..],
        Orientation::Landscape => &[[long, short]],
        Orientation::Auto => &[[short, long], [long, short]],
    };
    let laid_out = ways.iter().filter_map(|&size| dot_layout::fit(aspect, widest, size, params, press));
    let larger = |a: Layout, b: Layout| if b.figure.width() > a.figure.width() { b } else { a };
    let none = Layout { sheet: ways[0], figure: MmRect::zero(), overview: None, mark: None, room: None };
    laid_out.reduce(larger).unwrap_or(none)
}

/// A sheet as it lies.
pub(super) struct Sheet<'a> {
    params: &'a Params,
    size: [f32; 2],
    /// From the picture to the outer edge of its frame.
    border: f32,
}

impl<'a> Sheet<'a> {
    pub(super) fn new(size: [f32; 2], params: &'a Params) -> Self {
        Self { params, size, border: params.frame.map_or(0.0, |frame| frame.width + frame.gap) }
    }

    /// Width and height within the margins.
    fn room(&self) -> [f32; 2] {
        self.size.map(|side| side - 2.0 * self.params.margin)
    }

    /// What lies one below the other beside the pictures themselves, and the height of both pictures as a share of the
    /// figure's.
    fn stack(&self) -> (f32, f32) {
        match self.params.overview {
            Some(overview) => (4.0 * self.border + overview.gap, 1.0 + overview.scale),
            None => (2.0 * self.border, 1.0),
        }
    }

    /// How far, across and down added up, the top right corner of the figure's frame must lie from the corner of what can be
    /// printed to keep its distance from the mark: u to the left of that corner and v down, it lies (u + v) / sqrt 2 from
    /// the line that cuts the corner there.
    fn cut(&self) -> f32 {
        let cut = |mark: MarkParams| leg(mark) + mark.width + SQRT_2 * (0.5 * mark.width + mark.gap);
        self.params.mark.map_or(0.0, cut)
    }

    /// The greatest width of a figure; 0 where there is no room.
    pub(super) fn figure_width(&self, aspect: f32) -> f32 {
        let [width, height] = self.room();
        let (fixed, share) = self.stack();
        let free = width - 2.0 * self.border;
        let by_height = (height - fixed) / share * aspect;
        // The narrower the figure, the less it has to go down below the mark.
        let by_mark = (height - fixed - self.cut() + 0.5 * free) / (share / aspect + 0.5);
        free.min(by_height).min(by_mark).max(0.0)
    }

    pub(super) fn lay_out(&self, aspect: f32, width: f32) -> Layout {
        let Params { margin, overview, mark, .. } = *self.params;
        let size = MmVector::new(width, width / aspect);
        let middle = 0.5 * self.size[0];
        let place = |top: f32, size: MmVector| {
            let corner = MmPoint::new(middle - 0.5 * size.x, top);
            MmRect::new(corner, corner + size)
        };
        let beside = 0.5 * self.room()[0] - 0.5 * width - self.border;
        let down = (self.cut() - beside).max(0.0);
        let figure = place(margin + down + self.border, size);
        let overview =
            overview.map(|overview| place(figure.max.y + overview.gap + 2.0 * self.border, size * overview.scale));
        let mark = mark.map(|mark| bar(MmPoint::new(self.size[0] - margin, margin), mark));
        Layout { sheet: self.size, figure, overview, mark, room: None }
    }
}

/// How far the middle line of a mark reaches across, and as far down.
fn leg(mark: MarkParams) -> f32 {
    (mark.length - mark.width).max(0.0) * FRAC_1_SQRT_2
}

/// How far a mark reaches down and to the left from the corner that it cuts off, ink and all.
pub(super) fn reach(mark: MarkParams) -> f32 {
    leg(mark) + mark.width
}

/// The bar that cuts off a corner of what can be printed; all of its ink lies within.
pub(super) fn bar(corner: MmPoint, mark: MarkParams) -> Run {
    let inner = corner + MmVector::new(-0.5 * mark.width, 0.5 * mark.width);
    let points = vec![inner - MmVector::new(leg(mark), 0.0), inner + MmVector::new(0.0, leg(mark))];
    Run::stroke(mark.width, points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::nearest_on_segment;

    fn params() -> Params {
        Params {
            sheet: [210.0, 297.0],
            orientation: Orientation::Portrait,
            margin: 10.0,
            frame: Some(FrameParams { width: 3.0, dot: 0.8, pitch: 1.6, gap: 5.0 }),
            overview: Some(OverviewParams { scale: 0.4, gap: 12.0 }),
            mark: Some(MarkParams { length: 12.0, width: 2.0, gap: 5.0 }),
            press: None,
        }
    }

    const ASPECTS: [f32; 9] = [0.05, 0.3, 0.7, 1.0, 1.1, 1.5, 1.8, 4.0, 20.0];

    /// All ways to have or not to have the parts of a page.
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
        [Some(layout.figure), layout.overview]
            .into_iter()
            .flatten()
            .map(|place| place.inflate(border, border))
            .collect()
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
                    // at an end of the bar the way is longer than straight across
                    assert!(gap < 5.0 * SQRT_2 + 1.5, "{aspect}: further down than the mark needs: {gap}");
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
                let widths = Orientation::ALL.map(|way| with(way, aspect, overview).figure.width());
                assert!((widths[0] - widths[1].max(widths[2])).abs() < 1e-6, "{aspect}");
            }
        }
        let lies_across = |aspect, overview| {
            let [width, height] = with(Orientation::Auto, aspect, overview).sheet;
            width > height
        };
        assert!(
            lies_across(1.5, false) && !lies_across(1.0, false) && !lies_across(0.7, true) && lies_across(2.5, true)
        );
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
}
