//! Is text in bitmaps left out, and nothing else? Draws charts, maps, signs and worksheets with text, and scenes with what is
//! taken for text most easily, converts them, and looks what was found and what was lost.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin text        the table (480 scenes, some minutes)
//!   --scenes N         so many of each kind, ground, size and direction (default 1)
//!   --from SEED        the first of their seeds (default 0): other scenes, of the same kinds
//!   --kind NAME        only this kind
//!   --ground NAME      only plain, coloured or photo
//!   --list N           also the N worst scenes by what is found, and by what is lost
//!   --keep DIR         writes the pictures and pages of the listed ones into a folder
//!   --pictures FILE... instead: how many texts are found in these pictures, and what share of their lines is lost
//! ```
//!
//! **Scenes** (`scenes.rs`): ten kinds of 900 x 600 px, on white, on a colour and on a photograph, with text of 6 to 40 px in
//! ten fonts of Debian (`fonts-dejavu fonts-liberation fonts-lato fonts-open-sans fonts-ebgaramond fonts-comfortaa
//! fonts-noto-core`), level and aslant. **Found** is a text when at least 0.8 of its length lies in boxes that are reported
//! at its angle. **Lost** is the share of the lines of the scene without its text that is missing with text and all.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod layouts;
mod picture;
mod scenes;

use std::path::{Path, PathBuf};

use picture::{Fault, pixels, with_scene};
use scenes::{Ground, Kind, Task, WIDTH};
use tactograph::{Drawing, Options, Profile};
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::drawn::{Point, lines_of, near, share_near};
use tactograph_tools::words::Words;

/// Sizes of fonts, px.
const SIZES: [u32; 8] = [6, 8, 10, 12, 16, 20, 28, 40];
/// A text is found when so much of its length is.
const FOUND: f64 = 0.8;
/// ... at an angle that is at most so far off, degrees.
const ANGLE: f64 = 15.0;

/// What became of a scene.
#[derive(Debug, Clone, Copy)]
struct Outcome {
    /// Share of its texts that were found.
    found: f64,
    /// Share of its lines that were lost.
    lost: f64,
}

struct Args {
    scenes: u64,
    from: u64,
    kind: Option<Kind>,
    ground: Option<Ground>,
    list: usize,
    keep: Option<PathBuf>,
    pictures: Vec<PathBuf>,
}

impl Args {
    fn read(mut words: Words) -> Result<Self, String> {
        let mut args = Self { scenes: 1, from: 0, kind: None, ground: None, list: 0, keep: None, pictures: Vec::new() };
        while let Some(word) = words.next() {
            match word.as_str() {
                "--scenes" => args.scenes = words.whole_number(&word)? as u64,
                "--from" => args.from = words.whole_number(&word)? as u64,
                "--list" => args.list = words.whole_number(&word)?,
                "--keep" => args.keep = Some(words.value(&word)?.into()),
                "--pictures" => args.pictures = words.by_ref().map(PathBuf::from).collect(),
                "--kind" => {
                    let name = words.value(&word)?;
                    let kind = Kind::ALL.into_iter().find(|kind| kind.name() == name);
                    args.kind = Some(kind.ok_or_else(|| format!("there is no kind {name}"))?);
                }
                "--ground" => {
                    let name = words.value(&word)?;
                    let ground = Ground::ALL.into_iter().find(|ground| ground.name() == name);
                    args.ground = Some(ground.ok_or_else(|| format!("there is no ground {name}"))?);
                }
                _ => return Err(words.unknown(&word)),
            }
        }
        Ok(args)
    }

    fn tasks(&self) -> Vec<Task> {
        let mut tasks = Vec::new();
        for kind in Kind::ALL.into_iter().filter(|kind| self.kind.is_none_or(|only| only == *kind)) {
            for ground in Ground::ALL.into_iter().filter(|ground| self.ground.is_none_or(|only| only == *ground)) {
                for size in SIZES {
                    for slanted in [false, true] {
                        let seeds = self.from..self.from + self.scenes;
                        tasks.extend(seeds.map(|seed| Task { kind, ground, size, slanted, seed }));
                    }
                }
            }
        }
        tasks
    }
}

fn main() -> Result<(), Fault> {
    let args = Args::read(Words::of_program("tools/src/bin/text/main.rs"))?;
    if !args.pictures.is_empty() {
        return args.pictures.iter().try_for_each(|path| tell_of_picture(path));
    }
    let tasks = args.tasks();
    let outcomes: Result<Vec<Outcome>, Fault> = on_all_cores(&tasks, outcome).into_iter().collect();
    let outcomes: Vec<(Task, Outcome)> = tasks.into_iter().zip(outcomes?).collect();
    print!("{}", table(&outcomes));
    type Order = fn(&Outcome) -> f64;
    for (what, order) in [("found", (|outcome| outcome.found) as Order), ("lost", |outcome| -outcome.lost)] {
        let mut worst: Vec<_> = outcomes.iter().filter(|(task, _)| what == "lost" || task.size >= 10).collect();
        worst.sort_by(|a, b| order(&a.1).total_cmp(&order(&b.1)));
        for (task, outcome) in worst.into_iter().take(args.list) {
            println!("{what}: {} found {:.3} lost {:.4}", task.name(), outcome.found, outcome.lost);
            if let Some(folder) = &args.keep {
                keep(task, folder)?;
            }
        }
    }
    Ok(())
}

fn outcome(task: &Task) -> Result<Outcome, Fault> {
    with_scene(task, |scene| {
        let whole = convert(&pixels(scene, task, true, true)?.encode_png()?, false)?;
        let without = convert(&pixels(scene, task, true, false)?.encode_png()?, true)?;
        let place = whole.page.figure.place;
        let scale = f64::from(place.width()) / f64::from(WIDTH);
        let on_sheet = |at: Point| [f64::from(place.min.x) + scale * at[0], f64::from(place.min.y) + scale * at[1]];
        let texts = scene.texts()?;
        let is_found = |text: &scenes::TrueText| {
            let covers = |at: &Point| {
                whole.texts.iter().any(|found| {
                    let turn = (f64::from(found.angle) - text.angle + 540.0).rem_euclid(360.0) - 180.0;
                    let inside =
                        |axis: usize, min: f32, max: f32| (f64::from(min)..=f64::from(max)).contains(&at[axis]);
                    turn.abs() <= ANGLE
                        && inside(0, found.place.min.x, found.place.max.x)
                        && inside(1, found.place.min.y, found.place.max.y)
                })
            };
            let along: Vec<Point> = text.along().into_iter().map(on_sheet).collect();
            along.iter().filter(|at| covers(at)).count() as f64 >= FOUND * along.len() as f64
        };
        let found = texts.iter().filter(|text| is_found(text)).count() as f64 / texts.len().max(1) as f64;
        let mut wanted = lines_of(&without.page);
        if task.ground == Ground::Photo {
            // of the things, what a photograph lets be drawn with letters and without them
            let alone = Task { ground: Ground::Plain, ..*task };
            let things = lines_of(&convert(&pixels(scene, &alone, true, false)?.encode_png()?, true)?.page);
            let kept = lines_of(&convert(&pixels(scene, task, true, true)?.encode_png()?, true)?.page);
            wanted = near(&near(&wanted, &things), &kept);
        }
        let lost = share_near(&wanted, &lines_of(&whole.page)).map_or(0.0, |near| 1.0 - near);
        Ok(Outcome { found, lost })
    })
}

/// Draws the lines of a picture, with its letters or without.
fn convert(picture: &[u8], keep_text: bool) -> Result<Drawing, Fault> {
    let mut profile = Profile::named("swell-a4")?;
    for key in ["overview.on", "figure.textures"] {
        profile.set(key, "false")?;
    }
    Ok(tactograph::convert(picture, &Options::new(profile).keep_text(keep_text))?)
}

fn tell_of_picture(path: &Path) -> Result<(), Fault> {
    let picture = std::fs::read(path)?;
    let (drawn, kept) = (convert(&picture, false)?, convert(&picture, true)?);
    let lost = share_near(&lines_of(&kept.page), &lines_of(&drawn.page)).map_or(0.0, |near| 1.0 - near);
    println!("{}: {} texts, {:.2} % of the lines lost", path.display(), drawn.texts.len(), 100.0 * lost);
    Ok(())
}

fn keep(task: &Task, folder: &Path) -> Result<(), Fault> {
    std::fs::create_dir_all(folder)?;
    with_scene(task, |scene| {
        let picture = pixels(scene, task, true, true)?.encode_png()?;
        std::fs::write(folder.join(format!("{}.page.svg", task.name())), convert(&picture, false)?.page.to_svg())?;
        Ok(std::fs::write(folder.join(format!("{}.png", task.name())), picture)?)
    })
}

fn table(outcomes: &[(Task, Outcome)]) -> String {
    let mean = |of: &dyn Fn(&Task) -> bool, value: fn(&Outcome) -> f64| {
        let values: Vec<f64> =
            outcomes.iter().filter(|(task, _)| of(task)).map(|(_, outcome)| value(outcome)).collect();
        if values.is_empty() { f64::NAN } else { values.iter().sum::<f64>() / values.len() as f64 }
    };
    let mut text = String::from("| texts found, by size in px |");
    SIZES.iter().for_each(|size| text += &format!(" {size} |"));
    text += "\n|---|";
    text += &"---|".repeat(SIZES.len());
    text += "\n";
    for ground in Ground::ALL {
        for slanted in [false, true] {
            text += &format!("| {}, {} |", ground.name(), if slanted { "aslant" } else { "level" });
            for size in SIZES {
                let is = |task: &Task| task.ground == ground && task.slanted == slanted && task.size == size;
                text += &format!(" {:.2} |", mean(&is, |outcome| outcome.found));
            }
            text += "\n";
        }
    }
    text += "\n| lines lost, % |";
    Kind::ALL.iter().for_each(|kind| text += &format!(" {} |", kind.name()));
    text += "\n|---|";
    text += &"---|".repeat(Kind::ALL.len());
    text += "\n";
    for ground in Ground::ALL {
        text += &format!("| {} |", ground.name());
        for kind in Kind::ALL {
            text += &format!(
                " {:.2} |",
                100.0 * mean(&|task| task.ground == ground && task.kind == kind, |outcome| outcome.lost)
            );
        }
        text += "\n";
    }
    let of_size = |from: u32| mean(&|task| task.size >= from, |outcome| outcome.found);
    text += &format!(
        "\n{} scenes; found of 10 px and more {:.3}, of all {:.3}; lost {:.2} %\n",
        outcomes.len(),
        of_size(10),
        of_size(0),
        100.0 * mean(&|_| true, |outcome| outcome.lost)
    );
    text
}
