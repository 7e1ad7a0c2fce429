//! A proved workspace as plain data: volumes, parts, what takes how much away, and the boxes. Files, Python and the command line
//! share this one type.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::cut::Cut;
use super::parts::Parts;
use super::tree::Kind;
use super::{Ended, Proved, ValidAt};
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Aabb, Cuboid, Point, Rotation, wxyz};
use crate::path_file::SceneId;
use crate::regions::pair_name;

/// The name of the format in files.
const FORMAT: &str = "cdpr workspace";
/// The version of the format.
const VERSION: u32 = 1;

/// Where the platform of a scene can be, at one orientation or at several. Volumes are in m³; if the box of positions is flat, they
/// are areas in m², or lengths in m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Workspace {
    /// The name of the format.
    pub format: String,
    /// The version of the format.
    pub version: u32,
    /// The scene.
    pub scene: SceneId,
    /// The orientation, a world-from-platform unit quaternion w x y z.
    pub orientation: [f64; 4],
    /// Name of the orientation in the scene, if it has one.
    pub orientation_name: Option<String>,
    /// Further orientations, if any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub more_orientations: Vec<Oriented>,
    /// At how many of several orientations positions are valid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub valid_at: Option<ValidAt>,
    /// Why the division ended.
    pub ended: Ended,
    /// The positions at which the platform is inside the workspace of the scene, m.
    #[serde(rename = "box")]
    pub within: Extent,
    /// Number of axes along which this box extends: 3, or 2 for a planar robot.
    pub dimension: usize,
    /// Volume of this box.
    pub total: f64,
    /// Bounds of the volume of all valid positions.
    pub volume: Interval,
    /// Volume about which nothing is proved. Of undecided boxes, the part that convex forbidden pieces cut off counts as invalid, and
    /// what all of them leave as valid.
    pub undecided: f64,
    /// Share of the box of positions that is proved to be valid or invalid.
    pub decided: f64,
    /// Longest side of the smallest boxes, m.
    pub finest: f64,
    /// Connected parts of the boxes that are proved inside, the largest first.
    pub parts: Vec<Part>,
    /// What takes how much away, by the kind of the condition.
    pub shares: BTreeMap<String, Share>,
    /// The conditions that forbid boxes.
    pub causes: Vec<Cause>,
    /// The boxes, which tile the box of positions.
    pub boxes: Boxes,
}

/// An orientation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Oriented {
    /// World-from-platform unit quaternion w x y z.
    pub orientation: [f64; 4],
    /// Name in the scene, if it has one.
    pub name: Option<String>,
}

/// Bounds of a number.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// Lower bound.
    pub min: f64,
    /// Upper bound.
    pub max: f64,
}

/// A box of positions, m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Extent {
    /// Smallest coordinates.
    pub min: [f64; 3],
    /// Largest coordinates.
    pub max: [f64; 3],
}

/// A connected part of the boxes that are proved inside: between any two of its positions there is a valid path, at every orientation.
/// If positions are valid at any of several orientations, the platform may have to turn on the way, which is not proved to be possible.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Volume of its boxes.
    pub volume: f64,
    /// Number of its boxes.
    pub boxes: usize,
    /// The smallest box around it.
    pub extent: Extent,
    /// Whether it holds the start of the scene, at one of the orientations.
    pub start: bool,
    /// Whether it holds the goal of the scene, at one of the orientations.
    pub goal: bool,
}

/// What a kind of condition takes away. A box that several conditions forbid counts for the first of them, in the order of checking.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Share {
    /// Share of the box of positions.
    pub share: f64,
    /// Volume.
    pub volume: f64,
    /// Volume by the names of the bodies, as in "cable 3 / pillar"; empty for wrenches, which depend on all cables.
    pub culprits: BTreeMap<String, f64>,
}

/// A condition that forbids boxes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cause {
    /// The kind of the condition.
    pub condition: String,
    /// Names of the bodies.
    pub culprits: Vec<String>,
    /// Index of the orientation at which it forbids them, if there are several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<usize>,
}

/// Boxes of positions, as columns.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Boxes {
    /// Smallest coordinates, m.
    pub lower: Vec<[f64; 3]>,
    /// Largest coordinates, m.
    pub upper: Vec<[f64; 3]>,
    /// 1 if all positions are valid, -1 if none is, 0 if nothing is proved.
    pub verdict: Vec<i64>,
    /// Index of the part of a box that is inside, otherwise -1.
    pub part: Vec<i64>,
    /// Index of the condition that forbids a box, otherwise -1.
    pub cause: Vec<i64>,
}

impl Extent {
    fn of(low: &Point, high: &Point) -> Self {
        Extent { min: (*low).into(), max: (*high).into() }
    }

    fn with(self, span: &Cuboid) -> Self {
        let [min, max] = [self.min, self.max].map(Point::from);
        Extent::of(&min.inf(&span.low), &max.sup(&span.high))
    }
}

impl Proved<'_> {
    /// Sums up the boxes.
    pub fn workspace(&self) -> Workspace {
        let Proved { compiled, valid_at, within: Aabb { min, max }, tree, cuts, ended } = self;
        let scene = compiled[0].scene();
        let oriented = |of: &&CompiledScene| Oriented {
            orientation: wxyz(of.scene().orientation()),
            name: of.scene().orientation_name().map(str::to_string),
        };
        let total = tree.volume(super::WHOLE);
        let parts = Parts::of(tree);
        let mut found = Workspace {
            format: FORMAT.to_string(),
            version: VERSION,
            scene: SceneId::of(scene),
            orientation: wxyz(scene.orientation()),
            orientation_name: scene.orientation_name().map(str::to_string),
            more_orientations: compiled[1..].iter().map(oriented).collect(),
            valid_at: (compiled.len() > 1).then_some(*valid_at),
            ended: *ended,
            within: Extent::of(min, max),
            dimension: tree.dimension(),
            total,
            volume: Interval { min: 0.0, max: 0.0 },
            undecided: 0.0,
            decided: 0.0,
            finest: tree.finest(),
            parts: vec![Part::EMPTY; parts.count],
            shares: BTreeMap::new(),
            causes: Vec::new(),
            boxes: Boxes::default(),
        };
        let ends = ends(compiled);
        let mut causes: Vec<Option<usize>> = vec![None; compiled.iter().map(|at| conditions_of(at)).sum()];
        let mut taken: Vec<f64> = Vec::new();
        let mut cause_of = |condition: u32, found: &mut Workspace, volume: f64| {
            // The parts of a body have conditions of their own.
            let cause = *causes[condition as usize].get_or_insert_with(|| {
                let cause = self.cause(condition as usize);
                found.causes.iter().position(|known| *known == cause).unwrap_or_else(|| {
                    found.causes.push(cause);
                    taken.push(0.0);
                    taken.len() - 1
                })
            });
            taken[cause] += volume;
            cause
        };
        for leaf in tree.leaves() {
            let (span, volume) = (tree.span(leaf), tree.volume(leaf));
            match tree.kind(leaf) {
                Kind::Inside => {
                    let part = parts.number(leaf) as usize;
                    found.volume.min += volume;
                    found.parts[part].add(&span, volume, &ends);
                    found.boxes.add(&span, 1, Some(part), None);
                }
                Kind::Outside(condition) => {
                    let cause = cause_of(condition, &mut found, volume);
                    found.boxes.add(&span, -1, None, Some(cause));
                }
                Kind::Undecided | Kind::Divided(_) => {
                    found.undecided += volume;
                    found.boxes.add(&span, 0, None, None);
                }
            }
        }
        for Cut { valid, forbidden } in cuts {
            found.volume.min += valid;
            found.undecided -= valid;
            for (condition, volume) in forbidden {
                cause_of(*condition, &mut found, *volume);
                found.undecided -= volume;
            }
        }
        found.undecided = found.undecided.max(0.0);
        found.volume.max = found.volume.min + found.undecided;
        found.decided = 1.0 - found.undecided / total;
        for (cause, volume) in found.causes.iter().zip(taken) {
            let share = found.shares.entry(cause.condition.clone()).or_default();
            share.volume += volume;
            share.share += volume / total;
            if !cause.culprits.is_empty() {
                *share.culprits.entry(pair_name(&cause.culprits)).or_default() += volume;
            }
        }
        found
    }

    /// What a condition is, by its index among those of all orientations.
    fn cause(&self, mut condition: usize) -> Cause {
        let mut at = 0;
        while condition >= conditions_of(self.compiled[at]) {
            condition -= conditions_of(self.compiled[at]);
            at += 1;
        }
        let conditions = self.compiled[at].conditions();
        let at = (self.compiled.len() > 1).then_some(at);
        let name = |kind: crate::collision::Kind| match serde_json::json!(kind) {
            serde_json::Value::String(name) => name,
            other => other.to_string(),
        };
        match conditions.list.get(condition) {
            Some(of) => Cause { condition: name(conditions.kind(of)), culprits: conditions.culprits(of), at },
            None => Cause { condition: name(crate::collision::Kind::Wrench), culprits: Vec::new(), at },
        }
    }
}

/// Number of conditions, wrenches included.
fn conditions_of(compiled: &CompiledScene) -> usize {
    compiled.conditions().list.len() + 1
}

/// Start and goal of a scene, as far as they are given and have one of the orientations.
fn ends(compiled: &[&CompiledScene]) -> [Option<Point>; 2] {
    let scene = compiled[0].scene();
    let kept = |turn: &Rotation| compiled.iter().any(|of| of.scene().has_orientation(turn));
    let [start, goal] = scene.end_orientations();
    [scene.start().filter(|_| kept(&start)), scene.goal().filter(|_| kept(&goal))]
}

impl Part {
    const EMPTY: Part = Part {
        volume: 0.0,
        boxes: 0,
        extent: Extent { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] },
        start: false,
        goal: false,
    };

    fn add(&mut self, span: &Cuboid, volume: f64, ends: &[Option<Point>; 2]) {
        let holds = |end: &Option<Point>| end.is_some_and(|end| span.nearest_to(&end) == end);
        self.volume += volume;
        self.boxes += 1;
        self.extent = self.extent.with(span);
        self.start |= holds(&ends[0]);
        self.goal |= holds(&ends[1]);
    }
}

impl Boxes {
    fn add(&mut self, span: &Cuboid, verdict: i64, part: Option<usize>, cause: Option<usize>) {
        let index = |index: Option<usize>| index.map_or(-1, |index| index as i64);
        self.lower.push(span.low.into());
        self.upper.push(span.high.into());
        self.verdict.push(verdict);
        self.part.push(index(part));
        self.cause.push(index(cause));
    }

    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.verdict.len()
    }

    /// Whether there are no boxes.
    pub fn is_empty(&self) -> bool {
        self.verdict.is_empty()
    }
}

impl Workspace {
    /// The unit of volumes.
    pub fn unit(&self) -> &'static str {
        match self.dimension {
            3 => "m³",
            2 => "m²",
            1 => "m",
            _ => "position",
        }
    }

    /// All but the boxes, as JSON.
    pub fn summary(&self) -> serde_json::Value {
        let mut all = serde_json::json!(Workspace { boxes: Boxes::default(), ..self.clone() });
        all["boxes"] = self.boxes.len().into();
        all
    }

    /// The workspace of a JSON text, as [`serde_json`] writes it.
    ///
    /// # Errors
    /// Text that is not a workspace.
    pub fn from_json(text: &[u8]) -> Result<Self, Error> {
        let found: Self = serde_json::from_slice(text).map_err(|e| unsound("", e))?;
        if (found.format.as_str(), found.version) != (FORMAT, VERSION) {
            return Err(unsound("format", format!("found {:?} version {}", found.format, found.version)));
        }
        let Boxes { lower, upper, verdict, part, cause } = &found.boxes;
        if [lower.len(), upper.len(), part.len(), cause.len()].iter().any(|len| *len != verdict.len()) {
            return Err(unsound("boxes", "found columns of different lengths"));
        }
        let among = |index: i64, count: usize| index >= 0 && (index as usize) < count;
        let sound = |k: usize| match verdict[k] {
            1 => among(part[k], found.parts.len()) && cause[k] == -1,
            -1 => among(cause[k], found.causes.len()) && part[k] == -1,
            0 => part[k] == -1 && cause[k] == -1,
            _ => false,
        };
        let ordered = |k: usize| (0..3).all(|axis| lower[k][axis] <= upper[k][axis]);
        if let Some(k) = (0..verdict.len()).find(|k| !sound(*k) || !ordered(*k)) {
            return Err(unsound(&format!("boxes[{k}]"), "found a verdict, index or corner that does not fit"));
        }
        Ok(found)
    }
}

fn unsound(place: &str, problem: impl std::fmt::Display) -> Error {
    Error::invalid(place, format!("{problem}; expected a workspace as cdpr writes it"))
}
