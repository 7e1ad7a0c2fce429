//! Cable lengths as CSV: with a header of a quantity and the name of each cable, in any order and among other columns, as in a
//! trajectory; or without one, a length, m, for each cable in the order of the robot.
//!
//! The quantity is `length:`, m, or, in a file without it, `command:`, m, or `angle:`, rad. From commands and angles, lengths follow
//! with the drums and, if cables stretch, with the columns `tension:`, N.

use std::path::Path;

use cdpr_core::Choice;
use cdpr_core::error::{Error, printable};
use cdpr_core::model::{Joints, Robot};
use csv::StringRecord;

use super::cable_columns::cable_of;
use super::csv_cell::number;
use super::text;

/// Quantity of the columns that say how far cables are stretched.
const TENSION: &str = "tension";

/// Rows of cable lengths.
#[derive(Debug, Clone, PartialEq)]
pub struct CableLengths {
    /// What they were read from.
    pub source: Joints,
    /// For each row, the length of each cable in the order of the robot, m.
    pub rows: Vec<Vec<f64>>,
    /// The line of each row, for messages.
    pub lines: Vec<u64>,
}

/// Loads rows of cable lengths of a robot from a CSV file of any name.
///
/// # Errors
/// A file that cannot be read, and the errors of [`lengths_from_text`]; the file is named.
pub fn load_lengths(path: impl AsRef<Path>, robot: &Robot) -> Result<CableLengths, Error> {
    let path = path.as_ref();
    lengths_from_text(&text::read(path)?, robot).map_err(|e| e.in_file(path))
}

/// Reads rows of cable lengths of a robot.
///
/// # Errors
/// Columns that are missing, unknown or there twice; angles of a cable without a drum; no rows; a row with another number of values;
/// what is not a number; a negative tension. Whether numbers can be lengths is not checked here.
///
/// # Example
/// ```
/// let scene = cdpr_core::testing::empty(); // eight cables, "cable 0" to "cable 7"
/// let found = cdpr_files::lengths_from_text("1,2,3,4,5,6,7,8\n", scene.robot())?;
/// assert_eq!((found.rows[0][2], found.lines[0]), (3.0, 1));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn lengths_from_text(text: &str, robot: &Robot) -> Result<CableLengths, Error> {
    let mut reader =
        csv::ReaderBuilder::new().has_headers(false).flexible(true).trim(csv::Trim::All).from_reader(text.as_bytes());
    let mut found = CableLengths { source: Joints::Length, rows: Vec::new(), lines: Vec::new() };
    let mut columns: Option<Columns> = None;
    for record in reader.records() {
        let record = record.map_err(|e| {
            Error::invalid(e.position().map_or(String::new(), |p| format!("line {}", p.line())), e.to_string())
        })?;
        let line = record.position().map_or(0, |place| line_of(place, text));
        if columns.is_none() {
            match Joints::ALL.iter().map(|(joints, ..)| *joints).find(|source| has(&record, source.name())) {
                Some(source) => {
                    found.source = source;
                    columns = Some(Columns::named(&record, robot, source)?);
                    continue;
                }
                None => columns = Some(Columns::in_order(robot)),
            }
        }
        let columns = columns.as_ref().expect("they are known from the first row on");
        found.rows.push(columns.lengths(&record, robot, line)?);
        found.lines.push(line);
    }
    if found.rows.is_empty() {
        return Err(Error::invalid("", "found no rows, expected at least one with the length of each cable"));
    }
    Ok(found)
}

/// The line of a record, whose position is that of the empty lines before it.
fn line_of(place: &csv::Position, text: &str) -> u64 {
    let ends = text.bytes().skip(place.byte() as usize).take_while(|byte| matches!(byte, b'\n' | b'\r'));
    place.line() + ends.filter(|byte| *byte == b'\n').count() as u64
}

/// Whether a header has columns of a quantity.
fn has(header: &StringRecord, quantity: &str) -> bool {
    header.iter().any(|cell| cable_of(cell, &[quantity]).is_some())
}

/// Where the numbers are.
struct Columns {
    /// Number of columns.
    count: usize,
    source: Joints,
    /// The column of each cable.
    of_cables: Vec<usize>,
    /// The column of the tension of each cable, if it is needed.
    tensions: Option<Vec<usize>>,
}

impl Columns {
    fn in_order(robot: &Robot) -> Self {
        let count = robot.cables().len();
        Columns { count, source: Joints::Length, of_cables: (0..count).collect(), tensions: None }
    }

    fn named(header: &StringRecord, robot: &Robot, source: Joints) -> Result<Self, Error> {
        let stretch = source != Joints::Length && robot.cables().iter().any(|cable| cable.stiffness.is_finite());
        let tensions = (stretch && has(header, TENSION)).then(|| of_every_cable(header, robot, TENSION)).transpose()?;
        Ok(Columns { count: header.len(), source, of_cables: of_every_cable(header, robot, source.name())?, tensions })
    }

    fn lengths(&self, record: &StringRecord, robot: &Robot, line: u64) -> Result<Vec<f64>, Error> {
        if record.len() != self.count {
            let problem = format!("found {} values, expected {}", record.len(), self.count);
            return Err(Error::invalid(format!("line {line}"), problem));
        }
        let place = |cable: &str| format!("line {line}, {}", printable(cable));
        let numbers = |columns: &[usize]| -> Result<Vec<f64>, Error> {
            let cells = robot.cables().iter().zip(columns);
            cells.map(|(cable, column)| number(&record[*column], || place(&cable.name))).collect()
        };
        let tensions = self.tensions.as_deref().map(numbers).transpose()?;
        let lengths = robot.lengths_from(self.source, &numbers(&self.of_cables)?, tensions.as_deref());
        lengths.map_err(|error| match error.place().map(place) {
            Some(place) => error.at(&place),
            None => error,
        })
    }
}

fn header_error(problem: String) -> Error {
    Error::invalid("header", problem)
}

/// The column of a quantity for each cable.
fn of_every_cable(header: &StringRecord, robot: &Robot, quantity: &str) -> Result<Vec<usize>, Error> {
    let names = robot.cable_names();
    let cells = header.iter().enumerate();
    let found: Vec<(usize, &str)> = cells.filter_map(|(k, cell)| Some((k, cable_of(cell, &[quantity])?))).collect();
    if let Some((_, other)) = found.iter().find(|(_, name)| !names.contains(name)) {
        let expected = names.iter().map(|name| printable(name)).collect::<Vec<_>>().join(", ");
        return Err(header_error(format!("found {quantity}:{}, expected the cables {expected}", printable(other))));
    }
    let column = |name: &&str| {
        let mut at = found.iter().filter(|(_, found)| found == name).map(|(k, _)| *k);
        let column = format!("column {quantity}:{}", printable(name));
        match (at.next(), at.next()) {
            (Some(column), None) => Ok(column),
            (None, _) => Err(header_error(format!("found no {column}, expected every cable"))),
            (Some(_), Some(_)) => Err(header_error(format!("found the {column} twice, expected it once"))),
        }
    };
    names.iter().map(column).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::model::spec::DrumSpec;
    use cdpr_core::model::{BodySpec, CableSpec, RobotSpec};
    use cdpr_core::testing::paper_robot;

    /// A robot with three cables: "left", "a,b" and "cable 2".
    fn robot() -> Robot {
        let cable = |(k, name): (usize, Option<&str>)| CableSpec {
            name: name.map(str::to_string),
            outlet: [k as f64, 0.0, 1.0],
            ..CableSpec::default()
        };
        let cables = [Some("left"), Some("a,b"), None].into_iter().enumerate().map(cable).collect();
        let platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
        Robot::try_from(RobotSpec { cables, platform, ..paper_robot() }).unwrap()
    }

    #[test]
    fn rows_have_the_order_of_the_robot_whatever_that_of_the_columns() {
        let text = "t, length:cable 2,\"length:a,b\",speed:left,length:left\n0,3,2,9,1\n0.1,3.5,2.5,9,1.5\n";
        let source = Joints::Length;
        let expected = CableLengths { source, rows: vec![vec![1.0, 2.0, 3.0], vec![1.5, 2.5, 3.5]], lines: vec![2, 3] };
        assert_eq!(lengths_from_text(text, &robot()).unwrap(), expected);
        let plain = "1, 2,3\n\n1.5,2.5,3.5";
        assert_eq!(lengths_from_text(plain, &robot()).unwrap(), CableLengths { lines: vec![1, 3], ..expected });
    }

    #[test]
    fn numbers_are_read_as_written_and_judged_later() {
        assert_eq!(lengths_from_text("1e-3,-2,0", &robot()).unwrap().rows, [[1e-3, -2.0, 0.0]]);
    }

    /// `robot` whose cables have drums, of which "left" stretches by 1 % at 100 N.
    fn elastic() -> Robot {
        let drum = DrumSpec { radius: 0.1, gear: Some(-20.0), zero: Some(2.0), lead: Some(1.0) };
        let mut spec = robot().spec().clone();
        spec.cables.iter_mut().for_each(|cable| cable.drum = Some(drum));
        spec.cables[0].stiffness = Some(1e4);
        Robot::try_from(spec).unwrap()
    }

    #[test]
    fn lengths_follow_from_commands_and_angles() {
        let tensions = "tension:left,\"tension:a,b\",tension:cable 2";
        let by_hand = |text: &str, source| {
            let found = lengths_from_text(text, &elastic()).unwrap();
            assert_eq!(found.source, source);
            // (1 + 3) m of the first cable, 1 % longer; the others as commanded: 2 − 20 × 0.1 / 20, 2 + 40 × 0.1 / 20.
            let far = found.rows[0].iter().zip([3.04, 1.9, 2.2]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(far < 1e-14, "{:?}", found.rows);
        };
        let numbers = "3,1.9,2.2,100,7,0\n";
        by_hand(&format!("command:left,\"command:a,b\",command:cable 2,{tensions}\n{numbers}"), Joints::Command);
        let numbers = "-200,20,-40,100,7,0\n";
        by_hand(&format!("angle:left,\"angle:a,b\",angle:cable 2,{tensions}\n{numbers}"), Joints::Angle);
        // Lengths come first, then commands.
        let both = "angle:left,length:left,\"length:a,b\",length:cable 2\n7,3.04,1.9,2.2\n";
        by_hand(both, Joints::Length);
    }

    #[test]
    fn commands_and_angles_without_what_they_need_are_refused() {
        let commands = "command:left,\"command:a,b\",command:cable 2";
        let angles = "angle:left,\"angle:a,b\",angle:cable 2";
        let said = |text: String, robot: &Robot| lengths_from_text(&text, robot).unwrap_err().to_string();
        let expected = "line 2, left: found no tension of a cable that stretches, expected one";
        assert_eq!(said(format!("{commands}\n1,2,3\n"), &elastic()), expected);
        let expected = "header: found no column tension:a,b, expected every cable";
        assert_eq!(said(format!("{commands},tension:left\n1,2,3,4\n"), &elastic()), expected);
        let expected = "line 2, left: found an angle of a cable without a drum";
        assert_eq!(said(format!("{angles}\n1,2,3\n"), &robot()), expected);
        let expected = "line 2, left: found a tension of -1 N, expected a finite number of at least 0";
        let tensions = "tension:left,\"tension:a,b\",tension:cable 2";
        assert_eq!(said(format!("{angles},{tensions}\n1,2,3,-1,0,0\n"), &elastic()), expected);
        // Cables that do not stretch need no tensions.
        assert_eq!(lengths_from_text(&format!("{commands}\n1,2,3\n"), &robot()).unwrap().rows, [[1.0, 2.0, 3.0]]);
    }

    #[test]
    fn errors_name_line_and_cable() {
        let wrong = [
            ("", "found no rows, expected at least one"),
            (
                "length:left,length:\"a,b\",length:cable 2\n",
                "header: found length:\"a, expected the cables left, a,b, cable 2",
            ),
            ("length:left,\"length:a,b\",length:cable 2\n", "found no rows, expected at least one"),
            ("length:left,length:cable 2\n1,2\n", "header: found no column length:a,b, expected every cable"),
            ("length:left,length:left\n1,2\n", "header: found the column length:left twice, expected it once"),
            (
                "length:left,length:cable 2,\"length:a,b\",length:left\n1,2\n",
                "header: found the column length:left twice, expected it once",
            ),
            ("length:right\n1\n", "header: found length:right, expected the cables left, a,b, cable 2"),
            ("1,2\n", "line 1: found 2 values, expected 3"),
            ("1,2,3,4\n", "line 1: found 4 values, expected 3"),
            ("1,2,3\n1,2\n", "line 2: found 2 values, expected 3"),
            ("left,a,b\n1,2,3\n", "line 1, left: found \"left\", expected a number with a decimal point"),
            ("1,2,3\n1,,3\n", "line 2, a,b: found \"\", expected a number with a decimal point"),
            ("1,2,3\n1,2,NaN\n", "line 2, cable 2: found \"NaN\", expected a number with a decimal point"),
            ("1,2,inf\n", "line 1, cable 2: found \"inf\", expected a number"),
            ("\"length:left\u{1b}\"\n", "header: found length:left\\u001b, expected"),
        ];
        for (text, expected) in wrong {
            let said = lengths_from_text(text, &robot()).unwrap_err().to_string();
            assert!(said.starts_with(expected), "{said}\nexpected {expected}");
        }
    }
}
