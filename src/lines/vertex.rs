//! Lines in the making: polylines on the sheet, before it is known what of them is drawn.

use super::params::Params;
use crate::edges::{ChainKind, Edgel};
use crate::geom::mix;
use crate::geom::nearby::Nearby;
use crate::geom::polyline::{Blend, Located, Polyline, PolylineRef, smooth};
use crate::units::{Mm, MmPoint, MmRect, MmVector, PageTransform};

/// Distance of the vertices of a line in the making, mm: a few to the width of the thinnest line.
pub(super) const SPACING: f32 = 0.4;
/// Vertices farther apart than this, mm, get others between them: what looks at a line looks at its vertices.
const LONGEST: f32 = 1.25 * SPACING;

/// Steps in which lines are shortened, mm.
pub(super) const SHORTENED_BY: f32 = 0.25;

/// At a corner a line turns by at least 30 degrees (the cosine), over a short and a longer length, mm.
pub(crate) const CORNER: f32 = 0.866;
pub(crate) const CORNER_ARMS: [f32; 2] = [0.15, 1.0];

/// A vertex of a line in the making.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vertex {
    pub(super) at: MmPoint,
    pub(super) strength: f32,
    /// Colour on the right less colour on the left.
    pub(super) contrast: [f32; 3],
    /// Width of the line here, mm; 0 until `weight` has been there.
    pub(super) width: f32,
    /// Width of the stroke in whose middle it is, mm; 0 on an edge.
    pub(super) stroke: f32,
    /// Width of the thin area in whose middle it is, as of a wall that is a filled rectangle, mm; 0 elsewhere.
    pub(super) bar: f32,
    /// Where it was found.
    pub(super) source: FoundIn,
    /// How far being displaced by itself (`clearance/displace`) has moved it in all rounds.
    pub(super) displaced: MmVector,
}

/// Where a vertex was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FoundIn {
    /// In pixels.
    Pixels,
    /// In the pixels of a drawing, in the middle of a stroke: every one is meant, though one thinner than a pixel is
    /// faint.
    Stroke,
    /// In a vector drawing, and exactly there.
    Vector,
    /// The same, of a stroke that is faint beside others.
    FaintStroke,
    /// In what a person drew into a picture, and exactly there.
    Person,
    /// In the pixels of a drawing, a filled head of an arrow: its tip is the first of three corners.
    Head,
    /// The same, a sign that marks a place.
    Sign,
}

impl FoundIn {
    /// Whether it has no wobble of noise: it is where a path or a person has it, or is a corner of a head of an arrow,
    /// which was fitted to the pixels as a whole.
    pub(super) fn is_exact(self) -> bool {
        matches!(self, Self::Vector | Self::FaintStroke | Self::Person | Self::Head | Self::Sign)
    }
}

#[cfg(test)]
impl Vertex {
    /// One of a faint contour in pixels, from which tests differ in what they are about.
    pub(super) const TEST: Self = Self {
        at: MmPoint::new(0.0, 0.0),
        strength: 30.0,
        contrast: [0.0; 3],
        width: 0.0,
        stroke: 0.0,
        bar: 0.0,
        source: FoundIn::Pixels,
        displaced: MmVector::new(0.0, 0.0),
    };
}

impl Located for Vertex {
    type Unit = Mm;

    fn at(&self) -> MmPoint {
        self.at
    }
}

impl Blend for Vertex {
    fn between(&self, other: &Self, share: f32) -> Self {
        Self {
            at: self.at.lerp(other.at, share),
            strength: mix(self.strength, other.strength, share),
            contrast: std::array::from_fn(|i| mix(self.contrast[i], other.contrast[i], share)),
            width: mix(self.width, other.width, share),
            stroke: mix(self.stroke, other.stroke, share),
            bar: mix(self.bar, other.bar, share),
            source: if self.source == other.source { self.source } else { FoundIn::Pixels },
            displaced: self.displaced.lerp(other.displaced, share),
        }
    }

    fn reversed(self) -> Self {
        Self { contrast: self.contrast.map(|v| -v), ..self }
    }
}

impl Vertex {
    /// Whether it lies in the middle of a stroke, where there is no step of colour; otherwise it is on an edge.
    pub(super) fn is_in_stroke(&self) -> bool {
        is_no_step(self.contrast)
    }

    /// Its strength; of a stroke in a drawing at least full strength: one that is half a pixel wide is found with half
    /// its contrast, or less, and means as much as a wide one; a faint one of a vector drawing is meant, too.
    pub(super) fn counted_strength(&self, full_strength: f32) -> f32 {
        match self.source {
            FoundIn::Stroke | FoundIn::FaintStroke => self.strength.max(full_strength),
            FoundIn::Pixels | FoundIn::Vector | FoundIn::Person | FoundIn::Head | FoundIn::Sign => self.strength,
        }
    }
}

/// One of the two tips of an open line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tip {
    /// Its first vertex.
    First,
    /// Its last.
    Last,
}

impl Tip {
    /// Both, in the order of the line.
    pub(super) const BOTH: [Self; 2] = [Self::First, Self::Last];

    /// Its vertex of a line.
    pub(super) fn of(self, line: &Polyline<Vertex>) -> Option<&Vertex> {
        match self {
            Self::First => line.vertices.first(),
            Self::Last => line.vertices.last(),
        }
    }

    /// The same, to be changed.
    pub(super) fn of_mut(self, line: &mut Polyline<Vertex>) -> Option<&mut Vertex> {
        match self {
            Self::First => line.vertices.first_mut(),
            Self::Last => line.vertices.last_mut(),
        }
    }

    /// That at the other end.
    pub(super) fn other(self) -> Self {
        match self {
            Self::First => Self::Last,
            Self::Last => Self::First,
        }
    }
}

impl Polyline<Vertex> {
    /// Calls `visit` with the number of each line of which a segment is within `reach` of one of this line's ends, mm;
    /// once for each such segment. A ring has no ends.
    pub(super) fn each_that_it_ends_on(&self, segments: &Nearby, reach: f32, mut visit: impl FnMut(usize)) {
        if let (Some(first), Some(last), false) = (self.vertices.first(), self.vertices.last(), self.closed) {
            [first.at, last.at].into_iter().for_each(|at| segments.each_line_at(at, reach, &mut visit));
        }
    }

    /// Changes the vertices of an open line in the order that leads to one of its tips, which is the last of them.
    pub(super) fn change_tip(&mut self, which: Tip, change: impl FnOnce(&mut Vec<Vertex>)) {
        if which == Tip::First {
            self.vertices.reverse();
        }
        change(&mut self.vertices);
        if which == Tip::First {
            self.vertices.reverse();
        }
    }

    /// An open line without so much of one of its ends, mm.
    pub(super) fn shortened(&self, which: Tip, cut: f32) -> Self {
        let mut line = Self::open(self.vertices.clone());
        line.change_tip(which, |vertices| {
            let mut left = cut;
            while let [.., before, last] = vertices[..] {
                let step = (last.at - before.at).length();
                if step > left {
                    let share = if step > 0.0 { left / step } else { 0.0 };
                    if let Some(end) = vertices.last_mut() {
                        *end = Vertex { at: last.at.lerp(before.at, share), ..last };
                    }
                    break;
                }
                left -= step;
                vertices.pop();
            }
        });
        line
    }

    /// An open line as it is, and without more and more of one of its ends, up to `most`, mm, in steps of
    /// [`SHORTENED_BY`].
    pub(super) fn shorter_ones(&self, which: Tip, most: f32) -> impl Iterator<Item = Self> {
        (0..=(most / SHORTENED_BY) as u32).map(move |step| self.shortened(which, step as f32 * SHORTENED_BY))
    }

    /// A contour on the sheet.
    pub(super) fn of_chain(chain: PolylineRef<'_, Edgel>, kind: ChainKind, transform: &PageTransform) -> Self {
        let source = match kind {
            ChainKind { exact: true, added: true, .. } => FoundIn::Person,
            ChainKind { head: true, .. } => FoundIn::Head,
            ChainKind { sign: Some(_), .. } => FoundIn::Sign,
            ChainKind { exact: true, .. } => FoundIn::Vector,
            ChainKind { of_drawing: true, stroke: Some(_), .. } => FoundIn::Stroke,
            _ => FoundIn::Pixels,
        };
        let vertex = |p: &Edgel| Vertex {
            at: transform.to_mm(p.at),
            strength: p.strength,
            contrast: p.contrast,
            width: 0.0,
            stroke: kind.stroke.unwrap_or(0.0) * transform.mm_per_px(),
            bar: 0.0,
            source,
            displaced: MmVector::zero(),
        };
        Self { vertices: chain.vertices.iter().map(vertex).collect(), closed: chain.closed }
    }

    /// Length, mm, of a line of full strength that is worth as much: a weak line counts in proportion.
    pub(super) fn weighted_length(&self, full_strength: f32) -> f32 {
        self.length() * (self.mean(|vertex| vertex.counted_strength(full_strength)) / full_strength).min(1.0)
    }

    /// Mean strength along the path; of a ring the first vertex counts at both its ends.
    pub(super) fn mean_strength(&self) -> f32 {
        self.mean(|vertex| vertex.strength)
    }

    /// Mean width of the stroke whose middle the line is, mm; none of an edge.
    pub(super) fn stroke(&self) -> Option<f32> {
        self.mean_width(|vertex| vertex.stroke)
    }

    /// The same also of a thin area whose middle the line is.
    pub(super) fn breadth(&self) -> Option<f32> {
        self.mean_width(|vertex| vertex.stroke.max(vertex.bar))
    }

    /// Mean of a width that most of the vertices have.
    fn mean_width(&self, width: impl Fn(&Vertex) -> f32) -> Option<f32> {
        let widths = || self.vertices.iter().map(&width).filter(|width| *width > 0.0);
        let count = widths().count();
        (2 * count > self.vertices.len()).then(|| widths().sum::<f32>() / count as f32)
    }

    fn mean(&self, of: impl Fn(&Vertex) -> f32) -> f32 {
        let count = self.vertices.len() + usize::from(self.closed);
        self.path().map(of).sum::<f32>() / count.max(1) as f32
    }

    /// The line in the one of its two directions that begins with its stronger half, so that nothing hangs on the
    /// direction it was found in.
    pub(super) fn stronger_half_first(self) -> Self {
        let count = self.vertices.len() + usize::from(self.closed);
        let half = count / 2;
        let strengths = || self.path().map(|v| v.strength);
        let (first, second): (f32, f32) = (strengths().take(half).sum(), strengths().skip(count - half).sum());
        if second > first { self.reversed() } else { self }
    }

    /// Puts vertices at even distances of about [`SPACING`], the ends where they are. A ring begins at its strongest
    /// vertex, so that the result does not hang on where the search for it began.
    pub(super) fn evened(mut self) -> Self {
        if self.closed {
            let strength = |i: &usize| self.vertices[*i].strength;
            let strongest = (0..self.vertices.len()).max_by(|a, b| strength(a).total_cmp(&strength(b)));
            self.vertices.rotate_left(strongest.unwrap_or(0));
        }
        self.resampled(SPACING)
    }

    /// Puts vertices where two that follow one another are much farther apart than [`SPACING`].
    pub(super) fn fill(&mut self) {
        self.subdivide(LONGEST);
    }

    /// [`Self::smoothed`] and [`Self::evened`] between its corners, which stay where they are.
    pub(super) fn smoothed_between_corners(self, sigma: f32) -> Self {
        let mut corners = self.view().corners();
        let strength = |i: &usize| self.vertices[*i].strength;
        let strongest = (0..corners.len()).max_by(|&a, &b| strength(&corners[a]).total_cmp(&strength(&corners[b])));
        let Some(strongest) = strongest else { return self.smoothed(sigma).evened() };
        let (open, closed) = if self.closed {
            let (start, count) = (corners[strongest], self.vertices.len());
            corners.iter_mut().for_each(|corner| *corner = (*corner + count - start) % count);
            corners.sort_unstable();
            corners.remove(0);
            (self.opened_at(start), true)
        } else {
            (self, false)
        };
        let ends = corners.iter().copied().chain([open.vertices.len() - 1]);
        let (mut vertices, mut start): (Vec<Vertex>, usize) = (Vec::new(), 0);
        for end in ends {
            let piece = Polyline::open(open.vertices[start..=end].to_vec()).smoothed(sigma).evened();
            vertices.extend(piece.vertices.into_iter().skip(usize::from(start > 0)));
            start = end;
        }
        if closed {
            vertices.pop();
        }
        Self { vertices, closed }
    }

    /// Positions, strengths and steps smoothed along the line; widths are not yet known.
    pub(super) fn smoothed(self, sigma: f32) -> Self {
        let smooth = smooth(&self.arc_lengths(), self.closed, sigma, |i| {
            let v = &self.vertices[i];
            [v.at.x, v.at.y, v.strength, v.contrast[0], v.contrast[1], v.contrast[2]]
        });
        let vertex = |(vertex, [x, y, strength, l, a, b]): (&Vertex, [f32; 6])| Vertex {
            at: MmPoint::new(x, y),
            strength,
            contrast: [l, a, b],
            ..*vertex
        };
        Self { vertices: self.vertices.iter().zip(smooth).map(vertex).collect(), closed: self.closed }
    }
}

impl PolylineRef<'_, Vertex> {
    /// The vertices at which the line turns at once. Those near the ends of an open line are none.
    fn corners(self) -> Vec<usize> {
        let count = self.vertices.len();
        let direction = |i: usize, step: isize, length: f32| {
            let at = self.vertices[i].at;
            let ahead = (1..count as isize).map_while(|k| self.next(i, k * step));
            let to = ahead.map(|k| self.vertices[k].at).find(|to| (*to - at).length() >= length)?;
            (to - at).try_normalize()
        };
        let turns = |&i: &usize| {
            CORNER_ARMS.iter().all(|&arm| {
                let both = direction(i, 1, arm).zip(direction(i, -1, arm));
                both.is_some_and(|(on, back)| on.dot(back) >= -CORNER)
            })
        };
        let mut corners: Vec<usize> = (0..count).filter(turns).collect();
        // of coinciding vertices one is enough
        corners.dedup_by(|b, a| (self.vertices[*a].at - self.vertices[*b].at).length() < CORNER_ARMS[0]);
        corners
    }

    /// Whether it goes round: it is closed, or its ends lie in one place, and so it will be drawn closed.
    pub(super) fn goes_round(self) -> bool {
        let at = |vertex: Option<&Vertex>| vertex.map(|vertex| vertex.at);
        self.closed || at(self.vertices.first()) == at(self.vertices.last())
    }

    /// The corners of a line that goes round, which may stand on another line as the ends of an open one do: a leaf on
    /// its stem.
    pub(super) fn corners_of_ring(self) -> Vec<usize> {
        let ring = match (self.goes_round(), self.vertices) {
            (false, _) => return Vec::new(),
            (true, [ring @ .., _]) if !self.closed => PolylineRef { vertices: ring, closed: true },
            (true, _) => self,
        };
        ring.corners().into_iter().map(|corner| ring.tip_near(corner)).collect()
    }

    /// Of the vertices at a corner the one that is farthest out.
    fn tip_near(self, corner: usize) -> usize {
        let at = |i: usize| self.vertices[i].at;
        let along = |step: isize| (0..self.vertices.len() as isize).map_while(move |k| self.next(corner, k * step));
        let side = |step: isize| along(step).find(|&i| (at(i) - at(corner)).length() >= CORNER_ARMS[1]);
        let Some((on, back)) = side(1).zip(side(-1)) else { return corner };
        let out = |i: usize| (at(i) - at(back)).cross(at(on) - at(back)).abs();
        let near = |step: isize| along(step).take_while(move |&i| (at(i) - at(corner)).length() < CORNER_ARMS[0]);
        near(-1).chain(near(1)).max_by(|&a, &b| out(a).total_cmp(&out(b))).unwrap_or(corner)
    }
}

/// The segments of lines, to be found by their places.
pub(super) fn nearby<'a>(lines: impl Iterator<Item = &'a Polyline<Vertex>>, area: MmRect, params: &Params) -> Nearby {
    let mut segments = Nearby::new(area, params.max_spacing());
    for (line, polyline) in (0..).zip(lines) {
        segments.insert_line(line, polyline.view(), 0.0);
    }
    segments
}

/// Whether a colour step is none.
pub(super) fn is_no_step(step: [f32; 3]) -> bool {
    step.iter().all(|component| component.abs() <= 0.0)
}

#[cfg(test)]
mod tests;
