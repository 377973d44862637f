//! Textures, sizes of marks, margins, and the page as a whole.

use std::collections::BTreeMap;

use super::finding::FoundBreach;
use super::limits::{MOST_TEXTURES, MediumLimits, ROUNDING, RuleLimits};
use super::marks::{Mark, MarkOutline, PageObject};
use super::rules::{BLACK, EMPTY, GLYPH_SIZE, MARGIN, Rule, TEXTURE_AREA, TEXTURE_SIGN, TEXTURES};
use crate::page::{Medium, Names, Page, Shape, Texture};
use crate::units::{MmPoint, MmRect};

pub(super) fn findings(page: &Page, names: &Names, marks: &[Mark], limits: &RuleLimits) -> Vec<FoundBreach> {
    let mut found = Vec::new();
    // a key may have words only
    if page.is_empty() && !page.is_key() {
        found.push(FoundBreach::of_page(EMPTY, None, "there is neither a line nor a texture on the page".into()));
    }
    found.extend(too_small(page, names, limits));
    found.extend(of_other_classes(page, names, limits));
    found.extend(too_thin(page, names, marks, limits));
    found.extend(off_margins(page, names, marks, limits));
    found.extend(too_many(page));
    found
}

/// Ink as it is printed.
pub(super) fn black(page: &Page, limits: &RuleLimits) -> Option<FoundBreach> {
    let MediumLimits::Print { max_black, .. } = limits.medium else { return None };
    let share = page.black_share();
    let what = || format!("{:.0} % of the figure is black; {:.0} % is the most", 100.0 * share, 100.0 * max_black);
    (share > max_black).then(|| FoundBreach::of_page(BLACK, Some(100.0 * share), what()))
}

/// Areas too small for fingers to learn a texture in. What they know from a larger area of the page they find again in
/// a smaller one, such as the lowest bars of a chart.
fn too_small<'a>(page: &'a Page, names: &'a Names, limits: &'a RuleLimits) -> impl Iterator<Item = FoundBreach> + 'a {
    let textures = &page.figure.textures;
    let is_small = |texture: &Texture| texture.area < limits.texture_area - 0.5;
    let is_known = move |of: &Texture| textures.iter().any(|texture| texture.class == of.class && !is_small(texture));
    let small = textures.iter().enumerate().filter(move |(_, texture)| !is_known(texture));
    small.filter_map(|(number, texture)| {
        let extent = super::finding::around(texture.glyphs.iter().map(|glyph| glyph.at))?;
        let name = PageObject::Texture(number as u32).name(page, names);
        let (area, least) = (texture.area, limits.texture_area);
        let what = format!("{name} has {area:.0} square mm; {least} square mm is the least for a texture");
        Some(FoundBreach::at(TEXTURE_AREA, extent.center(), extent, area, what).of(&name))
    })
}

/// Textures of a printed page whose marks name another colour than theirs, as where an area was moved to another layer.
fn of_other_classes<'a>(
    page: &'a Page,
    names: &'a Names,
    limits: &RuleLimits,
) -> impl Iterator<Item = FoundBreach> + use<'a> {
    let is_printed =
        matches!(limits.medium, MediumLimits::Print { fringe: false, .. }) && matches!(page.medium, Medium::Print(_));
    let textures = page.figure.textures.iter().enumerate().filter(move |_| is_printed);
    textures.filter(|(_, texture)| texture.has_other_signs()).filter_map(|(number, texture)| {
        let extent = super::finding::around(texture.glyphs.iter().map(|glyph| glyph.at))?;
        let name = PageObject::Texture(number as u32).name(page, names);
        let what = format!("{name} is {}, and its marks are those of another colour", texture.class.name());
        Some(FoundBreach::at(TEXTURE_SIGN, extent.center(), extent, 0.0, what).unmeasured().of(&name))
    })
}

/// What many marks of one part have in common.
struct AreaGroup {
    count: usize,
    worst: f32,
    at: MmPoint,
    extent: MmRect,
}

/// The marks that are worse than `least`, by part; `place` says where one is, and the box around that.
fn grouped(
    marks: &[Mark],
    least: f32,
    measure: impl Fn(&Mark) -> f32,
    place: impl Fn(&Mark) -> (MmPoint, MmRect),
) -> BTreeMap<PageObject, AreaGroup> {
    let mut groups: BTreeMap<PageObject, AreaGroup> = BTreeMap::new();
    for mark in marks {
        let worst = measure(mark);
        if worst >= least {
            continue;
        }
        let (at, extent) = place(mark);
        let group = groups.entry(mark.part).or_insert(AreaGroup { count: 0, worst, at, extent });
        group.count += 1;
        group.extent = group.extent.union(&extent);
        if worst < group.worst {
            (group.worst, group.at) = (worst, at);
        }
    }
    groups
}

fn too_thin(page: &Page, names: &Names, marks: &[Mark], limits: &RuleLimits) -> Vec<FoundBreach> {
    let MediumLimits::Print { glyph, .. } = limits.medium else { return Vec::new() };
    // lines have a rule of their own
    let is_line = |part: PageObject| matches!(part, PageObject::Line(_) | PageObject::OverviewLine(_));
    let thickness = |mark: &Mark| match mark.outline {
        _ if is_line(mark.part) => f32::MAX,
        MarkOutline::Stroke { radius, .. } => 2.0 * radius,
        MarkOutline::Rhombus { corners: [a, b, c, d] } => (c - a).length().min((d - b).length()),
    };
    let of = |(part, group): (PageObject, AreaGroup)| {
        let (count, thinnest) = (group.count, group.worst);
        let noun = if count == 1 { "1 mark is" } else { &format!("{count} marks are") };
        let what = format!("{}: {noun} down to {thinnest:.2} mm thin; {glyph} mm is the least", part.name(page, names));
        FoundBreach::at(GLYPH_SIZE, group.at, group.extent, thinnest, what).of(&part.name(page, names))
    };
    let place = |mark: &Mark| (mark.middle, mark.extent());
    grouped(marks, glyph - ROUNDING, thickness, place).into_iter().map(of).collect()
}

fn off_margins(page: &Page, names: &Names, marks: &[Mark], limits: &RuleLimits) -> Vec<FoundBreach> {
    let sheet = MmRect::new(MmPoint::zero(), MmPoint::new(page.sheet[0], page.sheet[1]));
    let (inner, what) = match &page.medium {
        Medium::Print(_) => {
            (sheet.inflate(-limits.margin, -limits.margin), format!("the margin of {} mm", limits.margin))
        }
        Medium::Dots(dots) => {
            let radius = 0.5 * dots.diameter();
            (dots.area.bounds().inflate(radius, radius), format!("what the {} reaches", dots.device.name))
        }
    };
    // how far within a mark lies; below 0 it reaches out
    let within = |mark: &Mark| {
        let MmRect { min, max } = mark.extent();
        (min.x - inner.min.x).min(min.y - inner.min.y).min(inner.max.x - max.x).min(inner.max.y - max.y)
    };
    let of = |(part, group): (PageObject, AreaGroup)| {
        let out = -group.worst;
        let name = part.name(page, names);
        let what = format!("{name} reaches {out:.1} mm beyond {what}");
        let found = FoundBreach::at(MARGIN, group.at, group.extent, limits.margin - out, what).of(&name);
        // of dots there is no number
        if matches!(page.medium, Medium::Print(_)) { found } else { found.unmeasured() }
    };
    grouped(marks, -ROUNDING, within, |mark| mark.outside(inner)).into_iter().map(of).collect()
}

fn too_many(page: &Page) -> Option<FoundBreach> {
    let direction = |shape: Shape| match shape {
        Shape::Rhombus { degrees, .. } => Some(degrees.rem_euclid(180.0).round() as u32),
        Shape::Dot { .. } => None,
    };
    let glyphs = page.figure.textures.iter().flat_map(|texture| &texture.glyphs);
    let mut signs: Vec<Option<u32>> = glyphs.map(|glyph| direction(glyph.shape)).collect();
    signs.sort_unstable();
    signs.dedup();
    let count = signs.len();
    let rule: Rule = TEXTURES;
    (count > MOST_TEXTURES).then(|| {
        FoundBreach::of_page(
            rule,
            Some(count as f32),
            format!("there are {count} textures; {MOST_TEXTURES} are the most"),
        )
    })
}
