//! What the device of a profile of dots cannot do.

use super::fault::Fault;
use super::keys::{PaletteSettings, Profile};
use crate::classes::Class;
use crate::devices::{Device, DotArea};
use crate::dots::textures::carried;
use crate::page::layout::Orientation;
use crate::textures::{Palette, Sign};

/// The keys that a device may refuse.
const PRESSED: &[&str] = &["page.width", "page.height", "page.orientation", "dots.device", "dots.pitch"];

/// The keys of what only rhombuses can tell.
const FRINGE: &[&str] = &["textures.fringe", "dots.device"];

/// Those that say how large the sheet is, and how far dots are apart.
const SHEET: &[&str] = &["page.width", "page.height", "page.orientation", "dots.device"];
const PITCH: &[&str] = &["dots.pitch", "dots.device"];

/// The keys of the signs of colours, in the order of the classes.
pub(super) const PALETTE: [&str; Class::COUNT] = [
    "textures.palette.blue",
    "textures.palette.green",
    "textures.palette.yellow",
    "textures.palette.red",
    "textures.palette.grey",
];

impl PaletteSettings {
    /// The signs, in the order of the classes.
    pub(super) fn signs(&self) -> [Sign; Class::COUNT] {
        Class::ALL.map(|class| match class {
            Class::Blue => self.blue,
            Class::Green => self.green,
            Class::Yellow => self.yellow,
            Class::Red => self.red,
            Class::Grey => self.grey,
        })
    }
}

impl Profile {
    /// What the device cannot do that the profile asks for.
    pub(super) fn device_faults(&self) -> Vec<Fault> {
        let (Some(device), true) = (self.dots.device, self.sound(PRESSED)) else { return Vec::new() };
        let [short, long] = [self.page.width.min(self.page.height), self.page.width.max(self.page.height)];
        let (upright, across) = ([short, long], [long, short]);
        let area = |sheet| device.dots_on(sheet, self.dots.pitch);
        let refused = match self.page.orientation {
            Orientation::Portrait => area(upright).err(),
            Orientation::Landscape => area(across).err(),
            Orientation::Auto => area(upright).err().and_then(|faults| area(across).err().map(|_| faults)),
        };
        let mut faults = Vec::new();
        let mut fault = |paths: &[&'static str], what| faults.push(self.fault(paths, what));
        for (path, value) in [("dots.line_gap", self.dots.line_gap), ("dots.texture_gap", self.dots.texture_gap)] {
            if self.sound(&[path]) && value.fract() > 0.0 {
                fault(&[path], format!("{path} is {value}, but dots are counted, give a whole number"));
            }
        }
        if self.figure.textures && self.textures.fringe && self.sound(FRINGE) {
            let what = format!(
                "textures.fringe turns single rhombuses, and {} presses dots, which have no direction, set it to false",
                device.name
            );
            fault(FRINGE, what);
        }
        let has_pitch = device.pitches().find(self.dots.pitch).is_some();
        let of_pitch = usize::from(!has_pitch);
        let refused = refused.unwrap_or_default();
        // what is wrong with the sheet is told first, and then the pitch
        let of_sheet = refused.len().saturating_sub(of_pitch);
        for (i, what) in refused.iter().enumerate() {
            fault(if i < of_sheet { SHEET } else { PITCH }, what.clone());
        }
        if let (Ok(area), true, true) =
            (area(upright).or_else(|_| area(across)), refused.is_empty(), self.figure.textures)
        {
            faults.extend(self.carried_faults(device, &area));
        }
        faults
    }

    /// The classes that the patterns of a grid cannot tell apart. Cells of text carry few directions whatever the
    /// palette; the maker of such a page is told, and not refused.
    fn carried_faults(&self, device: &Device, area: &DotArea) -> Vec<Fault> {
        let palette = self.palette.signs();
        // those that no device tells apart are told as such
        let told = (0..palette.len()).any(|i| (0..i).any(|j| !palette[i].differs_from(palette[j])));
        if told || device.cell_dots().is_some() {
            return Vec::new();
        }
        let keys: Vec<_> = PALETTE.into_iter().chain(["dots.device"]).collect();
        let alike = carried(&Palette { signs: palette }, area).err().unwrap_or_default();
        let fault = |(a, b): (Class, Class)| {
            let what = format!(
                "the dots of {} {} mm apart lie in rows at 0, 45, 90 or 135 degrees, if they are near enough, and \
                 cannot tell {} from {}, give them directions that are nearest to different ones of these",
                device.name,
                self.dots.pitch,
                a.name(),
                b.name()
            );
            self.fault(&keys, what)
        };
        alike.into_iter().map(fault).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::keys::KEYS;
    use super::*;

    /// A misspelt path would switch its rule off without a word.
    #[test]
    fn rules_name_keys_that_exist() {
        let mut paths = PRESSED.iter().chain(&PALETTE).chain(FRINGE).chain(SHEET).chain(PITCH);
        assert!(paths.all(|path| KEYS.iter().any(|key| key.path == *path)));
    }
}
