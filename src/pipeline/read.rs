//! A picture is decoded, and the text in its pixels taken out of it.

use super::given::Given;
use super::misread::{ReadAt, off_their_scales};
use super::progress::{Event, ONE_COLOUR, Stage, Watch, run_stage};
use super::request::{LayoutOf, Request, working_size};
use super::text_reader::TextReader;
use crate::edges::PictureKind;
use crate::lettering::{self, FoundLine, Lettering};
use crate::paper::{Capture, Paper};
use crate::picture::Picture;
use crate::raster::Raster;
use crate::raster::decode::{self, DecodeOptions, Header};
use crate::raster::rim::Rim;
use crate::raster::vector::{DrawnText, PixelArea, VectorDrawing};
use crate::units::{PxPoint, Size};
use crate::{About, Error, Note, Reason};

/// Letters of a drawing are looked for in a picture so many times as fine as the working picture, where there is one:
/// at 4 px a millimetre, a letter of 2 mm is too small to be told from its neighbours.
const FINER: u32 = 2;
/// A picture that is less finer than this shows no more, as a ratio of widths. Small letters lose much when they are
/// shrunk by a little: of those of 9 to 11 px at the axes of four charts, half at 1.05 to 1.15.
const LEAST_FINER: f32 = 1.02;
/// Size of a font, in heights of its letters: between 1.4 (capitals) and 2 (small letters).
const FONT_SIZE: f32 = 1.6;

/// A picture, and what is known of it.
#[derive(Clone)]
pub(super) struct Read {
    pub(super) picture: decode::Decoded,
    pub(super) content: Content,
    /// Whether its ground was taken for paper, which is divided out.
    pub(super) is_on_paper: bool,
}

/// A picture as it was given, and as it was read for its size on the sheet.
#[derive(Clone)]
pub(super) struct ReadPicture<'p> {
    pub(super) file: Picture<'p>,
    pub(super) read: Read,
}

impl<'p> ReadPicture<'p> {
    /// Reads a picture that lies where `layout_of` its size says.
    pub(super) fn of(
        file: Picture<'p>,
        given: &Given,
        request: &Request<'_>,
        layout_of: &LayoutOf<'_>,
        watch: &mut Watch<'_>,
    ) -> Result<Self, Error> {
        let working_size = |source: Header| working_size(source, layout_of, &request.fit, request.plan);
        let read = read(file, &request.decoding(&working_size), given.text_reader.as_ref(), watch)?;
        Ok(Self { file, read })
    }

    /// Whether it has texts that are not drawn.
    pub(super) fn has_texts(&self) -> bool {
        !self.read.picture.texts.is_empty()
    }
}

/// What is known of a picture before contours are looked for.
#[derive(Clone)]
pub(super) enum Content {
    /// It is of one colour: there is nothing to find.
    Uniform,
    /// It is a vector drawing, whose contours come from its paths, none of which is a letter that is left out: nobody
    /// asks of what kind its pixels are.
    OfPaths,
    /// Pixels of this kind.
    OfKind(PictureKind),
}

impl Content {
    fn of(raster: &Raster, kind: Option<PictureKind>) -> Self {
        match kind {
            _ if raster.is_flat() => Self::Uniform,
            None => Self::OfPaths,
            Some(kind) => Self::OfKind(kind),
        }
    }

    pub(super) fn is_uniform(&self) -> bool {
        matches!(self, Self::Uniform)
    }

    /// What kind of picture it is, if that is known.
    pub(super) fn kind(&self) -> Option<&PictureKind> {
        match self {
            Self::Uniform | Self::OfPaths => None,
            Self::OfKind(kind) => Some(kind),
        }
    }
}

/// Decodes a picture. Unless letters are to be kept, text in its pixels is taken out, and joins those texts that the
/// decoder has left out, with the words that `reader` gives.
///
/// # Errors
/// As [`decode::decode_picture`].
pub(super) fn read(
    given: Picture<'_>,
    options: &DecodeOptions<'_>,
    reader: Option<&TextReader>,
    watch: &mut Watch<'_>,
) -> Result<Read, Error> {
    let (known, paper) = run_stage(watch, Stage::Decode, || decoded(given, options))?;
    let reason = if options.keep_text {
        "letters are drawn"
    } else if known.content.is_uniform() {
        ONE_COLOUR
    } else if matches!(known.content, Content::OfPaths) {
        "no paths are letters"
    } else {
        return Ok(run_stage(watch, Stage::Text, || without_text(known, paper.as_ref(), given, options, reader)));
    };
    watch(Event::Skip(Stage::Text, reason));
    Ok(known)
}

/// A picture of lines: no text is looked for in its pixels, where small closed lines look like letters.
///
/// # Errors
/// As [`decode::decode_picture`].
pub(super) fn read_lines(given: Picture<'_>, options: &DecodeOptions<'_>) -> Result<Read, Error> {
    decoded(given, options).map(|(known, _)| known)
}

/// A decoded picture; if it is a drawing that was scanned, on white paper in even light, with the paper that it was on.
fn decoded(given: Picture<'_>, options: &DecodeOptions<'_>) -> Result<(Read, Option<Paper>), Error> {
    let picture = decode::decode_picture(given, options)?;
    let content = Content::of(&picture.raster, None);
    // a drawing of paths alone was never on paper
    let is_painted = picture.drawing.as_ref().is_some_and(|drawing| drawing.pixel_areas.is_empty());
    let may_be_paper = !is_painted && !options.keep_ground;
    let needs_no_kind = is_painted && (options.keep_text || picture.drawing.as_ref().is_some_and(has_no_letters));
    Ok(match content.is_uniform() || needs_no_kind {
        true => (Read { picture, content, is_on_paper: false }, None),
        false => on_white_paper(picture, may_be_paper),
    })
}

/// What kind of picture it is, and its paper divided out where it may be on paper.
fn on_white_paper(picture: decode::Decoded, may_be_paper: bool) -> (Read, Option<Paper>) {
    let kind_of = if picture.drawing.is_none() { PictureKind::of_bitmap } else { PictureKind::of };
    let kind = kind_of(&picture.raster, picture.lossy);
    if !kind.is_drawing && may_be_paper {
        return (Read { picture: without_rim(picture), content: Content::OfKind(kind), is_on_paper: false }, None);
    }
    let paper = if kind.is_drawing && may_be_paper {
        let capture = Capture { noise: kind.noise_of_lightness(), lossy: picture.lossy.is_some() };
        Paper::of(&picture.raster, capture)
    } else {
        None
    };
    let Some(found) = &paper else {
        return (Read { picture, content: Content::OfKind(kind), is_on_paper: false }, None);
    };
    let raster = found.divided(&picture.raster);
    let (colour, darkest) = (found.colour, (100.0 * found.darkest).round() as u32);
    let mut notes = picture.notes;
    notes.push(Note::GroundAsPaper { colour, darkest });
    let content = Content::of(&raster, Some(kind.again_of(&raster)));
    (Read { picture: decode::Decoded { raster, notes, ..picture }, content, is_on_paper: true }, paper)
}

/// A photograph without the rim that a scanner gave it: it would be lines along the edge, and sides of all that
/// touches it.
fn without_rim(picture: decode::Decoded) -> decode::Decoded {
    let Some(rim) = Rim::of(&picture.raster) else { return picture };
    let size = picture.raster.size();
    let percent = |width: usize, across: u32| (100 * width).div_ceil(across as usize) as u32;
    let Rim([left, top, right, bottom]) = rim;
    let sides = [
        ("left", percent(left, size.width)),
        ("upper", percent(top, size.height)),
        ("right", percent(right, size.width)),
        ("lower", percent(bottom, size.height)),
    ];
    let mut notes = picture.notes;
    notes.push(Note::RimLeftOut(sides.into_iter().filter(|(_, percent)| *percent > 0).collect()));
    decode::Decoded { raster: rim.filled(&picture.raster), notes, ..picture }
}

fn without_text(
    known: Read,
    paper: Option<&Paper>,
    picture: Picture<'_>,
    options: &DecodeOptions<'_>,
    reader: Option<&TextReader>,
) -> Read {
    let Read { picture: decoded, content, is_on_paper } = known;
    let is_drawing = content.kind().is_some_and(|kind| kind.is_drawing);
    let working = decoded.raster.size();
    let finer = if is_drawing { finer(picture, &decoded, options) } else { None };
    let finer = match (finer, paper) {
        (Some(finer), Some(paper)) => Some(paper.divided(&finer)),
        (finer, _) => finer,
    };
    let raster = finer.as_ref().unwrap_or(&decoded.raster);
    let scale = working.width as f32 / raster.size().width as f32;
    let is_painted = |line: &FoundLine| {
        let of_drawing = decoded.drawing.as_ref();
        of_drawing.is_none_or(|drawing| holds_letters(drawing, line, scale))
    };
    let found = Lettering::find(raster, is_drawing).keeping(is_painted);
    if found.is_empty() {
        return Read { picture: decoded, content, is_on_paper };
    }
    let mut notes = decoded.notes;
    let mut words = reader.and_then(|reader| {
        let why = |why| notes.push(Note::TextsNotRead(why));
        reader.words(&found, raster).map_err(why).ok()
    });
    if let Some(words) = &mut words {
        let odd = without_misread(words, &found);
        notes.extend(told_read(words, &odd));
    }
    let word = |at: usize| words.as_mut().map_or_else(String::new, |words| std::mem::take(&mut words[at]));
    let new = found.lines.iter().zip((0..).map(word)).map(|(line, string)| text(line, string, scale));
    let texts = decoded.texts.into_iter().chain(new).collect();
    let erased = found.erased_from(raster);
    let raster = if finer.is_some() { erased.shrunk(working) } else { erased };
    // without its letters it may be of another kind, unless it is on paper
    let kind = match paper.and(content.kind()) {
        Some(kind) => Some(kind.again_of(&raster)),
        None => decoded.drawing.is_none().then(|| PictureKind::of_bitmap(&raster, decoded.lossy)),
    };
    let content = Content::of(&raster, kind);
    Read { picture: decode::Decoded { raster, texts, notes, ..decoded }, content, is_on_paper }
}

/// Takes out the words that were seen to be read wrongly; gives them.
fn without_misread(words: &mut [String], found: &Lettering) -> Vec<String> {
    let place = |line: &FoundLine| {
        let DrawnText { min, max, .. } = text(line, String::new(), 1.0);
        ReadAt { middle: min.lerp(max, 0.5), height: line.height }
    };
    let places: Vec<ReadAt> = found.lines.iter().map(place).collect();
    off_their_scales(words, &places).into_iter().map(|at| std::mem::take(&mut words[at])).collect()
}

/// What the maker is told of texts in pixels that somebody has read: a word that was read wrongly is found by reading
/// the list, and nowhere else. Some, `odd`, were seen to be.
fn told_read(words: &[String], odd: &[String]) -> Option<Note> {
    let read: Vec<String> = words.iter().filter(|text| !text.is_empty()).map(|text| format!("\"{text}\"")).collect();
    let odd: Vec<String> = odd.iter().map(|text| format!("\"{text}\"")).collect();
    let left_out = match odd.is_empty() {
        true => String::new(),
        false => {
            format!("; left out, as the other numbers of the row or column step evenly without: {}", odd.join(", "))
        }
    };
    let unread = match words.len() - read.len() - odd.len() {
        0 => String::new(),
        1 => "; 1 text could not be read".to_owned(),
        count => format!("; {count} texts could not be read"),
    };
    let told = format!("read from the pixels, and to be looked through: {}{left_out}{unread}", read.join(", "));
    (!read.is_empty()).then_some(Note::TakenAs(About::Texts, Reason::ReadFromPixels, told.into()))
}

/// The picture once more, finer than the working picture; none if there is no finer one, or it is over a limit.
fn finer(picture: Picture<'_>, decoded: &decode::Decoded, options: &DecodeOptions<'_>) -> Option<Raster> {
    let working = decoded.raster.size();
    let wanted = |source: Header| {
        let side = |side: u32, own: u32| {
            let wanted = side.saturating_mul(FINER);
            if source.is_drawing { wanted } else { wanted.min(own) }
        };
        Size::new(side(working.width, source.size.width), side(working.height, source.size.height))
    };
    if (wanted(decoded.source).width as f32) < LEAST_FINER * working.width as f32 {
        return None;
    }
    let working_size = |source: Header| Ok(wanted(source));
    let options = DecodeOptions { working_size: &working_size, pixels_only: true, ..*options };
    decode::decode_picture(picture, &options).ok().map(|picture| picture.raster)
}

/// Whether a drawing has paths alone, and none of them can be letters.
fn has_no_letters(drawing: &VectorDrawing) -> bool {
    drawing.pixel_areas.is_empty() && !paints_letters(drawing, 1.0 / FINER as f32, SEVERAL, |_| true, |_| true)
}

/// Whether what was found in the pixels of a drawing may be letters that its paths paint, each by itself: a piece of a
/// longer outline, such as that of a cloud, is none. `scale` is that of the working picture.
fn holds_letters(drawing: &VectorDrawing, line: &FoundLine, scale: f32) -> bool {
    let DrawnText { min, max, .. } = text(line, String::new(), scale);
    let reach = PxPoint::splat(AROUND_LETTERS * line.height * scale + 1.0).to_vector();
    let (min, max) = (min - reach, max + reach);
    let meets = |area: &PixelArea| area.min.x < max.x && area.max.x > min.x && area.min.y < max.y && area.max.y > min.y;
    let is_inside =
        |area: &PixelArea| area.min.x >= min.x && area.max.x <= max.x && area.min.y >= min.y && area.max.y <= max.y;
    let fewest = if line.may_be_one_letter() { 1 } else { SEVERAL };
    drawing.pixel_areas.iter().any(meets) || paints_letters(drawing, scale, fewest, meets, is_inside)
}

/// A text of several letters is as many parts of paths at least.
const SEVERAL: usize = 2;

/// Whether so many parts of paths at least, of those that are at some place and whose paths are near it, are as small
/// as letters, and not all of them straight strokes, such as the ticks of a clock, or bars and dots. The working
/// picture is `scale` times as large as the one in which letters are looked for.
fn paints_letters(
    drawing: &VectorDrawing,
    scale: f32,
    fewest: usize,
    is_near: impl Fn(&PixelArea) -> bool,
    is_there: impl Fn(&PixelArea) -> bool,
) -> bool {
    let (mut letters, mut has_bent) = (0, false);
    for painted in &drawing.paths {
        let of = painted.path.bounds();
        let (min, max) = (PxPoint::new(of.left(), of.top()), PxPoint::new(of.right(), of.bottom()));
        if !is_near(&PixelArea { min, max }) {
            continue;
        }
        let is_letter = |area: &PixelArea| is_there(area) && lettering::may_be_letters((area.max - area.min) / scale);
        let count = painted.parts().iter().filter(|area| is_letter(area)).count();
        letters += count;
        has_bent |= count > 0 && painted.may_be_letters();
        if letters >= fewest && has_bent {
            return true;
        }
    }
    false
}

/// How far beyond the box of a text its letters reach, as a share of their height: tails of small letters.
const AROUND_LETTERS: f32 = 0.4;

/// A line as a text of the working picture, which is smaller by `scale`.
fn text(line: &FoundLine, string: String, scale: f32) -> DrawnText {
    let corners = line.corners.map(|at| at * scale);
    let side = |of: fn(f32, f32) -> f32, axis: fn(&PxPoint) -> f32| corners.iter().map(axis).reduce(of).unwrap_or(0.0);
    DrawnText {
        string,
        min: PxPoint::new(side(f32::min, |at| at.x), side(f32::min, |at| at.y)),
        max: PxPoint::new(side(f32::max, |at| at.x), side(f32::max, |at| at.y)),
        angle: line.angle,
        size: FONT_SIZE * line.height * scale,
        hidden: false,
    }
}
