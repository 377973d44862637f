//! Where glyphs may stand: one lattice a class over the whole picture, so that regions of one colour share their rows.
//!
//! ```text
//!   x   x   x   x     dense and sparse
//!     o   o   o       dense only: the sparse texture drops whole rows
//!   x   x   x   x
//! ```
//!
//! Rows stand further apart than the glyphs along them, at both densities: measured through a fingertip's blur, a lattice
//! with nearer rows is felt in the *wrong* direction. The dots of grey form a hexagonal lattice, and so does every third of
//! them (at sqrt(3) times the distance): grey has no direction at either density.

use super::Params;
use super::glyph::{degrees, unit};
use crate::classes::Class;
use crate::units::{MmPoint, MmRect, MmVector};

/// A place for a glyph.
pub(super) struct Place {
    pub(super) at: MmPoint,
    /// Whether it stays empty where the texture is sparse.
    pub(super) dense_only: bool,
}

/// Visits the places of a class's lattice in `area`, row by row. The lattice is centred in the area, so that a mirrored
/// picture finds the mirrored lattice.
pub(super) fn each_place(class: Class, area: MmRect, params: &Params, mut visit: impl FnMut(Place)) {
    let (along, across, step, row) = match degrees(class) {
        Some(degrees) => (unit(degrees), unit(degrees + 90.0), params.along, params.across),
        None => (unit(0.0), unit(90.0), params.dot_pitch, params.dot_pitch * 0.75_f32.sqrt()),
    };
    let centre = area.center();
    let half = MmVector::new(0.5 * area.width(), 0.5 * area.height());
    let reach = |direction: MmVector| half.x * direction.x.abs() + half.y * direction.y.abs();
    let rows = (reach(across) / row).ceil() as i32;
    let columns = (reach(along) / step).ceil() as i32 + 1;
    for j in -rows..=rows {
        let stagger = if j % 2 == 0 { 0.0 } else { 0.5 };
        for i in -columns..=columns {
            let at = centre + along * ((i as f32 + stagger) * step) + across * (j as f32 * row);
            if area.contains_inclusive(at) {
                visit(Place { at, dense_only: is_dense_only(class, i, j) });
            }
        }
    }
}

fn is_dense_only(class: Class, i: i32, j: i32) -> bool {
    if class == Class::Grey {
        // In steps along the two axes of the hexagonal lattice, 60 degrees apart, the place is (a, j).
        let a = i - j.div_euclid(2);
        (a - j).rem_euclid(3) != 0
    } else {
        j % 2 != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::textures::tests_support::PARAMS;

    fn places(class: Class) -> Vec<Place> {
        let mut places = Vec::new();
        let area = MmRect::new(MmPoint::new(10.0, 20.0), MmPoint::new(110.0, 90.0));
        each_place(class, area, &PARAMS, |place| places.push(place));
        places
    }

    #[test]
    fn the_number_of_places_is_the_area_by_the_cell() {
        for (class, cell) in [
            (Class::Blue, PARAMS.along * PARAMS.across),
            (Class::Red, PARAMS.along * PARAMS.across),
            (Class::Grey, PARAMS.dot_pitch * PARAMS.dot_pitch * 0.75_f32.sqrt()),
        ] {
            let (count, want) = (places(class).len() as f32, 7000.0 / cell);
            assert!((count - want).abs() < 0.06 * want, "{class:?}: {count} places, the area has room for {want}");
        }
    }

    #[test]
    fn sparse_grey_is_a_hexagonal_lattice_again() {
        let sparse: Vec<MmPoint> = places(Class::Grey).into_iter().filter(|p| !p.dense_only).map(|p| p.at).collect();
        let pitch = PARAMS.dot_pitch * 3.0_f32.sqrt();
        let inner = |p: &&MmPoint| (20.0..100.0).contains(&p.x) && (30.0..80.0).contains(&p.y);
        for p in sparse.iter().filter(inner) {
            let near = sparse.iter().filter(|q| ((**q - *p).length() - pitch).abs() < 0.01).count();
            assert_eq!(near, 6, "around {p:?}");
        }
    }
}
