//! The pictures as files, under target/bench/inputs: made once, always the same.

use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::process::Command;

use tactograph_tools::camera_scene::Scene;
use tactograph_tools::cjpeg::cjpeg;
use tactograph_tools::photo::{self, Picture};

/// Changes whenever the pictures do; files made by another are made anew.
const EDITION: &str = "2";

/// Widths and heights of the photograph, with what they are called in megapixels.
pub(crate) const SIZES: [(&str, usize, usize); 4] =
    [("0.25", 576, 432), ("3", 2000, 1500), ("12", 4000, 3000), ("50", 8160, 6120)];

/// Colours of a photograph at full size, not at half.
pub(crate) const FULL_COLOUR: &str = "photo-12-progressive-444.jpg";
/// A drawing of few pixels, with the grain of a camera.
pub(crate) const DRAWING: &str = "drawing-0.75.png";

/// Where the pictures lie.
pub(crate) struct Inputs {
    folder: PathBuf,
}

impl Inputs {
    /// The path of a picture.
    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Makes what is not there yet. `is_quick` leaves out 50 megapixels.
    ///
    /// # Errors
    /// A program that writes pictures is missing, or the disk is full.
    pub(crate) fn make(target: &Path, is_quick: bool) -> Result<Self, String> {
        let inputs = Self { folder: target.join("bench/inputs") };
        let edition = inputs.file("edition");
        if fs::read_to_string(&edition).ok().as_deref() != Some(EDITION) {
            let _ = fs::remove_dir_all(&inputs.folder); // it may not be there
            fs::create_dir_all(&inputs.folder).map_err(|fault| told(&inputs.folder, fault))?;
            fs::write(&edition, EDITION).map_err(|fault| told(&edition, fault))?;
        }
        for (megapixels, width, height) in SIZES {
            if is_quick && megapixels == "50" {
                continue;
            }
            let name = |kind: &str| format!("photo-{megapixels}{kind}");
            let mut wanted = vec![name(".jpg"), name("-progressive.jpg")];
            if megapixels == "12" {
                wanted.extend([name(".png"), name("-16.png"), name(".webp"), name("-grey.jpg")]);
                wanted.push(FULL_COLOUR.into());
            }
            inputs.picture(&wanted, || photo::photo(width, height))?;
        }
        inputs.picture(&["white-12.jpg".into()], || photo::white(4000, 3000))?;
        inputs.picture(&["noise-3.png".into()], || photo::noise(2000, 1500))?;
        inputs.picture(&["lawn-3.jpg".into()], || photo::lawn(2000, 1500))?;
        inputs.picture(&[DRAWING.into()], drawing)?;
        Ok(inputs)
    }

    /// Writes one picture in the formats that the names ask for, if one of them is missing.
    fn picture(&self, names: &[String], paint: impl FnOnce() -> Picture) -> Result<(), String> {
        let missing: Vec<&String> = names.iter().filter(|name| !self.file(name).is_file()).collect();
        if missing.is_empty() {
            return Ok(());
        }
        eprintln!("making {}", missing.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(", "));
        let picture = paint();
        for name in missing {
            let part = self.file("part"); // a file has its name only when it is whole
            let jpeg = |options: &[&str]| cjpeg(&picture.bytes(), [picture.width, picture.height], options, &part);
            match name.as_str() {
                FULL_COLOUR => jpeg(&["-progressive", "-sample", "1x1"]),
                name if name.ends_with("-progressive.jpg") => jpeg(&["-progressive"]),
                name if name.ends_with("-grey.jpg") => jpeg(&["-grayscale"]),
                name if name.ends_with(".jpg") => jpeg(&[]),
                name if name.ends_with(".webp") => cwebp(&self.file(&name.replace(".webp", ".png")), &part),
                name => png(&picture, name.ends_with("-16.png"), &part).map_err(|fault| told(&part, fault)),
            }?;
            fs::rename(&part, self.file(name)).map_err(|fault| told(&self.file(name), fault))?;
        }
        Ok(())
    }
}

fn told(file: &Path, fault: impl std::fmt::Display) -> String {
    format!("{}: {fault}", file.display())
}

/// A scene of a camera at a quarter of its width and height: means of its pixels.
fn drawing() -> Picture {
    const SIDE: usize = 4;
    let scene = Scene::new(3);
    let pixels = scene.pixels();
    let [width, height] = scene.size.map(|side| side / SIDE);
    let mut rgb = Vec::with_capacity(3 * width * height);
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        for c in 0..3 {
            let at = |k: usize| 3 * ((SIDE * y + k / SIDE) * scene.size[0] + SIDE * x + k % SIDE) + c;
            let sum: u32 = (0..SIDE * SIDE).map(|k| u32::from(pixels[at(k)])).sum();
            // 257 takes 255 to 65535
            rgb.push((257 * sum / (SIDE * SIDE) as u32) as u16);
        }
    }
    Picture { width, height, rgb }
}

fn cwebp(from: &Path, file: &Path) -> Result<(), String> {
    let ended = Command::new("cwebp")
        .args(["-quiet", "-q", "85"])
        .arg(from)
        .arg("-o")
        .arg(file)
        .status()
        .map_err(|fault| needs("cwebp", fault))?;
    if ended.success() { Ok(()) } else { Err("cwebp could not write a picture".into()) }
}

fn needs(program: &str, fault: std::io::Error) -> String {
    format!("{program}, which makes the pictures, does not run ({fault}): run tools/src/bin/bench_all/peers.sh first")
}

fn png(picture: &Picture, deep: bool, file: &Path) -> Result<(), png::EncodingError> {
    let mut encoder =
        png::Encoder::new(BufWriter::new(File::create(file)?), picture.width as u32, picture.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(if deep { png::BitDepth::Sixteen } else { png::BitDepth::Eight });
    let mut writer = encoder.write_header()?;
    if deep {
        let bytes: Vec<u8> = picture.rgb.iter().flat_map(|sample| sample.to_be_bytes()).collect();
        writer.write_image_data(&bytes)?;
    } else {
        writer.write_image_data(&picture.bytes())?;
    }
    writer.finish()
}
