//! Files that are small and ask for much: sizes, depths, circles and compressed zeros.

use std::fmt::Write as _;
use std::io::Write as _;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};

use crate::Fault;
use crate::dense;
use crate::mutate::mend_checksums;
use crate::seeds::{Input, Seed};

/// All of them.
pub(crate) fn all() -> Result<Vec<Seed>, Fault> {
    let mut bombs = Vec::new();
    let mut add = |name: &str, input, bytes: Vec<u8>| {
        bombs.push(Seed { name: name.to_owned(), row: "bombs".to_owned(), input, is_text: false, bytes });
    };
    add("png 60000 x 60000, all zeros", Input::Picture, png(60_000, 60_000, &zlib_of_zeros(64 << 20)?));
    add("png 2147483647 x 1", Input::Picture, png(0x7fff_ffff, 1, &zlib_of_zeros(1 << 20)?));
    add("png 1 x 2147483647", Input::Picture, png(1, 0x7fff_ffff, &zlib_of_zeros(1 << 20)?));
    add("png 4294967295 x 4294967295", Input::Picture, png(u32::MAX, u32::MAX, &[]));
    add("png with an ICC profile of 1 GB of zeros", Input::Picture, png_with_icc(&zlib_of_zeros(1 << 30)?));
    add("png with a text of 1 GB of zeros", Input::Picture, png_with_text(&zlib_of_zeros(1 << 30)?));
    add("jpeg 65500 x 65500", Input::Picture, jpeg(65_500, 65_500));
    add(
        "gif 65535 x 65535",
        Input::Picture,
        b"GIF89a\xff\xff\xff\xff\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0\xff\xff\xff\xff\0\x02\x02D\x01\0;".to_vec(),
    );
    add("pnm 4294967295 x 4294967295", Input::Picture, b"P6 4294967295 4294967295 255\n".to_vec());
    add(
        "pam of 65535 planes",
        Input::Picture,
        b"P7\nWIDTH 60000\nHEIGHT 60000\nDEPTH 65535\nMAXVAL 65535\nENDHDR\n".to_vec(),
    );
    add("bmp 2147483647 x -2147483648", Input::Picture, bmp(0x7fff_ffff, i32::MIN));
    add(
        "webp 16384 x 16384, one byte",
        Input::Picture,
        b"RIFF\x1a\0\0\0WEBPVP8L\x0e\0\0\0\x2f\xff\xff\xff\x1f\0\0\0\0\0\0\0\0\0".to_vec(),
    );
    add("tiff whose directories form a circle", Input::Picture, tiff_in_a_circle());
    add("svgz of 4 GB of blanks", Input::Picture, gzip_of(b" ", 4 << 30)?);
    add("svgz of 10 million elements", Input::Picture, svgz_of(b"<g/>", 10 << 20)?);
    add("svgz of 100 million attributes", Input::Picture, svgz_of(b"<g a='' b='' c='' d='' />", 25 << 20)?);
    for (name, svg) in drawings() {
        add(&format!("svg {name}"), Input::Picture, svg.clone().into_bytes());
        add(&format!("page {name}"), Input::Page, svg.replace("<svg ", "<svg data-tactograph='1' ").into_bytes());
        add(&format!("lines {name}"), Input::Lines, svg.into_bytes());
    }
    for (name, svg) in dense::drawings() {
        add(&format!("dense {name}"), Input::Lettered, svg.into_bytes());
    }
    for (name, pdf) in documents()? {
        add(&format!("pdf {name}"), Input::Picture, pdf);
    }
    add("profile of 100000 nested arrays", Input::Profile, format!("a = {}", "[".repeat(100_000)).into_bytes());
    add(
        "profile of 200000 keys",
        Input::Profile,
        (0..200_000)
            .fold(String::new(), |mut text, i| {
                let _ = writeln!(text, "k{i} = {i}");
                text
            })
            .into_bytes(),
    );
    add("labels: 100000 rows", Input::Labels, "50%,50%,apple\n".repeat(100_000).into_bytes());
    // as many as a page takes, none of which has room in full
    add("labels: 300 at one place", Input::Labels, "50%,50%,apple\n".repeat(300).into_bytes());
    add("labels: 300 all over the figure", Input::Labels, labels_all_over().into_bytes());
    add("labels: one text of 1 MB", Input::Labels, format!("50%,50%,{}", "apple ".repeat(170_000)).into_bytes());
    Ok(bombs)
}

/// Labels of 300 different texts, each in another place.
fn labels_all_over() -> String {
    (0..300).fold(String::new(), |mut text, i| {
        let _ = writeln!(text, "{}%,{}%,apple {i}", 2 + 37 * i % 97, 3 + 61 * i % 95);
        text
    })
}

fn zlib_of_zeros(count: usize) -> Result<Vec<u8>, Fault> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    let zeros = vec![0; 1 << 20];
    for _ in 0..count >> 20 {
        encoder.write_all(&zeros)?;
    }
    Ok(encoder.finish()?)
}

fn gzip_of(byte: &[u8; 1], count: usize) -> Result<Vec<u8>, Fault> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    let block = byte.repeat(1 << 20);
    for _ in 0..count >> 20 {
        encoder.write_all(&block)?;
    }
    Ok(encoder.finish()?)
}

/// A drawing of `count` of these elements.
fn svgz_of(element: &[u8], count: usize) -> Result<Vec<u8>, Fault> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(b"<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>")?;
    let block = element.repeat(1 << 20);
    for _ in 0..count >> 20 {
        encoder.write_all(&block)?;
    }
    encoder.write_all(b"</svg>")?;
    Ok(encoder.finish()?)
}

fn chunk(png: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) {
    png.extend(u32::try_from(data.len()).unwrap_or(u32::MAX).to_be_bytes());
    png.extend(name);
    png.extend(data);
    png.extend([0; 4]);
}

fn png_of(width: u32, height: u32, chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
    chunk(&mut png, b"IHDR", &[&width.to_be_bytes()[..], &height.to_be_bytes(), &[8, 2, 0, 0, 0]].concat());
    for (name, data) in chunks {
        chunk(&mut png, name, data);
    }
    chunk(&mut png, b"IEND", &[]);
    mend_checksums(&mut png);
    png
}

fn png(width: u32, height: u32, pixels: &[u8]) -> Vec<u8> {
    png_of(width, height, &[(b"IDAT", pixels)])
}

fn png_with_icc(profile: &[u8]) -> Vec<u8> {
    let data = [b"x\0\0", profile].concat();
    let pixels = zlib_of_zeros(1 << 20).unwrap_or_default();
    png_of(64, 64, &[(b"iCCP", &data), (b"IDAT", &pixels)])
}

fn png_with_text(text: &[u8]) -> Vec<u8> {
    let data = [b"Comment\0\0", text].concat();
    let pixels = zlib_of_zeros(1 << 20).unwrap_or_default();
    png_of(64, 64, &[(b"zTXt", &data), (b"IDAT", &pixels)])
}

/// A frame header and a scan without data.
fn jpeg(width: u16, height: u16) -> Vec<u8> {
    let mut jpeg = b"\xff\xd8\xff\xdb\0\x43\0".to_vec();
    jpeg.extend([1; 64]);
    jpeg.extend(b"\xff\xc0\0\x0b\x08");
    jpeg.extend(height.to_be_bytes());
    jpeg.extend(width.to_be_bytes());
    jpeg.extend(b"\x01\x01\x11\0\xff\xc4\0\x14\0\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0");
    jpeg.extend(b"\xff\xc4\0\x14\x10\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xff\xda\0\x08\x01\x01\0\0\x3f\0\0\0\xff\xd9");
    jpeg
}

fn bmp(width: i32, height: i32) -> Vec<u8> {
    let mut bmp = b"BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0".to_vec();
    bmp.extend(width.to_le_bytes());
    bmp.extend(height.to_le_bytes());
    bmp.extend(b"\x01\0\x18\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0");
    bmp.extend([0; 16]);
    bmp
}

fn tiff_in_a_circle() -> Vec<u8> {
    let mut tiff = b"II*\0\x08\0\0\0\x02\0".to_vec();
    for (tag, value) in [(256u16, 60_000u32), (257, 60_000)] {
        tiff.extend(tag.to_le_bytes());
        tiff.extend(4u16.to_le_bytes());
        tiff.extend(1u32.to_le_bytes());
        tiff.extend(value.to_le_bytes());
    }
    tiff.extend(8u32.to_le_bytes());
    tiff
}

fn drawings() -> Vec<(&'static str, String)> {
    let whole = |inside: &str| {
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='200' height='200'>\
             {inside}</svg>"
        )
    };
    let doubling = |name: &str, inside: &str| {
        let mut text = format!("<defs><g id='a0'>{inside}</g>");
        for i in 1..=30 {
            let _ = write!(text, "<g id='a{i}'><use xlink:href='#a{0}'/><use xlink:href='#a{0}'/></g>", i - 1);
        }
        let _ = write!(text, "</defs><use xlink:href='#a30' id='{name}'/>");
        text
    };
    let nested = |open: &str, close: &str, times: usize| {
        format!("{}<rect width='99' height='99'/>{}", open.repeat(times), close.repeat(times))
    };
    vec![
        ("of 2^30 uses", whole(&doubling("all", "<path d='M0 0h9v9z'/>"))),
        ("with a use of itself", whole("<g id='a'><use xlink:href='#a'/></g>")),
        ("with patterns in a circle", whole("<pattern id='p' width='9' height='9'><rect width='9' height='9' fill='url(#p)'/></pattern><rect width='99' height='99' fill='url(#p)'/>")),
        ("with masks in a circle", whole("<mask id='m'><rect width='9' height='9' mask='url(#m)'/></mask><rect width='99' height='99' mask='url(#m)'/>")),
        ("with a pattern of tiny tiles", whole("<pattern id='p' width='1e-6' height='1e-6' patternUnits='userSpaceOnUse'><rect width='1' height='1'/></pattern><rect width='200' height='200' fill='url(#p)'/>")),
        ("with a pattern of huge tiles", whole("<pattern id='p' width='1e9' height='1e9' patternUnits='userSpaceOnUse'><rect width='1e9' height='1e9'/></pattern><rect width='200' height='200' fill='url(#p)'/>")),
        ("blurred by 1e9", whole("<filter id='f' x='-1e6' y='-1e6' width='1e7' height='1e7'><feGaussianBlur stdDeviation='1e9'/></filter><rect width='99' height='99' filter='url(#f)'/>")),
        ("with a dilation by 1e6", whole("<filter id='f'><feMorphology operator='dilate' radius='1000000'/></filter><rect width='99' height='99' filter='url(#f)'/>")),
        ("with turbulence of 1e6 octaves", whole("<filter id='f'><feTurbulence baseFrequency='0.9' numOctaves='1000000'/></filter><rect width='200' height='200' filter='url(#f)'/>")),
        ("of 300 filtered groups", whole(&format!("<filter id='f'><feGaussianBlur stdDeviation='50'/></filter>{}", nested("<g filter='url(#f)'>", "</g>", 300)))),
        ("of 100000 nested groups", whole(&nested("<g>", "</g>", 100_000))),
        ("of 900 groups with opacity", whole(&nested("<g opacity='0.9'>", "</g>", 900))),
        ("with dashes of 1e-9", whole("<path d='M0 0L200 200' stroke='black' stroke-dasharray='1e-9 1e-9'/>")),
        ("with dashes over 1e9", whole("<path d='M0 0L1e9 1e9' stroke='black' stroke-dasharray='1 1'/>")),
        ("with an arc of 1e38", whole("<path d='M0 0A1e38 1e38 0 0 1 9 9' stroke='black' fill='none'/>")),
        ("with an arc of 1e30", whole("<path d='M0 0A1e30 1e30 0 1 1 9 9' stroke='black' fill='none'/>")),
        ("with a circle of 1e38", whole("<circle r='1e38' stroke='black'/>")),
        ("with a stroke of 1e30", whole("<path d='M0 0C1e30 0 0 1e30 9 9' stroke='black' stroke-width='1e30'/>")),
        ("scaled by 1e30", whole("<g transform='scale(1e30)'><path d='M0 0h9v9z'/></g>")),
        ("scaled by 1e-30", whole("<g transform='scale(1e-30)'><path d='M0 0h9v9z' stroke='black'/></g>")),
        ("with a matrix of NaN", whole("<g transform='matrix(NaN NaN 1 1 1 1)'><path d='M0 0h9v9z'/></g>")),
        ("1e9 wide", "<svg xmlns='http://www.w3.org/2000/svg' width='1e9' height='1e9'><rect width='9' height='9'/></svg>".to_owned()),
        ("1e-9 wide", "<svg xmlns='http://www.w3.org/2000/svg' width='1e-9' height='1e-9'><rect width='9' height='9'/></svg>".to_owned()),
        ("with a viewBox of 1e38", "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100' viewBox='-1e38 -1e38 1e38 1e38'><rect width='9' height='9'/></svg>".to_owned()),
        ("of 300000 paths", whole(&"<path d='M1 1h9v9z'/>".repeat(300_000))),
        ("of one path of 1000000 corners", whole(&format!("<path d='M0 0{}'/>", (0..1_000_000).fold(String::new(), |mut text, i| {
            let _ = write!(text, "L{} {}", i * 7919 % 200, i * 104_729 % 200);
            text
        })))),
        ("of one stroke of 200000 curves", whole(&format!("<path fill='none' stroke='black' stroke-width='0.1' d='M0 0{}'/>", (0..200_000).fold(String::new(), |mut text, i| {
            let _ = write!(text, "C{} {} {} {} {} {}", i * 7919 % 200, i * 104_729 % 200, i * 31 % 200, i * 57 % 200, i * 91 % 200, i * 11 % 200);
            text
        })))),
        ("with an entity of 10^9 letters", format!(
            "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">{}]><svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><text>&j;</text></svg>",
            ('b'..='j').zip('a'..).fold(String::new(), |mut text, (new, old)| {
                let _ = write!(text, "<!ENTITY {new} \"{}\">", format!("&{old};").repeat(10));
                text
            })
        )),
        ("with a picture inside that is 60000 x 60000", whole(&format!("<image width='99' height='99' xlink:href='data:image/png;base64,{}'/>", BASE64_STANDARD.encode(png(60_000, 60_000, &[]))))),
        ("with a drawing inside a drawing, 40 deep", (0..40).fold(whole("<rect width='9' height='9'/>"), |svg, _| if svg.len() > 4 << 20 { svg } else {
            whole(&format!("<image width='99' height='99' xlink:href='data:image/svg+xml;base64,{}'/>", BASE64_STANDARD.encode(svg)))
        })),
        ("with a text of 1000000 letters", whole(&format!("<text y='20' font-family='DejaVu Sans'>{}</text>", "a ".repeat(500_000)))),
        ("with a text of size 1e9", whole("<text y='20' font-size='1e9' font-family='DejaVu Sans'>apple</text>")),
        ("with 100000 rules of style", whole(&format!("<style>{}</style><rect class='c1' width='9' height='9'/>", (0..100_000).fold(String::new(), |mut text, i| {
            let _ = write!(text, ".c{i} {{fill:red}} g > .c{i} * {{fill:blue}} ");
            text
        })))),
    ]
}

/// A document of these objects, numbered from 1; the first is the catalogue.
fn pdf(objects: &[Vec<u8>]) -> Vec<u8> {
    let mut pdf = b"%PDF-1.7\n".to_vec();
    let mut offsets = Vec::new();
    for (number, object) in (1..).zip(objects) {
        offsets.push(pdf.len());
        pdf.extend(format!("{number} 0 obj\n").bytes());
        pdf.extend(object);
        pdf.extend(b"\nendobj\n");
    }
    let start = pdf.len();
    pdf.extend(format!("xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1).bytes());
    for offset in offsets {
        pdf.extend(format!("{offset:010} 00000 n \n").bytes());
    }
    pdf.extend(format!("trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{start}\n%%EOF\n", objects.len() + 1).bytes());
    pdf
}

fn stream(dictionary: &str, data: &[u8]) -> Vec<u8> {
    let mut object = format!("<< {dictionary} /Length {} >>\nstream\n", data.len()).into_bytes();
    object.extend(data);
    object.extend(b"\nendstream");
    object
}

fn documents() -> Result<Vec<(&'static str, Vec<u8>)>, Fault> {
    let object = |text: &str| text.as_bytes().to_vec();
    let with = |resources: &str, others: Vec<Vec<u8>>, content: &str| {
        let mut objects = vec![
            object("<< /Type /Catalog /Pages 2 0 R >>"),
            object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),
            object(&format!(
                "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 200 200] /Contents 4 0 R /Resources << {resources} >> >>"
            )),
            stream("", content.as_bytes()),
        ];
        objects.extend(others);
        pdf(&objects)
    };
    let form = |inside: &str, resources: &str| {
        stream(
            &format!("/Type /XObject /Subtype /Form /BBox [0 0 200 200] /Resources << {resources} >>"),
            inside.as_bytes(),
        )
    };
    // each form draws the next one ten times
    let tenfold = (0..12).map(|i| {
        let next = 6 + i;
        let inside = if i == 11 { "0 0 9 9 re f".to_owned() } else { "/F Do ".repeat(10) };
        form(&inside, &if i == 11 { String::new() } else { format!("/XObject << /F {next} 0 R >>") })
    });
    let catalogue = object("<< /Type /Catalog /Pages 2 0 R >>");
    Ok(vec![
        (
            "whose pages are their own children",
            pdf(&[catalogue.clone(), object("<< /Type /Pages /Kids [2 0 R 2 0 R] /Count 1000000 /Parent 2 0 R >>")]),
        ),
        (
            "whose length is itself",
            pdf(&[
                catalogue.clone(),
                object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),
                object("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 200 200] /Contents 4 0 R >>"),
                b"<< /Length 4 0 R >>\nstream\n0 0 9 9 re f\nendstream".to_vec(),
            ]),
        ),
        (
            "with a form that draws itself",
            with("/XObject << /F 5 0 R >>", vec![form("/F Do /F Do", "/XObject << /F 5 0 R >>")], "/F Do"),
        ),
        ("with 10^11 forms", with("/XObject << /F 5 0 R >>", tenfold.collect(), "/F Do")),
        ("with 1 GB of zeros as content", {
            let zeros = zlib_of_zeros(1 << 30)?;
            pdf(&[
                catalogue.clone(),
                object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),
                object("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 200 200] /Contents 4 0 R >>"),
                stream("/Filter /FlateDecode", &zeros),
            ])
        }),
        ("with an object stream of 1 GB of zeros", {
            let zeros = zlib_of_zeros(1 << 30)?;
            pdf(&[
                object("<< /Type /Catalog /Pages 7 0 R >>"),
                stream("/Type /ObjStm /N 100000 /First 800000 /Filter /FlateDecode", &zeros),
            ])
        }),
        (
            "with a picture of 60000 x 60000",
            with(
                "/XObject << /F 5 0 R >>",
                vec![stream(
                    "/Type /XObject /Subtype /Image /Width 60000 /Height 60000 /BitsPerComponent 8 /ColorSpace /DeviceRGB /Filter /FlateDecode",
                    &zlib_of_zeros(64 << 20)?,
                )],
                "200 0 0 200 0 0 cm /F Do",
            ),
        ),
        (
            "1e9 wide",
            pdf(&[
                catalogue.clone(),
                object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),
                object("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 1000000000 1000000000] /Contents 4 0 R >>"),
                stream("", b"0 0 9 9 re f"),
            ]),
        ),
        (
            "with a tiling pattern of 1e-4",
            with(
                "/Pattern << /P 5 0 R >>",
                vec![stream(
                    "/Type /Pattern /PatternType 1 /PaintType 1 /TilingType 1 /BBox [0 0 1 1] /XStep 0.0001 /YStep 0.0001 /Resources << >>",
                    b"0 0 1 1 re f",
                )],
                "/Pattern cs /P scn 0 0 200 200 re f",
            ),
        ),
        ("with 200000 saved states", with("", vec![], &"q ".repeat(200_000))),
        ("with 100000 nested arrays", with("", vec![], &"[".repeat(100_000))),
        ("with a dash of 1e-6", with("", vec![], "[0.000001 0.000001] 0 d 0 0 m 200 200 l S")),
    ])
}
