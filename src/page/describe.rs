//! What is on a page, in words that can be read aloud.

use super::{Class, Figure, Overview};

/// The language of [`describe`] (BCP 47).
pub const LANGUAGE: &str = "en";

/// A description for people who do not see the page: its size, how many contours, the share of each colour (in the order of
/// [`Class::ALL`], 0..=1, the rest is white).
pub fn describe(figure: &Figure, overview: Option<&Overview>, shares: Option<[f32; 5]>) -> String {
    let (width, height) = (figure.place.width().round(), figure.place.height().round());
    let mut text = format!("Tactile graphic, {width} by {height} millimetres, {}.", contours(figure.lines.len()));
    if let Some(shares) = shares {
        text += &colours(shares);
    }
    if let Some(overview) = overview {
        let (width, height) = (overview.place.width().round(), overview.place.height().round());
        let count = contours(overview.lines.len());
        text += &format!(" Below it an overview of lines only, {width} by {height} millimetres, {count}.");
    }
    text
}

fn contours(count: usize) -> String {
    match count {
        0 => "no contours".into(),
        1 => "1 contour".into(),
        _ => format!("{count} contours"),
    }
}

/// The colours, most frequent first, in whole percent.
fn colours(shares: [f32; 5]) -> String {
    let white = 1.0 - shares.iter().sum::<f32>();
    let mut named: Vec<(&str, u32)> = Class::ALL
        .iter()
        .map(|class| class.name())
        .zip(shares)
        .chain([("white", white)])
        .map(|(name, share)| (name, (100.0 * share).round() as u32))
        .filter(|(_, percent)| *percent > 0)
        .collect();
    named.sort_by_key(|(_, percent)| std::cmp::Reverse(*percent));
    let list: Vec<String> = named.iter().map(|(name, percent)| format!("{name} {percent} percent")).collect();
    format!(" Colours: {}.", list.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_named_by_their_share() {
        assert_eq!(
            colours([0.25, 0.0, 0.0, 0.5, 0.004]),
            " Colours: red 50 percent, blue 25 percent, white 25 percent."
        );
    }
}
