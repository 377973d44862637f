//! The library as a browser runs it: WebAssembly in Node.js, whose engine is that of Chromium.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::measured::Job;
use crate::ours::Ours;

/// WebAssembly that may read and write files.
const TARGET: &str = "wasm32-wasip1";
/// Vectors, which all browsers have.
const FLAGS: &str = "-C target-feature=+simd128";

/// Builds the library for it and makes the job that runs it; none if the target is missing, which is told, or Node.js,
/// which is told with the other programs.
pub(crate) fn job(name: &str, picture: &str, ours: &Ours, target: &Path) -> Option<Job> {
    if !Command::new("node").arg("--version").stdout(Stdio::null()).status().is_ok_and(|ended| ended.success()) {
        return None;
    }
    let Some(program) = built(target) else {
        eprintln!(
            "the library could not be built for {TARGET}: its row is left out; run tools/src/bin/bench_all/peers.sh"
        );
        return None;
    };
    let page = ours.page("browser.svg");
    // it sees the file system from its root
    let picture = std::fs::canonicalize(picture).map_err(|fault| eprintln!("{picture}: {fault}")).ok()?;
    let words = ["node".as_ref(), "--no-warnings".as_ref(), "tools/browser/run.mjs".as_ref(), program.as_os_str()];
    Some(Job::new(name, words.into_iter().chain([picture.as_os_str(), page.as_os_str()])).writes(&page))
}

fn built(target: &Path) -> Option<PathBuf> {
    let folder = target.join("bench/browser");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let ended = Command::new(cargo)
        .args(["build", "--release", "--manifest-path", "tools/browser/Cargo.toml", "--target", TARGET, "--target-dir"])
        .arg(&folder)
        .env("RUSTFLAGS", FLAGS)
        .status();
    let program = folder.join(TARGET).join("release/tactograph-browser.wasm");
    (ended.is_ok_and(|ended| ended.success()) && program.is_file()).then_some(program)
}
