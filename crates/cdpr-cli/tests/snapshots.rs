//! The command line as an engineer meets it: exit status, standard output and standard error of each case in `snapshots/`.
//!
//! Every case runs in an empty environment. `TRYCMD=overwrite cargo test -p cdpr-cli --test snapshots` updates the files.

use std::fs;

#[test]
fn outputs_are_those_on_record() {
    trycmd::TestCases::new().default_bin_name("cdpr").case("tests/snapshots/*.toml");
}

#[test]
fn no_case_sees_the_environment_of_the_tests() {
    for entry in fs::read_dir("tests/snapshots").unwrap() {
        let path = entry.unwrap().path();
        if path.is_file() {
            assert!(fs::read_to_string(&path).unwrap().contains("[env]\ninherit = false\n"), "{}", path.display());
        }
    }
}
