//! Textures on a grid: which of its dots are set.

use super::field::Field;
use super::pattern::{GridSteps, Pattern};
use super::small_components;
use crate::classes::Class;
use crate::devices::Grid;
use crate::lines::Line;
use crate::textures::Sign;
use crate::units::MmPoint;

/// The dots of a grid that would be set if there were no lines.
pub(super) struct GridCandidates<'a> {
    field: &'a Field<'a>,
    grid: &'a Grid,
    columns: GridSteps,
    rows: GridSteps,
    /// The pattern of each class; none on a grid that has no patterns.
    patterns: [(Class, Option<Pattern>); Class::ALL.len()],
    /// The region of each dot of the grid, row by row, if it would be set.
    regions: Vec<Option<u32>>,
}

impl<'a> GridCandidates<'a> {
    pub(super) fn of(field: &'a Field<'a>, grid: &'a Grid) -> Self {
        let columns = GridSteps::of(&grid.columns, field.area.min.x, field.area.max.x);
        let rows = GridSteps::of(&grid.rows, field.area.min.y, field.area.max.y);
        let sign = |class| field.params.palette.sign(class);
        let patterns = Class::ALL.map(|class| (class, Pattern::of(sign(class), columns, rows)));
        let mut candidates = Self { field, grid, columns, rows, patterns, regions: Vec::new() };
        candidates.regions = (0..grid.columns.len() * grid.rows.len()).map(|dot| candidates.region(dot)).collect();
        candidates
    }

    /// The region of a dot, if its pattern has a dot here.
    fn region(&self, dot: usize) -> Option<u32> {
        let at = self.at(dot);
        let (region, amount) = self.field.at(at).filter(|_| self.field.holds(at))?;
        let pattern = self.pattern(self.field.class_of(region))?;
        let width = self.width();
        let (x, y) = ((dot % width) as i32 - self.columns.origin, (dot / width) as i32 - self.rows.origin);
        (pattern.needed_amount(x, y) <= amount).then_some(region)
    }

    fn width(&self) -> usize {
        self.grid.columns.len()
    }

    fn at(&self, dot: usize) -> MmPoint {
        MmPoint::new(self.grid.columns[dot % self.width()], self.grid.rows[dot / self.width()])
    }

    fn pattern(&self, class: Class) -> Option<Pattern> {
        self.patterns.iter().find(|(other, _)| *other == class).and_then(|(_, pattern)| *pattern)
    }

    fn sign(&self, class: Class) -> Sign {
        self.field.params.palette.sign(class)
    }

    /// The dots of each region with at least `gap` empty dots between them and those of lines.
    pub(super) fn dots(&self, lines: &[Line], gap: u32) -> Vec<Vec<MmPoint>> {
        let regions = &self.field.classes.regions;
        let mut sets = vec![Vec::new(); regions.len()];
        let taken = near_lines(lines, self.grid, gap as usize);
        let owners: Vec<Option<u32>> =
            self.regions.iter().zip(taken).map(|(region, taken)| region.filter(|_| !taken)).collect();
        for dot in 0..owners.len() {
            if let Some(region) = owners[dot].filter(|region| !self.yields(&owners, dot, *region)) {
                sets[region as usize].push(self.at(dot));
            }
        }
        for (set, region) in sets.iter_mut().zip(regions) {
            if let Some(pattern) = self.pattern(region.class) {
                let spacing = pattern.spacing(self.columns, self.rows, self.field.params.pitch);
                small_components::leave_out(set, self.sign(region.class), spacing, self.field.params.least);
            }
        }
        sets
    }

    /// Whether a dot has a neighbour of another class and yields to it: one empty dot lies between two textures. The
    /// smaller region keeps its dots, since it has fewer to show its class by.
    fn yields(&self, owners: &[Option<u32>], dot: usize, region: u32) -> bool {
        let (regions, width) = (&self.field.classes.regions, self.width());
        let own = regions[region as usize];
        let (x, y) = (dot % width, dot / width);
        let rows = y.saturating_sub(1)..(y + 2).min(owners.len() / width);
        rows.flat_map(|row| (x.saturating_sub(1)..(x + 2).min(width)).map(move |column| row * width + column))
            .filter_map(|near| owners[near])
            .map(|near| regions[near as usize])
            .any(|near| near.class != own.class && (near.cells, near.class) < (own.cells, own.class))
    }
}

/// Which dots of the grid have fewer than `gap` empty ones between them and the dots of lines, these included.
fn near_lines(lines: &[Line], grid: &Grid, gap: usize) -> Vec<bool> {
    let (width, height) = (grid.columns.len(), grid.rows.len());
    let mut taken = vec![false; width * height];
    for at in lines.iter().flat_map(|line| &line.runs).flat_map(|run| &run.points) {
        if let Some([x, y]) = grid.nearest(*at) {
            for row in y.saturating_sub(gap)..(y + gap + 1).min(height) {
                taken[row * width + x.saturating_sub(gap)..row * width + (x + gap + 1).min(width)].fill(true);
            }
        }
    }
    taken
}
