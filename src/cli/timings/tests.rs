//! Tests of `timings`.

use super::*;

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
    let table_of_one_of_many = stopped.table("a.png");
    let names =
        table_of_one_of_many.iter().map(|line| line.split_whitespace().next().unwrap_or("")).collect::<Vec<_>>();
    assert_eq!(names, ["timings", "read", "edges", "lines", "overview", "together", "textures", "write", "total"]);
    let table_of_one = table(true).table("a.png");
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
    assert_eq!(stopped.table("a.png"), table);
}

#[test]
fn a_stage_of_which_a_part_ran_is_one_row_with_its_time() {
    let part = [Event::Begin(Stage::Regions), Event::End(Stage::Regions)];
    let skipped = [Event::Skip(Stage::Regions, "the picture is a drawing")];
    for events in [[&skipped[..], &part].concat(), [&part[..], &skipped].concat()] {
        let timings = Timings::start(false);
        events.into_iter().for_each(|event| timings.watch(event));
        let table = timings.stop().table("a.png");
        assert!(table.len() == 3 && table[1].starts_with("  regions ") && table[1].ends_with(" ms"), "{table:?}");
    }
}
