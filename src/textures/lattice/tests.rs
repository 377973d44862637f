//! Tests of `lattice`.

use super::*;

const PARAMS: Params = Params::TEST;

fn places(class: Class) -> Vec<LatticePoint> {
    let mut places = Vec::new();
    let area = MmRect::new(MmPoint::new(10.0, 20.0), MmPoint::new(150.0, 130.0));
    each_position(class, area, &PARAMS, |place| places.push(place));
    places
}

#[test]
fn the_number_of_places_is_the_area_by_the_cell() {
    for (class, cell) in [
        (Class::Blue, PARAMS.along * PARAMS.across),
        (Class::Red, PARAMS.along * PARAMS.across),
        (Class::Grey, PARAMS.dot_pitch * PARAMS.dot_pitch * 0.75_f32.sqrt()), // dots, filled or hollow
    ] {
        let (count, want) = (places(class).len() as f32, 140.0 * 110.0 / cell);
        assert!((count - want).abs() < 0.04 * want, "{class:?}: {count} places, the area has room for {want}");
    }
}

#[test]
fn density_fills_places_evenly() {
    for (class, filled) in [
        (Class::Green, vec![(0.0, 0.5), (0.49, 0.5), (0.5, 1.0), (1.0, 1.0)]),
        (Class::Grey, vec![(0.0, 3.0 / 9.0), (0.3, 4.0 / 9.0), (0.6, 5.0 / 9.0), (1.0, 6.0 / 9.0)]),
    ] {
        let places = places(class);
        for (density, want) in filled {
            let filled = places.iter().filter(|place| place.from_density <= density).count() as f32;
            let share = filled / places.len() as f32;
            assert!((share - want).abs() < 0.03, "{class:?} at density {density}: {share}, not {want}");
        }
    }
}

#[test]
fn grey_is_the_same_at_every_third_of_a_turn_at_every_density() {
    let all = places(Class::Grey);
    for thirds in 0..=3 {
        let filled: Vec<MmPoint> = all.iter().filter(|p| p.from_density <= thirds as f32 / 3.0).map(|p| p.at).collect();
        let is_filled = |at: MmPoint| filled.iter().any(|p| (*p - at).length() < 0.02);
        let inner = |p: &&MmPoint| (50.0..110.0).contains(&p.x) && (50.0..100.0).contains(&p.y);
        let (sin, cos) = 120.0_f32.to_radians().sin_cos();
        let turned = |p: MmPoint, about: MmPoint| {
            let v = p - about;
            about + MmVector::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
        };
        // about one of nine neighbouring places all others fall on one another
        let near = |p: &&MmPoint| (**p - MmPoint::new(80.0, 75.0)).length() < 3.2 * PARAMS.dot_pitch;
        let symmetric = |about: MmPoint| {
            filled.iter().filter(inner).filter(|p| (**p - about).length() < 24.0).all(|p| is_filled(turned(*p, about)))
        };
        let places: Vec<MmPoint> = all.iter().map(|p| p.at).collect();
        assert!(
            places.iter().filter(near).any(|about| symmetric(*about)),
            "{thirds} thirds of the distance to dense have no such centre"
        );
    }
}

#[test]
fn fading_takes_equal_shares_and_whole_rows() {
    for class in [Class::Yellow, Class::Grey] {
        let base: Vec<LatticePoint> = places(class).into_iter().filter(|place| place.from_density < 0.0).collect();
        for quarter in 1..4 {
            let left = base.iter().filter(|place| place.from_boldness <= quarter as f32 / 4.0).count() as f32;
            let share = left / base.len() as f32;
            assert!((share - quarter as f32 / 4.0).abs() < 0.1, "{class:?}: {share} at {quarter} quarters");
        }
    }
    for row in places(Class::Yellow).chunk_by(|a, b| (a.at.x - b.at.x).abs() < 0.01) {
        assert!(
            row.iter().all(|place| (place.from_boldness - row[0].from_boldness).abs() < 1e-6),
            "a row of yellow is thinned out"
        );
    }
}
