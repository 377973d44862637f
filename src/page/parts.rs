//! What a page is made of.

use std::f32::consts::FRAC_PI_4;

use super::medium::{Medium, Print};
use crate::braille::unicode;
use crate::units::{MmPoint, MmRect, Size};

pub use crate::classes::Class;
pub use crate::lines::{Height, Line, Pen, Run};
pub use crate::textures::{Glyph, Palette, Shape, Sign, Texture};

/// The language of the titles and descriptions that are generated (BCP 47).
pub const LANGUAGE: &str = "en";

/// The name by which a page's origin says that left and right are exchanged.
pub const MIRRORED: &str = "mirrored";

/// A finished page. Its marks are those of [`Parts`], to which it derefs; [`convert`](crate::convert) makes it of a
/// picture, and `Page::new` of parts. To change one, clone its parts (`Parts::clone(&page)`), change these, and make a
/// page of them. Its `Display` lists all marks, one a line, for comparisons and tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    pub(super) parts: Parts,
}

/// What a page is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Parts {
    /// Width and height of the sheet, mm.
    pub sheet: [f32; 2],
    /// What the page is called, for viewers and screen readers; what is written of it in braille is in `braille`.
    pub title: String,
    /// What is on it, in plain words, for screen readers.
    pub description: String,
    /// The language of the title as in BCP 47, such as `en`.
    pub language: String,
    /// The language of the description, likewise.
    pub description_language: String,
    /// How it was made: program, profile and every parameter, as name and value. What reads a page again goes by it;
    /// what the page is made for (`medium`) is written with it where it is not said here.
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
    /// Dots that name sheets and samples, as on sheets of `--sheets` and of calibration; one entry for each size of
    /// dots. Few pages have any. Words of a picture, and those of [`Options::labels`](crate::Options::labels), are in
    /// `braille`.
    pub labels: Vec<Dots>,
    /// Words in braille: the title, and labels in the figure.
    pub braille: Vec<BrailleText>,
    /// The same words in print, for those who see; none unless somebody asks for it.
    pub print: Vec<PrintText>,
    /// What the page is made for. Of dots, every mark is to be a dot that the device can raise: in files for the device
    /// the nearest one is raised, and a page with strokes or rhombuses is refused there.
    pub medium: Medium,
}

impl Parts {
    /// A printed figure on a sheet (width and height, mm) with nothing beside it and no words.
    pub fn of(sheet: [f32; 2], figure: Figure) -> Self {
        Self {
            sheet,
            title: String::new(),
            description: String::new(),
            language: LANGUAGE.into(),
            description_language: LANGUAGE.into(),
            origin: Vec::new(),
            frame: Dots::default(),
            orientation_mark: None,
            registration: Vec::new(),
            figure,
            overview: None,
            labels: Vec::new(),
            braille: Vec::new(),
            print: Vec::new(),
            medium: Medium::Print(Print::default()),
        }
    }
}

/// Discs of one size.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Dots {
    /// Diameter of each, mm.
    pub diameter: f32,
    /// Centres, on the sheet.
    pub at: Vec<MmPoint>,
}

impl Dots {
    /// The box around all discs, to their edges; none without any.
    pub(crate) fn bounds(&self) -> Option<MmRect> {
        let radius = 0.5 * self.diameter;
        (!self.at.is_empty()).then(|| MmRect::from_points(&self.at).inflate(radius, radius))
    }
}

/// Words in braille, and the same as text for those who listen.
#[derive(Debug, Clone, PartialEq)]
pub struct BrailleText {
    /// What it is.
    pub role: TextRole,
    /// What it says.
    pub text: String,
    /// The language of the text (BCP 47).
    pub language: String,
    /// What stands in place of the text, if it is abbreviated.
    pub abbreviation: Option<String>,
    /// Its lines, in Unicode braille (U+2800 to U+283F).
    pub lines: Vec<String>,
    /// The dots of all lines.
    pub dots: Dots,
    /// The line that leads from a label to what it names, where that lies further away.
    pub leader: Option<Run>,
}

/// Words in print, in a grey that is too light to rise.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintText {
    /// What it says.
    pub string: String,
    /// Where its first letter stands on its line.
    pub at: MmPoint,
    /// Font size (em), mm.
    pub size: f32,
}

/// What a text is on a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum TextRole {
    /// The title.
    Title,
    /// A label in the figure.
    Label,
    /// A part of the key.
    Key,
    /// The number of the page.
    Number,
}

/// The main picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Where the picture lies on the sheet.
    pub place: MmRect,
    /// Size of the upright source picture, or of the part of it that is drawn: px, of a vector drawing in CSS px (1/96
    /// inch).
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
    /// Its lines, weightiest first.
    pub lines: Vec<Line>,
}

impl Figure {
    /// Share of the figure that the textures of a class cover, including the gaps between glyphs, 0..=1.
    pub fn share(&self, class: Class) -> f32 {
        let areas = self.textures.iter().filter(|texture| texture.class == class).map(|texture| texture.area);
        (areas.sum::<f32>() / self.place.area().max(f32::MIN_POSITIVE)).min(1.0)
    }

    /// Share of the figure that textures cover, 0..=1.
    pub fn textured_share(&self) -> f32 {
        Class::ALL.into_iter().map(|class| self.share(class)).sum::<f32>().min(1.0)
    }
}

impl BrailleText {
    /// A page number.
    pub(crate) fn page_number(number: u32, cells: &[u8], dots: Dots, language: &str) -> Self {
        Self {
            role: TextRole::Number,
            text: number.to_string(),
            language: language.to_owned(),
            abbreviation: None,
            lines: vec![unicode(cells)],
            dots,
            leader: None,
        }
    }

    /// What it says, for those who listen: of an abbreviation, what it stands for as well.
    pub fn spoken(&self) -> String {
        match &self.abbreviation {
            Some(short) => format!("{short}: {}", self.text),
            None => self.text.clone(),
        }
    }
}

impl TextRole {
    /// All of them, in the order of a page's layers.
    pub const ALL: [Self; 4] = [Self::Title, Self::Number, Self::Label, Self::Key];

    /// Its name in plain words, such as "title".
    pub fn name(self) -> &'static str {
        match self {
            Self::Title => "title",
            Self::Label => "label",
            Self::Key => "key",
            Self::Number => "page number",
        }
    }
}

impl Page {
    /// The same page with its maker's title and description, and the language of these (BCP 47, such as `en`). What is
    /// not given stays; a description that stays keeps its own language. Words in braille stay as they are: a title in
    /// braille is given to the options of the conversion.
    #[must_use]
    pub fn called(mut self, title: Option<&str>, description: Option<&str>, language: Option<&str>) -> Self {
        let put = |place: &mut String, words: Option<&str>| {
            if let Some(words) = words {
                words.clone_into(place);
            }
        };
        put(&mut self.parts.title, title);
        put(&mut self.parts.description, description);
        put(&mut self.parts.language, language);
        if description.is_some() {
            put(&mut self.parts.description_language, language);
        }
        self
    }

    /// The same page with a description that was made of its marks, in this language; `made` is the entry of its origin
    /// that tells so, in place of one of its name.
    #[must_use]
    pub(crate) fn described(mut self, description: String, language: &str, made: (String, String)) -> Self {
        self.parts.description = description;
        language.clone_into(&mut self.parts.description_language);
        // in its place, so that a page that is read and described again is the same to the byte
        match self.parts.origin.iter_mut().find(|(name, _)| *name == made.0) {
            Some(own) => *own = made,
            None => self.parts.origin.push(made),
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
        if self.medium.has_heights() { height } else { Height::High }
    }

    /// Share of the figure that is black, 0..=1: the ink of its lines and glyphs by its area. Where lines meet, ink
    /// that lies on ink counts twice, which is a thousandth or two.
    pub fn black_share(&self) -> f32 {
        let of_run = |run: &Run| match run.pen {
            Pen::Stroke => run.width * run.polyline().length(),
            Pen::Dots(_) => run.points.len() as f32 * FRAC_PI_4 * run.width * run.width,
        };
        let lines: f32 = self.figure.lines.iter().flat_map(|line| &line.runs).map(of_run).sum();
        let glyphs: f32 = self.figure.textures.iter().flat_map(|texture| &texture.glyphs).map(Glyph::area).sum();
        (lines + glyphs) / self.figure.place.area().max(f32::MIN_POSITIVE)
    }

    /// Whether left and right are exchanged, for a machine that presses dots up from the back of the sheet.
    pub fn is_mirrored(&self) -> bool {
        self.parts.origin.iter().any(|(name, value)| (name.as_str(), value.as_str()) == (MIRRORED, "true"))
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
