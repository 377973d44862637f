//! What one picture is converted with: the profile, and what its maker chooses anew for each picture.

use crate::Error;
use crate::page::heading::HeadingParams;
use crate::page::layout::{self, Layout, OverviewParams};
use crate::page::{MediumParams, PartShown};
use crate::profile::Plan;
use crate::raster::crop::Crop;
use crate::raster::decode::{DecodeOptions, FontLoader, Header, Limits};
use crate::units::Size;

/// Which part of a picture is drawn, and how. The default is all of it, as large as the sheet allows, for the front.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Fit {
    /// The part that is drawn.
    pub crop: Option<Crop>,
    /// Width of the figure, mm; without it, as much as there is room for.
    pub width: Option<f32>,
    /// Whether left and right are exchanged, for a machine that presses dots up from the back of the sheet.
    pub mirrored: bool,
    /// The page of a document, from 1; without it the first.
    pub page: Option<u32>,
    /// Whether the letters of drawings are drawn as lines.
    pub keep_text: bool,
    /// Whether the ground of a scan is drawn as it is, and not taken for paper.
    pub keep_ground: bool,
}

/// How much wider than there is room for a figure may be asked for, mm: less than is printed exactly. Widths that the
/// program tells have one digit after the point.
pub(super) const SLACK: f32 = 0.06;

/// A figure is larger if it is by a twentieth: less gives no more room to marks.
const LARGER: f32 = 1.05;

impl Fit {
    /// Where the drawn part of a picture, of `size` pixels, lies on the sheet.
    ///
    /// # Errors
    /// If it is asked for wider than there is room for, or its width is no length.
    pub(super) fn layout(&self, size: Size, plan: &Plan, overview: OverviewSize) -> Result<Layout, Error> {
        self.layout_below(size, plan, None, overview)
    }

    /// The same below a title in braille.
    ///
    /// # Errors
    /// As [`Fit::layout`].
    pub(super) fn layout_below(
        &self,
        size: Size,
        plan: &Plan,
        heading: Option<HeadingParams>,
        overview: OverviewSize,
    ) -> Result<Layout, Error> {
        self.check()?;
        let aspect = size.width as f32 / size.height as f32;
        let params = layout::Params { heading, ..overview.in_layout(plan.layout()) };
        let layout = layout::fit(aspect, self.width.unwrap_or(f32::MAX), &params);
        let most = layout.figure.width();
        match self.width {
            Some(wanted) if wanted > most + SLACK => {
                let params = layout::Params { overview: None, ..params };
                let without = layout::fit(aspect, wanted, &params).figure.width();
                let without_overview =
                    (wanted <= without + SLACK).then(|| layout::fit(aspect, f32::MAX, &params).figure.width());
                Err(Error::TooWide { wanted, most, without_overview })
            }
            _ => Ok(layout),
        }
    }

    /// Whether the figure of a page laid out like this would be larger without the overview: where that takes height of
    /// a printed sheet, and nobody asked for a width.
    pub(super) fn is_larger_without_overview(&self, layout: &Layout, plan: &Plan) -> bool {
        let params = plan.layout();
        let is_printed = matches!(params.medium, MediumParams::Print(_)) && layout.overview.is_some();
        let aspect = layout.figure.width() / layout.figure.height().max(f32::EPSILON);
        let width = |params: &layout::Params| layout::fit(aspect, f32::MAX, params).figure.width();
        let without = layout::Params { overview: None, ..params };
        is_printed && self.width.is_none() && width(&without) > LARGER * width(&params)
    }

    /// # Errors
    /// If the width asked for is no length: not finite, or not above 0.
    pub(super) fn check(&self) -> Result<(), Error> {
        match self.width {
            Some(wanted) if !(wanted > 0.0 && wanted.is_finite()) => Err(Error::NoWidth { wanted }),
            _ => Ok(()),
        }
    }

    /// How much of the picture is drawn.
    pub(super) fn part(&self) -> PartShown {
        PartShown { crop: self.crop.map(|crop| crop.to_string()), page: self.page, ..PartShown::default() }
    }

    /// Whether a page shows the same, as far as that can be said without the size of the picture.
    pub(super) fn may_show(&self, part: &PartShown) -> bool {
        let of_page = part.crop.as_ref().map(|crop| crop.parse::<Crop>());
        let is_part = |crop: Crop| Some(crop).filter(|crop| !crop.is_all());
        let is_same_crop = match (of_page.map(|crop| crop.map(is_part)), self.crop.and_then(is_part)) {
            // somebody has changed what the page says
            (Some(Err(_)), _) => true,
            (Some(Ok(Some(own))), Some(other)) => own.may_be_same(&other),
            (Some(Ok(own)), other) => own.is_none() && other.is_none(),
            (None, other) => other.is_none(),
        };
        is_same_crop && self.page.unwrap_or(1) == part.page.unwrap_or(1) && part.sheet.is_none()
    }

    /// As lines of a page's origin; nothing where it is the default.
    pub(super) fn origin(&self) -> impl Iterator<Item = (String, String)> {
        let width = self.width.map(|width| ("width asked for in mm", width.to_string()));
        let text = self.keep_text.then(|| ("text kept", "true".to_owned()));
        let ground = self.keep_ground.then(|| ("ground kept", "true".to_owned()));
        let rest = [width, text, ground].into_iter().flatten().map(|(name, value)| (name.to_owned(), value));
        self.part().to_origin().into_iter().chain(rest)
    }
}

/// Smallest width and height of a picture, px: below this there is nothing to find a contour in.
const MIN_PIXELS: u32 = 8;

/// # Errors
/// [`Error::TooFewPixels`] if a picture of this size has too few for a contour.
pub(super) fn enough_pixels(size: Size) -> Result<(), Error> {
    if size.width < MIN_PIXELS || size.height < MIN_PIXELS {
        return Err(Error::TooFewPixels { size, least: MIN_PIXELS });
    }
    Ok(())
}

/// How many times as large as the profile asks for the overview of a photograph is. At 0.5 of the figure it agreed with
/// what people outline to an F of .55, at 0.4 of .53 (50 photographs of BSDS500, val, with an earlier version; on 28
/// November it was .567 at 0.5, as `docs/photographs.md` says), and one hand still covers it: 85 mm of a figure as wide
/// as an A4 sheet.
const OF_PHOTOGRAPH: f32 = 1.25;

/// The scale of the overview of a photograph where the profile asks for `own`: no overview is larger than its figure.
pub(super) fn scale_of_photograph(own: f32) -> f32 {
    (OF_PHOTOGRAPH * own).min(1.0)
}

/// How large the overview is laid out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum OverviewSize {
    /// As the profile asks for.
    Own,
    /// As for a photograph ([`scale_of_photograph`]) on printed paper.
    OfPhotograph,
}

impl OverviewSize {
    /// The layout of a picture of `source` pixels with this overview, or with the profile's where this one would leave
    /// the figure less room than is asked for.
    ///
    /// # Errors
    /// As `layout_of`.
    pub(super) fn fitting(self, source: Size, plan: &Plan, layout_of: &LayoutOf<'_>) -> Result<(Self, Layout), Error> {
        let least = plan.profile().figure.min_side;
        let own = || layout_of(source, Self::Own).map(|layout| (Self::Own, layout));
        match layout_of(source, self) {
            Ok(layout) if layout.figure.width().min(layout.figure.height()) >= least => Ok((self, layout)),
            _ => own(),
        }
    }

    /// The layout's parameters with an overview of this size.
    pub(super) fn in_layout(self, params: layout::Params) -> layout::Params {
        let overview = match (self, params.medium) {
            (Self::OfPhotograph, MediumParams::Print(_)) => params
                .overview
                .map(|overview| OverviewParams { scale: scale_of_photograph(overview.scale), ..overview }),
            (Self::OfPhotograph, MediumParams::Dots { .. }) | (Self::Own, _) => params.overview,
        };
        layout::Params { overview, ..params }
    }
}

/// A bitmap has as many pixels on a smaller printed figure as on one whose longer side is so many mm: in fewer the
/// strokes of a sharp corner are one blot. Of the pages of a house on figures of 60 to 90 mm, 6 of 10 lost an eave
/// without. Dots are too coarse to show it.
const SMALL: f32 = 110.0;

/// The picture's size in pixels for its size on the sheet: as many as the profile wants for a millimetre, but never
/// more than there are.
pub(super) fn working_size(source: Header, layout_of: &LayoutOf<'_>, fit: &Fit, plan: &Plan) -> Result<Size, Error> {
    let Header { size, is_drawing } = source;
    enough_pixels(size)?;
    let place = layout_of(size, OverviewSize::Own)?.figure;
    let figure = &plan.profile().figure;
    let side = place.width().min(place.height());
    if side < figure.min_side {
        let least = figure.min_side;
        return Err(match fit.width {
            None => Error::TooNarrow { size, side, least },
            Some(wanted) => Error::NotWideEnough { wanted, side, least },
        });
    }
    let is_fine_enough = is_drawing || matches!(plan.medium(), MediumParams::Dots { .. });
    let finer = if is_fine_enough { 1.0 } else { (SMALL / place.width().max(place.height())).max(1.0) };
    let pixels = |mm: f32, own: u32| {
        let wanted = ((mm * figure.resolution * finer).round() as u32).max(1);
        if is_drawing { wanted } else { wanted.min(own) }
    };
    Ok(Size::new(pixels(place.width(), size.width), pixels(place.height(), size.height)))
}

/// Where a picture of this size lies on the sheet, with an overview of this size.
pub(super) type LayoutOf<'a> = dyn Fn(Size, OverviewSize) -> Result<Layout, Error> + 'a;

/// Everything beside the picture's bytes.
pub struct Request<'a> {
    /// The checked profile.
    pub plan: &'a Plan,
    /// What decoding may cost.
    pub limits: Limits,
    /// Fonts for drawings; asked only when a drawing has text.
    pub fonts: &'a FontLoader<'a>,
    /// What the page is called, such as the picture's file name.
    pub title: &'a str,
    /// The language in which the page is described (BCP 47); English where the program has no words in it.
    pub language: &'a str,
    /// Which part of the picture is drawn, how large, and whether for the back of the sheet.
    pub fit: Fit,
    /// Asked between stages whether to stop.
    pub cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl<'a> Request<'a> {
    /// The same with other settings.
    pub(super) fn with_plan<'b>(&self, plan: &'b Plan) -> Request<'b>
    where
        'a: 'b,
    {
        let Self { limits, fonts, title, language, fit, cancelled, .. } = *self;
        Request { plan, limits, fonts, title, language, fit, cancelled }
    }
}

impl Request<'_> {
    /// Between two stages: whether to go on.
    ///
    /// # Errors
    /// If the caller has cancelled.
    pub(crate) fn go_on(&self) -> Result<(), Error> {
        if (self.cancelled)() { Err(Error::Cancelled) } else { Ok(()) }
    }

    /// How the picture is decoded.
    pub(super) fn decoding<'b>(&'b self, working_size: &'b dyn Fn(Header) -> Result<Size, Error>) -> DecodeOptions<'b> {
        let Fit { crop, page, keep_text, keep_ground, .. } = self.fit;
        DecodeOptions {
            limits: self.limits,
            fonts: self.fonts,
            crop,
            page,
            keep_text,
            keep_ground,
            pixels_only: false,
            working_size,
        }
    }
}
