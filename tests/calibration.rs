//! The calibration sheet has what it says, with gaps that a finger can tell apart.

use tactograph::Error;
use tactograph::internals::braille::{CellSize, Code};
use tactograph::internals::calibration::sheets;
use tactograph::internals::output;
use tactograph::internals::page::Medium;
use tactograph::internals::page::cells::CellGrid;
use tactograph::internals::page::{Class, Glyph, Page, Shape};
use tactograph::internals::profile::{Plan, Profile, built_in};
use tactograph::internals::units::MmPoint;

fn plan(profile: &str, settings: &[(&str, &str)]) -> Plan {
    let mut profile = Profile::named(profile).expect("it is built in");
    for (key, value) in settings {
        profile.set(key, value).expect("the test sets what there is");
    }
    Plan::new(&profile).expect("the settings make sense together")
}

/// Everything on a page as discs: centre and radius. What is long is many discs.
fn discs(page: &Page) -> Vec<(MmPoint, f32)> {
    let mut discs: Vec<(MmPoint, f32)> = page.frame.at.iter().map(|&at| (at, 0.5 * page.frame.diameter)).collect();
    for run in page.figure.lines.iter().flat_map(|line| &line.runs) {
        let (from, to) = (run.points[0], run.points[run.points.len() - 1]);
        discs.extend((0..=50).map(|k| (from.lerp(to, k as f32 / 50.0), 0.5 * run.width)));
    }
    for glyph in glyphs(page) {
        match glyph.shape {
            Shape::Rhombus { .. } => discs.extend(glyph.corners().map(|corner| (corner, 0.0))),
            Shape::Dot { diameter } => discs.push((glyph.at, 0.5 * diameter)),
        }
    }
    discs
}

fn glyphs(page: &Page) -> impl Iterator<Item = &Glyph> {
    page.figure.textures.iter().flat_map(|texture| &texture.glyphs)
}

fn labels(page: &Page) -> Vec<(MmPoint, f32)> {
    page.labels.iter().flat_map(|dots| dots.at.iter().map(|&at| (at, 0.5 * dots.diameter))).collect()
}

#[test]
fn every_profile_has_its_sheets_within_their_margins() {
    for profile in built_in() {
        let plan = plan(profile.name, &[]);
        let pages = sheets(&plan).expect("the samples have room");
        let most = if plan.profile().dots.device.is_some() { 14 } else { 6 };
        assert!((1..=most).contains(&pages.len()), "{}: {} sheets", profile.name, pages.len());
        let margin = plan.profile().page.margin;
        for page in &pages {
            assert!(!page.labels.is_empty() && page.description.contains(profile.name), "{}", page.description);
            for (at, radius) in discs(page).into_iter().chain(labels(page)) {
                let (right, bottom) = (page.sheet[0] - margin, page.sheet[1] - margin);
                let inside = at.x - radius >= margin - 0.01 && at.x + radius <= right + 0.01;
                assert!(inside && at.y - radius >= margin - 0.01 && at.y + radius <= bottom + 0.01, "{at:?} off");
            }
        }
        assert!(pages == sheets(&plan).expect("the same"), "not the same sheets again");
    }
}

#[test]
fn labels_stand_clear_of_all_samples() {
    for page in sheets(&plan("swell-a4", &[])).expect("the samples have room") {
        let marks = discs(&page);
        for (dot, radius) in labels(&page) {
            let gaps = marks.iter().map(|(at, other)| (*at - dot).length() - radius - other);
            let least = gaps.fold(f32::MAX, f32::min);
            assert!(least >= 2.99, "a label at {dot:?} is {least} mm from a mark");
        }
    }
}

#[test]
fn lines_have_all_widths_and_pairs_all_gaps() {
    let page = &sheets(&plan("swell-a4", &[("lines.width_max", "1.6")])).expect("the samples have room")[0];
    let mut lines: Vec<_> = page.figure.lines.iter().map(|line| &line.runs[0]).collect();
    assert!(lines.iter().all(|run| run.points.len() == 2 && (run.points[0].x - run.points[1].x).abs() < 1e-4));
    let pairs = lines.split_off(12); // the eleven and the profile's own
    let widths: Vec<f32> = lines.iter().map(|run| run.width).collect();
    assert_eq!(widths, [0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.25, 1.5, 1.6, 2.0, 2.5, 3.0]);
    assert_eq!(pairs.len(), 16);
    for pair in pairs.windows(2).skip(1).step_by(2) {
        let apart = pair[1].points[0].x - pair[0].points[0].x - 1.6;
        assert!(apart > 8.5, "{apart} mm between two pairs: they are taken for one");
    }
    for (gap, pair) in (1..=8_u8).zip(pairs.chunks(2)) {
        let between = pair[1].points[0].x - pair[0].points[0].x - 0.5 * (pair[0].width + pair[1].width);
        assert!((between - f32::from(gap)).abs() < 0.001 && (pair[0].width - 1.6).abs() < 1e-6, "{between}, not {gap}");
    }
    assert!(page.description.contains(
        " a (lines.width_min, lines.width_max): lines 0.3, 0.4, 0.5, 0.6, 0.75, 1, 1.25, 1.5, 1.6, 2, 2.5, 3 mm wide."
    ));
}

#[test]
fn every_class_has_three_densities_of_five_boldnesses() {
    let pages = sheets(&plan("swell-a4", &[])).expect("the samples have room");
    for class in Class::ALL {
        let textures = pages.iter().flat_map(|page| &page.figure.textures).filter(|texture| texture.class == class);
        // Blue and grey have six samples more among the smallest glyphs, which come first.
        let samples: Vec<_> = textures.collect();
        let table = &samples[samples.len() - 15..];
        assert_eq!(samples.len(), if [Class::Blue, Class::Grey].contains(&class) { 21 } else { 15 }, "{class:?}");
        let counts: Vec<[usize; 5]> =
            table.chunks(5).map(|row| [0, 1, 2, 3, 4].map(|column| row[column].glyphs.len())).collect();
        for row in &counts {
            // Smaller glyphs find room nearer to the edge of the sample.
            assert!(row.is_sorted() && row[4] <= 2 * row[0], "{class:?}: boldness changes how many there are: {row:?}");
        }
        assert!(
            counts[0][0] > counts[1][0] && counts[1][0] > counts[2][0] && counts[2][0] >= 6,
            "{class:?}: {counts:?}"
        );
        let inks: Vec<Vec<f32>> =
            table.chunks(5).map(|row| row.iter().map(|texture| texture.glyphs[0].area()).collect()).collect();
        for row in inks {
            assert!(row.windows(2).all(|pair| pair[0] > pair[1]), "{class:?}: not ever lighter: {row:?}");
        }
    }
}

#[test]
fn smallest_glyphs_are_as_thin_as_told() {
    let pages = sheets(&plan("swell-a4", &[])).expect("the samples have room");
    let told = "0.3, 0.4, 0.5, 0.6, 0.8, 1 mm thick";
    let page = pages.iter().find(|page| page.description.contains(told)).expect("they are told of");
    let thickness = |class: Class| -> Vec<f32> {
        let of_class = page.figure.textures.iter().filter(|texture| texture.class == class).take(6);
        of_class
            .map(|texture| match texture.glyphs[0].shape {
                Shape::Rhombus { thickness, .. } => thickness,
                Shape::Dot { diameter } => diameter,
            })
            .collect()
    };
    for class in [Class::Blue, Class::Grey] {
        let found = thickness(class);
        assert_eq!(found.len(), 6, "{class:?}");
        assert!(
            found.iter().zip([0.3, 0.4, 0.5, 0.6, 0.8, 1.0]).all(|(a, b): (&f32, f32)| (a - b).abs() < 0.001),
            "{class:?}: {found:?}"
        );
    }
}

#[test]
fn a_sheet_too_small_for_a_sample_is_refused() {
    let settings = [("page.width", "100"), ("page.height", "150")];
    let error = sheets(&plan("swell-a4", &settings)).expect_err("a table of textures is wider");
    assert!(matches!(&error, Error::NoRoom { sheet, .. } if sheet == "100 x 150 mm"), "{error}");
}

#[test]
fn sheets_are_one_document_or_one_drawing_each() {
    let pages = sheets(&plan("swell-a4", &[])).expect("the samples have room");
    let pdf = String::from_utf8_lossy(&output::pdf::write("Calibration", &pages)).into_owned();
    assert!(pdf.contains(&format!("/Type/Pages/Count {}", pages.len())), "not one document of all sheets");
    for page in &pages {
        let svg = output::svg::write(page);
        let document = roxmltree::Document::parse(&svg).expect("XML");
        let labels =
            document.descendants().find(|node| node.attribute("id") == Some("labels")).expect("a layer of labels");
        let discs: usize =
            labels.children().filter_map(|path| path.attribute("d")).map(|d| d.matches('M').count()).sum();
        assert_eq!(discs, page.labels.iter().map(|dots| dots.at.len()).sum::<usize>());
    }
}

/// Every device with every pitch that it has.
fn device_plans() -> Vec<Plan> {
    let devices = built_in().iter().filter(|profile| plan(profile.name, &[]).profile().dots.device.is_some());
    devices
        .flat_map(|profile| match profile.name {
            name if name.starts_with("index") => vec![(name, "1.6"), (name, "2.0"), (name, "2.5")],
            "braillerap" => vec![("braillerap", "2.0"), ("braillerap", "2.5")],
            name => vec![(name, "")],
        })
        .map(|(name, pitch)| if pitch.is_empty() { plan(name, &[]) } else { plan(name, &[("dots.pitch", pitch)]) })
        .collect()
}

#[test]
fn sheets_of_dots_are_what_the_device_can_raise() {
    for plan in device_plans() {
        let (name, pages) = (&plan.profile().name, sheets(&plan).expect("the samples have room"));
        for &format in tactograph::DotFormat::ALL {
            let device = plan.profile().dots.device.expect("a device");
            if format.check(device).is_ok() {
                let files = tactograph::write_dots("c", &pages, format, tactograph::Embossing::default());
                assert!(files.is_ok(), "{name} as {}: {:?}", format.name(), files.err());
            }
        }
        for page in &pages {
            let Medium::Dots(medium) = &page.medium else { panic!("{name}: not of dots") };
            // no two dots are nearer than the pitch: labels, lines and textures keep clear of one another
            let mut all: Vec<MmPoint> = labels(page).into_iter().map(|(at, _)| at).collect();
            all.extend(page.figure.lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.points.iter().copied()));
            all.extend(glyphs(page).map(|glyph| glyph.at));
            all.sort_by(|a, b| a.x.total_cmp(&b.x));
            let least = if name == "braillerap" { 1.5 } else { 0.99 * medium.pitch };
            for (i, at) in all.iter().enumerate() {
                for other in all[i + 1..].iter().take_while(|other| other.x - at.x < least) {
                    assert!((*other - *at).length() >= least, "{name}: dots at {at:?} and {other:?}");
                }
            }
        }
    }
}

#[test]
fn every_row_names_its_key_and_every_sample_its_number() {
    let table = Code::of_language("en").and_then(Code::table).expect("a table");
    let of_paper = [
        "a lines.width_min lines.width_max",
        "b lines.min_gap",
        "c braille.cell",
        "d frame.pitch",
        "e textures.min_glyph",
    ];
    let of_dots = [
        "a dots.pitch",
        "b dots.line_gap",
        "c dots.heavy_from",
        "d frame.pitch",
        "e dots.texture_gap",
        "f textures.palette",
    ];
    for (plan, headings) in [
        (plan("swell-a4", &[]), &of_paper[..]),
        (plan("index-basic-d", &[]), &of_dots),
        (plan("braillerap", &[]), &of_dots),
    ] {
        let pages = sheets(&plan).expect("the samples have room");
        let told: String = pages.iter().map(|page| page.description.as_str()).collect();
        for heading in headings {
            let keys: Vec<&str> = heading.split(' ').skip(1).collect();
            assert!(told.contains(&format!(" {} ({}): ", &heading[..1], keys.join(", "))), "{heading}: {told}");
            // somewhere the letter and each key stand dot for dot; keys may be in lines of their own
            let first = format!("{} {}", &heading[..1], keys[0]);
            let stands = |words: &str| {
                pages.iter().any(|page| {
                    let cells = vec![table.translate(words).cells];
                    let grid = CellGrid::of(&page.medium, CellSize::MARBURG);
                    let shape = grid.dots(&cells, MmPoint::new(30.0, 30.0));
                    let dots: Vec<MmPoint> = labels(page).into_iter().map(|(at, _)| at).collect();
                    let is_at = |from: &MmPoint| {
                        shape
                            .iter()
                            .all(|at| dots.iter().any(|dot| (*dot - (*at + (*from - shape[0]))).length() < 0.05))
                    };
                    dots.iter().any(is_at)
                })
            };
            for words in [&[first.as_str()], &keys[1..]].concat() {
                assert!(stands(words), "{}: {words} stands nowhere in braille", plan.profile().name);
            }
        }
    }
}

#[test]
fn pairs_of_dots_are_as_far_apart_as_told() {
    for name in ["index-basic-d", "viewplus-columbia", "monarch", "braillerap"] {
        let plan = plan(name, &[]);
        let pages = sheets(&plan).expect("the samples have room");
        let pitch = plan.profile().dots.pitch;
        let columns = |run: &[MmPoint]| {
            let mut columns: Vec<f32> = run.iter().map(|at| at.x).collect();
            columns.sort_by(f32::total_cmp);
            columns.dedup_by(|a, b| (*a - *b).abs() < 0.01);
            columns
        };
        let runs = pages.iter().flat_map(|page| &page.figure.lines).flat_map(|line| &line.runs);
        let upright: Vec<Vec<f32>> =
            runs.map(|run| columns(&run.points)).filter(|columns| columns.len() == 2).collect();
        let gaps: Vec<i32> = upright.iter().map(|pair| ((pair[1] - pair[0]) / pitch).round() as i32 - 1).collect();
        let heavy = if plan.profile().dots.device.is_some_and(|device| device.has_heights()) { &[][..] } else { &[0] };
        assert_eq!(gaps, [&[1, 2, 3, 4, 5], heavy].concat(), "{name}");
    }
}

/// Least distance of two dots of a texture, mm.
fn pitch_of(glyphs: &[Glyph]) -> f32 {
    let pairs = glyphs.iter().enumerate().flat_map(|(i, one)| glyphs[..i].iter().map(move |other| (one.at, other.at)));
    pairs.map(|(a, b)| (a - b).length()).fold(f32::MAX, f32::min)
}

#[test]
fn textures_come_at_every_pitch_where_dots_can_be_anywhere() {
    let pages = sheets(&plan("braillerap", &[])).expect("the samples have room");
    let told: String = pages.iter().map(|page| page.description.as_str()).collect();
    let textures = || pages.iter().flat_map(|page| &page.figure.textures);
    let has = |pitch: f32| textures().any(|texture| (pitch_of(&texture.glyphs) - pitch).abs() < 0.01);
    for pitch in [1.6, 2.0, 2.4, 3.0] {
        assert!(told.contains(&format!(", of dots {pitch} mm apart")) && has(pitch), "{pitch}: {told}");
    }
    // its own is in the rows of all textures
    assert!(!told.contains(", of dots 2.5 mm apart") && has(2.5), "{told}");
    let index = sheets(&plan("index-basic-d", &[])).expect("the samples have room");
    let told: String = index.iter().map(|page| page.description.as_str()).collect();
    assert_eq!(told.matches("dense textures of").count(), 1, "a grid has one pitch: {told}");
}
