//! What several remarks would say of the same is said once.

use super::{About, Note, Reason};

/// Leaves out remarks that others have in them. Of a page from which all was erased nothing else is told that is not
/// there. Where an overview lacks much of the lines, shapes and areas are among these; and shapes that it leaves out
/// are among the areas that are not closed in it.
pub(super) fn leave_out(notes: &mut Vec<Note>) {
    let is_missing =
        |note: &Note| matches!(note, Note::NotOnPage(..) | Note::TextsLeftOut(_) | Note::LetteringLeftOut { .. });
    if notes.contains(&Note::AllErased) {
        notes.retain(|note| !is_missing(note));
    }
    let is_of_lines = |note: &Note| matches!(note, Note::LinesNotInOverview { .. } | Note::NoRoomForOverview);
    let is_of_areas = |note: &Note| matches!(note, Note::TakenAs(About::Overview, Reason::AreaNotInOverview, _));
    // which of few shapes the overview lacks is news
    let are_few = notes.iter().any(|note| matches!(note, Note::Simplified { .. }));
    let (lacks_lines, lacks_areas) = (!are_few && notes.iter().any(is_of_lines), notes.iter().any(is_of_areas));
    notes.retain(|note| match note {
        Note::ShapesNotInOverview(_) => !lacks_lines && !lacks_areas,
        Note::NotOnPage(About::Overview, Reason::NoRoomInOverview, _)
        | Note::TakenAs(About::Overview, Reason::NoRoomInOverview | Reason::AreaNotInOverview, _) => !lacks_lines,
        _ => true,
    });
}

/// Has only the first of these remarks, which are in their order, say from where its place is counted.
pub(super) fn share_origin(notes: &mut [Note]) {
    let mut is_said = false;
    for note in notes {
        let (Note::NotOnPage(_, _, told) | Note::TakenAs(_, _, told)) = note else { continue };
        if is_said {
            told.leave_origin_out();
        }
        is_said |= told.has_origin();
    }
}

/// Has only the first of these remarks, which are in their order, say that the figure should be larger.
pub(super) fn share_remedy(notes: &mut [Note]) {
    let mut is_said = false;
    for note in notes {
        let (Note::NotOnPage(_, _, told) | Note::TakenAs(_, _, told)) = note else { continue };
        if told.wants_larger() && is_said {
            told.leave_larger_out();
        }
        is_said |= told.wants_larger();
    }
}

#[cfg(test)]
mod tests {
    use super::super::Told;
    use super::*;

    fn missing(told: impl Into<Told>) -> Note {
        Note::NotOnPage(About::Lines, Reason::NoRoomForLine, told.into())
    }

    #[test]
    fn what_makes_the_figure_larger_is_said_once() {
        let no_room = |of: &str| Told::from(format!("{of}: no room"));
        let mut notes = [
            no_room("1 line").or_larger().or("say it in a label"),
            no_room("2 ticks").or("say it in a label"),
            no_room("3 ticks").or_larger().or("draw them longer").or("say it in a label"),
            no_room("4 lines").or_larger().or("say it in a label"),
            no_room("5 shapes").or_larger(),
            no_room("6 textures").or_larger().or_crop().or("say in labels what matters"),
            no_room("7 textures").or_larger().or_crop(),
            no_room("8 outlines").or_larger().or("crop the picture around them"),
        ]
        .map(missing);
        share_remedy(&mut notes);
        let wanted = [
            "1 line: no room; make the figure larger, or say it in a label",
            "2 ticks: no room; say it in a label",
            "3 ticks: no room; draw them longer, or say it in a label",
            "4 lines: no room; say it in a label",
            "5 shapes: no room",
            "6 textures: no room; say in labels what matters",
            "7 textures: no room",
            "8 outlines: no room; crop the picture around them",
        ];
        assert_eq!(notes.map(|note| note.to_string()), wanted.map(|told| format!("left out: {told}")));
    }

    #[test]
    fn from_where_places_are_counted_is_said_once() {
        let at = |place: &str| missing(format!("1 line (9 mm long, around {place})"));
        let mut notes = [
            missing("2 ticks (at 3, 4 mm)"),
            at("20, 30 mm from the left and the top of the sheet"),
            at("20, 40 mm from the left and the top of the sheet"),
            at("20, 50 mm from the left and the top of sheet a2"),
        ];
        let mut wanted = notes.clone();
        wanted[2] = at("20, 40 mm");
        share_origin(&mut notes);
        assert_eq!(notes, wanted);
    }

    #[test]
    fn what_is_missing_is_not_told_of_a_page_from_which_all_was_erased() {
        let all = || vec![missing("a line"), Note::TextsLeftOut(vec!["rain".to_owned()]), Note::UnevenDots];
        let left = |more: Note| {
            let mut notes = all();
            notes.push(more);
            leave_out(&mut notes);
            notes
        };
        assert_eq!(left(Note::AllErased), [Note::UnevenDots, Note::AllErased]);
        assert_eq!(left(Note::EmptyPage).len(), 4);
    }

    #[test]
    fn shapes_of_an_overview_are_among_its_lines_and_areas() {
        let areas = || Note::TakenAs(About::Overview, Reason::AreaNotInOverview, String::new().into());
        let links = || Note::NotOnPage(About::Overview, Reason::NoRoomInOverview, String::new().into());
        let lines = || Note::LinesNotInOverview { percent: 20, place: None };
        let left = |mut notes: Vec<Note>| {
            leave_out(&mut notes);
            notes
        };
        let shapes = Note::ShapesNotInOverview(2);
        assert_eq!(left(vec![shapes.clone(), links()]), [shapes.clone(), links()]);
        assert_eq!(left(vec![shapes.clone(), areas(), links()]), [areas(), links()]);
        assert_eq!(left(vec![shapes, lines(), areas(), links(), missing("a line")]), [lines(), missing("a line")]);
    }
}
