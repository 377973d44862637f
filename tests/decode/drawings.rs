//! SVG drawings: sizes, fonts, what they may reach and what they may cost.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use tactograph::internals::raster::decode::{DecodeOptions, Header, decode};
use tactograph::internals::units::Size;
use tactograph::{Error, Note, Reason};

use crate::decode::{check, decode_to, fault, folder, open, read, whole};

#[test]
fn a_text_of_too_many_elements_or_attributes_is_refused_before_it_is_parsed() {
    // parsed, these would take 400 MB; an element of the second would be refused for naming its attributes alike
    let elements = "<g/>".repeat(2_000_001);
    let attributes = format!("<g {}/>", "a=''".repeat(5_000_001));
    for (inside, what) in [(elements, "more than 1000000 elements"), (attributes, "more than 5000000 attributes")] {
        let svg = format!("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>{inside}</svg>");
        let refused = whole(svg.as_bytes());
        let Err(Error::TooComplex { format: "SVG", why }) = &refused else { panic!("{what}") };
        assert_eq!(why, &format!("it has {what}"));
    }
}

#[test]
fn nothing_outside_a_drawing_is_reached() {
    // The linked picture lies beside the drawing, and in the folder tests run in; it must not show.
    let picture = open("linked.svg");
    assert_eq!(picture.raster.planes().as_slice(), [vec![1.0; 64 * 32]]);
    let [Note::LeftOut(Reason::Elsewhere, file), Note::LeftOut(Reason::Elsewhere, net)] = &picture.notes[..] else {
        panic!("{:?}", picture.notes)
    };
    assert!(file.contains("rgb.png") && net.contains("http://localhost/rgb.png"), "{file} {net}");
    let path = folder().join("rgb.png");
    for what in [
        format!("<image width='9' height='9' href='{}'/>", path.display()),
        format!("<image width='9' height='9' href='file://{}'/>", path.display()),
        format!("<style>@import url('{0}'); rect {{ fill: url('{0}') }}</style>", path.display()),
        format!("<filter id='f'><feImage href='{}'/></filter><g filter='url(#f)'><rect/></g>", path.display()),
        format!("<use href='{}#a'/>", folder().join("rgb.svg").display()),
    ] {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>{what}</svg>");
        let picture = whole(text.as_bytes()).unwrap();
        assert!(picture.raster.planes().iter().flatten().all(|&v| v.total_cmp(&1.0).is_eq()), "{what}");
    }
}

#[test]
fn no_file_comes_in_as_an_entity() {
    let text = format!(
        "<!DOCTYPE svg [<!ENTITY file SYSTEM '{}'>]><svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>&file;</svg>",
        folder().join("rgb.svg").display()
    );
    assert!(fault(text.as_bytes()).contains("line 1"), "{}", fault(text.as_bytes()));
}

#[test]
fn fonts_are_asked_for_once_and_only_by_texts() {
    let asked = AtomicUsize::new(0);
    let fonts = || {
        asked.fetch_add(1, Ordering::Relaxed);
        let mut fonts = usvg::fontdb::Database::new();
        fonts.load_font_data(read("block.ttf"));
        Arc::new(fonts)
    };
    let working_size = |source: Header| Ok(source.size);
    let options = DecodeOptions { fonts: &fonts, ..DecodeOptions::whole(&working_size) };
    for name in ["rgb.svg", "picture-inside.svg", "linked.svg", "rgb.png"] {
        decode(&read(name), &options).unwrap();
    }
    assert_eq!(asked.load(Ordering::Relaxed), 0);
    // The letter is a black square of the em, in the left half.
    let picture = decode(&read("text.svg"), &options).unwrap();
    check("text.svg", &picture.raster, [0.0, 1.0, 0.0, 1.0].map(|v| vec![v]), 1e-6);
    assert_eq!(picture.notes, []);
    let two = String::from_utf8(read("text.svg")).unwrap().replace("</text>", "</text><text>A</text>");
    decode(two.as_bytes(), &options).unwrap();
    assert_eq!(asked.load(Ordering::Relaxed), 2);
}

#[test]
fn where_only_pixels_are_wanted_they_are_the_same_and_no_font_is_asked_for() {
    let fonts = || -> Arc<usvg::fontdb::Database> { panic!("letters are not drawn") };
    let mut fonts_of_all = usvg::fontdb::Database::new();
    fonts_of_all.load_font_data(read("block.ttf"));
    let fonts_of_all = Arc::new(fonts_of_all);
    let (working_size, of_all) = (|source: Header| Ok(source.size), || fonts_of_all.clone());
    let all = DecodeOptions { fonts: &of_all, keep_text: false, ..DecodeOptions::whole(&working_size) };
    let pixels = DecodeOptions { fonts: &fonts, pixels_only: true, ..all };
    let (all, pixels) = (decode(&read("text.svg"), &all).unwrap(), decode(&read("text.svg"), &pixels).unwrap());
    assert_eq!((all.texts.len(), all.drawing.is_some()), (1, true));
    assert_eq!((pixels.texts.len(), pixels.drawing.is_some(), pixels.raster), (0, false, all.raster));
}

/// The texts of a drawing that has a text with this inside.
fn texts_of(inside: &str) -> Vec<String> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(read("block.ttf"));
    let fonts = Arc::new(fonts);
    let (working_size, fonts) = (|source: Header| Ok(source.size), || fonts.clone());
    let options = DecodeOptions { fonts: &fonts, keep_text: false, ..DecodeOptions::whole(&working_size) };
    let text = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='60' font-family='Block' font-size='16'>\
         <text>{inside}</text></svg>"
    );
    let texts = decode(text.as_bytes(), &options).expect("a drawing").texts;
    texts.into_iter().map(|text| text.string).collect()
}

#[test]
fn signs_that_have_a_place_each_are_one_number_and_one_word() {
    let read = texts_of;
    let power = "<tspan x='46.4' y='24' font-size='11'>3</tspan>";
    for places in ["x='10 26 36.2' y='30'", "x='10 26 36.2' y='30 30 30'"] {
        let all = read(&format!("<tspan {places}>A10</tspan>{power}"));
        let expected = if places.ends_with("30 30 30'") { "A 10\u{b3}" } else { "A10\u{b3}" };
        assert_eq!(all, [expected], "{places}");
    }
    assert_eq!(read("<tspan x='10 26 42 48 64' y='30'>AA AA</tspan>"), ["AA AA"], "a row with a blank in it");
    assert_eq!(read("<tspan x='10' y='20'>A</tspan><tspan x='10' dy='16'>1</tspan>"), ["A 1"], "two lines");
    let small = "<tspan x='10' y='20'>1</tspan><tspan x='10' dy='14' font-size='10'>A</tspan>";
    assert_eq!(read(small), ["1 A"], "two lines, of which one is small");
    let lines = "<tspan x='10' y='20'>A1</tspan><tspan x='10' dy='14' font-size='11'>2</tspan>";
    assert_eq!(read(lines), ["A1 2"], "a small line below");
    assert_eq!(read("<tspan x='10' y='30'>A</tspan><tspan x='60'>A</tspan>"), ["A A"], "apart");
    let raised = "<tspan x='10' y='30'>A</tspan><tspan dy='-6' font-size='11'>3</tspan><tspan dy='6'> A</tspan>";
    assert_eq!(read(raised), ["A\u{b3} A"]);
    assert_eq!(read(&raised.replace("3<", "3 <").replace("> A", ">A")), ["A\u{b3} A"]);
    assert_eq!(read("<tspan x='10' y='30'>A<tspan fill='red'>1</tspan><tspan dy='4'>A</tspan></tspan>"), ["A1A"]);
}

#[test]
fn what_is_raised_or_lowered_within_a_text_is_a_power_or_an_index() {
    let of = |attributes: &str| {
        texts_of(&format!("<tspan x='10' y='30'>A1<tspan {attributes}>3</tspan><tspan fill='red'> A</tspan></tspan>"))
    };
    for shift in ["super", "6", "40%", "0.4em"] {
        assert_eq!(of(&format!("baseline-shift='{shift}' font-size='11'")), ["A1\u{b3} A"], "{shift}");
        assert_eq!(of(&format!("baseline-shift='{shift}'")), ["A1\u{b3} A"], "{shift}, as large");
    }
    for shift in ["sub", "-4", "-25%"] {
        assert_eq!(of(&format!("style='baseline-shift:{shift};font-size:65%'")), ["A1\u{2083} A"], "{shift}");
    }
    for shift in ["baseline", "0", "1", "14"] {
        assert_eq!(of(&format!("baseline-shift='{shift}'")), ["A13 A"], "{shift}");
    }
    let back = "<tspan x='10' y='30'>A<tspan dy='-6'>3</tspan><tspan dy='6'>A1</tspan></tspan>";
    assert_eq!(texts_of(back), ["A\u{b3}A1"]);
    let raised = "<tspan dy='-6' font-size='11'>3</tspan>";
    for anchor in ["middle", "end"] {
        let start = format!("<tspan x='90' y='30' text-anchor='{anchor}'>A");
        assert_eq!(texts_of(&format!("{start}{raised}</tspan>")), ["A\u{b3}"], "{anchor}");
        let below = format!("{start}1</tspan><tspan x='90' dy='14' text-anchor='{anchor}' font-size='11'>2</tspan>");
        assert_eq!(texts_of(&below), ["A1 2"], "{anchor}, a small line below");
    }
    let whole = "<tspan x='10' y='30' baseline-shift='-33%'>A1</tspan><tspan x='60' baseline-shift='-33%'>2</tspan>";
    assert_eq!(texts_of(whole), ["A1 2"]);
    // blanks between elements have the size of the whole text
    let small = |x: u32, sign: char| format!(" <tspan x='{x}' y='24' font-size='11'>{sign}</tspan>");
    let signs = format!("<tspan x='10' y='30'>A</tspan>{}{} ", small(26, '1'), small(33, '2'));
    assert_eq!(texts_of(&signs), ["A\u{b9}\u{b2}"]);
}

#[test]
fn letters_that_are_paths_are_texts_where_a_comment_says_which() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='60' height='30'><g id='text_1'><!-- A -->\
                <g transform='translate(10 20) scale(0.1 -0.1)'><defs><path id='F-41' d='M0 0H60V70H0z'/></defs>\
                <use href='#F-41'/></g></g><path d='M30 5V25' stroke='#000'/></svg>";
    let working_size = |source: Header| Ok(source.size);
    let of = |keep_text: bool| {
        let options = DecodeOptions { keep_text, ..DecodeOptions::whole(&working_size) };
        let picture = decode(text.as_bytes(), &options).unwrap();
        let light = picture.raster.planes().as_slice()[0][15 * 60 + 12];
        let strings: Vec<String> = picture.texts.into_iter().map(|text| text.string).collect();
        (strings, picture.drawing.unwrap().paths.len(), light > 0.5)
    };
    assert_eq!(of(false), (vec!["A".to_owned()], 1, true));
    assert_eq!(of(true), (Vec::new(), 2, false), "kept in the drawing");
}

#[test]
fn a_text_without_a_font_is_a_remark() {
    let picture = open("text.svg");
    assert!(
        matches!(&picture.notes[..], [Note::LeftOut(Reason::NoFonts, what)] if what.contains("Block")),
        "{:?}",
        picture.notes
    );
}

fn svg(attributes: &str) -> Vec<u8> {
    format!("<svg xmlns='http://www.w3.org/2000/svg' {attributes}><rect width='1' height='1'/></svg>").into_bytes()
}

#[test]
fn the_size_of_a_drawing_is_in_css_pixels_or_keeps_its_shape() {
    for (attributes, size) in [
        ("width='640' height='480'", Size::new(640, 480)),
        ("viewBox='0 0 640 480'", Size::new(640, 480)),
        ("width='210mm' height='297mm'", Size::new(794, 1123)),
        ("width='100%' height='100%' viewBox='5 5 20 10'", Size::new(20, 10)),
        ("width='1' height='1.4142'", Size::new(512, 724)),
        ("width='0.001' height='0.002'", Size::new(1, 2)),
    ] {
        let got = decode_to(&svg(attributes), &|_| Ok(Size::new(8, 8))).unwrap().source;
        let ratio = |size: Size| f64::from(size.width) / f64::from(size.height);
        if attributes.contains("0.001") || attributes.contains("1.4142") {
            assert!((ratio(got.size) / ratio(size) - 1.0).abs() < 0.001, "{attributes}: {}", got.size);
        } else {
            assert_eq!(got, Header { size, is_drawing: true }, "{attributes}");
        }
    }
}

#[test]
fn sizes_that_are_none_are_refused() {
    for attributes in [
        "width='0' height='10'",
        "width='-5' height='10'",
        "width='1e30' height='1e30'",
        "width='1e38' height='1'",
        "width='1e-30' height='1'",
        "width='NaN' height='1' viewBox='0 0 0 0'",
        "width='10000000' height='10000000'",
    ] {
        let bytes = svg(attributes);
        let got = decode_to(&bytes, &|_| Ok(Size::new(8, 8)));
        match got {
            Err(Error::Undecodable { format: "SVG", why } | Error::TooComplex { format: "SVG", why }) => {
                assert!(why.contains("size"), "{attributes}: {why}");
            }
            // usvg takes a size it cannot read as if it were not there.
            Ok(picture) => assert!(attributes.contains("NaN") && picture.source.size.area() > 0, "{attributes}"),
            Err(other) => panic!("{attributes}: {other}"),
        }
    }
}

#[test]
fn lengths_of_which_usvg_makes_curves_without_end_are_refused_at_once() {
    for shape in [
        "<path d='M0 0a1e38 1e38 0 0 0 5 5'/>",
        "<path d='M0 0A100000000000000000000000000000000000000 9 0 0 0 5 5'/>",
        "<circle r='1e38'/>",
        "<rect width='9' height='9' rx='1e30' ry='3'/>",
    ] {
        let text = format!("<svg xmlns='http://www.w3.org/2000/svg' width='99' height='99'>\n{shape}</svg>");
        let fault = fault(text.as_bytes());
        assert!(
            fault.contains("line 2, column 1: ") && fault.contains(" has a place or size too large to compute with"),
            "{fault}"
        );
        assert_eq!(fault.lines().count(), 1);
    }
    // a map in metres is no such drawing
    let map = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='1113000 -20037508 90 90'>\
               <path d='M1113010 -20037500h50v50z'/></svg>";
    assert!(decode_to(map.as_bytes(), &|_| Ok(Size::new(64, 64))).is_ok());
}

#[test]
fn a_malformed_drawing_is_refused_with_its_line() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>\n<g>\n</svg>";
    let fault = fault(text.as_bytes());
    assert!(fault.contains("SVG") && fault.contains("line 3"), "{fault}");
    assert_eq!(fault.lines().count(), 1);
}

/// A drawing of elements that each refer to the next one, `count` of them.
fn chain(count: usize, each: impl Fn(usize) -> String, last: &str) -> String {
    let body: String = (0..count).map(each).collect();
    format!("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>{body}{last}</svg>")
}

#[test]
fn drawings_too_deep_for_the_stack_are_refused() {
    let rect = "<rect width='9' height='9'";
    let nested = |tag: &str| {
        chain(0, |_| String::new(), &format!("{}{}", format!("<{tag}>").repeat(500), format!("</{tag}>").repeat(500)))
    };
    for text in [
        nested("g"),
        nested("svg"),
        nested("switch"),
        chain(
            5000,
            |i| format!("<clipPath id='c{i}' clip-path='url(#c{})'>{rect}/></clipPath>", i + 1),
            &format!("{rect} clip-path='url(#c0)'/>"),
        ),
        chain(
            5000,
            |i| format!("<mask id='c{i}'>{rect} style='mask: url(\"#c{}\")'/></mask>", i + 1),
            &format!("{rect} mask='url(#c0)'/>"),
        ),
        chain(
            5000,
            |i| format!("<pattern id='c{i}' width='2' height='2'>{rect} fill='url(#c{})'/></pattern>", i + 1),
            &format!("{rect} fill='url(#c0)'/>"),
        ),
        // The same by what goes down from a group, and by a style sheet.
        chain(
            5000,
            |i| format!("<g fill='url(#c{})'><pattern id='c{i}' width='2' height='2'>{rect}/></pattern></g>", i + 1),
            &format!("{rect} fill='url(#c0)'/>"),
        ),
        chain(
            5000,
            |i| {
                format!("<style>.c{i} {{ mask: url(#c{}) }}</style><mask id='c{i}'>{rect} class='c{i}'/></mask>", i + 1)
            },
            &format!("{rect} mask='url(#c0)'/>"),
        ),
        chain(
            5000,
            |i| format!("<marker id='c{i}'><path d='M0 0L1 1L2 0' marker-mid='url(#c{})'/></marker>", i + 1),
            "<path d='M0 0L5 5L9 0' marker-mid='url(#c0)'/>",
        ),
    ] {
        let fault = fault(text.as_bytes());
        assert!(fault.contains("deep") || fault.contains("too long"), "{fault}: {}", &text[..200]);
    }
}

#[test]
fn drawings_that_grow_without_end_are_refused() {
    let start = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>";
    let entities: String =
        (1..12).map(|i| format!("<!ENTITY e{i} '{}'>", format!("&e{};", i - 1).repeat(10))).collect();
    let uses: String =
        (1..12).map(|i| format!("<g id='u{i}'>{}</g>", format!("<use href='#u{}'/>", i - 1).repeat(10))).collect();
    let masks: String = (1..12)
        .map(|i| format!("<mask id='u{i}'>{}</mask>", format!("<rect mask='url(#u{})'/>", i - 1).repeat(10)))
        .collect();
    let canvases = format!("{}<rect width='9' height='9'/>{}", "<g opacity='.9'>".repeat(190), "</g>".repeat(190));
    for (text, why) in [
        (format!("<!DOCTYPE svg [<!ENTITY e0 'e'>{entities}]>{start}&e11;</svg>"), "entity"),
        (format!("{start}<defs><rect id='u0' width='1' height='1'/>{uses}</defs><use href='#u11'/></svg>"), "elements"),
        (format!("{start}<mask id='u0'/>{masks}<rect mask='url(#u11)'/></svg>"), "elements"),
        (
            format!("{start}<filter id='f'><feTurbulence numOctaves='99999'/></filter><rect filter='url(#f)'/></svg>"),
            "octaves",
        ),
        (format!("{start}{canvases}</svg>"), "MB of memory"),
        (
            format!("{start}<filter id='f'><feMorphology radius='2'/></filter><rect filter='url(#f)'/></svg>"),
            "morphology filter",
        ),
        (format!("{start}<style>{}</style></svg>", ".a{fill:red}".repeat(8001)), "rules"),
        (format!("{start}<text>{}<tspan>a</tspan></text></svg>", "a ".repeat(15_000)), "letters"),
        (format!("{start}<path d='M0 0{}'/></svg>", "L9 9L0 0".repeat(8000)), "times as long"),
        (format!("{start}<path d='{}'/></svg>", "M0 0L9 9z".repeat(8000)), "times as long"),
    ] {
        let got =
            decode_to(text.as_bytes(), &|_| Ok(Size::new(2000, 2000))).map(|_| ()).map_err(|fault| fault.to_string());
        assert!(matches!(&got, Err(fault) if fault.contains(why)), "{why}: {got:?}");
    }
}

/// A small file with filters that would take hours; those that people use are drawn.
#[test]
fn filters_of_endless_work_are_refused() {
    let drawing = |filter: &str, groups: usize| {
        let group = "<g filter='url(#f)'><rect width='900' height='600'/></g>".repeat(groups);
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'><filter id='f'>{filter}</filter>{group}</svg>"
        )
    };
    let blur = "<feGaussianBlur stdDeviation='2'/>";
    let convolution = format!("<feConvolveMatrix order='60' kernelMatrix='{}'/>", "1 ".repeat(3600));
    let turbulence = "<feTurbulence baseFrequency='0.05' numOctaves='16'/>";
    let inside = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'><filter id='f'>{blur}</filter>\
         <pattern id='p' width='1' height='1'>{0}</pattern><rect width='900' height='600' fill='url(#p)'/>\
         <mask id='m'>{0}</mask><g mask='url(#m)'><rect width='9' height='9'/></g></svg>",
        "<g filter='url(#f)'><rect width='900' height='600'/></g>".repeat(200)
    );
    for text in [drawing(blur, 400), drawing(&convolution, 1), drawing(turbulence, 40), inside] {
        let refused = decode_to(text.as_bytes(), &|_| Ok(Size::new(900, 600))).map(|_| ());
        let Err(Error::TooComplex { format: "SVG", why }) = &refused else { panic!("{refused:?}") };
        assert!(why.contains("filters would take about"), "{why}");
    }
    assert!(decode_to(drawing(blur, 1).as_bytes(), &|_| Ok(Size::new(900, 600))).is_ok());
}

#[test]
fn drawings_of_many_plain_parts_are_drawn() {
    // a thin dilation, rules, a long text and a long line that are all below their limits
    let start = "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='600'>";
    for inside in [
        "<filter id='f'><feMorphology radius='2 0.5'/></filter><rect width='9' height='9' filter='url(#f)'/>"
            .to_owned(),
        "<filter id='f' primitiveUnits='objectBoundingBox'><feMorphology radius='.01'/></filter>\
         <rect width='9' height='9' filter='url(#f)'/>"
            .to_owned(),
        format!("<style>{}</style><rect width='9' height='9'/>", ".a{fill:red}".repeat(500)),
        format!("<text>{}</text><rect width='9' height='9'/>", "a ".repeat(5000)),
        format!("<path d='M0 0{}' fill='none' stroke='#000'/>", "L900 600L0 0".repeat(500)),
        // letters of three bytes each
        format!("<text>{}</text><rect width='9' height='9'/>", "字".repeat(12_000)),
        // dots far from one another
        format!("<path d='{}' fill='none' stroke='#000'/>", "M1 1h1M899 599h1".repeat(15_000)),
        // beyond the canvas
        format!("<path d='M0 0{}' fill='none' stroke='#000'/>", "L90000000 6L0 0".repeat(500)),
    ] {
        let text = format!("{start}{inside}</svg>");
        assert!(whole(text.as_bytes()).is_ok(), "{}", fault(text.as_bytes()));
    }
    // Thousands of shapes that share gradients, a marker, a clip path and a pattern, in style sheets and out of them.
    let parts: String = (0..3000)
        .map(|i| {
            format!(
                "<g class='cls-{}' clip-path='url(#c)'><path fill='url(#l)' marker-end='url(#m)' d='M{i} 0V9H0z'/></g>",
                i % 50
            )
        })
        .collect();
    let rules: String = (0..50).map(|i| format!(".cls-{i}{{clip-path:url(#c);stroke:url(#p)}}")).collect();
    let text = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><style>{rules}</style>\
         <linearGradient id='l'>{}</linearGradient><marker id='m'><path d='M0 0h1v1'/></marker>\
         <clipPath id='c'><rect width='9' height='9'/></clipPath><pattern id='p' width='1' height='1'><rect/></pattern>{parts}</svg>",
        "<stop offset='0'/>".repeat(20)
    );
    assert!(whole(text.as_bytes()).is_ok(), "{}", fault(text.as_bytes()));
}

#[test]
fn a_drawing_inside_a_drawing_is_drawn_but_no_deeper() {
    let inside = |text: &str| {
        let text =
            text.replace('%', "%25").replace('#', "%23").replace('<', "%3C").replace('>', "%3E").replace('"', "%22");
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\">\
             <image width=\"9\" height=\"9\" href=\"data:image/svg+xml,{text}\"/></svg>"
        )
    };
    let black = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"><path d=\"M0 0h9v9H0z\"/></svg>";
    let one = whole(inside(black).as_bytes()).unwrap();
    assert_eq!(one.raster.planes().as_slice(), [vec![0.0; 81]]);
    assert_eq!(one.notes, []);
    let two = whole(inside(&inside(black)).as_bytes()).unwrap();
    assert_eq!(two.raster.planes().as_slice(), [vec![1.0; 81]]);
    assert!(matches!(&two.notes[..], [Note::LeftOut(..)]), "{:?}", two.notes);
}

#[test]
fn a_huge_picture_inside_a_drawing_is_left_out() {
    // 30000 x 30000 by its header.
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><image width='9' height='9' \
                href='data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAdTAAAHUwCAIAAADpRW/t'/></svg>";
    let picture = whole(text.as_bytes()).unwrap();
    assert!(
        matches!(&picture.notes[..], [Note::LeftOut(Reason::OverLimit, what)] if what.contains("30000 x 30000")),
        "{:?}",
        picture.notes
    );
}

#[test]
fn a_picture_without_height_in_a_drawing_is_no_panic() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg' width='64' height='32'><image width='64' height='32' \
                href='data:image/svg+xml,%3Csvg xmlns=%22http://www.w3.org/2000/svg%22 width=%22999999999%22 height=%221%22/%3E'/></svg>";
    assert!(fault(text.as_bytes()).contains("too small"), "{}", fault(text.as_bytes()));
}
