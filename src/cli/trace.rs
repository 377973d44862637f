//! `tactograph trace`: pictures in, contours as data out.

use tactograph::internals::output::json;
use tactograph::internals::pipeline::trace::{Request, trace};

use super::Exit;
use super::args::Trace;
use super::batch::{self, Made, Order};
use super::product::Product;
use super::report::Report;

/// Traces all pictures and tells what became of each, in their order.
pub(super) fn run(args: &Trace) -> Exit {
    let subject = match args.subject() {
        Ok(subject) => subject,
        Err(what) => {
            Report::plain().usage(what);
            return Exit::Usage;
        }
    };
    let order = Order {
        product: Product::Trace,
        pictures: &args.pictures,
        output: args.output.as_deref(),
        out_dir: args.out_dir.as_deref(),
        faults: Vec::new(),
        changes: Vec::new(),
        shared: &args.shared,
        check: &|_| Vec::new(),
    };
    batch::run(&order, |picture, _, common, timings| {
        let fonts = || common.fonts.get();
        let request =
            Request { subject, thresholds: args.threshold, plan: &common.plan, limits: common.limits, fonts: &fonts };
        let traced = trace(picture, &request, &mut |event| timings.watch(event))?;
        let text = timings.step("write", || json::write(&traced.trace));
        Ok(Made { files: vec![text.into_bytes()], notes: traced.notes })
    })
}
