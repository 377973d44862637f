//! One sentence on a page, weighted by area: how much of the figure is faulty, and how much of its textures a fingertip
//! reads.

use std::fmt;

use super::finding::Finding;
use super::rules::LINES_AMONG_ROWS;
use crate::page::{LeftOut, Page};
use crate::touch::{JUDGED_FROM, Report};
use crate::units::MmPoint;
use crate::wording::Wording;

/// Side of the squares in which faulty area is counted, mm: a third of a fingertip.
const SQUARE: f32 = 5.0;

/// Where less than this share of the textured area can be judged, what is read right of it says nothing of the rest.
const LEAST_JUDGED: f32 = 0.25;

/// From this share of the picture's contours on it is said that they are not on the page, as of drawings that are too
/// dense for their figure.
const MUCH: f32 = 0.2;

/// What is said of a page as a whole.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Verdict {
    /// How many errors there are.
    pub errors: usize,
    /// How many warnings there are.
    pub warnings: usize,
    /// Share of the figure in which there is an error, 0..=1.
    pub faulty: f32,
    /// Whether the lines can hardly be followed, as rows of textures lie close beside most of them.
    pub lines_among_rows: bool,
    /// Share of the picture's contours that are not on the page, 0..=1, if it is a fifth or more.
    pub left_out: Option<f32>,
    /// What a fingertip feels of the textures, if there are any and they were felt.
    pub textures: Option<Textures>,
}

/// What a fingertip says of a page.
#[derive(Debug, Clone, Copy)]
pub enum Fingertip<'a> {
    /// Nobody asked it.
    NotAsked,
    /// It cannot be asked, as the page is too large for its model.
    TooLarge,
    /// What it feels.
    Felt(&'a Report),
}

/// What a fingertip feels of a page's textures, in shares 0..=1.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Textures {
    /// Of the figure, how much has a texture.
    pub of_figure: f32,
    /// Of the textured area, how much was judged; the rest lies too near to lines and borders.
    pub judged: f32,
    /// Of what was judged, how much is read right.
    pub right: f32,
    /// Whether a fingertip could be asked at all: of pages that are too large for its model nothing is judged.
    pub felt: bool,
}

impl Verdict {
    /// The verdict on a page with these findings.
    pub(super) fn of(page: &Page, findings: &[Finding], felt: Fingertip<'_>) -> Self {
        let errors = findings.iter().filter(|finding| finding.is_error()).count();
        let of_figure = page.figure.textured_share();
        let textures = match felt {
            Fingertip::NotAsked => None,
            Fingertip::TooLarge if of_figure > 0.0 => {
                Some(Textures { of_figure, judged: 0.0, right: 0.0, felt: false })
            }
            Fingertip::TooLarge => None,
            Fingertip::Felt(report) => {
                Some(report.total()).filter(|total| total.textured() > 0.0).map(|total| Textures {
                    of_figure,
                    judged: total.judged() / total.textured(),
                    right: total.right_of_judged(),
                    felt: true,
                })
            }
        };
        Self {
            errors,
            warnings: findings.len() - errors,
            faulty: faulty(page, findings),
            lines_among_rows: findings.iter().any(|finding| finding.rule == LINES_AMONG_ROWS),
            // not from what is found: of a photograph little is no finding, and said all the same
            left_out: Some(LeftOut::of(page).share()).filter(|share| *share >= MUCH),
            textures,
        }
    }
}

/// Share of the squares of the figure that an error's box reaches into.
fn faulty(page: &Page, findings: &[Finding]) -> f32 {
    let place = page.figure.place;
    let count = |mm: f32| (mm / SQUARE).ceil().max(1.0) as usize;
    let (columns, rows) = (count(place.width()), count(place.height()));
    let mut squares = vec![false; columns * rows];
    for extent in findings.iter().filter(|finding| finding.is_error()).filter_map(|finding| finding.extent) {
        let index = |at: MmPoint| [(at.x - place.min.x) / SQUARE, (at.y - place.min.y) / SQUARE];
        let (low, high) = (index(extent.min), index(extent.max));
        if high[0] < 0.0 || high[1] < 0.0 {
            continue;
        }
        for row in (low[1].max(0.0) as usize)..=(high[1] as usize).min(rows - 1) {
            for column in (low[0].max(0.0) as usize)..=(high[0] as usize).min(columns - 1) {
                squares[row * columns + column] = true;
            }
        }
    }
    squares.iter().filter(|square| **square).count() as f32 / squares.len() as f32
}

impl Verdict {
    /// The sentence in the words of a language.
    pub(crate) fn told(&self, wording: &Wording) -> String {
        let Self { errors, warnings, faulty, lines_among_rows, left_out, textures } = *self;
        let percent = |share: f32| wording.percent(share);
        let lines = if lines_among_rows { wording.say("verdict-lines", &[]) } else { "none".to_owned() };
        let left_out = left_out.map_or_else(|| "none".to_owned(), percent);
        let textures = textures.map_or_else(|| "none".to_owned(), |textures| textures.told(wording));
        let faulty = if faulty > 0.0 { percent(faulty) } else { "none".to_owned() };
        let values = [
            ("errors", errors.into()),
            ("faulty", faulty.into()),
            ("warnings", warnings.into()),
            ("lines", lines.into()),
            ("missing", left_out.into()),
            ("textures", textures.into()),
        ];
        wording.say("verdict", &values)
    }
}

/// Less than this share is not told: it would be under 1 percent.
const LEAST_TOLD: f32 = 0.005;

impl Textures {
    /// What of them is read right and wrong and what could not be judged, in shares of all of them: what is told of a
    /// part sounds as if it were told of all.
    fn told(&self, wording: &Wording) -> String {
        let Self { judged, right, felt, .. } = *self;
        let from = ("from", JUDGED_FROM.into());
        if judged <= 0.0 {
            return match felt {
                true => wording.say("verdict-textures-near", &[from]),
                false => wording.say("verdict-textures-large", &[]),
            };
        }
        let percent = |share: f32| wording.percent(share).into();
        if judged < LEAST_JUDGED {
            return wording.say("verdict-textures-few", &[("judged", percent(judged)), from]);
        }
        let wrong = judged * (1.0 - right);
        let or_none = |is_told: bool, share: f32| if is_told { percent(share) } else { "none".into() };
        let values = [
            ("right", percent(judged * right)),
            ("wrong", or_none(wrong >= LEAST_TOLD, wrong)),
            ("rest", or_none(judged <= 1.0 - LEAST_TOLD, 1.0 - judged)),
        ];
        wording.say("verdict-textures", &values)
    }
}

impl fmt::Display for Verdict {
    /// The sentence in English.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(Wording::english()))
    }
}

#[cfg(test)]
mod tests;
