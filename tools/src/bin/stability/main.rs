//! How much does a page change when its picture changes a little? Puts in a small change, and measures what comes out.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin stability            the table of docs/stability.md, and its plot
//!   --pictures FILE... instead: these pictures (PNG, JPEG, SVG)
//!   --keep DIR         also writes every page into a folder
//!   --changes NAME,... only these changes, by their names in the table, such as 1/255,+1
//! ```
//!
//! **Lines** is the share of the length of all lines of one figure without a line within 1 mm in the other, the mean of
//! both ways: lost and gained. **Textures** is the same of glyphs without one of their class within 4 mm, which is more
//! than the distance of rows. Both figures are laid on one another and are about 150 mm wide. **Amplification** is the
//! share of lines by the relative change that was put in: the root mean square of the change of samples, or the change
//! of a side.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod picture;
mod plot;
mod scenes;

use std::path::{Path, PathBuf};

use picture::{Change, Fault, Picture};
use tactograph::{Class, Drawing, Options, Profile};
use tactograph_tools::ROOT;
use tactograph_tools::cores::on_all_cores;
use tactograph_tools::drawn::{Point, lines_of, share_within};
use tactograph_tools::words::Words;

/// Width of figures, mm; narrower where the sheet wants it.
const WIDTH: f32 = 150.0;
/// A line is where it was when it is this near, mm.
const NEAR: f64 = 1.0;
/// A glyph is where it was when one of its class is this near, mm.
const NEAR_GLYPH: f64 = 4.0;

/// What a picture is, for the rows of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Drawing,
    Photograph,
    Scene,
}

/// What became of a change.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Changed {
    pub(crate) lines: f64,
    textures: f64,
    amplification: f64,
}

struct Row {
    name: String,
    kind: Kind,
    changes: Vec<Changed>,
}

fn main() -> Result<(), Fault> {
    let mut words = Words::of_program("tools/src/bin/stability/main.rs");
    let (mut files, mut keep, mut wanted) = (Vec::new(), None::<PathBuf>, Change::ALL.to_vec());
    while let Some(word) = words.next() {
        match word.as_str() {
            "--keep" => keep = Some(words.value(&word)?.into()),
            "--changes" => wanted = only(&words.value(&word)?)?,
            "--pictures" => files.extend(words.by_ref().map(PathBuf::from)),
            _ => return Err(words.unknown(&word).into()),
        }
    }
    let is_of_docs = files.is_empty();
    let mut tasks = Vec::new();
    if is_of_docs {
        files = samples()?;
    }
    for path in &files {
        let picture = Picture::open(&std::fs::read(path)?).map_err(|fault| format!("{}: {fault}", path.display()))?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_drawing = path.extension().is_some_and(|ending| ending == "svg");
        tasks.push((name, if is_drawing { Kind::Drawing } else { Kind::Photograph }, picture));
    }
    if is_of_docs {
        tasks.extend(scenes::all()?.into_iter().map(|(name, picture)| (name.to_owned(), Kind::Scene, picture)));
    }
    let rows: Result<Vec<Row>, Fault> = on_all_cores(&tasks, |(name, kind, picture)| {
        let changes = changes(name, picture, &wanted, keep.as_deref())?;
        Ok(Row { name: name.clone(), kind: *kind, changes })
    })
    .into_iter()
    .collect();
    let rows = rows?;
    println!(
        "{}\n{}\n{}",
        table(&rows, &wanted, "lines", |c| c.lines),
        table(&rows, &wanted, "textures", |c| c.textures),
        { table(&rows, &wanted, "amplification", |c| c.amplification) }
    );
    if is_of_docs && wanted == Change::ALL {
        let names: Vec<String> = Change::ALL.iter().map(|change| change.name()).collect();
        let rows: Vec<(&str, &[Changed])> = rows.iter().map(|row| (row.name.as_str(), &row.changes[..])).collect();
        std::fs::write(format!("{ROOT}/docs/stability.svg"), plot::plot(&names, &rows))?;
    }
    Ok(())
}

/// The samples that are pictures of one page.
fn samples() -> Result<Vec<PathBuf>, Fault> {
    let entries = std::fs::read_dir(format!("{ROOT}/samples"))?;
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>()?;
    let is_picture =
        |path: &PathBuf| path.extension().is_some_and(|ending| ["png", "jpg", "svg"].iter().any(|e| ending == *e));
    paths.retain(|path| is_picture(path) && !path.ends_with("empty.png"));
    paths.sort();
    Ok(paths)
}

/// The changes of these names, or whose names begin so.
fn only(names: &str) -> Result<Vec<Change>, Fault> {
    let named = |name: &str| {
        let found = Change::ALL.into_iter().find(|change| change.name().starts_with(name));
        found.ok_or_else(|| format!("no change is called {name}").into())
    };
    names.split(',').map(named).collect()
}

fn changes(name: &str, picture: &Picture, wanted: &[Change], keep: Option<&Path>) -> Result<Vec<Changed>, Fault> {
    // as wide as can be, but for the millimetre that is added
    let profile = Profile::named("swell-a4")?;
    let fits = tactograph::convert(&picture.png()?, &Options::new(profile.clone()))?.page.figure.place.width();
    let width = WIDTH.min((fits - 2.0).floor());
    let convert = |picture: &Picture, wider: f32| -> Result<Drawing, Fault> {
        Ok(tactograph::convert(&picture.png()?, &Options::new(profile.clone()).width_mm(width + wider))?)
    };
    let before = convert(picture, 0.0)?;
    let mut all = Vec::new();
    for &change in wanted {
        let changed = change.of(picture)?;
        let wider = if let Change::Wider(mm) = change { mm } else { 0.0 };
        let after = convert(&changed, wider)?;
        if let Some(folder) = keep {
            std::fs::create_dir_all(folder)?;
            let file = format!("{name} {}.svg", change.name()).replace([' ', '/', '%'], "-");
            std::fs::write(folder.join(file), after.page.to_svg())?;
            std::fs::write(folder.join(format!("{name}.svg").replace(' ', "-")), before.page.to_svg())?;
        }
        let put_in = match change {
            Change::Resize(times) => f64::from((times - 1.0).abs()),
            Change::Wider(mm) => f64::from(mm / width),
            Change::Shift(px) => f64::from(px) / picture.width as f64,
            _ => picture.difference(&changed).ok_or("a change of size")?,
        };
        let (these, those) = (Laid::of(&before), Laid::of(&after));
        let lines = 0.5 * (these.lines_missing_in(&those) + those.lines_missing_in(&these));
        let textures = 0.5 * (these.glyphs_missing_in(&those) + those.glyphs_missing_in(&these));
        all.push(Changed { lines, textures, amplification: lines / put_in.max(1e-9) });
    }
    Ok(all)
}

/// A figure laid on a rectangle of [`WIDTH`].
struct Laid {
    lines: Vec<Vec<Point>>,
    glyphs: Vec<(Class, Point)>,
}

impl Laid {
    fn of(drawing: &Drawing) -> Self {
        let place = drawing.page.figure.place;
        let scale = f64::from(WIDTH / place.width());
        let laid = |at: Point| [scale * (at[0] - f64::from(place.min.x)), scale * (at[1] - f64::from(place.min.y))];
        let lines = lines_of(&drawing.page).into_iter().map(|line| line.into_iter().map(laid).collect()).collect();
        let of_texture = |texture: &tactograph::marks::Texture| -> Vec<(Class, Point)> {
            texture
                .glyphs
                .iter()
                .map(|glyph| (texture.class, laid([f64::from(glyph.at.x), f64::from(glyph.at.y)])))
                .collect()
        };
        Self { lines, glyphs: drawing.page.figure.textures.iter().flat_map(of_texture).collect() }
    }

    fn lines_missing_in(&self, other: &Self) -> f64 {
        share_within(&self.lines, &other.lines, NEAR).map_or(0.0, |near| 1.0 - near)
    }

    fn glyphs_missing_in(&self, other: &Self) -> f64 {
        let is_there = |(class, at): &&(Class, Point)| {
            let is_near = |to: &Point| (to[0] - at[0]).hypot(to[1] - at[1]) <= NEAR_GLYPH;
            other.glyphs.iter().any(|(of, to)| of == class && is_near(to))
        };
        let missing = self.glyphs.iter().filter(|glyph| !is_there(glyph)).count();
        missing as f64 / self.glyphs.len().max(1) as f64
    }
}

fn table(rows: &[Row], wanted: &[Change], what: &str, value: impl Fn(&Changed) -> f64) -> String {
    let mut text = format!("| {what} |");
    wanted.iter().for_each(|change| text += &format!(" {} |", change.name()));
    text += "\n|---|";
    text += &"---|".repeat(wanted.len());
    text += "\n";
    let mut line = |name: &str, values: Vec<f64>| {
        text += &format!("| {name} |");
        values.iter().for_each(|value| {
            text += &if what == "amplification" { format!(" {value:.2} |") } else { format!(" {value:.3} |") }
        });
        text += "\n";
    };
    for (kind, name) in [(Kind::Drawing, "drawings"), (Kind::Photograph, "photographs"), (Kind::Scene, "scenes")] {
        let of_kind: Vec<&Row> = rows.iter().filter(|row| row.kind == kind).collect();
        for row in &of_kind {
            line(&row.name, row.changes.iter().map(&value).collect());
        }
        if of_kind.is_empty() {
            continue;
        }
        let column = |i: usize| -> Vec<f64> {
            let mut values: Vec<f64> = of_kind.iter().map(|row| value(&row.changes[i])).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        let columns = 0..wanted.len();
        line(&format!("**{name}, median**"), columns.clone().map(|i| column(i)[of_kind.len() / 2]).collect());
        line(&format!("**{name}, worst**"), columns.map(|i| column(i)[of_kind.len() - 1]).collect());
    }
    text
}
