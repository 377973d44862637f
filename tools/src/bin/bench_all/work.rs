//! Work other than a photograph to a page: drawings, PDF, checking and writing pages.

use std::ffi::OsString;

use crate::measured::{Job, run};
use crate::ours::stage;
use crate::rounds::rounds;
use crate::table::{Table, number};
use crate::targets::Bench;

/// Everything that the program does beside photographs, as whole processes.
pub(crate) fn others(bench: &Bench<'_>) -> Table {
    let about = "Whole processes. Pages that are checked or written again are those of samples/coffee.png on swell-a4. As \
                 WebAssembly, the process makes nine pages; *alone* is the median page of them, without the engine's start.";
    let mut table = Table::new("Other work", about, &["work", "ms", "CPU ms", "MB", "alone, ms"]);
    let ours = bench.ours;
    let page = ours.page("checked.svg");
    let made = ours.job("a page", "samples/coffee.png".as_ref(), "checked.svg", &[]);
    if let Err(fault) = run(&made, false) {
        eprintln!("other work: {fault}");
        return table;
    }
    let convert = |name: &str, picture: &str, options: &[&str]| ours.job(name, picture.as_ref(), "page.svg", options);
    let of_page = |name: &str, words: &[&str], writes: Option<&str>| {
        let words = words.iter().map(OsString::from).chain([page.clone().into_os_string()]);
        let out = writes.map(|name| ours.page(name));
        let output = out.iter().flat_map(|file| ["-o".into(), file.clone().into_os_string()]);
        let job = ours.command(name, words.chain(output));
        match &out {
            Some(file) => job.writes(file),
            None => job,
        }
    };
    let mut jobs: Vec<Job> = vec![
        convert("vector drawing, samples/chart.svg", "samples/chart.svg", &[]),
        convert("vector drawing, samples/map.svg", "samples/map.svg", &[]),
        convert("vector drawing, dense, samples/portrait.svg", "samples/portrait.svg", &[]),
        convert("page of a PDF, samples/worksheet.pdf", "samples/worksheet.pdf", &["--page", "1"]),
        convert("photograph to dots, romeo-60", "samples/chelsea.png", &["--profile", "romeo-60"]),
        of_page("check a page", &["check"], None),
        of_page("describe a page", &["describe"], None),
        of_page("render a page as PNG", &["render"], Some("rendered.png")),
        of_page("render a page as PDF", &["render"], Some("rendered.pdf")),
    ];
    jobs.extend(crate::browser::job(
        "nine pages as WebAssembly in Node.js, samples/coffee.png",
        "samples/coffee.png",
        ours,
        bench.target,
    ));
    table.rows.extend(rounds(&jobs, bench.setting(false)).iter().map(|outcome| {
        let mut cells = vec![outcome.name.clone()];
        let alone = outcome.median(|run| stage(run, "alone"));
        cells.extend([outcome.wall(), outcome.cpu(), outcome.peak(), alone].map(number));
        cells
    }));
    table
}
