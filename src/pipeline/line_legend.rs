//! A legend of lines: short pieces of lines with words beside them, which tell by their colours what curves mean. On a
//! page all lines are alike and a sample says nothing, so each word becomes the label of its curve.

use super::legend::{MOST, places_along};
use super::legend_column::Column;
use super::legend_frames::{OF_PATCH, frames};
use super::legend_patches::{SAME, gap, is_beside};
use super::on_sheet::on_sheet;
use super::texts::Text;
use super::unwritten::named;
use crate::edges::Edges;
use crate::geom::{nearest_on_segment, polyline};
use crate::page::layout::Layout;
use crate::raster::Raster;
use crate::raster::contrast::{self, dot as cosine};
use crate::raster::lab::pixel;
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note, Reason};

/// How long a sample of a line is, mm: in print 5 to 10 mm, of a drawing that may be larger or smaller on the page.
const SAMPLE: std::ops::RangeInclusive<f32> = 2.5..=25.0;
/// It is level: so high at most, mm.
const LEVEL: f32 = 0.5;
/// Nothing but its own marker is so near to it, mm: it is no tick, and leads to nothing.
const FREE: f32 = 0.5;
/// Samples are about as long as one another, as a share, and stand in a column or a row, mm.
const ALIKE: f32 = 0.75;
const IN_LINE: f32 = 1.0;
/// A stroke differs by so much from its ground where its colour is looked at, in square roots of linear light.
const INK: f32 = 0.1;
/// Places of one stroke have one colour, and a sample has that of its curve: the cosine between the ways from the
/// ground to both (8 degrees). A thin stroke is blended with its ground: that changes how far it is, not the way.
const ONE_COLOUR: f32 = 0.99;
/// A stroke that is so broad, px, has its own colour in its middle.
const BROAD: f32 = 3.0;
/// Samples have different colours (15 degrees).
const OTHER: f32 = 0.966;
/// The way from a ground to grey.
const GREY: Colour = [0.577_35; 3];
/// A marker on a sample reaches so far beside it at most, as a share of its length.
const MARKER: f32 = 0.35;
/// Curves are so long at least, mm: longer than most samples.
const LEAST: f32 = 20.0;
/// A line is straight if its chord is at least this share of it: one with a word at its end may be a leader line (see
/// `leaders`), so its word stands at its side.
const STRAIGHT: f32 = 0.97;
/// A word stands at a curve where others are so far at least, mm; farther than this they need not be.
const APART: f32 = 4.0;
const ENOUGH: f32 = 15.0;
/// An end is as good as another place that is farther from other curves by this, mm.
const AT_END: f32 = 3.0;
/// Places are looked at between so many parts of a curve, and so many times as many where signs may be on it.
const PARTS: usize = 10;
const FINER: usize = 4;
/// A small shape with a text so near, mm, is a sign with a name, as a stop of a bus line: a word there would be taken
/// for its name. Chosen by us.
const SIGN: f32 = 8.0;
const TO_NAME: f32 = 4.0;
/// Half of the side of the box for which a word stands then, mm.
const HALF: f32 = 0.5;

/// The unit vector from the colour of a ground to that of a stroke on it.
type Colour = [f32; 3];

/// A sample of a line, the number of its word, and its colour.
#[derive(Debug, Clone, PartialEq)]
struct Sample {
    text: usize,
    place: MmRect,
    colour: Colour,
    ink: Option<[f32; 3]>,
}

/// A line that a sample may stand for.
struct Curve {
    chain: usize,
    length: f32,
    colour: Colour,
    ink: Option<[f32; 3]>,
    /// Whether it is level or upright, as axes are.
    is_axial: bool,
}

/// The contours of a drawing on the sheet.
struct Contours<'a> {
    edges: &'a Edges,
    raster: &'a Raster,
    points: Vec<Vec<MmPoint>>,
    /// The boxes around them.
    places: Vec<MmRect>,
}

/// Takes a legend of lines whose words would become labels out of a drawing, and has each word stand at its curve:
/// two samples and more, or single ones in a column of patches of colour. How many there are, and what is told of them.
pub(super) fn to_curves(
    edges: &mut Edges,
    texts: &mut [Text],
    (is_label, column): (impl Fn(&Text) -> bool, Option<&Column>),
    raster: &Raster,
    layout: &Layout,
) -> Option<(usize, Note)> {
    let labels = texts.iter().filter(|text| is_label(text)).count();
    if labels < 2 || raster.is_grey() || !edges.of_drawing() {
        return None;
    }
    let transform = PageTransform::new(edges.size, layout.figure);
    let contours = Contours::of(edges, raster, &transform);
    let (samples, places) = contours.legend(texts, is_label, column)?;
    let own: Vec<MmRect> = samples.iter().map(|sample| with_marker(sample.place)).collect();
    let is_of_sample = |points: &Vec<MmPoint>| own.iter().any(|sample| points.iter().all(|at| sample.contains(*at)));
    let of_samples: Vec<bool> = contours.points.iter().map(is_of_sample).collect();
    for (sample, at) in samples.iter().zip(places) {
        texts[sample.text].place = MmRect::new(at, at).inflate(HALF, HALF);
    }
    let patches: Vec<MmRect> = samples.iter().map(|sample| sample.place.inflate(OF_PATCH, OF_PATCH)).collect();
    let of_frame = frames(edges, &of_samples, &patches, texts, raster, &transform);
    let mut gone = of_samples.into_iter().zip(of_frame).map(|(of_sample, of_frame)| of_sample || of_frame);
    edges.chains.retain(|_| !gone.next().unwrap_or(false));
    let names: Vec<&str> = samples.iter().map(|sample| texts[sample.text].string.as_str()).collect();
    let told = "each word is the label of its line, and the samples are left out, as all lines are alike on the page";
    let told = format!("the legend of lines in the figure ({}): {told}", named(&names));
    Some((names.len(), Note::TakenAs(About::Lines, Reason::LegendAtLines, told.into())))
}

impl<'a> Contours<'a> {
    fn of(edges: &'a Edges, raster: &'a Raster, transform: &PageTransform) -> Self {
        let points: Vec<Vec<MmPoint>> =
            edges.chains.iter().map(|chain| on_sheet(edges, chain, transform).collect()).collect();
        let places = points.iter().map(MmRect::from_points).collect();
        Self { edges, raster, points, places }
    }

    /// The samples of a legend, each with the place of its word at its curve.
    fn legend(
        &self,
        texts: &[Text],
        is_label: impl Fn(&Text) -> bool,
        column: Option<&Column>,
    ) -> Option<(Vec<Sample>, Vec<MmPoint>)> {
        let all = self.samples(texts, is_label);
        let is_in = |of: &&Sample| column.is_some_and(|column| column.has_sample(of.text));
        let of_column: Vec<Sample> = all.iter().filter(is_in).cloned().collect();
        // many lines are grey or black
        let is_coloured = |of: &Sample| cosine(of.colour, GREY).abs() <= OTHER;
        let samples = in_line(all);
        if samples.len() < 2 && of_column.is_empty() {
            return None;
        }
        let (curves, signs) = (self.curves(), self.named_signs(texts, &samples));
        let place = |sample: &Sample| self.place_at(sample, &curves, &signs);
        let are_other = |a: &Sample, b: &Sample| cosine(a.colour, b.colour) <= OTHER;
        let is_other = |a: &Sample| samples.iter().all(|b| std::ptr::eq(a, b) || are_other(a, b));
        let is_legend = samples.len() > 1 && samples.iter().all(is_other);
        let places: Option<Vec<MmPoint>> = if is_legend { samples.iter().map(place).collect() } else { None };
        let (mut samples, mut places) = places.map(|places| (samples, places)).unwrap_or_default();
        for sample in &of_column {
            let is_known = samples.iter().any(|other| other.text == sample.text);
            let mut others = samples.iter().chain(&of_column).filter(|other| other.text != sample.text);
            let is_clear = is_coloured(sample) && others.all(|other| are_other(sample, other));
            if let Some(at) = place(sample).filter(|_| is_clear && !is_known) {
                samples.push(sample.clone());
                places.push(at);
            }
        }
        (!samples.is_empty()).then_some((samples, places))
    }

    /// Short level strokes, each with a word at its side; none where there are too many.
    fn samples(&self, texts: &[Text], is_label: impl Fn(&Text) -> bool) -> Vec<Sample> {
        let mut found: Vec<Sample> = Vec::new();
        for (chain, &place) in self.places.iter().enumerate() {
            if !self.is_open_stroke(chain) || !SAMPLE.contains(&place.width()) || place.height() > LEVEL {
                continue;
            }
            let beside = (0..texts.len()).filter(|&text| is_label(&texts[text]) && is_beside(place, texts[text].place));
            let nearest = beside.min_by(|&a, &b| gap(place, texts[a].place).total_cmp(&gap(place, texts[b].place)));
            let Some(text) = nearest.filter(|text| !found.iter().any(|other| other.text == *text)) else { continue };
            if let Some(colour) = self.colour(chain).filter(|_| self.is_free(chain)) {
                found.push(Sample { text, place, colour, ink: self.ink(chain) });
            }
        }
        if found.len() > MOST { Vec::new() } else { found }
    }

    /// Lines that samples may stand for.
    fn curves(&self) -> Vec<Curve> {
        let curve = |chain: usize| {
            let length = polyline::length(&self.points[chain]);
            if !self.is_open_stroke(chain) || length < LEAST {
                return None;
            }
            let is_axial = self.places[chain].width().min(self.places[chain].height()) <= LEVEL;
            Some(Curve { chain, length, colour: self.colour(chain)?, ink: self.ink(chain), is_axial })
        };
        (0..self.points.len()).filter_map(curve).collect()
    }

    /// The middles of small shapes that have names of their own.
    fn named_signs(&self, texts: &[Text], samples: &[Sample]) -> Vec<MmPoint> {
        let is_name = |text: usize| texts[text].is_read() && samples.iter().all(|sample| sample.text != text);
        let has_name = |place: &MmRect| {
            let near = place.inflate(TO_NAME, TO_NAME);
            (0..texts.len()).any(|text| is_name(text) && near.intersects(&texts[text].place))
        };
        let closed = self.edges.chains.iter().zip(&self.places).filter(|(chain, _)| chain.closed);
        let small = closed.map(|(_, place)| *place).filter(|place| place.width().max(place.height()) <= SIGN);
        small.filter(has_name).map(|place| place.center()).collect()
    }

    /// Where the word of a sample stands at its curve: the longest of its colour, or a level or upright one if it is
    /// the only one.
    fn place_at(&self, sample: &Sample, curves: &[Curve], signs: &[MmPoint]) -> Option<MmPoint> {
        let has_ink = |of: &Curve| of.ink.zip(sample.ink).is_some_and(|(a, b)| contrast::distance(a, b) < SAME);
        let is_own = |curve: &&Curve| cosine(curve.colour, sample.colour) >= ONE_COLOUR || has_ink(curve);
        let (own, others): (Vec<&Curve>, Vec<&Curve>) = curves.iter().partition(is_own);
        let longer = own.iter().filter(|curve| curve.length > 2.0 * sample.place.width());
        let (axial, bent): (Vec<&Curve>, Vec<&Curve>) = longer.copied().partition(|curve| curve.is_axial);
        let longest = bent.into_iter().max_by(|a, b| a.length.total_cmp(&b.length));
        let curve = longest.or_else(|| axial.first().copied().filter(|_| axial.len() == 1))?;
        let others = others.into_iter().filter(|other| !other.is_axial);
        let others: Vec<&[MmPoint]> = others.map(|other| &self.points[other.chain][..]).collect();
        best_place(&self.points[curve.chain], &others, signs)
    }

    fn is_open_stroke(&self, chain: usize) -> bool {
        let of = &self.edges.chains[chain];
        !of.closed && of.kind.of_drawing && of.kind.stroke.is_some() && !of.kind.faint && !of.kind.added
    }

    /// Whether nothing is at a sample but gridlines and what is no longer than it, as its marker.
    fn is_free(&self, sample: usize) -> bool {
        let near = self.places[sample].inflate(FREE, FREE);
        let own = with_marker(self.places[sample]);
        let is_at = |other: usize| {
            let points = &self.points[other];
            self.places[other].inflate(FREE, FREE).intersects(&near)
                && points.iter().any(|at| near.contains(*at))
                && !points.iter().all(|at| own.contains(*at))
        };
        !(0..self.points.len()).any(|other| other != sample && !self.edges.chains[other].kind.faint && is_at(other))
    }

    /// The colour of most of a stroke where it is seen on its ground.
    fn colour(&self, chain: usize) -> Option<Colour> {
        let chain = &self.edges.chains[chain];
        let places = places_along(self.edges, chain, chain.kind.stroke?, self.raster);
        let seen: Vec<Colour> =
            places.into_iter().filter_map(|(at, ground)| colour_on(self.raster, at, ground?)).collect();
        let count = |colour: Colour| seen.iter().filter(|other| cosine(**other, colour) >= ONE_COLOUR).count();
        seen.iter().copied().max_by_key(|colour| count(*colour)).filter(|colour| 2 * count(*colour) > seen.len())
    }

    /// The colour of most of a stroke that is so broad that pixels in its middle have no other in them: it may lie on
    /// another ground than its sample.
    fn ink(&self, chain: usize) -> Option<[f32; 3]> {
        let chain = &self.edges.chains[chain];
        let width = chain.kind.stroke.filter(|width| *width >= BROAD)?;
        let places = places_along(self.edges, chain, width, self.raster);
        let seen: Vec<[f32; 3]> = places.into_iter().map(|(at, _)| pixel(self.raster, at)).collect();
        let is_most = |ink: &[f32; 3]| {
            2 * seen.iter().filter(|other| contrast::distance(**other, *ink) < SAME).count() > seen.len()
        };
        seen.iter().copied().find(is_most)
    }
}

/// The box of a sample with the marker on it.
fn with_marker(sample: MmRect) -> MmRect {
    let beside = MARKER * sample.width();
    sample.inflate(beside, beside)
}

/// The colour of the pixel that differs most from that of the ground, of one and those around it: the middle of a thin
/// stroke lies between pixels. None where there is no stroke.
fn colour_on(raster: &Raster, at: usize, ground: usize) -> Option<Colour> {
    let (width, height) = (raster.size().width as usize, raster.size().height as usize);
    let light = |at: usize, plane: &Vec<f32>| plane[at].max(0.0).sqrt();
    let way = |at: usize| -> Colour {
        let mut planes = raster.planes().iter().map(|plane| light(at, plane) - light(ground, plane));
        std::array::from_fn(|_| planes.next().unwrap_or(0.0))
    };
    let columns = beside(at % width, width);
    let pixels = beside(at / width, height).flat_map(|y| columns.clone().map(move |x| y * width + x));
    let far = pixels.map(way).max_by(|a, b| contrast::length(*a).total_cmp(&contrast::length(*b)))?;
    let all = contrast::length(far);
    (all >= INK).then(|| far.map(|part| part / all))
}

/// A number of so many, and those next to it.
fn beside(number: usize, count: usize) -> std::ops::RangeInclusive<usize> {
    number.saturating_sub(1)..=(number + 1).min(count - 1)
}

/// The samples that stand in a column or a row with others which are about as long.
fn in_line(samples: Vec<Sample>) -> Vec<Sample> {
    let is_with = |a: MmRect, b: MmRect| {
        let off = (a.min.x - b.min.x).abs().min((a.center().y - b.center().y).abs());
        off <= IN_LINE && a.width().min(b.width()) >= ALIKE * a.width().max(b.width())
    };
    let has_other = |number: usize| {
        let mut others = samples.iter().enumerate().filter(|(other, _)| *other != number);
        others.any(|(_, other)| is_with(samples[number].place, other.place))
    };
    let mut stay = (0..samples.len()).map(has_other).collect::<Vec<bool>>().into_iter();
    samples.into_iter().filter(|_| stay.next().unwrap_or(false)).collect()
}

/// The place of a curve at which its word is taken for that of no other: an end, the right one rather than the left, or
/// one that is clearly farther from other curves; and from `signs` with names of their own, if it can be. None where
/// there is no such place.
fn best_place(curve: &[MmPoint], others: &[&[MmPoint]], signs: &[MmPoint]) -> Option<MmPoint> {
    let (&first, &last) = (curve.first()?, curve.last()?);
    let far = |at: MmPoint| {
        let segments = others.iter().flat_map(|other| other.windows(2));
        let from_signs = signs.iter().map(|sign| (*sign - at).length());
        segments.map(|pair| nearest_on_segment(at, pair[0], pair[1]).0).chain(from_signs).fold(ENOUGH, f32::min)
    };
    let is_straight = (last - first).length() >= STRAIGHT * polyline::length(curve);
    let ends = if first.x > last.x { [first, last] } else { [last, first] };
    let ends = ends.into_iter().filter(|_| !is_straight).map(|at| (at, AT_END));
    // not near the ends of a straight line either
    let finer = if signs.is_empty() { 1 } else { FINER };
    let (from, parts) = (if is_straight { 3 * finer } else { 1 }, PARTS * finer);
    let inner = (from..=parts - from).map(|part| (curve[part * (curve.len() - 1) / parts], 0.0));
    let mut best: Option<(MmPoint, f32)> = None;
    for (at, more) in ends.chain(inner) {
        let far = far(at);
        let is_better = best.is_none_or(|(_, most)| far + more > most);
        if far >= APART && is_better {
            best = Some((at, far + more));
        }
    }
    match best {
        // it has signs everywhere
        None if !signs.is_empty() => best_place(curve, others, &[]),
        best => best.map(|(at, _)| at),
    }
}

#[cfg(test)]
mod tests;
