//! Drawings as bitmaps that lost something: their pages have the lines of those that did not.

use tactograph::internals::geom::nearest_on_segment;
use tactograph::{Note, Options, Page, Profile};
use tactograph_tools::bitmap::{self, Capture, Light};
use tactograph_tools::drawn::{Point, shares};

/// A map in pale colours with thin grey borders: colours that are as light as one another, so that only chroma differs.
const MAP: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>
<g stroke="#777" stroke-width="2"><path d="M60 80L400 60L420 300L80 320Z" fill="#f0c8c8"/>
<path d="M400 60L840 90L800 290L420 300Z" fill="#bfe0bf"/><path d="M80 320L420 300L450 540L70 530Z" fill="#c8d2f4"/>
<path d="M420 300L800 290L830 520L450 540Z" fill="#e6dcae"/></g></svg>"##;

fn page(picture: &[u8]) -> Page {
    let profile = Profile::named("swell-a4").expect("it is built in");
    tactograph::convert(picture, &Options::new(profile)).expect("a page").page
}

fn lines(page: &Page) -> Vec<Vec<Point>> {
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
    let path = |at: &tactograph::MmPoint| [f64::from(at.x), f64::from(at.y)];
    runs.map(|run| run.points.iter().chain(run.points.first().filter(|_| run.closed)).map(path).collect()).collect()
}

/// Shapes in black outlines, as on worksheets.
const WORKSHEET: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>
<g fill="none" stroke="#222" stroke-width="4"><circle cx="150" cy="150" r="80"/><path d="M420 70L330 230L510 225Z"/>
<path d="M620 80L800 86L796 220L616 214Z"/><circle cx="700" cy="430" r="90"/><path d="M60 340L560 350L540 520L90 540Z"/></g></svg>"##;

#[test]
fn a_noisy_scan_of_a_drawing_has_the_lines_of_the_drawing() {
    let whole = lines(&page(&bitmap::png(WORKSHEET, 1000).expect("a PNG")));
    for seed in [1, 2] {
        let drawn = lines(&page(&bitmap::scan(WORKSHEET, 1000, seed).expect("a JPEG")));
        let shares = shares(&whole, &drawn);
        assert!(shares.drawn > 0.98 && shares.beside < 0.01, "seed {seed}: {shares:?}");
    }
}

/// In noise a faint stroke comes apart where it is looked for at the scale of letters; its pieces are none.
#[test]
fn a_faint_ring_in_noise_is_whole_and_no_text() {
    const RINGS: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>
<g fill="none" stroke-width="6"><circle cx="450" cy="300" r="280" stroke="#222"/><circle cx="450" cy="300" r="195" stroke="#ebebeb"/>
<circle cx="450" cy="300" r="110" stroke="#222"/></g></svg>"##;
    let whole = lines(&page(&bitmap::png(RINGS, 1200).expect("a PNG")));
    for seed in [0, 1] {
        let scan = bitmap::scan(RINGS, 1200, seed).expect("a JPEG");
        let options = Options::new(Profile::named("swell-a4").expect("it is built in"));
        let drawing = tactograph::convert(&scan, &options).expect("a page");
        assert!(drawing.texts.is_empty(), "seed {seed}: {:?}", drawing.notes);
        let shares = shares(&whole, &lines(&drawing.page));
        assert!(shares.drawn > 0.99 && shares.beside < 0.01, "seed {seed}: {shares:?}");
    }
}

#[test]
fn a_drawing_as_jpeg_has_the_lines_of_the_same_as_png() {
    let whole = lines(&page(&bitmap::png(MAP, 1200).expect("a PNG")));
    let length = |lines: &[Vec<Point>]| -> f64 {
        let segments = lines.iter().flat_map(|line| line.windows(2));
        segments.map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum()
    };
    for quality in [90, 80, 60] {
        let drawn = lines(&page(&bitmap::jpeg(MAP, 1200, quality).expect("a JPEG")));
        let shares = shares(&whole, &drawn);
        assert!(shares.drawn > 0.99 && shares.beside < 0.01, "quality {quality}: {shares:?}");
        let ratio = length(&drawn) / length(&whole);
        assert!((0.97..1.03).contains(&ratio), "quality {quality}: {ratio} of the length");
    }
}

/// A grey and a light yellow area beside outlines.
const AREAS: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>
<g stroke="#222" stroke-width="3"><circle cx="200" cy="180" r="120" fill="none"/><path d="M60 380H380V560H60Z" fill="#aaa"/>
<path d="M450 60H850V330H450Z" fill="#fff2b0"/><path d="M500 400L830 420L700 560Z" fill="none"/></g></svg>"##;

/// The page of a photograph, with its ground as it is or taken for paper, and whether that is told.
fn photographed(svg: &str, capture: &Capture, keep_ground: bool) -> (Page, bool) {
    let profile = Profile::named("swell-a4").expect("it is built in");
    let picture = bitmap::captured(svg, capture).expect("a JPEG");
    let options = Options::new(profile).keep_ground(keep_ground);
    let drawing = tactograph::convert(picture.as_slice(), &options).expect("a page");
    let told = drawing.notes.iter().any(|note| matches!(note, Note::GroundAsPaper { .. }));
    (drawing.page, told)
}

/// How many signs of textures lie in a part of the figure, given in units of 900 x 600.
fn signs(page: &Page, [left, top, right, bottom]: [f32; 4]) -> usize {
    let place = page.figure.place;
    let scale = place.width() / 900.0;
    let is_in = |at: tactograph::MmPoint| {
        let [x, y] = [(at.x - place.min.x) / scale, (at.y - place.min.y) / scale];
        (left..right).contains(&x) && (top..bottom).contains(&y)
    };
    page.figure.textures.iter().flat_map(|texture| &texture.glyphs).filter(|glyph| is_in(glyph.at)).count()
}

const PHOTOGRAPH: Capture =
    Capture { light: Light::Across(0.5), paper: [255; 3], cast: 0.0, noise: 3.0, quality: 80, side: 1400, seed: 5 };

#[test]
fn paper_in_uneven_light_is_blank_and_areas_keep_their_textures() {
    for (name, capture) in [
        ("across", PHOTOGRAPH),
        ("around", Capture { light: Light::Around(0.5), ..PHOTOGRAPH }),
        ("a shadow", Capture { light: Light::Shadow(0.6, 0.2), ..PHOTOGRAPH }),
        ("cream", Capture { paper: [0xf4, 0xea, 0xd2], ..PHOTOGRAPH }),
        ("even grey", Capture { light: Light::Even, paper: [0xd0, 0xce, 0xc8], ..PHOTOGRAPH }),
    ] {
        let whole = lines(&page(&bitmap::png(AREAS, 1400).expect("a PNG")));
        let (page, told) = photographed(AREAS, &capture, false);
        assert!(told, "{name}: not told");
        let areas = [[80.0, 400.0, 360.0, 540.0], [470.0, 80.0, 830.0, 310.0]];
        let all = signs(&page, [0.0, 0.0, 900.0, 600.0]);
        let [grey, yellow] = areas.map(|area| signs(&page, area));
        assert!(grey > 20 && yellow > 20, "{name}: {grey}, {yellow}");
        let in_areas = signs(&page, [60.0, 380.0, 380.0, 560.0]) + signs(&page, [450.0, 60.0, 850.0, 330.0]);
        assert_eq!(all, in_areas, "{name}: signs on blank paper");
        let shares = shares(&whole, &lines(&page));
        assert!(shares.drawn > 0.95 && shares.beside < 0.01, "{name}: {shares:?}");
        let (kept, told) = photographed(AREAS, &capture, true);
        assert!(!told && signs(&kept, [0.0, 0.0, 900.0, 600.0]) > all, "{name}: the ground was to be kept");
    }
}

#[test]
fn clean_drawings_and_meant_grounds_are_not_taken_for_paper() {
    let even = Capture { light: Light::Even, noise: 2.0, ..PHOTOGRAPH };
    assert!(!photographed(AREAS, &even, false).1, "white paper");
    let poster = AREAS.replace("fill=\"#fff\"", "fill=\"#9ec9e8\"");
    let (page, told) = photographed(&poster, &PHOTOGRAPH, false);
    assert!(!told && signs(&page, [520.0, 340.0, 800.0, 400.0]) > 10, "a blue ground");
    let grey = AREAS.replace("fill=\"#fff\"", "fill=\"#ccc\"");
    for picture in [bitmap::png(&grey, 1200).expect("a PNG"), bitmap::jpeg(&grey, 1200, 80).expect("a JPEG")] {
        let profile = Profile::named("swell-a4").expect("it is built in");
        let drawing = tactograph::convert(picture.as_slice(), &Options::new(profile)).expect("a page");
        assert!(!drawing.notes.iter().any(|note| matches!(note, Note::GroundAsPaper { .. })), "a painted ground");
    }
}

#[test]
fn strokes_of_any_thickness_in_a_picture_of_lines_are_one_line() {
    // 1 to 12 mm on the page, with a gap narrower than the strokes beside it, and a branch on a thick one
    let px_per_mm = 900.0 / 174.0;
    let at = [40.0, 110.0, 180.0, 250.0, 340.0, 440.0];
    let strokes = at.iter().zip([1.0, 2.0, 4.0, 6.0, 8.0, 12.0]);
    let strokes: String =
        strokes.map(|(y, mm)| format!("<path d='M60 {y}H840' stroke-width='{}'/>", mm * px_per_mm)).collect();
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'><rect width='900' height='600' fill='#fff'/>\
         <g fill='none' stroke='#000' stroke-linecap='round'>{strokes}<path d='M450 440V580' stroke-width='8'/></g></svg>"
    );
    let picture = bitmap::png(&svg, 900).expect("a picture");
    let profile = Profile::named("swell-a4").expect("it is built in");
    let options = Options::new(profile).lines(&picture).expect("a picture of lines");
    let page = tactograph::convert(WORKSHEET.as_bytes(), &options).expect("a page").page;
    let lines = &page.figure.lines;
    assert_eq!(lines.len(), at.len() + 1, "{lines:?}");
    assert!(lines.iter().all(|line| line.runs.iter().all(|run| !run.closed)), "{lines:?}");
    for y in at {
        let wanted = page.figure.place.min.y + y / px_per_mm;
        let lies = |at: &tactograph::MmPoint| (at.y - wanted).abs() < 0.3;
        let is_there = lines.iter().any(|line| line.runs.iter().flat_map(|run| &run.points).all(lies));
        assert!(is_there, "a line at {wanted} mm: {lines:?}");
    }
}

/// A bar that ends on a gridline keeps its top, and nothing as broad leads on from there to the next bar. The gridlines
/// are thin, and the overview leaves them out.
#[test]
fn a_pale_grid_behind_bars_gives_way() {
    let mut svg = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>"##.to_owned();
    for k in 1..=4 {
        svg += &format!(r##"<path d="M80 {y}H840" stroke="#ddd" stroke-width="2"/>"##, y = 540 - 110 * k);
    }
    for (k, height) in [250, 330, 180, 410].into_iter().enumerate() {
        let (x, y) = (140 + 180 * k, 540 - height);
        svg += &format!(
            r##"<rect x="{x}" y="{y}" width="90" height="{height}" fill="#48c" stroke="#111" stroke-width="2"/>"##
        );
    }
    svg += r##"<path d="M80 60V540H840" fill="none" stroke="#000" stroke-width="3"/></svg>"##;
    let profile = Profile::named("swell-a4").expect("it is built in");
    let drawing =
        tactograph::convert(&bitmap::png(&svg, 1200).expect("a PNG"), &Options::new(profile)).expect("a page");
    let place = drawing.page.figure.place;
    let broadest = |x: f32, y: f32| {
        let at = place.min + tactograph::MmPoint::new(x, y).to_vector() * (place.width() / 900.0);
        let is_near = |run: &&tactograph::marks::Run| {
            let points: Vec<_> = run.points.iter().chain(run.points.first().filter(|_| run.closed)).collect();
            points.windows(2).any(|side| nearest_on_segment(at, *side[0], *side[1]).0 < 1.0)
        };
        let runs = drawing.page.figure.lines.iter().flat_map(|line| &line.runs);
        runs.filter(is_near).map(|run| run.width).fold(0.0, f32::max)
    };
    // the second bar ends on the third gridline
    let (top, beside) = (broadest(365.0, 210.0), broadest(455.0, 210.0));
    assert!(top > 1.2 * beside && beside > 0.0, "{top} mm, beside it {beside} mm");
    assert!(drawing.notes.iter().any(|note| note.to_string().contains("gridlines, are not in the overview")));
}

/// A scatter plot of discs and squares on a pale grid: as many points are on its page, on paper and on dots, and
/// fingers tell the two kinds apart.
#[test]
fn all_points_of_a_scatter_plot_are_on_the_page_and_its_two_kinds_are_told_apart() {
    let mut svg = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>"##.to_owned();
    for k in 1..=4 {
        svg += &format!(r##"<path d="M80 {y}H840" stroke="#ccc" stroke-width="2"/>"##, y = 540 - 110 * k);
    }
    svg += r##"<path d="M80 60V540H840" fill="none" stroke="#000" stroke-width="3"/>"##;
    for (x, y) in [(161, 480), (233, 431), (290, 390), (371, 205), (522, 262), (655, 317), (741, 93)] {
        svg += &format!(r##"<circle cx="{x}" cy="{y}" r="6" fill="#17b"/>"##);
    }
    for (x, y) in [(142, 170), (301, 122), (437, 352), (488, 462), (603, 148), (786, 408)] {
        svg += &format!(r##"<rect x="{}" y="{}" width="11" height="11" fill="#e70"/>"##, x - 5, y - 5);
    }
    svg += "</svg>";
    let png = bitmap::png(&svg, 1200).expect("a PNG");
    let pictures = [(&png[..], "a bitmap"), (svg.as_bytes(), "paths")];
    for (profile, (bytes, name)) in
        ["swell-a4", "index-basic-d"].into_iter().flat_map(|profile| pictures.map(|of| (profile, of)))
    {
        let options = Options::new(Profile::named(profile).expect("it is built in"));
        let drawing = tactograph::convert(bytes, &options).expect("a page");
        let extent = |line: &tactograph::marks::Line| {
            let points: Vec<_> = line.runs.iter().flat_map(|run| &run.points).collect();
            let side = |of: fn(&tactograph::MmPoint) -> f32| {
                let at = || points.iter().map(|at| of(at));
                at().fold(f32::MIN, f32::max) - at().fold(f32::MAX, f32::min)
            };
            side(|at| at.x).max(side(|at| at.y))
        };
        let points = drawing.page.figure.lines.iter().filter(|line| extent(line) < 6.5).count();
        assert_eq!(points, 13, "{profile}, {name}: {:?}", drawing.notes);
        let told = drawing.notes.iter().map(ToString::to_string).find(|note| note.contains("signs of several kinds"));
        let is_told = told.is_some_and(|note| note.contains("7 are filled points on the page, and 6 are rings"));
        assert!(is_told, "{profile}, {name}");
    }
}
