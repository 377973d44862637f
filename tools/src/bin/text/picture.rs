//! Scenes as pixels.

use std::error::Error;
use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Pixmap, PixmapPaint, Transform};
use tactograph_tools::ROOT;

use crate::scenes::{Ground, HEIGHT, Scene, Task, WIDTH};

/// What a scene or a step of it fails with.
pub(crate) type Fault = Box<dyn Error + Send + Sync>;

/// The fonts of the computer, found once.
pub(crate) fn fonts() -> Arc<usvg::fontdb::Database> {
    static FONTS: OnceLock<Arc<usvg::fontdb::Database>> = OnceLock::new();
    let load = || {
        let mut fonts = usvg::fontdb::Database::new();
        fonts.load_system_fonts();
        Arc::new(fonts)
    };
    FONTS.get_or_init(load).clone()
}

/// Photographs among the samples that are grounds.
const PHOTOS: [&str; 3] = ["coffee.png", "chelsea.png", "astronaut.png"];

/// Draws a scene and hands it to `of`.
pub(crate) fn with_scene<T>(task: &Task, of: impl FnOnce(&Scene<'_>) -> Result<T, Fault>) -> Result<T, Fault> {
    if task.ground != Ground::Photo {
        return of(&Scene::new(*task, None));
    }
    let photo = photo(name(task))?;
    let lightness = |at: [f64; 2]| {
        let cell = |at: f64, count: u32| (at.max(0.0) as u32).min(count - 1);
        photo.pixel(cell(at[0], WIDTH), cell(at[1], HEIGHT)).map_or(0.0, |pixel| {
            f64::from(pixel.red()) * 0.3 / 255.0
                + f64::from(pixel.green()) * 0.6 / 255.0
                + f64::from(pixel.blue()) * 0.1 / 255.0
        })
    };
    of(&Scene::new(*task, Some(&lightness)))
}

/// The photograph behind a scene.
fn name(task: &Task) -> &'static str {
    PHOTOS[task.seed as usize % PHOTOS.len()]
}

/// A scene with its things and texts, or without.
pub(crate) fn pixels(scene: &Scene<'_>, task: &Task, things: bool, texts: bool) -> Result<Pixmap, Fault> {
    let options = usvg::Options { fontdb: fonts(), ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(&scene.svg(things, texts), &options)?;
    let mut canvas = match task.ground {
        Ground::Photo => photo(name(task))?,
        Ground::Plain | Ground::Coloured => Pixmap::new(WIDTH, HEIGHT).ok_or("no canvas")?,
    };
    resvg::render(&tree, Transform::identity(), &mut canvas.as_mut());
    Ok(canvas)
}

/// A photograph that fills a scene.
fn photo(name: &str) -> Result<Pixmap, Fault> {
    let photo = Pixmap::load_png(format!("{ROOT}/samples/{name}"))?;
    let mut canvas = Pixmap::new(WIDTH, HEIGHT).ok_or("no canvas")?;
    let scale = (WIDTH as f32 / photo.width() as f32).max(HEIGHT as f32 / photo.height() as f32);
    let paint = PixmapPaint { quality: resvg::tiny_skia::FilterQuality::Bilinear, ..PixmapPaint::default() };
    canvas.draw_pixmap(0, 0, photo.as_ref(), &paint, Transform::from_scale(scale, scale), None);
    Ok(canvas)
}
