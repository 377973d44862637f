//! Tests of `weight`.

use super::*;

fn straight(strength: impl Fn(f32) -> f32) -> Line {
    let vertices = (0..=300)
        .map(|i| Vertex {
            at: MmPoint::new(i as f32 * 0.2, 5.0),
            strength: strength(i as f32 * 0.2),
            contrast: [1.0, 0.0, 0.0],
            ..Vertex::TEST
        })
        .collect();
    let mut polyline = Polyline::open(vertices);
    assign(&mut polyline, &Params::TEST);
    finish(&polyline, &[false; 301], &Params::TEST).expect("there is a line")
}

#[test]
fn width_saturates_early_and_never_falls() {
    let widths: Vec<f32> = (0..100).map(|s| width(s as f32, &Params::TEST)).collect();
    assert!(widths.is_sorted());
    assert!((widths[7] - 0.75).abs() < 1e-6 && (widths[30] - 1.5).abs() < 1e-6 && (widths[99] - 1.5).abs() < 1e-6);
}

#[test]
fn a_fading_edge_is_drawn_in_runs_that_touch_and_thin_out() {
    let line = straight(|x| 40.0 - 0.5 * x);
    assert!(line.runs.len() > 4);
    for pair in line.runs.windows(2) {
        assert_eq!(pair[0].points.last(), pair[1].points.first());
        assert!(pair[0].width > pair[1].width);
    }
    assert!((line.length() - 60.0).abs() < 0.01);
}

#[test]
fn a_fading_edge_ends_at_the_least_width() {
    for fade in [4.0, 8.0, 20.0] {
        let line = straight(|x| 7.0 + 40.0 * ((60.0 - x) / fade).min(1.0));
        let last = line.runs.last().expect("a run").width;
        assert!(last <= Params::TEST.width_min + STEP + 1e-4, "fading over {fade} mm it ends {last} mm wide");
        assert!(line.runs.windows(2).all(|pair| pair[0].width > pair[1].width), "fading over {fade} mm");
    }
}

#[test]
fn a_weak_spot_does_not_make_a_line_twitch() {
    let line = straight(|x| if (30.0..30.6).contains(&x) { 12.0 } else { 60.0 });
    assert!(line.runs.iter().all(|run| run.width > 1.2), "{:?}", line.runs);
    let inner = &line.runs[1..line.runs.len().max(2) - 1];
    assert!(inner.iter().all(|run| run.polyline().length() >= MIN_RUN - 0.21));
}
