//! Every page that the program writes passes.

use crate::common::{page, samples};
use tactograph::Page;
use tactograph::internals::legibility::check;
use tactograph::internals::profile::{Plan, Profile, built_in};

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

/// Noise, blobs and stripes: pictures that nobody has looked at.
fn picture(seed: u64, size: usize) -> Vec<u8> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 40) as f32 / (1_u64 << 24) as f32
    };
    let noise = if seed.is_multiple_of(3) { 0.5 } else { 0.02 };
    let blobs: Vec<[f32; 6]> = (0..4 + seed % 9).map(|_| std::array::from_fn(|_| random())).collect();
    let mut pixels = Vec::with_capacity(4 * size * size);
    for i in 0..size * size {
        let (x, y) = ((i % size) as f32 / size as f32, (i / size) as f32 / size as f32);
        let mut colour = [0.9, 0.9, 0.85];
        for [cx, cy, r, red, green, blue] in &blobs {
            let radius = 0.05 + 0.3 * r;
            let (dx, dy) = (x - cx, y - cy);
            let inside = match (100.0 * r) as u32 % 3 {
                0 => dx.hypot(dy) < radius,
                1 => dx.abs().max(dy.abs()) < radius,
                _ => (8.0 * dx + 20.0 * dy * r).sin() > 0.6,
            };
            if inside {
                colour = [*red, *green, *blue];
            }
        }
        let grain = noise * (random() - 0.5);
        pixels.extend(colour.map(|channel: f32| (255.0 * (channel + grain).clamp(0.0, 1.0)) as u8));
        pixels.push(255);
    }
    pixels
}

#[test]
fn pages_of_random_scenes_and_noise_pass() {
    let mut faults = Vec::new();
    let profiles = ["swell-a4", "index-basic-d", "braillerap", "monarch"];
    for seed in 0..SCENES {
        let name = profiles[(seed % 4) as usize];
        let profile = Profile::named(name).expect("it is built in");
        let pixels = picture(seed, 240);
        let picture = tactograph::Picture::rgba8(240, 240, &pixels).expect("it has all its pixels");
        let options = tactograph::Options::new(profile.clone()).title(format!("scene {seed}"));
        let Ok(drawing) = tactograph::convert(picture, &options) else { continue };
        let pages = std::iter::once(&drawing.page).chain(&drawing.overview);
        faults.extend(pages.flat_map(|page| errors(page, &profile)).map(|error| format!("{name}: {error}")));
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
}

/// How many of them: a few seconds' work.
const SCENES: u64 = 40;
