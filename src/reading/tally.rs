//! What is told of a page that was read.

use std::collections::BTreeMap;

use crate::listing::counted;
use crate::units::MmPoint;
use crate::{About, Note};

/// What is told when all is read, as counts and the place of the first.
#[derive(Default)]
pub(super) struct Tally {
    told: BTreeMap<What, (usize, Option<MmPoint>)>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum What {
    LineOutside,
    DotOutside,
    Outlined,
    NoGlyph,
    OffSheet,
    Shaded,
    Dashed,
    UnevenDots,
    Foreign,
    InPrint,
    White,
}

/// What is told of pictures of pixels, of marks far beyond the sheet, of what cuts off others, and of what is filled
/// unevenly, by how many there are.
pub(super) fn told_of_file([pictures, far, clipped, patterned]: [usize; 4]) -> impl Iterator<Item = Note> {
    let all = [
        (pictures, format!("{}: convert what is in a picture to lines first", counted(pictures, "picture"))),
        (far, format!("{} far beyond the sheet", counted(far, "mark"))),
        (clipped, format!("clip paths, masks and filters ({clipped}): what they cut off is there")),
    ];
    let left_out = all.into_iter().filter(|(count, _)| *count > 0);
    let patterned_as = format!("gradients and patterns ({patterned}), taken as black: only black rises");
    let taken = (patterned > 0).then_some(Note::TakenAs(About::Marks, patterned_as));
    left_out.map(|(_, what)| Note::NotOnPage(About::Marks, what)).chain(taken)
}

impl Tally {
    pub(super) fn add(&mut self, what: What, at: Option<MmPoint>) {
        let (count, first) = self.told.entry(what).or_default();
        *count += 1;
        *first = first.or(at);
    }

    pub(super) fn notes(&self) -> impl Iterator<Item = Note> + '_ {
        self.told.iter().map(|(what, (count, first))| {
            let n = |one: &str, many: &str| if *count == 1 { format!("1 {one}") } else { format!("{count} {many}") };
            let at = first.map_or(String::new(), |at| format!(" (the first at {:.0}, {:.0} mm)", at.x, at.y));
            let left_out = |about: About, what: String| Note::NotOnPage(about, what);
            let taken = |about: About, what: String| Note::TakenAs(about, what);
            match what {
                What::LineOutside => taken(
                    About::Lines,
                    format!("{}{at} outside of the layers, taken as lines of the figure", n("line", "lines")),
                ),
                What::DotOutside => {
                    taken(About::Dots, format!("{}{at} outside of the layers, taken as dots", n("disc", "discs")))
                }
                What::Outlined => taken(
                    About::Areas,
                    format!(
                        "{}{at} without the colour of a texture, drawn as {}",
                        n("filled shape", "filled shapes"),
                        if *count == 1 { "a line around it" } else { "lines around them" }
                    ),
                ),
                What::NoGlyph => left_out(
                    About::Signs,
                    format!(
                        "{}{at} among the textures, neither rhombus nor dot; draw lines in the layer Lines",
                        n("shape", "shapes")
                    ),
                ),
                What::OffSheet => left_out(About::Marks, format!("{}{at} beyond the sheet", n("mark", "marks"))),
                What::Shaded => taken(
                    About::Marks,
                    format!("{}{at} in grey or colour, taken as black: only black rises", n("mark", "marks")),
                ),
                What::Dashed => {
                    taken(About::Lines, format!("{}{at} with dashes, taken without gaps", n("line", "lines")))
                }
                What::InPrint => {
                    left_out(About::Print, format!("{}{at} in the layer of words in print", n("shape", "shapes")))
                }
                What::White => taken(
                    About::Marks,
                    format!(
                        "{}{at}: what is white prints nothing and covers nothing; delete what lies under it",
                        n("white mark", "white marks")
                    ),
                ),
                What::Foreign => left_out(About::Marks, format!("{}{at} outside of the layer", n("mark", "marks"))),
                What::UnevenDots => taken(
                    About::Dots,
                    format!(
                        "{}{at} of other sizes than the others of its group, taken as of one size",
                        n("dot", "dots")
                    ),
                ),
            }
        })
    }
}
