//! Imported robots: every model in testdata against known values, and invalid files.

use std::fs;
use std::path::{Path, PathBuf};

use cdpr_core::Error;
use cdpr_core::geometry::{Point, Rotation};
use cdpr_core::kinematics::{condition, rank, wrench_matrix};
use cdpr_core::model::{CableSpec, InertiaSpec, PulleySpec, Robot};
use cdpr_files::{ImportOptions, Imported, import_robot, load_robot, save_imported};

fn testdata(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../testdata").join(name)
}

fn caspr(model: &str) -> PathBuf {
    testdata("caspr").join(model)
}

fn imported(path: &Path, cable_set: Option<&str>) -> Imported {
    let options = ImportOptions { cable_set: cable_set.map(str::to_string), ..ImportOptions::default() };
    import_robot(path, &options).unwrap()
}

/// Model, robot file of the same robot, a position, and the condition number of its wrench matrix there as another
/// program computed it (rank 6 everywhere).
const MODELS: [(&str, &str, [f64; 3], f64); 5] = [
    ("ACROBOT", "acrobot", [0.5, 0.5, 0.5], 6.884635942562862),
    ("CAROCA", "caroca", [0.0, 0.0, 1.0], 8.700747952307106),
    ("CoGiRo", "cogiro", [0.0, 0.0, 2.0], 3.2696864157942307),
    ("IPAnema_2", "ipanema2", [0.0, 0.0, 3.0], 4.6980337674243895),
    ("The_Cable_Robot_Simulator", "mpi_simulator", [5.9, 7.5, 4.3], 3.196463026509569),
];

#[test]
fn every_caspr_model_is_the_robot_it_is_known_to_be() {
    for (model, known, position, expected) in MODELS {
        let robot = Robot::try_from(imported(&caspr(model), None).robot).unwrap();
        let known = load_robot(testdata("robots").join(format!("{known}.toml"))).unwrap();
        let at = Point::from(position);
        let [found, stored] = [&robot, &known].map(|robot| wrench_matrix(robot, &Rotation::identity(), &at).unwrap());
        assert!((&found - stored).amax() < 1e-12, "{model}");
        assert_eq!(rank(&found), 6, "{model}");
        assert!((condition(&found) / expected - 1.0).abs() < 1e-9, "{model}: {}", condition(&found));
        assert_eq!(robot.mass(), known.mass(), "{model}");
        assert_eq!(robot.center_of_mass(), known.center_of_mass(), "{model}");
        // IPAnema's minimum tension is a placeholder in the source, and is 0 in the stored robot.
        let limits = |robot: &Robot| robot.cables().iter().map(|c| c.tension.unwrap()).collect::<Vec<_>>();
        if model != "IPAnema_2" {
            assert_eq!(limits(&robot), limits(&known), "{model}");
        }
    }
}

#[test]
fn every_cable_set_goes_into_a_robot_file_and_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut sets = 0;
    for (model, set) in [
        ("ACROBOT", "original"),
        ("CAROCA", "original"),
        ("CAROCA", "with_rotating_pulleys"),
        ("CAROCA", "gazebo_sim"),
        ("CoGiRo", "original"),
        ("IPAnema_2", "original"),
        ("IPAnema_2", "IROS_CASPR_2016"),
        ("The_Cable_Robot_Simulator", "original"),
        ("The_Cable_Robot_Simulator", "normal"),
    ] {
        let robot = imported(&caspr(model), Some(set));
        for extension in ["toml", "json"] {
            let path = folder.path().join(format!("robot.{extension}"));
            save_imported(&path, &robot).unwrap();
            assert_eq!(load_robot(&path).unwrap().spec(), &robot.robot, "{model} {set} {extension}");
        }
        sets += 1;
    }
    let in_files: usize = MODELS
        .iter()
        .map(|(model, ..)| fs::read_to_string(caspr(model).join(format!("{model}_cables.xml"))).unwrap())
        .map(|text| text.matches("<cable_set ").count())
        .sum();
    assert_eq!(sets, in_files);
}

#[test]
fn one_file_finds_the_other_and_bodies_may_stand_elsewhere() {
    let folder = caspr("CoGiRo");
    let cables = folder.join("CoGiRo_cables.xml");
    let whole = imported(&folder, None);
    assert_eq!(imported(&cables, None), whole);
    assert_eq!(imported(&folder.join("CoGiRo_bodies.xml"), None), whole);
    let apart = tempfile::tempdir().unwrap();
    let alone = apart.path().join("CoGiRo_cables.xml");
    fs::copy(&cables, &alone).unwrap();
    let error = import_robot(&alone, &ImportOptions::default()).unwrap_err().to_string();
    assert!(error.contains("CoGiRo_cables.xml") && error.contains("name of the bodies file"), "{error}");
    let options = ImportOptions { bodies: Some(folder.join("CoGiRo_bodies.xml")), ..ImportOptions::default() };
    assert_eq!(import_robot(&alone, &options).unwrap().robot, whole.robot);
}

#[test]
fn what_is_left_behind_is_listed() {
    let notes = imported(&caspr("CAROCA"), Some("with_rotating_pulleys")).notes.join("\n");
    for expected in ["joint SPATIAL_EULER_XYZ: q_initial \"0 0 1 0 0 0\"", "original, gazebo_sim"] {
        assert!(notes.contains(expected), "no {expected} in {notes}");
    }
}

#[test]
fn carocas_cables_run_round_pulleys_in_one_of_its_sets() {
    let of_set = |set: &str| imported(&caspr("CAROCA"), Some(set)).robot.cables;
    let round = PulleySpec { radius: 0.045, axis: [0.0, 0.0, 1.0] };
    let without: Vec<_> = of_set("with_rotating_pulleys")
        .into_iter()
        .inspect(|cable| assert_eq!(cable.pulley, Some(round)))
        .map(|cable| CableSpec { pulley: None, ..cable })
        .collect();
    assert_eq!(without, of_set("original"));
}

/// ACROBOT, whose centre of mass is off the joint, with text of its two files replaced.
fn changed(cables: &[(&str, &str)], bodies: &[(&str, &str)]) -> Result<Imported, Error> {
    let folder = tempfile::tempdir().unwrap();
    for (name, changes) in [("ACROBOT_cables.xml", cables), ("ACROBOT_bodies.xml", bodies)] {
        let mut text = fs::read_to_string(caspr("ACROBOT").join(name)).unwrap();
        for (from, to) in changes {
            assert!(text.contains(from), "{from} is not in {name}");
            text = text.replace(from, to);
        }
        fs::write(folder.path().join(name), text).unwrap();
    }
    import_robot(folder.path(), &ImportOptions::default())
}

#[test]
fn attachments_relative_to_the_com_move_to_the_joint() {
    let by_joint = changed(&[], &[]).unwrap().robot;
    let by_com = changed(&[("attachment_reference=\"joint\"", "attachment_reference=\"com\"")], &[]).unwrap().robot;
    let com = by_joint.center_of_mass.unwrap();
    assert_ne!(com, [0.0; 3]);
    for (joint, moved) in by_joint.cables.iter().zip(&by_com.cables) {
        assert_eq!(joint.outlet, moved.outlet);
        assert_eq!(moved.attachment, std::array::from_fn(|k| joint.attachment[k] + com[k]));
    }
}

#[test]
fn inertia_is_about_the_centre_of_mass() {
    let tensor = [[36.598, -0.453, 3.012], [-0.453, 35.982, -1.539], [3.012, -1.539, 25.439]];
    assert_eq!(imported(&caspr("CoGiRo"), None).robot.inertia, Some(InertiaSpec::Tensor(tensor)));
    assert_eq!(imported(&caspr("CAROCA"), None).robot.inertia, Some(InertiaSpec::Diagonal([6.5, 20.0, 22.5])));
    // By hand: 1 kg at (0.1645, 0.177, 0.149) has Ixx = 0.177² + 0.149² = 0.05353 and Ixy = -0.1645 · 0.177 = -0.0291165.
    let by_joint = changed(&[], &[("ref=\"com\"", "ref=\"joint\"")]).unwrap().robot.inertia;
    let Some(InertiaSpec::Tensor(moved)) = by_joint else { panic!("{by_joint:?}") };
    assert!((moved[0][0] - (1.0 - 0.05353)).abs() < 1e-12 && (moved[0][1] - 0.0291165).abs() < 1e-12, "{moved:?}");
}

#[test]
fn an_inertia_that_no_body_has_is_left_out_with_a_note() {
    let placeholder = changed(&[], &[("<Izz>1.0</Izz>", "<Izz>0.0</Izz>")]).unwrap();
    assert_eq!(placeholder.robot.inertia, None);
    let notes = placeholder.notes.join("\n");
    assert!(notes.contains("inertia, since no body has it (found a principal moment of 0 kg·m²"), "{notes}");
}

#[test]
fn models_that_make_no_sense_are_refused_with_element_and_line() {
    let second = "</link_rigid><link_rigid num=\"2\"></link_rigid>";
    for (cables, bodies, expected) in [
        (vec![("<force_max>80</force_max>", "")], vec![], "<properties>: found no <force_max>"),
        (
            vec![("<force_max>80</force_max>", "<force_max>much</force_max>")],
            vec![],
            "\"much\", expected 1 finite number",
        ),
        (vec![("<force_max>80</force_max>", "<force_max>-1</force_max>")], vec![], "tension"),
        (vec![("0.306 0.000 0.137", "0.15 0.15 0.07")], vec![], "attachment 0 lies"),
        (vec![("\"joint\"", "\"elsewhere\"")], vec![], "expected joint or com"),
        (vec![("<link>1</link>", "<link>2</link>")], vec![], "<link>: found link 2"),
        (vec![("id=\"original\"", "id=\"orignal\"")], vec![], "did you mean \"orignal\""),
        (vec![("</cable_ideal>", "")], vec![], "is not valid XML"),
        (vec![], vec![("SPATIAL_EULER_XYZ", "R_Z")], "expected a platform that moves freely"),
        (vec![], vec![("</link_rigid>", second)], "found a second link"),
        (vec![], vec![("<mass>1.0</mass>", "")], "found no <mass>"),
        (vec![], vec![("<mass>1.0</mass>", "<mass>x</mass>")], "<mass>: found \"x\""),
        (vec![], vec![("bodies_system>", "robot>")], "expected <bodies_system>"),
        (vec![], vec![("<Ixy>0.0</Ixy>", "")], "<inertia>: found no <Ixy>"),
        (vec![], vec![("ref=\"com\"", "ref=\"base\"")], "<inertia>: found ref \"base\", expected com or joint"),
    ] {
        let message = changed(&cables, &bodies).unwrap_err().to_string();
        assert!(message.contains(expected), "expected \"{expected}\" in: {message}");
        assert!(
            [".xml: ", ": cables[0]", ": platform"].iter().any(|place| message.contains(place)),
            "no file in: {message}"
        );
    }
}

/// The message for a cables file with this text.
fn refusal(text: &[u8]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let (cables, bodies) = (folder.path().join("a_cables.xml"), folder.path().join("a_bodies.xml"));
    fs::copy(caspr("ACROBOT").join("ACROBOT_bodies.xml"), &bodies).unwrap();
    fs::write(&cables, text).unwrap();
    let started = std::time::Instant::now();
    let message = import_robot(&cables, &ImportOptions::default()).unwrap_err().to_string();
    assert!(started.elapsed().as_secs() < 20, "{:?}: {message}", started.elapsed());
    assert!(message.contains("a_cables.xml"), "no file in: {message}");
    message
}

#[test]
fn hostile_xml_is_refused_in_bounded_time_and_memory() {
    let laughs: String =
        (1..10).map(|k| format!("<!ENTITY l{k} \"{}\">", format!("&l{};", k - 1).repeat(10))).collect();
    let bomb = format!("<!DOCTYPE cables [<!ENTITY l0 \"ha\">{laughs}]><cables>&l9;</cables>");
    assert!(refusal(bomb.as_bytes()).contains("not expanded"));
    let external = "<!DOCTYPE cables [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><cables>&x;</cables>";
    assert!(refusal(external.as_bytes()).contains("not expanded"));
    let nested = "<a>".repeat(1_000_000);
    assert!(refusal(nested.as_bytes()).contains("larger than 1 MB"));
    assert!(refusal(&nested.as_bytes()[..900_000]).contains("is not valid XML"));
    assert!(refusal(&vec![b' '; 100_000_000]).contains("larger than 1 MB"));
    let attributes: String = (0..90_000).map(|k| format!(" a{k}=\"\"")).collect();
    assert!(refusal(format!("<cables{attributes}").as_bytes()).contains("is not valid XML"));
    assert!(refusal(b"\xff\xfe<\0c\0").contains("UTF-8"));
    assert!(refusal(b"").contains("is not valid XML"));
}

#[test]
fn truncated_models_are_refused_wherever_they_end() {
    let text = fs::read(caspr("ACROBOT").join("ACROBOT_cables.xml")).unwrap();
    let end = text.len() - b"</cables>".len();
    for length in (0..end).step_by(97) {
        refusal(&text[..length]);
    }
}

#[test]
fn gazebo_yaml_matches_carocas_cable_set() {
    let gazebo = imported(&testdata("gazebo/caroca.yaml"), None).robot;
    let caspr = imported(&caspr("CAROCA"), Some("gazebo_sim")).robot;
    assert_eq!((gazebo.mass, gazebo.inertia), (caspr.mass, caspr.inertia));
    for (a, b) in gazebo.cables.iter().zip(&caspr.cables) {
        assert_eq!((a.outlet, a.attachment), (b.outlet, b.attachment));
        assert_eq!((a.tension, a.diameter), (b.tension, Some(0.01)));
    }
    assert_eq!(gazebo.platform[0].cuboid, Some([1.2, 0.6, 0.4]));
}

#[test]
fn yaml_that_makes_no_sense_is_refused() {
    let good = fs::read_to_string(testdata("gazebo/caroca.yaml")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("robot.yaml");
    let bomb = "a: &a [x,x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a,*a,*a,*a]\n".to_string()
        + &('b'..'k')
            .map(|c| {
                let n = (c as u8 + 1) as char;
                format!("{n}: &{n} [{}]\n", vec![format!("*{c}"); 9].join(","))
            })
            .collect::<String>();
    for text in [
        good.replace("frame: [-3.5, -2.0, 3.5]", "frame: [-3.5, -2.0]"),
        good.replace("min: 0, effort: 1000", "min: 0, effort: .nan"),
        good.replace("points:", "point:"),
        good.replace("inertia: [6.5, 20.0, 22.5, 0.0, 0.0, 0.0]", "inertia: [6.5, 20.0, 22.5]"),
        good[..700].to_string(),
        String::new(),
        bomb,
        "[".repeat(100_000),
    ] {
        fs::write(&path, text).unwrap();
        let message = import_robot(&path, &ImportOptions::default()).unwrap_err().to_string();
        assert!(message.contains("robot.yaml") && message.len() < 1000, "{message}");
    }
}
