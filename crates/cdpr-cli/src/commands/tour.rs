//! `cdpr tour`

use std::path::Path;
use std::sync::Arc;

use cdpr_core::compiled::CompiledScene;
use cdpr_core::planning::Status;
use cdpr_core::tour::{By, Leg, Tour, TourFile, plan_tour};
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::{Error, Scene};
use cdpr_files::matrix_csv;
use cdpr_view::{Contents, page};

use super::trajectory::hinted;
use super::view::{IN_BROWSER, form};
use crate::Answer;
use crate::args::{Format, TourArgs};
use crate::input;
use crate::interruption::interrupted;
use crate::output::{Console, Verdict, count, is_standard_output, is_stream, scene_line, short};
use crate::progress::with_progress;

pub fn run(args: &TourArgs, out: &Console) -> Result<Answer, Error> {
    let files = [&args.output, &args.matrix, &args.html].map(|file| file.as_deref());
    if files.iter().flatten().filter(|file| is_standard_output(file)).count() > 1 {
        let problem = "found - for more than one of -o, --matrix and --html; only one of them can be standard output";
        return Err(Error::invalid("", problem));
    }
    let out = &files.iter().fold(*out, |out, file| out.beside(*file));
    let scene = input::scene(&args.scene, out)?;
    let in_scene = |e: Error| args.given.blamed(hinted(e), &args.scene.scene);
    let options = args.search.options(&args.given)?;
    let (wanted, checker) = (args.tour(), &args.search.checker);
    let search = |stop: &Interrupt| {
        let compiled = CompiledScene::new(&scene, checker.engine, checker.interference, &Watch::on(stop))?;
        let compiled = Arc::new(compiled);
        let tour = plan_tour(&compiled, &wanted, &options, stop, &|_, _| ())?;
        Ok((tour, compiled))
    };
    let (tour, compiled) = with_progress(out, "planning between stations", search).map_err(in_scene)?;
    out.remarks(&scene, compiled.level().conditions());
    let file = TourFile::of(&scene, &tour);
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(file))),
        Format::Text => {
            out.result(&scene_line(&scene));
            out.verdict(&verdict(&tour, args.returns));
            lines(&tour).iter().for_each(|line| out.result(line));
        }
    }
    if let Some(path) = &args.output {
        save(path, &file, out)?;
    }
    if let Some(path) = &args.matrix {
        out.write(path, matrix_csv(&tour.legs).as_bytes(), "")?;
    }
    if interrupted() {
        let unknown = tour.legs.legs.iter().filter(|leg| leg.weight().is_infinite()).count();
        let what = if args.by == By::Time { "motion" } else { "path" };
        out.say(&format!("interrupted; no {what} between {} of {}", unknown, count(tour.legs.legs.len(), "pair")));
    } else if let Some(path) = &args.html {
        html(path, &scene, &tour, &file, out)?;
    }
    Ok(if tour.cost.is_finite() { Answer::Yes } else { Answer::No })
}

fn save(path: &Path, file: &TourFile, out: &Console) -> Result<(), Error> {
    match is_stream(path) {
        true => out.write(path, format!("{:#}\n", serde_json::json!(file)).as_bytes(), ""),
        false => out.save(path, "", || cdpr_files::save_path(path, file)),
    }
}

/// Writes the page of a tour; without one, there is nothing to show.
fn html(path: &Path, scene: &Scene, tour: &Tour, file: &TourFile, out: &Console) -> Result<(), Error> {
    match &tour.path[..] {
        [first, .., last] => {
            let page = page(&scene.with_ends([*first, *last])?, Contents::from(&file.path), form(false));
            out.write(path, page.as_bytes(), IN_BROWSER)
        }
        _ => {
            out.say(&format!("{} was not written: there is no tour", path.display()));
            Ok(())
        }
    }
}

fn verdict(tour: &Tour, returns: bool) -> Verdict {
    let stations = count(tour.legs.stations.len(), "station");
    if tour.cost.is_infinite() {
        let certain = tour.lower_bound.is_infinite();
        return match (certain, tour.time) {
            (true, _) => Verdict::no("no tour:", format!(" the {stations} cannot all be visited")),
            (false, Some(_)) => {
                Verdict::no("no tour found:", format!(" not all pairs of the {stations} have a path that can be timed"))
            }
            (false, None) => Verdict::no("no tour found:", format!(" not all pairs of the {stations} have a path")),
        };
    }
    let back = if returns { " and back" } else { "" };
    let time = tour.time.map_or(String::new(), |[duration, _]| format!(" {} s,", short(duration)));
    Verdict::yes("tour:", format!("{time} {} m through {stations}{back}", short(tour.cost)))
}

fn lines(tour: &Tour) -> Vec<String> {
    let name = |stop: usize| tour.legs.stations[stop].name.as_str();
    if tour.cost.is_infinite() {
        let lacking = tour.legs.pairs.iter().zip(&tour.legs.legs).filter(|(_, leg)| leg.weight().is_infinite());
        let line = |([a, b], leg): (&[usize; 2], &Leg)| format!("  {} to {}: {}", name(*a), name(*b), reason(leg));
        return lacking.map(line).collect();
    }
    let legs = tour.order.windows(2).zip(tour.order.windows(2).filter_map(|pair| tour.legs.between(pair[0], pair[1])));
    let line = |(pair, (leg, _)): (&[usize], (&Leg, bool))| {
        let time = leg.time.as_ref().map_or(String::new(), |time| format!("{} s, ", short(time.duration)));
        format!("  {} to {}: {time}{} m", name(pair[0]), name(pair[1]), short(leg.cost))
    };
    let excess = |found: f64, bound: f64| if found > bound { 100.0 * (found / bound - 1.0) } else { 0.0 };
    let bound = match tour.time {
        None => format!(
            "no tour is shorter than {} m, so this one is at most {:.2} % too long",
            short(tour.lower_bound),
            excess(tour.cost, tour.lower_bound)
        ),
        Some([_, 0.0]) => "no lower bound of the duration: speeds and accelerations have no limit".to_string(),
        Some([duration, least]) => format!(
            "no tour that stops at its stations takes less than {} s, so this one is at most {:.2} % too slow",
            short(least),
            excess(duration, least)
        ),
    };
    legs.map(line).chain([bound]).collect()
}

fn reason(leg: &Leg) -> String {
    let words = match leg.status {
        Status::StartInvalid => "the first of them is not valid",
        Status::GoalInvalid => "the second of them is not valid",
        Status::NoPath => "there is no path",
        Status::Interrupted => "interrupted",
        Status::BudgetSpent => "no path was found",
        Status::Solved => {
            let why = leg.time.as_ref().and_then(|time| time.reason.as_deref()).unwrap_or_default();
            return format!("the path cannot be timed: {why}");
        }
    };
    words.to_string()
}
