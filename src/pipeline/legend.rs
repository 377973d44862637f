//! What the colours of a drawing mean where that is not told by areas: a legend, small patches of colour with words
//! beside them, and lines that only their colours tell apart. A patch has no room for a texture, and a line has none.

use super::legend_column::{self, Column};
use super::legend_frames::{OF_PATCH, OFF, with_heading};
use super::legend_patches::{Patch, SAME, are_of_different_colours, colours_of, index, is_beside, patches};
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
use crate::units::{MmRect, PageTransform, PxPoint};
use crate::{About, Note, Reason};

/// A patch stands for areas elsewhere that are at least so many times as large: the others would be marks.
const LARGER: usize = 3;
/// Every so many-th pixel of a row or column is looked at for them.
const STEP: usize = 2;
/// Most entries of a legend, patches or samples of lines: print tells no more colours apart.
pub(super) const MOST: usize = 24;
/// Places of a line at which its colour is looked at.
const PLACES: usize = 9;
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

/// The legend of a drawing: patches of different colours, two and more, each with a word at its side, whose colours
/// larger areas have. Where shapes with words beside them have the same colour, as the towns of a map, those of the
/// `column`.
pub(super) fn entries(
    edges: &Edges,
    texts: &[Text],
    raster: &Raster,
    column: Option<&Column>,
    layout: &Layout,
    plan: &Plan,
) -> Vec<LegendEntry> {
    let transform = PageTransform::new(edges.size, layout.figure);
    let params = plan.classes(transform.px_per_mm());
    let mut patches = patches(edges, texts, raster, &transform);
    patches.retain(|patch| !column.is_some_and(|column| column.is_sign(patch.place)));
    patches.truncate(MOST);
    if !are_of_different_colours(&colours_of(&patches, raster)) {
        patches = column.map(|column| column.patches.clone()).unwrap_or_default();
    }
    if patches.len() < 2 {
        return Vec::new();
    }
    let elsewhere = pixels_elsewhere(raster, &patches, &transform);
    let px2 = |place: MmRect| place.area() * transform.px_per_mm().powi(2);
    let least = |place: MmRect| (LARGER as f32 * px2(place)) as usize / (STEP * STEP);
    let entry = |(patch, elsewhere): (&Patch, usize)| {
        let class = class_at(raster, patch.middle, &params).filter(|_| elsewhere >= least(patch.place))?;
        let text = texts[patch.text].string.clone();
        Some(LegendEntry { text, class, place: Some(patch.place), has_blank: false })
    };
    let entries: Vec<LegendEntry> = patches.iter().zip(elsewhere).filter_map(entry).collect();
    if entries.len() < 2 { Vec::new() } else { entries }
}

/// Takes a legend whose words would become labels out of a drawing that has a key: its patches have no room for a
/// texture, and a blank one beside a word would say that blank areas are what it names; words alone say nothing there,
/// and neither does a frame around them. With the patches go the samples of lines and signs in their `column`, and a
/// heading in the frame. Tells of it.
pub(super) fn moved_to_key(
    edges: &mut Edges,
    (entries, column): (&[LegendEntry], Option<&Column>),
    (texts, is_label): (&mut [Text], impl Fn(&Text) -> bool),
    raster: &Raster,
    layout: &Layout,
) -> Vec<Note> {
    let labels: Vec<bool> = texts.iter().map(is_label).collect();
    let is_entry = |text: &Text| entries.iter().any(|entry| entry.is_of(text));
    let own: Vec<bool> = texts.iter().zip(&labels).map(|(text, is_label)| *is_label && is_entry(text)).collect();
    if entries.is_empty() || own.iter().filter(|own| **own).count() < entries.len() {
        return Vec::new();
    }
    texts.iter_mut().zip(own).for_each(|(text, own)| text.of_legend |= own);
    let transform = PageTransform::new(edges.size, layout.figure);
    let samples = column.map(|column| column.samples(edges, texts, &transform, &labels)).unwrap_or_default();
    samples.iter().for_each(|sample| texts[sample.text].of_legend = true);
    let patches: Vec<MmRect> =
        entries.iter().filter_map(|entry| entry.place).map(|of| of.inflate(OF_PATCH, OF_PATCH)).collect();
    let is_patch = |chain: &ChainRange| {
        let mut points = on_sheet(edges, chain, &transform);
        let first = points.next();
        first
            .and_then(|first| patches.iter().find(|patch| patch.contains(first)))
            .is_some_and(|patch| points.all(|at| patch.contains(at)))
    };
    let mut of_patches: Vec<bool> = edges.chains.iter().map(is_patch).collect();
    samples.iter().flat_map(|sample| &sample.chains).for_each(|chain| of_patches[*chain] = true);
    let (of_frame, heading) = with_heading(edges, &of_patches, &patches, texts, raster, &transform);
    let mut gone = of_patches.into_iter().zip(of_frame).map(|(of_patch, of_frame)| of_patch || of_frame);
    edges.chains.retain(|_| !gone.next().unwrap_or(false));
    let names: Vec<&str> = entries.iter().map(|entry| entry.text.as_str()).collect();
    let but = heading.map(|heading| format!(", but not its heading {}", named(&[&texts[heading].string])));
    let why = "its patches have no room for textures, and blank they would say something else; the key has it";
    let told = format!("the legend in the figure ({}), as {why}{}", named(&names), but.unwrap_or_default());
    let told = Note::NotOnPage(About::Areas, Reason::LegendInKey, told.into());
    std::iter::once(told).chain(legend_column::told(&samples, texts)).collect()
}

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

/// How many pixels have the colour of each patch outside of it.
fn pixels_elsewhere(raster: &Raster, patches: &[Patch], transform: &PageTransform) -> Vec<usize> {
    let colours = colours_of(patches, raster);
    let size = raster.size();
    let (width, height) = (size.width as usize, size.height as usize);
    let mut counts = vec![0; colours.len()];
    for (x, y) in (0..height).step_by(STEP).flat_map(|y| (0..width).step_by(STEP).map(move |x| (x, y))) {
        let at = transform.to_mm(PxPoint::new(x as f32 + 0.5, y as f32 + 0.5));
        let colour = pixel(raster, y * width + x);
        let own = colours.iter().position(|other| distance(*other, colour) < SAME);
        if let Some(own) = own.filter(|own| !patches[*own].place.contains(at)) {
            counts[own] += 1;
        }
    }
    counts
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
