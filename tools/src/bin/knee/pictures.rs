//! The pictures, encoded once under target/knee.

use std::fs;
use std::path::Path;

use tactograph_tools::camera_scene::Scene;
use tactograph_tools::cjpeg::cjpeg;

/// A picture as its file.
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    pub(crate) bytes: Vec<u8>,
    /// What is drawn on it, where that is known.
    pub(crate) scene: Option<Scene>,
    /// Whether it can be decoded at a fraction of its size.
    pub(crate) is_jpeg: bool,
}

/// Files that are made here; another edition makes them anew.
const SCENES: [(&str, u32); 3] = [("scene-4:3", 3), ("scene-3:2", 4), ("scene-16:9", 5)];
const EDITION: &str = "3";
/// Width and height of the photo-like picture, px.
const PHOTO: [usize; 2] = [4000, 3000];

/// All pictures.
///
/// # Errors
/// `cjpeg` (of libjpeg-turbo) is missing, or a file cannot be read or written.
pub(crate) fn all(folder: &Path) -> Result<Vec<Picture>, String> {
    fs::create_dir_all(folder).map_err(|fault| format!("{}: {fault}", folder.display()))?;
    let made = |name: &str, size: [usize; 2], pixels: &dyn Fn() -> Vec<u8>| {
        let file = folder.join(format!("{}-{EDITION}.jpg", name.replace(':', "-")));
        if !file.is_file() {
            eprintln!("making {}", file.display());
            let part = file.with_extension("part"); // a file has its name only when it is whole
            cjpeg(&pixels(), size, &[], &part)?;
            fs::rename(&part, &file).map_err(|fault| format!("{}: {fault}", file.display()))?;
        }
        fs::read(&file).map_err(|fault| format!("{}: {fault}", file.display()))
    };
    let mut pictures = Vec::new();
    for (name, seed) in SCENES {
        let scene = Scene::new(seed);
        let bytes = made(name, scene.size, &|| scene.pixels())?;
        pictures.push(Picture { name, bytes, scene: Some(scene), is_jpeg: true });
    }
    let bytes = made("photo-12", PHOTO, &|| tactograph_tools::photo::photo(PHOTO[0], PHOTO[1]).bytes())?;
    pictures.push(Picture { name: "photo-12", bytes, scene: None, is_jpeg: true });
    for name in
        ["coffee.png", "astronaut.png", "chelsea.png", "rocket.jpg", "landscape.svg", "portrait.svg", "chart.svg"]
    {
        let bytes = fs::read(Path::new("samples").join(name)).map_err(|fault| format!("samples/{name}: {fault}"))?;
        pictures.push(Picture { name, bytes, scene: None, is_jpeg: false });
    }
    Ok(pictures)
}
