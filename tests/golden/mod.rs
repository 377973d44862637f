//! The pages of all samples, as they were when somebody last looked at them.
//!
//! `tests/golden/pages/` holds for each sample the page as text and as SVG, compared byte by byte, and its rendering by
//! resvg, compared within a tolerance (renderers round differently on different machines). `UPDATE=1 cargo test --test
//! golden` writes what the program makes now, and fails, so that nobody forgets to look at the difference and at the
//! renderings before committing them; under CI it is refused.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::common::{page, samples};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use tactograph::Page;
use tactograph::internals::output::dots::{DocumentWords, DotMatrix, pixels, text, ubrl};
use tactograph::internals::profile::Profile;

/// Resolution of the renderings: 1.6 px for a millimetre, so that every line and glyph leaves its mark in a small file.
const DPI: f32 = 40.0;
/// Largest mean difference of all pixels, of 255.
const MEAN_TOLERANCE: f64 = 0.2;
/// Largest difference of one pixel, of 255: a quarter of black against white.
const PIXEL_TOLERANCE: u8 = 64;

#[test]
fn pages_are_as_somebody_last_saw_them() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/pages");
    let update = std::env::var_os("UPDATE").is_some();
    assert!(!(update && std::env::var_os("CI").is_some()), "golden pages are not updated under CI");
    let mut faults = Vec::new();
    let mut expected = BTreeSet::new();
    for name in samples::names() {
        let page = &page::of_sample(&name, "swell-a4").page;
        let svg = tactograph::internals::output::svg::write(page);
        let rendering = render(&svg);
        let file = |ending: &str| folder.join(format!("{name}.{ending}"));
        expected.extend(["txt", "svg", "png"].map(&file));
        if update {
            std::fs::create_dir_all(&folder).expect("the folder can be made");
            std::fs::write(file("txt"), page.to_string()).expect("the text can be written");
            std::fs::write(file("svg"), svg).expect("the SVG can be written");
            rendering.save_png(file("png")).expect("the rendering can be written");
        } else {
            same_text(&file("txt"), &page.to_string(), &mut faults);
            same_text(&file("svg"), &svg, &mut faults);
            same_picture(&file("png"), &rendering, &mut faults);
        }
    }
    let there =
        std::fs::read_dir(&folder).expect("there are golden pages").map(|entry| entry.expect("readable").path());
    faults
        .extend(there.filter(|path| !expected.contains(path)).map(|path| format!("{} has no sample", path.display())));
    assert!(!update, "golden pages are written: look at them, then run the test without UPDATE");
    assert!(
        faults.is_empty(),
        "{}\nIf the new pages are better: UPDATE=1 cargo test --test suite golden::",
        faults.join("\n")
    );
}

/// Pages of dots, for one embosser and for each kind of pin display: as Unicode braille, and for the displays as plain
/// text and as a picture of a pixel a dot as well. All are compared byte by byte.
#[test]
fn pages_of_dots_are_as_somebody_last_saw_them() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/dots");
    let update = std::env::var_os("UPDATE").is_some();
    assert!(!(update && std::env::var_os("CI").is_some()), "golden pages are not updated under CI");
    let mut faults = Vec::new();
    let mut expected = BTreeSet::new();
    // Others on two samples, with all marks and heights, as text.
    let others = ["viewplus-columbia", "braillerap", "braille-cells"];
    for name in ["index-basic-d", "graphiti", "monarch", "pins-120x60"].into_iter().chain(others) {
        let profile = Profile::named(name).expect("it is built in");
        let device = profile.dots.device.expect("a profile of dots");
        for picture in samples::names() {
            if others.contains(&name) && !["coffee.png", "landscape.svg"].contains(&picture.as_str()) {
                continue;
            }
            let drawing = page::of_sample(&picture, name);
            let pages: Vec<&Page> = [Some(&drawing.page), drawing.overview.as_ref()].into_iter().flatten().collect();
            let matrices: Vec<DotMatrix> = pages.iter().filter_map(|page| DotMatrix::of(page)).collect();
            let mut files = vec![("ubrl", ubrl::write(&matrices).into_bytes())];
            if others.contains(&name) {
                files = vec![("txt", pages.iter().map(|page| page.to_string()).collect::<String>().into_bytes())];
            } else if name != "index-basic-d" {
                let words = DocumentWords { title: &picture, ..DocumentWords::default() };
                files.push(("txt", text::write(&matrices).into_bytes()));
                files.push(("png", pixels::write(&matrices[0], profile.dots.pitch, device.has_heights(), &words)));
            }
            for (ending, now) in files {
                let path = folder.join(format!("{picture}.{name}.{ending}"));
                if update {
                    std::fs::create_dir_all(&folder).expect("the folder can be made");
                    std::fs::write(&path, &now).expect("it can be written");
                } else if std::fs::read(&path).ok().as_ref() != Some(&now) {
                    faults.push(format!("{} is missing or differs", path.display()));
                }
                expected.insert(path);
            }
        }
    }
    let there =
        std::fs::read_dir(&folder).expect("there are golden pages").map(|entry| entry.expect("readable").path());
    faults
        .extend(there.filter(|path| !expected.contains(path)).map(|path| format!("{} has no sample", path.display())));
    assert!(!update, "golden pages of dots are written: look at them, then run the test without UPDATE");
    assert!(
        faults.is_empty(),
        "{}\nIf the new pages are better: UPDATE=1 cargo test --test suite golden::",
        faults.join("\n")
    );
}

/// The page in black on white.
fn render(svg: &str) -> Pixmap {
    let tree = usvg::Tree::from_str(svg, &usvg::Options { dpi: DPI, ..Default::default() }).expect("a page is an SVG");
    let size = tree.size().to_int_size();
    let mut pixmap = Pixmap::new(size.width(), size.height()).expect("a page has a size");
    pixmap.fill(Color::WHITE);
    resvg::render(&tree, Transform::identity(), &mut pixmap.as_mut());
    pixmap
}

fn same_text(path: &PathBuf, now: &str, faults: &mut Vec<String>) {
    let Ok(golden) = std::fs::read_to_string(path) else {
        faults.push(format!("{} is missing", path.display()));
        return;
    };
    if golden != now {
        let line = golden.lines().zip(now.lines()).take_while(|(a, b)| a == b).count();
        let show = |text: &str| text.lines().nth(line).unwrap_or("(end)").chars().take(90).collect::<String>();
        let (was, is) = (show(&golden), show(now));
        faults.push(format!("{} differs from line {}:\n  was {was}\n  is  {is}", path.display(), line + 1));
    }
}

fn same_picture(path: &PathBuf, now: &Pixmap, faults: &mut Vec<String>) {
    let Ok(golden) = Pixmap::load_png(path) else {
        faults.push(format!("{} is missing", path.display()));
        return;
    };
    if (golden.width(), golden.height()) != (now.width(), now.height()) {
        faults.push(format!("{} has another size", path.display()));
        return;
    }
    let differences = golden.data().iter().zip(now.data()).map(|(a, b)| a.abs_diff(*b));
    let (mut sum, mut most) = (0_u64, 0);
    for difference in differences {
        sum += u64::from(difference);
        most = most.max(difference);
    }
    let mean = sum as f64 / golden.data().len() as f64;
    if mean > MEAN_TOLERANCE || most > PIXEL_TOLERANCE {
        faults.push(format!("{}: pixels differ by {mean:.3} in the mean, {most} at most, of 255", path.display()));
    }
}
