//! Tests of `character`.

use super::*;
use crate::raster::Raster;
use crate::raster::residue::Polarity;

use super::super::glyph::{Thin, contrast, glyphs};
use super::super::levels::{Colours, Levels};

/// The first thin shape of a picture whose rows of pixels these are, four px each, in black on white.
fn like(rows: &[&str]) -> Vec<char> {
    const SCALE: usize = 4;
    const AROUND: usize = 12;
    let columns = rows[0].len() * SCALE + 2 * AROUND;
    let size = Size::new(columns as u32, (rows.len() * SCALE + 2 * AROUND) as u32);
    let is_ink = |x: usize, y: usize| {
        let row = y.checked_sub(AROUND).and_then(|y| rows.get(y / SCALE));
        let pixel = row.zip(x.checked_sub(AROUND)).and_then(|(row, x)| row.as_bytes().get(x / SCALE));
        pixel.is_some_and(|pixel| *pixel == b'#')
    };
    let light = (0..size.len()).map(|cell| if is_ink(cell % columns, cell / columns) { 0.0 } else { 1.0 });
    let raster = Raster::grey(size, light.collect());
    let colours = Colours::new(&raster, true);
    let plane = &colours.planes[0];
    let contrast = contrast(&Levels::of(plane), Polarity::Below, 10.0).expect("something thin");
    let thin = Thin { set: contrast.at_least_half(10.0), contrast };
    let found = glyphs(&thin, plane, &colours, |_, _| true);
    likenesses(&found[0], columns).iter().map(|like| like.character).collect()
}

#[test]
fn digits_and_capitals_look_like_themselves() {
    for (wanted, rows) in [
        ('0', [" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "]),
        ('2', [" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"]),
        ('3', [" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "]),
        ('7', ["#####", "    #", "   # ", "   # ", "  #  ", "  #  ", " #   "]),
        ('9', [" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "]),
        ('A', ["  #  ", "  #  ", " # # ", " # # ", " ### ", "#   #", "#   #"]),
        ('F', ["#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#    "]),
        ('R', ["#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"]),
        ('U', ["#   #", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "]),
    ] {
        let found = like(&rows);
        let of_kind = |of: &&char| of.is_ascii_digit() == wanted.is_ascii_digit();
        assert_eq!(found.iter().find(of_kind), Some(&wanted), "{found:?}");
    }
}

#[test]
fn other_small_shapes_look_like_none() {
    for rows in [
        // a window, an arrow, a note, a triangle, a plus
        ["#######", "#  #  #", "#  #  #", "#######", "#  #  #", "#  #  #", "#######"],
        ["   #   ", "  ###  ", " # # # ", "#  #  #", "   #   ", "   #   ", "   #   "],
        ["    #  ", "    ## ", "    # #", "    # #", "  ###  ", " ####  ", "  ##   "],
        ["   #   ", "  # #  ", "  # #  ", " #   # ", " #   # ", "#     #", "#######"],
        ["   #   ", "   #   ", "   #   ", "#######", "   #   ", "   #   ", "   #   "],
    ] {
        assert_eq!(like(&rows), [' '; 0], "{rows:?}");
    }
}
