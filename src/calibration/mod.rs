//! The calibration sheet: samples that a workshop prints once, to choose the numbers of its profile by touch.
//!
//! ```text
//!  a  | | | ...          lines, from the thinnest that a profile can ask for to 3 mm
//!  b  || | | ...         pairs of lines, 1 to 8 mm apart
//!  c  braille in cells of several measures
//!  d  frames             as the profile has it, finer and coarser
//!  e  the smallest glyphs
//!  f..j  textures        one table a class: three densities down, five boldnesses across
//! ```
//!
//! The marks come from the same code as those of a page, with the profile's numbers wherever a sample does not vary
//! them.
//!
//! Above each section stand its letter and the keys of the profile that it decides, in braille; each sample has a
//! number. The alternative was as many dots as the number says. Nobody has to know braille for these, but a finger has
//! to count up to eleven dots, and at a pitch of 2.5 mm they are wider than the samples. The description of the sheet
//! says the same as the labels.

mod dotted;
mod flow;
mod headings;
mod samples;

use flow::{Block, SheetMarks, SheetOfSamples};
pub use headings::title;
use headings::{Decides, heading_of, listed, told, words_of};

use crate::Error;
use crate::braille::CellSize;
use crate::classes::Class;
use crate::page::layout::FrameParams;
use crate::page::{DotMedium, Dots, Figure, MediumParams, Page, Parts};
use crate::profile::{Plan, Profile};
use crate::textures::{self, Sign};
use crate::units::{MmPoint, MmRect, MmVector, Size};

/// Widths of single lines, mm: from the least that a profile accepts (`lines.width_min`) to that of thick pens for
/// swell paper; the profile's own widths are added.
const WIDTHS: [f32; 11] = [0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0];
/// Gaps between the edges of two lines, mm: on both sides of the 3.2 and 6.4 mm of the guidelines.
const GAPS: [f32; 8] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
/// Additional blank after a pair of lines, mm: with the blank between samples, well over the widest gap in a pair.
const PAIR_GAP: f32 = 6.0;
/// Additional blank after a word of braille, mm: one braille cell.
const WORD_GAP: f32 = 6.0;
/// Distances of a frame's dots as shares of the profile's.
const FRAME_PITCHES: [f32; 3] = [0.75, 1.0, 1.5];
/// Thicknesses of the smallest glyph, mm: on both sides of 0.5 mm, the least that notes on hatching give for print.
const GLYPHS: [f32; 6] = [0.3, 0.4, 0.5, 0.6, 0.8, 1.0];
/// Lightness of the samples of a texture, as shares of the lightness from which there is no texture: from the boldest
/// glyphs to the lightest; at still lighter colours rows are left out.
const LIGHTNESS: [f32; 5] = [0.25, 0.45, 0.65, 0.8, 0.95];
/// Spacing of the glyphs of the middle density as a multiple of the dense one; the sparse texture has half the rows.
const WIDER: f32 = 1.25;

/// A group of samples, what it decides, and its description.
struct Section {
    blocks: Vec<Block>,
    keys: Decides,
    key: String,
}

/// The calibration sheets for a profile, one page each.
///
/// # Errors
/// [`Error::NoRoom`] if the profile's sheet is too small for a sample.
pub fn sheets(plan: &Plan) -> Result<Vec<Page>, Error> {
    let profile = plan.profile();
    let [width, height, margin] = [profile.page.width, profile.page.height, profile.page.margin];
    if let MediumParams::Dots { device, pitch } = plan.medium() {
        let dots = DotMedium::on(device, pitch, [width, height])
            .map_err(|_| Error::NoRoom { sample: "dot".to_owned(), sheet: format!("{width} x {height} mm") })?;
        return dotted::sheets(plan, dots);
    }
    let area = MmVector::new(width - 2.0 * margin, height - 2.0 * margin);
    let sections = sections(plan);
    let blocks = sections.iter().enumerate().flat_map(|(number, section)| {
        let heading = samples::heading(&heading_of(number, section.keys, samples::cells_in(area.x)));
        let blocks = [heading].into_iter().chain(section.blocks.iter().cloned());
        blocks.map(move |block| Block { section: number, ..block })
    });
    let sheets = flow::place(blocks.collect(), area).map_err(|flow::TooLarge(size)| Error::NoRoom {
        sample: format!("{:.0} x {:.0} mm", size.x.ceil(), size.y.ceil()),
        sheet: format!("{width} x {height} mm"),
    })?;
    let count = sheets.len();
    let pages = sheets.iter().enumerate().map(|(index, sheet)| page(sheet, index + 1, count, &sections, plan));
    pages.collect()
}

fn sections(plan: &Plan) -> Vec<Section> {
    let profile = plan.profile();
    let textures = plan.textures();
    let mut sections = vec![single_lines(profile), pairs(profile), braille_cells(), frames(profile), glyphs(&textures)];
    for class in Class::ALL {
        sections.push(textured(class, &textures));
    }
    sections
}

/// Numbered samples in rows.
fn row(samples: impl IntoIterator<Item = Block>) -> Vec<Block> {
    let numbered = samples.into_iter().enumerate();
    numbered.map(|(i, sample)| Block { starts_row: i == 0, ..samples::numbered(i + 1, &sample) }).collect()
}

fn single_lines(profile: &Profile) -> Section {
    let own = [profile.lines.width_min, profile.lines.width_max];
    let mut widths: Vec<f32> = WIDTHS.into_iter().chain(own.into_iter().filter(|width| *width <= 3.0)).collect();
    widths.sort_by(f32::total_cmp);
    widths.dedup_by(|a, b| (*a - *b).abs() < 0.005);
    let strength = profile.lines.full_strength;
    let key = format!("lines {} mm wide", listed(&widths));
    Section {
        keys: &["lines.width_min", "lines.width_max"],
        blocks: row(widths.iter().map(|&width| samples::lines(&[width], 0.0, strength))),
        key,
    }
}

fn pairs(profile: &Profile) -> Section {
    let width = profile.lines.width_max;
    let key = format!("pairs of lines {width} mm wide with gaps of {} mm", listed(&GAPS));
    let pair = |gap| samples::lines(&[width; 2], gap, profile.lines.full_strength);
    let blocks = row(GAPS.map(pair)).into_iter().map(|block| samples::apart(PAIR_GAP, block));
    Section { blocks: blocks.collect(), keys: &["lines.min_gap"], key }
}

fn braille_cells() -> Section {
    // cells of several countries have the same measures
    let measures = |cell: &CellSize| [cell.dot, cell.cell, cell.line].map(f32::to_bits);
    let mut sizes: Vec<(CellSize, String)> = Vec::new();
    for cell in CellSize::ALL {
        match sizes.iter_mut().find(|(other, _)| measures(other) == measures(&cell)) {
            Some((_, names)) => *names += &format!(" or {}", cell.name),
            None => sizes.push((cell, cell.name.to_owned())),
        }
    }
    let names: Vec<&str> = sizes.iter().map(|(_, names)| names.as_str()).collect();
    let key = format!("a full braille cell and the word dot, in cells of {}", listed(&names));
    let blocks = row(sizes.iter().map(|(cell, _)| samples::braille_trial(*cell))).into_iter();
    let blocks = blocks.map(|block| samples::apart(WORD_GAP, block)).collect();
    Section { blocks, keys: &["braille.cell"], key }
}

fn frames(profile: &Profile) -> Section {
    let frame = &profile.frame;
    let pitches = FRAME_PITCHES.map(|share| (100.0 * share * frame.pitch).round() / 100.0);
    let key = format!("frames of dots of {} mm, {} mm from dot to dot", frame.dot, listed(&pitches));
    let sample = |pitch| samples::frame(&FrameParams { width: frame.width, dot: frame.dot, pitch, gap: 0.0 });
    Section { blocks: row(pitches.map(sample)), keys: &["frame.pitch"], key }
}

fn glyphs(params: &textures::Params) -> Section {
    let side = samples::side(params);
    let key = format!("the smallest rhombuses, above, and dots, {} mm thick", listed(&GLYPHS));
    let sample = |thin| {
        // as thin for every lightness
        let params = textures::Params { min_glyph: thin, thickness: thin, dot: thin, ..*params };
        let of = |class| samples::texture(class, 0.0, 1.0, side, &params);
        samples::stacked(&of(Class::Blue), &of(Class::Grey))
    };
    Section { blocks: row(GLYPHS.map(sample)), keys: &["textures.min_glyph"], key }
}

/// The table of one class. Pages never have the middle density: it shows a profile with wider textures.
fn textured(class: Class, params: &textures::Params) -> Section {
    let wider = textures::Params {
        along: WIDER * params.along,
        across: WIDER * params.across,
        dot_pitch: WIDER * params.dot_pitch,
        ..*params
    };
    let side = samples::side(params);
    let rows = [(params, 1.0), (&wider, 1.0), (params, 0.0)].map(|(params, density)| {
        let sample = |share| samples::texture(class, share * params.white_from, density, side, params);
        LIGHTNESS.map(sample).to_vec()
    });
    let lightness = LIGHTNESS.map(|share| (100.0 * share * params.white_from).round() / 100.0);
    let key = format!(
        "the texture of {}; down 1 dense, 2 the same {WIDER} times as far apart, 3 sparse; across for colours of \
         lightness {}",
        class.name(),
        listed(&lightness)
    );
    let keys: Decides = match params.palette.sign(class) {
        Sign::Dot => &["textures.dot_pitch", "textures.white_from"],
        Sign::Rhombus { .. } => &["textures.along", "textures.across", "textures.white_from"],
    };
    Section { blocks: vec![Block { starts_row: true, ..samples::table(&rows) }], keys, key }
}

/// One sheet as a page: a figure that fills it. As there is no picture, a pixel of the source is a millimetre.
fn page(sheet: &SheetOfSamples, number: usize, count: usize, sections: &[Section], plan: &Plan) -> Result<Page, Error> {
    let profile = plan.profile();
    let [width, height, margin] = [profile.page.width, profile.page.height, profile.page.margin];
    let place = MmRect::new(MmPoint::new(margin, margin), MmPoint::new(width - margin, height - margin));
    let mut marks = SheetMarks::default();
    for (block, corner) in sheet {
        marks.add(&block.marks, *corner + place.min.to_vector());
    }
    marks.textures.sort_by_key(|texture| texture.class);
    let on_sheet = |section: usize| sheet.iter().any(|(block, _)| block.section == section);
    let keys = sections.iter().enumerate().filter(|(section, _)| on_sheet(*section));
    let keys: String = keys.map(|(section, Section { keys, key, .. })| told(section, keys, key)).collect();
    let (title, description, origin) = words_of(plan, (number, count), &keys);
    let figure = Figure {
        place,
        source: Size::new(place.width().round().max(1.0) as u32, place.height().round().max(1.0) as u32),
        textures: marks.textures,
        lines: marks.lines,
    };
    // no orientation mark: the letters of the labels show which side is up
    let parts = Parts {
        title,
        description,
        origin,
        frame: Dots { diameter: profile.frame.dot, at: marks.frame },
        labels: marks.labels,
        ..Parts::of([width, height], figure)
    };
    Page::new(parts)
}
