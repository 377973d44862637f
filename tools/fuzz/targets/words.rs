#![no_main]

tactograph_fuzz::run!("words");
