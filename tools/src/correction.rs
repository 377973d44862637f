//! One correction of a page by hand, as somebody would make it in an editor of SVG drawings, in stages: plain changes of the
//! page's XML. `docs/editing.md` shows them (`tools/src/bin/correction.rs`), and the tests write the result in all formats.

use usvg::roxmltree::{Document, Node};

/// A stage: what was done, and the page as it is then.
#[derive(Debug, Clone)]
pub struct Stage {
    /// What was done, in a few words.
    pub what: &'static str,
    /// The SVG.
    pub svg: String,
}

/// Short pieces on the saucer and on the table, and a spot on the cup.
const CLUTTER: [&str; 6] = ["line-14", "line-18", "line-19", "line-20", "line-21", "line-23"];
/// What was found of the saucer between the spoon and a gap ...
const BROKEN: &str = "line-8";
/// ... and the curve that is drawn in its place, mm.
const SAUCER: &str = "M139.28,68.66 C144.5,73.2 151.2,81 154.33,87.31";
/// The table at the left, which is red like the rest of it.
const MOVED: (&str, &str) = ("region-2", "texture-red");
/// A dot of a braille cell's size on the cup, mm.
const DOT: [f32; 3] = [103.0, 110.0, 0.75];
/// A cloth that the picture does not have, as a shape filled with blue.
const CLOTH: &str = "M24,128 L44,122 L52,148 L24,148 Z";

/// The stages of a correction of the page of `samples/coffee.png`, the page itself first.
///
/// # Errors
/// The id of what is not on the page, if it is another page.
pub fn stages(page: &str) -> Result<Vec<Stage>, String> {
    let mut all = vec![Stage { what: "the page as it is made", svg: page.to_owned() }];
    let mut add = |what, change: &dyn Fn(&str) -> Result<String, String>| {
        let svg = change(&all[all.len() - 1].svg)?;
        all.push(Stage { what, svg });
        Ok::<(), String>(())
    };
    add("clutter deleted", &|svg| CLUTTER.iter().try_fold(svg.to_owned(), |svg, id| without(&svg, id)))?;
    add("the gap of the saucer closed", &|svg| {
        inside(&without(svg, BROKEN)?, "lines", &format!("<path id=\"saucer\" stroke-width=\"1.4\" d=\"{SAUCER}\"/>"))
    })?;
    add("an area moved to another colour", &|svg| {
        let (id, to) = MOVED;
        let moved = svg[range(svg, id)?].to_owned();
        inside(&without(svg, id)?, to, &moved)
    })?;
    add("a dot and a blue cloth drawn", &|svg| {
        let [x, y, radius] = DOT;
        let drawn = format!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/><path id=\"cloth\" fill=\"#3060d0\" d=\"{CLOTH}\"/></svg>"
        );
        let (before, after) = svg.rsplit_once("</svg>").ok_or("no svg")?;
        Ok(format!("{before}{drawn}{after}"))
    })?;
    Ok(all)
}

/// Where an element is in the text.
fn range(svg: &str, id: &str) -> Result<std::ops::Range<usize>, String> {
    let document = Document::parse(svg).map_err(|fault| fault.to_string())?;
    element(&document, id).map(|node| node.range())
}

fn element<'d>(document: &'d Document<'_>, id: &str) -> Result<Node<'d, 'd>, String> {
    document.descendants().find(|node| node.attribute("id") == Some(id)).ok_or_else(|| format!("there is no {id}"))
}

fn without(svg: &str, id: &str) -> Result<String, String> {
    let range = range(svg, id)?;
    Ok(format!("{}{}", &svg[..range.start], &svg[range.end..]))
}

/// Adds an element at the end of a group.
fn inside(svg: &str, group: &str, added: &str) -> Result<String, String> {
    let end = range(svg, group)?.end - "</g>".len();
    Ok(format!("{}{added}{}", &svg[..end], &svg[end..]))
}
