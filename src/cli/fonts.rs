//! The system's fonts, for drawings with text.

use std::sync::{Arc, OnceLock};

use usvg::fontdb::{Database, Family, Query};

/// Fonts that are looked for on first use: a directory of fonts takes tens of milliseconds to read, and few drawings need it.
#[derive(Default)]
pub(super) struct SystemFonts(OnceLock<Arc<Database>>);

impl SystemFonts {
    /// The list of fonts; empty where the system has none.
    pub(super) fn get(&self) -> Arc<Database> {
        self.0.get_or_init(|| Arc::new(load())).clone()
    }
}

fn load() -> Database {
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    give_generic_families_a_font(&mut fonts);
    fonts
}

/// "sans-serif" and the like stand for a font by name (say Arial). Where that one is not installed, text would be left
/// out although other fonts are there: take the first that is.
fn give_generic_families_a_font(fonts: &mut Database) {
    let first = fonts.faces().filter_map(|face| face.families.first()).map(|(name, _)| name.clone()).min();
    let Some(first) = first else { return };
    let missing = |family| fonts.query(&Query { families: &[family], ..Query::default() }).is_none();
    let [serif, sans, mono, cursive, fantasy] =
        [Family::Serif, Family::SansSerif, Family::Monospace, Family::Cursive, Family::Fantasy].map(missing);
    if serif {
        fonts.set_serif_family(&first);
    }
    if sans {
        fonts.set_sans_serif_family(&first);
    }
    if mono {
        fonts.set_monospace_family(&first);
    }
    if cursive {
        fonts.set_cursive_family(&first);
    }
    if fantasy {
        fonts.set_fantasy_family(&first);
    }
}
