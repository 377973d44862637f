//! A page in sentences.

use super::checking::check;
use crate::description::{self, Description};
use crate::profile::Profile;
use crate::{Error, reading};

/// Describes a page in plain English sentences, the most important first: the SVG of a page, as
/// [`Page::to_svg`](crate::Page::to_svg) writes it or as somebody changed it in an editor. The last sentence is the
/// verdict of [`check`], with the numbers of `profile` or of the profile that the page was made with.
///
/// # Errors
/// As [`check`], and [`Error::NotAPage`] of a drawing that has no layers of a page.
pub fn describe(page: impl AsRef<[u8]>, profile: Option<&Profile>) -> Result<Description, Error> {
    let bytes = page.as_ref();
    let read = reading::read(bytes)?;
    let checked = check(bytes, profile)?;
    Ok(description::describe(&read.page, &checked.verdict))
}
