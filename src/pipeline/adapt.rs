//! A page that was read, as its own paper or device takes it: what a person changed is brought into its range, and
//! told.

use super::areas::{self, PageAreas};
use super::drawn_areas;
use super::finish::{described, is_made};
use super::kept_lines::{self, LineName};
use super::label_params::blank_to_signs;
use super::print_words;
use super::typed::{self, Typed};
use crate::braille::Translate;
use crate::classes::Classes;
use crate::lines::{Line, Pen};
use crate::listing::first_few;
use crate::page::cells::CellGrid;
use crate::page::{DotMedium, Glyph, Medium, Names, Page, Parts};
use crate::profile::Plan;
use crate::reading::Reading;
use crate::units::MmRect;
use crate::wording::Wording;
use crate::{About, Error, Note, Reason, dots, legibility};

/// Most areas that are named.
const MOST_NAMED: usize = 5;

/// A page as its paper or device takes it.
#[derive(Debug)]
pub struct Adapted {
    /// The page.
    pub page: Page,
    /// What the lines of its figure are called in the file that was read.
    pub lines: Vec<LineName>,
    /// What its areas are called there.
    pub areas: Vec<String>,
    /// What was changed.
    pub notes: Vec<Note>,
    /// What is told of its words where they stand, which is of no use where they are placed anew.
    pub of_places: Vec<Note>,
    /// What its overview shows that the figure has not, or lacks, where somebody changed the page.
    pub of_overview: Option<String>,
    /// Whether words are abbreviated that were not before.
    pub abbreviates: bool,
}

/// A page that was read as `render` makes it.
#[derive(Debug)]
pub struct AsRendered {
    /// As its paper or device takes it.
    pub adapted: Adapted,
    /// What was read.
    pub read: Reading,
    /// Whether both are here as they are felt, and not as they were read.
    pub turned_over: bool,
}

/// A page that was read as `render` makes it by `own`, the plan that it was made with. What a person changed, and
/// another paper or device, want a mirrored page as it is felt.
///
/// # Errors
/// If a mark is off the sheet then.
pub fn as_rendered(
    read: Reading,
    own: &Plan,
    for_another: bool,
    translate: Option<&Translate>,
) -> Result<AsRendered, Error> {
    let turned_over = read.page.is_mirrored() && (read.is_changed || for_another);
    let read = if turned_over { as_felt(read, own) } else { read };
    Ok(AsRendered { adapted: adapted(&read, own, for_another, translate)?, read, turned_over })
}

/// A page that was read as its paper or device takes it: widths of lines within the range of `plan`, strokes on a page
/// of dots as dots, areas that were moved to another colour or drawn by hand with the signs of that, typed texts in
/// braille, and textures apart from lines; these `for_another` paper or device stay as they are, as they only say where
/// their areas are.
///
/// # Errors
/// If a mark is off the sheet then.
fn adapted(read: &Reading, plan: &Plan, for_another: bool, translate: Option<&Translate>) -> Result<Adapted, Error> {
    let Reading { page, .. } = read;
    let mut parts = Parts::clone(page);
    let mut lines = LineName::of(&read.names);
    let mut overview_lines = read.names.overview_lines.clone();
    let mut areas = read.names.areas.clone();
    let mut notes: Vec<Note> = right_signs(&mut parts, page, &mut areas, plan);
    match &page.medium {
        Medium::Print(print) => notes.extend(widths_in_range(&mut parts, print.swell, plan)),
        Medium::Dots(medium) => {
            notes.extend(strokes_as_dots(&mut parts, &mut lines, &mut overview_lines, (medium, plan)));
        }
    }
    notes.extend(drawn_areas::lay(&mut parts, &mut areas, &read.areas, plan));
    let labels = parts.braille.len();
    let Typed { notes: of_texts, mut of_places, as_labels, abbreviates } =
        typed::write(&mut parts, &mut lines, &read.texts, plan, translate);
    notes.extend(of_texts.into_iter().chain(as_labels.filter(|_| for_another)));
    if read.is_changed {
        of_places.extend(print_words::follow(&mut parts, labels, plan));
    }
    let mut of_overview = None;
    let mut page = Page::new(parts)?;
    if read.is_changed {
        if !for_another {
            let (free, told) = without_crowded_signs(page, plan)?;
            page = free;
            notes.extend(told);
        }
        let names = Names {
            lines: lines.iter().map(|line| line.name.clone()).collect(),
            overview_lines,
            // they have others than in the file where some were drawn or left out
            areas: Names::of(&page).areas,
            rows: read.names.rows.clone(),
            by_hand: read.names.by_hand.clone(),
        };
        let limits = plan.limits();
        of_overview = legibility::overview_as_told(&page, &names, &limits);
        let of_braille = legibility::braille_as_told(&page, &names, &limits);
        of_places.extend(of_braille.map(|told| Note::Faulty(About::Braille, Reason::BrailleFaulty, told)));
    }
    if is_made(&read.page) {
        let wording = Wording::nearest(&page.description_language);
        page = described(page, wording);
    }
    Ok(Adapted { page, lines, areas, notes, of_places, of_overview, abbreviates })
}

/// Draws areas anew that have the signs of another colour, as they were moved or turned, over those on which they lie;
/// tells which, by their `names`, which have no room for its signs, and which lie under others.
fn right_signs(parts: &mut Parts, page: &Page, names: &mut Vec<String>, plan: &Plan) -> Vec<Note> {
    let wrong = wrong_signs(page);
    if wrong.is_empty() || plan.profile().textures.fringe {
        return Vec::new();
    }
    let all = areas::of_page(page, plan);
    let is_covered = |number: &usize| all.classes.regions[*number].cells == 0;
    let (mut covered, wrong): (Vec<usize>, Vec<usize>) = wrong.into_iter().partition(is_covered);
    covered.iter().for_each(|number| parts.figure.textures[*number].glyphs.clear());
    for &number in &wrong {
        let own = only(&all.classes, number);
        for below in all.lies_on[number].iter().map(|below| *below as usize) {
            drawn_areas::make_room(&mut parts.figure.textures[below..=below], &own, page.figure.place);
            let is_gone = parts.figure.textures[below].glyphs.is_empty();
            if is_gone && !wrong.contains(&below) && !covered.contains(&below) {
                covered.push(below);
            }
        }
        parts.figure.textures[number].glyphs = fill(page, &own, plan);
    }
    let has_room = |number: &usize| !parts.figure.textures[*number].glyphs.is_empty();
    let (drawn, bare): (Vec<usize>, Vec<usize>) = wrong.into_iter().partition(has_room);
    let notes = told_of_signs(page, names, &all, [&drawn, &bare, &covered]);
    areas::without_bare(&mut parts.figure.textures, names);
    notes
}

/// What is told of areas, by their `names`, that are drawn anew, that have no room for their signs, and that lie under
/// others.
fn told_of_signs(page: &Page, names: &[String], all: &PageAreas, [drawn, bare, covered]: [&[usize]; 3]) -> Vec<Note> {
    let named = |areas: &[usize]| {
        let name = |number: &usize| {
            let class = page.figure.textures[*number].class.name();
            names.get(*number).cloned().unwrap_or_else(|| format!("an area of {class}"))
        };
        first_few(areas, MOST_NAMED, name)
    };
    let its = |areas: &[usize]| if areas.len() == 1 { "its colour" } else { "their colours" };
    let told = || {
        let told = match drawn {
            [one] => {
                let class = page.figure.textures[*one].class.name();
                format!("{}, which was moved to {class} or turned, is drawn with the texture of {class}", named(drawn))
            }
            _ => format!(
                "{}, which were moved to other colours or turned, are drawn with the textures of their colours",
                named(drawn)
            ),
        };
        Note::TakenAs(About::Areas, Reason::AreaRecoloured, told.into())
    };
    let told_bare = || {
        let why = "there is no room for them clear of lines; say in a label what the colour means";
        let told = format!("the textures of {}, in the signs of {}: {why}", named(bare), its(bare));
        Note::NotOnPage(About::Areas, Reason::NoRoomForTexture, told.into())
    };
    let told_drawn = (!drawn.is_empty()).then(told);
    let told_bare = (!bare.is_empty()).then(told_bare);
    told_drawn.into_iter().chain(told_bare).chain(areas::told_lost(page, all, names, covered)).collect()
}

/// Brings the widths of printed lines into the range of the profile; tells of how many, and how wide they are then. Of
/// samples they are meant.
fn widths_in_range(parts: &mut Parts, swell: f32, plan: &Plan) -> Option<Note> {
    if parts.has_samples() {
        return None;
    }
    let params = plan.lines();
    // no profile has a swelling that leaves nothing of a line, whatever a page says
    let swell = if (0.0..params.width_min).contains(&swell) { swell } else { plan.profile().print.swell };
    let range = [params.width_min - swell, params.width_max - swell];
    let overview = parts.overview.iter_mut().flat_map(|overview| &mut overview.lines);
    let ends = parts.figure.lines.iter_mut().chain(overview).map(|line| snap(line, range));
    let snapped: Vec<[bool; 2]> = ends.filter(|to| to.contains(&true)).collect();
    let noun = if snapped.len() == 1 { "line is" } else { "lines are" };
    let [least, most] = [range[0].max(0.0), range[1]];
    let wide = match [0_usize, 1].map(|end| snapped.iter().any(|to| to[end])) {
        [true, false] => format!("{least:.2} mm wide, the least of the profile"),
        [false, true] => format!("{most:.2} mm wide, the most of the profile"),
        _ => format!("{least:.2} or {most:.2} mm wide, the least and the most of the profile"),
    };
    let told = format!("{} {noun} drawn {wide}", snapped.len());
    (!snapped.is_empty()).then_some(Note::TakenAs(About::Widths, Reason::WidthOutOfRange, told.into()))
}

/// Makes strokes on a page of dots dots, in the figure and in its overview; tells how many, and which are lost.
fn strokes_as_dots(
    parts: &mut Parts,
    names: &mut Vec<LineName>,
    overview_names: &mut Vec<String>,
    (medium, plan): (&DotMedium, &Plan),
) -> Vec<Note> {
    let place = parts.figure.place;
    let mut notes = dots_of_strokes((&mut parts.figure.lines, place, ""), names, medium, plan);
    if let Some(overview) = &mut parts.overview {
        let named = overview_names.drain(..).map(|name| LineName { name, by_hand: false });
        let mut own: Vec<LineName> = named.collect();
        let lines = (&mut overview.lines, overview.place, " of the overview");
        notes.extend(dots_of_strokes(lines, &mut own, medium, plan));
        overview_names.extend(own.into_iter().map(|own| own.name));
    }
    notes
}

/// Makes the strokes among these lines, which lie in `place`, dots, behind the rows of dots that are there; `of` says
/// in the notes what they are of.
fn dots_of_strokes(
    (lines, place, of): (&mut Vec<Line>, MmRect, &str),
    names: &mut Vec<LineName>,
    medium: &DotMedium,
    plan: &Plan,
) -> Vec<Note> {
    let all: Vec<(Line, LineName)> = lines.drain(..).zip(names.drain(..)).collect();
    let is_stroke = |(line, _): &(Line, LineName)| line.runs.iter().any(|run| run.pen == Pen::Stroke);
    let (strokes, rows): (Vec<_>, Vec<_>) = all.into_iter().partition(is_stroke);
    (*lines, *names) = rows.into_iter().unzip();
    if strokes.is_empty() {
        return Vec::new();
    }
    let (mut strokes, of_strokes): (Vec<Line>, Vec<LineName>) = strokes.into_iter().unzip();
    let (count, params) = (strokes.len(), plan.dots(medium));
    // on such a page the width of a stroke says how heavy its line is
    let widest = |line: &Line| line.runs.iter().map(|run| run.width).fold(0.0, f32::max);
    if let Some(heavy) = plan.heavy_strokes() {
        strokes.iter_mut().for_each(|line| line.strength = heavy.strength(widest(line), line.strength));
    }
    let light = strokes.iter().filter(|line| line.strength < params.heavy_from).count();
    let drawn = dots::lines(&strokes, place, &medium.area, &params);
    let (stand_for, shares) = kept_lines::matched(&strokes, place, &drawn, place);
    let (light_is, heavy_is) = match params.has_heights {
        true => ("of middle height", "high"),
        false => ("one row of dots", "two rows"),
    };
    let how = match (light, count - light) {
        (_, 0) => light_is.to_owned(),
        (0, _) => format!("{heavy_is}; a stroke narrower than {} mm is {light_is}", params.pitch),
        (light, heavy) => {
            format!("{light} {light_is} and {heavy} {heavy_is}, those with a stroke of {} mm and more", params.pitch)
        }
    };
    let noun = if count == 1 { "line" } else { "lines" };
    let told = Note::TakenAs(
        About::Lines,
        Reason::StrokesAsDots,
        format!("{count} {noun}{of} on a page of dots made dots, {how}").into(),
    );
    let nameless = || LineName { name: "a line without a name".to_owned(), by_hand: false };
    names.extend(stand_for.into_iter().map(|line| line.map_or_else(nameless, |line| of_strokes[line].clone())));
    lines.extend(drawn);
    std::iter::once(told).chain(kept_lines::lost(&of_strokes, &shares)).collect()
}

/// A page of dots on which somebody drew strokes, with the dots that are made of them, and what is told of them; none
/// if it is another page.
///
/// # Errors
/// If a dot is off the sheet.
pub fn with_strokes_as_dots(read: &Reading, plan: &Plan) -> Result<Option<(Reading, Vec<Note>)>, Error> {
    let Medium::Dots(medium) = &read.page.medium else { return Ok(None) };
    let mut parts = Parts::clone(&read.page);
    let mut lines = LineName::of(&read.names);
    let mut overview_lines = read.names.overview_lines.clone();
    let notes = strokes_as_dots(&mut parts, &mut lines, &mut overview_lines, (medium, plan));
    if notes.is_empty() {
        return Ok(None);
    }
    let lines = lines.into_iter().map(|line| line.name).collect();
    let names = Names { lines, overview_lines, ..read.names.clone() };
    Ok(Some((Reading { page: Page::new(parts)?, names, ..read.clone() }, notes)))
}

/// A mirrored page as it is felt; `own` is the plan that it was made with.
pub fn as_felt(read: Reading, own: &Plan) -> Reading {
    let (medium, cell) = (read.page.medium.clone(), own.profile().braille.cell);
    read.turned_over(|cells| CellGrid::of(&medium, cell).extent(cells, 1).x)
}

/// Which textures have signs of another class; of dots none, which look alike.
fn wrong_signs(page: &Page) -> Vec<usize> {
    let textures = page.figure.textures.iter().enumerate().filter(|_| matches!(page.medium, Medium::Print(_)));
    textures.filter(|(_, texture)| texture.has_other_signs()).map(|(number, _)| number).collect()
}

/// The cells of one area alone.
fn only(areas: &Classes, number: usize) -> Classes {
    let mut one = areas.clone();
    one.region.iter_mut().for_each(|region| *region = region.filter(|of| *of as usize == number));
    one
}

/// The signs of an area of a printed page, drawn anew.
fn fill(page: &Page, one: &Classes, plan: &Plan) -> Vec<Glyph> {
    let drawn = drawn_areas::fill(one, page.figure.place, &page.figure.lines, &page.medium, plan);
    let mut glyphs = drawn.into_iter().flat_map(|texture| texture.glyphs).collect();
    let boxes: Vec<MmRect> = page.braille.iter().filter_map(|text| text.dots.bounds()).collect();
    drawn_areas::clear_of_braille(&mut glyphs, blank_to_signs(&page.medium), &boxes, &page.braille);
    glyphs
}

/// Brings the widths of a line into a range, mm; tells whether any was below it, and whether any was above it.
fn snap(line: &mut Line, [least, most]: [f32; 2]) -> [bool; 2] {
    let mut changed = [false; 2];
    let is_bead: Vec<bool> = line.runs.iter().map(|run| line.is_bead(run)).collect();
    let pieces = line.runs.iter_mut().zip(is_bead).filter(|(run, is_bead)| run.pen == Pen::Stroke && !is_bead);
    for (run, _) in pieces {
        let width = run.width.clamp(least.max(0.0), most.max(least.max(0.0)));
        // widths are written in steps of 0.01 mm
        if (width - run.width).abs() > 0.011 {
            changed[usize::from(width < run.width)] = true;
            run.width = width;
        }
    }
    changed
}

/// An area of which so much is left, as a share of the least that a texture needs, is left out as a whole: a few signs
/// by themselves are felt as dots.
const LEAST_LEFT: f32 = 0.5;

/// The page without those signs of textures that are nearer to a line or a drawn dot than `plan` allows; says how many
/// they are.
///
/// # Errors
/// None of its own: marks only become fewer.
fn without_crowded_signs(page: Page, plan: &Plan) -> Result<(Page, Option<Note>), Error> {
    let crowded = legibility::crowded(&page, &plan.limits());
    if crowded.is_empty() {
        return Ok((page, None));
    }
    let mut parts = Parts::clone(&page);
    let least = LEAST_LEFT * plan.profile().colours.min_area;
    let mut areas = 0;
    // those of one texture follow one another, in its order
    for gone in crowded.chunk_by(|a, b| a.0 == b.0) {
        let texture = &mut parts.figure.textures[gone[0].0];
        let mut at = 0;
        let before = texture.glyphs.len();
        texture.glyphs.retain(|_| {
            at += 1;
            gone.binary_search_by_key(&(at - 1), |(_, glyph)| *glyph).is_err()
        });
        let left = texture.area * texture.glyphs.len() as f32 / before.max(1) as f32;
        if left < least {
            texture.glyphs.clear();
            areas += 1;
        }
    }
    parts.figure.textures.retain(|texture| !texture.glyphs.is_empty());
    let count = crowded.len();
    let (signs, are) = if count == 1 { ("sign", "is") } else { ("signs", "are") };
    let whole = match areas {
        0 => String::new(),
        1 => "; of 1 area too little is left for a texture".to_owned(),
        _ => format!("; of {areas} areas too little is left for a texture"),
    };
    let told =
        format!("{count} {signs} of textures that {are} too near to a line or dot that was drawn or moved{whole}");
    Ok((Page::new(parts)?, Some(Note::NotOnPage(About::Signs, Reason::SignNearLine, told.into()))))
}
