//! A legend of signs, as that of a scatter plot: one sign of each kind with a word beside it, which tells what the
//! points stand for. On a page a sample would be felt as one more point. So samples are left out, and with them their
//! words and their frame, which say nothing alone.

use super::legend_frames::{OF_PATCH, boxes, frames};
use super::legend_patches::{IN_LINE, are_in_column, gap, is_in_column_of};
use super::on_sheet::on_sheet;
use super::texts::Text;
use super::told_signs;
use super::unwritten::named;
use crate::edges::{ChainRange, Edges};
use crate::geom::polygon::holds_box;
use crate::page::layout::Layout;
use crate::raster::Raster;
use crate::units::{MmPoint, MmRect, PageTransform};
use crate::{About, Note, Reason, Told};

/// A word stands so far beside its sample at most, mm, or so many times the size of its font: in Matplotlib 1.5 times.
const FARTHEST: f32 = 8.0;
const FARTHEST_IN_FONTS: f32 = 2.0;
/// A frame lies so far around samples and words at most, in sizes of their font: what is wider may hold a point that
/// has a name.
const AROUND: f32 = 2.5;
/// Without a frame, samples stand in a column or a row, and at most this share of all other signs has a word beside
/// it: else words are names of points, or their values.
const NAMED: f32 = 0.2;

/// A sign on the sheet.
#[derive(Debug, Clone, PartialEq)]
struct PlacedSign {
    chain: usize,
    kind: u8,
    is_filled: bool,
    place: MmRect,
    /// The word beside it, of which it is the nearest sign.
    word: Option<usize>,
    /// Contours in a bitmap beside it that are letters of its word, where these were not taken for text.
    letters: Vec<usize>,
}

/// Takes a legend of signs out of a drawing. Tells of it.
pub(super) fn taken_out(edges: &mut Edges, texts: &mut [Text], raster: &Raster, layout: &Layout) -> Option<Note> {
    let transform = PageTransform::new(edges.size, layout.figure);
    let signs = signs(edges, texts, &transform);
    if signs.iter().all(|sign| sign.word.is_none()) {
        return None;
    }
    let is_other = |(_, chain): &(usize, &ChainRange)| chain.kind.sign.is_none() && !chain.kind.exact;
    let others = edges.chains.iter().enumerate().filter(is_other);
    let others: Vec<(usize, MmRect)> = others.map(|(of, chain)| (of, place_of(edges, chain, &transform))).collect();
    let boxes: Vec<MmRect> = boxes(edges, &transform).into_iter().map(|frame| frame.place).collect();
    let framed = in_frame(&signs, texts, &boxes, &others);
    let samples = if framed.is_empty() { in_line(&signs, texts) } else { framed };
    if samples.is_empty() {
        return None;
    }
    for sample in &samples {
        if let Some(word) = sample.word {
            let of_sign = texts[word].is_read().then_some(sample.is_filled);
            (texts[word].of_legend, texts[word].of_sign) = (true, of_sign);
        }
    }
    let patches: Vec<MmRect> = samples.iter().map(|of| of.place.inflate(OF_PATCH, OF_PATCH)).collect();
    let is_of_sample = |chain: usize| samples.iter().any(|of| of.chain == chain || of.letters.contains(&chain));
    let of_samples: Vec<bool> = (0..edges.chains.len()).map(is_of_sample).collect();
    let of_frame = frames(edges, &of_samples, &patches, texts, raster, &transform);
    let mut gone = of_samples.into_iter().zip(of_frame).map(|(of_sample, of_frame)| of_sample || of_frame);
    edges.chains.retain(|_| !gone.next().unwrap_or(false));
    let told = format!("{}: its samples would be felt as points of the drawing", legend_with(&samples, texts));
    Some(Note::NotOnPage(About::Lines, Reason::LegendOfSigns, helped(told, told_signs::are_of_kinds(edges))))
}

/// The legend of these samples in words, with what is known of theirs.
fn legend_with(samples: &[PlacedSign], texts: &[Text]) -> String {
    let words = samples.iter().filter_map(|of| Some(&texts[of.word?])).filter(|text| text.is_read());
    let names: Vec<&str> = words.map(|text| text.string.as_str()).collect();
    let legend = "the legend in the figure";
    match (names.len(), samples.len() - names.len()) {
        (0, _) => format!("{legend}, whose words nobody has read"),
        (_, 0) => format!("{legend} ({})", named(&names)),
        (_, 1) => format!("{legend} ({}, and 1 word that nobody has read)", named(&names)),
        (_, unread) => format!("{legend} ({}, and {unread} words that nobody has read)", named(&names)),
    }
}

/// What helps against a legend that is not on the page; where points are `of_kinds`, what is told of these says it, and
/// gives the words of the legend.
fn helped(told: String, of_kinds: bool) -> Told {
    let told = Told::from(told);
    if of_kinds { told } else { told.or("say in the title or a label what the points stand for") }
}

/// The signs among contours, each with its word.
fn signs(edges: &Edges, texts: &[Text], transform: &PageTransform) -> Vec<PlacedSign> {
    let sign = |(chain, of): (usize, &ChainRange)| {
        let kind = of.kind.sign?;
        let (place, is_filled) = (place_of(edges, of, transform), of.kind.stroke.is_none());
        Some(PlacedSign { chain, kind, is_filled, place, word: word_of(place, texts), letters: Vec::new() })
    };
    let mut signs: Vec<PlacedSign> = edges.chains.iter().enumerate().filter_map(sign).collect();
    let far = |sign: &PlacedSign, word: usize| gap(sign.place, texts[word].place);
    let is_nearest = |sign: &PlacedSign| {
        sign.word.is_some_and(|word| {
            let mut rivals = signs.iter().filter(|other| other.word == Some(word));
            rivals.all(|other| far(sign, word) <= far(other, word))
        })
    };
    let are_nearest: Vec<bool> = signs.iter().map(is_nearest).collect();
    signs.iter_mut().zip(are_nearest).for_each(|(sign, is_nearest)| sign.word = sign.word.filter(|_| is_nearest));
    signs
}

/// The word at the side of a sign, at its height, whether it was read or not.
fn word_of(sign: MmRect, texts: &[Text]) -> Option<usize> {
    let is_beside = |text: &Text| {
        let off = (sign.center().y - text.place.center().y).abs();
        let farthest = FARTHEST.max(FARTHEST_IN_FONTS * text.size);
        let is_level = off <= 0.5 * sign.height().max(text.place.height());
        !text.hidden && is_level && (0.0..=farthest).contains(&gap(sign, text.place))
    };
    let beside = (0..texts.len()).filter(|&text| is_beside(&texts[text]));
    beside.min_by(|&a, &b| gap(sign, texts[a].place).total_cmp(&gap(sign, texts[b].place)))
}

fn place_of(edges: &Edges, chain: &ChainRange, transform: &PageTransform) -> MmRect {
    MmRect::from_points(on_sheet(edges, chain, transform))
}

/// The samples in the frame of a legend: all signs that it holds, each with its word, and not much more. If these are
/// one of each kind in a column, words may be unread, and all but one may be shapes that are no texts, which are among
/// the `others`.
fn in_frame(signs: &[PlacedSign], texts: &[Text], boxes: &[MmRect], others: &[(usize, MmRect)]) -> Vec<PlacedSign> {
    let all = kinds(signs);
    let samples = |frame: &MmRect| -> Option<Vec<PlacedSign>> {
        let inside = signs.iter().filter(|sign| frame.contains(sign.place.center()));
        let mut samples: Vec<PlacedSign> = inside.cloned().collect();
        for sample in &mut samples {
            sample.word = sample.word.filter(|word| frame.contains(texts[*word].place.center()));
        }
        let is_read = |of: &PlacedSign| of.word.is_some_and(|word| texts[word].is_read());
        let is_column = || samples.iter().all(|of| is_in_column_of(of.place, samples[0].place));
        let has_each_kind = || all > 1 && samples.len() == all && kinds(&samples) == all;
        if !(samples.iter().all(is_read) || has_each_kind() && is_column()) {
            return None;
        }
        for sample in &mut samples {
            sample.letters = letters(sample.place, *frame, others);
        }
        let words: Vec<&Text> = samples.iter().filter_map(|of| Some(&texts[of.word?])).collect();
        let has_words = !words.is_empty() && samples.iter().all(|of| of.word.is_some() || !of.letters.is_empty());
        let places = samples.iter().map(|of| of.place).chain(words.iter().map(|of| of.place));
        let around = places.reduce(|a, b| a.union(&b)).filter(|_| has_words)?;
        let most = AROUND * words.iter().map(|of| of.size).fold(0.0, f32::max);
        holds_box(around.inflate(most, most), *frame).then_some(samples)
    };
    boxes.iter().filter_map(samples).max_by_key(Vec::len).unwrap_or_default()
}

/// The shapes beside a sample in a frame that are no higher than letters of its size, without the sides of the frame.
fn letters(sample: MmRect, frame: MmRect, others: &[(usize, MmRect)]) -> Vec<usize> {
    let row = MmRect::new(
        MmPoint::new(frame.min.x + OF_PATCH, sample.min.y - 0.5 * sample.height()),
        MmPoint::new(frame.max.x - OF_PATCH, sample.max.y + 0.5 * sample.height()),
    );
    let is_beside = |(_, place): &&(usize, MmRect)| holds_box(row, *place) && !place.intersects(&sample);
    others.iter().filter(is_beside).map(|(chain, _)| *chain).collect()
}

/// How many kinds of signs there are.
fn kinds(of: &[PlacedSign]) -> usize {
    let mut kinds: Vec<u8> = of.iter().map(|sign| sign.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds.len()
}

/// The samples of a legend without a frame: one of each kind, two kinds and more, in a column or a row.
fn in_line(signs: &[PlacedSign], texts: &[Text]) -> Vec<PlacedSign> {
    let with_words = || signs.iter().filter(|sign| sign.word.is_some_and(|word| texts[word].is_read()));
    let is_in_line = |a: &PlacedSign, b: &PlacedSign| {
        let words = a.word.zip(b.word).map(|(a, b)| [texts[a].place, texts[b].place]);
        let in_column = words.is_some_and(|words| are_in_column([a.place, b.place], words));
        in_column || (a.place.center().y - b.place.center().y).abs() <= IN_LINE
    };
    let all = kinds(signs);
    let samples = |first: &PlacedSign| -> Option<Vec<PlacedSign>> {
        let own: Vec<PlacedSign> = with_words().filter(|sign| is_in_line(first, sign)).cloned().collect();
        let others = with_words().count() - own.len();
        let are_few = others as f32 <= NAMED * (signs.len() - own.len()) as f32;
        (all > 1 && own.len() == all && kinds(&own) == all && are_few).then_some(own)
    };
    with_words().find_map(samples).unwrap_or_default()
}

#[cfg(test)]
mod tests;
