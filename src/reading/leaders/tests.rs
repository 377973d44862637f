//! Tests of `leaders`.

use super::*;

fn tip_of(attributes: &str, points: [(f32, f32); 2]) -> MmPoint {
    let text = format!("<g {attributes}/>");
    let document = usvg::roxmltree::Document::parse(&text).expect("a group");
    let leader = Run::stroke(0.75, points.map(MmPoint::from).to_vec());
    *with_own_tip(leader, document.root_element()).points.last().expect("two points")
}

#[test]
fn the_tip_of_a_moved_label_stays() {
    let written = "data-leader='10 10 30 20'";
    let moved = "data-leader='10 10 30 20' transform='translate(5,5)'";
    assert_eq!(tip_of(moved, [(15.0, 15.0), (35.0, 25.0)]), MmPoint::new(30.0, 20.0));
    // not moved; moved with all of its layer; an end moved by hand; a page from before
    assert_eq!(tip_of(moved, [(10.0, 10.0), (30.0, 20.0)]), MmPoint::new(30.0, 20.0));
    assert_eq!(tip_of(written, [(15.0, 15.0), (35.0, 25.0)]), MmPoint::new(35.0, 25.0));
    assert_eq!(tip_of(moved, [(15.0, 15.0), (36.0, 22.0)]), MmPoint::new(36.0, 22.0));
    assert_eq!(tip_of("transform='scale(1)'", [(15.0, 15.0), (35.0, 25.0)]), MmPoint::new(35.0, 25.0));
}
