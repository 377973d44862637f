//! What is wanted of labels, and what becomes of them.

use crate::braille::Lacking;
use crate::geom::nearest_on_segment;
use crate::geom::polygon::distance_to_box;
use crate::units::{MmPoint, MmRect};

/// How labels are placed, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Params {
    /// Where they may lie.
    pub area: MmRect,
    /// Boxes in one of which each of them must be whole; without any, they may lie anywhere in the area.
    pub tiles: Vec<MmRect>,
    /// Boxes that they keep clear of as of lines.
    pub blocked: Vec<MmRect>,
    /// Where small shapes are that texts may name and the page lacks.
    pub points: Vec<MmPoint>,
    /// Where leader lines of the drawing begin that are on the page.
    pub leaders: Vec<MmPoint>,
    /// What is written on the page already.
    pub written: Vec<WrittenLabel>,
    /// Blank to lines.
    pub clearance: f32,
    /// How much more there should be on the left and on the right where there is room, as on a grid the dots of a line
    /// that stand where those of a next cell would are read as a letter.
    pub more_aside: f32,
    /// The same of numbers along an axis, whose ticks end beside them: as much or more.
    pub off_ticks: f32,
    /// Whether all dots are those of cells, so that a line right beside a label is read as its letters.
    pub among_cells: bool,
    /// Blank between lines.
    pub line_gap: f32,
    /// The least strength that contours must have: lines as strong are weak ones.
    pub least_strength: f32,
    /// Blank to textures.
    pub texture_clearance: f32,
    /// Least height of what labels leave of a texture beside them.
    pub least_texture: f32,
    /// Whether what is drawn stands on an area of its own colour, such as the sea around an island, and not on blank
    /// paper.
    pub has_coloured_ground: bool,
    /// Whether leader lines may cross others: among the few pins of a display they are lost.
    pub may_cross: bool,
    /// Step in which places are looked for; on a grid that of its dots.
    pub step: f32,
    /// Of textures of dots, how far those of a row are apart; 0 on paper.
    pub dot_pitch: f32,
    /// How far the marks of a leader line lie off its straight segment, at most, mm: on a grid they stand on its dots.
    pub leader_off: f32,
    /// Least distance from a label to where the middle of its own leader line begins, mm, besides that: the check of a
    /// page asks for blank before its ink.
    pub least_before_leader: f32,
    /// Breadth of the line of an outline across it, at most, mm, along a slanted way.
    pub widest_outline: f32,
}

impl Params {
    #[cfg(test)]
    pub(super) fn of_test(area: MmRect) -> Self {
        Self {
            area,
            tiles: Vec::new(),
            blocked: Vec::new(),
            points: Vec::new(),
            leaders: Vec::new(),
            written: Vec::new(),
            least_texture: 0.0,
            clearance: 3.0,
            more_aside: 0.0,
            off_ticks: 0.0,
            among_cells: false,
            line_gap: 3.2,
            least_strength: 7.0,
            texture_clearance: 3.0,
            has_coloured_ground: false,
            may_cross: true,
            step: 0.5,
            dot_pitch: 0.0,
            leader_off: 0.0,
            least_before_leader: 2.375,
            widest_outline: 3.0,
        }
    }

    /// Whether a box is whole in one of the tiles, if there are any.
    pub(super) fn holds(&self, place: &MmRect) -> bool {
        self.tiles.is_empty() || self.tiles.iter().any(|tile| tile.contains_box(place))
    }
}

/// A label that is on a page already: others are not abbreviated to its cells, and those of its text are as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenLabel {
    /// What it says.
    pub text: String,
    /// What it says in place of its text, if it is abbreviated.
    pub abbreviation: Option<String>,
    /// Its cells, where it is one line.
    pub cells: Vec<u8>,
}

/// A label that is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// What it says.
    pub text: String,
    /// What it names: a point as an empty box, or the box of a text that it stands for.
    pub anchor: MmRect,
    /// Of a text whose leader line in the drawing is not on the page, where that begins. The label may get one of its
    /// own ([`Attachment::Leader`]).
    pub lost_leader: Option<MmPoint>,
    /// Of a text whose leader line in the drawing is on the page, where that begins.
    pub kept_leader: Option<MmPoint>,
    /// Whether it names nothing, and stands as near to that place as there is room, without a leader line.
    pub is_nameless: bool,
}

/// What a label stands with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlacedAs {
    /// By itself.
    Alone,
    /// In its row or column, which was placed as a whole and keeps its own blank.
    InRow,
    /// The same, in the margin beyond all lines.
    InMargin,
    /// As the title of an axis, at its row or column.
    AsTitle,
}

/// How a label is joined to what it names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attachment {
    /// It stands beside that.
    Beside,
    /// By a leader line that crosses no other.
    Leader([MmPoint; 2]),
    /// By a leader line across others, as there is room nowhere else.
    LeaderAcross([MmPoint; 2]),
}

impl Attachment {
    /// The leader line from the label to what it names, if there is one.
    pub fn leader(self) -> Option<[MmPoint; 2]> {
        match self {
            Self::Beside => None,
            Self::Leader(segment) | Self::LeaderAcross(segment) => Some(segment),
        }
    }

    /// Whether it is a leader line across others.
    pub fn crosses(self) -> bool {
        matches!(self, Self::LeaderAcross(_))
    }
}

/// A label that has a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The box around its dots.
    pub place: MmRect,
    /// Its cells.
    pub lines: Vec<Vec<u8>>,
    /// What its code has no cells for.
    pub lacking: Vec<Lacking>,
    /// What it says in place of its text, if it is abbreviated.
    pub abbreviation: Option<String>,
    /// How it is joined to its anchor: by a leader line, if it lies far away.
    pub attachment: Attachment,
    /// Whether it stands by itself, in a row, in the margin or as the title of an axis.
    pub stands: PlacedAs,
    /// Whether it is a number of an axis without its unit, which another has.
    pub is_bare: bool,
}

/// Why a label has no place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unplaced {
    /// There is no room for it.
    NoRoom,
    /// It is a number along an axis where there is room for every so many-th only.
    Thinned(i64),
    /// There are more labels than a page takes.
    TooMany,
    /// It is longer than anything that is written in braille on a page.
    TooLong,
    /// Its code has no cells for any of its characters.
    NoCells(Vec<Lacking>),
    /// Its code has no cells for characters without which it would say something else.
    Misleading(Vec<Lacking>),
    /// The translator could not write it; what it says.
    NotTranslated(String),
}

impl Placed {
    /// One in this box, by itself beside what it names.
    #[cfg(test)]
    pub(crate) fn of_test(place: MmRect) -> Self {
        Self {
            place,
            lines: Vec::new(),
            lacking: Vec::new(),
            abbreviation: None,
            attachment: Attachment::Beside,
            stands: PlacedAs::Alone,
            is_bare: false,
        }
    }

    /// Blank that is left to a point, mm, besides what textures keep from its box and from its leader line.
    pub(super) fn blank_to(&self, at: MmPoint, params: &Params) -> f32 {
        let to_leader = self.attachment.leader().map_or(f32::INFINITY, |[a, b]| nearest_on_segment(at, a, b).0);
        (distance_to_box(at, self.place) - params.texture_clearance).min(to_leader - params.clearance)
    }

    /// Distance from its box or leader line, mm; 0 inside.
    pub fn distance(&self, at: MmPoint) -> f32 {
        let to_leader = self.attachment.leader().map_or(f32::INFINITY, |[a, b]| nearest_on_segment(at, a, b).0);
        distance_to_box(at, self.place).min(to_leader)
    }
}
