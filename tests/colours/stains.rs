//! How far the blur stains areas with their neighbours' colours or with outlines.

use tactograph::classes::{self, Params};
use tactograph::units::PxPoint;

use crate::scenes::{self, PX_PER_MM, Scene, Style};

const STYLES: [Style; 6] = [
    Style { name: "no outline", outline: 0.0, ink: 0.0, softness: 0.5, noise: 0.0 },
    Style { name: "black 0.6 mm", outline: 0.6, ink: 0.0, softness: 0.5, noise: 0.0 },
    Style { name: "black 1.5 mm", outline: 1.5, ink: 0.0, softness: 0.5, noise: 0.0 },
    Style { name: "white 1.0 mm", outline: 1.0, ink: 1.0, softness: 0.5, noise: 0.0 },
    Style { name: "soft", outline: 0.0, ink: 0.0, softness: 2.0, noise: 0.0 },
    Style { name: "grainy", outline: 0.0, ink: 0.0, softness: 0.7, noise: 0.05 },
];

/// Share of the pixels off outlines that have their own area's class.
fn own(scene: &Scene, contours: &[Vec<PxPoint>], params: &Params) -> f32 {
    let sorted = classes::sort(&scene.raster, contours, params);
    let found = scenes::by_pixel(&sorted, scene.raster.size());
    let inside = scene.area.iter().zip(found).filter_map(|(area, found)| Some((scene.classes[(*area)?], found)));
    let (all, right) =
        inside.fold((0, 0), |(all, right), (want, found)| (all + 1, right + u32::from(found == Some(want))));
    right as f32 / all as f32
}

#[test]
fn the_blur_does_not_stain() {
    let full = scenes::params();
    let raw = Params { smoothing: 0.0, min_area: 0.0, ..full };
    let beside = |mm: f32| Params { beside: mm * PX_PER_MM, ..raw };
    let variants: Vec<(&str, bool, Params)> = vec![
        ("plain", false, raw),
        ("plain, smooth", false, Params { min_area: 0.0, ..full }),
        ("shut", true, beside(0.0)),
        ("shut 0.3", true, beside(0.3)),
        ("shut 0.6", true, beside(0.6)),
        ("shut 0.9", true, beside(0.9)),
        ("shut 1.2", true, beside(1.2)),
        ("shut 0.6 smooth 1", true, Params { smoothing: 5.0, ..beside(0.6) }),
        ("shut 0.6 smooth 1.5", true, Params { smoothing: 7.5, ..beside(0.6) }),
        ("shut 0.6 smooth 2", true, Params { smoothing: 10.0, ..beside(0.6) }),
        ("shut 0.9 smooth 2", true, Params { smoothing: 10.0, ..beside(0.9) }),
        ("shut 0.6 smooth 3", true, Params { smoothing: 15.0, ..beside(0.6) }),
        ("default", true, full),
        ("default, plain", false, full),
    ];
    let mut table = vec![[0.0_f32; STYLES.len()]; variants.len()];
    let seeds = 1..=4;
    let count = seeds.clone().count() as f32;
    for (column, style) in STYLES.iter().enumerate() {
        for seed in seeds.clone() {
            let scene = scenes::voronoi(seed, 12, *style);
            let contours = scenes::contours(&scene.raster);
            for (row, (_, line_aware, params)) in variants.iter().enumerate() {
                let contours = if *line_aware { &contours[..] } else { &[] };
                table[row][column] += own(&scene, contours, params) / count;
            }
        }
    }
    println!("{:>22}  {}", "", STYLES.map(|style| format!("{:>13}", style.name)).join(" "));
    for ((name, ..), row) in variants.iter().zip(&table) {
        println!("{name:>22}  {}", row.map(|share| format!("{share:>13.4}")).join(" "));
    }
}
