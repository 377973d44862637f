//! The devices.

use super::device::{Device, Family, PIN, Paper};
use crate::error::{self, Error};

impl Device {
    /// All of them, in the order in which a list shows them.
    pub const ALL: &'static [Self] = DEVICES;

    /// The device with this id, such as `index-basic-d-v4`.
    ///
    /// # Errors
    /// [`Error::NoSuchName`] with the ids that there are.
    pub fn named(id: &str) -> Result<&'static Self, Error> {
        error::named(id, "device", Self::ALL, |device| device.id)
    }
}

const fn index_v3(id: &'static str, name: &'static str, paper: Paper, widest: f32, longest: f32) -> Device {
    Device { id, name, family: Family::IndexV3 { paper }, widest, longest }
}

const fn index_v4(id: &'static str, name: &'static str, widest: f32, longest: f32) -> Device {
    Device { id, name, family: Family::IndexV4, widest, longest }
}

const fn braillerap(id: &'static str, name: &'static str, widest: f32, longest: f32, across: f32) -> Device {
    Device { id, name, family: Family::BrailleRap { across }, widest, longest }
}

const fn viewplus(id: &'static str, name: &'static str, widest: f32, longest: f32) -> Device {
    Device { id, name, family: Family::ViewPlus, widest, longest }
}

const fn pins(id: &'static str, name: &'static str, columns: u16, rows: u16) -> Device {
    let [widest, longest] = [columns as f32 * PIN, rows as f32 * PIN];
    Device { id, name, family: Family::Pins { columns, rows }, widest, longest }
}

/// Longest sheet of the Basic-D, S and 4-Waves, mm: 17 inches, the longest page that their driver names. They take
/// tractor paper, which has no end, and the driver's own limit of 10 m is none.
const TRACTOR: f32 = 431.8;

pub(super) const DEVICES: &[Device] = &[
    index_v3("index-basic-d-v3", "Index Basic-D V3", Paper::Inches, 325.0, TRACTOR),
    index_v3("index-basic-s-v3", "Index Basic-S V3", Paper::Inches, 325.0, TRACTOR),
    index_v3("index-4waves-v3", "Index 4-Waves PRO V3", Paper::Unsaid, 325.0, TRACTOR),
    index_v3("index-everest-d-v3", "Index Everest-D V3", Paper::Millimetres, 297.0, 585.0),
    index_v3("index-4x4-pro-v3", "Index 4x4 PRO V3", Paper::Millimetres, 297.0, 585.0),
    index_v4("index-basic-d-v4", "Index Basic-D V4", 325.0, TRACTOR),
    index_v4("index-basic-s-v4", "Index Basic-S V4", 325.0, TRACTOR),
    index_v4("index-everest-d-v4", "Index Everest-D V4", 297.0, 590.0),
    index_v4("index-braillebox-v4", "Index BrailleBox V4", 300.0, 440.0),
    index_v4("index-basic-d-v5", "Index Basic-D V5", 325.0, TRACTOR),
    index_v4("index-basic-s-v5", "Index Basic-S V5", 325.0, TRACTOR),
    index_v4("index-everest-d-v5", "Index Everest-D V5", 297.0, 590.0),
    index_v4("index-braillebox-v5", "Index BrailleBox V5", 300.0, 440.0),
    index_v4("index-fanfold-v5", "Index FanFold V5", 317.5, 304.8),
    // The Basic-D V5 under other names.
    index_v4("romeo-60", "Enabling Technologies Romeo 60", 317.5, 609.6),
    index_v4("juliet-120", "Enabling Technologies Juliet 120", 317.5, 609.6),
    // DesktopBrailleRAP's usable widths; the XL takes A4 and A3.
    braillerap("braillerap-a4", "BrailleRAP", 210.0, 297.0, 190.0),
    braillerap("braillerap-xl", "BrailleRAP XL", 297.0, 420.0, 297.0),
    viewplus("viewplus-columbia", "ViewPlus Columbia", 325.0, 610.0),
    viewplus("viewplus-pixblaster", "APH PixBlaster", 325.0, 610.0),
    viewplus("viewplus-delta", "ViewPlus Delta", 305.0, 432.0),
    viewplus("viewplus-premier", "ViewPlus Premier", 305.0, 610.0),
    viewplus("viewplus-elite", "ViewPlus Elite", 305.0, 610.0),
    viewplus("viewplus-max", "ViewPlus Max", 356.0, 610.0),
    viewplus("viewplus-embraille", "ViewPlus EmBraille", 216.0, 610.0),
    viewplus("viewplus-cub", "ViewPlus Cub", 216.0, 610.0),
    viewplus("viewplus-emprint", "ViewPlus Emprint SpotDot", 216.0, 432.0),
    viewplus("viewplus-tiger-pro", "ViewPlus Tiger Pro", 432.0, 610.0),
    viewplus("viewplus-emfuse", "ViewPlus EmFuse", 328.0, 457.0),
    pins("graphiti", "Orbit Graphiti", 60, 40),
    pins("dot-pad", "Dot Pad", 60, 40),
    pins("monarch", "APH Monarch", 96, 40),
    pins("pins-120x60", "pin display of 120 x 60", 120, 60),
    // The widest and longest of the Enabling Technologies, Braillo and ViewPlus embossers when they emboss text: 15 x
    // 14 inches.
    Device {
        id: "braille-cells",
        name: "a braille-cell embosser",
        family: Family::Cells,
        widest: 381.0,
        longest: 355.6,
    },
];
