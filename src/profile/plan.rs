//! A checked profile, turned into what each stage asks for: millimetres of the sheet become pixels of the working
//! picture where a stage works in pixels.

use super::keys::Profile;
use crate::Error;
use crate::devices::Device;
use crate::dots::textures::Least;
use crate::legibility::{MediumLimits, RuleLimits};
use crate::lines::PagePart;
use crate::page::{DotMedium, MediumParams, Print, layout};
use crate::textures::Palette;
use crate::{classes, dots, edges, legibility, lines, regions, textures};

/// Cells of mean colour, and how far from an edge they are compared, mm. On photographs of 481 pixels, which have 0.4
/// mm for a pixel on an A4 sheet, 5 and 8 pixels scored best, 2.0 and 3.2 mm. A little less here, which costs about
/// .002 of the score: what is narrower than twice the distance, a tower or a chair's leg, would be looked right
/// through.
const SIDE_CELL: f32 = 1.6;
const SIDE_OFFSET: f32 = 2.4;

/// Strength is averaged along a contour over this far to both sides, mm: less than a fingertip can tell apart.
const STRENGTH_WINDOW: f32 = 1.0;

/// Contours shorter than this share of a line are dropped at once: shorter pieces may still be joined, and only what
/// could never become a line goes there.
const PIECE: f32 = 0.25;
/// Least length of a line by which ticks of a drawing are found for dots, mm: that of swell paper.
const TICKS: f32 = 8.0;

// What joins and what bends is judged of finished marks, whose numbers are rounded, as laxly as of lines that are
// being drawn or more so: otherwise the check would find fault with what was drawn in accord with its stage.
const _: () = assert!(
    legibility::BEND >= lines::BEND
        && legibility::BEND_LEAST >= lines::BEND_LEAST
        && legibility::CORNER >= lines::SHARPEST
        && legibility::STRAIGHTNESS <= lines::STRAIGHTNESS
        && legibility::APPROACH >= lines::APPROACH_OF_DRAWINGS
        && legibility::CLUSTER_APPROACH >= lines::CLUSTER_APPROACH
        && legibility::APART >= lines::APART
        && legibility::RING_CORNER >= lines::CORNER
        && legibility::RING_CORNER_ARMS[0] == lines::CORNER_ARMS[0]
        && legibility::RING_CORNER_ARMS[1] == lines::CORNER_ARMS[1]
        && legibility::SMALL_RING >= lines::LARGEST_HOLLOW
        && allows_all_gaps(10)
        && legibility::GOES_ON <= dots::GOES_ON
        && legibility::STEPS == dots::STEPS
);

/// Whether the check lets lines of dots cross, meet and come back wherever they are drawn so, with gaps of up to so
/// many dots.
const fn allows_all_gaps(most: u32) -> bool {
    most == 0
        || legibility::longest_cut(most) >= dots::longest_cut(most)
            && legibility::longest_approach(most) > dots::longest_approach(most)
            && legibility::least_arc(most) >= dots::least_arc(most)
            && allows_all_gaps(most - 1)
}

/// Side of the cells in which colours are sorted, mm: a third of the distance of two glyphs.
const COLOUR_CELL: f32 = 1.0;

/// Pixels this near to a contour do not count for the colour of an area, mm: what lies there is a mixture of both
/// sides, or a drawn outline, whose own contours lie at its two edges. From 0.3 to 0.9 mm it is nearly the same
/// (`tests/colours/stains.rs`).
const MIXED_WITHIN: f32 = 0.6;

/// Which regions get outlines.
struct Shapes {
    most: usize,
    least_gain: f32,
    most_near: f32,
    /// In distances of two lines, as the next.
    spacing: f32,
    narrowest: f32,
}

/// Numbers that scored best on photographs (`docs/photographs.md`). In an overview two lines are far apart beside the
/// size of things, and what is a little too near gives way ([`lines`]): to forbid it would leave few shapes.
const FIGURE_SHAPES: Shapes = Shapes { most: 8, least_gain: 0.2, most_near: 0.3, spacing: 1.0, narrowest: 1.0 };
const OVERVIEW_SHAPES: Shapes = Shapes { most: 7, least_gain: 0.17, most_near: 0.1, spacing: 0.8, narrowest: 0.7 };

impl Profile {
    /// Distance of dots as the device has it, mm; profiles may be a hundredth off.
    fn pitch(&self, device: &Device) -> f32 {
        device.pitches().find(self.dots.pitch).unwrap_or(self.dots.pitch)
    }

    /// What pages are made for.
    pub(super) fn medium(&self) -> MediumParams {
        match self.dots.device {
            None => MediumParams::Print(Print { swell: self.print.swell, max_black: self.print.max_black }),
            Some(device) => MediumParams::Dots { device, pitch: self.pitch(device) },
        }
    }

    /// What the layout of a page needs.
    pub(super) fn layout(&self) -> layout::Params {
        let Self { page, frame, overview, mark, .. } = self;
        layout::Params {
            sheet: [page.width, page.height],
            orientation: page.orientation,
            margin: page.margin,
            frame: frame.on.then_some(layout::FrameParams {
                width: frame.width,
                dot: frame.dot,
                pitch: frame.pitch,
                gap: frame.gap,
            }),
            overview: overview.on.then_some(layout::OverviewParams { scale: overview.scale, gap: overview.gap }),
            mark: mark.on.then_some(layout::MarkParams { length: mark.length, width: mark.width, gap: mark.gap }),
            heading: None,
            medium: self.medium(),
        }
    }
}

/// A profile that has been found to make sense. Everything after trusts its numbers.
#[derive(Debug, Clone)]
pub struct Plan {
    profile: Profile,
}

impl Plan {
    /// Checks a profile as a whole.
    ///
    /// # Errors
    /// [`Error::Profile`] with every fault, each with the place where its number comes from.
    pub fn new(profile: &Profile) -> Result<Self, Error> {
        profile.check()?;
        Ok(Self { profile: profile.clone() })
    }

    /// The profile.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// What pages are made for.
    pub fn medium(&self) -> MediumParams {
        self.profile.medium()
    }

    /// How a page is laid out.
    pub fn layout(&self) -> layout::Params {
        self.profile.layout()
    }

    /// How contours are found in a picture of so many pixels for a millimetre of the page.
    pub fn edges(&self, px_per_mm: f32) -> edges::Params {
        let Profile { edges, lines, .. } = &self.profile;
        edges::Params {
            // Below one pixel a Gaussian derivative sees the grid rather than the picture.
            sigma: (edges.scale * px_per_mm).max(1.0),
            low: edges.low,
            high: edges.high,
            min_length: PIECE * lines.min_length * px_per_mm,
            min_length_of_drawing: PIECE * self.shortest_of_drawing() * px_per_mm,
            strength_window: STRENGTH_WINDOW * px_per_mm,
            suppression: edges.texture_suppression,
            side_cell: SIDE_CELL * px_per_mm,
            side_offset: SIDE_OFFSET * px_per_mm,
            // two lines nearer than this could not both be drawn
            widest_stroke: self.lines().max_spacing() * px_per_mm,
            dark_lines: None,
        }
    }

    /// Length from which on lines of a drawing are found, mm: ticks of dots are shorter than lines of dots.
    fn shortest_of_drawing(&self) -> f32 {
        let least = self.profile.lines.min_length;
        match self.medium() {
            MediumParams::Print(_) => least,
            MediumParams::Dots { .. } => least.min(TICKS),
        }
    }

    /// How lines are drawn.
    pub fn lines(&self) -> lines::Params {
        let Profile { edges, lines, .. } = &self.profile;
        let [width_min, width_max, min_gap] = match self.medium() {
            MediumParams::Print(_) => [lines.width_min, lines.width_max, lines.min_gap],
            MediumParams::Dots { device, pitch } => {
                let dots = self.dots_of(device, pitch);
                [dots.diameter, dots.diameter, dots.centres() - dots.diameter]
            }
        };
        lines::Params {
            width_min,
            width_max,
            least_strength: edges.low,
            full_strength: lines.full_strength,
            min_length: lines.min_length,
            min_gap,
            join_gap: lines.join_gap,
            gap_scale: 1.0,
            smoothing: lines.smoothing,
            tolerance: lines.tolerance,
            detail: lines.detail,
            most_shapes: (lines.shapes > 0).then_some(lines.shapes),
            part: PagePart::Figure,
            whole_rings: false,
            of_drawing: false,
            widen_bars: false,
            medium: self.heavy_strokes().map_or(lines::LineMedium::Print, lines::LineMedium::Dots),
            takes_points: true,
        }
    }

    /// How fine the regions of a photograph are, of which some are outlined; none where none is.
    pub fn region_detail(&self) -> Option<regions::Detail> {
        self.profile.lines.regions.then_some(regions::Detail::OUTLINES)
    }

    /// Which regions get an outline in a part of the page.
    pub fn regions(&self, part: PagePart) -> regions::Params {
        let lines = self.lines();
        let Shapes { most, least_gain, most_near, spacing, narrowest } = match part {
            PagePart::Figure => FIGURE_SHAPES,
            PagePart::Overview => OVERVIEW_SHAPES,
        };
        let (distance, smoothing) = (lines.max_spacing(), lines.smoothing);
        let (spacing, narrowest) = (spacing * distance, narrowest * distance);
        regions::Params { most, drawn: lines.most_shapes, least_gain, most_near, spacing, narrowest, smoothing }
    }

    /// How lines become dots, on a page of dots.
    pub fn dots(&self, medium: &DotMedium) -> dots::Params {
        self.dots_of(medium.device, medium.pitch)
    }

    /// Which strokes become heavy lines, on a page of dots: those at least as broad as two rows are apart.
    pub fn heavy_strokes(&self) -> Option<lines::HeavyStrokes> {
        match self.medium() {
            MediumParams::Print(_) => None,
            MediumParams::Dots { pitch, .. } => {
                Some(lines::HeavyStrokes { from: self.profile.dots.heavy_from, width: pitch })
            }
        }
    }

    pub(super) fn dots_of(&self, device: &Device, pitch: f32) -> dots::Params {
        let Profile { dots, lines, edges, .. } = &self.profile;
        dots::Params {
            pitch,
            diameter: device.diameter(),
            line_gap: dots.line_gap.round() as u32,
            heavy_from: dots.heavy_from,
            whole_rows: false,
            has_heights: device.has_heights(),
            least_strength: edges.low,
            min_length: lines.min_length,
        }
    }

    /// How textures of dots are drawn, on a page of dots.
    pub fn dot_textures(&self, medium: &DotMedium) -> dots::textures::Params {
        let Profile { dots, .. } = &self.profile;
        let textures::Params { density_blur, dense_from, white_from, palette, .. } = self.textures();
        dots::textures::Params {
            pitch: medium.pitch,
            diameter: medium.diameter(),
            line_gap: dots.texture_gap.round() as u32,
            least_gap: dots.texture_gap.round().min(1.0) as u32,
            least: Least::of_rows(dots.texture_rows.round() as usize),
            density_blur,
            dense_from,
            white_from,
            palette,
        }
    }

    /// How colours are sorted in a picture of so many pixels for a millimetre of the page.
    pub fn classes(&self, px_per_mm: f32) -> classes::Params {
        let Profile { colours, .. } = &self.profile;
        classes::Params {
            cell: COLOUR_CELL * px_per_mm,
            blur: colours.blur * px_per_mm,
            beside: MIXED_WITHIN * px_per_mm,
            smoothing: colours.smoothing * px_per_mm,
            min_saturation: colours.min_saturation,
            min_value: colours.min_value,
            white_from: colours.white_from,
            min_area: colours.min_area * px_per_mm * px_per_mm,
            fringe: self.profile.textures.fringe,
        }
    }

    /// How textures are drawn.
    pub fn textures(&self) -> textures::Params {
        let Profile { colours, textures, palette, .. } = &self.profile;
        textures::Params {
            line_gap: textures.line_gap,
            along: textures.along,
            across: textures.across,
            length: textures.length,
            thickness: textures.thickness,
            dot: textures.dot,
            dot_pitch: textures.dot_pitch,
            min_glyph: textures.min_glyph,
            density_blur: textures.density_blur,
            dense_from: textures.dense_from,
            white_from: colours.white_from,
            palette: Palette { signs: palette.signs() },
        }
    }

    /// The numbers that a page of this profile is held against.
    pub fn limits(&self) -> RuleLimits {
        let Profile { page, lines, colours, textures, braille, print, .. } = self.profile();
        let medium = match self.medium() {
            MediumParams::Print(_) => MediumLimits::Print {
                line_width: lines.width_min,
                line_gap: lines.min_gap,
                texture_gap: textures.line_gap,
                glyph: textures.min_glyph,
                max_black: print.max_black,
                fringe: textures.fringe,
            },
            MediumParams::Dots { device, pitch } => {
                let line_gap = self.dots_of(device, pitch).line_gap;
                // areas without room for the profile's gap keep one
                let texture_gap = self.profile().dots.texture_gap.round().min(1.0) as u32;
                MediumLimits::Dots { pitch, farthest_next: device.farthest_next(pitch), line_gap, texture_gap }
            }
        };
        RuleLimits {
            margin: page.margin,
            line_length: lines.min_length,
            least_strength: self.lines().least_strength,
            texture_area: colours.min_area,
            cell: braille.cell,
            medium,
        }
    }
}
