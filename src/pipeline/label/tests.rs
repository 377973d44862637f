//! Tests of `label`.

use super::*;

fn percent(number: f64) -> Position {
    Position::percent(number).expect("a number")
}

fn pixels(number: f64) -> Position {
    Position::pixels(number).expect("a number")
}

#[test]
fn rows_are_labels() {
    let text = "\u{feff}x,y,text\r\n10%,20 %,apple\n\n 412.5 ; 7;\"a \"\"big\"\", red pear\"\n5\t6\tplum, ripe\n";
    let labels = Label::from_csv(text).expect("labels");
    let label = |x, y, text: &str| Label { x, y, text: text.to_owned() };
    let expected = [
        label(percent(10.0), percent(20.0), "apple"),
        label(pixels(412.5), pixels(7.0), "a \"big\", red pear"),
        label(pixels(5.0), pixels(6.0), "plum, ripe"),
    ];
    assert_eq!(labels, expected);
}

#[test]
fn positions_read_back_as_they_are_written() {
    for text in ["30%", "0.5%", "412.5", "-7"] {
        assert_eq!(text.parse::<Position>().map(|position| position.to_string()), Ok(text.to_owned()));
    }
    assert_eq!(" 30 % ".parse(), Ok(percent(30.0)));
    assert_eq!("412.5 px".parse(), Ok(pixels(412.5)));
    assert_eq!("12mm".parse::<Position>(), Err(Error::NotAPosition));
}

#[test]
fn numbers_may_have_decimal_commas() {
    let labels = Label::from_csv("30,5%;40,25;Kiwi\n7\t1,5\tplum\n10%,20%,apple; red\n").expect("labels");
    let label = |x, y, text: &str| Label { x, y, text: text.to_owned() };
    let expected = [
        label(percent(30.5), pixels(40.25), "Kiwi"),
        label(pixels(7.0), pixels(1.5), "plum"),
        label(percent(10.0), percent(20.0), "apple; red"),
    ];
    assert_eq!(labels, expected);
}

/// A quoted number is one column whatever stands in it; where a comma may be one of a number, the row is refused.
#[test]
fn columns_may_stand_in_quotation_marks() {
    let labels = Label::from_csv("\"12,5%\",30%,sun\n\"7,5\" ; \"3%\";\"a; b\"\n\"1\",2,\"ten \"\"x\"\"\"\n");
    let label = |x, y, text: &str| Label { x, y, text: text.to_owned() };
    let expected = [
        label(percent(12.5), percent(30.0), "sun"),
        label(pixels(7.5), percent(3.0), "a; b"),
        label(pixels(1.0), pixels(2.0), "ten \"x\""),
    ];
    assert_eq!(labels, Ok(expected.into()));
    let refused = Label::from_csv("1,2,3 m\n12,5%,30%,sun\n12,5%,20,5%,cup\n1,2,\"two\nlines\"\n1,5%,7,40% rain\n");
    let Err(Error::NotLabels(faults)) = refused else { panic!("{refused:?}") };
    let more = "there are more columns";
    let begin = [(2, more), (3, more), (4, "the quotation mark"), (5, "write x, y"), (6, more)]
        .map(|(line, what)| format!("line {line}: {what}"));
    assert_eq!(faults.len(), begin.len(), "{faults:?}");
    assert!(faults.iter().zip(&begin).all(|(fault, begin)| fault.starts_with(begin)), "{faults:?}");
}

#[test]
fn every_fault_has_its_line() {
    let refused = Label::from_csv("10%,20%,a\nx,2,b\n1,2\n1,NaN,c\n1,2, \n");
    let Err(Error::NotLabels(faults)) = refused else { panic!("{refused:?}") };
    let at_line: Vec<&str> = faults.iter().filter_map(|fault| fault.split(':').next()).collect();
    assert_eq!(at_line, ["line 2", "line 3", "line 4", "line 5"], "{faults:?}");
    assert_eq!(faults[0], "line 2: x must be a number of pixels or a percentage such as 30%, not \"x\"");
}

#[test]
fn positions_are_shares_of_the_figure() {
    let place = MmRect::new(MmPoint::new(10.0, 20.0), MmPoint::new(110.0, 70.0));
    let at = |x, y| Label { x, y, text: "a".into() }.on(place, Size::new(400, 200));
    assert_eq!(at(percent(50.0), pixels(100.0)), Some(MmPoint::new(60.0, 45.0)));
    assert_eq!(at(percent(101.0), pixels(100.0)), None);
}
