//! Pages of devices that a program makes of parts, with nothing on them: what they are made for, and into which files of
//! dots they go.

use tactograph::marks::{Figure, Parts};
use tactograph::medium::{Device, DotArea, DotMedium, Medium};
use tactograph::{
    DotFormat, Embossing, Error, MmPoint, MmRect, Page, PageOptions, Profile, RenderOptions, Rule, Size, write_dots,
    write_pdf,
};

/// A page of a device with nothing on it.
fn page_of(medium: DotMedium, sheet: [f32; 2]) -> Page {
    let place = MmRect::new(MmPoint::new(30.0, 30.0), MmPoint::new(50.0, 50.0));
    let figure = Figure { place, source: Size::new(100, 100), textures: vec![], lines: vec![] };
    Page::new(Parts { medium: Medium::Dots(medium), ..Parts::of(sheet, figure) }).expect("nothing on it")
}

fn medium(device: &str, pitch: f32, sheet: [f32; 2]) -> DotMedium {
    DotMedium::on(Device::named(device).expect("in the table"), pitch, sheet).expect("a sheet that it takes")
}

const A4: [f32; 2] = [210.0, 297.0];

/// The sentence of an error of this kind.
fn refused(pages: &[Page], format: DotFormat, id: &str) -> String {
    let refused = write_dots("pages", pages, format, Embossing::default()).expect_err(id);
    assert_eq!(refused.id(), id, "{refused}");
    refused.to_string()
}

#[test]
fn a_page_of_parts_is_read_as_what_it_is_made_for() {
    for (device, pitch) in [("index-basic-d-v4", 2.0), ("index-basic-d-v5", 2.5), ("braillerap-a4", 2.5)] {
        let page = page_of(medium(device, pitch, A4), A4);
        let read = tactograph::render(page.to_svg(), &RenderOptions::new()).expect("it is one").page;
        assert_eq!(read.medium, page.medium, "{device}");
        let profile = Profile::of_page(page.to_svg()).expect("it is one");
        let id = profile.get("dots.device").expect("a key").to_string();
        assert_eq!(id.trim_matches('"'), device);
        let judged = tactograph::check(page.to_svg(), &PageOptions::new()).expect("it can be judged");
        assert!(judged.limit(&rule("line-gap")).is_some_and(|(_, unit)| unit == "dots"), "{device}");
    }
}

fn rule(id: &str) -> Rule {
    *Rule::all().iter().find(|rule| rule.id == id).expect("there is such a rule")
}

#[test]
fn no_pages_are_no_file() {
    assert_eq!(write_pdf("nothing", &[]), Err(Error::NoPages));
    for &format in DotFormat::ALL {
        let written = write_dots("nothing", &[], format, Embossing::default());
        assert_eq!(written, Err(Error::NoPages), "{}", format.name());
    }
}

#[test]
fn pages_that_do_not_go_into_one_file_are_refused() {
    let v4 = page_of(medium("index-basic-d-v4", 2.0, A4), A4);
    let v5 = page_of(medium("index-basic-d-v5", 2.0, A4), A4);
    for format in [DotFormat::Idx, DotFormat::Ubrl, DotFormat::Pef, DotFormat::Pixels, DotFormat::Txt] {
        let told = refused(&[v4.clone(), v5.clone()], format, "not-together");
        assert!(told.contains("Basic-D V4 and Index Basic-D V5"), "{told}");
    }
    let finer = page_of(medium("index-basic-d-v4", 1.6, A4), A4);
    let turned = page_of(medium("index-basic-d-v4", 2.0, [297.0, 210.0]), [297.0, 210.0]);
    for other in [finer, turned] {
        let told = refused(&[v4.clone(), other.clone()], DotFormat::Idx, "not-together");
        assert!(told.contains("different sheets or pitches"), "{told}");
        // Each page of the others says how large it is.
        let written = write_dots("pages", &[v4.clone(), other], DotFormat::Pixels, Embossing::default());
        assert!(written.is_ok_and(|files| files.len() == 2));
    }
}

#[test]
fn dots_that_a_format_cannot_hold_are_refused_and_not_dropped() {
    let mut on_grid = medium("braillerap-a4", 2.5, A4);
    on_grid.area = medium("index-basic-d-v4", 2.5, A4).area;
    let told = refused(&[page_of(on_grid, A4)], DotFormat::Gcode, "not-its-dots");
    assert!(told.contains("lie on a grid"), "{told}");
    let mut anywhere = medium("index-basic-d-v4", 2.5, A4);
    anywhere.area = DotArea::Free(MmRect::new(MmPoint::new(10.0, 10.0), MmPoint::new(200.0, 280.0)));
    for format in [DotFormat::Idx, DotFormat::Ubrl, DotFormat::Pef, DotFormat::Pixels, DotFormat::Txt] {
        let told = refused(&[page_of(anywhere.clone(), A4)], format, "not-its-dots");
        assert!(told.contains("no grid"), "{told}");
    }
}
