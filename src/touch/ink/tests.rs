//! Tests of `ink`.

use super::*;

const PAGE: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="80mm" viewBox="0 0 100 80">
    <rect id="background" width="100" height="80" fill="#000"/>
    <g id="figure" transform="translate(10 0)">
      <g id="textures"><g id="texture-red"><path d="M20,20h10v4h-10z"/></g>
        <g id="texture-blue" style="display:none"><path d="M60,20h2v2h-2z"/></g></g>
      <g id="lines" stroke="#000"><path d="M20,60h30" stroke-width="2"/></g>
    </g></svg>"##;

#[test]
fn ink_is_where_the_page_has_it_with_all_that_an_editor_did() {
    let ink = Ink::of(PAGE).expect("this is a page");
    assert_eq!(ink.area, MmRect::new(MmPoint::new(22.0, 12.0), MmPoint::new(68.0, 69.0)));
    let total = |plane: &Plane| plane.values.iter().sum::<f32>() / (PX_PER_MM * PX_PER_MM) as f32;
    let of = |class| ink.textures.iter().find(|(c, _)| *c == class).map(|(_, plane)| total(plane));
    assert!((of(Class::Red).expect("there is red") - 40.0).abs() < 0.1);
    assert_eq!(of(Class::Blue), Some(0.0), "a hidden layer has no ink");
    assert_eq!(of(Class::Grey), None);
    assert!((total(&ink.lines) - 60.0).abs() < 0.1);
    let red = &ink.textures.iter().find(|(class, _)| *class == Class::Red).expect("there is red").1;
    let at = |x: f32, y: f32| ((y - 12.0) * 8.0) as usize * ink.lines.size.width as usize + ((x - 22.0) * 8.0) as usize;
    assert!(
        red.values[at(35.0, 22.0)] > 0.99 && red.values[at(25.0, 22.0)] < 0.01,
        "the group around the figure moves it"
    );
}

#[test]
fn what_is_no_page_is_refused_in_one_line() {
    for (text, want) in [
        ("hello", "cannot be read"),
        ("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>", "figure"),
        (
            "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'><g id='figure'><g id='lines'>\
             <path d='M0,0h9999' stroke='#000'/></g></g></svg>",
            "mm",
        ),
    ] {
        let told = Ink::of(text).expect_err("this is no page").to_string();
        assert!(told.contains(want) && !told.contains('\n'), "{told}");
    }
}
