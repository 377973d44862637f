//! Markdown tables.

/// A table with what is said before and after it.
pub(crate) struct Table {
    pub(crate) title: &'static str,
    pub(crate) about: String,
    pub(crate) head: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
    /// What follows it, as Markdown.
    pub(crate) after: String,
}

impl Table {
    pub(crate) fn new(title: &'static str, about: impl Into<String>, head: &[&str]) -> Self {
        Self {
            title,
            about: about.into(),
            head: head.iter().map(|&name| name.into()).collect(),
            rows: Vec::new(),
            after: String::new(),
        }
    }

    /// Without its title.
    pub(crate) fn body(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let mut text = line(&self.head);
        text += &line(&vec!["---".into(); self.head.len()]);
        text.extend(self.rows.iter().map(|row| line(row)));
        text
    }

    /// All of it.
    pub(crate) fn text(&self) -> String {
        let after = if self.after.is_empty() { String::new() } else { format!("{}\n", self.after) };
        format!("## {}\n\n{}\n\n{}\n{after}", self.title, self.about, self.body())
    }
}

/// Milliseconds, megabytes or a ratio with as many digits as it deserves; a dash for nothing.
pub(crate) fn number(value: Option<f64>) -> String {
    match value {
        None => "-".into(),
        Some(value) if value.abs() >= 9999.5 => format!("{:.0} thousand", value / 1e3),
        Some(value) if value.abs() >= 99.95 => format!("{value:.0}"),
        Some(value) if value.abs() >= 9.995 => format!("{value:.1}"),
        Some(value) if value.abs() >= 0.00995 || value == 0.0 => format!("{value:.2}"),
        Some(value) => format!("{value:.4}"),
    }
}

/// What [`number`] wrote, as far as its digits tell; nothing of a dash.
pub(crate) fn value(cell: &str) -> Option<f64> {
    match cell.strip_suffix(" thousand") {
        Some(thousands) => Some(1e3 * thousands.parse::<f64>().ok()?),
        None => cell.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits_or_so() {
        let shown = [None, Some(0.0), Some(0.00061), Some(-0.25), Some(9.999), Some(123.4), Some(76_334.0)].map(number);
        assert_eq!(shown, ["-", "0.00", "0.0006", "-0.25", "10.0", "123", "76 thousand"]);
    }

    #[test]
    fn numbers_are_read_again() {
        let read = ["-", "0.25", "123", "76 thousand"].map(value);
        assert_eq!(read, [None, Some(0.25), Some(123.0), Some(76_000.0)]);
    }
}
