//! Refuses pages that take too long to interpret, before they are: a form that draws ten forms that draw ten forms and
//! so on is a small file that takes years.

use std::collections::HashMap;

use hayro_interpret::hayro_syntax::content::TypedIter;
use hayro_interpret::hayro_syntax::content::ops::TypedInstruction;
use hayro_interpret::hayro_syntax::object::{Array, Dict, Name, ObjectIdentifier, Stream};
use hayro_interpret::hayro_syntax::page::{Page, Resources};

use super::unpacked::FORMAT;
use crate::Error;
use crate::raster::decode::job::{Limits, unpacks_too_far};

/// Most steps with each form, pattern and letter counted as often as it is drawn. Maps of whole countries have some
/// millions; hayro takes about a second for ten.
const MOST_STEPS: u64 = 20_000_000;

/// Most forms, patterns, masks and drawn letters one inside the other; hayro stops at 50 of a kind.
const MOST_LEVELS: u32 = 40;

/// hayro-svg interprets what it puts at the end of its text twice: patterns, masks and drawn letters.
const TWICE: u64 = 2;

/// # Errors
/// If the page has too many steps, is too deep, or draws a part of itself inside that part.
pub(super) fn check(page: &Page<'_>, limits: Limits) -> Result<(), Error> {
    if length(page) > limits.memory_mb.saturating_mul(1_000_000) {
        return Err(unpacks_too_far(FORMAT, "the page", limits));
    }
    let steps =
        page.page_stream().map_or(Ok(0), |content| Costs::default().of_content(content, page.resources(), MOST_LEVELS));
    if steps? > MOST_STEPS {
        return Err(Error::too_complex(FORMAT, format!("its page takes more than {MOST_STEPS} steps to draw")));
    }
    Ok(())
}

/// How long a page's contents are when they are unpacked and joined: a page may name one part many times.
fn length(page: &Page<'_>) -> u64 {
    let Some(parts) = page.raw().get::<Array<'_>>("Contents") else { return 0 };
    let mut known = HashMap::new();
    let unpacked = |part: &Stream<'_>| part.decoded_data().map_or(0, |content| content.len() as u64);
    parts.iter::<Stream<'_>>().map(|part| *known.entry(part.obj_id()).or_insert_with(|| unpacked(&part))).sum()
}

/// Steps of what was looked into; none as long as it is.
#[derive(Default)]
struct Costs(HashMap<ObjectIdentifier, Option<u64>>);

impl Costs {
    fn of_content(&mut self, content: &[u8], resources: &Resources<'_>, levels: u32) -> Result<u64, Error> {
        let levels = levels.checked_sub(1).ok_or_else(|| {
            let told = format!("it is drawn in too many levels, more than {MOST_LEVELS} one inside the other");
            Error::too_complex(FORMAT, told)
        })?;
        // The dearest pattern and font that were chosen so far: what is chosen again later is not followed.
        let (mut pattern, mut font) = (0, 0);
        let mut total = 0_u64;
        let mut steps = TypedIter::new(content);
        while let Some(step) = steps.next() {
            let more = match step {
                TypedInstruction::XObject(name) => match resources.get_x_object(name.0) {
                    Some(stream) if is_form(&stream) => self.of_stream(&stream, resources, levels)?,
                    _ => 0,
                },
                TypedInstruction::SetGraphicsState(name) => {
                    let mask = resources.get_ext_g_state(name.0).and_then(|state| state.get::<Dict<'_>>("SMask"));
                    match mask.and_then(|mask| mask.get::<Stream<'_>>("G")) {
                        Some(group) => TWICE * self.of_stream(&group, resources, levels)?,
                        None => 0,
                    }
                }
                TypedInstruction::NonStrokeColorNamed(colour) => {
                    pattern = pattern.max(self.of_pattern(colour.1, resources, levels)?);
                    0
                }
                TypedInstruction::StrokeColorNamed(colour) => {
                    pattern = pattern.max(self.of_pattern(colour.1, resources, levels)?);
                    0
                }
                TypedInstruction::TextFont(chosen) => {
                    font = font.max(self.of_font(chosen.0, resources, levels)?);
                    0
                }
                TypedInstruction::ShowText(text) => font * text.0.as_bytes().len() as u64,
                TypedInstruction::NextLineAndShowText(text) => font * text.0.as_bytes().len() as u64,
                TypedInstruction::ShowTextWithParameters(text) => font * text.2.as_bytes().len() as u64,
                TypedInstruction::ShowTexts(texts) => font * texts.0.data().len() as u64,
                TypedInstruction::StrokePath(_)
                | TypedInstruction::CloseAndStrokePath(_)
                | TypedInstruction::FillPathNonZero(_)
                | TypedInstruction::FillPathNonZeroCompatibility(_)
                | TypedInstruction::FillPathEvenOdd(_)
                | TypedInstruction::FillAndStrokeNonZero(_)
                | TypedInstruction::FillAndStrokeEvenOdd(_)
                | TypedInstruction::CloseFillAndStrokeNonZero(_)
                | TypedInstruction::CloseFillAndStrokeEvenOdd(_) => pattern,
                _ => 0,
            };
            total = total.saturating_add(1).saturating_add(more);
            if total > MOST_STEPS {
                break;
            }
        }
        Ok(total)
    }

    /// Steps of a form, a pattern or a mask.
    fn of_stream(&mut self, stream: &Stream<'_>, around: &Resources<'_>, levels: u32) -> Result<u64, Error> {
        let id = stream.obj_id();
        match self.0.get(&id) {
            Some(Some(known)) => return Ok(*known),
            Some(None) => return Err(Error::undecodable(FORMAT, "a part of it draws itself")),
            // not looked into yet
            None => {}
        }
        self.0.insert(id, None);
        let own = stream.dict().get::<Dict<'_>>("Resources").map(Resources::new);
        let steps = match stream.decoded_data() {
            Ok(content) => self.of_content(&content, own.as_ref().unwrap_or(around), levels)?,
            Err(_) => 0,
        };
        self.0.insert(id, Some(steps));
        Ok(steps)
    }

    fn of_pattern(&mut self, name: Option<&Name<'_>>, resources: &Resources<'_>, levels: u32) -> Result<u64, Error> {
        let stream = name.and_then(|name| resources.get_pattern(name)).and_then(|pattern| pattern.into_stream());
        stream.map_or(Ok(0), |stream| Ok(TWICE * self.of_stream(&stream, resources, levels)?))
    }

    /// Steps of the dearest letter of a font whose letters are drawings.
    fn of_font(&mut self, name: &Name<'_>, resources: &Resources<'_>, levels: u32) -> Result<u64, Error> {
        let Some(font) = resources.get_font(name) else { return Ok(0) };
        let Some(letters) = font.get::<Dict<'_>>("CharProcs") else { return Ok(0) };
        let own = font.get::<Dict<'_>>("Resources").map(Resources::new);
        let mut most = 0;
        for letter in letters.keys() {
            if let Some(stream) = letters.get::<Stream<'_>>(letter.as_ref()) {
                most = most.max(TWICE * self.of_stream(&stream, own.as_ref().unwrap_or(resources), levels)?);
            }
        }
        Ok(most)
    }
}

fn is_form(stream: &Stream<'_>) -> bool {
    stream.dict().get::<Name<'_>>("Subtype").is_some_and(|kind| kind.as_ref() == b"Form")
}
