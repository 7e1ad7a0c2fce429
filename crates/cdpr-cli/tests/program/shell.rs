//! What people expect of any program in a shell: standard input and output, quiet and verbose, colours, hints, manuals.

use crate::support::*;
use assert_cmd::Command;

#[test]
fn a_dash_is_standard_input_or_output() {
    let scene = std::fs::read_to_string(testdata("scenes/hard1.toml")).unwrap();
    let folder = std::path::PathBuf::from(testdata("scenes")); // the scene names its robot relative to here
    let planned = cdpr_fed(&folder, &["plan", "-", "-o", "-"], &scene);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    let path = json(&planned);
    assert!(path["status"] == "solved" && stderr(&planned).contains("solved: "), "{}", stderr(&planned));
    let checked = cdpr_fed(&folder, &["check", "hard1.toml", "-"], &stdout(&planned));
    assert!(status(&checked) == 0 && stdout(&checked).contains("valid: "), "{}", stderr(&checked));
    let csv = "x,y,z\n0.3,1,0.3\n1.7,1,1.7\n";
    assert_eq!(status(&cdpr_fed(&folder, &["check", "hard1.toml", "-"], csv)), 1);
    let as_json = stdout(&cdpr(&["new", "--format", "json"]));
    assert_eq!(json(&cdpr_fed(&folder, &["info", "-", "--format", "json"], &as_json))["name"], "starter");
    let robot = cdpr(&["import", &testdata("caspr/CoGiRo"), "-o", "-"]);
    assert!(stdout(&robot).contains("[[cables]]") && stderr(&robot).contains("CoGiRo: 8 cables"), "{}", stdout(&robot));
    let page = cdpr(&["view", &testdata("scenes/hard1.toml"), "-o", "-"]);
    assert!(stdout(&page).starts_with("<!doctype html>") || stdout(&page).starts_with("<!DOCTYPE html>"));

    for (arguments, text, expected) in [
        (vec!["check", "-", "-"], "", "only one of them can be standard input"),
        (vec!["info", "-"], "version = 2", "standard input: missing field"),
        (vec!["check", "hard1.toml", "-"], "x,y\n1,2\n", "standard input: header: found \"x,y\""),
        (vec!["plan", "hard1.toml", "-o", "-", "--html", "-"], "", "only one of them can be standard output"),
    ] {
        let refused = cdpr_fed(&folder, &arguments, text);
        assert!(status(&refused) == 2 && stderr(&refused).contains(expected), "{arguments:?}: {}", stderr(&refused));
        assert_eq!(stdout(&refused), "");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn unwritable_results_are_an_error() {
    let hard1 = testdata("scenes/hard1.toml");
    for arguments in [&["plan", &hard1][..], &["plan", &hard1, "-o", "-"], &["schema"], &["new"]] {
        let full = std::fs::File::create("/dev/full").unwrap();
        let mut command = std::process::Command::new(assert_cmd::cargo::cargo_bin!("cdpr"));
        let ended = command.args(arguments).stdout(full).output().unwrap();
        assert_eq!(ended.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&ended).contains("standard output: cannot be written"), "{}", stderr(&ended));
    }
}

#[test]
fn quiet_says_results_only_and_verbose_says_more() {
    let hard1 = testdata("scenes/hard1.toml");
    let folder = folder();
    let run = |more: &[&str]| cdpr_in(folder.path(), &[&["plan", &hard1, "-o", "path.json"], more].concat());
    assert_eq!(stderr(&run(&["-q"])), "");
    assert!(stdout(&run(&["-q"])).contains("solved: "));
    let (usual, verbose) = (stderr(&run(&[])), stderr(&run(&["--verbose"])));
    assert!(usual.contains("wrote path.json") && !usual.contains(" ms: "), "{usual}");
    assert!(verbose.contains("1 obstacle of 1 part") && verbose.contains(" ms: 2.4352 m, 3 waypoints"), "{verbose}");
}

#[test]
fn colours_are_used_on_terminals_or_on_request() {
    let hard1 = testdata("scenes/hard1.toml");
    let coloured = "\u{1b}[1m\u{1b}[32msolved:\u{1b}[0m";
    assert!(!stdout(&cdpr(&["plan", &hard1])).contains('\u{1b}'));
    assert!(stdout(&cdpr(&["plan", &hard1, "--color", "always"])).contains(coloured));
    assert!(stderr(&cdpr(&["--color", "always", "info", "nowhere.toml"])).starts_with("\u{1b}[1m\u{1b}[31mcdpr:"));
}

#[test]
fn every_command_has_examples_a_manual_page_and_completions() {
    let folder = folder();
    assert_eq!(status(&cdpr_in(folder.path(), &["man", "-o", "man1"])), 0);
    let help = stdout(&cdpr(&["--help"]));
    let commands = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let named = commands.filter(|line| !line.starts_with("   ")); // others go on with a description
    let names: Vec<&str> =
        named.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help").collect();
    assert!(names.len() >= 15, "{help}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = stdout(&cdpr(&["completions", shell]));
        assert!(names.iter().all(|name| script.contains(name)), "{shell}");
    }
    for name in names {
        let help = stdout(&cdpr(&[name, "--help"]));
        assert!(help.contains("Example") && help.contains(&format!("cdpr {name}")), "{name}");
        let page = std::fs::read_to_string(folder.path().join(format!("man1/cdpr-{name}.1"))).unwrap();
        assert!(page.contains(".TH") && page.contains("EXAMPLE") | page.contains("Example"), "{name}");
    }
    assert!(folder.path().join("man1/cdpr.1").exists());
    assert!(stdout(&cdpr(&["man"])).contains(".TH cdpr 1"));
}

#[test]
fn help_fits_narrow_terminals_and_cuts_no_word() {
    let help = |command: &str, columns: &str| {
        let mut program = Command::cargo_bin("cdpr").unwrap();
        let arguments = [command, "--help"].into_iter().filter(|argument| !argument.is_empty());
        let output = program.env("COLUMNS", columns).args(arguments).output().unwrap();
        assert_eq!((status(&output), stderr(&output).as_str()), (0, ""), "{command}, {columns} columns");
        stdout(&output)
    };
    // clap may put the colon after a name on a line of its own.
    let words = |text: &str| text.replace(':', " : ").split_whitespace().map(str::to_string).collect::<Vec<_>>();
    for command in [
        "",
        "plan",
        "check",
        "new",
        "import",
        "view",
        "shadows",
        "export",
        "wrench",
        "pose",
        "batch",
        "merge",
        "completions",
    ] {
        let whole = words(&help(command, "1000"));
        for columns in ["80", "40", "20", "3", "0", "-1", "many"] {
            let text = help(command, columns);
            assert_eq!(words(&text), whole, "{command}, {columns} columns");
            let width = columns.parse().unwrap_or(100);
            for line in text.lines().filter(|_| width >= 20) {
                let fits = line.chars().count() <= width || line.split_whitespace().count() == 1;
                assert!(fits, "{command}, {columns} columns: {line}");
            }
        }
    }
}
