//! The whole files that are damaged: samples, the test pictures of every format, pages, profiles and lists of labels.

use std::path::Path;

use tactograph::{Options, Profile};

use crate::Fault;

/// What a file is given to the program as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Input {
    /// A picture to convert.
    Picture,
    /// One whose texts become labels, as `--labels texts`.
    Lettered,
    /// A page to render, check and describe.
    Page,
    /// Lines for a picture, as `--lines`.
    Lines,
    /// Areas for a picture, as `--regions`.
    Areas,
    /// Labels, as `--labels`.
    Labels,
    /// A profile of one's own.
    Profile,
}

impl Input {
    const ALL: [(Self, &str); 7] = [
        (Self::Picture, "picture"),
        (Self::Lettered, "lettered"),
        (Self::Page, "page"),
        (Self::Lines, "lines"),
        (Self::Areas, "areas"),
        (Self::Labels, "labels"),
        (Self::Profile, "profile"),
    ];

    /// Its name between processes.
    pub(crate) fn name(self) -> &'static str {
        Self::ALL.iter().find(|(input, _)| *input == self).map_or("", |(_, name)| name)
    }

    pub(crate) fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| *known == name).map(|(input, _)| *input)
    }
}

/// A whole file.
#[derive(Debug)]
pub(crate) struct Seed {
    pub(crate) name: String,
    /// Its row in the table: the format of a picture, or the kind of input.
    pub(crate) row: String,
    pub(crate) input: Input,
    /// Whether it is text, to be damaged as such.
    pub(crate) is_text: bool,
    pub(crate) bytes: Vec<u8>,
}

/// Formats of pictures by the endings of their names.
const FORMATS: [(&str, &str); 12] = [
    ("png", "PNG"),
    ("jpg", "JPEG"),
    ("webp", "WebP"),
    ("tif", "TIFF"),
    ("bmp", "BMP"),
    ("gif", "GIF"),
    ("pbm", "PNM"),
    ("pgm", "PNM"),
    ("ppm", "PNM"),
    ("svg", "SVG"),
    ("svgz", "SVGZ"),
    ("pdf", "PDF"),
];

/// All seeds, in the order of their names.
pub(crate) fn all(root: &Path) -> Result<Vec<Seed>, Fault> {
    let mut seeds = Vec::new();
    let read = |path: &Path| std::fs::read(path).map_err(|fault| format!("{}: {fault}", path.display()));
    for folder in ["tests/pictures", "samples", "samples/worksheet"] {
        let mut paths: Vec<_> = std::fs::read_dir(root.join(folder))?
            .map(|entry| entry.map(|entry| entry.path()))
            .collect::<Result<_, _>>()?;
        paths.sort();
        for path in paths {
            let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
            let Some((_, row)) = FORMATS.iter().find(|(known, _)| *known == ending) else { continue };
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let bytes = read(&path)?;
            seeds.push(Seed {
                name,
                row: (*row).to_owned(),
                input: Input::Picture,
                is_text: matches!(ending, "svg" | "pdf"),
                bytes,
            });
        }
    }
    let text = |name: &str, row: &str, input, text: &str| Seed {
        name: name.to_owned(),
        row: row.to_owned(),
        input,
        is_text: true,
        bytes: text.into(),
    };
    let chart = read(&root.join("samples/chart.svg"))?;
    for profile in ["swell-a4", "index-basic-d", "graphiti"] {
        let options = Options::new(Profile::named(profile)?).title("Favourite fruit");
        let page = tactograph::convert(&chart, &options)?.page.to_svg();
        seeds.push(text(&format!("page-{profile}.svg"), "pages", Input::Page, &page));
        if profile == "swell-a4" {
            seeds.push(text("lines.svg", "--lines", Input::Lines, &page));
            seeds.push(text("regions.svg", "--regions", Input::Areas, &page));
        }
    }
    seeds.push(Seed {
        name: "lines.png".into(),
        row: "--lines".into(),
        input: Input::Lines,
        is_text: false,
        bytes: read(&root.join("tests/pictures/grey.png"))?,
    });
    seeds.push(text("labels.csv", "--labels", Input::Labels, LABELS));
    for profile in Profile::built_in() {
        seeds.push(text(&format!("{}.toml", profile.name), "profiles", Input::Profile, profile.text));
    }
    seeds.push(text("own.toml", "profiles", Input::Profile, OWN));
    Ok(seeds)
}

const LABELS: &str = "x,y,text\n10%,20%,apple\n412.5,30,\"pear, \"\"ripe\"\"\"\n50%;50%;Zürich\n90%,90%,3,5 km\n";
const OWN: &str =
    "inherits = \"swell-a4\"\n[page]\nmargin = 15.0\n[lines]\nwidth_max = 1.2\n[textures]\nacross = 4.5\n";
