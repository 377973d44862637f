//! A place to run the program in, and small pictures for it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use tempfile::TempDir;

/// How one run of the program ended.
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// A directory of its own, in which the program is run so that messages hold short names.
pub(crate) struct Place(TempDir);

impl Place {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary directory"))
    }

    /// A place with a good picture in it.
    pub(crate) fn with_picture(name: &str) -> Self {
        let place = Self::new();
        place.put(name, &picture());
        place
    }

    /// A place with a drawing, half blue and half white, and the page of it.
    pub(crate) fn with_sea() -> Self {
        let place = Self::new();
        let drawing = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\">\
             <rect width=\"300\" height=\"200\" fill=\"#fff\"/><rect width=\"150\" height=\"200\" fill=\"#24c\"/></svg>";
        place.put("sea.svg", drawing.as_bytes());
        let run = place.run(&["convert", "sea.svg", "-o", "page.svg", "-q"]);
        assert_eq!(run.code, 0, "{}", run.err);
        place
    }

    pub(crate) fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, bytes: &[u8]) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().expect("a parent")).expect("the directory");
        fs::write(path, bytes).expect("the file");
    }

    pub(crate) fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Names of everything here, sorted; shows leftovers.
    pub(crate) fn names(&self) -> Vec<String> {
        let mut names = fs::read_dir(self.0.path())
            .expect("the directory")
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect::<Vec<_>>();
        names.sort();
        names
    }

    pub(crate) fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tactograph"));
        command.current_dir(self.0.path()).args(args).stdin(Stdio::null());
        command
    }

    pub(crate) fn run(&self, args: &[&str]) -> Run {
        ended(self.command(args).output().expect("the program starts"))
    }

    pub(crate) fn run_with_input(&self, args: &[&str], input: &[u8]) -> Run {
        let mut command = self.command(args);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("the program starts");
        child.stdin.take().expect("its input").write_all(input).expect("it reads");
        ended(child.wait_with_output().expect("it ends"))
    }

    /// The run fails with this code and says exactly these lines.
    #[track_caller]
    pub(crate) fn refuses(&self, args: &[&str], code: i32, lines: &[&str]) {
        let run = self.run(args);
        let expected = lines.iter().map(|line| format!("tactograph: {line}\n")).collect::<String>();
        assert_eq!((run.code, run.err.as_str()), (code, expected.as_str()), "{args:?}");
        assert_eq!(run.out, "", "{args:?} wrote to standard output");
    }

    /// A file is a page.
    #[track_caller]
    pub(crate) fn has_page(&self, name: &str) {
        assert_is_page(&self.text(name), name);
    }
}

#[track_caller]
pub(crate) fn assert_is_page(text: &str, name: &str) {
    let page = roxmltree::Document::parse(text).unwrap_or_else(|error| panic!("{name} is not XML: {error}"));
    let ids = page.descendants().filter_map(|node| node.attribute("id")).collect::<Vec<_>>();
    assert!(page.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg")), "{name} is no SVG");
    assert!(ids.contains(&"figure"), "{name} has no figure");
}

pub(crate) fn ended(output: std::process::Output) -> Run {
    Run {
        code: output.status.code().expect("no signal"),
        out: String::from_utf8(output.stdout).expect("text"),
        err: String::from_utf8(output.stderr).expect("text"),
    }
}

/// A red square on white, 120 x 90 pixels.
pub(crate) fn picture() -> Vec<u8> {
    let red = |x: u32, y: u32| (30..80).contains(&x) && (20..70).contains(&y);
    let pixels = (0..90).flat_map(|y| (0..120).flat_map(move |x| if red(x, y) { [200, 20, 20] } else { [255; 3] }));
    png(120, 90, &pixels.collect::<Vec<_>>())
}

pub(crate) fn png(width: u32, height: u32, rgb: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(rgb).expect("the pixels");
    writer.finish().expect("the end");
    bytes
}

/// A PNG whose palette has a byte too many; png 0.18.1 panics on it.
pub(crate) fn png_with_broken_palette() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 20, 20);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_palette([9; 7].as_slice());
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[1; 400]).expect("the pixels");
    writer.finish().expect("the end");
    bytes
}

/// A PNG that claims a size and has no pixels.
pub(crate) fn png_header(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    drop(encoder.write_header().expect("a header"));
    bytes
}

pub(crate) const DRAWING: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="120" height="90">
<rect width="120" height="90" fill="#fff"/><rect x="30" y="20" width="50" height="50" fill="#c22"/></svg>
"##;

/// A JPEG of 64 x 64 pixels, white above a diagonal and black below it.
pub(crate) fn jpeg() -> Vec<u8> {
    let digits = JPEG.split_whitespace().collect::<String>();
    let bytes = (0..digits.len()).step_by(2).map(|at| u8::from_str_radix(&digits[at..at + 2], 16).expect("hex digits"));
    bytes.collect()
}

const JPEG: &str = "
    ffd8ffe000104a46494600010100000100010000ffdb00831000500037003c0046003c00320050004600410046005a00550050005f0078
    00c800820078006e006e007800f500af00b9009100c8012200ff0131012c011d00ff011801130140016801cc01860140015401b3015901
    13011801900221019501b301db01ea020302080203013601810235025d023001f4025801cc01f9020301efffc1000b0800400040010111
    00ffc40017000101010100000000000000000000000000040502ffc4001c10010002010500000000000000000000000001030411122241
    51ffda0008010100003f00e7132b6e95d93c7a9f178003155e2656dd2bb278f53e2f0018a2bc4cadba5764f1ea7c5e00c50578995b74ae
    c9e3d4f8bc06280af132b6e95d93c7a9f178314015e2656dd2bb278f53e2f18a002bc4cadba5764f1ea7c5ec5000578995b74aec9e3d4f
    8fffd9";

// So that a wrong helper is not taken for a wrong program.
#[test]
fn the_test_pictures_are_what_they_claim() {
    let decoder = png::Decoder::new(std::io::Cursor::new(picture()));
    let size = decoder.read_info().expect("a PNG").info().size();
    assert_eq!(size, (120, 90));
    let huge = png_header(30_000, 30_000);
    assert!(huge.len() < 100 && huge.starts_with(b"\x89PNG"));
    assert!(Path::new(env!("CARGO_BIN_EXE_tactograph")).exists());
}
