//! How many glyphs there are in ink: patches that hang together.

use crate::raster::plane::Plane;

/// Share of the blackest ink from which a pixel belongs to a patch: dots that are pressed low are drawn grey.
const BLACK: f32 = 0.5;

/// The number of patches of ink, corners counting as contact.
pub(super) fn patches(ink: &Plane) -> usize {
    let (width, height) = (ink.size.width as usize, ink.size.height as usize);
    let blackest = ink.values.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    let mut unseen: Vec<bool> = ink.values.iter().map(|&value| value >= BLACK * blackest).collect();
    let mut open = Vec::new();
    let mut count = 0;
    for start in 0..unseen.len() {
        if !unseen[start] {
            continue;
        }
        count += 1;
        unseen[start] = false;
        open.push(start);
        while let Some(at) = open.pop() {
            let (x, y) = (at % width, at / width);
            for near_y in y.saturating_sub(1)..(y + 2).min(height) {
                for near_x in x.saturating_sub(1)..(x + 2).min(width) {
                    let near = near_y * width + near_x;
                    if unseen[near] {
                        unseen[near] = false;
                        open.push(near);
                    }
                }
            }
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Size;

    #[test]
    fn patches_hang_together_by_sides_and_corners() {
        let picture = ["#..#", ".#.#", "....", "#..#"];
        let values = picture.iter().flat_map(|row| row.chars().map(|c| f32::from(u8::from(c == '#')))).collect();
        assert_eq!(patches(&Plane { size: Size::new(4, 4), values }), 4);
    }
}
