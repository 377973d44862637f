//! How long each stage took, for `--timings`.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use tactograph::{Event, Stage};

/// A row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    Took(Duration),
    Skipped(&'static str),
}

/// A stopwatch for one picture. Clones are the same stopwatch.
#[derive(Debug, Clone)]
pub(super) struct Timings(Arc<Mutex<Clock>>);

#[derive(Debug)]
struct Clock {
    start: Instant,
    begun: Vec<(Stage, Instant)>,
    /// Of a stage with its place among the others.
    rows: Vec<(&'static str, Option<Stage>, Row)>,
    /// Stages that ran while others did.
    beside: Vec<Stage>,
}

/// What the stopwatch says when the picture is done, which is before its turn to be told of may come.
#[derive(Debug)]
pub(super) struct Stopped(Vec<(&'static str, Row, bool)>);

impl Timings {
    /// Starts the clock.
    pub(super) fn start() -> Self {
        let clock = Clock { start: Instant::now(), begun: Vec::new(), rows: Vec::new(), beside: Vec::new() };
        Self(Arc::new(Mutex::new(clock)))
    }

    /// Takes the time of a step outside the pipeline.
    pub(super) fn step<T>(&self, name: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let done = work();
        self.with(|clock| clock.add(name, None, start.elapsed()));
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
                if !self.begun.is_empty() {
                    self.beside.extend(self.begun.iter().map(|(running, _)| *running).chain([stage]));
                }
                self.begun.push((stage, Instant::now()));
            }
            Event::End(stage) => {
                if let Some(index) = self.begun.iter().rposition(|(begun, _)| *begun == stage) {
                    let (_, start) = self.begun.remove(index);
                    self.add(stage.name(), Some(stage), start.elapsed());
                }
            }
            Event::Skip(stage, why) => self.insert(stage.name(), Some(stage), Row::Skipped(why)),
            _ => {} // of other events nothing is timed
        }
    }

    /// A stage that runs in several parts is one row.
    fn add(&mut self, name: &'static str, stage: Option<Stage>, took: Duration) {
        for (row_name, _, row) in &mut self.rows {
            if let (true, Row::Took(sum)) = (*row_name == name, row) {
                *sum += took;
                return;
            }
        }
        self.insert(name, stage, Row::Took(took));
    }

    /// Stages stand in their own order, whichever of two side by side ended first.
    fn insert(&mut self, name: &'static str, stage: Option<Stage>, row: Row) {
        let later = |(_, other, _): &(_, Option<Stage>, _)| stage.is_some() && *other > stage;
        let place = self.rows.iter().position(later).unwrap_or(self.rows.len());
        self.rows.insert(place, (name, stage, row));
    }

    fn stop(&mut self) -> Stopped {
        self.rows.push(("total", None, Row::Took(self.start.elapsed())));
        let is_beside = |stage| self.beside.contains(&stage);
        let rows = self.rows.iter().map(|&(name, stage, row)| (name, row, stage.is_some_and(is_beside)));
        Stopped(rows.collect())
    }
}

impl Stopped {
    /// A heading, one line a stage, the total. Of stages that ran side by side, the sum is more than they took
    /// together.
    pub(super) fn table(&self, file: &str) -> Vec<String> {
        let mut lines = vec![format!("timings of {file}:")];
        lines.extend(self.0.iter().map(|(name, row, is_beside)| match row {
            Row::Took(time) => {
                let beside = if *is_beside { " side by side" } else { "" };
                format!("  {name:<9} {:>9.1} ms{beside}", time.as_secs_f64() * 1000.0)
            }
            Row::Skipped(why) => format!("  {name:<9} skipped: {why}"),
        }));
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_lists_stages_in_order_with_skips_and_a_total() {
        let timings = Timings::start();
        timings.step("read", || ());
        timings.watch(Event::Begin(Stage::Lines));
        timings.watch(Event::Begin(Stage::Overview)); // beside another
        timings.watch(Event::End(Stage::Overview));
        timings.watch(Event::End(Stage::Lines));
        timings.watch(Event::Skip(Stage::Textures, "figure.textures = false"));
        timings.watch(Event::Begin(Stage::Edges));
        timings.watch(Event::End(Stage::Edges));
        timings.watch(Event::Begin(Stage::Edges)); // a second part: the same row
        timings.watch(Event::End(Stage::Edges));
        timings.step("write", || ());
        let stopped = timings.stop();
        let table = stopped.table("a.png");
        let names = table.iter().map(|line| line.split_whitespace().next().unwrap_or("")).collect::<Vec<_>>();
        assert_eq!(names, ["timings", "read", "edges", "lines", "overview", "textures", "write", "total"]);
        assert_eq!(table[5], "  textures  skipped: figure.textures = false");
        for line in [&table[1], &table[2], &table[6], &table[7]] {
            assert!(line.ends_with(" ms") && line.len() == table[1].len(), "not aligned: {line}");
        }
        for line in [&table[3], &table[4]] {
            assert_eq!(line.strip_suffix(" side by side").map(str::len), Some(table[1].len()), "{line}");
        }
        std::thread::sleep(Duration::from_millis(2)); // waiting for its turn is not work on the picture
        assert_eq!(stopped.table("a.png"), table);
    }
}
