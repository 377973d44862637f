//! Pages that somebody changed in an editor, and what is said of them.

use tactograph::internals::output::svg;
use tactograph::internals::page::Class;
use tactograph::internals::touch::report::OfClass;
use tactograph::internals::touch::{self, FeltAs, Ink, Report};
use tactograph::internals::units::{MmPoint, MmRect};

use tactograph_tools::touch::chart;

use crate::touch::params;

/// A page with one texture, as an editor would get it.
fn page(class: Class) -> String {
    let place = MmRect::new(MmPoint::new(20.0, 20.0), MmPoint::new(90.0, 80.0));
    svg::write(&chart::page_of_sample(class, 0.4, 1.0, place, &params()))
}

fn report(page: &str) -> Report {
    let ink = Ink::of(page).expect("it is a page still");
    touch::report(&ink, &ink.felt(1.0).expect("there is such a finger"))
}

fn wrong_of_judged(of: &OfClass) -> f32 {
    of.areas.wrong / of.areas.judged()
}

#[test]
fn a_page_as_made_is_felt_as_meant() {
    for class in Class::ALL {
        let report = report(&page(class));
        assert_eq!(report.classes.len(), 1);
        let of = report.classes[0];
        assert!(of.class == class && of.areas.right_of_judged() > 0.999 && of.areas.judged() > 1500.0, "{of:?}");
        assert!((of.areas.textured() / (70.0 * 60.0) - 1.0).abs() < 0.2, "the area is that of the glyphs: {of:?}");
    }
}

#[test]
fn a_texture_that_was_turned_is_felt_as_another_and_told_so() {
    // an editor turns a layer by a transform on its group
    let page =
        page(Class::Blue).replacen("id=\"texture-blue\"", "id=\"texture-blue\" transform=\"rotate(-45 55 50)\"", 1);
    let report = report(&page);
    let of = &report.classes[0];
    assert!(wrong_of_judged(of) > 0.99 && of.mostly_felt_as == Some(FeltAs::Class(Class::Green)), "{of:?}");
    let text = report.to_string();
    assert!(text.contains(": right 0 %, unclear") && text.contains("Wrong is mostly felt as green."), "{text}");
}

#[test]
fn a_texture_that_was_hidden_or_deleted_is_blank_paper() {
    let hidden = page(Class::Red).replacen("id=\"texture-red\"", "id=\"texture-red\" style=\"display:none\"", 1);
    assert!(report(&hidden).to_string().starts_with("There are no textures on this page"));
}

#[test]
fn a_page_with_other_signs_is_read_by_them() {
    let sea_and_sand = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\">\
        <rect width=\"150\" height=\"200\" fill=\"#24c\"/><rect x=\"150\" width=\"150\" height=\"200\" fill=\"#fd0\"/></svg>";
    let signs = [("textures.palette.blue", "rhombus 90"), ("textures.palette.yellow", "rhombus 0")];
    let page = svg::write(&crate::common::page::page_of(sea_and_sand.as_bytes(), "sea", &signs, &mut |_| ()).page);
    let classes = report(&page).classes;
    assert_eq!(classes.iter().map(|of| of.class).collect::<Vec<_>>(), [Class::Blue, Class::Yellow]);
    assert!(classes.iter().all(|of| of.areas.right_of_judged() > 0.98 && of.areas.judged() > 1500.0), "{classes:?}");

    // by the paper's signs, each is the other
    let untold = report(&page.replace("data-sign=", "data-was=")).classes;
    assert!(untold.iter().all(|of| of.areas.right_of_judged() < 0.01 && wrong_of_judged(of) > 0.98), "{untold:?}");
    let unreadable = report(&page.replace("data-sign=\"rhombus", "data-sign=\"rhomb")).classes;
    assert_eq!(unreadable, untold);

    // alone on its page, blue is not taken for the yellow of the paper
    let alone = page.replace("id=\"texture-yellow\"", "id=\"sand\"");
    let classes = report(&alone).classes;
    assert!(
        classes.len() == 1 && classes[0].class == Class::Blue && classes[0].areas.right_of_judged() > 0.98,
        "{classes:?}"
    );
}

#[test]
fn density_is_counted_in_glyphs() {
    let params = params();
    let of = report(&page(Class::Yellow)).classes[0];
    let per_cm2 = 100.0 / (params.along * params.across);
    assert!((of.density / per_cm2 - 1.0).abs() < 0.12, "{} glyphs, the lattice has {per_cm2}", of.density);
    let rhombus = 0.5 * params.length * params.thickness;
    assert!(of.ink < 0.01 * of.density * rhombus && of.ink > 0.6 * 0.01 * of.density * rhombus, "ink {}", of.ink);
}

#[test]
fn fingertips_that_there_are_not_are_refused() {
    for finger in [0.0, -1.0, 0.2, 3.0, f32::NAN, f32::INFINITY] {
        let fault = touch::feel(&page(Class::Grey), finger).expect_err("there is no such finger");
        assert!(fault.to_string().contains("from 0.3 to 2.5"), "{fault}");
    }
}

#[test]
fn a_map_is_a_picture_of_the_felt_area() {
    let ink = Ink::of(&page(Class::Green)).expect("it is a page");
    let felt = ink.felt(1.0).expect("there is such a finger");
    let png = touch::map::png(&ink, &felt).expect("there is memory for it");
    let map = resvg::tiny_skia::Pixmap::decode_png(&png).expect("it is a PNG");
    assert!(map.width() >= 4 * 70 && map.height() >= 4 * 60);
    // two pixels a cell; in the middle stands the name, a quarter from the left the stripes of green, up to the right
    let dark = |x: u32, y: u32| map.pixel(x, y).is_some_and(|pixel| pixel.green() < 100);
    let (x, y) = (felt.size.width / 2, felt.size.height);
    let stripe = (x..x + 18).find(|&x| dark(x, y) && dark(x + 1, y)).expect("there is a stripe in every 17 pixels");
    assert!((0..30).all(|step| dark(stripe + step, y - step)), "the stripe goes up to the right");
    assert!((0..30).any(|step| !dark(stripe + step, y + step)), "and not down");
}
