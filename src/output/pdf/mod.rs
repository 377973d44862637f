//! Pages as a PDF document in true millimetres, written straight from the pages: DeviceGray black, layers, and words
//! that a screen reader finds.
//!
//! ```text
//! catalog   language, "show the title", "print at true size" (no scaling)
//!   pages       one a page: MediaBox = TrimBox = the sheet; one content stream
//!   structure   Document > Figure with Alt (the page's description), one a page
//!   layers      the groups of the SVG under the same names; one set for all pages
//!   metadata    title, description, language, how it was made, PDF/UA-1
//! ```
//!
//! Strokes stay strokes of their width, with round ends. There is no clock: the same pages give the same bytes.

mod content;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::types::StructRole;
use pdf_writer::writers::StructElement;
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, Settings, TextStr};

use self::content::POINTS_PER_MM;
use super::layer::Layer;
use super::seal;
use super::text::{origin_lines, plain};
use crate::page::Page;

/// Who wrote the file.
const PROGRAM: &str = concat!("tactograph ", env!("CARGO_PKG_VERSION"));
/// Of zlib-rs, 1..=9. Measured on pages of photographs: files are 1 to 2 % larger than at 6, and 20,000 glyphs take
/// half the time.
const LEVEL: Compression = Compression::new(3);

/// The pages, at least one, as one PDF document called `title`, which has the language and the origin of the first. The
/// same pages give the same bytes.
pub fn write<'p>(title: &str, pages: impl IntoIterator<Item = &'p Page>) -> Vec<u8> {
    let pages: &[&Page] = &pages.into_iter().collect::<Vec<_>>();
    let mut pdf = Pdf::with_settings(Settings { pretty: false });
    let ids = ObjectIds::new(pages);
    catalog(&mut pdf, pages, &ids);
    for (&layer, &id) in &ids.layers {
        pdf.indirect(id).dict().pair(Name(b"Type"), Name(b"OCG")).pair(Name(b"Name"), TextStr(&layer.label()));
    }
    structure(&mut pdf, pages, &ids);
    pdf.pages(ids.tree).count(pages.len() as i32).kids(ids.pages.iter().map(|page| page.page));
    for (number, (page, own)) in pages.iter().zip(&ids.pages).enumerate() {
        sheet(&mut pdf, page, own, number as i32, &ids);
    }
    let has_print = pages.iter().any(|page| !page.print.is_empty());
    if pages.iter().any(|page| has_words(page)) {
        pdf.type1_font(ids.font).base_font(Name(b"Helvetica")).encoding_predefined(Name(b"WinAnsiEncoding"));
    }
    if let Some(first) = pages.first() {
        let title = plain(title);
        let packet = xmp(&title, first, !has_print);
        let mut metadata = pdf.stream(ids.metadata, packet.as_bytes());
        metadata.pair(Name(b"Type"), Name(b"Metadata")).pair(Name(b"Subtype"), Name(b"XML"));
        metadata.finish();
        let mut info = pdf.document_info(ids.info);
        info.title(TextStr(&title)).creator(TextStr(PROGRAM)).producer(TextStr(PROGRAM));
    }
    // Everything up to here is what the seal is of; after it come only the table of contents and the seal.
    let seal = seal::of(pdf.as_bytes()).into_bytes();
    pdf.set_file_id((seal.clone(), seal));
    pdf.finish()
}

/// Whether these bytes are a PDF as [`write()`] makes it, changed by nobody since.
pub fn is_as_written(bytes: &[u8]) -> bool {
    let tail = &bytes[bytes.len().saturating_sub(TAIL)..];
    let Some(at) = find_last(tail, b"startxref\n") else { return false };
    let digits = tail[at + b"startxref\n".len()..].split(|&byte| byte == b'\n').next().unwrap_or_default();
    let Some(end) = std::str::from_utf8(digits).ok().and_then(|text| text.parse::<usize>().ok()) else { return false };
    let Some(sealed) = bytes.get(..end).filter(|_| tail.ends_with(format!("startxref\n{end}\n%%EOF").as_bytes()))
    else {
        return false; // something follows
    };
    let seal = seal::of(sealed);
    find_last(tail, format!("/ID[({seal})({seal})]").as_bytes()).is_some()
}

/// Bytes at the end of a file in which its trailer is looked for; it has about 150.
const TAIL: usize = 1024;

fn find_last(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).rposition(|part| part == what)
}

/// The numbers of all objects.
struct ObjectIds {
    catalog: Ref,
    tree: Ref,
    info: Ref,
    metadata: Ref,
    root: Ref,
    document: Ref,
    /// That of words in print, and of those in braille, where it is not seen.
    font: Ref,
    /// Every layer of any page, in the order of a page.
    layers: BTreeMap<Layer, Ref>,
    pages: Vec<PageIds>,
}

struct PageIds {
    page: Ref,
    content: Ref,
    figure: Ref,
}

impl ObjectIds {
    fn new(pages: &[&Page]) -> Self {
        let mut next = Ref::new(1);
        let mut new = || next.bump();
        let [catalog, tree, info, metadata, root, document] = [(); 6].map(|()| new());
        let mut layers: BTreeMap<Layer, Ref> =
            pages.iter().copied().flat_map(content::layers).map(|layer| (layer, root)).collect();
        layers.values_mut().for_each(|id| *id = new());
        let pages = pages.iter().map(|_| PageIds { page: new(), content: new(), figure: new() }).collect();
        let font = new();
        Self { catalog, tree, info, metadata, root, document, font, layers, pages }
    }
}

fn catalog(pdf: &mut Pdf, pages: &[&Page], ids: &ObjectIds) {
    let mut catalog = pdf.catalog(ids.catalog);
    catalog.pages(ids.tree).metadata(ids.metadata);
    if let Some(first) = pages.first() {
        catalog.lang(TextStr(&plain(&first.language)));
    }
    catalog.mark_info().marked(true);
    let mut viewer = catalog.viewer_preferences();
    // Printing dialogs then begin with "actual size": gaps are chosen for a fingertip and must not shrink.
    viewer.display_doc_title(true).pair(Name(b"PrintScaling"), Name(b"None"));
    viewer.finish();
    catalog.pair(Name(b"StructTreeRoot"), ids.root);
    let mut layers = catalog.insert(Name(b"OCProperties")).dict();
    layers.insert(Name(b"OCGs")).array().items(ids.layers.values().copied());
    let mut shown = layers.insert(Name(b"D")).dict();
    shown.pair(Name(b"Name"), TextStr("Layers")); // PDF/UA wants one
    order(shown.insert(Name(b"Order")).array(), ids);
}

/// The tree of layers as viewers list it: a list after a layer holds the layers in it.
fn order(mut outer: pdf_writer::Array<'_>, ids: &ObjectIds) {
    let textures = ids.layers.range(Layer::Textures..Layer::Lines);
    let in_textures: Vec<Ref> = textures.skip(1).map(|(_, &id)| id).collect();
    for (&layer, &id) in &ids.layers {
        match layer {
            Layer::Figure => {
                outer.item(id);
                let mut inner = outer.push().array();
                if let Some(&textures) = ids.layers.get(&Layer::Textures) {
                    inner.item(textures).push().array().items(in_textures.iter().copied());
                }
                inner.items(ids.layers.get(&Layer::Lines).copied());
            }
            // listed inside the figure above
            Layer::Textures | Layer::Texture(_) | Layer::Lines => {}
            Layer::OrientationMark
            | Layer::Registration
            | Layer::Frame
            | Layer::OverviewFrame
            | Layer::Overview
            | Layer::Labels
            | Layer::Braille(_)
            | Layer::PrintWords => {
                outer.item(id);
            }
        }
    }
}

/// The tags: a document of figures, each with the words for its page.
fn structure(pdf: &mut Pdf, pages: &[&Page], ids: &ObjectIds) {
    let mut root = pdf.indirect(ids.root).dict();
    root.pair(Name(b"Type"), Name(b"StructTreeRoot")).pair(Name(b"K"), ids.document);
    // From a page's number to the tags of its pieces of marked content, of which it has one.
    let mut parents = root.insert(Name(b"ParentTree")).dict();
    let mut numbers = parents.insert(Name(b"Nums")).array();
    for (number, own) in ids.pages.iter().enumerate() {
        numbers.item(number as i32).push().array().item(own.figure);
    }
    numbers.finish();
    parents.finish();
    root.pair(Name(b"ParentTreeNextKey"), pages.len() as i32);
    root.finish();
    let mut document = pdf.indirect(ids.document).start::<StructElement<'_>>();
    document.kind(StructRole::Document).parent(ids.root);
    document.insert(Name(b"K")).array().items(ids.pages.iter().map(|own| own.figure));
    document.finish();
    for (page, own) in pages.iter().zip(&ids.pages) {
        let (title, description) = (plain(&page.title), plain(&page.description));
        let mut figure = pdf.indirect(own.figure).start::<StructElement<'_>>();
        figure.kind(StructRole::Figure).parent(ids.document).page(own.page);
        figure.title(TextStr(&title)).alt(TextStr(&description)).lang(TextStr(&plain(&page.description_language)));
        figure.pair(Name(b"K"), content::MARKED_CONTENT);
        figure.attributes().push().layout().bbox(rect(page));
    }
}

fn sheet(pdf: &mut Pdf, page: &Page, own: &PageIds, number: i32, ids: &ObjectIds) {
    let name = |layer: Layer| ids.layers.get(&layer).map_or_else(String::new, |id| format!("L{}", id.get()));
    let mut leaf = pdf.page(own.page);
    leaf.parent(ids.tree).media_box(rect(page)).trim_box(rect(page)).contents(own.content).struct_parents(number);
    let mut resources = leaf.resources();
    let mut properties = resources.insert(Name(b"Properties")).dict();
    for layer in content::layers(page) {
        if let Some(&id) = ids.layers.get(&layer) {
            properties.pair(Name(name(layer).as_bytes()), id);
        }
    }
    properties.finish();
    if has_words(page) {
        resources.fonts().pair(content::FONT, ids.font);
    }
    resources.finish();
    leaf.finish();
    let content = compressed(&content::write(page, &name));
    pdf.stream(own.content, &content).filter(Filter::FlateDecode);
}

/// Whether words stand on a page, in braille or in print.
fn has_words(page: &Page) -> bool {
    !page.print.is_empty() || !page.braille.is_empty()
}

fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut stream = ZlibEncoder::new(Vec::new(), LEVEL);
    // Writing to memory cannot fail.
    let _ = stream.write_all(bytes);
    stream.finish().unwrap_or_default()
}

fn rect(page: &Page) -> Rect {
    let [width, height] = page.sheet.map(|side| side * POINTS_PER_MM);
    Rect::new(0.0, 0.0, width, height)
}

/// The vocabularies of the metadata.
const NAMESPACES: &str = concat!(
    r#" xmlns:dc="http://purl.org/dc/elements/1.1/""#,
    r#" xmlns:xmp="http://ns.adobe.com/xap/1.0/""#,
    r#" xmlns:pdf="http://ns.adobe.com/pdf/1.3/""#,
    r#" xmlns:pdfuaid="http://www.aiim.org/pdfua/ns/id/""#,
    r#" xmlns:tactograph="urn:tactograph:1""#,
);

/// What a PDF says of itself as XMP, for a document whose first page is this. The number of PDF/UA says that the file
/// keeps the rules of ISO 14289-1 (accessible PDF); `tactograph:made` says how the page was made, as the SVG does in
/// its `metadata`. A file with words in print does not say so: their font is not in it (for words that are not seen it
/// need not be, clause 7.21.4.1).
fn xmp(title: &str, page: &Page, is_accessible: bool) -> String {
    let (title, description) = (escaped(title), escaped(&page.description));
    let mut languages = vec![&page.language, &page.description_language];
    languages.dedup();
    let languages: String = languages.into_iter().map(|tag| format!("<rdf:li>{}</rdf:li>", escaped(tag))).collect();
    let mut made = String::new();
    for line in origin_lines(&page.origin) {
        let _ = writeln!(made, "<rdf:li>{}</rdf:li>", escaped(&line)); // writing to a String cannot fail
    }
    format!(
        r#"<?xpacket begin="{bom}" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/">
<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about=""{NAMESPACES}>
{claim}<dc:format>application/pdf</dc:format>
<dc:title><rdf:Alt><rdf:li xml:lang="x-default">{title}</rdf:li></rdf:Alt></dc:title>
<dc:description><rdf:Alt><rdf:li xml:lang="x-default">{description}</rdf:li></rdf:Alt></dc:description>
<dc:language><rdf:Bag>{languages}</rdf:Bag></dc:language>
<xmp:CreatorTool>{PROGRAM}</xmp:CreatorTool>
<pdf:Producer>{PROGRAM}</pdf:Producer>
<tactograph:made><rdf:Seq>
{made}</rdf:Seq></tactograph:made>
</rdf:Description>
</rdf:RDF>
</x:xmpmeta>
<?xpacket end="r"?>"#,
        claim = if is_accessible { "<pdfuaid:part>1</pdfuaid:part>\n" } else { "" },
        bom = '\u{feff}'
    )
}

fn escaped(text: &str) -> String {
    plain(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
