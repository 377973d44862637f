//! Pages made the way the program makes them.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock, OnceLock};

use tactograph::internals::pipeline::{Drawing, Request, Watch};
use tactograph::internals::profile::{Plan, Profile, built_in};
use tactograph::internals::raster::decode::Limits;

use super::samples;

/// The page of a sample with a built-in profile as it is; its title is the sample's name. Made once for all tests.
pub(crate) fn of_sample(sample: &str, profile: &str) -> &'static Drawing {
    type Made = BTreeMap<(String, &'static str), OnceLock<Drawing>>;
    static MADE: LazyLock<Made> = LazyLock::new(|| {
        let names = || built_in().iter().map(|file| file.name);
        let pairs = samples::names().into_iter().flat_map(|sample| names().map(move |name| (sample.clone(), name)));
        pairs.map(|pair| (pair, OnceLock::new())).collect()
    });
    let (_, page) = MADE
        .iter()
        .find(|((name, with), _)| name == sample && *with == profile)
        .expect("the sample and the profile are there");
    page.get_or_init(|| {
        let profile = Profile::named(profile).expect("it is built in");
        page_for(&samples::read(sample), sample, &profile, &mut |_| ())
    })
}

/// Makes the page of a picture with the default profile and `settings` on top; the stages that ran or were skipped go to
/// `watch`. No fonts, so that the page does not hang on the machine's.
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
    let request = Request {
        plan: &plan,
        limits: Limits::default(),
        fonts: &fonts,
        title,
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    tactograph::internals::pipeline::convert(bytes, &request, watch).expect("the picture can be converted")
}
