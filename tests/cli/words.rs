//! What the program tells, and how it teaches.

use std::fs;

use crate::cli::common::*;

#[test]
fn timings_are_told_for_every_stage() {
    let place = Place::with_picture("a.png");
    let run = place.run(&["convert", "a.png", "--quiet", "--timings", "--set", "figure.textures=false"]);
    assert_eq!((run.code, run.out.as_str()), (0, ""));
    let mut lines = run.err.lines();
    assert_eq!(lines.next(), Some("timings of a.png:"));
    let rows = lines.map(|line| line.split_whitespace().collect::<Vec<_>>()).collect::<Vec<_>>();
    // what ran side by side has a row where there are threads for it, and what is no stage where it takes a while
    let is_stage = |name: &&str| !["together", "other"].contains(name);
    let stages = rows.iter().map(|row| row[0]).filter(is_stage).collect::<Vec<_>>();
    let mut sorted = stages.clone();
    sorted.sort_unstable();
    let all = [
        "classes", "decode", "edges", "lines", "overview", "page", "read", "regions", "text", "textures", "total",
        "write",
    ];
    assert_eq!(sorted, all, "{}", run.err);
    assert_eq!((stages[0], stages[11]), ("read", "total"));
    let is_time = |ms: &str| ms.parse::<f64>().is_ok_and(|ms| (0.0..60_000.0).contains(&ms));
    for row in &rows {
        match row[..] {
            [_, "skipped:", ..] => assert!(row.len() > 2, "no reason: {row:?}"),
            [_, ms, "ms"] | [_, ms, "ms", "side", "by", "side"] => assert!(is_time(ms), "{row:?}"),
            [_, ms, "ms", worked, "ms", "CPU"] => assert!(is_time(ms) && is_time(worked), "{row:?}"),
            _ => panic!("neither a time nor a reason: {row:?}"),
        }
    }
    let total = rows.last().expect("a total");
    assert_eq!(total.last(), Some(&if cfg!(unix) { "CPU" } else { "ms" }), "{total:?}");
    let textures = rows.iter().find(|row| row[0] == "textures").expect("textures");
    assert_eq!(textures[1], "skipped:", "{}", run.err);
}

#[test]
fn print_stands_beside_the_braille_where_it_is_asked_for() {
    let place = Place::new();
    place.put("bars.svg", &crate::common::samples::read("bars.svg"));
    place.put("labels.csv", b"10%,10%,Rain\n");
    let args = |more: &[&'static str]| {
        let all =
            ["convert", "bars.svg", "--title", "Regen & Schnee", "--lang", "de", "--labels", "labels.csv", "--force"];
        [&all[..], more].concat()
    };
    let done = |more: &[&'static str]| {
        let run = place.run(&args(more));
        assert_eq!(run.code, 0, "{}", run.err);
        run.err
    };
    done(&["-o", "plain.svg"]);
    done(&["--set", "braille.print=true", "-o", "print.svg"]);
    let (plain, print) = (place.text("plain.svg"), place.text("print.svg"));
    assert!(!plain.contains("print-words") && !plain.contains("<text"));
    assert!(print.contains("fill=\"#c4c4c4\"") && print.matches("<text").count() == 2, "{print}");
    assert!(print.contains("Regen &amp; Schnee\n</text>") && print.contains("Rain\n</text>"));
    // it is read as it was, saved by another program or not, and is no fault
    let run = place.run(&["render", "print.svg", "-o", "again.svg"]);
    assert!(run.code == 0 && !run.err.contains("note"), "{}", run.err);
    assert_eq!(place.text("again.svg"), print);
    let style = "<g style=\"fill:#c4c4c4;stroke:none\" fill=\"#c4c4c4\"";
    place.put("saved.svg", print.replace("<g aria-hidden=\"true\" fill=\"#c4c4c4\"", style).as_bytes());
    let run = place.run(&["render", "saved.svg", "-o", "saved-again.svg"]);
    assert!(run.code == 0 && place.text("saved-again.svg") == print, "{}", run.err);
    for page in ["print.svg", "saved.svg"] {
        let run = place.run(&["check", page]);
        assert!(run.code == 0 && !run.out.contains("letters") && !run.out.contains("black-only"), "{}", run.out);
    }
    // darker than that, it would rise
    place.put("dark.svg", print.replace("#c4c4c4", "#444444").as_bytes());
    let run = place.run(&["check", "dark.svg"]);
    assert!(run.code == 1 && run.out.contains("\"Rain\" is written in letters"), "{}", run.out);
    // in a PDF in a font that viewers have; in a PNG where there are fonts
    done(&["--set", "braille.print=true", "-o", "print.pdf"]);
    let pdf = fs::read(place.path("print.pdf")).expect("it is there");
    let has = |what: &[u8]| pdf.windows(what.len()).any(|part| part == what);
    assert!(has(b"/BaseFont/Helvetica") && !has(b"pdfuaid:part"));
    done(&["-o", "plain.pdf"]);
    let pdf = fs::read(place.path("plain.pdf")).expect("it is there");
    let has = |what: &[u8]| pdf.windows(what.len()).any(|part| part == what);
    assert!(has(b"pdfuaid:part"), "its words are not seen");
    done(&["--set", "braille.print=true", "-o", "print.png"]);
    // dots print no letters
    let told = done(&["--set", "braille.print=true", "--profile", "index-basic-d", "--no-overview", "-o", "dots.svg"]);
    assert!(told.contains("braille.print does not count on a page of dots"), "{told}");
    assert!(!place.text("dots.svg").contains("print-words"));
}

#[test]
fn notes_are_told_unless_quiet() {
    let place = Place::new();
    place.put("white.png", &png(60, 60, &[255; 60 * 60 * 3]));
    let run = place.run(&["convert", "white.png"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let (notes, rest): (Vec<_>, Vec<_>) =
        run.err.lines().partition(|line| line.starts_with("tactograph: white.png: note: "));
    assert!(!notes.is_empty(), "an empty page without a word: {}", run.err);
    assert_eq!(rest, ["wrote white.svg"]);
    let quiet = place.run(&["convert", "white.png", "-q"]);
    assert_eq!((quiet.code, quiet.err.as_str()), (0, ""));
}

#[test]
fn a_drawing_with_text_is_converted_with_or_without_fonts() {
    let place = Place::new();
    let text = "<text x=\"5\" y=\"85\" font-family=\"No Such Font\" font-size=\"12\">pond</text></svg>";
    place.put("pond.svg", DRAWING.replace("</svg>", text).as_bytes());
    let run = place.run(&["convert", "pond.svg"]);
    assert_eq!((run.code, run.err.lines().last()), (0, Some("wrote pond.page.svg")), "{}", run.err);
    place.has_page("pond.page.svg");
}

#[cfg(unix)]
#[test]
fn a_strange_name_does_not_break_the_line() {
    let place = Place::with_picture("a\nb\u{1b}[2J.png");
    let run = place.run(&["convert", "a\nb\u{1b}[2J.png"]);
    assert_eq!((run.code, run.err.as_str()), (0, "wrote a b [2J.svg\n"));
    place.has_page("a\nb\u{1b}[2J.svg");
    use std::os::unix::ffi::OsStrExt;
    let name = std::ffi::OsStr::from_bytes(b"caf\xe9.png");
    fs::write(place.path(name), picture()).expect("a file");
    let run = ended(place.command(&["convert"]).arg(name).output().expect("the program starts"));
    assert_eq!((run.code, run.err.as_str()), (0, "wrote caf\u{fffd}.svg\n"));
    let page = place.path(std::ffi::OsStr::from_bytes(b"caf\xe9.svg"));
    assert_is_page(&fs::read_to_string(page).expect("the page"), "the page");
}

#[test]
fn help_teaches_every_option() {
    let place = Place::new();
    for args in [&["--help"][..], &["-h"], &["convert", "-h"], &["profiles", "--help"], &["profiles", "show", "-h"]] {
        let run = place.run(args);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{args:?}");
        assert!(run.out.contains("Usage: tactograph"), "{args:?}");
        assert!(!run.out.contains('\u{1b}'), "{args:?}: colours without a terminal");
    }
    let help = place.run(&["convert", "--help"]).out;
    let limits = tactograph::internals::raster::decode::Limits::default();
    let (megapixels, memory) = (limits.megapixels.to_string(), limits.memory_mb.to_string());
    let defaults = [
        ("-o, --output <PAGE>", "the picture's name with the ending of the format, beside the picture"),
        ("--out-dir <DIR>", "each page lies beside its picture"),
        ("--format <FORMAT>", "svg"),
        ("--dpi <N>", "300"),
        ("--title <TEXT>", "the picture's file name"),
        ("--alt <TEXT>", "what \"tactograph describe\" says of the page"),
        ("--profile <NAME|FILE.toml>", "swell-a4"),
        ("--max-megapixels <N>", &megapixels),
        ("--max-memory <MB>", &memory),
    ];
    for (option, default) in defaults {
        let (_, about) = help.split_once(option).unwrap_or_else(|| panic!("{option} is not in the help"));
        let (_, rest) = about.split_once("[default: ").unwrap_or_else(|| panic!("{option} has no default"));
        assert!(rest.starts_with(&format!("{default}]")), "{option}: {rest:.60}");
    }
    for word in ["--set <KEY=VALUE>", "--timings", "-q, --quiet", "Examples:", "Exit codes:", "Range: 1 to 1000000"] {
        assert!(help.contains(word), "{word} is not in the help");
    }
    for (topic, at_most) in [("convert", 35), ("profiles", 20)] {
        let lines = place.run(&[topic, "-h"]).out.lines().count();
        assert!(lines <= at_most, "{topic} -h has {lines} lines: no short help");
    }
}

#[test]
fn the_version_is_told() {
    let run = Place::new().run(&["--version"]);
    let expected = format!("tactograph {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!((run.code, run.out, run.err.as_str()), (0, expected, ""));
}

#[test]
fn wrong_usage_is_one_line_and_nothing_is_done() {
    let place = Place::with_picture("a.png");
    let cases: [(&[&str], &str); 9] = [
        (&["convert"], "name a picture to convert; see tactograph convert --help"),
        (&["a.png"], "there is no command a.png, did you mean: tactograph convert a.png; see tactograph --help"),
        (
            &["profiles", "swell-a4"],
            "there is no command profiles swell-a4, did you mean: tactograph profiles show swell-a4; see tactograph \
             profiles --help",
        ),
        (
            &["convert", "a.png", "--qiet"],
            "unexpected argument '--qiet' found; tip: a similar argument exists: '--quiet'; see tactograph convert --help",
        ),
        (
            &["convrt", "a.png"],
            "unrecognized subcommand 'convrt'; tip: a similar subcommand exists: 'convert'; see tactograph --help",
        ),
        (&["--nonsense"], "unexpected argument '--nonsense' found; see tactograph --help"),
        (
            &["convert", "a.png", "--set"],
            "a value is required for '--set <KEY=VALUE>' but none was supplied; see tactograph convert --help",
        ),
        (
            &["convert", "a.png", "-o", "b.svg", "-o", "c.svg"],
            "the argument '--output <PAGE>' cannot be used multiple times; see tactograph convert --help",
        ),
        (
            &["profiles", "show"],
            "name a profile to show (tactograph profiles lists them), or a .toml file of your own; see tactograph profiles --help",
        ),
    ];
    for (args, line) in cases {
        place.refuses(args, 2, &[line]);
    }
    let run = place.run(&[]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(run.err.contains("Usage: tactograph"), "no help: {}", run.err);
    assert_eq!(place.names(), ["a.png"]);
}
