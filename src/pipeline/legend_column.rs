//! A legend whose patches of colour stand in a column, such as that of a map, with what else stands in it: samples of
//! lines and of signs, each with its word. The key has only what colours mean, so these are told.

use super::legend_patches::{Patch, are_in_column, are_of_different_colours, patches};
use super::on_sheet::on_sheet;
use super::texts::Text;
use super::unwritten::named;
use crate::edges::Edges;
use crate::geom::polygon::holds_box;
use crate::raster::Raster;
use crate::raster::lab::pixel;
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note, Reason};

/// Fewest patches of a column, of different colours: two small shapes may be above one another by chance.
const LEAST: usize = 3;
/// They are of one size: width and height, as shares of those of others.
const ALIKE: f32 = 0.8;
/// A shape that has less than this share of the area of a patch is a sign.
const SIGN: f32 = 0.5;
/// A row of samples is no farther from another one than so many of the steps between patches.
const NEXT: f32 = 1.5;
/// Samples reach so far beyond the width and the height of patches at most, mm.
const BEYOND: f32 = 1.0;
/// A line spans at least this share of the width of a patch.
const OF_WIDTH: f32 = 0.6;

/// Patches in a column, from the top to the bottom, with words that begin in line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Column {
    pub(super) patches: Vec<Patch>,
    /// The word of the first patch.
    word: MmRect,
    /// The numbers of the words of samples of lines and signs.
    others: Vec<usize>,
}

/// A sample of a line or a sign that stands in a column of patches.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sample {
    /// The number of its word.
    pub(super) text: usize,
    is_line: bool,
    /// Its contours.
    pub(super) chains: Vec<usize>,
}

impl Column {
    /// The largest one of a drawing.
    pub(super) fn find(edges: &Edges, texts: &[Text], raster: &Raster, transform: &PageTransform) -> Option<Self> {
        let colour = |patch: &Patch| pixel(raster, patch.middle);
        let column = Self::of(&patches(edges, texts, raster, transform), texts, colour)?;
        Some(column.with_others(edges, texts, transform))
    }

    /// The largest one of these shapes, each of another colour.
    fn of(shapes: &[Patch], texts: &[Text], colour: impl Fn(&Patch) -> [f32; 3]) -> Option<Self> {
        let is_with = |a: &Patch, b: &Patch| {
            let words = [a, b].map(|patch| texts[patch.text].place);
            are_in_column([a.place, b.place], words) && are_alike(a.place, b.place)
        };
        let column =
            |first: &Patch| -> Vec<Patch> { shapes.iter().filter(|other| is_with(first, other)).copied().collect() };
        let mut largest: Vec<Patch> = Vec::new();
        for own in shapes.iter().map(column) {
            if own.len() > largest.len() {
                largest = own;
            }
        }
        let colours: Vec<[f32; 3]> = largest.iter().map(colour).collect();
        if largest.len() < LEAST || !are_of_different_colours(&colours) {
            return None;
        }
        largest.sort_by(|a, b| a.place.min.y.total_cmp(&b.place.min.y));
        let word = texts[largest[0].text].place;
        Some(Self { patches: largest, word, others: Vec::new() })
    }

    /// Whether a shape is too small for one of its patches.
    pub(super) fn is_sign(&self, shape: MmRect) -> bool {
        shape.area() < SIGN * self.patches[0].place.area()
    }

    /// The column with the samples above, between and below its patches, no more than a row from one another.
    fn with_others(self, edges: &Edges, texts: &[Text], transform: &PageTransform) -> Self {
        let places = places_of(edges, transform);
        let is_other = |text: &usize| texts[*text].is_read() && self.patches.iter().all(|patch| patch.text != *text);
        let is_sample = |text: &usize| self.sample(*text, texts, edges, &places).is_some();
        let mut left: Vec<usize> = (0..texts.len()).filter(is_other).filter(is_sample).collect();
        let height = |text: usize| texts[text].place.center().y;
        let mut rows: Vec<f32> = self.patches.iter().map(|patch| patch.place.center().y).collect();
        let farthest = NEXT * rows.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f32::max);
        let mut others = Vec::new();
        let is_next = |rows: &[f32], text: usize| rows.iter().any(|row| (row - height(text)).abs() <= farthest);
        while let Some(next) = left.iter().position(|text| is_next(&rows, *text)) {
            others.push(left.remove(next));
            rows.extend(others.last().map(|text| height(*text)));
        }
        Self { others, ..self }
    }

    /// Whether a text is the word of a sample in it.
    pub(super) fn has_sample(&self, text: usize) -> bool {
        self.others.contains(&text)
    }

    /// Its samples whose words are `own`, but for those that became labels of their lines.
    pub(super) fn samples(
        &self,
        edges: &Edges,
        texts: &[Text],
        transform: &PageTransform,
        own: &[bool],
    ) -> Vec<Sample> {
        let places = places_of(edges, transform);
        let own = self.others.iter().filter(|text| own[**text] && !texts[**text].of_legend);
        own.filter_map(|text| self.sample(*text, texts, edges, &places)).collect()
    }

    /// What lies beside a word in the column of patches, if that is in line with them.
    fn sample(&self, text: usize, texts: &[Text], edges: &Edges, places: &[MmRect]) -> Option<Sample> {
        let (patch, word) = (self.patches[0].place, texts[text].place);
        if !are_in_column([patch, patch], [self.word, word]) {
            return None;
        }
        let half = 0.5 * patch.height().max(word.height());
        let row = MmRect::new(
            MmPoint::new(patch.min.x, word.center().y - half),
            MmPoint::new(patch.max.x, word.center().y + half),
        );
        let row = row.inflate(BEYOND, BEYOND);
        let chains: Vec<usize> = (0..places.len()).filter(|&chain| holds_box(row, places[chain])).collect();
        let place = chains.iter().map(|chain| places[*chain]).reduce(|a, b| a.union(&b))?;
        let is_line =
            |chain: &usize| !edges.chains[*chain].closed && places[*chain].width() >= OF_WIDTH * patch.width();
        let is_line = chains.iter().any(is_line);
        are_in_column([patch, place], [self.word, word]).then_some(Sample { text, is_line, chains })
    }
}

/// Whether two shapes are of one size.
fn are_alike(a: MmRect, b: MmRect) -> bool {
    let alike = |a: f32, b: f32| a.min(b) >= ALIKE * a.max(b);
    alike(a.width(), b.width()) && alike(a.height(), b.height())
}

/// The boxes around contours.
fn places_of(edges: &Edges, transform: &PageTransform) -> Vec<MmRect> {
    edges.chains.iter().map(|chain| MmRect::from_points(on_sheet(edges, chain, transform))).collect()
}

/// What is told of samples that are left out with a legend of colours.
pub(super) fn told(samples: &[Sample], texts: &[Text]) -> Vec<Note> {
    let names = |is_line: bool| -> Option<String> {
        let own = samples.iter().filter(|sample| sample.is_line == is_line);
        let names: Vec<&str> = own.map(|sample| texts[sample.text].string.as_str()).collect();
        (!names.is_empty()).then(|| named(&names))
    };
    let lines = names(true).map(|names| {
        let why = "as all lines are alike on the page; write each word with a label at its own line";
        let told = format!("the samples of lines in the legend ({names}), {why}");
        Note::NotOnPage(About::Lines, Reason::ColoursOfLines, told.into())
    });
    let signs = names(false).map(|names| {
        let why = "they would be felt as signs of the drawing; say in the title or a label what its signs stand for";
        let told = format!("the samples of signs in the legend ({names}): {why}");
        Note::NotOnPage(About::Lines, Reason::LegendOfSigns, told.into())
    });
    lines.into_iter().chain(signs).collect()
}

#[cfg(test)]
mod tests;
