//! Textures give way to the lines of a page that somebody changed.

use crate::legibility;
use crate::page::{Page, Parts};
use crate::profile::Plan;
use crate::{About, Error, Note};

/// An area of which so much is left, as a share of the least that a texture needs, is left out as a whole: a few signs
/// by themselves are felt as dots.
const LEAST_LEFT: f32 = 0.5;

/// The page without those signs that are nearer to a line than `plan` allows; says how many they are.
///
/// # Errors
/// None of its own: marks only become fewer.
pub(super) fn textures(page: Page, plan: &Plan) -> Result<(Page, Option<Note>), Error> {
    let crowded = legibility::crowded(&page, &plan.limits());
    if crowded.is_empty() {
        return Ok((page, None));
    }
    let mut parts = Parts::clone(&page);
    let least = LEAST_LEFT * plan.profile().colours.min_area;
    let mut areas = 0;
    // those of one texture follow one another, in its order
    for gone in crowded.chunk_by(|a, b| a.0 == b.0) {
        let texture = &mut parts.figure.textures[gone[0].0];
        let mut at = 0;
        let before = texture.glyphs.len();
        texture.glyphs.retain(|_| {
            at += 1;
            gone.binary_search_by_key(&(at - 1), |(_, glyph)| *glyph).is_err()
        });
        let left = texture.area * texture.glyphs.len() as f32 / before.max(1) as f32;
        if left < least {
            texture.glyphs.clear();
            areas += 1;
        }
    }
    parts.figure.textures.retain(|texture| !texture.glyphs.is_empty());
    let count = crowded.len();
    let (signs, are) = if count == 1 { ("sign", "is") } else { ("signs", "are") };
    let whole = match areas {
        0 => String::new(),
        1 => "; of 1 area too little is left for a texture".to_owned(),
        _ => format!("; of {areas} areas too little is left for a texture"),
    };
    let told = format!("{count} {signs} of textures that {are} too near to a line that was drawn or moved{whole}");
    Ok((Page::new(parts)?, Some(Note::NotOnPage(About::Signs, told))))
}
