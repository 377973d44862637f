//! How large a mark of a texture is, as in `textures::glyph`.

use tactograph::Class;
use tactograph::internals::textures::{Params, sample};
use tactograph::internals::units::{MmPoint, MmRect};
use tactograph::marks::Shape;

/// The two measures of a mark of a class at this lightness, mm: length and thickness, or the diameter twice.
pub fn size(class: Class, lightness: f64, params: &Params) -> [f64; 2] {
    let white = f64::from(params.white_from);
    let boldness = ((white - lightness) / (white - 0.25)).clamp(0.0, 1.0);
    let [length, thickness, dot, least] =
        [params.length, params.thickness, params.dot, params.min_glyph].map(f64::from);
    let between = |least: f64, most: f64| least + (most - least) * boldness;
    match params.palette.degrees(class) {
        Some(_) => [length * between(0.75, 1.0), between(least, thickness)],
        None => [between((0.6 * dot).max(least), dot); 2],
    }
}

/// The greatest difference from the program's marks over all classes and lightnesses, mm, and of how many marks.
pub fn compare(params: &Params) -> (f64, usize) {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(60.0, 60.0));
    let (mut farthest, mut marks) = (0.0_f64, 0);
    for step in 0..=1000 {
        let lightness = step as f32 / 1000.0;
        for class in Class::ALL {
            for glyph in sample(class, lightness, 0.0, area, params).glyphs {
                marks += 1;
                let is = match glyph.shape {
                    Shape::Rhombus { length, thickness, .. } => [length, thickness],
                    Shape::Dot { diameter } => [diameter; 2],
                };
                let exact = size(class, f64::from(lightness), params);
                farthest =
                    exact.iter().zip(is).map(|(exact, is)| (exact - f64::from(is)).abs()).fold(farthest, f64::max);
            }
        }
    }
    (farthest, marks)
}
