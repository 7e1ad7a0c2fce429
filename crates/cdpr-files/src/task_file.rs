//! Task files: JSON that lists the legs of a task and names the files of their paths.

use std::path::{Path, PathBuf};

use super::output::write_atomically;
use super::path_file::save_path;
use super::text::{self, Notation, extension};
use super::trajectory_file::{
    MessageFields, check_trajectory_name, save_trajectory, trajectory_from_text, trajectory_texts,
};
use cdpr_core::error::Error;
use cdpr_core::limits::{MOST_TEXT_BYTES, MOST_TRAJECTORY_BYTES};
use cdpr_core::model::Scene;
use cdpr_core::task::{TASK_FORMAT, Task, TaskFile, TaskNames};
use cdpr_core::trajectory_file::TrajectoryFile;
use serde_json::Value;

/// The name of the file that lists the legs.
const TASK_NAME: &str = "task.json";

/// The name of the path file of a leg, counted from 0.
fn leg_name(k: usize) -> String {
    format!("leg-{}.json", k + 1)
}

/// The name of the trajectory file of a leg, counted from 0.
fn motion_name(k: usize) -> String {
    format!("leg-{}-motion.json", k + 1)
}

/// The name of the page of a leg, counted from 0.
pub fn page_name(k: usize) -> String {
    format!("leg-{}.html", k + 1)
}

/// The file of the motion through all legs: its name, and what a ROS 2 message holds.
#[derive(Debug, Clone, Copy)]
pub struct WholeFile<'a> {
    /// Name of the file in the folder of the task; the extension selects the format.
    pub name: &'a str,
    /// The fields of a message.
    pub fields: MessageFields,
}

impl Default for WholeFile<'_> {
    fn default() -> Self {
        WholeFile { name: "motion.json", fields: MessageFields::default() }
    }
}

impl WholeFile<'_> {
    /// Checks, before any work is done, that the motion can be written under this name.
    ///
    /// # Errors
    /// A name with a folder, the name of another file of the task, or what [`check_trajectory_name`] refuses.
    pub fn check(&self) -> Result<(), Error> {
        let path = Path::new(self.name);
        let alone = path.file_name().is_some_and(|name| name == path.as_os_str());
        if !alone || self.name == TASK_NAME || self.name.starts_with("leg-") {
            let problem = "is not the name of a file of its own in the folder of the task, such as motion.csv";
            return Err(Error::file(path, problem));
        }
        check_trajectory_name(path, self.fields)
    }

    /// Checks that the file can hold the fields of a message that are requested, before anything is printed or written.
    ///
    /// # Errors
    /// Quantities that are not known.
    pub fn fits(&self, task: &Task) -> Result<(), Error> {
        let motion = task.motion.as_ref().and_then(|motion| motion.whole.as_ref());
        let requested = motion.filter(|_| self.fields.requested().is_some());
        requested.map_or(Ok(()), |motion| self.fields.check(Path::new(self.name), &motion.file))
    }
}

/// A planned task as a file.
pub fn task_file(scene: &Scene, task: &Task, whole: WholeFile) -> TaskFile {
    TaskFile::of(scene, task, &TaskNames { path: leg_name, motion: motion_name, whole: whole.name })
}

/// Writes a planned task into a folder, which is made if it does not exist: a path file for each leg, a trajectory file for each that
/// was timed, the motion through all of them, and task.json. Files of a task that was there before are removed: its motions must not be
/// taken for those of this one. Returns the names of all files written.
///
/// # Errors
/// A folder or file that cannot be written; fields of a message that are not known, before anything is written.
pub fn save_task(
    folder: impl AsRef<Path>,
    scene: &Scene,
    task: &Task,
    whole: WholeFile,
) -> Result<Vec<PathBuf>, Error> {
    let folder = folder.as_ref();
    let motion = task.motion.as_ref();
    let of_all = motion.and_then(|motion| motion.whole.as_ref());
    whole.fits(task)?;
    std::fs::create_dir_all(folder).map_err(|e| Error::system(folder, "cannot be created", e))?;
    remove_earlier_task(folder)?;
    let mut written = Vec::new();
    for (k, plan) in task.plans.iter().enumerate() {
        let path = folder.join(leg_name(k));
        save_path(&path, &plan.file)?;
        written.push(path);
    }
    for (k, file) in motion.iter().flat_map(|motion| motion.legs.iter().enumerate()) {
        if let Ok(file) = file {
            let path = folder.join(motion_name(k));
            save_trajectory(&path, file, MessageFields::default())?;
            written.push(path);
        }
    }
    if let Some(motion) = of_all {
        let path = folder.join(whole.name);
        save_trajectory(&path, &motion.file, whole.fields)?;
        written.push(path);
    }
    let path = folder.join(TASK_NAME);
    let text = serde_json::to_string_pretty(&task_file(scene, task, whole)).expect("its numbers are finite");
    write_atomically(&path, format!("{text}\n").as_bytes())?;
    written.push(path);
    Ok(written)
}

/// Removes the files that the task.json of a folder names, and the pages of its legs.
///
/// # Errors
/// A file that cannot be removed.
pub fn remove_earlier_task(folder: impl AsRef<Path>) -> Result<(), Error> {
    let folder = folder.as_ref();
    let Ok(Some(earlier)) = load_if_task(folder.join(TASK_NAME)) else { return Ok(()) };
    let legs = earlier.legs.iter().enumerate();
    let of_legs = legs.flat_map(|(k, leg)| {
        let motion = leg.motion.as_ref().and_then(|motion| motion.file.clone());
        [Some(leg_name(k)), motion.filter(|name| *name == motion_name(k)), Some(page_name(k))]
    });
    let whole = earlier.motion.as_ref().map(|motion| motion.file.clone());
    let whole = whole.filter(|name| WholeFile { name, ..WholeFile::default() }.check().is_ok());
    for name in of_legs.chain([whole]).flatten() {
        let path = folder.join(name);
        match std::fs::remove_file(&path) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                return Err(Error::system(&path, "cannot be removed", error));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Checks that the file of the motion through all legs says what their motions say: samples and facts in JSON, each line of a table or of
/// a message.
///
/// # Errors
/// A file that cannot be read, or where it differs.
pub fn check_whole(path: impl AsRef<Path>, expected: &TrajectoryFile) -> Result<(), Error> {
    let path = path.as_ref();
    let text = text::read_at_most(path, MOST_TRAJECTORY_BYTES)?;
    let differs = |place: String, found: &str, expected: &str| {
        let problem = format!("found {found}, expected {expected}: the motions of the legs one after another");
        Err(Error::invalid(place, problem).in_file(path))
    };
    if extension(path).as_deref() == Some("json") {
        let found = trajectory_from_text(&text).map_err(|e| e.in_file(path))?;
        let [found, expected] = [&found, expected].map(|file| serde_json::json!(file));
        let Some((key, expected)) = first_difference(&found, &expected) else { return Ok(()) };
        return differs(key, "something else", &expected);
    }
    let texts = trajectory_texts(path, expected)?;
    if texts.contains(&text) {
        return Ok(());
    }
    // The text that agrees for longest shows where it differs.
    let agreed = |expected: &String| text.lines().zip(expected.lines()).take_while(|(a, b)| a == b).count();
    let nearest = texts.iter().max_by_key(|expected| agreed(expected)).expect("there is a text for each format");
    let line = agreed(nearest);
    let [found, expected] =
        [&text, nearest].map(|text| text.lines().nth(line).map_or("no more lines".into(), shortened));
    differs(format!("line {}", line + 1), &found, &expected)
}

/// The beginning of a line, in quotes.
fn shortened(line: &str) -> String {
    let start: String = line.chars().take(60).collect();
    let more = if start.len() < line.len() { "..." } else { "" };
    format!("\"{start}{more}\"")
}

/// The first place where two JSON texts differ, and what is expected there.
fn first_difference(found: &Value, expected: &Value) -> Option<(String, String)> {
    let under = |key: &str, (place, expected): (String, String)| match place.starts_with('[') || place.is_empty() {
        true => (format!("{key}{place}"), expected),
        false => (format!("{key}.{place}"), expected),
    };
    match (found, expected) {
        (Value::Object(found), Value::Object(known)) => {
            let other = found.keys().find(|key| !known.contains_key(*key)).map(|key| (key.clone(), "none".to_string()));
            let null = Value::Null;
            let of = |key: &String| found.get(key).unwrap_or(&null);
            known.iter().find_map(|(key, value)| Some(under(key, first_difference(of(key), value)?))).or(other)
        }
        (Value::Array(found), Value::Array(known)) if found.len() == known.len() => {
            let pairs = found.iter().zip(known).enumerate();
            pairs.into_iter().find_map(|(k, (a, b))| Some(under(&format!("[{k}]"), first_difference(a, b)?)))
        }
        (Value::Array(_), Value::Array(known)) => Some((String::new(), format!("{} entries", known.len()))),
        _ => (found != expected).then(|| (String::new(), expected.to_string())),
    }
}

/// Whether a text is JSON that says it is a task.
pub fn is_task(text: &str) -> bool {
    text::is_of_format(text, &[TASK_FORMAT])
}

/// Parses a task; [`TaskFile::legs`] checks it against its scene.
///
/// # Errors
/// Names the key, what was found and what was expected.
pub fn task_from_text(text: &str) -> Result<TaskFile, Error> {
    text::parse(text, Notation::Json)
}

/// Loads a task, if the file is one: a .json file that says so.
///
/// # Errors
/// Names the file, the key, what was found and what was expected.
pub fn load_if_task(path: impl AsRef<Path>) -> Result<Option<TaskFile>, Error> {
    let path = path.as_ref();
    let short = std::fs::metadata(path).is_ok_and(|found| found.is_file() && found.len() <= MOST_TEXT_BYTES);
    if !short || extension(path).as_deref() != Some("json") {
        return Ok(None);
    }
    let text = text::read(path)?;
    if is_task(&text) { task_from_text(&text).map(Some).map_err(|e| e.in_file(path)) } else { Ok(None) }
}
