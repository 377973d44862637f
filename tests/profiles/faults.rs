//! Profiles with mistakes: what is said of them.

use tactograph::Error;
use tactograph::internals::profile::{Profile, Value, built_in};

use crate::profiles::in_lines;

/// The faults of a text as the program prints them, one on a line.
fn faults(text: &str) -> String {
    match Profile::from_toml(text, "my.toml") {
        Ok(_) => "none".to_owned(),
        Err(faults) => in_lines(&faults),
    }
}

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(faults(text), expected, "\nfor the profile\n{text}");
}

const HEIR: &str = "inherits = \"swell-a4\"\n";

#[test]
fn unknown_names_get_a_suggestion() {
    for (line, expected) in [
        ("lines.widht_max = 1", "there is no key lines.widht_max, did you mean lines.width_max?"),
        ("lines.max_width = 1", "there is no key lines.max_width, did you mean lines.width_max?"),
        ("lines.width-max = 1", "there is no key lines.width-max, did you mean lines.width_max?"),
        ("lines.width = 1", "there is no key lines.width, did you mean lines.width_min or lines.width_max?"),
        ("lines.line_gap = 1", "there is no key lines.line_gap, did you mean textures.line_gap or dots.line_gap?"),
        ("edges.gap = 1", "there is no key edges.gap, did you mean frame.gap, mark.gap or overview.gap?"),
        ("page.colour = 1", "there is no key page.colour, the keys of page are width, height, orientation and margin"),
        ("colors.blur = 1", "there is no section colors, did you mean colours?"),
        ("overveiw = false", "there is no section overveiw, did you mean overview?"),
        ("descripton = \"x\"", "there is no section descripton, did you mean description?"),
        ("min_side = 13", "there is no section min_side, did you mean figure.min_side?"),
        (
            "\"two\\nlines\" = 13",
            "there is no section \"two\\nlines\", the sections are page, frame, mark, sheets, figure, overview, edges, \
                                lines, colours, textures, textures.palette, dots, braille and print",
        ),
    ] {
        check(&format!("{HEIR}{line}"), &format!("my.toml, line 2: {expected}"));
    }
}

#[test]
fn wrong_values_are_told_with_range_and_unit() {
    for (line, expected) in [
        ("lines.width_max = 11", "lines.width_max must be a number from 0.3 to 10 mm, not 11"),
        ("lines.width_max = -1.0", "lines.width_max must be a number from 0.3 to 10 mm, not -1.0"),
        ("lines.width_max = nan", "lines.width_max must be a number from 0.3 to 10 mm, not nan"),
        ("lines.width_max = inf", "lines.width_max must be a number from 0.3 to 10 mm, not inf"),
        ("lines.width_max = 0xFF", "lines.width_max must be a number from 0.3 to 10 mm, not 0xFF"),
        ("lines.width_max = 1e99", "lines.width_max must be a number from 0.3 to 10 mm, not 1e99"),
        (
            "lines.width_max = \"1.2 mm\"",
            "lines.width_max must be a number from 0.3 to 10 mm, not the text \"1.2 mm\", write it without the unit",
        ),
        (
            "lines.width_max = 1.2mm",
            "lines.width_max must be a number from 0.3 to 10 mm, not 1.2mm, write it without the unit",
        ),
        ("lines.width_max = true", "lines.width_max must be a number from 0.3 to 10 mm, not true"),
        ("lines.width_max = []", "lines.width_max must be a number from 0.3 to 10 mm, not a list in brackets"),
        ("lines.width_max = 2004-04-08", "lines.width_max must be a number from 0.3 to 10 mm, not a date or time"),
        ("lines.width_max.mm = 1", "lines.width_max must be a number from 0.3 to 10 mm, not a section of keys"),
        ("colours.min_value = 15", "colours.min_value must be a number from 0 to 1, not 15"),
        ("frame.on = 1", "frame.on must be true or false, not 1"),
        ("frame = \"off\"", "frame must be true, false or a section with keys, not the text \"off\""),
        ("lines = false", "lines must be a section, written [lines] with its keys on the lines below, not false"),
        (
            "[[lines]]",
            "lines must be a section, written [lines] with its keys on the lines below, not a list in brackets",
        ),
        ("description = 3", "description must be one line of text in quotes, not 3"),
        ("description = \"a\\nb\"", "description must be one line of text in quotes, not the text \"a\\nb\""),
    ] {
        check(&format!("{HEIR}\n{line}"), &format!("my.toml, line 3: {expected}"));
    }
    check("inherits = true", "my.toml, line 1: inherits must be one line of text in quotes, not true");
}

#[test]
fn mistakes_in_the_toml_are_told_and_the_rest_is_read() {
    for (text, expected) in [
        ("[page\nwidth = 3", "my.toml, line 2: \"[page\" cannot be read as TOML: unclosed table, expected \"]\""),
        (
            "[page]\nwidth 3\nheight = 1",
            "my.toml, line 3: \"width 3\" cannot be read as TOML: key with no value, expected \"=\"\n\
          my.toml, line 4: page.height must be a number from 60 to 1200 mm, not 1",
        ),
        (
            "lines.width_max = 1,5\nlines.min_gap = 0",
            "my.toml, line 2: \"lines.width_max = 1,5\" has a decimal comma, write a \
          point as in 1.5\nmy.toml, line 3: lines.min_gap must be a number from 0.5 to 30 mm, not 0",
        ),
        (
            "[lines]\nmin_gap = 4\nmin_gap = 5\n[page]\n[lines]\nwidth_max = 99",
            "my.toml, line 4: this key is given twice, take one \
          of the two away\nmy.toml, line 6: this section is given twice, take one of the two away\n\
          my.toml, line 7: lines.width_max must be a number from 0.3 to 10 mm, not 99",
        ),
        (
            "description = \"\"\"x\n[page]\nmargin = 200",
            "my.toml, line 2: the value does not end on its line, close the quotes or \
          brackets\nmy.toml, line 4: page.margin must be a number from 0 to 100 mm, not 200",
        ),
        (
            "description = \"x\npage.margin = 200",
            "my.toml, line 2: \"description = \\\"x\" cannot be read as TOML: invalid basic \
          string, expected \"\"\"\nmy.toml, line 3: page.margin must be a number from 0 to 100 mm, not 200",
        ),
        (
            "overview = [1,\n[page]\nmargin = 200",
            "my.toml, line 2: the value does not end on its line, close the quotes or \
          brackets\nmy.toml, line 4: page.margin must be a number from 0 to 100 mm, not 200",
        ),
        (
            "][page]\nmargin = 200\n[lines]\nmin_gap = 0",
            "my.toml, line 2: \"][page]\" cannot be read as TOML: missing table open, expected \"[\"\n\
             my.toml, line 5: lines.min_gap must be a number from 0.5 to 30 mm, not 0",
        ),
        (
            "description = {\"x\"\n[page]\nmargin = 200\nwidth = 10",
            "my.toml, line 2: the value does not end on its line, close the quotes or brackets\n\
             my.toml, line 4: page.margin must be a number from 0 to 100 mm, not 200\n\
             my.toml, line 5: page.width must be a number from 60 to 1200 mm, not 10",
        ),
        (
            "\"\"\"[page]\nmargin = 200\n",
            "my.toml, line 2: \"\\\"\\\"\\\"[page]\" cannot be read as TOML: keys cannot be multi-line basic strings, \
             expected basic string, literal string",
        ),
    ] {
        check(&format!("{HEIR}{text}"), expected);
    }
}

#[test]
fn values_that_do_not_go_together_are_told_where_they_were_given() {
    for (line, expected) in [
        (
            "lines.width_min = 2",
            "lines.width_min is 2 but must be at most lines.width_max, which is 1.5, since a weak contour has \
          the thinner line",
        ),
        (
            "edges.low = 10",
            "edges.low is 10 but must be at most edges.high, which is 7, since a contour is followed down to low \
          once it has reached high",
        ),
        (
            "lines.full_strength = 3",
            "edges.low is 3 but must be below lines.full_strength, which is 3, since lines grow from the \
          one to the other",
        ),
        ("frame.dot = 1.6", "frame.dot is 1.6 but must be below frame.pitch, which is 1.6, or its dots run together"),
        (
            "frame.width = 0.5",
            "frame.dot is 0.8 but must be at most frame.width, which is 0.5, or no dot fits into the frame",
        ),
        (
            "textures.along = 2.2",
            "textures.length is 2.2 but must be below textures.along, which is 2.2, or the rhombuses of a \
          row run together",
        ),
        (
            "textures.across = 1",
            "textures.thickness is 1.2 but must be below textures.across, which is 1, or the rows run together",
        ),
        (
            "textures.length = 1",
            "textures.thickness is 1.2 but must be at most textures.length, which is 1, or the rhombuses lie \
          across their row",
        ),
        (
            "textures.dot = 3.2",
            "textures.dot is 3.2 but must be below textures.dot_pitch, which is 3.2, or the dots run together",
        ),
        (
            "textures.along = 2.5",
            "textures.along is 2.5 but must be at least 2.8, which is textures.length and textures.min_glyph together, \
             or the blank between two glyphs is not felt",
        ),
        (
            "textures.dot = 0.5",
            "textures.min_glyph is 0.6 but must be at most textures.dot, which is 0.5, since it is the thickness of the \
             lightest glyph",
        ),
        (
            "textures.min_glyph = 1.3",
            "textures.min_glyph is 1.3 but must be at most textures.thickness, which is 1.2, since it is the \
             thickness of the lightest glyph",
        ),
        (
            "print.swell = 0.4",
            "print.swell is 0.4 mm, which leaves too little to print of textures.min_glyph, which is 0.6 mm, lessen the one \
             or enlarge the other",
        ),
        (
            "page.margin = 100",
            "the sheet leaves 0.0 mm by 37.9 mm for the figure, but figure.min_side asks for 12.7 mm, enlarge \
          page.width or page.height or lessen margin, frame, overview or their gaps",
        ),
        (
            "page.height = 98",
            "the sheet leaves 174.0 mm by 24.3 mm for the figure, but figure.min_side asks for 25 mm, enlarge \
          page.width or page.height or lessen margin, frame, overview or their gaps",
        ),
    ] {
        let text = format!("{HEIR}{line}").replace("98", "98\npage.orientation = \"landscape\"\nfigure.min_side = 25");
        let at = if line.contains("98") { 4 } else { 2 };
        check(&text, &format!("my.toml, line {at}: {expected}"));
    }
    check(
        &format!("{HEIR}mark.width = 10\nmark.length = 9"),
        "my.toml, line 3: mark.width is 10 but must be below mark.length, which is 9, or the bar is a dot, which does not \
         show which corner it cuts",
    );
    check(
        &format!("{HEIR}mark = {{ length = 50, gap = 50 }}\noverview.scale = 1\nfigure.min_side = 100"),
        "my.toml, line 4: the orientation mark leaves 84.8 mm for a square figure, but figure.min_side asks for 100 mm, \
         lessen mark.length or mark.gap, or enlarge the sheet",
    );
    let nothing = format!("{HEIR}overview = false\nfigure = {{ lines = false, textures = false }}");
    check(
        &nothing,
        "my.toml, line 3: figure.lines, figure.textures and overview.on are all false, so nothing would be drawn, \
        set one of them to true",
    );
}

/// What is switched off may hold anything.
#[test]
fn rules_rest_where_a_switch_is_off() {
    check(&format!("{HEIR}frame = {{ on = false, dot = 2 }}"), "none");
    check(&format!("{HEIR}figure.textures = false\ntextures.along = 1"), "none");
    let across = format!("{HEIR}page.orientation = \"landscape\"\nmark = false\n");
    check(&format!("{across}page.height = 90\noverview = false"), "none");
    assert!(Profile::from_toml(&format!("{across}page.height = 90"), "my.toml").is_ok());
    check(&format!("{across}page.height = 70\noverview = false"), "none");
    assert!(Profile::from_toml(&format!("{across}page.height = 70"), "my.toml").is_err());
    // a sheet that may be turned has room upright
    assert!(Profile::from_toml(&format!("{HEIR}page.height = 70"), "my.toml").is_ok());
    check(&format!("{HEIR}textures.min_glyph = 0.2\nfigure.textures = false\nprint.swell = 0.2"), "none");
}

#[test]
fn all_faults_come_at_once() {
    check(
        "inherits = \"swel-a4\"\n[lines]\nwidth_max = 0.1\nwidth_min = 2\nsmoothing 1\ngap = 3\n\n\
         [edges]\nlow = 20\nhigh = 10\n[pages]\n",
        "my.toml, line 1: inherits cannot be followed, there is no built-in profile called \"swel-a4\", did you mean \
         swell-a4? Take one of swell-a4, swell-a3, swell-letter, swell-11x11.5, swell-11x17, plain-print, \
         index-basic-d, index-everest-d, index-basic-d-v3, index-braillebox, romeo-60, juliet-120, braillerap, \
         viewplus-columbia, graphiti, dot-pad, monarch, pins-120x60, braille-cells\n\
         my.toml, line 3: lines.width_max must be a number from 0.3 to 10 mm, not 0.1\n\
         my.toml, line 5: \"smoothing 1\" cannot be read as TOML: key with no value, expected \"=\"\n\
         my.toml, line 6: there is no key lines.gap, did you mean lines.min_gap or lines.join_gap?\n\
         my.toml, line 11: there is no section pages, did you mean page?\n\
         my.toml, line 10: edges.low is 20 but must be at most edges.high, which is 10, since a contour is followed \
         down to low once it has reached high",
    );
}

#[test]
fn without_inherits_every_key_must_be_given() {
    let most = "my.toml: without inherits every key must be given, page.width, page.height, page.orientation, \
                page.margin, frame.on, frame.width and 68 more are missing, write inherits = \"swell-a4\" at the top to take what \
                is missing from there";
    check("", most);
    check(
        &built_in()[0].text.replace("tolerance = 0.05", ""),
        "my.toml: without inherits every key must be given, lines.tolerance is missing, write inherits = \"swell-a4\" \
         at the top to take what is missing from there",
    );
}

/// A value that goes on over lines and ends is blamed for nothing, whatever else is wrong.
#[test]
fn mistakes_hide_no_others() {
    for (text, expected) in [
        (
            "mark = {\n  length = 12,\n  gap = 4 }\nlines.detail = 2\nlines.min_gap 3\nlines.min_length = 999",
            "my.toml, line 5: lines.detail must be a number from 0 to 1, not 2\n\
             my.toml, line 6: \"lines.min_gap 3\" cannot be read as TOML: key with no value, expected \"=\"\n\
             my.toml, line 7: lines.min_length must be a number from 0 to 200 mm, not 999",
        ),
        (
            "description = \"\"\"x\n[page]\nmargin = 200\n[lines]\nmin_gap = '''\nmin_length 3\ndetail = 7",
            "my.toml, line 2: the value does not end on its line, close the quotes or brackets\n\
             my.toml, line 4: page.margin must be a number from 0 to 100 mm, not 200\n\
             my.toml, line 6: the value does not end on its line, close the quotes or brackets\n\
             my.toml, line 7: \"min_length 3\" cannot be read as TOML: key with no value, expected \"=\"\n\
             my.toml, line 8: lines.detail must be a number from 0 to 1, not 7",
        ),
    ] {
        check(&format!("{HEIR}{text}"), expected);
    }
}

/// A form can show a fault beside the fields that it is about.
#[test]
fn faults_name_their_keys() {
    let keys = |result: Result<Profile, Error>| match result {
        Err(Error::Profile(faults)) => faults.into_iter().map(|fault| fault.keys).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    let of_text = |text: &str| keys(Profile::from_toml(&format!("{HEIR}{text}"), "my.toml"));
    let wrong = "lines.detail = 2\nedges = { low = 9, high = 4 }\nlines.gap = 3\nlines.min_gap 3";
    let none: [&str; 0] = [];
    assert_eq!(of_text(wrong), [&["lines.detail"][..], &none, &none, &["edges.low", "edges.high"]]);
    assert_eq!(of_text("print.swell = 1"), [["textures.min_glyph", "print.swell"]]);
    let missing = built_in()[0].text.replace("tolerance = 0.05", "");
    assert_eq!(keys(Profile::from_toml(&missing, "my.toml")), [["lines.tolerance"]]);
    let mut profile = Profile::named("swell-a4").expect("it is built in");
    assert_eq!(keys(profile.set("lines.detail", "7").map(|()| profile.clone())), [["lines.detail"]]);
    profile.set("dots.line_gap", "3").expect("a key");
    assert_eq!(profile.unused().into_iter().map(|fault| fault.keys).collect::<Vec<_>>(), [["dots.line_gap"]]);
    let mut pressed = Profile::named("index-basic-d").expect("it is built in");
    pressed.set("dots.pitch", "7").expect("a number in the range");
    assert_eq!(keys(pressed.check().map(|()| pressed.clone())), [["dots.pitch", "dots.device"]]);
}

/// What a form offers for a key is what the key takes, and all of it.
#[test]
fn choices_of_keys_are_what_they_take() {
    for key in Profile::keys() {
        let choices = key.choices();
        assert!(choices.iter().all(|choice| key.takes(choice)), "{}", key.path);
        // an angle of a texture is any, and so is a number within its limits
        let has_other_bounds = key.limits.is_some() || key.section() == "textures.palette";
        assert!(!choices.is_empty() || has_other_bounds, "{}", key.path);
        for profile in built_in().iter().map(|profile| Profile::named(profile.name).expect("it is built in")) {
            assert!(choices.is_empty() || choices.contains(&key.value(&profile)), "{}", key.path);
        }
        if let Some(limits) = key.limits {
            let between = Value::Number(0.5 + (0.5 * (limits.low + limits.high)).floor());
            assert_eq!(limits.whole, !key.takes(&between), "{}", key.path);
        }
    }
    let texts = |path: &str| {
        let key = Profile::keys().iter().find(|key| key.path == path).expect("a key");
        key.choices().iter().map(Value::to_string).collect::<Vec<_>>()
    };
    assert_eq!(texts("page.orientation"), ["\"auto\"", "\"portrait\"", "\"landscape\""]);
    assert_eq!(texts("braille.grade"), ["1", "2"]);
    assert_eq!(texts("overview.on"), ["true", "false"]);
}

/// A file that is no profile at all is told so without a flood.
#[test]
fn faults_and_texts_have_a_limit() {
    let told = faults(&"[[[ no = profile\n".repeat(1000));
    assert_eq!(told.lines().count(), 51, "{told}");
    assert_eq!(told.lines().last(), Some("my.toml: there are 950 more faults"));
    let long = faults(&"# far too long\n".repeat(10_000));
    assert_eq!(long, "my.toml, line 1: a profile has at most 65536 bytes, this text has 150000, is it the right file?");
}
