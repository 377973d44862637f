//! The table of all keys. From it come the typed fields of [`Profile`], the list behind [`Profile::keys`], and what
//! reading, checking and documenting a profile need, so that a key is described in one place. The values themselves are
//! in `profiles/*.toml`, each with its reason; the ranges here only keep out what can be no page at all.

use super::built_in::built_in;
use super::fault::{Fault, has_decimal_comma, quoted_path};
use super::kind::{NumberRange, Setting, Value};
use crate::braille::{CellSize, Code, Grade};
use crate::devices::Device;
use crate::page::heading::Align;
use crate::page::layout::Orientation;
use crate::textures::Sign;

/// One key of a profile, such as `lines.width_max`.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// Section and name, joined by a point.
    pub path: &'static str,
    /// What it is for, in one line.
    pub doc: &'static str,
    /// From which to which number it goes; none for what is no number.
    pub limits: Option<NumberRange>,
    range: fn(Option<NumberRange>) -> String,
    choices: fn() -> Vec<Value>,
    get: fn(&Profile) -> Value,
    put: fn(&mut Profile, &Value, Option<NumberRange>) -> bool,
    takes: fn(&Value, Option<NumberRange>) -> bool,
    suggestion: fn(&str) -> Option<String>,
    blank: fn() -> Value,
}

impl Key {
    /// The section before the last point.
    pub fn section(&self) -> &'static str {
        self.path.rsplit_once('.').map_or("", |(section, _)| section)
    }

    /// The name after the last point.
    pub fn name(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |(_, name)| name)
    }

    /// What the profile holds under this key.
    pub fn value(&self, profile: &Profile) -> Value {
        (self.get)(profile)
    }

    /// What the key takes, in words: "a number from 0.3 to 10 mm", "true or false".
    pub fn range(&self) -> String {
        (self.range)(self.limits)
    }

    /// What there is to choose from, in the order of [`Key::range`]: `true` and `false`, the grades of braille, or the
    /// words that the key takes. Empty where that is no list: numbers between [limits](Key::limits), and signs of
    /// textures, whose directions are any angle.
    pub fn choices(&self) -> Vec<Value> {
        (self.choices)()
    }

    /// Is the value of the right kind and within the range?
    pub fn takes(&self, value: &Value) -> bool {
        (self.takes)(value, self.limits)
    }

    /// Is the value of the right kind, be it in the range or not?
    pub(super) fn is_of_kind(&self, value: &Value) -> bool {
        std::mem::discriminant(&(self.blank)()) == std::mem::discriminant(value)
    }

    /// Writes a value to the profile. One that the key does not take changes nothing and gives `false`.
    pub(super) fn put(&self, profile: &mut Profile, value: &Value) -> bool {
        (self.put)(profile, value, self.limits)
    }

    /// The fault of a value out of range or of the wrong kind; `got` names it.
    pub(super) fn refuse(&self, got: &str) -> String {
        let text = got.strip_prefix("the text ").unwrap_or(got).trim_matches('"');
        if let Some(suggestion) = (self.suggestion)(text) {
            return format!("{} cannot be {got}, {suggestion}", self.path);
        }
        let with_unit = self.limits.is_some_and(|limits| !limits.unit.is_empty() && text.ends_with(limits.unit));
        let advice = if with_unit {
            ", write it without the unit"
        } else if self.limits.is_some() && has_decimal_comma(got) {
            ", write a point for the decimal comma"
        } else {
            ""
        };
        format!("{} must be {}, not {got}{advice}", self.path, self.range())
    }
}

/// Where a key got its value.
#[derive(Debug, Clone, Default)]
pub(super) struct Origin {
    /// Which value was given before which: 0 for none at all, then counted up.
    pub(super) order: usize,
    /// Whether the value was taken; a refused one is in no rule.
    pub(super) held: bool,
    /// Whether the maker of this page gave it: in their own file or by `set`, not in what that file inherits.
    pub(super) own: bool,
    pub(super) place: String,
}

impl Profile {
    /// Are all these values given and in range?
    pub(super) fn sound(&self, paths: &[&str]) -> bool {
        let mut keys = KEYS.iter().zip(&self.origins).filter(|(key, _)| paths.contains(&key.path));
        keys.all(|(key, origin)| origin.held && key.takes(&key.value(self)))
    }

    /// A fault of these keys, where the one of them that was given last was given.
    pub(super) fn fault(&self, paths: &[&'static str], what: String) -> Fault {
        Fault::of_keys(paths, self.place(paths), what)
    }

    /// Where the one of these keys that was given last was given.
    pub(super) fn place(&self, paths: &[&str]) -> String {
        let origins = KEYS.iter().zip(&self.origins).filter(|(key, _)| paths.contains(&key.path));
        let last = origins.map(|(_, origin)| origin).max_by_key(|origin| origin.order);
        last.filter(|origin| origin.order > 0).map_or_else(|| self.name.clone(), |origin| origin.place.clone())
    }

    /// Where the maker of this profile gave this key: in its own file, or by [`Profile::set`]; none if it has what it
    /// inherits.
    pub(crate) fn own_place(&self, path: &str) -> Option<&str> {
        let index = KEYS.iter().position(|key| key.path == path)?;
        self.origins.get(index).filter(|origin| origin.own && origin.held).map(|origin| origin.place.as_str())
    }

    /// Gives the key at `index` of [`KEYS`] the value of a text such as `1.2`; a refused one changes nothing.
    pub(super) fn put_text(&mut self, index: usize, text: &str, place: String) -> Result<(), Fault> {
        let key = &KEYS[index];
        if !key.put(self, &Value::of_text(text)) {
            return Err(Fault::of_keys(&[key.path], place, key.refuse(&quoted_path(&[text]))));
        }
        let order = 1 + self.origins.iter().map(|origin| origin.order).max().unwrap_or(0);
        self.origins[index] = Origin { order, held: true, own: true, place };
        Ok(())
    }
}

/// Where in [`KEYS`] a key is. A profile asks for each of its keys, and only paths of that length are looked
/// into.
pub(super) fn position(section: &str, name: &str) -> Option<usize> {
    let length = section.len() + 1 + name.len();
    KEYS.iter().position(|key| key.path.len() == length && key.section() == section && key.name() == name)
}

/// The key that `true` or `false` in place of a whole section stands for.
pub(super) fn switch_of(section: &str) -> Option<usize> {
    position(section, "on")
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

/// None or one, as the table gives it.
const fn at_most_one(limits: &[NumberRange]) -> Option<NumberRange> {
    match limits {
        [limits, ..] => Some(*limits),
        [] => None,
    }
}

macro_rules! table {
    ($(
        $(#[doc = $section_doc:literal])+
        $section:ident: $settings:ident {
            $(
                $(#[doc = $doc:literal])+
                $key:ident: $kind:ty $(= $low:literal to $high:literal $(, $unit:literal)?)?;
            )+
        }
    )+) => {
        $(
            $(#[doc = $section_doc])+
            #[derive(Debug, Clone, Copy, PartialEq)]
            pub struct $settings {
                $(
                    #[doc = concat!($($doc),+ $(, " From ", $low, " to ", $high $(, " ", $unit)?, ".")?)]
                    pub $key: $kind,
                )+
            }
        )+

        /// Everything about a page that its maker can choose. Got from [`Profile::named`] or [`Profile::from_toml`];
        /// its values are read with [`Profile::get`] and written with [`Profile::set`].
        #[derive(Debug, Clone)]
        pub struct Profile {
            /// What the profile is called: its built-in name, or the file's name without path and ending.
            pub name: String,
            /// What it is for, in one line.
            pub description: String,
            $(
                // For the stages and this project's own tests. Others read and write by path, so that a profile knows
                // where each value came from: `set` says it in faults, and in what is written into the page.
                #[doc(hidden)]
                pub $section: $settings,
            )+
            /// The built-in profile that it inherits, itself or through files; the first of all where there is none.
            pub(super) base: &'static str,
            /// Where each key of [`KEYS`] got its value.
            pub(super) origins: Vec<Origin>,
        }

        impl Profile {
            /// A profile that holds nothing yet: no number is a number.
            pub(super) fn blank(name: String) -> Self {
                Self {
                    name,
                    description: String::new(),
                    $($section: $settings { $($key: <$kind as Setting>::BLANK),+ },)+
                    base: built_in()[0].name,
                    origins: vec![Origin::default(); KEYS.len()],
                }
            }
        }

        /// Every section, in the order of the table.
        pub(super) const SECTIONS: &[&str] = &[$(section_path!($section)),+];

        /// Every section with what it is about, in the order of the table.
        pub(super) fn section_docs() -> impl Iterator<Item = (&'static str, &'static str)> {
            [$((section_path!($section), concat!($($section_doc),+).trim_ascii())),+].into_iter()
        }

        /// Every key, in the order of the table.
        pub(super) const KEYS: &[Key] = &[$($(Key {
            path: concat!(section_path!($section), ".", stringify!($key)),
            doc: concat!($($doc),+).trim_ascii(),
            limits: at_most_one(&[$(NumberRange {
                low: $low,
                high: $high,
                unit: concat!("" $(, $unit)?),
                whole: <$kind as Setting>::WHOLE,
            })?]),
            range: <$kind as Setting>::range,
            choices: <$kind as Setting>::choices,
            get: |profile| profile.$section.$key.write(),
            put: |profile, value, limits| {
                let value = <$kind as Setting>::read(value, limits);
                let taken = value.is_some();
                profile.$section.$key = value.unwrap_or(profile.$section.$key);
                taken
            },
            takes: |value, limits| <$kind as Setting>::read(value, limits).is_some(),
            suggestion: <$kind as Setting>::suggestion,
            blank: || <$kind as Setting>::BLANK.write(),
        }),+),+];
    };
}

table! {
    /// The sheet of paper.
    page: PageSettings {
        /// Width of the sheet, which is turned as the orientation says.
        width: f32 = 60.0 to 1200.0, "mm";
        /// Height of the sheet, which is turned as the orientation says.
        height: f32 = 60.0 to 1200.0, "mm";
        /// Which way up the sheet lies; "auto" is the way in which the picture becomes larger.
        orientation: Orientation;
        /// Blank margin on all four sides.
        margin: f32 = 0.0 to 100.0, "mm";
    }
    /// The band of fine dots round the figure, and round the overview.
    frame: FrameSettings {
        /// Whether figure and overview have a frame.
        on: bool;
        /// Width of the band.
        width: f32 = 0.5 to 20.0, "mm";
        /// Diameter of its dots.
        dot: f32 = 0.3 to 3.0, "mm";
        /// Distance from the centre of a dot to the centre of the next.
        pitch: f32 = 0.6 to 10.0, "mm";
        /// Blank between the frame and the picture.
        gap: f32 = 0.0 to 50.0, "mm";
    }
    /// The short bar across the top right corner of the sheet, by which fingers find the right way up.
    mark: MarkSettings {
        /// Whether there is one.
        on: bool;
        /// Length of the bar.
        length: f32 = 3.0 to 50.0, "mm";
        /// Width of the bar.
        width: f32 = 0.3 to 10.0, "mm";
        /// Least blank between the bar and the frame.
        gap: f32 = 0.0 to 50.0, "mm";
    }
    /// A picture that is spread over several sheets.
    sheets: SheetsSettings {
        /// How much of the picture is on two neighbouring sheets.
        overlap: f32 = 5.0 to 60.0, "mm";
    }
    /// The large picture, with lines and textures.
    figure: FigureSettings {
        /// Whether contours are drawn.
        lines: bool;
        /// Whether colours are drawn.
        textures: bool;
        /// Whether the ground has a texture: the colour that most of the picture's edge has, where it reaches the edge.
        ground: bool;
        /// Working resolution, at most the picture's own; bitmaps on smaller prints have as many px as on 110 mm.
        resolution: f32 = 1.0 to 12.0, "px per mm";
        /// A picture whose shorter side would be smaller than this on the sheet is refused.
        min_side: f32 = 3.0 to 100.0, "mm";
    }
    /// The smaller picture below the figure, lines only, for a quick first impression.
    overview: OverviewSettings {
        /// Whether there is one.
        on: bool;
        /// Its width and height as a share of the figure's.
        scale: f32 = 0.1 to 1.0;
        /// Blank between the figure's frame and its own.
        gap: f32 = 0.0 to 100.0, "mm";
    }
    /// Finding contours in the picture.
    edges: EdgesSettings {
        /// Sigma of the Gaussian derivative: details smaller than this are blurred away.
        scale: f32 = 0.1 to 5.0, "mm";
        /// Height of a colour step down to which a contour is followed, chroma counted twice.
        low: f32 = 0.5 to 300.0, "units of lightness";
        /// Height of a colour step that a contour must reach somewhere, chroma counted twice.
        high: f32 = 0.5 to 300.0, "units of lightness";
        /// How strongly grass, gravel and other texture is kept from becoming contours; 0 is off.
        texture_suppression: f32 = 0.0 to 1.0;
    }
    /// Drawing contours as lines.
    lines: LinesSettings {
        /// Width of the line of the weakest contour.
        width_min: f32 = 0.3 to 10.0, "mm";
        /// Width of the line of a strong contour.
        width_max: f32 = 0.3 to 10.0, "mm";
        /// Height of a colour step from which a line has its greatest width, chroma counted twice.
        full_strength: f32 = 1.0 to 600.0, "units of lightness";
        /// How many lines are drawn: 0 the longest, strongest, closed and smooth ones only, 1 all that
        /// fingers can tell apart.
        detail: f32 = 0.0 to 1.0;
        /// Most shapes that are drawn, the most telling ones, and most other lines; 0 is no limit.
        shapes: usize = 0.0 to 100.0;
        /// Whether the most telling regions of a photograph are outlined, in figure and overview, before other
        /// contours are drawn.
        regions: bool;
        /// Lines shorter than this are left out.
        min_length: f32 = 0.0 to 200.0, "mm";
        /// Least blank between the edges of two lines.
        min_gap: f32 = 0.5 to 30.0, "mm";
        /// Longest gap that is bridged: between two ends that continue one another, and from an end to a line ahead of
        /// it.
        join_gap: f32 = 0.0 to 30.0, "mm";
        /// Sigma of the smoothing along a line.
        smoothing: f32 = 0.0 to 5.0, "mm";
        /// How far a simplified line may lie from the traced one.
        tolerance: f32 = 0.005 to 1.0, "mm";
    }
    /// Sorting colours into blue, green, yellow, red and grey.
    colours: ColoursSettings {
        /// Sigma of the blur before colours are sorted.
        blur: f32 = 0.0 to 20.0, "mm";
        /// Whether the blur stops at contours, so that no area is stained by its neighbour.
        stop_at_lines: bool;
        /// Sigma of the smoothing of the borders between areas of different colours.
        smoothing: f32 = 0.0 to 20.0, "mm";
        /// HSV saturation below which a colour counts as grey; dark colours need more, light ones less.
        min_saturation: f32 = 0.0 to 1.0;
        /// HSV value below which a colour counts as black, which is drawn as grey.
        min_value: f32 = 0.0 to 1.0;
        /// HSL lightness above which a colour counts as white, which has no texture.
        white_from: f32 = 0.3 to 1.0;
        /// Areas of one colour that are smaller than this go to the neighbour that suits them best.
        min_area: f32 = 0.0 to 5000.0, "square mm";
    }
    /// Drawing colours as textures of rhombuses, and grey as dots.
    textures: TexturesSettings {
        /// White between a line's edge and the nearest glyph.
        line_gap: f32 = 0.0 to 30.0, "mm";
        /// Distance from a rhombus to the next in its row.
        along: f32 = 1.0 to 20.0, "mm";
        /// Distance from a row of rhombuses to the next where the texture is dense.
        across: f32 = 1.0 to 20.0, "mm";
        /// Length of the boldest rhombus, along its row.
        length: f32 = 0.5 to 15.0, "mm";
        /// Thickness of the boldest rhombus.
        thickness: f32 = 0.3 to 10.0, "mm";
        /// Diameter of the boldest dot.
        dot: f32 = 0.3 to 10.0, "mm";
        /// Distance from a dot to the next where the texture is dense.
        dot_pitch: f32 = 1.0 to 20.0, "mm";
        /// Thickness of the lightest glyph; from there on glyphs grow with the darkness of the colour.
        min_glyph: f32 = 0.1 to 5.0, "mm";
        /// Sigma of the blur that turns lines into a density map.
        density_blur: f32 = 0.5 to 50.0, "mm";
        /// Density of lines from which the texture is dense; 1 is a lone straight line on itself.
        dense_from: f32 = 0.0 to 1.0;
        /// Whether colours between two classes are told: their rhombuses point in the neighbouring class's direction.
        fringe: bool;
    }
    /// Which class is told by which sign.
    palette: PaletteSettings {
        /// The sign of blue, cyan and bluish violet.
        blue: Sign;
        /// The sign of green and olive.
        green: Sign;
        /// The sign of yellow, light orange and light brown.
        yellow: Sign;
        /// The sign of red, pink and purple.
        red: Sign;
        /// The sign of black, greys and weakly saturated colours.
        grey: Sign;
    }
    /// Pages of dots, for embossers and pin displays: widths of lines, and sizes and rows of textures, are then the
    /// device's.
    dots: DotsSettings {
        /// What presses the page; with "none" it is printed.
        device: Option<&'static Device>;
        /// Distance of dots along a line, and of the columns and rows of a grid; one that the device has.
        pitch: f32 = 1.0 to 10.0, "mm";
        /// Empty dots between two lines, at least.
        line_gap: f32 = 1.0 to 10.0, "dots";
        /// Empty dots between a line and a texture; one is enough in areas that would lose more than half of their
        /// texture otherwise.
        texture_gap: f32 = 0.0 to 10.0, "dots";
        /// Rows beside one another that a texture has at least; an area with room for fewer has none.
        texture_rows: f32 = 2.0 to 10.0, "rows";
        /// Height of a colour step from which a line is two dots wide, or higher where the device has heights; of a
        /// stroke its width says so.
        heavy_from: f32 = 1.0 to 600.0, "units of lightness";
    }
    /// Words in braille, where the maker of a page gives any.
    braille: BrailleSettings {
        /// Whether a title that is given is written in braille above the figure.
        on: bool;
        /// The code; "auto" is that of the language of the words.
        code: Option<Code>;
        /// 1 is uncontracted, 2 contracted, which a translator writes: the program asks an installed liblouis.
        grade: Grade = 1.0 to 2.0;
        /// Measures of the cells; on a grid of dots cells come as near to them as they can.
        cell: CellSize;
        /// Where the lines of the title begin.
        align: Align;
        /// Whether the words also stand in print above their braille, small and in a grey that does not swell.
        print: bool;
    }
    /// Printing and swelling.
    print: PrintSettings {
        /// How much wider a mark is once it has risen than it was printed: marks are printed narrower by this.
        swell: f32 = 0.0 to 2.0, "mm";
        /// Share of the figure that may be black; the maker of a page with more is told so.
        max_black: f32 = 0.0 to 1.0;
    }
}
