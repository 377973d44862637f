//! Tests of `timings`.

use super::*;

/// A table without the row of what lies between stages, which tests on a busy machine may have.
fn of_stages(stopped: &Stopped) -> Vec<String> {
    stopped.table("a.png").into_iter().filter(|line| !line.starts_with("  other ")).collect()
}

#[test]
fn the_table_lists_stages_in_order_with_skips_and_a_total() {
    let table = |is_alone: bool| {
        let timings = Timings::start(is_alone);
        timings.step("read", || ());
        timings.watch(Event::Begin(Stage::Lines));
        timings.watch(Event::Begin(Stage::Overview)); // beside another
        timings.watch(Event::End(Stage::Overview));
        timings.watch(Event::End(Stage::Lines));
        timings.watch(Event::Skip(Stage::Textures, "figure.textures = false"));
        timings.watch(Event::Begin(Stage::Edges));
        timings.watch(Event::End(Stage::Edges));
        timings.watch(Event::Begin(Stage::Edges)); // a second part: the same row
        timings.watch(Event::End(Stage::Edges));
        timings.step("write", || ());
        timings.stop()
    };
    let stopped = table(false);
    let table_of_one_of_many = of_stages(&stopped);
    let names =
        table_of_one_of_many.iter().map(|line| line.split_whitespace().next().unwrap_or("")).collect::<Vec<_>>();
    assert_eq!(names, ["timings", "read", "edges", "lines", "overview", "together", "textures", "write", "total"]);
    let table_of_one = of_stages(&table(true));
    let end = if worked().is_some() { " ms CPU" } else { " ms" };
    for (table, end) in [(&table_of_one_of_many, " ms"), (&table_of_one, end)] {
        assert_eq!(table[6], "  textures  skipped: figure.textures = false");
        for line in [&table[1], &table[2], &table[5], &table[7], &table[8]] {
            assert!(line.ends_with(end) && line.len() == table[1].len(), "not aligned: {line}");
        }
        for line in [&table[3], &table[4]] {
            let time = line.strip_suffix(" side by side").map(str::len);
            assert_eq!(time, Some(table_of_one_of_many[1].len()), "{line}");
        }
    }
    let table = table_of_one_of_many;
    std::thread::sleep(Duration::from_millis(2)); // waiting for its turn is not work on the picture
    assert_eq!(of_stages(&stopped), table);
}

#[test]
fn a_stage_of_which_a_part_ran_is_one_row_with_its_time() {
    let part = [Event::Begin(Stage::Regions), Event::End(Stage::Regions)];
    let skipped = [Event::Skip(Stage::Regions, "the picture is a drawing")];
    for events in [[&skipped[..], &part].concat(), [&part[..], &skipped].concat()] {
        let timings = Timings::start(false);
        events.into_iter().for_each(|event| timings.watch(event));
        let table = of_stages(&timings.stop());
        assert!(table.len() == 3 && table[1].starts_with("  regions ") && table[1].ends_with(" ms"), "{table:?}");
    }
}

#[test]
fn what_no_stage_tells_of_is_a_row_of_its_own() {
    let timings = Timings::start(true);
    timings.step("read", || ());
    std::thread::sleep(Duration::from_millis(30));
    timings.watch(Event::Begin(Stage::Lines));
    timings.watch(Event::Begin(Stage::Overview)); // beside another
    std::thread::sleep(Duration::from_millis(2));
    timings.watch(Event::End(Stage::Lines));
    timings.watch(Event::End(Stage::Overview));
    let stopped = timings.stop();
    let took = |name: &str| {
        let row = stopped.0.iter().find(|(row_name, ..)| *row_name == name).map(|(_, row, _)| *row);
        let Some(Row::Took(time, _)) = row else { panic!("{name} has no time") };
        time
    };
    let names: Vec<&str> = stopped.0.iter().map(|(name, ..)| *name).collect();
    assert_eq!(names, ["read", "lines", "overview", TOGETHER, OTHER, "total"]);
    assert_eq!(took("read") + took(TOGETHER) + took(OTHER), took("total"));
    assert!(took(OTHER) >= Duration::from_millis(30));
}
