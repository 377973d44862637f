//! The profiles that come with the program.

/// A profile that comes with the program.
#[derive(Debug, Clone, Copy)]
pub struct BuiltIn {
    /// What it is called.
    pub name: &'static str,
    /// Names by which it is looked for; each is a reason to suggest it.
    pub(super) also: &'static [&'static str],
    /// Its whole file, with the reason of every number in a comment.
    pub text: &'static str,
}

impl BuiltIn {
    /// What it is for, in one line: the file's `description`.
    pub fn description(&self) -> &'static str {
        self.text.lines().find_map(|line| line.strip_prefix("description = \"")?.strip_suffix('"')).unwrap_or_default()
    }
}

/// A profile whose file is called as it is.
macro_rules! of_file {
    ($name:literal $(, also $($also:literal),+)?) => {
        BuiltIn {
            name: $name,
            also: &[$($($also),+)?],
            text: include_str!(concat!("../../profiles/", $name, ".toml")),
        }
    };
}

/// All of them; the first is the one to use when none is asked for.
pub fn built_in() -> &'static [BuiltIn] {
    &[
        of_file!("swell-a4"),
        of_file!("swell-a3"),
        of_file!("swell-letter"),
        of_file!("swell-11x11.5"),
        of_file!("swell-11x17"),
        of_file!("plain-print"),
        of_file!("index-basic-d", also "index-basic-d-v4", "index-basic-d-v5"),
        of_file!("index-everest-d", also "index-everest-d-v4", "index-everest-d-v5"),
        of_file!("index-basic-d-v3"),
        of_file!("index-braillebox", also "index-braillebox-v4", "index-braillebox-v5"),
        of_file!("romeo-60"),
        of_file!("juliet-120"),
        of_file!("braillerap"),
        of_file!("viewplus-columbia"),
        of_file!("graphiti"),
        of_file!("dot-pad"),
        of_file!("monarch"),
        of_file!("pins-120x60"),
        of_file!("braille-cells"),
    ]
}

/// The text of the built-in profile of this name.
pub(super) fn text_of(name: &str) -> Option<&'static str> {
    built_in().iter().find(|profile| profile.name == name).map(|profile| profile.text)
}

/// Whether a profile's name is the path of a file: it ends in `.toml`, or has a folder in it.
pub(super) fn is_path(name: &str) -> bool {
    name.contains(['/', '\\']) || name.to_ascii_lowercase().ends_with(".toml")
}
