//! What the picture is about, as its maker says by places on it.

use super::given::{Given, blank_where};
use super::hand_lines::without;
use crate::classes::Classes;
use crate::edges::{Edgel, Edges};
use crate::geom::polyline::Located;
use crate::page::layout::Layout;
use crate::profile::Plan;
use crate::regions::{Mask, RegionGrid};
use crate::units::{PageTransform, PxPoint, Size};
use crate::{About, Note};

/// Most places that are looked at: more is what a picture has, not what it is about.
const MOST: usize = 100;
/// A ring around the subject has at least this area, mm2: smaller ones are dots for a finger.
const LEAST_AREA: f32 = 15.0;
/// Lines this near to the subject belong to it, cells: its own contours run along its border.
const MARGIN: f32 = 3.0;

/// Finds the subjects among regions, or within closed contours, and tells the contours of them; where a calm background
/// is asked for, takes what is not of them out of the contours. Returns the cells around which textures are to be left
/// out too, if any are.
pub(super) fn prepare(
    given: &Given,
    edges: &mut Edges,
    source: Size,
    layout: &Layout,
    plan: &Plan,
) -> (Option<Mask>, Vec<Note>) {
    let (mut all, mut notes) = (None::<Mask>, Vec::new());
    let mm_per_px = PageTransform::new(edges.size, layout.figure).mm_per_px();
    let tree = edges.regions.as_ref().filter(|_| !given.subjects.is_empty());
    let most_telling = tree.map_or_else(Vec::new, |tree| tree.most_telling(mm_per_px, &plan.regions(false)));
    let beyond = given.subjects.len().saturating_sub(MOST);
    if beyond > 0 {
        let told = format!("{beyond} of the subjects, as {MOST} are the most");
        notes.push(Note::NotOnPage(About::Lines, told));
    }
    for [x, y] in given.subjects.iter().take(MOST) {
        let share = [x.share(source.width), y.share(source.height)];
        let percent = share.map(|share| (100.0 * share).round() as i32);
        let found = subject_at(edges, share, layout, &most_telling).and_then(|(mask, is_first)| {
            let [least, greatest] = mask.extent()?;
            let side = (greatest - least) * mm_per_px;
            Some((mask, [side.x, side.y].map(|side| side.round() as u32), is_first))
        });
        match found {
            Some((mask, mm, is_first)) => {
                all = Some(all.map_or(mask.clone(), |all| all.with(&mask)));
                notes.push(Note::Subject { at: percent, mm, is_first });
            }
            None => notes.push(Note::NoSubject(percent)),
        }
    }
    let around = all.filter(|_| given.calm_background);
    if let Some(subject) = &around {
        notes.push(Note::BackgroundCalmed(calm(edges, subject, layout, plan).round() as u32));
    }
    (around, notes)
}

/// The cells of the subject at a place, in shares of the picture, and whether it is a region, whose outline is drawn
/// first.
fn subject_at(edges: &mut Edges, [x, y]: [f32; 2], layout: &Layout, most_telling: &[u32]) -> Option<(Mask, bool)> {
    let mm_per_px = PageTransform::new(edges.size, layout.figure).mm_per_px();
    let at = PxPoint::new(x * edges.size.width as f32, y * edges.size.height as f32);
    let found = edges.regions.as_ref().and_then(|tree| {
        let region = tree.subject_at(at, mm_per_px, most_telling)?;
        Some((region, tree.mask(&[region])))
    });
    let Some((region, mask)) = found else { return ring_around(edges, at, mm_per_px).map(|mask| (mask, false)) };
    if !edges.constraints.subjects.contains(&region) {
        edges.constraints.subjects.push(region);
    }
    Some((mask, true))
}

/// The inside of the smallest closed contour around a place.
fn ring_around(edges: &Edges, at: PxPoint, mm_per_px: f32) -> Option<Mask> {
    let grid = RegionGrid::new(edges.size);
    let rings = edges.chains.iter().filter(|range| range.closed).map(|range| edges.chain(range));
    let inside = rings.map(|ring| {
        let points: Vec<PxPoint> = ring.vertices.iter().map(Located::at).collect();
        Mask::of_ring(grid, &points)
    });
    let cell = mm_per_px * edges.size.width as f32 / grid.cells.width as f32;
    let least = (LEAST_AREA / (cell * cell)) as usize;
    inside.filter(|mask| mask.contains(at) && mask.cells() >= least).min_by_key(Mask::cells)
}

/// Takes weak lines that are not of the subject out, and the outlines of other regions. Returns how much, mm.
fn calm(edges: &mut Edges, subject: &Mask, layout: &Layout, plan: &Plan) -> f32 {
    let (strong, near) = (plan.lines().full_strength, subject.clone().grown(MARGIN));
    let length = |edges: &Edges| edges.chains().map(|chain| chain.length()).sum::<f32>();
    let before = length(edges);
    let mean = |edges: &Edges| -> Vec<f32> {
        let mean = |strengths: &[Edgel]| {
            strengths.iter().map(|edgel| edgel.strength).sum::<f32>() / strengths.len().max(1) as f32
        };
        edges.chains().map(|chain| mean(chain.vertices)).collect()
    };
    let is_weak: Vec<bool> = mean(edges).into_iter().map(|strength| strength < strong).collect();
    without(edges, |number, range, edgel| is_weak[number] && !range.kind.added && !near.contains(edgel.at));
    edges.constraints.only_subjects = true;
    (before - length(edges)) * PageTransform::new(edges.size, layout.figure).mm_per_px()
}

/// Leaves the cells of colours that are not of the subject blank.
pub(super) fn blank_around(classes: &mut Classes, subject: &Mask, picture: Size) {
    blank_where(classes, |[x, y]| !subject.contains(PxPoint::new(x * picture.width as f32, y * picture.height as f32)));
}
