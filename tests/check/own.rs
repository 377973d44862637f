//! Every page that the program writes passes.

use crate::common::{page, samples};
use tactograph::internals::legibility::check;
use tactograph::internals::profile::{Plan, Profile, built_in};
use tactograph::marks::TextRole;
use tactograph::{Fonts, KeySheets, Label, Page, Position};
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
        // all of them have contours, so that none is refused
        let drawing = match tactograph::convert(picture, &options) {
            Ok(drawing) => drawing,
            Err(error) => {
                faults.push(format!("{name}: scene {seed} has no page: {error}"));
                continue;
            }
        };
        let pages = std::iter::once(&drawing.page).chain(&drawing.overview);
        faults.extend(pages.flat_map(|page| errors(page, &profile)).map(|error| format!("{name}: {error}")));
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
}

/// An area that is large enough on A3, and too small on A4.
#[test]
fn a_page_on_smaller_paper_passes_and_says_which_texture_it_lost() {
    let drawing = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 600'><rect x='20' y='20' width='760' \
                   height='560' fill='none' stroke='#000'/><rect x='100' y='100' width='55' height='55' \
                   fill='#d00'/></svg>";
    let [large, small] = ["swell-a3", "swell-a4"].map(|name| Profile::named(name).expect("it is built in"));
    let options = tactograph::Options::new(large).title("square");
    let page = tactograph::convert(drawing.as_bytes(), &options).expect("a page").page;
    assert_eq!(page.figure.textures.len(), 1, "on A3 it is large enough");
    let options = tactograph::RenderOptions::new().profile(small.clone());
    let rendered = tactograph::render(page.to_svg(), &options).expect("it has room");
    assert!(errors(&rendered.page, &small).is_empty() && rendered.page.figure.textures.is_empty());
    let told: Vec<String> = rendered.notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|note| note.contains("texture")), "{told:?}");
}

/// Drawings of school subjects, most cut down to the few lines that once made a page with errors: all in
/// `tests/check/drawings`.
#[test]
fn pages_of_drawings_pass() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/check/drawings");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("the folder").map(|file| file.expect("a file").path()).collect();
    files.sort();
    assert!(files.len() >= 22, "{} drawings", files.len());
    let mut faults = Vec::new();
    for name in ["swell-a4", "index-basic-d", "viewplus-columbia", "braillerap"] {
        let profile = Profile::named(name).expect("it is built in");
        for file in &files {
            let bytes = std::fs::read(file).expect("the drawing");
            let title = file.file_stem().expect("a name").to_string_lossy();
            let options = tactograph::Options::new(profile.clone()).title(title);
            let drawing = tactograph::convert(&bytes, &options).expect("a page");
            let pages = std::iter::once(&drawing.page).chain(&drawing.overview);
            faults.extend(pages.flat_map(|page| errors(page, &profile)).map(|error| format!("{name}: {error}")));
        }
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
}

/// With words: the texts of drawings as labels, labels on a photograph, a title, and a key, whose sheets are held
/// against the rules too.
#[test]
fn pages_with_words_pass_and_so_do_their_keys() {
    let fonts = Fonts::system();
    let at = |x, y, text: &str| {
        let [x, y] = [x, y].map(|share| Position::percent(share).expect("a number"));
        Label { x, y, text: text.to_owned() }
    };
    let of_photograph = vec![at(45.0, 40.0, "cup"), at(15.0, 75.0, "table"), at(85.0, 85.0, "wooden board")];
    let (mut faults, mut labels, mut keys) = (Vec::new(), 0, 0);
    for name in ["swell-a4", "index-basic-d", "viewplus-columbia", "dot-pad"] {
        let profile = Profile::named(name).expect("it is built in");
        for sample in ["chart.svg", "map.svg", "cell.svg", "coffee.png"] {
            let options = tactograph::Options::new(profile.clone()).title("A sample").fonts(fonts.clone());
            let options = options.label_texts(true).key(KeySheets::Always);
            let options = if sample == "coffee.png" { options.labels(of_photograph.clone()) } else { options };
            let drawing = tactograph::convert(&samples::read(sample), &options).expect("a page");
            labels += drawing.page.braille.iter().filter(|text| text.role == TextRole::Label).count();
            keys += drawing.key.len();
            let of_sample = drawing.all().flat_map(|page| errors(page, &profile));
            faults.extend(of_sample.map(|error| format!("{name}, {sample}: {error}")));
        }
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
    assert!(labels >= 60 && keys >= 12, "{labels} labels and {keys} sheets of keys");
}

/// Drawings that are far too full for their pages.
#[test]
fn pages_of_crowded_drawings_pass() {
    let mut faults = Vec::new();
    for seed in 0..DRAWINGS {
        let name = ["swell-a4", "braillerap"][seed as usize % 2];
        let profile = Profile::named(name).expect("it is built in");
        let svg = scenes::drawing(seed, 12 + 3 * (seed as usize % 10));
        let options = tactograph::Options::new(profile.clone()).title(format!("drawing {seed}"));
        let drawing = tactograph::convert(svg.as_bytes(), &options).expect("a page");
        let pages = std::iter::once(&drawing.page).chain(&drawing.overview);
        faults.extend(pages.flat_map(|page| errors(page, &profile)).map(|error| format!("{name}: {error}")));
    }
    assert!(faults.is_empty(), "{} errors:\n{}", faults.len(), faults.join("\n"));
}

/// Between the cells steps from dot to dot are wider: a line that leads over one to another line ends on that.
#[test]
fn short_lines_between_shapes_pass_on_braille_cells() {
    let drawing = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 300'><rect width='400' height='300' \
                   fill='#fff'/><ellipse cx='268' cy='53' rx='96' ry='27' fill='#b66c4f'/><g stroke='#000'><rect x='288' \
                   y='35' width='156' height='106' fill='#41109e'/><rect x='297' y='113' width='133' height='135' \
                   fill='#e4d123'/><rect x='226' y='29' width='151' height='61' fill='#56a76b'/></g></svg>";
    let profile = Profile::named("braille-cells").expect("it is built in");
    let drawing = tactograph::convert(drawing.as_bytes(), &tactograph::Options::new(profile.clone())).expect("a page");
    let pages: Vec<&Page> = std::iter::once(&drawing.page).chain(&drawing.overview).collect();
    let faults: Vec<String> = pages.iter().flat_map(|page| errors(page, &profile)).collect();
    assert!(faults.is_empty(), "{faults:?}");
    let length = |line: &tactograph::marks::Line| line.runs.iter().map(|run| run.points.len()).sum::<usize>();
    assert!(drawing.page.figure.lines.iter().any(|line| length(line) == 3), "one is so short");
}

/// How many of them: a few seconds' work. `tools/src/bin/checking.rs` looks at 200.
const SCENES: u64 = 40;
/// The same of drawings.
const DRAWINGS: u64 = 20;
