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
//! OUT is a folder: it gets `index.html`, and a PNG picture of each row, called as the picture is. A picture that a program
//! refuses leaves its column empty; what it said stands in `index.html`.
#![allow(clippy::print_stdout, reason = "this is a program")]

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use base64::Engine;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{self, Options, Tree};
use tactograph_tools::ROOT;
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::words::Words;

type Fault = Box<dyn Error + Send + Sync>;

/// Endings of pictures that rows are made of.
const PICTURES: [&str; 6] = ["png", "jpg", "jpeg", "webp", "gif", "svg"];
/// Blank between the parts of a row, mm.
const GAP: f32 = 6.0;
/// Width of the picture, of a figure and of an overview, mm: pages are laid side by side at the size of the sheet.
const COLUMN: f32 = 180.0;
/// Sigma of the fingertip, mm.
const FINGERTIP: f32 = 1.0;

struct Row {
    name: String,
    /// What each program said.
    said: Vec<String>,
}

fn main() -> Result<(), Fault> {
    let mut words = Words::of_program("tools/src/bin/contact_sheet.rs");
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
    std::fs::create_dir_all(to)?;
    let pictures = pictures(from)?;
    let rows: Result<Vec<Row>, Fault> =
        on_all_cores(&pictures, |picture| row(picture, &commands, to, per_mm)).into_iter().collect();
    let rows = rows?;
    std::fs::write(to.join("index.html"), index(&rows, &commands))?;
    println!("{} rows in {}", rows.len(), to.display());
    Ok(())
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

/// Makes the pages of a picture, and the PNG picture of its row.
fn row(picture: &Path, commands: &[String], to: &Path, per_mm: f32) -> Result<Row, Fault> {
    let name = picture.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folder = tempfile::tempdir()?;
    let (mut content, mut said) = (image(picture)?, Vec::new());
    let (mut across, mut down) = (COLUMN + GAP, COLUMN);
    for command in commands {
        let page = folder.path().join("page.svg");
        let mut words = command.split_whitespace();
        let output = Command::new(words.next().ok_or("an empty command")?)
            .args(words)
            .arg(picture)
            .arg("-o")
            .arg(&page)
            .arg("--force")
            .output()
            .map_err(|fault| format!("{command}: {fault}"))?;
        said.push(String::from_utf8_lossy(&output.stderr).trim().to_owned());
        if output.status.success() {
            let page = std::fs::read_to_string(&page)?;
            down = down.max(columns(&page, across, &mut content)?);
        }
        across += 2.0 * (COLUMN + GAP);
    }
    let row = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{across}\" \
         height=\"{down}\"><defs><filter id=\"finger\" filterUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" width=\"1000\" \
         height=\"1000\" color-interpolation-filters=\"sRGB\"><feGaussianBlur stdDeviation=\"{FINGERTIP}\"/></filter>\
         </defs>{content}</svg>"
    );
    draw(&row, per_mm)?.save_png(to.join(format!("{name}.png")))?;
    Ok(Row { name, said })
}

/// A picture as it is, as wide as a column.
fn image(picture: &Path) -> Result<String, Fault> {
    let bytes = std::fs::read(picture)?;
    let kind = match &bytes[..] {
        [0xff, 0xd8, ..] => "jpeg",
        [0x89, b'P', ..] => "png",
        [b'G', b'I', b'F', ..] => "gif",
        [b'R', b'I', b'F', b'F', ..] => "webp",
        _ => "svg+xml",
    };
    Ok(embedded(kind, &bytes, &format!("width=\"{COLUMN}\" height=\"{COLUMN}\" preserveAspectRatio=\"xMidYMin\"")))
}

fn embedded(kind: &str, bytes: &[u8], place: &str) -> String {
    let data = base64::engine::general_purpose::STANDARD.encode(bytes);
    format!("<image {place} xlink:href=\"data:image/{kind};base64,{data}\"/>")
}

/// Puts a page's figure and overview, sharp and blurred, from `across` on. Returns how far down they reach, mm.
fn columns(page: &str, across: f32, content: &mut String) -> Result<f32, Fault> {
    // the unit of a page is the millimetre
    let root = usvg::roxmltree::Document::parse(page)?;
    let view: Vec<f32> = numbers(root.root_element().attribute("viewBox").unwrap_or_default());
    let [_, _, width, height] = view[..] else { return Err("a page without a viewBox".into()) };
    let whole = embedded("svg+xml", page.as_bytes(), &format!("width=\"{width}\" height=\"{height}\""));
    let mut y = 0.0;
    for layer in ["figure", "overview"] {
        let of_layer = root.descendants().find(|node| node.attribute("id") == Some(layer));
        let place = numbers(of_layer.and_then(|node| node.attribute("data-box")).unwrap_or_default());
        let [left, top, wide, high] = place[..] else { continue };
        for (column, filter) in [(0.0, ""), (1.0, " filter=\"url(#finger)\"")] {
            let x = across + column * (COLUMN + GAP);
            write!(
                content,
                "<svg x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\" viewBox=\"{left} {top} {wide} {high}\"><g\
                 {filter}>{whole}</g></svg>"
            )?;
        }
        y += high + GAP;
    }
    Ok(y)
}

fn numbers(text: &str) -> Vec<f32> {
    text.split([' ', ',']).filter_map(|number| number.parse().ok()).collect()
}

fn draw(svg: &str, per_mm: f32) -> Result<Pixmap, Fault> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_system_fonts();
    let tree = Tree::from_str(svg, &Options { fontdb: Arc::new(fonts), ..Options::default() })?;
    let side = |side: f32| (side * per_mm).round().max(1.0) as u32;
    let mut canvas = Pixmap::new(side(tree.size().width()), side(tree.size().height())).ok_or("no canvas")?;
    canvas.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(per_mm, per_mm), &mut canvas.as_mut());
    Ok(canvas)
}

/// All rows, one below the other, with what the programs said.
fn index(rows: &[Row], commands: &[String]) -> String {
    let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;");
    let mut text =
        "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Contact sheet</title>\n".to_owned();
    text += "<style>img { max-width: 100%; }</style>\n<p>From the left: the picture, then figure and overview of ";
    text += &commands.iter().map(|command| escaped(command)).collect::<Vec<_>>().join("; ");
    text += ", as they are and blurred by 1 mm.</p>\n";
    for Row { name, said } in rows {
        let name = escaped(name);
        text += &format!("<h2>{name}</h2>\n<img src=\"{name}.png\" alt=\"The picture {name} and its pages\">\n");
        for (command, said) in commands.iter().zip(said).filter(|(_, said)| !said.is_empty()) {
            text += &format!("<p>{}: {}</p>\n", escaped(command), escaped(said).replace('\n', "<br>"));
        }
    }
    text + "</html>\n"
}
