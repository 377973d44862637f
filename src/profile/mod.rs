//! stub
/// One fault in a profile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Where: a file's name and line, or the option.
    pub place: String,
    /// What is wrong and what would do.
    pub what: String,
}

pub(crate) fn faults_in_one_line(faults: &[Fault]) -> String {
    faults.iter().map(|f| format!("{}: {}", f.place, f.what)).collect::<Vec<_>>().join("; ")
}

/// A page's settings.
#[derive(Debug, Clone, Default)]
pub struct Profile {}
/// A checked profile.
#[derive(Debug, Clone, Default)]
pub struct Plan {}
