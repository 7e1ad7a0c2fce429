//! Cable lengths as CSV, m: with a header of `length:` and the name of each cable, in any order and among other columns, as in a
//! trajectory; or without one, a number for each cable in the order of the robot.

use std::path::Path;

use cdpr_core::error::{Error, printable};
use cdpr_core::model::Robot;
use csv::StringRecord;

use super::csv_cell::number;
use super::text;

/// Beginning of the name of a column of lengths.
const LENGTH: &str = "length:";

/// Rows of cable lengths.
#[derive(Debug, Clone, PartialEq)]
pub struct CableLengths {
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
/// Columns that are missing, unknown or there twice; no rows; a row with another number of values; what is not a number. Whether
/// numbers can be lengths is not checked here.
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
    let mut found = CableLengths { rows: Vec::new(), lines: Vec::new() };
    let mut columns: Option<Columns> = None;
    for record in reader.records() {
        let record = record.map_err(|e| {
            Error::invalid(e.position().map_or(String::new(), |p| format!("line {}", p.line())), e.to_string())
        })?;
        let line = record.position().map_or(0, |place| line_of(place, text));
        match &columns {
            None if record.iter().any(|cell| cell.starts_with(LENGTH)) => {
                columns = Some(Columns::named(&record, robot)?);
                continue;
            }
            None => columns = Some(Columns::in_order(robot)),
            Some(_) => {}
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

/// Where the lengths are.
struct Columns {
    /// Number of columns.
    count: usize,
    /// The column of each cable.
    of_cables: Vec<usize>,
}

impl Columns {
    fn in_order(robot: &Robot) -> Self {
        let count = robot.cables().len();
        Columns { count, of_cables: (0..count).collect() }
    }

    fn named(header: &StringRecord, robot: &Robot) -> Result<Self, Error> {
        let names = robot.cable_names();
        let problem = |problem: String| Error::invalid("header", problem);
        let lengths: Vec<(usize, &str)> =
            header.iter().enumerate().filter_map(|(k, cell)| Some((k, cell.strip_prefix(LENGTH)?))).collect();
        if let Some((_, other)) = lengths.iter().find(|(_, name)| !names.contains(name)) {
            let expected = names.iter().map(|name| printable(name)).collect::<Vec<_>>().join(", ");
            return Err(problem(format!("found {LENGTH}{}, expected the cables {expected}", printable(other))));
        }
        let column = |name: &&str| {
            let mut at = lengths.iter().filter(|(_, found)| found == name).map(|(k, _)| *k);
            match (at.next(), at.next()) {
                (Some(column), None) => Ok(column),
                (None, _) => Err(problem(format!("found no column {LENGTH}{}, expected every cable", printable(name)))),
                (Some(_), Some(_)) => {
                    Err(problem(format!("found the column {LENGTH}{} twice, expected it once", printable(name))))
                }
            }
        };
        let of_cables = names.iter().map(column).collect::<Result<_, _>>()?;
        Ok(Columns { count: header.len(), of_cables })
    }

    fn lengths(&self, record: &StringRecord, robot: &Robot, line: u64) -> Result<Vec<f64>, Error> {
        if record.len() != self.count {
            let problem = format!("found {} values, expected {}", record.len(), self.count);
            return Err(Error::invalid(format!("line {line}"), problem));
        }
        let place = |cable: &str| format!("line {line}, {}", printable(cable));
        let cells = robot.cables().iter().zip(&self.of_cables);
        cells.map(|(cable, column)| number(&record[*column], || place(&cable.name))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let expected = CableLengths { rows: vec![vec![1.0, 2.0, 3.0], vec![1.5, 2.5, 3.5]], lines: vec![2, 3] };
        assert_eq!(lengths_from_text(text, &robot()).unwrap(), expected);
        let plain = "1, 2,3\n\n1.5,2.5,3.5";
        assert_eq!(lengths_from_text(plain, &robot()).unwrap(), CableLengths { lines: vec![1, 3], ..expected });
    }

    #[test]
    fn numbers_are_read_as_written_and_judged_later() {
        assert_eq!(lengths_from_text("1e-3,-2,0", &robot()).unwrap().rows, [[1e-3, -2.0, 0.0]]);
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
