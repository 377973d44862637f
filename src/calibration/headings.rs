//! The words of sheets: their titles, what stands above sections and beside samples, and what is said of them.

use crate::braille::{self, Code, Divide};
use crate::page::{MediumParams, SAMPLES};
use crate::profile::Plan;

/// Blank between a sample and its label, mm: as other programs leave around braille on graphics.
pub(super) const BLANK: f32 = 3.0;

/// The keys of a profile that a section decides; none where the program decides.
pub(super) type Decides = &'static [&'static str];

/// What stands above a section, in lines of so many cells: its letter, and the keys of a profile that it decides.
pub(super) fn heading_of(section: usize, keys: Decides, cells: usize) -> Vec<Vec<u8>> {
    let text = [&[&*char::from(b'a' + section as u8).to_string()], keys].concat().join(" ");
    let table = Code::of_language("en").and_then(Code::table);
    table.map_or_else(Vec::new, |table| braille::wrap(&table.translate(&text), cells, Divide::Never).lines)
}

/// The same in the description of the sheet.
pub(super) fn told(section: usize, keys: Decides, key: &str) -> String {
    let decides = if keys.is_empty() { String::new() } else { format!(" ({})", keys.join(", ")) };
    format!(" {}{decides}: {key}.", char::from(b'a' + section as u8))
}

/// The title of the document of all sheets for a profile; for a device, with the distance of its dots.
pub fn title(plan: &Plan) -> String {
    let name = &plan.profile().name;
    match plan.medium() {
        MediumParams::Print(_) => format!("Calibration sheet for {name}"),
        MediumParams::Dots { pitch, .. } => format!("Calibration sheet for {name}, dots {pitch} mm apart"),
    }
}

/// Title, description and origin of one sheet of several; `keys` says what is on it.
pub(super) fn words_of(
    plan: &Plan,
    (number, count): (usize, usize),
    keys: &str,
) -> (String, String, Vec<(String, String)>) {
    let profile = plan.profile();
    let title = match count {
        1 => title(plan),
        _ => format!("{}, {number} of {count}", title(plan)),
    };
    let mut origin = vec![
        ("program".into(), concat!("tactograph ", env!("CARGO_PKG_VERSION")).into()),
        (SAMPLES.to_owned(), format!("{number} of {count}")),
        ("profile".into(), profile.name.clone()),
    ];
    origin.extend(profile.counting_parameters().map(|(key, value)| (key.to_owned(), value)));
    let description = format!("{title}.{keys} Letters and numbers are in braille.");
    (title, description, origin)
}

/// Numbers one after the other.
pub(super) fn listed<T: ToString>(values: &[T]) -> String {
    values.iter().map(T::to_string).collect::<Vec<_>>().join(", ")
}
