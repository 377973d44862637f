//! Tests of `inherit`.

use super::*;

/// A folder of files that inherit one another.
fn find(path: &str) -> Result<String, String> {
    let text = match path {
        "egg.toml" => "inherits = \"hen.toml\"",
        "hen.toml" => "# lays\ninherits = \"./egg.toml\"",
        "faulty.toml" => "inherits = \"swell-a4\"\nlines.width_max = 99",
        "school/our.toml" => "inherits = \"papers/thin.toml\"\nlines.width_max = 1.4",
        "school/papers/thin.toml" => "inherits = \"swell-letter\"\nlines.width_max = 1.2\nlines.min_length = 9",
        path if path.starts_with("deep") => {
            return Ok(format!("inherits = \"{}.toml\"", path.trim_end_matches(".toml").to_owned() + "x"));
        }
        _ => return Err(format!("{path}: there is no such file")),
    };
    Ok(text.to_owned())
}

fn read(text: &str, place: &str) -> Result<Profile, String> {
    load(text, place, ProfileOrigin::File, &find)
        .map_err(|faults| faults.iter().map(Fault::to_string).collect::<Vec<_>>().join("\n"))
}

#[test]
#[expect(clippy::float_cmp, reason = "numbers are as they are written, to the bit")]
fn a_file_inherits_files_from_where_it_lies() {
    let profile = read("inherits = \"our.toml\"\nlines.detail = 0.6", "school/me.toml").expect("it is sound");
    assert_eq!([profile.lines.width_max, profile.lines.min_length, profile.lines.detail], [1.4, 9.0, 0.6]);
    assert_eq!(profile.page.width, 215.9);
    assert_eq!(profile.name, "me");
}

#[test]
fn circles_are_told() {
    for (text, place, expected) in [
        (
            "inherits = \"egg.toml\"",
            "hen.toml",
            "egg.toml, line 1: inherits goes round in a circle, hen.toml to egg.toml to hen.toml, take \
                 one of them away",
        ),
        (
            "inherits = \"egg.toml\"\npage.margin = 200",
            "my.toml",
            "my.toml, line 2: page.margin must be a number from 0 to 100 mm, not 200\n\
                 hen.toml, line 2: inherits goes round in a circle, my.toml to egg.toml to hen.toml to ./egg.toml, \
                 take one of them away",
        ),
        (
            "inherits = \"../a/self.toml\"",
            "a/self.toml",
            "a/self.toml, line 1: inherits goes round in a circle, a/self.toml to ../a/self.toml, take one \
                 of them away",
        ),
    ] {
        assert_eq!(read(text, place).expect_err("a circle"), expected);
    }
    let told = read("inherits = \"deep.toml\"", "my.toml").expect_err("no end");
    assert!(told.contains("inherits goes through more than 16 profiles, my.toml to deep.toml to "), "{told}");
}

/// Faults stay where they are, and a rule is not held against what stands in for a refused value.
#[test]
fn faults_of_inherited_profiles_name_them() {
    let refused = "faulty.toml, line 2: lines.width_max must be a number from 0.3 to 10 mm, not 99";
    for own in ["lines.width_min = 2", "lines.width_max = 2"] {
        assert_eq!(read(&format!("inherits = \"faulty.toml\"\n{own}"), "my.toml").expect_err("refused"), refused);
    }
    let none = "my.toml, line 1: inherits cannot be followed, none.toml: there is no such file";
    assert_eq!(read("inherits = \"none.toml\"", "my.toml").expect_err("none"), none);
}

#[test]
fn profiles_are_called_by_their_file() {
    for (place, name) in [("a/b/my.toml", "my"), ("C:\\my.toml", "my"), ("my.txt", "my.txt"), ("", "")] {
        assert_eq!(name_of(place), name);
    }
}

#[test]
fn paths_are_meant_from_the_file_that_names_them() {
    for (child, path, expected) in [
        ("my.toml", "our.toml", "our.toml"),
        ("a/my.toml", "b/our.toml", "a/b/our.toml"),
        ("a/my.toml", "/b/our.toml", "/b/our.toml"),
        ("a\\my.toml", "our.toml", "a\\our.toml"),
    ] {
        assert_eq!(beside(child, path), expected);
    }
    assert!(same_file("./a/../b.toml", "b.toml") && !same_file("a/b.toml", "/a/b.toml"));
}
