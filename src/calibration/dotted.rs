//! Samples for a device of dots. What a device fixes cannot be chosen: the size of its dots, and on a grid where they
//! can be. What is left is felt here.
//!
//! ```text
//!  a  dots.pitch        lines across, up and slanting; where dots can be anywhere, lines of several pitches
//!  b  dots.line_gap     pairs of lines with 1 to 5 empty dots between them
//!  c  dots.heavy_from   a weak line and a heavy one: one row and two, or three heights
//!  d  frame.pitch       lines of every dot, every second, third and fourth
//!  e  dots.texture_gap  a texture 0 to 3 empty dots from a line
//!  f  textures.palette  the texture of each class that the device can carry, dense
//!  g  textures.palette  the same, sparse
//!  h  dots.pitch        where dots can be anywhere: the dense textures at the other pitches, each in a row of its own
//! ```
//!
//! All is counted in columns and rows; a device without a grid gets one of its own pitch.

use super::flow::{self, Block};
use super::headings::{self, BLANK, Decides, heading_of};
use crate::braille;
use crate::classes::Class;
use crate::devices::{DotArea, Grid, Pitches};
use crate::dots::textures;
use crate::lines::{Height, Line};
use crate::page::cells::CellGrid;
use crate::page::{DotMedium, Dots, Figure, Medium, Page, Parts, Texture};
use crate::profile::Plan;
use crate::units::{MmPoint, MmRect, MmVector, Size};
use crate::{Error, dots};

/// Length of a line, mm: as on paper.
const LENGTH: f32 = 25.0;
/// Width and height of a texture, mm: 13 x 13 mm is quoted as the smallest area whose texture can be identified, and
/// rows of dots lie up to 7.5 mm apart.
const PATCH: [f32; 2] = [22.0, 16.0];
/// Empty dots between two lines.
const GAPS: [usize; 5] = [1, 2, 3, 4, 5];
/// Additional empty dots after a pair of lines: with the blank between samples, more than the widest gap in a pair.
const PAIR_GAP: usize = 3;
/// Every how many dots a line has one.
const EVERY: [usize; 4] = [1, 2, 3, 4];
/// Empty dots between a line and a texture.
const TEXTURE_GAPS: [usize; 4] = [0, 1, 2, 3];
/// Pitches where any can be had, mm: what Index embossers have, and wider up to frames.
const PITCHES: [f32; 6] = [1.6, 2.0, 2.4, 2.5, 3.0, 4.0];
/// Two pitches nearer than this are one, mm: half of the least step between those above.
const SAME_PITCH: f32 = 0.05;
/// Lightness of the colours of textures, 0..=1: a full colour.
const LIGHTNESS: f32 = 0.5;

/// The texture of a sample.
#[derive(Debug, Clone, Copy)]
struct Patch {
    class: Class,
    /// How dense it is, 0..=1.
    density: f32,
    /// How many columns it lies from the corner.
    gap: usize,
    /// From dot to dot along its rows, mm: that of the grid, or another where dots can be anywhere.
    pitch: f32,
}

/// What is raised: dots in columns and rows from the sample's own corner, or a texture.
#[derive(Debug, Clone, Default)]
struct DottedSample {
    dots: Vec<(usize, usize, Height)>,
    /// Dots off the grid, mm from the corner; only for devices that have none.
    free: Vec<MmVector>,
    texture: Option<Patch>,
    columns: usize,
    rows: usize,
}

struct DottedSection {
    keys: Decides,
    samples: Vec<DottedSample>,
    key: String,
}

/// What stands in a place of a sheet.
enum DottedItem<'a> {
    Heading(Vec<Vec<u8>>),
    DottedSample(&'a DottedSample, usize),
}

/// The device on its sheet.
struct Bed<'a> {
    plan: &'a Plan,
    medium: Medium,
    dots: DotMedium,
    grid: Grid,
    params: dots::Params,
}

/// The sheets for a device, one page each.
///
/// # Errors
/// [`Error::NoRoom`] if a sheet has no room for a sample.
pub(super) fn sheets(plan: &Plan, dots: DotMedium) -> Result<Vec<Page>, Error> {
    let profile = plan.profile();
    let grid = match &dots.area {
        DotArea::Grid(grid) => grid.clone(),
        DotArea::Free(area) => even(*area, dots.pitch),
    };
    let params = plan.dots(&dots);
    let bed = Bed { plan, medium: Medium::Dots(dots.clone()), dots, grid, params };
    let area = bed.area();
    let cells = CellGrid::of(&bed.medium, profile.braille.cell);
    let sections = bed.sections();
    let (mut blocks, mut items) = (Vec::new(), Vec::new());
    let size = |item: &DottedItem<'_>| bed.size(item, &cells);
    for (number, section) in sections.iter().enumerate() {
        let heading = DottedItem::Heading(heading_of(number, section.keys, cells.cells_in(area.width())));
        let keeps = Block { size: size(&heading), section: number, starts_row: true, keeps: true, ..Block::default() };
        blocks.push(keeps);
        items.push(heading);
        for (i, sample) in section.samples.iter().enumerate() {
            let item = DottedItem::DottedSample(sample, i + 1);
            blocks.push(Block { size: size(&item), section: number, starts_row: i == 0, ..Block::default() });
            items.push(item);
        }
    }
    let sheet = [profile.page.width, profile.page.height];
    let placed = flow::place(blocks, area.size().to_vector()).map_err(|flow::TooLarge(size)| Error::NoRoom {
        sample: format!("{:.0} x {:.0} mm", size.x.ceil(), size.y.ceil()),
        sheet: format!("{} x {} mm", sheet[0], sheet[1]),
    })?;
    let count = placed.len();
    let mut items = items.iter();
    let mut pages = Vec::new();
    for (index, on_sheet) in placed.iter().enumerate() {
        let with_items: Vec<_> = on_sheet.iter().zip(items.by_ref()).collect();
        let has = |section: usize| on_sheet.iter().any(|(block, _)| block.section == section);
        let keys = sections.iter().enumerate().filter(|(section, _)| has(*section));
        let keys: String = keys.map(|(i, section)| headings::told(i, section.keys, &section.key)).collect();
        let words = headings::words_of(plan, (index + 1, count), &keys);
        pages.push(bed.page(&with_items, &cells, words)?);
    }
    Ok(pages)
}

/// Columns and rows at this pitch in a rectangle that has none.
fn even(area: MmRect, pitch: f32) -> Grid {
    let steps = |from: f32, length: f32| (0..=(length / pitch) as usize).map(|i| from + i as f32 * pitch).collect();
    Grid { columns: steps(area.min.x, area.width()), rows: steps(area.min.y, area.height()) }
}

/// From column to column, on average where they are uneven, mm.
fn step(centres: &[f32], pitch: f32) -> f32 {
    match centres {
        [first, .., last] => (last - first) / (centres.len() - 1) as f32,
        _ => pitch,
    }
}

impl Bed<'_> {
    /// Where marks can be, as the margin says.
    fn area(&self) -> MmRect {
        let [width, height, margin] = {
            let page = &self.plan.profile().page;
            [page.width, page.height, page.margin]
        };
        let radius = 0.5 * self.dots.diameter();
        let inner = MmRect::new(MmPoint::new(margin, margin), MmPoint::new(width - margin, height - margin));
        self.grid.bounds().inflate(radius, radius).intersection(&inner).unwrap_or_else(MmRect::zero)
    }

    /// How many columns and rows are this long.
    fn count(&self, mm: f32) -> [usize; 2] {
        [&self.grid.columns, &self.grid.rows]
            .map(|centres| (mm / step(centres, self.dots.pitch)).round().max(2.0) as usize)
    }

    fn sections(&self) -> Vec<DottedSection> {
        let pitch = self.dots.pitch;
        let mut sections = vec![self.pitches()];
        let [_, long] = self.count(LENGTH);
        let upright = |column: usize| (0..=long).map(move |row| (column, row, Height::High));
        let sample = |dots: Vec<_>, columns| DottedSample { dots, columns, rows: long, ..DottedSample::default() };
        let pair = |gap: usize| sample(upright(0).chain(upright(gap + 1)).collect(), gap + 1 + PAIR_GAP);
        sections.push(DottedSection {
            keys: &["dots.line_gap"],
            samples: GAPS.map(pair).to_vec(),
            key: format!("pairs of lines with {} empty dots between them", headings::listed(&GAPS)),
        });
        let of_height = |height| sample(upright(0).map(|(x, y, _)| (x, y, height)).collect(), 0);
        let (samples, key) = if self.params.has_heights {
            let heights = [Height::Low, Height::Middle, Height::High].map(of_height);
            (heights.to_vec(), "lines of low, middle and high dots")
        } else {
            (
                vec![of_height(Height::High), sample(upright(0).chain(upright(1)).collect(), 1)],
                "lines of one row of dots, and of two",
            )
        };
        sections.push(DottedSection { keys: &["dots.heavy_from"], samples, key: key.to_owned() });
        let every = |n: usize| sample(upright(0).step_by(n).collect(), 0);
        sections.push(DottedSection {
            keys: &["frame.pitch"],
            samples: EVERY.map(every).to_vec(),
            key: format!(
                "lines with every dot, every second, third and fourth, {pitch} mm from dot to dot on the grid"
            ),
        });
        let classes = self.carried(pitch);
        if let Some(&class) = classes.first() {
            let beside = |gap: usize| {
                let sample = self.textured(Patch { class, density: 1.0, gap: gap + 1, pitch });
                DottedSample { dots: (0..sample.rows).map(|row| (0, row, Height::High)).collect(), ..sample }
            };
            let key =
                format!("the texture of {} {} empty dots from a line", class.name(), headings::listed(&TEXTURE_GAPS));
            sections.push(DottedSection {
                keys: &["dots.texture_gap"],
                samples: TEXTURE_GAPS.map(beside).to_vec(),
                key,
            });
            let names = classes.iter().map(|class| class.name()).collect::<Vec<_>>().join(", ");
            for (density, how) in [(1.0, "dense"), (0.0, "sparse")] {
                let of_class = |&class: &Class| self.textured(Patch { class, density, gap: 0, pitch });
                let samples = classes.iter().map(of_class).collect();
                sections.push(DottedSection {
                    keys: &["textures.palette"],
                    samples,
                    key: format!("{how} textures of {names}"),
                });
            }
        }
        sections.extend(self.textures_at_other_pitches());
        sections
    }

    /// Pitches to be felt where any can be had; none where the grid has one.
    fn choices(&self) -> Vec<f32> {
        match self.dots.device.pitches() {
            Pitches::Between(least, most) => {
                PITCHES.into_iter().filter(|pitch| (least..=most).contains(pitch)).collect()
            }
            Pitches::Listed(_) => Vec::new(),
        }
    }

    /// The dense textures that can be felt at each pitch but that of the sheet, whose textures are there already.
    fn textures_at_other_pitches(&self) -> Vec<DottedSection> {
        let other = self.choices().into_iter().filter(|pitch| (pitch - self.dots.pitch).abs() >= SAME_PITCH);
        let section = |pitch: f32| {
            let classes = self.carried(pitch);
            let names = classes.iter().map(|class| class.name()).collect::<Vec<_>>().join(", ");
            let of_class = |&class: &Class| self.textured(Patch { class, density: 1.0, gap: 0, pitch });
            let samples = classes.iter().map(of_class).collect();
            let key = format!("dense textures of {names}, of dots {pitch} mm apart");
            (!classes.is_empty()).then_some(DottedSection { keys: &["dots.pitch"], samples, key })
        };
        other.filter_map(section).collect()
    }

    /// Lines of the grid's own pitch; where any pitch can be had, of several.
    fn pitches(&self) -> DottedSection {
        let [wide, long] = self.count(LENGTH);
        match self.dots.device.pitches() {
            Pitches::Between(..) => {
                let pitches = self.choices();
                let free = |pitch: f32| {
                    let dots = (0..=(LENGTH / pitch) as usize).map(|i| MmVector::new(0.0, i as f32 * pitch));
                    DottedSample { free: dots.collect(), rows: long, ..DottedSample::default() }
                };
                let samples = pitches.iter().map(|&pitch| free(pitch)).collect();
                DottedSection {
                    keys: &["dots.pitch"],
                    samples,
                    key: format!("lines of dots {} mm apart", headings::listed(&pitches)),
                }
            }
            Pitches::Listed(_) => {
                let steps = wide.min(long);
                let line = |dot: fn(usize) -> (usize, usize), columns, rows| DottedSample {
                    dots: (0..=steps).map(|i| (dot(i).0, dot(i).1, Height::High)).collect(),
                    columns,
                    rows,
                    ..DottedSample::default()
                };
                let samples =
                    vec![line(|i| (0, i), 0, steps), line(|i| (i, 0), steps, 0), line(|i| (i, i), steps, steps)];
                let key = format!(
                    "lines up, across and slanting, of dots {} mm apart; {} has {}",
                    self.dots.pitch,
                    self.dots.device.name,
                    self.dots.device.pitches()
                );
                DottedSection { keys: &["dots.pitch"], samples, key }
            }
        }
    }

    /// The classes whose textures the device can carry at a pitch, so that a finger tells them.
    fn carried(&self, pitch: f32) -> Vec<Class> {
        let [columns, rows] = self.grid_of(PATCH);
        let place = self.place_of([0, 0], [columns, rows]);
        let has_signs = |class: Class| {
            let patch = Patch { class, density: 1.0, gap: 0, pitch };
            place.is_some_and(|place| !self.texture(patch, place).glyphs.is_empty())
        };
        Class::ALL.into_iter().filter(|class| has_signs(*class)).collect()
    }

    fn grid_of(&self, mm: [f32; 2]) -> [usize; 2] {
        [self.count(mm[0])[0], self.count(mm[1])[1]]
    }

    fn textured(&self, patch: Patch) -> DottedSample {
        let [columns, rows] = self.grid_of(PATCH);
        DottedSample { texture: Some(patch), columns: columns + patch.gap, rows, ..DottedSample::default() }
    }

    /// What half a pitch around so many columns and rows takes.
    fn place_of(&self, [column, row]: [usize; 2], [columns, rows]: [usize; 2]) -> Option<MmRect> {
        let half = MmVector::splat(0.5 * self.dots.pitch);
        let (from, to) = (self.grid.at(column, row)?, self.grid.at(column + columns - 1, row + rows - 1)?);
        Some(MmRect::new(from - half, to + half))
    }

    fn texture(&self, Patch { class, density, pitch, .. }: Patch, place: MmRect) -> Texture {
        let params = textures::Params { pitch, ..self.plan.dot_textures(&self.dots) };
        textures::sample(class, LIGHTNESS, density, place, &self.dots.area, &params)
    }

    /// The room that an item needs wherever on the grid it comes to lie.
    fn size(&self, item: &DottedItem<'_>, cells: &CellGrid<'_>) -> MmVector {
        let [x, y] = [&self.grid.columns, &self.grid.rows].map(|centres| step(centres, self.dots.pitch));
        let slack = MmVector::new(2.0 * x, 2.0 * y);
        match item {
            DottedItem::Heading(lines) => {
                let longest = lines.iter().map(Vec::len).max().unwrap_or(0);
                let size = cells.extent(longest, lines.len());
                MmVector::new(size.x, size.y + 2.0 * y)
            }
            DottedItem::DottedSample(sample, number) => {
                let label = cells.extent(braille::number(*number).len(), 1);
                let own = MmVector::new(sample.columns as f32 * x, sample.rows as f32 * y + BLANK + label.y);
                MmVector::new(own.x.max(label.x), own.y) + slack + MmVector::splat(self.dots.diameter())
            }
        }
    }

    /// One sheet: every item from the dot that is next to the corner of its place.
    fn page(
        &self,
        items: &[(&(Block, MmVector), &DottedItem<'_>)],
        cells: &CellGrid<'_>,
        (title, description, origin): (String, String, Vec<(String, String)>),
    ) -> Result<Page, Error> {
        let (area, radius) = (self.area(), 0.5 * self.dots.diameter());
        let (mut lines, mut of_textures, mut label) = (Vec::new(), Vec::new(), Vec::new());
        for ((_, corner), item) in items.iter().map(|(place, item)| (place, item)) {
            let corner = area.min + *corner;
            let after = |centres: &[f32], mm: f32| centres.partition_point(|&centre| centre - radius < mm - 1e-3);
            let start = [after(&self.grid.columns, corner.x), after(&self.grid.rows, corner.y)];
            let Some(first) = self.grid.at(start[0], start[1]) else { continue };
            let box_corner = first - MmVector::splat(radius);
            match item {
                DottedItem::Heading(braille) => label.extend(cells.dots(braille, box_corner)),
                DottedItem::DottedSample(sample, number) => {
                    lines.extend(self.lines(sample, start, first));
                    if let Some(patch) = sample.texture {
                        let size = [sample.columns - patch.gap, sample.rows];
                        let place = self.place_of([start[0] + patch.gap, start[1]], size);
                        let texture = place.map(|place| self.texture(patch, place));
                        of_textures.extend(texture.filter(|texture| !texture.glyphs.is_empty()));
                    }
                    let below = self.grid.at(start[0], start[1] + sample.rows).unwrap_or(first);
                    let under = MmPoint::new(box_corner.x, below.y + radius + BLANK);
                    label.extend(cells.dots(&[braille::number(*number)], under));
                }
            }
        }
        of_textures.sort_by_key(|texture| texture.class);
        let page = &self.plan.profile().page;
        let source = Size::new(area.width().round().max(1.0) as u32, area.height().round().max(1.0) as u32);
        let figure = Figure { place: area, source, textures: of_textures, lines };
        Page::new(Parts {
            title,
            description,
            origin,
            labels: vec![Dots { diameter: self.dots.diameter(), at: label }],
            medium: self.medium.clone(),
            ..Parts::of([page.width, page.height], figure)
        })
    }

    /// The lines of a sample: dots of one height in one column or more are one line.
    fn lines(&self, sample: &DottedSample, [column, row]: [usize; 2], first: MmPoint) -> Vec<Line> {
        let on_grid =
            sample.dots.iter().filter_map(|&(x, y, height)| Some((self.grid.at(column + x, row + y)?, height)));
        let free = sample.free.iter().map(|&by| (first + by, Height::High));
        let (mut points, mut height) = (Vec::new(), Height::High);
        for (at, own) in on_grid.chain(free) {
            points.push(at);
            height = own;
        }
        let line = |points: Vec<MmPoint>| Line { strength: 0.0, runs: vec![self.params.run(points, height)] };
        if points.is_empty() { Vec::new() } else { vec![line(points)] }
    }
}
