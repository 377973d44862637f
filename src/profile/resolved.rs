//! A profile written out: by what it changes of the one that it inherits, or with every key.

use super::keys::{KEYS, Key, Profile, SECTIONS, section_docs};

impl Profile {
    /// The profile as the TOML of a file of one's own: the built-in profile that it inherits, itself or through other
    /// files, and each key that has another value than there, also by [`Profile::set`]. Where [`Profile::check`] finds
    /// no fault, [`Profile::from_toml`] reads the same profile back; its name is not in the text, and is that of the
    /// file.
    ///
    /// ```
    /// use tactograph::Profile;
    ///
    /// let mut profile = Profile::from_toml("inherits = \"swell-a3\"", "workshop.toml")?;
    /// profile.set("lines.width_max", 1.2)?;
    /// let text = profile.to_toml();
    /// assert_eq!(text, "inherits = \"swell-a3\"\n\n[lines]\nwidth_max = 1.2\n");
    /// let again = Profile::from_toml(&text, &format!("{}.toml", profile.name))?;
    /// assert_eq!((again.parameters(), again.name), (profile.parameters(), profile.name));
    /// # Ok::<(), tactograph::Error>(())
    /// ```
    pub fn to_toml(&self) -> String {
        let base = Self::named(self.base).ok();
        let is_other = |key: &&Key| base.as_ref().is_none_or(|base| key.value(base) != key.value(self));
        let mut text = format!("inherits = \"{}\"\n", self.base);
        if !self.description.is_empty() {
            text += &self.description_line();
        }
        for section in SECTIONS {
            let mut keys = KEYS.iter().filter(|key| key.section() == *section).filter(is_other).peekable();
            if keys.peek().is_some() {
                text += &format!("\n[{section}]\n");
            }
            text.extend(keys.map(|key| format!("{} = {}\n", key.name(), key.value(self))));
        }
        text
    }

    fn description_line(&self) -> String {
        // one line; and without characters of control, strings of JSON are such of TOML
        let description = self.description.replace(char::is_control, " ");
        format!("description = {}\n", serde_json::Value::from(description))
    }

    /// The profile as TOML to read: every key with its value, and as a comment its range and the file and line that the
    /// value comes from. It inherits nothing, and reads back as the same profile.
    pub fn to_toml_in_full(&self) -> String {
        let mut text = format!("# {} with every value that it gives or inherits.\n", self.name);
        text += &self.description_line();
        for (section, doc) in section_docs() {
            text += &format!("\n# {doc}\n[{section}]\n");
            for key in KEYS.iter().filter(|key| key.section() == section) {
                let place = self.place(&[key.path]);
                text +=
                    &format!("# {}\n{} = {} # {}; from {place}\n", key.doc, key.name(), key.value(self), key.range());
            }
        }
        text
    }
}

#[cfg(test)]
mod tests;
