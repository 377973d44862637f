//! How much of what people outline in photographs do the lines of pages draw? The table of docs/photographs.md; with
//! `--contours --all` the row *now* of docs/accuracy.md, whose other rows another program read.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin people -- BSDS500/data
//!   --split NAME       val (the default), train or test; docs/photographs.md says which the constants were chosen on
//!   --pictures N       so many of it, evenly spaced (default 50)
//!   --after K          of each of those the K-th picture after it instead: others of the same set
//!   --all              val, train, and train --after 2, each with contours alone and as it is: the whole table
//!   --contours         in place of pages contours as data (`trace --full-resolution`): ODS, OIS and AP
//!   --set KEY=VALUE    changes a value of the profile (lines.regions=false: contours alone)
//! ```
//!
//! The data are those of the Berkeley segmentation benchmark (BSDS500, for research): a folder with `images` and
//! `groundTruth`. A line is right if anybody outlined something within .0075 of the diagonal; a boundary that at least
//! half of the people share is found if a line lies as near. *closed* is the share of the drawn length in rings,
//! *covering* the segmentation covering by what the lines part.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod contours;
mod mat;
mod measure;

use std::error::Error;
use std::path::{Path as FilePath, PathBuf};

use contours::StrengthMap;
use mat::{Array, Matrix};
use measure::{Agreement, Outlined, Path, agreement};
use tactograph::marks::Line;
use tactograph::{MmRect, Options, Profile, Tracing};
use tactograph_tools::cores::on_all_cores;

/// What the command line asks for.
struct Args {
    data: PathBuf,
    split: Option<String>,
    pictures: usize,
    after: usize,
    all: bool,
    contours: bool,
    profile: Profile,
}

/// Pictures, and how pages are made of them.
struct Set {
    split: String,
    after: usize,
    profile: Profile,
    /// What is said of its rows.
    told: &'static str,
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = args()?;
    if args.contours {
        return print_contours(&args);
    }
    println!("| | precision | recall | F | lines | closed | covering |");
    println!("|---|---|---|---|---|---|---|");
    let mut last = String::new();
    for set in args.sets()? {
        let ids = ids(&args, &set)?;
        let of_picture = |id: &String| measured(id, &args.data, &set).map_err(|error| format!("{id}: {error}"));
        let all: Vec<[Agreement; 2]> = on_all_cores(&ids, of_picture).into_iter().collect::<Result<_, _>>()?;
        let head = format!("| **{}** | | | | | | |", set.name(all.len()));
        if head != last {
            println!("{head}");
            last = head;
        }
        for (part, name) in ["figure", "overview"].into_iter().enumerate() {
            let of_part: Vec<Agreement> = all.iter().map(|parts| parts[part]).collect();
            println!("{}", row(&format!("{name}{}", set.told), &of_part));
        }
    }
    Ok(())
}

/// Prints how contours as data agree with what people outlined. The profile has no say in them.
fn print_contours(args: &Args) -> Result<(), Box<dyn Error>> {
    println!("| | ODS | OIS | AP |");
    println!("|---|---|---|---|");
    for set in args.sets()?.into_iter().filter(|set| set.told.is_empty()) {
        let ids = ids(args, &set)?;
        let of_picture = |id: &String| traced(id, &args.data, &set).map_err(|error| format!("{id}: {error}"));
        let all: Vec<(StrengthMap, Vec<Outlined>)> =
            on_all_cores(&ids, of_picture).into_iter().collect::<Result<_, _>>()?;
        let maps: Vec<&StrengthMap> = all.iter().map(|(map, _)| map).collect();
        let thresholds = contours::thresholds(&maps);
        let counts = on_all_cores(&all, |(map, people)| contours::counts(map, people, &thresholds));
        let scores = contours::scores(&counts);
        println!("| {} | {:.3} | {:.3} | {:.3} |", set.name(ids.len()), scores.ods, scores.ois, scores.ap);
    }
    Ok(())
}

/// The row of a part of pages: how it agrees in all pictures.
fn row(name: &str, of_part: &[Agreement]) -> String {
    let sum = |of: fn(&Agreement) -> usize| of_part.iter().map(of).sum::<usize>() as f64;
    let mean = |of: fn(&Agreement) -> f64| of_part.iter().map(of).sum::<f64>() / of_part.len().max(1) as f64;
    let precision = sum(|of| of.right) / sum(|of| of.drawn).max(1.0);
    let recall = sum(|of| of.found) / sum(|of| of.wanted).max(1.0);
    let f = 2.0 * precision * recall / (precision + recall).max(f64::MIN_POSITIVE);
    let (lines, closed, covering) = (mean(|of| of.lines as f64), mean(|of| of.closed), mean(|of| of.covering));
    format!("| {name} | {precision:.3} | {recall:.3} | {f:.3} | {lines:.1} | {closed:.3} | {covering:.3} |")
}

impl Set {
    /// What it is called in tables, with so many pictures.
    fn name(&self, pictures: usize) -> String {
        let after = if self.after > 0 { format!(", {} after each of those", self.after) } else { String::new() };
        format!("{}, {pictures} pictures{after}", self.split)
    }
}

impl Args {
    /// The sets of pictures that are asked for.
    fn sets(&self) -> Result<Vec<Set>, Box<dyn Error>> {
        let set = |split: &str, after: usize, profile: &Profile, told: &'static str| Set {
            split: split.to_owned(),
            after,
            profile: profile.clone(),
            told,
        };
        if !self.all {
            return Ok(vec![set(self.split.as_deref().unwrap_or("val"), self.after, &self.profile, "")]);
        }
        if self.split.is_some() || self.after > 0 {
            return Err("--all: it has splits of its own; leave out --split and --after".into());
        }
        let mut alone = self.profile.clone();
        alone.set("lines.regions", "false")?;
        let ways = [(&alone, ", contours alone"), (&self.profile, "")];
        let pictures = [("val", 0), ("train", 0), ("train", 2)];
        let of_pictures = |(split, after)| ways.map(|(profile, told)| set(split, after, profile, told));
        Ok(pictures.into_iter().flat_map(of_pictures).collect())
    }
}

fn args() -> Result<Args, Box<dyn Error>> {
    let mut args = Args {
        data: PathBuf::new(),
        split: None,
        pictures: 50,
        after: 0,
        all: false,
        contours: false,
        profile: Profile::named("swell-a4")?,
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word}: give a value"));
        match word.as_str() {
            "--split" => args.split = Some(value()?),
            "--pictures" => args.pictures = value()?.parse()?,
            "--after" => args.after = value()?.parse()?,
            "--all" => args.all = true,
            "--contours" => args.contours = true,
            "--set" => {
                let value = value()?;
                let (key, value) = value.split_once('=').ok_or("--set: give KEY=VALUE")?;
                args.profile.set(key, value)?;
            }
            _ if word.starts_with('-') => return Err(format!("{word}: there is no such option").into()),
            _ => args.data = word.into(),
        }
    }
    if args.data.as_os_str().is_empty() {
        return Err("give the folder that has images and groundTruth, such as BSDS500/data".into());
    }
    Ok(args)
}

/// The pictures, evenly spaced over the set.
fn ids(args: &Args, set: &Set) -> Result<Vec<String>, Box<dyn Error>> {
    let mut all = Vec::new();
    for entry in args.data.join("images").join(&set.split).read_dir()? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "jpg") {
            all.extend(path.file_stem().map(|name| name.to_string_lossy().into_owned()));
        }
    }
    all.sort();
    if all.is_empty() || args.pictures == 0 {
        return Err("there are no pictures".into());
    }
    let count = args.pictures.min(all.len());
    let at = |number: usize| number * (all.len() - 1) / (count - 1).max(1);
    let is_next = |number: usize| set.after >= at(number + 1) - at(number);
    if set.after > 0 && (0..count - 1).any(is_next) {
        return Err(
            format!("--after {}: these would be the same pictures; the set has {}", set.after, all.len()).into()
        );
    }
    let at = (0..count).map(|number| at(number) + set.after);
    Ok(at.filter_map(|at| all.get(at).cloned()).collect())
}

/// How figure and overview of a picture's page agree with what people outlined in it.
fn measured(id: &str, data: &FilePath, set: &Set) -> Result<[Agreement; 2], Box<dyn Error + Send + Sync>> {
    let file = |folder: &str, ending: &str| data.join(folder).join(&set.split).join(format!("{id}.{ending}"));
    let people = people(&file("groundTruth", "mat"))?;
    let picture = std::fs::read(file("images", "jpg"))?;
    let page = tactograph::convert(&picture, &Options::new(set.profile.clone()))?.page;
    let size = (people[0].boundaries.width as f64, people[0].boundaries.height as f64);
    let figure = agreement(&paths(&page.figure.lines, page.figure.place, size), &people);
    let overview = page.overview.as_ref().map(|overview| paths(&overview.lines, overview.place, size));
    Ok([figure, agreement(&overview.unwrap_or_default(), &people)])
}

/// The contours of a picture, as many as there are, and what people outlined in it.
fn traced(id: &str, data: &FilePath, set: &Set) -> Result<(StrengthMap, Vec<Outlined>), Box<dyn Error + Send + Sync>> {
    let file = |folder: &str, ending: &str| data.join(folder).join(&set.split).join(format!("{id}.{ending}"));
    let people = people(&file("groundTruth", "mat"))?;
    let picture = std::fs::read(file("images", "jpg"))?;
    let tracing = Tracing::contours_at_full_resolution().thresholds(0.0, 0.0)?;
    let trace = tactograph::trace(&picture, &tracing, &Options::new(set.profile.clone()))?.trace;
    let outlined = &people[0].boundaries;
    if [trace.size.width as usize, trace.size.height as usize] != [outlined.width, outlined.height] {
        return Err("what people outlined is of another size".into());
    }
    Ok((StrengthMap::of(&trace), people))
}

/// What the people outlined who looked at a picture.
fn people(file: &FilePath) -> Result<Vec<Outlined>, Box<dyn Error + Send + Sync>> {
    let Some(Array::Cells(people)) = mat::read(&std::fs::read(file)?)?.into_iter().next() else {
        return Err("there are no people in it".into());
    };
    let outlined = |person: Array| {
        let Array::Fields(fields) = person else { return Err("a person without fields".to_owned()) };
        let field = |name: &str| match fields.iter().find(|(own, _)| own == name) {
            Some((_, Array::Numbers(matrix))) => Ok::<Matrix, String>(matrix.clone()),
            _ => Err(format!("{name} is missing")),
        };
        Ok(Outlined { boundaries: field("Boundaries")?, segments: field("Segmentation")? })
    };
    let people: Vec<Outlined> = people.into_iter().map(outlined).collect::<Result<_, _>>()?;
    let is_alike = |person: &Outlined| {
        let size = |matrix: &Matrix| (matrix.width, matrix.height);
        let first = size(&people[0].boundaries);
        size(&person.boundaries) == first && size(&person.segments) == first
    };
    if people.is_empty() || !people.iter().all(is_alike) {
        return Err("people outlined pictures of different sizes, or none".into());
    }
    Ok(people)
}

/// Lines of a part of a page, in pixels of the picture.
fn paths(lines: &[Line], place: MmRect, (width, height): (f64, f64)) -> Vec<Path> {
    let path = |line: &Line| {
        let runs = line.runs.iter().flat_map(|run| run.polyline().path().copied().collect::<Vec<_>>());
        let px = |x: f32, from: f32, across: f32, size: f64| f64::from((x - from) / across) * size;
        let at =
            runs.map(|at| (px(at.x, place.min.x, place.width(), width), px(at.y, place.min.y, place.height(), height)));
        at.collect::<Path>()
    };
    lines.iter().map(path).filter(|path| path.len() > 1).collect()
}

#[cfg(test)]
mod tests;
