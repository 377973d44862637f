//! Areas are large enough to be read, and no glyph of theirs strays.

use std::path::Path;
use std::sync::Arc;

use tactograph::internals::classes::Classes;
use tactograph::internals::pipeline::{Request, colours};
use tactograph::internals::profile::{Plan, Profile};

use crate::common::page;

const SAMPLES: [&str; 7] =
    ["astronaut.png", "bars.svg", "chelsea.png", "coffee.png", "landscape.svg", "portrait.svg", "rocket.jpg"];

fn sample(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(name);
    std::fs::read(path).expect("a sample can be read")
}

/// The sorted colours of a picture, and the area of a cell, mm^2.
fn sorted(picture: &[u8], settings: &[(&str, &str)]) -> (Classes, f32) {
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("the test sets what there is"));
    let plan = Plan::new(&profile).expect("it makes sense");
    let request = Request {
        plan: &plan,
        limits: Default::default(),
        fonts: &Arc::default,
        title: "test",
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    let sorted = colours::sort(picture, &request, &mut |_| ()).expect("the picture can be sorted");
    let classes = sorted.classes.expect("the profile wants textures");
    let cell = sorted.place.area() / classes.size.area() as f32;
    (classes, cell)
}

#[test]
fn no_area_is_too_small_to_be_read() {
    for name in SAMPLES {
        let (classes, cell) = sorted(&sample(name), &[]);
        for region in &classes.regions {
            let area = region.cells as f32 * cell;
            // An area with only smaller ones around it would have no one to join; there is none such in the samples.
            assert!(area >= 0.97 * 170.0, "{name}: {region:?} is {area} mm2");
        }
    }
}

#[test]
fn regions_tell_their_mean_colour() {
    let (classes, cell) = sorted(&sample("bars.svg"), &[]);
    let bars: Vec<_> = classes.regions.iter().map(|region| (region.class.name(), region.colour)).collect();
    assert_eq!(bars.len(), 5);
    for (want, (name, [r, g, b])) in ["blue", "green", "yellow", "red", "grey"].iter().zip(bars) {
        let seen = match name {
            "blue" => b > r && b > g,
            "green" => g > r && g > b,
            "yellow" => r > b && g > b && r.abs_diff(g) < 80,
            "red" => r > g && r > b,
            _ => r == g && g == b,
        };
        assert!(name == *want && seen, "{want} is {name} with the colour {r} {g} {b}");
    }
    let all: f32 = classes.regions.iter().map(|region| region.cells as f32 * cell).sum();
    assert!((0.3..0.9).contains(&(all / (classes.size.area() as f32 * cell))), "{all} mm2");
}

/// No glyph, with lines or without, stands further from all others of its texture than rows of the sparsest texture do (8.4
/// mm), and few are the last of a row end.
#[test]
fn no_single_glyphs_stray() {
    for lines in ["true", "false"] {
        let (mut all, mut loose) = (0, 0);
        for name in SAMPLES {
            let page = page::page_of(&sample(name), name, &[("figure.lines", lines)], &mut |_| ()).page;
            for texture in &page.figure.textures {
                all += texture.glyphs.len();
                for glyph in &texture.glyphs {
                    // the glyph itself is one of them
                    let near = texture.glyphs.iter().filter(|other| (other.at - glyph.at).length() < 8.5).count();
                    assert!(near > 1, "{name}: a glyph of {} stands alone at {:?}", texture.class.name(), glyph.at);
                    loose += u32::from(near == 2);
                }
            }
        }
        let share = loose as f32 / all as f32;
        println!("lines {lines}: {:.2} % of {all} glyphs have but one neighbour", 100.0 * share);
        assert!(share < 0.025, "{share}");
    }
}
