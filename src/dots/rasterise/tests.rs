//! Tests of `rasterise`.

use super::*;

fn grid() -> Grid {
    let even = |count: usize| (0..count).map(|i| 2.5 * i as f32).collect();
    Grid { columns: even(60), rows: even(60) }
}

fn at(x: f32, y: f32) -> MmPoint {
    MmPoint::new(2.5 * x, 2.5 * y)
}

fn ring(radius: f32, x: f32, y: f32) -> Vec<MmPoint> {
    let angle = |i: i32| (i % 180) as f32 * std::f32::consts::TAU / 180.0;
    (0..=180).map(|i| at(x + radius * angle(i).cos(), y + radius * angle(i).sin())).collect()
}

/// Each dot is a neighbour of the next and of no other than those before and after it.
fn is_one_dot_wide(cells: &[GridDot], closed: bool) -> bool {
    let n = cells.len();
    (0..n).all(|i| {
        (0..i).all(|j| {
            let steps = if closed { (i - j).min(n - (i - j)) } else { i - j };
            (distance(cells[i], cells[j]) <= 1) == (steps == 1)
        })
    })
}

#[test]
fn straight_lines_at_any_angle_are_one_dot_wide_and_near_the_line() {
    for degrees in 0..360 {
        let (sin, cos) = (degrees as f32).to_radians().sin_cos();
        for (x, y) in [(30.0, 30.0), (30.3, 29.6), (30.5, 30.5)] {
            let end = [x + 20.0 * cos, y + 20.0 * sin];
            let cells = rasterise(Polyline::open(vec![at(x, y), at(end[0], end[1])]).view(), &grid()).cells;
            assert!(is_one_dot_wide(&cells, false), "{degrees}: {cells:?}");
            assert!(cells.len() >= 14 && cells.len() <= 22, "{degrees}: {}", cells.len());
            for cell in cells {
                let aside = (cell[0] as f32 - x) * sin - (cell[1] as f32 - y) * cos;
                assert!(aside.abs() <= 0.72, "{degrees}: {cell:?} lies {aside} steps aside");
            }
        }
    }
}

#[test]
fn rings_close_and_are_one_dot_wide() {
    for tenth in 25..200 {
        for (x, y) in [(30.0, 30.0), (29.7, 30.2), (30.5, 30.5)] {
            let radius = tenth as f32 / 10.0;
            let cells = rasterise(Polyline::from_path(ring(radius, x, y)).view(), &grid()).cells;
            assert!(is_one_dot_wide(&cells, true), "radius {radius}: {cells:?}");
            for cell in &cells {
                let off = (cell[0] as f32 - x).hypot(cell[1] as f32 - y) - radius;
                assert!(off.abs() < 0.75, "radius {radius}: {cell:?} lies {off} steps off");
            }
        }
    }
}

#[test]
fn a_rectangle_keeps_its_corners() {
    let points = [at(10.0, 10.0), at(20.2, 10.0), at(20.2, 16.4), at(10.0, 16.4), at(10.0, 10.0)];
    let cells = rasterise(Polyline::from_path(points.to_vec()).view(), &grid()).cells;
    for corner in [[20, 10], [20, 16], [10, 16]] {
        assert!(cells.contains(&corner), "{corner:?} is not in {cells:?}");
    }
    assert_eq!(cells.len(), 32);
}

#[test]
fn a_box_has_all_its_corners_wherever_it_lies() {
    for (dx, dy) in (0..10).flat_map(|i| (0..10).map(move |k| (0.1 * i as f32, 0.1 * k as f32))) {
        let (first, last) = ([10.0 + dx, 10.0 + dy], [20.3 + dx, 16.4 + dy]);
        let corners = [[first[0], first[1]], [last[0], first[1]], [last[0], last[1]], [first[0], last[1]]];
        let vertices = corners.map(|[x, y]| at(x, y)).to_vec();
        for closed in [true, false] {
            let cells = rasterise(Polyline { vertices: vertices.clone(), closed }.view(), &grid()).cells;
            let missing = corners.iter().find(|corner| {
                let [x, y] = **corner;
                !cells.contains(&nearest(to_grid(at(x, y), &grid())))
            });
            assert!(missing.is_none(), "{missing:?} of {dx}, {dy}: {cells:?}");
        }
    }
}

#[test]
fn a_bar_whose_sides_were_found_in_parts_has_its_corners() {
    for (dx, dy) in (0..10).flat_map(|i| (0..10).map(move |k| (0.1 * i as f32, 0.1 * k as f32))) {
        let corners = [[10.0 + dx, 10.0 + dy], [16.3 + dx, 10.0 + dy]];
        let [left, right] = corners.map(|[x, _]| x);
        let sides = |x: f32| [at(x, 24.0), at(x, 11.2 + dy)];
        let [top_left, top_right] = corners.map(|[x, y]| at(x, y));
        let vertices = [sides(left).to_vec(), vec![top_left, top_right], sides(right).into_iter().rev().collect()];
        let cells = rasterise(Polyline::open(vertices.concat()).view(), &grid()).cells;
        let is_there = |[x, y]: [f32; 2]| cells.contains(&nearest(to_grid(at(x, y), &grid())));
        assert!(corners.into_iter().all(is_there), "{dx}, {dy}: {cells:?}");
    }
}

#[test]
fn a_sharp_corner_keeps_its_dot() {
    // 65 degrees, as where a coast meets a border, in all directions and begun at any of its corners
    for degrees in (0..360).step_by(7) {
        let side = |degrees: f32| MmPoint::new(40.0 * degrees.to_radians().cos(), 40.0 * degrees.to_radians().sin());
        let tip = at(30.2, 29.7);
        let corners = [0.0, 65.0].map(|turn| tip + side(degrees as f32 + turn).to_vector());
        let triangle = [tip, corners[0], corners[1]];
        for start in 0..3 {
            let vertices = (0..3).map(|k| triangle[(start + k) % 3]).collect();
            let line = Polyline { vertices, closed: true };
            let Rasterised { cells, sharp } = rasterise(line.view(), &grid());
            for corner in triangle {
                let corner = nearest(to_grid(corner, &grid()));
                assert!(cells.iter().any(|cell| distance(*cell, corner) == 0), "{degrees} {start}: {cells:?}");
            }
            let again = thin(cells.clone(), true, &sharp);
            assert_eq!(again, cells, "{degrees} {start}");
        }
    }
}

#[test]
fn a_spike_of_a_wavering_line_is_no_corner() {
    let line = Polyline::open(
        [(10.0, 20.4), (14.0, 20.4), (14.3, 21.1), (14.6, 20.4), (20.0, 20.4)].map(|(x, y)| at(x, y)).to_vec(),
    );
    let Rasterised { cells, sharp } = rasterise(line.view(), &grid());
    assert!(sharp.is_empty());
    assert!(cells.iter().all(|cell| cell[1] == 20), "{cells:?}");
}
