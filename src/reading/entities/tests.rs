//! Tests of `entities`.

use super::*;

#[test]
fn entities_are_replaced_by_what_they_stand_for() {
    let text = "<?xml version=\"1.0\"?><!DOCTYPE svg PUBLIC \"-//W3C//DTD\" \"a>.dtd\" [\n<!-- ] -->\n\
                <!ENTITY ns 'http://a/]'>\n<!ENTITY both \"&ns; 'b'\"><!ENTITY ns 'late'>\n\
                <!ENTITY far SYSTEM 'f'>]>\
                <svg xmlns=\"&ns;\" a=\"&both;&amp;&far;\"><!-- &ns; --><![CDATA[&ns;]]>&both;</svg>";
    let expected = "<?xml version=\"1.0\"?><svg xmlns=\"http://a/]\" a=\"http://a/] &apos;b&apos;&amp;&far;\">\
                    <!-- &ns; --><![CDATA[&ns;]]>http://a/] &apos;b&apos;</svg>";
    assert_eq!(replaced(text).expect("short"), expected);
    for same in ["<svg/>", "<!DOCTYPE svg><svg/>", "<!DOCTYPE svg [<!ENTITY a 'b'"] {
        assert_eq!(replaced(same).expect("short"), same);
    }
}

#[test]
fn entities_that_grow_are_refused() {
    let mut declared = "<!ENTITY a0 'aaaaaaaaaa'>".to_owned();
    for level in 1..9 {
        declared += &format!("<!ENTITY a{level} '{}'>", format!("&a{};", level - 1).repeat(10));
    }
    assert!(replaced(&format!("<!DOCTYPE svg [{declared}]><svg>&a8;</svg>")).is_err());
    let looped = "<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><svg>&a;</svg>";
    assert!(replaced(looped).is_err());
}
