//! The report of a run.

use serde_json::Value;

use crate::cli::common::*;

/// The report without times, which must be there.
#[track_caller]
fn report(place: &Place, name: &str) -> Value {
    let mut report: Value = serde_json::from_str(&place.text(name)).expect("JSON");
    assert!(report["time_ms"].take().as_f64().is_some_and(|time| time > 0.0));
    for picture in report["pictures"].as_array_mut().expect("pictures") {
        assert!(picture["time_ms"].take().as_f64().is_some_and(|time| time >= 0.0), "{picture}");
    }
    report
}

#[test]
fn the_report_says_what_became_of_each_picture() {
    let place = Place::with_picture("a.png");
    place.put("bad.png", b"");
    place.put("white.png", &png(60, 60, &[255; 60 * 60 * 3]));
    let args = [
        "convert",
        "a.png",
        "bad.png",
        "white.png",
        "--profile",
        "index-basic-d",
        "--format",
        "idx",
        "--preview",
        "png",
        "--force",
        "-q",
        "--report",
        "run.json",
    ];
    let run = place.run(&args);
    assert_eq!(run.code, 1, "{}", run.err);
    let first = report(&place, "run.json");
    assert_eq!(
        (&first["format"], &first["profile"], &first["failed"]),
        (&"idx".into(), &"index-basic-d".into(), &1.into())
    );
    assert!(first["program"].as_str().is_some_and(|program| program.starts_with("tactograph ")));
    let [good, bad, white] = &first["pictures"].as_array().expect("pictures")[..] else { panic!("{first}") };
    assert_eq!((&good["picture"], &good["done"], &good["page"]), (&"a.png".into(), &true.into(), &Value::Null));
    assert_eq!(good["outputs"], serde_json::json!(["a.idx"]));
    assert_eq!(good["previews"], serde_json::json!(["a.idx.preview-1.png", "a.idx.preview-2.png"]));
    assert_eq!((&bad["picture"], &bad["done"]), (&"bad.png".into(), &false.into()));
    assert_eq!(bad["error"], serde_json::json!({ "about": "bad.png", "what": "the file is empty; give a picture" }));
    assert!(white["notes"].as_array().is_some_and(|notes| !notes.is_empty()), "an empty page without a note: {white}");
    // the verdict is that of the command check, on each sheet
    let sheets = good["sheets"].as_array().expect("sheets");
    assert_eq!(sheets.len(), 2);
    let look = ["convert", "a.png", "--profile", "index-basic-d", "-q", "-o", "look.svg"];
    assert_eq!(place.run(&look).code, 0);
    for (sheet, page) in sheets.iter().zip(["look-1.svg", "look-2.svg"]) {
        let run = place.run(&["check", page, "--format", "json"]);
        let checked: Value = serde_json::from_str(&run.out).expect("JSON");
        for key in ["verdict", "errors", "warnings", "findings"] {
            assert_eq!(sheet[key], checked[key], "{page}: {key}");
        }
        assert_eq!(sheet["title"], Value::Null, "nobody gave it one");
    }
    let titled = ["convert", "a.png", "--title", "A cup", "-q", "-o", "t.svg", "--report", "titled.json"];
    assert_eq!(place.run(&titled).code, 0);
    let titled: Value = report(&place, "titled.json");
    assert_eq!(titled["pictures"][0]["sheets"][0]["title"], "A cup");
    // but for the times it is the same again, whatever the report was before
    place.put("run.json", b"something else");
    assert_eq!(place.run(&args).code, 1);
    assert_eq!(report(&place, "run.json"), first);
}

#[test]
fn a_report_has_a_place_of_its_own() {
    let place = Place::with_picture("a.png");
    for name in ["a.png", "a.svg", "./a.svg.preview.png"] {
        let line = format!("--report {name}: a picture or a page has this name; choose another one");
        place.refuses(&["convert", "a.png", "--preview", "png", "--report", name], 2, &[&line]);
    }
    let line = "--report -: the page goes to standard output already; name a file for one of them";
    place.refuses(&["convert", "a.png", "-o", "-", "--report", "-"], 2, &[line]);
    let line =
        "none/run.json: the report cannot be written here, as the directory is missing; make it, or use --out-dir";
    place.refuses(&["convert", "a.png", "--report", "none/run.json"], 1, &[line]);
    assert_eq!(place.names(), ["a.png"], "the work was done all the same");
    let run = place.run(&["convert", "a.png", "--out-dir", "new", "--report", "-", "-q"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let report: Value = serde_json::from_str(&run.out).expect("JSON");
    assert_eq!(
        report["pictures"][0]["outputs"][0].as_str().map(|name| name.replace('\\', "/")),
        Some("new/a.svg".into())
    );
}

/// All labels that are not on the page are in the report, also those that a message has no room for.
#[test]
fn all_labels_that_are_left_out_are_in_the_report() {
    let place = Place::with_picture("a.png");
    let labels: String = (0..400).map(|i| format!("50%,50%,many words {i}\n")).collect();
    place.put("labels.csv", labels.as_bytes());
    let run = place.run(&["convert", "a.png", "--labels", "labels.csv", "--report", "run.json"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.err.contains("more"), "{}", run.err);
    let report = report(&place, "run.json");
    let left_out = report["pictures"][0]["labels_left_out"].as_array().expect("a list").clone();
    let texts = |why: &str| -> usize {
        let of = left_out.iter().filter(|of| of["why"].as_str().is_some_and(|reason| reason.contains(why)));
        of.filter_map(|of| of["texts"].as_array()).map(Vec::len).sum()
    };
    assert_eq!(texts("300 labels at most"), 100, "{left_out:?}");
    assert!(texts("no room") > 12, "{left_out:?}");
}
