//! A picture in its five classes.

use std::error::Error;
use std::sync::Arc;

use resvg::tiny_skia::{Color, Pixmap, PremultipliedColorU8};
use tactograph::internals::classes::{Class, Classes};
use tactograph::internals::pipeline::{Event, Request, Stage, colours};
use tactograph::internals::profile::{Plan, Profile};

/// Pixels of a cell.
const CELL: u32 = 6;

pub(super) fn draw(picture: &str, out: &str, settings: &[&str]) -> Result<(), Box<dyn Error>> {
    let mut profile = Profile::named("swell-a4").map_err(|faults| format!("{faults:?}"))?;
    for setting in settings {
        let (key, value) = setting.split_once('=').ok_or("settings are KEY=VALUE")?;
        profile.set(key, value).map_err(|fault| fault.to_string())?;
    }
    let plan = Plan::new(&profile).map_err(|faults| format!("{faults:?}"))?;
    let request = Request {
        plan: &plan,
        limits: Default::default(),
        fonts: &Arc::default,
        title: picture,
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    let mut begun = std::time::Instant::now();
    let sorted = colours::sort(&std::fs::read(picture)?, &request, &mut |event| match event {
        Event::Begin(_) => begun = std::time::Instant::now(),
        Event::End(Stage::Classes) => println!("classes in {:.1} ms", 1e3 * begun.elapsed().as_secs_f64()),
        _ => (),
    })?;
    let classes = sorted.classes.ok_or("the profile wants no textures")?;
    for region in &classes.regions {
        println!("{} of {} cells, mean colour {:?}", region.class.name(), region.cells, region.colour);
    }
    paint(&classes).ok_or("the picture is too large")?.save_png(out)?;
    Ok(())
}

fn paint(classes: &Classes) -> Option<Pixmap> {
    let mut map = Pixmap::new(CELL * classes.size.width, CELL * classes.size.height)?;
    map.fill(Color::WHITE);
    let width = map.width();
    let region = |x: u32, y: u32| {
        let inside = x < classes.size.width && y < classes.size.height;
        inside.then(|| classes.region[(y * classes.size.width + x) as usize]).flatten()
    };
    for (i, pixel) in map.pixels_mut().iter_mut().enumerate() {
        let (x, y) = (i as u32 % width, i as u32 / width);
        let (column, row) = (x / CELL, y / CELL);
        let cell = (row * classes.size.width + column) as usize;
        let Some(number) = region(column, row) else { continue };
        let fringe = classes.fringe.get(cell).copied().flatten().filter(|_| (x + y) / 4 % 3 == 0);
        let [r, g, b] = colour(fringe.unwrap_or(classes.regions[number as usize].class));
        let light = classes.lightness.values[cell].clamp(0.0, 1.0);
        let border = (x % CELL == CELL - 1 && region(column + 1, row) != Some(number))
            || (y % CELL == CELL - 1 && region(column, row + 1) != Some(number));
        let shade = |channel: u8| {
            if border { 0 } else { (255.0 - (255.0 - f32::from(channel)) * (1.3 - light).min(1.0)) as u8 }
        };
        *pixel = PremultipliedColorU8::from_rgba(shade(r), shade(g), shade(b), 255)?;
    }
    Some(map)
}

fn colour(class: Class) -> [u8; 3] {
    match class {
        Class::Blue => [30, 80, 255],
        Class::Green => [0, 150, 40],
        Class::Yellow => [240, 200, 0],
        Class::Red => [225, 30, 40],
        Class::Grey => [90, 90, 90],
    }
}
