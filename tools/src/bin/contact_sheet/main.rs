//! A contact sheet of pages: what do pictures look like as tactile graphics, and what does a change of the program do to
//! them? Each picture is a row: itself, then for each program its figure and its overview, as they are and blurred by a
//! fingertip (sigma 1 mm).
//!
//! ```text
//! cargo run -p tactograph-tools --bin contact_sheet -- FOLDER OUT
//!   --with COMMAND     how pages are made; several for columns side by side, such as an older program, or other options:
//!                      --with 'old/tactograph convert' --with 'new/tactograph convert --detail 0.2'
//!                      (default: target/debug/tactograph convert); words are divided at blanks
//!   --per-mm N         pixels for a millimetre of the sheet (default 2)
//! ```
//!
//! The programs are run, not built. OUT is a folder: it gets `index.html`, and a PNG picture of each row, called as the
//! picture is, with `.png` behind. Where a program writes several pages, such as figure and overview of a pin display,
//! these are below one another. What a program said, why its column is empty, and why a row has no picture stands in
//! `index.html`; the other rows go on.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod pages;
mod row;

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use pages::Made;
use tactograph_tools::ROOT;
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::words::Words;

type Fault = Box<dyn Error + Send + Sync>;

/// Endings of pictures that rows are made of.
const PICTURES: [&str; 6] = ["png", "jpg", "jpeg", "webp", "gif", "svg"];

struct Row {
    /// The name of the picture's file.
    name: String,
    /// What each program made of it.
    made: Vec<Made>,
    /// Whether the picture of the row was written.
    drawn: Result<(), Fault>,
}

impl Row {
    fn is_whole(&self) -> bool {
        self.drawn.is_ok() && self.made.iter().all(|made| made.pages.is_ok())
    }
}

fn main() -> Result<(), Fault> {
    let mut words = Words::of_program("tools/src/bin/contact_sheet/main.rs");
    let (mut folders, mut commands, mut per_mm) = (Vec::<PathBuf>::new(), Vec::<String>::new(), 2.0_f32);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--with" => commands.push(words.value(&word)?),
            "--per-mm" => per_mm = words.number(&word)?,
            _ if word.starts_with('-') => return Err(words.unknown(&word).into()),
            _ => folders.push(word.into()),
        }
    }
    let [from, to] = &folders[..] else { return Err("give the folder of the pictures, and one for the sheet".into()) };
    if commands.is_empty() {
        commands.push(format!("{ROOT}/target/debug/tactograph convert"));
    }
    let rows = sheet(from, to, &commands, per_mm)?;
    println!("{} rows in {}", rows.len(), to.display());
    let partial = rows.iter().filter(|row| !row.is_whole()).count();
    if partial > 0 {
        println!("{partial} of them lack something: index.html says what, and why");
    }
    Ok(())
}

/// Makes the sheet of the pictures of a folder in another one.
fn sheet(from: &Path, to: &Path, commands: &[String], per_mm: f32) -> Result<Vec<Row>, Fault> {
    std::fs::create_dir_all(to)?;
    let pictures = pictures(from)?;
    let of_picture =
        |picture: &PathBuf| -> Vec<Made> { commands.iter().map(|command| pages::made(picture, command)).collect() };
    let made = on_all_cores(&pictures, of_picture);
    let widths = widths(&made, commands.len());
    let pictures: Vec<(PathBuf, Vec<Made>)> = pictures.into_iter().zip(made).collect();
    let drawn = on_all_cores(&pictures, |(picture, made)| -> Result<(), Fault> {
        let file = to.join(format!("{}.png", name(picture)));
        Ok(row::draw(picture, made, &widths, per_mm)?.save_png(file)?)
    });
    let row = |((picture, made), drawn): ((PathBuf, Vec<Made>), _)| Row { name: name(&picture), made, drawn };
    let rows: Vec<Row> = pictures.into_iter().zip(drawn).map(row).collect();
    std::fs::write(to.join("index.html"), index(&rows, commands))?;
    Ok(rows)
}

/// The pictures of a folder, in the order of their names.
fn pictures(folder: &Path) -> Result<Vec<PathBuf>, Fault> {
    let paths = std::fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut paths: Vec<PathBuf> = paths.collect::<Result<_, _>>()?;
    let ending = |path: &PathBuf| path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    paths.retain(|path| ending(path).is_some_and(|ending| PICTURES.contains(&ending.as_str())));
    paths.sort();
    Ok(paths)
}

/// The name of a file with its ending: `a.png` and `a.jpg` are two pictures.
fn name(picture: &Path) -> String {
    picture.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// How wide the columns of each program are, mm: as its widest figure or overview of all rows, so that none lies on its
/// neighbour and all rows have one scale.
fn widths(made: &[Vec<Made>], commands: usize) -> Vec<f32> {
    let of_command = |command: usize| {
        let pages = made.iter().filter_map(|made| made[command].pages.as_ref().ok()).flatten();
        pages.flat_map(|page| &page.parts).map(|[_, _, wide, _]| *wide).fold(0.0, f32::max)
    };
    (0..commands).map(of_command).collect()
}

/// All rows, one below the other, with what the programs said.
fn index(rows: &[Row], commands: &[String]) -> String {
    let mut text =
        "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Contact sheet</title>\n".to_owned();
    text += "<style>img { max-width: 100%; }</style>\n<p>From the left: the picture, then figure and overview of ";
    text += &commands.iter().map(|command| escaped(command)).collect::<Vec<_>>().join("; ");
    text += ", as they are and blurred by 1 mm.</p>\n";
    for Row { name, made, drawn } in rows {
        let file = in_address(&format!("{name}.png"));
        let name = escaped(name);
        text += &match drawn {
            Ok(()) => format!("<h2>{name}</h2>\n<img src=\"{file}\" alt=\"The picture {name} and its pages\">\n"),
            Err(fault) => format!("<h2>{name}</h2>\n<p>No picture of this row: {}</p>\n", escaped(&fault.to_string())),
        };
        for (command, made) in commands.iter().zip(made) {
            let fault = made.pages.as_ref().err().map(|fault| format!("No page: {fault}"));
            for said in [made.said.clone(), fault.unwrap_or_default()].into_iter().filter(|said| !said.is_empty()) {
                text += &format!("<p>{}: {}</p>\n", escaped(command), escaped(&said).replace('\n', "<br>"));
            }
        }
    }
    text + "</html>\n"
}

/// A text as it stands in HTML, also between quotes.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The name of a file as it stands in an address: all but letters, digits and four signs in percents (RFC 3986).
fn in_address(name: &str) -> String {
    let mut address = String::new();
    for byte in name.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            address.push(char::from(byte));
        } else {
            // Writing to a String cannot fail.
            let _ = write!(address, "%{byte:02X}");
        }
    }
    address
}

#[cfg(test)]
mod tests;
