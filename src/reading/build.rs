//! A page of what was found drawn.

use super::areas::DrawnArea;
use super::clip;
use super::document::{Elements, layer_of, numbers, own_id, renamed};
use super::kind::{Kind, Sorted, Sorter, common_width};
use super::leaders::with_own_tip;
use super::marks::{PaintedShape, PaintedShapes};
use super::names::{self, Name};
use super::said::{medium, on_sheet, palette, place_of, source};
use super::shapes::glyph;
use super::subpath::clean;
use super::tally::{self, OfFile, Tally, What};
use super::words::{PageWords, language};
use crate::devices::DotArea;
use crate::output::layer::Layer;
use crate::page::{
    BrailleText, Class, DotMedium, Dots, Figure, Height, Line, Medium, Names, Overview, Page, Palette, Parts, Pen,
    PrintText, Run, Shape, Sign, TextRole, Texture, text_name,
};
use crate::units::{MmPoint, MmRect, MmVector, Size};
use crate::{Error, Note};

/// Strength of a line that a person drew, in the unit of contours: that of black on white, since it is meant.
const DRAWN: f32 = 100.0;
/// Two pieces of a line are one where their ends are this near, mm.
const JOINED: f32 = 0.05;
/// A dot this near to one that the device has is that one, mm: coordinates are written in steps of 0.01 mm.
const SAME: f32 = 0.02;
/// Area that a glyph stands for where the page does not say, mm2: that of a dense texture of `swell-a4`.
const GLYPH_AREA: f32 = 11.2;
/// Pixels for a millimetre of a picture that is not known.
const PX_PER_MM: f32 = 4.0;

/// What is found on a page.
pub(super) struct Built {
    pub(super) page: Page,
    pub(super) names: Names,
    pub(super) notes: Vec<Note>,
    /// Areas that a person drew.
    pub(super) areas: Vec<DrawnArea>,
    /// The texts in braille that a person moved, by their names.
    pub(super) moved_texts: Vec<String>,
}

/// The page of these marks.
///
/// # Errors
/// If the device that the page names does not take its sheet, or a number is out of all range.
pub(super) fn page(
    (marks, print, file): (PaintedShapes<'_>, Vec<PrintText>, OfFile),
    words: PageWords,
    elements: &Elements<'_>,
    sheet: [f32; 2],
) -> Result<Built, Error> {
    let PaintedShapes { marks, transforms, patterned, far, .. } = marks;
    let place = |layer: Layer| place_of(layer, elements, transforms.get(&layer.id()));
    let medium = medium(&words, sheet)?;
    let sorter = Sorter {
        is_foreign: elements.has_layer() && !elements.are_of_page,
        sheet,
        has_heights: medium.has_heights(),
        is_dotted: matches!(medium, Medium::Dots(_)),
        common_width: common_width(&marks),
    };
    let builder = Builder::new(&medium, palette(&words), sorter).with(&marks);
    let Builder {
        mut parts,
        tally,
        overview,
        overview_frame,
        mut regions,
        areas,
        line_names,
        overview_names,
        text_begins,
        moved_texts,
        ..
    } = builder;
    regions.sort_by_key(|(number, _, _)| *number);
    let area_names = regions.iter().map(|(_, name, _)| name.clone()).collect();
    let moved_texts = moved_texts.into_iter().map(|text| text_name(&parts.braille[text])).collect();
    let texts: Vec<(String, usize)> = parts.braille.iter().map(text_name).zip(text_begins).collect();
    let objects = [line_names, overview_names, area_names];
    let names = names::of_page(&objects, texts, elements.text);
    parts.figure.textures = regions.into_iter().map(|(_, _, texture)| texture).collect();
    parts.figure.place = on_sheet(place(Layer::Figure), sheet);
    parts.figure.source = source(elements).unwrap_or_else(|| {
        let px = |mm: f32| (mm * PX_PER_MM).round().clamp(1.0, 100_000.0) as u32;
        Size::new(px(parts.figure.place.width()), px(parts.figure.place.height()))
    });
    if elements.layer(Layer::Overview).is_some() && !(overview.is_empty() && overview_frame.at.is_empty()) {
        let place = on_sheet(place(Layer::Overview), sheet);
        parts.overview = Some(Overview { place, frame: overview_frame, lines: overview });
    }
    let notes = tally.notes().chain(OfFile { far, patterned, ..file }.told());
    let notes = notes.chain(tally::told_no_figure(elements)).chain(tally::told_renamed(elements)).collect();
    let [width, height] = sheet;
    let is_on_sheet = |text: &PrintText| (0.0..=width).contains(&text.at.x) && (0.0..=height).contains(&text.at.y);
    parts.print = print.into_iter().filter(is_on_sheet).collect();
    parts.title = words.title;
    parts.language = words.language;
    parts.description = words.description;
    parts.description_language = words.description_language;
    parts.origin = words.origin;
    parts.medium = medium;
    Ok(Built { page: Page::new(parts)?, names, notes, areas, moved_texts })
}

/// The strokes and rows of dots of one object.
struct Pieces {
    object: usize,
    layer: Layer,
    strength: f32,
    name: Name,
    runs: Vec<Run>,
}

impl Pieces {
    fn of(mark: &PaintedShape<'_>, layer: Layer, runs: Vec<Run>) -> Self {
        let strength = mark.element.attribute("data-strength").and_then(|text| text.parse::<f32>().ok());
        let strength = strength.filter(|strength| strength.is_finite() && *strength >= 0.0).unwrap_or(DRAWN);
        Self { object: mark.object, layer, strength, name: names::of_line(mark.element, mark.clone), runs }
    }
}

struct Builder<'m> {
    medium: &'m Medium,
    /// The signs of layers that do not say which they have, such as one that a person made.
    palette: Palette,
    sheet: [f32; 2],
    sorter: Sorter,
    parts: Parts,
    overview: Vec<Line>,
    overview_frame: Dots,
    line_names: Vec<Name>,
    overview_names: Vec<Name>,
    /// Textures by the number that their id has.
    regions: Vec<(usize, Name, Texture)>,
    /// Which text is which object.
    texts: Vec<usize>,
    /// Where the element of each text begins in the file.
    text_begins: Vec<usize>,
    /// Which of them a person moved: they are written without a transform.
    moved_texts: Vec<usize>,
    /// Areas that a person drew.
    areas: Vec<DrawnArea>,
    /// Which dots of labels are which object.
    labels: Vec<usize>,
    /// What lies in the layer of the orientation mark, one of which is that.
    orientation_marks: Vec<Pieces>,
    tally: Tally,
}

impl<'m> Builder<'m> {
    fn new(medium: &'m Medium, palette: Palette, sorter: Sorter) -> Self {
        let sheet = sorter.sheet;
        let empty = Figure { place: MmRect::zero(), source: Size::new(1, 1), textures: Vec::new(), lines: Vec::new() };
        Self {
            medium,
            palette,
            sheet,
            sorter,
            parts: Parts::of(sheet, empty),
            overview: Vec::new(),
            overview_frame: Dots::default(),
            line_names: Vec::new(),
            overview_names: Vec::new(),
            regions: Vec::new(),
            texts: Vec::new(),
            text_begins: Vec::new(),
            moved_texts: Vec::new(),
            areas: Vec::new(),
            labels: Vec::new(),
            orientation_marks: Vec::new(),
            tally: Tally::default(),
        }
    }

    /// The same with all that paths draw.
    fn with(mut self, marks: &[PaintedShape<'_>]) -> Self {
        let mut runs: Vec<Pieces> = Vec::new();
        marks.iter().for_each(|mark| self.add(mark, &mut runs));
        runs.extend(self.keep_orientation_mark());
        runs.into_iter().for_each(|pieces| self.add_lines(pieces));
        self
    }

    /// Adds what a path draws. Strokes are collected, object by object, in `runs`.
    fn add(&mut self, mark: &PaintedShape<'_>, runs: &mut Vec<Pieces>) {
        let first = mark.subpaths.first().and_then(|subpath| subpath.points.first()).copied();
        let Sorted { kind, area, told } = self.sorter.sort(mark);
        self.areas.extend(area);
        told.into_iter().for_each(|what| self.tally.add(what, first));
        match kind {
            Kind::LeftOut(what) => self.tally.add(what, first),
            Kind::Blank => {}
            Kind::Strokes(of_path) => self.add_strokes(mark, of_path, runs),
            Kind::Signs(class) => self.add_glyphs(mark, class),
            Kind::Discs(discs, height) => self.add_discs(mark, &discs, height, runs),
            Kind::Around(around, layer) => collect(mark, layer, around, runs),
        }
    }

    fn add_strokes(&mut self, mark: &PaintedShape<'_>, of_path: Vec<Run>, runs: &mut Vec<Pieces>) {
        let is_text = mark.element.has_attribute("data-braille");
        match mark.layer {
            Some(Layer::OrientationMark) => {
                let pieces = Pieces::of(mark, Layer::Lines, of_path);
                self.orientation_marks.push(pieces);
            }
            Some(Layer::Registration) => {
                let kept = self.on_sheet(of_path);
                self.parts.registration.extend(kept);
            }
            Some(Layer::Braille(role)) if is_text => {
                let leader = self.on_sheet(of_path).into_iter().next();
                let leader = leader.map(|leader| with_own_tip(leader, mark.element));
                let index = self.text_of(mark, role);
                self.parts.braille[index].leader = leader;
            }
            Some(layer @ (Layer::Lines | Layer::Overview)) => collect(mark, layer, of_path, runs),
            layer => {
                if !matches!(layer, Some(Layer::Figure)) {
                    let at = of_path.first().and_then(|run| run.points.first()).copied();
                    self.tally.add(What::LineOutside, at);
                }
                collect(mark, Layer::Lines, of_path, runs);
            }
        }
    }

    /// Keeps of the marks in the layer of the orientation mark the one that is nearest to the upper corner that it
    /// cuts, whichever comes first in the file; the others, which are returned, are lines.
    fn keep_orientation_mark(&mut self) -> Vec<Pieces> {
        let mut marks = std::mem::take(&mut self.orientation_marks);
        let corners = [MmPoint::zero(), MmPoint::new(self.sheet[0], 0.0)];
        let off = |mark: &Pieces| {
            let points = mark.runs.first().map_or(&[][..], |run| &run.points);
            let to = |corner: MmPoint| points.iter().map(|at| (*at - corner).length()).sum::<f32>();
            corners.map(to).into_iter().fold(f32::MAX, f32::min) / points.len().max(1) as f32
        };
        let nearest = (0..marks.len()).min_by(|a, b| off(&marks[*a]).total_cmp(&off(&marks[*b])));
        let Some(own) = nearest.map(|own| marks.remove(own)) else { return marks };
        let mut own = self.on_sheet(own.runs).into_iter();
        self.parts.orientation_mark = own.next();
        self.parts.registration.extend(own);
        for other in &marks {
            let at = other.runs.first().and_then(|run| run.points.first()).copied();
            self.tally.add(What::BesideMark, at);
        }
        marks
    }

    /// Runs that end where the next begins are one line.
    fn add_lines(&mut self, pieces: Pieces) {
        let Pieces { layer, strength, name, runs, .. } = pieces;
        let mut lines: Vec<Line> = Vec::new();
        for run in self.on_sheet(runs) {
            let follows = lines.last().and_then(|line| line.runs.last()).is_some_and(|last| {
                // a heavy line has a second row of dots beside the first
                if (last.pen, run.pen) != (Pen::Stroke, Pen::Stroke) {
                    return last.pen != Pen::Stroke && run.pen != Pen::Stroke;
                }
                let ends = last.points.last().zip(run.points.first());
                !last.closed && !run.closed && ends.is_some_and(|(a, b)| (*a - *b).length() <= JOINED)
            });
            match lines.last_mut() {
                Some(line) if follows => line.runs.push(run),
                _ => lines.push(Line { strength, runs: vec![run] }),
            }
        }
        let (all, names) = if layer == Layer::Overview {
            (&mut self.overview, &mut self.overview_names)
        } else {
            (&mut self.parts.figure.lines, &mut self.line_names)
        };
        names.extend(std::iter::repeat_n(name, lines.len()));
        all.extend(lines);
    }

    fn add_discs(&mut self, mark: &PaintedShape<'_>, discs: &[(MmPoint, f32)], height: Height, runs: &mut Vec<Pieces>) {
        let Some(&(_, diameter)) = discs.first() else { return };
        let uneven = discs.iter().find(|(_, other)| (other - diameter).abs() > SAME);
        if let Some((at, _)) = uneven {
            self.tally.add(What::UnevenDots, Some(*at));
        }
        let diameter = self.device_diameter(diameter);
        let mut at: Vec<MmPoint> = discs.iter().map(|(at, _)| self.device_dot(*at)).collect();
        let before = at.len();
        let first = at.first().copied();
        at.retain_mut(|at| nudged(at, 0.5 * diameter, self.sheet));
        if at.len() < before {
            self.tally.add(What::OffSheet, first);
        }
        let is_dotted = matches!(self.medium, Medium::Dots(_));
        let row = |at: Vec<MmPoint>| Run::dots(diameter, at, height);
        // as on paper: one by itself that a person drew among lines is no line
        let is_dot =
            mark.layer == Some(Layer::Lines) && discs.len() == 1 && !mark.element.has_attribute("data-strength");
        match mark.layer {
            Some(Layer::Frame) => extend(&mut self.parts.frame, diameter, at),
            Some(Layer::OverviewFrame) => extend(&mut self.overview_frame, diameter, at),
            Some(Layer::OrientationMark) if is_dotted => {
                let pieces = Pieces::of(mark, Layer::Lines, vec![row(at)]);
                self.orientation_marks.push(pieces);
            }
            Some(Layer::Registration) if is_dotted => self.parts.registration.push(row(at)),
            Some(layer @ (Layer::Lines | Layer::Overview)) if is_dotted && !is_dot => {
                collect(mark, layer, vec![row(at)], runs);
            }
            Some(Layer::Braille(role)) if mark.element.has_attribute("data-braille") => {
                let index = self.text_of(mark, role);
                let text = &mut self.parts.braille[index];
                if mark.is_direct {
                    extend(&mut text.dots, diameter, at);
                } else {
                    text.leader = Some(row(at));
                }
            }
            layer => {
                if layer.is_none() {
                    self.tally.add(What::DotOutside, at.first().copied());
                }
                let own = self.labels.last() == Some(&mark.object);
                match self.parts.labels.last_mut().filter(|dots| own && (dots.diameter - diameter).abs() <= SAME) {
                    Some(dots) => dots.at.extend(at),
                    None => {
                        self.labels.push(mark.object);
                        self.parts.labels.push(Dots { diameter, at });
                    }
                }
            }
        }
    }

    fn add_glyphs(&mut self, mark: &PaintedShape<'_>, class: Class) {
        let mut glyphs = Vec::with_capacity(mark.subpaths.len());
        for subpath in &mark.subpaths {
            let Some(mut glyph) = glyph(subpath) else {
                self.tally.add(What::NoGlyph, subpath.points.first().copied());
                continue;
            };
            glyph.at = self.device_dot(glyph.at);
            if let Shape::Dot { diameter } = &mut glyph.shape {
                *diameter = self.device_diameter(*diameter);
            }
            let radius = glyph.radius();
            if nudged(&mut glyph.at, radius, self.sheet) {
                glyphs.push(glyph);
            } else {
                self.tally.add(What::OffSheet, Some(glyph.at));
            }
        }
        if glyphs.is_empty() {
            return;
        }
        let element = mark.element;
        let layer = element.ancestors().find(|node| layer_of(*node) == Some(Layer::Texture(class)));
        // a layer that was renamed has the sign of its old class
        let layer = layer.filter(|layer| renamed(*layer).is_none());
        let sign = layer.and_then(|layer| layer.attribute("data-sign")).and_then(Sign::named);
        let colour = numbers(element, "data-colour").and_then(|all| <[f32; 3]>::try_from(all).ok());
        let area = numbers(element, "data-area").and_then(|all| all.first().copied());
        let number = own_id(element).and_then(|id| id.strip_prefix("region-")?.parse().ok());
        let texture = Texture {
            class,
            sign: sign.unwrap_or_else(|| self.palette.sign(class)),
            colour: colour.map_or([128; 3], |colour| colour.map(|channel| channel.clamp(0.0, 255.0) as u8)),
            area: area.map_or(GLYPH_AREA * glyphs.len() as f32, |area| clean((area * mark.area_scale).max(0.0))),
            glyphs,
        };
        self.regions.push((number.unwrap_or(usize::MAX), names::of_area(element, mark.clone, class), texture));
    }

    /// The text that an object is; a new one if it was not met yet.
    fn text_of(&mut self, mark: &PaintedShape<'_>, role: TextRole) -> usize {
        if let Some(index) = self.texts.iter().position(|object| *object == mark.object) {
            return index;
        }
        let said = |name: &str| mark.element.attribute(name).map(str::to_owned);
        let (spoken, abbreviation) = (said("aria-label").unwrap_or_default(), said("data-abbreviation"));
        let prefix = abbreviation.as_ref().map(|short| format!("{short}: ")).unwrap_or_default();
        let text = spoken.strip_prefix(&prefix).unwrap_or(&spoken).to_owned();
        let lines = said("data-braille").unwrap_or_default();
        self.texts.push(mark.object);
        self.text_begins.push(mark.element.range().start);
        if mark.element.ancestors().any(|around| around.has_attribute("transform")) {
            self.moved_texts.push(self.parts.braille.len());
        }
        self.parts.braille.push(BrailleText {
            role,
            text,
            language: language(Some(mark.element)),
            abbreviation,
            lines: lines.split(' ').filter(|line| !line.is_empty()).map(str::to_owned).collect(),
            dots: Dots::default(),
            leader: None,
        });
        self.texts.len() - 1
    }

    /// What of these runs lies on the sheet.
    fn on_sheet(&mut self, runs: Vec<Run>) -> Vec<Run> {
        let sheet = self.sheet;
        let mut kept = Vec::with_capacity(runs.len());
        for mut run in runs {
            let Some(&first) = run.points.first() else { continue };
            let radius = 0.5 * run.width;
            if run.points.iter_mut().all(|at| nudged(at, radius, sheet)) {
                kept.push(run);
                continue;
            }
            let of_stroke = MmRect::new(MmPoint::zero(), sheet.into()).inflate(-radius, -radius);
            let parts = match run.pen {
                Pen::Stroke if !of_stroke.is_empty() => clip::inside(&run.points, run.closed, of_stroke),
                _ => Vec::new(),
            };
            // half the width of a line along the edge of the sheet is not missed
            let all = MmRect::new(MmPoint::zero(), sheet.into()).inflate(SAME, SAME);
            if parts.is_empty() {
                // one along the edge is beyond the sheet with half of its width
                let is_broad = run.pen == Pen::Stroke && of_stroke.is_empty();
                let inside = run.points.iter().find(|at| is_broad && all.contains(**at));
                self.tally.add(inside.map_or(What::OffSheet, |_| What::TooBroad), Some(*inside.unwrap_or(&first)));
            } else if let Some(beyond) = run.points.iter().find(|at| !all.contains(**at)) {
                self.tally.add(What::CutAtSheet, Some(*beyond));
            }
            kept.extend(parts.into_iter().map(|points| Run { points, closed: false, ..run.clone() }));
        }
        kept
    }

    /// The dot that the device has there; on paper, and where it has none, the place itself.
    fn device_dot(&self, at: MmPoint) -> MmPoint {
        let Medium::Dots(DotMedium { area: DotArea::Grid(grid), .. }) = self.medium else { return at };
        let nearest = grid.nearest(at).and_then(|[column, row]| grid.at(column, row));
        nearest.filter(|dot| (*dot - at).length() <= SAME).unwrap_or(at)
    }

    fn device_diameter(&self, diameter: f32) -> f32 {
        match self.medium {
            Medium::Dots(dots) if (dots.diameter() - diameter).abs() <= SAME => dots.diameter(),
            Medium::Print(_) | Medium::Dots(_) => diameter,
        }
    }
}

/// Keeps the pieces of one object together, in the order in which they are drawn.
fn collect(mark: &PaintedShape<'_>, layer: Layer, of_path: Vec<Run>, runs: &mut Vec<Pieces>) {
    match runs.last_mut() {
        Some(pieces) if pieces.object == mark.object => pieces.runs.extend(of_path),
        _ => runs.push(Pieces::of(mark, layer, of_path)),
    }
}

fn extend(dots: &mut Dots, diameter: f32, at: Vec<MmPoint>) {
    if dots.at.is_empty() {
        dots.diameter = diameter;
    }
    dots.at.extend(at);
}

/// Whether a mark that reaches `radius` mm around a place lies on the sheet; what is off by rounding only is moved.
fn nudged(at: &mut MmPoint, radius: f32, [width, height]: [f32; 2]) -> bool {
    let moved = MmPoint::new(at.x.min(width - radius).max(radius), at.y.min(height - radius).max(radius));
    let off: MmVector = moved - *at;
    if off.length() > SAME {
        return false;
    }
    *at = moved;
    at.x - radius >= 0.0 && at.y - radius >= 0.0 && at.x + radius <= width && at.y + radius <= height
}
