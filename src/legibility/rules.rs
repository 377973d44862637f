//! The rules, as data: what each asks for, its number and unit, where the number comes from, and what to do.

use super::limits::{
    BRAILLE_GAP, BRAILLE_OFF, LEADER_END, MOST_BESIDE_ROWS, MOST_TEXTURES, MediumLimits, RuleLimits, SHAPE,
};

/// How bad a breach of a rule is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Fingers will not read it.
    Error,
    /// Somebody should look at it.
    Warning,
}

impl Severity {
    /// All of them, the worst first.
    pub const ALL: [Self; 2] = [Self::Error, Self::Warning];

    /// Its name, such as "error".
    pub fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
        }
    }
}

/// A rule that pages are held against.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Rule {
    /// Its id, such as `line-gap`.
    pub id: &'static str,
    /// What it asks for, in one sentence.
    pub asks: &'static str,
    /// How bad a breach is.
    pub severity: Severity,
    /// Where its number comes from.
    pub source: &'static str,
    /// What to do about a breach.
    pub remedy: &'static str,
    number: fn(&RuleLimits) -> Option<(f32, &'static str)>,
}

impl Rule {
    /// All rules, in the order in which their findings are told.
    pub fn all() -> &'static [Self] {
        RULES
    }

    /// Its number and the unit of it on pages of a profile; none where it has none.
    pub(crate) fn number(&self, limits: &RuleLimits) -> Option<(f32, &'static str)> {
        (self.number)(limits)
    }
}

impl PartialEq for Rule {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

const MM: &str = "mm";
const DOTS: &str = "dots";

fn none(_: &RuleLimits) -> Option<(f32, &'static str)> {
    None
}

fn line_width(limits: &RuleLimits) -> Option<(f32, &'static str)> {
    match limits.medium {
        MediumLimits::Print { line_width, .. } => Some((line_width, MM)),
        MediumLimits::Dots { .. } => None,
    }
}

fn line_gap(limits: &RuleLimits) -> Option<(f32, &'static str)> {
    Some(match limits.medium {
        MediumLimits::Print { line_gap, .. } => (line_gap, MM),
        MediumLimits::Dots { line_gap, .. } => (line_gap as f32, DOTS),
    })
}

fn texture_gap(limits: &RuleLimits) -> Option<(f32, &'static str)> {
    Some(match limits.medium {
        MediumLimits::Print { texture_gap, .. } => (texture_gap, MM),
        MediumLimits::Dots { texture_gap, .. } => (texture_gap as f32, DOTS),
    })
}

fn glyph(limits: &RuleLimits) -> Option<(f32, &'static str)> {
    match limits.medium {
        MediumLimits::Print { glyph, .. } => Some((glyph, MM)),
        MediumLimits::Dots { .. } => None,
    }
}

fn max_black(limits: &RuleLimits) -> Option<(f32, &'static str)> {
    match limits.medium {
        MediumLimits::Print { max_black, .. } => Some((100.0 * max_black, "%")),
        MediumLimits::Dots { .. } => None,
    }
}

pub(super) const LINE_WIDTH: Rule = Rule {
    id: "line-width",
    asks: "A line is not thinner than this.",
    severity: Severity::Error,
    source: "the profile's lines.width_min",
    remedy: "give it a wider stroke",
    number: line_width,
};
pub(super) const LINE_GAP: Rule = Rule {
    id: "line-gap",
    asks: "Between two lines, and between two parts of one line, there is at least this blank, but where they join; on \
           paper, beside a disc that stands for a point, half of it.",
    severity: Severity::Error,
    source: "the profile's lines.min_gap (of dots, dots.line_gap); Hasty: the 1/8 inch rule",
    remedy: "move one of them away, join them, or delete one",
    number: line_gap,
};
pub(super) const LINE_LENGTH: Rule = Rule {
    id: "line-length",
    asks: "A line is at least this long from tip to tip, unless it leads from line to line.",
    severity: Severity::Error,
    source: "the profile's lines.min_length; BANA is quoted with 6 mm for lesser lines and 12.5 mm for main ones",
    remedy: "delete it, or make it a part of another line",
    number: |limits| Some((limits.line_length, MM)),
};
pub(super) const BROKEN_LINE: Rule = Rule {
    id: "broken-line",
    asks: "Two ends of lines that point at one another, or one that a person drew and a line, leave no gap so small \
           that it may be missed.",
    severity: Severity::Warning,
    source: "chosen by us: twice the least blank between two lines; on dots, twice the least distance of their middles",
    remedy: "join the two, or shorten one so that the gap is clear",
    number: |limits| Some((limits.missed_gap(), MM)),
};
pub(super) const LOOSE_ENDS: Rule = Rule {
    id: "loose-ends",
    asks: "On a page of a photograph at most so many ends of lines lead to nothing: to no line, and not to the border \
           of the figure.",
    severity: Severity::Warning,
    source: "chosen by us, by looking at pages: with more, photographs of leaves or grass are scraps that no finger \
             follows",
    remedy: "convert the picture with less detail, or a part of it, or delete lines that lead nowhere",
    number: |limits| Some((limits.loose_ends(), "ends in 100 square cm")),
};
pub(super) const TEXTURE_GAP: Rule = Rule {
    id: "texture-gap",
    asks: "Between a line and the marks of a texture there is at least this blank.",
    severity: Severity::Error,
    source: "the profile's textures.line_gap (of dots, one empty dot where dots.texture_gap is 1 or more)",
    remedy: "delete the marks beside the line, or move the texture",
    number: texture_gap,
};
pub(super) const TEXTURE_AREA: Rule = Rule {
    id: "texture-area",
    asks: "An area, or another of its colour, is large enough for its texture to be told.",
    severity: Severity::Error,
    source: "the profile's colours.min_area; MapGen in the name of BANA: 13 x 13 mm",
    remedy: "delete the texture, or give the area that of its neighbour",
    number: |limits| Some((limits.texture_area, "square mm")),
};
pub(super) const TEXTURE_SIGN: Rule = Rule {
    id: "texture-sign",
    asks: "The marks of a texture have the direction of its colour.",
    severity: Severity::Error,
    source: "the profile's textures.palette, which says the sign of each colour",
    remedy: "move the area to the texture of its marks, or let the program draw them anew",
    number: none,
};
pub(super) const GLYPH_SIZE: Rule = Rule {
    id: "mark-size",
    asks: "A rhombus or dot is not thinner than this.",
    severity: Severity::Error,
    source: "the profile's textures.min_glyph; hatching notes in the name of BANA: 0.5 mm",
    remedy: "make the marks larger, or delete them",
    number: glyph,
};
pub(super) const MARGIN: Rule = Rule {
    id: "margin",
    asks: "All marks keep this far from the sheet's edges, or within what the device reaches.",
    severity: Severity::Error,
    source: "the profile's page.margin; Gardiner and Perkins: at least 10 mm",
    remedy: "move them inwards",
    number: |limits| match limits.medium {
        MediumLimits::Print { .. } => Some((limits.margin, MM)),
        MediumLimits::Dots { .. } => None,
    },
};
pub(super) const OVERLAP: Rule = Rule {
    id: "overlap",
    asks: "Marks of different parts of the page do not lie on one another.",
    severity: Severity::Error,
    source: "what lies on something else is not felt as itself",
    remedy: "move or delete one of them",
    number: none,
};
pub(super) const TEXTURES: Rule = Rule {
    id: "textures",
    asks: "There are at most so many textures.",
    severity: Severity::Error,
    source: "BANA, as quoted by others: 5 area textures on one graphic",
    remedy: "give areas that may be felt alike the same texture",
    number: |_| Some((MOST_TEXTURES as f32, "textures")),
};
pub(super) const BLACK: Rule = Rule {
    id: "black",
    asks: "At most this share of the figure is black.",
    severity: Severity::Warning,
    source: "the profile's print.max_black; above 40 to 45 % swell paper curls",
    remedy: "make marks smaller or set them further apart",
    number: max_black,
};
pub(super) const LINES_AMONG_ROWS: Rule = Rule {
    id: "lines-among-rows",
    asks: "On a device with one height of dots, at most this share of the length of the lines has rows of a texture \
           nearer than 5 mm on both sides, which feel as lines do; lines of two rows of dots stand out all the same.",
    severity: Severity::Warning,
    source: "the share was chosen by us, on the sample pictures; a study of guide maps (40 sighted testers) found \
             lines easiest to tell from a texture of dots from 5 mm on",
    remedy: "convert the picture with lines only, without textures around its subject, or for a larger sheet; or \
             delete textures beside the lines that matter",
    number: |limits| match limits.medium {
        MediumLimits::Print { .. } => None,
        MediumLimits::Dots { .. } => Some((100.0 * MOST_BESIDE_ROWS, "%")),
    },
};
pub(super) const BRAILLE_CELL: Rule = Rule {
    id: "braille-cell",
    asks: "The dots of braille lie where a standard cell has them, and not farther off than this.",
    severity: Severity::Error,
    source: "the profile's braille.cell; EN ISO 17351 allows 4 % of 2.5 mm",
    remedy: "write the text anew; braille must not be scaled or bent",
    number: |_| Some((BRAILLE_OFF, MM)),
};
pub(super) const BRAILLE_CLEAR: Rule = Rule {
    id: "braille-gap",
    asks: "Around braille there is at least this blank; 2 mm between a label and its own line.",
    severity: Severity::Error,
    source: "MapGen: 3 mm on each side of a label",
    remedy: "move the text away, or delete what is beside it",
    number: |_| Some((BRAILLE_GAP, MM)),
};
pub(super) const LABEL_LINE: Rule = Rule {
    id: "label-line",
    asks: "A label's line ends no farther than this from a line or a texture, or within a closed shape, and begins \
           off the cell beside the label where dots are those of letters.",
    severity: Severity::Warning,
    source: "chosen by us: less than half of a fingertip's width; beyond it the finger finds nothing there",
    remedy: "lead it to what the label names, or delete the line and set the label beside that",
    number: |_| Some((LEADER_END, MM)),
};
pub(super) const LEFT_OUT: Rule = Rule {
    id: "left-out",
    asks: "No strong outline of the picture is left out of the page.",
    severity: Severity::Warning,
    source: "convert, which writes into the page what it had no room for",
    remedy: "make the figure larger, on larger paper if there is any, take a part of the picture, or draw by hand \
             what matters",
    number: none,
};
pub(super) const OVERVIEW: Rule = Rule {
    id: "overview",
    asks: "Every line of the overview has its like in the figure, not farther off than this.",
    severity: Severity::Warning,
    source: "chosen by us: in an overview lines are displaced by up to a spacing of two lines",
    remedy: "delete the line in the overview, or draw it in the figure too",
    number: |limits| Some((limits.spacing(), MM)),
};
pub(super) const OVERVIEW_LACKS: Rule = Rule {
    id: "overview-lacks",
    asks: "Every closed line of the figure that would be at least this wide and high in the overview is there, but for \
           faint ones; and most of all lines of a drawing.",
    severity: Severity::Warning,
    source: "chosen by us: about the width of a fingertip, the least that is felt as a shape at once",
    remedy: "copy the line into the overview, or leave it if it matters little",
    number: |_| Some((SHAPE, MM)),
};
pub(super) const BLACK_ONLY: Rule = Rule {
    id: "black-only",
    asks: "All marks of a printed page are black.",
    severity: Severity::Error,
    source: "tactilelibrary.com: only black swells; dark grey rises less, and coloured marks stay flat",
    remedy: "make them black, or delete them",
    number: none,
};
pub(super) const PICTURE: Rule = Rule {
    id: "picture",
    asks: "There is no picture of pixels on the page.",
    severity: Severity::Error,
    source: "its greys and details are not felt",
    remedy: "convert the picture, and delete it from the page",
    number: none,
};
pub(super) const LETTERS: Rule = Rule {
    id: "letters",
    asks: "There are no letters on the page.",
    severity: Severity::Error,
    source: "fingers do not read letters; transcribers write braille",
    remedy: "delete them, and write them as a label in braille",
    number: none,
};
pub(super) const ELSEWHERE: Rule = Rule {
    id: "elsewhere",
    asks: "All that the page shows is in its own file, and in SVG.",
    severity: Severity::Warning,
    source: "render reads no other files, and no HTML within a page",
    remedy: "put what is shown there on the page, as lines, areas or braille, or delete it",
    number: none,
};
pub(super) const FILLED: Rule = Rule {
    id: "filled",
    asks: "No large area is all black.",
    severity: Severity::Error,
    source: "of a block only the edge is felt, and it swells too much; 6.4 mm are APH's least symbol",
    remedy: "draw its outline, and fill it with a texture",
    number: none,
};
pub(super) const LAYERS: Rule = Rule {
    id: "layers",
    asks: "The drawing has the layers of a page of tactograph.",
    severity: Severity::Warning,
    source: "without them lines, textures and braille cannot be told apart, so all of it is judged as ink",
    remedy: "convert the picture with tactograph, and change that page",
    number: none,
};
pub(super) const EMPTY: Rule = Rule {
    id: "empty",
    asks: "There is a figure on the page.",
    severity: Severity::Warning,
    source: "a page without lines and textures says nothing",
    remedy: "draw something, or convert the picture with lower edges.high and edges.low",
    number: none,
};

/// What `render` makes of a breach, where it puts it right on a page that somebody changed.
pub(super) fn mended(rule: &Rule) -> Option<&'static str> {
    const MENDED: [(Rule, &str); 5] = [
        (LINE_WIDTH, "gives it the least width of the profile"),
        (TEXTURE_GAP, "leaves these marks out"),
        (FILLED, "draws the outline of a filled shape as a line, or in a layer of textures fills it with its texture"),
        (TEXTURE_SIGN, "draws the marks of its colour"),
        (BLACK_ONLY, "prints them black, or fills areas with the textures of their colours"),
    ];
    MENDED.iter().find(|(known, _)| known == rule).map(|(_, what)| *what)
}

/// What `render` makes of texts that are to be written in braille.
pub(super) const IN_BRAILLE: &str = "writes them in braille of standard cells";

/// All rules, in the order in which their breaches are told.
pub const RULES: &[Rule] = &[
    LAYERS,
    EMPTY,
    BLACK_ONLY,
    PICTURE,
    LETTERS,
    FILLED,
    LINE_GAP,
    LINE_WIDTH,
    LINE_LENGTH,
    TEXTURE_GAP,
    TEXTURE_AREA,
    TEXTURE_SIGN,
    GLYPH_SIZE,
    OVERLAP,
    MARGIN,
    TEXTURES,
    BRAILLE_CELL,
    BRAILLE_CLEAR,
    LINES_AMONG_ROWS,
    LABEL_LINE,
    BLACK,
    ELSEWHERE,
    LEFT_OUT,
    BROKEN_LINE,
    LOOSE_ENDS,
    OVERVIEW,
    OVERVIEW_LACKS,
];

#[cfg(test)]
mod tests;
