//! What stops everything. Each message says what is wrong and what to do about it, in one line without the file's name
//! (the caller knows it).

mod ids;
mod making;
mod phrases;

pub(crate) use ids::id_table;
pub(crate) use making::named;

use crate::listing::list;
use crate::profile::{Fault, quoted};
use crate::touch::FINGERS;
use crate::units::Size;
use phrases::{has_pages, hint, or_without, simpler, take_one};

/// Why no page could be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// There are no bytes at all.
    #[error("the file is empty; give a picture")]
    Empty,
    /// The bytes begin like no format that is read here.
    #[error(
        "this is not a picture in a format that is read here (JPEG, PNG, WebP, TIFF, BMP, GIF, PNM, SVG{}){}",
        if cfg!(feature = "pdf") { ", PDF" } else { "" },
        hint(.looks_like)
    )]
    UnknownFormat {
        /// What the bytes look like instead, if that can be told: "text", "PDF".
        looks_like: Option<&'static str>,
    },
    /// The format is known but the bytes cannot be decoded: they are damaged, or of a kind that is not read here.
    #[error(
        "the {format} picture cannot be read: {why}; open and save it again in another program, or use another copy"
    )]
    Undecodable {
        /// Name of the format, such as "JPEG".
        format: &'static str,
        /// What its decoder says.
        why: String,
    },
    /// The file is sound, and has more of something than can be drawn: elements in elements, letters, digits, paths.
    #[error("this {format} is beyond what can be drawn: {why}; {}", simpler(format))]
    TooComplex {
        /// Name of the format, such as "SVG".
        format: &'static str,
        /// What there is too much of.
        why: String,
    },
    /// The file is locked with a password.
    #[error("this {format} is locked with a password; unlock it first (print it into a new {format}, say)")]
    Locked {
        /// Name of the format, such as "PDF".
        format: &'static str,
    },
    /// More pixels than the limit allows.
    #[error("the picture has {size} pixels, which is over the limit of {limit_megapixels} megapixels; {remedy}")]
    TooManyPixels {
        /// What the picture's header says.
        size: Size,
        /// The limit in force, in millions of pixels.
        limit_megapixels: u64,
        /// What the user can do.
        remedy: &'static str,
    },
    /// Decoding would take more memory than the limit allows.
    #[error(
        "decoding this {format} of {size} pixels would take about {needed_mb} MB of memory, over the limit of \
         {limit_mb} MB; {remedy}"
    )]
    TooMuchMemory {
        /// Name of the format, such as "TIFF".
        format: &'static str,
        /// What the picture's header says.
        size: Size,
        /// Megabytes that decoding would take.
        needed_mb: u64,
        /// The limit in force, in megabytes.
        limit_mb: u64,
        /// What the user can do.
        remedy: &'static str,
    },
    /// What a compressed file holds takes more memory than the limit allows.
    #[error("{what} of this {format} unpacks to more than the limit of {limit_mb} MB; {remedy}")]
    UnpacksTooFar {
        /// Name of the format, such as "PDF".
        format: &'static str,
        /// Which part of it: "the drawing", "a page".
        what: &'static str,
        /// The limit in force, in megabytes.
        limit_mb: u64,
        /// What the user can do.
        remedy: &'static str,
    },
    /// The picture has too few pixels for a contour.
    #[error("the picture has {size} pixels: too few to find anything in; give one of at least {least} x {least}")]
    TooFewPixels {
        /// What the picture's header says.
        size: Size,
        /// The fewest along a side.
        least: u32,
    },
    /// The picture is so long and narrow that nothing could be felt in it as wide as the sheet allows.
    #[error(
        "the picture has {size} pixels: so long and narrow a picture would be only {side:.1} mm wide on the sheet, and \
         {least} mm is the least; crop it"
    )]
    TooNarrow {
        /// What the picture's header says.
        size: Size,
        /// Its shorter side in the figure, mm.
        side: f32,
        /// `figure.min_side` of the profile, mm.
        least: f32,
    },
    /// At the width that is asked for nothing could be felt in the figure.
    #[error(
        "a figure {wanted} mm wide would have a side of only {side:.1} mm, and {least} mm is the least; ask for a \
         greater width"
    )]
    NotWideEnough {
        /// Width that was asked for, mm.
        wanted: f32,
        /// The shorter side of the figure, mm.
        side: f32,
        /// `figure.min_side` of the profile, mm.
        least: f32,
    },
    /// The part of the picture that is asked for is not in it.
    #[error("the part {part} reaches beyond the picture, which has {size} pixels; give a part that lies in it")]
    NotInPicture {
        /// The part, as it was asked for.
        part: String,
        /// The whole picture.
        size: Size,
    },
    /// The part of the figure that is asked for is not in it.
    #[error(
        "the part {part} reaches beyond the figure, which is {width:.1} x {height:.1} mm and {size} pixels; give a \
         part that lies in it, from the figure's top left corner"
    )]
    NotInFigure {
        /// The part, as it was asked for.
        part: String,
        /// The picture.
        size: Size,
        /// Width of the figure, mm.
        width: f32,
        /// Height of the figure, mm.
        height: f32,
    },
    /// A part of the picture is asked for in mm before the figure is laid out.
    #[error("the part {part} is in mm, and the figure is laid out of that part; give it in pixels or in percent")]
    PartInMm {
        /// The part, as it was asked for.
        part: String,
    },
    /// The document does not have the page that is asked for.
    #[error("there is no page {page}: {}", has_pages(.pages))]
    NoSuchPage {
        /// The page, counted from 1.
        page: u32,
        /// How many there are.
        pages: usize,
    },
    /// The figure would be wider than the sheet has room for.
    #[error(
        "a figure {wanted} mm wide does not fit; {most:.1} mm is the most for this picture on this sheet{}, so take \
         that or a larger sheet",
        or_without(.without_overview)
    )]
    TooWide {
        /// Width that was asked for, mm.
        wanted: f32,
        /// The most there is room for, mm.
        most: f32,
        /// The most without the overview, mm, where that is enough.
        without_overview: Option<f32>,
    },
    /// The width asked for is no length.
    #[error("a figure cannot be {wanted} mm wide; give a width above 0")]
    NoWidth {
        /// Width that was asked for, mm.
        wanted: f32,
    },
    /// The sheets that a picture is to be spread over have no room for it.
    #[error(
        "{grid} sheets of this size have no room for a picture; take a larger sheet, or lessen page.margin or \
         sheets.overlap"
    )]
    NoRoomOnSheets {
        /// How many sheets across and down.
        grid: String,
    },
    /// A mark would lie off the sheet.
    #[error("the page does not fit its sheet: {0}; give more margin or thinner lines")]
    OffSheet(String),
    /// A number on a page is not finite, or a length is below 0.
    #[error("a page cannot have a {what} of {value}")]
    NoMeasure {
        /// Of what it is the measure.
        what: &'static str,
        /// The number that was given.
        value: f32,
    },
    /// There are no pages to write.
    #[error("there are no pages to write; give at least one")]
    NoPages,
    /// The sheet is too small for what must be on it.
    #[error(
        "a sample of {sample} has no room between the margins of a sheet of {sheet}; take larger paper or less margin"
    )]
    NoRoom {
        /// Its size.
        sample: String,
        /// The sheet's size.
        sheet: String,
    },
    /// The device does not take the sheet, or has no dots this far apart; every reason is listed.
    #[error("{}", .0.join("; "))]
    CannotPress(Vec<String>),
    /// Dots are asked for of a page that is for printing.
    #[error(
        "{} holds dots, and the page is for printing; take a profile for dots, such as {profile}",
        .format.to_uppercase()
    )]
    NotOfDots {
        /// Name of the format that was asked for.
        format: &'static str,
        /// A built-in profile whose pages can be written in it.
        profile: &'static str,
    },
    /// A page of dots has strokes or rhombuses, which its device cannot press.
    #[error("the page has strokes or rhombuses, and its device presses dots; draw them as dots")]
    NotAllDots,
    /// The device does not take this format.
    #[error(
        "{} is not for {device}, which takes {}; take one of these, or SVG, PDF or PNG to look at",
        .format.to_uppercase(),
        list(.takes, "or")
    )]
    NotItsFormat {
        /// Name of the format that was asked for.
        format: &'static str,
        /// What the device is called.
        device: &'static str,
        /// Names of the formats that it takes, the best one first.
        takes: Vec<&'static str>,
    },
    /// The dots of a page are not where its device has any, or where the format could say them; says which.
    #[error("{0}; lay the page out for its device")]
    NotItsDots(String),
    /// Pages do not go into one file: they are for different devices, sheets or distances of dots; says which.
    #[error("{0}; write each in a file of its own")]
    NotTogether(String),
    /// There are no such numbers for an embosser.
    #[error(
        "{copies} copies with an impact of {impact} cannot be embossed; give 1 to {most_copies} copies and an impact \
         of 1 to {most_impact}"
    )]
    NoSuchEmbossing {
        /// How many copies were asked for.
        copies: u16,
        /// The most that there can be.
        most_copies: u16,
        /// How hard the embosser should strike.
        impact: u8,
        /// The hardest that it can.
        most_impact: u8,
    },
    /// Bytes that were given as a font are no font.
    #[error("file {file} of the fonts is no font; give files in TTF or OTF, or collections of them")]
    NotAFont {
        /// Which of the files, counted from 1.
        file: usize,
    },
    /// More pixels than a picture of the page may have.
    #[error(
        "at {dpi} dots per inch the page would have {size} pixels, over the limit of {limit_megapixels} megapixels; \
         take fewer dots per inch"
    )]
    TooFine {
        /// The picture of the page.
        size: Size,
        /// What was asked for.
        dpi: u32,
        /// The limit, in millions of pixels.
        limit_megapixels: u64,
    },
    /// A picture was given as pixels, and there are not as many bytes as its size says.
    #[error("{size} pixels of RGBA take 4 bytes each, and {bytes} bytes were given")]
    WrongPixels {
        /// The size that was given.
        size: Size,
        /// How many bytes there are.
        bytes: usize,
    },
    /// A picture of a page was asked for with too few or too many pixels for an inch.
    #[error("{dpi} dots per inch are not drawn; give a number from {least} to {most}")]
    NoSuchDpi {
        /// What was asked for.
        dpi: u32,
        /// The fewest.
        least: u32,
        /// The most.
        most: u32,
    },
    /// Contours of no such strengths can be asked for.
    #[error("thresholds of {low} and {high} are not known; give two numbers from 0 up, the first not above the second")]
    NoSuchThresholds {
        /// The strength down to which a contour goes on.
        low: f32,
        /// The strength that it has somewhere.
        high: f32,
    },
    /// The text says no part of a picture.
    #[error(
        "give four numbers x,y,width,height, each in whole pixels or in percent of the picture from 0% to 100%, such \
         as 10%,0,80%,400; what is erased or kept can also be in mm of the figure, such as 10mm,5mm,30mm,20mm"
    )]
    NotACrop,
    /// The text says no grid of sheets.
    #[error("give how many sheets across and down, from 1x2 to 9x9, such as 2x2")]
    NotASheetGrid,
    /// The text is no sign of a texture.
    #[error("give dot, or rhombus and a direction from 0 to below 180 degrees, such as rhombus 45")]
    NotASign,
    /// The text says no place along a side of a picture.
    #[error("give a number of pixels, such as 412.5, or a percentage, such as 30%")]
    NotAPosition,
    /// A list of labels has rows that are none; every fault is listed, each with its line.
    #[error("{}", .0.join("; "))]
    NotLabels(Vec<String>),
    /// The page is larger than can be felt.
    #[error(
        "the figure is {width} x {height} mm, and at most {longest} x {longest} mm can be felt; \
         check the page's size in mm"
    )]
    TooLargeToFeel {
        /// Width of all that is drawn, mm.
        width: f32,
        /// Its height, mm.
        height: f32,
        /// The limit, mm.
        longest: f32,
    },
    /// There is no such fingertip, mm.
    #[error(
        "a fingertip of {0} mm is not known; give one from {low} to {high} mm",
        low = FINGERS.start(),
        high = FINGERS.end()
    )]
    NoSuchFinger(f32),
    /// What is to be read as a page is none: another kind of file, an SVG without the layers of a page, or one of an
    /// impossible size. What is an SVG and broken is [`Error::Undecodable`].
    #[error("this cannot be read as a page: {why}; {remedy}")]
    NotAPage {
        /// What it is instead, or what it lacks.
        why: &'static str,
        /// What the user can do.
        remedy: &'static str,
    },
    /// What is to be converted is a page already.
    #[error(
        "this is a page that tactograph made, and no picture; render it to write it in another format or for \
         another device"
    )]
    IsAPage,
    /// What is to be converted is a page already, in a format from which pages are not read.
    #[error("this is a {format} of a page that tactograph made, and no picture; render the SVG of the page instead")]
    IsAPageIn {
        /// What the format is called.
        format: &'static str,
    },
    /// There is nothing of this name: no profile, device, format, language.
    #[error("there is no {what} called {}{} {}", quoted(.name), take_one(.nearest), .known.join(", "))]
    NoSuchName {
        /// Of what kind it would be.
        what: &'static str,
        /// What was asked for.
        name: String,
        /// The names that there are.
        known: Vec<String>,
        /// Those of them that may have been meant, as they are spelt alike.
        nearest: Vec<String>,
    },
    /// Lines are given that belong to another picture, or another part of it.
    #[error(
        "the lines given are of a figure {lines:.2} times as wide as high, and the picture is {picture:.2} times; \
         give the lines of a page of this picture, and the same part of it"
    )]
    OtherShape {
        /// Width of the figure of the lines by its height.
        lines: f32,
        /// The same of the picture.
        picture: f32,
    },
    /// Lines or areas are given of a page that shows another part of the picture.
    #[error(
        "the page given as lines or areas shows {page}, and {drawn} is to be drawn: its lines would lie over something \
         else; draw the same part of the picture as that page, or give a page of this part"
    )]
    OtherPart {
        /// What the page shows.
        page: String,
        /// What is to be drawn.
        drawn: String,
    },
    /// There is no memory left.
    #[error("there is no memory for {what}")]
    NoMemory {
        /// For what.
        what: &'static str,
    },
    /// The caller did not want it any more: see [`Options::cancelled`](crate::Options::cancelled).
    #[error("cancelled; no page was made")]
    Cancelled,
    /// The profile cannot be used; every fault is listed.
    #[error("{}", crate::profile::faults_in_one_line(.0))]
    Profile(Vec<Fault>),
}

#[cfg(test)]
mod tests;
