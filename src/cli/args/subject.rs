//! Options that say what the picture is about.

use clap::Args;
use tactograph::{Length, Options, Position};

/// Options of `tactograph convert` for what the picture is about.
#[derive(Debug, Args)]
pub(in crate::cli) struct Subject {
    /// Says what the picture is about: a place on it; can be given several times
    ///
    /// How far from the left and from the top of the part that is drawn, in percent (50%,40%) or in pixels of the
    /// picture. The thing around the place that stands out is outlined before all else, in figure and
    /// overview.
    #[arg(long, value_name = "X,Y", value_parser = place, allow_hyphen_values = true, hide_short_help = true)]
    subject: Vec<SubjectPoint>,

    /// Leaves textures and weak lines around the subject out
    #[arg(long, requires = "subject", hide_short_help = true)]
    calm_background: bool,
}

#[derive(Debug, Clone, Copy)]
struct SubjectPoint([Position; 2]);

/// Most subjects: more than that is what a picture has, not what it is about.
const MOST: usize = 8;

impl Subject {
    /// # Errors
    /// That there are too many.
    pub(in crate::cli) fn check(&self) -> Result<(), String> {
        match self.subject.len() {
            count if count > MOST => Err(format!("--subject: there are {count}; give at most {MOST}")),
            _ => Ok(()),
        }
    }

    /// Puts them into the options of the library.
    pub(in crate::cli) fn add_to(&self, options: Options) -> Options {
        let options = self.subject.iter().fold(options, |options, SubjectPoint([x, y])| options.subject(*x, *y));
        options.calm_background(self.calm_background)
    }
}

fn place(text: &str) -> Result<SubjectPoint, String> {
    let within = |text: &str| {
        let position: Position = text.trim().parse().ok()?;
        let is_within = match position.length() {
            Length::Percent(percent) => (0.0..=100.0).contains(&percent),
            Length::Pixels(at) | Length::Mm(at) => at >= 0.0,
        };
        is_within.then_some(position)
    };
    let wanted = "give how far it is from the left and from the top, such as 50%,40% or, in pixels, 300,220";
    let (x, y) = text.split_once(',').ok_or(wanted)?;
    let (x, y) = (within(x).ok_or(wanted)?, within(y).ok_or(wanted)?);
    let is_percent = |position: Position| matches!(position.length(), Length::Percent(_));
    if is_percent(x) != is_percent(y) {
        return Err(
            "one number is in percent and the other in pixels; give both in percent, such as 50%,40%, or both \
                    in pixels, such as 300,220"
                .to_owned(),
        );
    }
    Ok(SubjectPoint([x, y]))
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn a_place_is_in_percent_or_in_pixels() {
        assert!(place("50%,40%").is_ok() && place("300, 220").is_ok());
        let told = |text: &str| place(text).expect_err("it is refused");
        for mixed in ["40%,20", "40,20%"] {
            assert!(told(mixed).starts_with("one number is in percent and the other in pixels"), "{mixed}");
        }
        for wrong in ["40%", "120%,10%", "-1,5", "a,b"] {
            assert!(told(wrong).starts_with("give how far it is"), "{wrong}");
        }
    }
}
