//! The command-line program `tactograph`; everything it does is in `cli`, everything it draws in the library.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
