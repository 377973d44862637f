//! Pages of dots in the files that embossers, braille programs and pin displays take.

use tactograph::internals::devices::{Device, DotArea, Family};
use tactograph::internals::output::dots::{Matrix, Words, art, brf, dots, gcode, greys, index, pef, ubrl};
use tactograph::internals::page::{DotMedium, Medium};
use tactograph::internals::profile::Plan;
use tactograph::{Error, Page};

use super::args::Embossing;
use super::product::Format;

/// Everything in which a format does not go with a profile, and what goes instead.
pub(super) fn faults(format: Format, plan: &Plan, embossing: &Embossing) -> Vec<String> {
    let mut faults = Vec::new();
    let profile = plan.profile();
    for (option, given) in [("--copies", embossing.copies.is_some()), ("--impact", embossing.impact.is_some())] {
        if given && format != Format::Idx {
            faults.push(format!("{option} is for Index embossers; leave it out, or give a name that ends in .idx"));
        }
    }
    match profile.dots.device {
        _ if !format.is_of_dots() => {}
        None => faults.push(format!(
            "{} holds dots, and the profile {} is for printing; take one for dots, such as --profile {}",
            format.name().to_uppercase(),
            profile.name,
            example(format)
        )),
        Some(device) => match refusal(format, device) {
            Some(why) => faults.push(why),
            None if format == Format::Idx => {
                let sheet = [profile.page.width, profile.page.height];
                faults.extend(params(device, sheet, plan, embossing).err().into_iter().flatten());
            }
            None => {}
        },
    }
    faults
}

/// A profile for a format.
fn example(format: Format) -> &'static str {
    match format {
        Format::Brf => "braille-cells",
        Format::Gcode => "braillerap",
        Format::Pixels => "viewplus-columbia",
        Format::Txt => "dot-pad",
        _ => "index-basic-d",
    }
}

/// Why a device has nothing to do with a format, and what does.
fn refusal(format: Format, device: &Device) -> Option<String> {
    let Device { name, family, .. } = device;
    let goes = match (format, family) {
        (Format::Gcode, Family::BrailleRap { .. })
        | (Format::Brf | Format::Txt, Family::Cells)
        | (Format::Idx, Family::IndexV3 { .. } | Family::IndexV4) => true,
        (Format::Gcode | Format::Brf | Format::Idx, _) | (_, Family::BrailleRap { .. } | Family::Cells) => false,
        _ => true,
    };
    if goes {
        return None;
    }
    let can = match family {
        Family::IndexV3 { .. } | Family::IndexV4 => "idx, ubrl, pef, pixels or txt",
        Family::BrailleRap { .. } => "gcode",
        Family::ViewPlus | Family::Pins { .. } => "pixels, ubrl, pef or txt",
        Family::Cells => "brf or txt",
    };
    let format = format.name().to_uppercase();
    Some(format!("{format} is not for {name}, which takes {can}; take one of these, or SVG, PDF or PNG to look at"))
}

fn params(device: &Device, sheet: [f32; 2], plan: &Plan, embossing: &Embossing) -> Result<index::Params, Vec<String>> {
    let pitch = plan.profile().dots.pitch;
    index::Params::new(device, sheet, pitch, embossing.copies.unwrap_or(1), embossing.impact.unwrap_or(1))
}

/// The files of pages that belong together and are called `title`; one where the format holds them all.
///
/// # Errors
/// If the device cannot press them.
pub(super) fn write(
    title: &str,
    pages: &[Page],
    format: Format,
    plan: &Plan,
    embossing: &Embossing,
) -> Result<Vec<Vec<u8>>, Error> {
    let Some(device) = plan.profile().dots.device else { return Ok(Vec::new()) };
    let matrices: Vec<Matrix> = pages.iter().filter_map(Matrix::of).collect();
    let text = |text: String| vec![text.into_bytes()];
    Ok(match format {
        Format::Ubrl => text(ubrl::write(&matrices)),
        Format::Brf => text(brf::write(&matrices)),
        Format::Pef => {
            let words = pages.first().map_or(Words::default(), words);
            text(pef::write(&matrices, &Words { title, ..words }))
        }
        Format::Txt => text(art::write(&matrices)),
        Format::Idx => {
            let sheet = pages.first().map_or([0.0; 2], |page| page.sheet);
            let params = params(device, sheet, plan, embossing);
            let params = params.map_err(|faults| Error::CannotPress(faults.join("; ")))?;
            vec![index::write(&matrices, &params)]
        }
        Format::Gcode => pages.iter().map(gcode_of).collect::<Result<_, _>>()?,
        Format::Pixels => {
            let with_pages = matrices.iter().zip(pages);
            let of = |(matrix, page): (&Matrix, &Page)| match &page.medium {
                Medium::Print(_) => None,
                Medium::Dots(dots) => Some(greys::write(matrix, dots.pitch, dots.device.has_heights(), &words(page))),
            };
            with_pages.filter_map(of).collect()
        }
        Format::Svg | Format::Pdf | Format::Png => Vec::new(), // not of dots
    })
}

fn words(page: &Page) -> Words<'_> {
    Words { title: &page.title, description: &page.description, language: &page.language }
}

fn gcode_of(page: &Page) -> Result<Vec<u8>, Error> {
    let Medium::Dots(DotMedium { area: DotArea::Free(reach), .. }) = &page.medium else { return Ok(Vec::new()) };
    let params = gcode::Params {
        limits: [reach.width(), reach.height()],
        origin: [reach.min.x, reach.min.y],
        paper_length: page.sheet[1],
        title: page.title.clone(),
        ..gcode::Params::a4()
    };
    let places: Vec<_> = dots(page).into_iter().map(|(at, _)| at).collect();
    gcode::write(&places, &params).map(String::into_bytes).map_err(|refused| Error::CannotPress(refused.to_string()))
}
