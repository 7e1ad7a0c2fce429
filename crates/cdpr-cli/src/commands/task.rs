//! `cdpr task`

use std::path::Path;

use cdpr_core::Error;
use cdpr_core::collision::Conditions;
use cdpr_core::planning::Status;
use cdpr_core::task::{LegKeys, Task, TaskFile, plan_task};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_files::{save_task, task_file};
use cdpr_view::{Contents, page};

use super::view::{IN_BROWSER, form};
use crate::Answer;
use crate::args::{Format, TaskArgs};
use crate::input;
use crate::interruption::{interrupted, writing};
use crate::output::{Console, Verdict, count, scene_line, short};
use crate::progress::with_progress;

pub fn run(args: &TaskArgs, out: &Console) -> Result<Answer, Error> {
    let scene = input::scene(&args.scene, out)?;
    let in_scene = |e: Error| args.given.blamed(e, &args.scene.scene);
    let options = args.search.options(&args.given)?;
    let conditions = Conditions::within(&scene, &Watch::on(&interrupted)).map_err(in_scene)?;
    let search = |stop: &Interrupt| {
        // Searches poll the interruption themselves, and what they have is written before it may end the program.
        let _writing = writing();
        let task = plan_task(&scene, &options, args.search.threads, stop, &|_, _| ())?;
        let written = save_task(&args.output, &scene, &task);
        Ok((task, written))
    };
    let (task, written) = with_progress(out, "planning legs", search).map_err(in_scene)?;
    out.remarks(&scene, &conditions);
    let file = task_file(&scene, &task);
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(file))),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.verdict(&verdict(&task));
            lines(&file).iter().for_each(|line| out.result(line));
        }
    }
    out.say(&format!("wrote {} to {}", count(written?.len(), "file"), args.output.display()));
    if interrupted() {
        let unknown = task.plans.iter().filter(|plan| plan.status == Status::Interrupted).count();
        out.say(&format!("interrupted; no path for {unknown} of {}", count(task.plans.len(), "leg")));
    } else if args.html {
        pages(&args.output, &task, out)?;
    }
    Ok(if task.status() == Status::Solved { Answer::Yes } else { Answer::No })
}

/// Writes a page of each leg that has a path.
fn pages(folder: &Path, task: &Task, out: &Console) -> Result<(), Error> {
    for (k, (leg, plan)) in task.legs.legs.iter().zip(&task.plans).enumerate() {
        if plan.status == Status::Solved {
            let page = page(&leg.scene, Contents::from(&plan.file), form(false));
            out.write(&folder.join(format!("leg-{}.html", k + 1)), page.as_bytes(), IN_BROWSER)?;
        }
    }
    Ok(())
}

fn verdict(task: &Task) -> Verdict {
    let legs = count(task.plans.len(), "leg");
    let lacking = task.plans.iter().filter(|plan| plan.status != Status::Solved).count();
    match lacking {
        0 => Verdict::yes("task:", format!(" {} m in {legs}", short(task.cost()))),
        _ => Verdict::no("no task:", format!(" {lacking} of {legs} without a path")),
    }
}

fn lines(file: &TaskFile) -> Vec<String> {
    let line = |(k, leg): (usize, &LegKeys)| {
        let answer = leg.cost.map_or_else(|| reason(leg), |cost| format!("{} m", short(cost)));
        format!("  {}: {answer}", leg_words(k, leg))
    };
    file.legs.iter().enumerate().map(line).collect()
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
