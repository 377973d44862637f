//! What became of each picture, as JSON: for `--report`.

use std::path::Path;
use std::time::Duration;

use serde_json::{Value, json};
use tactograph::{Checked, Page, PageOptions, check};

use super::places::{self, Job};
use super::{output, panics};

/// What is known of a picture whose page is written.
pub(super) struct Written<'a> {
    pub(super) pages: &'a [String],
    pub(super) previews: &'a [String],
    /// What [`checked`] says of its sheets.
    pub(super) sheets: &'a [Value],
    pub(super) notes: Vec<String>,
    /// All labels that are not on the page, by the reason why.
    pub(super) labels_left_out: &'a [(Vec<String>, &'static str)],
}

/// The report of a run, picture by picture.
pub(super) struct Record {
    profile: String,
    format: &'static str,
    notes: Vec<Value>,
    pictures: Vec<Value>,
    failed: usize,
}

impl Record {
    /// A run with this profile and format; `notes` are those that are of no picture, each with what it is about.
    pub(super) fn new(profile: &str, format: &'static str, notes: &[(String, String)]) -> Self {
        let notes = notes.iter().map(|(about, what)| json!({ "about": about, "what": what }));
        Self { profile: profile.to_owned(), format, notes: notes.collect(), pictures: Vec::new(), failed: 0 }
    }

    /// A picture whose page is written.
    pub(super) fn done(&mut self, job: &Job, written: &Written<'_>, took: Duration) {
        let Written { pages, previews, sheets, notes, labels_left_out } = written;
        let labels = labels_left_out.iter().map(|(texts, why)| json!({ "texts": texts, "why": why }));
        let mut entry = self.entry(job, took);
        entry["done"] = json!(true);
        entry["outputs"] = json!(pages);
        entry["previews"] = json!(previews);
        entry["sheets"] = json!(sheets);
        entry["notes"] = json!(notes);
        entry["labels_left_out"] = labels.collect();
        self.pictures.push(entry);
    }

    /// A picture whose page is not written: what stood in the way, or nothing if it was a fault of this program.
    pub(super) fn failed(&mut self, job: &Job, why: Option<(&str, &str)>, took: Option<Duration>) {
        let mut entry = self.entry(job, took.unwrap_or_default());
        let of_program = (places::job_name(job), panics::line());
        let (about, what) = why.unwrap_or((&of_program.0, &of_program.1));
        entry["error"] = json!({ "about": about, "what": what });
        if took.is_none() {
            entry["time_ms"] = Value::Null;
        }
        self.pictures.push(entry);
        self.failed += 1;
    }

    fn entry(&self, job: &Job, took: Duration) -> Value {
        json!({
            "picture": places::picture_name(&job.picture),
            "page": job.page,
            "done": false,
            "outputs": [],
            "previews": [],
            "sheets": [],
            "notes": [],
            "labels_left_out": [],
            "error": null,
            "time_ms": milliseconds(took),
        })
    }

    /// Writes it to a file, or to standard output.
    ///
    /// # Errors
    /// In plain words, without the path.
    pub(super) fn write(&self, path: &Path, took: Duration) -> anyhow::Result<()> {
        let all = json!({
            "program": concat!("tactograph ", env!("CARGO_PKG_VERSION")),
            "profile": self.profile,
            "format": self.format,
            "pictures": self.pictures,
            "failed": self.failed,
            "notes": self.notes,
            "time_ms": milliseconds(took),
        });
        let text = format!("{all:#}\n");
        if places::is_std(path) {
            output::to_stdout(text.as_bytes(), "report")
        } else {
            output::to_file(path, text.as_bytes(), "report")
        }
    }
}

/// What `tactograph check` says of a page, as it says it with `--format json`, with the page's title, if it was given
/// one.
pub(super) fn checked(page: &Page) -> Value {
    let read = |checked: Checked| serde_json::from_str(&checked.to_json()).unwrap_or(Value::Null);
    let mut sheet = match check(page.to_svg(), &PageOptions::new()) {
        Ok(checked) => read(checked),
        Err(error) => json!({ "verdict": null, "why": error.to_string() }),
    };
    sheet["title"] = json!(given_title(page));
    sheet
}

/// The title of a page; none of one that is called as the file of its picture, as nobody gave it a title.
fn given_title(page: &Page) -> Option<&str> {
    let picture = page.origin.iter().find(|(name, _)| name == "picture").map(|(_, file)| file.as_str());
    // a sheet of several, an overview and a key say what they are behind it
    let rest = picture.and_then(|file| page.title.strip_prefix(file));
    let is_file = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(", "));
    (!is_file).then_some(page.title.as_str())
}

fn milliseconds(took: Duration) -> f64 {
    (took.as_secs_f64() * 1e4).round() / 10.0
}
