//! Tests of `profiles`.

use super::*;

#[test]
fn a_shown_profile_tells_every_range_and_is_a_profile_still() {
    let shown = with_ranges(Profile::built_in()[0].text);
    for key in Profile::keys() {
        let line = format!("{} = ", key.name());
        let told = |text: &str| text.starts_with(&line) && text.ends_with(&format!(" # {}", key.range()));
        assert!(shown.lines().any(told), "no range for {}", key.path);
    }
    let read = Profile::from_toml(&shown, "shown.toml").expect("it can be read again");
    assert_eq!(read.parameters(), Profile::named("swell-a4").expect("it is built in").parameters());
}
