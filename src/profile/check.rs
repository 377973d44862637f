//! What the keys of a profile owe one another.

use super::device::PALETTE;
use super::fault::Fault;
use super::keys::{KEYS, Key, Profile};
use super::kind::Value;
use crate::Error;
use crate::page::layout::{self, Orientation};
use crate::textures::{LEAST_ANGLE, Sign};

/// A key whose value must stay below another's.
struct Order {
    small: &'static str,
    relation: Relation,
    large: &'static str,
    /// The switches that must all be on for this to matter.
    when: &'static [&'static str],
    /// Why, as the end of a sentence.
    why: &'static str,
}

#[derive(Clone, Copy)]
enum Relation {
    Below,
    AtMost,
}
use Relation::{AtMost, Below};

const ORDERS: &[Order] = &[
    Order {
        small: "frame.dot",
        relation: Below,
        large: "frame.pitch",
        when: &["frame.on"],
        why: "or its dots run together",
    },
    Order {
        small: "frame.dot",
        relation: AtMost,
        large: "frame.width",
        when: &["frame.on"],
        why: "or no dot fits into the frame",
    },
    Order {
        small: "mark.width",
        relation: Below,
        large: "mark.length",
        when: &["mark.on"],
        why: "or the bar is a dot, which does not show which corner it cuts",
    },
    Order {
        small: "edges.low",
        relation: AtMost,
        large: "edges.high",
        when: &[],
        why: "since a contour is followed down to low once it has reached high",
    },
    Order {
        small: "edges.low",
        relation: Below,
        large: "lines.full_strength",
        when: &[],
        why: "since lines grow from the one to the other",
    },
    Order {
        small: "lines.width_min",
        relation: AtMost,
        large: "lines.width_max",
        when: &[],
        why: "since a weak contour has the thinner line",
    },
    Order {
        small: "textures.length",
        relation: Below,
        large: "textures.along",
        when: &["figure.textures"],
        why: "or the rhombuses of a row run together",
    },
    Order {
        small: "textures.thickness",
        relation: Below,
        large: "textures.across",
        when: &["figure.textures"],
        why: "or the rows run together",
    },
    Order {
        small: "textures.thickness",
        relation: AtMost,
        large: "textures.length",
        when: &["figure.textures"],
        why: "or the rhombuses lie across their row",
    },
    Order {
        small: "textures.dot",
        relation: Below,
        large: "textures.dot_pitch",
        when: &["figure.textures"],
        why: "or the dots run together",
    },
    Order {
        small: "textures.min_glyph",
        relation: AtMost,
        large: "textures.thickness",
        when: &["figure.textures"],
        why: "since it is the thickness of the lightest glyph",
    },
    Order {
        small: "textures.min_glyph",
        relation: AtMost,
        large: "textures.dot",
        when: &["figure.textures"],
        why: "since it is the thickness of the lightest glyph",
    },
];

/// Glyphs and how far apart they stand: between two there must be a blank that is felt.
const SPACED: &[(&str, &str)] = &[
    ("textures.length", "textures.along"),
    ("textures.thickness", "textures.across"),
    ("textures.dot", "textures.dot_pitch"),
];
/// The least blank between two glyphs.
const BLANK: &str = "textures.min_glyph";

/// The keys that decide how large a figure can be.
const ROOM: &[&str] = &[
    "page.width",
    "page.height",
    "page.orientation",
    "page.margin",
    "frame.on",
    "frame.width",
    "frame.gap",
    "overview.on",
    "overview.scale",
    "overview.gap",
    "mark.on",
    "mark.length",
    "mark.width",
    "mark.gap",
    "figure.min_side",
    "dots.device",
    "dots.pitch",
];

/// The keys of marks that may be the narrowest ones printed, each with the switches that must all be on for it to be
/// drawn and how many times what swelling adds is taken from it. A rhombus loses more than it gains in width at its
/// sides, at most the square root of 2 times as much, for a square.
const NARROW: &[(&str, &[&str], f32)] = &[
    ("lines.width_min", &[], 1.0),
    ("frame.dot", &["frame.on"], 1.0),
    ("mark.width", &["mark.on"], 1.0),
    ("textures.min_glyph", &["figure.textures"], std::f32::consts::SQRT_2),
];

/// The narrowest that anything is printed, mm. Chosen by us, because two dots of a printer of 300 dpi (0.085 mm each)
/// are the least that surely comes out black.
const LEAST_PRINTED: f32 = 0.17;

/// The keys that decide whether anything is drawn.
const DRAWN: &[&str] = &["figure.lines", "figure.textures", "overview.on"];

impl Profile {
    /// Whether all values are in range and go together. They do in a profile fresh from [`Profile::named`] or
    /// [`Profile::from_toml`]; to be asked again after
    /// [`Profile::set`].
    ///
    /// # Errors
    /// [`Error::Profile`] with every fault at once. The place of a fault is where the value concerned was last given by
    /// a file or by `set`.
    pub fn check(&self) -> Result<(), Error> {
        let refuse = |key: &Key| self.fault(&[key.path], key.refuse(&key.value(self).to_string()));
        let mut faults: Vec<_> = KEYS.iter().filter(|key| !key.takes(&key.value(self))).map(refuse).collect();
        faults.extend(self.rule_faults());
        if faults.is_empty() { Ok(()) } else { Err(faults.into()) }
    }

    /// The largest width and height in mm that a figure can have on the sheet, beside its frame and above its overview,
    /// when nothing is taken by the orientation mark; 0 where there is no room at all. Of a sheet that is turned to the
    /// picture's shape, when it lies upright.
    fn figure_room(&self) -> (f32, f32) {
        let band = if self.frame.on { 2.0 * (self.frame.width + self.frame.gap) } else { 0.0 };
        let (short, long) = (self.page.width.min(self.page.height), self.page.width.max(self.page.height));
        let (across, down) =
            if self.page.orientation == Orientation::Landscape { (long, short) } else { (short, long) };
        let width = across - 2.0 * self.page.margin - band;
        let height = down - 2.0 * self.page.margin - band;
        let height =
            if self.overview.on { (height - self.overview.gap - band) / (1.0 + self.overview.scale) } else { height };
        (width.max(0.0), height.max(0.0))
    }

    /// The faults of values that do not go together; a rule about a value that is out of range anyway is left aside.
    pub(super) fn rule_faults(&self) -> Vec<Fault> {
        let mut faults: Vec<_> = ORDERS.iter().filter_map(|order| self.order_fault(order)).collect();
        faults.append(&mut self.palette_faults());
        faults.extend(SPACED.iter().filter_map(|(glyph, pitch)| self.spacing_fault(glyph, pitch)));
        let device_faults = self.device_faults();
        let fits_device = device_faults.is_empty();
        faults.extend(device_faults);
        faults.extend(self.room_fault().filter(|_| fits_device));
        faults.extend(self.swell_fault());
        if self.sound(DRAWN) && !self.figure.lines && !self.figure.textures && !self.overview.on {
            let what = "figure.lines, figure.textures and overview.on are all false, so nothing would be drawn, set \
                        one of them to true";
            faults.push(self.fault(DRAWN, what.to_owned()));
        }
        faults
    }

    /// The fault of a sheet on which a square figure would be too small.
    fn room_fault(&self) -> Option<Fault> {
        if !self.sound(ROOM) {
            return None;
        }
        let (width, height) = self.figure_room();
        let least = self.figure.min_side;
        let square = layout::fit(1.0, f32::MAX, &self.layout()).figure.width();
        if square >= least {
            return None;
        }
        let what = if let Some(device) = self.dots.device {
            format!(
                "the grid of {} leaves {square:.1} mm for a square figure, but figure.min_side asks for {least} mm, \
                 enlarge the sheet or lessen frame.gap or mark.gap",
                device.name
            )
        } else if width >= least && height >= least {
            format!(
                "the orientation mark leaves {square:.1} mm for a square figure, but figure.min_side asks for {least} \
                 mm, lessen mark.length or mark.gap, or enlarge the sheet"
            )
        } else {
            format!(
                "the sheet leaves {width:.1} mm by {height:.1} mm for the figure, but figure.min_side asks for {least} \
                 mm, enlarge page.width or page.height or lessen margin, frame, overview or their gaps"
            )
        };
        Some(self.fault(ROOM, what))
    }

    /// The faults of signs that a finger cannot tell apart, one for each pair.
    fn palette_faults(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        if !self.figure.textures {
            return faults;
        }
        let signs: Vec<(&str, Sign)> = PALETTE.into_iter().zip(self.palette.signs()).collect();
        for (i, &(second, sign)) in signs.iter().enumerate() {
            for &(first, other) in signs[..i].iter().filter(|(_, other)| !sign.differs_from(*other)) {
                let keys = [first, second];
                if self.sound(&keys) {
                    let what = format!(
                        "{first} is \"{other}\" and {second} is \"{sign}\", which fingers cannot tell apart, give one \
                         of them a direction that is {LEAST_ANGLE} degrees or more from all others"
                    );
                    faults.push(self.fault(&keys, what));
                }
            }
        }
        faults
    }

    fn order_fault(&self, order: &Order) -> Option<Fault> {
        let keys = [order.small, order.large];
        let matters = self.all_on(order.when);
        let (small, large) = (self.number(order.small)?, self.number(order.large)?);
        let (holds, relation) = match order.relation {
            Below => (small < large, "below"),
            AtMost => (small <= large, "at most"),
        };
        if holds || !matters || !self.sound(&keys) {
            return None;
        }
        let what = format!(
            "{} is {small} but must be {relation} {}, which is {large}, {}",
            order.small, order.large, order.why
        );
        Some(self.fault(&keys, what))
    }

    /// The fault of a swelling that leaves too little to print of some mark: of the one that has least.
    fn swell_fault(&self) -> Option<Fault> {
        let left = |(path, when, times): &(&'static str, &[&str], f32)| {
            let width = self.number(path)?;
            (self.all_on(when) && self.sound(&[path, "print.swell"]))
                .then(|| (*path, width, width - times * self.print.swell))
        };
        let (path, width, left) = NARROW.iter().filter_map(left).min_by(|a, b| a.2.total_cmp(&b.2))?;
        let swell = self.print.swell;
        if left >= LEAST_PRINTED || swell <= 0.0 {
            return None;
        }
        let what = format!(
            "print.swell is {swell} mm, which leaves too little to print of {path}, which is {width} mm, lessen the \
             one or enlarge the other"
        );
        Some(self.fault(&[path, "print.swell"], what))
    }

    fn number(&self, path: &str) -> Option<f32> {
        let key = KEYS.iter().find(|key| key.path == path)?;
        if let Value::Number(number) = key.value(self) { Some(number) } else { None }
    }

    fn all_on(&self, switches: &[&str]) -> bool {
        let mut keys = KEYS.iter().filter(|key| switches.contains(&key.path));
        keys.all(|key| key.value(self) == Value::Switch(true))
    }

    /// A glyph that fits its place but leaves too little blank to the next.
    fn spacing_fault(&self, glyph: &'static str, pitch: &'static str) -> Option<Fault> {
        let keys = [glyph, pitch, BLANK];
        let (size, step, blank) = (self.number(glyph)?, self.number(pitch)?, self.number(BLANK)?);
        // Sums of decimal numbers are a little off in f32.
        let holds = size + blank <= step + 1e-4;
        // What is wrong with one of the numbers by itself is told by the other rules.
        let told = size >= step || blank > self.textures.thickness;
        if holds || told || !self.figure.textures || !self.sound(&keys) {
            return None;
        }
        let least = ((size + blank) * 1000.0).round() / 1000.0;
        let what = format!(
            "{pitch} is {step} but must be at least {least}, which is {glyph} and {BLANK} together, or the blank \
             between two glyphs is not felt"
        );
        Some(self.fault(&keys, what))
    }
}

#[cfg(test)]
mod tests;
