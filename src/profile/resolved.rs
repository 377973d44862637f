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
mod tests {
    use super::*;

    #[test]
    fn a_profile_written_out_reads_back_as_the_same() {
        let own = "inherits = \"swell-a3\"\ndescription = \"A \\\"wide\\\" one, C:\\\\x\"\n[lines]\nwidth_max = 1.2\n\
                   [textures.palette]\nblue = \"rhombus 10\"";
        let mut profile = Profile::from_toml(own, "my.toml").expect("it is right");
        profile.description += "\nin";
        let text = profile.to_toml_in_full();
        let line = |start: &str| text.lines().find(|line| line.starts_with(start)).expect(start).to_owned();
        assert_eq!(line("width_max"), "width_max = 1.2 # a number from 0.3 to 10 mm; from my.toml, line 4");
        assert!(line("width = 297").contains("; from swell-a3.toml, line "), "{text}");
        assert!(line("width_min").contains("; from swell-a4.toml, line "), "{text}");
        let back = Profile::from_toml(&text, "back.toml").expect("it can be read");
        assert_eq!(
            (back.parameters(), back.description),
            (profile.parameters(), profile.description.replace('\n', " "))
        );
    }

    /// Reads a text back under the name of the profile that wrote it.
    fn read_back(profile: &Profile, text: &str) -> Profile {
        let back = Profile::from_toml(text, &format!("{}.toml", profile.name)).expect("it can be read");
        assert_eq!((&back.name, &back.description), (&profile.name, &profile.description), "{text}");
        assert_eq!(back.parameters(), profile.parameters(), "{text}");
        back
    }

    #[test]
    fn a_changed_profile_is_written_by_its_differences() {
        let own = "inherits = \"paper.toml\"\ndescription = \"Thick \\\"lines\\\"\"\n[lines]\nwidth_max = 2.5";
        let paper = "inherits = \"swell-a3\"\n[page]\nmargin = 15";
        let mut profile = Profile::from_toml_with(own, "our school.toml", &|_| Ok(paper.into())).expect("right");
        profile.set("overview", false).expect("a switch");
        profile.set("textures.palette.blue", "rhombus 10").expect("a sign");
        let text = profile.to_toml();
        let expected = "inherits = \"swell-a3\"\ndescription = \"Thick \\\"lines\\\"\"\n\n[page]\nmargin = 15\n\n\
                        [overview]\non = false\n\n[lines]\nwidth_max = 2.5\n\n[textures.palette]\n\
                        blue = \"rhombus 10\"\n";
        assert_eq!(text, expected);
        assert_eq!(read_back(&profile, &text).to_toml(), text);
        // what is as before is no difference
        profile.set("overview", true).expect("a switch");
        assert!(!profile.to_toml().contains("overview"));
    }

    #[test]
    fn every_profile_is_written_and_read_back() {
        for built_in in Profile::built_in() {
            let profile = Profile::named(built_in.name).expect("it is built in");
            let text = profile.to_toml();
            assert!(
                text.starts_with(&format!("inherits = \"{}\"\n", built_in.name)) && !text.contains("\n["),
                "{text}"
            );
            let full = profile.to_toml_in_full();
            // of one that inherits nothing the differences to the first of all are told
            let back = read_back(&profile, &full);
            read_back(&read_back(&profile, &text), &back.to_toml());
        }
    }
}
