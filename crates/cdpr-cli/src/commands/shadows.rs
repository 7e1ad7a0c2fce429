//! `cdpr shadows`

use cdpr_core::collision::Conditions;
use cdpr_core::regions::{NamedMesh, Regions, regions_within};
use cdpr_core::watch::Watch;
use cdpr_core::{Choice, Error, Scene};
use cdpr_files::{RegionFormat, save_regions};
use cdpr_view::regions_page;
use serde_json::json;

use super::view::IN_BROWSER;
use crate::Answer;
use crate::args::{Format, ShadowsArgs};
use crate::input;
use crate::interruption::interrupted;
use crate::output::{Console, count, lossy, scene_line};

pub fn run(args: &ShadowsArgs, out: &Console) -> Result<Answer, Error> {
    let scene = input::scene(&args.scene, out)?;
    let watch = Watch::on(&interrupted);
    let found = regions_within(&scene, &args.options(), &watch).map_err(|e| args.given.blamed(e, &args.scene.scene))?;
    if args.all {
        out.remarks(&scene, &Conditions::new(&scene)?);
    }
    if has_round_regions(&scene) {
        out.note(
            "the meshes do not include clearances and cable diameters, which would round the edges of the regions",
        );
    }
    match args.scene.format {
        Format::Json => out.result(&format!("{:#}", summary(args, &found))),
        Format::Text => {
            out.result(&scene_line(&scene));
            lines(&found).iter().for_each(|line| out.result(line));
        }
    }
    let hint = if RegionFormat::of(&args.output)? == RegionFormat::Html { IN_BROWSER } else { "" };
    out.save(&args.output, hint, || save_regions(&args.output, &scene, &found, regions_page))?;
    Ok(Answer::Yes)
}

fn has_round_regions(scene: &Scene) -> bool {
    scene.pairs().largest() > 0.0 || scene.robot().cables().iter().any(|cable| cable.diameter > 0.0)
}

fn triangles(found: &Regions) -> usize {
    found.meshes.iter().map(|region| region.mesh.triangles.len()).sum()
}

fn summary(args: &ShadowsArgs, found: &Regions) -> serde_json::Value {
    let mut within = json!(found.within);
    within["volume"] = found.box_volume().into();
    json!({
        "output": lossy(&args.output),
        "space": found.space,
        "box": within,
        "triangles": triangles(found),
        "meshes": found.meshes.iter().map(NamedMesh::summary).collect::<Vec<_>>(),
    })
}

fn lines(found: &Regions) -> Vec<String> {
    let space = found.space.name();
    if found.box_volume() == 0.0 {
        return vec![format!(
            "0 regions in the space of {space}s: the box that clips them is flat, so they have no volume"
        )];
    }
    let Some(largest) = found.meshes.iter().max_by(|a, b| a.mesh.volume().total_cmp(&b.mesh.volume())) else {
        return vec![format!("0 regions in the space of {space}s: nothing is forbidden there")];
    };
    let share = 100.0 * largest.mesh.volume() / found.box_volume();
    vec![
        format!(
            "{} in the space of {space}s, {}, closed and oriented outward",
            count(found.meshes.len(), "region"),
            count(triangles(found), "triangle")
        ),
        format!("largest: {}, {:.3} m³, {share:.1} % of the box that clips it", largest.name, largest.mesh.volume()),
    ]
}
