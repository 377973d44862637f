//! What must hold between a picture's page and the page of the same picture changed in a way that a reader would not
//! notice, or would notice in one way only. No truth has to be known. Everything is with the thresholds that profiles
//! ship: all with the default profile, some with one of each other family. Flips, turns and shifts are in
//! `tests/metamorphic.rs`, detail in `tests/lines.rs`, threads in `tests/threads.rs`. What each relation tolerates, and
//! why, is in `docs/stability.md`.

use tactograph::internals::classes::{self, Class};
use tactograph::internals::edges::{self, Edges};
use tactograph::internals::lines::Line;
use tactograph::internals::page::Figure;
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::{Planes, Raster};
use tactograph::internals::units::Size;
use tactograph::{Options, Picture};
use tactograph_tools::near::Near;

use crate::common::{families, samples};

/// A picture in code values.
pub(crate) struct Bitmap {
    name: String,
    size: [usize; 2],
    rgba: Vec<[u8; 4]>,
}

/// A sample as pixels: a drawing is painted 1200 px wide.
pub(crate) fn bitmap(name: &str) -> Bitmap {
    let bytes = samples::read(name);
    if name.ends_with(".svg") {
        let tree = usvg::Tree::from_data(&bytes, &usvg::Options::default()).expect("a drawing");
        let scale = 1200.0 / tree.size().width();
        let mut pixels =
            resvg::tiny_skia::Pixmap::new(1200, (tree.size().height() * scale) as u32 / 8 * 8).expect("so many pixels");
        pixels.fill(resvg::tiny_skia::Color::WHITE);
        resvg::render(&tree, usvg::Transform::from_scale(scale, scale), &mut pixels.as_mut());
        let size = [pixels.width(), pixels.height()].map(|side| side as usize);
        return Bitmap { name: name.into(), size, rgba: pixels.data().as_chunks().0.to_vec() };
    }
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("small")];
    let info = reader.next_frame(&mut pixels).expect("pixels");
    let colours = info.color_type.samples();
    let rgba = pixels.chunks(colours).map(|pixel| [pixel[0], pixel[1], pixel[2], 255]).collect();
    Bitmap { name: name.into(), size: [info.width, info.height].map(|side| side as usize), rgba }
}

impl Bitmap {
    pub(crate) fn of(name: &str, size: [usize; 2], colour: impl Fn(usize, usize) -> [u8; 3]) -> Self {
        let pixel = |i: usize| {
            let [r, g, b] = colour(i % size[0], i / size[0]);
            [r, g, b, 255]
        };
        Self { name: name.into(), size, rgba: (0..size[0] * size[1]).map(pixel).collect() }
    }

    fn at(&self, x: usize, y: usize) -> [u8; 3] {
        let [r, g, b, _] = self.rgba[y * self.size[0] + x];
        [r, g, b]
    }

    /// Width and height, px.
    pub(crate) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Every pixel as this makes of its column, row and colour.
    pub(crate) fn changed(&self, to: impl Fn(usize, usize, [u8; 3]) -> [u8; 3]) -> Self {
        Self::of(&self.name, self.size, |x, y| to(x, y, self.at(x, y)))
    }

    /// Every pixel as a square of so many.
    fn magnified(&self, by: usize) -> Self {
        Self::of(&self.name, self.size.map(|side| side * by), |x, y| self.at(x / by, y / by))
    }

    /// With so many pixels of a colour around it.
    fn bordered(&self, by: usize, colour: [u8; 3]) -> Self {
        let [width, height] = self.size;
        Self::of(&self.name, [width + 2 * by, height + 2 * by], |x, y| {
            let inside = (by..by + width).contains(&x) && (by..by + height).contains(&y);
            if inside { self.at(x - by, y - by) } else { colour }
        })
    }

    /// The page, with the ground of a scan as it is or not, and whether it is told that a rim is left out.
    fn page(&self, keep_ground: bool) -> (tactograph::Page, bool) {
        let options = Options::new(Profile::named("swell-a4").expect("it is built in")).keep_ground(keep_ground);
        let picture =
            Picture::rgba8(self.size[0] as u32, self.size[1] as u32, self.rgba.as_flattened()).expect("so many");
        let drawing = tactograph::convert(picture, &options).expect("a page");
        let is_told = drawing.notes.iter().any(|note| matches!(note, tactograph::Note::RimLeftOut(_)));
        (drawing.page, is_told)
    }

    /// Its figure, so many mm wide; all that is found is drawn.
    pub(crate) fn figure(&self, width_mm: f32) -> Figure {
        self.figure_with(families::DEFAULT, width_mm)
    }

    /// The same with a built-in profile.
    fn figure_with(&self, profile: &str, width_mm: f32) -> Figure {
        let mut profile = Profile::named(profile).expect("it is built in");
        profile.set("overview.on", "false").expect("a key");
        let picture =
            Picture::rgba8(self.size[0] as u32, self.size[1] as u32, self.rgba.as_flattened()).expect("so many");
        let options = Options::new(profile).width_mm(width_mm);
        tactograph::convert(picture, &options)
            .unwrap_or_else(|fault| panic!("{}: {fault}", self.name))
            .page
            .figure
            .clone()
    }

    fn raster(&self) -> Raster {
        let light = |channel: usize| self.rgba.iter().map(|pixel| light(pixel[channel])).collect();
        let size = Size::new(self.size[0] as u32, self.size[1] as u32);
        Raster::new(size, Planes::Colour([light(0), light(1), light(2)]))
    }
}

/// Linear light of a code value (IEC 61966-2-1).
fn light(code: u8) -> f32 {
    let value = f32::from(code) / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// Share of the points of either that have none of the other within some length, the more of both.
fn unmatched(one: Vec<[f64; 2]>, other: Vec<[f64; 2]>, within: f64) -> f64 {
    let sides = |i: usize| one.iter().chain(&other).map(|at| at[i]).fold(1.0, f64::max).ceil() as usize;
    let size = [sides(0), sides(1)];
    let lost = |of: &[[f64; 2]], among: &[[f64; 2]]| {
        let near = Near::new(among.to_vec(), size, within.max(0.5));
        let is_alone = |at: &&[f64; 2]| near.nearest(**at).is_none_or(|(_, distance)| distance > within);
        of.iter().filter(is_alone).count() as f64 / of.len().max(1) as f64
    };
    lost(&one, &other).max(lost(&other, &one))
}

/// [`unmatched`] of lines, whose positions count from a corner on the sheet each, mm.
fn astray(one: &[Line], one_from: [f32; 2], other: &[Line], other_from: [f32; 2], within: f64) -> f64 {
    let points = |lines: &[Line], from: [f32; 2]| -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for (a, b) in lines.iter().flat_map(|line| &line.runs).flat_map(|run| run.polyline().segments()) {
            let steps = ((*b - *a).length() / 0.02).ceil().max(1.0);
            let places = (0..=steps as u32).map(|k| a.lerp(*b, k as f32 / steps));
            points.extend(places.map(|at| [f64::from(at.x - from[0]), f64::from(at.y - from[1])]));
        }
        points
    };
    unmatched(points(one, one_from), points(other, other_from), within)
}

fn corner(figure: &Figure) -> [f32; 2] {
    [figure.place.min.x, figure.place.min.y]
}

/// Working pixels for a millimetre of the stages that are asked alone.
const PX_PER_MM: f32 = 4.0;

pub(crate) const DRAWINGS: [&str; 6] =
    ["bars.svg", "cell.svg", "chart.svg", "landscape.svg", "map.svg", "portrait.svg"];
const PHOTOGRAPHS: [&str; 3] = ["astronaut.png", "chelsea.png", "coffee.png"];

/// What holds for the profiles that relations are tested with holds for all: each asks the same of contours and colours
/// as one of them.
#[test]
fn every_profile_is_of_one_family() {
    let is_alike = |one: &Plan, other: &Plan| {
        let [one_edges, other_edges] = [one, other].map(|plan| plan.edges(PX_PER_MM));
        // a sum and difference with the diameter of a dot, which may differ by rounding
        let is_as_wide = (one_edges.widest_stroke - other_edges.widest_stroke).abs() < 1e-3;
        let other_edges = edges::Params { widest_stroke: one_edges.widest_stroke, ..other_edges };
        is_as_wide && one_edges == other_edges && one.classes(PX_PER_MM) == other.classes(PX_PER_MM)
    };
    for profile in Profile::built_in() {
        let own = families::plan(profile.name);
        let of: Vec<&str> = families::all().filter(|head| is_alike(&own, &families::plan(head))).collect();
        assert_eq!(of.len(), 1, "{} is of the families {of:?}: tests/common/families.rs", profile.name);
        // on paper of other sizes, lines and textures are the same, too
        let paper = families::plan(families::DEFAULT);
        if of[0] == families::DEFAULT {
            assert_eq!(own.lines(), paper.lines(), "{}", profile.name);
            assert_eq!(own.textures(), paper.textures(), "{}", profile.name);
        }
    }
}

/// The same picture of two or three times the pixels is the same page: it is shrunk to as many pixels for a millimetre.
#[test]
fn magnified_pictures_give_the_same_page() {
    let all = DRAWINGS.map(|name| (name, 150.0)).into_iter().chain(PHOTOGRAPHS.map(|name| (name, 100.0)));
    for (name, width) in all {
        let once = bitmap(name);
        let before = once.figure(width);
        for by in [2, 3] {
            let after = once.magnified(by).figure(width);
            assert_eq!(before.lines.len(), after.lines.len(), "{name} x{by}");
            let off = astray(&before.lines, corner(&before), &after.lines, corner(&after), 0.02);
            assert!(off == 0.0, "{name} x{by}: {off} of the lines are elsewhere");
            assert_eq!(marks(&before).len(), marks(&after).len(), "{name} x{by}");
        }
    }
}

/// So it is on dots, whose grid is where it was: but for ties of rounding, every dot.
#[test]
fn magnified_pictures_give_the_same_dots() {
    for profile in families::DOTS {
        let once = bitmap("landscape.svg");
        let (before, after) = (once.figure_with(profile, 100.0), once.magnified(2).figure_with(profile, 100.0));
        assert!(!before.lines.is_empty(), "{profile}");
        assert_eq!(before.lines.len(), after.lines.len(), "{profile}");
        let off = astray(&before.lines, corner(&before), &after.lines, corner(&after), 0.02);
        assert!(off <= 0.002, "{profile}: {off} of the lines are elsewhere");
        let (one, other) = (marks(&before).len(), marks(&after).len());
        assert!(one.abs_diff(other) * 500 <= one, "{profile}: {one} dots of textures, and {other}");
    }
}

/// The marks of all textures as class and place from the corner of the figure, hundredths of a mm.
fn marks(figure: &Figure) -> Vec<(Class, [i32; 2])> {
    let [x, y] = corner(figure);
    let places =
        figure.textures.iter().flat_map(|texture| texture.glyphs.iter().map(|glyph| (texture.class, glyph.at)));
    places.map(|(class, at)| (class, [at.x - x, at.y - y].map(|mm| (100.0 * mm).round() as i32))).collect()
}

/// More of the background around a drawing that ends in it all round moves the marks and does nothing else.
#[test]
fn a_border_of_background_moves_the_page_and_changes_nothing() {
    for (name, is_white) in [("bars.svg", true), ("cell.svg", true), ("chart.svg", true), ("map.svg", false)] {
        let bare = bitmap(name);
        let background = bare.at(0, 0);
        let [width, height] = bare.size;
        let rows = (0..width).flat_map(|x| [(x, 0), (x, height - 1)]);
        let mut rim = rows.chain((0..height).flat_map(|y| [(0, y), (width - 1, y)]));
        assert!(rim.all(|(x, y)| bare.at(x, y) == background), "{name} does not end in its background");
        assert_eq!(background == [255; 3], is_white, "{name}");
        // 8 px are a millimetre and 2 of them a working pixel, with and without the border
        let (before, after) = (bare.figure(150.0), bare.bordered(80, background).figure(170.0));
        let [x, y] = corner(&after);
        let off = astray(&before.lines, corner(&before), &after.lines, [x + 10.0, y + 10.0], 0.05);
        assert!(off <= 0.003, "{name}: {off} of the lines are elsewhere");
        if is_white {
            assert_eq!((off, before.lines.len()), (0.0, after.lines.len()), "{name}");
            let count = |figure: &Figure| -> Vec<(Class, usize)> {
                figure.textures.iter().map(|texture| (texture.class, texture.glyphs.len())).collect()
            };
            assert_eq!(count(&before), count(&after), "{name}");
        }
    }
}

/// A grey picture as one plane and as three equal ones: the same edges and the same classes.
#[test]
fn grey_is_the_same_by_one_plane_and_by_three() {
    let default = DRAWINGS.into_iter().chain(PHOTOGRAPHS).map(|name| (families::DEFAULT, name));
    for (profile, name) in default.chain(families::DOTS.map(|profile| (profile, "bars.svg"))) {
        let plan = families::plan(profile);
        let bitmap = bitmap(name);
        let name = format!("{name} with {profile}");
        let raster = bitmap.raster();
        let Planes::Colour([_, green, _]) = raster.planes() else { unreachable!("it has three planes") };
        let grey = Raster::new(raster.size(), Planes::Grey(green.clone()));
        let colour = Raster::new(raster.size(), Planes::Colour([green.clone(), green.clone(), green.clone()]));
        let find = |raster: &Raster| edges::find(raster, &plan.edges(PX_PER_MM));
        let (one, three) = (find(&grey), find(&colour));
        let off = edges_astray(&one, &three, 0.02);
        let classes = |raster: &Raster, edges: &Edges| labels(raster, edges, &plan);
        let (a, b) = (classes(&grey, &one), classes(&colour, &three));
        let other = a.iter().zip(&b).filter(|(a, b)| a != b).count() as f64 / a.len() as f64;
        assert!(off == 0.0, "{name}: {off} of the edges are elsewhere");
        assert!(other == 0.0, "{name}: {other} of the cells are of another class");
        let strength = |edges: &Edges| edges.edgels.iter().map(|edgel| f64::from(edgel.strength)).sum::<f64>();
        let (one, three) = (strength(&one), strength(&three));
        assert!((one - three).abs() <= 1e-6 * one, "{name}: strength {one} and {three}");
    }
}

fn labels(raster: &Raster, edges: &Edges, plan: &Plan) -> Vec<Option<Class>> {
    let classes = classes::sort(raster, &edges.borders(), &plan.classes(PX_PER_MM));
    let label = |region: &Option<u32>| region.map(|region| classes.regions[region as usize].class);
    classes.region.iter().map(label).collect()
}

fn edges_astray(one: &Edges, other: &Edges, within: f64) -> f64 {
    let points = |edges: &Edges| -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for chain in &edges.chains {
            for (a, b) in edges.chain(chain).segments() {
                let steps = ((b.at - a.at).length() / (0.5 * within as f32)).ceil().max(1.0);
                let places = (0..=steps as u32).map(|k| a.at.lerp(b.at, k as f32 / steps));
                points.extend(places.map(|at| [f64::from(at.x), f64::from(at.y)]));
            }
        }
        points
    };
    unmatched(points(one), points(other), within)
}

/// Light times k is lightness times a power of k, so thresholds times that power find the same edges: of greys, above
/// the straight part of the curve of sRGB. Drawings only: what separates texture from objects in photographs has bounds
/// of its own in code values, which do not scale.
#[test]
fn brightness_scaled_with_the_thresholds_gives_the_same_edges() {
    const SCALES: &[f32] = &[0.25, 0.5, 0.8];
    const HALF: &[f32] = &[0.5];
    let default = DRAWINGS.map(|name| (families::DEFAULT, name, SCALES));
    let others = families::DOTS.map(|profile| (profile, "bars.svg", HALF));
    for (profile, name, scales) in default.into_iter().chain(others) {
        let plan = families::plan(profile);
        let raster = bitmap(name).raster();
        for &k in scales {
            let off = scaled_astray(&raster, &plan, k);
            assert!(off <= 0.003, "{name} x {k} with {profile}: {off} of the edges are elsewhere");
        }
    }
}

/// Share of the edges that are elsewhere when light is times `k` and thresholds are times `k` to the power of 1/2.4.
fn scaled_astray(raster: &Raster, plan: &Plan, k: f32) -> f64 {
    let Planes::Colour([_, green, _]) = raster.planes() else { unreachable!("it has three planes") };
    // from 0.05 to 1: half of that is still beyond the straight part
    let lifted: Vec<f32> = green.iter().map(|value| 0.05 + 0.95 * value).collect();
    let scaled = lifted.iter().map(|value| k * value).collect();
    let find = |values: Vec<f32>, by: f32| {
        let params = plan.edges(PX_PER_MM);
        let params = edges::Params { low: by * params.low, high: by * params.high, ..params };
        edges::find(&Raster::new(raster.size(), Planes::Grey(values)), &params)
    };
    edges_astray(&find(lifted, 1.0), &find(scaled, k.powf(1.0 / 2.4)), 0.02)
}

/// Of photographs it does not hold, by as much as `docs/stability.md` says: if it does one day, the docs can say so.
#[test]
fn brightness_of_photographs_does_not_scale() {
    let plan = families::plan(families::DEFAULT);
    let mut worst = [0.0_f64; 2];
    for name in PHOTOGRAPHS {
        let raster = bitmap(name).raster();
        let off = [0.8, 0.25].map(|k| scaled_astray(&raster, &plan, k));
        worst = [worst[0].max(off[0]), worst[1].max(off[1])];
    }
    assert!(worst[0] <= 0.04 && (0.05..=0.4).contains(&worst[1]), "{worst:?} of the edges are elsewhere");
}

/// Areas of pure red, green and blue whose planes change places: the regions stay, and their classes change places.
#[test]
fn permuted_hues_permute_the_classes() {
    let pure = |x: usize, y: usize| match (x / 100, y / 100) {
        (1, 1) | (3, 2) => [220, 20, 30],
        (2, 1) | (1, 3) => [30, 200, 40],
        (3, 1) | (2, 2) => [20, 40, 230],
        (0, 3) => [128, 128, 128],
        _ => [255; 3],
    };
    let once = Bitmap::of("pure", [500, 500], pure);
    let turned = Bitmap::of("turned", [500, 500], |x, y| {
        let [r, g, b] = pure(x, y);
        [b, r, g]
    });
    let to = |class: &Option<Class>| match class {
        Some(Class::Red) => Some(Class::Green),
        Some(Class::Green) => Some(Class::Blue),
        Some(Class::Blue) => Some(Class::Red),
        other => *other,
    };
    for profile in families::all() {
        let plan = families::plan(profile);
        let of = |bitmap: &Bitmap| {
            let raster = bitmap.raster();
            labels(&raster, &edges::find(&raster, &plan.edges(PX_PER_MM)), &plan)
        };
        let (before, after) = (of(&once), of(&turned));
        let other = before.iter().zip(&after).filter(|(before, after)| to(before) != **after).count();
        let count = |class| before.iter().filter(|label| **label == class).count();
        assert!(
            [Class::Red, Class::Green, Class::Blue].into_iter().all(|class| count(Some(class)) > 1000),
            "areas are lost with {profile}"
        );
        // at corners a cell may be of either side
        assert!(other <= 3, "{other} of {} cells with {profile}", before.len());
    }
}

/// A figure of shapes in a square of 100 units times `k`, whose places are times `k` as well.
fn drawn(shapes: &str, k: f64) -> Figure {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {0}' width='400' height='400'>\
         <rect width='{0}' height='{0}' fill='#fff'/><g transform='scale({k})'>{shapes}</g></svg>",
        100.0 * k
    );
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("overview.on", "false").expect("a key");
    tactograph::convert(svg.as_bytes(), &Options::new(profile).width_mm(120.0)).expect("a page").page.figure.clone()
}

const SHAPES: &str = "<path d='M10 20L60 15L85 60L40 90Z' fill='#c22' stroke='#000' stroke-width='1.5'/>\
                      <path d='M70 10C95 5 95 40 75 35' fill='none' stroke='#024' stroke-width='2'/>";

fn same_lines(one: &Figure, other: &Figure) -> f64 {
    assert_eq!(one.lines.len(), other.lines.len());
    astray(&one.lines, corner(one), &other.lines, corner(other), 0.05)
}

/// Units are nobody's business: a drawing in millionths, or in millions, is the same drawing.
#[test]
fn drawings_a_million_times_larger_or_smaller_give_the_same_page() {
    let before = drawn(SHAPES, 1.0);
    assert!(before.lines.len() >= 2 && !marks(&before).is_empty());
    for k in [1e-6, 1e-3, 1e3, 1e6] {
        let after = drawn(SHAPES, k);
        assert!(same_lines(&before, &after) == 0.0, "x {k}");
        assert_eq!(marks(&before).len(), marks(&after).len(), "x {k}");
    }
}

/// What draws nothing new: a path over itself, and paths without length or area.
#[test]
fn paths_that_coincide_or_have_no_length_change_nothing() {
    let before = drawn(SHAPES, 1.0);
    let nothing = "<path d='M30 30L30 30' stroke='#000'/><path d='M20 80z' stroke='#000'/><line x1='5' y1='5' x2='5' y2='5' \
                   stroke='#000'/><rect x='50' y='50' width='0' height='9'/><path d='M50 50h0v0h0z' fill='#00f'/>\
                   <polygon points='1,1'/><path d=''/><circle cx='50' cy='50' r='0'/>";
    for more in [SHAPES.to_owned(), SHAPES.repeat(9), nothing.to_owned()] {
        let after = drawn(&format!("{SHAPES}{more}"), 1.0);
        assert!(same_lines(&before, &after) == 0.0, "{more}");
        assert_eq!(marks(&before).len(), marks(&after).len(), "{more}");
    }
}

/// Paths that cross themselves, turn back on themselves or wind many times round a point are pages like others.
#[test]
fn paths_that_cross_themselves_make_pages() {
    let wound = (0..400).map(|i| {
        let (angle, r) = (0.37 * f64::from(i), 5.0 + 0.1 * f64::from(i));
        format!("{} {}", 50.0 + r * angle.cos(), 50.0 + r * angle.sin())
    });
    let wound = format!("<path d='M{}' fill='none' stroke='#000'/>", wound.collect::<Vec<_>>().join("L"));
    for path in [
        "<path d='M10 10L90 90L90 10L10 90Z' fill='#c22'/>",
        "<path d='M50 5L79 95L3 39H97L21 95Z' fill='#c22' fill-rule='evenodd' stroke='#000'/>",
        "<path d='M10 50H90H10H90H10' fill='none' stroke='#000' stroke-width='2'/>",
        "<path d='M10 50C200 50 -100 50 90 50' fill='none' stroke='#000' stroke-width='2'/>",
        &wound,
    ] {
        let figure = drawn(path, 1.0);
        let length: f32 = figure.lines.iter().map(Line::length).sum();
        assert!(length > 50.0, "{path}: {length} mm of lines");
    }
}

/// What reaches far beyond the picture is drawn where it is seen.
#[test]
fn shapes_that_reach_far_away_are_drawn_where_they_are_seen() {
    let near = drawn("<rect x='10' y='20' width='30' height='90' fill='#c22'/>", 1.0);
    let far = drawn("<rect x='10' y='20' width='30' height='100000' fill='#c22'/>", 1.0);
    assert!(!near.lines.is_empty());
    assert!(same_lines(&near, &far) <= 0.01, "{} of the lines are elsewhere", same_lines(&near, &far));
}

/// A billion pixels away, where the renderer gives up, there is a page all the same, and it takes no more memory.
/// Before, this ended the program.
#[test]
fn shapes_that_reach_a_billion_pixels_away_make_a_page() {
    let far = "<g transform='scale(1e7)'><rect x='1e-6' y='2e-6' width='3e-6' height='400' fill='#c22'/></g>";
    let figure = drawn(&format!("{SHAPES}{far}"), 1.0);
    assert!(figure.lines.len() >= drawn(SHAPES, 1.0).lines.len());
}

/// How much of the lines of a figure runs along its frame, within 4 mm, mm.
fn along_the_frame(figure: &Figure) -> f32 {
    let place = figure.place;
    let is_near = |at: &tactograph::MmPoint| {
        let sides = [at.x - place.min.x, place.max.x - at.x, at.y - place.min.y, place.max.y - at.y];
        sides.into_iter().fold(f32::MAX, f32::min) < 4.0
    };
    let runs = figure.lines.iter().flat_map(|line| &line.runs).map(|run| run.path().collect::<Vec<_>>());
    let near = |path: Vec<tactograph::MmPoint>| -> f32 {
        path.windows(2).filter(|pair| pair.iter().all(is_near)).map(|pair| (pair[1] - pair[0]).length()).sum()
    };
    runs.map(near).sum()
}

/// A finger would take the line along the rim of a scan for the frame of something.
#[test]
fn the_rim_of_a_scanned_photograph_is_no_line() {
    let plain = bitmap("coffee.png");
    assert!(!plain.page(false).1);
    for colour in [[12, 10, 11], [252, 252, 252]] {
        let rimmed = plain.bordered(6, colour);
        let ((without, is_told), (with, is_told_if_kept)) = (rimmed.page(false), rimmed.page(true));
        assert!(is_told && !is_told_if_kept, "{colour:?}");
        // one side of the dark one stays: the table beside it is as dark
        let [without, with] = [&without, &with].map(|page| along_the_frame(&page.figure));
        assert!(with > without + 200.0, "{colour:?}: {without} mm, and {with} if it is kept");
    }
}
