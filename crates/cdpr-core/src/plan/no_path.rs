//! Why a scene has no path, in the names of the scene.

use std::collections::BTreeMap;

use serde::Serialize;

use super::PlanOptions;
use crate::batch::each;
use crate::certificate::WRENCH;
use crate::collision::Checker;
use crate::compiled::engine_within;
use crate::error::Error;
use crate::geometry::{Point, path_length};
use crate::limits::PROOF_EFFORT;
use crate::model::Scene;
use crate::planning::PathOptimizer;
use crate::postprocess::StringPuller;
use crate::proof::{Answer, Certificate, Content, Proof, ProofBox, decide, quick_path};
use crate::watch::{Watch, unless_stopped};
use crate::words::length;

/// Why a scene has no path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NoPath {
    /// Culprits: the pairs whose conditions close off the goal, by name. A single name is a cable with length limits,
    /// or "wrench".
    pub culprits: Vec<Vec<String>>,
    /// The obstacles that close off the goal, by name; each of them is needed for that.
    pub blocking: Vec<String>,
    /// For each obstacle of `blocking`, the length of the path that exists if it is removed, m; `None` if no path was
    /// found then either.
    pub without: BTreeMap<String, Option<f64>>,
    /// The paths whose lengths are in `without`, m.
    #[serde(skip)]
    pub paths_without: BTreeMap<String, Vec<Point>>,
    /// Volume of the positions known to be reachable from the start, m³.
    pub reachable_volume: f64,
    /// The reachable position that is nearest to the goal, m.
    pub nearest_to_goal: [f64; 3],
    /// The proof applies to paths that keep a gap of more than this, m.
    pub margin: f64,
    /// Number of boxes of the proof.
    pub boxes: usize,
    /// For each condition of the proof, its index in `culprits`.
    #[serde(skip)]
    pub culprit_of: BTreeMap<usize, usize>,
    /// The proof itself.
    #[serde(skip)]
    pub proof: Proof,
    /// The proof as plain data.
    #[serde(skip)]
    pub certificate: Certificate,
}

impl NoPath {
    /// Decides whether there is a path between two positions, and explains it if there is none; `None` if there is one, if that
    /// stays undecided, or if a position is not valid.
    ///
    /// # Errors
    /// The errors of [`decide`].
    pub fn decided(
        scene: &Scene,
        checker: &dyn Checker,
        ends: [&Point; 2],
        options: &PlanOptions,
        watch: &Watch,
    ) -> Result<Option<Self>, Error> {
        if !ends.iter().all(|end| checker.state_valid(end)) {
            return Ok(None);
        }
        match decide(checker, ends, PROOF_EFFORT, watch)? {
            Answer::NoPath(proof) => NoPath::of(*proof, scene, checker, options, watch).map(Some),
            Answer::Path(_) | Answer::OpeningBelow(_) => Ok(None),
        }
    }

    /// Explains a proof about a scene. If the caller wants to stop, only paths without obstacles are missing.
    ///
    /// # Errors
    /// A scene that is too large to be compiled without one of its obstacles.
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
        let mut culprit_of = BTreeMap::new();
        for condition in &proof.conditions {
            let pair = names(condition);
            let known = culprits.iter().position(|other| *other == pair); // several parts of one obstacle
            culprit_of.insert(*condition, known.unwrap_or(culprits.len()));
            if known.is_none() {
                culprits.push(pair);
            }
        }
        let blocking: Vec<String> = proof.blocking.iter().map(|&j| scene.obstacles()[j].name.clone()).collect();
        let paths = each(blocking.len(), 2, &|(), k| {
            let Some(way) = proof.paths_without[k].as_deref() else { return Ok(None) };
            unless_stopped(path_without(scene, &blocking[k], way, options, watch)).map(Option::flatten)
        })?;
        let names = || blocking.iter().cloned();
        let without = names().zip(paths.iter().map(|path| path.as_deref().map(path_length))).collect();
        let paths_without = names().zip(paths).filter_map(|(name, path)| path.map(|path| (name, path))).collect();
        Ok(NoPath {
            culprits,
            blocking,
            without,
            paths_without,
            culprit_of,
            reachable_volume: proof.reachable_volume,
            nearest_to_goal: proof.nearest_to_goal.into(),
            margin: proof.margin,
            boxes: proof.boxes.len(),
            certificate: Certificate::of(&proof, scene, checker),
            proof,
        })
    }

    /// What closes a box of the proof, as an index into `culprits`; `None` for an open box.
    pub fn closed_by(&self, positions: &ProofBox) -> Option<usize> {
        let condition = match positions.content {
            Content::Open => return None,
            Content::Region(region) => self.proof.regions[region].condition,
            Content::Bound(condition) => condition,
        };
        self.culprit_of.get(&condition).copied()
    }

    /// The reason in plain words: "cable 3 and pillar, the platform and beam".
    pub fn reason(&self) -> String {
        let pairs: Vec<String> = self.culprits.iter().map(|names| names.join(" and ")).collect();
        pairs.join(", ")
    }

    /// Describes what removing each obstacle gives: "without pillar 2.930 m, without beam no path found".
    pub fn remedies(&self) -> String {
        let remedy = |(name, found): (&String, &Option<f64>)| match found {
            Some(cost) => format!("without {name} {}", length(*cost)),
            None => format!("without {name} no path found"),
        };
        self.without.iter().map(remedy).collect::<Vec<_>>().join(", ")
    }
}

/// The length of the path that exists without an obstacle, m, given a path past all other obstacles.
fn path_without(
    scene: &Scene,
    name: &str,
    way: &[Point],
    options: &PlanOptions,
    watch: &Watch,
) -> Result<Option<Vec<Point>>, Error> {
    let engine = engine_within(&scene.without(name)?, options.engine, options.interference, watch)?;
    let path = if way.windows(2).all(|ends| engine.motion_valid(&ends[0], &ends[1])) {
        way.to_vec()
    } else {
        let ends = [&way[0], &way[way.len() - 1]];
        let Some(path) = quick_path(&*engine, ends, watch)? else { return Ok(None) };
        path
    };
    StringPuller::new(&*engine).polished(&path, watch).map(Some)
}
