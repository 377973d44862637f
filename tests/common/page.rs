//! Pages made the way the program makes them.

use std::sync::Arc;

use tactograph::internals::pipeline::{Drawing, Request, Watch};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::decode::Limits;

/// Makes the page of a picture with the default profile and `settings` on top; the stages that ran or were skipped go to
/// `watch`. No fonts, so that the page does not hang on the machine's.
#[allow(dead_code, reason = "not every test that has this file uses all of it")]
pub(crate) fn page_of(bytes: &[u8], title: &str, settings: &[(&str, &str)], watch: &mut Watch<'_>) -> Drawing {
    let mut profile = Profile::named("swell-a4").expect("the default profile is there");
    for (key, value) in settings {
        profile.set(key, value).expect("the test sets what there is");
    }
    page_for(bytes, title, &profile, watch)
}

/// Makes the page of a picture with a profile.
pub(crate) fn page_for(bytes: &[u8], title: &str, profile: &Profile, watch: &mut Watch<'_>) -> Drawing {
    let plan = Plan::new(profile).expect("the settings make sense together");
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request { plan: &plan, limits: Limits::default(), fonts: &fonts, title, fit: Default::default() };
    tactograph::internals::pipeline::convert(bytes, &request, watch).expect("the picture can be converted")
}
