//! SVG drawings: rendered by resvg at the working size itself, over white. Nothing outside the drawing is reached: no
//! files, no network. Pictures inside it (data: links) are drawn, under the same limits as pictures of their own.

use std::io::{Cursor, Read};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock};

use image::ImageDecoder;
use resvg::tiny_skia;
use usvg::fontdb::Database;
use usvg::roxmltree::{self, Document, ParsingOptions};
use usvg::{FontResolver, ImageHrefResolver, ImageKind, Tree};

use super::canvas::{FORMAT, MOST_FINER, canvas, canvases, check_canvases, density, render};
use super::colour::one_line;
use super::complexity;
use super::job::{
    self, DecodeOptions, Decoded, FontLoader, Header, Limits, OVER_LIMIT, check_memory, guarded, unpacks_too_far,
    working_bytes,
};
use super::outlined::{self, LettersAsPaths};
use super::texts::short;
use super::{filters, paths, place_names, texts};
use crate::raster::crop::PixelPart;
use crate::raster::vector::DrawnText;
use crate::units::Size;
use crate::{About, Error, Note, Reason};

/// Longest side of a drawing in CSS pixels: a kilometre of paper. Beyond it f32, in which usvg computes, is coarse.
const LONGEST_SIDE: f32 = 4_000_000.0;

/// Most remarks on one drawing; a drawing of a thousand links would hide all else.
const MOST_NOTES: usize = 8;

/// An SVG drawing compressed with gzip (SVGZ), or something else that is.
pub(super) fn decode_gzip(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    let limit = options.limits.memory_mb.saturating_mul(1_000_000);
    let mut text = Vec::new();
    // One byte more than the limit, to distinguish an end at the limit from a cut.
    let mut inflate = flate2::read::GzDecoder::new(bytes).take(limit.saturating_add(1));
    inflate.read_to_end(&mut text).map_err(|fault| Error::undecodable("SVGZ", one_line(&fault)))?;
    if text.len() as u64 > limit {
        return Err(unpacks_too_far("SVGZ", "the drawing", options.limits));
    }
    match super::sniff::format(&text) {
        Ok(super::sniff::PictureFormat::Svg) => decode(&text, options),
        _ => Err(Error::UnknownFormat { looks_like: Some("something compressed with gzip: unpack it first") }),
    }
}

/// The first bytes of what is packed in a file by gzip, at most so many; none if it is no such file.
pub(crate) fn start_of_packed(bytes: &[u8], most: u64) -> Option<Vec<u8>> {
    let mut start = Vec::new();
    let is_packed = bytes.starts_with(b"\x1f\x8b");
    // one that is cut or broken is told of when it is decoded
    let _ = is_packed.then(|| flate2::read::GzDecoder::new(bytes).take(most).read_to_end(&mut start))?;
    Some(start)
}

pub(super) fn decode(bytes: &[u8], options: &DecodeOptions<'_>) -> Result<Decoded, Error> {
    let text = std::str::from_utf8(bytes).map_err(|_| Error::undecodable(FORMAT, "it is not in UTF-8"))?;
    let left_out = DrawingLosses::default();
    let Trees { tree, with_texts, outlined } = trees(text, options, &left_out)?;
    let texts = |target: Target<'_>| {
        let Some(with_texts) = with_texts else { return Vec::new() };
        let mut found = texts::of_tree(&with_texts, target.transform, target.size);
        let letters = outlined.map(|outlined| outlined.of_tree(&with_texts, target.transform, target.size));
        found.extend(letters.unwrap_or_default());
        let (seen, unseen) = seen_of(found, &with_texts, &tree, target);
        texts::told_unseen(&unseen).into_iter().for_each(|told| left_out.add(Reason::NotSeen, told));
        place_names::joined(texts::sentences(seen), || paths::of_tree(&tree, target.transform))
    };
    drawn(&tree, options, texts).map(|decoded| with_notes(decoded, left_out))
}

/// What is drawn of a drawing.
struct Trees {
    tree: Tree,
    /// The same with its texts, if these are left out and it has some.
    with_texts: Option<Tree>,
    /// Those of its texts whose letters are paths.
    outlined: Option<LettersAsPaths>,
}

fn trees(text: &str, options: &DecodeOptions<'_>, left_out: &DrawingLosses) -> Result<Trees, Error> {
    let document = document(text, complexity::MOST_LEVELS)?;
    let outlined = if options.keep_text { None } else { outlined::of_document(text, &document) };
    let (tree, with_texts) = match &outlined {
        Some(found) => {
            let bare = checked_document(&found.bare)?;
            if options.pixels_only {
                parsed([&bare, &bare], true, options, left_out)?
            } else {
                parsed([&checked_document(&found.marked)?, &bare], true, options, left_out)?
            }
        }
        None => parsed([&document, &document], false, options, left_out)?,
    };
    Ok(Trees { tree, with_texts, outlined })
}

/// What is drawn of a document, and the same with its texts, if these are left out and it has some. `has_more`: the
/// first document has texts that are no elements of their own, and the second has not.
fn parsed(
    [marked, bare]: [&Document<'_>; 2],
    has_more: bool,
    options: &DecodeOptions<'_>,
    left_out: &DrawingLosses,
) -> Result<(Tree, Option<Tree>), Error> {
    let fonts = OnceLock::new();
    let parse = |document: &Document<'_>, font_resolver| {
        let image_href_resolver = links(left_out, options.limits);
        tree_of(document, &usvg::Options { image_href_resolver, font_resolver, ..usvg::Options::default() })
    };
    let with_fonts = || parse(marked, font_resolver(left_out, options.fonts, &fonts));
    // Without a font a text is not drawn.
    Ok(match (options.keep_text, options.pixels_only) {
        (true, _) => (with_fonts()?, None),
        (false, true) => (parse(bare, no_fonts())?, None),
        (false, false) => {
            let with_texts = with_fonts()?;
            match has_more || texts::has_any(with_texts.root()) {
                true => (parse(bare, no_fonts())?, Some(with_texts)),
                false => (with_texts, None),
            }
        }
    })
}

/// The pixels of a drawing.
#[derive(Clone, Copy)]
pub(super) struct Target<'a> {
    /// From the drawing to its pixels.
    pub(super) transform: tiny_skia::Transform,
    pub(super) size: Size,
    /// The drawing over white; none if it was rendered finer.
    canvas: Option<&'a tiny_skia::Pixmap>,
}

/// Texts that are seen in a drawing, and those that are not, by the drawing with its texts and without. All count as
/// seen where it would cost too much to look.
fn seen_of(
    texts: Vec<DrawnText>,
    with: &Tree,
    without: &Tree,
    Target { transform, size, canvas: known }: Target<'_>,
) -> (Vec<DrawnText>, Vec<DrawnText>) {
    let is_cheap = filters::check(with, transform, size, 1).is_ok()
        && paths::check_length(with, transform, size).is_ok()
        && check_canvases(with, transform, size).is_ok();
    let rendered = |tree: &Tree| unless_beyond_numbers(|| canvas(tree, transform, size)).ok()?.ok();
    let Some(with) = is_cheap.then(|| rendered(with)).flatten() else { return (texts, Vec::new()) };
    let own = if known.is_some() { None } else { rendered(without) };
    match known.or(own.as_ref()) {
        Some(without) => texts.into_iter().partition(|text| texts::is_seen(text, [&with, without])),
        None => (texts, Vec::new()),
    }
}

/// A page of a document that was made a drawing: SVG without texts. `texts` are those of the page.
#[cfg(feature = "pdf")]
pub(super) fn decode_page(
    text: &str,
    options: &DecodeOptions<'_>,
    texts: impl FnOnce(Target<'_>) -> Vec<DrawnText>,
) -> Result<Decoded, Error> {
    let left_out = DrawingLosses::default();
    let image_href_resolver = links(&left_out, options.limits);
    let parsing = usvg::Options { image_href_resolver, font_resolver: no_fonts(), ..usvg::Options::default() };
    let document = document(text, complexity::MOST_LEVELS)?;
    let tree = tree_of(&document, &parsing)?;
    drop((parsing, document));
    drawn(&tree, options, texts).map(|decoded| with_notes(decoded, left_out))
}

/// Renders a drawing, and asks for the texts that are left out of it.
fn drawn(
    tree: &Tree,
    options: &DecodeOptions<'_>,
    texts: impl FnOnce(Target<'_>) -> Vec<DrawnText>,
) -> Result<Decoded, Error> {
    let whole = nominal_size(tree.size())?;
    let part = job::part(whole, options)?;
    let source = Header { size: part.size, is_drawing: true };
    let target = (options.working_size)(source)?;
    if target.area() == 0 {
        return Err(Error::undecodable(FORMAT, format!("it cannot be drawn at {target} pixels")));
    }
    let limits = options.limits;
    if target.area() > limits.megapixels.saturating_mul(1_000_000) {
        let limit_megapixels = limits.megapixels;
        return Err(Error::TooManyPixels { size: target, limit_megapixels, remedy: OVER_LIMIT });
    }
    // Each group that is blended as a whole has a canvas of its own while it is drawn, and so has each one inside it.
    let canvases = 1 + canvases(tree.root());
    let bytes = |finer: u32| {
        let area = target.area().saturating_mul(u64::from(finer * finer));
        canvases.saturating_mul(area.saturating_mul(4)).saturating_add(working_bytes(target))
    };
    check_memory(FORMAT, target, bytes(1), limits)?;
    let transform = to_pixels(tree, whole, part, target);
    paths::check_length(tree, transform, target).map_err(|why| Error::too_complex(FORMAT, why))?;
    let filtered = |finer: u32| filters::check(tree, transform, target, finer);
    filtered(1).map_err(|why| Error::too_complex(FORMAT, why))?;
    let wanted = density(tree.root(), transform).ceil().min(MOST_FINER) as u32;
    let has_room =
        |finer: &u32| check_memory(FORMAT, target, bytes(*finer), limits).is_ok() && filtered(*finer).is_ok();
    let finer = (2..=wanted).rev().find(has_room).unwrap_or(1);
    let (raster, canvas) = unless_beyond_numbers(|| render(tree, transform, target, finer))??;
    // a finer one takes much memory
    let canvas = (finer == 1).then_some(canvas);
    if options.pixels_only {
        return Ok(Decoded { raster, lossy: None, source, drawing: None, texts: Vec::new(), notes: Vec::new() });
    }
    let drawing = unless_beyond_numbers(|| paths::of_tree(tree, transform))?;
    let notes = drawing.is_none().then(|| {
        let told = format!(
            "it has more than {} paths, so its lines are found in its pixels, as those of a picture",
            paths::MOST_PATHS
        );
        Note::TakenAs(About::Lines, Reason::ManyPaths, told.into())
    });
    let canvas = canvas.as_ref();
    let (texts, notes) = (texts(Target { transform, size: target, canvas }), notes.into_iter().collect());
    Ok(Decoded { raster, lossy: None, source, drawing, texts, notes })
}

/// The same with what is told of parts that are left out.
fn with_notes(decoded: Decoded, left_out: DrawingLosses) -> Decoded {
    Decoded { notes: left_out.notes().into_iter().chain(decoded.notes).collect(), ..decoded }
}

/// Runs usvg or resvg. usvg 0.49 panics on a picture inside a drawing that is so much wider than high that in f32 it
/// has no height where it is put (found by the test of damaged pictures, and a test of its own now).
pub(crate) fn unless_beyond_numbers<T>(work: impl FnOnce() -> T) -> Result<T, Error> {
    const WHY: &str = "it has places or sizes too large or too small to compute with (beside one another, as numbers \
                       have 7 digits)";
    guarded(work).map_err(|_| Error::too_complex(FORMAT, WHY))
}

/// What is drawn of a document.
///
/// # Errors
/// [`Error::Undecodable`] or [`Error::TooComplex`].
pub(crate) fn tree_of(document: &Document<'_>, parsing: &usvg::Options<'_>) -> Result<Tree, Error> {
    let parsed = unless_beyond_numbers(|| Tree::from_xmltree(document, parsing))?;
    parsed.map_err(|fault| match fault {
        usvg::Error::InvalidSize => {
            Error::undecodable(FORMAT, "it has no size: neither a width and height above zero nor a viewBox")
        }
        usvg::Error::ElementsLimitReached => Error::too_complex(FORMAT, complexity::too_many_elements()),
        other => Error::undecodable(FORMAT, one_line(&other)),
    })
}

/// From a drawing whose size counts as `whole` pixels to a canvas of `target` pixels that shows a part of it.
fn to_pixels(tree: &Tree, whole: Size, part: PixelPart, target: Size) -> tiny_skia::Transform {
    // Pixels that the canvas would have for all of the drawing.
    let whole_canvas = |target: u32, part: u32, whole: u32| f64::from(target) * (f64::from(whole) / f64::from(part));
    let width = whole_canvas(target.width, part.size.width, whole.width);
    let height = whole_canvas(target.height, part.size.height, whole.height);
    let (across, down) = (width as f32 / tree.size().width(), height as f32 / tree.size().height());
    let left = width * f64::from(part.left) / f64::from(whole.width);
    let top = height * f64::from(part.top) / f64::from(whole.height);
    tiny_skia::Transform::from_row(across, 0.0, 0.0, down, -left as f32, -top as f32)
}

/// The drawing's size in whole pixels. A size that is no whole number is doubled until rounding leaves its shape alone:
/// a drawing of 1 x 1.414 would become a square otherwise.
fn nominal_size(size: usvg::Size) -> Result<Size, Error> {
    // A tenth of a millimetre over the height of an A4 page is a 3000th.
    const SHAPE: f32 = 1.0 / 3000.0;
    let (mut width, mut height) = (size.width(), size.height());
    if width.max(height) > LONGEST_SIDE {
        let why =
            format!("its size of {width} x {height} pixels is beyond any page: no side can be over {LONGEST_SIDE}");
        return Err(Error::too_complex(FORMAT, why));
    }
    let keeps_shape = |width: f32, height: f32| {
        ((width.round() / width) / (height.round() / height) - 1.0).abs() <= SHAPE && width.min(height) >= 0.5
    };
    // At most 2^24 times: usvg has no size that is zero, but may have one that is as good as zero.
    for _ in 0..24 {
        if keeps_shape(width, height) || width.max(height) > LONGEST_SIDE {
            break;
        }
        (width, height) = (width * 2.0, height * 2.0);
    }
    let (width, height) = (width.round() as u32, height.round() as u32);
    if width == 0 || height == 0 {
        return Err(Error::undecodable(
            FORMAT,
            format!("its size of {} x {} pixels has no area", size.width(), size.height()),
        ));
    }
    Ok(Size::new(width, height))
}

/// The elements of a drawing, when usvg can take them.
///
/// # Errors
/// [`Error::Undecodable`] or [`Error::TooComplex`].
fn document(text: &str, most_levels: u32) -> Result<Document<'_>, Error> {
    let too_complex = |why: String| Error::too_complex(FORMAT, why);
    complexity::check_text(text).map_err(too_complex)?;
    let parsing = ParsingOptions { allow_dtd: true, nodes_limit: complexity::MOST_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, parsing).map_err(|fault| {
        if matches!(fault, roxmltree::Error::NodesLimitReached) {
            return too_complex(complexity::too_many_elements());
        }
        let place = fault.pos();
        let what = one_line(&fault);
        // Most messages of roxmltree end with the position; here it comes first, in words.
        let what = what.trim_end_matches(&format!(" at {place}"));
        Error::undecodable(FORMAT, format!("line {}, column {}: {what}", place.row, place.col))
    })?;
    complexity::check(&document, most_levels).map_err(too_complex)?;
    Ok(document)
}

/// The elements of a drawing that usvg can take without end or overflow, for others who give it to usvg.
///
/// # Errors
/// [`Error::Undecodable`] or [`Error::TooComplex`], which say what is wrong and where.
pub(crate) fn checked_document(text: &str) -> Result<Document<'_>, Error> {
    document(text, complexity::MOST_LEVELS)
}

/// What is left out of a drawing, each once. usvg asks for links and fonts from closures that have to be `Sync`.
#[derive(Default)]
struct DrawingLosses(Mutex<Vec<(Reason, String)>>);

impl DrawingLosses {
    fn add(&self, why: Reason, what: String) {
        let loss = (why, what);
        if let Ok(mut list) = self.0.lock()
            && !list.contains(&loss)
        {
            list.push(loss);
        }
    }

    fn notes(self) -> Vec<Note> {
        let mut list = self.0.into_inner().unwrap_or_default();
        let more = list.len().saturating_sub(MOST_NOTES);
        list.truncate(MOST_NOTES);
        if more > 0 {
            list.push((Reason::AndMore, format!("{more} more links or texts")));
        }
        list.into_iter().map(|(why, what)| Note::LeftOut(why, what)).collect()
    }
}

fn links<'a>(left_out: &'a DrawingLosses, limits: Limits) -> ImageHrefResolver<'a> {
    let inside = ImageHrefResolver::default_data_resolver();
    let level = AtomicUsize::new(0);
    ImageHrefResolver {
        resolve_data: Box::new(move |mime, data, options| {
            let found = match size_of_picture(&data) {
                Ok(Some(size)) if is_over(size, limits) => {
                    let most = limits.megapixels;
                    let told = format!(
                        "a picture inside the drawing, of {size} pixels, which is over the limit of {most} megapixels \
                         (raise it, or make that picture smaller)"
                    );
                    left_out.add(Reason::OverLimit, told);
                    return None;
                }
                Ok(Some(_)) => inside(mime, data, options),
                Ok(None) => drawing_inside(&data, options, &level),
                Err(Unreadable) => None,
            };
            if found.is_none() {
                let told = format!("a picture inside the drawing, which cannot be read ({})", short(mime));
                left_out.add(Reason::Unreadable, told);
            }
            found
        }),
        resolve_string: Box::new(move |href, _| {
            let told = format!("the linked picture {} (only pictures inside the drawing are used)", short(href));
            left_out.add(Reason::Elsewhere, told);
            None
        }),
    }
}

/// A drawing inside a drawing, but none inside that; `level` counts how deep it goes.
fn drawing_inside(data: &[u8], options: &usvg::Options<'_>, level: &AtomicUsize) -> Option<ImageKind> {
    // All of them share the stack.
    const MOST_LEVELS: usize = 1;
    document(std::str::from_utf8(data).ok()?, complexity::MOST_LEVELS_INSIDE).ok()?;
    let tree = (level.fetch_add(1, Ordering::Relaxed) < MOST_LEVELS).then(|| Tree::from_data_nested(data, options));
    level.fetch_sub(1, Ordering::Relaxed);
    Some(ImageKind::SVG(tree?.ok()?))
}

/// Whether a picture inside a drawing costs too much: it is decoded whole, and drawn from a canvas of its own.
fn is_over(size: Size, limits: Limits) -> bool {
    let memory = size.area().saturating_mul(8);
    size.area() > limits.megapixels.saturating_mul(1_000_000) || check_memory(FORMAT, size, memory, limits).is_err()
}

/// A picture whose header cannot be read.
struct Unreadable;

/// The size in the header of a picture inside a drawing; `None` for a drawing or an unknown format.
fn size_of_picture(data: &[u8]) -> Result<Option<Size>, Unreadable> {
    use super::sniff::{PictureFormat, format};
    let reader = Cursor::new(data);
    let size = match format(data) {
        Ok(PictureFormat::Png) => {
            let mut decoder = png::Decoder::new(reader);
            let info = decoder.read_header_info().ok();
            let sound = info.filter(|info| super::png::check_palette(info.color_type, data).is_ok());
            sound.map(|info| (info.width, info.height))
        }
        Ok(PictureFormat::Jpeg) => {
            let mut decoder = jpeg_decoder::Decoder::new(data);
            let info = decoder.read_info().ok().and_then(|()| decoder.info());
            info.map(|info| (info.width.into(), info.height.into()))
        }
        Ok(PictureFormat::Gif) => image::codecs::gif::GifDecoder::new(reader).ok().map(|decoder| decoder.dimensions()),
        Ok(PictureFormat::WebP) => {
            image::codecs::webp::WebPDecoder::new(reader).ok().map(|decoder| decoder.dimensions())
        }
        _ => return Ok(None),
    };
    size.map(|(width, height)| Some(Size::new(width, height))).ok_or(Unreadable)
}

/// Fonts are asked for with the first text that needs one: finding those of a computer takes longer than most drawings.
fn font_resolver<'a>(
    left_out: &'a DrawingLosses,
    fonts: &'a FontLoader<'a>,
    asked: &'a OnceLock<Arc<Database>>,
) -> FontResolver<'a> {
    let select = FontResolver::default_font_selector();
    FontResolver {
        select_font: Box::new(move |font, database| {
            if database.is_empty() {
                *database = asked.get_or_init(fonts).clone();
            }
            let found = select(font, database);
            if found.is_none() {
                let families = font.families().iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
                left_out.add(Reason::NoFonts, format!("a text, for which there is no font ({})", short(&families)));
            }
            found
        }),
        select_fallback: FontResolver::default_fallback_selector(),
    }
}

/// Finds no font for any text.
fn no_fonts() -> FontResolver<'static> {
    FontResolver { select_font: Box::new(|_, _| None), select_fallback: FontResolver::default_fallback_selector() }
}
