//! Tests of `titles`.

use super::*;

fn row(line: u64, file: &str, title: Option<&str>, alt: Option<&str>) -> Row {
    Row { line, file: file.into(), title: title.map(str::to_owned), alt: alt.map(str::to_owned) }
}

#[test]
fn tables_are_read_as_programs_write_them() {
    let table = "File|Title|ALT\na.png|\"A cup| red\"|\"One \"\"big\"\" cup\"\n\n||\n b/c.png |\"two\nlines\"\n\n\
                     d.png||a pond\n";
    for parting in [',', ';', '\t'] {
        let expected = [
            row(2, "a.png", Some(&format!("A cup{parting} red")), Some("One \"big\" cup")),
            row(5, "b/c.png", Some("two lines"), None),
            row(8, "d.png", None, Some("a pond")),
        ];
        let table = table.replace('|', &parting.to_string());
        assert_eq!(rows(&table), Ok(expected.to_vec()), "{parting:?}");
        let of_windows = format!("\u{feff}{}", table.replace('\n', "\r\n"));
        assert_eq!(rows(&of_windows), Ok(expected.to_vec()), "{parting:?}");
    }
}

#[test]
fn every_fault_has_its_line() {
    let table = "file,title,alt\na.png,cup\n,pond\nb.png\na.png,cup,again\nc.png,a,b,c\n";
    let faults = rows(table).expect_err("faults");
    let expected = [
        "line 3: there is no name of a file",
        "line 5: a.png has a row already, line 2; keep one",
        "line 6: there are 4 columns, and the heading has 3; put a text that has the sign between columns in it in \
             quotation marks",
    ];
    assert_eq!(faults, expected);
}

#[test]
fn a_heading_must_name_the_columns() {
    for (table, told) in [
        ("", &["line 1: the table is empty; the columns are file, title and alt"][..]),
        ("a.png,cup\n", &["\"a.png\"", "\"cup\"", "no column file;", "no column title;"]),
        ("\nfile;Titel\n", &["line 2: there is no column \"titel\"", "no column title;"]),
        ("file,title,title\n", &["the column title is there twice"]),
    ] {
        let faults = rows(table).expect_err(table);
        assert_eq!(faults.len(), told.len(), "{faults:?}");
        faults.iter().zip(told).for_each(|(fault, told)| assert!(fault.contains(told), "{fault}"));
    }
}

#[test]
fn a_picture_is_found_by_its_path_or_its_name() {
    let rows = vec![
        row(2, "a.png", Some("one"), None),
        row(3, "d/a.png", Some("two"), None),
        row(4, "B.png", Some("b"), None),
    ];
    let titles = Titles { table: "t.csv".into(), rows };
    let title = |picture: &str| titles.of(Path::new(picture)).and_then(|row| row.title.as_deref());
    assert_eq!(
        ["a.png", "x/a.png", "d/a.png", "./d/a.png", "b.png"].map(title),
        [Some("one"), Some("one"), Some("two"), Some("two"), None]
    );
    let pictures = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
    assert_eq!(titles.faults(&pictures(&["a.png", "d/a.png", "a.png"])), [""; 0]);
    let faults = titles.faults(&pictures(&["x/a.png", "y/a.png"]));
    let of_both = "--titles t.csv, line 2: a.png is the name of both x/a.png and y/a.png; write it with its directory";
    assert_eq!(faults, [of_both]);
    let pictures = pictures(&["a.png", "x/b.png"]);
    let notes = [titles.without_words(&pictures), titles.without_picture(&pictures)].concat();
    let note = |place: &str, what: &str| (place.to_owned(), what.to_owned());
    let expected = [
        note("x/b.png", "t.csv has no row for it, so it gets no title from there; line 4 has B.png, in other capitals"),
        note("t.csv, line 3", "no picture that is given is called d/a.png"),
        note("t.csv, line 4", "no picture that is given is called B.png"),
    ];
    assert_eq!(notes, expected);
}

/// One picture without words keeps no others from theirs.
#[test]
fn a_row_without_words_is_told() {
    let rows = rows("file,title,alt\na.png,one,\nb.png\nc.png,,two\n").expect("a table");
    let titles = Titles { table: "t.csv".into(), rows };
    let notes = titles.without_words(&["a.png", "b.png", "c.png"].map(PathBuf::from));
    assert_eq!(notes, [("b.png".to_owned(), "t.csv, line 3 has neither a title nor an alt for it".to_owned())]);
}
