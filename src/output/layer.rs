//! The layers of a page and the greys of heights: the same in every format that has them.

use crate::page::{Class, Height, TextRole};

/// A layer. Those with a parent lie in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Layer {
    OrientationMark,
    Registration,
    Frame,
    Figure,
    Textures,
    Texture(Class),
    Lines,
    OverviewFrame,
    Overview,
    Labels,
    Braille(TextRole),
    PrintWords,
}

impl Layer {
    /// All of them.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let beside =
            [Self::OrientationMark, Self::Registration, Self::Frame, Self::Figure, Self::Textures, Self::Lines];
        let below = [Self::OverviewFrame, Self::Overview, Self::Labels, Self::PrintWords];
        let textures = Class::ALL.map(Self::Texture);
        beside.into_iter().chain(textures).chain(below).chain(TextRole::ALL.map(Self::Braille))
    }

    /// The layer of this id or label, whatever its case: some editors keep only one of the two.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let id = name.trim().to_lowercase().replace([' ', '_'], "-");
        Self::all().find(|layer| layer.id() == id)
    }

    /// Its id, for programs.
    pub(crate) fn id(self) -> String {
        self.label().to_lowercase().replace(' ', "-")
    }

    /// Its name, for people.
    pub(crate) fn label(self) -> String {
        match self {
            Self::OrientationMark => "Orientation mark".into(),
            Self::Registration => "Registration".into(),
            Self::Frame => "Frame".into(),
            Self::Figure => "Figure".into(),
            Self::Textures => "Textures".into(),
            Self::Texture(class) => format!("Texture {}", class.name()),
            Self::Lines => "Lines".into(),
            Self::OverviewFrame => "Overview frame".into(),
            Self::Overview => "Overview".into(),
            Self::Labels => "Labels".into(),
            Self::PrintWords => "Print words".into(),
            Self::Braille(TextRole::Title) => "Braille title".into(),
            Self::Braille(TextRole::Label) => "Braille labels".into(),
            Self::Braille(TextRole::Key) => "Braille key".into(),
            Self::Braille(TextRole::Number) => "Braille page number".into(),
        }
    }
}

/// The grey of words in print: 23 % of black. What rises does so the more the blacker it is (tactilelibrary.com: dark
/// grey less than black); how little a light grey rises depends on paper and heater, and no measurement is known to us.
pub(crate) const PRINT_GREY: u8 = 0xc4;

/// The greys of no dot, and of a low, a middle and a high one: as far apart as they can be, so that a driver that has
/// more heights than we use maps them to heights that differ.
pub(super) const GREYS: [u8; 4] = [255, 170, 85, 0];

/// The grey of a dot's height, 0 black: what is lighter is raised less.
pub(super) fn grey(height: Height) -> u8 {
    GREYS[1 + height as usize]
}

/// The height that is drawn in the nearest grey.
pub(crate) fn height(grey: u8) -> Height {
    let off = |height: &Height| self::grey(*height).abs_diff(grey);
    Height::ALL.into_iter().min_by_key(off).unwrap_or_default()
}

#[cfg(test)]
mod tests;
