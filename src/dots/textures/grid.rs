//! Textures on a grid: which of its dots are set.

use super::pattern::{Pattern, Steps};
use super::{Field, strays};
use crate::classes::Class;
use crate::devices::Grid;
use crate::lines::Line;
use crate::units::MmPoint;

/// The dots of each region; none on a grid that has no patterns.
pub(super) fn fill(field: &Field<'_>, lines: &[Line], grid: &Grid) -> Vec<Vec<MmPoint>> {
    let mut sets = vec![Vec::new(); field.classes.regions.len()];
    let width = grid.columns.len();
    let columns = Steps::of(&grid.columns, field.area.min.x, field.area.max.x);
    let rows = Steps::of(&grid.rows, field.area.min.y, field.area.max.y);
    let sign = |class| field.params.palette.sign(class);
    let patterns = Class::ALL.map(|class| (class, Pattern::of(sign(class), columns, rows)));
    let pattern_of =
        |class: Class| patterns.iter().find(|(other, _)| *other == class).and_then(|(_, pattern)| *pattern);
    let taken = near_lines(lines, grid, field.params.line_gap as usize);
    let at = |dot: usize| MmPoint::new(grid.columns[dot % width], grid.rows[dot / width]);
    let owner = |dot: usize| {
        let (region, amount) = field.at(at(dot)).filter(|_| !taken[dot] && field.holds(at(dot)))?;
        let pattern = pattern_of(field.class_of(region))?;
        let (x, y) = ((dot % width) as i32 - columns.origin, (dot / width) as i32 - rows.origin);
        (pattern.needed_amount(x, y) <= amount).then_some(region)
    };
    let owners: Vec<Option<u32>> = (0..width * grid.rows.len()).map(owner).collect();
    for dot in 0..owners.len() {
        if let Some(region) = owners[dot].filter(|region| !gives_way(field, &owners, width, dot, *region)) {
            sets[region as usize].push(at(dot));
        }
    }
    for (set, region) in sets.iter_mut().zip(&field.classes.regions) {
        if let Some(pattern) = pattern_of(region.class) {
            strays::leave_out(set, sign(region.class), pattern.apart(columns, rows, field.params.pitch));
        }
    }
    sets
}

/// Which dots of the grid are nearer to the dots of lines than `gap` empty ones, the dots of lines among them.
fn near_lines(lines: &[Line], grid: &Grid, gap: usize) -> Vec<bool> {
    let (width, height) = (grid.columns.len(), grid.rows.len());
    let mut taken = vec![false; width * height];
    for at in lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points) {
        if let (Some(x), Some(y)) = (nearest(&grid.columns, at.x), nearest(&grid.rows, at.y)) {
            for row in y.saturating_sub(gap)..(y + gap + 1).min(height) {
                taken[row * width + x.saturating_sub(gap)..row * width + (x + gap + 1).min(width)].fill(true);
            }
        }
    }
    taken
}

/// The number of the place nearest to `at`.
fn nearest(places: &[f32], at: f32) -> Option<usize> {
    let above = places.partition_point(|place| *place < at);
    let candidates = above.saturating_sub(1)..(above + 1).min(places.len());
    candidates.min_by(|a, b| (places[*a] - at).abs().total_cmp(&(places[*b] - at).abs()))
}

/// Whether a dot has a neighbour that says another class, and leaves the place to it: one empty dot lies between two
/// textures. The smaller region keeps its dots, since it has fewer to tell its colour by.
fn gives_way(field: &Field<'_>, owners: &[Option<u32>], width: usize, dot: usize, region: u32) -> bool {
    let own = field.classes.regions[region as usize];
    let (x, y) = (dot % width, dot / width);
    let rows = y.saturating_sub(1)..(y + 2).min(owners.len() / width);
    rows.flat_map(|row| (x.saturating_sub(1)..(x + 2).min(width)).map(move |column| row * width + column))
        .filter_map(|near| owners[near])
        .map(|near| field.classes.regions[near as usize])
        .any(|near| near.class != own.class && (near.cells, near.class) < (own.cells, own.class))
}
