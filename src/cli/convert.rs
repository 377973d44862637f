//! `tactograph convert`: pictures in, pages out.

use tactograph::internals::output::{pdf, png, svg, write_dots};
use tactograph::internals::pipeline::{self, Request, sheets};
use tactograph::{Error, Page};

use super::Exit;
use super::args::{Chosen, Convert};
use super::batch::{self, Made, Order};
use super::dots;
use super::product::{DrawingFormat, Format, Product};

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
        check: &|plan| {
            let mut faults = dots::faults(chosen.format, plan, &args.embossing);
            faults.extend(args.fitting.fault(plan));
            faults
        },
    };
    batch::run(&order, |picture, title, common, timings| {
        let fonts = || common.fonts.get();
        let request =
            Request { plan: &common.plan, limits: common.limits, fonts: &fonts, title, fit: args.fitting.fit() };
        let (pages, notes): (Vec<Page>, _) = if args.fitting.is_for_several_sheets(&common.plan) {
            let request = Request { title: args.title.as_deref().unwrap_or(title), ..request };
            let drawn = sheets::convert(picture, args.fitting.sheets, &request, &mut |event| timings.watch(event))?;
            // Words of the maker's own are about the picture, which all sheets show together.
            let called = |page: Page| page.called(None, args.description());
            (drawn.pages.into_iter().map(called).collect(), drawn.notes)
        } else {
            let drawing = pipeline::convert(picture, &request, &mut |event| timings.watch(event))?;
            let of_overview = args.title.as_deref().map(pipeline::title_of_overview);
            let overview = drawing.overview.map(|page| page.called(of_overview.as_deref(), None));
            let figure = drawing.page.called(args.title.as_deref(), args.description());
            ([figure].into_iter().chain(overview).collect(), drawing.notes)
        };
        let title = args.title.as_deref().unwrap_or(title);
        let files = timings.step("write", || match (&pages[..], chosen.format) {
            (pages, Format::Dots(format)) => write_dots(title, pages, format, args.embossing.numbers()),
            ([page], Format::Drawing(format)) => write(page, format, chosen).map(|file| vec![file]),
            (pages, Format::Drawing(DrawingFormat::Pdf)) => Ok(vec![pdf::write(title, pages)]),
            (pages, Format::Drawing(format)) => pages.iter().map(|page| write(page, format, chosen)).collect(),
        })?;
        Ok(Made { files, notes })
    })
}

/// The file of one page.
///
/// # Errors
/// If a PNG would have too many pixels.
pub(super) fn write(page: &Page, format: DrawingFormat, chosen: Chosen) -> Result<Vec<u8>, Error> {
    Ok(match format {
        DrawingFormat::Svg => svg::write(page).into_bytes(),
        DrawingFormat::Pdf => pdf::write(&page.title, std::slice::from_ref(page)),
        DrawingFormat::Png => png::write(page, chosen.dpi, chosen.depth)?,
    })
}
