//! PEF, read back as XML.

use roxmltree::{Document, Node};
use tactograph::internals::output::dots::{DocumentWords, DotMatrix, pef};

use super::{Random, dots, reading};

const PEF: &str = "http://www.daisy.org/ns/2008/pef";
const DC: &str = "http://purl.org/dc/elements/1.1/";

fn words(text: &str) -> Vec<(String, String)> {
    let document = Document::parse(text).expect("XML");
    let of_dublin_core = |node: &Node| node.tag_name().namespace() == Some(DC);
    let found = document.descendants().filter(of_dublin_core);
    found.map(|node| (node.tag_name().name().into(), node.text().unwrap_or("").into())).collect()
}

#[test]
fn pages_come_back() {
    let mut random = Random(5);
    for _ in 0..100 {
        let pages = random.pages();
        let text = pef::write(&pages, &DocumentWords { title: "A page", ..DocumentWords::default() });
        let document = Document::parse(&text).expect("XML");
        let all = |name: &'static str| document.descendants().filter(move |node| node.has_tag_name((PEF, name)));
        let volume = all("volume").next().expect("a volume");
        let said = ["cols", "rows", "rowgap", "duplex"].map(|name| volume.attribute(name).expect("there"));
        assert_eq!(said[2..], ["0", "false"]);
        let [columns, rows] = [0, 1].map(|i| said[i].parse::<usize>().expect("a number"));
        assert!(columns > 0 && rows > 0);
        let back: Vec<DotMatrix> = all("page")
            .map(|page| {
                let cells: Vec<&str> =
                    page.children().filter(Node::is_element).map(|row| row.text().unwrap_or("")).collect();
                assert!(cells.len() <= rows && cells.iter().all(|row| row.chars().count() <= columns));
                reading::ubrl(&(cells.join("\n") + "\n\u{c}")).remove(0)
            })
            .collect();
        assert_eq!(back.len(), pages.len().max(1));
        for (page, back) in pages.iter().zip(&back) {
            assert_eq!(dots(back), dots(page));
        }
    }
}

#[test]
fn any_words_are_kept_or_left_out() {
    let title = "<&>\"' ]]> \u{1} żółć 𝔊\u{fffe}\nend";
    let text = pef::write(
        &[],
        &DocumentWords { title, description: "a\tb & c", language: "pl-PL", description_language: "pl-PL", text: &[] },
    );
    let found = words(&text);
    let names: Vec<_> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["format", "identifier", "title", "description", "language"]);
    assert_eq!(found[0].1, "application/x-pef+xml");
    assert_eq!(found[2].1, "<&>\"' ]]> \u{fffd} żółć 𝔊\u{fffd} end");
    assert_eq!((found[3].1.as_str(), found[4].1.as_str()), ("a b & c", "pl-PL"));
    for language in ["", "no language", "-", "en-", "1a", "abcdefghi", "en-é"] {
        let text = pef::write(&[], &DocumentWords { title, language, ..DocumentWords::default() });
        assert_eq!(words(&text).len(), 3, "{language}");
    }
}

#[test]
fn documents_are_told_apart_by_their_identifier() {
    let identifier = |pages: &[DotMatrix], title| {
        words(&pef::write(pages, &DocumentWords { title, ..DocumentWords::default() })).remove(1).1
    };
    let (page, other) = (reading::drawn("#..\n"), reading::drawn(".#.\n"));
    let one = identifier(std::slice::from_ref(&page), "A");
    assert_eq!(one, identifier(std::slice::from_ref(&page), "A"));
    for another in [
        identifier(&[other], "A"),
        identifier(std::slice::from_ref(&page), "B"),
        identifier(&[page.clone(), page], "A"),
    ] {
        assert_ne!(one, another);
    }
}
