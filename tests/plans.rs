//! Any plan that the check accepts makes a page of any small picture, or says why not: no panic, whatever the numbers.
//!
//! `PROPTEST_CASES=2000 cargo test --release --test suite plans::` looks longer.

use std::sync::Arc;

use proptest::prelude::*;
use proptest::sample::select;
use tactograph::internals::output::dots::{DotMatrix, ubrl};
use tactograph::internals::output::{pdf, svg};
use tactograph::internals::pipeline::{Request, convert};
use tactograph::internals::profile::{Key, Plan, Profile, built_in};

/// A value of the key as it is written; numbers are often the ends of their range, and often small.
fn value(key: Key) -> BoxedStrategy<String> {
    if let Some(limits) = key.limits {
        let share = prop_oneof![Just(0.0_f32), Just(1.0), 0.0..1.0_f32, (0.0..1.0_f32).prop_map(|x| x * x * x)];
        let (low, high) = (limits.low, limits.high);
        return share.prop_map(move |share| (low + share * (high - low)).clamp(low, high).to_string()).boxed();
    }
    let words: Vec<String> = match key.range().as_str() {
        "true or false" => vec!["true".to_owned(), "false".to_owned()],
        _ if key.section() == "textures.palette" => {
            ["rhombus 0", "rhombus 45", "rhombus 90", "rhombus 135", "dot"].map(str::to_owned).to_vec()
        }
        // A choice is told as its words in quotes.
        range => range.split('"').skip(1).step_by(2).map(str::to_owned).collect(),
    };
    select(words).boxed()
}

fn setting() -> impl Strategy<Value = (&'static str, String)> {
    select(Profile::keys()).prop_flat_map(|key| value(key).prop_map(move |value| (key.path, value)))
}

/// A picture as a PPM file: a few rectangles of colour, and noise on half of them.
fn picture() -> impl Strategy<Value = Vec<u8>> {
    let rectangle = ((0..40_usize, 0..40_usize), (1..40_usize, 1..40_usize), any::<[u8; 3]>(), any::<u8>());
    (1..40_usize, 1..40_usize, prop::collection::vec(rectangle, 0..5)).prop_map(|(width, height, rectangles)| {
        let mut pixels = vec![[255; 3]; width * height];
        for ((left, top), (across, down), colour, noise) in rectangles {
            for (x, y) in (top..top + down).flat_map(|y| (left..left + across).map(move |x| (x, y))) {
                if x < width && y < height {
                    let grain = ((x * 31 + y * 17) * usize::from(noise / 128) * 7 % 61) as u8;
                    pixels[y * width + x] = colour.map(|value| value.saturating_sub(grain));
                }
            }
        }
        [format!("P6 {width} {height} 255\n").into_bytes(), pixels.concat()].concat()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_plan_that_is_accepted_converts_any_small_picture(
        base in select(built_in().iter().map(|file| file.name).collect::<Vec<_>>()),
        settings in prop::collection::vec(setting(), 0..6),
        picture in picture(),
    ) {
        let mut profile = Profile::named(base).expect("it is built in");
        // A value out of range at this key is refused on its own and leaves the profile as it was.
        let refused = settings.iter().filter(|(key, value)| profile.set(key, value).is_err()).count();
        prop_assert!(refused <= settings.len());
        if let Ok(plan) = Plan::new(&profile) {
            let fonts = || Arc::new(usvg::fontdb::Database::new());
            let request = Request {
                plan: &plan,
                limits: Default::default(),
                fonts: &fonts,
                title: "any",
                language: "en",
                fit: Default::default(),
                cancelled: &|| false,
            };
            // An error is an answer: nothing fits between these margins, say.
            if let Ok(drawing) = convert(&picture, &request, &mut |_| ()) {
                for page in [Some(&drawing.page), drawing.overview.as_ref()].into_iter().flatten() {
                    prop_assert!(svg::write(page).contains("</svg>"));
                    prop_assert!(!pdf::write(&page.title, std::slice::from_ref(page)).is_empty());
                    DotMatrix::of(page).iter().for_each(|matrix| drop(ubrl::write(std::slice::from_ref(matrix))));
                }
            }
        }
    }
}

/// Few in `cargo test`, as many as `PROPTEST_CASES` says otherwise.
fn cases() -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(48)
}
