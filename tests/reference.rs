//! The program's f32 beside the same computations in f64, where rounding may turn a decision: `docs/stability.md` has
//! the table of `tools/src/bin/reference.rs`, these are its bounds.

use tactograph::internals::profile::{Plan, Profile};
use tactograph_tools::reference::edges::quantile;
use tactograph_tools::reference::{colours, edges, glyphs, samples, scenes};

fn plan() -> Plan {
    Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("built-in profiles make sense")
}

/// Scenes in which neither has a point.
const WITHOUT_A_POINT: [&str; 6] = [
    "steps of one unit in the last place",
    "1/255 over 2048 px",
    "ramp of 1/255 every 12 px",
    "ramp of 16 bits",
    "1 x 400 px",
    "400 x 1 px",
];

#[test]
fn positions_and_heights_of_edges_are_those_of_f64() {
    let mut looked_at = 0;
    for (name, raster) in scenes::all() {
        let found = edges::compare(&raster, &plan().edges(4.0));
        looked_at += found.both;
        let is_empty = found.both + found.other_axis + found.single == 0;
        assert_eq!(is_empty, WITHOUT_A_POINT.contains(&name), "{name}: {} points", found.both);
        // Where the gradient is least (saddles of a checkerboard, beyond the resolution of a zone plate, noise), and
        // where colours are nearly black, the height of a step hangs on the last digits; elsewhere it does not.
        let (px, share) = match name {
            "checkerboards of 1 to 8 px" | "zone plate" | "saturated, and nearly black" => (0.02, 0.25),
            _ if name.starts_with("noise") => (0.005, 0.03),
            _ => (0.001, 0.002),
        };
        let [off_px, off_share] = [&found.px, &found.share].map(|values| quantile(values, 1.0));
        assert!(off_px <= px && off_share <= share, "{name}: {off_px} px, {off_share} of the height");
        assert!(found.single * 300 <= found.both, "{name}: {} of {} points", found.single, found.both);
        assert!(found.other_axis <= 1 + found.both / 50, "{name}: {} of {} points", found.other_axis, found.both);
    }
    assert!(looked_at > 10_000, "{looked_at}");
}

/// What `docs/stability.md` says of the samples, and a quarter more, as vectors of other machines may round otherwise.
#[test]
fn the_samples_are_as_near_to_f64_as_the_docs_say() {
    let plan = plan();
    let lines = plan.lines();
    let mm_per_unit = f64::from((lines.width_max - lines.width_min) / (lines.full_strength - lines.least_strength));
    for (name, raster) in samples::all().expect("the samples are there") {
        let found = edges::compare(&raster, &plan.edges(samples::PX_PER_MM));
        let (px, strength) = if name.ends_with(".svg") { (0.0004, 0.11) } else { (0.022, 0.5) };
        let [off_px, off_strength] = [&found.px, &found.height].map(|values| quantile(values, 1.0));
        assert!(off_px <= 1.25 * px, "{name}: {off_px} px");
        assert!(off_strength <= 1.25 * strength, "{name}: {off_strength} of strength");
        let width = mm_per_unit * quantile(&found.height, 0.999);
        assert!(width <= 1.25 * 0.013, "{name}: lines {width} mm wider or narrower");
        assert!(found.both > 3000 && found.single * 300 <= found.both, "{name}: {} of {}", found.single, found.both);
        let classes = colours::compare(samples::codes(&raster), &plan.classes(samples::PX_PER_MM));
        assert!(classes.colours > 100_000 && classes.other <= 3, "{name}: {classes:?}");
    }
}

#[test]
fn classes_are_those_of_f64() {
    let all = (0..1 << 24).step_by(101).map(|code: u32| [16, 8, 0].map(|shift| (code >> shift & 0xff) as f32 / 255.0));
    let found = colours::compare(all, &plan().classes(4.0));
    assert!(found.colours > 100_000);
    assert!(found.farthest < 1e-5 && found.other * 10_000 < found.colours, "{found:?}");
}

#[test]
fn marks_of_textures_are_as_large_as_in_f64() {
    let (off, marks) = glyphs::compare(&plan().textures());
    assert!(off < 1e-6 && marks > 10_000, "{off} mm of {marks} marks");
}
