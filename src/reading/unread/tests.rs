//! Tests of `unread`.

use crate::units::{MmPoint, MmRect};
use crate::{Checked, Finding, PageOptions};

/// The check of a page whose figure is `20 20 160 200`, with elements beside it.
fn checked(beside: &str) -> Checked {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='210mm' height='297mm' viewBox='0 0 210 297'>\
         <g id='figure' data-box='20 20 160 200'><g id='lines' fill='none' stroke='#000' stroke-width='1'>\
         <path d='M30,210h40'/></g></g>{beside}</svg>"
    );
    crate::check(svg, &PageOptions::new()).expect("it is a page")
}

fn of<'c>(checked: &'c Checked, rule: &str) -> Vec<&'c Finding> {
    checked.findings.iter().filter(|finding| finding.rule.id == rule).collect()
}

/// The box of the one finding of a rule, in whole mm.
fn extent(checked: &Checked, rule: &str) -> [i32; 4] {
    let found = of(checked, rule);
    assert_eq!(found.len(), 1, "{checked}");
    let MmRect { min, max } = found[0].extent.expect("it has a place");
    [min.x, min.y, max.x, max.y].map(|mm| mm.round() as i32)
}

#[test]
fn a_picture_has_its_box_whatever_moves_it() {
    let picture = "<image x='20' y='20' width='160' height='100' href='data:,'/>";
    let checked_one = checked(picture);
    assert_eq!(extent(&checked_one, "picture"), [20, 20, 180, 120]);
    assert!((checked_one.verdict.faulty - 0.5).abs() < 0.05, "half of the figure: {}", checked_one.verdict.faulty);
    let place = &of(&checked_one, "picture")[0].place;
    assert!(place.ends_with("of the figure"), "{place}");
    let moved = checked(&format!("<g transform='translate(10 20) scale(0.5)'>{picture}</g>"));
    assert_eq!(extent(&moved, "picture"), [20, 30, 100, 80]);
    let turned = checked("<image width='30' height='20' transform='translate(100 50) rotate(90)' href='data:,'/>");
    assert_eq!(extent(&turned, "picture"), [80, 50, 100, 80]);
    let unsaid = checked("<image x='50' y='60' width='auto' href='data:,'/>");
    assert_eq!(extent(&unsaid, "picture")[..2], [50, 60]);
    assert!(of(&checked(&format!("<g visibility='hidden'>{picture}</g>")), "picture").is_empty());
    // what only its clones show has no place of its own
    let symbol = checked(&format!("<symbol id='s'>{picture}</symbol><use href='#s'/>"));
    assert_eq!(of(&symbol, "picture")[0].extent, None);
}

#[test]
fn letters_have_the_box_of_their_text() {
    let large = checked("<text x='30' y='120' font-size='30'>Cup of tea</text>");
    let [left, top, right, bottom] = extent(&large, "letters");
    assert!(left == 30 && (90..110).contains(&top) && (125..135).contains(&bottom), "{top} to {bottom}");
    assert!((150..210).contains(&right), "{right}");
    assert!(large.verdict.faulty > 0.1, "{}", large.verdict.faulty);
    assert_eq!(of(&large, "letters")[0].at, Some(MmPoint::new(30.0, 120.0)), "where it begins");
    let middle = checked("<text x='100' y='120' font-size='10' text-anchor='middle'>Cup</text>");
    let [left, _, right, _] = extent(&middle, "letters");
    assert_eq!(left + right, 200);
    let turned = checked("<text transform='translate(100 120) rotate(90)' font-size='10'>Cup of tea</text>");
    let [left, top, right, bottom] = extent(&turned, "letters");
    assert!(bottom - top > 2 * (right - left) && top == 120, "{left} to {right}, {top} to {bottom}");
    let lines = "<text x='30' y='50' font-size='10'>Cup<tspan x='30' y='62'>of</tspan><tspan x='30' y='74'>tea</tspan>";
    let [left, _, right, bottom] = extent(&checked(&format!("{lines}</text>")), "letters");
    assert!(right - left < 25 && bottom > 70, "three lines of three letters");
}

#[test]
fn what_is_left_out_is_found_with_its_place_and_its_letters() {
    let clone = checked("<g transform='translate(10 5)'><use href='other.svg#cup' x='60' y='240'/></g>");
    let found = of(&clone, "elsewhere");
    assert!(found.len() == 1 && !found[0].is_error(), "{clone}");
    assert!(found[0].what.starts_with("a clone shows \"other.svg#cup\", which is not in this file"), "{clone}");
    assert_eq!(extent(&clone, "elsewhere")[..2], [70, 245]);
    assert_eq!(of(&checked("<use href='#gone'/>"), "elsewhere").len(), 1);
    assert!(
        of(&checked("<path id='here' d='M30,240h40' stroke='#000'/><use href='#here' y='20'/>"), "elsewhere")
            .is_empty()
    );
    let html = "<foreignObject x='40' y='230' width='50' height='20'><p xmlns='http://www.w3.org/1999/xhtml'>A cup\
                <b>of tea</b></p></foreignObject>";
    let foreign = checked(html);
    assert_eq!(extent(&foreign, "elsewhere"), [40, 230, 90, 250]);
    assert_eq!(extent(&foreign, "letters"), [40, 230, 90, 250]);
    assert!(of(&foreign, "letters")[0].what.starts_with("\"A cup of tea\" is written in letters"), "{foreign}");
    let replaced = checked(&format!("<switch>{html}<text x='40' y='240'>A cup</text></switch>"));
    assert!(of(&replaced, "elsewhere").is_empty(), "{replaced}");
    assert_eq!(of(&replaced, "letters").len(), 1, "those that are shown in its place");
}
