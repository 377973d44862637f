//! The program as its user meets it: what it is given, what it says, what it leaves behind and how it ends.

mod calibrate;
mod changed;
mod check;
mod common;
mod describe;
mod docs;
mod dots;
mod feel;
mod fitting;
mod formats;
mod louis;
mod newcomers;
mod pages;
mod pictures;
mod places;
mod preview;
mod profiles;
mod record;
mod render;
mod several;
mod tesseract;
mod titles;
mod trace;
mod watch;
mod words;
mod writing;
