//! What a person gives beside the picture, and the parts of it that are erased.

use super::Fit;
use super::cut_contours::{index_of_edges, parts_apart, parts_left, take_out};
use super::decisions::Decisions;
use super::hand_lines::{HandLines, added};
use super::label::Position;
use super::request::enough_pixels;
use super::text_reader::TextReader;
use crate::classes::Classes;
use crate::edges::Edges;
use crate::page::PartShown;
use crate::profile::{Plan, Profile};
use crate::raster::crop::Crop;
use crate::raster::decode;
use crate::reading::DrawnArea;
use crate::regions::{RegionOutline, TracePoint, TracedContour};
use crate::units::{MmRect, PxPoint, Size};
use crate::{About, Error, GivenFile, Note, Reason};

/// What a person gives beside the picture.
#[derive(Debug, Clone, Default)]
pub struct Given {
    /// The lines of the figure; without them, contours are found in the picture.
    pub lines: Option<GivenLines>,
    /// Lines beside those that are found, which make room for them.
    pub added: Option<HandLines>,
    /// The areas of textures; without them, colours of the picture are sorted.
    pub areas: Option<Classes>,
    /// Who reads text in the pixels of the picture; without, nobody knows what it says.
    pub text_reader: Option<TextReader>,
    /// The areas that somebody drew on the page of which areas are taken.
    pub drawn_areas: Vec<DrawnArea>,
    /// How much of a picture the page shows of which areas are taken, as far as it says.
    pub part_of_areas: Option<PartShown>,
    /// How many braille texts the page has that the lines are of: they are not taken from it.
    pub texts_of_page: usize,
    /// What the maker should know of these files.
    pub notes: GivenNotes,
    /// Parts of the picture, as it is drawn, that stay blank.
    pub erased: Vec<Crop>,
    /// Parts outside which it stays blank; without any, it does so nowhere.
    pub kept: Vec<Crop>,
    /// Places on what the picture is about: from the left and from the top.
    pub subjects: Vec<[Position; 2]>,
    /// Whether weak lines and textures around it are left out.
    pub calm_background: bool,
}

/// What the maker should know of the files that are given.
#[derive(Debug, Clone, Default)]
pub struct GivenNotes {
    /// Of that of the lines.
    pub of_lines: Vec<Note>,
    /// Of that of the added ones.
    pub of_added: Vec<Note>,
    /// Of that of the areas.
    pub of_areas: Vec<Note>,
}

/// Lines in place of those that would be found.
#[derive(Debug, Clone)]
pub enum GivenLines {
    /// Of a page, or of a layer of a drawing.
    Vectors(HandLines),
    /// A picture of them, black on white: the bytes of its file.
    Picture(Vec<u8>),
}

impl GivenLines {
    /// A picture of them, of which the header can be read.
    ///
    /// # Errors
    /// [`Error::Empty`], [`Error::UnknownFormat`], [`Error::Undecodable`], [`Error::TooComplex`], [`Error::Locked`],
    /// and [`Error::TooFewPixels`]. What it may cost is a matter of [`Request::limits`](super::Request::limits).
    pub fn picture(bytes: &[u8]) -> Result<Self, Error> {
        match decode::look_at(bytes, &|header| enough_pixels(header.size)) {
            Ok(()) | Err(Error::TooManyPixels { .. } | Error::TooMuchMemory { .. } | Error::UnpacksTooFar { .. }) => {
                Ok(Self::Picture(bytes.to_vec()))
            }
            Err(other) => Err(other),
        }
    }
}

impl Given {
    /// The plan by which a page is made of it. Of lines that a person gave, all are drawn that have room: few of them
    /// would be others than were meant.
    ///
    /// # Errors
    /// [`Error::Profile`] with every fault of the profile.
    pub fn plan(&self, profile: &Profile) -> Result<Plan, Error> {
        if self.lines.is_none() {
            return Plan::new(profile);
        }
        let mut profile = profile.clone();
        profile.set("lines.detail", "1")?;
        profile.set("lines.shapes", "0")?;
        Plan::new(&profile)
    }

    /// The lines of pages and drawings, in place of those that would be found or beside them.
    pub(super) fn hand_lines(&self) -> impl Iterator<Item = &HandLines> {
        let lines = match &self.lines {
            Some(GivenLines::Vectors(lines)) => Some(lines),
            Some(GivenLines::Picture(_)) | None => None,
        };
        lines.into_iter().chain(&self.added)
    }

    /// What is told of the files that are given; of one that is given as two things, once.
    pub(super) fn told(&self) -> Vec<Note> {
        let GivenNotes { of_lines, of_added, of_areas } = &self.notes;
        let files = [(GivenFile::Lines, of_lines), (GivenFile::AddedLines, of_added), (GivenFile::Areas, of_areas)];
        let mut told: Vec<(&Note, GivenFile)> = Vec::new();
        for (note, file) in files.into_iter().flat_map(|(file, notes)| notes.iter().map(move |note| (note, file))) {
            if !told.iter().any(|(other, _)| *other == note) {
                told.push((note, file));
            }
        }
        told.into_iter().map(|(note, file)| Note::OfFile(file, Box::new(note.clone()))).collect()
    }

    /// What is told of areas that somebody drew beside lines of which only these are taken.
    pub(super) fn told_areas(&self) -> Option<Note> {
        let mut left_out: Vec<&DrawnArea> = Vec::new();
        for area in self.hand_lines().flat_map(HandLines::areas) {
            // a page that is given as both has them among its areas, and one that is given twice has the same
            if !self.drawn_areas.contains(area) && !left_out.contains(&area) {
                left_out.push(area);
            }
        }
        let count = left_out.len();
        let told = || {
            let (noun, them) = if count == 1 { ("area that was", "it is") } else { ("areas that were", "they are") };
            let why = "of what is given as lines no areas are taken; draw them on a page, and give that as areas";
            let told = format!("{count} {noun} drawn beside the lines given, as {them} filled: {why}");
            Note::NotOnPage(About::Areas, Reason::AreasBesideLines, told.into())
        };
        (count > 0).then(told)
    }

    /// Refuses lines and areas of a page that shows another part of the picture than `fit` asks for: they would lie
    /// over something else.
    ///
    /// # Errors
    /// [`Error::OtherPart`].
    pub fn check_parts(&self, fit: &Fit) -> Result<(), Error> {
        let drawn = fit.part();
        let of_lines = self.hand_lines().filter_map(HandLines::part);
        match of_lines.chain(&self.part_of_areas).find(|part| !fit.may_show(part)) {
            Some(part) => Err(Error::OtherPart { page: part.in_words(), drawn: drawn.in_words() }),
            None => Ok(()),
        }
    }

    /// What is told of lines or areas of a page whose picture has another size than this one: it may be another one.
    pub(super) fn told_other_picture(&self, size: Size) -> Option<Note> {
        let parts = self.hand_lines().filter_map(HandLines::part).chain(&self.part_of_areas);
        let other = parts.filter_map(|part| part.source).find(|source| *source != size)?;
        let told = format!(
            "the page given as lines or areas is of a picture of {other} pixels, and this one has {size}: look whether \
             both show the same"
        );
        Some(Note::TakenAs(About::Lines, Reason::OtherPicture, told.into()))
    }

    /// What is erased of a picture of this size, in shares of it: left, top, right, bottom. `figure` is its place on
    /// the sheet.
    ///
    /// # Errors
    /// If a part reaches beyond the picture.
    pub(super) fn boxes(&self, size: Size, figure: MmRect) -> Result<Vec<[f32; 4]>, Error> {
        let shares = |crop: &Crop| crop.shares(size, [figure.width(), figure.height()]);
        let mut boxes: Vec<[f32; 4]> = self.erased.iter().map(shares).collect::<Result<_, _>>()?;
        let kept: Vec<[f32; 4]> = self.kept.iter().map(shares).collect::<Result<_, _>>()?;
        if !kept.is_empty() {
            boxes.extend(around(&kept));
        }
        Ok(boxes)
    }
}

/// The complement of these boxes, as boxes: the picture is cut into strips at their upper and lower edges, and each
/// strip gives the intervals that no box covers.
fn around(boxes: &[[f32; 4]]) -> Vec<[f32; 4]> {
    // a little beyond the picture, whose border counts as inside
    const LOW: f32 = -1.0;
    const HIGH: f32 = 2.0;
    let reach = |[left, top, right, bottom]: [f32; 4]| {
        let low = |at: f32| if at <= 0.0 { LOW } else { at };
        let high = |at: f32| if at >= 1.0 { HIGH } else { at };
        [low(left), low(top), high(right), high(bottom)]
    };
    let boxes: Vec<[f32; 4]> = boxes.iter().copied().map(reach).collect();
    let mut edges: Vec<f32> = boxes.iter().flat_map(|[_, top, _, bottom]| [*top, *bottom]).chain([LOW, HIGH]).collect();
    edges.sort_by(f32::total_cmp);
    let mut left = Vec::new();
    for row in edges.windows(2).filter(|row| row[0] < row[1]) {
        let mut kept: Vec<[f32; 2]> = boxes
            .iter()
            .filter(|[_, top, _, bottom]| *top <= row[0] && row[1] <= *bottom)
            .map(|[left, _, right, _]| [*left, *right])
            .collect();
        kept.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut from = LOW;
        for [start, end] in kept.into_iter().chain([[HIGH, HIGH]]) {
            if start > from {
                left.push([from, row[0], start, row[1]]);
            }
            from = from.max(end);
        }
    }
    left
}

/// Takes the parts of contours out that lie in boxes, in shares of the picture.
pub(super) fn erase(edges: &mut Edges, boxes: &[[f32; 4]]) {
    let size = edges.size;
    if !boxes.is_empty() {
        take_out(edges, |_, _, edgel| is_in(share(edgel.at, size), boxes));
    }
}

/// Leaves the cells in boxes, in shares of the picture, without a colour.
pub(super) fn blank(classes: &mut Classes, boxes: &[[f32; 4]]) {
    if !boxes.is_empty() {
        blank_where(classes, |at| is_in(at, boxes));
    }
}

/// Leaves the cells at some places, in shares of the picture, without a colour.
pub(super) fn blank_where(classes: &mut Classes, is_blank: impl Fn([f32; 2]) -> bool) {
    let [width, height] = [classes.size.width, classes.size.height].map(|side| side as usize);
    blank_cells(classes, |cell, _| {
        is_blank([((cell % width) as f32 + 0.5) / width as f32, ((cell / width) as f32 + 0.5) / height as f32])
    });
}

/// Leaves cells without a colour, given by their number and that of their region. Returns how many.
pub(super) fn blank_cells(classes: &mut Classes, is_blank: impl Fn(usize, u32) -> bool) -> usize {
    let mut blank = 0;
    for (cell, region) in classes.region.iter_mut().enumerate() {
        if let Some(number) = region.filter(|&number| is_blank(cell, number)) {
            // areas of a page may have more cells than they are large
            let cells = &mut classes.regions[number as usize].cells;
            *cells = cells.saturating_sub(1);
            *region = None;
            blank += 1;
        }
    }
    blank
}

/// The parts of outlines of regions that are not erased and do not run along lines that were added.
pub(super) fn with_room(outlines: Vec<RegionOutline>, edges: &Edges, decisions: &Decisions) -> Vec<RegionOutline> {
    let own = added(edges);
    if decisions.erased.is_empty() && own.is_empty() {
        return outlines;
    }
    let near = index_of_edges(&own);
    let is_erased = |point: &TracePoint| is_in(share(point.at, edges.size), &decisions.erased);
    let parts = |RegionOutline { contour, region }: &RegionOutline| {
        let left = parts_left(&contour.vertices, contour.closed, is_erased).into_iter();
        let apart = left.flat_map(|(part, closed)| parts_apart(&part, closed, &near, decisions.room_of_added));
        let part = |(vertices, closed)| RegionOutline { contour: TracedContour { vertices, closed }, region: *region };
        apart.map(part).collect::<Vec<_>>()
    };
    outlines.iter().flat_map(parts).collect()
}

fn share(at: PxPoint, size: Size) -> [f32; 2] {
    [at.x / size.width as f32, at.y / size.height as f32]
}

/// Whether a place, in shares of the picture, lies in one of the boxes.
pub(super) fn is_in([x, y]: [f32; 2], boxes: &[[f32; 4]]) -> bool {
    boxes.iter().any(|[left, top, right, bottom]| (*left..=*right).contains(&x) && (*top..=*bottom).contains(&y))
}

#[cfg(test)]
mod tests;
