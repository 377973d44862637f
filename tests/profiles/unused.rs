//! Keys that do not count on a page: changing one of them moves no mark, and the page does not record it.

use tactograph::internals::page::{Page, Parts};
use tactograph::internals::profile::{Key, Profile, Value, built_in};

use crate::common::page::page_for;
use crate::profiles::named;

/// Shapes in all five colours on white, 96 x 72 pixels, so that a page of it takes some milliseconds.
fn picture() -> Vec<u8> {
    const COLOURS: [[u8; 3]; 5] = [[20, 60, 200], [20, 140, 40], [240, 220, 20], [200, 20, 20], [90, 90, 90]];
    let pixel = |x: usize, y: usize| {
        let (column, row) = (x / 32, y / 36);
        let is_inside = (4..28).contains(&(x % 32)) && (4..32).contains(&(y % 36));
        if is_inside { COLOURS.get(3 * row + column).copied().unwrap_or([255; 3]) } else { [255; 3] }
    };
    let pixels: Vec<u8> = (0..72).flat_map(|y| (0..96).flat_map(move |x| pixel(x, y))).collect();
    [b"P6 96 72 255\n", &pixels[..]].concat()
}

/// The pages of the picture, without what they say of how they were made.
fn marks(profile: &Profile) -> Vec<Parts> {
    let drawing = page_for(&picture(), "picture", profile, &mut |_| ());
    let pages = [Some(drawing.page), drawing.overview];
    pages.into_iter().flatten().map(|page| Parts { origin: Vec::new(), ..Parts::clone(&page) }).collect()
}

/// The keys of a page's record, in words.
fn recorded(profile: &Profile) -> Vec<String> {
    let page: Page = page_for(&picture(), "picture", profile, &mut |_| ()).page;
    page.origin.iter().map(|(name, _)| name.clone()).collect()
}

/// The profile with another value for a key, as far from the old one as its rules allow.
fn changed(profile: &Profile, key: &Key) -> Profile {
    let Value::Number(value) = key.value(profile) else { panic!("{} is no number", key.path) };
    let limits = key.limits.expect("a number has a range");
    let others = [2.0 * value, 0.5 * value, 1.3 * value, 0.8 * value, value + 0.1, value - 0.1];
    let others = others.into_iter().map(|other| (10.0 * other).round() / 10.0);
    let mut profiles = others.filter(|other| (limits.low..=limits.high).contains(other)).filter_map(|other| {
        let mut changed = profile.clone();
        changed.set(key.path, other).expect("it is in the range");
        (key.value(&changed) != key.value(profile) && changed.check().is_ok()).then_some(changed)
    });
    profiles.next().unwrap_or_else(|| panic!("{}: no other value for {}", profile.name, key.path))
}

#[test]
fn keys_that_do_not_count_move_no_mark_and_are_not_recorded() {
    for file in built_in() {
        let profile = named(file.name);
        let (plain, record) = (marks(&profile), recorded(&profile));
        let mut count = 0;
        // keys of braille are recorded where anything is written in it
        let has_number = |key: &&Key| key.limits.is_some() && !key.path.starts_with("braille.");
        for key in Profile::keys().iter().filter(has_number) {
            let mut given = profile.clone();
            given.set(key.path, key.value(&profile)).expect("it has this value");
            let is_told = given.unused().iter().any(|fault| fault.what.starts_with(key.path));
            assert_eq!(is_told, !record.iter().any(|name| name == key.path), "{}: {}", file.name, key.path);
            if is_told {
                count += 1;
                assert!(marks(&changed(&profile, key)) == plain, "{}: {} moves a mark", file.name, key.path);
            }
        }
        assert!(count >= 4, "{}: only {count} keys that do not count", file.name);
    }
}
