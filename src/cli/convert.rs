//! `tactograph convert`: pictures in, pages out.

use tactograph::output::svg;
use tactograph::pipeline::{self, Request};

use super::Exit;
use super::args::Convert;
use super::batch::{self, Made, Order};
use super::product::Product;

/// Converts all pictures and tells what became of each, in their order.
pub(super) fn run(args: &Convert) -> Exit {
    let order = Order {
        product: Product::Page,
        pictures: &args.pictures,
        output: args.output.as_deref(),
        out_dir: args.out_dir.as_deref(),
        shared: &args.shared,
    };
    batch::run(&order, |picture, title, common, timings| {
        let fonts = || common.fonts.get();
        let request = Request { plan: &common.plan, limits: common.limits, fonts: &fonts, title };
        let drawing = pipeline::convert(picture, &request, &mut |event| timings.watch(event))?;
        let text = timings.step("write", || svg::write(&drawing.page));
        Ok(Made { text, notes: drawing.notes })
    })
}
