//! `tactograph convert`: pictures in, pages out.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use tactograph::{
    Drawing, Error, Note, Options, Page, PageOptions, Profile, RenderOptions, convert, convert_to_sheets, render,
};

use super::args::{Chosen, Convert, Corrections, GivenLabels};
use super::batch::{self, Made, Order};
use super::product::{Format, Product};
use super::remedies::Making;
use super::report::Exit;
use super::session::Session;
use super::timings::Timings;
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

fn batch(args: &Convert, pictures: &[PathBuf], session: Option<&Session>, asked: &Asked) -> Exit {
    let (chosen, mut faults) = args.writing.choose(args.output.as_deref());
    let given = Given::read(args, pictures, session, &mut faults);
    let ocr = asked.language_of_texts(args).unwrap_or_else(|fault| {
        faults.push(fault);
        None
    });
    let order = Order {
        product: Product::Page(chosen.format),
        pictures,
        output: args.output.as_deref(),
        out_dir: args.out_dir.as_deref(),
        preview: chosen.preview,
        report: args.running.report.as_deref(),
        session,
        faults,
        notes: given.notes(args, pictures, session),
        changes: args.fitting.changes(),
        shared: &args.shared,
        check: &|profile| {
            let mut faults = dots::faults(chosen.format, profile, &args.embossing);
            faults.extend(asked.table(args, profile).err());
            faults
        },
    };
    batch::run(&order, |input| {
        let table = asked.table(args, input.options.profile()).ok().flatten();
        let options = given.add_to(input.options.clone(), args, &input.job.picture)?;
        let drawn =
            PagesOfPicture::of(input.bytes, &with_programs(options, table, ocr.as_ref()), args, &given, session)?;
        drawn.written(args, chosen, input.timings)
    })
}

impl Asked {
    /// The table of liblouis, where there is anything to write.
    fn table(&self, args: &Convert, profile: &Profile) -> Result<Option<String>, String> {
        let asked = args.labels.braille_table.as_deref();
        let has_words = args.words.has_title() || args.labels.are_given();
        let wanted = || if has_words { louis::wanted(asked, profile, args.words.language()) } else { Ok(None) };
        self.table.get_or_init(wanted).clone()
    }

    /// What Tesseract calls the language of texts in pixels; none where it is not to read any.
    fn language_of_texts(&self, args: &Convert) -> Result<Option<String>, String> {
        if !args.labels.ocr {
            return Ok(None);
        }
        self.language.get_or_init(|| tesseract::language(args.words.language())).clone().map(Some)
    }
}

/// The options with the programs that write words and read texts.
fn with_programs(options: Options, table: Option<String>, language: Option<&String>) -> Options {
    let options = match table {
        Some(table) => options.translator(move |text| louis::translate(&table, text)),
        None => options,
    };
    match language.cloned() {
        Some(language) => options.text_reader(move |lines| tesseract::read(&language, lines)),
        None => options,
    }
}

/// What is given in files beside the pictures.
struct Given {
    labels: GivenLabels,
    corrections: Corrections,
    titles: Titles,
}

impl Given {
    /// Reads the files; adds what is wrong with them, and with the words, to `faults`.
    fn read(args: &Convert, pictures: &[PathBuf], session: Option<&Session>, faults: &mut Vec<String>) -> Self {
        fn or_told<T: Default>(read: Result<T, Vec<String>>, faults: &mut Vec<String>) -> T {
            read.unwrap_or_else(|more| {
                faults.extend(more);
                T::default()
            })
        }
        faults.extend(args.faults_of_words());
        faults.extend(args.subject.check().err());
        let labels = or_told(args.labels.read(), faults);
        let corrections = or_told(args.correcting.read(pictures.len(), session.is_some()), faults);
        let titles = args.words.titles.as_deref().map_or_else(|| Ok(Titles::default()), Titles::read);
        let titles = or_told(titles, faults);
        faults.extend(titles.faults(pictures));
        // what is wrong with a file of lines is told before any picture is looked at
        if let Some((path, error)) = trial(&corrections) {
            faults.push(format!("{}: {error}", path.display()));
        }
        Self { labels, corrections, titles }
    }

    /// What is told of titles without a picture and of pictures without a title.
    fn notes(&self, args: &Convert, pictures: &[PathBuf], session: Option<&Session>) -> Vec<(String, String)> {
        if args.words.titles.is_none() {
            return Vec::new();
        }
        // of pictures that are saved one by one, the other rows may be of those to come
        let alone = if session.is_none() { self.titles.without_picture(pictures) } else { Vec::new() };
        [self.titles.without_words(pictures), alone].concat()
    }

    fn add_to(&self, options: Options, args: &Convert, picture: &Path) -> Result<Options, Error> {
        let options = self.titles.add_to(args.words.add_to(options), picture);
        let options = self.labels.add_to(args.fitting.add_to(options));
        self.corrections.add_to(args.subject.add_to(options)).map_err(|(_, error)| error)
    }
}

/// The pages of a picture.
struct PagesOfPicture {
    /// What they are called together.
    title: String,
    pages: Vec<Page>,
    notes: Vec<Note>,
    /// What they are, for the options that help.
    making: Making,
}

impl PagesOfPicture {
    fn of(
        bytes: &[u8],
        options: &Options,
        args: &Convert,
        given: &Given,
        session: Option<&Session>,
    ) -> Result<Self, Error> {
        let is_spread = args.fitting.is_for_several_sheets(options.profile());
        let mut making = Making::of_picture(options.profile(), is_spread).of_width(args.fitting.has_width());
        let drawn = if is_spread {
            let drawn = convert_to_sheets(bytes, args.fitting.sheets, options);
            drawn.map(|mut drawn| (std::mem::take(&mut drawn.notes), drawn.into_pages()))
        } else {
            convert(bytes, options).map(|drawing| {
                making = making.beside_overview(drawing.is_larger_without_overview).turned(drawing.is_larger_turned);
                notes_and_pages(drawing)
            })
        };
        let mut title = options.document_title().to_owned();
        let (notes, pages) = match drawn {
            // a page that is saved into a watched directory was changed by somebody
            Err(Error::IsAPage) if session.is_some() => {
                let own = Profile::of_page(bytes)?;
                let rendering = RenderOptions::new().key(given.labels.key());
                let is_its_own = options.profile().name == own.name;
                making = if is_its_own { Making::Other } else { Making::PageAnew };
                let drawing = if is_its_own {
                    render(bytes, &rendering)?
                } else {
                    render(bytes, &rendering.profile(options.profile().clone()))?
                };
                title = drawing.page.title.clone();
                notes_and_pages(drawing)
            }
            drawn => drawn?,
        };
        Ok(Self { title, pages, notes, making })
    }

    /// The files of the pages, with what is told of them.
    fn written(self, args: &Convert, chosen: Chosen, timings: &Timings) -> Result<Made, Error> {
        let Self { title, pages, mut notes, making } = self;
        notes.extend(sheets::not_in(&pages, [Some(chosen.format), chosen.preview.map(Format::Drawing)]));
        let describe =
            |page: &Page| tactograph::describe(page.to_svg(), &PageOptions::new()).map(|told| told.to_string());
        let description = match args.describe {
            true => Some(pages.iter().map(describe).collect::<Result<Vec<_>, _>>()?.join("\n")),
            false => None,
        };
        let checked = if args.running.report.is_some() {
            timings.step("check", || pages.iter().map(record::checked).collect())
        } else {
            Vec::new()
        };
        // what is out of its range was told before anything was done
        let embossing = args.embossing.numbers().unwrap_or_default();
        let encode = |format| sheets::encode(&title, &pages, format, chosen, embossing);
        let (files, previews) = timings.step("write", || {
            let files = encode(chosen.format)?;
            let previews = chosen.preview.map(Format::Drawing).map_or_else(|| Ok(Vec::new()), encode)?;
            Ok::<_, Error>((files, previews))
        })?;
        let sheets = pages.iter().map(Page::part_of_set).collect();
        Ok(Made { files, previews, sheets, notes, making, checked, description })
    }
}

fn notes_and_pages(mut drawing: Drawing) -> (Vec<Note>, Vec<Page>) {
    (std::mem::take(&mut drawing.notes), drawing.into_pages())
}

/// What is wrong with the files of a person's corrections.
fn trial(corrections: &Corrections) -> Option<(&Path, Error)> {
    if !corrections.has_files() {
        return None; // most calls have none, and a profile takes a sixth of the time of a white page
    }
    let profile = Profile::named(Profile::built_in()[0].name).ok()?;
    corrections.add_to(Options::new(profile)).err()
}
