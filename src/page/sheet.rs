//! The measures of a sheet, and where on it things lie.

use std::f32::consts::{FRAC_1_SQRT_2, SQRT_2};

use super::cells::CellGrid;
use super::heading::{Heading, HeadingParams};
use super::medium::{Medium, MediumParams};
use super::parts::Run;
use super::sheet_windows::{SheetWindows, place_in_words};
use crate::units::{MmPoint, MmRect, MmVector};

/// Which way up a sheet lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// The orientation in which the picture becomes larger; upright when there is no difference.
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
    /// The title in braille, if there is one.
    pub heading: Option<HeadingParams>,
    /// What the page is made for.
    pub medium: MediumParams,
}

impl Params {
    /// From a picture to the outer edge of its frame.
    pub(super) fn border(&self) -> f32 {
        self.frame.map_or(0.0, |frame| frame.width + frame.gap)
    }

    /// The width of the widest figure on the sheet upright.
    pub fn widest_upright(&self) -> f32 {
        let [a, b] = self.sheet;
        a.min(b) - 2.0 * self.margin - 2.0 * self.border()
    }
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
    /// What its frame is around: the picture, and blank beside it where labels need room.
    pub room: MmRect,
    /// The overview's picture; of a page of dots, on a sheet of its own.
    pub overview: Option<MmRect>,
    /// The orientation mark.
    pub mark: Option<Run>,
    /// Where the title stands in braille, if there is one and there is room for it.
    pub heading: Option<Heading>,
    /// What the page is made for.
    pub medium: Medium,
    /// Where the figure is spread over several sheets: which of them shows what.
    pub sheets: Option<SheetWindows>,
}

impl Layout {
    /// A figure alone at its place on a sheet.
    pub fn of_figure(sheet: [f32; 2], figure: MmRect, medium: Medium) -> Self {
        Self { sheet, figure, room: figure, overview: None, mark: None, heading: None, medium, sheets: None }
    }

    /// A place of the figure in words, as `20, 30 mm` or `20, 30 mm on sheet b1`.
    pub fn place_in_words(&self, at: MmPoint) -> String {
        place_in_words(at, self.sheets.as_ref())
    }

    /// The largest overview that there is room for below the figure as things are, up to this share of the figure's
    /// width and height, in hundredths; none if the own one is as large.
    pub fn largest_overview(&self, most: f32, params: &Params) -> Option<MmRect> {
        let own = self.overview.filter(|own| own.min.y > self.figure.max.y)?;
        let border = params.border();
        let below = self.sheet[1] - params.margin - border - own.min.y;
        let beside = 2.0 * (own.center().x - params.margin - border);
        let room = (below / self.figure.height()).min(beside / self.figure.width()).min(most);
        let scale = (100.0 * room).floor() / 100.0;
        if scale * self.figure.width() <= own.width() { None } else { self.overview_at(scale, params) }
    }

    /// The overview at another share of the figure's width and height, if it lies below the figure and there is room
    /// for it as things are.
    pub fn overview_at(&self, scale: f32, params: &Params) -> Option<MmRect> {
        let own = self.overview.filter(|own| own.min.y > self.figure.max.y)?;
        let size = self.figure.size() * scale;
        let at = MmRect::from_origin_and_size(MmPoint::new(own.center().x - 0.5 * size.width, own.min.y), size);
        let border = params.border();
        (at.max.y + border <= self.sheet[1] - params.margin && at.min.x - border >= params.margin).then_some(at)
    }
}

/// Where things lie on one sheet.
pub(super) struct Positions {
    pub(super) figure: MmRect,
    pub(super) overview: Option<MmRect>,
    pub(super) mark: Option<Run>,
}

/// A sheet as it lies.
pub(super) struct Sheet<'a> {
    params: &'a Params,
    /// Width and height.
    pub(super) size: [f32; 2],
    /// From the picture to the outer edge of its frame.
    border: f32,
    /// From the top margin to what lies below the title, mm.
    heading: f32,
}

impl<'a> Sheet<'a> {
    pub(super) fn new(size: [f32; 2], params: &'a Params, heading: Option<&Heading>) -> Self {
        Self { params, size, border: params.border(), heading: heading.map_or(0.0, Heading::height) }
    }

    /// Width and height within the margins.
    fn inner(&self) -> [f32; 2] {
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

    /// How far, across and down added up, the top right corner of the figure's frame must lie from the corner of what
    /// can be printed to keep its distance from the mark: u to the left of that corner and v down, it lies (u + v) /
    /// sqrt 2 from the line that cuts the corner there.
    fn cut(&self) -> f32 {
        let cut = |mark: MarkParams| leg(mark) + mark.width + SQRT_2 * (0.5 * mark.width + mark.gap);
        self.params.mark.map_or(0.0, cut)
    }

    /// The greatest width of a figure; 0 where there is no room.
    pub(super) fn figure_width(&self, aspect: f32) -> f32 {
        let [width, height] = self.inner();
        let (fixed, share) = self.stack();
        let free = width - 2.0 * self.border;
        let by_height = (height - fixed - self.heading) / share * aspect;
        // The narrower the figure, the less it has to go down below the mark.
        let by_mark = (height - fixed - self.cut() + 0.5 * free) / (share / aspect + 0.5);
        free.min(by_height).min(by_mark).max(0.0)
    }

    /// Where things lie with a figure of this width.
    pub(super) fn lay_out(&self, aspect: f32, width: f32) -> Positions {
        let Params { margin, overview, mark, .. } = *self.params;
        let size = MmVector::new(width, width / aspect);
        let middle = 0.5 * self.size[0];
        let centred = |top: f32, size: MmVector| {
            let corner = MmPoint::new(middle - 0.5 * size.x, top);
            MmRect::new(corner, corner + size)
        };
        let beside = 0.5 * self.inner()[0] - 0.5 * width - self.border;
        let down = (self.cut() - beside).max(self.heading);
        let figure = centred(margin + down + self.border, size);
        let overview =
            overview.map(|overview| centred(figure.max.y + overview.gap + 2.0 * self.border, size * overview.scale));
        let mark = mark.map(|mark| bar(MmPoint::new(self.size[0] - margin, margin), mark));
        Positions { figure, overview, mark }
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

/// Least blank between the title and the mark, mm: as other programs leave around braille on graphics.
const BESIDE_MARK: f32 = 3.0;

/// How far from the corner of what can be printed a title in these cells has to end, because of the mark.
pub(super) fn beside(mark: Option<MarkParams>, cells: &CellGrid<'_>) -> f32 {
    mark.map_or(0.0, |mark| reach(mark) + mark.gap.max(BESIDE_MARK).max(cells.blank_before_cells()))
}

/// The bar that cuts off a corner of what can be printed; all of its ink lies within.
pub(super) fn bar(corner: MmPoint, mark: MarkParams) -> Run {
    let inner = corner + MmVector::new(-0.5 * mark.width, 0.5 * mark.width);
    let points = vec![inner - MmVector::new(leg(mark), 0.0), inner + MmVector::new(0.0, leg(mark))];
    Run::stroke(mark.width, points)
}
