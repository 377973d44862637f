//! Pictures that cannot be converted, and limits.

use std::io::{Read, Write};
use std::process::Stdio;

use crate::cli::common::*;

#[test]
fn each_bad_picture_has_its_own_line() {
    let place = Place::new();
    let unknown =
        "this is not a picture in a format that is read here (JPEG, PNG, WebP, TIFF, BMP, GIF, PNM, SVG, PDF)";
    let cut = |format| {
        format!(
            "the {format} picture cannot be read: the file ends before the picture does; \
             open and save it again in another program, or use another copy"
        )
    };
    let few = |size| format!("the picture has {size} pixels: too few to find anything in; give one of at least 8 x 8");
    let strip = "the picture has 40 x 4000 pixels: so long and narrow a picture would be only";
    let palette = "the PNG picture cannot be read: its palette (chunk PLTE at byte 33) has 7 bytes, and a colour takes 3; \
        open and save it again in another program, or use another copy\n";
    let cases: [(&str, &[u8], &str); 10] = [
        ("empty.png", b"", "the file is empty; give a picture\n"),
        ("text.png", b"Dear reader,\nthis is a letter.\n", &format!("{unknown}; it looks like text\n")),
        ("noise.png", &[0x13, 0x9b, 0xf0, 0x02, 0x77], &format!("{unknown}\n")),
        ("head.jpg", &jpeg()[..20], &format!("{}\n", cut("JPEG"))),
        ("half.jpg", &jpeg()[..300], &format!("{}\n", cut("JPEG"))),
        ("half.png", &picture()[..60], &format!("{}\n", cut("PNG"))),
        ("palette.png", &png_with_broken_palette(), palette),
        ("dot.png", &png(1, 1, &[0; 3]), &format!("{}\n", few("1 x 1"))),
        ("hair.png", &png(1, 10_000, &[0; 30_000]), &format!("{}\n", few("1 x 10000"))),
        ("strip.png", &png(40, 4000, &[0; 480_000]), strip), // how narrow depends on the profile
    ];
    for (name, bytes, begins) in cases {
        place.put(name, bytes);
        place.put("p.svg", b"old");
        let run = place.run(&["convert", name, "-o", "p.svg"]);
        assert_eq!((run.code, run.out.as_str()), (1, ""), "{name}: {}", run.err);
        assert!(run.err.starts_with(&format!("tactograph: {name}: {begins}")), "{name}: {}", run.err);
        assert_eq!(run.err.lines().count(), 1, "{name}: {}", run.err);
        assert_eq!(place.text("p.svg"), "old", "{name}");
    }
    place.put("whole.jpg", &jpeg());
    assert_eq!(place.run(&["convert", "whole.jpg"]).code, 0);
    place.refuses(&["convert", "."], 1, &[".: this is a directory; name the files in it"]);
    let line = "empty.png/x.png: a part of this path is a file, not a directory; check the name";
    place.refuses(&["convert", "empty.png/x.png", "-o", "-"], 1, &[line]);
}

#[test]
fn a_huge_picture_is_refused_by_its_header() {
    let place = Place::new();
    place.put("huge.png", &png_header(30_000, 30_000));
    let line = "huge.png: the picture has 30000 x 30000 pixels, which is over the limit of 300 megapixels; \
        make it smaller in a picture editor first, or raise the limit with --max-megapixels";
    place.refuses(&["convert", "huge.png"], 1, &[line]);
    assert_eq!(place.names(), ["huge.png"]);
}

#[test]
fn limits_can_be_set() {
    let place = Place::new();
    place.put("a.png", &png_header(1500, 1000));
    let line = "a.png: the picture has 1500 x 1000 pixels, which is over the limit of 1 megapixels; \
        make it smaller in a picture editor first, or raise the limit with --max-megapixels";
    place.refuses(&["convert", "a.png", "--max-megapixels", "1"], 1, &[line]);
    // A BMP is decoded as a whole: 1000 x 400 pixels of 3 bytes are over 1 MB.
    let mut bmp = b"BM\x36\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0".to_vec();
    bmp.extend([1000_u32.to_le_bytes(), 400_u32.to_le_bytes()].concat());
    bmp.extend(b"\x01\0\x18\0");
    bmp.resize(900_000, 0);
    place.put("m.bmp", &bmp);
    let run = place.run(&["convert", "m.bmp", "--max-memory", "1"]);
    assert!(run.err.starts_with("tactograph: m.bmp: decoding this BMP of 1000 x 400 pixels would take"), "{}", run.err);
    assert!(
        run.err.ends_with(
            "over the limit of 1 MB; make it smaller in a picture editor first, or raise the limit with --max-memory\n"
        ),
        "{}",
        run.err
    );
    assert_eq!((run.code, run.err.lines().count()), (1, 1));
    place.put("b.png", &vec![b'x'; 1_000_001]);
    let line = "b.png: the file is longer than the memory limit of 1 MB; raise it with --max-memory";
    place.refuses(&["convert", "b.png", "--max-memory", "1"], 1, &[line]);
    for option in ["--max-megapixels", "--max-memory"] {
        for value in ["0", "1000001", "many", "1.5"] {
            let run = place.run(&["convert", "a.png", option, value]);
            let ends = "give a whole number from 1 to 1000000; see tactograph convert --help\n";
            assert!(run.code == 2 && run.err.ends_with(ends), "{option} {value}: {}", run.err);
            assert!(run.err.contains(option) && run.err.lines().count() == 1, "{option} {value}: {}", run.err);
        }
    }
}

#[test]
fn an_endless_input_stops_at_the_limit() {
    let place = Place::new();
    let mut command = place.command(&["convert", "-", "--max-memory", "1"]);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    let mut input = child.stdin.take().expect("its input");
    while input.write_all(&[b'x'; 4096]).is_ok() {} // until the program has had enough
    let mut err = String::new();
    child.stderr.take().expect("its messages").read_to_string(&mut err).expect("text");
    let line = "standard input: the file is longer than the memory limit of 1 MB; raise it with --max-memory";
    assert_eq!(err, format!("tactograph: {line}\n"));
    assert_eq!(child.wait().expect("it ends").code(), Some(1));
}
