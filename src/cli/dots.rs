//! Which format of dots goes with which profile.

use tactograph::{DotFormat, Embossing as Numbers, Error, Format, Profile};

use super::args::Embossing;

impl Embossing {
    /// What these options say together; each not given is as usual.
    ///
    /// # Errors
    /// If a number is out of its range.
    pub(super) fn numbers(&self) -> Result<Numbers, Error> {
        let usual = Numbers::default();
        Numbers::new(self.copies.unwrap_or(usual.copies()), self.impact.unwrap_or(usual.impact()))
    }
}

/// Everything in which a format does not go with a profile, and what goes instead.
pub(super) fn faults(format: Format, profile: &Profile, embossing: &Embossing) -> Vec<String> {
    let mut faults = Vec::new();
    for (option, given) in [("--copies", embossing.copies.is_some()), ("--impact", embossing.impact.is_some())] {
        if given && format != Format::Dots(DotFormat::Idx) {
            faults.push(format!("{option} is for Index embossers; leave it out, or give a name that ends in .idx"));
        }
    }
    let Format::Dots(format) = format else { return faults };
    match profile.dots.device {
        None => faults.push(format!(
            "{} holds dots, and the profile {} is for printing; take one for dots, such as --profile {}",
            format.name().to_uppercase(),
            profile.name,
            format.example_profile()
        )),
        Some(device) => match format.check(device) {
            Err(why) => faults.push(why.to_string()),
            Ok(()) if format == DotFormat::Idx => {
                faults.extend(embossing.numbers().err().map(|why| why.to_string()));
            }
            Ok(()) => {}
        },
    }
    faults
}
