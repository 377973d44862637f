//! Settings of every kind, and pictures with them.

use tactograph::{Key, Options, Picture, Profile, RenderOptions};

use super::is_clear;

/// Most pixels along a side of a picture.
const SIDE: u32 = 64;

/// A profile as a TOML file; what is accepted can be written and read again.
pub(super) fn profile(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Profile::from_toml(text, "own.toml") {
        Ok(profile) => {
            let again = Profile::from_toml(&profile.to_toml(), "again.toml").expect("what is written is read");
            assert_eq!(again.parameters(), profile.parameters());
            checked(&profile);
        }
        Err(fault) => is_clear(&fault),
    }
}

/// Settings as on a command line, one a line: `key=value`.
pub(super) fn set(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    for line in text.lines() {
        let (key, value) = line.split_once('=').unwrap_or((line, ""));
        let before = profile.parameters();
        if let Err(fault) = profile.set(key, value) {
            is_clear(&fault);
            assert_eq!(profile.parameters(), before, "a setting that is refused changes something");
        }
    }
    checked(&profile);
}

/// The faults of a profile are clear; one without faults makes calibration sheets or says why not.
fn checked(profile: &Profile) {
    let faults = [profile.check().err(), tactograph::calibrate(profile).err()];
    faults.iter().flatten().for_each(is_clear);
    let _ = profile.unused();
}

/// What a fuzzer takes from its bytes, one after the other; zeros when there are none left.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let (first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        *first
    }

    fn below(&mut self, count: usize) -> usize {
        (usize::from(self.next()) << 8 | usize::from(self.next())) % count
    }
}

/// A value of a key: `share` of the way through its range, or one of its words.
fn value(key: &Key, share: u8) -> String {
    if let Some(limits) = key.limits {
        let share = f32::from(share) / 255.0;
        return (limits.low + share * (limits.high - limits.low)).clamp(limits.low, limits.high).to_string();
    }
    let range = key.range();
    let words: Vec<&str> = match range.as_str() {
        "true or false" => vec!["true", "false"],
        _ if key.section() == "textures.palette" => {
            vec!["rhombus 0", "rhombus 45", "rhombus 90", "rhombus 135", "dot"]
        }
        // a choice is told as its words in quotes
        words => words.split('"').skip(1).step_by(2).collect(),
    };
    words.get(usize::from(share) % words.len().max(1)).map_or_else(String::new, |word| (*word).to_owned())
}

/// A picture of up to 64 x 64 px with a built-in profile and a few settings; the page that it makes is written, and
/// read again as it was.
pub(super) fn convert(bytes: &[u8]) {
    let mut bytes = Bytes(bytes);
    let named = &Profile::built_in()[bytes.below(Profile::built_in().len())];
    let mut profile = Profile::named(named.name).expect("it is built in");
    for _ in 0..bytes.next() % 8 {
        let key = &Profile::keys()[bytes.below(Profile::keys().len())];
        // a value of few kinds may go by no word that is known here
        let _ = profile.set(key.path, value(key, bytes.next()));
    }
    let [width, height] = [0; 2].map(|_: u32| 1 + u32::from(bytes.next()) % SIDE);
    let (palette, grain) = ([0; 4].map(|_: u8| [0; 4].map(|_: u8| bytes.next())), bytes.next());
    // two bits a pixel: large areas of a few colours are what pictures are made of; the rest is grain
    let pixel = |i: usize, bytes: &[u8]| -> [u8; 4] {
        let byte = bytes.get(i / 4 % bytes.len().max(1)).copied().unwrap_or(0);
        let colour = palette[usize::from(byte >> (i % 4 * 2) & 3)];
        if grain > 128 { colour.map(|value| value.wrapping_add(byte)) } else { colour }
    };
    let pixels: Vec<u8> = (0..(width * height) as usize).flat_map(|i| pixel(i, bytes.0)).collect();
    let picture = Picture::rgba8(width, height, &pixels).expect("so many bytes");
    let drawing = match tactograph::convert(picture, &Options::new(profile).title("Any")) {
        Ok(drawing) => drawing,
        Err(fault) => return is_clear(&fault),
    };
    for page in std::iter::once(&drawing.page).chain(&drawing.overview).chain(&drawing.key) {
        let svg = page.to_svg();
        match tactograph::render(&svg, &RenderOptions::new()) {
            Ok(read) => {
                let again = read.page.to_svg();
                let other = svg.lines().zip(again.lines()).find(|(written, read)| written != read);
                assert!(again == svg, "a page is not read as it was written: {other:?}");
            }
            Err(fault) => panic!("a page is not read: {fault}"),
        }
        assert!(!page.to_pdf().is_empty());
    }
}
