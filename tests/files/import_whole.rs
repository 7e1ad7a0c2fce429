//! Robot files of other programs are read whole: what is not imported is named, or refused.

use std::fs;

use cdpr_core::Error;
use cdpr_core::collision::{CspaceEngine, Interference, Validity};
use cdpr_core::geometry::Point;
use cdpr_core::model::{CableSpec, InertiaSpec, PulleySpec};
use cdpr_files::{ImportOptions, Imported, import_robot, robot_toml, scene_from_text, text::Notation};

/// Outlets and attachments of seven cables, m.
const SEVEN: [([f64; 3], [f64; 3]); 7] = [
    ([0.0, 1.0, 0.0], [-0.15, -0.1, 0.3]),
    ([0.0, 3.0, 0.0], [-0.15, 0.1, 0.3]),
    ([4.0, 2.0, 0.0], [0.15, 0.0, 0.3]),
    ([0.0, 0.0, 4.0], [-0.15, -0.2, -0.3]),
    ([0.0, 4.0, 4.0], [-0.15, 0.2, -0.3]),
    ([4.0, 4.0, 4.0], [0.15, 0.2, -0.3]),
    ([4.0, 0.0, 4.0], [0.15, -0.2, -0.3]),
];

fn cables_file() -> String {
    let place = |[x, y, z]: [f64; 3]| format!("<location>{x} {y} {z}</location>");
    let cable = |(k, (outlet, attachment)): (usize, &([f64; 3], [f64; 3]))| {
        format!(
            "<cable_ideal name=\"cable {}\" attachment_reference=\"joint\">\n<properties>\n<force_min>0</force_min>\n\
             <force_max>1000</force_max>\n<diameter>0.1</diameter>\n</properties>\n<attachments>\n\
             <attachment><link>0</link>{}</attachment>\n<attachment><link>1</link>{}</attachment>\n\
             </attachments>\n</cable_ideal>\n",
            k + 1,
            place(*outlet),
            place(*attachment)
        )
    };
    let cables: String = SEVEN.iter().enumerate().map(cable).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!DOCTYPE cables SYSTEM \"cables.dtd\">\n\
         <cables default_cable_set=\"original\">\n<cable_set id=\"original\">\n{cables}</cable_set>\n</cables>\n"
    )
}

const BODIES: &str = "<bodies_system>\n<links>\n<link_rigid num=\"1\">\n<joint type=\"SPATIAL_EULER_XYZ\"/>\n<physical>\n\
    <mass>1</mass>\n<com_location>0 0 0</com_location>\n</physical>\n</link_rigid>\n</links>\n</bodies_system>\n";

fn caspr(cables: &str, bodies: &str) -> Result<Imported, Error> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("seven_cables.xml"), cables).unwrap();
    fs::write(folder.path().join("seven_bodies.xml"), bodies).unwrap();
    import_robot(folder.path(), &ImportOptions::default())
}

#[test]
fn cables_of_caspr_have_their_diameter() {
    let imported = caspr(&cables_file(), BODIES).unwrap();
    assert_eq!(robot_toml(&imported).matches("diameter = 0.1\n").count(), 7);
    assert_eq!(imported.notes, ["joint SPATIAL_EULER_XYZ: no ranges"]);
    let robot = serde_json::json!(cdpr_core::model::RobotSpec { version: None, ..imported.robot });
    let scene = |clearance: f64| {
        let text = serde_json::json!({
            "version": 1,
            "robot": robot,
            "clearance": clearance,
            "workspace": { "min": [0.0, 0.0, 0.0], "max": [4.0, 4.0, 4.0] },
        });
        let scene = scene_from_text(&text.to_string(), Notation::Json, None).unwrap();
        CspaceEngine::new(&scene, Interference::Exact).unwrap()
    };
    let start = Point::new(2.0, 2.0, 2.0);
    // The axes of cables 1 and 4 are 0.173454 m apart.
    let found = scene(0.0).clearance(&start, &start).unwrap().value;
    assert!((found - 0.073454).abs() < 1e-6, "{found}");
    assert!(scene(0.07).state_valid(&start) && !scene(0.1).state_valid(&start));
}

/// The text with `from` replaced where it first occurs.
fn first(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from} is not in {text}");
    text.replacen(from, to, 1)
}

const POINT: &str = "<attachment><link>0</link><location>0 1 0</location></attachment>";
const PULLEY: &str = "<base_rotating_pulley><fixed_location>0 1 0.5</fixed_location><pulley_radius>0.045</pulley_radius>\
    <cable_entry_vector>0 0 2</cable_entry_vector></base_rotating_pulley>";

/// The first of seven cables runs round a pulley, and the second is a spring with E A = 7e5 N, in CASPR's words.
fn pulley_and_spring() -> String {
    let text = first(&cables_file(), POINT, PULLEY);
    let second = "<cable_ideal name=\"cable 2\"";
    let at = text.find(second).unwrap();
    let spring = first(&text[at..], "cable_ideal", "cable_linear_spring");
    let spring = first(&spring, "</cable_ideal>", "</cable_linear_spring>");
    format!("{}{}", &text[..at], first(&spring, "<properties>", "<properties><K>7e5</K>"))
}

#[test]
fn pulleys_and_stiffness_of_caspr_are_those_of_a_robot_file() {
    let imported = caspr(&pulley_and_spring(), BODIES).unwrap();
    assert_eq!(imported.notes, ["joint SPATIAL_EULER_XYZ: no ranges"]);
    let plain = caspr(&cables_file(), BODIES).unwrap().robot.cables;
    let pulley = PulleySpec { radius: 0.045, axis: [0.0, 0.0, 2.0] };
    let mut expected = plain.clone();
    expected[0] = CableSpec { outlet: [0.0, 1.0, 0.5], pulley: Some(pulley), ..expected[0].clone() };
    expected[1].stiffness = Some(7e5);
    assert_eq!(imported.robot.cables, expected);
    let text = robot_toml(&imported);
    assert!(text.contains("radius = 0.045\n") && text.contains("stiffness = 700000.0\n"), "{text}");
}

#[test]
fn cables_of_variable_stiffness_are_read_without_their_spring() {
    for (kind, inside) in [
        ("cable_vsd_torsion_spring", "<K_cable>7e5</K_cable><num_torsion_springs>4</num_torsion_springs>"),
        ("cable_vsd_flexure_linear", "<K_cable>7e5</K_cable>"),
        ("cable_vsd_polynomial", "<K_cable>7e5</K_cable>"),
    ] {
        let text = first(&pulley_and_spring(), "<K>7e5</K>", inside).replace("cable_linear_spring", kind);
        let imported = caspr(&text, BODIES).unwrap();
        assert!(imported.robot.cables.iter().all(|cable| cable.stiffness.is_none()));
        let notes = imported.notes.join("\n");
        assert!(notes.contains(&format!("{kind}: its spring is left out, and so is the stiffness")), "{notes}");
        assert!(notes.contains("<K_cable> of <properties> (line 17)"), "{notes}");
    }
}

#[test]
fn cables_of_caspr_that_make_no_sense_are_refused_with_element_and_line() {
    let text = pulley_and_spring();
    let radius = "<pulley_radius>0.045</pulley_radius>";
    let entry = "<cable_entry_vector>0 0 2</cable_entry_vector>";
    for (from, to, expected) in [
        (radius, "", "<base_rotating_pulley>: found no <pulley_radius>, expected one (line 12)"),
        (entry, "", "<base_rotating_pulley>: found no <cable_entry_vector>, expected one (line 12)"),
        (
            "<fixed_location>0 1 0.5</fixed_location>",
            "",
            "<base_rotating_pulley>: found no <fixed_location>, expected one (line 12)",
        ),
        (
            radius,
            "<pulley_radius>45 mm</pulley_radius>",
            "<pulley_radius>: found \"45 mm\", expected 1 finite number (line 12)",
        ),
        (radius, "<pulley_radius>1e999</pulley_radius>", "<pulley_radius>: found \"1e999\", expected 1 finite number"),
        (
            radius,
            "<pulley_radius>-0.045</pulley_radius>",
            "<cable_ideal>: pulley.radius: found -0.045, expected a finite positive number (line 5)",
        ),
        (radius, "<pulley_radius>0</pulley_radius>", "<cable_ideal>: pulley.radius: found 0, "),
        (
            radius,
            &format!("{radius}{radius}"),
            "<pulley_radius>: found a second <pulley_radius>, expected one (line 12)",
        ),
        (
            entry,
            "<cable_entry_vector>0 0 0</cable_entry_vector>",
            "<cable_ideal>: pulley.axis: found [0.0, 0.0, 0.0], expected the direction in which the cable arrives (line 5)",
        ),
        (
            entry,
            "<cable_entry_vector>0 1</cable_entry_vector>",
            "<cable_entry_vector>: found \"0 1\", expected 3 finite numbers (line 12)",
        ),
        (
            PULLEY,
            "<screw_base_rotating_pulley></screw_base_rotating_pulley>",
            "<screw_base_rotating_pulley>: found this, expected <attachment>, or <base_rotating_pulley> for the base (line 12)",
        ),
        ("<K>7e5</K>", "", "<properties>: found no <K>, expected one (line 17)"),
        (
            "<K>7e5</K>",
            "<K>0</K>",
            "<cable_linear_spring>: stiffness: found 0, expected a finite positive number (line 16)",
        ),
        ("<K>7e5</K>", "<K>-7e5</K>", "<cable_linear_spring>: stiffness: found -700000, "),
        ("<K>7e5</K>", "<K></K>", "<K>: found \"\", expected 1 finite number (line 17)"),
        ("<force_max>1000</force_max>", "<force_max>-1</force_max>", "<cable_ideal>: tension: found [0, -1], "),
        (
            "attachment_reference=\"joint\"",
            "",
            "<cable_ideal>: found no attribute attachment_reference, expected one (line 5)",
        ),
        (
            "</cable_set>",
            "<cable_passive_linear_spring name=\"s\"><properties><K>5</K><l0>1</l0></properties></cable_passive_linear_spring>\
             </cable_set>",
            "<cable_passive_linear_spring>: found a spring without a winch, expected cables only (line 82)",
        ),
        (
            "</cable_set>",
            "<muscle_hill_type><properties/></muscle_hill_type></cable_set>",
            "<muscle_hill_type>: found this in <cable_set>, expected <cable_ideal>, <cable_linear_spring>, \
             <cable_vsd_torsion_spring>",
        ),
    ] {
        let message = caspr(&first(&text, from, to), BODIES).unwrap_err().to_string();
        assert!(message.contains(&format!("seven_cables.xml: {expected}")), "{expected} is not in {message}");
    }
    let both_ends = text.replace("<attachment><link>1</link>", "<base_rotating_pulley><link>1</link>");
    let both_ends = both_ends.replace("0.3</location></attachment>", "0.3</location></base_rotating_pulley>");
    let message = caspr(&both_ends, BODIES).unwrap_err().to_string();
    assert!(message.contains("<base_rotating_pulley>: found this, expected <attachment>"), "{message}");
}

#[test]
fn document_types_that_declare_no_entity_are_skipped() {
    let declared = "<!DOCTYPE cables [\n  <!ATTLIST cable_set id ID #REQUIRED>\n]>";
    let text = cables_file().replace("<!DOCTYPE cables SYSTEM \"cables.dtd\">", declared);
    let imported = caspr(&format!("\u{feff}{text}"), BODIES).unwrap();
    assert_eq!(imported.robot, caspr(&cables_file(), BODIES).unwrap().robot);
    let entity = text.replace("<!ATTLIST cable_set id ID #REQUIRED>", "<!ENTITY x \"y\">");
    let message = caspr(&entity, BODIES).unwrap_err().to_string();
    let expected =
        "seven_cables.xml: found an entity, which is not expanded, in the document type, expected none (line 3)";
    assert!(message.ends_with(expected), "{message}");
}

#[test]
fn unread_caspr_contents_are_listed_or_refused() {
    let (cables, joint) = (cables_file(), "joint SPATIAL_EULER_XYZ: no ranges");
    let noted = |cables: &str, bodies: &str| caspr(cables, bodies).unwrap().notes;
    for (from, to, expected) in [
        (
            "</properties>",
            "<K_cable>9</K_cable>\n</properties>",
            "<K_cable> of <properties> (7 times, the first in line 10)",
        ),
        ("name=\"cable 1\"", "name=\"cable 1\" color=\"red\"", "color of <cable_ideal> (line 5)"),
        // A cable without a name would be called by its index, which may be the name of another one.
        ("name=\"cable 1\"", "", "names of cables, since two are equal or one has none"),
        ("name=\"cable 2\"", "name=\"1\"", "names of cables, since two are equal or one has none"),
        ("<link>0</link>", "<link unit=\"1\">0</link>", "unit of <link> (7 times, the first in line 12)"),
        ("<cable_set id", "<cable_set note=\"\" id", "note of <cable_set> (line 4)"),
        ("</cables>", "<extra><deep/></extra></cables>", "<extra> of <cables> (line 83)"),
        ("</cable_set>", "stray</cable_set>", "text in <cable_set> (line 4)"),
        ("</cable_set>", "</cable_set><cable_set id=\"other\"><anything/></cable_set>", "other cable sets: other"),
    ] {
        assert_eq!(noted(&cables.replace(from, to), BODIES), [joint, expected]);
    }
    let nameless = (1..=7).fold(cables.clone(), |text, k| text.replace(&format!("name=\"cable {k}\" "), ""));
    assert_eq!(noted(&nameless, BODIES), [joint]);
    for (from, to, expected) in [
        ("<links>", "<links display_range=\"0 1\">", "display_range of <links> (line 2)"),
        ("num=\"1\"", "num=\"1\" name=\"Plate\"", "name of the platform \"Plate\""),
        ("</physical>", "<friction>1</friction></physical>", "<friction> of <physical> (line 8)"),
        ("</link_rigid>", "<tool/></link_rigid>", "<tool> of <link_rigid> (line 9)"),
        ("</links>", "</links><operational_spaces/>", "<operational_spaces> of <bodies_system> (line 10)"),
    ] {
        assert_eq!(noted(&cables, &BODIES.replace(from, to)), [joint, expected]);
    }
    for (from, to, expected) in [
        ("<diameter>0.1</diameter>", "<diameter>-1</diameter>", "<cable_ideal>: diameter: found -1, "),
        (
            "<diameter>0.1</diameter>",
            "<diameter>0.1</diameter><diameter>1</diameter>",
            "found a second <diameter>, expected one (line 9)",
        ),
        (
            "<diameter>0.1</diameter>",
            "<diameter>0.1<unit>m</unit></diameter>",
            "<unit>: found this in <diameter>, expected numbers only (line 9)",
        ),
        ("<attachment><link>0</link>", "<anchor><link>0</link>", "is not valid XML"),
        ("<cables", "<!-- --><cable", "is not valid XML"),
        (
            "</cable_set>",
            "</cable_set><cable_set id=\"original\"/>",
            "found several cable sets \"original\", expected one (line 4)",
        ),
    ] {
        let message = caspr(&cables.replace(from, to), BODIES).unwrap_err().to_string();
        assert!(message.contains(expected), "{expected} is not in {message}");
    }
    let anchors = cables
        .replace("<attachment><link>1", "<anchor><link>1")
        .replace("0.3</location></attachment>", "0.3</location></anchor>");
    let message = caspr(&anchors, BODIES).unwrap_err().to_string();
    assert!(message.contains("<anchor>: found this, expected <attachment>"), "{message}");
    for (from, to, expected) in [
        ("num=\"1\"", "num=\"2\"", "<link_rigid>: found num \"2\", expected 1 for the platform (line 3)"),
        (
            "</physical>",
            "</physical><parent><num>1</num><location>0 0 0</location></parent>",
            "found link 1, expected 0",
        ),
        ("<mass>1</mass>", "<mass>1</mass><mass>2</mass>", "found a second <mass>"),
    ] {
        let message = caspr(&cables, &BODIES.replace(from, to)).unwrap_err().to_string();
        assert!(message.contains(expected), "{expected} is not in {message}");
    }
}

/// A robot of the Gazebo simulation.
const CUBE: &str = "\
cable: {radius: 0.005}
joints:
  actuated: {effort: 6500, min: 5}
platform:
  mass: 50.0
  size: [0.4, 0.3, 0.25]
  type: box
points:
- {frame: [-3.5, 2.0, 3.5], platform: [0.2, 0.15, 0.125]}
- {frame: [3.5, 2.0, 3.5], platform: [-0.2, 0.15, -0.125]}
- {frame: [-3.5, -2.0, 3.5], platform: [-0.2, -0.15, -0.125]}
- {frame: [3.5, -2.0, 3.5], platform: [0.2, -0.15, 0.125]}
";

fn gazebo(text: &str) -> Result<Imported, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cube.yaml");
    fs::write(&path, text).unwrap();
    import_robot(&path, &ImportOptions::default())
}

fn nested(text: &str) -> String {
    let lines: String = text.lines().map(|line| format!("  {line}\n")).collect();
    format!("model:\n{lines}")
}

#[test]
fn gazebo_robots_are_read_at_the_top_or_under_model() {
    let cube = gazebo(CUBE).unwrap();
    assert_eq!(cube.notes, Vec::<String>::new());
    assert_eq!(cube.robot.cables.len(), 4);
    assert_eq!((cube.robot.cables[0].tension, cube.robot.cables[0].diameter), (Some([5.0, 6500.0]), Some(0.01)));
    assert_eq!(gazebo(&nested(CUBE)).unwrap(), cube);
    let beside = "controllers:\n  linear0: {position: {d: 0.5, i: 0.1, p: 10}}\n";
    let found =
        gazebo(&format!("{beside}{}  filepath: /a/cube.yaml\n  global_frame: {{position: [0, 0, 1]}}\n", nested(CUBE)))
            .unwrap();
    assert_eq!(found.robot, cube.robot);
    assert_eq!(found.notes, ["controllers, model.filepath, model.global_frame"]);
}

#[test]
fn gazebo_platforms_have_a_size_or_corners() {
    let size = "size: [0.4, 0.3, 0.25]";
    let body = |with: &str| gazebo(&CUBE.replace(size, with)).unwrap().robot.platform.remove(0);
    let around = body("lower: [-0.2, -0.15, -0.125]\n  upper: [0.2, 0.15, 0.125]");
    assert_eq!(around, gazebo(CUBE).unwrap().robot.platform[0]);
    let beside = body("lower: [-0.2, -0.15, -0.125]\n  upper: [0.2, 0.15, 0.625]");
    assert_eq!((beside.cuboid, beside.position), (Some([0.4, 0.3, 0.75]), Some([0.0, 0.0, 0.25])));
    for (text, note) in [
        (
            CUBE.replace(size, "color: Black"),
            "the platform has no box with a size: the hull of the attachments is used",
        ),
        (CUBE.replace("box", "sphere"), "platform.type is sphere, not box: the hull of the attachments is used"),
    ] {
        let imported = gazebo(&text).unwrap();
        assert_eq!(imported.notes[0], note);
        assert_eq!(imported.robot.platform[0].vertices.as_ref().unwrap().len(), 4);
    }
}

#[test]
fn gazebo_inertias_are_lists_or_tables() {
    let list = gazebo(&CUBE.replace("mass: 50.0", "mass: 50.0\n  inertia: [0.1, 0.2, 0.2, 0.01, 0, 0]")).unwrap().robot;
    let table = "mass: 50.0\n  inertial: {xx: 0.1, xy: 0.01, xz: 0, yy: 0.2, yz: 0, zz: 0.2}";
    assert_eq!(gazebo(&CUBE.replace("mass: 50.0", table)).unwrap().robot, list);
    let tensor = [[0.1, 0.01, 0.0], [0.01, 0.2, 0.0], [0.0, 0.0, 0.2]];
    assert_eq!(list.inertia, Some(InertiaSpec::Tensor(tensor)));
    let zero = "mass: 50.0\n  inertial: {xx: 0, xy: 0, xz: 0, yy: 0, yz: 0, zz: 0}";
    let imported = gazebo(&CUBE.replace("mass: 50.0", zero)).unwrap();
    assert_eq!((imported.robot.inertia, imported.notes.len()), (None, 1));
    assert!(imported.notes[0].starts_with("inertia, since no body has it"), "{:?}", imported.notes);
}

#[test]
fn unread_gazebo_contents_are_listed() {
    let text = CUBE
        .replace("{radius: 0.005}", "{radius: 0.005, mass: 0.001}\nframe: {type: poles, lower: [0, 0, 0]}\nversion: 2")
        .replace("min: 5}", "min: 5, velocity: 10}\n  passive: {damping: 0.01}")
        .replace("mass: 50.0", "mass: 50.0\n  visual: box\n  position: {xyz: [0, 0, 1], rpy: [0, 0, 0], frame: w}")
        .replace("{frame: [", "{name: a, frame: [");
    assert_eq!(
        gazebo(&text).unwrap().notes,
        [
            "cable.mass 0.001: that of a bar whose length is not the cable's; linear_density is mass per metre",
            "initial position [0.0, 0.0, 1.0], rpy [0.0, 0.0, 0.0]: start and orientation belong in the query of a scene",
            "frame: its bars are not imported as obstacles",
            "joints.actuated.velocity, joints.passive, platform.position.frame, platform.visual, points.name, version",
        ]
    );
}

#[test]
fn gazebo_files_that_give_half_a_robot_are_refused_with_the_key() {
    let [whole, size] = [CUBE, "size: [0.4, 0.3, 0.25]"];
    for (text, expected) in [
        (
            whole.replace("points:", "point:"),
            "points: found none, expected a list of cables, each with frame and platform",
        ),
        (nested(&whole.replace("points:", "point:")), "model.points: found none, expected a list of cables"),
        (
            whole.replace("platform:\n", "plate:\n"),
            "platform: found none, expected a table with the mass and shape of the platform",
        ),
        (format!("{whole}model: {{}}\n"), "platform: found beside model, expected under model"),
        (whole.replace("frame: [-3.5, 2.0, 3.5], ", ""), "points[0].frame: found none, expected 3 numbers"),
        (
            whole.replace("frame: [3.5, 2.0, 3.5]", "frame: [3.5, 2.0]"),
            "points[1].frame: found [3.5,2.0], expected 3 finite numbers",
        ),
        (
            whole.replace("frame: [3.5, 2.0, 3.5]", "frame: [3.5, 2.0, a]"),
            "points[1].frame: found [3.5,2.0,\"a\"], expected 3 finite numbers",
        ),
        (whole.replace("effort: 6500", "effort: .nan"), "is not valid YAML: line 3 column 22: non-finite float"),
        (whole.replace("effort: 6500", "effort:"), "joints.actuated.effort: found nothing, expected a finite number"),
        (whole.replace("effort: 6500, ", ""), "joints.actuated.effort: found none, expected a number"),
        (
            whole.replace("actuated", "passive"),
            "joints.actuated: found none, expected a table with the tension limits effort and min",
        ),
        (whole.replace("mass: 50.0", "mass: heavy"), "platform.mass: found \"heavy\", expected a finite number"),
        (whole.replace("mass: 50.0", "inertia: [1, 2]"), "platform.inertia: found [1,2], expected 6 finite numbers"),
        (whole.replace("mass: 50.0", "inertial: {xx: 1}"), "platform.inertial.yy: found none, expected a number"),
        (
            whole.replace(size, "lower: [0, 0, 0]"),
            "platform: expected either size, or lower and upper, to give the box",
        ),
        (
            whole.replace(size, &format!("{size}\n  lower: [0, 0, 0]\n  upper: [1, 1, 1]")),
            "platform: expected either size",
        ),
        (
            whole.replace(size, "lower: [0, 0, 1]\n  upper: [1, 1, 1]"),
            "platform.lower: found [0.0, 0.0, 1.0], expected numbers below those of upper, [1.0, 1.0, 1.0]",
        ),
        (whole.replace("  type: box\n", ""), "platform.type: found none, expected box, since the size of one is given"),
        (whole.replace("type: box", "type: [box]"), "platform.type: found [\"box\"], expected a word"),
        (whole.replace("cable: {radius: 0.005}", "cable: 0.005"), "cable: found 0.005, expected a table"),
        (format!("{whole}cable: {{radius: 1}}\n"), "is not valid YAML"),
        ("- 1\n".to_string(), "found [1], expected a table"),
        (String::new(), "found nothing"),
    ] {
        let message = gazebo(&text).unwrap_err().to_string();
        assert!(message.contains(&format!("cube.yaml: {expected}")), "{expected} is not in {message}");
        assert!(!message.contains("missing field") && !message.contains("invalid type"), "{message}");
    }
}
