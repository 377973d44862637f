//! What is decided about the lines of a picture before any is drawn.

use crate::regions::{Chosen, Mask};
use crate::units::PxPoint;

/// What the person who makes a page asks of the drawing of its contours, as it is found in this picture. It is decided
/// before lines are drawn, and heeded by whatever draws them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Decisions {
    /// Boxes in which nothing is drawn, in shares of the picture: left, top, right, bottom.
    pub(super) erased: Vec<[f32; 4]>,
    /// How near to lines that a person added nothing else is drawn, px.
    pub(super) room_of_added: f32,
    /// Regions whose outlines come before all others.
    pub(super) subjects: Vec<u32>,
    /// The places along the border of each, px.
    pub(super) borders: Vec<Vec<PxPoint>>,
    /// The cells of the subjects, where the rest of the picture is calmed: then no other region has an outline.
    pub(super) calmed_around: Option<Mask>,
}

/// Whose lines are drawn.
#[derive(Debug, Clone, Copy)]
pub(super) enum LinesOf<'a> {
    /// Those that were found in a picture, below the outlines of its regions, if it has any. Bars of a chart that have
    /// no room as they are may be drawn otherwise.
    Picture(Option<OutlinedRegions<'a>>),
    /// Those that a person drew, which stay as they are.
    Person,
}

/// The regions that get an outline in the figure.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutlinedRegions<'a> {
    pub(super) of_figure: &'a Chosen,
    pub(super) decisions: &'a Decisions,
}

impl<'a> LinesOf<'a> {
    /// The regions that get an outline, if there are any.
    pub(super) fn regions(self) -> Option<OutlinedRegions<'a>> {
        match self {
            Self::Picture(regions) => regions,
            Self::Person => None,
        }
    }
}
