//! What is decided about the lines of a picture before any is drawn.

use crate::regions::{Chosen, Mask};
use crate::units::PxPoint;

/// What the person who makes a page asks of the drawing of its contours, as it is found in this picture. It is decided
/// before lines are drawn, and heeded by whatever draws them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Decisions {
    /// Boxes in which nothing is drawn, in shares of the picture: left, top, right, bottom.
    pub(super) erased: Vec<[f32; 4]>,
    /// How near to lines that a person added nothing else is drawn along them, px.
    pub(super) room_of_added: f32,
    /// Where contours gave way to these, in shares of the width and height of the picture.
    pub(super) gave_way: Vec<[f32; 2]>,
    /// Regions whose outlines come before all others.
    pub(super) subjects: Vec<u32>,
    /// What was found at the places that name subjects.
    pub(super) found: Vec<FoundSubject>,
    /// The cells of the subjects, where the rest of the picture is calmed: then no other region has an outline.
    pub(super) calmed_around: Option<Mask>,
    /// How much of weak contours went for it, mm in the figure.
    pub(super) calmed_mm: u32,
}

/// What was found at a place that names a subject.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FoundSubject {
    /// The place, percent from the left and from the top.
    pub(super) at: [i32; 2],
    /// Its width and height, mm in the figure.
    pub(super) mm: [u32; 2],
    /// Its middle, percent from the left and from the top.
    pub(super) middle: [i32; 2],
    /// The colour that most of it has; none if none has, or if colours are not looked at.
    pub(super) colour: Option<&'static str>,
    /// Whether it fills most of the picture, as the ground of a thing does.
    pub(super) fills: bool,
    /// The region that it is, whose outline comes before others; none where it is the inside of closed lines.
    pub(super) region: Option<u32>,
    /// Its cells.
    pub(super) mask: Mask,
    /// The places along its border, px.
    pub(super) border: Vec<PxPoint>,
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

    /// Whether the outline of what the picture is about is among them: it is drawn even where no contour is strong
    /// enough for a line.
    pub(super) fn has_subject(self) -> bool {
        self.regions().is_some_and(|regions| !regions.decisions.subjects.is_empty())
    }
}
