//! Tests of which pictures are measured.

use super::*;

/// The pictures of a set of ten, `0.jpg` to `9.jpg`.
fn ids_of_ten(pictures: usize, after: usize) -> Result<String, String> {
    let data = tempfile::tempdir().unwrap();
    let folder = data.path().join("images/val");
    std::fs::create_dir_all(&folder).unwrap();
    for number in (0..10).rev() {
        std::fs::write(folder.join(format!("{number}.jpg")), "").unwrap();
    }
    std::fs::write(folder.join("5.txt"), "").unwrap();
    let profile = Profile::named("swell-a4").unwrap();
    let set = Set { split: "val".into(), after, profile: profile.clone(), told: "" };
    let split = None;
    let args = Args { data: data.path().into(), split, pictures, after, all: false, contours: false, profile };
    ids(&args, &set).map(|ids| ids.join(" ")).map_err(|error| error.to_string())
}

#[test]
fn pictures_are_evenly_spaced_over_a_set_the_one_before_each_even_place() {
    for (pictures, ids) in
        [(1, "0"), (2, "0 9"), (3, "0 4 9"), (4, "0 3 6 9"), (10, "0 1 2 3 4 5 6 7 8 9"), (99, "0 1 2 3 4 5 6 7 8 9")]
    {
        assert_eq!(ids_of_ten(pictures, 0).as_deref(), Ok(ids), "{pictures} pictures");
    }
    assert_eq!(ids_of_ten(0, 0), Err("there are no pictures".into()));
}

#[test]
fn those_after_each_are_others_and_the_last_has_none_after_it() {
    assert_eq!(ids_of_ten(4, 1).as_deref(), Ok("1 4 7"));
    assert_eq!(ids_of_ten(4, 2).as_deref(), Ok("2 5 8"));
    let same = ids_of_ten(4, 3).unwrap_err();
    assert!(same.starts_with("--after 3: these would be the same pictures"), "{same}");
}
