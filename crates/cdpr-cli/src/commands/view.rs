//! `cdpr view`

use std::path::Path;

use cdpr_core::collision::{Checker, check_path};
use cdpr_core::geometry::{Pose, wxyz};
use cdpr_core::plan::{NoPath, PlanOptions};
use cdpr_core::proof::certificate_ends;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use cdpr_files::{LoadedPath, PathFile};
use cdpr_view::{Contents, Form, Planning, page_within, trajectory_page_within};

use crate::Answer;
use crate::args::{Format, ViewArgs};
use crate::input::{self, Given};
use crate::interruption::interrupted;
use crate::output::{Console, lossy};

/// Hint for a page.
pub const IN_BROWSER: &str = "(open it in a browser)";

pub fn run(args: &ViewArgs, out: &Console) -> Result<Answer, Error> {
    let out = &out.beside(Some(&args.output));
    let watch = Watch::on(&interrupted);
    let form = form(args.is_static);
    let given = |path: &Path| input::path_trajectory_or_proof(&args.scene, path, args.strict, out);
    let (page, violations) = match args.path.as_deref().map(|path| Ok::<_, Error>((path, given(path)?))).transpose()? {
        None => (page_within(&input::scene(&args.scene, out)?, Contents::default(), form, &watch)?, Vec::new()),
        Some((path, Given::Proof(found))) => {
            let (scene, text) = *found;
            if cdpr_certify::is_bound(&text) {
                let problem = "found a proof that no path is shorter than a length, which is not drawn; expected a path, a \
                               trajectory or a proof that there is no path";
                let hint = "or check it: cdpr check".to_string();
                return Err(Error::invalid("", problem).with_hints(&[hint]).in_file(path));
            }
            args.given.refuse(&["--strict"], "with a proof", "a path or a trajectory")?;
            input::selects_orientation(&scene, &args.scene)?;
            input::never_turns(&scene, &args.scene)?;
            let engine = input::compiled(&scene, &[], &args.scene, args.checker)?;
            let shown = proved_again(&scene, engine.level(), &text, args, &watch).map_err(|e| e.in_file(path))?;
            (page_within(&scene, Contents::from(&shown), form, &watch)?, Vec::new())
        }
        Some((path, Given::Path(found))) => {
            let (scene, loaded) = *found;
            let way = loaded.path(&scene);
            let compiled = input::compiled(&scene, &way, &args.scene, args.checker)?;
            let report = check_path(&compiled, &way, &watch)?;
            let shown = shown(&scene, &way, &loaded, report.length);
            // A CSV path has no planning data.
            let text = path.is_file().then(|| std::fs::read_to_string(path)).and_then(Result::ok);
            let planning = text.and_then(|text| Planning::of_json(&text));
            let violations = &report.violations;
            let contents = Contents { path: Some(&shown), planning: planning.as_ref(), violations };
            (page_within(&scene, contents, form, &watch)?, report.violations)
        }
        Some((path, Given::Trajectory(found))) => {
            let (scene, loaded) = *found;
            let file = loaded.whole(Some(&scene)).map_err(|e| e.in_file(path))?;
            let moving = file.limits.moving_again(&scene)?.into_owned();
            let compiled = input::compiled(&moving, &file.poses(), &args.scene, args.checker)?;
            let violations = file.violations(&compiled, &watch)?;
            (trajectory_page_within(&scene, &file, &violations, &watch)?, violations)
        }
    };
    out.write(&args.output, page.as_bytes(), IN_BROWSER)?;
    if args.scene.format == Format::Json {
        out.result(&serde_json::json!({ "page": lossy(&args.output), "violations": violations }).to_string());
    }
    Ok(Answer::Yes)
}

/// The form of a page, given `--static`.
pub fn form(is_static: bool) -> Form {
    if is_static { Form::Static } else { Form::Live }
}

/// Decides again why the scene has no path between the ends of a certificate, since a certificate lacks what is needed to draw
/// it, such as what can be reached.
fn proved_again(
    scene: &Scene,
    engine: &dyn Checker,
    text: &str,
    args: &ViewArgs,
    watch: &Watch,
) -> Result<PathFile, Error> {
    let [start, goal] = certificate_ends(text)?;
    let (engine_kind, interference) = (args.checker.engine, args.checker.interference);
    let options = PlanOptions { engine: engine_kind, interference, ..PlanOptions::default() };
    let found = NoPath::decided(scene, engine, [&start, &goal], &options, watch)?;
    let problem = "found a proof for another scene or orientation, expected one for this scene";
    let no_path = found.ok_or_else(|| Error::invalid("", problem))?;
    Ok(PathFile::without_path(scene, no_path))
}

/// The path as given in its file, with its length computed again.
fn shown(scene: &Scene, path: &[Pose], loaded: &LoadedPath, length: f64) -> PathFile {
    let waypoints = loaded.waypoints.iter().map(|p| (*p).into()).collect();
    let turns = !scene.keeps_orientation(path);
    let orientations = turns.then(|| path.iter().map(|pose| wxyz(&pose.orientation)).collect());
    PathFile { waypoints, orientations, cost: Some(length), ..loaded.file.clone().unwrap_or_default() }
}
