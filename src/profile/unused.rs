//! Keys that do not count on a page: a page of dots has the widths and signs of its device, and a printed page has no
//! grid.

use super::fault::Fault;
use super::keys::Profile;

/// A key that one kind of page does not look at.
struct Unused {
    path: &'static str,
    /// Why it does not count, and what does.
    why: &'static str,
}

/// On a page of dots.
const WITH_DOTS: &[Unused] = &[
    Unused { path: "frame.width", why: FRAME },
    Unused { path: "frame.dot", why: FRAME },
    Unused { path: "mark.width", why: "the bar is one row of dots; mark.length says how long it is" },
    Unused { path: "overview.gap", why: "the overview has a sheet to itself; overview.scale says how large it is" },
    Unused { path: "lines.width_min", why: WIDTH },
    Unused { path: "lines.width_max", why: WIDTH },
    Unused { path: "lines.min_gap", why: "gaps between lines are counted in dots; dots.line_gap says how many" },
    Unused { path: "textures.line_gap", why: "gaps are counted in dots; dots.texture_gap says how many" },
    Unused { path: "textures.along", why: TEXTURE },
    Unused { path: "textures.across", why: TEXTURE },
    Unused { path: "textures.length", why: TEXTURE },
    Unused { path: "textures.thickness", why: TEXTURE },
    Unused { path: "textures.dot", why: TEXTURE },
    Unused { path: "textures.dot_pitch", why: TEXTURE },
    Unused { path: "textures.min_glyph", why: TEXTURE },
    Unused { path: "braille.print", why: "dots print no letters; a page on paper has them" },
    Unused { path: "print.swell", why: "dots are pressed and do not swell; the device has their size" },
    Unused { path: "print.max_black", why: "paper with pressed dots does not curl" },
];
const FRAME: &str = "the frame is one row of the device's dots; frame.pitch says how far they are apart";
const WIDTH: &str =
    "a line is one row of the device's dots, or two; dots.heavy_from says from which strength it is two";
const TEXTURE: &str = "textures are rows of the device's dots; dots.pitch says how far dots are apart";

/// On a printed page.
const PRINTED: &[Unused] = &[
    Unused {
        path: "dots.pitch",
        why: "the page is printed; textures.along, across and dot_pitch are the pitches of textures",
    },
    Unused { path: "dots.line_gap", why: "the page is printed; lines.min_gap is the gap between lines" },
    Unused {
        path: "dots.texture_gap",
        why: "the page is printed; textures.line_gap is the gap between lines and textures",
    },
    Unused { path: "dots.texture_rows", why: "the page is printed; textures.min_glyph says what is too small" },
    Unused { path: "dots.heavy_from", why: "the page is printed; lines.full_strength says where lines are widest" },
];

impl Profile {
    /// The keys that the maker of this profile gave (in its own file, or by [`Profile::set`]) although they do not
    /// count on its pages, each with the place where it was given, why it does not count and what does instead.
    pub fn unused(&self) -> Vec<Fault> {
        let told = |unused: &Unused| {
            let place = self.own_place(unused.path)?;
            let page = if self.dots.device.is_some() { "a page of dots" } else { "a printed page" };
            let what = format!("{} does not count on {page}: {}", unused.path, unused.why);
            Some(Fault::of_keys(&[unused.path], place, what))
        };
        self.not_counting().iter().filter_map(told).collect()
    }

    /// [`Profile::parameters`] without the keys that do not count on its pages.
    pub(crate) fn counting_parameters(&self) -> impl Iterator<Item = (&'static str, String)> {
        let unused = self.not_counting();
        self.parameters().into_iter().filter(|(path, _)| unused.iter().all(|unused| unused.path != *path))
    }

    fn not_counting(&self) -> &'static [Unused] {
        if self.dots.device.is_some() { WITH_DOTS } else { PRINTED }
    }
}

/// The keys that do not count on one kind of page, as Markdown: what the page about keys says of them.
pub(super) fn listing() -> String {
    let mut text = String::new();
    for (page, keys) in [("a page of dots", WITH_DOTS), ("a printed page", PRINTED)] {
        text += &format!("\nOn {page}:\n\n");
        text.extend(keys.iter().map(|unused| format!("* `{}`: {}\n", unused.path, unused.why)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::keys::KEYS;
    use super::*;

    #[test]
    fn they_are_keys_that_exist() {
        let mut all = WITH_DOTS.iter().chain(PRINTED);
        assert!(all.all(|unused| KEYS.iter().any(|key| key.path == unused.path)));
    }
}
