//! Tests of `args`.

use super::*;

#[test]
fn the_definitions_agree_with_each_other() {
    Cli::command().debug_assert();
}

/// It names them in texts of its own, where clap would give each a line.
#[test]
fn the_help_names_every_format() {
    use tactograph::Format;
    let mut command = Cli::command();
    let convert = command.find_subcommand_mut("convert").expect("a command");
    let help = convert.render_long_help().to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    let names = |of: &dyn Fn(&Format) -> bool| {
        Format::ALL.iter().filter(|format| of(format)).map(|format| format.name()).collect::<Vec<_>>().join(", ")
    };
    let (all, without_seal) = (names(&|_| true), names(&|format| format.is_as_written(&[]).is_none()));
    assert!(help.contains(&format!("[possible values: {all}]")), "{help}");
    assert!(help.contains(&format!("format cannot tell that ({without_seal})")), "{help}");
}
