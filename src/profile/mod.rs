//! What the maker of a page can choose: a profile as it is written, read with all its faults at once.
//!
//! A profile is a TOML file with one section for each part of the page. `inherits = "swell-a4"` takes every key that is
//! not given from a built-in profile; without it, every key must be given. A section with a key `on` can be replaced by
//! `true` or `false`: `overview = false`.

mod built_in;
mod check;
mod device;
mod inherit;
mod key;
mod keys;
pub mod manual;
mod parse;
mod plan;
mod suggest;
mod syntax;

pub use built_in::{BuiltIn, built_in};
pub use key::{Key, Kind, Value};
pub use keys::{
    ColoursSettings, EdgesSettings, FigureSettings, FrameSettings, LinesSettings, MarkSettings, OverviewSettings,
    PageSettings, PaletteSettings, PrintSettings, Profile, SheetsSettings, TexturesSettings,
};
pub use plan::Plan;

/// One fault in a profile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Where: a file's name and line, or the option.
    pub place: String,
    /// What is wrong and what would do.
    pub what: String,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.place, self.what)
    }
}

pub(crate) fn faults_in_one_line(faults: &[Fault]) -> String {
    faults.iter().map(Fault::to_string).collect::<Vec<_>>().join("; ")
}

/// A fault in a text whose name is not known yet.
#[derive(Debug)]
struct Found {
    /// Counted from 1.
    line: usize,
    what: String,
}

impl Found {
    fn new(line: usize, what: String) -> Self {
        Self { line, what }
    }
}

/// Where a key got its value.
#[derive(Debug, Clone, Default)]
struct Origin {
    /// Which value was given before which: 0 for none at all, then counted up.
    order: usize,
    /// Whether the value was taken; a refused one is in no rule.
    held: bool,
    place: String,
}

impl Profile {
    /// Every key there is, in a fixed order.
    pub fn keys() -> &'static [Key] {
        keys::KEYS
    }

    /// The built-in profile of this name.
    ///
    /// # Errors
    /// When there is none, with the names that there are.
    pub fn named(name: &str) -> Result<Self, Vec<Fault>> {
        let Some(text) = built_in::text_of(name) else {
            let place = format!("profile {}", suggest::quoted_path(&[name]));
            return Err(vec![Fault { place, what: suggest::unknown_profile(name) }]);
        };
        inherit::load(text, &format!("{name}.toml"), Some(name), &built_in::text_of)
    }

    /// Reads a profile. `place` is the file's name as the messages shall give it; the profile is called by its last
    /// part without `.toml`. The text may inherit any built-in profile.
    ///
    /// # Errors
    /// Every fault with its line: mistakes in the TOML, unknown keys, wrong kinds, values out of range, keys missing
    /// where nothing is inherited, and values that do not go together.
    pub fn from_toml(text: &str, place: &str) -> Result<Self, Vec<Fault>> {
        inherit::load(text, place, None, &built_in::text_of)
    }

    /// What a key holds, by its path, such as `lines.width_max`.
    pub fn get(&self, path: &str) -> Option<Value> {
        keys::KEYS.iter().find(|key| key.path == path).map(|key| key.value(self))
    }

    /// Gives one key another value, as `--set key=value` does. A section with a key `on` may stand for that key.
    /// Whether the values still go together is for [`Profile::check`] to say, after the last `set`.
    ///
    /// # Errors
    /// When there is no such key, or the value is not of its kind or not in its range; then nothing is changed.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), Fault> {
        let (key, value) = (key.trim(), value.trim());
        let place = format!("--set {}={}", suggest::quoted_path(&[key]), suggest::quoted_path(&[value]));
        let fail = |what| Err(Fault { place: place.clone(), what });
        let known = |parts: &(&str, &str)| keys::SECTIONS.contains(&parts.0) && !keys::SECTIONS.contains(&key);
        let found = match key.rsplit_once('.').filter(known).or_else(|| key.split_once('.')) {
            _ if key.contains('.') && keys::SECTIONS.contains(&key) => Err(suggest::section_alone(key)),
            Some((section, name)) if keys::SECTIONS.contains(&section) => {
                parse::position(section, name).ok_or_else(|| suggest::unknown_key(section, name))
            }
            Some((section, _)) => Err(suggest::unknown_section(section, &[])),
            None if keys::SECTIONS.contains(&key) => parse::switch_of(key).ok_or_else(|| suggest::section_alone(key)),
            None => Err(suggest::unknown_section(key, &[])),
        };
        let index = match found {
            Ok(index) => index,
            Err(what) => return fail(what),
        };
        let key = &keys::KEYS[index];
        match key.read(value) {
            Some(value) if key.takes(value) => {
                key.put(self, value);
                let order = 1 + self.origins.iter().map(|origin| origin.order).max().unwrap_or(0);
                self.origins[index] = Origin { order, held: true, place };
                Ok(())
            }
            _ => fail(key.refuse(&suggest::quoted_path(&[value]))),
        }
    }

    /// Every parameter as (path, value), in the order of [`Profile::keys`]; numbers are the shortest decimals that read
    /// back as the same.
    pub fn parameters(&self) -> Vec<(&'static str, String)> {
        keys::KEYS.iter().map(|key| (key.path, key.value(self).to_string())).collect()
    }
}
