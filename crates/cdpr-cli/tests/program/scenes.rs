//! Scenes made, imported and drawn: `new`, `import`, `shadows`, and the orientations of a scene.

use std::fs;

use crate::support::*;
use serde_json::Value;

#[test]
fn a_new_scene_plans_and_is_not_overwritten() {
    let folder = folder();
    for name in ["hall.toml", "hall.json"] {
        assert_eq!(status(&cdpr_in(folder.path(), &["new", name])), 0);
        let planned = cdpr_in(folder.path(), &["plan", name]);
        assert_eq!(status(&planned), 0, "{}{}", stdout(&planned), stderr(&planned));
        let again = cdpr_in(folder.path(), &["new", name]);
        assert_eq!(status(&again), 2);
        assert!(stderr(&again).contains("--force"));
        assert_eq!(status(&cdpr_in(folder.path(), &["new", name, "--force"])), 0);
    }
    assert!(stdout(&cdpr(&["new"])).starts_with("# A scene for cdpr"));
}

#[test]
fn shadows_have_one_mesh_per_cable_and_obstacle() {
    let folder = folder();
    let hard3 = testdata("scenes/hard3.toml");
    let written = |name: &str, arguments: &[&str]| {
        let output = cdpr_in(folder.path(), &[&["shadows", &hard3, "-o", name], arguments].concat());
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        assert!(stderr(&output).contains(&format!("wrote {name}")));
        (fs::read(folder.path().join(name)).unwrap(), stdout(&output))
    };
    let (obj, text) = written("s.obj", &[]);
    let obj = String::from_utf8(obj).unwrap();
    assert!(text.contains("24 regions in the space of attachments") && text.contains("largest: cable "), "{text}");
    assert_eq!(obj.lines().filter(|line| line.starts_with("o ")).count(), 24);
    assert!(obj.contains("\n# cable 3 / south\no cable_3_south\nv "));
    let faces = obj.lines().filter(|line| line.starts_with("f ")).count();
    let (ply, _) = written("s.ply", &[]);
    assert!(String::from_utf8(ply).unwrap().contains(&format!("element face {faces}\n")));
    let (stl, _) = written("s.stl", &["--cable", "cable 3", "--obstacle", "south", "west"]);
    let triangles = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
    assert_eq!(stl.len(), 84 + 50 * triangles);
    let (page, _) = written("s.html", &["--space", "position"]);
    assert!(String::from_utf8(page).unwrap().contains("\"space\":\"position\""));
    let (_, all) = written("all.obj", &["--all", "--format", "json"]);
    let all: Value = serde_json::from_str(&all).unwrap();
    assert_eq!((&all["space"], all["meshes"].as_array().unwrap().len()), (&"position".into(), 27));
    let first = &all["meshes"][0];
    assert_eq!((&first["name"], &first["kind"]), (&"platform / west".into(), &"platform-obstacle".into()));
    // The Minkowski sum of two boxes, cut where the platform stands on the floor: (0.2 + 0.15)² × 1.2 m³.
    assert!((first["volume"].as_f64().unwrap() - 0.35 * 0.35 * 1.2).abs() < 1e-12, "{first}");
}

#[test]
fn shadows_list_omissions_and_refuse_unknown_names() {
    let folder = folder();
    let clearance = testdata("cases/clearance.toml");
    let output = cdpr_in(folder.path(), &["shadows", &clearance, "-o", "s.obj"]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    assert!(stderr(&output).contains("note: the meshes do not include clearances and cable diameters"));
    let none = cdpr_in(folder.path(), &["shadows", &testdata("scenes/empty.toml"), "-o", "none.stl"]);
    assert_eq!((status(&none), fs::read(folder.path().join("none.stl")).unwrap().len()), (0, 84));
    assert!(stdout(&none).contains("0 regions"));
    let hard1 = testdata("scenes/hard1.toml");
    for (arguments, words) in [
        (vec!["-o", "out.step"], vec!["out.step", ".step", ".obj, .ply, .stl or .html"]),
        (vec!["-o", "out.obj", "--cable", "cabel 3"], vec!["--cable: found \"cabel 3\"", "did you mean \"cable 3\"?"]),
        (vec!["-o", "out.obj", "--obstacle", "column"], vec!["obstacle", "column", "expected one of pillar"]),
        (vec!["-o", "out.obj", "--all", "--space", "attachment"], vec!["space", "attachment", "expected \"position\""]),
        (vec!["-o", "out.obj", "--space", "joint"], vec!["joint", "attachment", "position"]),
        (vec!["-o", "nofolder/out.obj"], vec!["nofolder", "cannot be written"]),
    ] {
        let output = cdpr_in(folder.path(), &[&["shadows", &hard1], &arguments[..]].concat());
        assert_eq!(status(&output), 2, "{arguments:?}: {}", stderr(&output));
        for word in words {
            assert!(stderr(&output).contains(word), "{arguments:?}: no \"{word}\" in {}", stderr(&output));
        }
        assert!(stdout(&output).is_empty());
    }
    let unread = cdpr_in(folder.path(), &["shadows", "nowhere.toml", "-o", "out.step"]);
    assert!(stderr(&unread).contains("out.step"), "the name is judged before the scene is read");
    let left = fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    assert!(left.into_iter().all(|name| !name.starts_with("out") && !name.starts_with('.')));
}

#[test]
fn an_imported_robot_is_planned_around_an_obstacle_from_a_mesh() {
    let folder = folder();
    let imported = cdpr_in(folder.path(), &["import", &testdata("caspr/CoGiRo"), "-o", "cogiro.toml"]);
    assert_eq!(status(&imported), 0, "{}", stderr(&imported));
    assert!(stdout(&imported).starts_with("CoGiRo: 8 cables, 91.058 kg\nnot carried over:\n"), "{}", stdout(&imported));
    let angle = "v -0.2 -0.2 0\nv 0.8 -0.2 0\nv 0.8 0.2 0\nv -0.2 0.2 0\nv -0.2 -0.2 1\nv 0.8 -0.2 1\nv 0.8 0.2 1\n\
        v -0.2 0.2 1\nv 0.2 -0.2 1\nv 0.2 0.2 1\nv -0.2 -0.2 3\nv 0.2 -0.2 3\nv 0.2 0.2 3\nv -0.2 0.2 3\n\
        f 1 4 3 2\nf 1 2 6 9 5\nf 5 9 12 11\nf 2 3 7 6\nf 3 4 8 10 7\nf 8 14 13 10\nf 4 1 5 11 14 8\nf 9 6 7 10\n\
        f 9 10 13 12\nf 11 12 13 14\n";
    fs::write(folder.path().join("angle.obj"), angle).unwrap();
    let scene = "version = 1\nrobot = \"cogiro.toml\"\n[workspace]\nmin = [-7.0, -5.0, 0.0]\nmax = [7.0, 5.0, 6.0]\n\
        [[obstacles]]\nname = \"angle\"\nmesh = \"angle.obj\"\nposition = [2.0, 0.0, 0.0]\n\
        [query]\nstart = [0.0, 2.0, 1.0]\ngoal = [2.0, -2.0, 1.0]\n";
    fs::write(folder.path().join("hall.toml"), scene).unwrap();
    let planned = cdpr_in(folder.path(), &["plan", "hall.toml", "-o", "path.json"]);
    assert_eq!(status(&planned), 0, "{}", stderr(&planned));
    assert!(stderr(&planned).contains("in 2 convex parts, which fill it exactly"), "{}", stderr(&planned));
    assert_eq!(status(&cdpr_in(folder.path(), &["check", "hall.toml", "path.json"])), 0);
    let wrong = cdpr_in(folder.path(), &["import", &testdata("caspr/CAROCA"), "--cable-set", "gazebo", "-o", "a.toml"]);
    assert_eq!(status(&wrong), 2);
    assert!(stderr(&wrong).contains("original, with_rotating_pulleys, gazebo_sim"), "{}", stderr(&wrong));
}

/// A table with a wall on it, in millimetres.
const MACHINE: &str = "\
v -1500 -2000 0\nv 1500 -2000 0\nv 1500 2000 0\nv -1500 2000 0\n\
v -1500 -2000 400\nv 1500 -2000 400\nv 1500 2000 400\nv -1500 2000 400\n\
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n\
v 600 -1500 400\nv 1200 -1500 400\nv 1200 1500 400\nv 600 1500 400\n\
v 600 -1500 2600\nv 1200 -1500 2600\nv 1200 1500 2600\nv 600 1500 2600\n\
f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";

#[test]
fn a_new_scene_around_ones_own_robot_and_mesh_plans() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("parts")).unwrap();
    std::fs::write(folder.path().join("parts/machine.obj"), MACHINE).unwrap();
    let import = ["import", &testdata("caspr/CoGiRo"), "-o", "parts/cogiro.toml"];
    assert_eq!(status(&cdpr_in(folder.path(), &import)), 0);
    let files = ["--robot", "parts/cogiro.toml", "--obstacle", "parts/machine.obj", "--units", "mm"];
    let made = cdpr_in(folder.path(), &[&["new", "hall.toml"], &files[..]].concat());
    assert_eq!(status(&made), 0, "{}", stderr(&made));
    let text = std::fs::read_to_string(folder.path().join("hall.toml")).unwrap();
    for line in ["robot = \"parts/cogiro.toml\"", "mesh = \"parts/machine.obj\"", "units = \"mm\"", "[wrench]"] {
        assert!(text.contains(line), "{line}: {text}");
    }
    let found = json(&cdpr_in(folder.path(), &["plan", "hall.toml", "--format", "json", "-o", "path.json"]));
    assert_eq!(found["status"], "solved");
    assert!(found["waypoints"].as_array().unwrap().len() > 2, "something is in the way");
    let checked = json(&cdpr_in(folder.path(), &["check", "hall.toml", "path.json", "--format", "json"]));
    assert_eq!(checked["valid"], true);

    let end = ["--start", "-4", "0", "1"];
    let made = cdpr_in(folder.path(), &[&["new", "--format", "json"], &files[..], &end].concat());
    assert_eq!(json(&made)["query"]["start"], serde_json::json!([-4.0, 0.0, 1.0]));
    // The weight of ropes limits their lengths, and so the workspace, which is not known at first.
    let robot = std::fs::read_to_string(folder.path().join("parts/cogiro.toml")).unwrap();
    let roped = |density: f64| {
        let cable = format!("[cable]\nlinear_density = {density}\nsag_tension = 500.0\n\n[[platform]]");
        std::fs::write(folder.path().join("parts/ropes.toml"), robot.replacen("[[platform]]", &cable, 1)).unwrap();
        cdpr_in(folder.path(), &["new", "ropes.toml", "--robot", "parts/ropes.toml", "--force"])
    };
    let made = roped(0.1);
    assert_eq!(status(&made), 0, "{}", stderr(&made));
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", "ropes.toml"])), 0);
    let text = std::fs::read_to_string(folder.path().join("ropes.toml")).unwrap();
    assert!(!text.contains("gravity"), "{text}");
    let made = roped(1.0);
    assert!(status(&made) == 2 && stderr(&made).contains("N of weight on 1"), "{}", stderr(&made));
    let made = cdpr_in(folder.path(), &["new", "--obstacle", "parts/machine.obj"]);
    assert!(status(&made) == 2 && stderr(&made).contains("--robot"), "{}", stderr(&made));
    let made = cdpr_in(folder.path(), &["new", "x.toml", "--robot", "nowhere.toml"]);
    assert!(status(&made) == 2 && stderr(&made).contains("nowhere.toml") && !folder.path().join("x.toml").exists());
}

#[test]
fn every_command_takes_an_orientation_and_plan_chooses_one() {
    let folder = folder();
    std::fs::copy(testdata("scenes/plank.toml"), folder.path().join("slot.toml")).unwrap();
    let run = |arguments: &[&str]| cdpr_in(folder.path(), arguments);
    let found = run(&["plan", "slot.toml", "-o", "path.json", "--html", "view.html"]);
    assert!(stdout(&found).contains("at \"along\"") && stdout(&found).contains("solved: 1.1 m"), "{}", stdout(&found));
    let path = std::fs::read_to_string(folder.path().join("path.json")).unwrap();
    assert!(path.contains("\"orientation_name\": \"along\""), "{path}");
    assert!(std::fs::read_to_string(folder.path().join("view.html")).unwrap().contains("\"orientation\":[1.0,"));
    // Without --orientation the path's orientation is used, otherwise the given one.
    assert_eq!(status(&run(&["check", "slot.toml", "path.json"])), 0);
    let refused = run(&["check", "slot.toml", "path.json", "--orientation", "across"]);
    assert!(
        status(&refused) == 2 && stderr(&refused).contains("path.json: orientation: found a path at [1.0"),
        "{}",
        stderr(&refused)
    );
    std::fs::write(folder.path().join("path.csv"), "x,y,z\n0.45,1,0.5\n1.55,1,0.5\n").unwrap();
    let refused = run(&["check", "slot.toml", "path.csv"]);
    assert!(
        status(&refused) == 2 && stderr(&refused).contains("select one; use --orientation NAME"),
        "{}",
        stderr(&refused)
    );
    for (orientation, expected) in [("across", 1), ("along", 0), ("1,0,0,0", 0), ("-0.707106781,0,0,-0.707106781", 1)] {
        let checked = run(&["check", "slot.toml", "path.csv", "--orientation", orientation]);
        assert_eq!(status(&checked), expected, "{orientation}: {}", stderr(&checked));
    }
    let unknown = run(&["plan", "slot.toml", "--orientation", "acros"]);
    assert!(status(&unknown) == 2 && stderr(&unknown).contains("did you mean \"across\"?"), "{}", stderr(&unknown));

    let info = json(&run(&["info", "slot.toml", "--orientation", "along", "--format", "json"]));
    assert_eq!((&info["orientation_name"], &info["orientations"][1]), (&"along".into(), &"along".into()));
    let size = |orientation: &str| {
        let arguments =
            ["shadows", "slot.toml", "-o", "s.obj", "--all", "--format", "json", "--orientation", orientation];
        let regions = json(&run(&arguments));
        let meshes = regions["meshes"].as_array().unwrap().clone();
        meshes.iter().find(|mesh| mesh["kind"] == "platform-obstacle").unwrap()["volume"].as_f64().unwrap()
    };
    assert!(size("across") != size("along"));
}

#[test]
fn a_long_bar_passes_only_by_turning() {
    let folder = folder();
    let turn = testdata("scenes/turn.toml");
    for (orientation, end) in [("along", "goal"), ("across", "start")] {
        let ends = ["--start-orientation", orientation, "--goal-orientation", orientation];
        let planned = cdpr(&[&["plan", &turn, "--orientation", orientation][..], &ends].concat());
        assert_eq!(status(&planned), 1, "{}", stderr(&planned));
        assert!(stdout(&planned).contains(&format!("the {end} of turn is not valid")), "{}", stdout(&planned));
    }
    for seed in ["0", "1", "2", "3"] {
        for (name, page) in [("path.json", "plan.html"), ("path.csv", "csv.html")] {
            let planned = cdpr_in(folder.path(), &["plan", &turn, "--seed", seed, "-o", name, "--html", page]);
            assert_eq!(status(&planned), 0, "{}{}", stdout(&planned), stderr(&planned));
            let checked = cdpr_in(folder.path(), &["check", &turn, name, "--format", "json"]);
            assert_eq!(json(&checked)["valid"], true, "{}", stdout(&checked));
        }
        let written: Value = serde_json::from_slice(&fs::read(folder.path().join("path.json")).unwrap()).unwrap();
        let orientations = written["orientations"].as_array().unwrap();
        assert_eq!(orientations.len(), written["waypoints"].as_array().unwrap().len());
        assert_eq!(orientations[0], serde_json::json!([1.0, 0.0, 0.0, 0.0]));
    }
    let viewed = cdpr_in(folder.path(), &["view", &turn, "path.csv", "-o", "view.html"]);
    assert_eq!(status(&viewed), 0, "{}", stderr(&viewed));
    for name in ["view.html", "plan.html"] {
        let page = fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(page.contains("\"orientations\":[[1.0,0.0,0.0,0.0],") && page.contains("\"turn_weight\":"), "{name}");
    }
}

#[test]
fn fixed_orientation_proofs_do_not_cover_turning() {
    let folder = folder();
    let closed = testdata("scenes/closed.toml");
    assert_eq!(status(&cdpr_in(folder.path(), &["plan", &closed, "--proof", "proof.json"])), 1);
    // The order of keys does not matter.
    let proof = std::fs::read_to_string(folder.path().join("proof.json")).unwrap();
    let sorted = serde_json::from_str::<serde_json::Value>(&proof).unwrap().to_string();
    assert!(sorted.find("\"format\"").unwrap() > 1000);
    std::fs::write(folder.path().join("sorted.json"), sorted).unwrap();
    let checked = cdpr_in(folder.path(), &["check", &closed, "sorted.json"]);
    assert_eq!(status(&checked), 0, "{}", stderr(&checked));
    let robot = testdata("robots/paper.toml");
    let text =
        fs::read_to_string(&closed).unwrap().replace("../robots/paper.toml", &robot) + "\n[turning]\nmax_tilt = 0\n";
    fs::write(folder.path().join("turning.toml"), text).unwrap();
    for arguments in
        [&["check", "turning.toml", "proof.json"][..], &["view", "turning.toml", "proof.json", "-o", "a.html"]]
    {
        let refused = cdpr_in(folder.path(), arguments);
        assert_eq!(status(&refused), 2, "{}", stdout(&refused));
        assert!(stderr(&refused).contains("turning.toml: turning: found a scene whose platform may turn"));
    }
}

/// Robot files of one to four cables: in the corners of a room or in a plane, attached at corners of a box or all at one
/// point, which may be away from the centre of mass; with forces or without.
fn small_robots() -> Vec<(String, String)> {
    let corners = [[0.0, 0.0, 3.0], [4.0, 0.0, 3.0], [4.0, 3.0, 3.0], [0.0, 3.0, 3.0]];
    let plane = [[0.0, 1.5, 0.0], [4.0, 1.5, 0.0], [4.0, 1.5, 3.0], [0.0, 1.5, 3.0]];
    let sides = [[-0.1, -0.1, 0.05], [0.1, -0.1, 0.05], [0.1, 0.1, 0.05], [-0.1, 0.1, 0.05]];
    let in_plane = [[-0.1, 0.0, -0.05], [0.1, 0.0, -0.05], [0.1, 0.0, 0.05], [-0.1, 0.0, 0.05]];
    let kinds = [
        ("corners", corners, sides),
        ("planar", plane, in_plane),
        ("hung", corners, [[0.0, 0.0, 0.05]; 4]),
        ("offset", corners, [[0.05, 0.0, 0.05]; 4]),
    ];
    let mut robots = Vec::new();
    for (kind, outlets, attachments) in kinds {
        for count in 1..=4 {
            for [mass, tension] in [["", ""], ["mass = 5.0\n", "tension = [1.0, 500.0]\n"]] {
                let mut text = format!("version = 1\n{mass}[[platform]]\nbox = [0.2, 0.2, 0.1]\n");
                for (outlet, attachment) in outlets.iter().zip(attachments).take(count) {
                    text += &format!("[[cables]]\noutlet = {outlet:?}\nattachment = {attachment:?}\n{tension}");
                }
                robots.push((format!("{kind}{count}{}", if mass.is_empty() { "" } else { "_forces" }), text));
            }
        }
    }
    robots
}

/// Runs the command after "next: " and returns its exit status.
fn status_of_next(folder: &std::path::Path, made: &std::process::Output) -> i32 {
    let told = stderr(made);
    let next = told.lines().find_map(|line| line.strip_prefix("next: cdpr ")).unwrap_or_else(|| panic!("{told}"));
    status(&cdpr_in(folder, &next.split_whitespace().collect::<Vec<_>>()))
}

#[test]
fn new_scenes_work_for_one_to_four_cables() {
    let folder = folder();
    for (name, robot) in small_robots() {
        let [file, scene] = [format!("{name}.toml"), format!("{name}_hall.toml")];
        fs::write(folder.path().join(&file), robot).unwrap();
        let made = cdpr_in(folder.path(), &["new", &scene, "--robot", &file]);
        assert_eq!(status(&made), 0, "{name}: {}", stderr(&made));
        assert_eq!(status(&cdpr_in(folder.path(), &["info", &scene])), 0, "{name}");
        assert!(stderr(&made).contains("query: a path from "), "{name}: {}", stderr(&made));
        assert_eq!(status_of_next(folder.path(), &made), 0, "{name}: {}", stderr(&made));
        // No fewer than three cables hold a point, no fewer than six anything else.
        let holds = ["hung3_forces", "hung4_forces"].contains(&name.as_str());
        let text = fs::read_to_string(folder.path().join(&scene)).unwrap();
        let required = text.lines().any(|line| line == "[wrench]");
        assert_eq!(required, name.ends_with("_forces") && holds, "{name}");
        let told = stderr(&made).contains("so the scene has no [wrench]");
        assert_eq!([told, text.contains("\n# [wrench]\n")], [name.ends_with("_forces") && !holds; 2], "{name}");
    }
}

#[test]
fn a_new_scene_without_a_query_says_why() {
    let folder = folder();
    let made = |name: &str, robot: &str, more: &[&str]| {
        fs::write(folder.path().join("robot.toml"), robot).unwrap();
        let made = cdpr_in(folder.path(), &[&["new", name, "--robot", "robot.toml", "--force"], more].concat());
        assert_eq!(status(&made), 0, "{}", stderr(&made));
        made
    };
    let robots = small_robots();
    let robot = |name: &str| &robots.iter().find(|(known, _)| known == name).unwrap().1;
    // A cable that is far too short.
    let short = format!("{}length = [0.0, 0.05]\n", robot("corners4"));
    let none = made("none.toml", &short, &[]);
    for words in ["note: found no valid position; at 100 of 100 random positions, cable 3 breaks its length", "[query]"]
    {
        assert!(stderr(&none).contains(words), "{}", stderr(&none));
    }
    assert!(stderr(&none).contains("next: cdpr info none.toml\n"), "{}", stderr(&none));
    assert_eq!(status_of_next(folder.path(), &none), 0);
    let text = fs::read_to_string(folder.path().join("none.toml")).unwrap();
    assert!(
        text.contains("\n# found no valid position; at 100 of 100") && text.contains("\n# start = [x, y, z]\n"),
        "{text}"
    );
    // A start outside; both ends given, one of them outside.
    let outside = ["--start", "0", "0", "9"];
    let made_outside = made("outside.toml", robot("corners4"), &outside);
    assert!(stderr(&made_outside).contains("note: the start is not valid: "), "{}", stderr(&made_outside));
    assert_eq!(status_of_next(folder.path(), &made_outside), 0);
    let both = made("both.toml", robot("corners4"), &[&outside[..], &["--goal", "2", "1", "1"]].concat());
    assert!(stderr(&both).contains("the start is not valid") && stderr(&both).contains("next: cdpr plan both.toml"));
    assert_eq!(status_of_next(folder.path(), &both), 1);
}

#[test]
fn similar_mesh_notes_are_grouped_unless_verbose() {
    let folder = folder();
    let mut scene = fs::read_to_string(testdata("scenes/empty.toml")).unwrap();
    scene = scene.replace("../robots/paper.toml", &testdata("robots/paper.toml"));
    for k in 0..20 {
        let x = 10 + k;
        fs::write(folder.path().join(format!("{k}.obj")), format!("v {x} 0 0\nv {x} 1 0\nv {x} 0 1\nf 1 2 3\n"))
            .unwrap();
        scene += &format!("\n[[obstacles]]\nmesh = \"{k}.obj\"\n");
    }
    fs::write(folder.path().join("hall.toml"), scene).unwrap();
    let run = |arguments: &[&str]| cdpr_in(folder.path(), &[arguments, &["hall.toml"]].concat());
    let lines = |text: &str, words: &str| text.lines().filter(|line| line.contains(words)).count();
    let [info, each, plan] = [&["info"][..], &["info", "-v"], &["plan"]].map(run);
    let all = json(&run(&["info", "--format", "json"]))["notes"].as_array().unwrap().len();
    assert!(all >= 40, "{all}");
    for text in [stdout(&info), stderr(&plan)] {
        assert!(lines(&text, "note: ") <= 5, "{text}");
        assert_eq!(lines(&text, "20 meshes have a note like this one"), 3, "{text}");
        assert_eq!(lines(&text, &format!("note: {all} notes in all; -v prints each")), 1, "{text}");
    }
    assert_eq!(lines(&stdout(&each), "note: "), all);
}
