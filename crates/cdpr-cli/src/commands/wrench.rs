//! `cdpr wrench`

use std::path::Path;

use cdpr_core::collision::Constraints;
use cdpr_core::collision::batch::BatchOptions;
use cdpr_core::geometry::{Aabb, Point};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::map::Place;
use cdpr_core::wrench::{
    Loads, MapOptions, Required, Statics, TensionRow, WrenchMap, WrenchReport, constraint, tensions_along, wrench_at,
};
use cdpr_core::{Error, Scene, io};

use crate::Answer;
use crate::args::{Format, WrenchArgs};
use crate::input;
use crate::output::{Console, is_stream, position, scene_line, thousandths};
use crate::progress::{interrupted, with_sign_of_life, writing};

pub fn run(args: &WrenchArgs, out: &Console) -> Result<Answer, Error> {
    let scene = input::scene(&args.scene, out)?;
    match (&args.at, args.grid, &args.along) {
        (Some(at), _, _) => at_position(args, &scene, &Point::from_slice(at), out),
        (_, Some(step), _) => map(args, &scene, step, out),
        (_, _, path) => along(args, &scene, path.as_deref().expect("clap asks for one of the three"), out),
    }
}

/// What the cables can produce, and what they must.
fn asked(args: &WrenchArgs, scene: &Scene) -> Result<(Statics, Required), Error> {
    let statics = Statics::new(scene.robot(), &Loads::of(scene)).map_err(|e| e.in_file(&args.scene.scene))?;
    Ok((statics, constraint::required_of(scene, args.force, args.moment)?))
}

fn at_position(args: &WrenchArgs, scene: &Scene, at: &Point, out: &Console) -> Result<Answer, Error> {
    let (statics, required) = asked(args, scene)?;
    let report = wrench_at(&statics, &required, at).map_err(|e| e.in_file(&args.scene.scene))?;
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!(report))),
        Format::Text => {
            out.result(&scene_line(scene));
            report_lines(&statics, &report, &position(at)).iter().for_each(|line| out.result(line));
        }
    }
    Ok(if report.feasible { Answer::Yes } else { Answer::No })
}

fn along(args: &WrenchArgs, scene: &Scene, path: &Path, out: &Console) -> Result<Answer, Error> {
    let named = args.output.as_deref().filter(|output| !is_stream(output));
    named.map(io::check_tensions_name).transpose()?;
    let out = &out.beside(args.output.as_deref());
    let (scene, path) = input::path(scene, &args.scene, path, args.strict, out)?;
    let (statics, required) = asked(args, &scene)?;
    let rows = tensions_along(&statics, &required, &path.waypoints, args.step, None, &interrupted)
        .map_err(|e| e.in_file(&args.scene.scene))?;
    let all_balanced = rows.iter().all(|row| row.tensions.is_some());
    if let Some(output) = &args.output {
        out.write(output, io::tensions_csv(&rows).as_bytes(), "")?;
    }
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", serde_json::json!({ "rows": rows }))),
        Format::Text if args.output.is_none() => out.result(io::tensions_csv(&rows).trim_end()),
        Format::Text => summary(&scene, &statics, &rows).iter().for_each(|line| out.result(line)),
    }
    Ok(if all_balanced { Answer::Yes } else { Answer::No })
}

fn report_lines(statics: &Statics, report: &WrenchReport, at: &str) -> Vec<String> {
    let verdict = if report.feasible { "feasible" } else { "not feasible" };
    let full = if statics.point_mass() { 3 } else { 6 };
    let mut lines = vec![format!("{verdict} at {at}: capacity margin {} N", thousandths(report.capacity_margin))];
    if report.rank < full {
        lines.push(format!(
            "rank {} of {full}: some wrenches cannot be had at any tension, and no ball of moments can be required",
            report.rank
        ));
    }
    let moment =
        report.moment_margin.map_or("none (point mass)".to_string(), |margin| format!("{} N·m", thousandths(margin)));
    lines.push(format!("force margin {} N, moment margin {moment}", thousandths(report.force_margin)));
    lines.push(format!("limited by: {}", saturated(report)));
    match &report.tensions {
        None => lines.push("no tensions within the limits balance the loads".to_string()),
        Some(tensions) => {
            lines.push("tensions nearest to the middle of their limits:".to_string());
            lines.extend(
                statics
                    .cables()
                    .iter()
                    .zip(tensions)
                    .zip(&report.lengths)
                    .map(|((cable, tension), length)| format!("  {}: {tension:.3} N, {length:.4} m", cable.name)),
            );
        }
    }
    lines
}

fn saturated(report: &WrenchReport) -> String {
    let side =
        |cables: &[String], which: &str| (!cables.is_empty()).then(|| format!("{} at {which}", cables.join(", ")));
    let sides: Vec<String> =
        [side(&report.limit.at_greatest, "greatest tension"), side(&report.limit.at_least, "least tension")]
            .into_iter()
            .flatten()
            .collect();
    if sides.is_empty() { "no cable (the set is flat)".to_string() } else { sides.join("; ") }
}

fn summary(scene: &Scene, statics: &Statics, rows: &[TensionRow]) -> Vec<String> {
    let balanced: Vec<&TensionRow> = rows.iter().filter(|row| row.tensions.is_some()).collect();
    let tensions = || {
        balanced
            .iter()
            .flat_map(|row| row.tensions.iter().flatten().enumerate().map(|(cable, tension)| (*tension, cable, row.s)))
    };
    let told = |what: &str, found: Option<(f64, usize, f64)>| {
        found.map(|(tension, cable, s)| {
            format!("{what} tension {tension:.3} N: {} at {s:.4} m", statics.cables()[cable].name)
        })
    };
    let scarcest = rows.iter().filter_map(|row| row.capacity_margin.map(|margin| (margin, row.s)));
    let mut lines = vec![scene_line(scene)];
    lines.push(format!("{} places, the loads balanced at {} of them", rows.len(), balanced.len()));
    lines.extend(told("least", tensions().min_by(|a, b| a.0.total_cmp(&b.0))));
    lines.extend(told("greatest", tensions().max_by(|a, b| a.0.total_cmp(&b.0))));
    lines.extend(
        scarcest
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(margin, s)| format!("least capacity margin {margin:.3} N at {s:.4} m")),
    );
    lines
}

fn map(args: &WrenchArgs, scene: &Scene, step: f64, out: &Console) -> Result<Answer, Error> {
    let (statics, required) = asked(args, scene)?;
    let output = args.output.as_deref().expect("clap asks for it");
    io::MapFormat::of(output)?;
    let (min, max) = Constraints::within(scene, &Watch::on(&interrupted))?.position_box();
    if (min - max).max() > 0.0 {
        return Err(Error::invalid(
            "workspace",
            "found one that the platform does not fit into, so there are no positions",
        ));
    }
    let options = MapOptions { step, projected: args.projected };
    let map = with_sign_of_life(out, "measuring", |stop| {
        let batch = BatchOptions { threads: None, interrupted: stop };
        WrenchMap::new(&statics, &required, &Aabb { min, max }, &options, &batch)
    })?;
    let writing = writing();
    io::save_wrench_map(output, &map)?;
    drop(writing);
    let found = map.summary();
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", summary_json(&map))),
        Format::Text => {
            out.result(&scene_line(scene));
            let [nx, ny, nz] = map.grid().counts;
            let share = 100.0 * found.share;
            out.result(&format!(
                "{} of {} nodes feasible ({nx} x {ny} x {nz}), {share:.1} %",
                found.feasible, found.nodes
            ));
            out.result(&format!("feasible volume {:.3} m³", found.volume));
            let extent = found.extent.iter().map(|e| format!("from {} to {} m", position(&e.min), position(&e.max)));
            extent.for_each(|extent| out.result(&format!("its extent {extent}")));
            for (what, place) in [("least", &found.least), ("greatest", &found.greatest)] {
                let told =
                    |p: &Place| format!("{what} margin {} N at {}", thousandths(p.margin), position(&p.position));
                place.iter().for_each(|place| out.result(&told(place)));
            }
        }
    }
    out.wrote(output, "");
    Ok(if found.feasible > 0 { Answer::Yes } else { Answer::No })
}

fn summary_json(map: &WrenchMap) -> serde_json::Value {
    let (found, grid) = (map.summary(), map.grid());
    let place = |p: &Place| serde_json::json!({ "margin": p.margin, "position": p.position.coords.as_slice() });
    let extent = |e: &Aabb| serde_json::json!({ "min": e.min.coords.as_slice(), "max": e.max.coords.as_slice() });
    serde_json::json!({
        "origin": grid.origin.coords.as_slice(),
        "step": grid.step,
        "counts": grid.counts,
        "nodes": found.nodes,
        "feasible": found.feasible,
        "undefined": found.undefined,
        "share": found.share,
        "volume": found.volume,
        "extent": found.extent.as_ref().map(extent),
        "least": found.least.as_ref().map(place),
        "greatest": found.greatest.as_ref().map(place),
        "fingerprint": map.identity().fingerprint(),
    })
}
