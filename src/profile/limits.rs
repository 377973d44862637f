//! What a profile's pages must keep.

use super::keys::Profile;
use super::plan::Plan;
use crate::legibility::{Limits, MediumLimits};
use crate::page::MediumParams;

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
