//! The other programs: which of them there are, and how each does the work.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::measured::Job;
use crate::ours::Ours;

/// Pixels across that the others make, as many as we work on for a swell-a4 page of a wide picture: 174 mm, 4 px each.
const ACROSS: &str = "696";

/// Names by which ImageMagick may be called; a plain `convert` can be something else.
const MAGICK: [&str; 3] = ["magick", "convert-im6.q16", "convert-im6"];

/// What is installed.
pub(crate) struct Peers {
    python: Option<PathBuf>,
    magick: Option<&'static str>,
    /// Names of what is not.
    pub(crate) missing: Vec<String>,
}

impl Peers {
    /// Looks for all of them.
    pub(crate) fn find(target: &Path) -> Self {
        let mut missing = Vec::new();
        let mut lacks = |name: &str| missing.push(name.to_owned());
        // Node.js runs our own library, as a browser would
        for program in ["djpeg", "vips", "potrace", "node"] {
            if !is_program(program) {
                lacks(program);
            }
        }
        let magick = MAGICK.into_iter().find(|name| is_program(name));
        if magick.is_none() {
            lacks("ImageMagick");
        }
        let python = target.join("bench/venv/bin/python");
        let works = Command::new(&python).args(["-c", "import cv2, vtracer"]).stderr(Stdio::null()).status();
        let python = works.is_ok_and(|ended| ended.success()).then_some(python);
        if python.is_none() {
            lacks("Python with OpenCV and vtracer");
        }
        Self { python, magick, missing }
    }

    /// Entropy decoding and a scaled inverse transform, no more: the floor for whoever reads a JPEG.
    pub(crate) fn djpeg(&self, picture: &Path, scale: &str) -> Option<Job> {
        let command = ["djpeg".as_ref(), "-scale".as_ref(), scale.as_ref(), picture.as_os_str()];
        is_program("djpeg").then(|| Job::new(&format!("djpeg -scale {scale}"), command))
    }

    pub(crate) fn vips(&self, picture: &Path, ours: &Ours) -> Option<Job> {
        let out = ours.page("vips.png");
        let command = ["vips".as_ref(), "thumbnail".as_ref(), picture.as_os_str(), out.as_os_str(), ACROSS.as_ref()];
        is_program("vips").then(|| Job::new("vips thumbnail", command).writes(&out))
    }

    pub(crate) fn magick(&self, picture: &Path, ours: &Ours) -> Option<Job> {
        let out = ours.page("magick.png");
        let [program, resize, across, canny, how] = [self.magick?, "-resize", ACROSS, "-canny", "0x1+10%+30%"];
        let command = [
            program.as_ref(),
            picture.as_os_str(),
            resize.as_ref(),
            across.as_ref(),
            canny.as_ref(),
            how.as_ref(),
            out.as_os_str(),
        ];
        Some(Job::new("ImageMagick -resize -canny", command).writes(&out))
    }

    /// Decoded at a quarter, made smaller, Canny.
    pub(crate) fn opencv(&self, picture: &Path, ours: &Ours) -> Option<Job> {
        self.script("OpenCV Canny in Python", "canny", picture, &ours.page("opencv.png"), &[ACROSS])
    }

    /// Outlines of all colours as SVG.
    pub(crate) fn vtracer(&self, picture: &Path, ours: &Ours) -> Option<Job> {
        self.script("vtracer", "vtracer", picture, &ours.page("vtracer.svg"), &[])
    }

    fn script(&self, name: &str, what: &str, picture: &Path, out: &Path, more: &[&str]) -> Option<Job> {
        let script = Path::new("tools/src/bin/bench_all/peers.py");
        let python = self.python.as_ref()?;
        let command = [python.as_os_str(), script.as_os_str(), what.as_ref(), picture.as_os_str(), out.as_os_str()];
        let more = more.iter().map(OsStr::new);
        Some(Job::new(name, command.into_iter().chain(more)).writes(out))
    }

    /// Outlines of the dark half as SVG. potrace reads no JPEG, so djpeg runs before it.
    pub(crate) fn potrace(&self, picture: &Path, ours: &Ours) -> Option<Job> {
        let out = ours.page("potrace.svg");
        let pipe = r#"djpeg -grayscale "$0" | potrace --svg --output "$1""#;
        let command = ["sh".as_ref(), "-c".as_ref(), pipe.as_ref(), picture.as_os_str(), out.as_os_str()];
        (is_program("djpeg") && is_program("potrace"))
            .then(|| Job::new("potrace (djpeg -grayscale before it)", command).writes(&out))
    }

    /// [`Peers::potrace`] of many pictures, one after the other.
    pub(crate) fn potrace_loop(&self, pictures: &[PathBuf], ours: &Ours) -> Option<Job> {
        let out = ours.page("potrace.svg");
        let pipe = r#"out=$0; for file; do djpeg -grayscale "$file" | potrace --svg --output "$out"; done"#;
        let command = ["sh".as_ref(), "-c".as_ref(), pipe.as_ref(), out.as_os_str()].map(OsString::from);
        let pictures = pictures.iter().map(|file| file.clone().into_os_string());
        (is_program("djpeg") && is_program("potrace"))
            .then(|| Job::new("djpeg and potrace in a shell loop", command.into_iter().chain(pictures)).writes(&out))
    }
}

fn is_program(name: &str) -> bool {
    let paths = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&paths).any(|folder| folder.join(name).is_file())
}
