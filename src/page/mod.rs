//! The page: finished marks in millimetres. Everything before makes it, everything after reads it.
//!
//! A page has no options, no references and no pixels. Its constructor checks it once; writers need not check again.

pub(crate) mod braille;
mod describe;
pub(crate) mod dot_layout;
mod dump;
pub mod frame_dots;
mod ink;
pub mod layout;
mod mirror;
pub mod spread;

pub use crate::classes::Class;
pub use crate::lines::{Height, Line, Pen, Run};
pub use crate::textures::{Glyph, Palette, Shape, Sign, Texture};
pub use describe::{LANGUAGE, describe};

use crate::devices::Room;
use crate::units::{MmPoint, MmRect, Size};

/// A finished page.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    parts: Parts,
}

/// What a page is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Parts {
    /// Width and height of the sheet, mm.
    pub sheet: [f32; 2],
    /// What the page is called.
    pub title: String,
    /// What is on it, in plain words.
    pub description: String,
    /// The language of title and description as in BCP 47, such as `en`.
    pub language: String,
    /// How it was made: program, profile and every parameter, as name and value.
    pub origin: Vec<(String, String)>,
    /// The band of fine dots around the figure; empty if there is none.
    pub frame: Dots,
    /// The short bar across the top right corner that tells which way up the sheet lies, if there is one.
    pub orientation_mark: Option<Run>,
    /// Ticks by which sheets that belong together are laid side by side; few pages have any.
    pub registration: Vec<Run>,
    /// The textured figure.
    pub figure: Figure,
    /// The smaller picture of lines only, if there is one.
    pub overview: Option<Overview>,
    /// Braille and other dots that name or number what is on the page; one entry a size. Few pages have any.
    pub labels: Vec<Dots>,
    /// The device that presses the page as dots, if it is one of dots; then every mark is a dot that it can press.
    pub press: Option<Press>,
}

impl Parts {
    /// A figure on a sheet (width and height, mm) with nothing beside it and no words.
    pub fn of(sheet: [f32; 2], figure: Figure) -> Self {
        Self {
            sheet,
            title: String::new(),
            description: String::new(),
            language: LANGUAGE.into(),
            origin: Vec::new(),
            frame: Dots::default(),
            orientation_mark: None,
            registration: Vec::new(),
            figure,
            overview: None,
            labels: Vec::new(),
            press: None,
        }
    }
}

/// What a writer of dots needs to know of the device.
#[derive(Debug, Clone, PartialEq)]
pub struct Press {
    /// Where it can press dots.
    pub room: Room,
    /// Distance of dots, mm.
    pub pitch: f32,
    /// Diameter of a dot as it is felt, mm.
    pub diameter: f32,
    /// Whether it presses dots to different heights.
    pub has_heights: bool,
}

/// Discs of one size.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Dots {
    /// Diameter of each, mm.
    pub diameter: f32,
    /// Centres.
    pub at: Vec<MmPoint>,
}

/// The main picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Where the picture lies on the sheet.
    pub place: MmRect,
    /// Size of the upright source picture, px.
    pub source: Size,
    /// One texture a region.
    pub textures: Vec<Texture>,
    /// One line a contour, weightiest first.
    pub lines: Vec<Line>,
}

/// The small picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Overview {
    /// Where it lies on the sheet.
    pub place: MmRect,
    /// Its band of fine dots; empty if there is none.
    pub frame: Dots,
    /// Its lines.
    pub lines: Vec<Line>,
}

/// A mark that cannot be on a page.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{what} lies at {at}, off the sheet of {sheet}")]
pub struct OffSheet {
    what: &'static str,
    at: String,
    sheet: String,
}

impl Page {
    /// Makes a page of its parts.
    ///
    /// # Errors
    /// If a mark is not finite or reaches beyond the sheet.
    pub fn new(parts: Parts) -> Result<Self, OffSheet> {
        let [width, height] = parts.sheet;
        let on_sheet = |what, at: MmPoint, radius: f32| {
            // NaN fails every comparison, so it is caught here as well
            let inside =
                at.x - radius >= 0.0 && at.y - radius >= 0.0 && at.x + radius <= width && at.y + radius <= height;
            let sheet = || format!("{width} x {height} mm");
            if inside {
                Ok(())
            } else {
                Err(OffSheet { what, at: format!("{} mm, {} mm", at.x, at.y), sheet: sheet() })
            }
        };
        let overview = parts.overview.iter();
        let frames = [&parts.frame].into_iter().chain(overview.clone().map(|o| &o.frame));
        let labels = parts.labels.iter().map(|dots| ("a dot of a label", dots));
        for (what, dots) in frames.map(|dots| ("a dot of a frame", dots)).chain(labels) {
            dots.at.iter().try_for_each(|&at| on_sheet(what, at, 0.5 * dots.diameter))?;
        }
        let lines = parts.figure.lines.iter().chain(overview.flat_map(|o| &o.lines));
        let runs = lines.flat_map(|line| &line.runs).map(|run| ("a line", run));
        for (what, run) in runs.chain(
            parts.orientation_mark.iter().chain(&parts.registration).map(|run| ("a mark beside the picture", run)),
        ) {
            run.points.iter().try_for_each(|&at| on_sheet(what, at, 0.5 * run.width))?;
        }
        for texture in &parts.figure.textures {
            texture.glyphs.iter().try_for_each(|glyph| on_sheet("a glyph", glyph.at, glyph.radius()))?;
        }
        Ok(Self { parts })
    }

    /// The same page with words of its maker's: a title, and a description with its language (BCP 47, such as `en`). What is
    /// not given stays.
    #[must_use]
    pub fn called(mut self, title: Option<&str>, description: Option<(&str, &str)>) -> Self {
        if let Some(title) = title {
            self.parts.title = title.to_owned();
        }
        if let Some((description, language)) = description {
            (self.parts.description, self.parts.language) = (description.to_owned(), language.to_owned());
        }
        self
    }

    /// How high the dots of frames are pressed.
    pub fn height_of_frame(&self) -> Height {
        self.height(Height::Middle)
    }

    /// How high the dots of textures are pressed.
    pub fn height_of_textures(&self) -> Height {
        self.height(Height::Low)
    }

    fn height(&self, height: Height) -> Height {
        if self.press.as_ref().is_some_and(|press| press.has_heights) { height } else { Height::High }
    }

    /// Whether there is neither a line nor a glyph on it.
    pub fn is_empty(&self) -> bool {
        self.figure.lines.is_empty() && self.figure.textures.is_empty()
    }
}

impl std::ops::Deref for Page {
    type Target = Parts;

    fn deref(&self) -> &Parts {
        &self.parts
    }
}
