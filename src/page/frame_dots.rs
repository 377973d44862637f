//! The frame: rows of fine dots around a picture, neutral as the texture of grey and much finer.

use super::Dots;
use super::layout::FrameParams;
use crate::units::{MmPoint, MmRect, MmVector};

/// The dots of the frame around a picture.
pub fn around(picture: MmRect, params: &FrameParams) -> Dots {
    // Rows as in a hexagonal lattice, as many as the band has room for, the innermost at its inner edge.
    let row_pitch = params.pitch * 0.75_f32.sqrt();
    let rows = ((params.width - params.dot) / row_pitch).floor().max(0.0) as u32 + 1;
    let mut dots = Dots { diameter: params.dot, at: Vec::new() };
    for row in 0..rows {
        let out = params.gap + 0.5 * params.dot + row as f32 * row_pitch;
        ring(picture.inflate(out, out), params.pitch, row % 2 == 1, &mut dots.at);
    }
    dots
}

/// Dots evenly on the four sides: whole steps with a dot in each corner, or half a step further for every other row.
fn ring(rect: MmRect, pitch: f32, between: bool, dots: &mut Vec<MmPoint>) {
    let (right, down) = (MmVector::new(rect.width(), 0.0), MmVector::new(0.0, rect.height()));
    let corners = [rect.min, rect.min + right, rect.max, rect.min + down];
    for (i, &from) in corners.iter().enumerate() {
        let side = corners[(i + 1) % 4] - from;
        let steps = (side.length() / pitch).round().max(1.0);
        let shift = if between { 0.5 } else { 0.0 };
        dots.extend((0..steps as u32).map(|k| from + side * ((k as f32 + shift) / steps)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_dots_touch_and_all_keep_their_distance_from_the_picture() {
        let picture = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(137.3, 98.1));
        let params = FrameParams { width: 3.0, dot: 0.8, pitch: 1.6, gap: 5.0 };
        let dots = around(picture, &params);
        assert!(dots.at.len() > 400);
        for (i, p) in dots.at.iter().enumerate() {
            let outside =
                (picture.min.x - p.x).max(p.x - picture.max.x).max(picture.min.y - p.y).max(p.y - picture.max.y);
            assert!(outside >= params.gap + 0.39 && outside <= params.gap + params.width - 0.39, "{p:?}");
            assert!(dots.at[..i].iter().all(|q| (*q - *p).length() > params.dot + 0.3), "a dot touches {p:?}");
        }
    }
}
