//! Our own program alone: every kind of picture, what is skipped, and how time grows.

use crate::inputs::{DRAWING, FULL_COLOUR, SIZES};
use crate::measured::{Job, run};
use crate::numbers::{exponent, hundredths};
use crate::ours::{STAGES, after_decoding, skipped, stage};
use crate::plot::{about_numbers, plot};
use crate::rounds::{Outcome, rounds};
use crate::table::{Table, number};
use crate::targets::Bench;

/// Where the drawing of the stages lies.
const PLOT: &str = "docs/speed/stages.svg";

/// Every kind of picture, stage by stage.
pub(crate) fn kinds(bench: &Bench<'_>) -> Table {
    let mut names = Vec::new();
    for (megapixels, ..) in SIZES {
        names.extend([format!("photo-{megapixels}.jpg"), format!("photo-{megapixels}-progressive.jpg")]);
    }
    let rest = [
        FULL_COLOUR,
        "photo-12.png",
        "photo-12-16.png",
        "photo-12.webp",
        "photo-12-grey.jpg",
        "white-12.jpg",
        "noise-3.png",
        "lawn-3.jpg",
    ];
    names.extend(rest.map(String::from));
    let mut pictures: Vec<_> = names.iter().map(|name| (name.clone(), bench.inputs.file(name))).collect();
    let photos = ["astronaut.png", "chelsea.png", "coffee.png", "rocket.jpg", "empty.png"];
    let drawings = ["bars.svg", "cell.svg", "chart.svg", "landscape.svg", "map.svg", "portrait.svg", "worksheet.pdf"];
    pictures.extend(photos.into_iter().chain(drawings).map(|name| {
        let name = format!("samples/{name}");
        (name.clone(), name.into())
    }));
    pictures.retain(|(_, file)| file.is_file());
    let mut jobs: Vec<Job> = pictures.iter().map(|(name, file)| bench.ours.job(name, file, "page.svg", &[])).collect();
    let drawn: [(&str, &[&str]); 2] = [("", &[]), (", fine", &["--quality", "fine"])];
    jobs.extend(drawn.map(|(how, options)| {
        bench.ours.job(&format!("{DRAWING}{how}"), &bench.inputs.file(DRAWING), "page.svg", options)
    }));
    let mut head = vec!["picture", "ms", "CPU ms", "MB"];
    head.extend(STAGES);
    let about = "Whole process (picture to SVG, swell-a4) and its stages, ms. The number in a name is megapixels; a dash is a \
                 stage that was skipped. Stages that run side by side have their own time each, so a row's sum may \
                 exceed its ms. The last two are a drawing of 1000 x 750 pixels with grain: at 4 px for a millimetre, and at \
                 its own pixels (`--quality fine`).";
    let mut table = Table::new("Every kind of picture", about, &head);
    let outcomes = rounds(&jobs, bench.setting(false));
    table.rows.extend(outcomes.iter().map(|outcome| {
        let mut cells = vec![outcome.name.clone()];
        cells.extend([outcome.wall(), outcome.cpu(), outcome.peak()].map(number));
        cells.extend(STAGES.map(|name| number(outcome.median(|run| stage(run, name)))));
        cells
    }));
    // to look at where nothing is to be written
    let file = if bench.args.write { PLOT.into() } else { bench.target.join("bench/stages.svg") };
    match std::fs::write(&file, plot(&outcomes)) {
        Ok(()) if bench.args.write => {
            let says = "A bar for each kind of picture in the table above, made of the time of each stage";
            table.after = format!("![{says}.]({})\n\n{}\n", PLOT.trim_start_matches("docs/"), about_numbers());
        }
        Ok(()) => eprintln!("drawn: {}", file.display()),
        Err(fault) => eprintln!("{}: {fault}", file.display()),
    }
    table
}

/// Pages that need less, beside the whole page of the same size.
pub(crate) fn skips(bench: &Bench<'_>) -> Table {
    let work: [(&str, &str, &[&str]); 6] = [
        ("photo, everything", "photo-12.jpg", &[]),
        ("photo, no overview", "photo-12.jpg", &["--set", "overview=false"]),
        ("photo, outlines only", "photo-12.jpg", &["--outlines"]),
        ("photo, textures only", "photo-12.jpg", &["--textures-only"]),
        ("grey photo", "photo-12-grey.jpg", &[]),
        ("white page", "white-12.jpg", &[]),
    ];
    let about = "12 MP JPEG to SVG, after decoding, with the figure in the same size on all of these pages (without an overview \
                 there would be room for a larger one). *Worth* is what the skipped stages take of the page with everything \
                 (of hues, by how much less the classes take), *saved* how much less all of it takes: what is then smaller to \
                 write or simpler to find counts too. Where a skipped stage ran beside a longer one, little or nothing \
                 is saved.";
    let head = ["page", "skipped", "worth, ms", "after decoding, ms", "saved, ms", "whole process, ms"];
    let mut table = Table::new("What is skipped", about, &head);
    let job = |(name, file, options): (&str, &str, &[&str]), width: &[&str]| {
        bench.ours.job(name, &bench.inputs.file(file), "page.svg", &[options, width].concat())
    };
    let Some(width) = figure_width(&job(work[0], &[])) else { return table };
    let jobs = work.map(|work| job(work, &["--width-mm", &width]));
    let outcomes = rounds(&jobs, bench.setting(false));
    let Some(all) = outcomes.first() else { return table };
    table.rows.extend(outcomes.iter().map(|outcome| {
        let first = outcome.runs.as_ref().ok().and_then(|runs| runs.first());
        let names = first.map(skipped).unwrap_or_default();
        let worth = |name: &&str| match *name {
            "hues" => Some(classes(all)? - classes(outcome)?),
            name => all.median(|run| stage(run, name)),
        };
        let worth = names.iter().filter_map(worth).fold(0.0, |sum, time| sum + time);
        let saved = all.beside(outcome, |all, this| Some(after_decoding(all)? - after_decoding(this)?));
        vec![
            outcome.name.clone(),
            if names.is_empty() { "nothing".into() } else { names.join(", ") },
            number(Some(worth)),
            number(outcome.median(after_decoding)),
            number(saved),
            number(outcome.wall()),
        ]
    }));
    table
}

fn classes(outcome: &Outcome) -> Option<f64> {
    outcome.median(|run| stage(run, "classes"))
}

/// How wide the program makes a figure, mm, as its page says.
fn figure_width(job: &Job) -> Option<String> {
    run(job, false).map_err(|fault| eprintln!("{}: {fault}", job.name)).ok()?;
    let page = std::fs::read_to_string(job.writes.as_ref()?).ok()?;
    let tag = page.split('<').find(|tag| tag.contains("id=\"figure\""))?;
    let numbers = tag.split_once("data-box=\"")?.1.split_once('"')?.0;
    numbers.split_whitespace().nth(2).map(String::from)
}

/// Sheets of a series, each of half the area of the next but one: width and height, mm.
const SHEETS: [(&str, u32, u32); 5] =
    [("A5", 148, 210), ("B5", 176, 250), ("A4", 210, 297), ("B4", 250, 353), ("A3", 297, 420)];

/// How time grows with the picture and with the page: exponents of the power law that fits best.
pub(crate) fn growth(bench: &Bench<'_>) -> Table {
    let about = "The exponent e of time = c x^e, by least squares on logarithms: 1 is linear, 0 does not grow. Times are \
                 medians in ms, from the smallest to the largest.";
    let mut table = Table::new("Growth", about, &["what", "grows with", "times, ms", "exponent"]);
    let mut row = |what: &str, with: &str, points: &[(f64, Option<f64>)]| {
        let times: Vec<String> = points.iter().map(|&(_, time)| number(time)).collect();
        let known: Vec<(f64, f64)> = points.iter().filter_map(|&(x, time)| Some((x, time?))).collect();
        table.rows.push(vec![what.into(), with.into(), times.join(", "), number(exponent(&known).map(hundredths))]);
    };
    let sizes: Vec<_> = SIZES.into_iter().filter(|(name, ..)| !(bench.args.quick && *name == "50")).collect();
    let pixels = |times: &dyn Fn(&Outcome) -> Option<f64>, outcomes: &[Outcome]| -> Vec<(f64, Option<f64>)> {
        sizes
            .iter()
            .zip(outcomes)
            .map(|((_, width, height), outcome)| ((width * height) as f64, times(outcome)))
            .collect()
    };
    let with = format!("pixels, {} MP", sizes.iter().map(|(name, ..)| *name).collect::<Vec<_>>().join(", "));
    for (kind, ending) in [("JPEG", ".jpg"), ("progressive JPEG", "-progressive.jpg")] {
        let jobs: Vec<Job> = sizes
            .iter()
            .map(|(name, ..)| (name, bench.inputs.file(&format!("photo-{name}{ending}"))))
            .map(|(name, file)| bench.ours.job(name, &file, "page.svg", &[]))
            .collect();
        let outcomes = rounds(&jobs, bench.setting(false));
        let decode = |outcome: &Outcome| outcome.median(|run| stage(run, "decode"));
        row(&format!("decoding, {kind}"), &with, &pixels(&decode, &outcomes));
        if kind == "JPEG" {
            row("all after decoding", &with, &pixels(&|outcome| outcome.median(after_decoding), &outcomes));
        }
    }
    let picture = bench.inputs.file("photo-12.jpg");
    let sides = |width: u32, height: u32| [format!("page.width={width}"), format!("page.height={height}")];
    let jobs = SHEETS.map(|(name, width, height)| {
        let [wide, high] = sides(width, height);
        bench.ours.job(name, &picture, "page.svg", &["--set", &wide, "--set", &high])
    });
    let outcomes = rounds(&jobs, bench.setting(false));
    let sheets = |time: &dyn Fn(&Outcome) -> Option<f64>| -> Vec<(f64, Option<f64>)> {
        SHEETS.iter().zip(&outcomes).map(|((_, w, h), outcome)| (f64::from(w * h), time(outcome))).collect()
    };
    let with = format!("area of the sheet, {}", SHEETS.map(|(name, ..)| name).join(", "));
    row("all after decoding", &with, &sheets(&|outcome| outcome.median(after_decoding)));
    for name in ["edges", "regions", "lines", "overview", "classes", "textures", "write"] {
        row(name, &with, &sheets(&|outcome| outcome.median(|run| stage(run, name))));
    }
    row("decoding, 12 MP JPEG", &with, &sheets(&|outcome| outcome.median(|run| stage(run, "decode"))));
    table
}
