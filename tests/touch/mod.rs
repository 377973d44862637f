//! Can a fingertip tell the textures? The targets, on scenes whose colours are known. `cargo run
//! --release -p tactograph-tools --bin touch` prints the same for more scenes; the scenes and the measures are that program's.

mod dotted;
mod edited;

use crate::common::{page, samples};
use tactograph::internals::output::svg;
use tactograph::internals::page::{Class, Page};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::textures::Params;
use tactograph::internals::touch::Ink;
use tactograph::internals::units::{MmPoint, MmRect};
use tactograph_tools::touch::judge::{self, Tally};
use tactograph_tools::touch::scenes::{self, FINE_PX, KINDS, QUICK_PX, Scene};
use tactograph_tools::touch::{boldness, chart, density, gaps};

const FINGERS: [f32; 3] = [0.5, 1.0, 1.5];
/// Shares that must be read right at each of them.
const AREAS: [f32; 3] = [0.99, 0.98, 0.95];
const GREY: [f32; 3] = [0.99, 0.98, 0.93];

fn params() -> Params {
    let profile = Profile::named("swell-a4").expect("it is built in");
    Plan::new(&profile).expect("it makes sense").textures()
}

fn page_of(scene: &Scene, settings: &[(&str, &str)]) -> Page {
    page::page_of(&scene.picture, "scene", settings, &mut |_| ()).page
}

/// What is felt of all kinds of scenes with these seeds.
fn felt(seeds: &[u64]) -> [Tally; 3] {
    let of_kind = |kind: usize| {
        let mut tallies = [Tally::default(); 3];
        for &seed in seeds {
            let scene = scenes::scene(kind, seed, FINE_PX);
            let page = page_of(&scene, &[]);
            let ink = Ink::of(&svg::write(&page)).expect("a page is a page");
            for (tally, finger) in tallies.iter_mut().zip(FINGERS) {
                tally.add(&judge::judge(&scene, &page, &ink.felt(finger).expect("there is such a finger")));
            }
        }
        tallies
    };
    let mut sums = [Tally::default(); 3];
    std::thread::scope(|scope| {
        let work: Vec<_> = (0..KINDS.len()).map(|kind| scope.spawn(move || of_kind(kind))).collect();
        for tallies in work.into_iter().map(|work| work.join().expect("no scene fails")) {
            sums.iter_mut().zip(&tallies).for_each(|(sum, tally)| sum.add(tally));
        }
    });
    sums
}

#[track_caller]
fn hold(sums: &[Tally; 3]) {
    for (f, sum) in sums.iter().enumerate() {
        let told = format!("a fingertip of {} mm: {:?}", FINGERS[f], sum.felt);
        let (judged, areas) = sum.share(judge::CLASSES);
        assert!(judged > 20_000, "too little is judged, {told}");
        assert!(areas >= AREAS[f], "{areas} of the areas, {told}");
        let grey = sum.share(judge::only(Some(Class::Grey))).1;
        assert!(grey >= GREY[f], "{grey} of grey, {told}");
        let (judged, white) = sum.share(judge::only(None));
        assert!(judged > 1000 && white >= 1.0, "{white} of white, {told}");
    }
}

#[test]
fn colours_are_read_right_on_the_scenes_that_textures_were_tuned_to() {
    hold(&felt(&[0, 1]));
}

#[test]
fn colours_are_read_right_on_scenes_never_tuned_to() {
    hold(&felt(&[1000]));
}

#[test]
fn each_texture_is_read_right_at_every_density_and_lightness() {
    let params = params();
    let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(60.0, 60.0));
    for class in Class::ALL {
        for (density, lightness) in [0.0, 0.2, 0.4, 1.0].into_iter().flat_map(|d| [0.88, 0.1].map(|l| (d, l))) {
            let sample = chart::page_of_sample(class, lightness, density, place, &params);
            let ink = Ink::of(&svg::write(&sample)).expect("a page is a page");
            for (finger, least) in FINGERS.into_iter().zip(AREAS) {
                let share = judge::share_of_sample(class, &ink.felt(finger).expect("there is such a finger"), place);
                let told = format!("{class:?}, density {density}, lightness {lightness}, fingertip {finger} mm");
                assert!(share >= least, "{told}: {share} is read right");
            }
        }
    }
}

#[test]
fn ink_falls_with_lightness_without_a_step() {
    for class in Class::ALL {
        for density in [0.0, 0.4, 1.0] {
            let boldness = boldness::measure(class, density, &params());
            assert!(boldness.monotone, "{class:?} at density {density}: {boldness:?}");
            assert!(boldness.rank > 0.98 && boldness.jump < 0.08, "{class:?} at density {density}: {boldness:?}");
        }
    }
}

#[test]
fn glyphs_stand_dense_where_lines_are() {
    let full = Profile::named("swell-a4").expect("it is built in").textures.dense_from;
    let mut pairs = Vec::new();
    for (kind, seed) in [(1, 1001), (2, 1000), (2, 1002), (3, 1000)] {
        let scene = scenes::scene(kind, seed, FINE_PX);
        let [page, dense] = [page_of(&scene, &[]), page_of(&scene, &[("textures.dense_from", "0")])];
        pairs.extend(Class::ALL.iter().flat_map(|&class| density::pairs(&page, &dense, class)));
    }
    assert!(pairs.len() > 1000, "only {} places", pairs.len());
    let wanted: Vec<(f32, f32)> = pairs.iter().map(|(lines, glyphs)| ((lines / full).min(1.0), *glyphs)).collect();
    let (cut, plain) = (density::correlation(&wanted), density::correlation(&pairs));
    assert!(cut > 0.95 && plain > 0.93, "correlation {cut} up to dense_from, {plain} over all of the map");
}

#[test]
fn no_glyph_is_too_near_to_anything_or_too_small() {
    let params = params();
    let mut faults = Vec::new();
    for (kind, name) in KINDS.iter().enumerate() {
        for seed in 1000..1034 {
            let page = page_of(&scenes::scene(kind, seed, QUICK_PX), &[]);
            faults.extend(gaps::faults(&page, &params).into_iter().map(|fault| format!("{name} {seed}: {fault}")));
        }
    }
    for name in samples::names() {
        let page = &page::of_sample(&name, "swell-a4").page;
        faults.extend(gaps::faults(page, &params).into_iter().map(|fault| format!("{name}: {fault}")));
    }
    assert!(faults.is_empty(), "{} faults, such as {}", faults.len(), faults[0]);
}
