//! Where the letters of SVG drawings come from.

use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use usvg::fontdb::{Database, Family, Query};

use crate::Error;

/// Fonts for the text of SVG drawings, and for words in print of a page that is written as PNG; nothing else needs any.
/// Those that are installed are read when they are first needed, and once: clones share them.
///
/// A text for which there is no font is left out of the page, which a [`Note`](crate::Note) tells; it is no label
/// either.
#[derive(Clone, Default)]
pub struct Fonts(Option<Arc<SharedFonts>>);

struct SharedFonts {
    source: FontSource,
    loaded: OnceLock<Arc<Database>>,
}

enum FontSource {
    Data,
    #[cfg(feature = "system-fonts")]
    System,
}

impl Fonts {
    /// No fonts at all: the default, and what a browser has.
    pub fn none() -> Self {
        Self(None)
    }

    /// Fonts from the bytes of font files (TTF, OTF or collections of them).
    ///
    /// # Errors
    /// [`Error::NotAFont`] for the first file that is none, such as a WOFF, or a page of a server that has no font.
    pub fn from_data(files: Vec<Vec<u8>>) -> Result<Self, Error> {
        let mut fonts = Database::new();
        for (i, file) in files.into_iter().enumerate() {
            let before = fonts.len();
            fonts.load_font_data(file);
            if fonts.len() == before {
                return Err(Error::NotAFont { file: i + 1 });
            }
        }
        give_generic_families_a_font(&mut fonts);
        let loaded = OnceLock::from(Arc::new(fonts));
        Ok(Self(Some(Arc::new(SharedFonts { source: FontSource::Data, loaded }))))
    }

    /// The fonts that are installed on this machine. Reading their list takes some tens of milliseconds, once.
    ///
    /// With the feature `system-fonts`, which the feature `cli` brings.
    #[cfg(feature = "system-fonts")]
    pub fn system() -> Self {
        Self(Some(Arc::new(SharedFonts { source: FontSource::System, loaded: OnceLock::new() })))
    }

    /// The fonts, read now if they have not been before.
    pub(crate) fn database(&self) -> Arc<Database> {
        let Some(shared) = &self.0 else { return Arc::default() };
        shared.loaded.get_or_init(|| Arc::new(shared.source.load())).clone()
    }
}

impl std::fmt::Debug for Fonts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let source = self.0.as_ref().map(|shared| &shared.source);
        f.write_str(match source {
            None => "Fonts::none()",
            Some(FontSource::Data) => "Fonts::from_data(..)",
            #[cfg(feature = "system-fonts")]
            Some(FontSource::System) => "Fonts::system()",
        })
    }
}

impl FontSource {
    fn load(&self) -> Database {
        let mut fonts = Database::new();
        match self {
            // they were loaded when they were given
            Self::Data => {}
            #[cfg(feature = "system-fonts")]
            Self::System => fonts.load_system_fonts(),
        }
        give_generic_families_a_font(&mut fonts);
        fonts
    }
}

/// Fonts that stand for "sans-serif" and the like, those first that are alike in width to what drawings are made with.
const SANS: [&str; 6] = ["Liberation Sans", "Helvetica", "DejaVu Sans", "Noto Sans", "Open Sans", "Roboto"];
const SERIF: [&str; 4] = ["Liberation Serif", "Times", "DejaVu Serif", "Noto Serif"];
const MONO: [&str; 4] = ["Liberation Mono", "Courier", "DejaVu Sans Mono", "Noto Sans Mono"];

/// "sans-serif" and the like stand for a font by name (say Arial). Where that one is not among the fonts, text would
/// be left out although others are there: take a usual one, or else the first that is. Which of them are there beside
/// changes nothing, so that labels stand at the same places.
fn give_generic_families_a_font(fonts: &mut Database) {
    let names: BTreeSet<String> =
        fonts.faces().filter_map(|face| face.families.first()).map(|(name, _)| name.clone()).collect();
    let Some(first) = names.first() else { return };
    let usual = |usual: &[&str]| usual.iter().copied().find(|name| names.contains(*name)).unwrap_or(first).to_owned();
    let missing = |family| fonts.query(&Query { families: &[family], ..Query::default() }).is_none();
    let [serif, sans, mono, cursive, fantasy] =
        [Family::Serif, Family::SansSerif, Family::Monospace, Family::Cursive, Family::Fantasy].map(missing);
    if serif {
        fonts.set_serif_family(usual(&SERIF));
    }
    if sans {
        fonts.set_sans_serif_family(usual(&SANS));
    }
    if mono {
        fonts.set_monospace_family(usual(&MONO));
    }
    if cursive {
        fonts.set_cursive_family(usual(&SANS));
    }
    if fantasy {
        fonts.set_fantasy_family(usual(&SANS));
    }
}

#[cfg(test)]
mod tests;
