//! The sheet: on every profile and sample nothing leaves the margins, touches its neighbour or falls below what the
//! profile promises, and changing one number does to the page what a person would expect.

use crate::common::page::{of_sample, page_for};
use crate::common::{apart, samples};
use tactograph::internals::geom::nearby::Nearby;
use tactograph::internals::geom::nearest_on_segment;
use tactograph::internals::page::{Class, Dots, Page, Run, Shape, Texture};
use tactograph::internals::pipeline::Drawing;
use tactograph::internals::profile::{BuiltIn, Profile, built_in};
use tactograph::internals::units::{MmPoint, MmRect, MmVector};
use tactograph::{Note, Options};

/// Numbers are kept in f32; this is more than adding up a few of them loses.
const ROUNDING: f32 = 1e-3;
/// The largest share of the figure's size that the overview of a drawing has.
const LARGEST_OVERVIEW: f32 = 0.7;
/// A line may be this much shorter than the least length: simplifying it takes away a little.
const SHORTENED: f32 = 0.97;

fn profile(name: &str, settings: &[(&str, &str)]) -> Profile {
    let mut profile = Profile::named(name).expect("built in");
    settings.iter().for_each(|(key, value)| profile.set(key, value).expect("the test sets what there is"));
    profile
}

/// The page of a sample with the default profile and one or more numbers changed.
fn changed(name: &str, settings: &[(&str, &str)]) -> Page {
    page_for(&samples::read(name), name, &profile("swell-a4", settings), &mut |_| ()).page
}

/// The overview of a photograph is half as wide as the figure, that of a square one too, unless the figure is asked for
/// as wide as it can be.
#[test]
fn the_overview_of_a_photograph_has_its_share_of_the_sheet() {
    let share = |page: &Page| {
        let overview = page.overview.as_ref().expect("there is one");
        (overview.place.width() / page.figure.place.width(), page.figure.place.width())
    };
    for name in ["astronaut.png", "coffee.png"] {
        let (of_width, _) = share(&changed(name, &[]));
        assert!((of_width - 0.5).abs() < 1e-4, "{name}: {of_width}");
    }
    let (asked, widest) = share(&changed("astronaut.png", &[("lines.regions", "false")]));
    assert!((asked - 0.4).abs() < 1e-4, "contours alone: {asked}");
    let options = Options::new(tactograph::Profile::named("swell-a4").expect("built in")).width_mm(widest);
    let page = tactograph::convert(&samples::read("astronaut.png"), &options).expect("as wide as it can be").page;
    let (of_width, width) = share(&page);
    assert!(width >= widest - 0.01 && of_width < 0.45, "{width} {of_width}");
}

#[test]
fn pages_of_every_profile_keep_what_it_promises() {
    // pages of dots: tests/dotted.rs
    let printed = |file: &&BuiltIn| profile(file.name, &[]).dots.device.is_none();
    for file in built_in().iter().filter(printed) {
        for name in samples::names() {
            holds(of_sample(&name, file.name), &name, &profile(file.name, &[]));
        }
    }
}

#[test]
fn pages_of_every_make_up_keep_what_the_profile_promises() {
    for settings in [
        &[("page.orientation", "landscape")][..],
        &[("page.orientation", "portrait"), ("frame", "false")],
        &[("overview", "false")],
        &[("mark", "false"), ("page.margin", "25")],
        &[("frame", "false"), ("overview", "false"), ("page.width", "120")],
        &[("print.swell", "0.25"), ("frame.dot", "1"), ("lines.width_min", "1")],
        &[("mark.length", "40"), ("mark.gap", "10"), ("frame.width", "6"), ("frame.gap", "2")],
        &[("lines.min_gap", "6"), ("lines.min_length", "15"), ("lines.width_max", "2.5")],
    ] {
        for name in ["coffee.png", "portrait.svg"] {
            let profile = profile("swell-a4", settings);
            holds(&page_for(&samples::read(name), name, &profile, &mut |_| ()), name, &profile);
        }
    }
}

/// Checks a page against the numbers of its profile.
fn holds(made: &Drawing, name: &str, profile: &Profile) {
    let (page, swell) = (&made.page, profile.print.swell);
    let name = format!("{name} with {}", profile.name);
    let margin = profile.page.margin - 0.5 * swell;
    let [width, height] = page.sheet;
    let inner = MmRect::new(MmPoint::new(0.0, 0.0), MmPoint::new(width, height)).inflate(-margin, -margin);
    let smaller_and_larger = |a: f32, b: f32| MmVector::new(a.min(b), a.max(b));
    let asked = smaller_and_larger(profile.page.width, profile.page.height);
    assert!((smaller_and_larger(width, height) - asked).length() < 1e-3, "{name}: the size of the sheet");

    // Frames lie around their pictures, as far away as the profile says, within the margins.
    let frames: Vec<_> = [(&page.frame, page.figure.place)]
        .into_iter()
        .chain(page.overview.iter().map(|overview| (&overview.frame, overview.place)))
        .collect();
    for (dots, place) in &frames {
        assert_eq!(!dots.at.is_empty(), profile.frame.on, "{name}: a frame");
        assert!(inner.inflate(ROUNDING, ROUNDING).contains_box(place), "{name}: a picture leaves the margins");
        let Some(around) = extent(dots) else { continue };
        assert!(inner.inflate(ROUNDING, ROUNDING).contains_box(&around), "{name}: a frame leaves the margins");
        assert!((dots.diameter + swell - profile.frame.dot).abs() < ROUNDING, "{name}: dots of {}", dots.diameter);
        let nearest = dots.at.iter().map(|&at| outside(at, *place)).fold(f32::MAX, f32::min);
        let blank = nearest - 0.5 * (dots.diameter + swell);
        assert!((blank - profile.frame.gap).abs() < ROUNDING, "{name}: {blank} mm from the picture to its frame");
        let band = around.width() - place.width() - 2.0 * blank + swell;
        assert!(band <= 2.0 * profile.frame.width + ROUNDING, "{name}: a band of {band} mm on both sides");
    }
    if let Some(overview) = &page.overview {
        let border = if profile.frame.on { 2.0 * (profile.frame.gap + profile.frame.width) } else { 0.0 };
        let blank = overview.place.min.y - page.figure.place.max.y - border;
        assert!((blank - profile.overview.gap).abs() < ROUNDING, "{name}: {blank} mm to the overview");
        let scale = overview.place.width() / page.figure.place.width();
        // that of a drawing may need more room, and that of a photograph takes some where there is any
        let most = if apart::is_drawing(&name) {
            profile.overview.scale.max(LARGEST_OVERVIEW)
        } else {
            1.25 * profile.overview.scale
        };
        let fits = (profile.overview.scale - ROUNDING..=most + ROUNDING).contains(&scale);
        assert!(fits, "{name}: an overview of {scale}");
    }

    // The orientation mark lies at the top right, within the margins and clear of everything.
    assert_eq!(page.orientation_mark.is_some(), profile.mark.on, "{name}: a mark");
    if let Some(mark) = &page.orientation_mark {
        assert!((mark.width + swell - profile.mark.width).abs() < ROUNDING, "{name}: a mark {} mm wide", mark.width);
        let (a, b) = (mark.points[0], mark.points[1]);
        let length = (b - a).length() + mark.width + swell;
        assert!((length - profile.mark.length).abs() < ROUNDING, "{name}: a mark of {length} mm");
        let inset = 0.5 * mark.width - ROUNDING;
        assert!(inner.inflate(-inset, -inset).contains_inclusive(a) && b.y > a.y && b.x > a.x, "{name}: {mark:?}");
        assert!(a.x > 0.5 * width, "{name}: the mark is not at the right");
        let place = frames[0].1;
        let near = extent(&page.frame).unwrap_or(place);
        let corner = MmPoint::new(near.max.x, near.min.y);
        let blank = nearest_on_segment(corner, a, b).0 - 0.5 * mark.width - swell;
        assert!(blank >= profile.mark.gap - ROUNDING, "{name}: {blank} mm from the mark to the frame");
    }

    // Lines and glyphs lie in their picture and are as large and as far apart as promised.
    let lines = &profile.lines;
    let overview = page.overview.iter().map(|overview| (overview.place, &overview.lines));
    for (place, drawn) in [(page.figure.place, &page.figure.lines)].into_iter().chain(overview) {
        for (number, line) in drawn.iter().enumerate() {
            let is_whole = line.length() >= SHORTENED * lines.min_length
                || lines.min_length <= 2.0 * line.length() && apart::leads_from_line_to_line(drawn, number);
            assert!(is_whole, "{name}: a line of {} mm", line.length());
            for run in &line.runs {
                let width = run.width + swell;
                // a point on a line is three times as broad as the broadest line
                let most = if run.length() < 0.2 { 3.0 * lines.width_max } else { lines.width_max };
                let range = lines.width_min - ROUNDING..=most + ROUNDING;
                assert!(range.contains(&width), "{name}: a line {width} mm wide");
                let inside = run.points.iter().all(|at| place.inflate(0.05, 0.05).contains_inclusive(*at));
                assert!(inside, "{name}: a line leaves its picture");
            }
        }
        let risen: Vec<_> = drawn
            .iter()
            .map(|line| {
                let mut line = line.clone();
                line.runs.iter_mut().for_each(|run| run.width += swell);
                line
            })
            .collect();
        let near = apart::too_near(&risen, lines.min_gap, apart::approach_of(&name));
        let length: f32 = near.iter().map(|place| place.length).sum();
        let all: f32 = drawn.iter().map(|line| line.length()).sum();
        assert!(length <= 0.001 * all, "{name}: {length} of {all} mm are too near: {:?}", near.first());
    }
    glyphs_hold(page, profile, &name);

    let share = page.black_share();
    assert!(share <= 0.4, "{name}: {share} of the figure is black");
    let told = made.notes.iter().any(|note| matches!(note, Note::TooBlack { .. }));
    assert_eq!(told, share > profile.print.max_black, "{name}: {:?}", made.notes);
}

fn glyphs_hold(page: &Page, profile: &Profile, name: &str) {
    let (textures, swell, place) = (&profile.textures, profile.print.swell, page.figure.place);
    let mut nearby = Nearby::new(place, textures.line_gap + textures.length);
    for (number, run) in (0..).zip(page.figure.lines.iter().flat_map(|line| &line.runs)) {
        nearby.insert_line(number, run.polyline(), 0.5 * (run.width + swell));
    }
    let reach = textures.line_gap + 0.5 * (profile.lines.width_max + textures.length);
    for Texture { glyphs, class, .. } in &page.figure.textures {
        for glyph in glyphs {
            let corners = glyph.corners();
            assert!(
                corners.iter().all(|corner| place.contains_inclusive(*corner)),
                "{name}: {glyph:?} leaves the figure"
            );
            let (least, most, thickness) = match glyph.shape {
                Shape::Dot { diameter } => (textures.min_glyph, textures.dot, diameter + swell),
                Shape::Rhombus { length, thickness, .. } => {
                    assert!(length <= textures.length + ROUNDING, "{name}: {glyph:?}");
                    // what swells evenly on all sides gains more from tip to tip
                    let radius = 0.5 * length * thickness / length.hypot(thickness);
                    (textures.min_glyph, textures.thickness, thickness * (1.0 + 0.5 * swell / radius))
                }
            };
            let fits = (least - ROUNDING..=most + ROUNDING).contains(&thickness);
            assert!(fits, "{name}: {thickness} mm, {glyph:?} of {}", class.name());
            let on_glyph = corners.into_iter().chain([glyph.at]);
            for at in on_glyph {
                nearby.around(at, at, reach, |segment| {
                    let gap = nearest_on_segment(at, segment.a, segment.b).0 - segment.half_width;
                    let least = if at == glyph.at { textures.line_gap + 0.5 * thickness } else { textures.line_gap };
                    let slack = if matches!(glyph.shape, Shape::Dot { .. }) || at != glyph.at {
                        ROUNDING
                    } else {
                        0.5 * thickness
                    };
                    assert!(gap >= least - slack, "{name}: {glyph:?} is {gap} mm from a line");
                });
            }
        }
    }
}

fn extent(dots: &Dots) -> Option<MmRect> {
    let radius = 0.5 * dots.diameter;
    (!dots.at.is_empty()).then(|| MmRect::from_points(&dots.at).inflate(radius, radius))
}

/// How far a place lies outside a rectangle.
fn outside(at: MmPoint, rect: MmRect) -> f32 {
    let x = (rect.min.x - at.x).max(at.x - rect.max.x);
    let y = (rect.min.y - at.y).max(at.y - rect.max.y);
    if x > 0.0 && y > 0.0 { x.hypot(y) } else { x.max(y) }
}

fn runs(page: &Page) -> Vec<&Run> {
    page.figure.lines.iter().flat_map(|line| &line.runs).collect()
}

fn glyph_count(page: &Page, class: Class) -> f32 {
    page.figure
        .textures
        .iter()
        .filter(|texture| texture.class == class)
        .map(|texture| texture.glyphs.len())
        .sum::<usize>() as f32
}

#[test]
fn sizes_of_sheet_and_parts_move_what_they_name() {
    let upright = ("page.orientation", "portrait");
    let plain = changed("coffee.png", &[upright]);
    let (width, border) = (plain.figure.place.width(), 8.0);
    assert!((width - (210.0 - 20.0 - 2.0 * border)).abs() < ROUNDING, "the sheet less margins and frame: {width}");
    let figure = |settings: &[(&str, &str)]| changed("coffee.png", &[&[upright], settings].concat()).figure.place;
    for (key, value, grows) in [
        ("page.width", "230", 20.0),
        ("page.margin", "15", -10.0),
        ("frame.gap", "8", -6.0),
        ("frame.width", "4", -2.0),
        ("frame", "false", 2.0 * border),
        ("mark", "false", 0.0),
        ("overview.gap", "20", 0.0),
    ] {
        let place = figure(&[(key, value)]);
        assert!((place.width() - width - grows).abs() < ROUNDING, "{key} = {value}: {} mm wide", place.width());
        assert!((place.center().x - if key == "page.width" { 115.0 } else { 105.0 }).abs() < ROUNDING, "{key}");
        let shape = place.width() / place.height() / (width / plain.figure.place.height());
        assert!((shape - 1.0).abs() < ROUNDING, "{key} = {value} changes the picture's shape");
    }
    // without the mark the figure begins at the top margin, with it further down
    assert!((figure(&[("mark", "false")]).min.y - 18.0).abs() < ROUNDING && plain.figure.place.min.y > 25.0);
    let overview = |page: &Page| page.overview.as_ref().expect("an overview").place;
    let (half, whole) = (overview(&changed("coffee.png", &[upright, ("overview.scale", "0.2")])), overview(&plain));
    assert!(
        (2.0 * half.width() - whole.width()).abs() < ROUNDING
            && (2.0 * half.height() - whole.height()).abs() < ROUNDING
    );
}

#[test]
fn widths_pitches_and_gaps_do_what_they_say() {
    let plain = changed("landscape.svg", &[]);
    let widest = |page: &Page| runs(page).iter().map(|run| run.width).fold(0.0, f32::max);
    let thinnest = |page: &Page| runs(page).iter().map(|run| run.width).fold(f32::MAX, f32::min);
    let wide = changed("landscape.svg", &[("lines.width_max", "2.2"), ("lines.width_min", "1.1")]);
    assert!((widest(&plain) - 1.5).abs() < ROUNDING && (widest(&wide) - 2.2).abs() < ROUNDING);
    assert!(thinnest(&plain) >= 0.75 - ROUNDING && thinnest(&wide) >= 1.1 - ROUNDING);

    let fine = changed("landscape.svg", &[("frame.pitch", "1.2"), ("frame.dot", "0.6")]);
    let dots = |page: &Page| page.frame.at.len() as f32;
    // by the pitch along the band and, where there is room for it, one more row
    assert!(dots(&fine) / dots(&plain) > 1.3 && (fine.frame.diameter - 0.6).abs() < ROUNDING);

    // Lattices half as dense again; glyphs on the borders of areas blur the numbers a little.
    let sparse = changed("landscape.svg", &[("textures.along", "4.2"), ("textures.dot_pitch", "4.5")]);
    for (class, ratio) in [(Class::Blue, 1.5), (Class::Green, 1.5)] {
        let found = glyph_count(&plain, class) / glyph_count(&sparse, class).max(1.0);
        assert!((found / ratio - 1.0).abs() < 0.2, "{}: {found} times fewer", class.name());
    }
    let long = changed("landscape.svg", &[("lines.min_length", "30")]);
    assert!(long.figure.lines.len() < plain.figure.lines.len());
    let lines = &long.figure.lines;
    let is_link = |number: usize| apart::leads_from_line_to_line(lines, number) && lines[number].length() >= 15.0;
    let is_long = |number: usize| lines[number].length() >= SHORTENED * 30.0;
    assert!((0..lines.len()).all(|number| is_long(number) || is_link(number)));
    assert_eq!(changed("landscape.svg", &[("print.max_black", "1")]).figure, plain.figure);
}

/// What swelling adds is taken from every mark before, and nothing moves.
#[test]
fn swelling_gives_back_the_width_that_was_asked_for() {
    let (plain, printed) = (changed("landscape.svg", &[]), changed("landscape.svg", &[("print.swell", "0.2")]));
    assert_eq!(runs(&plain).len(), runs(&printed).len());
    for (asked, drawn) in runs(&plain).iter().zip(runs(&printed)) {
        assert_eq!(asked.points, drawn.points);
        assert!((asked.width - drawn.width - 0.2).abs() < ROUNDING);
    }
    let bar = |page: &Page| page.orientation_mark.as_ref().map_or(0.0, |mark| mark.width);
    assert!((bar(&plain) - bar(&printed) - 0.2).abs() < ROUNDING);
    assert!((plain.frame.diameter - printed.frame.diameter - 0.2).abs() < ROUNDING);
    for (asked, drawn) in plain.figure.textures.iter().zip(&printed.figure.textures) {
        assert_eq!(asked.glyphs.len(), drawn.glyphs.len());
        for (asked, drawn) in asked.glyphs.iter().zip(&drawn.glyphs) {
            assert_eq!(asked.at, drawn.at);
            assert!(drawn.area() > 0.0 && drawn.area() < asked.area());
        }
    }
    let black = |page: &Page| page.black_share();
    assert!(black(&printed) < black(&plain));
}

#[test]
fn a_page_with_too_much_black_is_made_and_its_maker_told() {
    let profile = profile("swell-a4", &[("print.max_black", "0.01")]);
    let made = page_for(&samples::read("landscape.svg"), "landscape", &profile, &mut |_| ());
    let percent = (100.0 * made.page.black_share()).round() as u32;
    assert!(percent > 1);
    assert!(made.notes.contains(&Note::TooBlack { percent, most: 1 }), "{:?}", made.notes);
}

/// Left and right change places, also in what a texture says; twice is the page again.
#[test]
fn a_mirrored_page_is_the_page_seen_from_its_back() {
    let page = changed("landscape.svg", &[]);
    let mirrored = page.clone().mirrored();
    assert_eq!(runs(&mirrored).len(), runs(&page).len());
    for (front, back) in runs(&page).iter().zip(runs(&mirrored)) {
        let pairs = front.points.iter().zip(&back.points);
        let far = |(a, b): (&MmPoint, &MmPoint)| (page.sheet[0] - a.x - b.x).hypot(a.y - b.y) >= ROUNDING;
        assert!(front.points.len() == back.points.len() && !pairs.into_iter().any(far), "{front:?} {back:?}");
    }
    for (front, back) in page.frame.at.iter().zip(&mirrored.frame.at) {
        assert!((page.sheet[0] - front.x - back.x).abs() < ROUNDING, "{front:?} {back:?}");
    }
    for (front, back) in page.figure.textures.iter().zip(&mirrored.figure.textures) {
        assert_eq!(back.sign, front.sign.mirrored());
    }
    for (front, back) in page.figure.textures.iter().zip(&mirrored.figure.textures) {
        for (front, back) in front.glyphs.iter().zip(&back.glyphs) {
            let flipped = front.corners().map(|at| MmPoint::new(page.sheet[0] - at.x, at.y));
            let found =
                flipped.iter().all(|at| back.corners().iter().any(|corner| (*corner - *at).length() < ROUNDING));
            assert!(found, "{front:?} {back:?}");
        }
    }
    let mark = |page: &Page| page.orientation_mark.clone().expect("a mark");
    assert!(mark(&page).points[0].x > 150.0 && mark(&mirrored).points[0].x < 60.0);
    let twice = mirrored.mirrored();
    for (once, twice) in runs(&page).iter().zip(runs(&twice)) {
        assert!(once.points.iter().zip(&twice.points).all(|(a, b)| (*a - *b).length() < ROUNDING));
    }
}
