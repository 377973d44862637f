//! The short table of README: a few rows of the others, in the words of somebody who makes pages.

use crate::table::{Table, value};
use crate::throughput::CALL;

/// A row: what it says, and where its figures stand.
struct Source {
    says: &'static str,
    /// Title of the table with the figures.
    table: &'static str,
    /// Cells by which the row is known there; of several such rows the last counts, which is that of most cores.
    cells: &'static [&'static str],
    /// Whether the figures are those of who stands beside, which come last in a row.
    is_peer: bool,
}

const fn ours(says: &'static str, table: &'static str, cells: &'static [&'static str]) -> Source {
    Source { says, table, cells, is_peer: false }
}

const fn theirs(says: &'static str, cells: &'static [&'static str]) -> Source {
    Source { says, table: "Beside others", cells, is_peer: true }
}

const SOURCES: [Source; 8] = [
    ours("a photograph of 12 megapixels, as JPEG", "Beside others", &["12 MP JPEG"]),
    ours("a photograph of 50 megapixels, as JPEG", "Beside others", &["50 MP JPEG"]),
    ours("a small picture of 600 x 400 pixels, as PNG", "Beside others", &["600 x 400 PNG: whole process, ms"]),
    ours("a chart, as SVG", "Other work", &["vector drawing, samples/chart.svg"]),
    ours("a page of a worksheet, as PDF", "Other work", &["page of a PDF, samples/worksheet.pdf"]),
    ours("200 photographs of 12 megapixels in one call", "Throughput", &[CALL]),
    theirs("*djpeg only reads the photograph of 12 megapixels*", &["12 MP JPEG", "djpeg -scale 1/4"]),
    theirs("*potrace traces its dark parts*", &["12 MP JPEG", "potrace (djpeg -grayscale before it)"]),
];

/// The table, made of all others.
///
/// # Errors
/// A figure was not measured, as a program was missing or failed.
pub(crate) fn table(tables: &[Table]) -> Result<Table, String> {
    let mut readme = Table::new("", "", &["what is made into a page", "seconds", "memory, MB"]);
    for source in &SOURCES {
        let [ms, memory] = source
            .figures(tables)
            .ok_or_else(|| format!("README lacks \"{}\", which was not measured", source.cells.join(", ")))?;
        readme.rows.push(vec![source.says.into(), seconds(ms), format!("{memory:.0}")]);
    }
    Ok(readme)
}

impl Source {
    /// Time, ms, and memory, MB.
    fn figures(&self, tables: &[Table]) -> Option<[f64; 2]> {
        let table = tables.iter().find(|table| table.title == self.table)?;
        let has_all = |row: &&Vec<String>| self.cells.iter().all(|cell| row.iter().any(|other| other == cell));
        let row = table.rows.iter().rfind(has_all)?;
        let figure = |name: &str| {
            let mut names = table.head.iter();
            let column =
                if self.is_peer { names.rposition(|head| head == name) } else { names.position(|head| head == name) };
            value(row.get(column?)?)
        };
        Some([figure("ms")?, figure("MB")?])
    }
}

/// With as many digits as one run deserves.
fn seconds(ms: f64) -> String {
    let seconds = ms / 1e3;
    if seconds < 9.95 { format!("{seconds:.2}") } else { format!("{seconds:.0}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tables() -> Vec<Table> {
        let table = |title: &'static str, head: &[&str], rows: &[&[&str]]| {
            let mut table = Table::new(title, "", head);
            table.rows.extend(rows.iter().map(|row| row.iter().map(|&cell| cell.to_owned()).collect::<Vec<_>>()));
            table
        };
        let beside = table(
            "Beside others",
            &["work", "ms", "MB", "beside", "ms", "MB"],
            &[
                &["12 MP JPEG", "239", "39.0", "djpeg -scale 1/4", "71.0", "4.20"],
                &["12 MP JPEG", "239", "39.0", "potrace (djpeg -grayscale before it)", "426", "76.1"],
                &["50 MP JPEG", "491", "47.1", "djpeg -scale 1/8", "215", "4.16"],
                &["600 x 400 PNG: whole process, ms", "141", "38.3", "", "-", "-"],
            ],
        );
        let other = table(
            "Other work",
            &["work", "ms", "MB", "alone, ms"],
            &[
                &["vector drawing, samples/chart.svg", "199", "61.4", "-"],
                &["page of a PDF, samples/worksheet.pdf", "159", "57.7", "-"],
            ],
        );
        let call = table(
            "Throughput",
            &["work", "cores", "ms", "MB"],
            &[&[CALL, "1", "58 thousand", "45.0"], &[CALL, "2", "26 thousand", "78.4"]],
        );
        vec![beside, other, call]
    }

    #[test]
    fn figures_are_those_of_their_rows() {
        let all = tables();
        let rows = table(&all).unwrap().rows;
        let row = |number: usize| rows[number][1..].join(" ");
        assert_eq!([row(0), row(2), row(5), row(6), row(7)], ["0.24 39", "0.14 38", "26 78", "0.07 4", "0.43 76"]);
    }

    /// The tables of a page, by these titles.
    fn written(page: &str, titles: &[&'static str]) -> Vec<Table> {
        let cells = |line: &str| -> Vec<String> {
            line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
        };
        let table = |&title: &&'static str| {
            let (_, section) = page.split_once(&format!("\n## {title}\n")).expect("the table is there");
            let mut lines = section.lines().skip_while(|line| !line.starts_with('|'));
            let head = cells(lines.next().expect("a head"));
            let head: Vec<&str> = head.iter().map(String::as_str).collect();
            let mut table = Table::new(title, "", &head);
            table.rows.extend(lines.skip(1).take_while(|line| line.starts_with('|')).map(cells));
            table
        };
        titles.iter().map(table).collect()
    }

    /// Sources are known by their words: another name of a row elsewhere would be seen only when all has been measured.
    #[test]
    fn the_rows_in_readme_are_those_of_the_tables_in_docs() {
        let page = |name: &str| std::fs::read_to_string(format!("{}/{name}", tactograph_tools::ROOT)).unwrap();
        let all = written(&page("docs/speed.md"), &["Beside others", "Other work", "Throughput"]);
        assert!(page("README.md").contains(&table(&all).unwrap().body()));
    }

    #[test]
    fn a_figure_that_was_not_measured_is_told() {
        let mut all = tables();
        all[0].rows[3][1] = "-".into();
        let fault = table(&all).err().unwrap();
        assert!(fault.contains("600 x 400 PNG"), "{fault}");
    }
}
