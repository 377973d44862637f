//! The pages that a program makes of a picture, as it writes them: one file, or several with numbers.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Output};

use resvg::usvg::roxmltree::Document;
use tempfile::TempDir;

use crate::Fault;

/// What became of a picture.
pub(crate) struct Made {
    /// What the program said.
    pub(crate) said: String,
    /// In their order; or why there are none.
    pub(crate) pages: Result<Vec<Page>, Fault>,
}

/// A page. Its unit is the millimetre.
pub(crate) struct Page {
    pub(crate) svg: String,
    /// Width and height of the sheet.
    pub(crate) size: [f32; 2],
    /// Left, top, width and height of its figure and of its overview, those of them that it has.
    pub(crate) parts: Vec<[f32; 4]>,
}

/// Has a program make the pages of a picture.
pub(crate) fn made(picture: &Path, command: &str) -> Made {
    match run(picture, command) {
        Ok((folder, Output { status, stderr, .. })) => {
            Made { said: String::from_utf8_lossy(&stderr).trim().to_owned(), pages: read(folder.path(), status) }
        }
        Err(fault) => Made { said: String::new(), pages: Err(fault) },
    }
}

/// Runs a program on a picture. Its pages are in the folder.
fn run(picture: &Path, command: &str) -> Result<(TempDir, Output), Fault> {
    let folder = tempfile::tempdir()?;
    let mut words = command.split_whitespace();
    let output = Command::new(words.next().ok_or("there is no command")?)
        .args(words)
        .arg(picture)
        .arg("-o")
        .arg(folder.path().join("page.svg"))
        .arg("--force")
        .output()?;
    Ok((folder, output))
}

fn read(folder: &Path, status: ExitStatus) -> Result<Vec<Page>, Fault> {
    if !status.success() {
        return Err(status.to_string().into());
    }
    let files = written(folder)?;
    let pages: Result<Vec<Page>, Fault> = files.iter().map(|file| Page::of(std::fs::read_to_string(file)?)).collect();
    let pages = pages?;
    if pages.iter().all(|page| page.parts.is_empty()) {
        return Err("the program wrote no figure".into());
    }
    Ok(pages)
}

/// The files that a program wrote which was asked for `page.svg`: this one or, as those are which write several, all
/// `page-*.svg`, the tenth after the ninth.
fn written(folder: &Path) -> Result<Vec<PathBuf>, Fault> {
    let page = folder.join("page.svg");
    if page.exists() {
        return Ok(vec![page]);
    }
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if name.starts_with("page-") && name.ends_with(".svg") {
            names.push((name.len(), name));
        }
    }
    names.sort();
    Ok(names.into_iter().map(|(_, name)| folder.join(name)).collect())
}

impl Page {
    fn of(svg: String) -> Result<Self, Fault> {
        let (size, parts) = measures(&svg)?;
        Ok(Self { svg, size, parts })
    }
}

/// Size and parts of a page.
fn measures(svg: &str) -> Result<([f32; 2], Vec<[f32; 4]>), Fault> {
    let document = Document::parse(svg)?;
    let view = numbers(document.root_element().attribute("viewBox").unwrap_or_default());
    let [_, _, width, height] = view[..] else { return Err("a page without a viewBox".into()) };
    let mut parts: Vec<[f32; 4]> = Vec::new();
    for layer in ["figure", "overview"] {
        let of_layer = document.descendants().find(|node| node.attribute("id") == Some(layer));
        let place = numbers(of_layer.and_then(|node| node.attribute("data-box")).unwrap_or_default());
        parts.extend(<[f32; 4]>::try_from(place).ok());
    }
    Ok(([width, height], parts))
}

fn numbers(text: &str) -> Vec<f32> {
    text.split([' ', ',']).filter_map(|number| number.parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_one_file_or_those_with_numbers_in_their_order() {
        let folder = tempfile::tempdir().unwrap();
        let check = |expected: &[&str]| {
            let files = written(folder.path()).unwrap();
            let names: Vec<_> = files.iter().filter_map(|file| file.file_name()?.to_str()).collect();
            assert_eq!(names, expected);
        };
        check(&[]);
        for name in ["page-10.svg", "page-2.svg", "page-1.svg", "page-1.png", "other-1.svg"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        check(&["page-1.svg", "page-2.svg", "page-10.svg"]);
        std::fs::write(folder.path().join("page.svg"), "").unwrap();
        check(&["page.svg"]);
    }

    #[test]
    fn a_page_has_the_places_of_those_layers_that_it_has() {
        let svg = "<svg viewBox=\"0 0 210 297\"><g id=\"overview\" data-box=\"10 200 80 60\"/><g id=\"key\"/></svg>";
        let page = Page::of(svg.to_owned()).unwrap();
        assert_eq!((page.size, page.parts), ([210.0, 297.0], vec![[10.0, 200.0, 80.0, 60.0]]));
        assert!(Page::of("<svg/>".to_owned()).is_err_and(|fault| fault.to_string() == "a page without a viewBox"));
    }
}
