//! The list of named colours, `named.csv`: what a person would say against what the program says.

use tactograph::internals::classes::class_of;
use tactograph::internals::pipeline::colours;
use tactograph::internals::profile::{Plan, Profile};

/// Share of the names that must agree.
const WANTED: f32 = 0.95;

struct Named {
    name: &'static str,
    rgb: [f32; 3],
    class: &'static str,
}

fn list() -> Vec<Named> {
    let rows = include_str!("named.csv").lines().filter(|line| !line.starts_with(['#']) && !line.starts_with("name,"));
    rows.map(|row| {
        let mut fields = row.splitn(4, ',');
        let mut field = || fields.next().expect("every row has four fields");
        let (name, code, class) = (field(), field(), field());
        let code = u32::from_str_radix(code, 16).expect("a colour in hexadecimal");
        let rgb = [16, 8, 0].map(|shift| (code >> shift & 0xff) as f32 / 255.0);
        Named { name, rgb, class }
    })
    .collect()
}

#[test]
fn named_colours_are_sorted_as_a_person_would_say() {
    let plan = Plan::new(&Profile::named("swell-a4").expect("it is built in")).expect("it makes sense");
    let params = colours::params(&plan);
    let list = list();
    assert!(list.len() >= 120, "only {} names", list.len());
    let said = |named: &Named| class_of(named.rgb, &params).map_or("white", |class| class.name());
    let missed: Vec<String> = list
        .iter()
        .filter(|named| said(named) != named.class)
        .map(|named| format!("{} is {}, not {}", named.name, named.class, said(named)))
        .collect();
    let share = 1.0 - missed.len() as f32 / list.len() as f32;
    println!("{:.1} % of {} named colours agree; missed: {}", 100.0 * share, list.len(), missed.join("; "));
    assert!(share >= WANTED, "{share}: {missed:?}");
}
