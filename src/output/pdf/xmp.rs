//! What a PDF says of itself, for programs that look for it as XMP.

use std::fmt::Write;

use super::super::{origin_lines, plain};
use super::PROGRAM;
use crate::page::Page;

/// The packet for a document whose first page is this. The number of PDF/UA says that the file keeps the rules of ISO 14289-1 (accessible PDF); `tactograph:made`
/// says how the page was made, as the SVG does in its `metadata`.
pub(super) fn packet(title: &str, page: &Page) -> String {
    let (title, description) = (escaped(title), escaped(&page.description));
    let language = escaped(&page.language);
    let mut made = String::new();
    for line in origin_lines(&page.origin) {
        let _ = writeln!(made, "<rdf:li>{}</rdf:li>", escaped(&line)); // writing to a String cannot fail
    }
    format!(
        r#"<?xpacket begin="{bom}" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/">
<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/" xmlns:xmp="http://ns.adobe.com/xap/1.0/" xmlns:pdf="http://ns.adobe.com/pdf/1.3/" xmlns:pdfuaid="http://www.aiim.org/pdfua/ns/id/" xmlns:tactograph="urn:tactograph:1">
<pdfuaid:part>1</pdfuaid:part>
<dc:format>application/pdf</dc:format>
<dc:title><rdf:Alt><rdf:li xml:lang="x-default">{title}</rdf:li></rdf:Alt></dc:title>
<dc:description><rdf:Alt><rdf:li xml:lang="x-default">{description}</rdf:li></rdf:Alt></dc:description>
<dc:language><rdf:Bag><rdf:li>{language}</rdf:li></rdf:Bag></dc:language>
<xmp:CreatorTool>{PROGRAM}</xmp:CreatorTool>
<pdf:Producer>{PROGRAM}</pdf:Producer>
<tactograph:made><rdf:Seq>
{made}</rdf:Seq></tactograph:made>
</rdf:Description>
</rdf:RDF>
</x:xmpmeta>
<?xpacket end="r"?>"#,
        bom = '\u{feff}'
    )
}

fn escaped(text: &str) -> String {
    plain(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
