//! What the pipeline tells while it works, and two parts of it at once.

use std::sync::Mutex;

/// A step on the way, for progress and timings; in the order in which they run, or begin where several run side by
/// side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// Bytes to pixels.
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
    /// All of them, in the order in which they run.
    pub const ALL: [Self; 10] = [
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

/// What the pipeline tells while it works.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event {
    /// A stage begins; others may run already.
    Begin(Stage),
    /// A stage that began is done.
    End(Stage),
    /// A stage, or a part of it, is not needed for this page, and why: a text in English, which may change.
    Skip(Stage, &'static str),
}

/// Is told of every stage: where a program keeps its clock or its progress bar. Stages that run side by side tell from
/// the threads that they run on, one at a time.
pub type Watch<'a> = dyn FnMut(Event) + Send + 'a;

pub(super) fn run<T>(watch: &mut Watch<'_>, stage: Stage, work: impl FnOnce() -> T) -> T {
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
