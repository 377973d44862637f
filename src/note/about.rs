//! What a remark is about, for programs.

/// What on a page a remark is about, for programs: its sentence may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum About {
    /// Marks of any kind.
    Marks,
    /// Lines, or contours that would be lines.
    Lines,
    /// How wide lines are.
    Widths,
    /// Areas and their textures.
    Areas,
    /// Single signs of textures.
    Signs,
    /// Texts that a person typed.
    Texts,
    /// Words in braille.
    Braille,
    /// Leader lines of labels.
    Leaders,
    /// Words in print beside braille.
    Print,
    /// Dots that a person drew.
    Dots,
    /// The overview.
    Overview,
}

/// A file that is given beside a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum GivenFile {
    /// That of [`Options::lines`](crate::Options::lines).
    Lines,
    /// That of [`Options::add_lines`](crate::Options::add_lines).
    AddedLines,
    /// That of [`Options::areas`](crate::Options::areas).
    Areas,
}

impl GivenFile {
    /// What is given in it, such as "lines".
    pub fn name(self) -> &'static str {
        match self {
            Self::Lines => "lines",
            Self::AddedLines => "added lines",
            Self::Areas => "areas",
        }
    }
}

impl About {
    /// All of them.
    pub const ALL: &'static [Self] = &[
        Self::Marks,
        Self::Lines,
        Self::Widths,
        Self::Areas,
        Self::Signs,
        Self::Texts,
        Self::Braille,
        Self::Leaders,
        Self::Print,
        Self::Dots,
        Self::Overview,
    ];

    /// Its name, such as "lines".
    pub fn name(self) -> &'static str {
        match self {
            Self::Marks => "marks",
            Self::Lines => "lines",
            Self::Widths => "widths",
            Self::Areas => "areas",
            Self::Signs => "signs",
            Self::Texts => "texts",
            Self::Braille => "braille",
            Self::Leaders => "leaders",
            Self::Print => "print",
            Self::Dots => "dots",
            Self::Overview => "overview",
        }
    }
}
