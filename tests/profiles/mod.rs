//! Profiles as their writers see them: what the built-in ones hold, and what is said of one with mistakes.

mod any;
mod faults;
mod palette;
mod unused;

use tactograph::Error;
use tactograph::internals::page::layout::Orientation;
use tactograph::internals::profile::{Profile, Value, built_in};

/// The faults of a profile, one on a line.
fn in_lines(error: &Error) -> String {
    let Error::Profile(faults) = error else { panic!("no faults of a profile: {error}") };
    faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

fn named(name: &str) -> Profile {
    Profile::named(name).unwrap_or_else(|faults| panic!("{}", in_lines(&faults)))
}

#[test]
fn built_in_profiles_are_sound_and_described() {
    assert_eq!(built_in()[0].name, "swell-a4");
    for file in built_in() {
        let profile = named(file.name);
        assert_eq!(profile.check(), Ok(()));
        assert_eq!(profile.name, file.name);
        assert!(!profile.description.is_empty(), "{} has no description", file.name);
        assert_eq!(profile.description, file.description());
    }
}

#[test]
fn every_key_is_documented_and_in_range() {
    for file in built_in() {
        let profile = named(file.name);
        for key in Profile::keys() {
            assert!(key.doc.ends_with('.') && !key.doc.contains('\n') && key.doc.len() > 15, "{}", key.path);
            assert!(key.takes(&key.value(&profile)), "{} {} is not {}", file.name, key.path, key.range());
            assert_eq!(key.limits.is_some(), matches!(key.value(&profile), Value::Number(_)), "{}", key.path);
            if let Some(limits) = key.limits {
                assert!(limits.low < limits.high, "{}", key.path);
                let above = [limits.high * 1.001, f32::NAN].map(Value::Number);
                assert!(above.iter().all(|value| !key.takes(value)), "{}", key.path);
            }
        }
    }
}

/// Few printers reach the edge of a sheet, and fingers need to hold it.
#[test]
fn built_in_profiles_have_margins() {
    for file in built_in() {
        let profile = named(file.name);
        // the grid of a device ends where it cannot press
        assert!(profile.page.margin >= 10.0 || profile.dots.device.is_some(), "{}", file.name);
    }
}

#[test]
fn the_manual_tells_of_every_key_and_of_no_program() {
    let page = Profile::manual();
    for of_program in ["`tactograph ", "`--", "command line"] {
        let told = page.lines().filter(|line| !line.starts_with("|---")).find(|line| line.contains(of_program));
        assert_eq!(told, None, "{of_program}");
    }
    for key in Profile::keys() {
        let row = format!("| `{}` | ", key.name());
        assert!(page.lines().any(|line| line.starts_with(&row) && line.contains(key.doc)), "{}", key.path);
        let reason = format!("* `{}` - ", key.name());
        let is_switch = matches!(key.value(&named("swell-a4")), Value::Switch(_));
        assert!(is_switch || page.lines().any(|line| line.starts_with(&reason)), "no reason for {}", key.path);
    }
}

#[test]
fn keys_have_paths_of_their_own_and_reach_their_fields() {
    let profile = named("swell-a4");
    let mut paths: Vec<_> = Profile::keys().iter().map(|key| key.path).collect();
    assert_eq!(profile.get("lines.width_max"), Ok(Value::Number(profile.lines.width_max)));
    assert_eq!(profile.get("frame.on"), Ok(Value::Switch(profile.frame.on)));
    let unknown = profile.get("lines.widthmax").expect_err("no key").to_string();
    assert_eq!(unknown, "lines.widthmax: there is no key lines.widthmax, did you mean lines.width_max?");
    paths.sort_unstable();
    paths.dedup();
    assert_eq!(paths.len(), Profile::keys().len());
}

/// Every `key = value` of the built-in files has a comment beside it or directly above, with the unit and the reason.
#[test]
fn every_number_says_why() {
    for file in built_in() {
        let (mut section, mut above) = (String::new(), String::new());
        for line in file.text.lines() {
            if line.starts_with('#') {
                above.push_str(line);
                continue;
            }
            if let Some(name) = line.strip_prefix('[') {
                section = name.trim_end_matches(']').to_owned();
            } else if let Some((name, rest)) = line.split_once('=').filter(|_| !section.is_empty()) {
                let path = format!("{section}.{}", name.trim());
                let key = Profile::keys().iter().find(|key| key.path == path).expect("a known key");
                let why = rest.split_once('#').map_or(above.as_str(), |(_, beside)| beside).trim_matches(['#', ' ']);
                assert!(why.len() > 12, "{} {path}: {why:?}", file.name);
                let unit = key.limits.map_or("", |limits| limits.unit);
                assert!(why.starts_with(unit), "{} {path}: {why:?} does not begin with its unit {unit}", file.name);
            }
            above.clear();
        }
    }
}

#[test]
fn inherits_key_by_key() {
    let (a4, a3, letter) = (named("swell-a4"), named("swell-a3"), named("swell-letter"));
    let differing = |other: &Profile| {
        let pairs = a4.parameters().into_iter().zip(other.parameters());
        pairs.filter(|(a, b)| a != b).map(|(_, (path, value))| format!("{path}={value}")).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(differing(&a3), "page.width=297 page.height=420");
    assert_eq!(differing(&letter), "page.width=215.9 page.height=279.4");
    assert_eq!(differing(&named("swell-11x11.5")), "page.width=279.4 page.height=292.1");
    assert_eq!(differing(&named("swell-11x17")), "page.width=279.4 page.height=431.8");
    assert_eq!(differing(&named("plain-print")), "print.max_black=1");

    let mine = "inherits = \"swell-letter\"\ndescription = \"Mine\"\noverview = false\n\
                lines.width_max = 2\n[page]\nmargin = 1e1";
    let mine = Profile::from_toml(mine, "some/where/my.toml").expect("sound");
    assert_eq!(differing(&mine), "page.width=215.9 page.height=279.4 overview.on=false lines.width_max=2");
    assert_eq!((mine.name.as_str(), mine.description.as_str()), ("my", "Mine"));
}

/// A file may be called like the profile that it inherits: that is no circle.
#[test]
fn own_file_may_have_a_built_in_name() {
    let profile = Profile::from_toml("inherits = \"swell-a4\"", "swell-a4.toml").expect("sound");
    assert_eq!(profile.parameters(), named("swell-a4").parameters());
}

/// What a profile says of itself is a profile again, to the last bit.
#[test]
fn parameters_read_back_the_same() {
    let mut profile = named("swell-a4");
    profile.set("lines.width_max", "1.2345678").expect("in range");
    profile.set("colours.blur", "-0").expect("in range");
    profile.set("page.orientation", "landscape").expect("a word of it");
    let text: Vec<_> = profile.parameters().iter().map(|(path, value)| format!("{path} = {value}")).collect();
    assert!(text.contains(&"lines.width_max = 1.2345678".to_owned()) && text.contains(&"colours.blur = 0".to_owned()));
    let again = Profile::from_toml(&text.join("\n"), "again.toml").expect("sound");
    assert_eq!(again.parameters(), profile.parameters());
    assert_eq!(again.lines, profile.lines);
}

#[test]
fn unknown_profile_is_told_with_the_known_ones() {
    let told = |name| Profile::named(name).expect_err("unknown").to_string();
    let known = "swell-a4, swell-a3, swell-letter, swell-11x11.5, swell-11x17, plain-print, index-basic-d, \
         index-everest-d, index-basic-d-v3, index-braillebox, romeo-60, juliet-120, braillerap, viewplus-columbia, \
         graphiti, dot-pad, monarch, pins-120x60, braille-cells";
    assert_eq!(
        told("swell_letter"),
        format!("there is no built-in profile called \"swell_letter\", did you mean swell-letter? Take one of {known}")
    );
    for (other_name, meant) in [
        ("index-basic-d-v4", "index-basic-d"),
        ("index-basic-d-v5", "index-basic-d"),
        ("Index-Basic-D-V4", "index-basic-d"),
        ("index-everest-d-v4", "index-everest-d"),
    ] {
        let refused = Profile::named(other_name).expect_err("unknown");
        let Error::NoSuchName { nearest, .. } = &refused else { panic!("{refused:?}") };
        assert_eq!(nearest, &[meant], "{refused}");
    }
    assert_eq!(told("printer\n"), format!("there is no built-in profile called \"printer\\n\"; take one of {known}"));
}

#[test]
fn set_changes_one_value() {
    let mut profile = named("swell-a4");
    for (key, value) in [
        ("lines.width_max", "1.2"),
        (" page.width ", " 3e2 "),
        ("overview", "false"),
        ("frame.on", "false"),
        ("page.orientation", "landscape"),
    ] {
        profile.set(key, value).expect("a good value");
    }
    assert_eq!(profile.get("lines.width_max"), Ok(Value::Number(1.2)));
    assert_eq!(profile.get("page.width"), Ok(Value::Number(300.0)));
    assert!(!profile.overview.on && !profile.frame.on);
    assert_eq!(profile.get("page.orientation"), Ok(Value::Text("landscape".to_owned())));
    profile.set("page.orientation", "\"portrait\"").expect("as TOML has it");
    assert_eq!(profile.page.orientation, Orientation::Portrait);
    assert_eq!(profile.check(), Ok(()));
}

#[test]
fn what_a_key_holds_can_be_given_to_it() {
    for built_in in built_in() {
        let profile = named(built_in.name);
        let mut other = named("swell-a4");
        for key in Profile::keys() {
            let held = profile.get(key.path).expect("a key");
            other.set(key.path, &held).expect("what a profile holds");
            assert_eq!(other.get(key.path), Ok(held.clone()), "{}", key.path);
            // as a text, without quotes, from another place, and by the section that stands for its switch
            let text = held.to_string().trim_matches('"').to_owned();
            other.set_from(key.path, &text, "a form").expect("the same as a text");
            assert_eq!(other.get(&format!(" {} ", key.path)), Ok(held.clone()), "{}", key.path);
            if key.name() == "on" {
                assert_eq!(profile.get(key.section()), Ok(held));
            }
            for choice in key.choices() {
                other.set(key.path, &choice).expect("a choice");
                assert_eq!(other.get(key.path), Ok(choice), "{}", key.path);
            }
            other.set(key.path, profile.get(key.path).expect("a key")).expect("as before");
        }
        assert_eq!(other.parameters(), profile.parameters(), "{}", built_in.name);
    }
    let mut profile = named("swell-a4");
    profile.set("lines.shapes", 3).expect("a whole number");
    profile.set("frame", false).expect("a switch");
    assert_eq!([profile.get("lines.shapes"), profile.get("frame")], [Ok(Value::Number(3.0)), Ok(Value::Switch(false))]);
    // what is refused by one is refused by the other, for the same reason
    for key in ["lines.widthmax", "line.width_max", "gap", "page", ""] {
        let reason = |told: Error| told.to_string().split_once(": ").map(|(_, reason)| reason.to_owned());
        let refused = [profile.get(key).map(drop), profile.set(key, 1.0)].map(|refused| refused.map_err(reason));
        assert!(refused[0].is_err() && refused[0] == refused[1], "{refused:?}");
    }
}

#[test]
fn set_refuses_what_it_cannot_take() {
    let mut profile = named("swell-a4");
    let before = profile.parameters();
    for (key, value, expected) in [
        (
            "lines.width_max",
            "1,2",
            "lines.width_max=\"1,2\": lines.width_max must be a number from 0.3 to 10 mm, not \"1,2\", \
             write a point for the decimal comma",
        ),
        ("lines.width_max", "inf", "lines.width_max=inf: lines.width_max must be a number from 0.3 to 10 mm, not inf"),
        ("lines.width_max", "", "lines.width_max=\"\": lines.width_max must be a number from 0.3 to 10 mm, not \"\""),
        (
            "page.orientation",
            "sideways",
            "page.orientation=sideways: page.orientation must be \"auto\", \"portrait\" or \"landscape\", not sideways",
        ),
        ("overview", "no", "overview=no: overview.on must be true or false, not no"),
        ("line.width_max", "1", "line.width_max=1: there is no section line, did you mean lines?"),
        ("lines.widthmax", "1", "lines.widthmax=1: there is no key lines.widthmax, did you mean lines.width_max?"),
        ("gap", "1", "gap=1: there is no section gap, did you mean frame.gap, mark.gap or overview.gap?"),
        (
            "page",
            "1",
            "page=1: page is a section, name one of its keys: page.width, page.height, page.orientation or page.margin",
        ),
        (
            "page.",
            "1",
            "page.=1: there is no key page.\"\", the keys of page are width, height, orientation and margin",
        ),
    ] {
        assert_eq!(profile.set(key, value).expect_err(key).to_string(), expected);
    }
    assert_eq!(profile.parameters(), before);
}

/// A value given last is the one to blame, and one written past the door is caught.
#[test]
fn check_after_set_names_the_option() {
    let mut profile = named("swell-a4");
    profile.set("lines.width_max", "0.5").expect("in range");
    assert_eq!(
        in_lines(&profile.check().expect_err("a fault")),
        "lines.width_max=0.5: lines.width_min is 0.75 but must be at most lines.width_max, which is 0.5, since a \
         weak contour has the thinner line"
    );
    profile.lines.width_max = f32::NAN;
    assert_eq!(
        in_lines(&profile.check().expect_err("a fault")),
        "lines.width_max=0.5: lines.width_max must be a number from 0.3 to 10 mm, not NaN"
    );
}
