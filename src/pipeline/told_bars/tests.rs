//! Tests of `told_bars`.

use super::*;

#[test]
fn the_overview_tells_only_what_the_figure_does_not() {
    let touching = BarStyle { bars: Bars::Touching, left_out: LeftOut::Gridlines, low: 1, is_at_axis: false, torn: 0 };
    let outline = BarStyle { bars: Bars::Outline, ..touching };
    assert!(told(None, None).is_empty());
    let of_figure = told(Some(touching), None);
    assert_eq!(of_figure.len(), 3, "bars, gridlines, a low bar: {of_figure:?}");
    assert_eq!(told(Some(touching), Some(touching)), of_figure);
    let more_torn = told(Some(touching), Some(BarStyle { torn: 5, ..touching }));
    assert!(more_torn.len() == 4 && more_torn[..3] == of_figure, "{more_torn:?}");
    let of_both = told(Some(touching), Some(outline));
    assert_eq!(of_both[..3], of_figure);
    let about = |note: &Note| match note {
        Note::TakenAs(about, _, told) | Note::NotOnPage(about, _, told) => {
            Some((*about, told.to_string().contains("the overview")))
        }
        _ => None,
    };
    assert!(of_both[3..].iter().all(|note| about(note) == Some((About::Overview, true))), "{of_both:?}");
    assert_eq!(of_both.len(), 4, "the outline alone");
}

#[test]
fn what_of_bars_is_not_drawn_all_the_same_is_told() {
    let torn = BarStyle { torn: 7, ..BarStyle::AS_IT_IS };
    let told = told(None, Some(torn));
    let [Note::NotOnPage(About::Overview, Reason::BarTorn, what)] = &told[..] else { panic!("{told:?}") };
    assert!(what.to_string().contains("in the overview 7 percent"), "{what}");
}
