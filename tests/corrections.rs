//! Lines and areas of a page that a person corrected, given to a new conversion of its picture.

use tactograph::{Crop, Error, MmPoint, Options, Page, Profile, SheetGrid};

const PICTURE: &str = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>\
    <rect width='300' height='200' fill='#fff'/>\
    <path d='M30 30H140V170H30Z' fill='#c00' stroke='#000' stroke-width='3'/>\
    <path d='M190 60L270 150H190Z' fill='#06c' stroke='#000' stroke-width='3'/></svg>";

fn options() -> Options {
    Options::new(Profile::named("swell-a4").expect("it is built in"))
}

fn page(options: &Options) -> Page {
    tactograph::convert(PICTURE.as_bytes(), options).expect("a page").page
}

/// All points of the figure's lines, and the places of its signs by class.
fn marks(page: &Page) -> (Vec<MmPoint>, Vec<(String, Vec<MmPoint>)>) {
    let runs = page.figure.lines.iter().flat_map(|line| &line.runs);
    let points = runs.flat_map(|run| run.points.iter().copied()).collect();
    let textures = page.figure.textures.iter();
    let signs = |texture: &tactograph::marks::Texture| texture.glyphs.iter().map(|glyph| glyph.at).collect();
    (points, textures.map(|texture| (texture.class.name().to_owned(), signs(texture))).collect())
}

/// Whether each of some places is near one of the others.
fn are_near(some: &[MmPoint], others: &[MmPoint]) -> bool {
    !some.is_empty() && some.iter().all(|at| others.iter().any(|other| (*other - *at).length() < 0.1))
}

#[test]
fn a_page_for_the_back_of_the_sheet_is_taken_as_its_picture_lies() {
    let [own, back] = [false, true].map(|mirrored| page(&options().mirrored(mirrored)).to_svg());
    for mirrored in [false, true] {
        let with = |svg: &String| {
            let all = options().lines(svg).and_then(|options| options.areas(svg)).expect("a page of the program");
            let made = page(&all.mirrored(mirrored));
            marks(&if mirrored { made.mirrored() } else { made })
        };
        let ((lines, signs), (of_back, signs_of_back)) = (with(&own), with(&back));
        assert!(are_near(&lines, &of_back) && are_near(&of_back, &lines), "mirrored: {mirrored}");
        assert_eq!((signs.len(), signs_of_back.len()), (2, 2));
        for ((class, at), (class_of_back, at_of_back)) in signs.iter().zip(&signs_of_back) {
            assert_eq!(class, class_of_back);
            assert!(are_near(at, at_of_back) && are_near(at_of_back, at), "{class}, mirrored: {mirrored}");
        }
    }
}

#[test]
fn areas_drawn_beside_lines_that_are_given_are_told() {
    let own = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><g fill='none' stroke='#000'>\
               <path d='M20 20H280'/></g><path d='M160 40H180V180H160Z' fill='#06c'/></svg>";
    let told = |options: Options| {
        let drawing = tactograph::convert(PICTURE.as_bytes(), &options).expect("a page");
        drawing.notes.iter().map(ToString::to_string).filter(|note| note.contains("1 area that was drawn")).count()
    };
    assert_eq!(told(options().add_lines(own).expect("a drawing")), 1);
    assert_eq!(told(options().lines(own).expect("a drawing")), 1);
    let areas = page(&options()).to_svg();
    assert_eq!(told(options().add_lines(own).and_then(|options| options.areas(areas)).expect("a page")), 0);
}

#[test]
fn a_page_of_another_part_of_the_picture_is_refused() {
    let part: Crop = "0,0,60%,100%".parse().expect("a part");
    let [whole, piece] = [options(), options().crop(part)].map(|options| page(&options).to_svg());
    let refused = |options: Options| match tactograph::convert(PICTURE.as_bytes(), &options) {
        Err(Error::OtherPart { page, drawn }) => Some((page, drawn)),
        Err(error) => panic!("{error}"),
        Ok(_) => None,
    };
    let (all, of_part) = ("all of it".to_owned(), "the part 0,0,60%,100% of it".to_owned());
    let given = |svg: &String| [options().lines(svg), options().add_lines(svg), options().areas(svg)];
    for options in given(&piece).map(|options| options.expect("a page of the program")) {
        assert_eq!(refused(options.clone()), Some((of_part.clone(), all.clone())));
        assert_eq!(refused(options.crop("0%,0%,60%,100%".parse().expect("a part"))), None, "the same part");
    }
    for options in given(&whole).map(|options| options.expect("a page of the program")) {
        assert_eq!(refused(options.clone().crop(part)), Some((all.clone(), of_part.clone())));
        assert_eq!(refused(options.crop("0,0,100%,100%".parse().expect("a part"))), None, "all of it");
    }
    let grid = SheetGrid::new(2, 1).expect("a grid");
    let sheets = tactograph::convert_to_sheets(PICTURE.as_bytes(), Some(grid), &options()).expect("sheets");
    let sheet = sheets.pages[0].to_svg();
    let (page, _) = refused(options().lines(sheet).expect("a page of the program")).expect("it is a piece");
    assert!(page.contains("sheet a1"), "{page}");
}
