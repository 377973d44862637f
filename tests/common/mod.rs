//! What several tests share.

pub(crate) mod apart;
pub(crate) mod drawn;
pub(crate) mod families;
pub(crate) mod page;
pub(crate) mod samples;
