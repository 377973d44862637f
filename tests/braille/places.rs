//! Where labels must not stand: in another cell or sector than their text, or on a leader line of the drawing.

use super::labels::place;
use super::worksheets::{drawn, notes, svg};
use tactograph::marks::BrailleText;
use tactograph::medium::Medium;
use tactograph::{Drawing, MmPoint, MmRect, Reason};

const PROFILES: [&str; 3] = ["swell-a4", "index-basic-d", "braillerap"];

fn label<'d>(drawing: &'d Drawing, text: &str) -> Option<&'d BrailleText> {
    drawing.page.braille.iter().find(|label| label.text == text)
}

/// Where the middle of a label lies in the drawing, px, of so many across.
fn middle(drawing: &Drawing, label: &BrailleText, width: f32) -> MmPoint {
    let (figure, middle) = (drawing.page.figure.place, place(label).center());
    ((middle - figure.min) * (width / figure.width())).to_point()
}

/// Each word of a table stands in its own cell, and is not abbreviated because another one has no room in its.
#[test]
fn words_of_a_table_stand_each_for_itself() {
    let rows = [["Land", "Capital", "People"], ["Peru", "Lima", "33,000,000"], ["Mali", "Bamako", "22,000,000"]];
    let mut marks = "<path d='M20 20H620V260H20ZM20 100H620M20 180H620M220 20V260M420 20V260' fill='none' \
        stroke='#000' stroke-width='2'/>"
        .to_owned();
    for (y, row) in rows.iter().enumerate() {
        for (x, text) in row.iter().enumerate() {
            let (x, y) = (120 + 200 * x, 66 + 80 * y);
            marks += &format!("<text x='{x}' y='{y}' text-anchor='middle'>{text}</text>");
        }
    }
    let drawing = drawn(&svg([640.0, 280.0], &marks), "swell-a4");
    for (y, row) in rows.iter().enumerate() {
        for (x, text) in row.iter().enumerate().filter(|(_, text)| text.chars().all(char::is_alphabetic)) {
            let label = label(&drawing, text).unwrap_or_else(|| panic!("{text} is not there"));
            assert_eq!(label.abbreviation, None, "{text}: {}", notes(&drawing));
            let at = middle(&drawing, label, 640.0);
            let cell = ((at.x - 20.0) / 200.0, (at.y - 20.0) / 80.0);
            assert_eq!((cell.0 as usize, cell.1 as usize), (x, y), "{text}: {at:?}");
        }
    }
    // a number that is too long for its cell is in the key
    let key: Vec<&str> = drawing.key.iter().flat_map(|page| &page.braille).map(|text| text.text.as_str()).collect();
    for (row, number) in [(1, "33,000,000"), (2, "22,000,000")] {
        let label = label(&drawing, number).unwrap_or_else(|| panic!("no {number}: {}", notes(&drawing)));
        let at = middle(&drawing, label, 640.0);
        assert_eq!((((at.x - 20.0) / 200.0) as usize, ((at.y - 20.0) / 80.0) as usize), (2, row), "{number}: {at:?}");
        let is_in_key = key.iter().any(|text| text.ends_with(number));
        assert_eq!(label.abbreviation.is_some(), is_in_key, "{number}: {key:?}");
    }
}

/// Its rows are 13 mm high beside the overview, in which braille has no room.
#[test]
fn a_table_has_no_overview_where_its_words_need_the_room() {
    let rows = [
        ["Planet", "Moons", "Days", "Kind"],
        ["Mercury", "0", "88", "rock"],
        ["Venus", "0", "225", "rock"],
        ["Earth", "1", "365", "rock"],
        ["Jupiter", "95", "4333", "gas"],
        ["Saturn", "146", "10759", "gas"],
    ];
    let mut marks = "<path d='M60 60H740V420H60ZM60 120H740M60 180H740M60 240H740M60 300H740M60 360H740M240 60V420\
        M400 60V420M560 60V420' fill='none' stroke='#555' stroke-width='1.2'/>"
        .to_owned();
    for (row, words) in rows.iter().enumerate() {
        for (x, word) in [150, 320, 480, 650].into_iter().zip(words) {
            let y = 97 + 60 * row;
            marks += &format!("<text x='{x}' y='{y}' font-size='20' text-anchor='middle'>{word}</text>");
        }
    }
    let drawing = drawn(&svg([800.0, 480.0], &marks), "swell-a4");
    assert!(drawing.page.overview.is_none(), "{}", notes(&drawing));
    assert!(drawing.notes.iter().any(|note| note.reason() == Some(Reason::OverviewForWords)), "{}", notes(&drawing));
    for word in rows.into_iter().flatten() {
        assert!(label(&drawing, word).is_some(), "{word}: {}", notes(&drawing));
    }
}

/// The share of a sector stands in that sector or beside the pie, never in another sector.
#[test]
fn a_share_stands_in_no_other_sector() {
    let shares = [30.0_f32, 30.0, 20.0, 14.0, 6.0];
    let colours = ["#2266cc", "#22aa33", "#eecc22", "#cc2222", "#888888"];
    let (centre, radius) = (MmPoint::new(260.0, 240.0), 160.0_f32);
    let on = |share: f32, far: f32| {
        let (sin, cos) = (share * 0.02 * std::f32::consts::PI).sin_cos();
        MmPoint::new(centre.x + far * sin, centre.y - far * cos)
    };
    let (mut marks, mut begin) = (String::new(), 0.0);
    for (share, colour) in shares.iter().zip(colours) {
        let (a, b, text) = (on(begin, radius), on(begin + share, radius), on(begin + 0.5 * share, 0.65 * radius));
        marks += &format!(
            "<path d='M{} {}L{} {}A160 160 0 0 1 {} {}Z' fill='{colour}' stroke='#fff' stroke-width='2'/>\
             <text x='{}' y='{}' font-size='14' text-anchor='middle'>{share} %</text>",
            centre.x, centre.y, a.x, a.y, b.x, b.y, text.x, text.y
        );
        begin += share;
    }
    for profile in PROFILES {
        let drawing = drawn(&svg([520.0, 450.0], &marks), profile);
        assert!(drawing.page.braille.len() >= 3, "{profile}: {}", notes(&drawing));
        let mut begin = 0.0;
        for (number, share) in shares.iter().enumerate() {
            let text = format!("{share} %");
            let own = begin..begin + share;
            begin += share;
            // both of the first two say the same
            for label in drawing.page.braille.iter().filter(|label| number > 1 && label.text == text) {
                let off = middle(&drawing, label, 520.0) - centre;
                let at = (off.x.atan2(-off.y) / std::f32::consts::TAU * 100.0).rem_euclid(100.0);
                assert!(off.length() > radius || own.contains(&at), "{profile}: {text} stands at {at} %");
            }
        }
    }
}

/// The names around a pie, with their shares, stand each before its own sector, or have a leader line that ends at it:
/// in braille they are longer, and would be pushed before the next one.
#[test]
fn a_name_beside_a_pie_stands_before_its_own_sector() {
    // where each begins on the circle, px, and its text: its place and which of its ends lies there
    let sectors = [
        ("Bus 45%", 45.0_f32, "#1f77b4", [220.0_f32, 40.0], [422.0, 188.0], "start"),
        ("Walk 25%", 25.0, "#ff7f0e", [275.6, 391.2], [127.0, 403.0], "end"),
        ("Bicycle 20%", 20.0, "#2ca02c", [48.8, 275.6], [25.0, 157.0], "end"),
        ("Car 7%", 7.0, "#d62728", [114.2, 74.4], [139.0, 32.0], "end"),
        ("Other 3%", 3.0, "#9467bd", [186.3, 43.2], [201.0, 16.0], "end"),
    ];
    let mut marks = String::new();
    for (number, (text, _, colour, [x, y], [text_x, text_y], end)) in sectors.iter().enumerate() {
        let [to_x, to_y] = sectors[(number + 1) % sectors.len()].3;
        marks += &format!(
            "<path d='M220 220L{x} {y}A180 180 0 0 1 {to_x} {to_y}Z' fill='{colour}' stroke='#fff' stroke-width='2'/>\
             <text x='{text_x}' y='{text_y}' text-anchor='{end}' font-size='16'>{text}</text>"
        );
    }
    let centre = MmPoint::new(220.0, 220.0);
    let share_at = |off: MmPoint| {
        let off = off - centre;
        (off.x.atan2(-off.y) / std::f32::consts::TAU * 100.0).rem_euclid(100.0)
    };
    for profile in PROFILES {
        let drawing = drawn(&svg([520.0, 440.0], &marks), profile);
        let figure = drawing.page.figure.place;
        let in_drawing = |at: MmPoint| ((at - figure.min) * (520.0 / figure.width())).to_point();
        let (mut begin, mut count) = (0.0, 0);
        for (text, share, ..) in sectors {
            let middle_of_own = begin + 0.5 * share;
            begin += share;
            let Some(label) = label(&drawing, text) else { continue };
            count += 1;
            let tip = label.leader.as_ref().and_then(|leader| leader.points.last().copied());
            let at = share_at(in_drawing(tip.unwrap_or(place(label).center())));
            let off = (at - middle_of_own + 50.0).rem_euclid(100.0) - 50.0;
            // an outline may lie a little aside
            assert!(off.abs() <= 0.5 * share + 1.01, "{profile}: {text} stands at {at} %, led: {}", tip.is_some());
        }
        assert!(count >= 4, "{profile}: {}", notes(&drawing));
    }
}

/// The name of a land that a river parts has no room in full on either side of it: it stands abbreviated in the land,
/// and not in the sea around it, where it would be a name of that.
#[test]
fn the_name_of_a_land_stands_in_no_sea() {
    let lands = [
        ("Norland", vec![[60.0, 60.0], [330.0, 40.0], [350.0, 150.0], [300.0, 260.0], [180.0, 300.0], [90.0, 230.0]]),
        (
            "Sudania",
            vec![[180.0, 300.0], [300.0, 260.0], [430.0, 250.0], [460.0, 340.0], [380.0, 450.0], [240.0, 440.0]],
        ),
    ];
    let path = |points: &[[f32; 2]]| {
        let points: Vec<String> = points.iter().map(|[x, y]| format!("{x} {y}")).collect();
        format!("<path d='M{}Z' stroke='#333' stroke-width='2' ", points.join("L"))
    };
    let marks = format!(
        "<path d='M0 0H700V520H0Z' fill='#9ecae1'/>{} fill='#a1d99b'/>{} fill='#ef5350'/>\
         <path d='M330 40L620 70L600 220L430 250L300 260L350 150Z' fill='#fdd835' stroke='#333' stroke-width='2'/>\
         <path d='M200 45Q230 150 150 270' fill='none' stroke='#1f4fbf' stroke-width='3'/>\
         <text x='190' y='130' text-anchor='middle' font-size='18'>Norland</text>\
         <text x='330' y='350' text-anchor='middle' font-size='18'>Sudania</text>",
        path(&lands[0].1),
        path(&lands[1].1)
    );
    for profile in PROFILES {
        let drawing = drawn(&svg([700.0, 520.0], &marks), profile);
        for (text, land) in &lands {
            let label = label(&drawing, text).unwrap_or_else(|| panic!("{profile}: no {text}: {}", notes(&drawing)));
            let at = middle(&drawing, label, 700.0);
            // its outline goes round clockwise
            let is_inside = |i: usize| {
                let [[ax, ay], [bx, by]] = [land[i], land[(i + 1) % land.len()]];
                (bx - ax) * (at.y - ay) - (by - ay) * (at.x - ax) > 0.0
            };
            assert!((0..land.len()).all(is_inside), "{profile}: {text} stands at {at:?}");
        }
    }
}

/// Leader lines that lie side by side are no lines of a grid: no label stands on one of them.
#[test]
fn leader_lines_side_by_side_are_whole() {
    let marks = "<path d='M330 620V220' stroke='#282' stroke-width='14'/>\
        <circle cx='330' cy='150' r='70' fill='#f4c020' stroke='#000' stroke-width='3'/>\
        <path d='M332 420C400 340 470 350 520 390C460 450 390 450 332 420Z' fill='#3a3' stroke='#000' stroke-width='3'/>\
        <path d='M20 622H680' stroke='#000' stroke-width='3'/>\
        <g stroke='#000' stroke-width='2'><path d='M400 130H520'/><path d='M337 290H520'/><path d='M480 385L540 360'/></g>\
        <g font-size='22'><text x='526' y='137'>petal</text><text x='526' y='297'>stem</text>\
        <text x='546' y='364'>leaf blade</text></g>";
    for profile in PROFILES {
        let drawing = drawn(&svg([700.0, 700.0], marks), profile);
        let told = notes(&drawing);
        for (text, named) in [("petal", [400.0, 130.0]), ("stem", [337.0, 290.0])] {
            let label = label(&drawing, text).unwrap_or_else(|| panic!("{profile}: no {text}: {told}"));
            let place = place(label);
            let figure = drawing.page.figure.place;
            let named = figure.min + MmPoint::new(named[0], named[1]).to_vector() * (figure.width() / 700.0);
            // where dots are those of letters, it begins beyond the cell beside its label
            let farthest = if matches!(drawing.page.medium, Medium::Dots(_)) { 13.0 } else { 8.0 };
            let leads = |points: &[MmPoint]| {
                let ends = [points[0], points[points.len() - 1]];
                let from_to =
                    |a: usize, b: usize| distance(ends[a], place) < farthest && (ends[b] - named).length() < 8.0;
                from_to(0, 1) || from_to(1, 0)
            };
            let mut runs = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).chain(&label.leader);
            let has = runs.any(|run| run.points.len() > 1 && leads(&run.points));
            let lost = told.lines().find(|line| line.contains("left out: the leader line"));
            let is_told = lost.is_some_and(|line| line.contains(&format!("\"{text}\"")));
            assert!(has || is_told, "{profile}: nothing leads from {text} to its part: {told}");
        }
    }
}

/// From a point to a box, mm.
fn distance(at: MmPoint, place: MmRect) -> f32 {
    (at - at.clamp(place.min, place.max)).length()
}

/// A heading that has no room in its place has no leader line to there.
#[test]
fn a_heading_has_no_leader_line() {
    let bars: String =
        (0..6).map(|bar| format!("<rect x='{}' y='60' width='50' height='330' fill='#24c'/>", 70 + 80 * bar)).collect();
    let marks = format!(
        "<path d='M50 20V390H580' fill='none' stroke='#000' stroke-width='3'/>{bars}\
         <text x='310' y='48' text-anchor='middle'>What everybody in the class likes to eat at noon</text>"
    );
    for profile in PROFILES {
        let drawing = drawn(&svg([600.0, 420.0], &marks), profile);
        assert!(drawing.page.braille.iter().all(|label| label.leader.is_none()), "{profile}: {}", notes(&drawing));
        let heading = "What everybody in the class likes to eat at noon";
        assert!(label(&drawing, heading).is_some() || notes(&drawing).contains(heading), "{profile}");
    }
}
