//! Drawings as bitmaps that lost something: their pages have the lines of those that did not.

use tactograph::{Options, Page, Profile};
use tactograph_tools::bitmap;
use tactograph_tools::drawn::{Point, shares};

/// A map in pale colours with thin grey borders: colours that are as light as one another, so that only chroma differs.
const MAP: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>
<g stroke="#777" stroke-width="2"><path d="M60 80L400 60L420 300L80 320Z" fill="#f0c8c8"/>
<path d="M400 60L840 90L800 290L420 300Z" fill="#bfe0bf"/><path d="M80 320L420 300L450 540L70 530Z" fill="#c8d2f4"/>
<path d="M420 300L800 290L830 520L450 540Z" fill="#e6dcae"/></g></svg>"##;

fn page(picture: &[u8]) -> Page {
    let profile = Profile::named("swell-a4").expect("it is built in");
    tactograph::convert(picture, &Options::new(profile)).expect("a page").page
}

fn lines(page: &Page) -> Vec<Vec<Point>> {
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
    let path = |at: &tactograph::MmPoint| [f64::from(at.x), f64::from(at.y)];
    runs.map(|run| run.points.iter().chain(run.points.first().filter(|_| run.closed)).map(path).collect()).collect()
}

/// Shapes in black outlines, as on worksheets.
const WORKSHEET: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="900" height="600"><rect width="900" height="600" fill="#fff"/>
<g fill="none" stroke="#222" stroke-width="4"><circle cx="150" cy="150" r="80"/><path d="M420 70L330 230L510 225Z"/>
<path d="M620 80L800 86L796 220L616 214Z"/><circle cx="700" cy="430" r="90"/><path d="M60 340L560 350L540 520L90 540Z"/></g></svg>"##;

#[test]
fn a_noisy_scan_of_a_drawing_has_the_lines_of_the_drawing() {
    let whole = lines(&page(&bitmap::png(WORKSHEET, 1000).expect("a PNG")));
    for seed in [1, 2] {
        let drawn = lines(&page(&bitmap::scan(WORKSHEET, 1000, seed).expect("a JPEG")));
        let shares = shares(&whole, &drawn);
        assert!(shares.drawn > 0.98 && shares.beside < 0.01, "seed {seed}: {shares:?}");
    }
}

#[test]
fn a_drawing_as_jpeg_has_the_lines_of_the_same_as_png() {
    let whole = lines(&page(&bitmap::png(MAP, 1200).expect("a PNG")));
    let length = |lines: &[Vec<Point>]| -> f64 {
        let segments = lines.iter().flat_map(|line| line.windows(2));
        segments.map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum()
    };
    for quality in [90, 80, 60] {
        let drawn = lines(&page(&bitmap::jpeg(MAP, 1200, quality).expect("a JPEG")));
        let shares = shares(&whole, &drawn);
        assert!(shares.drawn > 0.99 && shares.beside < 0.01, "quality {quality}: {shares:?}");
        let ratio = length(&drawn) / length(&whole);
        assert!((0.97..1.03).contains(&ratio), "quality {quality}: {ratio} of the length");
    }
}
