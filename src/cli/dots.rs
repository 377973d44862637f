//! Which format of dots goes with which profile.

use tactograph::{DotFormat, Embossing as Numbers, Error, Format, Profile};

use super::args::Embossing;

impl Embossing {
    /// What these options say together; each not given is as usual.
    pub(super) fn numbers(&self) -> Numbers {
        let usual = Numbers::default();
        Numbers { copies: self.copies.unwrap_or(usual.copies), impact: self.impact.unwrap_or(usual.impact) }
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
        Some(device) => match format.refusal(device) {
            Some(why) => faults.push(why),
            None if format == DotFormat::Idx => {
                let page = &profile.page;
                // as the device has it; profiles may be a hundredth off
                let pitch = device.pitches().find(profile.dots.pitch).unwrap_or(profile.dots.pitch);
                match embossing.numbers().check(device, [page.width, page.height], pitch) {
                    Ok(()) => {}
                    Err(Error::CannotPress(why)) => faults.extend(why),
                    Err(other) => faults.push(other.to_string()),
                }
            }
            None => {}
        },
    }
    faults
}
