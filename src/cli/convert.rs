//! `tactograph convert`: pictures in, pages out.

use std::path::Path;

use tactograph::{Error, Options, Page, Profile, built_in, convert, convert_to_sheets, write_dots, write_pdf};

use super::args::{Chosen, Convert, Corrections};
use super::batch::{self, Input, Made, Order};
use super::dots;
use super::louis;
use super::product::{DrawingFormat, Format, Product};
use super::report::Exit;
use super::titles::Titles;

/// Converts all pictures and tells what became of each, in their order.
pub(super) fn run(args: &Convert) -> Exit {
    let (chosen, mut faults) = args.writing.choose(args.output.as_deref());
    faults.extend(args.faults_of_words());
    let labels = args.labels.read().unwrap_or_else(|more| {
        faults.extend(more);
        Default::default()
    });
    let corrections = args.correcting.read(args.pictures.len()).unwrap_or_else(|more| {
        faults.extend(more);
        Corrections::default()
    });
    let titles = args.words.titles.as_deref().map_or_else(|| Ok(Titles::default()), Titles::read);
    let titles = titles.unwrap_or_else(|more| {
        faults.extend(more);
        Titles::default()
    });
    faults.extend(titles.faults(&args.pictures));
    // what is wrong with a file of lines is told before any picture is looked at
    if let Some((path, error)) = trial(&corrections) {
        faults.push(format!("{}: {error}", path.display()));
    }
    let table = |profile: &Profile| {
        let asked = args.labels.braille_table.as_deref();
        let has_words = args.words.has_title() || args.labels.are_given();
        if has_words { louis::wanted(asked, profile, args.words.language()) } else { Ok(None) }
    };
    let order = Order {
        product: Product::Page(chosen.format),
        pictures: &args.pictures,
        output: args.output.as_deref(),
        out_dir: args.out_dir.as_deref(),
        faults,
        notes: if args.words.titles.is_some() { titles.notes(&args.pictures) } else { Vec::new() },
        changes: args.fitting.changes(),
        shared: &args.shared,
        check: &|profile| {
            let mut faults = dots::faults(chosen.format, profile, &args.embossing);
            faults.extend(args.fitting.fault(profile));
            faults.extend(table(profile).err());
            faults
        },
    };
    batch::run(&order, |&Input { job, bytes, options, timings }| {
        let options = titles.add_to(args.words.add_to(options.clone()), &job.picture);
        let options = labels.add_to(args.fitting.add_to(options));
        let options = corrections.add_to(options).map_err(|(_, error)| error)?;
        // a fault of the table was told before the first picture
        let options = match table(options.profile()).ok().flatten() {
            Some(table) => options.translator(move |text| louis::translate(&table, text)),
            None => options,
        };
        let (pages, notes): (Vec<Page>, _) = if args.fitting.is_for_several_sheets(options.profile()) {
            let drawn = convert_to_sheets(bytes, args.fitting.sheets, &options)?;
            (drawn.pages, drawn.notes)
        } else {
            let drawing = convert(bytes, &options)?;
            ([drawing.page].into_iter().chain(drawing.overview).chain(drawing.key).collect(), drawing.notes)
        };
        let title = options.document_title();
        let files = timings.step("write", || match (&pages[..], chosen.format) {
            (pages, Format::Dots(format)) => write_dots(title, pages, format, args.embossing.numbers()),
            ([page], Format::Drawing(format)) => write(page, format, chosen).map(|file| vec![file]),
            (pages, Format::Drawing(DrawingFormat::Pdf)) => write_pdf(title, pages).map(|file| vec![file]),
            (pages, Format::Drawing(format)) => pages.iter().map(|page| write(page, format, chosen)).collect(),
        })?;
        Ok(Made { files, sheets: pages.len(), notes })
    })
}

/// What is wrong with the files of a person's corrections.
fn trial(corrections: &Corrections) -> Option<(&Path, Error)> {
    let profile = Profile::named(built_in()[0].name).ok()?;
    corrections.add_to(Options::new(profile)).err()
}

/// The file of one page.
///
/// # Errors
/// If a PNG would have too many pixels.
pub(super) fn write(page: &Page, format: DrawingFormat, chosen: Chosen) -> Result<Vec<u8>, Error> {
    page.to_drawing(format, chosen.dpi, chosen.depth)
}
