//! What the maker of a page can choose: a profile as it is written, read with all its faults at once.
//!
//! A profile is a TOML file with one section for each part of the page. `inherits = "swell-a4"` takes every key that is
//! not given from a built-in profile, `inherits = "our-school.toml"` from another file; without it, every key must be
//! given. A section with a key `on` can be replaced by `true` or `false`: `overview = false`.

mod built_in;
mod check;
mod device;
mod fault;
mod inherit;
mod keys;
mod kind;
mod manual;
mod nearest;
mod parse;
mod plan;
mod resolved;
mod suggest;
mod syntax;
mod unused;

pub use built_in::{BuiltIn, built_in};
pub use fault::Fault;
pub(crate) use fault::{faults_in_one_line, quoted};
pub use keys::{
    BrailleSettings, ColoursSettings, EdgesSettings, FigureSettings, FrameSettings, Key, LinesSettings, MarkSettings,
    OverviewSettings, PageSettings, PaletteSettings, PrintSettings, Profile, SheetsSettings, TexturesSettings,
};
pub use kind::{NumberRange, Value};
pub(crate) use nearest::{did_you_mean, nearest};
pub use plan::Plan;

use crate::listing::first_few;
use crate::{About, Error, Note, Reason};
use inherit::ProfileOrigin;

/// Most values of a page's profile that are not taken and are told one by one.
const MOST_REFUSED: usize = 5;

impl Profile {
    /// Every key there is, in a fixed order.
    pub fn keys() -> &'static [Key] {
        keys::KEYS
    }

    /// The profiles that come with the library; the first is the one to use when none is asked for.
    pub fn built_in() -> &'static [BuiltIn] {
        built_in::built_in()
    }

    /// Whether a profile's name is the path of a file: it ends in `.toml`, or has a folder in it.
    pub fn is_path(name: &str) -> bool {
        built_in::is_path(name)
    }

    /// The built-in profile of this name, such as `swell-a4`.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the names that there are, and the nearest of them.
    pub fn named(name: &str) -> Result<Self, Error> {
        let text = built_in::text_of(name).ok_or_else(|| suggest::unknown_profile(name))?;
        Ok(inherit::load(text, &format!("{name}.toml"), ProfileOrigin::BuiltIn, &no_file)?)
    }

    /// Reads a profile from the text of a TOML file. `place` is the file's name as the messages shall give it; the
    /// profile is called by its last part without `.toml`. The text may inherit any built-in profile.
    ///
    /// # Errors
    /// [`Error::Profile`] with every fault and its line: mistakes in the TOML, unknown keys, wrong kinds, values out of
    /// range, keys missing where nothing is inherited, and values that do not go together.
    pub fn from_toml(text: &str, place: &str) -> Result<Self, Error> {
        Self::from_toml_with(text, place, &no_file)
    }

    /// As [`Profile::from_toml`], for a text that may inherit other files too, such as `inherits = "our-school.toml"`.
    /// `find` gives their texts: it gets a path that is meant from the folder of the file that names it, so `a/b.toml`
    /// if `a/my.toml` inherits `b.toml`. If there is no such file, it says why in words for the maker of the profile.
    ///
    /// # Errors
    /// As [`Profile::from_toml`], with the faults of the inherited files too; and files that inherit one another in a
    /// circle.
    pub fn from_toml_with(
        text: &str,
        place: &str,
        find: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Self, Error> {
        Ok(inherit::load(text, place, ProfileOrigin::File, find)?)
    }

    /// What a key holds, by its path, such as `lines.width_max`. A section with a key `on` may stand for that key.
    ///
    /// # Errors
    /// [`Error::Profile`] when there is no such key, with those that are spelt like it.
    pub fn get(&self, key: &str) -> Result<Value, Error> {
        let key = key.trim();
        let index = index_of(key).map_err(|what| Fault::new(fault::quoted_path(&[key]), what))?;
        Ok(keys::KEYS[index].value(self))
    }

    /// Gives one key another value, such as `lines.width_max` the value `1.2`: what [`Profile::get`] gives, a number,
    /// or a text as TOML has it, with or without its quotes. A section with a key `on` may stand for that key. Whether
    /// the values still go together is for [`Profile::check`] to say, after the last `set`. In messages the place of
    /// the value is `key=value`.
    ///
    /// ```
    /// use tactograph::{Profile, Value};
    ///
    /// let mut profile = Profile::named("swell-a4")?;
    /// profile.set("lines.width_max", 1.2)?;
    /// profile.set("page.orientation", "landscape")?;
    /// profile.set("overview", false)?;
    /// assert_eq!(profile.get("overview")?, Value::Switch(false));
    /// let mut other = Profile::named("swell-a3")?;
    /// other.set("lines.width_max", profile.get("lines.width_max")?)?;
    /// # Ok::<(), tactograph::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Profile`] when there is no such key, or the value is not of its kind or not in its range; then nothing
    /// is changed.
    pub fn set(&mut self, key: &str, value: impl std::fmt::Display) -> Result<(), Error> {
        let value = value.to_string();
        let place = format!("{}={}", fault::quoted_path(&[key.trim()]), fault::quoted_path(&[value.trim()]));
        self.set_from(key, value, &place)
    }

    /// As [`Profile::set`]; `place` is what messages about the value shall call the place where it was given, such as
    /// an option of a program or a field of a form.
    ///
    /// # Errors
    /// As [`Profile::set`].
    pub fn set_from(&mut self, key: &str, value: impl std::fmt::Display, place: &str) -> Result<(), Error> {
        let index = index_of(key.trim()).map_err(|what| Fault::new(place, what))?;
        Ok(self.put_text(index, value.to_string().trim(), place.to_owned())?)
    }

    /// The profile that a page was made with, from how it says that it was made: the profile of its name with every
    /// value that stands there. What is missing, or of an unknown name, is that of the default profile; values that do
    /// not go together (of another version) all give way to those of the profile of that name. Also says what was not
    /// taken.
    pub(crate) fn of_origin(origin: &[(String, String)]) -> Result<(Self, Option<Note>), Error> {
        let value = |value: &str| value.trim_matches('"').to_owned();
        let name = origin.iter().find(|(known, _)| known == "profile").map(|(_, name)| value(name));
        let named = name.as_deref().and_then(|name| Self::named(name).ok());
        let mut profile = match named {
            Some(profile) => profile,
            None => Self::named(built_in()[0].name)?,
        };
        let (base, mut refused) = (profile.clone(), Vec::<String>::new());
        // what another version wrote may not be there any more, and not all that is said of a page are keys
        for (key, said) in origin.iter().filter(|(key, _)| index_of(key).is_ok()) {
            if profile.set_from(key, value(said), "the page").is_err() {
                refused.push(format!("{key} = {said}"));
            }
        }
        profile.name = name.unwrap_or(profile.name);
        let goes_together = profile.check().is_ok();
        if !goes_together {
            refused = vec!["all values together, as they do not fit one another".to_owned()];
        }
        let told = (!refused.is_empty()).then(|| {
            let (refused, name) = (first_few(&refused, MOST_REFUSED, String::clone), &base.name);
            let told =
                format!("of what the page says of its profile, this is not taken: {refused}; {name} counts there");
            Note::TakenAs(About::Marks, Reason::ProfileOfPage, told.into())
        });
        Ok((if goes_together { profile } else { base }, told))
    }

    /// Every parameter as (path, value), in the order of [`Profile::keys`]; numbers are the shortest decimals that read
    /// back as the same.
    pub fn parameters(&self) -> Vec<(&'static str, String)> {
        keys::KEYS.iter().map(|key| (key.path, key.value(self).to_string())).collect()
    }
}

fn no_file(path: &str) -> Result<String, String> {
    Err(format!("no file is given for {}", fault::quoted_path(&[path])))
}

/// Where in the table a key that is set by its name is, or what is wrong with its name.
fn index_of(key: &str) -> Result<usize, String> {
    let is_section = keys::SECTIONS.contains(&key);
    if is_section {
        let switch = keys::switch_of(key).filter(|_| !key.contains('.'));
        return switch.ok_or_else(|| suggest::section_alone(key));
    }
    // The palette is a section in a section.
    let inner = key.rsplit_once('.').filter(|(section, _)| keys::SECTIONS.contains(section));
    match inner.or_else(|| key.split_once('.')) {
        Some((section, name)) if keys::SECTIONS.contains(&section) => {
            keys::position(section, name).ok_or_else(|| suggest::unknown_key(section, name))
        }
        Some((section, _)) => Err(suggest::unknown_section(section, &[])),
        None => Err(suggest::unknown_section(key, &[])),
    }
}
