//! Can a fingertip tell the colours apart? Scenes whose colours are known become pages, and the pages are felt.
#![allow(clippy::print_stdout, reason = "this is a program")]

mod density;
mod judge;
mod rng;
mod scenes;

use std::sync::Arc;

use judge::Tally;
use scenes::KINDS;
use tactograph::pipeline::Request;
use tactograph::profile::{Plan, Profile};
use tactograph::{Page, output::svg, touch::Ink};

const FINGERS: [f32; 3] = [0.5, 1.0, 1.5];

fn page_of(picture: &[u8], plan: &Plan) -> Page {
    let fonts = || Arc::new(usvg::fontdb::Database::new());
    let request = Request { plan, limits: Default::default(), fonts: &fonts, title: "scene" };
    tactograph::convert(picture, &request, &mut |_| ()).expect("a scene can be converted").page
}

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |name: &str, otherwise: u64| {
        args.iter().position(|a| a == name).and_then(|i| args.get(i + 1)?.parse().ok()).unwrap_or(otherwise)
    };
    let (from, count) = (number("--from", 0), number("--seeds", 2));
    let mut profile = Profile::named("swell-a4").expect("built in");
    for pair in args.windows(2).filter(|p| p[0] == "--set") {
        let (k, v) = pair[1].split_once('=').expect("key=value");
        profile.set(k, v).expect("a key");
    }
    if args.iter().any(|a| a == "--density") {
        let mut dense = profile.clone();
        dense.set("textures.dense_from", "0.0001").expect("a key");
        let (plan, dense) = (Plan::new(&profile).expect("ok"), Plan::new(&dense).expect("ok"));
        let mut all = [const { Vec::new() }; 5];
        for kind in [1, 2, 3, 5] {
            for seed in from..from + count {
                let scene = scenes::scene(kind, seed);
                let (page, full) = (page_of(&scene.picture, &plan), page_of(&scene.picture, &dense));
                for (pairs, class) in all.iter_mut().zip(tactograph::page::Class::ALL) {
                    pairs.extend(density::pairs(&page, &full, class));
                }
            }
        }
        for (pairs, class) in all.iter().zip(tactograph::page::Class::ALL) {
            println!("{} {} pairs, correlation {:.4}", class.name(), pairs.len(), density::correlation(pairs));
            for b in 0..10 {
                let v: Vec<f32> = pairs.iter().filter(|p| ((p.0 * 10.0) as i32).min(9) == b).map(|p| p.1).collect();
                if !v.is_empty() {
                    let m = v.iter().sum::<f32>() / v.len() as f32;
                    let s = (v.iter().map(|x| (x - m).powi(2)).sum::<f32>() / v.len() as f32).sqrt();
                    print!(" [{b} n{} {m:.2}±{s:.2}]", v.len());
                }
            }
            println!();
        }
        println!("all {:.4}", density::correlation(&all.concat()));
        return;
    }
    let only = args.windows(2).find(|p| p[0] == "--kind").map(|p| p[1].clone());
    let dir = args.windows(2).find(|p| p[0] == "--keep").map(|p| p[1].clone());
    let plan = Plan::new(&profile).expect("makes sense");
    let mut sums = vec![[Tally::default(); 3]; KINDS.len() + 1];
    for kind in 0..KINDS.len() {
        if only.as_ref().is_some_and(|only| only != KINDS[kind]) {
            continue;
        }
        for seed in from..from + count {
            let scene = scenes::scene(kind, seed);
            let page = page_of(&scene.picture, &plan);
            let text = svg::write(&page);
            if let Some(dir) = &dir {
                std::fs::write(format!("{dir}/{}-{seed}.svg", KINDS[kind]), &text).expect("written");
            }
            let ink = Ink::of(&text).expect("a page");
            for (f, finger) in FINGERS.into_iter().enumerate() {
                let felt = ink.felt(finger).expect("a finger");
                let tally = judge::judge(&scene, &page, &felt);
                sums[kind][f].add(&tally);
                for c in 0..6 {
                    let (n, ok) = tally.share(c..c + 1);
                    if n > 0 && ok < 0.95 {
                        println!(
                            "   {} {seed} finger {finger} class {c}: {n} {ok:.3} {:?}",
                            KINDS[kind], tally.felt[c]
                        );
                    }
                }
                sums[KINDS.len()][f].add(&tally);
            }
        }
    }
    for (kind, tallies) in sums.iter().enumerate() {
        let name = KINDS.get(kind).copied().unwrap_or("all");
        for (f, tally) in tallies.iter().enumerate() {
            let (n, all) = tally.share(0..5);
            let (ng, grey) = tally.share(4..5);
            let (nw, white) = tally.share(5..6);
            println!(
                "{name:8} finger {:.1}: {n:6} places {all:.4}  grey {ng:5} {grey:.4}  white {nw:5} {white:.4}   b {:.3} g {:.3} y {:.3} r {:.3}",
                FINGERS[f],
                tally.share(0..1).1,
                tally.share(1..2).1,
                tally.share(2..3).1,
                tally.share(3..4).1
            );
        }
    }
    for tally in &sums[KINDS.len()] {
        println!("{:?}", tally.felt);
    }
}
