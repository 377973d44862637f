//! All that a page draws, path by path, in millimetres.

use std::collections::HashMap;

use resvg::tiny_skia::{Point, Transform};
use usvg::roxmltree::Node;
use usvg::{Group, Paint, Tree};

use super::document::{Elements, is_object, layer_of, own_id};
use super::markers;
use super::subpath::{Subpath, clean, subpaths};
use super::texts::{self, PLACE_OF};
use super::tone::Tone;
use crate::Error;
use crate::output::layer::Layer;
use crate::page::{Class, TextRole, arrowhead};
use crate::units::{MM_PER_CSS_PX, MmPoint, MmRect, MmVector};

/// Scales of transforms are off by less.
const ROUNDING: f32 = 1e-5;
/// Most points of all paths together: a page of ours has 100 000 at most.
const MOST_POINTS: usize = 5_000_000;

/// Farthest that a path may reach, mm: curves of more would take points without end.
const FAR: f32 = 10_000.0;

/// A painted path.
pub(super) struct PaintedShape<'a> {
    /// The layer in which it lies.
    pub(super) layer: Option<Layer>,
    /// Which object it is a part of: a contour, a text, or itself. A clone is another one.
    pub(super) object: usize,
    /// The element of that object.
    pub(super) element: Node<'a, 'a>,
    /// The clone by which it is shown, if it is shown by one.
    pub(super) clone: Option<Node<'a, 'a>>,
    /// Whether it lies right in its object, and not in a group of that.
    pub(super) is_direct: bool,
    pub(super) subpaths: Vec<Subpath>,
    /// How light is what fills it.
    pub(super) fill: Option<Tone>,
    /// The colour of that, on white.
    pub(super) colour: [u8; 3],
    pub(super) stroke: Option<PaintedStroke>,
    /// By how much its area is larger than its element says.
    pub(super) area_scale: f32,
}

/// A ground covers this share of its sheet at least: people leave a narrow rim. Chosen by us.
const GROUND: f32 = 0.9;

impl PaintedShape<'_> {
    /// Whether it is painted, and white all over.
    pub(super) fn is_white(&self) -> bool {
        let stroke = self.stroke.as_ref().filter(|stroke| stroke.width > 0.0).map(|stroke| stroke.tone);
        let mut tones = [self.fill, stroke].into_iter().flatten().peekable();
        tones.peek().is_some() && tones.all(|tone| tone.is_white)
    }

    /// Whether it may be the ground of a sheet of this width and height, mm: it reaches over nearly all of it.
    pub(super) fn covers(&self, [width, height]: [f32; 2]) -> bool {
        let all = MmRect::from_points(self.subpaths.iter().flat_map(|subpath| &subpath.points));
        let on_sheet = all.intersection(&MmRect::new(MmPoint::zero(), MmPoint::new(width, height)));
        on_sheet.is_some_and(|part| part.area() >= GROUND * width * height)
    }
}

pub(super) struct PaintedStroke {
    /// Width, mm.
    pub(super) width: f32,
    pub(super) tone: Tone,
    pub(super) is_dashed: bool,
}

impl PaintedStroke {
    /// Whether anything of it is printed.
    pub(super) fn is_seen(&self) -> bool {
        !self.tone.is_white && self.width > 0.0
    }
}

/// Everything that is drawn.
pub(super) struct PaintedShapes<'a> {
    pub(super) marks: Vec<PaintedShape<'a>>,
    /// From the units of each layer's element to mm.
    pub(super) transforms: HashMap<String, Transform>,
    /// How many paths have a gradient or a pattern.
    pub(super) patterned: usize,
    /// How many paths reach so far that they are on no sheet.
    pub(super) far: usize,
    /// Where texts are shown, by their keys.
    pub(super) texts: HashMap<String, TextPlace>,
    points: usize,
    objects: usize,
}

/// Where a text is shown.
#[derive(Debug, Clone, Copy)]
pub(super) struct TextPlace {
    /// Where it begins, or what its anchor says, mm on the sheet.
    pub(super) at: MmPoint,
    /// How many mm one of its units has.
    pub(super) unit: f32,
    /// Which ways its lines run and follow one another, each 1 long.
    pub(super) axes: [MmVector; 2],
}

/// What is known of the groups around a path.
#[derive(Clone, Copy)]
struct Inherited<'a> {
    layer: Option<Layer>,
    object: Option<(usize, Node<'a, 'a>)>,
    /// What a clone shows: usvg leaves its parts no ids.
    cloned: Option<Node<'a, 'a>>,
    /// That clone; of clones of clones the one that is shown.
    clone: Option<Node<'a, 'a>>,
    /// The line of which it is a marker: usvg leaves the parts of markers no ids either.
    marked: Option<Node<'a, 'a>>,
    opacity: f32,
}

/// All marks of a page.
///
/// # Errors
/// If they have more points than [`MOST_POINTS`].
pub(super) fn of<'a>(tree: &Tree, elements: &Elements<'a>) -> Result<PaintedShapes<'a>, Error> {
    let mut marks = PaintedShapes {
        marks: Vec::new(),
        transforms: HashMap::new(),
        patterned: 0,
        far: 0,
        texts: HashMap::new(),
        points: 0,
        objects: 0,
    };
    marks.add_group(
        tree.root(),
        Inherited { layer: None, object: None, cloned: None, clone: None, marked: None, opacity: 1.0 },
        elements,
    )?;
    Ok(marks)
}

/// The layer of an object that we wrote, which lies in this one: editors put a group of objects where the uppermost of
/// them is, and none of them becomes another thing by that. An area in another texture has been moved there on purpose.
fn layer_of_object(element: Node<'_, '_>, around: Option<Layer>) -> Option<Layer> {
    let has = |name: &str| element.has_attribute(name);
    match around {
        Some(Layer::Texture(_)) if has("data-class") => around,
        Some(Layer::Braille(_)) if has("data-braille") => around,
        Some(Layer::Lines | Layer::Overview | Layer::Figure) if has("data-strength") => around,
        _ if has("data-class") => {
            let class = element.attribute("data-class").and_then(|name| Class::named(name).ok());
            class.map(Layer::Texture).or(around)
        }
        _ if has("data-braille") => {
            let id = own_id(element).unwrap_or_default();
            let layers = TextRole::ALL.into_iter().map(Layer::Braille);
            layers.into_iter().find(|layer| id.starts_with(&layer.id())).or(around)
        }
        Some(Layer::Texture(_) | Layer::Textures | Layer::Braille(_)) if has("data-strength") => Some(Layer::Lines),
        _ => around,
    }
}

/// How an object that we wrote is painted: its layer says that, and in another one it is still what it was, a line a
/// stroke and an area filled.
fn painted_as_its_object(
    object: Node<'_, '_>,
    own: Node<'_, '_>,
    painted: (Option<Tone>, Option<PaintedStroke>),
    area_scale: f32,
) -> (Option<Tone>, Option<PaintedStroke>) {
    let width = own.attribute("stroke-width").and_then(|width| width.parse::<f32>().ok());
    match (painted, width) {
        ((Some(tone), None), Some(width)) if object.has_attribute("data-strength") => {
            (None, Some(PaintedStroke { width: clean(width * area_scale.sqrt()), tone, is_dashed: false }))
        }
        ((None, Some(stroke)), _) if object.has_attribute("data-class") => (Some(stroke.tone), None),
        (painted, _) => painted,
    }
}

/// From CSS pixels to mm.
fn to_mm(transform: Transform) -> Transform {
    transform.post_scale(MM_PER_CSS_PX, MM_PER_CSS_PX)
}

impl<'a> PaintedShapes<'a> {
    fn add_group(&mut self, group: &Group, around: Inherited<'a>, elements: &Elements<'a>) -> Result<(), Error> {
        let mut around = Inherited { opacity: around.opacity * group.opacity().get(), ..around };
        let own = elements.get(group.id());
        if let Some(element) = own.and_then(|element| elements.shown_by(element)) {
            if own != Some(element) {
                (around.cloned, around.clone) = (Some(element), around.clone.or(own));
            }
            if let Some(layer) = layer_of(element) {
                around = Inherited { layer: Some(layer), object: None, ..around };
                self.transforms.entry(layer.id()).or_insert_with(|| to_mm(group.abs_transform()));
            } else if is_object(element) {
                around.object = Some((self.next_object(), element));
                around.layer = layer_of_object(element, around.layer);
            }
        }
        // the markers of a line follow it, each as a group; the next object is one, too, with a transform or opacity
        let are_markers = |group: &Group| {
            group.id().is_empty() && group.children().iter().all(|child| matches!(child, usvg::Node::Group(_)))
        };
        let mut line = None;
        for node in group.children() {
            match node {
                usvg::Node::Group(group) => match line.filter(|_| are_markers(group)) {
                    Some(line) => self.add_markers(group, line, around, elements)?,
                    None => self.add_group(group, around, elements)?,
                },
                usvg::Node::Path(path) => {
                    let before = self.marks.len();
                    self.add_path(path, around, elements)?;
                    line = elements.get(path.id()).filter(|_| self.marks.len() > before).map(|own| (before, own));
                }
                // without fonts there are no letters, and pictures are not read: the document tells of them
                usvg::Node::Image(_) | usvg::Node::Text(_) => {}
            }
        }
        Ok(())
    }

    /// Adds the markers of a line, which is the mark of this number. The head of an arrow becomes one as it is drawn on
    /// pages, with its tip at the end of the line; any other is what it shows.
    fn add_markers(
        &mut self,
        group: &Group,
        (line, own): (usize, Node<'a, 'a>),
        around: Inherited<'a>,
        elements: &Elements<'a>,
    ) -> Result<(), Error> {
        let around =
            Inherited { object: None, marked: Some(own), opacity: around.opacity * group.opacity().get(), ..around };
        for marker in group.children() {
            let usvg::Node::Group(marker) = marker else { continue };
            let before = self.marks.len();
            self.add_group(marker, around, elements)?;
            let points = self.marks[before..].iter().flat_map(|mark| &mark.subpaths).flat_map(|of| of.points.clone());
            let points: Vec<MmPoint> = points.collect();
            let Some((end, tip, toward)) = markers::head(&points, &self.marks[line].subpaths) else { continue };
            let Some(PaintedStroke { width, tone, .. }) = self.marks[line].stroke else { continue };
            self.marks.truncate(before);
            let object = self.next_object();
            let shaft = &mut self.marks[line];
            end.put(&mut shaft.subpaths, tip);
            let points = arrowhead(tip, toward).to_vec();
            let strokes = Subpath { named: points.clone(), points, closed: false, curved: false };
            let head = PaintedShape {
                // told with its line, if that lies in no layer
                layer: shaft.layer.or(Some(Layer::Figure)),
                object,
                element: own,
                clone: None,
                is_direct: true,
                subpaths: vec![strokes],
                fill: None,
                colour: [0; 3],
                stroke: Some(PaintedStroke { width, tone, is_dashed: false }),
                area_scale: 1.0,
            };
            self.marks.push(head);
        }
        Ok(())
    }

    /// Adds the place of a text, if it is seen at all.
    fn add_place(&mut self, key: &str, mark: &usvg::Path, transform: Transform, opacity: f32) {
        if opacity <= 0.0 {
            return;
        }
        let corner = mark.data().bounds();
        let mut at = [Point::from_xy(corner.left(), corner.top())];
        transform.map_points(&mut at);
        let unit = clean((transform.sx * transform.sy - transform.kx * transform.ky).abs().sqrt());
        let axis = |x: f32, y: f32, level: MmVector| MmVector::new(x, y).try_normalize().unwrap_or(level);
        let along = axis(transform.sx, transform.ky, MmVector::new(1.0, 0.0));
        let down = axis(transform.kx, transform.sy, MmVector::new(0.0, 1.0));
        let place = TextPlace { at: MmPoint::new(clean(at[0].x), clean(at[0].y)), unit, axes: [along, down] };
        self.texts.insert(key.to_owned(), place);
    }

    fn next_object(&mut self) -> usize {
        self.objects += 1;
        self.objects
    }

    fn add_path(&mut self, path: &usvg::Path, around: Inherited<'a>, elements: &Elements<'a>) -> Result<(), Error> {
        if !path.is_visible() {
            return Ok(());
        }
        let transform = to_mm(path.abs_transform());
        if let Some(text) = path.id().strip_prefix(PLACE_OF) {
            self.add_place(text, path, transform, around.opacity);
            return Ok(());
        }
        let own_size = path.data().bounds();
        if around.cloned.is_some() && texts::is_mark(own_size.width(), own_size.height()) {
            return Ok(());
        }
        let Some(geometry) = path.data().clone().transform(transform) else { return Ok(()) };
        let bounds = geometry.bounds();
        let far = [bounds.left(), bounds.top(), bounds.right(), bounds.bottom()].iter().any(|side| side.abs() > FAR);
        if far {
            self.far += 1;
            return Ok(());
        }
        let subpaths = subpaths(&geometry);
        self.points += subpaths.iter().map(|subpath| subpath.points.len()).sum::<usize>();
        if self.points > MOST_POINTS {
            let why = format!("its paths have more than {MOST_POINTS} points");
            return Err(Error::too_complex(super::document::FORMAT, why));
        }
        let own = elements.get(path.id()).or(around.cloned).or(around.object.map(|(_, element)| element));
        let own = own.or(around.marked);
        let Some(own) = own else {
            return Ok(());
        };
        let (object, element) = match around.object {
            Some(object) if !is_object(own) => object,
            _ => (self.next_object(), own),
        };
        let area_scale = (transform.sx * transform.sy - transform.kx * transform.ky).abs();
        // on a page that nobody scaled it is 1 but for a rounding, by which a large area would change
        let area_scale = if (area_scale - 1.0).abs() < ROUNDING { 1.0 } else { area_scale };
        let opacity = around.opacity;
        let colour = path.fill().map_or([0; 3], |fill| colour_of(fill.paint(), fill.opacity().get() * opacity));
        let fill = path.fill().map(|fill| self.tone(fill.paint(), fill.opacity().get() * opacity));
        let stroke = path.stroke().map(|stroke| PaintedStroke {
            width: clean(stroke.width().get() * area_scale.sqrt()),
            tone: self.tone(stroke.paint(), stroke.opacity().get() * opacity),
            is_dashed: stroke.dasharray().is_some(),
        });
        let (fill, stroke) = painted_as_its_object(element, own, (fill, stroke), area_scale);
        let is_direct = own.parent() == Some(element) || own == element;
        let Inherited { layer, clone, .. } = around;
        let layer = if around.object.is_none() { layer_of_object(own, layer) } else { layer };
        let of = PaintedShape { layer, object, element, clone, is_direct, subpaths, fill, colour, stroke, area_scale };
        self.marks.push(of);
        Ok(())
    }

    /// How light a paint is on white; patterns count as black, and are counted.
    fn tone(&mut self, paint: &Paint, opacity: f32) -> Tone {
        if !matches!(paint, Paint::Color(_)) {
            self.patterned += 1;
            return Tone::BLACK;
        }
        Tone::of(colour_of(paint, opacity))
    }
}

/// The colour of a paint on white; patterns count as black.
fn colour_of(paint: &Paint, opacity: f32) -> [u8; 3] {
    let Paint::Color(colour) = paint else { return [0; 3] };
    [colour.red, colour.green, colour.blue].map(|channel| on_white(f32::from(channel), opacity))
}

fn on_white(channel: f32, opacity: f32) -> u8 {
    (255.0 - (255.0 - channel) * opacity).round() as u8
}
