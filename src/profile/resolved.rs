//! A profile written out with every key, whether its own file gives it or a file that it inherits.

use super::keys::{KEYS, Profile, section_docs};

impl Profile {
    /// The profile as TOML: every key with its value, and as a comment its range and the file and line that the value
    /// comes from. It inherits nothing, and reads back as the same profile.
    pub fn to_toml(&self) -> String {
        let mut text = format!("# {} with every value that it gives or inherits.\n", self.name);
        // one line; and without characters of control, strings of JSON are such of TOML
        let description = self.description.replace(char::is_control, " ");
        text += &format!("description = {}\n", serde_json::Value::from(description));
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
        let text = profile.to_toml();
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
}
