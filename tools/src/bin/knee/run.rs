//! One picture, one setting: its page as the program makes it, and how long each stage takes.

use std::sync::Arc;

use tactograph::internals::classes::Classes;
use tactograph::internals::lines::Line;
use tactograph::internals::output::svg;
use tactograph::internals::pipeline::{self, Event, Request, colours};
use tactograph::internals::profile::Plan;
use tactograph::internals::units::{MmRect, Size};

use crate::clock::Clock;
use crate::pictures::Picture;

/// The stages in their order; the last is the page, its SVG, and what lies between stages.
pub(crate) const STAGES: [&str; 9] =
    ["decode", "text", "edges", "regions", "lines", "overview", "classes", "textures", "page"];
const DECODE: usize = 0;
const PAGE: usize = STAGES.len() - 1;

/// What came of it.
pub(crate) struct Outcome {
    /// Of the picture, px.
    pub(crate) source: Size,
    pub(crate) place: MmRect,
    pub(crate) lines: Vec<Line>,
    /// The colours of the picture, once somebody has asked for them ([`classes`]).
    pub(crate) classes: Option<Classes>,
    pub(crate) svg: String,
    /// Milliseconds of each stage.
    pub(crate) times: [f64; STAGES.len()],
}

/// Makes the page of a picture. A JPEG is decoded at `eighths` of its size and handed over as pixels, or as the program
/// does.
///
/// # Errors
/// The picture cannot be made into a page.
pub(crate) fn run(picture: &Picture, plan: &Plan, eighths: Option<u32>) -> Result<Outcome, String> {
    let mut clock = Clock::start();
    let mut times = [0.0; STAGES.len()];
    let decoded = eighths.map(|eighths| decoded_at(&picture.bytes, eighths)).transpose()?;
    times[DECODE] += clock.lap();
    let pixels = decoded.map(|(size, samples)| (size, opaque(&samples)));
    let given = match &pixels {
        Some((size, pixels)) => {
            tactograph::Picture::rgba8(size.width, size.height, pixels).map_err(|fault| fault.to_string())?
        }
        None => tactograph::Picture::file(&picture.bytes),
    };
    clock.lap(); // a decoder would average its own samples
    let drawing = with_request(plan, |request| {
        pipeline::convert(given, request, &mut |event| match event {
            Event::Begin(_) => times[PAGE] += clock.lap(),
            Event::End(stage) => {
                let number = STAGES.iter().position(|name| *name == stage.name());
                times[number.unwrap_or(PAGE)] += clock.lap();
            }
            _ => {}
        })
    });
    let page = drawing.map_err(|fault| fault.to_string())?.page;
    let svg = svg::write(&page);
    times[PAGE] += clock.lap();
    let figure = &page.figure;
    Ok(Outcome { source: figure.source, place: figure.place, lines: figure.lines.clone(), classes: None, svg, times })
}

/// The colours of a picture, sorted as for its page.
///
/// # Errors
/// The picture cannot be decoded.
pub(crate) fn classes(picture: &Picture, plan: &Plan) -> Result<Option<Classes>, String> {
    let sorted = with_request(plan, |request| colours::sort(&picture.bytes, request, &mut |_| ()));
    sorted.map(|sorted| sorted.classes).map_err(|fault| fault.to_string())
}

/// Does something with a plan and nothing else that a person could ask for.
fn with_request<T>(plan: &Plan, work: impl FnOnce(&Request<'_>) -> T) -> T {
    let (limits, fit) = (Default::default(), Default::default());
    let request =
        Request { plan, limits, fonts: &Arc::default, title: "a picture", language: "en", fit, cancelled: &|| false };
    work(&request)
}

/// A JPEG of three colours at so many eighths of its size: red, green and blue, a byte each.
fn decoded_at(bytes: &[u8], eighths: u32) -> Result<(Size, Vec<u8>), String> {
    let told = |fault: jpeg_decoder::Error| fault.to_string();
    let mut decoder = jpeg_decoder::Decoder::new(bytes);
    decoder.read_info().map_err(told)?;
    let info = decoder.info().ok_or("a JPEG without a header")?;
    let side = |whole: u16| (u32::from(whole) * eighths).div_ceil(8) as u16;
    let (width, height) = decoder.scale(side(info.width), side(info.height)).map_err(told)?;
    let samples = decoder.decode().map_err(told)?;
    Ok((Size::new(width.into(), height.into()), samples))
}

/// The same pixels with their opacity.
fn opaque(samples: &[u8]) -> Vec<u8> {
    samples.chunks_exact(3).flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]).collect()
}
