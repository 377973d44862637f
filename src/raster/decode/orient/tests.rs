//! Tests of `orient`.

use super::*;

/// The letter F as the eight EXIF orientations store it, after the EXIF standard's own drawing (row 0 and column 0
/// of the stored picture are which sides of the scene).
#[test]
fn all_eight_orientations_stand_up() {
    let upright_f = "##\n#.\n##\n#.\n#.";
    for (exif, stored) in [
        (1, "##\n#.\n##\n#.\n#."),
        (2, "##\n.#\n##\n.#\n.#"),
        (3, ".#\n.#\n##\n.#\n##"),
        (4, "#.\n#.\n##\n#.\n##"),
        (5, "#####\n#.#.."),
        (6, "#.#..\n#####"),
        (7, "..#.#\n#####"),
        (8, "#####\n..#.#"),
    ] {
        let rows: Vec<&str> = stored.lines().collect();
        let size = Size::new(rows[0].len() as u32, rows.len() as u32);
        let plane = rows.concat().chars().map(|c| if c == '#' { 0.0 } else { 1.0 }).collect();
        let orientation = Orientation::from_exif(exif).unwrap();
        let out = upright(plane, size, orientation);
        let text: Vec<String> = out
            .chunks(turned(size, orientation).width as usize)
            .map(|row| row.iter().map(|&v| if v < 0.5 { '#' } else { '.' }).collect())
            .collect();
        assert_eq!(text.join("\n"), upright_f, "orientation {exif}");
    }
}

/// Cutting a part out of the stored picture and turning it is the same as turning the picture and cutting.
#[test]
fn parts_are_found_in_all_eight_orientations() {
    for exif in 1..=8 {
        let orientation = Orientation::from_exif(exif).unwrap();
        let stored = Size::new(7, 5);
        let plane: Vec<f32> = (0..35).map(|i| i as f32).collect();
        let cut = |plane: &[f32], width: u32, part: PixelPart| -> Vec<f32> {
            let rows = plane.chunks(width as usize).skip(part.top as usize).take(part.size.height as usize);
            rows.flat_map(|row| row[part.left as usize..][..part.size.width as usize].to_vec()).collect()
        };
        let part = PixelPart { left: 1, top: 2, size: Size::new(3, 2) };
        let turned_first = cut(&upright(plane.clone(), stored, orientation), turned(stored, orientation).width, part);
        let as_stored = part_as_stored(part, stored, orientation);
        let cut_first = upright(cut(&plane, 7, as_stored), as_stored.size, orientation);
        assert_eq!(turned_first, cut_first, "orientation {exif}");
    }
}
