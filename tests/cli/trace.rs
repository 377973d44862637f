//! `tactograph trace`: contours as data.

use serde_json::Value;

use crate::cli::common::*;

/// The trace in a text, after a look at whether it is what was promised.
#[track_caller]
fn trace_in(text: &str) -> Value {
    let trace: Value = serde_json::from_str(text).unwrap_or_else(|error| panic!("no JSON: {error}"));
    assert_eq!(trace["program"], format!("tactograph {}", env!("CARGO_PKG_VERSION")));
    for polyline in trace["polylines"].as_array().expect("polylines") {
        assert!(polyline["closed"].is_boolean());
        let count = polyline["points"].as_array().expect("points").len();
        assert!(count > 1 && polyline["strength"].as_array().is_some_and(|strength| strength.len() == count));
    }
    trace
}

/// The trace of the picture that all tests use: a red square from 30, 20 to 80, 70.
#[track_caller]
fn is_the_square(trace: &Value) {
    assert_eq!(trace["image"], serde_json::json!([120, 90]));
    let [square] = &trace["polylines"].as_array().expect("polylines")[..] else { panic!("{trace}") };
    assert_eq!(square["closed"], true);
    let number = |value: &Value| value.as_f64().expect("a number");
    for at in square["points"].as_array().expect("points") {
        let off = ((number(&at[0]) - 55.0).abs().max((number(&at[1]) - 45.0).abs()) - 25.0).abs();
        assert!(off < 1.0, "{at} lies {off} px off");
    }
}

#[test]
fn a_trace_lies_beside_its_picture() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["trace", "a.png"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", "wrote a.json\n"));
    is_the_square(&trace_in(&place.text("a.json")));
    let run = place.run(&["trace", "a.png", "-o", "full.json", "--full-resolution", "--threshold", "3, 6"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote full.json\n"));
    is_the_square(&trace_in(&place.text("full.json")));
    assert_eq!(place.names(), ["a.json", "a.png", "full.json"]);
}

#[test]
fn lines_have_widths_and_follow_the_profile() {
    let place = Place::with_picture("a.png");
    let widest = |more: &[&str]| {
        let run = place.run(&[&["trace", "a.png", "-o", "-", "-q", "--stage", "lines"], more].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let trace = trace_in(&run.out);
        let widths = trace["polylines"][0]["width_mm"].as_array().expect("widths").clone();
        assert_eq!(widths.len(), trace["polylines"][0]["points"].as_array().expect("points").len());
        widths.iter().filter_map(Value::as_f64).fold(0.0, f64::max)
    };
    assert!((widest(&[]) - 1.5).abs() < 0.001);
    assert!((widest(&["--set", "lines.width_max=1.2"]) - 1.2).abs() < 0.001);
    let edges = trace_in(&place.run(&["trace", "a.png", "-o", "-"]).out);
    assert_eq!(edges["polylines"][0]["width_mm"], Value::Null, "contours have no width");
}

#[test]
fn standard_input_to_standard_output() {
    let place = Place::new();
    let run = place.run_with_input(&["trace", "-"], &picture());
    assert_eq!((run.code, run.err.as_str()), (0, "wrote standard output\n"));
    is_the_square(&trace_in(&run.out));
    let file = place.run_with_input(&["trace", "-", "-q", "-o", "b.json"], &picture());
    assert_eq!((file.code, file.out.as_str(), file.err.as_str()), (0, "", ""));
    assert_eq!(place.text("b.json"), run.out, "not the same trace again");
    let run = place.run_with_input(&["trace", "-"], b"");
    assert_eq!((run.code, run.out.as_str()), (1, ""));
    assert_eq!(run.err, "tactograph: standard input: the file is empty; give a picture\n");
}

#[test]
fn several_pictures_go_to_a_directory_and_a_bad_one_stops_none() {
    let place = Place::with_picture("a.png");
    place.put("b.png", b"");
    place.put("c.png", &picture());
    let run = place.run(&["trace", "a.png", "b.png", "c.png", "--out-dir", "new"]);
    let expected = "1 of 3: a.png: wrote new/a.json\n\
        tactograph: b.png: the file is empty; give a picture\n\
        3 of 3: c.png: wrote new/c.json\n\
        tactograph: 1 of 3 pictures could not be traced\n";
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (1, "", expected));
    assert!(place.text("new/a.json") == place.text("new/c.json"));
    let lines = [
        "-o names one trace, but there are 2 pictures; use --out-dir DIR for several",
        "a.json: would be the trace of both a.png and a.jpg; trace one of them alone, with -o",
    ];
    place.refuses(&["trace", "a.png", "c.png", "-o", "x.json"], 2, &lines[..1]);
    place.put("a.jpg", &jpeg());
    place.refuses(&["trace", "a.png", "a.jpg"], 2, &lines[1..]);
}

#[test]
fn what_is_not_a_trace_is_kept() {
    let place = Place::with_picture("a.png");
    let kept = "a.json: this file exists and was not written by tactograph, or changed since; name the trace with -o, move that file away, or replace it with --force";
    let other = "{\"image\":[1,1],\"polylines\":[]}";
    place.put("a.json", other.as_bytes());
    place.refuses(&["trace", "a.png"], 1, &[kept]);
    assert_eq!(place.text("a.json"), other);
    // Whoever names it means it; a trace of ours is replaced, and so is an empty file.
    assert_eq!(place.run(&["trace", "a.png", "-o", "a.json"]).code, 0);
    let own = place.text("a.json");
    assert_eq!(place.run(&["trace", "a.png", "--threshold", "900,900"]).code, 0);
    assert!(place.text("a.json") != own);
    place.put("a.json", b"");
    assert_eq!(place.run(&["trace", "a.png"]).code, 0);
    assert_eq!(place.text("a.json"), own);
    // Set anew by another program.
    let read: Value = serde_json::from_str(&own).expect("JSON");
    place.put("a.json", format!("{read:#}").as_bytes());
    place.refuses(&["trace", "a.png"], 1, &[kept]);
    // A page of ours is no trace.
    assert_eq!(place.run(&["convert", "a.png", "-o", "a.svg"]).code, 0);
    place.put("a.json", place.text("a.svg").as_bytes());
    place.refuses(&["trace", "a.png"], 1, &[kept]);
    // A picture that is called like a trace.
    place.put("odd.json", &picture());
    let run = place.run(&["trace", "odd.json"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote odd.trace.json\n"));
    let itself = "odd.json: the trace would overwrite the picture itself; choose another name with -o";
    place.refuses(&["trace", "odd.json", "-o", "odd.json"], 2, &[itself]);
}

#[test]
fn wrong_usage_of_trace_is_one_line_and_nothing_is_done() {
    let place = Place::with_picture("a.png");
    for bad in ["3,2", "-1,2", "-2,-1", "nan,nan", "1,inf", "5", "1,2,3", "1;2", "low,high", ""] {
        let line = format!(
            "invalid value '{bad}' for '--threshold <LOW,HIGH>': give two numbers from 0 up, the first not above the second, \
             such as 3,6; see tactograph trace --help"
        );
        place.refuses(&["trace", "a.png", "--threshold", bad], 2, &[&line]);
    }
    let cases: [(&[&str], &[&str]); 5] = [
        (&["trace"], &["name a picture to trace; see tactograph trace --help"]),
        (&["trace", "a.png", "-o", "a.svg"], &["a.svg: a trace is not written as .svg, only as .json; name it a.json"]),
        (
            &["trace", "a.png", "--stage", "lines", "--full-resolution"],
            &[
                "--full-resolution does not go with --stage lines: a page has lines only at the size that its profile works \
               on; leave one out, or make that size larger with --set figure.resolution=12",
            ],
        ),
        (
            &["trace", "a.png", "--stage", "dots"],
            &[
                "invalid value 'dots' for '--stage <STAGE>' [possible values: edges, lines]; see tactograph trace --help",
            ],
        ),
        (
            &["trace", "a.png", "-o", "b.svg", "--set", "lines"],
            &[
                "b.svg: a trace is not written as .svg, only as .json; name it b.json",
                "--set lines: write it as key=value, such as lines.width_max=1.2",
            ],
        ),
    ];
    for (args, lines) in cases {
        place.refuses(args, 2, lines);
    }
    assert_eq!(place.names(), ["a.png"]);
}

#[test]
fn limits_of_trace_are_told_with_their_options() {
    let place = Place::new();
    place.put("huge.png", &png_header(30_000, 30_000));
    let line = "huge.png: the picture has 30000 x 30000 pixels, which is over the limit of 300 megapixels; make it smaller in a \
                picture editor first, or raise the limit with --max-megapixels";
    place.refuses(&["trace", "huge.png", "--full-resolution"], 1, &[line]);
    place.put("large.png", &png(1200, 1000, &[200; 1200 * 1000 * 3]));
    let run = place.run(&["trace", "large.png", "--full-resolution", "--max-memory", "20"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("over the limit of 20 MB") && run.err.ends_with("with --max-memory\n"), "{}", run.err);
    assert_eq!(place.names(), ["huge.png", "large.png"]);
}

#[test]
fn trace_tells_of_its_stages_and_of_nothing_found() {
    let place = Place::with_picture("a.png");
    place.put("white.png", &png(60, 60, &[255; 60 * 60 * 3]));
    let run = place.run(&["trace", "a.png", "-q", "--timings"]);
    let names = run.err.lines().skip(1).filter_map(|line| line.split_whitespace().next());
    let rows = names.filter(|name| *name != "other").collect::<Vec<_>>();
    assert_eq!(rows, ["read", "decode", "text", "edges", "regions", "write", "total"], "{}", run.err);
    let nothing = "tactograph: white.png: note: nothing to trace: no contour is strong and long enough; lower the thresholds, \
                   or give a brighter picture\nwrote white.json\n";
    let run = place.run(&["trace", "white.png"]);
    assert_eq!((run.code, run.err.as_str()), (0, nothing));
    assert_eq!(trace_in(&place.text("white.json"))["polylines"], serde_json::json!([]));
    let quiet = place.run(&["trace", "white.png", "-q"]);
    assert_eq!((quiet.code, quiet.err.as_str()), (0, ""));
}

#[test]
fn help_teaches_the_format_and_the_unit() {
    let place = Place::new();
    let help = place.run(&["trace", "--help"]);
    assert_eq!((help.code, help.err.as_str()), (0, ""));
    for word in [
        "-o, --output <TRACE.json>",
        "--out-dir <DIR>",
        "--stage <STAGE>",
        "--threshold <LOW,HIGH>",
        "--full-resolution",
        "--profile <NAME|FILE.toml>",
        "--set <KEY=VALUE>",
        "--timings",
        "-q, --quiet",
        "--max-megapixels <N>",
        "--max-memory <MB>",
        "\"polylines\":[",
        "width_mm",
        "CIELAB",
        "Examples:",
        "Exit codes:",
    ] {
        assert!(help.out.contains(word), "{word} is not in the help");
    }
    // What is said of --full-resolution's own thresholds is so.
    let own = tactograph::internals::edges::Params::default();
    assert!(help.out.contains(&format!("with --full-resolution {},{}]", own.low, own.high)));
    let words = help.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains(&format!("crumbs, which at full resolution are shorter than {} pixels", own.min_length)));
    let lines = place.run(&["trace", "-h"]).out.lines().count();
    assert!(lines <= 35, "trace -h has {lines} lines: no short help");
}
