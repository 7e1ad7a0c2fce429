//! Output files behave as usual: modes, links, pipes; impossible targets are rejected before any work is done.

#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Output};

use crate::support::*;

/// A folder with a scene and a path of it.
fn hall() -> tempfile::TempDir {
    let folder = folder();
    assert_eq!(status(&cdpr_in(folder.path(), &["new", "hall.toml"])), 0);
    fs::write(folder.path().join("path.csv"), "x,y,z\n1,1.5,0.5\n1,1.6,0.6\n").unwrap();
    folder
}

/// A shell command in this folder; `cdpr` is the program.
fn shell(folder: &Path, script: &str) -> Output {
    let script = script.replace("cdpr ", &format!("{} ", assert_cmd::cargo::cargo_bin!("cdpr").display()));
    Command::new("bash").current_dir(folder).args(["-c", &script]).output().unwrap()
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).unwrap().permissions().mode() & 0o777
}

fn set_mode(path: &Path, mode: u32) {
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
}

#[test]
fn new_files_obey_the_umask_and_old_ones_keep_their_mode() {
    let folder = hall();
    let path = folder.path().join("p.json");
    for (umask, expected) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        let _ = fs::remove_file(&path);
        let ended = shell(folder.path(), &format!("umask {umask}; cdpr plan hall.toml -q -o p.json"));
        assert_eq!((status(&ended), mode(&path)), (0, expected), "{}", stderr(&ended));
    }
    set_mode(&path, 0o640);
    assert_eq!(status(&shell(folder.path(), "umask 077; cdpr plan hall.toml -q -o p.json")), 0);
    assert_eq!(mode(&path), 0o640);
    let run = "printf 'version = 1\ntrials = 1\nscenarios = [{ name = \"s\", scene = \"hall.toml\" }]\n\
        methods = [{ name = \"m\" }]\n' > e.toml; umask 077; cdpr batch e.toml -q -o run";
    assert_eq!(status(&shell(folder.path(), run)), 0);
    assert_eq!(mode(&folder.path().join("run/trials.csv")), 0o600);
}

#[test]
fn a_read_only_file_is_not_overwritten() {
    let folder = hall();
    let path = folder.path().join("p.json");
    fs::write(&path, "precious").unwrap();
    set_mode(&path, 0o444);
    let refused = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "p.json"]);
    assert_eq!((status(&refused), stdout(&refused).as_str()), (2, ""));
    assert!(stderr(&refused).contains("p.json: cannot be written: it is read-only"), "{}", stderr(&refused));
    assert_eq!((fs::read_to_string(&path).unwrap().as_str(), mode(&path)), ("precious", 0o444));
}

#[test]
fn a_link_is_written_through_also_where_it_leads_to_nothing_yet() {
    let folder = hall();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("elsewhere")).unwrap();
    fs::write(at("elsewhere/old.json"), "old").unwrap();
    symlink("elsewhere/old.json", at("old.json")).unwrap();
    symlink("old.json", at("twice.json")).unwrap();
    symlink("elsewhere/new.json", at("new.json")).unwrap();
    for (name, end) in [("old.json", "old.json"), ("twice.json", "old.json"), ("new.json", "new.json")] {
        let _ = fs::write(at("elsewhere").join(end), "old");
        if name == "new.json" {
            fs::remove_file(at("elsewhere/new.json")).unwrap();
        }
        let ended = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", name]);
        assert_eq!(status(&ended), 0, "{name}: {}", stderr(&ended));
        assert!(fs::symlink_metadata(at(name)).unwrap().is_symlink(), "{name}");
        let written = fs::read(at("elsewhere").join(end)).unwrap();
        assert_eq!(serde_json::from_slice::<serde_json::Value>(&written).unwrap()["status"], "solved", "{name}");
    }
    symlink("circle.json", at("circle.json")).unwrap();
    let refused = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "circle.json"]);
    assert!(status(&refused) == 2 && stderr(&refused).contains("circle"), "{}", stderr(&refused));
    // Reading a missing file names the end of the link, not the link itself.
    symlink("nowhere.json", at("dangling.json")).unwrap();
    let refused = cdpr_in(folder.path(), &["check", "hall.toml", "dangling.json"]);
    let told = stderr(&refused);
    assert!(told.contains("a link to nowhere.json, which does not exist") && !told.contains("did you mean"), "{told}");
}

#[test]
fn irreplaceable_files_are_written_in_place() {
    let folder = hall();
    let inner = folder.path().join("inner");
    fs::create_dir(&inner).unwrap();
    let (path, other) = (inner.join("p.json"), inner.join("other.json"));
    fs::write(&path, "old, and much longer than nothing".repeat(1000)).unwrap();
    let number = fs::metadata(&path).unwrap().ino();
    set_mode(&inner, 0o555);
    let ended = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "inner/p.json"]);
    let refused = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "inner/new.json"]);
    set_mode(&inner, 0o755);
    assert_eq!(status(&ended), 0, "{}", stderr(&ended));
    assert_eq!(fs::metadata(&path).unwrap().ino(), number);
    assert!(serde_json::from_slice::<serde_json::Value>(&fs::read(&path).unwrap()).is_ok());
    assert!(
        status(&refused) == 2 && stderr(&refused).contains("the folder inner cannot be written"),
        "{}",
        stderr(&refused)
    );
    // A file with two names keeps both.
    fs::hard_link(&path, &other).unwrap();
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", "hall.toml", "--seed", "7", "-o", "inner/p.json"])), 0);
    assert_eq!(fs::metadata(&other).unwrap().ino(), number);
    assert!(fs::read_to_string(&other).unwrap().contains("\"seed\": 7"));
}

/// Every command that writes, with its output as `OUT`, and the extension it needs.
const WRITERS: [(&str, &str); 14] = [
    ("plan hall.toml -o OUT", "json"),
    ("plan hall.toml --html OUT", "html"),
    ("post hall.toml path.csv -o OUT", "csv"),
    ("view hall.toml -o OUT", "html"),
    ("shadows hall.toml -o OUT", "obj"),
    ("export hall.toml -o OUT", "xml"),
    ("export hall.toml motion.csv -o OUT", "xml"),
    ("wrench hall.toml --along path.csv -o OUT", "csv"),
    ("wrench hall.toml --grid 1 -o OUT", "npz"),
    ("wrench hall.toml --grid 1 -o OUT", "vti"),
    ("import robot.yaml -o OUT", "toml"),
    ("new OUT", "toml"),
    ("new OUT --robot robot.toml", "json"),
    ("report run -o OUT", "html"),
];

#[test]
fn outputs_are_checked_before_any_work() {
    let folder = folder(); // no input files: a command that read them first would report those instead
    fs::write(folder.path().join("file"), "").unwrap();
    fs::create_dir(folder.path().join("folder.json")).unwrap();
    let refused = |command: &str, output: &str, expected: &str| {
        let command = command.replace("OUT", output);
        let ended = cdpr_in(folder.path(), &command.split(' ').collect::<Vec<_>>());
        let told = stderr(&ended);
        assert_eq!((status(&ended), stdout(&ended).as_str()), (2, ""), "{command}");
        assert!(told.contains(&format!("{output}: cannot be written: {expected}")), "{command}: {told}");
        assert!(!told.contains(".cdpr-") && !told.contains("os error"), "{command}: {told}");
    };
    for (command, extension) in WRITERS {
        refused(command, &format!("nodir/out.{extension}"), "there is no folder nodir");
        refused(command, &format!("file/out.{extension}"), "");
        fs::create_dir_all(folder.path().join(format!("folder.{extension}"))).unwrap();
        refused(command, &format!("folder.{extension}"), "it is a folder");
    }
    for command in ["batch e.toml -o OUT", "merge a b -o OUT", "man -o OUT"] {
        refused(command, "file/run", "");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 9, "nothing is left behind");
}

#[test]
fn pipes_and_devices_are_written_directly() {
    let folder = hall();
    let told = |script: &str| {
        let ended = shell(folder.path(), script);
        assert_eq!(status(&ended), 0, "{script}: {}", stderr(&ended));
        stdout(&ended)
    };
    let solved = |text: &str| serde_json::from_str::<serde_json::Value>(text).expect(text)["status"] == "solved";
    assert!(solved(&told("cdpr plan hall.toml -o /dev/stdout")));
    assert!(solved(&told("cdpr plan hall.toml -o /dev/stdout > out; cat out")));
    assert!(solved(&told("echo '{\"x\":' > out; cdpr plan hall.toml -o /dev/stdout >> out; sed 1d out")));
    assert!(solved(&told("cdpr plan hall.toml -q -o >(cat > out) > /dev/null; sleep 0.5; cat out")));
    assert!(solved(&told("mkfifo p.json; cat p.json & cdpr plan hall.toml -q -o p.json > /dev/null; wait")));
    assert!(solved(&told("cdpr plan hall.toml --format json -o /dev/null --html /dev/null")));
    assert!(Path::new("/dev/null").metadata().unwrap().mode() & 0o777 == 0o666, "and stay what they are");
    told("cdpr plan hall.toml -o >(head -c 1 > /dev/null) > /dev/null"); // a reader that has seen enough
    assert!(told("cdpr view hall.toml -q -o >(cat > out); sleep 0.5; cat out").contains("</html>"));
    assert!(told("cdpr new /dev/stdout").contains("[workspace]"));
    let cogiro = testdata("scenes/cogiro.toml");
    told("printf 'x,y,z\n0,0,2\n0,0,2.1\n' > cogiro.csv");
    assert!(told(&format!("cdpr wrench {cogiro} --along cogiro.csv -o /dev/stdout")).starts_with("s,x,y,z"));
    // And read: from what the shell has opened.
    told("cdpr plan hall.toml -q -o path.json; cdpr check hall.toml <(cat path.json)");
    told("cdpr check <(cat hall.toml) <(cat path.json)");
    told("cdpr check hall.toml /dev/stdin < path.json");
}

#[test]
fn a_byte_order_mark_and_capital_extensions_are_understood() {
    let folder = hall();
    let at = |name: &str| folder.path().join(name);
    let marked = |from: &str, to: &str| {
        fs::write(at(to), [&b"\xef\xbb\xbf"[..], &fs::read(at(from)).unwrap()].concat()).unwrap();
    };
    let run = |arguments: &[&str]| {
        let ended = cdpr_in(folder.path(), arguments);
        assert_eq!(status(&ended), 0, "{arguments:?}: {}", stderr(&ended));
    };
    run(&["new", "HALL.JSON"]);
    run(&["plan", "hall.toml", "-o", "PATH.JSON", "--html", "VIEW.HTML"]);
    run(&["plan", "hall.toml", "-o", "PATH.CSV"]);
    run(&["shadows", "hall.toml", "-o", "SHADOWS.STL"]);
    run(&["shadows", "hall.toml", "-o", "SHADOWS.OBJ"]);
    marked("hall.toml", "MARKED.TOML");
    marked("HALL.JSON", "marked.json");
    marked("PATH.JSON", "path.json");
    marked("PATH.CSV", "marked.csv");
    for scene in ["hall.toml", "HALL.JSON", "MARKED.TOML", "marked.json"] {
        run(&["info", scene]);
    }
    for path in ["PATH.JSON", "PATH.CSV", "path.json", "marked.csv"] {
        run(&["check", "hall.toml", path]);
    }
    let scene = fs::read_to_string(at("hall.toml")).unwrap();
    fs::write(at("mesh.toml"), format!("{scene}\n[[obstacles]]\nname = \"shadow\"\nmesh = \"SHADOWS.STL\"\n")).unwrap();
    let ended = cdpr_in(folder.path(), &["info", "mesh.toml"]);
    assert!(!stderr(&ended).contains("extension"), "{}", stderr(&ended));
}

#[test]
fn unwritable_help_is_an_error() {
    let full = || fs::File::create("/dev/full").unwrap();
    for arguments in [
        &["--version"][..],
        &["--help"],
        &["-h"],
        &["plan", "--help"],
        &["help"],
        &["help", "plan"],
        &["completions", "bash"],
        &["man"],
        &["schema"],
    ] {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("cdpr"));
        let ended = command.args(arguments).stdout(full()).output().unwrap();
        assert_eq!(status(&ended), 2, "{arguments:?}");
        assert!(stderr(&ended).contains("standard output: cannot be written"), "{arguments:?}: {}", stderr(&ended));
        assert_eq!(status(&cdpr(arguments)), 0, "{arguments:?}");
    }
}

/// A scene in JSON of three files, and a path, all of whose names fit several outputs.
fn hall_in_json() -> tempfile::TempDir {
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let cable = |x: f64, y: f64| serde_json::json!({"outlet": [x, y, 2.0], "attachment": [0.0, 0.0, 0.0]});
    let cables = [cable(0.0, 0.0), cable(2.0, 0.0), cable(0.0, 2.0), cable(2.0, 2.0)];
    let robot = serde_json::json!({"version": 1, "platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "cables": cables});
    write("robot.json", &robot.to_string());
    write("hall.obj", "v 0.9 0.9 0\nv 1.1 0.9 0\nv 1 1.1 0\nv 1 1 0.4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    let scene = serde_json::json!({
        "version": 1, "robot": "robot.json", "workspace": {"min": [0.0, 0.0, 0.0], "max": [2.0, 2.0, 2.0]},
        "obstacles": [{"mesh": "hall.obj"}], "query": {"start": [0.4, 1.0, 0.3], "goal": [1.6, 1.0, 0.3]},
        "motion": {"speed": 1.0, "acceleration": 1.0},
    });
    write("scene.json", &scene.to_string());
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", "scene.json", "-q", "-o", "path.json"])), 0);
    fs::create_dir(folder.path().join("sub")).unwrap();
    symlink("../scene.json", folder.path().join("sub/link.json")).unwrap();
    folder
}

#[test]
fn no_output_replaces_an_input() {
    let folder = hall_in_json();
    let files = ["scene.json", "robot.json", "hall.obj", "path.json"];
    let contents = || files.map(|name| fs::read(folder.path().join(name)).unwrap());
    let before = contents();
    for command in [
        "plan scene.json -o scene.json",
        "plan scene.json -o ./sub/../scene.json",
        "plan scene.json -o sub/link.json",
        "plan scene.json -o robot.json",
        "plan scene.json --trajectory scene.json",
        "plan scene.json --trajectory robot.json",
        "plan scene.json --proof scene.json",
        "plan scene.json --proof hall.obj",
        "post scene.json path.json -o path.json",
        "post scene.json path.json -o scene.json",
        "trajectory scene.json path.json -o path.json",
        "trajectory scene.json path.json -o robot.json",
        "shadows scene.json -o hall.obj",
        "export scene.json -o scene.json",
        "export scene.json path.json -o robot.json",
        "new robot.json --robot robot.json --force",
        "wrench scene.json --along path.json -o path.json",
    ] {
        let ended = cdpr_in(folder.path(), &command.split(' ').collect::<Vec<_>>());
        assert_eq!(status(&ended), 2, "{command}");
        assert!(stderr(&ended).contains("is an input of this command; choose another name"), "{}", stderr(&ended));
        assert!(contents() == before, "{command}");
    }
    let again = ["post", "scene.json", "path.json", "-q", "-o", "new.json"];
    assert_eq!([0; 2].map(|_| status(&cdpr_in(folder.path(), &again))), [0, 0]);
}

#[test]
fn no_output_replaces_another_of_the_same_call() {
    let folder = hall_in_json();
    for outputs in [
        "-o new.json --trajectory new.json",
        "-o new.json --proof ./new.json",
        "--trajectory sub/new.json --proof sub/../sub/new.json",
        "-o path.json --proof path.json",
    ] {
        let ended = cdpr_in(folder.path(), &format!("plan scene.json {outputs}").split(' ').collect::<Vec<_>>());
        assert_eq!(status(&ended), 2, "{outputs}");
        assert!(stderr(&ended).contains("is the name of two outputs; choose different names"), "{}", stderr(&ended));
    }
    assert!(!folder.path().join("new.json").exists());
    let nowhere = cdpr_in(folder.path(), &["plan", "scene.json", "--proof", "nowhere/proof.json"]);
    assert_eq!(status(&nowhere), 2);
    assert!(stderr(&nowhere).contains("there is no folder nowhere") && nowhere.stdout.is_empty());
}

#[test]
fn example_files_are_written_once_and_never_over_others() {
    let folder = folder();
    let new = |options: &[&str]| cdpr_in(folder.path(), &[&["new", "--example-files", "examples"], options].concat());
    let mesh = folder.path().join("examples/meshes/machine.stl");
    for options in [&[][..], &["-q"], &["--force"]] {
        let written = new(options);
        assert_eq!(status(&written), 0, "{}", stderr(&written));
        assert_eq!(stderr(&written).is_empty(), options == ["-q"]);
    }
    let json: serde_json::Value = serde_json::from_str(&stdout(&new(&["--format", "json"]))).unwrap();
    assert_eq!(json["output"], "examples");
    let files = json["files"].as_array().unwrap();
    assert!(
        files.len() == 21 && files.iter().all(|file| folder.path().join(file.as_str().unwrap()).is_file()),
        "{json}"
    );
    assert_eq!(status(&cdpr_in(folder.path(), &["import", "examples/caspr/CoGiRo", "-o", "cogiro.toml"])), 0);

    let whole = fs::read(&mesh).unwrap();
    fs::write(&mesh, "mine").unwrap();
    let refused = new(&[]);
    assert_eq!((status(&refused), fs::read(&mesh).unwrap().as_slice()), (2, &b"mine"[..]));
    assert!(stderr(&refused).contains("examples/meshes/machine.stl: differs from the example"), "{}", stderr(&refused));
    assert_eq!((status(&new(&["--force"])), fs::read(&mesh).unwrap()), (0, whole));
    for (option, value) in [("--example", "hard1"), ("--robot", "cogiro.toml"), ("--units", "mm")] {
        assert_eq!(status(&new(&[option, value])), 2, "{option}");
    }
}
