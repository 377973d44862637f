//! Errors that are made in several places.

use super::Error;
use crate::profile::{Fault, nearest};

impl Error {
    /// Bytes of this format that cannot be decoded, and why.
    pub(crate) fn undecodable(format: &'static str, why: impl Into<String>) -> Self {
        Self::Undecodable { format, why: why.into() }
    }

    /// A sound file with too much of something.
    pub(crate) fn too_complex(format: &'static str, why: impl Into<String>) -> Self {
        Self::TooComplex { format, why: why.into() }
    }

    /// No one of `known` is called `name`; where `near` is empty, those spelt like it are the ones that may be meant.
    pub(crate) fn no_such_name(what: &'static str, name: &str, known: &[&str], near: Vec<&str>) -> Self {
        let near = if near.is_empty() { nearest(name, known.iter().map(|&one| (one, one))).offers } else { near };
        let owned = |names: &[&str]| names.iter().map(|&one| one.to_owned()).collect();
        Self::NoSuchName { what, name: name.to_owned(), known: owned(known), nearest: owned(&near) }
    }
}

/// The one of `all` that is called `name`; `what` says of what kind they are.
///
/// # Errors
/// [`Error::NoSuchName`] with the names that there are.
pub(crate) fn named<T: Copy>(
    name: &str,
    what: &'static str,
    all: impl IntoIterator<Item = T> + Clone,
    name_of: impl Fn(T) -> &'static str,
) -> Result<T, Error> {
    let found = all.clone().into_iter().find(|one| name_of(*one) == name);
    found.ok_or_else(|| {
        let known: Vec<&str> = all.into_iter().map(name_of).collect();
        Error::no_such_name(what, name, &known, Vec::new())
    })
}

impl From<Vec<Fault>> for Error {
    fn from(faults: Vec<Fault>) -> Self {
        Self::Profile(faults)
    }
}

impl From<Fault> for Error {
    fn from(fault: Fault) -> Self {
        Self::Profile(vec![fault])
    }
}
