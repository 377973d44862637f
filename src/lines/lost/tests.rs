//! Tests of `lost`.

use super::*;
use crate::lines::faint::weaken;

fn line(from: (f32, f32), to: (f32, f32)) -> Polyline<Vertex> {
    let vertex = |(x, y): (f32, f32)| Vertex { at: MmPoint::new(x, y), strength: 20.0, width: 1.0, ..Vertex::TEST };
    let mut line = Polyline::open(vec![vertex(from), vertex(to)]);
    line.fill();
    line
}

#[test]
fn a_closed_line_that_lacks_a_piece_is_open_and_one_whose_border_another_has_is_not() {
    let side = |points: &[(f32, f32)], closed: bool| {
        let all = points.windows(2).map(|pair| line(pair[0], pair[1]).vertices);
        Polyline { vertices: all.flatten().collect(), closed }
    };
    let corners = [(20.0, 20.0), (50.0, 20.0), (50.0, 40.0), (20.0, 40.0), (20.0, 20.0)];
    let ring = side(&corners, true);
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 70.0));
    let gaps_of = |drawn: &[Polyline<Vertex>]| {
        let gaps = gaps(&[&ring], drawn.iter(), area, &Params::TEST);
        gaps.iter().map(|gap| (gap.length.round(), gap.extent.center().x.round())).collect::<Vec<_>>()
    };
    assert!(gaps_of(std::slice::from_ref(&ring)).is_empty());
    let open = [(32.0, 20.0), (20.0, 20.0), (20.0, 40.0), (50.0, 40.0), (50.0, 20.0), (44.0, 20.0)];
    // to a vertex or two
    assert_eq!(gaps_of(&[side(&open, false)]), [(11.0, 38.0)]);
    let [one, other] = [side(&corners[..3], false), side(&corners[2..], false)];
    assert!(gaps_of(&[one.clone(), other]).is_empty());
    assert!(gaps_of(&[side(&[(20.0, 21.0), (24.0, 21.0)], false)]).is_empty(), "it is gone");
}

/// Its tip is moved down from a beam.
#[test]
fn a_triangle_that_is_closed_has_no_gap_at_its_tip() {
    let path = |points: &[(f32, f32)], closed: bool| {
        let all = points.windows(2).map(|pair| line(pair[0], pair[1]).vertices);
        let mut vertices: Vec<Vertex> = all.flatten().collect();
        vertices.dedup_by(|a, b| (a.at - b.at).length() < 1e-3);
        Polyline { vertices, closed }
    };
    let beam = line((10.0, 10.0), (90.0, 10.0));
    let triangle = path(&[(50.0, 11.0), (62.0, 36.0), (38.0, 36.0), (50.0, 11.2)], true);
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 70.0));
    let gaps_of = |drawn: &[Polyline<Vertex>]| gaps(&[&beam, &triangle], drawn.iter(), area, &Params::TEST).len();
    // the beam covers less than two millimetres of it
    let lower = path(&[(50.0, 16.0), (61.0, 36.0), (39.0, 36.0), (50.0, 16.2)], true);
    assert_eq!(gaps_of(&[lower]), 0, "it is closed");
    let open = path(&[(51.0, 18.0), (61.0, 36.0), (39.0, 36.0), (49.0, 18.0)], false);
    assert_eq!(gaps_of(&[open]), 1, "its tip is open");
    let other = path(&[(52.0, 60.0), (60.0, 50.0), (40.0, 50.0), (52.0, 59.8)], true);
    let most = path(&[(57.0, 25.6), (62.0, 36.0), (38.0, 36.0), (45.0, 21.4)], false);
    assert_eq!(gaps_of(&[most, other]), 1, "another closed line does not close it");
}

/// A lamp of 10.8 mm, whose ring is drawn 0.2 mm farther in.
#[test]
fn the_ring_of_a_lamp_does_not_stand_for_the_cross_in_it() {
    let at = |degrees: f32, radius: f32| {
        let (y, x) = degrees.to_radians().sin_cos();
        (50.0 + radius * x, 40.0 + radius * y)
    };
    let ring = |radius: f32| {
        let vertex = |k: u16| line(at(37.5 + 15.0 * f32::from(k), radius), at(52.5 + 15.0 * f32::from(k), radius));
        Polyline { vertices: (0..24).map(|k| vertex(k).vertices[0]).collect(), closed: true }
    };
    let strokes = [(45.0, 225.0), (135.0, 315.0)].map(|(from, to)| line(at(from, 5.4), at(to, 5.4)));
    let (area, own) = (MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 70.0)), ring(5.4));
    let gone_beside = |drawn: &[Polyline<Vertex>]| {
        let lines = [&own, &strokes[0], &strokes[1]];
        gone(&lines, drawn.iter(), area, &Params::TEST).iter().map(|line| line.closed).collect::<Vec<_>>()
    };
    assert_eq!(gone_beside(&[ring(5.2)]), [false, false], "both strokes of the cross");
    let [one, other] = strokes.clone();
    assert!(gone_beside(&[ring(5.2), one, other]).is_empty());
}

#[test]
fn strokes_that_cross_or_meet_are_a_cross_and_those_side_by_side_are_none() {
    let stroke = |from: (f32, f32), to: (f32, f32)| [MmPoint::from(from), MmPoint::from(to)];
    let slanting = stroke((46.0, 46.0), (54.0, 54.0));
    let crosses = |from: (f32, f32), to: (f32, f32)| is_cross(slanting, stroke(from, to));
    assert!(crosses((46.0, 54.0), (54.0, 46.0)));
    assert!(crosses((50.5, 49.5), (54.0, 46.0)), "a half of the other stroke");
    assert!(!crosses((48.0, 46.0), (56.0, 54.0)), "side by side");
    assert!(!crosses((54.0, 50.0), (58.0, 46.0)), "far from it");
    assert!(!crosses((50.0, 50.0), (50.0, 50.0)), "a place");
    let [one, other] = diagonals(MmRect::from_points(slanting));
    assert!(one == slanting && is_cross(one, other));
}

#[test]
fn what_is_lost_is_told_with_its_length_and_its_place() {
    let area = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(100.0, 70.0));
    let (mut wanted, mut kept) = (LossTally::new(area), LossTally::new(area));
    wanted.add(&line((12.0, 12.0), (32.0, 12.0)));
    wanted.add(&line((80.0, 40.0), (95.0, 40.0)));
    kept.add(&line((12.0, 12.0), (32.0, 12.0)));
    let lost = wanted.lost(&kept);
    assert!((lost.lost - 15.0).abs() < 1e-3 && (lost.share() - 15.0 / 35.0).abs() < 1e-3, "{lost:?}");
    assert_eq!(lost.place_name(), Some("middle right"));
    let even = Lost { by_place: [2.0, 3.0, 3.0, 1.0, 0.0, 2.0, 1.0, 0.0, 1.0], ..lost.clone() };
    assert_eq!(even.place_name(), None);
    assert!((lost.keeping(0.5).lost - 25.0).abs() < 1e-3);
}

#[test]
fn contours_without_a_line_are_not_lost_where_there_are_to_be_few_shapes() {
    let area = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(100.0, 70.0));
    let mut wanted = LossTally::new(area);
    wanted.add(&line((12.0, 12.0), (32.0, 12.0)));
    let mut lost = Lost { rings: 2, ..wanted.lost(&LossTally::new(area)) };
    assert!(lost.share() > 0.99 && lost.place_name().is_some(), "{lost:?}");
    lost.lack_on_purpose();
    assert!(lost.share() < 0.01 && lost.place_name().is_none() && lost.rings == 2, "{lost:?}");
}

#[test]
fn what_a_grid_that_is_left_out_lacked_before_is_no_loss_of_others() {
    let area = MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(100.0, 70.0));
    let faint = |from: (f32, f32), to: (f32, f32)| weaken(line(from, to), &Params::TEST);
    let (mut wanted, mut kept) = (LossTally::new(area), LossTally::new(area));
    // of a gridline a part is drawn; of two other lines, one of them pale and slanted, nothing
    wanted.add(&faint((12.0, 12.0), (92.0, 12.0)));
    wanted.add(&line((80.0, 40.0), (95.0, 40.0)));
    wanted.add(&faint((40.0, 60.0), (46.0, 68.0)));
    wanted.add(&line((12.0, 30.0), (42.0, 30.0)));
    kept.add(&faint((12.0, 12.0), (62.0, 12.0)));
    kept.add(&line((12.0, 30.0), (42.0, 30.0)));
    let mut lost = wanted.lost(&kept);
    assert!((lost.lost - 55.0).abs() < 1e-3, "{lost:?}");
    lost.without_gridlines(1, 50.0);
    assert!((lost.lost - 25.0).abs() < 1e-3 && (lost.wanted - 55.0).abs() < 1e-3, "{lost:?}");
    assert_eq!(lost.place_name(), Some("middle right"));
}

#[test]
fn rings_that_are_lost_are_those_wanted_that_are_not_kept() {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 70.0));
    let ring = || Polyline { closed: true, ..line((20.0, 20.0), (40.0, 20.0)) };
    let (open, mut wanted, mut kept) = (line((10.0, 60.0), (90.0, 60.0)), LossTally::new(area), LossTally::new(area));
    [ring(), ring(), ring()].iter().for_each(|ring| wanted.add(ring));
    wanted.add(&open);
    assert_eq!(wanted.lost(&kept).rings, 3);
    kept.add(&ring());
    kept.add(&open);
    assert_eq!(wanted.lost(&kept).rings, 2);
    // the length of a part of a line says nothing of rings
    kept.add_where(&ring(), |_| true);
    assert_eq!(wanted.lost(&kept).rings, 2);
    kept.count_rings([&ring(), &open].into_iter());
    assert_eq!(wanted.lost(&kept).rings, 1);
    kept.count_rings([&ring(), &ring()].into_iter());
    assert_eq!(wanted.lost(&kept).rings, 0, "more are there than were wanted");
}
