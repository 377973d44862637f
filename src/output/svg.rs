//! A page as an SVG document in true millimetres, pure black on white, with the ids and layers that other programs
//! rely on.
//!
//! ```text
//! svg > title, desc, metadata (lines "name = value")
//!   g#orientation-mark > path (stroke-width in mm)
//!   g#registration > path (only where several sheets belong together)
//!   g#frame
//!   g#figure  data-box="x y w h" (mm)  data-source="w h" (px)
//!     g#textures > g#texture-blue ...  data-sign="rhombus 0" (degrees counter-clockwise) or "dot"
//!       path  id="region-1"  label "blue area 1"  data-class  data-colour="r g b" (0..255)  data-area (mm2)
//!     g#lines > path  id="line-1"  label "line 1"  data-strength  stroke-width (mm)   (one a contour)
//!   g#overview-frame
//!   g#overview  data-box > path  id="overview-line-1" ...
//!   g#labels (one path a size of dots)
//!   g#braille-title > g  id="braille-title-1"  aria-label (the text)  data-braille (its lines in Unicode braille)
//!                        data-abbreviation (what stands for the text, if anything does) > path
//!   g#braille-page-number > the same
//!   g#braille-key > the same, on the sheets of a key
//!   g#print-words > text  x  y  font-size (mm), in grey (only where a profile has braille.print)
//!   g#braille-labels > the same; a label that leads to what it names has > g > path (stroke-width in mm)
//! ```
//!
//! A contour whose width changes along it is a group of paths in place of a path: in an editor it is one object either
//! way. Layers are those of Inkscape (`inkscape:groupmode`); other editors show groups. A layer that would be empty is
//! left out. `reading` reads all of it back.

use std::fmt::Write;

use svg::node::element::{Description, Element, Group, Path, Text, Title};
use svg::{Document, Node};

use super::layer::{Layer, PRINT_GREY, grey};
use super::seal;
use super::text::{origin_lines, plain, push_number, written_corners};
use crate::page::{
    BrailleText, Class, Dots, Figure, Glyph, Height, LANGUAGE, Line, Overview, Page, Pen, PrintText, Run, Shape,
    TextRole, Texture, area_name, line_name, overview_line_name,
};
use crate::units::{MmPoint, MmRect};

/// The page as an SVG document. The same page gives the same bytes.
pub fn write(page: &Page) -> String {
    let [width, height] = page.sheet.map(number);
    let mut document = Document::new()
        .set("width", format!("{width}mm"))
        .set("height", format!("{height}mm"))
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape")
        .set("role", "img")
        .add(title(page))
        .add(
            Description::new()
                .set("xml:lang", plain(&page.description_language))
                .add(svg::node::Text::new(plain(&page.description))),
        )
        .add(metadata(&page.whole_origin()));
    if let Some(mark) = &page.orientation_mark {
        document = document.add(with_strokes(layer(Layer::OrientationMark)).add(stroke(mark)));
    }
    if !page.registration.is_empty() {
        let group = with_strokes(layer(Layer::Registration));
        document = document.add(page.registration.iter().fold(group, |group, run| group.add(stroke(run))));
    }
    if !page.frame.at.is_empty() {
        let frame = raised(layer(Layer::Frame), page.height_of_frame());
        document = document.add(frame.add(dots(&page.frame)));
    }
    document = document.add(figure(&page.figure, page.height_of_textures()));
    if let Some(overview) = &page.overview {
        if !overview.frame.at.is_empty() {
            document = document.add(layer(Layer::OverviewFrame).add(dots(&overview.frame)));
        }
        document = document.add(overview_layer(overview));
    }
    if !page.labels.is_empty() {
        document = document.add(page.labels.iter().fold(layer(Layer::Labels), |group, label| group.add(dots(label))));
    }
    document = braille_layers(page).into_iter().fold(document, Document::add);
    if !page.print.is_empty() {
        document = document.add(print_words(&page.print));
    }
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{document}");
    let seal = seal::comment(text.as_bytes());
    text + &seal
}

/// Words in braille, in a layer for each of their roles.
fn braille_layers(page: &Page) -> Vec<Group> {
    let of_role = |role: TextRole| {
        let mut texts = page.braille.iter().filter(|text| text.role == role).peekable();
        texts.peek()?;
        let id = Layer::Braille(role).id();
        let numbered = (1..).zip(texts);
        Some(numbered.fold(layer(Layer::Braille(role)), |group, (number, text)| {
            group.add(braille(text).set("id", format!("{id}-{number}")))
        }))
    };
    TextRole::ALL.into_iter().filter_map(of_role).collect()
}

/// Words for those who see; those who listen hear them with their braille.
fn print_words(words: &[PrintText]) -> Group {
    let group = layer(Layer::PrintWords)
        .set("fill", format!("#{PRINT_GREY:02x}{PRINT_GREY:02x}{PRINT_GREY:02x}"))
        .set("font-family", FONTS)
        .set("aria-hidden", "true");
    words.iter().fold(group, |group, text| {
        let element = Text::new(plain(&text.string)).set("x", number(text.at.x)).set("y", number(text.at.y));
        group.add(element.set("font-size", number(text.size)))
    })
}

/// Fonts of words in print, the first that is there: sans-serif, as is easy to read when it is small and light.
const FONTS: &str = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// One text: a person who listens hears what fingers read.
fn braille(text: &BrailleText) -> Group {
    let group = Group::new()
        .set("role", "img")
        .set("xml:lang", plain(&text.language))
        .set("inkscape:label", plain(&text.text))
        .set("aria-label", plain(&text.spoken()))
        .set("data-braille", text.lines.join(" "));
    let group = match &text.abbreviation {
        Some(short) => group.set("data-abbreviation", plain(short)),
        None => group,
    };
    let group = group.add(dots(&text.dots));
    let ends = text.leader.as_ref().and_then(|leader| leader.points.first().zip(leader.points.last()));
    // where it runs, for a label that is moved in an editor: its tip stays
    let group = match ends {
        Some((from, tip)) => group.set("data-leader", [from.x, from.y, tip.x, tip.y].map(number).join(" ")),
        None => group,
    };
    match &text.leader {
        Some(leader) => group.add(with_strokes(Group::new()).add(stroke(leader))),
        None => group,
    }
}

/// The title, with its language where that is not the one of generated titles.
fn title(page: &Page) -> Title {
    let title = Title::new(plain(&page.title));
    if page.language == LANGUAGE { title } else { title.set("xml:lang", plain(&page.language)) }
}

/// Whether these bytes are a drawing as [`write()`] makes it, changed by nobody since: neither in an editor nor by
/// hand.
pub fn is_as_written(bytes: &[u8]) -> bool {
    seal::is_commented(bytes)
}

/// How the page was made, as lines `name = value`. Text, because Inkscape warns of every element that it does not know.
fn metadata(origin: &[(String, String)]) -> Element {
    let lines: Vec<String> = origin_lines(origin).collect();
    let mut metadata = Element::new("metadata");
    metadata.append(svg::node::Text::new(lines.join("\n")));
    metadata
}

fn layer(layer: Layer) -> Group {
    Group::new().set("id", layer.id()).set("inkscape:groupmode", "layer").set("inkscape:label", layer.label())
}

fn data_box(place: MmRect) -> String {
    [place.min.x, place.min.y, place.width(), place.height()].map(number).join(" ")
}

fn figure(figure: &Figure, of_textures: Height) -> Group {
    let mut group = layer(Layer::Figure)
        .set("data-box", data_box(figure.place))
        .set("data-source", format!("{} {}", figure.source.width, figure.source.height));
    if !figure.textures.is_empty() {
        let mut textures = raised(layer(Layer::Textures), of_textures);
        let numbered = || (1..).zip(&figure.textures);
        for class in Class::ALL {
            let mut paths = numbered().filter(|(_, texture)| texture.class == class).peekable();
            if let Some((_, first)) = paths.peek() {
                let of_class = layer(Layer::Texture(class)).set("data-sign", first.sign.to_string());
                let in_class = (1..).zip(paths);
                textures = textures.add(
                    in_class.fold(of_class, |group, (nth, (number, texture))| group.add(region(number, nth, texture))),
                );
            }
        }
        group = group.add(textures);
    }
    if figure.lines.is_empty() {
        group
    } else {
        group.add(lines(with_strokes(layer(Layer::Lines)), line_name, &figure.lines))
    }
}

/// All glyphs of a region as one object, so that a person can delete, move or change it as a whole; what it stands
/// for is said beside it. It is the `nth` of its class.
fn region(number: usize, nth: usize, texture: &Texture) -> Path {
    let name = texture.class.name();
    Path::new()
        .set("id", format!("region-{number}"))
        .set("inkscape:label", area_name(texture.class, nth))
        .set("data-class", name)
        .set("data-colour", texture.colour.map(|channel| channel.to_string()).join(" "))
        .set("data-area", self::number(texture.area))
        .set("d", glyph_path(&texture.glyphs))
}

fn overview_layer(overview: &Overview) -> Group {
    let group = layer(Layer::Overview).set("data-box", data_box(overview.place));
    lines(with_strokes(group), overview_line_name, &overview.lines)
}

/// Lines as strokes: an editor can change their width and bend them. Each is one object with a name; where its width
/// changes along it, a group.
fn lines(layer: Group, name: fn(usize) -> String, lines: &[Line]) -> Group {
    (1..).zip(lines).fold(layer, |layer: Group, (number, line): (usize, &Line)| {
        let label = name(number);
        let id = label.replace(' ', "-");
        let strength = format!("{:.1}", line.strength);
        match line.runs.as_slice() {
            [run] => layer.add(stroke(run).set("id", id).set("inkscape:label", label).set("data-strength", strength)),
            runs => {
                let group = Group::new().set("id", id).set("inkscape:label", label).set("data-strength", strength);
                layer.add(runs.iter().fold(group, |group, run| group.add(stroke(run))))
            }
        }
    })
}

fn with_strokes(group: Group) -> Group {
    group.set("fill", "none").set("stroke", "#000000").set("stroke-linecap", "round").set("stroke-linejoin", "round")
}

fn stroke(run: &Run) -> Path {
    if let Pen::Dots(height) = run.pen {
        let dots = discs(&run.points, run.width);
        return Path::new().set("fill", shade(height)).set("stroke", "none").set("d", dots);
    }
    Path::new().set("stroke-width", number(run.width)).set("d", line_path(&run.points, run.closed))
}

/// `d` of a polyline, in whole steps of 0.01 mm. Written by hand: these strings are most of the document.
fn line_path(points: &[MmPoint], closed: bool) -> String {
    let mut d = String::with_capacity(12 * points.len());
    for (i, at) in points.iter().enumerate() {
        d.push(match i {
            0 => 'M',
            1 => 'L',
            _ => ' ',
        });
        push_point(&mut d, *at);
    }
    if closed {
        d.push('Z');
    }
    d
}

fn dots(dots: &Dots) -> Path {
    Path::new().set("d", discs(&dots.at, dots.diameter))
}

/// What is pressed lower is drawn lighter; everything else is black.
fn shade(height: Height) -> String {
    let grey = grey(height);
    format!("#{grey:02x}{grey:02x}{grey:02x}")
}

/// A layer of dots of this height.
fn raised(group: Group, height: Height) -> Group {
    // black is what is drawn unless something else is said
    if height == Height::High { group } else { group.set("fill", shade(height)) }
}

fn discs(at: &[MmPoint], diameter: f32) -> String {
    let mut d = String::with_capacity(48 * at.len());
    let disc = DiscPath::of(diameter);
    at.iter().for_each(|&at| disc.push(&mut d, at));
    d
}

fn glyph_path(glyphs: &[Glyph]) -> String {
    let mut d = String::with_capacity(48 * glyphs.len());
    for glyph in glyphs {
        match glyph.shape {
            Shape::Rhombus { .. } => d.push_str(&line_path(&written_corners(glyph), true)),
            Shape::Dot { diameter } => DiscPath::of(diameter).push(&mut d, glyph.at),
        }
    }
    d
}

/// A disc as two half circles. The diameter is twice the radius as written: were it rounded by itself, the arcs
/// would be a little more or less than half circles, and a disc of 1.294 mm 0.17 mm too high.
struct DiscPath {
    /// In whole steps of 0.01 mm.
    radius: f32,
    /// What follows the place where it begins, the same for all of one size.
    arcs: String,
}

impl DiscPath {
    fn of(diameter: f32) -> Self {
        let rounded = (50.0 * f64::from(diameter)).round() as f32 / 100.0;
        let (radius, across) = (number(rounded), number(2.0 * rounded));
        let arcs = format!("a{radius} {radius} 0 1 0 {across} 0a{radius} {radius} 0 1 0-{across} 0z");
        Self { radius: rounded, arcs }
    }

    fn push(&self, d: &mut String, at: MmPoint) {
        d.push('M');
        push_point(d, MmPoint::new(at.x - self.radius, at.y));
        d.push_str(&self.arcs);
    }
}

fn push_point(d: &mut String, at: MmPoint) {
    push_length(d, at.x);
    d.push(',');
    push_length(d, at.y);
}

fn number(value: f32) -> String {
    let mut text = String::new();
    push_length(&mut text, value);
    text
}

/// A length in mm with at most two decimals (0.01 mm: a printer's dot is 0.02 to 0.08).
fn push_length(text: &mut String, mm: f32) {
    push_number::<2>(text, mm);
}

#[cfg(test)]
mod tests;
