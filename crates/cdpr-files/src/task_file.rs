//! Task files: JSON that lists the legs of a task and names the files of their paths.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::output::write_atomically;
use super::path_file::save_path;
use super::text::{self, Notation, extension};
use cdpr_core::error::Error;
use cdpr_core::limits::MOST_TEXT_BYTES;
use cdpr_core::model::Scene;
use cdpr_core::task::{TASK_FORMAT, Task, TaskFile};

/// The name of the file that lists the legs.
const TASK_NAME: &str = "task.json";

/// The name of the path file of a leg, counted from 0.
fn leg_name(k: usize) -> String {
    format!("leg-{}.json", k + 1)
}

/// A planned task as a file.
pub fn task_file(scene: &Scene, task: &Task) -> TaskFile {
    TaskFile::of(scene, task, leg_name)
}

/// Writes a planned task into a folder, which is made if it does not exist: a path file for each leg, and task.json. Returns the
/// names of all files.
///
/// # Errors
/// A folder or file that cannot be written.
pub fn save_task(folder: impl AsRef<Path>, scene: &Scene, task: &Task) -> Result<Vec<PathBuf>, Error> {
    let folder = folder.as_ref();
    std::fs::create_dir_all(folder).map_err(|e| Error::system(folder, "cannot be created", e))?;
    let mut written = Vec::new();
    for (k, plan) in task.plans.iter().enumerate() {
        let path = folder.join(leg_name(k));
        save_path(&path, &plan.file)?;
        written.push(path);
    }
    let path = folder.join(TASK_NAME);
    let text = serde_json::to_string_pretty(&task_file(scene, task)).expect("its numbers are finite");
    write_atomically(&path, format!("{text}\n").as_bytes())?;
    written.push(path);
    Ok(written)
}

/// Whether a text is JSON that says it is a task.
pub fn is_task(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Head {
        format: String,
    }
    text.contains(TASK_FORMAT) && serde_json::from_str(text).is_ok_and(|Head { format }| format == TASK_FORMAT)
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
