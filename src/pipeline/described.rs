//! What stands in a page's files for screen readers: its marks in sentences, unless its maker has described it.

use crate::description;
use crate::output::seal;
use crate::page::{Page, Parts};
use crate::wording::Wording;

/// The entry of a page's origin by which a description that was made is told from a person's: the seal of its text.
const MADE: &str = "seal of the description";

/// A page with a description of its marks, in the words of `wording`.
pub(super) fn described(page: Page, wording: &Wording) -> Page {
    let description = description::of_marks(&page, wording);
    let made = (MADE.to_owned(), seal::of(description.as_bytes()));
    page.described(description, wording.language(), made)
}

/// Whether a page's description is as it was made: no person has changed it.
pub fn is_made(page: &Parts) -> bool {
    let seal = seal::of(page.description.as_bytes());
    page.origin.iter().any(|(name, value)| name == MADE && *value == seal)
}
