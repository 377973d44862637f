//! Tests of `copies`: triangles of 12 px that point to the right, each with its tip at a place.

use super::*;

const SIZE: Size = Size::new(160, 60);

/// Black triangles and shafts of so many px on white.
fn picture(tips: &[([f32; 2], f32)]) -> Plane {
    let value = |cell: usize| {
        let (x, y) = ((cell % 160) as f32 + 0.5, (cell / 160) as f32 + 0.5);
        let is_ink = tips.iter().any(|([tip_x, tip_y], shaft)| {
            let (before, aside) = (tip_x - x, (y - tip_y).abs());
            (0.0..=12.0).contains(&before) && aside <= 0.5 * before
                || (12.0..=12.0 + shaft).contains(&before) && aside <= 1.0
        });
        if is_ink { 0.0 } else { 100.0 }
    };
    Plane { size: SIZE, values: (0..SIZE.len()).map(value).collect() }
}

fn head(x: f32, y: f32) -> FilledHead {
    FilledHead {
        apex: PxPoint::new(x, y),
        base: PxPoint::new(x - 12.0, y),
        half_width: 6.0,
        shaft: 2.0,
        ground: [100.0, 0.0, 0.0],
        ink: [-100.0, 0.0, 0.0],
        line: None,
    }
}

#[test]
fn triangles_like_a_head_are_counted_and_those_with_a_shaft_are_told_apart() {
    let of = |others: &[([f32; 2], f32)], heads: &[FilledHead]| {
        let all: Vec<_> = others.iter().chain([&([50.0, 30.0], 30.0)]).copied().collect();
        Copies::of_each(heads, &[picture(&all)])[0]
    };
    let alone = [head(50.0, 30.0)];
    assert_eq!(of(&[], &alone), Copies { all: 0, without_shaft: 0 });
    assert_eq!(of(&[([90.0, 20.0], 0.0)], &alone), Copies { all: 1, without_shaft: 1 });
    assert_eq!(of(&[([110.0, 20.0], 30.0)], &alone), Copies { all: 1, without_shaft: 0 });
    assert_eq!(of(&[([90.0, 20.0], 0.0), ([140.0, 40.0], 30.0)], &alone), Copies { all: 2, without_shaft: 1 });
    assert_eq!(of(&[([90.0, 50.0], 6.0)], &alone), Copies { all: 1, without_shaft: 0 }, "a short one");
    let both = [head(50.0, 30.0), head(110.0, 20.0)];
    assert_eq!(of(&[([110.0, 20.0], 30.0)], &both), Copies { all: 0, without_shaft: 0 }, "the other is a head");
}

#[test]
fn a_triangle_to_which_dashes_lead_counts_as_no_sign() {
    let copies_of = |dashes: &[(f32, f32)]| {
        let mut plane = picture(&[([50.0, 15.0], 30.0), ([120.0, 40.0], 0.0)]);
        for &(from, to) in dashes {
            let [first, end] = [108.0 - to, 108.0 - from].map(|x: f32| 39 * 160 + x as usize);
            plane.values[first..end].fill(0.0);
        }
        Copies::of_each(&[head(50.0, 15.0)], &[plane])[0]
    };
    for gap in 0..=8 {
        let gap = gap as f32;
        let dashes = [(gap, gap + 8.0), (gap + 14.0, gap + 22.0)];
        assert_eq!(copies_of(&dashes), Copies { all: 0, without_shaft: 0 }, "{gap}");
        assert_eq!(copies_of(&[(gap + 24.0, gap + 34.0)]), Copies { all: 1, without_shaft: 1 }, "{gap}");
    }
    assert_eq!(copies_of(&[(0.0, 40.0)]), Copies { all: 1, without_shaft: 0 }, "no dashes");
    assert_eq!(copies_of(&[(4.0, 5.0), (14.0, 15.0)]), Copies { all: 1, without_shaft: 0 }, "little ink");
}
