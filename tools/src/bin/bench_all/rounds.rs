//! Several programs in turn, round after round: whatever else the machine does then falls on all of them alike.

use tactograph_tools::median::median;

use crate::measured::{Job, Run, run};

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

    /// Median of something made of this program's run and another's of the same round, over the rounds in which both ran.
    /// The only run of what is slow, before the first round, stands beside all of the other's.
    pub(crate) fn beside(&self, other: &Self, of: impl Fn(&Run, &Run) -> Option<f64>) -> Option<f64> {
        let (ours, theirs) = (self.runs.as_ref().ok()?, other.runs.as_ref().ok()?);
        let is_only = |runs: &[Run]| matches!(runs, [run] if run.round == 0);
        let is_any = is_only(ours) || is_only(theirs);
        let pairs = ours.iter().flat_map(|our| theirs.iter().map(move |their| (our, their)));
        let pairs = pairs.filter(|(our, their)| is_any || our.round == their.round);
        median(pairs.filter_map(|(our, their)| of(our, their)))
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
                        runs.push(Run { round, ..run });
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

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(runs: &[(usize, f64)]) -> Outcome {
        let run = |&(round, wall): &(usize, f64)| Run { round, wall, cpu: wall, peak: 1.0, said: String::new() };
        Outcome { name: String::new(), runs: Ok(runs.iter().map(run).collect()) }
    }

    #[test]
    fn runs_of_one_round_stand_beside_one_another() {
        let ratio = |ours: &[(usize, f64)], theirs: &[(usize, f64)]| {
            outcome(ours).beside(&outcome(theirs), |our, their| Some(our.wall / their.wall))
        };
        let ours = [(1, 20.0), (2, 60.0), (3, 50.0)];
        assert_eq!(ratio(&ours, &[(2, 30.0), (3, 50.0)]), Some(1.5));
        assert_eq!(ratio(&ours, &[(1, 10.0)]), Some(2.0));
        assert_eq!(ratio(&ours, &[(0, 100.0)]), Some(0.5), "the median of all beside its only run");
        assert_eq!(ratio(&[(0, 100.0)], &ours), Some(2.0));
        assert_eq!(ratio(&ours, &[]), None);
    }
}
