#![no_main]

tactograph_fuzz::run!("labels");
