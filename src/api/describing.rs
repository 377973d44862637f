//! A page in sentences.

use super::checking::check;
use crate::description::{self, Description};
use crate::pipeline;
use crate::profile::{Plan, Profile};
use crate::wording::Wording;
use crate::{Error, reading};

/// Describes a page in plain sentences, the most important first: the SVG of a page, as
/// [`Page::to_svg`](crate::Page::to_svg) writes it or as somebody changed it in an editor. The last sentence is the
/// verdict of [`check`], with the numbers of `profile` or of the profile that the page was made with. `language` is a
/// tag of BCP 47: `en`, `de`, `es`, `fr` or `pl`; without it the language of the page's own description is taken.
///
/// # Errors
/// As [`check`], [`Error::NotAPage`] of a drawing that has no layers of a page, and [`Error::NoSentences`] of another
/// language.
pub fn describe(
    page: impl AsRef<[u8]>,
    profile: Option<&Profile>,
    language: Option<&str>,
) -> Result<Description, Error> {
    let wording = language.map(|tag| {
        Wording::of_language(tag).ok_or_else(|| Error::NoSentences {
            language: tag.to_owned(),
            known: Wording::languages().collect::<Vec<_>>().join(", "),
        })
    });
    let wording = wording.transpose()?;
    let bytes = page.as_ref();
    let read = reading::read(bytes)?;
    let checked = check(bytes, profile)?;
    let wording = wording.unwrap_or_else(|| Wording::nearest(&read.page.description_language));
    // what somebody drew or typed is told as render makes it
    let page = if read.areas.is_empty() && read.texts.is_empty() {
        read.page
    } else {
        let plan = Plan::new(&Profile::of_page(&read.page.origin)?.0)?;
        pipeline::adapted(&read, &plan, None)?.page
    };
    Ok(description::describe(&page, &checked.verdict, wording))
}
