//! The profiles that come with the program.

/// A profile that comes with the program.
#[derive(Debug, Clone, Copy)]
pub struct BuiltIn {
    /// What it is called.
    pub name: &'static str,
    /// Its whole file, with the reason of every number in a comment.
    pub text: &'static str,
}

impl BuiltIn {
    /// What it is for, in one line: the file's `description`.
    pub fn description(&self) -> &'static str {
        self.text.lines().find_map(|line| line.strip_prefix("description = \"")?.strip_suffix('"')).unwrap_or_default()
    }
}

/// All of them; the first is the one to use when none is asked for.
pub fn built_in() -> &'static [BuiltIn] {
    &[
        BuiltIn { name: "swell-a4", text: include_str!("../../profiles/swell-a4.toml") },
        BuiltIn { name: "swell-a3", text: include_str!("../../profiles/swell-a3.toml") },
        BuiltIn { name: "swell-letter", text: include_str!("../../profiles/swell-letter.toml") },
        BuiltIn { name: "swell-11x11.5", text: include_str!("../../profiles/swell-11x11.5.toml") },
        BuiltIn { name: "swell-11x17", text: include_str!("../../profiles/swell-11x17.toml") },
        BuiltIn { name: "plain-print", text: include_str!("../../profiles/plain-print.toml") },
        BuiltIn { name: "index-basic-d", text: include_str!("../../profiles/index-basic-d.toml") },
        BuiltIn { name: "index-everest-d", text: include_str!("../../profiles/index-everest-d.toml") },
        BuiltIn { name: "index-basic-d-v3", text: include_str!("../../profiles/index-basic-d-v3.toml") },
        BuiltIn { name: "index-braillebox", text: include_str!("../../profiles/index-braillebox.toml") },
        BuiltIn { name: "romeo-60", text: include_str!("../../profiles/romeo-60.toml") },
        BuiltIn { name: "juliet-120", text: include_str!("../../profiles/juliet-120.toml") },
        BuiltIn { name: "braillerap", text: include_str!("../../profiles/braillerap.toml") },
        BuiltIn { name: "viewplus-columbia", text: include_str!("../../profiles/viewplus-columbia.toml") },
        BuiltIn { name: "graphiti", text: include_str!("../../profiles/graphiti.toml") },
        BuiltIn { name: "dot-pad", text: include_str!("../../profiles/dot-pad.toml") },
        BuiltIn { name: "monarch", text: include_str!("../../profiles/monarch.toml") },
        BuiltIn { name: "pins-120x60", text: include_str!("../../profiles/pins-120x60.toml") },
        BuiltIn { name: "braille-cells", text: include_str!("../../profiles/braille-cells.toml") },
    ]
}

/// The text of the built-in profile of this name.
pub(super) fn text_of(name: &str) -> Option<&'static str> {
    built_in().iter().find(|profile| profile.name == name).map(|profile| profile.text)
}
