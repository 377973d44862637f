//! `tactograph convert`: pictures in, pages out.

use tactograph::output::{pdf, png, svg};
use tactograph::pipeline::{self, Request};
use tactograph::{Error, Page};

use super::Exit;
use super::args::{Chosen, Convert};
use super::batch::{self, Made, Order};
use super::product::{Format, Product};

/// Converts all pictures and tells what became of each, in their order.
pub(super) fn run(args: &Convert) -> Exit {
    let (chosen, mut faults) = args.writing.choose(args.output.as_deref());
    faults.extend(args.words_for_many());
    let order = Order {
        product: Product::Page(chosen.format),
        pictures: &args.pictures,
        output: args.output.as_deref(),
        out_dir: args.out_dir.as_deref(),
        faults,
        changes: args.fitting.changes().collect(),
        shared: &args.shared,
    };
    batch::run(&order, |picture, title, common, timings| {
        let fonts = || common.fonts.get();
        let request =
            Request { plan: &common.plan, limits: common.limits, fonts: &fonts, title, fit: args.fitting.fit() };
        let drawing = pipeline::convert(picture, &request, &mut |event| timings.watch(event))?;
        let page = drawing.page.called(args.title.as_deref(), args.description());
        let file = timings.step("write", || write(&page, chosen))?;
        Ok(Made { file, notes: drawing.notes })
    })
}

/// The file of one page.
///
/// # Errors
/// If a PNG would have too many pixels.
pub(super) fn write(page: &Page, chosen: Chosen) -> Result<Vec<u8>, Error> {
    Ok(match chosen.format {
        Format::Svg => svg::write(page).into_bytes(),
        Format::Pdf => pdf::write(&page.title, std::slice::from_ref(page)),
        Format::Png => png::write(page, chosen.dpi, chosen.depth)?,
    })
}
