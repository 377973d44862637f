//! Textures make room for labels and their leader lines. What these leave of a texture beside them is left out where it
//! would be felt as something else: as dots by themselves, as a line, or as another texture.

use std::cmp::Reverse;

use super::placed::{Params, Placed};
use crate::geom::components;
use crate::geom::polygon::distance_to_box;
use crate::page::{Glyph, Texture};
use crate::units::{MmPoint, MmRect};

/// Takes the signs out of a texture that labels and their leader lines need blank, and what is left of it in strips, in
/// few rows, at ends of rows and by itself beside them.
pub(super) fn make_room(texture: &mut Texture, placed: &[&Placed], params: &Params) {
    let before = std::mem::take(&mut texture.glyphs);
    // from sign to sign, as if they lay in a square
    let step = (texture.area / before.len().max(1) as f32).sqrt();
    let is_apart = |glyph: &Glyph| placed.iter().all(|label| label.blank_to(glyph.at, params) >= glyph.radius());
    let mut left: Vec<Glyph> = before.iter().filter(|glyph| is_apart(glyph)).copied().collect();
    if left.len() < before.len() {
        leave_out_strips(&mut left, &before, step, placed);
    }
    if left.len() < before.len() && params.dot_pitch > 0.0 {
        let along = along(&before);
        leave_out_short_pieces(&mut left, &before, UNEVEN * along);
        leave_out_few_rows(&mut left, side_by_side(step, along), placed, params.least_texture);
    }
    let is_cut = left.len() < before.len();
    left = without_stray(left, &before, placed);
    texture.glyphs = if is_cut { without_torn(left, &before, step, placed) } else { left };
}

/// A label stands in a texture, too, if it takes a third as many signs as another, or more.
const ALSO_IN: usize = 3;

/// Which of the labels stand in a texture that is as it was before they did: the one that takes most of its signs, and
/// others that take about as many; what reaches into it from beside is none. Where none takes any itself, the one that
/// is nearest to its middle.
pub(super) fn labels_in(texture: &Texture, placed: &[&Placed], params: &Params) -> Vec<usize> {
    let takes = |glyph: &&Glyph, label: &Placed| label.blank_to(glyph.at, params) < glyph.radius();
    let count = |label: &Placed| texture.glyphs.iter().filter(|glyph| takes(glyph, label)).count();
    let mut counts: Vec<(usize, usize)> = placed.iter().map(|label| count(label)).enumerate().collect();
    let most = counts.iter().map(|(_, count)| *count).max().unwrap_or(0);
    if most == 0 {
        let middle = MmRect::from_points(texture.glyphs.iter().map(|glyph| glyph.at)).center();
        let far = |label: &usize| placed[*label].distance(middle);
        return (0..placed.len()).min_by(|a, b| far(a).total_cmp(&far(b))).into_iter().collect();
    }
    counts.retain(|(_, count)| ALSO_IN * count >= most);
    counts.sort_by_key(|(label, count)| (Reverse(*count), *label));
    counts.into_iter().map(|(label, _)| label).collect()
}

/// Signs without so many others of their area around them, within this distance, mm, are felt as dots by themselves; so
/// near to a label they are read as letters.
const COMPANY: usize = 2;
const AROUND: f32 = 9.0;
const NEAR_LABEL: f32 = 12.0;
/// Signs no further apart than this are of one part of a texture, mm: the widest steps of its rows, across; but where
/// its rows of dots are farther apart, as far as those are, with so much more, and no farther than the latter.
const SIDE_BY_SIDE: f32 = 5.7;
const UNEVEN: f32 = 1.1;
const FARTHEST_ROWS: f32 = 10.0;
/// Every how many-th sign is asked for its nearest.
const SAMPLED: usize = 20;

/// How far apart signs of one part of a texture are at most, mm: of one in steps of `step` mm, whose rows have a sign
/// every `along` mm.
fn side_by_side(step: f32, along: f32) -> f32 {
    let across = UNEVEN * step * step / along;
    SIDE_BY_SIDE.max(across.min(FARTHEST_ROWS))
}

/// How far apart the signs of a row are, mm: as far as the nearest ones.
fn along(signs: &[Glyph]) -> f32 {
    let to_others = |sign: &Glyph| {
        let others = signs.iter().filter(|other| other.at != sign.at);
        others.map(|other| (other.at - sign.at).length()).fold(f32::INFINITY, f32::min)
    };
    signs.iter().step_by(SAMPLED).map(to_others).fold(f32::INFINITY, f32::min)
}

/// The glyphs of a texture without those that are left alone beside labels, or farther off by what labels took of those
/// that were there `before`.
fn without_stray(glyphs: Vec<Glyph>, before: &[Glyph], placed: &[&Placed]) -> Vec<Glyph> {
    let company = |glyph: &Glyph, all: &[Glyph]| {
        let near = all.iter().filter(|other| (other.at - glyph.at).length() <= AROUND);
        near.take(COMPANY + 1).count() > COMPANY
    };
    let is_stray = |glyph: &Glyph| is_near(glyph, placed) || company(glyph, before);
    let kept: Vec<bool> = glyphs.iter().map(|glyph| company(glyph, &glyphs) || !is_stray(glyph)).collect();
    let mut kept = kept.into_iter();
    glyphs.into_iter().filter(|_| kept.next().unwrap_or(true)).collect()
}

/// Around a sign of a texture lie its neighbours within this distance, in steps of the texture: on a square lattice
/// eight, at an edge five. One beside a label that has less than this share of them left is in a column that the label
/// has cut off: there two of five are left.
const NEIGHBOURS: f32 = 1.6;
const KEPT_NEIGHBOURS: f32 = 0.45;

/// The glyphs of a texture without those beside labels that have lost most of their neighbours of `before`.
fn without_torn(glyphs: Vec<Glyph>, before: &[Glyph], step: f32, placed: &[&Placed]) -> Vec<Glyph> {
    let count = |of: &Glyph, all: &[Glyph]| {
        all.iter().filter(|other| (other.at - of.at).length() <= NEIGHBOURS * step).count().saturating_sub(1)
    };
    let is_whole = |of: &Glyph| count(of, &glyphs) as f32 >= KEPT_NEIGHBOURS * count(of, before) as f32;
    glyphs.iter().filter(|glyph| !is_near(glyph, placed) || is_whole(glyph)).copied().collect()
}

fn is_near(glyph: &Glyph, placed: &[&Placed]) -> bool {
    placed.iter().any(|label| label.distance(glyph.at) < NEAR_LABEL)
}

/// How far around a sign others are of its part of a texture, in steps of that; and the share of a whole circle of them
/// that a part of three rows has, and one of two has not.
const STEPS_AROUND: f32 = 2.5;
const BROAD: f32 = 0.6;

/// Leaves out what labels leave of a texture in strips of one or two rows beside them, as between a label and a line:
/// signs in a row are felt as a line. `before` are all signs of the texture, in steps of `step` mm.
fn leave_out_strips(left: &mut Vec<Glyph>, before: &[Glyph], step: f32, placed: &[&Placed]) {
    let reach = STEPS_AROUND * step;
    let far = |glyph: &Glyph| placed.iter().map(|label| label.distance(glyph.at)).fold(f32::INFINITY, f32::min);
    let near = |all: &[Glyph]| -> Vec<MmPoint> {
        all.iter().filter(|glyph| far(glyph) < NEAR_LABEL + 2.0 * reach).map(|glyph| glyph.at).collect()
    };
    let least = BROAD * std::f32::consts::PI * STEPS_AROUND * STEPS_AROUND;
    // whether a sign is within reach of one with so many around it
    let broad = |all: &[MmPoint]| -> Vec<MmPoint> {
        let around =
            |at: &&MmPoint| all.iter().filter(|other| (**other - **at).length() <= reach).count() as f32 >= least;
        all.iter().filter(around).copied().collect()
    };
    let (of_left, of_before) = (broad(&near(left)), broad(&near(before)));
    let is_in = |of: &[MmPoint], at: MmPoint| of.iter().any(|other| (*other - at).length() <= reach);
    left.retain(|glyph| far(glyph) >= NEAR_LABEL || is_in(&of_left, glyph.at) || !is_in(&of_before, glyph.at));
}

/// Fewest dots of a piece of a row that a label cut off: two or three in a row are letters of braille.
const LEAST_PIECE: usize = 4;

/// Leaves out pieces of rows of dots that labels cut off and that are too short to be felt as rows. `before` are all
/// dots of the texture, those that are left in the same order; dots of a row are no further apart than `apart` mm.
fn leave_out_short_pieces(left: &mut Vec<Glyph>, before: &[Glyph], apart: f32) {
    let pieces_of = |dots: &[Glyph]| -> Vec<usize> {
        let points: Vec<MmPoint> = dots.iter().map(|dot| dot.at).collect();
        let pieces = components::of_points(&points, apart, |between| between.length() <= apart);
        (0..points.len()).map(|dot| pieces[pieces.of(dot)].len()).collect()
    };
    let (lengths, whole) = (pieces_of(left), pieces_of(before));
    let mut lengths = lengths.into_iter();
    let mut all = before.iter().zip(whole);
    left.retain(|dot| {
        let length = lengths.next().unwrap_or(LEAST_PIECE);
        let whole = all.find(|(other, _)| other.at == dot.at).map_or(length, |(_, whole)| whole);
        length >= LEAST_PIECE || length == whole
    });
}

/// Leaves out parts of a texture that labels cut which lie beside their braille and are less than `least` mm high;
/// signs of one part are no further apart than `apart` mm.
fn leave_out_few_rows(glyphs: &mut Vec<Glyph>, apart: f32, placed: &[&Placed], least: f32) {
    let points: Vec<MmPoint> = glyphs.iter().map(|glyph| glyph.at).collect();
    let parts = components::of_points(&points, apart, |between| between.length() <= apart);
    components::retain(glyphs, &parts, |glyphs, part| {
        let extent = MmRect::from_points(part.iter().map(|&glyph| glyphs[glyph].at));
        let is_beside = |at: MmPoint| placed.iter().any(|label| distance_to_box(at, label.place) < NEAR_LABEL);
        extent.height() >= least || !part.iter().any(|&glyph| is_beside(glyphs[glyph].at))
    });
}

#[cfg(test)]
mod tests;
