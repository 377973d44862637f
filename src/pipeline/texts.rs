//! Texts of a picture that are not drawn, on the sheet.

use crate::Note;
use crate::geom::{nearest_on_segment, ninths};
use crate::lines::Line;
use crate::raster::vector::{DrawnText, VectorDrawing};
use crate::units::{MmPoint, MmRect, MmVector, PageTransform};

/// A text of a picture that is not drawn, for labels in braille or a list beside the page.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Text {
    /// Its letters, without line breaks; empty where they are pixels, and nobody knows what they say.
    pub string: String,
    /// The box around it, mm on the sheet.
    pub place: MmRect,
    /// Direction in which it is read, degrees counter-clockwise from left to right; whole turns do not
    /// count.
    pub angle: f32,
    /// Size of its font, mm; of letters in pixels 1.6 times their height.
    pub size: f32,
    /// Whether it is not painted, as the words that lie behind a scanned page are not: its letters are a part of the
    /// picture, if they are seen at all.
    pub hidden: bool,
    /// Of a text whose leader line in the drawing is not on the page, where that begins and its tip at what it names.
    /// It may have another one that is.
    pub(super) lost_leader: Option<(MmPoint, MmPoint)>,
    /// Of a text whose leader line in the drawing is on the page, where that begins and its tip.
    pub(super) kept_leader: Option<(MmPoint, MmPoint)>,
    /// Whether it is a word of a legend that is taken out of the drawing.
    pub(super) of_legend: bool,
    /// Of a word of a legend of signs, whether it stands for filled ones.
    pub(super) of_sign: Option<bool>,
}

impl Text {
    /// A level one in print of 4 mm.
    #[cfg(test)]
    pub(super) fn of_test(string: &str, place: MmRect) -> Self {
        Self {
            string: string.to_owned(),
            place,
            angle: 0.0,
            size: 4.0,
            hidden: false,
            lost_leader: None,
            kept_leader: None,
            of_legend: false,
            of_sign: None,
        }
    }

    /// Whether it is seen in the picture, and known what it says.
    pub(super) fn is_read(&self) -> bool {
        !self.hidden && !self.string.is_empty()
    }

    /// Whether it is seen in the picture, and not known what it says.
    pub(super) fn is_unread(&self) -> bool {
        !self.hidden && self.string.is_empty()
    }

    /// The tip of its leader line in the drawing, whether that is on the page or not.
    pub(super) fn tip(&self) -> Option<MmPoint> {
        self.lost_leader.or(self.kept_leader).map(|(_, tip)| tip)
    }

    /// Where it stands: its box, or of a slanted text, such as a long word below a bar of a chart, its upper end, which
    /// is at what it names. Where its leader line is not on the page, the tip of that.
    pub(super) fn anchor(&self) -> MmRect {
        if let Some((_, tip)) = self.lost_leader {
            return MmRect::new(tip, tip);
        }
        if !self.is_slanted() {
            return self.place;
        }
        let side = self.side();
        let left = if self.upright_angle() < 90.0 { self.place.max.x - side } else { self.place.min.x };
        let corner = MmPoint::new(left, self.place.min.y);
        MmRect::new(corner, corner + MmVector::new(side, side))
    }
}

impl Text {
    /// The same where these lines are drawn: a slanted text that runs along one, such as the name of a river, is of
    /// that, and stands at its middle.
    pub(super) fn anchor_among(&self, lines: &[Line]) -> MmRect {
        if self.lost_leader.is_some() || !self.is_slanted() || !self.runs_along(lines) {
            return self.anchor();
        }
        let (middle, half) = (self.place.center(), 0.5 * self.side());
        MmRect::new(middle, middle).inflate(half, half)
    }

    /// Between 0 and 180 degrees: a text upside down has its upper end where it would have it otherwise.
    fn upright_angle(&self) -> f32 {
        self.angle.rem_euclid(180.0)
    }

    fn is_slanted(&self) -> bool {
        let angle = self.upright_angle();
        SLANTED.contains(&angle) || SLANTED.contains(&(180.0 - angle))
    }

    /// The height of its letters, about.
    fn side(&self) -> f32 {
        self.size.min(self.place.width()).min(self.place.height())
    }

    /// Whether a line runs along it, beside its middle.
    fn runs_along(&self, lines: &[Line]) -> bool {
        let (middle, reach) = (self.place.center(), self.side() + BESIDE_LINE);
        let (sin, cos) = self.angle.to_radians().sin_cos();
        let way = MmVector::new(cos, -sin);
        lines.iter().flat_map(|line| &line.runs).any(|run| {
            let points: Vec<MmPoint> = run.path().collect();
            let mut from = 0;
            (0..points.len()).any(|to| {
                let (a, b) = (points[from], points[to]);
                if (b - a).length() < PIECE {
                    return false;
                }
                from = to;
                nearest_on_segment(middle, a, b).0 <= reach && (b - a).normalize().dot(way).abs() >= ALONG
            })
        })
    }
}

/// Print stands so far beside the line that it names, mm, besides the height of its letters.
const BESIDE_LINE: f32 = 4.0;
/// The direction of a line is that of pieces of this length, mm: on a grid of dots they have steps of 45 degrees.
const PIECE: f32 = 6.0;
/// A line runs along a text if its direction differs by no more than 25 degrees: the cosine.
const ALONG: f32 = 0.906;

/// Degrees off the horizontal between which a text is slanted.
const SLANTED: std::ops::RangeInclusive<f32> = 15.0..=75.0;

/// Texts where they stand on the sheet.
pub(super) fn placed(texts: &[DrawnText], transform: &PageTransform) -> Vec<Text> {
    let placed = |text: &DrawnText| Text {
        string: text.string.clone(),
        place: MmRect::new(transform.to_mm(text.min), transform.to_mm(text.max)),
        angle: text.angle,
        size: text.size * transform.mm_per_px(),
        hidden: text.hidden,
        lost_leader: None,
        kept_leader: None,
        of_legend: false,
        of_sign: None,
    };
    texts.iter().map(placed).collect()
}

/// So few parts of a picture that were taken for text may be none.
const MAY_BE_NONE: usize = 2;

/// How many texts of a figure are neither drawn nor to be written, and what the maker is told of those that are not
/// drawn: of texts that `are_labels` those are told that have no room, elsewhere. Those of which nobody knows what they
/// say are shapes where the picture is a `drawing` of paths alone; few of them may be none, and do not count.
pub(super) fn left_out(
    texts: &[Text],
    are_labels: bool,
    figure: MmRect,
    drawing: Option<&VectorDrawing>,
) -> (u32, Vec<Note>) {
    let known = texts.iter().filter(|text| !are_labels && text.is_read());
    let known: Vec<String> = known.map(|text| text.string.clone()).collect();
    let unknown: Vec<&Text> = texts.iter().filter(|text| text.is_unread()).collect();
    let count = known.len() + if unknown.len() > MAY_BE_NONE { unknown.len() } else { 0 };
    let largest = unknown.iter().max_by(|a, b| a.size.total_cmp(&b.size));
    let told = largest.map(|largest| Note::LetteringLeftOut {
        texts: unknown.len(),
        place: ninths::NAMES[ninths::ninth(largest.place.center(), figure)],
        are_shapes: drawing.is_some_and(|drawing| drawing.pixel_areas.is_empty()),
    });
    let notes = (!known.is_empty()).then_some(Note::TextsLeftOut(known)).into_iter().chain(told).collect();
    (count as u32, notes)
}
