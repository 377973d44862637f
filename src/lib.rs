//! From a colour picture to a page that fingers can read.
//!
//! The contours of the picture become raised lines, the stronger the broader; its colours become textures of small
//! rhombuses whose direction names the colour; a smaller picture of lines only lies below. The method is that of A.
//! Rataj (2004). The page is in true millimetres: an SVG drawing, a PDF or a PNG for swell paper, or dots for a
//! braille embosser or a pin display.
//!
//! Five tasks, each of which runs as it stands in a checkout, where `samples/` is. First the usual one, a picture to a
//! page:
//!
//! ```
//! use tactograph::{Options, Profile};
//!
//! let picture = std::fs::read("samples/coffee.png")?;
//! let options = Options::new(Profile::named("swell-a4")?).title("A cup of coffee").width_mm(150.0);
//! let drawing = tactograph::convert(&picture, &options)?;
//! for note in &drawing.notes {
//!     eprintln!("{note}"); // what the page survives, and its maker should know
//! }
//! # let folder = std::env::temp_dir();
//! std::fs::write(folder.join("cup.svg"), drawing.page.to_svg())?;
//! std::fs::write(folder.join("cup.pdf"), drawing.page.to_pdf())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`Profile`] is a paper or a device with all the numbers that a page for it needs. Your own inherits one that
//! comes with the program and says what differs; [`Profile::manual`] tells of every key:
//!
//! ```
//! use tactograph::{Options, Profile};
//!
//! let text = "inherits = \"swell-a4\"\n[page]\nmargin = 15.0\n[lines]\nwidth_max = 1.2";
//! let mut profile = Profile::from_toml(text, "workshop.toml")?;
//! profile.set("textures.across", "4.5")?; // one value more
//! let drawing = tactograph::convert(&std::fs::read("samples/coffee.png")?, &Options::new(profile))?;
//! let widest = drawing.page.figure.lines.iter().flat_map(|line| &line.runs).map(|run| run.width).fold(0.0, f32::max);
//! assert!(widest <= 1.2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Contours as data, in pixels of the picture, for programs that go on with them:
//!
//! ```
//! use tactograph::{Options, Profile, Tracing};
//!
//! let options = Options::new(Profile::named("swell-a4")?);
//! let traced = tactograph::trace(&std::fs::read("samples/coffee.png")?, &Tracing::contours(), &options)?;
//! let longest = traced.trace.polylines.iter().max_by_key(|polyline| polyline.points.len());
//! assert!(longest.is_some_and(|polyline| polyline.points.len() == polyline.strength.len()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Dots for an embosser or a pin display. Of such a page the overview has a sheet of its own, and the files of all
//! sheets come together:
//!
//! ```
//! use tactograph::{DotFormat, Embossing, Options, Profile};
//!
//! let options = Options::new(Profile::named("index-basic-d")?).title("A cup of coffee");
//! let sheets = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.into_pages();
//! let files = tactograph::write_dots("A cup of coffee", &sheets, DotFormat::Idx, Embossing::default())?;
//! assert_eq!((sheets.len(), files.len()), (2, 1)); // both sheets in one document
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! What a fingertip would feel of a page, also of one that was changed in an editor:
//!
//! ```
//! use tactograph::{Options, PageOptions, Profile};
//!
//! let options = Options::new(Profile::named("swell-a4")?);
//! let page = tactograph::convert(&std::fs::read("samples/coffee.png")?, &options)?.page;
//! let felt = tactograph::feel(page.to_svg(), &PageOptions::new())?;
//! println!("{}", felt.report());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Short programs to begin from are in `examples/`: a picture to a page, pixels in memory, contours as data, files for
//! an embosser, a page that was edited.
//!
//! Pixels in memory are given as [`Picture::rgba8`]. All but [`Picture`], which borrows them, is owned, `Send`,
//! `Sync` and `'static`, so that it can be held by classes of other languages. The crate prints nothing, reads no
//! files (but fonts, where `Fonts::system` is asked for) and no clock, and gives the same bytes for the same input,
//! however many threads there are. These are those of the global pool of `rayon`: `RAYON_NUM_THREADS`, or a pool of
//! the caller's in which the functions are called, says how many.
//!
//! # Features
//!
//! * `cli` (default): the program `tactograph` and what only it needs. A library does without: `default-features =
//!   false`.
//! * `system-fonts`: `Fonts::system`, the fonts that are installed, for SVG drawings with text. Part of `cli`.
//! * `pdf`: pages of PDF documents as pictures; see [`Options::page`]. Part of `cli`. It brings 30 more crates, all
//!   of them Rust.
//! * `turbojpeg`: JPEGs through the C library libjpeg-turbo, built by cmake and nasm.
//!
//! # Wrapping it for other languages
//!
//! * What is given to [`Options::progress`], [`Options::cancelled`], [`Options::translator`] and
//!   [`Options::text_reader`] is called while [`convert`], [`convert_to_sheets`] or [`trace`] runs, what is given to
//!   [`RenderOptions`] while [`render`] runs, and what is given to [`PageOptions`] while [`check`], [`describe`] or
//!   [`feel`] runs; progress also from threads of its own, one call at a time. A caller
//!   that holds a lock which these functions take (Python's interpreter lock, say) has to let go of it before it calls
//!   any of them, or both wait for each other for ever. In a browser there are no threads, and a function of
//!   JavaScript needs a wrapper that is `Send + Sync` by an `unsafe impl`, which is sound there as nothing is sent.
//!   What is called must not call this crate, nor wait for work of the pool of threads in which it runs: it may be
//!   called from the middle of that. A wrapper that does not know what its users write puts events into a queue.
//! * What a caller gives may fail: a translator and a reader of text say why, which a note tells, and the page is made
//!   without those words. One that panics ends the work, and its panic goes on through the function that was called (a
//!   wrapper catches it there, with [`catch_unwind`](std::panic::catch_unwind) and
//!   [`AssertUnwindSafe`](std::panic::AssertUnwindSafe)); options and all else stay as they
//!   were and can be used again. To end the work in order there is `cancelled`, also for progress that cannot be shown.
//! * [`Picture`] borrows pixels and bytes while it is converted. A wrapper that lets go of the interpreter's lock
//!   copies those that other threads may write, such as the buffer of an array.
//! * Work is shared with the pool of threads. A process that was forked after the first call has no such threads and
//!   would wait for ever: start workers anew (Python: the start method `spawn`), or fork before the first call.
//!   The deepest drawings that are taken need a stack of 1 MB in the calling thread, as WebAssembly has; threads of
//!   Rust have two.
//! * Setters of [`Options`] take the options and give them back. Three read a file and can fail ([`Options::lines`],
//!   [`Options::add_lines`], [`Options::areas`]), and then the options are gone: a class calls them on a clone. Most
//!   settings cannot be asked for again; a class that has properties keeps what it was given. What is given as a value
//!   says what it is: [`Crop`], [`Position`], [`SheetGrid`], [`Dpi`], [`Embossing`].
//! * The sentences of errors, notes and findings are in English, with names, numbers and places in them. Ids of kinds
//!   ([`Error::id`], [`Note::id`], [`Reason::name`], `rule.id` of a [`Finding`]) are for programs, which can say the
//!   general part in another language. [`describe`] has languages of its own.
//! * Decoders are other people's code. Should one panic on a file, it is caught and told as [`Error::Undecodable`];
//!   before that the panic hook of the process runs, whose default writes to standard error: a program that wants
//!   silence sets its own. WebAssembly cannot catch a panic: there the instance ends, and a new one has to be made.
//!   What is known to panic is refused before.
//! * [`Options::cancelled`], [`RenderOptions::cancelled`] and [`PageOptions::cancelled`] end work that is no longer
//!   wanted: a button, a closed window, a signal. In a browser no event arrives while a function runs: there it takes a
//!   worker, and a flag in shared memory or the end of that worker. All else takes less than a second, but for a PNG
//!   ([`Page::to_png`]) at more than 300 dots per inch, and for pages of millions of points, which take seconds to be
//!   read.
//! * [`Event::Done`] is what a progress bar shows: a share of the work that never goes back.
//! * Profiles, devices, rules of [`check`] and languages can be listed for forms: [`Profile::built_in`],
//!   [`Profile::keys`] with [what each takes](Key::choices), [`medium::Device::ALL`], [`Rule::all`],
//!   [`Options::languages`] of braille, [`Description::languages`]. A [`Fault`] names the keys that it is about;
//!   [errors](Error::id), [notes](Note::id) and [rules](Rule::id) have ids that stay when their sentences change, and
//!   [`Error::ids`], [`Note::ids`] and [`Rule::all`] list them. Notes of one id that are made for several reasons have
//!   a [`Reason`] each ([`Note::reason`]). Errors of one id may want several remedies, which their sentences say
//!   ([`Error::NotAPage`]); all faults of a profile are one error ([`Error::Profile`]).
//! * A profile that a form changed by [`Profile::set`] is kept as [`Profile::to_toml`] writes it.
//!
//! # Names and text
//!
//! * What is chosen from a list has `ALL`, `name` and `named`: [`Format`], [`DotFormat`], [`DrawingFormat`],
//!   [`Depth`], [`KeySheets`], [`Class`]. [`Profile::named`] and [`medium::Device::named`] take the ids of profiles and
//!   devices. A name that there is not is refused by all of them with [`Error::NoSuchName`], which has those that there
//!   are, and those that may have been meant.
//! * What has a syntax of its own is parsed with [`FromStr`](std::str::FromStr) and written with
//!   [`Display`](std::fmt::Display): [`Crop`], [`Position`], [`SheetGrid`], [`marks::Sign`].
//! * What the library gives, and nobody gives to it by its name, has a `name` or an `id`: [`Stage`], [`About`],
//!   [`Reason`], [`Severity`], [`marks::Height`] and [`marks::TextRole`] with `ALL`, [`felt::FeltAs`], [`Error`],
//!   [`Note`], [`Rule`].
//! * What may be refused gives a [`Result`] with the crate's [`Error`], constructors (`new`) and `named` too.
//!
//! # Words
//!
//! * maker: the person who makes the page. Told: reported in a [`Note`].
//! * ring: a closed line.
//! * drawing: a vector picture, such as an SVG or a page of a PDF; but [`Drawing`] is what a picture has become. Key:
//!   the sheets that say what textures and abbreviations stand for; but [`Key`] is one of a profile's settings.
//! * Places in words, in notes and findings, are upper, middle and lower, each with left, middle and right, and
//!   "middle" for that of the middle; sides of a rim are left, upper, right and lower.
//! * glyph: one rhombus or dot of a texture. Sign: the kind of glyph, and its direction, that stands for a [`Class`] of
//!   colours.
//! * seen from the back: with left and right exchanged, as for a machine that presses dots from the back of the sheet.
//!
//! # What grows
//!
//! What is `#[non_exhaustive]` may get more cases or fields in a release that changes nothing else: errors, notes,
//! events, formats of files, devices, and most of what functions give; its `ALL` is a slice, that of what is complete
//! an array. An id or a name that there is stays, and goes on to stand for the same. What is not, is complete: so the
//! marks of a page ([`marks::Shape`], [`marks::Pen`], [`marks::Sign`], [`Class`]), and whoever draws them can see that
//! none is missing.
//!
//! # Points and units
//!
//! Positions are points of `euclid`, which is re-exported and part of this interface: `MmPoint` in millimetres on the
//! sheet (x right, y down, from its top left corner), `PxPoint` in pixels of the picture, or of the part of it that is
//! drawn (the middle of the first is 0.5, 0.5). Their tags, by which the two do not mix, are `Mm` and `Px`. Each has
//! `x` and `y` as `f32`; lengths that are plain numbers are millimetres unless their doc says otherwise.

mod api;
mod braille;
mod calibration;
mod classes;
mod contours;
mod description;
mod devices;
mod dots;
mod edges;
mod error;
mod geom;
mod labels;
mod legibility;
mod lettering;
mod lines;
mod listing;
mod note;
mod output;
mod page;
mod paper;
mod picture;
mod pipeline;
mod profile;
mod ranked;
mod raster;
mod reading;
mod regions;
mod textures;
mod touch;
mod units;
mod wording;

// Functions, and what they take.
pub use api::{
    Calibration, Felt, Fonts, Options, PageOptions, RenderOptions, calibrate, check, convert, convert_to_sheets,
    describe, feel, language_of_page, render, trace, write_pdf,
};
pub use output::png::{Depth, Dpi};
pub use output::{DotFormat, DrawingFormat, Embossing, Format, write_dots};
pub use page::spread::SheetGrid;
pub use picture::Picture;
pub use pipeline::trace::Tracing;
pub use pipeline::{Event, KeySheets, Label, Position, Stage};
pub use profile::{BuiltIn, Fault, Key, NumberRange, Profile, Value};
pub use raster::crop::Crop;
pub use raster::decode::Limits;
// What they give.
pub use contours::{Polyline, Trace};
pub use description::Description;
pub use error::Error;
pub use legibility::{Checked, Finding, Rule, Severity, Verdict};
pub use note::{About, GivenFile, Note, Reason, Told};
pub use page::{Class, Page};
pub use pipeline::sheets::Sheets;
pub use pipeline::trace::Traced;
pub use pipeline::{Drawing, Text};
// Points and sizes: those of euclid, which is part of the interface.
pub use lyon::geom::euclid;
pub use units::{Length, Mm, MmPoint, MmRect, Px, PxPoint, Size};

/// What a [`Page`] consists of: its figure and overview, and the lines, signs and braille in them, in millimetres. For
/// whoever draws or changes a page by a program.
pub mod marks {
    pub use crate::page::{
        BrailleText, Dots, Figure, Glyph, Height, Line, Overview, Parts, Pen, PrintText, Run, Shape, Sign, TextRole,
        Texture,
    };
}

/// What a [`Page`] is made for: paper that is printed, or the dots of an embosser or a pin display.
pub mod medium {
    pub use crate::devices::{Device, DotArea, Grid, Pitches};
    pub use crate::page::{DotMedium, Medium, Print};
}

/// What [`feel`] gives as data: how much of the textured area a fingertip tells, of each class of colours. Where, the
/// map shows ([`Felt::to_png`]).
pub mod felt {
    pub use crate::legibility::Textures;
    pub use crate::touch::report::{Areas, OfClass};
    pub use crate::touch::{FeltAs, Report};
}

/// The stages, for this project's own tests, benchmarks and measuring programs. No part of the public interface:
/// anything in here may change with any release.
#[doc(hidden)]
pub mod internals {
    pub mod braille {
        pub use crate::braille::*;
    }
    pub mod calibration {
        pub use crate::calibration::*;
    }
    pub mod classes {
        pub use crate::classes::*;
    }
    pub mod contours {
        pub use crate::contours::*;
    }
    pub mod devices {
        pub use crate::devices::*;
    }
    pub mod dots {
        pub use crate::dots::*;
    }
    pub mod edges {
        pub use crate::edges::*;
    }
    pub mod error {
        pub use crate::error::*;
    }
    pub mod geom {
        pub use crate::geom::*;
    }
    pub mod labels {
        pub use crate::labels::*;
    }
    pub mod legibility {
        pub use crate::legibility::*;
    }
    pub mod lettering {
        pub use crate::lettering::*;
    }
    pub mod lines {
        pub use crate::lines::*;
    }
    pub mod note {
        pub use crate::note::*;
    }
    pub mod output {
        pub use crate::output::*;
    }
    pub mod page {
        pub use crate::page::*;
    }
    pub mod paper {
        pub use crate::paper::*;
    }
    pub mod pipeline {
        pub use crate::pipeline::*;
    }
    pub mod profile {
        pub use crate::profile::*;
    }
    pub mod raster {
        pub use crate::raster::*;
    }
    pub mod reading {
        pub use crate::reading::*;
    }
    pub mod regions {
        pub use crate::regions::*;
    }
    pub mod textures {
        pub use crate::textures::*;
    }
    pub mod touch {
        pub use crate::touch::*;
    }
    pub mod units {
        pub use crate::units::*;
    }
}
