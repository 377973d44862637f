//! How long the rules of a check take on full pages of four sizes, each twice the one before: near-linear means that the time
//! for a mark stays as it is.
//!
//! ```text
//! cargo bench -p tactograph-benches --bench checking
//! ```

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput};
use tactograph::internals::legibility::check;
use tactograph::internals::profile::{Plan, Profile};
use tactograph_tools::full_page;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut criterion = Criterion::default().configure_from_args();
    let limits = Plan::new(&Profile::named("swell-a4")?)?.limits();
    let mut group = criterion.benchmark_group("check");
    group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(3));
    for (name, contours, glyphs, sheet) in full_page::SIZES {
        let page = full_page::page(contours, glyphs, sheet)?;
        group.throughput(Throughput::Elements((contours + glyphs) as u64));
        group.bench_function(BenchmarkId::from_parameter(name), |b| b.iter(|| check(black_box(&page), &limits, None)));
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
