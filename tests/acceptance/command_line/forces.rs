//! `palkki certify` as a library call would have it: the reader of forces.

use palkki::scene::file::parse_forces;

#[track_caller]
fn refused(text: &str) -> String {
    parse_forces("forces.csv", text, 10.0).expect_err("these are no forces").to_string()
}

#[test]
fn forces_are_read() {
    let text = "\u{feff}x,force\r\n# by somebody\r\n 2.5 , 1.25\r\n\r\n7.5,-1e-3\r\n";
    assert_eq!(parse_forces("forces.csv", text, 10.0), Ok(vec![(2.5, 1.25), (7.5, -1e-3)]));
}

#[test]
fn what_is_no_force_is_refused_with_its_place() {
    for (text, message, place) in [
        ("x|force\n1|2\n", "must begin with the header `x,force`", "forces.csv:1:1"),
        ("\n", "neither header nor forces", "forces.csv:1:1"),
        ("x,force\n1,2,3\n", "2 fields", "forces.csv:2:1"),
        ("x,force\n1,2\n3,nan\n", "`force` must be a finite number", "forces.csv:3:3"),
        ("x,force\n1e999,2\n", "`x` must be a finite number", "forces.csv:2:1"),
        ("x,force\n1,2\n 10.5,2\n", "between 0 and 10, but is 10.5", "forces.csv:3:2"),
        ("x,force\n-1,2\n", "between 0 and 10, but is -1", "forces.csv:2:1"),
    ] {
        let said = refused(text);
        assert!(said.contains(message) && said.contains(place), "{text:?}: {said}");
    }
}
