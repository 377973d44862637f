//! How long each stage took, for `--timings`.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use tactograph::{Event, Stage};

/// A row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    /// By the clock, and the working time of all cores where it is known and nothing else ran.
    Took(Duration, Option<Duration>),
    Skipped(&'static str),
}

impl Row {
    /// Both, one after the other: what was skipped took no time.
    fn and(self, later: Self) -> Self {
        match (self, later) {
            (Self::Took(sum, all_worked), Self::Took(time, worked)) => {
                Self::Took(sum + time, all_worked.zip(worked).map(|(a, b)| a + b))
            }
            (_, later) => later,
        }
    }
}

/// A stopwatch for one picture. Clones are the same stopwatch.
#[derive(Debug, Clone)]
pub(super) struct Timings(Arc<Mutex<Clock>>);

#[derive(Debug)]
struct Clock {
    start: Moment,
    begun: Vec<(Stage, Moment)>,
    /// When the stages that run side by side began.
    together: Option<Moment>,
    /// Whether nothing but this picture is worked on.
    is_alone: bool,
    /// Of a stage with its place among the others.
    rows: Vec<(&'static str, Option<Stage>, Row)>,
    /// Stages that ran while others did.
    beside: Vec<Stage>,
    /// What the rows took, those side by side as a whole.
    told: Row,
}

/// A moment, by the clock and by the working time of all threads of the program.
#[derive(Debug, Clone, Copy)]
struct Moment {
    clock: Instant,
    worked: Option<Duration>,
}

impl Moment {
    fn now() -> Self {
        Self { clock: Instant::now(), worked: worked() }
    }

    /// What has passed since.
    fn took(self) -> Row {
        let now = Self::now();
        let worked = now.worked.zip(self.worked).map(|(now, then)| now.saturating_sub(then));
        Row::Took(now.clock - self.clock, worked)
    }
}

/// The working time of all threads of this program since its start; none where the system does not tell.
fn worked() -> Option<Duration> {
    #[cfg(unix)]
    return nix::time::clock_gettime(nix::time::ClockId::CLOCK_PROCESS_CPUTIME_ID).ok().map(Duration::from);
    #[cfg(not(unix))]
    None
}

/// The row of all stages that ran side by side.
const TOGETHER: &str = "together";
/// The row of what no stage tells of, as where a page is drawn a second time because its words have no room, told if it
/// took so long by the clock.
const OTHER: &str = "other";
const TOLD: Duration = Duration::from_millis(1);

/// What the stopwatch says when the picture is done, which is before its turn to be told of may come.
#[derive(Debug)]
pub(super) struct Stopped(Vec<(&'static str, Row, bool)>);

impl Timings {
    /// Starts the clock. Working time is told if the program works on nothing else meanwhile.
    pub(super) fn start(is_alone: bool) -> Self {
        let (start, begun, rows, beside) = (Moment::now(), Vec::new(), Vec::new(), Vec::new());
        let told = Row::Took(Duration::ZERO, Some(Duration::ZERO));
        let clock = Clock { start, begun, together: None, is_alone, rows, beside, told };
        Self(Arc::new(Mutex::new(clock)))
    }

    /// Takes the time of a step outside the pipeline.
    pub(super) fn step<T>(&self, name: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Moment::now();
        let done = work();
        self.with(|clock| {
            let took = start.took();
            clock.add(name, None, took);
            clock.told = clock.told.and(took);
        });
        done
    }

    /// Hears the pipeline, from whichever thread a stage runs on.
    pub(super) fn watch(&self, event: Event) {
        self.with(|clock| clock.watch(event));
    }

    /// Stops the clock.
    pub(super) fn stop(&self) -> Stopped {
        self.with(Clock::stop)
    }

    fn with<T>(&self, work: impl FnOnce(&mut Clock) -> T) -> T {
        work(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Clock {
    fn watch(&mut self, event: Event) {
        match event {
            Event::Begin(stage) => {
                if let Some((_, first)) = self.begun.first() {
                    self.together.get_or_insert(*first);
                    self.beside.extend(self.begun.iter().map(|(running, _)| *running).chain([stage]));
                }
                self.begun.push((stage, Moment::now()));
            }
            Event::End(stage) => {
                if let Some(index) = self.begun.iter().rposition(|(begun, _)| *begun == stage) {
                    let (_, start) = self.begun.remove(index);
                    let took = start.took();
                    self.add(stage.name(), Some(stage), took);
                    if self.begun.is_empty() {
                        self.alone_again(took);
                    }
                }
            }
            // where another part of it has run, that is what it took
            Event::Skip(stage, why) if self.rows.iter().all(|(name, ..)| *name != stage.name()) => {
                self.insert(stage.name(), Some(stage), Row::Skipped(why));
            }
            _ => {} // of other events nothing is timed
        }
    }

    /// Nothing runs any more: the last stage took this, and maybe it was one of several side by side.
    fn alone_again(&mut self, last: Row) {
        let mut took = last;
        if let Some(start) = self.together.take() {
            took = start.took();
            self.add(TOGETHER, self.beside.iter().max().copied(), took);
        }
        self.told = self.told.and(took);
    }

    /// A stage that runs in several parts is one row, also where some of them are skipped.
    fn add(&mut self, name: &'static str, stage: Option<Stage>, took: Row) {
        let Some((.., row)) = self.rows.iter_mut().find(|(row_name, ..)| *row_name == name) else {
            self.insert(name, stage, took);
            return;
        };
        *row = row.and(took);
    }

    /// Stages stand in their own order, whichever of two side by side ended first.
    fn insert(&mut self, name: &'static str, stage: Option<Stage>, row: Row) {
        let later = |(_, other, _): &(_, Option<Stage>, _)| stage.is_some() && *other > stage;
        let place = self.rows.iter().position(later).unwrap_or(self.rows.len());
        self.rows.insert(place, (name, stage, row));
    }

    fn stop(&mut self) -> Stopped {
        let total = self.start.took();
        self.rows.extend(self.left_of(total).map(|left| (OTHER, None, left)));
        self.rows.push(("total", None, total));
        let is_beside =
            |name, stage: Option<Stage>| name != TOGETHER && stage.is_some_and(|of| self.beside.contains(&of));
        let told = |row: Row, is_beside: bool| match row {
            Row::Took(time, _) if is_beside || !self.is_alone => Row::Took(time, None),
            row => row,
        };
        let rows = self.rows.iter().map(|&(name, stage, row)| {
            let is_beside = is_beside(name, stage);
            (name, told(row, is_beside), is_beside)
        });
        Stopped(rows.collect())
    }

    /// What the rows leave of the total, if it is long enough to be told.
    fn left_of(&self, total: Row) -> Option<Row> {
        let (Row::Took(all, all_worked), Row::Took(told, worked)) = (total, self.told) else { return None };
        let left = all.saturating_sub(told);
        let worked = all_worked.zip(worked).map(|(all, told)| all.saturating_sub(told));
        (left >= TOLD).then_some(Row::Took(left, worked))
    }
}

impl Stopped {
    /// A heading, one line a stage, the total: the time by the clock and the working time. Stages that ran side by side
    /// have no working time each, as threads help where they can; a line tells what they took together.
    pub(super) fn table(&self, file: &str) -> Vec<String> {
        let mut lines = vec![format!("timings of {file}:")];
        lines.extend(self.0.iter().map(|(name, row, is_beside)| match row {
            Row::Took(time, worked) => {
                let ms = |time: &Duration| time.as_secs_f64() * 1000.0;
                let worked = worked.map_or(String::new(), |worked| format!(" {:>9.1} ms CPU", ms(&worked)));
                let beside = if *is_beside { " side by side" } else { "" };
                format!("  {name:<9} {:>9.1} ms{worked}{beside}", ms(time))
            }
            Row::Skipped(why) => format!("  {name:<9} skipped: {why}"),
        }));
        lines
    }
}

#[cfg(test)]
mod tests;
