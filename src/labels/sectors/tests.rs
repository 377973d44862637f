//! Tests of `sectors`.

use super::*;
use crate::geom::polygon::circle_points;
use crate::labels::Params;
use crate::labels::surroundings::LabelsAt;
use crate::page::{Class, Glyph, Line, Run, Shape, Sign, Texture};

/// Whether a label in a place would blank the texture around a text in the left half of a disc of 80 mm, which is
/// split into two halves or whole. Signs are 4 mm apart.
fn is_blanked_in(is_split: bool, dot_pitch: f32, text: &str, place: MmRect) -> bool {
    let middle = MmPoint::new(100.0, 100.0);
    let line = |points: Vec<MmPoint>, closed: bool| Line {
        strength: 50.0,
        runs: vec![Run { closed, ..Run::stroke(1.0, points) }],
    };
    let border = line(vec![MmPoint::new(100.0, 60.0), MmPoint::new(100.0, 140.0)], false);
    let circle = line(circle_points(middle, 40.0, 90).collect(), true);
    let lines: Vec<Line> = std::iter::once(circle).chain(is_split.then_some(border)).collect();
    let texture = |from: f32, to: f32| {
        let all = (0..400_u32).map(|k| MmPoint::new(62.0 + 4.0 * (k % 20) as f32, 62.0 + 4.0 * (k / 20) as f32));
        let inside = all.filter(|at| (*at - middle).length() < 36.0 && (from..to).contains(&at.x));
        let glyphs: Vec<Glyph> = inside.map(|at| Glyph { at, shape: Shape::Dot { diameter: 1.0 } }).collect();
        let area = 16.0 * glyphs.len() as f32;
        Texture { class: Class::Grey, sign: Sign::Dot, colour: [120; 3], area, glyphs }
    };
    let textures = if is_split { vec![texture(0.0, 96.0), texture(104.0, 200.0)] } else { vec![texture(0.0, 200.0)] };
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(200.0, 200.0));
    let params = Params { dot_pitch, ..Params::of_test(area) };
    let room = Room::new(&lines, &textures, &params);
    let anchors = [MmRect::new(MmPoint::new(74.0, 97.0), MmPoint::new(84.0, 103.0))];
    let wanted = [Wanted {
        text: text.to_owned(),
        anchor: anchors[0],
        lost_leader: None,
        kept_leader: None,
        is_nameless: false,
    }];
    let mut around = [Surroundings::of(0, LabelsAt { wanted: &wanted, anchors: &anchors }, 20.0, &room, &params)];
    look(&mut around, &wanted);
    around[0].is_blanked_by(room.glyphs(place.inflate(3.0, 3.0)))
}

/// The same in print.
fn is_blanked(is_split: bool, text: &str, place: MmRect) -> bool {
    is_blanked_in(is_split, 0.0, text, place)
}

#[test]
fn a_label_that_takes_more_than_a_third_of_its_sector_blanks_it() {
    let place = |from: (f32, f32), to: (f32, f32)| MmRect::new(from.into(), to.into());
    let large = place((70.0, 88.0), (92.0, 112.0));
    assert!(is_blanked(true, "Bus", large), "about 56 of 109 signs");
    assert!(!is_blanked(true, "Bus", place((76.0, 97.0), (84.0, 103.0))), "about 16");
    assert!(is_blanked(true, "25 %", large), "a share");
    assert!(!is_blanked(true, "25", large), "a number");
    assert!(!is_blanked(false, "Bus", place((70.0, 70.0), (130.0, 130.0))), "no other is beside it");
}

#[test]
fn on_dots_less_is_too_much_as_strips_beside_the_label_go_too() {
    let place = |from: (f32, f32), to: (f32, f32)| MmRect::new(from.into(), to.into());
    let middling = place((70.0, 96.5), (90.0, 103.5));
    assert!(is_blanked_in(true, 2.0, "Bus", middling), "24 of 109 signs");
    assert!(!is_blanked(true, "Bus", middling));
    assert!(!is_blanked_in(true, 2.0, "Bus", place((76.0, 97.0), (84.0, 103.0))), "about 16");
}
