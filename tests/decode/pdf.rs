//! Pages of PDF documents.

use super::*;
use tactograph::Note;
use tactograph::internals::raster::vector::DrawnText;

/// A document of these objects, the first of which is the catalog.
fn document(objects: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = b"%PDF-1.7\n".to_vec();
    let mut places = Vec::new();
    for (i, object) in objects.iter().enumerate() {
        places.push(bytes.len());
        bytes.extend(format!("{} 0 obj\n", i + 1).as_bytes());
        bytes.extend(object);
        bytes.extend(b"\nendobj\n");
    }
    let start = bytes.len();
    bytes.extend(format!("xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1).as_bytes());
    places.iter().for_each(|place| bytes.extend(format!("{place:010} 00000 n \n").as_bytes()));
    let trailer = format!("trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{start}\n%%EOF\n", objects.len() + 1);
    bytes.extend(trailer.as_bytes());
    bytes
}

fn stream(entries: &str, data: &[u8]) -> Vec<u8> {
    [format!("<< {entries} /Length {} >>\nstream\n", data.len()).as_bytes(), data, b"\nendstream"].concat()
}

/// A document of one page, with entries of its own and further objects from number 5.
fn page(entries: &str, content: &str, more: &[Vec<u8>]) -> Vec<u8> {
    let page = format!("<< /Type /Page /Parent 2 0 R /Contents 4 0 R {entries} >>");
    let first = [
        b"<< /Type /Catalog /Pages 2 0 R >>".to_vec(),
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>".to_vec(),
        page.into_bytes(),
        stream("", content.as_bytes()),
    ];
    document(&[&first[..], more].concat())
}

const FONT: &str = "/Font << /F << /Type /Font /Subtype /Type1 /BaseFont /Helvetica >> >>";

fn decode_page(bytes: &[u8], page: Option<u32>, keep_text: bool, limits: Limits) -> Result<Decoded, Error> {
    let working_size = |source: Header| Ok(source.size);
    decode(bytes, &DecodeOptions { limits, page, keep_text, ..DecodeOptions::whole(&working_size) })
}

fn without_text(bytes: &[u8], page: Option<u32>) -> Decoded {
    decode_page(bytes, page, false, Limits::default()).expect("a page")
}

fn strings(picture: &Decoded) -> Vec<&str> {
    picture.texts.iter().map(|text| text.string.as_str()).collect()
}

/// Red, green and blue at a pixel, in linear light; one value where the picture is grey.
fn at(picture: &Decoded, x: u32, y: u32) -> Vec<f32> {
    let at = (y * picture.raster.size().width + x) as usize;
    picture.raster.planes().iter().map(|plane| plane[at]).collect()
}

fn is(picture: &Decoded, (x, y): (u32, u32), rgb: [u8; 3]) -> bool {
    at(picture, x, y).iter().zip(rgb).all(|(light, sample)| (light - linear(f32::from(sample))).abs() < 0.03)
}

const RED: [u8; 3] = [255, 0, 0];
const WHITE: [u8; 3] = [255; 3];

#[test]
fn texts_of_a_page_are_data() {
    let bytes = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/worksheet.pdf")).expect("a sample");
    let first = without_text(&bytes, Some(1));
    assert_eq!(first.source.size, Size::new(794, 1123), "A4 in CSS pixels");
    assert!(first.source.is_drawing && first.drawing.is_some());
    assert_eq!(
        strings(&first),
        [
            "Triangles: measure and name",
            "1. Measure the three sides.",
            "2. Which angle is a right angle?",
            "A",
            "B",
            "C",
            "c = 13 cm",
            "b = 8 cm",
            "a = ?",
            "circle",
            "square",
            "r",
        ]
    );
    // "Triangles: measure and name" begins 20 mm from the left and stands 26 mm from the top, 8 mm high.
    let px = 96.0 / 25.4;
    let DrawnText { min, max, angle, size, hidden, .. } = &first.texts[0];
    assert!((min.x - 20.0 * px).abs() < 2.0 && (max.x - 138.0 * px).abs() < 10.0, "{min:?} {max:?}");
    assert!(min.y < 21.0 * px && max.y > 26.0 * px && max.y < 29.0 * px, "{min:?} {max:?}");
    assert!(angle.abs() < 0.1 && (size - 8.0 * px).abs() < 0.1 && !hidden, "{angle} {size}");
    assert!((first.texts[7].angle - 90.0).abs() < 0.1, "{:?}", first.texts[7]);
    assert!((first.texts[8].angle + 31.6).abs() < 0.1, "{:?}", first.texts[8]);
    let second = without_text(&bytes, Some(2));
    assert_eq!(strings(&second)[..3], ["Favourite fruit of class 5b", "How many children chose plums?", "Apple"]);
    assert_eq!(second.notes, []);

    let blank = |picture: &Decoded| (150..500).all(|x| (75..100).all(|y| is(picture, (x, y), WHITE)));
    let kept = decode_page(&bytes, Some(1), true, Limits::default()).expect("a page");
    assert!(blank(&first) && !blank(&kept), "the letters of the first line");
    assert_eq!(strings(&kept), [""; 0]);
}

#[test]
fn without_a_number_it_is_the_first_page_and_told_so() {
    let bytes = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/worksheet.pdf")).expect("a sample");
    let (first, other) = (without_text(&bytes, None), without_text(&bytes, Some(1)));
    assert!(first.raster.planes() == other.raster.planes(), "each time the same");
    assert_eq!(first.texts, other.texts);
    assert_eq!((first.notes, other.notes), (vec![Note::FirstPageOnly { pages: 2 }], vec![]));
}

#[test]
fn pages_that_are_not_there_are_refused() {
    let bytes = page("/MediaBox [0 0 72 36]", "1 0 0 rg 0 0 72 36 re f", &[]);
    for number in [0, 2, u32::MAX] {
        let told = decode_page(&bytes, Some(number), false, Limits::default()).expect_err("no page").to_string();
        assert!(told.starts_with(&format!("there is no page {number}: the file has one page")), "{told}");
    }
    let told = decode_page(&read("rgb.png"), Some(2), false, Limits::default()).expect_err("one page").to_string();
    assert!(told.contains("the file has one page"), "{told}");
    assert!(decode_page(&read("rgb.png"), Some(1), false, Limits::default()).is_ok());
}

#[test]
fn pages_are_turned_and_cut_as_they_say() {
    // A red square at the top left of the crop box, which is 60 x 30 points of a page of 100 x 100.
    let content = "1 0 0 rg 20 40 10 10 re f";
    for (turn, size, corner) in [
        ("", Size::new(80, 40), (6, 6)),
        ("/Rotate 90", Size::new(40, 80), (34, 6)),
        ("/Rotate 180", Size::new(80, 40), (74, 34)),
        ("/Rotate -90", Size::new(40, 80), (6, 74)),
    ] {
        let bytes = page(&format!("/MediaBox [0 0 100 100] /CropBox [20 20 80 50] {turn}"), content, &[]);
        let picture = without_text(&bytes, None);
        assert_eq!(picture.source.size, size, "{turn}");
        let reds = (0..size.width).flat_map(|x| (0..size.height).map(move |y| (x, y)));
        let red = reds.filter(|place| is(&picture, *place, RED)).count();
        assert!(is(&picture, corner, RED), "{turn}");
        assert!((144..=196).contains(&red), "{turn}: {red} pixels"); // 13.3 x 13.3
    }
}

#[test]
fn documents_that_cannot_be_read_are_refused_in_plain_words() {
    let whole = page("/MediaBox [0 0 72 36]", "1 0 0 rg 0 0 72 36 re f", &[]);
    let no_page =
        document(&[b"<< /Type /Catalog /Pages 2 0 R >>".to_vec(), b"<< /Type /Pages /Kids [] /Count 0 >>".to_vec()]);
    for (bytes, told) in [
        (&b"%PDF-1.4 and nothing else"[..], "it is damaged, or has no page"),
        (&whole[..60], "it is damaged, or has no page"),
        (&no_page, "it has no page"),
    ] {
        let fault = fault(bytes);
        assert!(fault.starts_with(&format!("the PDF picture cannot be read: {told}")), "{fault}");
    }
    assert_eq!(
        decode(&read("locked.pdf"), &DecodeOptions::whole(&|header| Ok(header.size))).err(),
        Some(Error::Locked { format: "PDF" })
    );
    assert!(fault(&read("locked.pdf")).contains("locked with a password; unlock it first"));
    assert_eq!(strings(&without_text(&read("restricted.pdf"), None)), ["locked"], "only changes are locked");
}

#[test]
fn a_scanned_page_is_its_picture_and_its_hidden_words_are_data() {
    let kind = "/Type /XObject /Subtype /Image /Width 64 /Height 32 /ColorSpace /DeviceRGB /BitsPerComponent 8";
    let scan = stream(&format!("{kind} /Filter /DCTDecode"), &read("rgb.jpg"));
    let content = "BT 3 Tr /F 10 Tf 4 20 Td (two words) Tj ET q 96 0 0 48 0 0 cm /S Do Q";
    let entries = format!("/MediaBox [0 0 96 48] /Resources << /XObject << /S 5 0 R >> {FONT} >>");
    let picture = without_text(&page(&entries, content, &[scan]), None);
    assert_eq!(picture.source.size, Size::new(128, 64));
    for (i, place) in [(32, 16), (96, 16), (32, 48), (96, 48)].into_iter().enumerate() {
        let light = at(&picture, place.0, place.1);
        let near = light.iter().zip(SCENE[i]).all(|(light, sample)| (light - linear(f32::from(sample))).abs() < 0.05);
        assert!(near, "{place:?}: {light:?}");
    }
    assert_eq!(strings(&picture), ["two words"]);
    assert!(picture.texts[0].hidden);
    assert_eq!(picture.drawing.expect("a drawing").pixel_areas.len(), 1);
}

/// A font whose letters, those of "ijklm", are drawings: all are object 5.
fn drawn_font(matrix: &str, widths: &str) -> String {
    format!(
        "/Font << /F << /Type /Font /Subtype /Type3 /FontBBox [0 0 0 0] /FontMatrix [{matrix}] /FirstChar 105 \
         /LastChar 109 /Widths [{widths}] /Encoding << /Type /Encoding /Differences [105 /i /j /k /l /m] >> \
         /CharProcs << /i 5 0 R /j 5 0 R /k 5 0 R /l 5 0 R /m 5 0 R >> >> >>"
    )
}

#[test]
fn letters_that_are_drawings_are_one_text() {
    let letter = stream("", b"278 0 d0 50 0 150 700 re f");
    let texts = |font: &str, content: &str| {
        let entries = format!("/MediaBox [0 0 200 48] /Resources << {font} >>");
        without_text(&page(&entries, content, std::slice::from_ref(&letter)), None)
    };
    let font = drawn_font("0.001 0 0 0.001 0 0", "278 278 579 278 974");
    let picture = texts(&font, "BT /F 10 Tf 4 20 Td (mil) Tj [-350 (k) 20 (im) -350 (i)] TJ ET");
    assert_eq!(strings(&picture), ["mil kim i"]);
    let px = picture.source.size.height as f32 / 48.0;
    assert!((picture.texts[0].size - 10.0 * px).abs() < 0.1, "{:?}", picture.texts[0]);
    // as TeX makes them of pixels: upside down in text that is upside down, of a size that is none
    let font = drawn_font("1 0 0 -1 0 0", "23 23 48 23 81");
    let picture = texts(&font, "BT /F 0.12 Tf 1 0 0 -1 4 20 Tm [(mil) -28000 (kim)] TJ ET");
    assert_eq!(strings(&picture), ["mil kim"]);
    let DrawnText { min, max, .. } = &picture.texts[0];
    assert!(min.y < 22.0 * px && max.y > 27.5 * px && max.y < 31.5 * px, "{min:?} {max:?}");
}

#[test]
fn forms_that_are_letters_are_in_their_texts() {
    let letter = stream("", b"278 0 d0 50 0 150 700 re f");
    let form = "/Type /XObject /Subtype /Form /BBox [-1021 -463 1794 1233]";
    let minus = stream(form, b"\n106 355 m\n732 355 l\n732 272 l\n106 272 l\n106 355 l\nh\nf\n");
    let font = drawn_font("0.001 0 0 0.001 0 0", "278 278 579 278 974");
    let entries = format!("/MediaBox [0 0 200 48] /Resources << {font} /XObject << /F1-Drawn-minus 6 0 R >> >>");
    let number = |x: u32| {
        format!("q 1 0 0 1 {x} 20 cm BT /F 10 Tf 8.38 0 Td (ilk) Tj ET q 0.01 0 0 0.01 0 0 cm /F1-Drawn-minus Do Q Q ")
    };
    let picture = without_text(&page(&entries, &(number(10) + &number(110)), &[letter, minus]), None);
    assert_eq!(strings(&picture), ["\u{2212}ilk"; 2]);
    assert!(picture.drawing.is_some_and(|drawing| drawing.paths.is_empty()), "no letter is left");
    assert_eq!(picture.notes, []);
}

#[test]
fn a_form_that_is_longer_than_letters_are_is_no_letter() {
    let form = "/Type /XObject /Subtype /Form /BBox [0 0 1000 1000]";
    let entries = "/MediaBox [0 0 200 48] /Resources << /XObject << /F1-Drawn-minus 5 0 R >> >>";
    let of = |blanks: usize| {
        let content = format!("{}106 355 m\n732 355 l\n732 272 l\nh\nf\n", " ".repeat(blanks));
        let more = [stream(form, content.as_bytes())];
        let picture = without_text(&page(entries, "q 0.02 0 0 0.02 20 20 cm /F1-Drawn-minus Do Q", &more), None);
        (strings(&picture).len(), picture.drawing.is_some_and(|drawing| !drawing.paths.is_empty()))
    };
    assert_eq!(of(0), (1, false));
    assert_eq!(of(20_000), (0, true), "it is drawn");
}

#[test]
fn letters_that_are_filled_and_stroked_are_one_text() {
    let entries = format!("/MediaBox [0 0 200 48] /Resources << {FONT} >>");
    let content = "BT 2 Tr /F 10 Tf 4 20 Td [(Wa) 80 (ter) -300 (lily)] TJ 100 0 Td (far) Tj ET";
    assert_eq!(strings(&without_text(&page(&entries, content, &[]), None)), ["Water lily", "far"]);
}

#[test]
fn small_numbers_off_the_line_are_raised_and_lowered() {
    let entries = format!("/MediaBox [0 0 200 48] /Resources << {FONT} >>");
    let power = "BT /F 10 Tf 4 20 Td (10) Tj /F 7 Tf 11.2 4 Td (3) Tj /F 10 Tf 3.9 -4 Td ( kg) Tj ET";
    let water = "BT /F 10 Tf 104 20 Td (H) Tj /F 7 Tf 7.3 -2 Td (2) Tj /F 10 Tf 3.9 2 Td (O) Tj ET";
    let content = format!("{power} {water}");
    assert_eq!(strings(&without_text(&page(&entries, &content, &[]), None)), ["10\u{b3} kg", "H\u{2082}O"]);
}

#[test]
fn pages_that_grow_without_end_are_refused() {
    let form = |next: usize, times: usize| {
        let resources = format!("/Resources << /XObject << /N {next} 0 R >> >>");
        stream(
            &format!("/Type /XObject /Subtype /Form /BBox [0 0 72 36] {resources}"),
            "/N Do ".repeat(times).as_bytes(),
        )
    };
    let entries = "/MediaBox [0 0 72 36] /Resources << /XObject << /N 5 0 R >> >>";
    let told = |forms: &[Vec<u8>]| fault(&page(entries, "/N Do", forms));
    let growing: Vec<_> = (0..12).map(|i| form(6 + i, 10)).collect();
    assert!(told(&growing).contains("takes more than 20000000 steps"), "{}", told(&growing));
    let rings = [vec![form(5, 2)], vec![form(6, 2), form(5, 2)]];
    for forms in rings {
        // hayro does not follow the first kind.
        match whole(&page(entries, "/N Do", &forms)) {
            Ok(picture) => assert!(picture.raster.is_flat(), "{}", forms.len()),
            Err(fault) => assert!(fault.to_string().contains("a part of it draws itself"), "{fault}"),
        }
    }
    let deep: Vec<_> = (0..45).map(|i| form(6 + i, 1)).collect();
    assert!(told(&deep).contains("too many levels, more than 40 one inside"), "{}", told(&deep));
}

#[test]
fn pictures_on_pages_keep_the_limits() {
    let entries = "/MediaBox [0 0 72 36] /Resources << /XObject << /S 5 0 R >> >>";
    let image = |size: u32| {
        let kind = "/Type /XObject /Subtype /Image /ColorSpace /DeviceGray /BitsPerComponent 8";
        stream(&format!("{kind} /Width {size} /Height {size}"), &[128; 64])
    };
    let told = |size| fault(&page(entries, "q 72 0 0 36 0 0 cm /S Do Q", &[image(size)]));
    assert!(
        told(30_000).contains("30000 x 30000 pixels, which is over the limit of 300 megapixels"),
        "{}",
        told(30_000)
    );
    assert!(told(12_000).contains("decoding this PDF of 12000 x 12000 pixels"), "{}", told(12_000));
}

#[test]
fn a_page_that_names_a_part_many_times_is_refused() {
    let objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>".to_vec(),
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>".to_vec(),
        format!("<< /Type /Page /MediaBox [0 0 72 36] /Contents [{}] >>", "4 0 R ".repeat(3000)).into_bytes(),
        stream("", &[b' '; 1000]),
    ];
    let limits = Limits { memory_mb: 2, ..Limits::default() };
    let told = decode_page(&document(&objects), None, false, limits).expect_err("3 MB").to_string();
    assert!(told.contains("unpacks to more than the limit of 2 MB"), "{told}");
}

#[test]
fn a_fine_scan_is_averaged() {
    // A pixel of the page, of 120 x 240, has 6 x 6 of the scan, of which every second row is black.
    let rows: Vec<u8> = (0..1440).flat_map(|row| [if row % 2 == 0 { 0 } else { 255 }; 720]).collect();
    let kind = "/Type /XObject /Subtype /Image /ColorSpace /DeviceGray /BitsPerComponent 8 /Width 720 /Height 1440";
    let entries = "/MediaBox [0 0 90 180] /Resources << /XObject << /S 5 0 R >> >>";
    let picture = without_text(&page(entries, "q 90 0 0 180 0 0 cm /S Do Q", &[stream(kind, &rows)]), None);
    assert_eq!(picture.raster.size(), Size::new(120, 240));
    for (x, y) in [(10, 10), (60, 120), (110, 230)] {
        let light = at(&picture, x, y)[0];
        assert!((light - 0.5).abs() < 0.2, "half of the light: {light} at {x}, {y}");
    }
}
