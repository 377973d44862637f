//! Options that say what pages are called and what is on them.

use std::path::PathBuf;

use clap::Args;
use tactograph::Options;

use super::labels::Labels;
use super::pages::Pages;

/// Words for the page.
#[derive(Debug, Args)]
pub(in crate::cli) struct Words {
    /// What the page is called, for one picture
    ///
    /// Written in braille above the figure, or in the key if it has no room there; shown by viewers and read out by
    /// screen readers. --no-braille leaves the braille out. The file name is never written on a page.
    ///
    /// [default: the picture's file name]
    #[arg(long, value_name = "TEXT", value_parser = words, allow_hyphen_values = true)]
    title: Option<String>,

    /// What is on the page, in your words, for one picture
    ///
    /// Read out by screen readers in place of the picture. Say what one could not guess from the file's name.
    ///
    /// [default: what "tactograph describe" says of the page]
    #[arg(long, value_name = "TEXT", value_parser = words, allow_hyphen_values = true)]
    alt: Option<String>,

    /// Titles and descriptions of several pictures: a CSV file with the columns file, title and alt
    ///
    /// Its first line has the names of the columns; alt can be missing. Pictures are found by their names, with or
    /// without their directories; titles are never made of names. A picture without a row has no title, and you are
    /// told; so you are of one whose row is empty, and of a row without a picture.
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["title", "alt"], hide_short_help = true)]
    pub(in crate::cli) titles: Option<PathBuf>,

    /// Language of --title, --alt, --titles, --labels and --ocr, such as de or fr-CA
    ///
    /// With it a screen reader speaks them well, and braille is written in the code of the language.
    ///
    /// The description that is made without --alt is in it too, if it is en, de, es, fr or pl; otherwise it is in
    /// English, and is marked as English.
    ///
    /// [default: en]
    #[arg(long, value_name = "TAG", value_parser = language, hide_short_help = true)]
    lang: Option<String>,
}

/// A text that a screen reader has something to say of.
fn words(text: &str) -> Result<String, String> {
    if text.trim().is_empty() { Err("give some words, or leave the option out".into()) } else { Ok(text.into()) }
}

impl Words {
    /// Puts the words into the options of the library; those of a table are added elsewhere.
    pub(in crate::cli) fn add_to(&self, options: Options) -> Options {
        let options = self.title.iter().fold(options, |options, title| options.title(title));
        let options = self.alt.iter().fold(options, |options, alt| options.description(alt));
        self.lang.iter().fold(options, |options, lang| options.language(lang))
    }

    /// Whether there are titles, which are written in braille.
    pub(in crate::cli) fn has_title(&self) -> bool {
        self.title.is_some() || self.titles.is_some()
    }

    /// The language of the words.
    pub(in crate::cli) fn language(&self) -> &str {
        self.lang.as_deref().unwrap_or("en")
    }

    /// Everything that is wrong with words for so many pictures, or so many pages of one; for a directory that is
    /// watched, nobody knows how many.
    pub(super) fn faults(&self, labels: &Labels, pictures: Option<usize>, pages: Option<Pages>) -> Vec<String> {
        let pages = pages.map_or(1, |pages| pages.numbers().count());
        let of_pages = (self.titles.is_some() && pages > 1).then(|| {
            format!("--titles: a row is for one page, but there are {pages} of each picture; convert them one by one")
        });
        of_pages.into_iter().chain(self.for_many(labels, pictures, pages)).collect()
    }

    /// What is wrong if one picture's words are given to several.
    fn for_many(&self, labels: &Labels, pictures: Option<usize>, pages: usize) -> Option<String> {
        let given = [
            ("--title", self.title.is_some()),
            ("--alt", self.alt.is_some()),
            ("--labels", labels.is_for_one_picture()),
            ("--number", labels.is_numbered()),
        ];
        let given: Vec<&str> = given.iter().filter(|(_, given)| *given).map(|(option, _)| *option).collect();
        let which = match given[..] {
            ["--number"] => "this page number is",
            [.., "--number"] => "these are",
            _ => "these words are",
        };
        let given = given.join(" and ");
        let many = match pictures {
            None => "and --watch is for many; convert it by itself".to_owned(),
            Some(1) if pages > 1 => format!("but there are {pages} pages; convert them one by one"),
            Some(pictures) if pictures > 1 => format!("but there are {pictures}; convert them one by one"),
            Some(_) => return None,
        };
        (!given.is_empty()).then(|| format!("{given}: {which} for one picture, {many}"))
    }
}

/// The shape of a language tag (BCP 47): letters and digits in groups of up to eight, the first of two or three
/// letters.
fn language(text: &str) -> Result<String, String> {
    let mut groups = text.split('-');
    let first = groups
        .next()
        .is_some_and(|group| matches!(group.len(), 2 | 3) && group.bytes().all(|byte| byte.is_ascii_alphabetic()));
    let others =
        groups.all(|group| (1..=8).contains(&group.len()) && group.bytes().all(|byte| byte.is_ascii_alphanumeric()));
    if first && others { Ok(text.into()) } else { Err("give a language tag, such as de or fr-CA".into()) }
}
