//! The same page, to the byte, whatever the number of cores.

use std::sync::Arc;

use rayon::ThreadPoolBuilder;
use tactograph::internals::output::svg;
use tactograph::internals::pipeline::{Request, convert};
use tactograph::internals::profile::Plan;

use crate::common::families;

fn page(picture: &[u8], plan: &Plan) -> String {
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request {
        plan,
        limits: Default::default(),
        fonts: &fonts,
        title: "threads",
        language: "en",
        fit: Default::default(),
        cancelled: &|| false,
    };
    svg::write(&convert(picture, &request, &mut |_| ()).expect("a sample can be converted").page)
}

#[test]
fn any_number_of_threads_makes_the_same_page_again_and_again() {
    // a photograph that fills many bands, one in rows of blocks, and a drawing; with the other families the drawing
    const ALL: &[&str] = &["samples/coffee.png", "samples/rocket.jpg", "samples/chart.svg"];
    let profiles = [(families::DEFAULT, ALL), ("index-everest-d", ALL)];
    let others = families::DOTS.map(|profile| (profile, &ALL[2..]));
    for (name, samples) in profiles.into_iter().chain(others) {
        let plan = families::plan(name);
        for sample in samples {
            let picture = std::fs::read(sample).expect("the sample is there");
            let on = |threads: usize| {
                let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be had");
                pool.install(|| page(&picture, &plan))
            };
            let alone = on(1);
            assert!(alone.contains("<path"), "{sample} has no lines");
            for threads in [1, 2, 3, 8] {
                assert!(on(threads) == alone, "{sample}, {name}: {threads} threads make another page");
            }
        }
    }
}
