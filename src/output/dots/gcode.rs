//! G-code for BrailleRAP, the embosser of open hardware that presses dots anywhere.
//!
//! ```text
//! G28 X; title                 the needle to its end stop
//! G28 Y; tactograph 0.1.0      the paper is drawn in until its end stop tells
//! M204 T1500;                  acceleration, mm/s2
//! G1 F6000;                    feed, mm/min
//! G1 X0.00 Y0.00;
//! G1 X12.40 Y31.05;            for each dot: there,
//! M3 S1;                       magnet on,
//! M3 S0;                       magnet off
//! ...
//! G1 F6000;
//! G1 X0.00 Y317.00;            the paper is fed out
//! M84; as written ...          motors off; a number that tells whether anybody has changed the file
//! ```
//!
//! Lines end with CR LF. Commands and their order are those of DesktopBrailleRAP (commit a6b9ba1), the machine's own
//! program; only the order of the dots is ours ([`super::path_order`]). The firmware is Marlin: millimetres and
//! absolute positions by default (it is built without inches), `;` begins a comment. A comment follows a command,
//! never on a line of its own: Marlin answers no `ok` to a line without a command, and a plain sender waits for one.
//!
//! **Orientation.** X runs to the right, Y down the sheet as it is read, (0, 0) is the top left corner of what can be
//! reached. The older firmware (BrailleRAP, Marlin 1) is at Y -20 after homing, the newer one (MarlinBraille2) at 0;
//! going to (0, 0) makes them equal. Nothing is mirrored: the magnet sits below the paper and pushes the dots up, and
//! the machine's own programs write braille from left to right with rising X. (3D printers used as embossers press
//! from above and need the mirrored picture; this is not for them.)
//!
//! **Time.** `M3` waits until the move has ended. `S1` holds the magnet 15 ms on and 10 ms off (MarlinBraille2) and
//! lets it go by itself, so that it cannot overheat. Each move starts and ends at rest, so short distances matter
//! more than a high feed.

use std::fmt::Write;

use super::path_order::{self, DotPosition};
use crate::output::seal;
use crate::output::text::{plain, push_hundredths};

/// How far beyond the paper's length the paper is fed to come out, mm (DesktopBrailleRAP).
const EJECT: f64 = 20.0;
/// The feed at which paper is fed out at most, mm/min (DesktopBrailleRAP).
const EJECT_FEED: u32 = 6000;
/// No BrailleRAP reaches farther, mm; bounds the numbers in G-code.
const MOST_MM: f32 = 2000.0;

/// What the machine can do and how it is driven.
#[derive(Debug, Clone, PartialEq)]
pub struct Params {
    /// What the needle reaches from its zero: across and down, mm. Above 0, at most 2000.
    pub limits: [f32; 2],
    /// Where on the sheet, from its top left corner, the needle's zero is, mm: it is subtracted from each dot's
    /// position. [0, 0] as in DesktopBrailleRAP, whose sheet begins where the needle does.
    pub origin: [f32; 2],
    /// Length of the paper, mm, which is fed out 20 mm beyond it. Above 0, at most 2000. Firmware stops at its own
    /// limit (420 mm in MarlinBraille2), which an A3 sheet meets; it clamps and goes on.
    pub paper_length: f32,
    /// mm/s2, at least 1; 1500 by default as in DesktopBrailleRAP and AccessBrailleRAP (whose fast mode has 8000). The
    /// firmware caps it at 3000 an axis (MarlinBraille2; 1500 in BrailleRAP-SP).
    pub acceleration: u32,
    /// mm/min along the path, at least 1; 6000 by default as in both programs (fast mode 10000). The firmware caps it
    /// at 18000 an axis.
    pub feed: u32,
    /// How far the paper may be pulled back at most: no dot lies farther above any dot that was pressed before it,
    /// mm, at least 0; infinity for no limit. 12 by default.
    ///
    /// Rollers turn the paper under the needle, and each time it is pulled far back it can slip or its end can leave
    /// the guide, so that dots no longer meet. DesktopBrailleRAP goes strictly row by row by default (0 mm back) and
    /// lets its user choose bands of 2 mm or blocks of 12 mm, which are in use; it says nothing of slipping, and no
    /// measurement is known. So 12 mm is the most that is known to be done. It costs travel: for a drawing of lines
    /// some 60 % over paths that go anywhere (5.4 m instead of 3.3 m for 1,070 dots; 2.4 minutes instead of 2.0), for
    /// text 12 %, for textures nothing (`tools/src/bin/travel.rs`).
    pub most_back: f32,
    /// A comment in the first line.
    pub title: String,
}

impl Params {
    /// BrailleRAP with A4: 190 mm across and 250 mm down can be reached (DesktopBrailleRAP's default).
    pub fn a4() -> Self {
        Self {
            limits: [190.0, 250.0],
            origin: [0.0, 0.0],
            paper_length: 297.0,
            acceleration: 1500,
            feed: 6000,
            most_back: 12.0,
            title: String::new(),
        }
    }
}

/// [`Params::a4`], whose limits every machine reaches.
impl Default for Params {
    fn default() -> Self {
        Self::a4()
    }
}

/// Why there is no G-code; one line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// Dots that the needle does not reach.
    #[error(
        "{count} of {all} dots lie off the {} x {} mm that the machine reaches: \
         they need {:.2} to {:.2} mm across and {:.2} to {:.2} mm down",
        .limits[0], .limits[1], .from[0], .to[0], .from[1], .to[1]
    )]
    OffLimits {
        /// How many.
        count: usize,
        /// How many there are in all.
        all: usize,
        /// What the needle reaches, mm.
        limits: [f32; 2],
        /// Least position across and down of all dots, mm from the needle's zero.
        from: [f32; 2],
        /// Greatest position across and down of all dots.
        to: [f32; 2],
    },
    /// Dots whose position is not finite.
    #[error("{count} of {all} dots have no position that is a number; give positions in millimetres")]
    NoPosition {
        /// How many.
        count: usize,
        /// How many there are in all.
        all: usize,
    },
    /// Parameters out of their ranges; all of them.
    #[error("the machine cannot be driven so: {0}")]
    Params(String),
}

/// G-code of one sheet with `dots` (page space), each position of 0.01 mm once, in an order that does not depend on
/// theirs.
///
/// # Errors
/// Dots off the limits after rounding to 0.01 mm or without a position, parameters out of their ranges.
pub fn write(dots: &[crate::units::MmPoint], params: &Params) -> Result<String, Refused> {
    check(params)?;
    let positions = positions(dots, params)?;
    let end = [0, hundredths(f64::from(params.paper_length) + EJECT)];
    let most_back = if params.most_back.is_finite() { hundredths(f64::from(params.most_back)) } else { i32::MAX };
    let path = path_order::order(&positions, [[0, 0], end], most_back);

    // Some 34 bytes a dot.
    let mut out = String::with_capacity(300 + params.title.len() + 40 * path.len());
    let title = plain(&params.title);
    line(&mut out, format_args!("{}", format!("G28 X; {title}").trim_end()));
    line(&mut out, format_args!(concat!("G28 Y; ", env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"))));
    line(&mut out, format_args!("M204 T{};", params.acceleration));
    line(&mut out, format_args!("G1 F{};", params.feed));
    go(&mut out, [0, 0]);
    for position in path {
        go(&mut out, position);
        line(&mut out, format_args!("M3 S1;"));
        line(&mut out, format_args!("M3 S0;"));
    }
    line(&mut out, format_args!("G1 F{};", params.feed.min(EJECT_FEED)));
    go(&mut out, end);
    let seal = sealed(out.as_bytes());
    Ok(out + &seal)
}

/// Whether these bytes are G-code as [`write()`] makes it, changed by nobody since.
pub fn is_as_written(bytes: &[u8]) -> bool {
    let last = sealed(&[]).len();
    bytes.split_at_checked(bytes.len().saturating_sub(last)).is_some_and(|(body, end)| end == sealed(body).as_bytes())
}

/// The last line: motors off, and the seal of all before it.
fn sealed(body: &[u8]) -> String {
    format!("M84; as written {}\r\n", seal::of(body))
}

fn check(params: &Params) -> Result<(), Refused> {
    let mut faults = Vec::new();
    let mut need = |fine: bool, fault: String| (!fine).then(|| faults.push(fault));
    let length = |value: f32| value > 0.0 && value <= MOST_MM;
    let [across, down] = params.limits;
    need(
        length(across) && length(down),
        format!("limits of {across} x {down} mm must be above 0 and at most {MOST_MM}"),
    );
    let [x, y] = params.origin;
    need(
        x.abs() <= MOST_MM && y.abs() <= MOST_MM,
        format!("a zero at {x}, {y} mm must be within {MOST_MM} of the sheet"),
    );
    let paper = params.paper_length;
    need(length(paper), format!("paper {paper} mm long must be above 0 and at most {MOST_MM}"));
    need(params.acceleration > 0, "the acceleration must be at least 1 mm/s2".into());
    need(params.feed > 0, "the feed must be at least 1 mm/min".into());
    let back = params.most_back;
    need(back >= 0.0, format!("pulling paper back {back} mm must be at least 0"));
    if faults.is_empty() { Ok(()) } else { Err(Refused::Params(faults.join("; "))) }
}

/// The dots as the machine is told them.
fn positions(dots: &[crate::units::MmPoint], params: &Params) -> Result<Vec<DotPosition>, Refused> {
    let (all, [x, y]) = (dots.len(), params.origin.map(f64::from));
    let count = dots.iter().filter(|dot| !dot.is_finite()).count();
    if count > 0 {
        return Err(Refused::NoPosition { count, all });
    }
    let position = |dot: &crate::units::MmPoint| [hundredths(f64::from(dot.x) - x), hundredths(f64::from(dot.y) - y)];
    let positions: Vec<DotPosition> = dots.iter().map(position).collect();
    let most = params.limits.map(|limit| hundredths(f64::from(limit)));
    let off = |at: &&DotPosition| (0..2).any(|axis| at[axis] < 0 || at[axis] > most[axis]);
    let count = positions.iter().filter(off).count();
    if count == 0 {
        return Ok(positions);
    }
    let extreme = |axis: usize, pick: fn(i32, i32) -> i32| {
        positions.iter().map(|at| at[axis]).reduce(pick).map_or(0.0, |value| value as f32 / 100.0)
    };
    let limits = params.limits;
    let from = [extreme(0, i32::min), extreme(1, i32::min)];
    let to = [extreme(0, i32::max), extreme(1, i32::max)];
    Err(Refused::OffLimits { count, all, limits, from, to })
}

/// Millimetres in whole hundredths; saturates far beyond any machine.
fn hundredths(mm: f64) -> i32 {
    (mm * 100.0).round() as i32
}

fn go(out: &mut String, [x, y]: DotPosition) {
    // never below 0: the limits say so
    out.push_str("G1 X");
    push_hundredths(out, x.unsigned_abs());
    out.push_str(" Y");
    push_hundredths(out, y.unsigned_abs());
    out.push_str(";\r\n");
}

fn line(out: &mut String, text: std::fmt::Arguments<'_>) {
    // Writing to a text cannot fail.
    let _ = out.write_fmt(text);
    out.push_str("\r\n");
}
