//! How long each stage takes, alone and in memory, on two samples and a made-up photograph of 3 megapixels.
//!
//! ```text
//! cargo bench -p tactograph-benches                               all of it (four minutes); tells what changed since the last time
//! cargo bench -p tactograph-benches --bench stages -- edges       one stage
//! cargo bench -p tactograph-benches --bench stages -- coffee      one picture
//! ```
//!
//! Stages have the parameters of swell-a4, and each has what those before it made. Other than in `src/pipeline/`, text in
//! the pixels stays there, lines have no outlines of regions, and the overview is drawn once, by the figure's rules;
//! regions are timed with the edges that they weight, beside edges alone. The whole program beside others is
//! `tools/src/bin/bench_all/`; what CI watches are counted instructions (`tests/instructions.sh`), since times differ.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BatchSize, BenchmarkGroup, BenchmarkId, Criterion};
use tactograph::Error;
use tactograph::internals::edges::{self, PictureKind};
use tactograph::internals::lettering::Lettering;
use tactograph::internals::output::png::{Depth, Dpi};
use tactograph::internals::output::{pdf, png as page_png, svg};
use tactograph::internals::page::Page;
use tactograph::internals::page::layout::{self, Layout};
use tactograph::internals::pipeline::{Request, convert};
use tactograph::internals::profile::{Plan, Profile};
use tactograph::internals::raster::decode::{self, DecodeOptions, Decoded, Header, Limits};
use tactograph::internals::units::{PageTransform, Size};
use tactograph::internals::{classes, lines, textures, touch};
use tactograph_tools::{ROOT, photo};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Outcome<()> {
    let mut criterion = Criterion::default().configure_from_args();
    let pictures = [
        ("coffee.png", std::fs::read(format!("{ROOT}/samples/coffee.png"))?),
        ("rocket.jpg", std::fs::read(format!("{ROOT}/samples/rocket.jpg"))?),
        ("photo-3.png", photo_png()?),
    ];
    let profile = Profile::named("swell-a4").map_err(|faults| format!("{faults:?}"))?;
    let plan = Plan::new(&profile).map_err(|faults| format!("{faults:?}"))?;
    for (name, bytes) in &pictures {
        let mut group = criterion.benchmark_group(*name);
        group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
        stages(&mut group, bytes, &plan)?;
        group.finish();
    }
    criterion.final_summary();
    Ok(())
}

/// The photograph as a file.
fn photo_png() -> Outcome<Vec<u8>> {
    let picture = photo::photo(2000, 1500);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.width as u32, picture.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.write_header()?.write_image_data(&picture.bytes())?;
    Ok(bytes)
}

fn stages(group: &mut BenchmarkGroup<'_, WallTime>, bytes: &[u8], plan: &Plan) -> Outcome<()> {
    let decoded = decode(bytes, plan)?;
    let raster = &decoded.raster;
    let layout = layout_of(decoded.source.size, plan);
    let frame = PageTransform::new(raster.size(), layout.figure);
    let px_per_mm = 1.0 / frame.mm_per_px();
    let kind = PictureKind::of_bitmap(raster, decoded.lossy);
    let contours_of = |regions| edges::find_of_kind(raster, &kind, &plan.edges(px_per_mm), regions);
    let found = contours_of(plan.region_detail());
    let drawn = lines::draw(&found, &frame, layout.figure, &plan.lines());
    let contours = found.borders();
    let sorted = classes::sort(raster, &contours, &plan.classes(px_per_mm));
    let page = page(bytes, plan)?;
    let drawing = svg::write(&page);
    let dpi = Dpi::new(150)?;

    bench(group, "decode", || decode(bytes, plan));
    bench(group, "text", || Lettering::find(raster, kind.is_drawing));
    bench(group, "edges", || contours_of(None));
    bench(group, "edges-regions", || contours_of(plan.region_detail()));
    bench(group, "lines", || lines::draw(&found, &frame, layout.figure, &plan.lines()));
    if let Some(place) = layout.overview {
        let frame = PageTransform::new(raster.size(), place);
        bench(group, "overview", || lines::draw(&found, &frame, place, &plan.lines()));
    }
    bench(group, "classes", || classes::sort(raster, &contours, &plan.classes(px_per_mm)));
    bench(group, "textures", || textures::fill(&sorted, layout.figure, &drawn.lines, &plan.textures()));
    group.bench_function(BenchmarkId::from_parameter("page"), |bencher| {
        bencher.iter_batched(|| (*page).clone(), Page::new, BatchSize::SmallInput);
    });
    bench(group, "svg", || svg::write(&page));
    bench(group, "pdf", || pdf::write(&page.title, std::slice::from_ref(&page)));
    bench(group, "png", || page_png::write(&page, dpi, Depth::Bilevel, Default::default()));
    bench(group, "feel", || touch::feel(&drawing, 1.0));
    Ok(())
}

fn bench<T>(group: &mut BenchmarkGroup<'_, WallTime>, stage: &str, mut work: impl FnMut() -> T) {
    group.bench_function(BenchmarkId::from_parameter(stage), |bencher| bencher.iter(|| black_box(work())));
}

fn layout_of(size: Size, plan: &Plan) -> Layout {
    layout::fit(size.width as f32 / size.height as f32, f32::MAX, &plan.layout())
}

/// At the working size of a page, as the pipeline asks for.
fn decode(bytes: &[u8], plan: &Plan) -> Result<Decoded, Error> {
    let working_size = |Header { size, .. }: Header| {
        let place = layout_of(size, plan).figure;
        let pixels = |mm: f32, own: u32| ((mm * plan.profile().figure.resolution).round() as u32).clamp(1, own);
        Ok(Size::new(pixels(place.width(), size.width), pixels(place.height(), size.height)))
    };
    decode::decode(bytes, &DecodeOptions::whole(&working_size))
}

/// The finished page.
fn page(bytes: &[u8], plan: &Plan) -> Result<Page, Error> {
    let (limits, fit) = (Limits::default(), Default::default());
    let request =
        Request { plan, limits, fonts: &Arc::default, title: "a picture", language: "en", fit, cancelled: &|| false };
    Ok(convert(bytes, &request, &mut |_| ())?.page)
}
