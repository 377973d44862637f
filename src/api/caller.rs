//! The caller while work is done for it: whom progress is told, and who is asked whether the result is still wanted.

use std::sync::Arc;

use crate::Error;
use crate::pipeline::{Event, Progress, Stage, Watch};

/// What options hold of their caller: shared by clones, and nothing unless it is set.
#[derive(Clone, Default)]
pub(super) struct Caller {
    told: Option<Arc<dyn Fn(Event) + Send + Sync>>,
    asked: Option<Arc<dyn Fn() -> bool + Send + Sync>>,
}

impl Caller {
    /// Tells this function of every stage, and of the share of the work that is done.
    pub(super) fn on_progress(&mut self, told: impl Fn(Event) + Send + Sync + 'static) {
        self.told = Some(Arc::new(told));
    }

    /// Asks this function whether the result is no longer wanted.
    pub(super) fn on_question(&mut self, asked: impl Fn() -> bool + Send + Sync + 'static) {
        self.asked = Some(Arc::new(asked));
    }

    /// Whether the result is no longer wanted.
    pub(super) fn has_cancelled(&self) -> bool {
        self.asked.as_ref().is_some_and(|asked| asked())
    }

    /// Between two parts of the work: whether to go on.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the result is no longer wanted.
    pub(super) fn go_on(&self) -> Result<(), Error> {
        if self.has_cancelled() { Err(Error::Cancelled) } else { Ok(()) }
    }

    /// Does work that ends with the stage `last`, and tells of its stages and of how much of it is done.
    ///
    /// # Errors
    /// That of the work.
    pub(super) fn watched<T>(
        &self,
        last: Stage,
        work: impl FnOnce(&mut Watch<'_>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let mut progress = Progress::until(last);
        let done = work(&mut |event| {
            self.tell(event);
            let share = progress.after(event);
            if matches!(event, Event::End(_) | Event::Skip(..)) {
                self.tell(Event::Done(share));
            }
        })?;
        self.tell(Event::Done(1.0));
        Ok(done)
    }

    fn tell(&self, event: Event) {
        if let Some(told) = &self.told {
            told(event);
        }
    }
}
