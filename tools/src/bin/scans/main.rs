//! Is paper blank on the pages of scans, and have areas the class of their colour? Draws worksheets, charts and maps on
//! paper, scans or photographs them, and sorts the colours of each, with its ground taken for paper and as it is.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin scans        the table (147 scans, a minute)
//!   --scans N          so many scans for each kind and variant (default 1)
//!   --from SEED        the first of their seeds (default 0): other scans, of the same kinds
//!   --list N           also the N worst scans
//!   --keep DIR         writes each scan, and what is true of it, into a folder
//! ```
//!
//! **Scenes** (`scenes.rs`): seven kinds of 900 x 600 units. **Variants**: one thing at a time differs from a plain photograph
//! (light that falls to 0.7 across, white paper, noise of 3 of 255, JPEG of quality 80, 1600 px); the last has all of them at
//! random. **Truth**: what is drawn, but for what is nearer to a border or stroke than 1.5 mm on A4.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod scenes;

use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;

use scenes::{Kind, Scene, Truth};
use tactograph::internals::pipeline::{Fit, Request, colours};
use tactograph::internals::profile::{Plan, Profile};
use tactograph_tools::bitmap::{self, Capture, Light};
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::rng::Rng;

type Fault = Box<dyn Error + Send + Sync>;

/// Longer side of what is true, px.
const TRUTH: u32 = 450;
/// What is nearer to another truth is not asked, px of it: 1.5 mm on A4.
const BESIDE: usize = 4;

const WHITE: [u8; 3] = [255; 3];
const CREAM: [u8; 3] = [0xf4, 0xea, 0xd2];
const GREY: [u8; 3] = [0xd0, 0xce, 0xc8];

/// Which scans are made alike, for a row of the table.
type Variant = (&'static str, fn(&mut Capture, &mut Rng));

const VARIANTS: [Variant; 21] = [
    ("plain photograph", |_, _| ()),
    ("clean white scan", |of, _| (of.light, of.noise) = (Light::Even, 2.0)),
    ("across to 0.85", |of, _| of.light = Light::Across(0.85)),
    ("across to 0.5", |of, _| of.light = Light::Across(0.5)),
    ("across to 0.3", |of, _| of.light = Light::Across(0.3)),
    ("around to 0.7", |of, _| of.light = Light::Around(0.7)),
    ("around to 0.5", |of, _| of.light = Light::Around(0.5)),
    ("shadow of 0.6, soft", |of, _| of.light = Light::Shadow(0.6, 0.2)),
    ("shadow of 0.6, harder", |of, _| of.light = Light::Shadow(0.6, 0.06)),
    ("cream, even", |of, _| (of.light, of.paper) = (Light::Even, CREAM)),
    ("cream", |of, _| of.paper = CREAM),
    ("grey, even", |of, _| (of.light, of.paper) = (Light::Even, GREY)),
    ("grey", |of, _| of.paper = GREY),
    ("warm light", |of, _| of.cast = 0.12),
    ("cold light", |of, _| of.cast = -0.12),
    ("noise 0", |of, _| of.noise = 0.0),
    ("noise 8", |of, _| of.noise = 8.0),
    ("quality 60", |of, _| of.quality = 60),
    ("1000 px", |of, _| of.side = 1000),
    ("3000 px", |of, _| of.side = 3000),
    ("all at random", at_random),
];

fn at_random(of: &mut Capture, rng: &mut Rng) {
    let dark = rng.between(0.5, 1.0);
    of.light = [Light::Across(dark), Light::Around(dark), Light::Shadow(dark, rng.between(0.08, 0.3))][rng.below(3)];
    of.paper = [WHITE, CREAM, GREY][rng.below(3)];
    of.cast = rng.between(-0.12, 0.12);
    of.noise = rng.between(0.0, 6.0);
    of.quality = rng.between(60.0, 90.0) as u8;
    of.side = rng.between(1000.0, 3000.0) as u32;
}

/// One scan to be made.
#[derive(Debug, Clone, Copy)]
struct Task {
    kind: Kind,
    variant: usize,
    seed: u64,
}

impl Task {
    fn scan(&self, scene: &Scene) -> Result<Vec<u8>, Fault> {
        let mut rng = Rng::new(self.seed ^ 0x5ca9 ^ ((self.kind as u64) << 20) ^ ((self.variant as u64) << 40));
        let light = Light::Across(0.7);
        let mut capture = Capture {
            light,
            paper: WHITE,
            cast: 0.0,
            noise: 3.0,
            quality: 80,
            side: 1600,
            seed: rng.below(1 << 30) as u64,
        };
        (VARIANTS[self.variant].1)(&mut capture, &mut rng);
        bitmap::captured(&scene.svg(), &capture)
    }

    fn name(&self) -> String {
        format!("{}-{}-seed{}", self.kind.name(), VARIANTS[self.variant].0.replace([' ', ','], "_"), self.seed)
    }
}

/// How much of what is true is so on the page.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    /// Blank places, and those of them that have a texture.
    blank: usize,
    stained: usize,
    /// Places of areas, and those of them that have their class.
    area: usize,
    right: usize,
}

struct Args {
    scans: u64,
    from: u64,
    list: usize,
    keep: Option<PathBuf>,
}

impl Args {
    fn read(mut args: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut read = Self { scans: 1, from: 0, list: 0, keep: None };
        while let Some(arg) = args.next() {
            let mut value = || args.next().ok_or_else(|| format!("{arg} needs a value"));
            let whole = |text: String| text.parse::<u64>().map_err(|_| format!("{text} is no whole number"));
            match arg.as_str() {
                "--scans" => read.scans = whole(value()?)?,
                "--from" => read.from = whole(value()?)?,
                "--list" => read.list = whole(value()?)? as usize,
                "--keep" => read.keep = Some(value()?.into()),
                _ => return Err(format!("{arg} is not known; the head of main.rs tells what is")),
            }
        }
        Ok(read)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::read(std::env::args().skip(1))?;
    let mut tasks = Vec::new();
    for variant in 0..VARIANTS.len() {
        for kind in Kind::ALL {
            tasks.extend((args.from..args.from + args.scans).map(|seed| Task { kind, variant, seed }));
        }
    }
    if let Some(folder) = &args.keep {
        std::fs::create_dir_all(folder)?;
    }
    let results = on_all_cores(&tasks, |task| measured(task, args.keep.as_ref()));
    let results: Vec<[Counts; 2]> =
        results.into_iter().collect::<Result<_, _>>().map_err(|error: Fault| error.to_string())?;
    print!("{}", table(&tasks, &results));
    let wrong =
        |counts: &Counts| (counts.stained + counts.area - counts.right) as f64 / (counts.blank + counts.area) as f64;
    let mut all: Vec<(&Task, &[Counts; 2])> = tasks.iter().zip(&results).collect();
    all.sort_by(|a, b| wrong(&b.1[1]).total_cmp(&wrong(&a.1[1])));
    for (task, [before, after]) in all.into_iter().take(args.list) {
        println!("wrong {:.3}, as it is {:.3}: {}", wrong(after), wrong(before), task.name());
    }
    Ok(())
}

/// With the ground as it is, and taken for paper.
fn measured(task: &Task, keep: Option<&PathBuf>) -> Result<[Counts; 2], Fault> {
    let scene = Scene::new(task.kind, task.seed);
    let scan = task.scan(&scene)?;
    if let Some(folder) = keep {
        std::fs::write(folder.join(format!("{}.jpg", task.name())), &scan)?;
        std::fs::write(folder.join(format!("{}-truth.png", task.name())), bitmap::png(&scene.truth(), TRUTH)?)?;
    }
    let truth = bitmap::pixels(&scene.truth(), TRUTH)?;
    Ok([counts(&scan, &truth, true)?, counts(&scan, &truth, false)?])
}

fn counts(scan: &[u8], truth: &resvg::tiny_skia::Pixmap, keep_ground: bool) -> Result<Counts, Fault> {
    let profile = Profile::named("swell-a4")?;
    let plan = Plan::new(&profile).map_err(|faults| format!("{faults:?}"))?;
    let request = Request {
        plan: &plan,
        limits: Default::default(),
        fonts: &Arc::default,
        title: "",
        language: "en",
        fit: Fit { keep_ground, ..Fit::default() },
        cancelled: &|| false,
    };
    let classes = colours::sort(scan, &request, &mut |_| ())?.classes.ok_or("the profile wants no textures")?;
    let (width, height) = (truth.width() as usize, truth.height() as usize);
    let all: Vec<Truth> =
        truth.pixels().iter().map(|pixel| Truth::named([pixel.red(), pixel.green(), pixel.blue()])).collect();
    let mut counts = Counts::default();
    for y in BESIDE..height - BESIDE {
        for x in BESIDE..width - BESIDE {
            let own = all[y * width + x];
            let around = |dy: usize| &all[(y + dy - BESIDE) * width..][x - BESIDE..=x + BESIDE];
            if own == Truth::Stroke || (0..=2 * BESIDE).any(|dy| around(dy).iter().any(|other| *other != own)) {
                continue;
            }
            let column = x * classes.size.width as usize / width;
            let row = y * classes.size.height as usize / height;
            let region = classes.region[row * classes.size.width as usize + column];
            let found = region.map(|number| classes.regions[number as usize].class);
            match own {
                Truth::Area(class) => {
                    counts.area += 1;
                    counts.right += usize::from(found == Some(class));
                }
                Truth::Blank => {
                    counts.blank += 1;
                    counts.stained += usize::from(found.is_some());
                }
                Truth::Stroke => (),
            }
        }
    }
    Ok(counts)
}

fn table(tasks: &[Task], results: &[[Counts; 2]]) -> String {
    let mut text = String::from(
        "| scans | blank paper with a texture, as it is | with its ground as paper | worst | areas of the right class, as they are \
         | with the ground as paper | worst |\n|---|---|---|---|---|---|---|\n",
    );
    let mut row = |name: &str, is_in: &dyn Fn(&Task) -> bool| {
        let of: Vec<&[Counts; 2]> = tasks.iter().zip(results).filter(|(task, _)| is_in(task)).map(|(_, c)| c).collect();
        let stained = |at: usize| shares(&of, &|counts| (counts[at].stained, counts[at].blank));
        let right = |at: usize| shares(&of, &|counts| (counts[at].right, counts[at].area));
        let told = |value: Option<f64>| value.map_or_else(|| "-".into(), |value| format!("{value:.3}"));
        let mean =
            |shares: &[f64]| told((!shares.is_empty()).then(|| shares.iter().sum::<f64>() / shares.len() as f64));
        let most = |shares: &[f64]| told(shares.iter().copied().reduce(f64::max));
        let least = |shares: &[f64]| told(shares.iter().copied().reduce(f64::min));
        let (before, after, worst) = (mean(&stained(0)), mean(&stained(1)), most(&stained(1)));
        text += &format!("| {name} | {before} | {after} | {worst} ");
        let (before, after, worst) = (mean(&right(0)), mean(&right(1)), least(&right(1)));
        text += &format!("| {before} | {after} | {worst} |\n");
    };
    for (number, (name, _)) in VARIANTS.iter().enumerate() {
        row(name, &|task| task.variant == number);
    }
    for kind in Kind::ALL {
        row(&format!("all of {}", kind.name()), &|task| task.kind == kind);
    }
    row("all", &|_| true);
    text
}

/// The share in each scan that has any.
fn shares(of: &[&[Counts; 2]], parts: &dyn Fn(&[Counts; 2]) -> (usize, usize)) -> Vec<f64> {
    let share = |counts: &&[Counts; 2]| match parts(counts) {
        (_, 0) => None,
        (part, whole) => Some(part as f64 / whole as f64),
    };
    of.iter().filter_map(share).collect()
}
