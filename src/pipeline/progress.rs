//! What the pipeline tells while it works, and two parts of it at once.

use std::sync::Mutex;

/// A step on the way, for progress and timings; in the order in which they run, or begin where several run side by
/// side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// Bytes to pixels; of a page that is rendered, to its marks.
    Decode,
    /// Text in the pixels is found, and left out.
    Text,
    /// Pixels to contours.
    Edges,
    /// The regions between contours, by which those are weighted, and those that are outlined: of photographs
    /// [`Stage::Edges`] and it take turns, and each begins twice.
    Regions,
    /// Contours to lines in millimetres.
    Lines,
    /// The lines of the overview.
    Overview,
    /// Telling hues apart, the larger part of [`Stage::Classes`]; only ever told of when it is skipped.
    Hues,
    /// Pixels to colour classes and their regions.
    Classes,
    /// Regions to glyphs.
    Textures,
    /// Everything to a page.
    Page,
}

impl Stage {
    /// Its place in the order: stages of one number run side by side or take turns, and end before the next begins.
    fn turn(self) -> u8 {
        match self {
            Self::Decode => 0,
            Self::Text => 1,
            Self::Edges | Self::Regions => 2,
            Self::Lines | Self::Overview | Self::Hues | Self::Classes => 3,
            Self::Textures => 4,
            Self::Page => 5,
        }
    }

    /// All of them, in the order in which they run.
    pub const ALL: &'static [Self] = &[
        Self::Decode,
        Self::Text,
        Self::Edges,
        Self::Regions,
        Self::Lines,
        Self::Overview,
        Self::Hues,
        Self::Classes,
        Self::Textures,
        Self::Page,
    ];

    /// Its name in plain words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Decode => "decode",
            Self::Text => "text",
            Self::Edges => "edges",
            Self::Regions => "regions",
            Self::Lines => "lines",
            Self::Overview => "overview",
            Self::Hues => "hues",
            Self::Classes => "classes",
            Self::Textures => "textures",
            Self::Page => "page",
        }
    }
}

/// How long stages take beside one another, in the order of [`Stage::ALL`]: in these proportions a photograph of 12
/// megapixels as JPEG did on 23 November (two cores). Other pictures share their time out otherwise: where texts are
/// looked for in a drawing, or its lines are crowded, those stages take most of it.
const COST: [f32; Stage::ALL.len()] = [38.0, 6.0, 14.0, 18.0, 16.0, 11.0, 0.0, 5.0, 1.0, 1.0];

/// Keeps count of how much of the work is done.
#[derive(Debug, Clone)]
pub struct Progress {
    /// The last stage that there will be.
    last: Stage,
    /// How much of each stage is done, 0..=1, in the order of [`Stage::ALL`]; it only grows.
    done: [f32; Stage::ALL.len()],
}

impl Progress {
    /// Of work that ends with this stage.
    pub fn until(last: Stage) -> Self {
        Self { last, done: [0.0; Stage::ALL.len()] }
    }

    /// The share of the work that is done after an event, 0..=1.
    pub fn after(&mut self, event: Event) -> f32 {
        match event {
            Event::Begin(stage) => self.end_before(stage),
            Event::End(stage) if stage.turn() == Stage::Edges.turn() => {
                // they take turns, and nobody knows how often: half of what was left
                self.set(stage, 0.5 + 0.5 * self.done[stage as usize]);
            }
            Event::End(stage) | Event::Skip(stage, _) => self.set(stage, 1.0),
            Event::Done(_) => {}
        }
        let stages = || Stage::ALL.iter().filter(|stage| **stage <= self.last).map(|stage| *stage as usize);
        let whole: f32 = stages().map(|stage| COST[stage]).sum();
        stages().map(|stage| self.done[stage] * COST[stage]).sum::<f32>() / whole
    }

    /// Once a stage begins, what never runs beside or after it is done, also where it was not told of.
    fn end_before(&mut self, begun: Stage) {
        for stage in Stage::ALL.iter().filter(|stage| stage.turn() < begun.turn()) {
            self.set(*stage, 1.0);
        }
    }

    fn set(&mut self, stage: Stage, done: f32) {
        let before = &mut self.done[stage as usize];
        *before = before.max(done);
    }
}

/// What the pipeline tells while it works.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// A stage begins; others may run already.
    Begin(Stage),
    /// A stage that began is done.
    End(Stage),
    /// A stage, or a part of it, is not needed for this page, and why: a text in English, which may change.
    Skip(Stage, &'static str),
    /// How much of the work is done, 0 to 1: after every stage that ended or was skipped, and 1 when all of it is. It
    /// never goes back. Stages count by the time that they take of a photograph of 12 megapixels; of other pictures the
    /// share is that of stages, and not of time.
    Done(f32),
}

/// Why most stages skip a picture with nothing on it.
pub(super) const ONE_COLOUR: &str = "the picture is of one colour";

/// Is told of every stage: where a program keeps its clock or its progress bar. Stages that run side by side tell from
/// the threads that they run on, one at a time.
pub type Watch<'a> = dyn FnMut(Event) + Send + 'a;

/// Does a stage and tells `watch` of it.
pub fn run_stage<T>(watch: &mut Watch<'_>, stage: Stage, work: impl FnOnce() -> T) -> T {
    watch(Event::Begin(stage));
    let result = work();
    watch(Event::End(stage));
    result
}

/// Runs two parts that do not need one another: side by side if `is_worth_it`, else the first and then the second.
/// Each may tell `watch` of its stages.
pub(super) fn in_parallel<A: Send, B: Send>(
    is_worth_it: bool,
    watch: &mut Watch<'_>,
    first: impl FnOnce(&mut Watch<'_>) -> A + Send,
    second: impl FnOnce(&mut Watch<'_>) -> B + Send,
) -> (A, B) {
    if !is_worth_it || rayon::current_num_threads() < 2 {
        return (first(watch), second(watch));
    }
    let ear = Mutex::new(watch);
    // A watch that panicked is asked no more; its panic goes on when both are done.
    let tell = |event: Event| {
        if let Ok(mut watch) = ear.lock() {
            watch(event);
        }
    };
    rayon::join(|| first(&mut |event| tell(event)), || second(&mut |event| tell(event)))
}

#[cfg(test)]
mod tests;
