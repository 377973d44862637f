//! Tests of `resolved`.

use super::*;

#[test]
fn a_profile_written_out_reads_back_as_the_same() {
    let own = "inherits = \"swell-a3\"\ndescription = \"A \\\"wide\\\" one, C:\\\\x\"\n[lines]\nwidth_max = 1.2\n\
               [textures.palette]\nblue = \"rhombus 10\"";
    let mut profile = Profile::from_toml(own, "my.toml").expect("it is right");
    profile.description += "\nin";
    let text = profile.to_toml_in_full();
    let line = |start: &str| text.lines().find(|line| line.starts_with(start)).expect(start).to_owned();
    assert_eq!(line("width_max"), "width_max = 1.2 # a number from 0.3 to 10 mm; from my.toml, line 4");
    assert!(line("width = 297").contains("; from swell-a3.toml, line "), "{text}");
    assert!(line("width_min").contains("; from swell-a4.toml, line "), "{text}");
    let back = Profile::from_toml(&text, "back.toml").expect("it can be read");
    assert_eq!((back.parameters(), back.description), (profile.parameters(), profile.description.replace('\n', " ")));
}

/// Reads a text back under the name of the profile that wrote it.
fn read_back(profile: &Profile, text: &str) -> Profile {
    let back = Profile::from_toml(text, &format!("{}.toml", profile.name)).expect("it can be read");
    assert_eq!((&back.name, &back.description), (&profile.name, &profile.description), "{text}");
    assert_eq!(back.parameters(), profile.parameters(), "{text}");
    back
}

#[test]
fn a_changed_profile_is_written_by_its_differences() {
    let own = "inherits = \"paper.toml\"\ndescription = \"Thick \\\"lines\\\"\"\n[lines]\nwidth_max = 2.5";
    let paper = "inherits = \"swell-a3\"\n[page]\nmargin = 15";
    let mut profile = Profile::from_toml_with(own, "our school.toml", &|_| Ok(paper.into())).expect("right");
    profile.set("overview", false).expect("a switch");
    profile.set("textures.palette.blue", "rhombus 10").expect("a sign");
    let text = profile.to_toml();
    let expected = "inherits = \"swell-a3\"\ndescription = \"Thick \\\"lines\\\"\"\n\n[page]\nmargin = 15\n\n\
                    [overview]\non = false\n\n[lines]\nwidth_max = 2.5\n\n[textures.palette]\n\
                    blue = \"rhombus 10\"\n";
    assert_eq!(text, expected);
    assert_eq!(read_back(&profile, &text).to_toml(), text);
    // what is as before is no difference
    profile.set("overview", true).expect("a switch");
    assert!(!profile.to_toml().contains("overview"));
}

#[test]
fn every_profile_is_written_and_read_back() {
    for built_in in Profile::built_in() {
        let profile = Profile::named(built_in.name).expect("it is built in");
        let text = profile.to_toml();
        assert!(text.starts_with(&format!("inherits = \"{}\"\n", built_in.name)) && !text.contains("\n["), "{text}");
        let full = profile.to_toml_in_full();
        // of one that inherits nothing the differences to the first of all are told
        let back = read_back(&profile, &full);
        read_back(&read_back(&profile, &text), &back.to_toml());
    }
}
