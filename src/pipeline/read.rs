//! A picture is decoded, and the text in its pixels taken out of it.

use super::progress::{Event, Stage, Watch, run};
use crate::Error;
use crate::edges;
use crate::lettering::{FoundLine, Lettering};
use crate::picture::Picture;
use crate::raster::Raster;
use crate::raster::decode::{self, Options, Source};
use crate::raster::vector::DrawnText;
use crate::units::{PxPoint, Size};

/// Letters of a drawing are looked for in a picture so many times as fine as the working picture, where there is one:
/// at 4 px a millimetre, a letter of 2 mm is too small to be told from its neighbours.
const FINER: u32 = 2;
/// A picture that is less finer than this shows no more, as a ratio of widths.
const LEAST_FINER: f32 = 1.15;
/// Size of a font, in heights of its letters: between 1.4 (capitals) and 2 (small letters).
const FONT_SIZE: f32 = 1.6;

/// Decodes a picture. Unless letters are to be kept, text in its pixels is taken out, and joins those texts that the
/// decoder has left out, with no string.
///
/// # Errors
/// As [`decode::decode_picture`].
pub(super) fn read(
    picture: Picture<'_>,
    options: &Options<'_>,
    watch: &mut Watch<'_>,
) -> Result<decode::Picture, Error> {
    let decoded = run(watch, Stage::Decode, || decode::decode_picture(picture, options))?;
    if options.keep_text {
        watch(Event::Skip(Stage::Text, "letters are drawn"));
    } else if !decoded.raster.is_flat() {
        return Ok(run(watch, Stage::Text, || without_text(decoded, picture, options)));
    }
    Ok(decoded)
}

fn without_text(decoded: decode::Picture, picture: Picture<'_>, options: &Options<'_>) -> decode::Picture {
    let is_drawing = edges::is_drawing(&decoded.raster);
    let working = decoded.raster.size();
    let finer = if is_drawing { finer(picture, &decoded, options) } else { None };
    let raster = finer.as_ref().unwrap_or(&decoded.raster);
    let found = Lettering::find(raster, is_drawing);
    if found.is_empty() {
        return decoded;
    }
    let scale = working.width as f32 / raster.size().width as f32;
    let texts = decoded.texts.into_iter().chain(found.lines.iter().map(|line| text(line, scale))).collect();
    let erased = found.erased_from(raster);
    let raster = if finer.is_some() { shrunk(&erased, working) } else { erased };
    decode::Picture { raster, texts, ..decoded }
}

/// The picture once more, finer than the working picture; none if there is no finer one, or it is over a limit.
fn finer(picture: Picture<'_>, decoded: &decode::Picture, options: &Options<'_>) -> Option<Raster> {
    let working = decoded.raster.size();
    let wanted = |source: Source| {
        let side = |side: u32, own: u32| {
            let wanted = side.saturating_mul(FINER);
            if source.is_drawing { wanted } else { wanted.min(own) }
        };
        Size::new(side(working.width, source.size.width), side(working.height, source.size.height))
    };
    if (wanted(decoded.source).width as f32) < LEAST_FINER * working.width as f32 {
        return None;
    }
    let working_size = |source: Source| Ok(wanted(source));
    let options = Options { working_size: &working_size, ..*options };
    decode::decode_picture(picture, &options).ok().map(|picture| picture.raster)
}

fn shrunk(raster: &Raster, size: Size) -> Raster {
    let shrink = |plane: &Vec<f32>| crate::raster::shrink::shrink(plane, raster.size(), size).values;
    Raster::new(size, raster.planes().as_ref().map(shrink))
}

/// A line as a text of the working picture, which is smaller by `scale`.
fn text(line: &FoundLine, scale: f32) -> DrawnText {
    let corners = line.corners.map(|at| at * scale);
    let side = |of: fn(f32, f32) -> f32, axis: fn(&PxPoint) -> f32| corners.iter().map(axis).reduce(of).unwrap_or(0.0);
    DrawnText {
        string: String::new(),
        min: PxPoint::new(side(f32::min, |at| at.x), side(f32::min, |at| at.y)),
        max: PxPoint::new(side(f32::max, |at| at.x), side(f32::max, |at| at.y)),
        angle: line.angle,
        size: FONT_SIZE * line.height * scale,
        hidden: false,
    }
}
