//! `tactograph convert`: pictures in, pages out.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use tactograph::{
    Drawing, Error, Options, Page, Profile, convert, convert_to_sheets, profile_of_page, render_with_key,
};

use super::args::{Convert, Corrections};
use super::batch::{self, Input, Made, Order};
use super::product::{Format, Product};
use super::report::Exit;
use super::session::Session;
use super::titles::Titles;
use super::{dots, louis, record, sheets, tesseract, watch};

/// Converts all pictures and tells what became of each, in their order; or those that are saved into a directory, until
/// it is stopped.
pub(super) fn run(args: &Convert) -> Exit {
    let asked = Asked::default();
    match &args.running.watch {
        Some(dir) => {
            watch::run(dir, args.shared.quiet, &|pictures, session| batch(args, pictures, Some(session), &asked))
        }
        None => batch(args, &args.pictures, None, &asked),
    }
}

/// What other programs are asked for once, before the first picture, however often pictures are saved.
#[derive(Default)]
struct Asked {
    /// The table of liblouis with which words are written, if not with one of the program's own.
    table: OnceLock<Result<Option<String>, String>>,
    /// What Tesseract calls the language of texts in pixels.
    language: OnceLock<Result<String, String>>,
}

fn batch(args: &Convert, pictures: &[PathBuf], session: Option<&Session>, other_programs: &Asked) -> Exit {
    let (chosen, mut faults) = args.writing.choose(args.output.as_deref());
    faults.extend(args.faults_of_words());
    faults.extend(args.subject.check().err());
    let labels = args.labels.read().unwrap_or_else(|more| {
        faults.extend(more);
        Default::default()
    });
    let corrections = args.correcting.read(pictures.len(), args.running.watch.is_some()).unwrap_or_else(|more| {
        faults.extend(more);
        Corrections::default()
    });
    let titles = args.words.titles.as_deref().map_or_else(|| Ok(Titles::default()), Titles::read);
    let titles = titles.unwrap_or_else(|more| {
        faults.extend(more);
        Titles::default()
    });
    faults.extend(titles.faults(pictures));
    let mut notes = Vec::new();
    if args.words.titles.is_some() {
        notes.extend(titles.without_row(pictures));
        // of pictures that are saved one by one, the other rows may be of those to come
        notes.extend(if session.is_none() { titles.without_picture(pictures) } else { Vec::new() });
    }
    // what is wrong with a file of lines is told before any picture is looked at
    if let Some((path, error)) = trial(&corrections) {
        faults.push(format!("{}: {error}", path.display()));
    }
    let table = |profile: &Profile| {
        let asked = args.labels.braille_table.as_deref();
        let has_words = args.words.has_title() || args.labels.are_given();
        let wanted = || if has_words { louis::wanted(asked, profile, args.words.language()) } else { Ok(None) };
        other_programs.table.get_or_init(wanted).clone()
    };
    let language = || tesseract::language(args.words.language());
    let of_texts = match args.labels.ocr {
        true => other_programs.language.get_or_init(language).clone().map_err(|fault| faults.push(fault)).ok(),
        false => None,
    };
    let order = Order {
        product: Product::Page(chosen.format),
        pictures,
        output: args.output.as_deref(),
        out_dir: args.out_dir.as_deref(),
        preview: chosen.preview,
        report: args.running.report.as_deref(),
        session,
        faults,
        notes,
        changes: args.fitting.changes(),
        shared: &args.shared,
        check: &|profile| {
            let mut faults = dots::faults(chosen.format, profile, &args.embossing);
            faults.extend(table(profile).err());
            faults
        },
    };
    batch::run(&order, |&Input { job, bytes, options, timings }| {
        let options = titles.add_to(args.words.add_to(options.clone()), &job.picture);
        let options = labels.add_to(args.fitting.add_to(options));
        let options = corrections.add_to(args.subject.add_to(options)).map_err(|(_, error)| error)?;
        let options = table(options.profile())
            .ok()
            .flatten()
            .into_iter()
            .fold(options, |options, table: String| options.translator(move |text| louis::translate(&table, text)));
        let options = of_texts.iter().fold(options, |options, language| {
            let language = language.clone();
            options.text_reader(move |lines| tesseract::read(&language, lines))
        });
        let drawn = if args.fitting.is_for_several_sheets(options.profile()) {
            convert_to_sheets(bytes, args.fitting.sheets, &options)
                .map(|drawn| ([drawn.pages, drawn.key].concat(), drawn.notes))
        } else {
            convert(bytes, &options).map(|drawing| (pages_of(&drawing), drawing.notes))
        };
        let mut title = options.document_title().to_owned();
        let (pages, mut notes) = match drawn {
            // a page that is saved into a watched directory was changed by somebody
            Err(Error::IsAPage) if session.is_some() => {
                let own = profile_of_page(bytes)?;
                let other = Some(options.profile()).filter(|profile| profile.name != own.name);
                let drawing = render_with_key(bytes, other, labels.key())?;
                title = drawing.page.title.clone();
                (pages_of(&drawing), drawing.notes)
            }
            drawn => drawn?,
        };
        notes.extend(sheets::not_in(&pages, [Some(chosen.format), chosen.preview.map(Format::Drawing)]));
        let describe = |page: &Page| tactograph::describe(page.to_svg(), None, None).map(|told| told.to_string());
        let description = match args.describe {
            true => Some(pages.iter().map(describe).collect::<Result<Vec<_>, _>>()?.join("\n")),
            false => None,
        };
        let checked = if args.running.report.is_some() {
            timings.step("check", || pages.iter().map(record::checked).collect())
        } else {
            Vec::new()
        };
        let encode = |format| sheets::encode(&title, &pages, format, chosen, args.embossing.numbers());
        let (files, previews) = timings.step("write", || {
            let files = encode(chosen.format)?;
            let previews = chosen.preview.map(Format::Drawing).map_or_else(|| Ok(Vec::new()), encode)?;
            Ok::<_, Error>((files, previews))
        })?;
        Ok(Made { files, previews, sheets: pages.len(), notes, checked, description })
    })
}

/// All pages of a picture, the figure first.
fn pages_of(drawing: &Drawing) -> Vec<Page> {
    [&drawing.page].into_iter().chain(&drawing.overview).chain(&drawing.key).cloned().collect()
}

/// What is wrong with the files of a person's corrections.
fn trial(corrections: &Corrections) -> Option<(&Path, Error)> {
    let profile = Profile::named(Profile::built_in()[0].name).ok()?;
    corrections.add_to(Options::new(profile)).err()
}
