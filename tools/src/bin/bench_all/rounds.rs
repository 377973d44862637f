//! Several programs in turn, round after round: whatever else the machine does then falls on all of them alike.

use crate::measured::{Job, Run, run};
use crate::numbers::median;

/// How often and where.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Setting {
    pub(crate) runs: usize,
    /// Who has used up this much working time, ms, does not run again.
    pub(crate) patience: f64,
    pub(crate) one_core: bool,
}

/// All runs of one program.
#[derive(Debug, Clone)]
pub(crate) struct Outcome {
    pub(crate) name: String,
    /// One for each round, or why there is none.
    pub(crate) runs: Result<Vec<Run>, String>,
}

impl Outcome {
    /// Median of something over the runs.
    pub(crate) fn median(&self, of: impl Fn(&Run) -> Option<f64>) -> Option<f64> {
        median(self.runs.as_ref().ok()?.iter().filter_map(of))
    }

    pub(crate) fn wall(&self) -> Option<f64> {
        self.median(|run| Some(run.wall))
    }

    pub(crate) fn cpu(&self) -> Option<f64> {
        self.median(|run| Some(run.cpu))
    }

    pub(crate) fn peak(&self) -> Option<f64> {
        self.median(|run| Some(run.peak))
    }

    /// Median over the rounds of something made of this program's run and another's of the same round.
    pub(crate) fn beside(&self, other: &Self, of: impl Fn(&Run, &Run) -> Option<f64>) -> Option<f64> {
        let (ours, theirs) = (self.runs.as_ref().ok()?, other.runs.as_ref().ok()?);
        median(ours.iter().zip(theirs).filter_map(|(our, their)| of(our, their)))
    }
}

/// Runs a program once: for what takes a minute.
pub(crate) fn once(job: &Job, one_core: bool) -> Outcome {
    let runs = run(job, one_core).map(|run| vec![run]).inspect_err(|fault| eprintln!("{}: {fault}", job.name));
    Outcome { name: job.name.clone(), runs }
}

/// Runs all, first once to warm up (what is slow is not warmed up), then in turn, every second round in reverse.
pub(crate) fn rounds(jobs: &[Job], setting: Setting) -> Vec<Outcome> {
    let mut outcomes: Vec<Outcome> =
        jobs.iter().map(|job| Outcome { name: job.name.clone(), runs: Ok(Vec::new()) }).collect();
    let mut spent = vec![0.0; jobs.len()];
    for round in 0..=setting.runs {
        let mut order: Vec<usize> = (0..jobs.len()).collect();
        if round % 2 == 1 {
            order.reverse();
        }
        for i in order {
            let Ok(runs) = &mut outcomes[i].runs else { continue };
            if spent[i] >= setting.patience {
                continue;
            }
            match run(&jobs[i], setting.one_core) {
                Ok(run) => {
                    spent[i] += run.cpu;
                    // A first run that used up the patience is all there will be.
                    if round > 0 || spent[i] >= setting.patience {
                        runs.push(run);
                    }
                }
                Err(fault) => {
                    eprintln!("{}: {fault}", jobs[i].name);
                    outcomes[i].runs = Err(fault);
                }
            }
        }
    }
    outcomes
}
