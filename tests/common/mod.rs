//! What several tests need: the sample pictures as they lie in `samples/`, and their pages.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use tactograph::pipeline::{Drawing, Event, Request};
use tactograph::profile::{Plan, Profile};
use tactograph::raster::decode::Limits;

/// The sample pictures, sorted by name.
pub(crate) fn samples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples");
    let mut pictures: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("there is a folder of samples")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|ending| ending != "md"))
        .collect();
    pictures.sort();
    pictures
}

/// Makes the page of a picture with the default profile and `settings` on top; the stages that ran or were skipped go to
/// `watch`. No fonts, so that the page does not hang on the machine's.
pub(crate) fn page_of(bytes: &[u8], title: &str, settings: &[(&str, &str)], watch: &mut dyn FnMut(Event)) -> Drawing {
    let mut profile = Profile::named("swell-a4").expect("the default profile is there");
    for (key, value) in settings {
        profile.set(key, value).expect("the test sets what there is");
    }
    let plan = Plan::new(&profile).expect("the settings make sense together");
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request { plan: &plan, limits: Limits::default(), fonts: &fonts, title };
    tactograph::convert(bytes, &request, watch).expect("the picture can be converted")
}
