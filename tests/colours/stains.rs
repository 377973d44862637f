//! How far the blur stains areas with their neighbours' colours or with outlines.

use tactograph::internals::classes::{self, Params};
use tactograph::internals::geom::polyline::Polyline;
use tactograph::internals::units::PxPoint;

use crate::colours::scenes::{self, PX_PER_MM, Scene, Style};

const STYLES: [Style; 6] = [
    Style { name: "no outline", outline: 0.0, ink: 0.0, softness: 0.5, noise: 0.0 },
    Style { name: "black 0.6 mm", outline: 0.6, ink: 0.0, softness: 0.5, noise: 0.0 },
    Style { name: "black 1.5 mm", outline: 1.5, ink: 0.0, softness: 0.5, noise: 0.0 },
    Style { name: "white 1.0 mm", outline: 1.0, ink: 1.0, softness: 0.5, noise: 0.0 },
    Style { name: "soft", outline: 0.0, ink: 0.0, softness: 2.0, noise: 0.0 },
    Style { name: "grainy", outline: 0.0, ink: 0.0, softness: 0.7, noise: 0.05 },
];

/// Share of the pixels off outlines that have their own area's class.
fn own(scene: &Scene, contours: &[Polyline<PxPoint>], params: &Params) -> f32 {
    let sorted = classes::sort(&scene.raster, contours, params);
    let found = scenes::by_pixel(&sorted, scene.raster.size());
    let inside = scene.area.iter().zip(found).filter_map(|(area, found)| Some((scene.classes[(*area)?], found)));
    let (all, right) =
        inside.fold((0, 0), |(all, right), (want, found)| (all + 1, right + u32::from(found == Some(want))));
    right as f32 / all as f32
}

/// Prints the table from which the defaults were chosen, and holds the ones that are.
#[test]
fn the_blur_does_not_stain() {
    let full = scenes::params();
    let cells = Params { smoothing: 0.0, min_area: 0.0, ..full };
    let smooth = |mm: f32| Params { smoothing: mm * PX_PER_MM, min_area: 0.0, ..full };
    let beside = |mm: f32| Params { beside: mm * PX_PER_MM, ..cells };
    let variants: [(&str, bool, Params); 13] = [
        ("plain, cells", false, cells),
        ("cells, beside 0", true, beside(0.0)),
        ("cells, beside 0.3", true, beside(0.3)),
        ("cells, beside 0.6", true, cells),
        ("cells, beside 0.9", true, beside(0.9)),
        ("plain, smoothing 1.5", false, smooth(1.5)),
        ("smoothing 1", true, smooth(1.0)),
        ("smoothing 1.5", true, smooth(1.5)),
        ("smoothing 2", true, smooth(2.0)),
        ("smoothing 3", true, smooth(3.0)),
        ("plain, default areas", false, full),
        ("default, blur 3", true, Params { blur: 3.0 * PX_PER_MM, ..full }),
        ("default", true, full),
    ];
    let seeds = 1..=6;
    let count = seeds.clone().count() as f32;
    let mut table = [[0.0_f32; STYLES.len()]; 13];
    for (column, style) in STYLES.iter().enumerate() {
        for seed in seeds.clone() {
            let scene = scenes::voronoi(seed, 12, *style);
            let contours = scenes::contours(&scene.raster);
            for (row, (_, stops, params)) in variants.iter().enumerate() {
                let contours = if *stops { &contours[..] } else { &[] };
                table[row][column] += own(&scene, contours, params) / count;
            }
        }
    }
    println!("{:>22}  {}", "", STYLES.map(|style| format!("{:>13}", style.name)).join(" "));
    for ((name, ..), row) in variants.iter().zip(&table) {
        println!("{name:>22}  {}", row.map(|share| format!("{share:>13.4}")).join(" "));
    }
    let row = |name: &str| table[variants.iter().position(|(own, ..)| *own == name).expect("a row")];
    for (style, (plain, stops)) in STYLES.iter().zip(row("plain, cells").iter().zip(row("smoothing 1.5"))) {
        assert!(stops > 0.98, "{}: {stops}", style.name);
        // At least half of the stain is gone; a cell is a millimetre wide, so some of it cannot go.
        assert!(1.0 - stops < 0.5 * (1.0 - plain), "{}: {plain} to {stops}", style.name);
    }
    for (style, (plain, stops)) in STYLES.iter().zip(row("plain, default areas").iter().zip(row("default"))) {
        assert!(stops > *plain && stops > 0.97, "{}: {plain} to {stops}", style.name);
    }
}
