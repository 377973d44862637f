//! What there is on a page before it is drawn: its texts with their places, and whether its pictures are within the
//! limits.

use std::collections::HashSet;

use hayro_interpret::encode::EncodedShadingType;
use hayro_interpret::font::GlyphRun;
use hayro_interpret::hayro_syntax::page::Page;
use hayro_interpret::kurbo::{Affine, BezPath, Point, Rect, Shape};
use hayro_interpret::pattern::Pattern;
use hayro_interpret::{
    BlendMode, CacheKey, ClipPath, Context, Device, DrawMode, DrawProps, Image, ImageDrawProps, InterpreterCache,
    InterpreterSettings, Paint, SoftMask, TransformExt, interpret_page,
};

use super::letters::{self, FormLetter};
use super::unpacked::FORMAT;
use super::words::{Letter, Texts, Written};
use crate::Error;
use crate::raster::decode::job::{Limits, OVER_LIMIT, check_memory};
use crate::units::Size;

/// Memory for a pixel of a picture inside a page while it is decoded and written as PNG, or drawn, with copies.
const BYTES_PER_PIXEL: u64 = 14;

/// Memory for a pixel of any of the pictures of a page, as text of the drawing and as PNG, at most.
const BYTES_PER_PIXEL_KEPT: u64 = 8;

/// What a page has.
pub(super) struct PageContent {
    pub(super) texts: Vec<Written>,
    /// Letters and other signs of which the document does not tell which they are.
    pub(super) unknown_letters: usize,
    /// How hayro-svg begins the elements of forms that are letters.
    pub(super) form_letters: Vec<String>,
}

/// # Errors
/// If a picture on the page is over a limit.
pub(super) fn of_page(page: &Page<'_>, settings: &InterpreterSettings, limits: Limits) -> Result<PageContent, Error> {
    let (width, height) = page.render_dimensions();
    let sheet = Rect::new(0.0, 0.0, f64::from(width), f64::from(height));
    let cache = InterpreterCache::new();
    let to_page = page.initial_transform(true).to_kurbo();
    let mut context = Context::new(to_page, sheet, &cache, page.xref(), settings.clone());
    let mut survey = Survey {
        limits,
        seen: vec![sheet],
        texts: Texts::default(),
        forms: FormLetter::all_of(page),
        line: Vec::new(),
        last_run: None,
        inside: 0,
        known: HashSet::new(),
        pixels: 0,
        fault: None,
    };
    interpret_page(page, &mut context, &mut survey);
    survey.end_line();
    let Survey { texts, forms, fault, .. } = survey;
    let (texts, unknown_letters) = texts.finish();
    let form_letters = forms.iter().map(FormLetter::element).collect();
    fault.map_or(Ok(PageContent { texts, unknown_letters, form_letters }), Err)
}

struct Survey {
    limits: Limits,
    /// Boxes of the clips that are in force; of the page first.
    seen: Vec<Rect>,
    texts: Texts,
    /// Forms that are letters.
    forms: Vec<FormLetter>,
    /// Letters of one line and the boxes in which they are seen, until the line is whole.
    line: Vec<(Letter, Option<Rect>)>,
    /// Where the last run of letters begins, and how many it has.
    last_run: Option<(Point, usize)>,
    /// How many masks and patterns deep: texts in those are not read.
    inside: u32,
    /// Masks and patterns that were looked into.
    known: HashSet<u128>,
    /// Of all pictures, as often as they are drawn.
    pixels: u64,
    fault: Option<Error>,
}

impl Survey {
    fn clip(&mut self, area: Rect) {
        let seen = self.seen.last().copied().unwrap_or(area).intersect(area);
        self.seen.push(seen);
    }

    /// Adds a letter. Where a page has forms that are letters, which come behind the others of their line, those wait
    /// for them.
    fn add(&mut self, letter: Letter) {
        let seen = self.seen.last().copied();
        if self.forms.is_empty() {
            self.texts.add(letter, seen);
            return;
        }
        if self.line.last().is_some_and(|(last, _)| !letters::is_on_line(last, &letter)) {
            self.end_line();
        }
        self.line.push((letter, seen));
    }

    /// Adds the letters of a line in the order in which they are read.
    fn end_line(&mut self) {
        let mut line = std::mem::take(&mut self.line);
        if let Some((first, _)) = line.first() {
            let (start, along) = (first.from, first.along);
            let place = |letter: &Letter| along.dot(letter.from - start);
            line.sort_by(|(a, _), (b, _)| place(a).total_cmp(&place(b)));
        }
        line.into_iter().for_each(|(letter, seen)| self.texts.add(letter, seen));
    }

    /// Notes a picture of this size that has to be held in memory.
    fn hold(&mut self, width: u32, height: u32) {
        let size = Size::new(width, height);
        let limit_megapixels = self.limits.megapixels;
        self.pixels = self.pixels.saturating_add(size.area());
        let kept = self.pixels.saturating_mul(BYTES_PER_PIXEL_KEPT);
        let checked = if size.area() > limit_megapixels.saturating_mul(1_000_000) {
            Err(Error::TooManyPixels { size, limit_megapixels, remedy: OVER_LIMIT })
        } else {
            check_memory(FORMAT, size, size.area().saturating_mul(BYTES_PER_PIXEL).max(kept), self.limits)
        };
        if let Err(fault) = checked {
            self.fault.get_or_insert(fault);
        }
    }

    /// Looks into a mask, once.
    fn mask<'a>(&mut self, mask: Option<&SoftMask<'a>>) {
        if let Some(mask) = mask
            && self.known.insert(mask.cache_key())
        {
            self.within(|survey| mask.interpret(survey));
        }
    }

    fn paint<'a>(&mut self, paint: &Paint<'a>, area: impl FnOnce() -> Rect) {
        let Paint::Pattern(pattern) = paint else { return };
        match &**pattern {
            Pattern::Tiling(tiling) => {
                if self.known.insert(tiling.cache_key()) {
                    self.within(|survey| {
                        tiling.interpret(survey, Affine::IDENTITY, false);
                    });
                }
            }
            // hayro-svg writes other shadings as pictures of a pixel for a point.
            Pattern::Shading(shading) => {
                if !matches!(shading.encode().shading_type, EncodedShadingType::RadialAxial(_)) {
                    let area = area();
                    self.hold(area.width().ceil() as u32, area.height().ceil() as u32);
                }
            }
        }
    }

    /// Looks into something that is no place to read texts in.
    fn within(&mut self, look: impl FnOnce(&mut Self)) {
        let seen = std::mem::take(&mut self.seen);
        self.inside += 1;
        look(self);
        self.inside -= 1;
        self.seen = seen;
    }
}

impl<'a> Device<'a> for Survey {
    fn draw_path(&mut self, path: &BezPath, props: DrawProps<'a>, _: &DrawMode) {
        self.mask(props.soft_mask.as_ref());
        self.paint(&props.paint, || (props.transform * path.clone()).bounding_box());
        let form = self.forms.iter().find(|form| self.inside == 0 && form.is(path));
        if let Some(letter) = form.map(|form| form.letter(props.transform)) {
            self.add(letter);
        }
    }

    fn push_clip_path(&mut self, clip: &ClipPath) {
        self.clip(clip.path.bounding_box());
    }

    fn push_transparency_group(&mut self, _: f32, mask: Option<SoftMask<'a>>, _: BlendMode) {
        self.mask(mask.as_ref());
    }

    fn draw_glyph_run(&mut self, run: &GlyphRun<'_, 'a>, props: DrawProps<'a>, mode: &DrawMode) {
        self.mask(props.soft_mask.as_ref());
        if self.inside > 0 {
            return;
        }
        let hidden = matches!(mode, DrawMode::Invisible);
        let letters = letters::of_run(run, props.transform, hidden);
        let Some(first) = letters.first() else { return };
        // Letters that are filled and stroked come twice.
        let is_again = matches!(mode, DrawMode::Stroke(_))
            && self.last_run.is_some_and(|(at, count)| count == letters.len() && at.distance(first.from) < 1e-3);
        self.last_run = Some((first.from, letters.len()));
        if !is_again {
            letters.into_iter().for_each(|letter| self.add(letter));
        }
    }

    fn draw_image(&mut self, image: Image<'a, '_>, props: ImageDrawProps<'a>) {
        self.mask(props.soft_mask.as_ref());
        self.hold(image.width(), image.height());
    }

    fn pop_clip(&mut self) {
        self.seen.pop();
    }

    fn pop_transparency_group(&mut self) {}
}
