//! `cdpr trajectory`

use std::path::Path;

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::Pose;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::trajectory::{Largest, Limit, Minimise, NearestInTime, TimedPlan, Trajectory};
use cdpr_core::trajectory_file::{CornerKind, TrajectoryCorner, TrajectoryFile};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::words::length;
use cdpr_core::{Error, Scene};
use cdpr_files::{MessageFields, trajectory_json};
use serde_json::{Value, json};

use crate::Answer;
use crate::args::{Format, TrajectoryArgs};
use crate::input;
use crate::output::{Console, Verdict, count, is_stream, scene_line, short, thousandths};
use crate::progress::with_progress;
use crate::target::check_message;

/// Writes a trajectory in the format given by the extension; JSON to standard output, pipes and devices.
pub fn save_trajectory(path: &Path, file: &TrajectoryFile, fields: MessageFields, out: &Console) -> Result<(), Error> {
    if is_stream(path) {
        return out.write(path, trajectory_json(file).as_bytes(), "");
    }
    out.save(path, "", || cdpr_files::save_trajectory(path, file, fields))
}

pub fn run(args: &TrajectoryArgs, out: &Console) -> Result<Answer, Error> {
    let fields = args.timing.fields();
    check_message(args.output.as_deref(), fields)?;
    let out = &out.beside(args.output.as_deref());
    let scene = args.tensions.in_scene(input::scene(&args.scene, out)?);
    let (scene, loaded) = input::path(&scene, &args.scene, &args.path, args.strict, &|warning| out.warning(warning))?;
    let path = loaded.path(&scene);
    let limits = args.timing.limits.spec();
    limits.in_scene(&scene).map_err(|e| named(e, args))?;
    let timed = |stop: &Interrupt| {
        Timed::along(&scene, (&path, loaded.kept(&scene)), &limits, args.timing.rate, &Watch::on(stop))
    };
    let timed = with_progress(out, "timing", timed).map_err(|e| named(e, args))?;
    timed.fits(args.output.as_deref(), fields)?;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", timed.json())),
        Format::Text => {
            out.result(&scene_line(&scene));
            timed.print(out);
        }
    }
    if let Some(output) = &args.output {
        save_trajectory(output, &timed.file, fields, out)?;
    }
    Ok(Answer::Yes)
}

/// The error with the file that it concerns: the path, or the scene with its limits; the rate is in neither.
fn named(error: Error, args: &TrajectoryArgs) -> Error {
    match error.place() {
        Some("rate") => args.given.named(error).0,
        Some(place) if place.starts_with("waypoints") => error.in_file(&args.path),
        _ => args.given.blamed(hinted(error), &args.scene.scene),
    }
}

/// The error with a hint about a missing limit.
pub fn hinted(error: Error) -> Error {
    let Some(key @ ("acceleration" | "turn_acceleration")) = error.place() else { return error };
    let hint = format!("pass --{} or set it in [motion]", key.replace('_', "-"));
    error.with_hints(&[hint])
}

/// A planned trajectory and its summary.
pub struct Timed {
    /// The trajectory.
    pub file: TrajectoryFile,
    /// Why tensions are not limited, if they are not.
    note: Option<String>,
    /// The assumption about the platform's inertia, if it matters.
    assumption: Option<String>,
    /// The note that speeds are not limited, if they are not.
    speeds: Option<&'static str>,
    /// How the path was chosen, if several were tried.
    choice: Option<Choice>,
}

/// How a path was chosen for the shortest time.
struct Choice {
    seed: u64,
    seed_of_shortest: u64,
    room: f64,
    tried: usize,
    duration_of_shortest: Option<f64>,
}

impl Timed {
    /// The fastest motion along a path that keeps the clearance `kept` from obstacles, m, if that is more than the scene's.
    fn along(
        scene: &Scene,
        (path, kept): (&[Pose], Option<f64>),
        limits: &MotionSpec,
        rate: Option<f64>,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let compiled = CompiledScene::new(scene, Engine::default(), Interference::default(), watch)?;
        Self::of(&compiled, path, &Trajectory::keeping(&compiled, kept, path, limits, watch)?, rate, watch)
    }

    fn of(
        compiled: &CompiledScene,
        path: &[Pose],
        trajectory: &Trajectory,
        rate: Option<f64>,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let file = TrajectoryFile::of(compiled, path, trajectory, rate, watch)?;
        let winches = trajectory.winches();
        let assumption = winches.assumption().filter(|_| file.orientations.is_some()).map(str::to_string);
        let speeds = trajectory.limits().note();
        Ok(Timed { file, note: winches.note().map(str::to_string), assumption, speeds, choice: None })
    }

    /// The trajectory of a planned path.
    pub fn planned(
        compiled: &CompiledScene,
        plan: &TimedPlan,
        minimise: Minimise,
        rate: Option<f64>,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let timed = Self::of(compiled, &plan.result.path, &plan.trajectory, rate, watch)?;
        let TimedPlan { first_seed: seed_of_shortest, room, tried, duration_of_first: duration_of_shortest, .. } =
            *plan;
        let seed = plan.options.seed;
        let choice = (minimise == Minimise::Time).then_some(Choice {
            seed,
            seed_of_shortest,
            room,
            tried,
            duration_of_shortest,
        });
        Ok(Timed { choice, ..timed })
    }

    /// Checks that the file can hold the fields of a message that are requested, before anything is printed.
    pub fn fits(&self, output: Option<&Path>, fields: MessageFields) -> Result<(), Error> {
        output.filter(|_| fields.requested().is_some()).map_or(Ok(()), |output| fields.check(output, &self.file))
    }

    /// Prints the summary.
    pub fn print(&self, out: &Console) {
        let TrajectoryFile { duration, length, times, .. } = &self.file;
        let rest = format!(" {} s along {} m, {}", short(*duration), short(*length), count(times.len(), "sample"));
        out.verdict(&Verdict::yes("timed:", rest));
        self.choice.iter().for_each(|choice| out.result(&choice.sentence()));
        corner_lines(&self.file.corners, self.file.limits.blend()).iter().for_each(|line| out.result(line));
        limited_by(&self.shares()).iter().for_each(|line| out.result(line));
        let TrajectoryFile { largest, nearest, .. } = &self.file;
        largest.iter().flat_map(largest_lines).for_each(|line| out.result(&line));
        nearest.iter().for_each(|nearest| out.result(&nearest_line(nearest)));
        self.note.iter().chain(&self.assumption).for_each(|note| out.note(note));
        self.speeds.iter().for_each(|note| out.note(note));
    }

    /// The summary as JSON.
    pub fn json(&self) -> Value {
        let TrajectoryFile { duration, length, rate, times, limits, corners, largest, nearest, .. } = &self.file;
        let shares = self.shares().into_iter().map(|(kind, share)| (kind.key().to_string(), json!(share)));
        let mut json = json!({
            "duration": duration,
            "length": length,
            "rate": rate,
            "samples": times.len(),
            "limits": limits,
            "corners": corners,
            "limiting": shares.collect::<serde_json::Map<_, _>>(),
            "largest": largest,
            "nearest": nearest,
            "tensions_limited": self.note.is_none(),
            "note": self.note,
        });
        if let Some(note) = self.speeds {
            json["speed_note"] = json!(note);
        }
        if let Some(assumption) = &self.assumption {
            json["assumption"] = json!(assumption);
        }
        if let Some(Choice { seed, room, tried, duration_of_shortest, .. }) = &self.choice {
            json["choice"] = json!({
                "seed": seed, "room": room, "tried": tried, "duration_of_shortest": duration_of_shortest,
            });
        }
        json
    }

    /// For each limit that determines the motion at some time, its share of the duration; largest first.
    fn shares(&self) -> Vec<(Limit, f64)> {
        let mut shares: Vec<(Limit, f64)> = Vec::new();
        for entry in &self.file.limiting {
            let share = (entry.to - entry.from) / self.file.duration;
            match shares.iter_mut().find(|(kind, _)| *kind == entry.limit) {
                Some((_, sum)) => *sum += share,
                None => shares.push((entry.limit, share)),
            }
        }
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        shares
    }
}

/// The largest rates of a motion and its range of tensions, in words.
pub fn largest_lines(largest: &Largest) -> Vec<String> {
    let rates = format!(
        "at most {} m/s and {} m/s², cables {} m/s and {} m/s²",
        short(largest.speed),
        short(largest.acceleration),
        short(largest.cable_speed),
        short(largest.cable_acceleration)
    );
    let turns = largest.turn_speed.zip(largest.turn_acceleration).map(|(speed, acceleration)| {
        format!("turns at most by {} rad/s and {} rad/s²", short(speed), short(acceleration))
    });
    let tensions = largest
        .tensions
        .map(|[least, most]| format!("tensions from {} N to {} N", thousandths(least), thousandths(most)));
    [Some(rates), turns, tensions].into_iter().flatten().collect()
}

/// The nearest approach of a motion in words.
pub fn nearest_line(nearest: &NearestInTime) -> String {
    let (gap, culprits) = (length(nearest.value), nearest.culprits.join(" and "));
    format!("nearest approach {gap}: {culprits} at {:.3} s", nearest.time)
}

impl Choice {
    fn sentence(&self) -> String {
        if self.seed_of_shortest == self.seed && self.room == 0.0 {
            return format!("the shortest of {} is the fastest", count(self.tried, "path"));
        }
        let room = match self.room > 0.0 {
            true => format!(" with {} more clearance", length(self.room)),
            false => String::new(),
        };
        let of_shortest = match self.duration_of_shortest {
            Some(duration) => format!("{} s along the shortest one", short(duration)),
            None => "the shortest one cannot be timed".to_string(),
        };
        format!(
            "kept the path of seed {}{room}, the fastest of {}; {of_shortest}",
            self.seed,
            count(self.tried, "path")
        )
    }
}

/// Lines about how corners are passed, one for each way.
fn corner_lines(corners: &[TrajectoryCorner], blend: f64) -> Vec<String> {
    let stop = match blend > 0.0 {
        true => "passed with a stop, since no curve within --blend is proved free there",
        false => "passed with a stop; with --blend they may be rounded",
    };
    let ways = [(CornerKind::Rounded, "rounded"), (CornerKind::Outward, "passed outside"), (CornerKind::Stop, stop)];
    ways.into_iter().filter_map(|(kind, words)| corner_line(corners, kind, words)).collect()
}

/// The line about the limits that determine the motion; nothing if none does for long enough to be named.
fn limited_by(shares: &[(Limit, f64)]) -> Option<String> {
    let words = |(kind, share): &(Limit, f64)| format!("{} {:.0} %", kind.key().replace('_', " "), 100.0 * share);
    let list: Vec<String> = shares.iter().filter(|(_, share)| *share >= LEAST_SHARE).map(words).collect();
    (!list.is_empty()).then(|| format!("limited by: {} of the time", list.join(", ")))
}

/// Limits that determine the motion for less than this share of the time are not printed.
const LEAST_SHARE: f64 = 0.005;

/// Waypoints named in a line.
const MOST_NAMED: usize = 8;

fn corner_line(corners: &[TrajectoryCorner], kind: CornerKind, words: &str) -> Option<String> {
    let found: Vec<&TrajectoryCorner> = corners.iter().filter(|corner| corner.kind == kind).collect();
    let deviation = found.iter().map(|corner| corner.deviation).fold(0.0, f64::max);
    let names: Vec<String> = found.iter().take(MOST_NAMED).map(|corner| corner.waypoint.to_string()).collect();
    let more = if found.len() > MOST_NAMED { " and more" } else { "" };
    let waypoints = if found.len() == 1 { "waypoint" } else { "waypoints" };
    let deviation = match kind {
        CornerKind::Stop => String::new(),
        _ => format!(", up to {} from the path", length(deviation)),
    };
    let line =
        || format!("{} {words}: {waypoints} {}{more}{deviation}", count(found.len(), "corner"), names.join(", "));
    (!found.is_empty()).then(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_that_hardly_ever_determine_the_motion_are_not_named() {
        assert_eq!(limited_by(&[]), None);
        assert_eq!(limited_by(&[(Limit::Jerk, 0.001)]), None);
        let both = limited_by(&[(Limit::Speed, 0.5), (Limit::Jerk, 0.001)]);
        assert_eq!(both.unwrap(), format!("limited by: {} 50 % of the time", Limit::Speed.key()));
    }
}
