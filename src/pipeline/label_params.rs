//! How labels are placed on a page: what its medium and its profile ask for.

use std::f32::consts::{FRAC_1_SQRT_2, SQRT_2};

use super::label::CLEARANCE;
use crate::devices::DotArea;
use crate::labels::{FROM_KEPT_LEADER, Params};
use crate::legibility::{LEADER_FROM_BRAILLE, OWN_LEADER_GAP};
use crate::page::Medium;
use crate::page::cells::{CellGrid, LEAST_OF_LETTERS};
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::units::MmRect;

// labels stand where the check finds their leader lines
const _: () = assert!(FROM_KEPT_LEADER <= LEADER_FROM_BRAILLE);

/// Blank between labels and the dots of textures, which are as large as those of braille, mm: the width of a cell.
const TO_DOTS: f32 = 6.0;
/// Step in which places for labels are looked for where they can stand anywhere, mm: less than a fingertip can tell.
const STEP: f32 = 1.0;

/// Blank between braille and signs, mm.
pub(super) fn blank_to_signs(medium: &Medium) -> f32 {
    match medium {
        Medium::Print(_) => CLEARANCE,
        Medium::Dots(_) => TO_DOTS,
    }
}

/// Twice the widest line of most profiles, mm.
const WIDEST: f32 = 3.0;
/// What the squares in which lines are looked at may add to the breadth of one, mm.
const SQUARES: f32 = 1.0;
/// Parts of a texture beside braille that are lower are read as a line of it, mm: three dots, 2.5 mm apart.
const THREE_ROWS: f32 = 7.5;
/// The same where dots are as far apart as those of letters: two lines, 10 mm from one to the next, and a dot more.
const TWO_LINES: f32 = 17.5;

/// Labels may lie in the frame, on paper as far as the frame leaves its clearance. On a grid the
/// frame is some columns from the outermost of the figure, which may lie a step within it.
pub(super) fn params(layout: &Layout, tiles: &[MmRect], plan: &Plan) -> Params {
    let beside = plan.layout().frame.map_or(0.0, |frame| (frame.gap - CLEARANCE).max(0.0));
    let (step, area) = match &layout.medium {
        Medium::Print(_) => (STEP, layout.room.inflate(beside, beside)),
        Medium::Dots(dots) => {
            let radius = 0.5 * dots.diameter();
            let reach = dots.area.bounds().inflate(radius, radius);
            let step = match dots.area {
                DotArea::Grid(_) => dots.pitch,
                DotArea::Free(_) => STEP,
            };
            (step, layout.room.intersection_unchecked(&reach))
        }
    };
    let may_cross = !matches!(&layout.medium, Medium::Dots(dots) if !dots.device.takes_paper());
    let texture_clearance = blank_to_signs(&layout.medium);
    // a stroke reaches nearer to its label than its middle by half of its width; the dots of a leader line reach half a
    // step further than those of a label, and lie up to half of the diagonal of four dots off its place
    let (leader_off, least_before_leader) = match &layout.medium {
        Medium::Print(_) => (0.0, OWN_LEADER_GAP + 0.5 * plan.lines().width_min),
        Medium::Dots(dots) => (0.5 * dots.diameter() + dots.pitch * FRAC_1_SQRT_2, OWN_LEADER_GAP),
    };
    let (dot_pitch, least_texture) = match &layout.medium {
        Medium::Print(_) => (0.0, 0.0),
        Medium::Dots(dots) if dots.pitch < LEAST_OF_LETTERS => (dots.pitch, THREE_ROWS),
        Medium::Dots(dots) => (dots.pitch, TWO_LINES),
    };
    // the second row of a heavy line lies a step beside the first; twice as broad for a slanted way across it
    let widest_outline = match &layout.medium {
        Medium::Print(_) => (2.0 * plan.lines().width_max).max(WIDEST),
        Medium::Dots(dots) => SQRT_2 * (dots.pitch + dots.diameter()) + SQUARES,
    };
    let (tiles, lines) = (tiles.to_vec(), plan.lines());
    let [more_aside, off_ticks] = asides(layout, plan);
    Params {
        area,
        tiles,
        points: Vec::new(),
        leaders: Vec::new(),
        written: Vec::new(),
        blocked: Vec::new(),
        clearance: CLEARANCE,
        more_aside,
        off_ticks,
        among_cells: matches!(&layout.medium, Medium::Dots(dots) if dots.device.cell_dots().is_some()),
        line_gap: lines.min_gap,
        least_strength: lines.least_strength,
        texture_clearance,
        least_texture,
        has_coloured_ground: false,
        may_cross,
        step,
        dot_pitch,
        leader_off,
        least_before_leader,
        widest_outline,
    }
}

/// How much more blank than the clearance there is to be between a label and a line beside it, mm: as much as keeps the
/// dots of the line off the first column of a next cell. Where the line is cells itself, a whole cell: one beside the
/// label would be read as a letter of it. The second is that of numbers beside ticks: on pins, where the two dots of a
/// tick are as those of a letter, a whole cell too.
fn asides(layout: &Layout, plan: &Plan) -> [f32; 2] {
    let Medium::Dots(dots) = &layout.medium else { return [0.0; 2] };
    let size = CellGrid::of(&layout.medium, plan.profile().braille.cell).size();
    let beyond = |columns: f32| (columns + 0.5 * dots.pitch - dots.diameter() - CLEARANCE).max(0.0);
    let (most, whole) = (beyond(size.cell - size.dot), beyond(size.cell));
    match (dots.device.cell_dots().is_some(), dots.device.takes_paper()) {
        (true, _) => [whole; 2],
        (false, true) => [most; 2],
        (false, false) => [most, whole],
    }
}
