//! What the colours of a drawing mean where that is not told by areas: a legend, small patches of colour with words
//! beside them, and lines that only their colours tell apart. A patch has no room for a texture, and a line has none.

use super::on_sheet::on_sheet;
use super::texts::Text;
use super::unwritten::named;
use crate::classes::{Class, class_at};
use crate::edges::{ChainRange, Edges};
use crate::geom::polygon::holds_box;
use crate::lines::{Line, Lines, LostSign, SignKind};
use crate::listing::list;
use crate::page::layout::Layout;
use crate::page::{Figure, Page, ToldInKey};
use crate::profile::Plan;
use crate::raster::Raster;
use crate::raster::contrast::distance;
use crate::raster::lab::pixel;
use crate::units::{MmPoint, MmRect, PageTransform, PxPoint};
use crate::{About, Note, Reason};

/// Short side of a patch, mm: smaller ones are points, and larger ones may be areas by themselves.
const PATCH: std::ops::RangeInclusive<f32> = 1.5..=12.0;
/// Its long side and its area at most, mm and mm2: the patches of Matplotlib are three times as wide as high, and in a
/// chart that is small before it is drawn across the sheet they are 17 mm wide. What is larger may have a texture.
const LONGEST_PATCH: f32 = 24.0;
const LARGEST_PATCH: f32 = 144.0;
/// Farthest that the word of a patch lies from it, mm: print stands up to half of its own width beside it.
const FARTHEST_WORD: f32 = 8.0;
/// Colours nearer than this are one (perceptual; 2 can just be told apart side by side).
const SAME: f32 = 4.0;
/// A patch stands for areas elsewhere that are at least so many times as large: the others would be marks.
const LARGER: usize = 3;
/// Every so many-th pixel of a row or column is looked at for them.
const STEP: usize = 2;
/// Most entries of a legend, patches or samples of lines: print tells no more colours apart.
pub(super) const MOST: usize = 24;
/// Places of a line at which its colour is looked at.
const PLACES: usize = 9;
/// Beside a line, its ground is looked at so far from its edge, px.
const OFF: f32 = 2.0;
/// Lines of one colour are so long together at least, mm: longer than a sample in a legend.
const LEAST: f32 = 30.0;

/// So much of the strokes of a colour are lines and no outlines of areas, as a share, where that is told.
const MOSTLY: f32 = 0.7;

/// An entry of a legend.
#[derive(Debug, Clone, PartialEq)]
pub struct LegendEntry {
    pub(super) text: String,
    pub(super) class: Class,
    /// Its patch; none on a page that is drawn anew.
    pub(super) place: Option<MmRect>,
    /// Whether areas that it stands for are blank, as they have no room for a texture.
    pub(super) has_blank: bool,
}

impl LegendEntry {
    /// Of bars that are blank and of which no legend says what their colour means: its name is all that a key can tell.
    pub(super) fn of_blank(class: Class) -> Self {
        Self { text: String::new(), class, place: None, has_blank: true }
    }

    /// Whether a legend says what the colour means.
    pub(super) fn has_meaning(&self) -> bool {
        !self.text.is_empty()
    }

    /// Whether a text is its word.
    fn is_of(&self, text: &Text) -> bool {
        text.string == self.text && self.place.is_some_and(|place| is_beside(place, text.place))
    }
}

/// The legend of a drawing: patches of different colours, two and more, each with a
/// word at its side, whose colours larger areas have.
pub(super) fn entries(
    edges: &Edges,
    texts: &[Text],
    raster: &Raster,
    layout: &Layout,
    plan: &Plan,
) -> Vec<LegendEntry> {
    let transform = PageTransform::new(edges.size, layout.figure);
    let params = plan.classes(transform.px_per_mm());
    let mut patches: Vec<(&Text, MmRect, usize)> = Vec::new();
    for chain in edges.chains.iter().filter(|chain| chain.closed && chain.kind.of_drawing) {
        let place = MmRect::from_points(on_sheet(edges, chain, &transform));
        // in a legend in one line a patch has the word of another on its other side
        let beside = texts.iter().filter(|text| text.is_read() && is_beside(place, text.place));
        let text = beside.min_by(|a, b| gap(place, a.place).total_cmp(&gap(place, b.place)));
        let is_patch = may_be_patch(place);
        let known = |(other, of, _): &(&Text, MmRect, usize)| {
            text.is_some_and(|text| std::ptr::eq(*other, text)) || of.contains(place.center())
        };
        let middle = index(raster, transform.to_px(place.center()));
        if let (Some(text), Some(middle), true) = (text, middle, is_patch && patches.len() < MOST)
            && !patches.iter().any(known)
            && !is_on_line(place, edges, &transform)
        {
            patches.push((text, place, middle));
        }
    }
    let colours: Vec<[f32; 3]> = patches.iter().map(|(_, _, at)| pixel(raster, *at)).collect();
    let is_same = |a: [f32; 3], b: [f32; 3]| distance(a, b) < SAME;
    let is_one = |number: usize| colours.iter().filter(|other| is_same(**other, colours[number])).count() == 1;
    if patches.len() < 2 || !(0..patches.len()).all(is_one) {
        return Vec::new();
    }
    let elsewhere = pixels_elsewhere(raster, &colours, &patches, &transform);
    let px2 = |place: MmRect| place.area() * transform.px_per_mm().powi(2);
    let least = |place: MmRect| (LARGER as f32 * px2(place)) as usize / (STEP * STEP);
    let entry = |(number, (text, place, at)): (usize, &(&Text, MmRect, usize))| {
        let class = class_at(raster, *at, &params).filter(|_| elsewhere[number] >= least(*place))?;
        Some(LegendEntry { text: text.string.clone(), class, place: Some(*place), has_blank: false })
    };
    let entries: Vec<LegendEntry> = patches.iter().enumerate().filter_map(entry).collect();
    if entries.len() < 2 { Vec::new() } else { entries }
}

/// Whether a shape is as large as a patch.
fn may_be_patch(place: MmRect) -> bool {
    let (short, long) = (place.width().min(place.height()), place.width().max(place.height()));
    PATCH.contains(&short) && long <= LONGEST_PATCH && short * long <= LARGEST_PATCH
}

/// Whether a line ends at a small shape or goes through it: then it is a point of a curve, and the word beside it a
/// number at an axis. The lines of a grid may lie behind a legend.
fn is_on_line(place: MmRect, edges: &Edges, transform: &PageTransform) -> bool {
    let around = place.inflate(OF_POINT, OF_POINT);
    let lines = edges.chains.iter().filter(|chain| !chain.closed && chain.kind.of_drawing && !chain.kind.faint);
    lines.flat_map(|chain| on_sheet(edges, chain, transform)).any(|at| around.contains(at))
}

/// A line that is seen up to a point ends no farther from it, mm.
const OF_POINT: f32 = 0.5;

/// Takes a legend whose words would become labels out of a drawing that has a key: its patches have no room for a
/// texture, and a blank one beside a word would say that blank areas are what it names; words alone say nothing there,
/// and neither does a frame around them. Tells of it.
pub(super) fn moved_to_key(
    edges: &mut Edges,
    entries: &[LegendEntry],
    (texts, is_label): (&mut [Text], impl Fn(&Text) -> bool),
    raster: &Raster,
    layout: &Layout,
) -> Option<Note> {
    let is_entry = |text: &Text| entries.iter().any(|entry| entry.is_of(text));
    let own: Vec<bool> = texts.iter().map(|text| is_entry(text) && is_label(text)).collect();
    if entries.is_empty() || own.iter().filter(|own| **own).count() < entries.len() {
        return None;
    }
    texts.iter_mut().zip(own).for_each(|(text, own)| text.of_legend |= own);
    let transform = PageTransform::new(edges.size, layout.figure);
    let patches: Vec<MmRect> =
        entries.iter().filter_map(|entry| entry.place).map(|of| of.inflate(OF_PATCH, OF_PATCH)).collect();
    let is_patch = |chain: &ChainRange| {
        let mut points = on_sheet(edges, chain, &transform);
        let first = points.next();
        first
            .and_then(|first| patches.iter().find(|patch| patch.contains(first)))
            .is_some_and(|patch| points.all(|at| patch.contains(at)))
    };
    let of_patches: Vec<bool> = edges.chains.iter().map(is_patch).collect();
    let of_frame = frames(edges, &of_patches, &patches, texts, raster, &transform);
    let mut gone = of_patches.into_iter().zip(of_frame).map(|(of_patch, of_frame)| of_patch || of_frame);
    edges.chains.retain(|_| !gone.next().unwrap_or(false));
    let names: Vec<&str> = entries.iter().map(|entry| entry.text.as_str()).collect();
    let why = "its patches have no room for textures, and blank they would say something else; the key has it";
    let told = format!("the legend in the figure ({}), as {why}", named(&names));
    Some(Note::NotOnPage(About::Areas, Reason::LegendInKey, told.into()))
}

/// Which of the contours are frames of a legend: closed, along the sides of a box that holds all `patches`, and in that
/// nothing of the drawing but what is `of_patches` and words of the legend. What is filled stays, as its texture
/// does.
pub(super) fn frames(
    edges: &Edges,
    of_patches: &[bool],
    patches: &[MmRect],
    texts: &[Text],
    raster: &Raster,
    transform: &PageTransform,
) -> Vec<bool> {
    let is_frame = |(number, chain): (usize, &ChainRange)| {
        let Some(place) = along_box(edges, chain, transform).filter(|_| !of_patches[number]) else { return false };
        let inside = place.inflate(-BESIDE_FRAME, -BESIDE_FRAME);
        let holds = |chain: &ChainRange| on_sheet(edges, chain, transform).any(|at| inside.contains(at));
        let has_others = || {
            let others = edges.chains.iter().zip(of_patches).enumerate();
            // the lines of a grid may lie behind it
            let mut others = others.filter(|(other, (of, of_patch))| *other != number && !**of_patch && !of.kind.faint);
            others.any(|(_, (other, _))| holds(other))
        };
        patches.iter().all(|patch| holds_box(place, patch.inflate(-OF_PATCH, -OF_PATCH)))
            && texts.iter().all(|text| text.of_legend || !place.contains(text.place.center()))
            && is_hollow(chain, place, raster, transform)
            && !has_others()
    };
    edges.chains.iter().enumerate().map(is_frame).collect()
}

/// The box around a contour, if that is closed and runs along the sides of it, as a frame does.
pub(super) fn along_box(edges: &Edges, chain: &ChainRange, transform: &PageTransform) -> Option<MmRect> {
    let place = MmRect::from_points(on_sheet(edges, chain, transform));
    let inside = place.inflate(-BESIDE_FRAME, -BESIDE_FRAME);
    (chain.closed && on_sheet(edges, chain, transform).all(|at| !inside.contains(at))).then_some(place)
}

/// Whether a frame has one colour on both of its sides, above and below.
fn is_hollow(chain: &ChainRange, place: MmRect, raster: &Raster, transform: &PageTransform) -> bool {
    let off = transform.mm_per_px() * (0.5 * chain.kind.stroke.unwrap_or(0.0) + OFF);
    let colour = |y: f32| {
        let at = transform.to_px(MmPoint::new(place.center().x, y));
        index(raster, at).map(|at| pixel(raster, at))
    };
    let is_same = |y: f32| colour(y - off).zip(colour(y + off)).is_some_and(|(a, b)| distance(a, b) < SAME);
    [place.min.y, place.max.y].into_iter().all(is_same)
}

/// A frame of a legend lies no farther from the sides of the box around it, mm: its corners may be round.
pub(super) const BESIDE_FRAME: f32 = 1.5;

/// The patches that were taken out of a drawing.
pub(super) fn patches_in_key(entries: &[LegendEntry], texts: &[Text]) -> Vec<MmRect> {
    let is_in_key = |entry: &&LegendEntry| texts.iter().any(|text| text.of_legend && entry.is_of(text));
    entries.iter().filter(is_in_key).filter_map(|entry| entry.place).collect()
}

/// Lines without the patches of a legend where not all of them have room: one of five says nothing, and a reader looks
/// for what it is. Those that are taken out are lost as the others are.
pub(super) fn with_all_patches_or_none(mut drawn: Lines, entries: &[LegendEntry]) -> Lines {
    let patches: Vec<MmRect> = entries.iter().filter_map(|entry| entry.place).collect();
    let signs = drawn.lost.signs.clone();
    let is_lost = |patch: &MmRect| {
        let near = patch.inflate(MOVED, MOVED);
        let is_ring = |sign: &LostSign| matches!(sign.kind, SignKind::Ring | SignKind::Series);
        signs.iter().any(|sign| is_ring(sign) && near.contains(sign.at))
    };
    if !patches.iter().any(is_lost) {
        return drawn;
    }
    let is_whole = |&patch: &&MmRect| !is_lost(patch) && drawn.lines.iter().any(|line| is_of_patch(line, *patch));
    let whole = patches.iter().filter(is_whole).map(|patch| LostSign { at: patch.center(), kind: SignKind::Ring });
    drawn.lost.signs.extend(whole.collect::<Vec<_>>());
    drawn.lines.retain(|line| !patches.iter().any(|patch| is_of_patch(line, *patch)));
    drawn
}

/// Whether a line is that of a patch or a piece of it: its box is about that of the patch, or it lies in that. Another
/// line may lie beside it.
fn is_of_patch(line: &Line, patch: MmRect) -> bool {
    let own = MmRect::from_points(line.runs.iter().flat_map(|run| &run.points));
    let (low, high) = (own.min - patch.min, own.max - patch.max);
    let is_as_patch = [low.x, low.y, high.x, high.y].into_iter().all(|off| off.abs() <= MOVED);
    is_as_patch || holds_box(patch.inflate(OF_PATCH, OF_PATCH), own)
}

/// A patch is drawn, each of its sides, no farther from its place, mm.
const MOVED: f32 = 2.5;

/// Strokes around a patch reach no further beyond it, mm.
pub(super) const OF_PATCH: f32 = 1.0;

/// The legend of a page that was read, as its key told it.
pub(super) fn of_page(page: &Page) -> Vec<LegendEntry> {
    let told = ToldInKey::of(page).unwrap_or_default();
    let is_blank =
        |class: Class, text: &str| told.blank.iter().any(|(of, blank)| *of == class && blank.as_deref() == Some(text));
    let entry = |(class, text): (Class, &str)| LegendEntry {
        text: text.to_owned(),
        class,
        place: None,
        has_blank: is_blank(class, text),
    };
    let mut entries: Vec<LegendEntry> = told.meanings().map(entry).collect();
    let is_there = |class: Class, text: &str| entries.iter().any(|entry| entry.class == class && entry.text == text);
    let of_blank = |(class, text): &(Class, Option<String>)| match text {
        None => Some(LegendEntry::of_blank(*class)),
        Some(text) => (!is_there(*class, text)).then(|| entry((*class, text))),
    };
    let blank: Vec<LegendEntry> = told.blank.iter().filter_map(of_blank).collect();
    entries.extend(blank);
    entries
}

/// Whether a text stands at the side of a patch, at its height.
pub(super) fn is_beside(patch: MmRect, text: MmRect) -> bool {
    let level = (patch.center().y - text.center().y).abs() <= 0.5 * patch.height().max(text.height());
    level && (0.0..=FARTHEST_WORD).contains(&gap(patch, text))
}

/// The blank between a patch and a text on its left or right, mm.
pub(super) fn gap(patch: MmRect, text: MmRect) -> f32 {
    (text.min.x - patch.max.x).max(patch.min.x - text.max.x)
}

/// How many pixels have each colour outside of the patches.
fn pixels_elsewhere(
    raster: &Raster,
    colours: &[[f32; 3]],
    patches: &[(&Text, MmRect, usize)],
    transform: &PageTransform,
) -> Vec<usize> {
    let size = raster.size();
    let (width, height) = (size.width as usize, size.height as usize);
    let mut counts = vec![0; colours.len()];
    for (x, y) in (0..height).step_by(STEP).flat_map(|y| (0..width).step_by(STEP).map(move |x| (x, y))) {
        let at = transform.to_mm(PxPoint::new(x as f32 + 0.5, y as f32 + 0.5));
        let colour = pixel(raster, y * width + x);
        let own = colours.iter().position(|other| distance(*other, colour) < SAME);
        if let Some(own) = own.filter(|own| !patches[*own].1.contains(at)) {
            counts[own] += 1;
        }
    }
    counts
}

/// The number of the pixel at a place; none outside.
fn index(raster: &Raster, at: PxPoint) -> Option<usize> {
    let size = raster.size();
    let is_inside = at.x >= 0.0 && at.y >= 0.0 && at.x < size.width as f32 && at.y < size.height as f32;
    is_inside.then(|| at.y as usize * size.width as usize + at.x as usize)
}

/// The legend of a page with the textures of this figure. Colours without any there, as labels stand in their areas or
/// these are too narrow, are marked: the key names them as blank. On a page that is drawn anew such an area may be
/// gone.
pub(super) fn with_blank(entries: &[LegendEntry], figure: &Figure, plan: &Plan) -> Vec<LegendEntry> {
    let has_textures = plan.profile().figure.textures;
    let marked = |entry: &LegendEntry| {
        let is_there = entry.has_meaning() && entry.place.is_some();
        let is_blank = has_textures && is_there && !occurs(entry.class, figure);
        LegendEntry { has_blank: entry.has_blank || is_blank, ..entry.clone() }
    };
    entries.iter().map(marked).collect()
}

/// Whether there is a texture of a colour in a figure.
pub(super) fn occurs(class: Class, figure: &Figure) -> bool {
    figure.textures.iter().any(|texture| texture.class == class)
}

/// What is told of a legend whose words become labels, and of its key if there is one: of which of them no texture
/// tells on the page, and which share one; and of all of them where there is no key.
pub(super) fn told(entries: &[LegendEntry], figure: &Figure, key: Option<&ToldInKey>) -> Vec<Note> {
    let occurs = |class: Class| occurs(class, figure);
    let texts = |is: &dyn Fn(&LegendEntry) -> bool| -> Vec<&str> {
        let told = entries.iter().filter(|entry| entry.has_meaning() && is(entry));
        told.map(|entry| entry.text.as_str()).collect()
    };
    let note = |texts: &[&str], reason: Reason, why: &str| {
        (!texts.is_empty()).then(|| {
            let told = format!("what the colours of the legend mean ({}), as {why}", named(texts));
            Note::NotOnPage(
                About::Areas,
                reason,
                format!("{told}; write each word with a label at its own area").into(),
            )
        })
    };
    let Some(key) = key else {
        return note(&texts(&|_| true), Reason::LegendWithoutKey, "there is no key that tells it")
            .into_iter()
            .collect();
    };
    let shares = |entry: &LegendEntry| entries.iter().filter(|other| other.class == entry.class).count() > 1;
    let lost = texts(&|entry| !occurs(entry.class) && !entry.has_blank);
    let are_blank = lost.iter().all(|text| key.blank.iter().any(|(_, blank)| blank.as_deref() == Some(*text)));
    let why = if are_blank {
        "no texture of such a colour is on the page, and all that the key says is that these areas are blank"
    } else {
        "no texture of such a colour is on the page"
    };
    let lost = note(&lost, Reason::LegendWithoutTexture, why);
    let shared = texts(&|entry| occurs(entry.class) && shares(entry));
    let shared = note(&shared, Reason::LegendSharesTexture, "these colours have one texture");
    lost.into_iter().chain(shared).collect()
}

/// What is told of lines of a drawing that only their colours tell apart, such as the routes of a map: on the page all
/// lines are alike. Outlines of areas are none of them, and grey and black lines are no colour.
pub(super) fn told_lines(edges: &Edges, raster: &Raster, layout: &Layout, plan: &Plan) -> Option<Note> {
    if raster.is_grey() || !plan.profile().figure.lines {
        return None;
    }
    let transform = PageTransform::new(edges.size, layout.figure);
    let params = plan.classes(transform.px_per_mm());
    // of each colour, how long its strokes are and how much of that are lines
    let mut lengths = [[0.0_f32; 2]; Class::ALL.len()];
    for chain in &edges.chains {
        let places = chain.kind.stroke.map(|width| places_along(edges, chain, width, raster)).unwrap_or_default();
        let step = transform.mm_per_px() * edges.chain(chain).length() / PLACES as f32;
        for (at, ground) in places {
            let class = class_at(raster, at, &params);
            if let Some(number) = Class::ALL.iter().position(|of| Some(*of) == class) {
                lengths[number][0] += step;
                lengths[number][1] += if ground.is_some() { step } else { 0.0 };
            }
        }
    }
    let is_told = |(class, [all, of_lines]): &(Class, [f32; 2])| {
        *class != Class::Grey && *of_lines >= LEAST && *of_lines >= MOSTLY * all
    };
    let told = Class::ALL.into_iter().zip(lengths).filter(is_told).map(|(class, _)| class.name());
    let names: Vec<&str> = told.collect();
    (names.len() > 1).then(|| {
        let told = format!(
            "lines of {} colours ({}) are alike on the page, as fingers feel no colour of a line; say with labels \
             which is which",
            names.len(),
            list(&names, "and")
        );
        Note::TakenAs(About::Lines, Reason::ColoursOfLines, told.into())
    })
}

/// The pixels in the middle of a stroke at some places along it, each with one of its ground, if both of its sides
/// have one colour there.
pub(super) fn places_along(
    edges: &Edges,
    chain: &ChainRange,
    width: f32,
    raster: &Raster,
) -> Vec<(usize, Option<usize>)> {
    let edgels = &edges.edgels[chain.edgels.clone()];
    let at = |place: usize| {
        let number = (place * (edgels.len() - 1)) / PLACES.max(1) + (edgels.len() - 1) / (2 * PLACES);
        let (before, own) = (edgels[number.saturating_sub(1)].at, edgels[number].at);
        let after = edgels[(number + 1).min(edgels.len() - 1)].at;
        let along = (after - before).try_normalize()?;
        let aside = PxPoint::new(-along.y, along.x).to_vector() * (0.5 * width + OFF);
        let [left, right] = [own - aside, own + aside].map(|side| index(raster, side));
        let are_alike = |(left, right): &(usize, usize)| distance(pixel(raster, *left), pixel(raster, *right)) < SAME;
        Some((index(raster, own)?, left.zip(right).filter(are_alike).map(|(left, _)| left)))
    };
    if edgels.len() < 2 { Vec::new() } else { (0..PLACES).filter_map(at).collect() }
}

#[cfg(test)]
mod tests;
