//! Printing: results to standard output, talk to standard error. A reader that has gone away is no error.

use std::io::Write;

use cdpr_core::Scene;
use cdpr_core::collision::Constraints;
use cdpr_core::geometry::Point;

/// Prints a line of the result.
pub fn result(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// Says something that is not part of the result.
pub fn say(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

/// Says what is special about a scene.
pub fn say_notes(constraints: &Constraints) {
    for note in &constraints.notes {
        say(&format!("note: {note}"));
    }
}

/// "1 obstacle", "3 obstacles".
pub fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

/// A position for people.
pub fn position(p: &Point) -> String {
    format!("({}, {}, {})", short(p.x), short(p.y), short(p.z))
}

/// A length for people, m: up to four decimals.
pub fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// A force or moment for people, three decimals, never minus zero.
pub fn thousandths(number: f64) -> String {
    format!("{:.3}", (number * 1e3).round() / 1e3 + 0.0)
}

/// One line about a scene.
pub fn scene_line(scene: &Scene) -> String {
    let robot = scene.robot();
    format!(
        "{}: {} with {}, {}",
        scene.name(),
        robot.name(),
        count(robot.cables().len(), "cable"),
        count(scene.obstacles().len(), "obstacle")
    )
}
