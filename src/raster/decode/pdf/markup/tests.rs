//! Tests of `markup`.

use super::*;

const PAGE: &str = r##"<svg viewBox="0 0 72 36" width="72" height="36" xmlns="http://www.w3.org/2000/svg">
<g clip-path="url(#c0)">
    <path d="M0,0 L1,1"/>
</g>
<g clip-path="url(#c0)">
    <use xlink:href="#g0" transform="scale(0.1 0.1)"/>
</g>
<g clip-path="url(#c0)">
    <g opacity="0.5" clip-path="url(#c0)">
        <path d="M2,2 L3,3"/>
    </g>
</g>
<use xlink:href="#e12"/>
<g clip-path="url(#c1)">
    <use xlink:href="#s0"/>
</g>
<path d="M4,4"/>
<path d="M5,5" fill="#000000"/>
</svg>"##;

#[test]
fn letters_are_left_out_and_clipped_neighbours_united() {
    let without = prepared(PAGE, (72.0, 36.0), Some(&["<path d=\"M5,5\"".to_owned()]));
    assert_eq!(
        without,
        r##"<svg viewBox="0 0 72 36" width="96" height="48" xmlns="http://www.w3.org/2000/svg">
<g clip-path="url(#c0)">
<path d="M0,0 L1,1"/>
<g opacity="0.5" clip-path="url(#c0)">
<path d="M2,2 L3,3"/>
</g>
</g>
<g clip-path="url(#c1)">
<use xlink:href="#s0"/>
</g>
<path d="M4,4"/>
</svg>"##
    );
    let with = prepared(PAGE, (72.0, 36.0), None);
    assert_eq!(with.matches("<use").count(), 3, "{with}");
    assert_eq!(with.matches("</g>").count(), 3, "{with}");
    assert_eq!(with.matches("M5,5").count(), 1, "{with}");
}
