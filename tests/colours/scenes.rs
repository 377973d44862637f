//! Drawn scenes whose areas have known classes.

use tactograph::internals::classes::{self, Class, Classes};
use tactograph::internals::edges;
use tactograph::internals::geom::polyline::Polyline;
use tactograph::internals::pipeline::colours;
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::Raster;
use tactograph::internals::raster::plane::Plane;
use tactograph::internals::units::{PxPoint, Size};

/// The working resolution of the default profile.
pub(crate) const PX_PER_MM: f32 = 4.0;

/// Numbers that look random, the same for the same seed (xorshift).
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// 0..1.
    pub(crate) fn roll(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f32 / (1_u64 << 24) as f32
    }
}

/// A picture and the area that each pixel belongs to; `None` on outlines.
pub(crate) struct Scene {
    pub(crate) raster: Raster,
    pub(crate) area: Vec<Option<usize>>,
    /// Class of each area.
    pub(crate) classes: Vec<Class>,
}

/// How areas meet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    pub(crate) name: &'static str,
    /// Width of the outlines between areas, mm, and their grey (linear light).
    pub(crate) outline: f32,
    pub(crate) ink: f32,
    /// Sigma of the blur of the picture, px.
    pub(crate) softness: f32,
    /// Standard deviation of the noise of every pixel, linear light.
    pub(crate) noise: f32,
}

/// Shades of the five classes that nobody would argue about, sRGB.
const SHADES: [(Class, u32); 15] = [
    (Class::Blue, 0x2040d0),
    (Class::Blue, 0x70b0e8),
    (Class::Blue, 0x102880),
    (Class::Green, 0x20a030),
    (Class::Green, 0x90d890),
    (Class::Green, 0x105818),
    (Class::Yellow, 0xf0d010),
    (Class::Yellow, 0xf4e890),
    (Class::Yellow, 0xe0a020),
    (Class::Red, 0xd01818),
    (Class::Red, 0xf09090),
    (Class::Red, 0x881018),
    (Class::Grey, 0x888888),
    (Class::Grey, 0xc8c8c8),
    (Class::Grey, 0x202020),
];

/// A map of `count` areas around random places, 100 by 80 mm, each in a random shade.
pub(crate) fn voronoi(seed: u64, count: usize, style: Style) -> Scene {
    let mut dice = Dice::new(seed);
    let size = Size::new((100.0 * PX_PER_MM) as u32, (80.0 * PX_PER_MM) as u32);
    let places: Vec<(f32, f32)> =
        (0..count).map(|_| (dice.roll() * size.width as f32, dice.roll() * size.height as f32)).collect();
    let shades: Vec<(Class, u32)> =
        (0..count).map(|_| SHADES[((dice.roll() * SHADES.len() as f32) as usize).min(SHADES.len() - 1)]).collect();
    let half = 0.5 * style.outline * PX_PER_MM;
    let mut area = Vec::new();
    for i in 0..size.area() as usize {
        let at = ((i % size.width as usize) as f32 + 0.5, (i / size.width as usize) as f32 + 0.5);
        let squared = |p: (f32, f32)| (p.0 - at.0).powi(2) + (p.1 - at.1).powi(2);
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|a, b| squared(places[*a]).total_cmp(&squared(places[*b])));
        let (p, q) = (places[order[0]], places[order[1]]);
        let apart = (p.0 - q.0).hypot(p.1 - q.1);
        let to_border = (squared(q) - squared(p)) / (2.0 * apart);
        area.push((to_border >= half).then_some(order[0]));
    }
    let planes = [16, 8, 0].map(|shift: u32| {
        let linear = |code: u32| decoded((code >> shift & 0xff) as f32 / 255.0);
        let values = area.iter().map(|area| area.map_or(style.ink, |area| linear(shades[area].1))).collect();
        let mut plane = Plane { size, values }.blurred(style.softness).values;
        plane.iter_mut().for_each(|value| {
            let bell: f32 = (0..12).map(|_| dice.roll()).sum::<f32>() - 6.0;
            *value = (*value + style.noise * bell).clamp(0.0, 1.0);
        });
        plane
    });
    Scene { raster: Raster::colour(size, planes), area, classes: shades.into_iter().map(|(class, _)| class).collect() }
}

/// sRGB to linear light.
pub(crate) fn decoded(value: f32) -> f32 {
    if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// The sRGB values of a colour given as HSV, hue in degrees.
pub(crate) fn rgb_of(hue: f32, saturation: f32, value: f32) -> [f32; 3] {
    [5.0, 3.0, 1.0].map(|n| {
        let k = (n + hue / 60.0) % 6.0;
        value - value * saturation * k.min(4.0 - k).clamp(0.0, 1.0)
    })
}

/// The numbers of the default profile.
pub(crate) fn params() -> classes::Params {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    colours::params(&plan)
}

/// The contours of a scene, as the pipeline finds them at this resolution.
pub(crate) fn contours(raster: &Raster) -> Vec<Polyline<PxPoint>> {
    let params = edges::Params {
        sigma: 2.25,
        low: 3.0,
        high: 7.0,
        min_length: 10.0,
        min_length_of_drawing: 10.0,
        strength_window: 5.0,
        suppression: 1.0,
        side_cell: 8.0,
        side_offset: 12.0,
        widest_stroke: 19.0,
        dark_lines: None,
    };
    edges::find(raster, &params).borders()
}

/// The class of every pixel.
pub(crate) fn by_pixel(classes: &Classes, size: Size) -> Vec<Option<Class>> {
    let cell = |i: usize| {
        let (x, y) = (i % size.width as usize, i / size.width as usize);
        let column = x * classes.size.width as usize / size.width as usize;
        let row = y * classes.size.height as usize / size.height as usize;
        row * classes.size.width as usize + column
    };
    (0..size.area() as usize)
        .map(|i| classes.region[cell(i)].map(|region| classes.regions[region as usize].class))
        .collect()
}
