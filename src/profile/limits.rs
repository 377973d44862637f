//! What a profile's pages must keep; and the profile of a page, from what the page says of how it was made.

use super::keys::Profile;
use super::plan::Plan;
use super::{built_in, keys};
use crate::legibility::{Limits, MediumLimits};
use crate::page::{MediumParams, Page};

/// The entry of a page's origin that names its profile.
const PROFILE: &str = "profile";

impl Plan {
    /// The numbers that a page of this profile is held against.
    pub fn limits(&self) -> Limits {
        let Profile { page, lines, colours, textures, braille, print, .. } = self.profile();
        let medium = match self.medium() {
            MediumParams::Print(_) => MediumLimits::Print {
                line_width: lines.width_min,
                line_gap: lines.min_gap,
                texture_gap: textures.line_gap,
                glyph: textures.min_glyph,
                max_black: print.max_black,
            },
            MediumParams::Dots { device, pitch } => {
                let line_gap = self.dots_of(device, pitch).line_gap;
                // areas without room for the profile's gap keep one
                let texture_gap = self.profile().dots.texture_gap.round().min(1.0) as u32;
                MediumLimits::Dots { pitch, line_gap, texture_gap }
            }
        };
        Limits {
            margin: page.margin,
            line_length: lines.min_length,
            texture_area: colours.min_area,
            cell: braille.cell,
            medium,
        }
    }
}

impl Profile {
    /// The profile that a page was made with, as the page itself says; of a page that says nothing, the default one.
    ///
    /// # Errors
    /// [`Error::Profile`](crate::Error::Profile) if the page's values do not go together.
    pub fn of_page(page: &Page) -> Result<Self, crate::Error> {
        let value = |name: &str| page.origin.iter().find(|(of, _)| of == name).map(|(_, value)| value.as_str());
        let named = value(PROFILE).and_then(|name| Self::named(name).ok());
        let mut profile = match named {
            Some(profile) => profile,
            None => Self::named(built_in()[0].name)?,
        };
        for key in keys::KEYS {
            if let Some(value) = value(key.path) {
                profile.set(key.path, value)?;
            }
        }
        if let Some(name) = value(PROFILE) {
            name.clone_into(&mut profile.name);
        }
        profile.check()?;
        Ok(profile)
    }
}
