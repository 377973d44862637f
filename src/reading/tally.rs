//! What is told of a page that was read.

use std::collections::BTreeMap;

use super::areas::LEAST;
use super::document::Elements;
use super::said::source;
use crate::listing::counted;
use crate::output::layer::Layer;
use crate::page::{Page, Shape};
use crate::units::MmPoint;
use crate::{About, Note, Reason, Told};

/// What is told when all is read, as counts and the place of the first.
#[derive(Default)]
pub(super) struct Tally {
    told: BTreeMap<What, (usize, Option<MmPoint>)>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum What {
    LineOutside,
    DotOutside,
    BesideMark,
    Outlined,
    OutlinedSmall,
    OutlinedThere,
    NoGlyph,
    OffSheet,
    CutAtSheet,
    TooBroad,
    Shaded,
    Dashed,
    UnevenDots,
    Foreign,
    InPrint,
    White,
}

/// How much of a file is no mark of a page.
#[derive(Clone, Copy, Default)]
pub(super) struct OfFile {
    /// Pictures of pixels.
    pub(super) pictures: usize,
    /// What is in another file, or of another kind than SVG.
    pub(super) elsewhere: usize,
    /// Marks far beyond the sheet.
    pub(super) far: usize,
    /// Clip paths, masks and filters.
    pub(super) cut: usize,
    /// What is filled unevenly.
    pub(super) patterned: usize,
}

impl OfFile {
    /// What is told of it.
    pub(super) fn told(self) -> impl Iterator<Item = Note> {
        let Self { pictures, elsewhere, far, cut: clipped, patterned } = self;
        let of_elsewhere = counted(elsewhere, "object");
        let all = [
            (
                pictures,
                Reason::Pixels,
                format!("{}: convert what is in a picture to lines first", counted(pictures, "picture")),
            ),
            (
                elsewhere,
                Reason::Elsewhere,
                format!(
                    "{of_elsewhere} of another file or of no kind that SVG draws: put what is shown there on the page"
                ),
            ),
            (far, Reason::OffSheet, format!("{} far beyond the sheet", counted(far, "mark"))),
            (
                clipped,
                Reason::Clipped,
                format!("clip paths, masks and filters ({clipped}): what they cut off is there"),
            ),
        ];
        let left_out = all.into_iter().filter(|(count, ..)| *count > 0);
        let patterned_as = format!("gradients and patterns ({patterned}), taken as black: only black rises");
        let taken = (patterned > 0).then_some(Note::TakenAs(About::Marks, Reason::NotBlack, patterned_as.into()));
        left_out.map(|(_, reason, what)| Note::NotOnPage(About::Marks, reason, what.into())).chain(taken)
    }
}

/// What is told of a page without the layer of its figure.
pub(super) fn told_no_figure(elements: &Elements<'_>) -> Option<Note> {
    let remedy = "undo that, or give a group of its lines and textures this name and the data-box that it had";
    let is_gone = elements.are_of_page && elements.layer(Layer::Figure).is_none();
    is_gone.then(|| {
        Note::TakenAs(
            About::Marks,
            Reason::NoFigure,
            format!("the whole sheet is taken as the figure, as its layer is gone: {remedy}").into(),
        )
    })
}

/// What is told of layers of textures that were renamed.
pub(super) fn told_renamed(elements: &Elements<'_>) -> impl Iterator<Item = Note> {
    elements.renamed_layers().into_iter().map(|[before, class]| {
        let (layer, class) = (Layer::Texture(class).label(), class.name());
        let told = format!("the layer \"{layer}\" was that of {}: the areas in it are {class} now", before.name());
        Note::TakenAs(About::Areas, Reason::LayerRenamed, told.into())
    })
}

/// What is told of a page of which the file does not say how large its sheet is.
pub(super) fn told_no_size([width, height]: [f32; 2]) -> Note {
    let told = format!("the file does not say how large its sheet is, which is taken as {width} x {height} mm");
    Note::TakenAs(About::Marks, Reason::NoSize, told.into())
}

/// What is told of a page that does not say how it was made; if all of its marks are dots it may be one for a device.
pub(super) fn told_no_metadata(page: &Page, elements: &Elements<'_>) -> Option<Note> {
    let lines = page.overview.iter().flat_map(|overview| &overview.lines).chain(&page.figure.lines);
    let mut glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let has_dots = !page.labels.is_empty() || !page.figure.textures.is_empty();
    let are_dots = lines.count() == 0 && has_dots && glyphs.all(|glyph| matches!(glyph.shape, Shape::Dot { .. }));
    let dots = match are_dots {
        true => "; all its marks are dots, so that it looks like a page for an embosser or a pin display",
        false => "",
    };
    let told = format!(
        "the file does not say how its page was made, as its metadata are gone: it is taken as printed, by the default \
         profile{dots}; save it with its metadata, or ask with another profile"
    );
    let is_gone = page.origin.is_empty() && source(elements).is_some();
    is_gone.then_some(Note::TakenAs(About::Marks, Reason::NoMetadata, told.into()))
}

impl Tally {
    pub(super) fn add(&mut self, what: What, at: Option<MmPoint>) {
        let (count, first) = self.told.entry(what).or_default();
        *count += 1;
        *first = first.or(at);
    }

    pub(super) fn notes(&self) -> impl Iterator<Item = Note> + '_ {
        self.told.iter().map(|(what, (count, first))| {
            let at = first.map_or(String::new(), |at| format!(" (the first at {:.0}, {:.0} mm)", at.x, at.y));
            what.note(what.sentence(*count, &at).into())
        })
    }
}

impl What {
    /// The remark that says so.
    fn note(self, told: Told) -> Note {
        match self {
            Self::LineOutside => Note::TakenAs(About::Lines, Reason::OutsideLayers, told),
            Self::DotOutside => Note::TakenAs(About::Dots, Reason::OutsideLayers, told),
            Self::BesideMark => Note::TakenAs(About::Lines, Reason::OutsideLayers, told),
            Self::Outlined => Note::TakenAs(About::Areas, Reason::NoTextureColour, told),
            Self::OutlinedSmall => Note::TakenAs(About::Areas, Reason::AreaTooSmall, told),
            Self::OutlinedThere => Note::TakenAs(About::Areas, Reason::NoTexturesThere, told),
            Self::NoGlyph => Note::NotOnPage(About::Signs, Reason::NoSign, told),
            Self::OffSheet => Note::NotOnPage(About::Marks, Reason::OffSheet, told),
            Self::CutAtSheet => Note::NotOnPage(About::Lines, Reason::OffSheet, told),
            Self::TooBroad => Note::NotOnPage(About::Lines, Reason::OffSheet, told),
            Self::Shaded => Note::TakenAs(About::Marks, Reason::NotBlack, told),
            Self::Dashed => Note::TakenAs(About::Lines, Reason::Dashed, told),
            Self::InPrint => Note::NotOnPage(About::Print, Reason::NoPrintWord, told),
            Self::White => Note::TakenAs(About::Marks, Reason::White, told),
            Self::Foreign => Note::NotOnPage(About::Marks, Reason::OutsideLayers, told),
            Self::UnevenDots => Note::TakenAs(About::Dots, Reason::UnevenDotSizes, told),
        }
    }

    /// What is told of so many of them, the first of which is `at` a place, in words.
    fn sentence(self, count: usize, at: &str) -> String {
        let n = |one: &str, many: &str| if count == 1 { format!("1 {one}") } else { format!("{count} {many}") };
        let outlined = |why: String| {
            let lines = if count == 1 { "a line around it" } else { "lines around them" };
            format!("{}{at} {why}, drawn as {lines}", n("filled shape", "filled shapes"))
        };
        match self {
            Self::LineOutside => {
                format!("{}{at} outside of the layers, taken as lines of the figure", n("line", "lines"))
            }
            Self::DotOutside => format!("{}{at} outside of the layers, taken as dots", n("disc", "discs")),
            Self::BesideMark => {
                let (more, lines) = (n("more mark", "more marks"), if count == 1 { "a line" } else { "lines" });
                format!("{more}{at} in the layer of the orientation mark, taken as {lines} of the figure")
            }
            Self::Outlined => outlined("without the colour of a texture".to_owned()),
            Self::OutlinedSmall => outlined(format!("smaller than {LEAST} square mm, too small for a texture")),
            Self::OutlinedThere => outlined("in a layer that has no textures".to_owned()),
            Self::NoGlyph => format!(
                "{}{at} among the textures, neither rhombus nor dot; draw lines in the layer Lines",
                n("shape", "shapes")
            ),
            Self::OffSheet => format!("{}{at} beyond the sheet", n("mark", "marks")),
            Self::CutAtSheet => format!("what of {}{at} reaches beyond the sheet", n("line", "lines")),
            Self::TooBroad => format!(
                "{}{at} whose stroke is too broad for the sheet: give it a stroke width of 1.5 mm",
                n("line", "lines")
            ),
            Self::Shaded => {
                format!("{}{at} in grey or colour, taken as black: only black rises", n("mark", "marks"))
            }
            Self::Dashed => format!("{}{at} with dashes, taken without gaps", n("line", "lines")),
            Self::InPrint => format!("{}{at} in the layer of words in print", n("shape", "shapes")),
            Self::White => format!(
                "{}{at}: what is white prints nothing and covers nothing; delete what lies under it",
                n("white mark", "white marks")
            ),
            Self::Foreign => format!("{}{at} outside of the layer", n("mark", "marks")),
            Self::UnevenDots => {
                format!("{}{at} of other sizes than the others of its group, taken as of one size", n("dot", "dots"))
            }
        }
    }
}
