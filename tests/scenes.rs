//! Drawn scenes with a known truth: the height of a step, its place, the middle of a pen stroke, which of two lines stays.

use crate::common::drawn::LINES;
use tactograph::internals::edges::{self, Edges};
use tactograph::internals::lines::{self, Line};
use tactograph::internals::raster::Raster;
use tactograph::internals::units::{MmPoint, MmRect, PageTransform, Size};

const SIDE: u32 = 300;
/// Millimetres for a pixel: the scene is 100 mm wide.
const SCALE: f32 = 1.0 / 3.0;

/// A grey picture of `lightness(x, y)`, 0..=100 as pictures store it, at pixel centres.
fn picture(lightness: impl Fn(f32, f32) -> f32) -> Raster {
    let size = Size::new(SIDE, SIDE);
    let linear = |l: f32| ((l / 100.0 + 0.055) / 1.055).powf(2.4); // all scenes are lighter than where sRGB turns straight
    let values = (0..SIDE * SIDE).map(|i| linear(lightness((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5)));
    Raster::grey(size, values.collect())
}

fn edge_params(sigma: f32) -> edges::Params {
    edges::Params {
        sigma,
        low: 5.0,
        high: 10.0,
        min_length: 5.0,
        min_length_of_drawing: 5.0,
        strength_window: 3.0,
        suppression: 1.0,
        side_cell: 3.0,
        side_offset: 6.6,
        widest_stroke: 19.0,
        dark_lines: None,
    }
}

fn draw(raster: &Raster) -> Vec<Line> {
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(SIDE as f32 * SCALE, SIDE as f32 * SCALE));
    lines::draw(&edges::find(raster, &edge_params(1.5)), &PageTransform::new(raster.size(), area), area, &LINES).lines
}

/// A step blurred by `blur`, as share 0..=1 of the way from one side to the other: logistic, near a Gaussian's integral.
fn step(distance: f32, blur: f32) -> f32 {
    1.0 / (1.0 + (-1.702 * distance / blur).exp())
}

/// Signed distance of a pixel from the line through the middle of the scene at `degrees`.
fn across(degrees: f32, x: f32, y: f32) -> f32 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    (x - 150.3) * -sin + (y - 149.6) * cos
}

/// Coverage of a pixel by a pen stroke of this width along the line at `degrees`, 200 px long.
fn stroke(degrees: f32, width: f32, x: f32, y: f32) -> f32 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let along = (x - 150.3) * cos + (y - 149.6) * sin;
    let outside = (across(degrees, x, y).abs() - 0.5 * width).max(along.abs() - 100.0);
    (0.5 - outside).clamp(0.0, 1.0).min(width)
}

#[test]
fn strength_is_the_height_of_the_step_at_any_angle_scale_and_blur() {
    for degrees in [0.0, 17.0, 30.0, 45.0, 63.0, 90.0] {
        for sigma in [1.2, 1.5, 2.5] {
            for blur in [0.7, 1.5, 2.5] {
                for height in [12.0, 40.0] {
                    let raster = picture(|x, y| 40.0 + height * step(across(degrees, x, y), blur));
                    let edges = edges::find(&raster, &edge_params(sigma));
                    let inner: Vec<_> = edges
                        .edgels
                        .iter()
                        .filter(|p| (20.0..280.0).contains(&p.at.x) && (20.0..280.0).contains(&p.at.y))
                        .collect();
                    assert!(inner.len() > 200, "{degrees} {sigma} {blur}: only {} points", inner.len());
                    let mean = inner.iter().map(|p| p.strength).sum::<f32>() / inner.len() as f32;
                    let scene =
                        format!("{degrees} degrees, sigma {sigma}, blur {blur}: {height} is measured as {mean}");
                    assert!((mean - height).abs() < 0.08 * height, "{scene}");
                }
            }
        }
    }
}

#[test]
fn edges_lie_where_the_step_is() {
    let error = |edges: &Edges, degrees: f32| {
        let inner = edges.edgels.iter().filter(|p| (20.0..280.0).contains(&p.at.x) && (20.0..280.0).contains(&p.at.y));
        let squares: Vec<f32> = inner.map(|p| across(degrees, p.at.x, p.at.y).powi(2)).collect();
        (squares.iter().sum::<f32>() / squares.len() as f32).sqrt()
    };
    for degrees in [0.0, 10.0, 25.0, 45.0, 70.0, 90.0] {
        let raster = picture(|x, y| 30.0 + 50.0 * step(across(degrees, x, y), 1.0));
        let rms = error(&edges::find(&raster, &edge_params(1.5)), degrees);
        assert!(rms < 0.03, "{degrees} degrees: {rms} px");
    }
}

#[test]
fn a_closed_contour_is_one_closed_line() {
    for radius in [12.0, 40.0, 120.0] {
        let raster = picture(|x, y| 30.0 + 50.0 * step(radius - (x - 150.3).hypot(y - 149.6), 0.8));
        let lines = draw(&raster);
        assert_eq!(lines.len(), 1, "radius {radius}");
        assert!(lines[0].runs.len() == 1 && lines[0].runs[0].closed, "radius {radius}: not closed");
        let length = std::f32::consts::TAU * radius * SCALE;
        assert!((lines[0].length() / length - 1.0).abs() < 0.03, "radius {radius}: {} for {length}", lines[0].length());
    }
}

#[test]
fn a_pen_stroke_is_one_line_along_its_middle() {
    for width in [1.5, 2.0, 3.0, 5.0, 8.0] {
        for degrees in [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0] {
            let lines = draw(&picture(|x, y| 95.0 - 75.0 * stroke(degrees, width, x, y)));
            let scene = format!("a stroke of {width} px at {degrees} degrees");
            assert_eq!(lines.len(), 1, "{scene} has {} lines", lines.len());
            for at in lines[0].runs.iter().flat_map(|run| &run.points) {
                let off = SCALE * across(degrees, at.x / SCALE, at.y / SCALE).abs();
                assert!(off < 0.7, "{scene}: {off} mm beside its middle");
            }
            let length = 200.0 * SCALE;
            assert!((lines[0].length() - length).abs() < 0.7, "{scene}: {} mm for {length}", lines[0].length());
        }
    }
}

#[test]
fn of_two_rivals_the_stronger_stays() {
    // a stair of two steps, 6 px (2 mm) apart: both go up, so this is no bar
    let raster = picture(|x, _| 30.0 + 15.0 * step(x - 147.0, 0.8) + 40.0 * step(x - 153.0, 0.8));
    let lines = draw(&raster);
    assert_eq!(lines.len(), 1);
    let points = lines[0].runs.iter().flat_map(|run| &run.points);
    points.for_each(|at| assert!((at.x / SCALE - 153.0).abs() < 1.5, "the weaker step stayed, at {}", at.x / SCALE));
}

#[test]
fn grass_is_quiet_and_the_path_through_it_stays() {
    // short strokes every way, and a higher step through the middle
    let hash = |i: i32, j: i32| ((i * 7919 + j * 104_729 + i * j * 31).rem_euclid(1000)) as f32 / 1000.0;
    let grass = |x: f32, y: f32| {
        let mut light = 0.0_f32;
        for i in (x / 8.0) as i32 - 1..=(x / 8.0) as i32 + 1 {
            for j in (y / 8.0) as i32 - 1..=(y / 8.0) as i32 + 1 {
                let (cx, cy) = (8.0 * (i as f32 + hash(i, j)), 8.0 * (j as f32 + hash(j + 57, i)));
                let (sin, cos) = (std::f32::consts::PI * hash(i + 91, j)).sin_cos();
                let (along, side) = ((x - cx) * cos + (y - cy) * sin, (y - cy) * cos - (x - cx) * sin);
                let outside = (side.abs() - 1.0).max(along.abs() - 5.0);
                light = light.max((0.5 - outside).clamp(0.0, 1.0));
            }
        }
        light
    };
    let meadow = picture(|x, y| 30.0 + 25.0 * grass(x, y));
    let path = picture(|x, y| 30.0 + 25.0 * grass(x, y) + 40.0 * step(x - 150.0, 1.0));
    let total = |lines: &[Line]| lines.iter().map(Line::length).sum::<f32>();
    let (quiet, with_path) = (total(&draw(&meadow)), total(&draw(&path)));
    let loud = edges::find(&meadow, &edges::Params { suppression: 0.0, ..edge_params(1.5) });
    let area = MmRect::new(MmPoint::zero(), MmPoint::new(100.0, 100.0));
    let without = total(&lines::draw(&loud, &PageTransform::new(meadow.size(), area), area, &LINES).lines);
    assert!(quiet < 0.2 * without, "{quiet} mm of lines in the grass, {without} mm without suppression");
    assert!(with_path > quiet + 50.0, "{with_path} mm with the path, {quiet} mm without");
}
