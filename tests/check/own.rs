//! Every page that the program writes passes.

use crate::common::{page, samples};
use tactograph::Page;
use tactograph::internals::legibility::check;
use tactograph::internals::profile::{Plan, Profile, built_in};
use tactograph_tools::scenes;

/// The errors of a page that was made with a profile.
fn errors(page: &Page, profile: &Profile) -> Vec<String> {
    let plan = Plan::new(profile).expect("it makes sense");
    let checked = check(page, &plan.limits(), None);
    let errors = checked.findings.into_iter().filter(|finding| finding.is_error());
    errors.map(|error| format!("{}: {} at {:?}: {}", page.title, error.rule.id, error.at, error.what)).collect()
}

#[test]
fn pages_of_samples_pass_with_every_profile() {
    let mut faults = Vec::new();
    for file in built_in() {
        let profile = Profile::named(file.name).expect("it is built in");
        for sample in samples::names() {
            let drawing = page::of_sample(&sample, file.name);
            let pages = std::iter::once(&drawing.page).chain(&drawing.overview);
            faults.extend(pages.flat_map(|page| errors(page, &profile)).map(|error| format!("{}: {error}", file.name)));
        }
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn pages_of_random_scenes_and_noise_pass() {
    let mut faults = Vec::new();
    for seed in 0..SCENES {
        let name = scenes::PROFILES[seed as usize % scenes::PROFILES.len()];
        let profile = Profile::named(name).expect("it is built in");
        let pixels = scenes::picture(seed, 240);
        let picture = tactograph::Picture::rgba8(240, 240, &pixels).expect("it has all its pixels");
        let options = tactograph::Options::new(profile.clone()).title(format!("scene {seed}"));
        let Ok(drawing) = tactograph::convert(picture, &options) else { continue };
        let pages = std::iter::once(&drawing.page).chain(&drawing.overview);
        faults.extend(pages.flat_map(|page| errors(page, &profile)).map(|error| format!("{name}: {error}")));
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
}

/// How many of them: a few seconds' work. `tools/src/bin/checking.rs` looks at 200.
const SCENES: u64 = 40;
