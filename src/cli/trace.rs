//! `tactograph trace`: pictures in, contours as data out.

use super::args::Trace;
use super::batch::{self, Input, Made, Order};
use super::product::Product;
use super::report::{Exit, Report};

/// Traces all pictures and tells what became of each, in their order.
pub(super) fn run(args: &Trace) -> Exit {
    let tracing = match args.tracing() {
        Ok(tracing) => tracing,
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
        preview: None,
        report: None,
        session: None,
        faults: Vec::new(),
        notes: Vec::new(),
        changes: Vec::new(),
        shared: &args.shared,
        check: &|_| Vec::new(),
    };
    batch::run(&order, |&Input { bytes, options, timings, .. }| {
        let traced = tactograph::trace(bytes, &tracing, options)?;
        let text = timings.step("write", || traced.trace.to_json());
        Ok(Made { files: vec![text.into_bytes()], notes: traced.notes, ..Made::default() })
    })
}
