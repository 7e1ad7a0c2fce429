//! Why a scene has no path, in the names of the scene.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{PlanOptions, engine_within};
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::Point;
use crate::model::Scene;
use crate::planning::PathOptimizer;
use crate::postprocess::StringPuller;
use crate::proof::{Certificate, Proof, WRENCH, quick_path};
use crate::watch::{Watch, in_time};
use crate::words::length;

/// Why a scene has no path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NoPath {
    /// The pairs whose conditions close the way, by name; single names are of cables with length limits, or "wrench".
    pub culprits: Vec<Vec<String>>,
    /// The obstacles that close the way, by name; none can be left out.
    pub blocking: Vec<String>,
    /// For each of these the length of the path that exists if it is removed, m; `None` if no path was found then either.
    pub without: BTreeMap<String, Option<f64>>,
    /// Volume of the positions known to be reachable from the start, m³.
    pub reachable_volume: f64,
    /// The reachable position that is nearest to the goal, m.
    pub nearest_to_goal: [f64; 3],
    /// No path keeps a gap of more than this, m.
    pub margin: f64,
    /// Number of boxes of the proof.
    pub boxes: usize,
    /// The proof.
    #[serde(skip)]
    pub proof: Proof,
    /// The proof as plain data.
    #[serde(skip)]
    pub certificate: Certificate,
}

impl NoPath {
    /// Explains a proof about a scene.
    ///
    /// # Errors
    /// [`Error::interrupted`].
    pub fn of(
        proof: Proof,
        scene: &Scene,
        checker: &dyn Checker,
        options: &PlanOptions,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let conditions = checker.conditions();
        let names = |&condition: &usize| match conditions.list.get(condition) {
            Some(condition) => conditions.culprits(condition),
            None => vec![WRENCH.to_string()],
        };
        let mut culprits: Vec<Vec<String>> = Vec::new();
        for pair in proof.conditions.iter().map(names) {
            if !culprits.contains(&pair) {
                culprits.push(pair); // several parts of one obstacle
            }
        }
        let blocking: Vec<String> = proof.blocking.iter().map(|&j| scene.obstacles()[j].name.clone()).collect();
        let mut without = BTreeMap::new();
        for name in &blocking {
            let path = path_without(scene, name, [&proof.start, &proof.goal], options, watch);
            without.insert(name.clone(), in_time(path)?.flatten());
        }
        Ok(NoPath {
            culprits,
            blocking,
            without,
            reachable_volume: proof.reachable_volume,
            nearest_to_goal: proof.nearest_to_goal.into(),
            margin: proof.margin,
            boxes: proof.boxes.len(),
            certificate: Certificate::of(&proof, scene, checker),
            proof,
        })
    }

    /// The reason in plain words: "cable 3 and pillar, the platform and beam".
    pub fn reason(&self) -> String {
        let pairs: Vec<String> = self.culprits.iter().map(|names| names.join(" and ")).collect();
        pairs.join(", ")
    }

    /// What removing each obstacle gives: "without pillar 2.930 m, without beam no path found".
    pub fn remedies(&self) -> String {
        let remedy = |(name, found): (&String, &Option<f64>)| match found {
            Some(cost) => format!("without {name} {}", length(*cost)),
            None => format!("without {name} no path found"),
        };
        self.without.iter().map(remedy).collect::<Vec<_>>().join(", ")
    }
}

/// The length of the path that exists without an obstacle, m.
fn path_without(
    scene: &Scene,
    name: &str,
    ends: [&Point; 2],
    options: &PlanOptions,
    watch: &Watch,
) -> Result<Option<f64>, Error> {
    let engine = engine_within(&scene.without(name)?, options.engine, options.interference, watch)?;
    let Some(path) = quick_path(&*engine, ends, watch)? else { return Ok(None) };
    let path = StringPuller::new(&*engine).polished(&path, watch)?;
    Ok(Some(crate::collision::path_check::path_length(&path)))
}
