//! `textures.palette`: which class is told by which sign.

use tactograph::internals::profile::{Profile, Value};
use tactograph::internals::textures::Sign;

fn faults(text: &str) -> String {
    let text = format!("inherits = \"swell-a4\"\n{text}");
    Profile::from_toml(&text, "my.toml").map_or_else(|faults| crate::profiles::in_lines(&faults), |_| "none".into())
}

#[test]
fn a_school_keeps_its_own_code() {
    for text in [
        "[textures.palette]\nblue = \"rhombus 90\"\nyellow = \"rhombus 0\"",
        "[textures]\nalong = 2.9\npalette.blue = \"rhombus 90\"\npalette.yellow = \"rhombus 0\"",
        "textures.palette = { blue = \"rhombus 90\", yellow = \"rhombus 0\" }",
    ] {
        assert_eq!(faults(text), "none", "{text}");
        let profile = Profile::from_toml(&format!("inherits = \"swell-a4\"\n{text}"), "my.toml").expect("it is sound");
        assert_eq!(profile.palette.blue, Sign::Rhombus { degrees: 90.0 });
        assert_eq!(profile.palette.yellow, Sign::Rhombus { degrees: 0.0 });
        assert_eq!(profile.get("textures.palette.red"), Ok(Value::Text("rhombus 135".to_owned())));
    }
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    profile.set("textures.palette.grey", "rhombus 67.5").expect("it is a sign");
    assert_eq!(profile.palette.grey, Sign::Rhombus { degrees: 67.5 });
    let told = super::in_lines(&profile.check().expect_err("between green and yellow there is no room"));
    assert_eq!(told.lines().count(), 2, "{told}");
}

#[test]
fn all_faults_of_a_palette_come_at_once() {
    let signs = "\"dot\" or \"rhombus D\" with D from 0 to below 180 degrees";
    assert_eq!(
        faults(
            "[textures.palette]\nblue = \"rhombus 180\"\ngreen = 45\nyelow = \"dot\"\nred = \"circle\"\ngrey = true"
        ),
        format!(
            "my.toml, line 3: textures.palette.blue must be {signs}, not the text \"rhombus 180\"\n\
             my.toml, line 4: textures.palette.green must be {signs}, not 45\n\
             my.toml, line 5: there is no key textures.palette.yelow, did you mean textures.palette.yellow?\n\
             my.toml, line 6: textures.palette.red must be {signs}, not the text \"circle\"\n\
             my.toml, line 7: textures.palette.grey must be {signs}, not true"
        )
    );
    assert_eq!(faults("textures.palette = 5").lines().count(), 1);
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    assert_eq!(
        profile.set("textures.palette.blu", "dot").expect_err("no such key").to_string(),
        "textures.palette.blu=dot: there is no key textures.palette.blu, did you mean textures.palette.blue?"
    );
    assert_eq!(
        profile.set("textures.palette", "dot").expect_err("a section").to_string(),
        "textures.palette=dot: textures.palette is a section, name one of its keys: textures.palette.blue, \
         textures.palette.green, textures.palette.yellow, textures.palette.red or textures.palette.grey"
    );
}

#[test]
fn signs_that_fingers_cannot_tell_apart_are_refused() {
    let apart =
        "which fingers cannot tell apart, give one of them a direction that is 30 degrees or more from all others";
    assert_eq!(
        faults("[textures.palette]\nblue = \"rhombus 160\"\ngreen = \"dot\""),
        format!(
            "my.toml, line 3: textures.palette.blue is \"rhombus 160\" and textures.palette.red is \"rhombus 135\", {apart}\n\
             my.toml, line 4: textures.palette.green is \"dot\" and textures.palette.grey is \"dot\", {apart}"
        )
    );
    assert_eq!(faults("figure.textures = false\ntextures.palette.green = \"dot\""), "none");
}

/// What dots on a grid cannot tell is refused where it was given; what cells of text cannot tell is theirs to say.
#[test]
fn what_dots_cannot_carry_is_refused() {
    let faults = |text: &str| {
        Profile::from_toml(text, "my.toml").map_or_else(|error| super::in_lines(&error), |_| String::new())
    };
    let school = "[textures.palette]\ngreen = \"rhombus 60\"\nyellow = \"rhombus 95\"\nred = \"rhombus 150\"\n";
    assert_eq!(faults(&format!("inherits = \"braillerap\"\n{school}")), "");
    assert_eq!(faults(&format!("inherits = \"index-basic-d\"\n{school}")), "");
    let close = school.replace("60", "65").replace("150", "130");
    assert_eq!(faults(&format!("inherits = \"braillerap\"\n{}", close.replace("95", "96"))), "");
    assert!(
        faults(&format!("inherits = \"dot-pad\"\n{}", close.replace("65", "68").replace("95", "100")))
            .contains("cannot tell green from yellow"),
    );
    assert!(
        faults("inherits = \"monarch\"\ntextures.fringe = true").contains("textures.fringe turns single rhombuses")
    );
    assert_eq!(faults("inherits = \"monarch\"\ntextures.fringe = true\nfigure.textures = false"), "");
}
