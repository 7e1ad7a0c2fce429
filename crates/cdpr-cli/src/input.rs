//! Reads scenes, paths and experiments from files, or from standard input if the file name is `-`.

use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::time::Instant;

use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Pose, Rotation, wxyz};
use cdpr_core::plan::Query;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Robot, Scene};
use cdpr_files::text::Notation;
use cdpr_files::{
    CableLengths, LoadedPath, LoadedTrajectory, Loader, PathFormat, begins_at, lengths_from_text, load_if_trajectory,
    loaded_if_trajectory, scene_of_loaded, scene_of_path, waypoints_from_text,
};
use cdpr_study::Experiment;

use crate::args::{CheckerArgs, PathArgs, SceneArgs, Strict, position};
use crate::interruption::interrupted;
use crate::output::{Console, count, is_dash};

/// The name of standard input in messages.
const STANDARD_INPUT: &str = "standard input";
/// Folders of files opened by the shell, for instance those of `<(command)`. A process is writing to them, so reading
/// does not wait forever, as it may for other pipes.
const OPENED_BY_SHELL: [&str; 2] = ["/dev/fd/", "/proc/self/fd/"];

/// A loader that stops on Ctrl-C, since meshes can take seconds.
pub fn loader() -> Loader<'static> {
    Loader::new(Watch::on(&interrupted))
}

/// The scene, at the requested orientation. Paths in a scene from standard input are relative to the working directory.
pub fn scene(args: &SceneArgs, out: &Console) -> Result<Scene, Error> {
    let clock = Instant::now();
    let scene = match stream_of(&args.scene)? {
        Some(stream) => stream.parse(|text| loader().scene_from_text(text, notation(text), Some(Path::new(""))))?,
        None => loader().scene(&args.scene)?,
    };
    let parts = scene.obstacles().iter().map(|obstacle| obstacle.parts.len()).sum();
    let what = format!("{} of {}", count(scene.obstacles().len(), "obstacle"), count(parts, "part"));
    out.detail(&format!("read {} in {:.1} ms: {what}", args.scene.display(), 1e3 * clock.elapsed().as_secs_f64()));
    let Some(orientation) = &args.orientation else { return Ok(scene) };
    scene.named_orientation("--orientation", orientation)?;
    scene.turned(orientation.clone())
}

/// The scene with the start and goal that options give, if they do.
pub fn between(scene: Scene, ends: [(&str, Option<&[String]>); 2]) -> Result<Scene, Error> {
    let given = |(option, words): (&str, Option<&[String]>)| {
        let Some(words) = words else { return Ok(None) };
        let source = position(option, words)?;
        scene.named_position(option, &source)?;
        Ok(Some(source))
    };
    let [start, goal] = ends.map(given);
    let (start, goal) = (start?, goal?);
    let query = scene.spec().query.clone().unwrap_or_default();
    scene.between([start.or(query.start), goal.or(query.goal)])
}

/// The position that `--at` gives, and the scene at the orientation of the station if none was requested.
pub fn at(words: &[String], args: &SceneArgs, scene: Scene) -> Result<(Scene, Point), Error> {
    let (at, orientation) = scene.named_position("--at", &position("--at", words)?)?;
    match orientation {
        Some(turn) if args.orientation.is_none() => Ok((scene.turned(wxyz(&turn).into())?, at)),
        _ => Ok((scene, at)),
    }
}

/// A robot.
pub fn robot(path: &Path) -> Result<Robot, Error> {
    match stream_of(path)? {
        Some(stream) => stream.parse(|text| loader().robot_from_text(text, notation(text), Some(Path::new("")))),
        None => loader().robot(path),
    }
}

/// Rows of cable lengths of a robot.
pub fn lengths(path: &Path, robot: &Robot) -> Result<CableLengths, Error> {
    match stream_of(path)? {
        Some(stream) => stream.parse(|text| lengths_from_text(text, robot)),
        None => cdpr_files::load_lengths(path, robot),
    }
}

/// The name of an input in messages.
pub fn name_of(path: &Path) -> &Path {
    if is_standard_input(path) { Path::new(STANDARD_INPUT) } else { path }
}

/// Refuses a scene that leaves its orientation open.
pub fn selects_orientation(scene: &Scene, args: &SceneArgs) -> Result<(), Error> {
    if !scene.orientation_is_open() {
        return Ok(());
    }
    let problem = "found a scene that selects none, expected one: a proof is for one orientation";
    let hint = "use --orientation NAME".to_string();
    Err(Error::invalid("orientation", problem).with_hints(&[hint]).in_file(&args.scene))
}

/// Refuses a scene whose platform may turn, which proofs that there is no path do not cover.
pub fn never_turns(scene: &Scene, args: &SceneArgs) -> Result<(), Error> {
    if !Query::of(scene).turns() {
        return Ok(());
    }
    let problem = "found a scene whose platform may turn, expected one whose platform keeps its orientation: a proof is for one \
                   orientation";
    Err(Error::invalid("turning", problem).in_file(&args.scene))
}

/// The scene compiled for the motions of a path; errors name the scene file.
pub fn compiled(scene: &Scene, path: &[Pose], args: &SceneArgs, checker: CheckerArgs) -> Result<CompiledScene, Error> {
    let compiled = CompiledScene::new(scene, checker.engine, checker.interference, &Watch::on(&interrupted));
    let ready = compiled.and_then(|compiled| compiled.ready_for(path).map(|()| compiled));
    ready.map_err(|e| in_scene_file(e, &args.scene))
}

/// The error with the name of the scene file, unless it is about the option --interference.
fn in_scene_file(error: Error, file: &Path) -> Error {
    if error.place() == Some("interference") { error.at("--interference") } else { error.in_file(file) }
}

/// A path, and its scene at the path's orientation.
pub fn scene_and_path(args: &PathArgs, out: &Console) -> Result<(Scene, Vec<Pose>), Error> {
    only_one_stream(("scene", &args.scene.scene), ("path", &args.path))?;
    let scene = scene(&args.scene, out)?;
    let (scene, loaded) = path(&scene, &args.scene, &args.path, args.strict, &|warning| out.warning(warning))?;
    let path = loaded.path(&scene);
    Ok((scene, path))
}

/// A path of an earlier scene, and the scene at the path's orientation.
pub fn path_before(scene: &Scene, args: &SceneArgs, file: &Path) -> Result<(Scene, Vec<Pose>), Error> {
    let (scene, loaded) = path(scene, args, file, Strict { strict: false }, &|_| ())?;
    let path = loaded.path(&scene);
    match path.len() {
        0 | 1 => {
            let problem = format!("found {}, expected at least two", count(path.len(), "waypoint"));
            Err(Error::invalid("waypoints", problem).in_file(name_of(file)))
        }
        _ => Ok((scene, path)),
    }
}

/// Refuses two inputs, each given by what it is and the name of its file, that are both standard input.
pub fn only_one_stream((one, path): (&str, &Path), (other, beside): (&str, &Path)) -> Result<(), Error> {
    if is_standard_input(path) && is_standard_input(beside) {
        let problem = format!("found - for both {one} and {other}; only one of them can be standard input");
        return Err(Error::invalid("", problem));
    }
    Ok(())
}

/// A path of a scene, and the scene at the path's orientation; `warn` hears that the path was planned for another scene.
pub fn path(
    scene: &Scene,
    args: &SceneArgs,
    path: &Path,
    strict: Strict,
    warn: &dyn Fn(&str),
) -> Result<(Scene, LoadedPath), Error> {
    only_one_stream(("scene", &args.scene), ("path", path))?;
    match stream_of(path)? {
        Some(stream) => stream.parse(|text| path_from_text((scene, args), text, strict, warn)),
        None => {
            let loaded = cdpr_files::load_waypoints(path)?;
            in_scene((scene, args), loaded, strict, warn).map_err(|e| e.in_file(path))
        }
    }
}

fn path_from_text(
    asked: (&Scene, &SceneArgs),
    text: &str,
    strict: Strict,
    warn: &dyn Fn(&str),
) -> Result<(Scene, LoadedPath), Error> {
    let loaded = waypoints_from_text(text, PathFormat::of_text(text))?;
    in_scene(asked, loaded, strict, warn)
}

/// The orientations of waypoints or samples must begin with the one that is given as an option, if any.
fn begins_as_given(scene: &Scene, args: &SceneArgs, turns: &[Rotation]) -> Result<(), Error> {
    if args.orientation.is_some() { begins_at(scene.orientation(), turns) } else { Ok(()) }
}

fn in_scene(
    (scene, args): (&Scene, &SceneArgs),
    loaded: LoadedPath,
    Strict { strict }: Strict,
    warn: &dyn Fn(&str),
) -> Result<(Scene, LoadedPath), Error> {
    if loaded.orientation().is_none() {
        begins_as_given(scene, args, loaded.orientations.as_deref().unwrap_or_default())?;
    }
    let open = scene.orientation_is_open() && loaded.orientation().is_none() && loaded.orientations.is_none();
    let hint = open.then(|| "use --orientation NAME".to_string());
    let found = scene_of_path(scene, &loaded, strict).map_err(|e: Error| e.with_hints(hint.as_slice()));
    let (scene, warning) = found?;
    warning.iter().for_each(|warning| warn(warning));
    Ok((scene, loaded))
}

/// A path or the samples of a trajectory, with the scene at its orientation; or a proof, with the scene.
pub enum Given {
    /// A path without times.
    Path(Box<(Scene, LoadedPath)>),
    /// A trajectory from any source.
    Trajectory(Box<(Scene, LoadedTrajectory)>),
    /// The text of a proof.
    Proof(Box<(Scene, String)>),
}

/// A path or a trajectory from any source, JSON or CSV, or a proof. Warns if it was made for another scene.
pub fn path_trajectory_or_proof(args: &SceneArgs, file: &Path, strict: Strict, out: &Console) -> Result<Given, Error> {
    only_one_stream(("scene", &args.scene), ("path", file))?;
    let scene = scene(args, out)?;
    if let Some(text) = cdpr_files::text::read_certificate(file)? {
        return Ok(Given::Proof(Box::new((scene, text))));
    }
    let recorded = |loaded: LoadedTrajectory| {
        let turns = loaded.motion.orientations.as_deref().unwrap_or_default();
        if loaded.orientation.is_none() {
            begins_as_given(&scene, args, turns)?;
        }
        let open = scene.orientation_is_open() && loaded.orientation.is_none() && turns.is_empty();
        let hint = open.then(|| "use --orientation NAME".to_string());
        let found = scene_of_loaded(&scene, &loaded, strict.strict);
        let (scene, motion, warning) = found.map_err(|e: Error| e.with_hints(hint.as_slice()))?;
        warning.iter().for_each(|warning| out.warning(warning));
        Ok(Given::Trajectory(Box::new((scene, LoadedTrajectory { motion, ..loaded }))))
    };
    let of_path = |found| Given::Path(Box::new(found));
    let warn = |warning: &str| out.warning(warning);
    if let Some(stream) = stream_of(file)? {
        return stream.parse(|text| match loaded_if_trajectory(text)? {
            _ if cdpr_files::text::is_certificate(text) => {
                Ok(Given::Proof(Box::new((scene.clone(), text.to_string()))))
            }
            Some(loaded) => recorded(loaded),
            None => path_from_text((&scene, args), text, strict, &warn).map(of_path),
        });
    }
    match load_if_trajectory(file)? {
        Some(loaded) => recorded(loaded).map_err(|e| e.in_file(file)),
        None => path(&scene, args, file, strict, &warn).map(of_path),
    }
}

/// An experiment.
pub fn experiment(path: &Path) -> Result<Experiment, Error> {
    match stream_of(path)? {
        Some(stream) => stream.parse(|text| Experiment::from_text(text, notation(text), None, &loader())),
        None => Experiment::load(path, &loader()),
    }
}

fn is_standard_input(path: &Path) -> bool {
    is_dash(path) || path.as_os_str() == "/dev/stdin"
}

/// An input stream.
struct Stream<'a> {
    name: &'a Path,
    bytes: Box<dyn Read>,
}

/// The stream to read instead of a file, if the name refers to one.
fn stream_of(path: &Path) -> Result<Option<Stream<'_>>, Error> {
    if is_standard_input(path) {
        return Ok(Some(Stream { name: Path::new(STANDARD_INPUT), bytes: Box::new(std::io::stdin()) }));
    }
    if !OPENED_BY_SHELL.iter().any(|folder| path.starts_with(folder)) {
        return Ok(None);
    }
    let file = File::open(path).map_err(|e| Error::system(path, "cannot be read", e))?;
    Ok(Some(Stream { name: path, bytes: Box::new(file) }))
}

impl Stream<'_> {
    fn parse<T>(self, parse: impl FnOnce(&str) -> Result<T, Error>) -> Result<T, Error> {
        let text = cdpr_files::text::read_stream(self.bytes, self.name)?;
        parse(&text).map_err(|e| e.in_file(self.name))
    }
}

/// JSON begins with a brace, TOML never does.
fn notation(text: &str) -> Notation {
    if text.trim_start().starts_with('{') { Notation::Json } else { Notation::Toml }
}
