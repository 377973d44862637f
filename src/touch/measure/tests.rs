//! Tests of `measure`.

use super::*;

/// Waves of a wavelength in mm whose crests run along `degrees`, ink 0 to 0.3.
fn waves(degrees: f32, wavelength: f32) -> Plane {
    let side = 60 * PX_PER_MM;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let value = |i: u32| {
        let (x, y) = ((i % side) as f32 / PX_PER_MM as f32, (i / side) as f32 / PX_PER_MM as f32);
        0.15 + 0.15 * (std::f32::consts::TAU * (x * sin + y * cos) / wavelength).cos()
    };
    Plane { size: Size::new(side, side), values: (0..side * side).map(value).collect() }
}

fn middle(feels: &Feels) -> Feel {
    feels.cells[(feels.size.height / 2 * feels.size.width + feels.size.width / 2) as usize]
}

#[test]
fn the_direction_of_waves_is_felt_as_a_reader_sees_it() {
    for degrees in [0.0, 20.0, 45.0, 90.0, 110.0, 135.0, 170.0] {
        for finger in [0.5, 1.0, 1.5] {
            let felt = middle(&feel(&waves(degrees, 3.6), finger));
            let off = (felt.degrees - degrees + 90.0).rem_euclid(180.0) - 90.0;
            assert!(off.abs() < 1.0, "{degrees} degrees are felt as {}", felt.degrees);
            assert!((felt.ink - 0.15).abs() < 0.002, "ink {}", felt.ink);
        }
    }
}

#[test]
fn coherence_is_what_the_formula_gives_for_a_wave() {
    // slope a k / sqrt 2 of a wave of amplitude a, less by the blur and the window's own; exact for a single wave
    let k = std::f32::consts::TAU / 3.6;
    for finger in [0.5_f32, 1.0, 1.5] {
        let amplitude = 0.15 * (-0.5 * (k * finger).powi(2)).exp() * (1.0 - (-0.5 * (k * WINDOW).powi(2)).exp());
        let energy = 0.5 * (amplitude * k).powi(2);
        let want = energy / (energy + (FAINT * 0.15 / finger).powi(2));
        let got = middle(&feel(&waves(30.0, 3.6), finger)).coherence;
        assert!((got - want).abs() < 0.02, "a fingertip of {finger}: {got}, not {want}");
    }
}

#[test]
fn the_threshold_is_the_measured_one_at_the_measured_sizes() {
    for (finger, want) in [(0.2, 0.12), (0.5, 0.12), (0.75, 0.21), (1.0, 0.30), (1.5, 0.35), (3.0, 0.35)] {
        assert!((directed_from(finger) - want).abs() < 1e-6);
    }
}
