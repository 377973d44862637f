//! Labels in braille: each beside what it names, apart from lines and from one another.
//!
//! ```text
//! wanted -> forms (one line, two, abbreviated) -> candidates (free places near the anchor) -> choose -> placed
//! ```
//!
//! Labels are horizontal, as fingers read them, and 3 mm from lines; textures make room for them. One that has to lie
//! further away than 12 mm has a leader line. What has no room in full is abbreviated.

mod abbreviate;
mod candidates;
mod choose;
mod forms;
mod placed;
mod room;

pub use candidates::Params;
pub use choose::{Choice, choose};
pub use placed::{Placed, Unplaced, Wanted};

use crate::braille::Translator;
use crate::page::Figure;
use crate::page::cells::CellGrid;
use candidates::Candidate;
use forms::{Form, Forms};
use room::Room;

/// Most labels of a page. Chosen by us: a sheet of A3 has room for some 150, and looking for places takes its time.
pub const MOST: usize = 300;

pub use forms::LONGEST;

/// The labels in the order in which they were wanted, each with its place or the reason why it has none.
pub fn place(
    wanted: &[Wanted],
    translator: &Translator<'_>,
    figure: &Figure,
    cells: &CellGrid<'_>,
    params: &Params,
) -> Vec<Result<Placed, Unplaced>> {
    let (wanted, too_many) = wanted.split_at(wanted.len().min(MOST));
    let room = Room::new(params.area, &figure.lines, &figure.textures, params.clearance);
    let texts: Vec<&str> = wanted.iter().map(|label| label.text.as_str()).collect();
    let forms = forms::of(&texts, translator);
    let candidates_of = |(label, forms): (&Wanted, &Result<Forms, Unplaced>)| match forms {
        Ok(forms) => candidates::of(label, &forms.forms, &room, cells, params),
        Err(_) => Vec::new(),
    };
    let candidates: Vec<Vec<Candidate>> = wanted.iter().zip(&forms).map(candidates_of).collect();
    let costs: Vec<Vec<f32>> =
        candidates.iter().map(|of| of.iter().map(|candidate| candidate.cost).collect()).collect();
    let chosen = choose(&costs, &|a, b| candidates[a.label][a.candidate].conflicts(&candidates[b.label][b.candidate]));
    let placed = forms.into_iter().zip(chosen).zip(&candidates).map(|((forms, chosen), candidates)| {
        let Forms { mut forms, lacking } = forms?;
        let candidate = &candidates[chosen.ok_or(Unplaced::NoRoom)?];
        let Form { lines, abbreviation, .. } = forms.swap_remove(candidate.form);
        Ok(Placed { place: candidate.place, lines, lacking, abbreviation, leader: candidate.leader })
    });
    placed.chain(too_many.iter().map(|_| Err(Unplaced::TooMany))).collect()
}

/// Takes the glyphs out of a figure that labels and their leader lines need blank.
pub fn make_room(figure: &mut Figure, placed: &[&Placed], params: &Params) {
    for texture in &mut figure.textures {
        texture
            .glyphs
            .retain(|glyph| placed.iter().all(|label| label.distance(glyph.at) - glyph.radius() >= params.clearance));
    }
    figure.textures.retain(|texture| !texture.glyphs.is_empty());
}
