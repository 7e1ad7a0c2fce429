//! Trajectories as CSV: `t,x,y,z,qw,qx,qy,qz,vx,vy,vz,ax,ay,az`, s, m, m/s, m/s², then [columns of cables](crate::cable_columns):
//! `length:` and `speed:` and, if they are known, those of the other quantities. If the platform turns, its angular velocity `wx,wy,wz`, rad/s, and acceleration
//! `alphax,alphay,alphaz`, rad/s², world axes, follow those of its origin. Only t, x, y and z must be present when a file is
//! read. Headers begin with letters and all other cells are numbers, so spreadsheets do not take any cell for a formula.

use std::collections::HashMap;

use cdpr_core::error::{Error, printable};
use cdpr_core::geometry::{Point, Rotation, Vector, rotation_as_written};
use cdpr_core::model::{CommandRows, body};
use cdpr_core::trajectory_check::Recorded;
use cdpr_core::trajectory_file::{BY_CABLE, TrajectoryFile};
use csv::StringRecord;

use crate::cable_columns::{cable_of, columns, csv_text};
use crate::csv_cell::number;

/// Columns other than those of cables.
const PLATFORM: [&str; 14] = ["t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "ax", "ay", "az"];
/// Columns of a platform that turns.
const TURNING: [&str; 6] = ["wx", "wy", "wz", "alphax", "alphay", "alphaz"];
/// Columns that are present together or not at all; the first one must be present.
const TOGETHER: [&[&str]; 6] = [
    &["t", "x", "y", "z"],
    &["qw", "qx", "qy", "qz"],
    &["vx", "vy", "vz"],
    &["ax", "ay", "az"],
    &["wx", "wy", "wz"],
    &["alphax", "alphay", "alphaz"],
];
/// Largest difference of the components of unit quaternions that are the same orientation.
const SAME_ORIENTATION: f64 = 1e-6;

/// A trajectory as CSV text.
pub fn table(file: &TrajectoryFile) -> String {
    let rows_by_cable = file.by_cable();
    let named = BY_CABLE.iter().zip(&rows_by_cable).filter(|(_, rows)| rows.is_some());
    let names = named.flat_map(|(quantity, _)| columns(quantity, &file.cables));
    let turning = if file.orientations.is_some() { &TURNING[..] } else { &[] };
    let header: Vec<String> = PLATFORM.iter().chain(turning).map(ToString::to_string).chain(names).collect();
    let turns = [&file.angular_velocities, &file.angular_accelerations];
    let record = |k: usize| {
        let orientation = file.orientations.as_ref().map_or(&file.orientation, |orientations| &orientations[k]);
        let mut platform = [&file.positions[k][..], orientation, &file.velocities[k], &file.accelerations[k]].concat();
        turns.into_iter().flatten().for_each(|rows| platform.extend(rows[k]));
        let cables = rows_by_cable.iter().flatten().flat_map(|rows| rows[k].iter().copied());
        [file.times[k]].into_iter().chain(platform).chain(cables).map(|x| (x + 0.0).to_string()).collect::<Vec<_>>() // no -0
    };
    csv_text(header, (0..file.times.len()).map(record))
}

/// The contents of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// The samples; cables in the order of `cables`.
    pub motion: Recorded,
    /// The orientation of all rows, if it is given and the same.
    pub orientation: Option<[f64; 4]>,
    /// Names of the cables that have columns.
    pub cables: Vec<String>,
}

/// Whether this is CSV with times and positions.
pub fn is_table(text: &str) -> bool {
    let header = text.lines().next().unwrap_or_default();
    let names: Vec<&str> = header.split(',').map(|name| name.trim().trim_matches('"')).collect();
    TOGETHER[0].iter().all(|name| names.contains(name))
}

/// Reads a table.
///
/// # Errors
/// Names the line and the column, what was found and what was expected.
pub fn read_table(text: &str) -> Result<Table, Error> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(text.as_bytes());
    let columns = Columns::of(reader.headers().map_err(csv_problem)?)?;
    let mut rows = Vec::new();
    for row in reader.records() {
        let row = row.map_err(csv_problem)?;
        let line = row.position().map_or(0, csv::Position::line);
        let numbers = columns.numbers(&row, line)?;
        rows.push((line, numbers));
    }
    columns.table(&rows)
}

/// A row of numbers and its line.
type Row = (u64, Vec<f64>);

/// The columns of a table.
struct Columns {
    names: Vec<String>,
    /// The index of each column.
    index: HashMap<String, usize>,
    /// Names of the cables that have columns.
    cables: Vec<String>,
}

impl Columns {
    fn of(header: &StringRecord) -> Result<Self, Error> {
        let names: Vec<String> = header.iter().map(str::to_string).collect();
        let mut index = HashMap::new();
        let problem = |problem: String| Err(Error::invalid("header", problem));
        let known = [&PLATFORM[..], &TURNING].concat();
        for (k, name) in names.iter().enumerate() {
            if !known.contains(&name.as_str()) && cable_of(name, &BY_CABLE).is_none() {
                let expected = format!("expected {}, or {}: and a cable", known.join(", "), BY_CABLE.join(":, "));
                return problem(format!("found the column \"{}\", {expected}", printable(name)));
            }
            if index.insert(name.clone(), k).is_some() {
                return problem(format!("found the column \"{}\" twice, expected it once", printable(name)));
            }
        }
        for (k, group) in TOGETHER.into_iter().enumerate() {
            let missing: Vec<&str> = group.iter().copied().filter(|name| !index.contains_key(*name)).collect();
            if !missing.is_empty() && (k == 0 || missing.len() < group.len()) {
                return problem(format!(
                    "found no column {}, expected {} together",
                    missing.join(", "),
                    group.join(", ")
                ));
            }
        }
        let mut cables: Vec<String> = Vec::new();
        for cable in names.iter().filter_map(|name| cable_of(name, &BY_CABLE)) {
            if !cables.iter().any(|known| known == cable) {
                cables.push(cable.to_string());
            }
        }
        let columns = Columns { names, index, cables };
        for what in BY_CABLE {
            let has = |cable: &&String| columns.index.contains_key(&format!("{what}:{cable}"));
            let (with, without): (Vec<&String>, Vec<&String>) = columns.cables.iter().partition(has);
            if let (Some(with), Some(without)) = (with.first(), without.first()) {
                let [with, without] = [with, without].map(|name| printable(name));
                return problem(format!("found {what}:{with} but not {what}:{without}, expected all cables or none"));
            }
        }
        Ok(columns)
    }

    fn numbers(&self, row: &StringRecord, line: u64) -> Result<Vec<f64>, Error> {
        if row.len() != self.names.len() {
            let (found, expected) = (row.len(), self.names.len());
            return Err(Error::invalid(format!("line {line}"), format!("found {found} values, expected {expected}")));
        }
        row.iter().zip(&self.names).map(|(text, name)| number(text, || at(line, name))).collect()
    }

    /// The numbers of some columns, if they are present.
    fn group<const N: usize>(&self, names: [&str; N], rows: &[Row]) -> Option<Vec<[f64; N]>> {
        let mut indices = [0; N];
        for (index, name) in indices.iter_mut().zip(names) {
            *index = *self.index.get(name)?;
        }
        Some(rows.iter().map(|(_, row)| indices.map(|index| row[index])).collect())
    }

    /// The numbers of all cables, if they are present.
    fn by_cable(&self, what: &str, rows: &[Row]) -> Option<Vec<Vec<f64>>> {
        let index = |cable: &String| self.index.get(&format!("{what}:{cable}")).copied();
        let indices: Vec<usize> = self.cables.iter().map(index).collect::<Option<_>>()?;
        let values = |(_, row): &Row| indices.iter().map(|&index| row[index]).collect();
        (!indices.is_empty()).then(|| rows.iter().map(values).collect())
    }

    fn table(&self, rows: &[Row]) -> Result<Table, Error> {
        if rows.len() < 2 {
            let found = if rows.is_empty() { "no samples" } else { "1 sample" };
            return Err(Error::invalid("", format!("found {found}, expected at least two")));
        }
        let times: Vec<f64> = self.group(["t"], rows).into_iter().flatten().map(|[t]| t).collect();
        if let Some(k) = (1..times.len()).find(|&k| times[k] <= times[k - 1]) {
            let problem = format!("found {} s after {} s, expected times that increase", times[k], times[k - 1]);
            return Err(Error::invalid(at(rows[k].0, "t"), problem));
        }
        let position = |((line, _), point): (&Row, [f64; 3])| body::point(&format!("line {line}"), point);
        let points = self.group(["x", "y", "z"], rows).unwrap_or_default();
        let positions: Vec<Point> = rows.iter().zip(points).map(position).collect::<Result<_, _>>()?;
        let vectors = |names| Some(self.group(names, rows)?.into_iter().map(Vector::from).collect());
        let angular_velocities = vectors(TURN_RATES[0]);
        let angular_accelerations = vectors(TURN_RATES[1]);
        let given = angular_velocities.is_some() || angular_accelerations.is_some();
        let orientation = self.orientation(rows, given)?;
        let orientations = match &orientation {
            Orientation::Each(orientations) => Some(orientations.clone()),
            Orientation::None | Orientation::One(_) => None,
        };
        let motion = Recorded {
            times,
            positions,
            orientations,
            velocities: vectors(["vx", "vy", "vz"]),
            accelerations: vectors(["ax", "ay", "az"]),
            cable_lengths: self.by_cable("length", rows),
            cable_speeds: self.by_cable("speed", rows),
            cable_accelerations: self.by_cable("acceleration", rows),
            tensions: self.by_cable("tension", rows),
            tension_distribution: None,
            winches: CommandRows {
                commands: self.by_cable("command", rows),
                angles: self.by_cable("angle", rows),
                torques: self.by_cable("torque", rows),
            },
            path: None,
            exact: None,
            angular_velocities,
            angular_accelerations,
        };
        let one = if let Orientation::One(quaternion) = orientation { Some(quaternion) } else { None };
        Ok(Table { motion, orientation: one, cables: self.cables.clone() })
    }

    /// The orientations; a quaternion and its negative are the same. If they hardly differ, they count as a single one, unless
    /// angular rates are given.
    fn orientation(&self, rows: &[Row], rates: bool) -> Result<Orientation, Error> {
        let Some(turns) = self.group(["qw", "qx", "qy", "qz"], rows) else {
            let problem = "found columns of angular rates but none of an orientation, expected qw, qx, qy, qz as well";
            return if rates { Err(Error::invalid("header", problem)) } else { Ok(Orientation::None) };
        };
        let far =
            |a: &[f64; 4], sign: f64| a.iter().zip(&turns[0]).any(|(a, b)| !((a - sign * b).abs() <= SAME_ORIENTATION));
        if !rates && !turns.iter().any(|turn| far(turn, 1.0) && far(turn, -1.0)) {
            return Ok(Orientation::One(turns[0]));
        }
        let rotation = |((line, _), turn): (&Row, &[f64; 4])| {
            body::unit_quaternion(&format!("line {line}, columns qw to qz"), *turn)?;
            Ok(rotation_as_written(*turn))
        };
        rows.iter().zip(&turns).map(rotation).collect::<Result<_, _>>().map(Orientation::Each)
    }
}

/// The columns of angular velocity and acceleration.
const TURN_RATES: [[&str; 3]; 2] = [["wx", "wy", "wz"], ["alphax", "alphay", "alphaz"]];

/// The orientations of a table.
enum Orientation {
    None,
    /// One orientation in all rows.
    One([f64; 4]),
    /// Orientations that differ between rows.
    Each(Vec<Rotation>),
}

fn at(line: u64, column: &str) -> String {
    format!("line {line}, column {}", printable(column))
}

fn csv_problem(error: csv::Error) -> Error {
    let line = error.position().map_or(String::new(), |p| format!("line {}", p.line()));
    Error::invalid(line, error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::testing::{hard1, moving};

    fn upward() -> TrajectoryFile {
        moving(&hard1(), Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 4)
    }

    #[test]
    fn a_table_is_read_as_it_was_written() {
        let mut file = upward();
        file.cables[2] = "a, \"b\"\n=1".to_string();
        file.times[1] += 1e-17 + f64::EPSILON;
        for known in [None, Some(vec![vec![0.1 + 0.2; 8]; 5])] {
            let other = |by: f64| {
                known.as_ref().map(|rows| rows.iter().map(|row| row.iter().map(|x| x + by).collect()).collect())
            };
            file.cable_accelerations = other(0.5);
            (file.commands, file.angles, file.torques) = (other(1.0), other(2.0), other(-3.0));
            file.tensions = known;
            let text = table(&file);
            assert!(text.starts_with("t,x,y,z,qw,qx,qy,qz,vx,vy,vz,ax,ay,az,length:cable 0,") && is_table(&text));
            let Table { motion, orientation, cables } = read_table(&text).unwrap();
            assert_eq!(motion, Recorded { path: None, ..Recorded::of(&file).unwrap() });
            assert_eq!((orientation, &cables), (Some(file.orientation), &file.cables));
        }
    }

    #[test]
    fn columns_may_be_few_and_in_any_order() {
        let found = read_table("z, y ,t,x\n3,2,0,1\n3.5,2,0.1,1\n").unwrap();
        assert_eq!((found.motion.positions[1], found.motion.times[1]), (Point::new(1.0, 2.0, 3.5), 0.1));
        assert_eq!((found.orientation, found.cables.len(), found.motion.velocities), (None, 0, None));
        let flipped = "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,0,1,0,0\n1,0,0,0,0,-1,0,0\n";
        assert_eq!(read_table(flipped).unwrap().orientation, Some([0.0, 1.0, 0.0, 0.0]));
        assert!(!is_table("x,y,z\n1,2,3\n") && !is_table("") && is_table("\"t\",x,y,z"));
    }

    #[test]
    fn errors_name_line_and_column() {
        let wrong = [
            ("t,x,y\n0,0,0\n", "header: found no column z, expected t, x, y, z together"),
            ("t;x;y;z\n0;0;0;0\n", "header: found the column \"t;x;y;z\", expected t, x, y, z,"),
            ("t,x,y,z,t\n", "header: found the column \"t\" twice, expected it once"),
            ("t,x,y,z,vx\n", "header: found no column vy, vz, expected vx, vy, vz together"),
            ("t,x,y,z,roll\n", "header: found the column \"roll\", expected t, x,"),
            ("t,x,y,z,length:\n", "header: found the column \"length:\", expected"),
            ("t,x,y,z,torques:a\n", "header: found the column \"torques:a\", expected t, x,"),
            ("t,x,y,z,angle:a,torque:b\n", "header: found angle:a but not angle:b, expected all cables or none"),
            (
                "t,x,y,z,length:a,length:b,speed:b\n",
                "header: found speed:b but not speed:a, expected all cables or none",
            ),
            ("t,x,y,z\n", "found no samples, expected at least two"),
            ("t,x,y,z\n0,0,0,0\n", "found 1 sample, expected at least two"),
            ("t,x,y,z\n0,0,0,0\n1,0,0\n", "line 3: found 3 values, expected 4"),
            ("t,x,y,z\n0,0,0,0\n1,nan,0,0\n", "line 3, column x: found \"nan\", expected a number"),
            ("t,x,y,z\n0,0,0,inf\n1,0,0,0\n", "line 2, column z: found \"inf\", expected a number"),
            ("t,x,y,z\n0,0,,0\n1,0,0,0\n", "line 2, column y: found \"\", expected a number"),
            ("t,x,y,z\n0,0,1e9,0\n1,0,0,0\n", "line 2: found 1000000000 m, expected coordinates up to 1e6 m"),
            (
                "t,x,y,z\n0,0,0,0\n2,0,0,0\n1,0,0,0\n",
                "line 4, column t: found 1 s after 2 s, expected times that increase",
            ),
            ("t,x,y,z\n0,0,0,0\n0,0,0,0\n", "line 3, column t: found 0 s after 0 s, expected times that increase"),
            (
                "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,0,2,0,0\n",
                "line 3, columns qw to qz: found a quaternion of length 2, expected length 1",
            ),
            ("t,x,y,z,wx,wy,wz\n0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n", "header: found columns of angular rates but none of"),
            ("t,x,y,z,wx\n", "header: found no column wy, wz, expected wx, wy, wz together"),
        ];
        for (text, expected) in wrong {
            let said = read_table(text).unwrap_err().to_string();
            assert!(said.starts_with(expected), "{said}\nexpected {expected}");
        }
    }
}
