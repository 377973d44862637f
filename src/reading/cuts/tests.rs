//! Tests of `cuts`.

use super::*;

fn taken_out(css: &str) -> String {
    let mut out = css.to_owned();
    values(css).into_iter().rev().for_each(|range| out.replace_range(range, NONE));
    out
}

#[test]
fn values_end_where_declarations_do() {
    for (css, want) in [
        ("fill:none;filter:url(#a);stroke:#000", "fill:none;filter:none;stroke:#000"),
        ("filter : url(&quot;#a&quot;) ;mask:none", "filter : none ;mask:none"),
        ("clip-path:url('#a;b');mask:url(#b)", "clip-path:none;mask:none"),
        (".a{filter:blur(2px) url(#a)}.b{mask-type:alpha}", ".a{filter:none}.b{mask-type:alpha}"),
        ("-inkscape-filter:url(#a);é:filter", "-inkscape-filter:url(#a);é:filter"),
        ("filter:;mask", "filter:;mask"),
    ] {
        assert_eq!(taken_out(css), want);
    }
}
