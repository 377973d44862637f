//! Blank between marks of different parts, and what lies on one another.

use std::collections::BTreeMap;

use super::dotted::empty_between;
use super::finding::FoundBreach;
use super::limits::{BRAILLE_GAP, MediumLimits, OWN_LEADER_GAP, ROUNDING, RuleLimits};
use super::marks::{Mark, PageObject, index, marks_of};
use super::rules::{BRAILLE_CLEAR, OVERLAP, Rule, TEXTURE_GAP};
use crate::page::{Medium, Names, Page};
use crate::units::{MmPoint, MmRect};

/// Where dots can be anywhere, rounding to whole empty dots goes this way.
const HALF_A_DOT: f32 = 0.5;

/// Least side of the cells in which marks are looked for, mm: the blank around braille.
const LEAST_CELL: f32 = BRAILLE_GAP;

/// What one part does to another, mark by mark.
struct Breach {
    count: usize,
    blank: f32,
    at: MmPoint,
    extent: MmRect,
    last: u32,
}

type Breaches = BTreeMap<(PageObject, Option<PageObject>), Breach>;

fn note(
    breaches: &mut Breaches,
    key: (PageObject, Option<PageObject>),
    number: u32,
    (at, extent): (MmPoint, MmRect),
    blank: f32,
) {
    let breach = breaches.entry(key).or_insert(Breach { count: 0, blank: f32::MAX, at, extent, last: u32::MAX });
    breach.count += usize::from(breach.last != number);
    breach.last = number;
    breach.extent = breach.extent.union(&extent);
    if blank < breach.blank {
        (breach.blank, breach.at) = (blank, at);
    }
}

/// Everything about blank between marks.
pub(super) fn findings(page: &Page, names: &Names, marks: &[Mark], limits: &RuleLimits) -> Vec<FoundBreach> {
    let All { textures, braille, overlaps } = breaches(page, marks, limits);
    let name = |part: &PageObject| part.name(page, names);
    let mut found: Vec<FoundBreach> = Vec::new();
    found.extend(textures.into_iter().map(|((part, dot), breach)| {
        let other = dot.as_ref().map_or_else(|| "a line".to_owned(), name);
        let name = name(&part);
        of_texture(&name, &other, breach, limits).of(&name)
    }));
    found.extend(braille.into_iter().map(|((part, other), breach)| {
        let least = other.map_or(BRAILLE_GAP, |other| braille_gap(part, other));
        let (other, blank) = (other.as_ref().map_or_else(String::new, name), millimetres(breach.blank));
        let what = format!("{} is {blank} from {other}; {least} mm of blank is the least", name(&part));
        finding(BRAILLE_CLEAR, breach, what).of(&name(&part))
    }));
    found.extend(overlaps.into_iter().map(|((part, other), breach)| {
        let what = if other == Some(part) {
            format!("{}: {} of its marks lie on one another", name(&part), breach.count)
        } else {
            let other = other.as_ref().map_or_else(String::new, name);
            format!("{} lies on {other}, in {}", name(&part), places(breach.count))
        };
        finding(OVERLAP, breach, what).of(&name(&part))
    }));
    found
}

/// What is too near, by rule.
#[derive(Default)]
struct All {
    textures: Breaches,
    braille: Breaches,
    overlaps: Breaches,
}

fn breaches(page: &Page, marks: &[Mark], limits: &RuleLimits) -> All {
    let cell = match limits.medium {
        MediumLimits::Print { texture_gap, .. } => texture_gap,
        MediumLimits::Dots { pitch, .. } => pitch,
    };
    let index = index(marks, cell.max(LEAST_CELL));
    let mut all = All::default();
    // a mark lies in several cells
    let mut seen = vec![u32::MAX; marks.len()];
    for (number, mark) in (0..).zip(marks) {
        let extent = mark.extent();
        let reach = match mark.part {
            PageObject::Texture(_) => texture_reach(limits),
            PageObject::Braille(_) => BRAILLE_GAP,
            PageObject::OrientationMark
            | PageObject::Tick
            | PageObject::Frame
            | PageObject::Line(_)
            | PageObject::OverviewFrame
            | PageObject::OverviewLine(_)
            | PageObject::Numbers(_)
            | PageObject::Leader(_) => 0.0,
        };
        index.around(extent.min, extent.max, reach, |&id| {
            let other = &marks[id as usize];
            if std::mem::replace(&mut seen[id as usize], number) == number {
                return;
            }
            if other.part != mark.part || matches!(mark.part, PageObject::Texture(_)) && id < number {
                all.judge((number, mark), (id, other), page, limits);
            }
        });
    }
    all
}

/// Least blank between braille and something else, mm.
fn braille_gap(braille: PageObject, other: PageObject) -> f32 {
    match (braille, other) {
        (PageObject::Braille(text), PageObject::Leader(of)) if text == of => OWN_LEADER_GAP,
        _ => BRAILLE_GAP,
    }
}

impl All {
    /// Notes what a mark is too near to, or lies on. Each pair comes in both orders.
    fn judge(&mut self, (number, mark): (u32, &Mark), (id, other): (u32, &Mark), page: &Page, limits: &RuleLimits) {
        match (mark.part, other.part) {
            (PageObject::Texture(_), of) if gets_room(of) => {
                if let Some(blank) = too_near(mark, other, page, limits) {
                    let dot = matches!(of, PageObject::Numbers(_)).then_some(PageObject::Numbers(0));
                    note(&mut self.textures, (mark.part, dot), number, (mark.middle, mark.extent()), blank);
                }
            }
            // the other order of this pair tells it
            (PageObject::Braille(text), PageObject::Braille(of)) if of > text => {}
            (PageObject::Braille(_), _) => {
                let least = braille_gap(mark.part, other.part);
                if mark.may_be_within(other, least) {
                    let blank = mark.blank(other);
                    if blank < least - ROUNDING {
                        note(
                            &mut self.braille,
                            (mark.part, Some(other.part)),
                            number,
                            (mark.middle, mark.extent()),
                            blank,
                        );
                    }
                }
            }
            _ if id >= number || may_meet(mark.part, other.part) => {}
            _ => {
                if mark.may_be_within(other, 0.0) {
                    let blank = mark.blank(other);
                    if blank < -ROUNDING || (blank <= 0.0 && is_rhombus(mark, other)) {
                        let key = (mark.part.min(other.part), Some(mark.part.max(other.part)));
                        note(&mut self.overlaps, key, number, mark.meeting(other), blank);
                    }
                }
            }
        }
    }
}

fn is_rhombus(a: &Mark, b: &Mark) -> bool {
    [a, b].iter().any(|mark| matches!(mark.outline, super::marks::MarkOutline::Rhombus { .. }))
}

/// Whether marks of two parts may touch: lines join, and a leader line leads to what it names.
fn may_meet(a: PageObject, b: PageObject) -> bool {
    matches!(
        (a, b),
        (PageObject::Line(_) | PageObject::Leader(_), PageObject::Line(_) | PageObject::Leader(_))
            | (PageObject::OverviewLine(_), PageObject::OverviewLine(_))
            | (PageObject::Line(_) | PageObject::Numbers(_), PageObject::Texture(_))
            | (_, PageObject::Braille(_))
            | (PageObject::Numbers(_), PageObject::Numbers(_))
    )
}

fn texture_reach(limits: &RuleLimits) -> f32 {
    match limits.medium {
        MediumLimits::Print { texture_gap, .. } => texture_gap,
        MediumLimits::Dots { pitch, texture_gap, .. } => (texture_gap + 1) as f32 * pitch,
    }
}

/// The glyphs that are too near to a line: which texture each belongs to, and which of its glyphs it is, in order.
pub fn crowded(page: &Page, limits: &RuleLimits) -> Vec<(usize, usize)> {
    let felt = page.risen();
    let marks = marks_of(&felt);
    let index = index(&marks, texture_reach(limits).max(LEAST_CELL));
    let of = |mark: &Mark| if let PageObject::Texture(texture) = mark.part { Some(texture as usize) } else { None };
    let (mut found, mut last, mut glyph) = (Vec::new(), None, 0);
    for (mark, texture) in marks.iter().filter_map(|mark| Some((mark, of(mark)?))) {
        glyph = if last == Some(texture) { glyph + 1 } else { 0 };
        last = Some(texture);
        let extent = mark.extent();
        let mut near = false;
        index.around(extent.min, extent.max, texture_reach(limits), |&id| {
            let other = &marks[id as usize];
            near = near || gets_room(other.part) && too_near(mark, other, page, limits).is_some();
        });
        if near {
            found.push((texture, glyph));
        }
    }
    found
}

/// Whether textures give way to marks of a part: to lines, and to dots that a person drew.
fn gets_room(part: PageObject) -> bool {
    matches!(part, PageObject::Line(_) | PageObject::Numbers(_))
}

/// The blank between a glyph and a mark that gets room, mm, where it is too little.
fn too_near(glyph: &Mark, line: &Mark, page: &Page, limits: &RuleLimits) -> Option<f32> {
    let least = match limits.medium {
        MediumLimits::Print { texture_gap, .. } => texture_gap - ROUNDING,
        MediumLimits::Dots { pitch, texture_gap, .. } => match &page.medium {
            Medium::Dots(medium) => {
                let empty = empty_between(glyph.middle, line.middle, medium);
                return (empty < texture_gap as f32 - HALF_A_DOT).then(|| glyph.blank(line));
            }
            Medium::Print(_) => texture_gap as f32 * pitch,
        },
    };
    if !glyph.may_be_within(line, least) {
        return None;
    }
    Some(glyph.blank(line)).filter(|blank| *blank < least)
}

fn of_texture(name: &str, other: &str, breach: Breach, limits: &RuleLimits) -> FoundBreach {
    let least = match limits.medium {
        MediumLimits::Print { texture_gap, .. } => format!("{texture_gap} mm of blank is the least"),
        MediumLimits::Dots { texture_gap, .. } => match texture_gap {
            1 => "1 empty dot is the least".to_owned(),
            _ => format!("{texture_gap} empty dots are the least"),
        },
    };
    let (count, marks) = (breach.count, if breach.count == 1 { "mark lies" } else { "marks lie" });
    let nearest = millimetres(breach.blank);
    let what = format!("{name}: {count} {marks} too near to {other}, the nearest {nearest} from it; {least}");
    // in the unit of its limit
    let unit = match limits.medium {
        MediumLimits::Print { .. } => 1.0,
        MediumLimits::Dots { pitch, .. } => pitch,
    };
    let blank = breach.blank / unit;
    finding(TEXTURE_GAP, Breach { blank, ..breach }, what)
}

fn finding(rule: Rule, breach: Breach, what: String) -> FoundBreach {
    FoundBreach::at(rule, breach.at, breach.extent, breach.blank, what)
}

fn places(count: usize) -> String {
    if count == 1 { "1 place".into() } else { format!("{count} places") }
}

/// A blank in words; to 0.01 mm, as it may be just short of the least.
pub(super) fn millimetres(blank: f32) -> String {
    match (100.0 * blank).round().max(0.0) as u32 {
        0 => "0 mm".into(),
        hundredths if hundredths % 10 == 0 => format!("{blank:.1} mm"),
        _ => format!("{blank:.2} mm"),
    }
}
