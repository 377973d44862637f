//! Profiles and their values.

use crate::cli::common::*;

#[test]
fn profiles_are_listed_and_shown() {
    let place = Place::new();
    let run = place.run(&["profiles"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let names = run.out.lines().map(|line| line.split_whitespace().next().unwrap_or(""));
    let printed = ["swell-a4", "swell-a3", "swell-letter", "swell-11x11.5", "swell-11x17", "plain-print"];
    let embossed =
        ["index-basic-d", "index-everest-d", "index-basic-d-v3", "index-braillebox", "romeo-60", "juliet-120"];
    let others = ["braillerap", "viewplus-columbia", "graphiti", "dot-pad", "monarch", "pins-120x60", "braille-cells"];
    let expected = [&printed[..], &embossed, &others].concat();
    assert_eq!(names.collect::<Vec<_>>(), expected);
    let descriptions = run.out.lines().map(|line| line[13..].trim_start().len());
    assert!(descriptions.min() > Some(10), "a profile without description:\n{}", run.out);
    assert_eq!(run.out.matches("(default)").count(), 1);
    for profile in tactograph::internals::profile::built_in() {
        let run = place.run(&["profiles", "show", profile.name]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        // as it was written, with the range of each key behind it
        assert_eq!(run.out.lines().count(), profile.text.lines().count());
        for (shown, written) in run.out.lines().zip(profile.text.lines()) {
            assert!(shown.starts_with(written), "{written} is shown as {shown}");
        }
    }
}

/// The page about all keys is what the program says of them. `UPDATE=1` writes it anew.
#[test]
fn every_key_is_told_on_one_page() {
    let run = Place::new().run(&["profiles", "keys"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/profiles.md");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path, &run.out).expect("the page can be written");
    }
    let found = std::fs::read_to_string(path).unwrap_or_default();
    assert!(found == run.out, "docs/profiles.md is not up to date: cargo run -- profiles keys > docs/profiles.md");
    assert!(run.out.contains(&tactograph::Profile::manual()));
}

#[test]
fn an_unknown_profile_is_wrong_usage() {
    let place = Place::with_picture("a.png");
    let expected = tactograph::Profile::named("swel-a4").expect_err("no such profile").to_string();
    assert!(expected.contains("swell-a4"), "no suggestion: {expected}");
    let with_hint = format!("profile: {expected}; for a file of your own give a name that ends in .toml");
    place.refuses(&["profiles", "show", "swel-a4"], 2, &[&with_hint]);
    place.refuses(&["convert", "a.png", "--profile", "swel-a4"], 2, &[&with_hint]);
    assert_eq!(place.names(), ["a.png"]);
}

#[test]
fn a_profile_can_be_named_or_a_file() {
    let place = Place::with_picture("a.png");
    place.put("my.toml", b"inherits = \"swell-a4\"\n[lines]\nwidth_max = 1.3\n");
    place.put("d/mine", b"inherits = \"swell-a4\"\n");
    for profile in ["my.toml", "./my.toml", "d/mine", "swell-a3", "swell-11x11.5", "plain-print"] {
        let run = place.run(&["convert", "a.png", "-o", "p.svg", "--profile", profile]);
        assert_eq!((run.code, run.err.as_str()), (0, "wrote p.svg\n"), "{profile}");
        place.has_page("p.svg");
    }
    let none = "none.toml: there is no such file; check the name";
    place.refuses(&["convert", "a.png", "--profile", "none.toml"], 2, &[none]);
    place.put("picture.toml", &vec![0; (1 << 20) + 1]);
    let large = "picture.toml: this is too large for a profile; give a TOML file";
    place.refuses(&["convert", "a.png", "--profile", "picture.toml"], 2, &[large]);
    place.put("latin.toml", b"# caf\xe9\n");
    let latin = "latin.toml: this is not text in UTF-8; give a profile, which is a TOML file";
    place.refuses(&["convert", "a.png", "--profile", "latin.toml"], 2, &[latin]);
}

#[test]
fn a_profile_file_inherits_another_from_where_it_lies() {
    let place = Place::with_picture("a.png");
    place.put("school/our.toml", b"inherits = \"papers/thin.toml\"\noverview = false\n");
    place.put("school/papers/thin.toml", b"inherits = \"swell-a4\"\nlines.width_max = 1.2\n");
    place.put("my.toml", b"inherits = \"school/our.toml\"\nlines.detail = 0.6\n");
    let page = |words: &[&str]| place.run(&[&["convert", "a.png", "-q", "-o", "-", "--profile"], words].concat());
    let (own, set) = (page(&["my.toml"]), ["overview=false", "lines.width_max=1.2", "lines.detail=0.6"]);
    let sets = set.iter().flat_map(|set| ["--set", set]).collect::<Vec<_>>();
    let same = page(&[&["swell-a4"], &sets[..]].concat());
    assert_eq!((own.code, own.err.as_str()), (0, ""));
    assert_eq!(
        without_seal(&own.out).replace("profile = my\n", ""),
        without_seal(&same.out).replace("profile = swell-a4\n", "")
    );
    place.put("school/papers/thin.toml", b"inherits = \"../our.toml\"\n");
    let circle = "school/papers/thin.toml, line 1: inherits goes round in a circle, my.toml to school/our.toml to \
                  school/papers/thin.toml to ../our.toml, take one of them away";
    place.refuses(&["convert", "a.png", "--profile", "my.toml"], 2, &[circle]);
    place.put("school/papers/thin.toml", b"inherits = \"none.toml\"\n");
    let none = "school/papers/thin.toml, line 1: inherits cannot be followed, school/papers/none.toml: there is no \
                such file; check the name";
    place.refuses(&["convert", "a.png", "--profile", "my.toml"], 2, &[none]);
}

/// The page without its last line, which tells whether anybody has changed it.
fn without_seal(page: &str) -> String {
    page.lines().filter(|line| !line.starts_with("<!--")).fold(String::new(), |text, line| text + line + "\n")
}

/// What does not count on a page is told once, where it was given; what a profile only inherits is nobody's choice.
#[test]
fn keys_that_do_not_count_are_told() {
    let place = Place::with_picture("a.png");
    place.put("my.toml", b"inherits = \"index-basic-d\"\nlines.width_max = 1.3\nlines.detail = 0.6\n");
    let dots = ["convert", "a.png", "-o", "a.idx", "--profile", "my.toml", "--set", "print.swell=0.1"];
    let run = place.run(&dots);
    assert_eq!(run.code, 0, "{}", run.err);
    let notes: Vec<_> = run.err.lines().filter(|line| line.contains("does not count")).collect();
    let line = "tactograph: my.toml, line 2: note: lines.width_max does not count on a page of dots: a line is one row \
                of the device's dots, or two; dots.heavy_from says from which strength it is two";
    let set = "tactograph: --set print.swell=0.1: note: print.swell does not count on a page of dots: dots are pressed \
               and do not swell; the device has their size";
    assert_eq!(notes, [line, set]);
    let run = place.run(&["convert", "a.png", "-o", "a.svg", "--set", "dots.pitch=2"]);
    assert!(run.err.contains("note: dots.pitch does not count on a printed page: "), "{}", run.err);
    let run = place.run(&["convert", "a.png", "-q", "-o", "b.svg", "--set", "dots.pitch=2"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
}

#[test]
fn all_faults_are_told_at_once_with_their_places() {
    let place = Place::with_picture("a.png");
    place.put("bad.toml", b"inherits = \"swell-a4\"\n\n[lines]\nwidth_maxx = 1.0\nwidth_min = \"thin\"\n");
    let sets = ["--set", "nonsense", "--set", "=1", "--set", "lines.width_max=wide", "--set", "frame.colour=red"];
    let run = place.run(&[&["convert", "a.png", "-o", "a.jpg", "--profile", "bad.toml"], &sets[..]].concat());
    let places = run.err.lines().map(|line| line.split(": ").nth(1).unwrap_or("")).collect::<Vec<_>>();
    let expected = ["a.jpg", "bad.toml, line 4", "bad.toml, line 5", "--set nonsense", "--set =1"];
    assert_eq!(places[..5], expected, "{}", run.err);
    assert_eq!(places.len(), 7, "{}", run.err);
    assert!(
        places[5].starts_with("--set lines.width_max") && places[6].starts_with("--set frame.colour"),
        "{}",
        run.err
    );
    assert!(run.err.contains("did you mean lines.width_max?"), "no suggestion: {}", run.err);
    assert!(run.err.contains("--set nonsense: write it as key=value, such as lines.width_max=1.2\n"), "{}", run.err);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert_eq!(place.names(), ["a.png", "bad.toml"]);
}

#[test]
fn set_changes_the_page_and_the_last_one_counts() {
    let place = Place::with_picture("a.png");
    let page = |sets: &[&str]| {
        let run = place.run(&[&["convert", "a.png", "-q", "-o", "-"], sets].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{sets:?}");
        run.out
    };
    let (plain, wide) = (page(&[]), page(&["--set", "lines.width_max=1.7"]));
    assert_ne!(plain, wide);
    assert_eq!(page(&["--set", "lines.width_max=1.2", "--set", "lines.width_max=1.7"]), wide);
    assert!(plain.contains("id=\"overview\"") && !page(&["--set", "overview=false"]).contains("id=\"overview\""));
}

#[test]
fn detail_is_short_for_a_key_and_counts_after_set() {
    let place = Place::with_picture("a.png");
    let page = |words: &[&str]| {
        let run = place.run(&[&["convert", "a.png", "-q", "-o", "-"], words].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{words:?}");
        run.out
    };
    let least = page(&["--detail", "0"]);
    assert_eq!(least, page(&["--set", "lines.detail=0"]));
    assert_eq!(least, page(&["--detail", "0", "--set", "lines.detail=1"]));
    for wrong in ["2", "-0.5", "much"] {
        let what = format!("--detail {wrong}: lines.detail must be a number from 0 to 1, not {wrong}");
        place.refuses(&["convert", "a.png", "--detail", wrong], 2, &[&what]);
    }
}

#[test]
fn quality_is_short_for_keys_and_counts_before_set() {
    let place = Place::new();
    // 900 pixels are more than the page of the default profile asks for, so that fine sees more and draft less.
    let is_dark = |x: u32, y: u32| (x.abs_diff(450)).pow(2) + (y.abs_diff(350)).pow(2) < 200 * 200;
    let grey = |x, y| [if is_dark(x, y) { 40 } else { 220 }; 3];
    let pixels = (0..700).flat_map(|y| (0..900).flat_map(move |x| grey(x, y)));
    place.put("a.png", &png(900, 700, &pixels.collect::<Vec<u8>>()));
    let page = |command: &str, words: &[&str]| {
        let run = place.run(&[&[command, "a.png", "-q", "-o", "-"], words].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{words:?}");
        run.out
    };
    let draft = ["--set", "figure.resolution=2", "--set", "edges.scale=0.6"];
    let fine = ["--set", "figure.resolution=8"];
    for command in ["convert", "trace"] {
        let plain = page(command, &[]);
        assert_eq!(page(command, &["--quality", "standard"]), plain);
        assert_eq!(page(command, &["--quality", "draft"]), page(command, &draft));
        assert_eq!(page(command, &["--quality", "fine"]), page(command, &fine));
        assert_ne!(page(command, &draft), plain);
        assert_ne!(page(command, &fine), plain);
        // what is set goes before what is short for it, wherever it stands
        let set = ["--set", "figure.resolution=4"];
        assert_eq!(page(command, &[&set[..], &["--quality", "fine"]].concat()), plain);
    }
    let run = place.run(&["convert", "a.png", "--quality", "best"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("'best'") && run.err.contains("draft, standard, fine"), "{}", run.err);
    assert_eq!(place.names(), ["a.png"]);
}

/// A draft is coarser and a fine page finer than the page of every profile, whatever it is pressed or printed with.
#[test]
fn every_built_in_profile_lies_between_draft_and_fine() {
    for file in tactograph::internals::profile::built_in() {
        let profile = tactograph::internals::profile::Profile::named(file.name).expect("a built-in profile");
        let resolution = profile.figure.resolution;
        assert!(2.0 < resolution && resolution < 8.0, "{} {resolution}", file.name);
    }
}
