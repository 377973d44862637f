//! What was promised beside what is reached, and the other programs.

use std::path::Path;

use crate::inputs::{FULL_COLOUR, Inputs};
use crate::measured::Job;
use crate::ours::{Ours, after_decoding, stage};
use crate::peers::Peers;
use crate::rounds::{Outcome, Setting, rounds};
use crate::table::{Table, number};

/// What all that measure need.
pub(crate) struct Bench<'a> {
    pub(crate) args: &'a crate::args::Args,
    pub(crate) ours: &'a Ours,
    pub(crate) peers: &'a Peers,
    pub(crate) inputs: &'a Inputs,
    /// Where builds and pictures lie.
    pub(crate) target: &'a Path,
}

impl Bench<'_> {
    pub(crate) fn setting(&self, one_core: bool) -> Setting {
        let patience = if self.args.quick { 2e3 } else { 15e3 };
        Setting { runs: self.args.runs, patience, one_core }
    }
}

/// A measured row of the table of targets.
pub(crate) struct Row {
    pub(crate) work: String,
    /// Ours by the clock, ms; its working time, ms; its memory, MB.
    pub(crate) ours: [Option<f64>; 3],
    pub(crate) beside: Beside,
    pub(crate) wanted: String,
    pub(crate) met: Option<bool>,
    /// Whether the short table has it also where nothing is wanted.
    pub(crate) is_short: bool,
}

/// What is held against the goal.
pub(crate) enum Beside {
    /// A figure of ours, in the unit that the work names.
    Nobody(Option<f64>),
    /// Ours beside another program.
    Peer {
        name: String,
        /// Its time by the clock, ms; its working time, ms; its memory, MB.
        figures: [Option<f64>; 3],
        /// Ours to theirs by the clock, and of working times: medians over the rounds.
        ratios: [Option<f64>; 2],
    },
}

impl Beside {
    /// What the program is called.
    fn name(&self) -> String {
        match self {
            Self::Nobody(_) => String::new(),
            Self::Peer { name, .. } => name.clone(),
        }
    }
}

/// One picture, ours first, then the peers with the ratio that is wanted.
struct Contest {
    work: &'static str,
    ours: Job,
    peers: Vec<(Option<Job>, Option<f64>)>,
    /// Most memory, MB.
    peak: Option<f64>,
    /// Most time after decoding, ms.
    after_decoding: Option<f64>,
    /// Whether the short table has everybody.
    is_short: bool,
    /// Whether it takes too long for somebody in a hurry.
    is_slow: bool,
}

/// At least ten times faster than who writes vectors.
const TENTH: Option<f64> = Some(0.1);
/// Of who works longer than this, ms, it is not told how long without its start: the start of Python is nothing beside it.
const LONG: f64 = 10e3;

fn contests(bench: &Bench<'_>, one_core: bool) -> Vec<Contest> {
    let Bench { ours, peers, inputs, .. } = bench;
    let contest = |work, name: &str, peak, list: Vec<(Option<Job>, Option<f64>)>| Contest {
        work,
        ours: ours.job(work, &inputs.file(name), "page.svg", &[]),
        peers: list,
        peak,
        after_decoding: None,
        is_short: false,
        is_slow: false,
    };
    let slow_contest = |work, name: &str, peak, list| Contest { is_slow: true, ..contest(work, name, peak, list) };
    let file = |name: &str| inputs.file(name);
    let (plain, slow) = (file("photo-12.jpg"), file("photo-12-progressive.jpg"));
    let full = file(FULL_COLOUR);
    let (large, large_slow) = (file("photo-50.jpg"), file("photo-50-progressive.jpg"));
    let decode = |name: &str| Some(Job::new("decoding alone, png crate", crate::floor::command(&inputs.file(name))));
    let mut contests = vec![
        Contest {
            after_decoding: Some(if one_core { 28.0 } else { 18.0 }),
            is_short: true,
            ..contest("12 MP JPEG", "photo-12.jpg", Some(40.0), everybody(bench, &plain, one_core))
        },
        contest(
            "12 MP progressive JPEG",
            "photo-12-progressive.jpg",
            None,
            vec![(peers.djpeg(&slow, "1/4"), Some(1.45)), (peers.vips(&slow, ours), None)],
        ),
        contest(
            "12 MP progressive JPEG, 4:4:4",
            FULL_COLOUR,
            None,
            vec![(peers.djpeg(&full, "1/4"), None), (peers.vips(&full, ours), None)],
        ),
        slow_contest(
            "50 MP JPEG",
            "photo-50.jpg",
            Some(60.0),
            vec![(peers.djpeg(&large, "1/8"), Some(1.5)), (peers.vips(&large, ours), None)],
        ),
        slow_contest(
            "50 MP progressive JPEG",
            "photo-50-progressive.jpg",
            None,
            vec![(peers.djpeg(&large_slow, "1/8"), None), (peers.vips(&large_slow, ours), None)],
        ),
        contest(
            "12 MP PNG",
            "photo-12.png",
            None,
            vec![(decode("photo-12.png"), Some(1.2)), (peers.vips(&file("photo-12.png"), ours), None)],
        ),
        contest("12 MP PNG, 16 bit", "photo-12-16.png", None, vec![(decode("photo-12-16.png"), None)]),
        contest("12 MP WebP", "photo-12.webp", None, vec![(peers.vips(&file("photo-12.webp"), ours), None)]),
    ];
    contests.retain(|contest| !(bench.args.quick && contest.is_slow));
    contests
}

/// All others that do a part of the work on a JPEG.
fn everybody(bench: &Bench<'_>, picture: &Path, one_core: bool) -> Vec<(Option<Job>, Option<f64>)> {
    let Bench { ours, peers, .. } = bench;
    vec![
        (peers.djpeg(picture, "1/4"), Some(2.0)),
        (peers.vips(picture, ours), None),
        (peers.magick(picture, ours), None),
        (peers.opencv(picture, ours), None),
        (peers.potrace(picture, ours), TENTH),
        // It takes a minute, and one core in any case.
        (peers.vtracer(picture, ours).filter(|_| !one_core && !bench.args.quick), TENTH),
    ]
}

/// Measures all of it, on one core or as many as there are.
pub(crate) fn measure(bench: &Bench<'_>, one_core: bool) -> Vec<Row> {
    let mut rows = Vec::new();
    for contest in contests(bench, one_core) {
        if !begin(bench, contest.work, one_core) {
            continue;
        }
        let (peers, wanted): (Vec<Job>, Vec<Option<f64>>) =
            contest.peers.into_iter().filter_map(|(job, wanted)| Some((job?, wanted))).unzip();
        let jobs: Vec<Job> = std::iter::once(contest.ours).chain(peers).collect();
        let outcomes = rounds(&jobs, bench.setting(one_core));
        let Some((ours, theirs)) = outcomes.split_first() else { continue };
        if let Some(most) = contest.peak {
            rows.push(limit(&format!("{}: memory, MB", contest.work), ours, ours.peak(), most));
        }
        if let Some(most) = contest.after_decoding {
            let after = ours.median(after_decoding);
            rows.push(limit(&format!("{}: all after decoding, ms", contest.work), ours, after, most));
        }
        let beside = theirs.iter().zip(wanted).map(|(their, wanted)| versus(contest.work, ours, their, wanted));
        rows.extend(beside.map(|row| Row { is_short: contest.is_short || row.is_short, ..row }));
    }
    rows.extend(small(bench, one_core));
    rows
}

/// Is this work asked for? Then its name is told.
fn begin(bench: &Bench<'_>, work: &str, one_core: bool) -> bool {
    let name = format!("{}: {work}", if one_core { "one core" } else { "beside others" });
    let wanted = bench.args.wants(&name);
    if wanted {
        eprintln!("{name}");
    }
    wanted
}

/// The small picture, as SVG and as PDF.
fn small(bench: &Bench<'_>, one_core: bool) -> Vec<Row> {
    let work = "600 x 400 PNG";
    if !begin(bench, work, one_core) {
        return Vec::new();
    }
    let sample = "samples/coffee.png".as_ref();
    let empty = "samples/empty.png".as_ref();
    let jobs = [("svg", sample, "page.svg"), ("pdf", sample, "page.pdf"), ("white", empty, "white.svg")];
    let jobs = jobs.map(|(name, picture, page)| bench.ours.job(name, picture, page, &[]));
    let outcomes = rounds(&jobs, bench.setting(one_core));
    let [svg, pdf, white] = &outcomes[..] else { return Vec::new() };
    let more = pdf.beside(svg, |pdf, svg| Some(pdf.wall - svg.wall));
    vec![
        limit(&format!("{work}: whole process, ms"), svg, svg.wall(), 30.0),
        limit(&format!("{work}: more for PDF, ms"), pdf, more, 15.0),
        limit("white page: whole process, ms", white, white.wall(), 3.0),
    ]
}

fn limit(work: &str, ours: &Outcome, value: Option<f64>, most: f64) -> Row {
    Row {
        work: work.into(),
        ours: [ours.wall(), ours.cpu(), ours.peak()],
        beside: Beside::Nobody(value),
        wanted: format!("at most {most}"),
        met: value.map(|value| value <= most),
        is_short: true,
    }
}

fn versus(work: &str, ours: &Outcome, theirs: &Outcome, wanted: Option<f64>) -> Row {
    let mut name = theirs.name.clone();
    if let Err(fault) = &theirs.runs {
        name += &format!(" (failed: {fault})");
    } else if let Some(alone) = theirs.median(|run| stage(run, "alone")).filter(|&alone| alone < LONG) {
        name += &format!(" ({} ms without its start)", number(Some(alone)));
    }
    let ratio = ours.beside(theirs, |our, their| Some(our.wall / their.wall));
    let cpu = ours.beside(theirs, |our, their| Some(our.cpu / their.cpu));
    Row {
        work: work.into(),
        ours: [ours.wall(), ours.cpu(), ours.peak()],
        beside: Beside::Peer { name, figures: [theirs.wall(), theirs.cpu(), theirs.peak()], ratios: [ratio, cpu] },
        wanted: wanted.map_or(String::new(), |most| format!("at most {most}")),
        met: wanted.and_then(|most| Some(ratio? <= most)),
        is_short: wanted.is_some(),
    }
}

fn answer(met: Option<bool>) -> String {
    met.map_or("", |met| if met { "yes" } else { "no" }).into()
}

/// Every figure.
pub(crate) fn long_table(title: &'static str, about: &str, rows: &[Row]) -> Table {
    let head =
        ["work", "ms", "CPU ms", "MB", "beside", "ms", "CPU ms", "MB", "ratio or value", "of CPU", "wanted", "met"];
    let mut table = Table::new(title, about, &head);
    table.rows.extend(rows.iter().map(|row| {
        let (theirs, ratios) = match row.beside {
            Beside::Nobody(value) => ([None; 3], [value, None]),
            Beside::Peer { figures, ratios, .. } => (figures, ratios),
        };
        let mut cells = vec![row.work.clone()];
        cells.extend(row.ours.map(number));
        cells.push(row.beside.name());
        cells.extend(theirs.into_iter().chain(ratios).map(number));
        cells.extend([row.wanted.clone(), answer(row.met)]);
        cells
    }));
    table
}

/// What the head of docs/speed.md shows: what was promised, also where it could not be measured, and everybody on one
/// picture.
pub(crate) fn short_table(rows: &[Row]) -> Table {
    let mut table = Table::new("", "", &["work", "tactograph", "beside", "", "ratio", "wanted", "met"]);
    table.rows.extend(rows.iter().filter(|row| row.is_short).map(|row| {
        let ms = |time| format!("{} ms", number(time));
        let [ours, theirs, ratio] = match row.beside {
            Beside::Nobody(value) => [number(value), String::new(), String::new()],
            Beside::Peer { figures, ratios, .. } => [ms(row.ours[0]), ms(figures[0]), number(ratios[0])],
        };
        vec![row.work.clone(), ours, row.beside.name(), theirs, ratio, row.wanted.clone(), answer(row.met)]
    }));
    table
}
