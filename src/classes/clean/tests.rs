//! Tests of `clean`.

use super::*;
use crate::classes::class::Params;
use crate::raster::Planes;

/// Classes by their first letters; `g` is a green that is nearly blue.
fn read(map: &str) -> (Vec<ComponentLabel>, Vec<Membership>, BlurCells) {
    let rows: Vec<&str> = map.split_whitespace().collect();
    let size = Size::new(rows[0].len() as u32, rows.len() as u32);
    let rgb = |c| match c {
        'B' => [0.1, 0.2, 0.9],
        'G' => [0.1, 0.8, 0.2],
        'g' => [0.1, 0.8, 0.69],
        'R' => [0.9, 0.1, 0.1],
        _ => [1.0; 3],
    };
    let colours: Vec<[f32; 3]> = rows.iter().flat_map(|row| row.chars().map(rgb)).collect();
    let memberships: Vec<Membership> = colours.iter().map(|rgb| hue::membership(*rgb, &Params::TEST)).collect();
    let planes = Planes::Colour([0, 1, 2].map(|channel| colours.iter().map(|rgb| rgb[channel]).collect()));
    let grid = BlurCells { size, planes, weight: vec![1.0; size.len()], conductance: Conductance::open(size) };
    (memberships.iter().map(Membership::label).collect(), memberships, grid)
}

fn written(labels: &[ComponentLabel], size: Size) -> String {
    let letter =
        |label: &ComponentLabel| label.map_or('.', |class| class.name().to_uppercase().chars().next().unwrap_or('?'));
    let rows: Vec<String> = labels.chunks(size.width as usize).map(|row| row.iter().map(letter).collect()).collect();
    rows.join(" ")
}

#[track_caller]
fn small(before: &str, min_cells: f32, after: &str) {
    let (labels, memberships, grid) = read(before);
    assert_eq!(written(&join_small(labels, &memberships, &grid, min_cells), grid.size), after);
}

#[test]
fn a_small_area_joins_the_neighbour_around_it() {
    small("BBBBBB BBRRBB BBRRBB BBBB.. ......", 5.0, "BBBBBB BBBBBB BBBBBB BBBB.. ......");
}

#[test]
fn a_small_area_joins_the_neighbour_that_it_resembles() {
    // One cell less of border with blue, but nearly blue itself.
    small("RRRRRR RRggRR BBggBB BBBBBB", 5.0, "RRRRRR RRBBRR BBBBBB BBBBBB");
    small("RRRRRR RRRRRR RRGGRR BBBBBB", 5.0, "RRRRRR RRRRRR RRRRRR BBBBBB");
}

#[test]
fn one_area_stays_however_small() {
    small("GG GG", 100.0, "GG GG");
}

#[test]
fn an_undecided_area_joins_a_larger_neighbour_unless_a_contour_lies_between() {
    let map = "BBBBBB BBBBBB gggBBB gggBBB";
    let (labels, memberships, grid) = read(map);
    assert_eq!(written(&labels, grid.size), "BBBBBB BBBBBB GGGBBB GGGBBB");
    let calm = join_undecided(labels.clone(), &memberships, &grid, 5.0);
    assert_eq!(written(&calm, grid.size), "BBBBBB BBBBBB BBBBBB BBBBBB");
    let same = |cell: usize, other: usize| labels[cell] == labels[other];
    let parted = BlurCells { conductance: Conductance::between(grid.size, same), ..grid };
    assert_eq!(join_undecided(labels.clone(), &memberships, &parted, 5.0), labels);
}

#[test]
fn regions_are_connected_by_their_sides_and_have_a_colour() {
    let (labels, _, grid) = read("BB.R B..R .BB.");
    let (of_cell, regions) = regions(&labels, &grid);
    let sizes: Vec<u32> = regions.iter().map(|r| r.cells).collect();
    assert_eq!(sizes, [3, 2, 2]);
    assert_eq!(of_cell[3], Some(1));
    assert_eq!(of_cell[2], None);
    // 0.9 and 0.1 of linear light
    assert_eq!(regions[1].colour, [243, 89, 89]);
}
