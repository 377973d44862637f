//! What was found as text that is read aloud, and as data.

use std::fmt;

use serde_json::{Value, json};

use super::finding::Finding;
use super::limits::RuleLimits;
use super::rules::{RULES, Rule, Severity};
use super::verdict::{Textures, Verdict};
use crate::units::{MmPoint, MmRect};
use crate::{About, Note, Reason};

/// What was found on a page. Its `Display` has a line for each finding, errors first, and the verdict at the end.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Checked {
    /// Every breach of a rule: errors first, in the order of the rules, then from the top of the sheet down.
    pub findings: Vec<Finding>,
    /// The numbers that the page was held against.
    pub(crate) limits: RuleLimits,
    /// All of it in one sentence.
    pub verdict: Verdict,
    /// What of the page was taken otherwise than it looks, or left out, when it was read.
    pub notes: Vec<Note>,
}

impl Checked {
    /// How many errors there are.
    pub fn errors(&self) -> usize {
        self.findings.iter().filter(|finding| finding.is_error()).count()
    }

    /// How many warnings there are.
    pub fn warnings(&self) -> usize {
        self.findings.len() - self.errors()
    }

    /// The number that a rule asks for on this page and its unit, as [`Rule::limit`] gives it for a profile.
    pub fn limit(&self, rule: &Rule) -> Option<(f32, &'static str)> {
        rule.number(&self.limits)
    }

    /// The same as JSON: how many `errors` and `warnings`; `verdict`, and the shares 0..=1 that it tells of: `faulty`
    /// of the figure, and of `textures` what is `of_figure`, `judged` and `right` (null where none were felt);
    /// `findings` with `rule`, `severity`, `place`, `at_mm` and `box_mm` (from the sheet's top left), `what`,
    /// `measured`, `limit`, `unit`, `remedy`, `render` (what that makes of it, or null), `object` (its name, or null),
    /// `line` (of the file, or null); and `notes`, what was taken otherwise than it looks, with `id`, `about`, `reason`
    /// (null where there is none) and `what`.
    pub fn to_json(&self) -> String {
        let finding = |finding: &Finding| {
            let (limit, unit) = self.number(&finding.rule);
            json!({
                "rule": finding.rule.id,
                "severity": finding.severity().name(),
                "place": finding.place,
                "at_mm": finding.at.map(point),
                "box_mm": finding.extent.map(corners),
                "what": finding.what,
                "measured": finding.measured.map(rounded),
                "limit": limit,
                "unit": unit,
                "remedy": finding.remedy(),
                "render": finding.mended,
                "object": finding.object,
                "line": finding.line,
            })
        };
        let note = |note: &Note| {
            json!({
                "id": note.id(),
                "about": note.about().map(About::name),
                "reason": note.reason().map(Reason::name),
                "what": note.to_string(),
            })
        };
        let findings: Vec<Value> = self.findings.iter().map(finding).collect();
        let (errors, warnings) = (self.errors(), self.warnings());
        let textures = self.verdict.textures.map(|Textures { of_figure, judged, right, .. }| {
            // of what was not judged nothing is said
            let right = (judged > 0.0).then(|| rounded(right));
            json!({ "of_figure": rounded(of_figure), "judged": rounded(judged), "right": right })
        });
        let all = json!({
            "errors": errors,
            "warnings": warnings,
            "verdict": self.verdict.to_string(),
            "faulty": rounded(self.verdict.faulty),
            "textures": textures,
            "findings": findings,
            "notes": self.notes.iter().map(note).collect::<Vec<_>>(),
        });
        format!("{all:#}\n")
    }

    /// The same as SARIF 2.1.0 (OASIS), for programs that collect what checkers find. `file` is the page's name, which
    /// becomes a URI (RFC 3986). Places are lines of the file, or its first where it is a matter of no one element;
    /// those on the sheet are in messages and, in mm, in properties, as SARIF has none for drawings. Objects are
    /// elements among the logical locations.
    pub fn to_sarif(&self, file: &str) -> String {
        let rule = |rule: &Rule| {
            let (number, unit) = self.number(rule);
            json!({
                "id": rule.id,
                "shortDescription": { "text": rule.asks },
                "help": { "text": rule.remedy },
                "defaultConfiguration": { "level": rule.severity.name() },
                "properties": { "number": number, "unit": unit, "source": rule.source },
            })
        };
        let result = |finding: &Finding| {
            let object = finding.object.as_ref().map(|name| json!({ "name": name, "kind": "element" }));
            json!({
                "ruleId": finding.rule.id,
                "level": finding.severity().name(),
                "message": { "text": format!("{}: {}; {}", place(finding), finding.what, finding.remedy()) },
                "locations": [{
                    // viewers show nothing without a region
                    "physicalLocation": {
                        "artifactLocation": { "uri": uri(file) },
                        "region": { "startLine": finding.line.unwrap_or(1) },
                    },
                    "logicalLocations": object.into_iter().collect::<Vec<_>>(),
                }],
                "properties": {
                    "place": finding.place,
                    "at_mm": finding.at.map(point),
                    "box_mm": finding.extent.map(corners),
                },
            })
        };
        let rules: Vec<Value> = RULES.iter().map(rule).collect();
        let results: Vec<Value> = self.findings.iter().map(result).collect();
        let driver = json!({ "name": "tactograph", "version": env!("CARGO_PKG_VERSION"), "rules": rules });
        let run = json!({ "tool": { "driver": driver }, "results": results });
        let schema = "https://json.schemastore.org/sarif-2.1.0.json";
        format!("{:#}\n", json!({ "$schema": schema, "version": "2.1.0", "runs": [run] }))
    }

    fn number(&self, rule: &Rule) -> (Option<f64>, Option<&'static str>) {
        self.limit(rule).map_or((None, None), |(number, unit)| (Some(rounded(number)), Some(unit)))
    }
}

/// A file's name as a reference by RFC 3986, as SARIF asks for: `/` between its parts, also for `\`, and all but the
/// unreserved characters as bytes in hex. The colon too: what stands before one would be a scheme.
fn uri(file: &str) -> String {
    let written = |byte: u8| match byte {
        b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => char::from(byte).to_string(),
        b'\\' => "/".to_owned(),
        _ => format!("%{byte:02X}"),
    };
    file.bytes().map(written).collect()
}

fn rounded(value: f32) -> f64 {
    (f64::from(value) * 100.0).round() / 100.0
}

fn point(at: MmPoint) -> [f64; 2] {
    [at.x, at.y].map(rounded)
}

fn corners(extent: MmRect) -> [f64; 4] {
    [extent.min.x, extent.min.y, extent.max.x, extent.max.y].map(rounded)
}

/// Where something was found, in words and in mm.
fn place(finding: &Finding) -> String {
    let at = finding.at.map(|at| format!(", {:.0} mm from the left and {:.0} mm from the top", at.x, at.y));
    format!("{}{}", finding.place, at.unwrap_or_default())
}

impl Finding {
    /// What to do about it: what its rule says, and where `render` puts it right that this may be printed.
    pub fn remedy(&self) -> String {
        match self.mended {
            Some(mended) => {
                format!("print what render makes of the page, as it {mended}; or {}", self.rule.remedy)
            }
            None => self.rule.remedy.to_owned(),
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}: {}", self.severity().name(), self.rule.id, place(self))?;
        write!(f, ": {}. What to do: {}.", self.what, self.remedy())
    }
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.findings.iter().try_for_each(|finding| writeln!(f, "{finding}"))?;
        writeln!(f, "{}", self.verdict)
    }
}

/// The rules as text, one a line, with their numbers for pages of a profile.
pub fn rules_as_text(limits: &RuleLimits) -> String {
    let line = |rule: &Rule| {
        let number = rule.number(limits).map_or_else(String::new, |(number, unit)| format!(" ({number} {unit})"));
        let severity = if rule.severity == Severity::Error { "error" } else { "warning" };
        format!(
            "{}, {severity}{number}: {} Source: {}. What to do: {}.\n",
            rule.id, rule.asks, rule.source, rule.remedy
        )
    };
    RULES.iter().map(line).collect()
}

/// The same as JSON: an array with `rule`, `severity`, `number` and `unit` (null where it asks for none), `asks`,
/// `source` and `remedy`.
pub fn rules_as_json(limits: &RuleLimits) -> String {
    let of = |rule: &Rule| {
        let (number, unit) = rule.number(limits).map(|(number, unit)| (rounded(number), unit)).unzip();
        json!({
            "rule": rule.id,
            "severity": rule.severity.name(),
            "number": number,
            "unit": unit,
            "asks": rule.asks,
            "source": rule.source,
            "remedy": rule.remedy,
        })
    };
    format!("{:#}\n", Value::Array(RULES.iter().map(of).collect()))
}
