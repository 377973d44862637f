//! Which format of dots goes with which profile.

use tactograph::{Embossing, Error, Format, Profile};

use super::args::EmbossingOptions;

impl EmbossingOptions {
    /// What these options say together; each not given is as usual.
    ///
    /// # Errors
    /// If a number is out of its range.
    pub(super) fn numbers(&self) -> Result<Embossing, Error> {
        let usual = Embossing::default();
        Embossing::new(self.copies.unwrap_or(usual.copies()), self.impact.unwrap_or(usual.impact()))
    }
}

/// Everything in which a format does not go with a profile, and what goes instead.
pub(super) fn faults(format: Format, profile: &Profile, options: &EmbossingOptions) -> Vec<String> {
    let mut faults = Vec::new();
    let tells_embosser = matches!(format, Format::Dots(dots) if dots.tells_embosser());
    for (option, given) in [("--copies", options.copies.is_some()), ("--impact", options.impact.is_some())] {
        if given && !tells_embosser {
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
            Ok(()) if tells_embosser => faults.extend(options.numbers().err().map(|why| why.to_string())),
            Ok(()) => {}
        },
    }
    faults
}
