//! `cdpr task`

use std::path::Path;

use cdpr_core::Error;
use cdpr_core::collision::Conditions;
use cdpr_core::planning::Status;
use cdpr_core::task::{LegKeys, Task, TaskFile, TaskLegs, plan_task};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_files::{page_name, save_task, task_file};
use cdpr_view::{Contents, page};

use super::trajectory::hinted;
use super::view::{IN_BROWSER, form};
use crate::Answer;
use crate::args::{Format, TaskArgs};
use crate::input;
use crate::interruption::{answered_while, interrupted, writing};
use crate::output::{Console, Verdict, count, scene_line, short};
use crate::progress::with_progress;

pub fn run(args: &TaskArgs, out: &Console) -> Result<Answer, Error> {
    let (whole, timing) = (args.whole()?, args.task_timing());
    let scene = args.tensions.in_scene(input::scene(&args.scene, out)?);
    let in_scene = |e: Error| args.given.blamed(hinted(e), &args.scene.scene);
    if let Some(timing) = &timing {
        TaskLegs::of(&scene).and_then(|legs| timing.checked(&scene, &legs)).map_err(in_scene)?;
    }
    let options = args.search.options(&args.given)?;
    let conditions = Conditions::within(&scene, &Watch::on(&interrupted)).map_err(in_scene)?;
    let search = |stop: &Interrupt| {
        // Searches poll the interruption themselves, and what they have is written before it may end the program.
        let writing = writing();
        let task = plan_task(&scene, &options, args.search.threads, stop, &|_, _| ())?;
        let task = match &timing {
            Some(timing) => task.timed(&scene, timing, args.search.threads, stop)?,
            None => task,
        };
        whole.fits(&task)?;
        let written = save_task(&args.output, &scene, &task, whole);
        answered_while(&writing);
        Ok((task, written))
    };
    let (task, written) = with_progress(out, "planning legs", search).map_err(in_scene)?;
    out.remarks(&scene, &conditions);
    let file = task_file(&scene, &task, whole);
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(file))),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.verdict(&verdict(&task));
            lines(&file).iter().for_each(|line| out.result(line));
            task.motion.iter().flat_map(|motion| &motion.notes).for_each(|note| out.note(note));
        }
    }
    out.say(&format!("wrote {} to {}", count(written?.len(), "file"), args.output.display()));
    if timing.is_some() && task.motion.as_ref().is_none_or(|motion| motion.whole.is_none()) {
        out.say(&format!("{} was not written: not every leg has a motion", args.output.join(whole.name).display()));
    }
    if interrupted() {
        let unknown = task.plans.iter().filter(|plan| plan.status == Status::Interrupted).count();
        out.say(&format!("interrupted; no path for {unknown} of {}", count(task.plans.len(), "leg")));
    } else if args.html {
        pages(&args.output, &task, out)?;
    }
    let complete = task.motion.as_ref().is_none_or(|motion| motion.whole.is_some());
    Ok(if task.status() == Status::Solved && complete { Answer::Yes } else { Answer::No })
}

/// Writes a page of each leg that has a path.
fn pages(folder: &Path, task: &Task, out: &Console) -> Result<(), Error> {
    for (k, (leg, plan)) in task.legs.legs.iter().zip(&task.plans).enumerate() {
        if plan.status == Status::Solved {
            // The planner of the page knows no via points.
            let page = page(&leg.scene, Contents::from(&plan.file), form(!leg.via.is_empty()));
            out.write(&folder.join(page_name(k)), page.as_bytes(), IN_BROWSER)?;
        }
    }
    Ok(())
}

fn verdict(task: &Task) -> Verdict {
    let legs = count(task.plans.len(), "leg");
    let lacking = task.plans.iter().filter(|plan| plan.status != Status::Solved).count();
    let motion = task.motion.as_ref();
    let untimed = motion.map_or(0, |motion| motion.legs.iter().filter(|leg| leg.is_err()).count());
    if lacking > 0 {
        return Verdict::no("no task:", format!(" {lacking} of {legs} without a path"));
    }
    let way = format!(" {} m in {legs}", short(task.cost()));
    match motion.and_then(|motion| motion.whole.as_ref()) {
        Some(whole) => Verdict::yes("task:", format!("{way}, {} s", short(whole.file.duration))),
        None if untimed > 0 => Verdict::no("no motion:", format!("{way}, {untimed} of them cannot be timed")),
        None => Verdict::yes("task:", way),
    }
}

fn lines(file: &TaskFile) -> Vec<String> {
    let line = |(k, leg): (usize, &LegKeys)| {
        let answer = leg.cost.map_or_else(|| reason(leg), |cost| format!("{} m{}", short(cost), motion_words(leg)));
        format!("  {}: {answer}", leg_words(k, leg))
    };
    file.legs.iter().enumerate().map(line).collect()
}

/// The duration of a leg and when it starts, or why it has no motion.
fn motion_words(leg: &LegKeys) -> String {
    let Some(motion) = &leg.motion else { return String::new() };
    match (motion.duration, motion.start) {
        (Some(duration), Some(start)) => format!(" in {} s, from {} s", short(duration), short(start)),
        (Some(duration), None) => format!(" in {} s", short(duration)),
        (None, _) => format!(", but it cannot be timed: {}", motion.reason.as_deref().unwrap_or_default()),
    }
}

/// A leg in words: "leg 2, gap to corner, carrying tower".
pub fn leg_words(k: usize, leg: &LegKeys) -> String {
    let name = |place: &cdpr_core::task::PlaceKeys| {
        let [x, y, z] = place.position.map(short);
        place.name.clone().unwrap_or_else(|| format!("({x}, {y}, {z})"))
    };
    let carried = if leg.carried.is_empty() { String::new() } else { format!(", carrying {}", leg.carried.join(", ")) };
    format!("leg {}, {} to {}{carried}", k + 1, name(&leg.from), name(&leg.to))
}

/// Why a leg has no path.
pub fn reason(leg: &LegKeys) -> String {
    let words = [
        (Status::NoPath, "no path exists"),
        (Status::StartInvalid, "its start is not valid"),
        (Status::GoalInvalid, "its goal is not valid"),
        (Status::Interrupted, "interrupted"),
    ];
    let known = words.iter().find(|(status, _)| cdpr_core::Choice::name(*status) == leg.status);
    let words = known.map_or("no path was found", |(_, words)| words);
    leg.reason.as_ref().map_or(words.to_string(), |reason| format!("{words}: {reason}"))
}
