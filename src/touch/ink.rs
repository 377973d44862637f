//! The ink of a page, drawn by resvg from its SVG: textures class by class, and lines.
//!
//! Only what is drawn counts, with the ids of the layers and the sign that each layer states. So a page that was
//! changed in an editor is judged as it is now: what is hidden, moved or turned there is so here.

use resvg::tiny_skia::{Color, Pixmap, Transform};
use usvg::roxmltree::{Document, Node};
use usvg::{ImageHrefResolver, Tree};

use super::measure::PX_PER_MM;
use super::signs::Signs;
use crate::Error;
use crate::page::{Class, Sign};
use crate::raster::decode::{check_canvases, checked_document, tree_of};
use crate::raster::plane::Plane;
use crate::units::{MM_PER_CSS_PX as MM_PER_PX, MmPoint, MmRect, Size};

/// Id of the figure's group and of its lines.
const FIGURE: &str = "figure";
const LINES: &str = "lines";

/// Attribute of a texture's layer: the sign of its class.
const SIGN: &str = "data-sign";

/// Blank around all ink, mm: wider than the blur of the fingertip and of the window, so that the border of a texture
/// is felt as one.
const MARGIN: f32 = 8.0;

/// Longest side that is felt, mm: a little more than A2. Ink takes 64 pixels a square millimetre.
const LONGEST: f32 = 700.0;

/// Elements that draw nothing where they stand but are used by what does.
const RESOURCES: &[&str] =
    &["defs", "style", "clipPath", "mask", "linearGradient", "radialGradient", "pattern", "symbol", "marker", "filter"];

/// The ink of a page's figure.
#[derive(Debug, Clone)]
pub struct Ink {
    /// The part of the sheet that is judged: whole millimetres, with blank around all ink.
    pub area: MmRect,
    /// For each class with a texture on the page its ink, 0 white and 1 black, at [`PX_PER_MM`].
    pub textures: Vec<(Class, Plane)>,
    /// The signs of the classes as the layers state them, and those of the default palette where they do not.
    pub signs: Signs,
    /// The ink of the figure's lines.
    pub lines: Plane,
}

impl Ink {
    /// Draws the figure of a page.
    ///
    /// # Errors
    /// [`Error::Undecodable`] or [`Error::TooComplex`] of the text, [`Error::NotAPage`] if it has no group with the id
    /// of a figure or of a texture, [`Error::TooLargeToFeel`].
    pub fn of(svg: &str) -> Result<Self, Error> {
        Self::of_page(svg, &|| Ok(()))
    }

    /// As [`Ink::of`]; `go_on` is asked before each texture.
    ///
    /// # Errors
    /// As [`Ink::of`], and those of `go_on`.
    pub fn of_page(svg: &str, go_on: &dyn Fn() -> Result<(), Error>) -> Result<Self, Error> {
        let document = checked_document(svg)?;
        let names: Vec<(Class, String)> = Class::ALL.map(|class| (class, format!("texture-{}", class.name()))).into();
        let group = |id: &str| document.descendants().find(|node| node.attribute("id") == Some(id));
        let present: Vec<(&(Class, String), Node<'_, '_>)> =
            names.iter().filter_map(|name| Some((name, group(&name.1)?))).collect();
        if present.is_empty() && group(FIGURE).is_none() {
            return Err(Error::NotAPage {
                why: "it has no group with the id figure or texture-blue (-green, -yellow, -red, -grey)",
                remedy: "give a page that tactograph made",
            });
        }
        let stated = |layer: &Node<'_, '_>| layer.attribute(SIGN).and_then(Sign::named);
        let signs: Vec<(Class, Option<Sign>)> = present.iter().map(|(name, layer)| (name.0, stated(layer))).collect();
        go_on()?;
        let lines = tree(&only(svg, &document, LINES))?;
        let trees = present
            .iter()
            .map(|((class, id), _)| {
                go_on()?;
                Ok((*class, tree(&only(svg, &document, id))?))
            })
            .collect::<Result<Vec<_>, Error>>()?;
        let area = area(trees.iter().map(|(_, tree)| tree).chain([&lines]))?;
        let textures = trees.iter().map(|(class, tree)| {
            go_on()?;
            Ok((*class, draw(tree, area)?))
        });
        let textures = textures.collect::<Result<_, Error>>()?;
        Ok(Self { area, textures, signs: Signs::of_layers(&signs), lines: draw(&lines, area)? })
    }

    /// The ink of all textures together.
    pub(super) fn all_textures(&self) -> Plane {
        let mut all = Plane::filled(self.lines.size, 0.0);
        for (_, plane) in &self.textures {
            all.values.iter_mut().zip(&plane.values).for_each(|(sum, ink)| *sum = (*sum + ink).min(1.0));
        }
        all
    }
}

/// The document without what is not in the group `id`. Groups around it stay, for they may move, hide or clip it.
fn only(svg: &str, document: &Document<'_>, id: &str) -> String {
    let is_kept = |node: &Node<'_, '_>| node.attribute("id") == Some(id);
    let mut cuts = Vec::new();
    let mut open = vec![document.root_element()];
    while let Some(node) = open.pop() {
        for child in node.children().filter(Node::is_element) {
            if is_kept(&child) || RESOURCES.contains(&child.tag_name().name()) {
                continue;
            }
            if child.descendants().any(|below| is_kept(&below)) {
                open.push(child);
            } else {
                cuts.push(child.range());
            }
        }
    }
    cuts.sort_by_key(|cut| cut.start);
    let mut text = String::with_capacity(svg.len());
    let mut at = 0;
    for cut in cuts {
        text.push_str(&svg[at..cut.start]);
        at = cut.end;
    }
    text.push_str(&svg[at..]);
    text
}

fn tree(svg: &str) -> Result<Tree, Error> {
    let nothing = ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = usvg::Options { image_href_resolver: nothing, ..usvg::Options::default() };
    tree_of(&checked_document(svg)?, &options)
}

/// All ink of the trees with blank around it; the sheet where there is none.
fn area<'a>(trees: impl Iterator<Item = &'a Tree>) -> Result<MmRect, Error> {
    let mut all: Option<MmRect> = None;
    let mut sheet = MmRect::zero();
    for tree in trees {
        sheet = MmRect::new(MmPoint::zero(), MmPoint::new(tree.size().width(), tree.size().height()) * MM_PER_PX);
        if tree.root().has_children() {
            let ink = tree.root().abs_stroke_bounding_box();
            let (low, high) = (MmPoint::new(ink.left(), ink.top()), MmPoint::new(ink.right(), ink.bottom()));
            let ink = MmRect::new(low * MM_PER_PX, high * MM_PER_PX);
            all = Some(all.map_or(ink, |all| all.union(&ink)));
        }
    }
    let area = all.map_or(sheet, |all| all.inflate(MARGIN, MARGIN).round_out());
    let sides = [area.width().ceil().max(1.0), area.height().ceil().max(1.0)];
    if sides.iter().any(|side| !(side.is_finite() && *side <= LONGEST)) {
        return Err(Error::TooLargeToFeel { width: sides[0], height: sides[1], longest: LONGEST });
    }
    Ok(MmRect::new(area.min, area.min + crate::units::MmVector::new(sides[0], sides[1])))
}

/// Darkness of what a tree draws in `area` over white.
fn draw(tree: &Tree, area: MmRect) -> Result<Plane, Error> {
    let pixels = |mm: f32| mm as u32 * PX_PER_MM;
    let size = Size::new(pixels(area.width()), pixels(area.height()));
    let mut plane = Plane::filled(size, 0.0);
    if !tree.root().has_children() {
        return Ok(plane);
    }
    let too_large = || Error::TooLargeToFeel { width: area.width(), height: area.height(), longest: LONGEST };
    let per_px = PX_PER_MM as f32 * MM_PER_PX;
    let corner = area.min * PX_PER_MM as f32;
    let transform = Transform::from_row(per_px, 0.0, 0.0, per_px, -corner.x, -corner.y);
    check_canvases(tree, transform, size)?;
    let mut canvas = Pixmap::new(size.width, size.height).ok_or_else(too_large)?;
    canvas.fill(Color::WHITE);
    resvg::render(tree, transform, &mut canvas.as_mut());
    for (ink, pixel) in plane.values.iter_mut().zip(canvas.pixels()) {
        let light = u16::from(pixel.red()) + u16::from(pixel.green()) + u16::from(pixel.blue());
        *ink = 1.0 - f32::from(light) / 765.0;
    }
    Ok(plane)
}

#[cfg(test)]
mod tests;
