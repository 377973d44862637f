//! Makes the pictures of the README, `docs/readme/*.png`: a sample on the left, the page that the library makes of it on
//! the right; and the calibration sheet.
//!
//! ```text
//! cargo run --release -p tactograph-tools --bin readme_pictures
//! ```

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use tactograph::internals::output::svg;
use tactograph::internals::pipeline::{Request, convert};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::decode::Limits;

/// Samples with their size in pixels on the left, the profile of the page on the right, and the picture's name.
const SAMPLES: &[(&str, [f32; 2], &str, &str)] = &[
    ("coffee.png", [540.0, 360.0], "swell-a4", "coffee.png"),
    ("landscape.svg", [540.0, 405.0], "swell-a4", "landscape.png"),
    ("coffee.png", [540.0, 360.0], "index-basic-d", "dots.png"),
];

/// Pixels per millimetre of the page: the thinnest line is then still over two pixels wide.
const PX_PER_MM: f32 = 3.2;
/// Pixels around picture and page.
const MARGIN: f32 = 24.0;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(tactograph_tools::ROOT);
    let (samples, out) = (root.join("samples"), root.join("docs/readme"));
    std::fs::create_dir_all(&out)?;
    for &(name, size, profile, to) in SAMPLES {
        let page = Tree::from_str(&page_of(&samples.join(name), name, profile)?, &Options::default())?;
        let picture = picture(&samples, name, size)?;
        side_by_side(&picture, &page)?.save_png(out.join(to))?;
    }
    let sheets = tactograph::internals::calibration::sheets(&plan("swell-a4")?)?;
    let first = sheets.first().ok_or("no calibration sheet")?;
    let first = Tree::from_str(&svg::write(first), &Options::default())?;
    on_grey(&first)?.save_png(out.join("calibration.png"))?;
    Ok(())
}

fn plan(name: &str) -> Result<Plan, Box<dyn Error>> {
    let profile = Profile::named(name).map_err(|faults| format!("{faults:?}"))?;
    Ok(Plan::new(&profile).map_err(|faults| format!("{faults:?}"))?)
}

/// The page of a sample, as `tactograph convert` makes it.
fn page_of(file: &Path, title: &str, profile: &str) -> Result<String, Box<dyn Error>> {
    let plan = plan(profile)?;
    // None of these samples has text.
    let request = Request {
        plan: &plan,
        limits: Limits::default(),
        fonts: &Arc::default,
        title,
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    Ok(svg::write(&convert(&std::fs::read(file)?, &request, &mut |_| ())?.page))
}

/// The sample itself; resvg reads all the formats that the samples have.
fn picture(folder: &Path, name: &str, [width, height]: [f32; 2]) -> Result<Tree, Box<dyn Error>> {
    let options = Options { resources_dir: Some(folder.into()), ..Options::default() };
    let text = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">
             <image href="{name}" width="{width}" height="{height}"/>
           </svg>"#
    );
    Ok(Tree::from_str(&text, &options)?)
}

/// A sheet alone, on grey as in [`side_by_side`].
fn on_grey(page: &Tree) -> Result<Pixmap, Box<dyn Error>> {
    let scale = PX_PER_MM * 25.4 / 96.0;
    let [width, height] = [page.size().width(), page.size().height()].map(|side| (side * scale + 2.0 * MARGIN).ceil());
    let mut all = Pixmap::new(width as u32, height as u32).ok_or("too large")?;
    all.fill(Color::from_rgba8(0xd8, 0xd8, 0xd8, 0xff));
    let mut sheet = Pixmap::new((width - 2.0 * MARGIN) as u32, (height - 2.0 * MARGIN) as u32).ok_or("too large")?;
    sheet.fill(Color::WHITE);
    resvg::render(page, Transform::from_scale(scale, scale), &mut sheet.as_mut());
    let (at, paint) = (MARGIN as i32, Default::default());
    all.draw_pixmap(at, at, sheet.as_ref(), &paint, Transform::identity(), None);
    Ok(all)
}

/// Both on grey, so that the white sheet is seen to its edge.
fn side_by_side(picture: &Tree, page: &Tree) -> Result<Pixmap, Box<dyn Error>> {
    let scale = PX_PER_MM * 25.4 / 96.0;
    let [sheet_width, sheet_height] = [page.size().width() * scale, page.size().height() * scale];
    let width = 3.0 * MARGIN + picture.size().width() + sheet_width;
    let height = 2.0 * MARGIN + sheet_height.max(picture.size().height());
    let mut both = Pixmap::new(width.ceil() as u32, height.ceil() as u32).ok_or("too large")?;
    both.fill(Color::from_rgba8(0xd8, 0xd8, 0xd8, 0xff));
    let top = ((height - picture.size().height()) / 2.0).round();
    resvg::render(picture, Transform::from_translate(MARGIN, top), &mut both.as_mut());

    let mut sheet = Pixmap::new(sheet_width.round() as u32, sheet_height.round() as u32).ok_or("too large")?;
    sheet.fill(Color::WHITE);
    resvg::render(page, Transform::from_scale(scale, scale), &mut sheet.as_mut());
    let left = (2.0 * MARGIN + picture.size().width()) as i32;
    both.draw_pixmap(left, MARGIN as i32, sheet.as_ref(), &Default::default(), Transform::identity(), None);
    Ok(both)
}
