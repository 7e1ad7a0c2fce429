//! What winches are commanded: lengths, angles of their motors, torques; and the lengths of cables from what winches report.

use serde::Serialize;

use super::drum::Drum;
use super::robot::{Cable, Robot};
use crate::choices;
use crate::error::Error;

/// What the joints of winches are. Joints grow while their cable is let out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Joints {
    /// Lengths of the cables from outlet to attachment, m.
    #[default]
    Length,
    /// Commanded lengths, m.
    Command,
    /// Angles of the motors, rad.
    Angle,
}

choices!(Joints, "joints", [
    Length = "length": "lengths of the cables from outlet to attachment, m",
    Command = "command": "unstretched lengths that the winches are commanded, m",
    Angle = "angle": "angles of the motors, rad",
]);

impl Cable {
    /// Length to command to the winch so that the cable, stretched by a tension, N, has this length, m: the unstretched length of
    /// what is beyond the drum, without the lead. A cable that does not stretch has the length itself.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::{Cable, Drum};
    /// let drum = Drum { radius: 0.1, gear: 20.0, zero: 9.0, lead: 3.0 };
    /// let scene = cdpr_core::testing::empty();
    /// let cable = Cable { stiffness: 7e5, drum: Some(drum), ..scene.robot().cables()[0].clone() };
    /// let command = cable.command(10.0, 7000.0); // stretched by 1 %: 13 m are 12.871 m unstretched
    /// assert!((command - (13.0 / 1.01 - 3.0)).abs() < 1e-12);
    /// assert!((drum.angle(command) - 20.0 * (command - 9.0) / 0.1).abs() < 1e-9);
    /// assert!((drum.torque(7000.0) - 35.0).abs() < 1e-12);
    /// ```
    pub fn command(&self, length: f64, tension: f64) -> f64 {
        let (lead, strain) = (self.drum.map_or(0.0, |drum| drum.lead), tension / self.stiffness);
        length - (lead + length) * (strain / (1.0 + strain))
    }

    /// Length of the cable at a commanded length, m, and a tension, N: the inverse of [`Cable::command`].
    pub fn stretched(&self, command: f64, tension: f64) -> f64 {
        let lead = self.drum.map_or(0.0, |drum| drum.lead);
        command + (lead + command) * (tension / self.stiffness)
    }
}

/// What the winches of a robot are commanded, cables in the order of the robot. A list is absent if it is not known.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Commands {
    /// Commanded length of each cable, m, if some stretch and the tensions are known; see [`Cable::command`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub commands: Option<Vec<f64>>,
    /// Angle of each motor at its commanded length, rad, if all cables have drums; see [`Drum::angle`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angles: Option<Vec<f64>>,
    /// Torque of each tension about its motor's axis, N·m, if all cables have drums; see [`Drum::torque`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torques: Option<Vec<f64>>,
}

/// [`Commands`] at several instants: rows by time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CommandRows {
    /// Commanded lengths, m.
    pub commands: Option<Vec<Vec<f64>>>,
    /// Angles of the motors, rad.
    pub angles: Option<Vec<Vec<f64>>>,
    /// Torques about the motors' axes, N·m.
    pub torques: Option<Vec<Vec<f64>>>,
}

impl CommandRows {
    /// These rows, and the other ones where these are not known.
    pub fn or(self, other: CommandRows) -> Self {
        CommandRows {
            commands: self.commands.or(other.commands),
            angles: self.angles.or(other.angles),
            torques: self.torques.or(other.torques),
        }
    }
}

impl Robot {
    /// Lengths of the cables, m, from the joints of the winches and the tensions of the cables, N: the inverse of
    /// [`Robot::commands`]. Cables that do not stretch need no tensions, and lengths themselves are returned as they are.
    ///
    /// # Errors
    /// Commanded lengths or angles without tensions if cables stretch, or with a negative tension; angles of a cable without a
    /// drum. The cable is named.
    pub fn lengths_from(&self, joints: Joints, values: &[f64], tensions: Option<&[f64]>) -> Result<Vec<f64>, Error> {
        let length = |(k, cable): (usize, &Cable)| {
            let problem = |problem: String| Err(Error::invalid(&cable.name, problem));
            let command = match (joints, cable.drum) {
                (Joints::Length, _) => return Ok(values[k]),
                (Joints::Command, _) => values[k],
                (Joints::Angle, Some(drum)) => drum.command(values[k]),
                (Joints::Angle, None) => return problem("found an angle of a cable without a drum".to_string()),
            };
            match tensions.map(|tensions| tensions[k]) {
                _ if cable.stiffness.is_infinite() => Ok(command),
                None => problem("found no tension of a cable that stretches, expected one".to_string()),
                Some(tension) if !(0.0..f64::INFINITY).contains(&tension) => {
                    problem(format!("found a tension of {tension} N, expected a finite number of at least 0"))
                }
                Some(tension) => Ok(cable.stretched(command, tension)),
            }
        };
        self.cables().iter().enumerate().map(length).collect()
    }

    /// What the winches are commanded at these lengths, m, and tensions, N, of the cables. If a cable stretches, angles are known
    /// only with the tensions.
    pub fn commands(&self, lengths: &[f64], tensions: Option<&[f64]>) -> Commands {
        let cables = self.cables();
        let stretches = cables.iter().any(|cable| cable.stiffness.is_finite());
        let drums: Option<Vec<&Drum>> = cables.iter().map(|cable| cable.drum.as_ref()).collect();
        let commanded: Option<Vec<f64>> = match (stretches, tensions) {
            (false, _) => Some(lengths.to_vec()),
            (true, None) => None,
            (true, Some(tensions)) => {
                let pulled = cables.iter().zip(lengths).zip(tensions);
                Some(pulled.map(|((cable, length), tension)| cable.command(*length, *tension)).collect())
            }
        };
        let of_drums = |of: fn(&Drum, f64) -> f64, values: &[f64]| {
            Some(drums.as_ref()?.iter().zip(values).map(|(drum, value)| of(drum, *value)).collect())
        };
        Commands {
            angles: commanded.as_ref().and_then(|commanded| of_drums(Drum::angle, commanded)),
            torques: tensions.and_then(|tensions| of_drums(Drum::torque, tensions)),
            commands: commanded.filter(|_| stretches),
        }
    }

    /// What the winches are commanded at several instants, given the lengths and tensions of the cables then.
    pub fn commands_at_each(&self, lengths: &[Vec<f64>], tensions: Option<&[Vec<f64>]>) -> CommandRows {
        let row = |(k, lengths): (usize, &Vec<f64>)| self.commands(lengths, tensions.map(|rows| &rows[k][..]));
        let rows: Vec<Commands> = lengths.iter().enumerate().map(row).collect();
        let list = |of: fn(&Commands) -> &Option<Vec<f64>>| rows.iter().map(|row| of(row).clone()).collect();
        CommandRows {
            commands: list(|row| &row.commands),
            angles: list(|row| &row.angles),
            torques: list(|row| &row.torques),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::spec::{CableDefaultsSpec, DrumSpec};
    use crate::testing::empty;

    /// The robot of eight cables with these keys of some cables.
    fn robot(stiff: &[usize], drums: &[usize]) -> Robot {
        let mut spec = empty().robot().spec().clone();
        stiff.iter().for_each(|&k| spec.cables[k].stiffness = Some(1e5));
        let drum = DrumSpec { radius: 0.05, gear: Some(-10.0), zero: Some(1.5), lead: Some(2.0) };
        drums.iter().for_each(|&k| spec.cables[k].drum = Some(drum));
        Robot::try_from(spec).unwrap()
    }

    #[test]
    fn commands_are_those_worked_by_hand() {
        let all: Vec<usize> = (0..8).collect();
        let found = robot(&[2], &all).commands(&[3.0; 8], Some(&[250.0; 8]));
        // Cable 2: a strain of 1/400, so 5 m of cable are 5 / 1.0025 m unstretched; a wheel turn of (c − 1.5) / 0.05.
        let (commands, angles) = (found.commands.unwrap(), found.angles.unwrap());
        assert!((commands[2] - 2.987_531_172_069_826_4).abs() < 1e-14 && commands[3] == 3.0, "{commands:?}");
        assert!((angles[2] + 297.506_234_413_965_3).abs() < 1e-10 && (angles[3] + 300.0).abs() < 1e-10, "{angles:?}");
        assert_eq!(found.torques, Some(vec![-1.25; 8]));
    }

    #[test]
    fn lengths_come_back_from_commands_and_angles() {
        let all: Vec<usize> = (0..8).collect();
        let robot = robot(&[2, 5], &all);
        for (length, tension) in [(3.0, 250.0), (0.02, 0.0), (40.0, 4e4)] {
            let tensions = [tension; 8];
            let found = robot.commands(&[length; 8], Some(&tensions));
            for (joints, values) in [(Joints::Command, found.commands), (Joints::Angle, found.angles)] {
                let back = robot.lengths_from(joints, &values.unwrap(), Some(&tensions)).unwrap();
                assert!(back.iter().all(|back| (back - length).abs() < 1e-14 * (length + 10.0)), "{joints:?} {back:?}");
            }
        }
        // Cable 2 with 4 m beyond a lead of 2 m, at a strain of 1/400: 6 m are 15 mm longer.
        let found = robot.lengths_from(Joints::Command, &[4.0; 8], Some(&[250.0; 8])).unwrap();
        assert!((found[2] - 4.015).abs() < 1e-14 && found[3] == 4.0, "{found:?}");
    }

    #[test]
    fn lengths_without_what_they_need_are_refused() {
        let robot = robot(&[2], &[0, 1, 2, 3, 4]);
        let said = |joints, tensions: Option<&[f64]>| match robot.lengths_from(joints, &[3.0; 8], tensions) {
            Ok(lengths) => format!("{lengths:?}"),
            Err(error) => error.to_string(),
        };
        let mut slack = [250.0; 8];
        (slack[2], slack[4]) = (-1.0, -1.0);
        assert_eq!(said(Joints::Length, None), format!("{:?}", [3.0; 8]));
        let expected = "cable 2: found no tension of a cable that stretches, expected one";
        assert_eq!(said(Joints::Command, None), expected);
        assert_eq!(
            said(Joints::Command, Some(&slack)),
            "cable 2: found a tension of -1 N, expected a finite number of at least 0"
        );
        let expected = "cable 5: found an angle of a cable without a drum";
        assert_eq!(said(Joints::Angle, Some(&[250.0; 8])), expected);
    }

    #[test]
    fn wrong_drums_are_refused_with_key_and_number() {
        type Change = fn(&mut DrumSpec);
        let said = |change: Change, common: bool| {
            let mut drum = DrumSpec { radius: 0.05, gear: None, zero: None, lead: None };
            change(&mut drum);
            let mut spec = empty().robot().spec().clone();
            match common {
                true => spec.cable = Some(CableDefaultsSpec { drum: Some(drum), ..CableDefaultsSpec::default() }),
                false => spec.cables[3].drum = Some(drum),
            }
            Robot::try_from(spec).unwrap_err().to_string()
        };
        let wrong: [(Change, &str); 7] = [
            (|drum| drum.radius = 0.0, "radius: found 0 m, expected at least 1e-5 m"),
            (|drum| drum.radius = f64::NAN, "radius: found NaN, expected finite numbers"),
            (|drum| drum.radius = 2e6, "radius: found 2000000 m, expected coordinates up to 1e6 m"),
            (|drum| drum.gear = Some(0.0), "gear: found 0, expected turns of the motor for one of the drum"),
            (|drum| drum.gear = Some(-f64::INFINITY), "gear: found -inf, expected"),
            (|drum| drum.zero = Some(f64::NAN), "zero: found NaN, expected finite numbers"),
            (|drum| drum.lead = Some(-0.1), "lead: found -0.1, expected a finite number of at least 0"),
        ];
        for (change, expected) in wrong {
            let [own, common] = [false, true].map(|common| said(change, common));
            assert!(own.starts_with(&format!("cables[3].drum.{expected}")), "{own}");
            assert!(common.starts_with(&format!("cables[0].drum.{expected}")), "{common}");
        }
    }

    #[test]
    fn lists_are_absent_without_what_they_need() {
        let (all, lengths, pulled): (Vec<usize>, _, _) = ((0..8).collect(), [3.0; 8], [250.0; 8]);
        let known = |robot: Robot, tensions: Option<&[f64]>| {
            let Commands { commands, angles, torques } = robot.commands(&lengths, tensions);
            [commands.is_some(), angles.is_some(), torques.is_some()]
        };
        assert_eq!(known(robot(&[], &[]), Some(&pulled)), [false; 3]);
        assert_eq!(known(robot(&[1], &all[1..]), Some(&pulled)), [true, false, false]);
        assert_eq!(known(robot(&[1], &all), None), [false; 3]);
        assert_eq!(known(robot(&[], &all), None), [false, true, false]);
        assert_eq!(known(robot(&[1], &all), Some(&pulled)), [true; 3]);
        let rows = robot(&[1], &all).commands_at_each(&[vec![3.0; 8], vec![4.0; 8]], None);
        assert_eq!(rows, CommandRows::default());
    }
}
