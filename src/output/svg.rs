//! A page as SVG.
use crate::Page;
/// The page as an SVG document.
pub fn write(page: &Page) -> String {
    let _ = page;
    String::from("<svg xmlns='http://www.w3.org/2000/svg'/>\n")
}
