//! Faults are found, each by its rule and in its place: on pages that somebody changed, and on drawings from elsewhere.

use crate::common::page;
use tactograph::{Checked, PageOptions, Reason, check};

/// The page of a sample as its maker left it, with one thing changed.
fn changed(sample: &str, change: impl Fn(String) -> String) -> Checked {
    let svg = page::of_sample(sample, "swell-a4").page.to_svg();
    let with = change(svg.clone());
    assert_ne!(svg, with, "nothing was changed");
    check(with, &PageOptions::new()).expect("it can be read")
}

fn has(checked: &Checked, rule: &str, words: &str) -> bool {
    checked.findings.iter().any(|finding| finding.rule.id == rule && finding.to_string().contains(words))
}

/// Adds elements to the layer of lines.
fn with_lines(svg: String, added: &str) -> String {
    let (before, after) = svg.split_once("id=\"lines\"").expect("there are lines");
    let (open, rest) = after.split_once('>').expect("the layer begins");
    format!("{before}id=\"lines\"{open}>{added}{rest}")
}

#[test]
fn a_page_as_it_was_written_passes() {
    for (sample, profile) in [
        ("coffee.png", "swell-a4"),
        ("chart.svg", "swell-letter"),
        ("landscape.svg", "swell-a3"),
        ("coffee.png", "index-basic-d"),
        ("map.svg", "monarch"),
    ] {
        let svg = page::of_sample(sample, profile).page.to_svg();
        let checked = check(svg, &PageOptions::new()).expect("it can be read");
        assert_eq!(checked.errors(), 0, "{sample} {profile}: {checked}");
    }
}

#[test]
fn lines_drawn_by_hand_are_held_against_the_rules() {
    let near = "<path d=\"M60,250 L120,250\" stroke-width=\"1\"/><path d=\"M60,252 L120,252\" stroke-width=\"1\"/>";
    let checked = changed("bars.svg", |svg| with_lines(svg, near));
    assert!(has(&checked, "line-gap", "1.0 mm apart along 60 mm; 3.2 mm is the least"), "{checked}");
    assert!(has(&checked, "line-gap", "line 1 without a name and line 2 without a name are"), "{checked}");
    let short = "<path d=\"M60,250 L63,250\" stroke-width=\"1\"/>";
    assert!(has(&changed("bars.svg", |svg| with_lines(svg, short)), "line-length", "4.0 mm long; 8 mm"));
    let out = "<path d=\"M60,292 L120,292\" stroke-width=\"1\"/>";
    assert!(has(&changed("bars.svg", |svg| with_lines(svg, out)), "margin", "5.5 mm beyond the margin of 10 mm"));
}

#[test]
fn what_reaches_beyond_the_sheet_is_found() {
    let drawn = |d: &str| changed("bars.svg", |svg| with_lines(svg, &format!("<path id=\"far\" d=\"{d}\"/>")));
    let checked = drawn("M-20,250 H60");
    assert!(
        has(&checked, "margin", "\"far\" reaches 20.5 mm beyond the sheet, and render cuts it off at the edge"),
        "{checked}"
    );
    assert!(has(&checked, "margin", ", 0 mm from the left and 250 mm from the top"), "{checked}");
    assert!(checked.errors() > 0);
    assert!(!has(&drawn("M60,250 H150"), "margin", ""));
    let white = "<rect x=\"-5\" y=\"-5\" width=\"220\" height=\"310\" fill=\"#fff\"/>";
    let checked = changed("bars.svg", |svg| svg.replacen("<g ", &format!("{white}<g "), 1));
    assert!(!has(&checked, "margin", ""), "white prints nothing: {checked}");
}

#[test]
fn a_black_block_is_found_and_what_is_drawn_with_a_hole_is_none() {
    let block = "<path d=\"M40,235 h60 v20 h-60 z\" fill=\"#000\"/>";
    let checked = changed("bars.svg", |svg| with_lines(svg, block));
    assert!(has(&checked, "filled", "a block of"), "{checked}");
    let frame = "<path d=\"M40,235 h60 v20 h-60 z M42,237 v16 h56 v-16 z\" fill=\"#000\"/>";
    assert!(!has(&changed("bars.svg", |svg| with_lines(svg, frame)), "filled", ""), "a frame of 2 mm");
    let red = "<path d=\"M40,235 h60 v20 h-60 z\" fill=\"#f00\"/>";
    assert!(!has(&changed("bars.svg", |svg| with_lines(svg, red)), "filled", ""), "an area that is to have a texture");
}

#[test]
fn lines_that_cross_in_a_vertex_of_both_cross() {
    let cross = |bend: &str| {
        format!(
            "<path d=\"M60,250 L90,250 L120,250\" stroke-width=\"1\"/>\
             <path d=\"M90,235 L90,249.9 {bend} L90,265\" stroke-width=\"1\"/>"
        )
    };
    for bend in ["L90,250", "L90,250.1", "L90.05,250 L90,250.15"] {
        let checked = changed("bars.svg", |svg| with_lines(svg, &cross(bend)));
        assert!(!has(&checked, "line-gap", "without a name and line 2"), "{bend}: {checked}");
    }
    let beside = cross("L90,250").replace("M90,235", "M60,240").replace("L90,249.9", "L80,247");
    let checked = changed("bars.svg", |svg| with_lines(svg, &beside.replace("L90,250", "L90,247")));
    assert!(has(&checked, "line-gap", "without a name and line 2"), "a line along another is too near: {checked}");
}

/// The page without the path of this id, and nothing else.
fn without_path(svg: &str, id: &str) -> String {
    let at = svg.find(&format!("id=\"{id}\"")).expect("the object is there");
    let start = svg[..at].rfind('<').expect("its element begins");
    let end = at + svg[at..].find("/>").expect("it ends") + 2;
    let element = &svg[start..end];
    assert!(element.starts_with("<path ") && element.matches('<').count() == 1, "{element}");
    [&svg[..start], &svg[end..]].concat()
}

/// What is told of a line is told by the name that an editor shows, whatever was deleted before it.
#[test]
fn findings_name_lines_and_areas_as_the_page_does() {
    let near = "<path id=\"path77\" inkscape:label=\"my roof\" d=\"M60,250 L120,250\" stroke-width=\"1\"/>\
                <path id=\"line-44\" inkscape:label=\"line 44\" d=\"M60,252 L120,252\" stroke-width=\"1\"/>\
                <path id=\"path99\" inkscape:label=\"line 44\" d=\"M60,270 L62,270\" stroke-width=\"1\"/>";
    let checked = changed("bars.svg", |svg| with_lines(without_path(&svg, "line-1"), near));
    assert!(has(&checked, "line-gap", "line \"my roof\" and line 44 (\"line-44\") are 1.0 mm apart"), "{checked}");
    assert!(has(&checked, "line-length", "line 44 (\"path99\") is 3.0 mm long"), "{checked}");
    // one object of two parts
    let parts = "<path id=\"line-50\" d=\"M60,250 L120,250 M60,252 L120,252\" stroke-width=\"1\"/>";
    let checked = changed("bars.svg", |svg| with_lines(svg, parts));
    assert!(has(&checked, "line-gap", "two parts of line 50 are 1.0 mm apart"), "{checked}");
    // an area behind one that was deleted, with a line through it
    let page = page::of_sample("coffee.png", "swell-a4").page.clone();
    let class = page.figure.textures[0].class;
    let last = page.figure.textures.iter().rposition(|texture| texture.class == class).expect("there is one");
    assert!(last > 0, "it has several areas of one class");
    let nth = page.figure.textures.iter().filter(|texture| texture.class == class).count();
    let at = page.figure.textures[last].glyphs[0].at;
    let through = format!("<path d=\"M{},{} h9\" stroke-width=\"1\"/>", at.x - 4.0, at.y);
    let checked = changed("coffee.png", |svg| with_lines(without_path(&svg, "region-1"), &through));
    let name = format!("{} area {nth}: ", class.name());
    assert!(has(&checked, "texture-gap", &name), "{name} {checked}");
}

/// What `render` puts right is a warning that says so, and what it does not is an error.
#[test]
fn what_render_mends_is_a_warning() {
    let mended = |checked: &Checked, rule: &str, words: &str| {
        let of_rule = checked.findings.iter().filter(|finding| finding.rule.id == rule);
        let told: Vec<String> = of_rule.filter(|finding| !finding.is_error()).map(ToString::to_string).collect();
        told.iter().any(|told| told.starts_with("warning ") && told.contains(words))
    };
    let thin = "<path d=\"M60,250 L120,250\" stroke-width=\"0.2\"/>";
    let checked = changed("bars.svg", |svg| with_lines(svg, thin));
    assert!(mended(&checked, "line-width", "0.20 mm wide"), "{checked}");
    assert!(mended(&checked, "line-width", "what render makes of the page, as it gives it the least width"));
    assert!(!checked.to_string().contains("error line-width"), "{checked}");
    // by the numbers of another profile, render would have to be asked for that
    let svg = with_lines(page::of_sample("bars.svg", "swell-a4").page.to_svg(), thin);
    let other = tactograph::Profile::named("swell-a4").expect("it is built in");
    let checked = check(svg, &PageOptions::new().profile(other)).expect("it can be read");
    assert!(checked.to_string().contains("error line-width"), "{checked}");
    // words
    let typed = "<g id=\"labels-text\"><text x=\"60\" y=\"250\">Rain</text></g><text x=\"60\" y=\"99\">no</text>";
    let checked = changed("bars.svg", |svg| svg.replace("</svg>", &format!("{typed}</svg>")));
    assert!(mended(&checked, "letters", "\"Rain\" is written in letters"), "{checked}");
    assert!(mended(&checked, "letters", "writes them in braille"), "{checked}");
    assert_eq!(checked.errors(), 1, "the other is left out: {checked}");
    let json: serde_json::Value = serde_json::from_str(&checked.to_json()).expect("JSON");
    let finding = |severity: &str| {
        let findings = json["findings"].as_array().expect("findings").iter();
        findings.filter(|of| of["rule"] == "letters").find(|of| of["severity"] == severity).expect("one").clone()
    };
    assert_eq!(finding("warning")["render"], "writes them in braille of standard cells");
    assert!(finding("error")["render"].is_null());
}

/// Two ends between which another line passes are no broken line, also where it passes in one of its vertices.
#[test]
fn a_line_between_two_ends_keeps_them_apart() {
    let ends = "<path d=\"M60,250 L87,250\" stroke-width=\"1\"/><path d=\"M93,250 L120,250\" stroke-width=\"1\"/>";
    let broken = |between: &str| {
        let checked = changed("bars.svg", |svg| with_lines(svg, &format!("{ends}{between}")));
        has(&checked, "broken-line", "before one another")
    };
    assert!(broken(""));
    for between in ["M90,240 L90,260", "M90,240 L90,250 L90,260", "M90,240 L90.5,250 L90,260"] {
        assert!(!broken(&format!("<path fill=\"none\" d=\"{between}\" stroke-width=\"1\"/>")), "{between}");
    }
}

/// The second row of a heavy line of dots, and the next dot of a ring, are no gaps.
#[test]
fn rows_of_dots_are_not_broken_lines() {
    let svg = page::of_sample("coffee.png", "index-basic-d").page.to_svg();
    let checked = check(svg, &PageOptions::new()).expect("it can be read");
    assert!(!has(&checked, "broken-line", "the two ends of"), "{checked}");
    let svg = page::of_sample("chart.svg", "index-basic-d").page.to_svg();
    let checked = check(svg, &PageOptions::new()).expect("it can be read");
    assert!(!has(&checked, "broken-line", ""), "{checked}");
}

/// On dots it is the figure of a sheet of its own.
#[test]
fn places_of_an_overview_are_called_so() {
    let overview = page::of_sample("coffee.png", "index-basic-d").overview.clone().expect("there is one");
    let checked = check(overview.to_svg(), &PageOptions::new()).expect("it can be read");
    assert!(
        has(&checked, "broken-line", "of the overview, ") && !checked.to_string().contains("of the figure"),
        "{checked}"
    );
}

#[test]
fn colours_and_letters_are_found() {
    let grey = changed("bars.svg", |svg| svg.replacen("stroke=\"#000000\"", "stroke=\"#777777\"", 1));
    assert!(has(&grey, "black-only", "#777777"), "{grey}");
    let print = changed("bars.svg", |svg| svg.replace("</svg>", "<text x=\"30\" y=\"40\">Rain</text></svg>"));
    assert!(has(&print, "letters", "\"Rain\" is written in letters"), "{print}");
    assert!(print.findings.iter().any(|finding| finding.rule.id == "letters" && finding.at.is_some()));
}

/// A tracing as other programs make it: filled shapes with holes, in one path.
const TRACING: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"180mm\" height=\"120mm\" viewBox=\"0 0 1800 1200\">\
    <g transform=\"translate(0,1200) scale(1,-1)\" fill=\"#000000\" stroke=\"none\">\
    <path d=\"M100 100 C 300 900 900 1100 1400 700 L 1400 704 C 900 1104 300 904 96 102 Z \
    M500 300l300 0l0 300l-300 0z M820 300l200 0l0 300l-200 0z\"/>\
    <path fill=\"#336699\" d=\"M1100 300l300 0l0 200l-300 0z\"/></g></svg>";

#[test]
fn a_tracing_of_another_program_is_found_faulty() {
    let checked = check(TRACING, &PageOptions::new()).expect("it is an SVG");
    for (rule, words) in [
        ("layers", "no page of tactograph"),
        ("line-width", "thinner than 0.75 mm"),
        ("line-gap", "narrower than 3.2 mm"),
        ("filled", "all black"),
        ("black-only", "#336699"),
    ] {
        assert!(has(&checked, rule, words), "{rule}: {checked}");
    }
    // 20 units, which are 2 mm, lie between the two squares, whose lower edges are 30 mm from the bottom
    let gap = checked.findings.iter().find(|finding| finding.rule.id == "line-gap").expect("found above");
    let at = gap.at.expect("it has a place");
    assert!((at.x - 81.0).abs() < 0.5 && (at.y - 75.0).abs() < 0.5, "{at:?}");
    assert_eq!(gap.place, "middle of the figure");
}

#[test]
fn what_is_no_drawing_is_refused() {
    for bytes in [&b"%PDF-1.7"[..], b"\x89PNG\r\n\x1a\n", b"", b"<html/>", b"<svg"] {
        assert!(check(bytes, &PageOptions::new()).is_err(), "{bytes:?}");
    }
}

#[test]
fn the_verdict_is_weighted_by_area_and_says_what_was_not_judged() {
    let checked =
        check(page::of_sample("coffee.png", "swell-a4").page.to_svg(), &PageOptions::new()).expect("it can be read");
    let textures = checked.verdict.textures.expect("it has textures");
    assert!(textures.judged < 0.25 && textures.right > 0.9, "{textures:?}");
    let told = checked.verdict.to_string();
    let few = format!("only {:.0} % of the textures is 7 mm or more from lines and borders", 100.0 * textures.judged);
    assert!(told.contains(&few) && !told.contains("right"), "{told}");
    assert!(told.ends_with("a larger figure, or one with fewer lines, has wider areas."), "{told}");
    let mut near = checked.verdict;
    near.textures.iter_mut().for_each(|textures| textures.judged = 0.0);
    assert!(near.to_string().contains("; all textures are nearer than 7 mm to lines or borders"), "{near}");
    let mut enough = checked.verdict;
    enough.textures.iter_mut().for_each(|textures| textures.judged = 0.6);
    let told = enough.to_string();
    assert!(told.contains("; the rest lies too near to lines and borders to be judged"), "{told}");
    enough.textures.iter_mut().for_each(|textures| (textures.judged, textures.right) = (0.8, 0.75));
    let told = enough.to_string();
    assert!(told.contains("reads 60 % of the textures right and 20 % wrong; the rest lies"), "{told}");
    enough.textures.iter_mut().for_each(|textures| (textures.judged, textures.right) = (1.0, 1.0));
    let told = enough.to_string();
    assert!(told.ends_with("; a fingertip reads 100 % of the textures right."), "{told}");
}

/// A photograph on an embosser whose textures drown its lines says so when it is made and when it is checked; without
/// textures, and on paper, there is nothing to say.
#[test]
fn a_page_whose_lines_drown_in_rows_of_textures_says_so() {
    const RULE: &str = "lines-among-rows";
    let photograph = page::of_sample("rocket.jpg", "index-basic-d");
    let checked = check(photograph.page.to_svg(), &PageOptions::new()).expect("it can be read");
    assert!(has(&checked, RULE, "14 % is the most") && has(&checked, RULE, "lines only"), "{checked}");
    assert_eq!(checked.errors(), 0, "it is a warning: {checked}");
    assert!(checked.verdict.to_string().contains("lines can hardly be followed"), "{}", checked.verdict);
    assert!(photograph.notes.iter().any(|note| note.reason() == Some(Reason::AmongRows)), "{:?}", photograph.notes);
    let mut alone = tactograph::marks::Parts::clone(&photograph.page);
    alone.figure.textures.clear();
    let svg = tactograph::Page::new(alone).expect("a page").to_svg();
    let checked = check(svg, &PageOptions::new()).expect("it can be read");
    assert!(!has(&checked, RULE, "") && !checked.verdict.to_string().contains("followed"), "{checked}");
    for (sample, profile) in [("rocket.jpg", "swell-a4"), ("landscape.svg", "index-basic-d")] {
        let made = page::of_sample(sample, profile);
        let checked = check(made.page.to_svg(), &PageOptions::new()).expect("it can be read");
        assert!(!has(&checked, RULE, ""), "{sample} {profile}: {checked}");
        let told = |reason: Reason| made.notes.iter().any(|note| note.reason() == Some(reason));
        assert!(!told(Reason::AmongRows) && !told(Reason::LooseEnds), "{sample} {profile}: {:?}", made.notes);
    }
}

/// A finding says in which line of the file its element stands: of lines and texts, as they were written or drawn by
/// hand.
#[test]
fn findings_have_their_line_in_the_file() {
    let written = page::of_sample("cell.svg", "swell-a4").page.to_svg();
    let by_hand = "<path id=\"roof\" d=\"M100,150L103,150\" stroke=\"#000\" stroke-width=\"1.5\"/>\n\
                   <text x=\"30\" y=\"40\" font-size=\"6\">cell</text>\n";
    let (before, after) = written.rsplit_once("</svg>").expect("its end");
    let edited = format!("{before}\n{by_hand}</svg>{after}");
    let row_of = |what: &str| 1 + edited[..edited.find(what).expect("it is there")].matches('\n').count() as u32;
    let checked = check(&edited, &PageOptions::new()).expect("it can be read");
    let line_of = |rule: &str, what: &str| {
        let found = checked.findings.iter().find(|found| found.rule.id == rule && found.what.contains(what));
        found.unwrap_or_else(|| panic!("{rule}: {checked}")).line
    };
    assert_eq!(line_of("line-length", "\"roof\""), Some(row_of("<path id=\"roof\"")));
    assert_eq!(line_of("letters", "\"cell\""), Some(row_of("<text")));
    let roof =
        checked.findings.iter().find(|finding| finding.rule.id == "line-length" && finding.what.contains("roof"));
    let object = roof.and_then(|finding| finding.object.as_deref());
    assert!(object.is_some_and(|object| object.contains("roof")), "{object:?}");
    let sarif: serde_json::Value = serde_json::from_str(&checked.to_sarif("page.svg")).expect("JSON");
    let rows = sarif["runs"][0]["results"].as_array().expect("results").iter();
    let rows = rows.map(|result| result["locations"][0]["physicalLocation"]["region"]["startLine"].as_u64());
    assert!(rows.flatten().any(|row| row == u64::from(row_of("<path id=\"roof\""))));
    let mut results = sarif["runs"][0]["results"].as_array().expect("results").iter();
    let roof = results.find(|result| result["ruleId"] == "line-length").expect("the roof is too short");
    let named = &roof["locations"][0]["logicalLocations"][0];
    assert_eq!((named["name"].as_str(), named["kind"].as_str()), (object, Some("element")));
    assert!(roof["message"]["text"].as_str().is_some_and(|text| text.contains(" mm from the left")), "{roof}");
}

#[test]
fn places_are_where_a_mark_leaves_the_margin_and_where_two_meet() {
    let lines = "<path id=\"out\" d=\"M60,250 L160,293\" stroke-width=\"1\"/>";
    let checked = changed("bars.svg", |svg| with_lines(svg, lines));
    let found = checked.findings.iter().find(|finding| finding.rule.id == "margin").expect("it is out");
    let (at, extent) = (found.at.expect("a place"), found.extent.expect("a box"));
    assert!((at.y - 286.5).abs() < 0.01 && extent.min.y > 285.5, "{at:?} {extent:?}");
    // across the band of dots around the figure
    let left = page::of_sample("bars.svg", "swell-a4").page.figure.place.min.x;
    let across = format!("<path id=\"in\" d=\"M{},100 H{}\" stroke-width=\"1\"/>", left - 7.0, left + 60.0);
    let checked = changed("bars.svg", |svg| with_lines(svg, &across));
    let found = checked.findings.iter().find(|finding| finding.rule.id == "overlap").expect("it lies on the frame");
    // not the middle of the line
    assert!((left - found.at.expect("a place").x - 3.5).abs() < 3.5, "{found:?} {left}");
    assert!(found.extent.expect("a box").width() < 3.0, "{found:?}");
}

#[test]
fn a_line_drawn_by_hand_that_ends_just_before_another_is_told() {
    let drawn = |end: f32| {
        let lines = format!(
            "<path id=\"post\" d=\"M60,250 H160\" stroke-width=\"1\"/>\
                             <path id=\"branch\" d=\"M100,280 V{end}\" stroke-width=\"1\"/>"
        );
        changed("bars.svg", |svg| with_lines(svg, &lines))
    };
    let told = "line \"branch\" ends 4.0 mm before line \"post\", so that it may be meant to meet it";
    assert!(has(&drawn(255.0), "broken-line", told), "{}", drawn(255.0));
    assert!(!has(&drawn(262.0), "broken-line", ""), "far off");
    assert!(!has(&drawn(250.0), "broken-line", ""), "it meets it");
}

#[test]
fn contours_that_a_photograph_lacks_are_told_from_a_fifth_on() {
    let told = |notes: &[tactograph::Note]| notes.iter().filter(|note| note.id() == "lines-left-out").count();
    let drawing = page::of_sample("coffee.png", "swell-a4");
    for (said, expected) in [("190 of 1000", 0), ("210 of 1000", 1)] {
        let mut parts = tactograph::marks::Parts::clone(&drawing.page);
        let of_contours = parts.origin.iter_mut().find(|(name, _)| name == "contours left out in mm");
        said.clone_into(&mut of_contours.expect("it lacks some").1);
        let checked = check(tactograph::Page::new(parts).expect("a page").to_svg(), &PageOptions::new());
        let checked = checked.expect("it can be read");
        let other = |rule: &str| !["broken-line", "loose-ends"].contains(&rule);
        let others = checked.findings.iter().filter(|finding| other(finding.rule.id)).count();
        assert_eq!((told(&checked.notes), others), (expected, 0), "{said}: {checked}");
    }
    assert_eq!(told(&drawing.notes), 0, "it lacks an eighth of them: {:?}", drawing.notes);
}

#[test]
fn findings_are_data_too() {
    let checked = check(TRACING, &PageOptions::new()).expect("it is an SVG");
    let json: serde_json::Value = serde_json::from_str(&checked.to_json()).expect("JSON");
    assert_eq!(json["errors"].as_u64(), Some(checked.errors() as u64));
    let finding = &json["findings"][0];
    assert!(finding["rule"].is_string() && finding["place"].is_string() && finding["remedy"].is_string(), "{finding}");
    assert!(json["faulty"].as_f64().is_some_and(|share| share > 0.0), "{}", json["faulty"]);
    assert_eq!(json["notes"].as_array().map(Vec::len), Some(checked.notes.len()));
    for finding in &checked.findings {
        let of_json = json["findings"].as_array().expect("findings").iter().find(|one| one["rule"] == finding.rule.id);
        let unit = of_json.expect("each is there")["unit"].as_str();
        assert_eq!(unit, checked.limit(&finding.rule).map(|(_, unit)| unit));
    }
    let sarif = |file: &str| -> serde_json::Value { serde_json::from_str(&checked.to_sarif(file)).expect("JSON") };
    for (file, uri) in [
        ("page.svg", "page.svg"),
        ("my page 50%.svg", "my%20page%2050%25.svg"),
        ("pages\\straße.svg", "pages/stra%C3%9Fe.svg"),
        ("/pages/c:#?.svg", "/pages/c%3A%23%3F.svg"),
    ] {
        let all = sarif(file);
        let location = &all["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
        assert_eq!(location["artifactLocation"]["uri"].as_str(), Some(uri));
    }
    let sarif = sarif("page.svg");
    let run = &sarif["runs"][0];
    assert_eq!(run["results"].as_array().map(Vec::len), Some(checked.findings.len()));
    let rules = run["tool"]["driver"]["rules"].as_array().expect("rules");
    let known = |result: &serde_json::Value| rules.iter().any(|rule| rule["id"] == result["ruleId"]);
    assert!(run["results"].as_array().expect("results").iter().all(known));
    // none of them is of an object
    let is_placed = |result: &serde_json::Value| {
        let location = &result["locations"][0];
        location["physicalLocation"]["region"]["startLine"] == 1
            && location["logicalLocations"].as_array().is_some_and(Vec::is_empty)
    };
    assert!(run["results"].as_array().expect("results").iter().all(is_placed));
}

/// A marked page reads as the page without its marks.
#[test]
fn a_marked_page_is_the_page() {
    let near = "<path d=\"M60,250 L120,250\" stroke-width=\"1\"/><path d=\"M60,252 L120,252\" stroke-width=\"1\"/>";
    let svg = with_lines(page::of_sample("bars.svg", "swell-a4").page.to_svg(), near);
    let checked = check(&svg, &PageOptions::new()).expect("it can be read");
    let marked = checked.marked(&svg).expect("it can be read");
    assert!(marked.contains("id=\"findings\"") && marked.matches("<rect").count() > svg.matches("<rect").count());
    let again = check(marked, &PageOptions::new()).expect("it can be read");
    assert_eq!(again.findings, checked.findings);
}

#[test]
fn a_large_shape_that_the_overview_lacks_is_told() {
    let checked =
        check(page::of_sample("landscape.svg", "swell-a4").page.to_svg(), &PageOptions::new()).expect("it can be read");
    assert!(!has(&checked, "overview-lacks", ""), "{checked}");
    let bare = changed("landscape.svg", |svg| {
        let (before, overview) = svg.split_once("id=\"overview\"").expect("it has an overview");
        format!("{before}id=\"overview\"{}", overview.replace("<path ", "<path display=\"none\" "))
    });
    assert!(has(&bare, "overview-lacks", "which is closed, 31 mm wide and 31 mm high"), "the sun: {bare}");
    // one that other lines of the overview only cross is not in it
    let crossed = changed("coffee.png", |svg| with_lines(svg, "<circle id=\"big\" cx=\"50\" cy=\"60\" r=\"20\"/>"));
    assert!(
        has(&crossed, "overview-lacks", "nothing like line \"big\" of the figure, which is closed, 40 mm"),
        "{crossed}"
    );
}

#[test]
fn an_overview_whose_figure_has_no_lines_any_more_is_told() {
    let svg = page::of_sample("landscape.svg", "swell-a4").page.to_svg();
    let hidden = svg.replacen("<g fill=\"none\" id=\"lines\"", "<g display=\"none\" fill=\"none\" id=\"lines\"", 1);
    assert_ne!(svg, hidden);
    let rules = |svg: String| {
        let checked = check(svg, &PageOptions::new()).expect("it can be read");
        checked.findings.iter().filter(|finding| finding.rule.id == "overview").count()
    };
    assert_eq!(rules(svg), 0);
    assert!(rules(hidden) > 2);
}

#[test]
fn an_overview_that_lacks_much_of_a_drawing_is_told() {
    let lacks = |svg: String| {
        let bare = |svg: &str| {
            let (before, overview) = svg.split_once("id=\"overview\"").expect("it has an overview");
            format!("{before}id=\"overview\"{}", overview.replacen("<path ", "<path display=\"none\" ", 2))
        };
        let checked = |svg: String| check(svg, &PageOptions::new()).expect("it can be read");
        (
            has(&checked(svg.clone()), "overview-lacks", "% of the lines"),
            has(&checked(bare(&svg)), "overview-lacks", "% of the lines"),
        )
    };
    // an open line and a box
    let picture = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 300'>\
        <rect width='300' height='300' fill='#fff'/><g fill='none' stroke='#000' stroke-width='4'>\
        <path d='M150 20V280'/><path d='M30 40L60 260'/><path d='M240 40V260'/></g></svg>";
    let options = tactograph::Options::new(tactograph::Profile::named("swell-a4").expect("it is built in"));
    let page = tactograph::convert(picture.as_bytes(), &options).expect("a page").page;
    assert_eq!(lacks(page.to_svg()), (false, true));
}

/// Copies of a line on itself are one finding, however many there are: each pair of them would be one otherwise.
#[test]
fn lines_on_one_another_are_told_once() {
    let copies = |count: usize| {
        changed("chart.svg", |svg| {
            let line = "<path d=\"M60 60L90 60 90 90\" fill=\"none\" stroke=\"#000\" stroke-width=\"1\"/>";
            with_lines(svg, &line.repeat(count))
        })
    };
    let (one, many) = (copies(1), copies(300));
    assert!(has(&many, "overlap", "299 other lines lie on it, point for point"), "{many}");
    assert_eq!(many.findings.len(), one.findings.len() + 1, "{many}");
}
