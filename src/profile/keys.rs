//! The table of all keys. From it come the typed fields of [`Profile`], the list behind [`Profile::keys`], and what
//! reading, checking and documenting a profile need, so that a key is added in one place. The values themselves are
//! in `profiles/*.toml`, each with its reason; the ranges here only keep out what can be no page at all.

use super::Origin;
use super::key::{DEVICES, Key, Kind};
use crate::devices::Device;
use crate::page::layout::Orientation;
use crate::textures::Sign;

macro_rules! field {
    (switch) => {
        bool
    };
    (orientation) => {
        Orientation
    };
    (device) => {
        Option<&'static Device>
    };
    (sign) => {
        Sign
    };
    (number) => {
        f32
    };
}

macro_rules! blank {
    (switch) => {
        false
    };
    (orientation) => {
        Orientation::Auto
    };
    (device) => {
        None
    };
    (sign) => {
        Sign::Dot
    };
    (number) => {
        f32::NAN
    };
}

macro_rules! kind {
    (switch) => {
        Kind::Switch
    };
    (orientation) => {
        Kind::Choice(&Orientation::NAMES)
    };
    (device) => {
        Kind::Choice(&DEVICES)
    };
    (sign) => {
        Kind::Sign
    };
    (number $low:literal $high:literal $unit:literal) => {
        Kind::Number { low: $low, high: $high, unit: $unit }
    };
}

macro_rules! in_words {
    (switch) => {
        ""
    };
    (orientation) => {
        ""
    };
    (device) => {
        ""
    };
    (sign) => {
        ""
    };
    (number $low:literal $high:literal "") => {
        concat!(" From ", $low, " to ", $high, ".")
    };
    (number $low:literal $high:literal $unit:literal) => {
        concat!(" From ", $low, " to ", $high, " ", $unit, ".")
    };
}

/// How a section is written in a profile: the palette is a part of the textures.
macro_rules! section_path {
    (palette) => {
        "textures.palette"
    };
    ($section:ident) => {
        stringify!($section)
    };
}

macro_rules! table {
    ($(
        #[doc = $section_doc:literal]
        $section:ident: $settings:ident {
            $( #[doc = $doc:literal] $key:ident: $kind:ident $(($low:tt to $high:tt, $unit:tt))?; )+
        }
    )+) => {
        $(
            #[doc = $section_doc]
            #[derive(Debug, Clone, Copy, PartialEq)]
            pub struct $settings {
                $(
                    #[doc = concat!($doc, in_words!($kind $($low $high $unit)?))]
                    pub $key: field!($kind),
                )+
            }
        )+

        /// Everything about a page that its maker can choose. Got from [`Profile::named`] or [`Profile::from_toml`].
        #[derive(Debug, Clone)]
        pub struct Profile {
            /// What the profile is called: its built-in name, or the file's name without path and ending.
            pub name: String,
            /// What it is for, in one line.
            pub description: String,
            $(
                #[doc = $section_doc]
                pub $section: $settings,
            )+
            /// Where each key of [`KEYS`] got its value.
            pub(super) origins: Vec<Origin>,
        }

        impl Profile {
            /// A profile that holds nothing yet: no number is a number.
            pub(super) fn blank(name: String) -> Self {
                Self {
                    name,
                    description: String::new(),
                    $($section: $settings { $($key: blank!($kind)),+ },)+
                    origins: vec![Origin::default(); KEYS.len()],
                }
            }
        }

        /// Every section, in the order of the table.
        pub(super) const SECTIONS: &[&str] = &[$(section_path!($section)),+];

        /// Every section with what it is about, in the order of the table.
        pub(super) fn section_docs() -> impl Iterator<Item = (&'static str, &'static str)> {
            [$((section_path!($section), $section_doc.trim_ascii())),+].into_iter()
        }

        /// Every key, in the order of the table.
        pub(super) const KEYS: &[Key] = &[$($(Key {
            path: concat!(section_path!($section), ".", stringify!($key)),
            doc: $doc.trim_ascii(),
            kind: kind!($kind $($low $high $unit)?),
            get: |profile| profile.$section.$key.into(),
            slot: |profile| (&mut profile.$section.$key).into(),
        }),+),+];
    };
}

table! {
    /// The sheet of paper.
    page: PageSettings {
        /// Width of the sheet, which is turned as the orientation says.
        width: number(60.0 to 1200.0, "mm");
        /// Height of the sheet, which is turned as the orientation says.
        height: number(60.0 to 1200.0, "mm");
        /// Which way up the sheet lies; "auto" is the way in which the picture becomes larger.
        orientation: orientation;
        /// Blank margin on all four sides.
        margin: number(0.0 to 100.0, "mm");
    }
    /// The band of fine dots round the figure, and round the overview.
    frame: FrameSettings {
        /// Whether figure and overview have a frame.
        on: switch;
        /// Width of the band.
        width: number(0.5 to 20.0, "mm");
        /// Diameter of its dots.
        dot: number(0.3 to 3.0, "mm");
        /// Distance from the centre of a dot to the centre of the next.
        pitch: number(0.6 to 10.0, "mm");
        /// Blank between the frame and the picture.
        gap: number(0.0 to 50.0, "mm");
    }
    /// The short bar across the top right corner of the sheet, by which fingers find the right way up.
    mark: MarkSettings {
        /// Whether there is one.
        on: switch;
        /// Length of the bar.
        length: number(3.0 to 50.0, "mm");
        /// Width of the bar.
        width: number(0.3 to 10.0, "mm");
        /// Least blank between the bar and the frame.
        gap: number(0.0 to 50.0, "mm");
    }
    /// A picture that is spread over several sheets.
    sheets: SheetsSettings {
        /// How much of the picture is on two neighbouring sheets.
        overlap: number(5.0 to 60.0, "mm");
    }
    /// The large picture, with lines and textures.
    figure: FigureSettings {
        /// Whether contours are drawn.
        lines: switch;
        /// Whether colours are drawn.
        textures: switch;
        /// Working resolution, at most the picture's own.
        resolution: number(1.0 to 12.0, "px per mm");
        /// A picture whose shorter side would be smaller than this on the sheet is refused.
        min_side: number(3.0 to 100.0, "mm");
    }
    /// The smaller picture below the figure, lines only, for a quick first impression.
    overview: OverviewSettings {
        /// Whether there is one.
        on: switch;
        /// Its width and height as a share of the figure's.
        scale: number(0.1 to 1.0, "");
        /// Blank between the figure's frame and its own.
        gap: number(0.0 to 100.0, "mm");
    }
    /// Finding contours in the picture.
    edges: EdgesSettings {
        /// Sigma of the Gaussian derivative: details smaller than this are blurred away.
        scale: number(0.1 to 5.0, "mm");
        /// Height of a colour step down to which a contour is followed, chroma counted twice.
        low: number(0.5 to 300.0, "units of lightness");
        /// Height of a colour step that a contour must reach somewhere, chroma counted twice.
        high: number(0.5 to 300.0, "units of lightness");
        /// How strongly grass, gravel and other texture is kept from becoming contours; 0 is off.
        texture_suppression: number(0.0 to 1.0, "");
    }
    /// Drawing contours as lines.
    lines: LinesSettings {
        /// Width of the line of the weakest contour.
        width_min: number(0.3 to 10.0, "mm");
        /// Width of the line of a strong contour.
        width_max: number(0.3 to 10.0, "mm");
        /// Height of a colour step from which a line has its greatest width, chroma counted twice.
        full_strength: number(1.0 to 600.0, "units of lightness");
        /// How many lines are drawn: 0 the longest, strongest, closed and smooth ones only, 1 all that fingers can part.
        detail: number(0.0 to 1.0, "");
        /// Lines shorter than this are left out.
        min_length: number(0.0 to 200.0, "mm");
        /// Least blank between the edges of two lines.
        min_gap: number(0.5 to 30.0, "mm");
        /// Longest gap that is bridged between two ends that continue one another.
        join_gap: number(0.0 to 30.0, "mm");
        /// Sigma of the smoothing along a line.
        smoothing: number(0.0 to 5.0, "mm");
        /// How far a simplified line may lie from the traced one.
        tolerance: number(0.005 to 1.0, "mm");
    }
    /// Sorting colours into blue, green, yellow, red and grey.
    colours: ColoursSettings {
        /// Sigma of the blur before colours are sorted.
        blur: number(0.0 to 20.0, "mm");
        /// Whether the blur stops at contours, so that no area is stained by its neighbour.
        stop_at_lines: switch;
        /// Sigma of the smoothing of the borders between areas of different colours.
        smoothing: number(0.0 to 20.0, "mm");
        /// HSV saturation below which a colour counts as grey; dark colours need more, light ones less.
        min_saturation: number(0.0 to 1.0, "");
        /// HSV value below which a colour counts as black, which is drawn as grey.
        min_value: number(0.0 to 1.0, "");
        /// HSL lightness above which a colour counts as white, which has no texture.
        white_from: number(0.3 to 1.0, "");
        /// Areas of one colour that are smaller than this go to the neighbour that suits them best.
        min_area: number(0.0 to 5000.0, "square mm");
    }
    /// Drawing colours as textures of rhombuses, and grey as dots.
    textures: TexturesSettings {
        /// White between a line's edge and the nearest glyph.
        line_gap: number(0.0 to 30.0, "mm");
        /// Distance from a rhombus to the next in its row.
        along: number(1.0 to 20.0, "mm");
        /// Distance from a row of rhombuses to the next where the texture is dense.
        across: number(1.0 to 20.0, "mm");
        /// Length of the boldest rhombus, along its row.
        length: number(0.5 to 15.0, "mm");
        /// Thickness of the boldest rhombus.
        thickness: number(0.3 to 10.0, "mm");
        /// Diameter of the boldest dot.
        dot: number(0.3 to 10.0, "mm");
        /// Distance from a dot to the next where the texture is dense.
        dot_pitch: number(1.0 to 20.0, "mm");
        /// Thickness of the lightest glyph; from there on glyphs grow with the darkness of the colour.
        min_glyph: number(0.1 to 5.0, "mm");
        /// Sigma of the blur that turns lines into a density map.
        density_blur: number(0.5 to 50.0, "mm");
        /// Density of lines from which the texture is dense; 1 is a lone straight line on itself.
        dense_from: number(0.0 to 1.0, "");
        /// Whether colours between two classes are told: their rhombuses point in the neighbouring class's direction.
        fringe: switch;
    }
    /// Which class is told by which sign.
    palette: PaletteSettings {
        /// The sign of blue, cyan and violet.
        blue: sign;
        /// The sign of green and olive.
        green: sign;
        /// The sign of yellow, light orange and light brown.
        yellow: sign;
        /// The sign of red, pink and purple.
        red: sign;
        /// The sign of black, greys and weakly saturated colours.
        grey: sign;
    }
    /// Pages of dots, for embossers and pin displays: widths of lines, and sizes and rows of textures, are then those of the device.
    dots: DotsSettings {
        /// What presses the page; with "none" it is printed.
        device: device;
        /// Distance of dots along a line, and of the columns and rows of a grid; one that the device has.
        pitch: number(1.0 to 10.0, "mm");
        /// Empty dots between two lines, at least.
        line_gap: number(1.0 to 10.0, "dots");
        /// Empty dots between a line and a texture; one is enough in areas that would lose more than half of their texture otherwise.
        texture_gap: number(0.0 to 10.0, "dots");
        /// Height of a colour step from which a line is two dots wide, or higher where the device has heights.
        heavy_from: number(1.0 to 600.0, "units of lightness");
    }
    /// Printing and swelling.
    print: PrintSettings {
        /// How much wider a mark is once it has risen than it was printed: marks are printed narrower by this.
        swell: number(0.0 to 2.0, "mm");
        /// Share of the figure that may be black; the maker of a page with more is told so.
        max_black: number(0.0 to 1.0, "");
    }
}
