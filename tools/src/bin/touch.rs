//! Can a fingertip tell the colours apart? Scenes whose colours are known become pages, and the pages are felt.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin touch                     the table of targets (some minutes)
//!   --seeds N                scenes of each kind (default 6); the same number again is of seeds never tuned to
//!   --kinds                  also a table for each kind of scene
//!   --set KEY=VALUE          another value of the profile
//!   --dots PROFILE           the same for a built-in profile of dots
//!   --page PICTURE FILE.svg  with --dots: draw the page of a picture instead
//!   --chart FILE.svg         draw the chart of the textures instead (docs/textures/textures.svg)
//! ```
//!
//! **Scenes** (`scenes.rs`): the paper's five bars, a ramp of each colour from dark to white, maps of twelve areas, stripes
//! and discs of falling size, colour wheels; all but the first of a kind turned by any angle. **Read right** (`judge.rs`):
//! the measure of `tactograph::internals::touch` on the page's SVG, at every millimetre further than 7 mm from a border and not lighter
//! than 0.88. **Samples**: one texture all over a page, at every density and three lightnesses. **Density** (`density.rs`):
//! the share of glyphs in a window of 8 mm against the map of lines. **Boldness** (`boldness.rs`): ink at 256 lightnesses.
//! **Gaps** (`gaps.rs`): every glyph of every sample picture and 200 random scenes. **Time**: the textures of a full
//! A4 figure, the least of twenty runs.
#![allow(clippy::print_stdout, reason = "this is a program")]

use std::sync::Arc;
use std::time::{Duration, Instant};

use tactograph::Page;
use tactograph::internals::output::svg;
use tactograph::internals::page::Class;
use tactograph::internals::pipeline::{Event, Request, Stage, Watch};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::textures;
use tactograph::internals::touch::Ink;
use tactograph::internals::units::{MmPoint, MmRect};
use tactograph_tools::touch::judge::{self, Tally};
use tactograph_tools::touch::scenes::{self, FINE_PX, KINDS, QUICK_PX, Scene};
use tactograph_tools::touch::{boldness, chart, density, dots, gaps};

const FINGERS: [f32; 3] = [0.5, 1.0, 1.5];
/// Wanted of areas, of grey and of white, for each fingertip.
const WANTED: [[f32; 3]; 3] = [[0.99, 0.98, 0.95], [0.99, 0.98, 0.93], [1.0, 1.0, 1.0]];
/// The textures were tuned on seeds from 0 to 25.
const UNTUNED: u64 = 1000;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let value = |name: &str| args.iter().position(|arg| arg == name).and_then(|at| args.get(at + 1));
    let dots = value("--dots");
    let mut profile = Profile::named(dots.map_or("swell-a4", String::as_str)).expect("a built-in profile");
    for pair in args.windows(2).filter(|pair| pair[0] == "--set") {
        let (key, value) = pair[1].split_once('=').expect("--set KEY=VALUE");
        profile.set(key, value).expect("a key of the profile");
    }
    let plan = Plan::new(&profile).expect("the values make sense");
    if let Some(file) = value("--chart") {
        std::fs::write(file, chart::chart(&plan.textures())).expect("the chart can be written");
        return;
    }
    let seeds = value("--seeds").map_or(6, |number| number.parse().expect("--seeds N"));
    let kinds = args.iter().any(|arg| arg == "--kinds");
    if dots.is_some() {
        return of_dots(&profile, &args, seeds, kinds);
    }
    let pages = |scene: &Scene| vec![(scene.clone(), page_of(&scene.picture, &plan, &mut |_| ()))];
    readability("seeds tuned to", 0..seeds, kinds, &pages);
    readability("seeds never tuned to", UNTUNED..UNTUNED + seeds, kinds, &pages);
    let params = plan.textures();
    samples(&|class, lightness, density| {
        let place = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(80.0, 80.0));
        (chart::page_of_sample(class, lightness, density, place, &params), place)
    });
    profile.set("textures.dense_from", "0").expect("a key of the profile");
    let dense = Plan::new(&profile).expect("the values make sense");
    let dense = |scene: &Scene| vec![(scene.clone(), page_of(&scene.picture, &dense, &mut |_| ()))];
    follows_lines(plan.profile().textures.dense_from, UNTUNED..UNTUNED + seeds, &pages, &dense);
    follows_lightness(&plan.textures());
    distances(&plan);
    time(&plan);
}

/// The tables of a profile of dots, or the page of a picture.
fn of_dots(profile: &Profile, args: &[String], seeds: u64, kinds: bool) {
    let device = |profile: &Profile| dots::Device::of(profile).expect("a profile of dots");
    let shipped = device(profile);
    if let Some(at) = args.iter().position(|arg| arg == "--page") {
        let picture = std::fs::read(&args[at + 1]).expect("--page PICTURE FILE.svg");
        std::fs::write(&args[at + 2], svg::write(&shipped.page_of(&picture, None))).expect("the page can be written");
        return;
    }
    let pages = |scene: &Scene| shipped.pages_of(scene);
    readability("seeds tuned to", 0..seeds, kinds, &pages);
    readability("seeds never tuned to", UNTUNED..UNTUNED + seeds, kinds, &pages);
    samples(&|class, lightness, density| shipped.page_of_sample(class, lightness, density, 70.0));
    let mut dense = profile.clone();
    dense.set("textures.dense_from", "0").expect("a key of the profile");
    let dense = device(&dense);
    let dense = |scene: &Scene| dense.pages_of(scene);
    follows_lines(shipped.params.dense_from, UNTUNED..UNTUNED + seeds, &pages, &dense);
}

/// The pages of a scene, each with what is on it.
type Pages<'a> = dyn Fn(&Scene) -> Vec<(Scene, Page)> + 'a;

fn page_of(picture: &[u8], plan: &Plan, watch: &mut Watch<'_>) -> Page {
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request {
        plan,
        limits: Default::default(),
        fonts: &fonts,
        title: "scene",
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    tactograph::internals::pipeline::convert(picture, &request, watch).expect("a scene can be converted").page
}

fn verdict(holds: bool) -> &'static str {
    if holds { "holds" } else { "MISSED" }
}

fn readability(name: &str, seeds: std::ops::Range<u64>, kinds: bool, pages_of: &Pages<'_>) {
    println!("Read right, {name} ({} to {})", seeds.start, seeds.end - 1);
    let mut sums = [Tally::default(); 3];
    for (kind, kind_name) in KINDS.iter().enumerate() {
        let mut tallies = [Tally::default(); 3];
        for seed in seeds.clone() {
            for (scene, page) in pages_of(&scenes::scene(kind, seed, FINE_PX)) {
                let ink = Ink::of(&svg::write(&page)).expect("the page is a page");
                for (tally, finger) in tallies.iter_mut().zip(FINGERS) {
                    tally.add(&judge::judge(&scene, &page, &ink.felt(finger).expect("there is such a finger")));
                }
            }
        }
        for (sum, tally) in sums.iter_mut().zip(&tallies) {
            sum.add(tally);
        }
        if kinds {
            let rights = tallies.map(|tally| format!("{:.4}", tally.share(judge::CLASSES).1)).join(" ");
            let greys = tallies.map(|tally| format!("{:.4}", tally.share(judge::only(Some(Class::Grey))).1)).join(" ");
            println!("  {kind_name:<8} all {rights}   grey {greys}");
        }
    }
    let (grey, white) = (judge::only(Some(Class::Grey)), judge::only(None));
    for (what, classes, wanted) in
        [("areas", judge::CLASSES, WANTED[0]), ("grey", grey, WANTED[1]), ("white", white, WANTED[2])]
    {
        let shares = sums.map(|sum| sum.share(classes.clone()));
        let holds = shares.iter().zip(wanted).all(|((_, share), wanted)| *share >= wanted);
        let told = shares.map(|(_, share)| format!("{share:.4}")).join(" ");
        let wanted = wanted.map(|wanted| format!("{wanted}")).join(" ");
        println!("  {what:<6} {told}   wanted {wanted}   {}   {} places", verdict(holds), shares[0].0);
    }
}

/// `page_of` makes the page of a class at a lightness and a density, and says where its texture is.
fn samples(page_of: &dyn Fn(Class, f32, f32) -> (Page, MmRect)) {
    println!("Read right, one texture at every density (0, 0.15, 0.3, 1) and lightness 0.88, 0.5, 0.1");
    for class in Class::ALL {
        let mut least = [1.0_f32; 3];
        for (density, lightness) in [0.0, 0.15, 0.3, 1.0].into_iter().flat_map(|d| [0.88, 0.5, 0.1].map(|l| (d, l))) {
            let (page, place) = page_of(class, lightness, density);
            let ink = Ink::of(&svg::write(&page)).expect("the page is a page");
            for (least, finger) in least.iter_mut().zip(FINGERS) {
                let felt = ink.felt(finger).expect("there is such a finger");
                *least = least.min(judge::share_of_sample(class, &felt, place));
            }
        }
        let holds = least.iter().zip(WANTED[0]).all(|(share, wanted)| *share >= wanted);
        println!("  {:<6} least {}   {}", class.name(), least.map(|s| format!("{s:.4}")).join(" "), verdict(holds));
    }
}

/// How many glyphs there are where many lines are; `dense` makes the same pages with the densest texture all over.
fn follows_lines(full: f32, seeds: std::ops::Range<u64>, pages_of: &Pages<'_>, dense: &Pages<'_>) {
    let mut all = Vec::new();
    for kind in [1, 2, 3, 5] {
        for seed in seeds.clone() {
            let scene = scenes::scene(kind, seed, FINE_PX);
            for ((_, page), (_, full)) in pages_of(&scene).iter().zip(&dense(&scene)) {
                all.extend(Class::ALL.iter().flat_map(|&class| density::pairs(page, full, class)));
            }
        }
    }
    let full = full.max(f32::MIN_POSITIVE);
    let wanted: Vec<(f32, f32)> = all.iter().map(|(lines, glyphs)| ((lines / full).min(1.0), *glyphs)).collect();
    let (plain, cut) = (density::correlation(&all), density::correlation(&wanted));
    println!("Density of glyphs against the map of lines, {} places", all.len());
    println!(
        "  correlation {cut:.4} with the map up to dense_from, {plain:.4} with all of it   wanted 0.95   {}",
        verdict(cut > 0.95)
    );
}

fn follows_lightness(params: &textures::Params) {
    println!("Boldness over 256 lightnesses");
    for class in Class::ALL {
        for density in [0.0, 1.0] {
            let boldness::Boldness { rank, jump, monotone } = boldness::measure(class, density, params);
            let holds = rank > 0.98 && jump < 0.08 && monotone;
            println!(
                "  {:<6} density {density}: rank correlation {rank:.4}, largest jump {:.1} % of full ink, never falls: {monotone}   {}",
                class.name(),
                100.0 * jump,
                verdict(holds)
            );
        }
    }
}

fn distances(plan: &Plan) {
    let mut pages = 0;
    let mut faults = Vec::new();
    let mut look = |page: &Page| {
        pages += 1;
        faults.extend(gaps::faults(page, &plan.textures()));
    };
    for kind in 0..KINDS.len() {
        for seed in 0..200_u64.div_ceil(KINDS.len() as u64) {
            look(&page_of(&scenes::scene(kind, UNTUNED + seed, QUICK_PX).picture, plan, &mut |_| ()));
        }
    }
    let samples = std::path::Path::new(tactograph_tools::ROOT).join("samples");
    for entry in std::fs::read_dir(samples).expect("there are samples").flatten() {
        if entry.path().extension().is_some_and(|ending| ending != "md") {
            look(&page_of(&std::fs::read(entry.path()).expect("a sample can be read"), plan, &mut |_| ()));
        }
    }
    println!("Gaps and minima: {} violations on {pages} pages   {}", faults.len(), verdict(faults.is_empty()));
    faults.iter().take(5).for_each(|fault| println!("  {fault}"));
}

fn time(plan: &Plan) {
    let mut profile = plan.profile().clone();
    profile.set("overview", "false").expect("a key of the profile");
    let plan = Plan::new(&profile).expect("the values make sense");
    // as high as the sheet, so that the figure takes all of it
    let scene = scenes::scene(2, 3, FINE_PX);
    let head = format!("P6 {0} {0} 255\n", scene.side).len();
    let pixels = &scene.picture[head..];
    let mut picture = format!("P6 {} {} 255\n", scene.side, scene.side * 3 / 2).into_bytes();
    picture.extend(pixels.iter().chain(&pixels[..pixels.len() / 2]));
    let mut least = Duration::MAX;
    let mut glyphs = 0;
    for _ in 0..20 {
        let mut start = Instant::now();
        let page = page_of(&picture, &plan, &mut |event| match event {
            Event::Begin(Stage::Textures) => start = Instant::now(),
            Event::End(Stage::Textures) => least = least.min(start.elapsed()),
            _ => (),
        });
        glyphs = page.figure.textures.iter().map(|texture| texture.glyphs.len()).sum();
    }
    let ms = least.as_secs_f64() * 1e3;
    println!("Texture stage of a full A4 figure ({glyphs} glyphs): {ms:.2} ms   wanted 10   {}", verdict(ms < 10.0));
}
