//! Are drawings whole on their pages? Draws simple diagrams whose contours are known, converts them, and counts the pages
//! on which at least 0.99 of the contours' length has a line within 0.7 mm.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin drawings        the table (about 1300 pages, two minutes)
//!   --pages N          so many pages for each kind, stroke width and input (default 12)
//!   --from SEED        the first of their seeds (default 0): other pages, of the same kinds
//!   --again FILE       instead: the pages named in this list, as --list names them
//!   --kind NAME        only this kind
//!   --input NAME       only svg, png, jpg or scan
//!   --list N           also the N worst pages, each with what makes it again
//!   --keep DIR         writes the picture and the page of the listed ones into a folder
//!   --profile NAME     default swell-a3
//!   --csv FILE         also every page on a line of its own
//! ```
//!
//! **Scenes** (`scenes.rs`): twelve kinds of 900 x 600 units with strokes of 0.5, 1, 2, 3 and 6 units. **Input**: the drawing
//! as SVG, and rendered as a PNG, a JPEG and a scan (uneven light, noise, JPEG) of 1200 px for its longer side. **Pages**: each has its own seed, one of four quarter
//! turns, and a figure from 60 to 250 mm wide in steps of 1 mm (the golden ratio spreads them evenly). **Truth**: outlines
//! and the middle of strokes.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod scenes;

use std::error::Error;
use std::path::{Path, PathBuf};

use scenes::{Kind, Point, Scene};
use tactograph::marks::{Line, Run};
use tactograph::{Options, Profile};
use tactograph_tools::bitmap;
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::drawn::{Shares, shares};

/// Widths of strokes, in units of the drawing.
const STROKES: [f64; 5] = [0.5, 1.0, 2.0, 3.0, 6.0];
/// Narrowest and widest figure, mm.
const WIDTHS: [u32; 2] = [60, 250];
/// A page is whole from this share of its contours on.
const WHOLE: f64 = 0.99;
/// Longer side of bitmaps, px.
const SIDE: u32 = 1200;

/// Quality of JPEGs, 1 to 100: as pictures on web pages are.
const JPEG_QUALITY: u8 = 80;

/// How a drawing is given to the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Input {
    Svg,
    Png,
    Jpeg,
    Scan,
}

impl Input {
    const ALL: [Self; 4] = [Self::Svg, Self::Png, Self::Jpeg, Self::Scan];

    fn name(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Jpeg => "jpg",
            Self::Scan => "scan",
        }
    }
}

/// One page to be made.
#[derive(Debug, Clone, Copy)]
struct Task {
    kind: Kind,
    stroke: f64,
    input: Input,
    seed: u64,
    turns: u8,
    width: u32,
}

impl Task {
    fn picture(&self) -> Result<Vec<u8>, Box<dyn Error + Send + Sync>> {
        let svg = Scene::new(self.kind, self.stroke, self.seed).svg(self.turns);
        match self.input {
            Input::Svg => Ok(svg.into_bytes()),
            Input::Png => bitmap::png(&svg, SIDE),
            Input::Jpeg => bitmap::jpeg(&svg, SIDE, JPEG_QUALITY),
            Input::Scan => bitmap::scan(&svg, SIDE, self.seed),
        }
    }

    /// The page of a line that ends in its file name.
    fn named(line: &str) -> Result<Self, String> {
        let read = || {
            let (_, name) = line.trim().rsplit_once(' ').unwrap_or(("", line.trim()));
            let [kind, stroke, input, seed, turns, width] = name.split('-').collect::<Vec<_>>().try_into().ok()?;
            Some(Self {
                kind: Kind::ALL.into_iter().find(|of| of.name() == kind)?,
                stroke: stroke.parse().ok()?,
                input: Input::ALL.into_iter().find(|of| of.name() == input)?,
                seed: seed.strip_prefix("seed")?.parse().ok()?,
                turns: turns.strip_prefix("turn")?.parse().ok()?,
                width: width.split_once("mm")?.0.parse().ok()?,
            })
        };
        read().ok_or_else(|| format!("{line}: not a page as --list names them"))
    }

    fn file_name(&self, end: &str) -> String {
        let Self { kind, stroke, input, seed, turns, width } = self;
        format!("{}-{stroke}-{}-seed{seed}-turn{turns}-{width}mm.{end}", kind.name(), input.name())
    }
}

struct Args {
    pages: u64,
    from: u64,
    again: Option<PathBuf>,
    kind: Option<Kind>,
    input: Option<Input>,
    list: usize,
    keep: Option<PathBuf>,
    profile: String,
    csv: Option<PathBuf>,
}

impl Args {
    fn read(mut args: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut read = Self {
            pages: 12,
            from: 0,
            again: None,
            kind: None,
            input: None,
            list: 0,
            keep: None,
            profile: "swell-a3".into(),
            csv: None,
        };
        while let Some(arg) = args.next() {
            let mut value = || args.next().ok_or_else(|| format!("{arg} needs a value"));
            match arg.as_str() {
                "--pages" => read.pages = value()?.parse().map_err(|_| "--pages takes a whole number")?,
                "--from" => read.from = value()?.parse().map_err(|_| "--from takes a whole number")?,
                "--list" => read.list = value()?.parse().map_err(|_| "--list takes a whole number")?,
                "--again" => read.again = Some(value()?.into()),
                "--keep" => read.keep = Some(value()?.into()),
                "--csv" => read.csv = Some(value()?.into()),
                "--profile" => read.profile = value()?,
                "--input" => {
                    let name = value()?;
                    let input = Input::ALL.into_iter().find(|input| input.name() == name);
                    read.input = Some(input.ok_or_else(|| format!("there is no input {name}"))?);
                }
                "--kind" => {
                    let name = value()?;
                    let kind = Kind::ALL.into_iter().find(|kind| kind.name() == name);
                    read.kind = Some(kind.ok_or_else(|| format!("there is no kind {name}"))?);
                }
                _ => return Err(format!("{arg} is not known; the head of main.rs tells what is")),
            }
        }
        Ok(read)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::read(std::env::args().skip(1))?;
    let tasks = match &args.again {
        Some(file) => std::fs::read_to_string(file)?.lines().map(Task::named).collect::<Result<_, _>>()?,
        None => tasks(&args),
    };
    let results = on_all_cores(&tasks, |task| page(task, &args.profile));
    let mut measured = Vec::new();
    for (task, result) in tasks.iter().zip(results) {
        let (shares, _) = result.map_err(|error| format!("{task:?}: {error}"))?;
        measured.push((*task, shares));
    }
    print!("{}", table(&measured));
    if let Some(file) = &args.csv {
        std::fs::write(file, csv(&measured))?;
    }
    measured.sort_by(|a, b| (a.1.drawn - a.1.beside).total_cmp(&(b.1.drawn - b.1.beside)));
    for (task, shares) in measured.iter().take(args.list) {
        println!("drawn {:.3}, beside {:.3}: {}", shares.drawn, shares.beside, task.file_name("svg"));
        if let Some(folder) = &args.keep {
            keep(task, folder, &args.profile)?;
        }
    }
    Ok(())
}

/// The pages, the same in every run.
fn tasks(args: &Args) -> Vec<Task> {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let widths = f64::from(WIDTHS[1] - WIDTHS[0] + 1);
    let mut tasks = Vec::new();
    for kind in Kind::ALL.into_iter().filter(|kind| args.kind.is_none_or(|only| only == *kind)) {
        for (s, stroke) in STROKES.into_iter().enumerate() {
            for seed in args.from..args.from + args.pages {
                let spread = (GOLDEN * (seed as f64 + 0.2 * s as f64 + 0.07 * kind as u8 as f64)).fract();
                let width = WIDTHS[0] + (spread * widths) as u32;
                let turns = ((seed + s as u64) % 4) as u8;
                let task = |input| Task { kind, stroke, input, seed, turns, width };
                let inputs = Input::ALL.into_iter();
                tasks.extend(inputs.filter(|input| args.input.is_none_or(|only| only == *input)).map(task));
            }
        }
    }
    tasks
}

/// Shares of a page, and the page as SVG.
fn page(task: &Task, profile: &str) -> Result<(Shares, String), Box<dyn Error + Send + Sync>> {
    let scene = Scene::new(task.kind, task.stroke, task.seed);
    let drawn = convert(&task.picture()?, profile, task.width as f32)?;
    let scale = drawn.width / if task.turns.is_multiple_of(2) { scenes::WIDTH } else { scenes::HEIGHT };
    let on_sheet = |&[x, y]: &Point| [drawn.corner[0] + scale * x, drawn.corner[1] + scale * y];
    let truth: Vec<Vec<Point>> =
        scene.truth(task.turns).iter().map(|line| line.iter().map(on_sheet).collect()).collect();
    Ok((shares(&truth, &drawn.lines), drawn.svg))
}

/// What is on a page: the corner of its figure and its width, mm, its lines in mm, and the page as SVG.
struct Drawn {
    corner: Point,
    width: f64,
    lines: Vec<Vec<Point>>,
    svg: String,
}

/// Converts a picture to a figure `width` mm wide, without an overview, which would take room from it.
fn convert(picture: &[u8], profile: &str, width: f32) -> Result<Drawn, Box<dyn Error + Send + Sync>> {
    let mut profile = Profile::named(profile)?;
    profile.set("overview.on", "false")?;
    // room for the widest figure when it stands on its side
    profile.set("page.width", "320")?;
    profile.set("page.height", "450")?;
    let page = tactograph::convert(picture, &Options::new(profile).width_mm(width))?.page;
    let place = page.figure.place;
    // runs one after the other; a ring's own begin and end where it does
    let points = |line: &Line| -> Vec<Point> {
        let run = |run: &Run| run.points.iter().chain(run.points.first().filter(|_| run.closed)).copied().collect();
        let all: Vec<_> = line.runs.iter().flat_map::<Vec<_>, _>(run).collect();
        all.into_iter().map(|at| [f64::from(at.x), f64::from(at.y)]).collect()
    };
    Ok(Drawn {
        corner: [f64::from(place.min.x), f64::from(place.min.y)],
        width: f64::from(place.width()),
        lines: page.figure.lines.iter().map(points).collect(),
        svg: page.to_svg(),
    })
}

fn table(measured: &[(Task, Shares)]) -> String {
    let mut text = String::from(
        "| input | kind | pages | whole | mean drawn | worst drawn | mean beside | most beside |\n|---|---|---|---|---|---|---|---|\n",
    );
    for input in Input::ALL {
        let kinds = Kind::ALL.into_iter().map(Some).chain([None]);
        for kind in kinds {
            let of: Vec<&Shares> = measured
                .iter()
                .filter(|(task, _)| task.input == input && kind.is_none_or(|kind| kind == task.kind))
                .map(|(_, shares)| shares)
                .collect();
            if !of.is_empty() {
                text += &row(input.name(), kind.map_or("all", Kind::name), &of);
            }
        }
        for stroke in STROKES {
            let of: Vec<&Shares> = measured
                .iter()
                .filter(|(task, _)| task.input == input && (task.stroke - stroke).abs() < f64::EPSILON)
                .map(|(_, shares)| shares)
                .collect();
            if !of.is_empty() {
                text += &row(input.name(), &format!("stroke {stroke}"), &of);
            }
        }
    }
    text
}

fn row(input: &str, what: &str, of: &[&Shares]) -> String {
    let count = of.len() as f64;
    let mean = |value: &dyn Fn(&Shares) -> f64| of.iter().map(|shares| value(shares)).sum::<f64>() / count;
    let whole = mean(&|shares| f64::from(u8::from(shares.drawn >= WHOLE)));
    let worst = of.iter().map(|shares| shares.drawn).fold(f64::INFINITY, f64::min);
    let most = of.iter().map(|shares| shares.beside).fold(0.0, f64::max);
    format!(
        "| {input} | {what} | {} | {whole:.3} | {:.3} | {worst:.3} | {:.4} | {most:.4} |\n",
        of.len(),
        mean(&|shares| shares.drawn),
        mean(&|shares| shares.beside),
    )
}

fn csv(measured: &[(Task, Shares)]) -> String {
    let mut text = String::from("kind,stroke,input,seed,turns,width_mm,drawn,beside\n");
    for (task, shares) in measured {
        let Task { kind, stroke, input, seed, turns, width } = task;
        text += &format!(
            "{},{stroke},{},{seed},{turns},{width},{:.4},{:.4}\n",
            kind.name(),
            input.name(),
            shares.drawn,
            shares.beside
        );
    }
    text
}

/// Writes a picture and its page.
fn keep(task: &Task, folder: &Path, profile: &str) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let picture = task.picture().map_err(|error| error.to_string())?;
    let (_, page) = page(task, profile).map_err(|error| error.to_string())?;
    std::fs::write(folder.join(format!("picture-{}", task.file_name(task.input.name()))), picture)?;
    std::fs::write(folder.join(format!("page-{}", task.file_name("svg"))), page)?;
    Ok(())
}
