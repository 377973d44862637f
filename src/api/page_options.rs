//! How a page that was written, and perhaps changed, is looked at.

use std::fmt;
use std::ops::RangeInclusive;

use super::caller::Caller;
use crate::profile::{Plan, Profile};
use crate::{Error, touch};

/// How a page is [checked](crate::check), [described](crate::describe) or [felt](crate::feel). A builder, owned and
/// cheap to clone as [`Options`](crate::Options); what is not set has a default. Not all of it counts everywhere:
///
/// | | [`check`](crate::check) | [`describe`](crate::describe) | [`feel`](crate::feel) |
/// |---|---|---|---|
/// | [`profile`](Self::profile) | yes | yes | no |
/// | [`language`](Self::language) | no | yes | no |
/// | [`finger_mm`](Self::finger_mm) | no | no | yes |
/// | [`cancelled`](Self::cancelled) | yes | yes | yes |
///
/// ```
/// use tactograph::{PageOptions, Profile};
///
/// let options = PageOptions::new().profile(Profile::named("swell-a3")?).language("de");
/// # let _ = options;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
#[non_exhaustive]
#[must_use]
pub struct PageOptions {
    pub(super) profile: Option<Profile>,
    pub(super) language: Option<String>,
    pub(super) finger: f32,
    caller: Caller,
}

/// Fingertip of most adults, mm: that by which a check judges textures. Chosen by us: it serves to compare textures,
/// and does not stand for a reader.
pub(super) const USUAL_FINGER: f32 = 1.0;

impl PageOptions {
    /// The fingertips that there are, 0.3 to 2.5 mm: what [`PageOptions::finger_mm`] takes. Chosen by us, around those
    /// of children and of large hands.
    pub const FINGERS: RangeInclusive<f32> = touch::FINGERS;

    /// The page by its own profile, in its own language, with a fingertip of 1 mm.
    pub fn new() -> Self {
        Self { profile: None, language: None, finger: USUAL_FINGER, caller: Caller::default() }
    }

    /// Whose numbers a check, and the last sentence of a description, hold the page against. Default: those of the
    /// profile that the page says it was made with; of a page of an unknown profile, and of a drawing, the first of
    /// [`Profile::built_in`].
    pub fn profile(mut self, profile: Profile) -> Self {
        self.profile = Some(profile);
        self
    }

    /// The language of a description as a tag of BCP 47, such as `de` or `de-CH`: one of
    /// [`Description::languages`](crate::Description::languages), or [`describe`](crate::describe) gives
    /// [`Error::NoSuchName`]. Default: that of the page's own description.
    pub fn language(mut self, tag: impl Into<String>) -> Self {
        self.language = Some(tag.into());
        self
    }

    /// The fingertip that feels the page, mm, one of [`PageOptions::FINGERS`], or [`feel`](crate::feel) gives
    /// [`Error::NoSuchFinger`]. A check always takes the usual one. Default: 1.0.
    pub fn finger_mm(mut self, finger: f32) -> Self {
        self.finger = finger;
        self
    }

    /// Is asked, from the calling thread, whether the result is still wanted: after the page is read, between the
    /// textures that are felt, and between the kinds of rules. Once it is not, the work ends with [`Error::Cancelled`].
    /// Default: it is always wanted.
    ///
    /// Measured on two busy cores: an A4 page takes 0.3 s; the largest that can be felt, 700 x 700 mm full of textures
    /// and lines, 8 s, with at most 1.7 s from one question to the next. Of the largest that is read at all, with five
    /// million points, a check takes 34 s and a description 53 s, with up to 17 s between two questions. A drawing with
    /// filters is rendered without a question; one whose filters would take more than about 10 s is refused
    /// ([`Error::TooComplex`]). There is no progress.
    pub fn cancelled(mut self, asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        self.caller.on_question(asked);
        self
    }

    /// Between two parts of the work: whether to go on.
    ///
    /// # Errors
    /// If the caller has cancelled.
    pub(super) fn go_on(&self) -> Result<(), Error> {
        self.caller.go_on()
    }

    /// The plan of the profile that was asked for, or of the page's own.
    ///
    /// # Errors
    /// [`Error::Profile`] if it has faults.
    pub(super) fn plan(&self, origin: &[(String, String)]) -> Result<Plan, Error> {
        match &self.profile {
            Some(profile) => Ok(Plan::new(profile)?),
            None => Ok(Plan::new(&Profile::of_origin(origin)?.0)?),
        }
    }
}

impl Default for PageOptions {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for PageOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let profile = self.profile.as_ref().map(|profile| &profile.name);
        let Self { language, finger, .. } = self;
        f.debug_struct("PageOptions")
            .field("profile", &profile)
            .field("language", language)
            .field("finger", finger)
            .finish_non_exhaustive()
    }
}
