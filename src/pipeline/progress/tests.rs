//! Tests of `progress`.

use super::*;

#[test]
fn the_share_that_is_done_only_grows() {
    use Event::{Begin, End, Skip};
    use Stage::{Classes, Decode, Edges, Lines, Overview, Page, Regions, Text, Textures};
    let photograph = [
        (Begin(Decode), End(Decode)),
        (Begin(Text), End(Text)),
        (Begin(Edges), End(Edges)),
        (Begin(Regions), End(Regions)),
        (Begin(Edges), End(Edges)),
        (Begin(Regions), End(Regions)),
        (Begin(Lines), Skip(Overview, "it is off")),
        (Begin(Classes), End(Classes)),
        (End(Lines), Begin(Textures)),
        (End(Textures), Begin(Page)),
    ];
    let mut progress = Progress::until(Page);
    let events = photograph.iter().flat_map(|(one, two)| [*one, *two]).chain([End(Page)]);
    let shares: Vec<f32> = events.map(|event| progress.after(event)).collect();
    assert!(shares.is_sorted(), "{shares:?}");
    assert_eq!(shares.first(), Some(&0.0));
    assert!(shares.last().is_some_and(|share| (share - 1.0).abs() < 1e-6), "{shares:?}");
    let drawing = [
        Begin(Decode),
        End(Decode),
        Skip(Text, "no paths are letters"),
        Skip(Regions, "the picture is a drawing"),
        Begin(Edges),
        End(Edges),
        Begin(Page),
        End(Page),
    ];
    let mut progress = Progress::until(Page);
    let shares = drawing.map(|event| progress.after(event));
    let after_skips = (COST[Decode as usize] + COST[Text as usize] + COST[Regions as usize]) / COST.iter().sum::<f32>();
    assert!(shares.is_sorted() && (shares[3] - after_skips).abs() < 1e-6, "{shares:?}");
    assert!((shares[7] - 1.0).abs() < 1e-6, "{shares:?}");
    // of contours alone, the rest is no work
    let mut progress = Progress::until(Regions);
    assert!(progress.after(Begin(Edges)) > 0.5);
}
