//! Areas that a person drew as filled shapes: they get the textures of their colours.

use super::words::CLEARANCE;
use crate::classes::{self, Classes, Region};
use crate::geom::nearest_on_segment;
use crate::page::{BrailleText, DotMedium, Glyph, Line, Medium, Parts, Texture};
use crate::profile::Plan;
use crate::raster::plane::Plane;
use crate::reading::DrawnArea;
use crate::units::{MmPoint, MmRect, MmVector, Size};
use crate::{Note, dots, textures};

/// Side of the cells in which areas are drawn, mm: as small as the blank beside signs.
const CELL: f32 = 0.5;
/// Blank between the signs of a drawn area and those of others, mm: rows of a texture are further apart.
const APART: f32 = 1.0;

/// Lays the textures of drawn areas over those that are there, the last on top. Tells how many, and which have none.
pub(super) fn lay(parts: &mut Parts, areas: &[DrawnArea], plan: &Plan) -> Vec<Note> {
    let mut laid = 0;
    let mut lost: Vec<(MmPoint, &str)> = Vec::new();
    for area in areas {
        let at = MmRect::from_points(area.outlines.iter().flatten()).center();
        let rgb = area.colour.map(|channel| f32::from(channel) / 255.0);
        let class = area.class.or_else(|| classes::class_of(rgb, &plan.classes(1.0 / CELL)));
        let Some(class) = class else {
            lost.push((at, "too light for a colour"));
            continue;
        };
        let (inside, cells) = inside(&area.outlines, parts.figure.place);
        let place = parts.figure.place;
        let step = MmVector::new(place.width() / inside.size.width as f32, place.height() / inside.size.height as f32);
        let size = cells as f32 * step.x * step.y;
        if size < plan.profile().colours.min_area {
            lost.push((at, if cells == 0 { "outside the figure" } else { "too small for a texture" }));
            continue;
        }
        make_room(&mut parts.figure.textures, &inside, place);
        let [low, high] = [rgb.iter().copied().fold(1.0, f32::min), rgb.iter().copied().fold(0.0, f32::max)];
        let of_area = Classes {
            size: inside.size,
            region: inside.values.iter().map(|is_inside| is_inside.then_some(0)).collect(),
            regions: vec![Region { class, colour: area.colour, cells }],
            lightness: Plane::filled(inside.size, 0.5 * (low + high)),
            fringe: Vec::new(),
        };
        let mut textures = fill(&of_area, place, &parts.figure.lines, &parts.medium, plan);
        textures.iter_mut().for_each(|texture| clear_of_braille(&mut texture.glyphs, &parts.braille));
        textures.retain(|texture| !texture.glyphs.is_empty());
        if textures.is_empty() {
            lost.push((at, "too narrow for a texture"));
        } else {
            laid += 1;
        }
        parts.figure.textures.extend(textures);
    }
    parts.figure.textures.retain(|texture| !texture.glyphs.is_empty());
    let areas = |count: usize| if count == 1 { "1 drawn area".to_owned() } else { format!("{count} drawn areas") };
    let told = (laid > 0).then(|| Note::TakenAs(format!("{} filled with the texture of its colour", areas(laid))));
    let gone = lost.first().map(|(at, why)| {
        Note::LeftOut(format!("{} (the first at {:.0}, {:.0} mm), {why}", areas(lost.len()), at.x, at.y))
    });
    told.into_iter().chain(gone).collect()
}

/// Takes out the signs that are too near to braille or its leader lines.
pub(super) fn clear_of_braille(glyphs: &mut Vec<Glyph>, braille: &[BrailleText]) {
    let boxes: Vec<MmRect> = braille
        .iter()
        .filter(|text| !text.dots.at.is_empty())
        .map(|text| MmRect::from_points(&text.dots.at).inflate(0.5 * text.dots.diameter, 0.5 * text.dots.diameter))
        .collect();
    let leaders = || braille.iter().filter_map(|text| text.leader.as_ref()).flat_map(|run| run.points.windows(2));
    let is_clear = |glyph: &Glyph| {
        let least = CLEARANCE + glyph.radius();
        boxes.iter().all(|place| (glyph.at - glyph.at.clamp(place.min, place.max)).length() >= least)
            && leaders().all(|ends| nearest_on_segment(glyph.at, ends[0], ends[1]).0 >= least)
    };
    glyphs.retain(is_clear);
}

/// The signs of one area, as its paper or device takes them.
pub(super) fn fill(classes: &Classes, place: MmRect, lines: &[Line], medium: &Medium, plan: &Plan) -> Vec<Texture> {
    match medium {
        Medium::Print(print) => {
            let mut drawn = textures::fill(classes, place, lines, &plan.textures());
            let glyphs = drawn.iter_mut().flat_map(|texture| &mut texture.glyphs);
            glyphs.for_each(|glyph| glyph.shape = glyph.shape.narrowed(print.swell));
            drawn
        }
        Medium::Dots(medium @ DotMedium { area, .. }) => {
            dots::textures::fill(classes, place, lines, area, &plan.dot_textures(medium))
        }
    }
}

/// Which cells of a figure lie in a shape.
struct Inside {
    size: Size,
    values: Vec<bool>,
}

impl Inside {
    fn has(&self, at: MmPoint, place: MmRect) -> bool {
        let share = (at - place.min).component_div(place.size().to_vector());
        if !(0.0..1.0).contains(&share.x) || !(0.0..1.0).contains(&share.y) {
            return false;
        }
        let (x, y) = (share.x * self.size.width as f32, share.y * self.size.height as f32);
        self.values.get(y as usize * self.size.width as usize + x as usize).copied().unwrap_or(false)
    }
}

/// The cells whose middles lie in an odd number of outlines, and how many these are.
fn inside(outlines: &[Vec<MmPoint>], place: MmRect) -> (Inside, u32) {
    let cells = |side: f32| (side / CELL).round().clamp(1.0, 8000.0) as u32;
    let size = Size::new(cells(place.width()), cells(place.height()));
    let (width, height) = (size.width as usize, size.height as usize);
    let mut values = vec![false; width * height];
    let mut count = 0;
    for (row, cells) in values.chunks_mut(width).enumerate() {
        let y = place.min.y + (row as f32 + 0.5) / height as f32 * place.height();
        let mut crossings: Vec<f32> = Vec::new();
        for outline in outlines {
            let next = outline.iter().skip(1).chain(outline.first());
            let sides = outline.iter().zip(next).filter(|(a, b)| (a.y > y) != (b.y > y));
            crossings.extend(sides.map(|(a, b)| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)));
        }
        crossings.sort_by(f32::total_cmp);
        let column = |x: f32| ((x - place.min.x) / place.width() * width as f32 - 0.5).ceil().clamp(0.0, width as f32);
        for pair in crossings.chunks_exact(2) {
            for cell in &mut cells[column(pair[0]) as usize..column(pair[1]) as usize] {
                count += 1;
                *cell = true;
            }
        }
    }
    (Inside { size, values }, count)
}

/// Takes away the signs that lie in a shape or too near to it; their areas are smaller then.
fn make_room(textures: &mut [Texture], inside: &Inside, place: MmRect) {
    const AROUND: [(f32, f32); 8] =
        [(1.0, 0.0), (0.7, 0.7), (0.0, 1.0), (-0.7, 0.7), (-1.0, 0.0), (-0.7, -0.7), (0.0, -1.0), (0.7, -0.7)];
    let is_free = |glyph: &Glyph| {
        let reach = glyph.radius() + APART;
        let around = AROUND.iter().map(|(x, y)| glyph.at + MmVector::new(*x, *y) * reach);
        !around.chain([glyph.at]).any(|at| inside.has(at, place))
    };
    for texture in textures {
        let before = texture.glyphs.len();
        texture.glyphs.retain(is_free);
        texture.area *= texture.glyphs.len() as f32 / before.max(1) as f32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_with_a_hole_has_its_cells() {
        let place = MmRect::new(MmPoint::new(10.0, 20.0), MmPoint::new(50.0, 60.0));
        let square = |x: f32, y: f32, side: f32| {
            [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|(a, b)| MmPoint::new(x + a, y + b)).to_vec()
        };
        let (inside, cells) = inside(&[square(15.0, 25.0, 20.0), square(20.0, 30.0, 5.0)], place);
        assert!((cells as f32 * CELL * CELL - (400.0 - 25.0)).abs() < 1e-3);
        assert!(inside.has(MmPoint::new(16.0, 26.0), place) && !inside.has(MmPoint::new(22.0, 32.0), place));
        assert!(!inside.has(MmPoint::new(36.0, 26.0), place) && !inside.has(MmPoint::new(5.0, 5.0), place));
    }
}
