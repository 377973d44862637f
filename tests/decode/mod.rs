//! Decoding, on the pictures of `tests/pictures` (see the README there).

mod bad;
mod colours;
mod crops;
mod drawings;
mod pdf;

use std::path::{Path, PathBuf};

use tactograph::Error;
use tactograph::internals::raster::Raster;
use tactograph::internals::raster::decode::{DecodeOptions, Decoded, Header, Limits, decode};
use tactograph::internals::units::Size;

/// The scene's quarters: red, green, blue, grey.
const SCENE: [[u8; 3]; 4] = [[200, 40, 40], [40, 160, 60], [40, 60, 200], [128, 128, 128]];

const SIZE: Size = Size::new(64, 32);

/// A step of an 8-bit sample is at most this much light.
const STEP: f32 = 0.009;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pictures")
}

fn read(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

fn decode_to(bytes: &[u8], working_size: &dyn Fn(Header) -> Result<Size, Error>) -> Result<Decoded, Error> {
    decode(bytes, &DecodeOptions::whole(working_size))
}

/// At the size of the source.
fn whole(bytes: &[u8]) -> Result<Decoded, Error> {
    decode_to(bytes, &|source| Ok(source.size))
}

fn open(name: &str) -> Decoded {
    whole(&read(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

fn fault(bytes: &[u8]) -> String {
    match whole(bytes) {
        Ok(_) => panic!("this should not be read"),
        Err(fault) => fault.to_string(),
    }
}

fn linear(sample: f32) -> f32 {
    let value = sample / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

fn light(colour: [u8; 3]) -> [f32; 3] {
    colour.map(|sample| linear(sample.into()))
}

/// Grey as the test pictures have it: rounded luma of the scene.
fn grey(colour: [u8; 3]) -> f32 {
    let [r, g, b] = colour.map(f32::from);
    (0.299 * r + 0.587 * g + 0.114 * b).round()
}

/// The values in the middle of the quarters.
fn quarters(raster: &Raster) -> [Vec<f32>; 4] {
    let Size { width, height } = raster.size();
    [(1, 1), (3, 1), (1, 3), (3, 3)].map(|(x, y)| {
        let at = (height * y / 4 * width + width * x / 4) as usize;
        raster.planes().iter().map(|plane| plane[at]).collect()
    })
}

fn check(name: &str, raster: &Raster, wanted: [Vec<f32>; 4], tolerance: f32) {
    for (quarter, (got, want)) in quarters(raster).iter().zip(&wanted).enumerate() {
        assert_eq!(got.len(), want.len(), "{name}: planes");
        let near = got.iter().zip(want).all(|(a, b)| (a - b).abs() <= tolerance);
        assert!(near, "{name}, quarter {quarter}: got {got:?}, want {want:?}");
    }
}

fn scene() -> [Vec<f32>; 4] {
    SCENE.map(|colour| light(colour).to_vec())
}
