//! A drawing whose words are most of it, as a table, has no overview where that takes the room of most of them: a
//! reader of a table seeks its words, and the overview has only its lines. One that was asked for stays.

use super::texts::Text;
use super::told_labels::LabelCounts;
use crate::profile::Plan;
use crate::{About, Error, Note, Reason};

/// So many words are more than one part of a drawing, such as an axis. Chosen by us.
const LEAST: usize = 6;
/// Without the overview at most this share of the words that had no room may lack. Chosen by us: where more lack, both
/// pages lack much, and one has an overview.
const STILL: f32 = 0.25;

/// Whether half of a drawing's own words or more have no room.
pub(super) fn lack(labels: LabelCounts, texts: &[Text]) -> bool {
    is_most(labels.without_room, texts.iter().filter(|text| text.is_read()).count())
}

fn is_most(lost: usize, words: usize) -> bool {
    lost >= LEAST && 2 * lost >= words
}

/// Whether the maker of the page asked for an overview, so that it does not go by itself; the settings have one.
pub(super) fn is_asked(plan: &Plan) -> bool {
    plan.profile().own_place("overview.on").is_some()
}

/// The same settings without an overview.
///
/// # Errors
/// None, as these settings are checked and lack one part.
pub(super) fn plan_without(plan: &Plan) -> Result<Plan, Error> {
    let mut profile = plan.profile().clone();
    profile.set("overview", false)?;
    Plan::new(&profile)
}

/// What is told of a page without its overview, where it has most of the words that one `with` it lacks; none where the
/// latter is as good.
pub(super) fn told(with: LabelCounts, without: LabelCounts) -> Option<Note> {
    let (lost, still) = (with.without_room, without.without_room);
    (still as f32 <= STILL * lost as f32).then(|| {
        let saved = lost - still;
        let told = format!(
            "{saved} words have room only without the overview, so there is none; larger paper or several sheets may \
             have room for both"
        );
        Note::TakenAs(About::Overview, Reason::OverviewForWords, told.into())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Profile;

    #[test]
    fn words_are_most_of_a_table_and_not_of_a_chart() {
        let lost = |without_room: usize| LabelCounts { left_out: 17, without_room, ..LabelCounts::default() };
        let told = |still: usize| told(lost(8), lost(still)).map(|note| note.to_string());
        assert!(told(2).is_some_and(|told| told.starts_with("6 words have room only without the overview")));
        assert_eq!(told(3), None, "both lack much");
        assert_eq!(
            [(24, 24), (12, 24), (11, 24), (5, 5)].map(|(lost, words)| is_most(lost, words)),
            [true, true, false, false]
        );
    }

    #[test]
    fn settings_lose_their_overview() {
        let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("a plan");
        let without = plan_without(&plan).expect("a plan");
        assert!(plan.layout().overview.is_some() && without.layout().overview.is_none());
    }

    #[test]
    fn an_overview_that_was_asked_for_stays() {
        let is_asked = |profile: &Profile| is_asked(&Plan::new(profile).expect("a plan"));
        let mut profile = Profile::named("swell-a4").expect("it is built in");
        profile.set("lines.width_max", 1.2).expect("a width");
        assert!(!is_asked(&profile), "what the built-in profile has is the default");
        profile.set("overview", true).expect("a switch");
        assert!(is_asked(&profile));
        let own = |text: &str| Profile::from_toml(text, "my.toml").expect("it is right");
        assert!(!is_asked(&own("inherits = \"swell-a3\"")));
        assert!(is_asked(&own("inherits = \"swell-a3\"\noverview = true")));
        assert!(!is_asked(&own("inherits = \"swell-a3\"\n[overview]\nscale = 0.4")));
    }
}
