//! Makes the picture of docs/editing.md, `docs/editing/stages.png`: a page that is corrected by hand, stage by stage as an
//! editor shows it, then as it is printed and as an embosser presses it.
//!
//! ```text
//! cargo run -p tactograph-tools --bin correction
//! cargo run -p tactograph-tools --bin correction -- DIRECTORY     the stages as SVG files there, and no picture
//! ```

use std::error::Error;
use std::path::Path;

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use tactograph::{Profile, RenderOptions, render};
use tactograph_tools::{ROOT, correction};

const PX_PER_MM: f32 = 2.4;
/// Blank between two pictures, px.
const MARGIN: u32 = 12;
const COLUMNS: usize = 2;
/// What is shown of the sheet: the figure within its frame, mm.
const PART: [f32; 4] = [17.0, 27.0, 176.0, 126.0];

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(ROOT);
    let options = tactograph::Options::new(Profile::named("swell-a4")?).picture_name("coffee.png");
    let page = tactograph::convert(&std::fs::read(root.join("samples/coffee.png"))?, &options)?.page.to_svg();
    let stages = correction::stages(&page)?;
    if let Some(directory) = std::env::args_os().nth(1) {
        for (number, stage) in stages.iter().enumerate() {
            std::fs::write(Path::new(&directory).join(format!("stage-{number}.svg")), &stage.svg)?;
        }
        return Ok(());
    }
    let last = &stages[stages.len() - 1].svg;
    let printed = render(last, &RenderOptions::new())?.page;
    let pressed = render(last, &RenderOptions::new().profile(Profile::named("index-basic-d")?))?.page;
    let mut pictures: Vec<Pixmap> = Vec::new();
    for stage in &stages[1..] {
        pictures.push(picture(&stage.svg, PART)?);
    }
    pictures.push(picture(&printed.to_svg(), PART)?);
    let place = pressed.figure.place.inflate(5.0, 5.0);
    pictures.push(picture(&pressed.to_svg(), [place.min.x, place.min.y, place.width(), place.height()])?);
    let out = root.join("docs/editing");
    std::fs::create_dir_all(&out)?;
    together(&pictures)?.save_png(out.join("stages.png"))?;
    Ok(())
}

/// A part of a sheet, as wide as the others.
fn picture(svg: &str, [left, top, width, height]: [f32; 4]) -> Result<Pixmap, Box<dyn Error>> {
    let tree = Tree::from_str(svg, &Options::default())?;
    let scale = PX_PER_MM * PART[2] / width;
    let mut picture =
        Pixmap::new((scale * width).round() as u32, (PX_PER_MM * PART[3]).max(scale * height).round() as u32)
            .ok_or("too large")?;
    picture.fill(Color::WHITE);
    let per_px = scale * 25.4 / 96.0;
    let transform = Transform::from_scale(per_px, per_px).post_translate(-scale * left, -scale * top);
    resvg::render(&tree, transform, &mut picture.as_mut());
    Ok(picture)
}

/// All pictures in rows, on grey.
fn together(pictures: &[Pixmap]) -> Result<Pixmap, Box<dyn Error>> {
    let width = pictures.iter().map(Pixmap::width).max().unwrap_or(1);
    let height = pictures.iter().map(Pixmap::height).max().unwrap_or(1);
    let rows = pictures.len().div_ceil(COLUMNS) as u32;
    let across = COLUMNS as u32 * (width + MARGIN) + MARGIN;
    let mut all = Pixmap::new(across, rows * (height + MARGIN) + MARGIN).ok_or("too large")?;
    all.fill(Color::from_rgba8(0xd8, 0xd8, 0xd8, 0xff));
    for (number, picture) in pictures.iter().enumerate() {
        let (column, row) = ((number % COLUMNS) as u32, (number / COLUMNS) as u32);
        let (x, y) = (MARGIN + column * (width + MARGIN), MARGIN + row * (height + MARGIN));
        all.draw_pixmap(x as i32, y as i32, picture.as_ref(), &Default::default(), Transform::identity(), None);
    }
    Ok(all)
}
