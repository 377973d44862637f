//! Tests of `hue`.

use super::*;

const PARAMS: Params = Params::TEST;

#[test]
fn the_corrected_hue_never_runs_backwards() {
    for value in [0.15, 0.4, 0.7, 1.0] {
        for saturation in [0.1, 0.4, 1.0] {
            let hue = |tenth| corrected(tenth as f32 / 10.0, saturation, value);
            let hues: Vec<f32> = (0..3600).map(hue).collect();
            assert!(hues.is_sorted(), "at value {value}");
        }
    }
}

fn rgb_of(hue: f32, saturation: f32, value: f32) -> [f32; 3] {
    [5.0, 3.0, 1.0].map(|n| {
        let k = (n + hue / 60.0) % 6.0;
        value - value * saturation * k.min(4.0 - k).clamp(0.0, 1.0)
    })
}

/// A step of one code value of 255 changes no membership by more than a fifth, and that only in dark colours, where
/// the hue turns by many degrees from one code value to the next.
#[test]
fn memberships_are_continuous() {
    let step = 1.0 / 255.0;
    let mut worst = 0.0_f32;
    for hue in (0..360).step_by(4) {
        for saturation in 0..=20 {
            for value in 0..=20 {
                let rgb = rgb_of(hue as f32, saturation as f32 / 20.0, value as f32 / 20.0);
                for channel in 0..3 {
                    let mut near = rgb;
                    near[channel] = (near[channel] + step).min(1.0);
                    let (a, b) = (membership(rgb, &PARAMS).parts(), membership(near, &PARAMS).parts());
                    let jump = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                    worst = worst.max(jump);
                }
            }
        }
    }
    assert!(worst < 0.2, "a share jumps by {worst}");
}

#[test]
fn shares_add_up_to_one_and_agree_with_the_class() {
    for hue in 0..360 {
        for (saturation, value) in [(0.0, 0.5), (0.2, 0.9), (0.3, 0.5), (0.7, 0.3), (1.0, 1.0), (0.05, 0.99)] {
            let rgb = rgb_of(hue as f32, saturation, value);
            let membership = membership(rgb, &PARAMS);
            let labels = || [None].into_iter().chain(Class::ALL.map(Some));
            let sum: f32 = labels().map(|label| membership.share(label)).sum();
            assert!((sum - 1.0).abs() < 1e-5, "{hue} {saturation} {value}: {sum}");
            assert!(membership.parts().iter().all(|part| (0.0..=1.0).contains(part)));
            let most = labels().find(|label| membership.share(*label) > 0.5 + 1e-4);
            assert!(most.is_none_or(|label| label == membership.label()), "{hue} {saturation} {value}");
        }
    }
}

#[test]
fn colours_between_two_classes_lean_to_the_other() {
    use Class::{Blue, Green, Grey, Red, Yellow};
    for (name, rgb, class, leaning_to) in [
        ("red", 0xff0000, Red, None),
        ("orange red", 0xff4500, Red, Some(Yellow)),
        ("magenta", 0xff00ff, Red, Some(Blue)),
        ("yellow", 0xffff00, Yellow, None),
        ("dark orange", 0xff8c00, Yellow, Some(Red)),
        ("green", 0x008000, Green, None),
        ("chartreuse", 0x7fff00, Green, Some(Yellow)),
        ("spring green", 0x00ff7f, Green, Some(Blue)),
        ("blue", 0x0000ff, Blue, None),
        ("sky blue", 0x87ceeb, Blue, None),
        ("cyan", 0x00ffff, Blue, Some(Green)),
        ("blue violet", 0x8a2be2, Blue, Some(Red)),
    ] {
        let rgb = [16, 8, 0].map(|shift: u32| (rgb >> shift & 0xff) as f32 / 255.0);
        assert_eq!((class_of(rgb, &PARAMS), leaning(rgb, class)), (Some(class), leaning_to), "{name}");
    }
    assert_eq!(leaning([0.5, 0.4, 0.4], Grey), None);
}
