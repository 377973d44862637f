//! The marks of a page as PDF drawing operators.
//!
//! User space is turned to y down and scaled to hundredths of a millimetre, so that every number is a whole one, the
//! same that the SVG has with a point in it. All ink is DeviceGray 0, set once: what is black here is black on any
//! printer, and never a mixture of colours.

use pdf_writer::types::{LineCapStyle, LineJoinStyle, TextRenderingMode};
use pdf_writer::{Content, Name, Settings, Str, TextStr};

use super::super::layer::{Layer, PRINT_GREY, grey};
use super::super::text::{plain, written_corners};
use crate::page::{BrailleText, Class, Dots, Glyph, Height, Line, Page, Pen, PrintText, Run, Shape, TextRole};
use crate::units::MmPoint;

/// Points of a PDF in a millimetre.
pub(super) const POINTS_PER_MM: f32 = 72.0 / 25.4;
/// The name of the font of words in print.
pub(super) const FONT: Name<'static> = Name(b"F1");
/// Width of a blank in the font, as a share of its size: that of Helvetica.
const BLANK: f32 = 0.278;
/// Units of user space in a millimetre.
const UNITS: f32 = 100.0;
/// The page's only piece of tagged content.
pub(super) const MARKED_CONTENT: i32 = 0;
/// A quarter of a circle of radius 1 as a Bezier curve has its control points this far from its ends; it then leaves
/// the circle by at most 0.03 % of the radius. From 4/3 (sqrt 2 - 1).
const CIRCLE: f32 = 0.552_284_8;

/// A page's content stream, not compressed. `name_of` gives the name of a layer in the page's resources.
pub(super) fn write(page: &Page, name_of: &dyn Fn(Layer) -> String) -> Vec<u8> {
    let scale = POINTS_PER_MM / UNITS;
    let mut out = ContentWriter {
        content: Content::with_settings(Settings { pretty: false }),
        name_of,
        width: f32::NAN,
        fill: Height::High,
    };
    out.content.transform([scale, 0.0, 0.0, -scale, 0.0, page.sheet[1] * POINTS_PER_MM]);
    out.content.set_fill_gray(0.0).set_stroke_gray(0.0);
    out.content.set_line_cap(LineCapStyle::RoundCap).set_line_join(LineJoinStyle::RoundJoin);
    out.content.begin_marked_content_with_properties(Name(b"Figure")).properties().identify(MARKED_CONTENT);
    out.page(page);
    out.content.end_marked_content();
    out.content.finish().into_vec()
}

/// The layers that [`write()`] puts a page into, in the order of the page, each after the one that it lies in.
pub(super) fn layers(page: &Page) -> Vec<Layer> {
    let mut layers = Vec::new();
    let mut add = |layer, is_there: bool| layers.extend(is_there.then_some(layer));
    let has = |class| page.figure.textures.iter().any(|texture| texture.class == class);
    add(Layer::OrientationMark, page.orientation_mark.is_some());
    add(Layer::Registration, !page.registration.is_empty());
    add(Layer::Frame, !page.frame.at.is_empty());
    add(Layer::Figure, true);
    add(Layer::Textures, !page.figure.textures.is_empty());
    Class::ALL.into_iter().for_each(|class| add(Layer::Texture(class), has(class)));
    add(Layer::Lines, !page.figure.lines.is_empty());
    add(Layer::OverviewFrame, page.overview.as_ref().is_some_and(|overview| !overview.frame.at.is_empty()));
    add(Layer::Overview, page.overview.is_some());
    add(Layer::Labels, !page.labels.is_empty());
    TextRole::ALL.into_iter().for_each(|role| {
        add(Layer::Braille(role), page.braille.iter().any(|text| text.role == role));
    });
    add(Layer::PrintWords, !page.print.is_empty());
    layers
}

struct ContentWriter<'a> {
    content: Content,
    name_of: &'a dyn Fn(Layer) -> String,
    /// Line width in force.
    width: f32,
    /// Grey of discs and glyphs in force.
    fill: Height,
}

impl ContentWriter<'_> {
    fn page(&mut self, page: &Page) {
        for layer in layers(page) {
            match layer {
                Layer::OrientationMark => {
                    self.layer(layer, |out| page.orientation_mark.iter().for_each(|run| out.run(run)));
                }
                Layer::Registration => self.layer(layer, |out| page.registration.iter().for_each(|run| out.run(run))),
                Layer::Frame => self.layer(layer, |out| {
                    out.raise(page.height_of_frame());
                    out.dots(&page.frame);
                }),
                Layer::Figure => self.layer(layer, |out| out.figure(page)),
                Layer::OverviewFrame => {
                    self.layer(layer, |out| page.overview.iter().for_each(|overview| out.dots(&overview.frame)));
                }
                Layer::Overview => {
                    self.layer(layer, |out| page.overview.iter().for_each(|overview| out.lines(&overview.lines)));
                }
                Layer::Labels => self.layer(layer, |out| {
                    out.raise(Height::High);
                    page.labels.iter().for_each(|label| out.dots(label));
                }),
                Layer::Braille(role) => self.layer(layer, |out| {
                    out.raise(Height::High);
                    page.braille.iter().filter(|text| text.role == role).for_each(|text| out.braille(text));
                }),
                Layer::PrintWords => self.layer(layer, |out| out.print_words(&page.print)),
                Layer::Textures | Layer::Texture(_) | Layer::Lines => {} // in the figure
            }
        }
    }

    fn figure(&mut self, page: &Page) {
        let figure = &page.figure;
        if !figure.textures.is_empty() {
            self.layer(Layer::Textures, |out| {
                out.raise(page.height_of_textures());
                for class in Class::ALL {
                    let mut textures = figure.textures.iter().filter(|texture| texture.class == class).peekable();
                    if textures.peek().is_some() {
                        out.layer(Layer::Texture(class), |out| {
                            textures.for_each(|texture| out.glyphs(&texture.glyphs))
                        });
                    }
                }
            });
        }
        if !figure.lines.is_empty() {
            self.layer(Layer::Lines, |out| out.lines(&figure.lines));
        }
    }

    /// What `draw` writes, as optional content.
    fn layer(&mut self, layer: Layer, draw: impl FnOnce(&mut Self)) {
        let name = (self.name_of)(layer);
        self.content.begin_marked_content_with_properties(Name(b"OC")).properties_named(Name(name.as_bytes()));
        draw(self);
        self.content.end_marked_content();
    }

    /// Lines stay strokes: an editor can change their width and bend them.
    fn lines(&mut self, lines: &[Line]) {
        lines.iter().flat_map(|line| &line.runs).for_each(|run| self.run(run));
    }

    /// What is filled from here on is pressed this high.
    fn raise(&mut self, height: Height) {
        if height != self.fill {
            self.content.set_fill_gray((f32::from(grey(height)) / 255.0 * 1000.0).round() / 1000.0);
            self.fill = height;
        }
    }

    fn run(&mut self, run: &Run) {
        if let Pen::Dots(height) = run.pen {
            self.raise(height);
            run.points.iter().for_each(|&at| self.disc(at, run.width));
            self.content.fill_nonzero();
            return;
        }
        let width = units(run.width);
        if width.total_cmp(&self.width).is_ne() {
            self.content.set_line_width(width);
            self.width = width;
        }
        self.polyline(&run.points);
        if run.closed {
            self.content.close_and_stroke();
        } else {
            self.content.stroke();
        }
    }

    /// The glyphs of one region as one path, which an editor takes as one object.
    fn glyphs(&mut self, glyphs: &[Glyph]) {
        for glyph in glyphs {
            match glyph.shape {
                Shape::Rhombus { .. } => {
                    self.polyline(&written_corners(glyph));
                    self.content.close_path();
                }
                Shape::Dot { diameter } => self.disc(glyph.at, diameter),
            }
        }
        self.content.fill_nonzero();
    }

    /// Words in braille, which a screen reader reads as text. Programs take the height of words from the font that is
    /// set where these end, so that it stays set until then.
    fn braille(&mut self, text: &BrailleText) {
        let words = plain(&text.spoken());
        let (width, fill) = (self.width, self.fill);
        self.content.save_state();
        let mut content = self.content.begin_marked_content_with_properties(Name(b"Span"));
        content.properties().actual_text(TextStr(&words));
        drop(content);
        self.dots(&text.dots);
        self.unseen(&text.dots);
        text.leader.iter().for_each(|run| self.run(run));
        self.content.end_marked_content();
        self.content.restore_state();
        (self.width, self.fill) = (width, fill);
    }

    /// A blank in place of dots, which takes no ink: programs look for words, and copy them, only where a letter
    /// stands.
    fn unseen(&mut self, dots: &Dots) {
        let Some(place) = dots.bounds() else { return };
        let (width, size) = (units(place.width()), units(place.height()));
        self.content.begin_text().set_text_rendering_mode(TextRenderingMode::Invisible);
        self.content.set_font(FONT, size).set_horizontal_scaling((100.0 * width / (BLANK * size)).round());
        self.content.set_text_matrix([1.0, 0.0, 0.0, -1.0, units(place.min.x), units(place.max.y)]);
        self.content.show(Str(b" "));
        self.content.end_text();
    }

    /// Words in print, in a font that every viewer has.
    fn print_words(&mut self, words: &[PrintText]) {
        let grey = f32::from(PRINT_GREY) / 255.0;
        self.content.save_state().set_fill_gray((grey * 1000.0).round() / 1000.0).begin_text();
        for text in words {
            self.content.set_font(FONT, units(text.size));
            // y runs down, and letters stand upright
            self.content.set_text_matrix([1.0, 0.0, 0.0, -1.0, units(text.at.x), units(text.at.y)]);
            self.content.show(Str(&in_font(&plain(&text.string))));
        }
        self.content.end_text().restore_state();
    }

    fn dots(&mut self, dots: &Dots) {
        dots.at.iter().for_each(|&at| self.disc(at, dots.diameter));
        self.content.fill_nonzero();
    }

    fn polyline(&mut self, points: &[MmPoint]) {
        for (i, at) in points.iter().enumerate() {
            let (x, y) = (units(at.x), units(at.y));
            if i == 0 {
                self.content.move_to(x, y);
            } else {
                self.content.line_to(x, y);
            }
        }
    }

    /// A disc with its radius and its place rounded as in the SVG.
    fn disc(&mut self, at: MmPoint, diameter: f32) {
        let radius = units(0.5 * diameter);
        let (left, middle) = (units(at.x - radius / UNITS), units(at.y));
        let on = |x: f32, y: f32| [(left + radius + radius * x).round(), (middle + radius * y).round()];
        let [x, y] = on(1.0, 0.0);
        self.content.move_to(x, y);
        // A quarter from (a, b) to (-b, a).
        for (a, b) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
            let ([x1, y1], [x2, y2]) = (on(a - b * CIRCLE, b + a * CIRCLE), on(a * CIRCLE - b, b * CIRCLE + a));
            let [x3, y3] = on(-b, a);
            self.content.cubic_to(x1, y1, x2, y2, x3, y3);
        }
        self.content.close_path();
    }
}

/// A text in the bytes of WinAnsiEncoding; letters that it has not are written without their marks, or as "?".
fn in_font(text: &str) -> Vec<u8> {
    let byte = |letter: char| match letter {
        ' '..='~' | '\u{a0}'..='\u{ff}' => letter as u8,
        '€' => 0x80,
        '‚' => 0x82,
        '„' => 0x84,
        '…' => 0x85,
        'Š' => 0x8a,
        'Œ' => 0x8c,
        'Ž' => 0x8e,
        '‘' => 0x91,
        '’' => 0x92,
        '“' => 0x93,
        '”' => 0x94,
        '•' => 0x95,
        '–' => 0x96,
        '—' => 0x97,
        'š' => 0x9a,
        'œ' => 0x9c,
        'ž' => 0x9e,
        // of Polish and Czech, whose words are written too
        'ą' => b'a',
        'Ą' => b'A',
        'ć' | 'č' => b'c',
        'Ć' | 'Č' => b'C',
        'ď' => b'd',
        'Ď' => b'D',
        'ę' | 'ě' => b'e',
        'Ę' | 'Ě' => b'E',
        'ł' => b'l',
        'Ł' => b'L',
        'ń' | 'ň' => b'n',
        'Ń' | 'Ň' => b'N',
        'ř' => b'r',
        'Ř' => b'R',
        'ś' => b's',
        'Ś' => b'S',
        'ť' => b't',
        'Ť' => b'T',
        'ů' => b'u',
        'Ů' => b'U',
        'ź' | 'ż' => b'z',
        'Ź' | 'Ż' => b'Z',
        _ => b'?',
    };
    text.chars().map(byte).collect()
}

/// A length in whole units of user space: 0.01 mm, as in the SVG.
fn units(mm: f32) -> f32 {
    (f64::from(mm) * f64::from(UNITS)).round() as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_all_languages_are_written_at_least_without_their_marks() {
        // French, German, Polish, Czech, Swedish, Spanish, Portuguese
        let letters = "œŒàâçéèêëîïôùûüÿäöüßÄÖÜąćęłńóśźżčďěňřšťůžŠŽåÅñÑ¿¡ãõ";
        assert!(!in_font(letters).contains(&b'?'));
        assert_eq!(in_font("œuf, žluť"), [0x9c, b'u', b'f', b',', b' ', 0x9e, b'l', b'u', b't']);
        assert_eq!(in_font("☕"), b"?");
    }
}
