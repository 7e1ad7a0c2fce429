//! The rule of a scene for each pair of bodies: a clearance, contact allowed, or ignored. All collision checks look it
//! up here.

use std::collections::{BTreeMap, BTreeSet};

use super::body;
use super::obstacle::Obstacle;
use super::robot::Robot;
use super::spec::{PLATFORM, SceneSpec};
use crate::error::{Error, nearest_name};

/// A body or cable that can be in contact; named in pairs and in messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Member {
    /// A cable, counting from 0.
    Cable(usize),
    /// The platform.
    Platform,
    /// An obstacle, in order of first appearance.
    Obstacle(usize),
}

/// The rule of a scene for one pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PairRule {
    /// At least this distance between the surfaces of the two, m.
    Apart(f64),
    /// The two may touch but not overlap.
    Touch,
    /// The two are not checked against each other.
    Ignore,
}

/// The rules of all pairs of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct PairRules {
    platform_obstacle: f64,
    cable_obstacle: f64,
    cable_platform: f64,
    cable_cable: f64,
    named: BTreeMap<(Member, Member), PairRule>,
}

impl PairRules {
    pub(super) fn new(spec: &SceneSpec, robot: &Robot, obstacles: &[Obstacle]) -> Result<Self, Error> {
        let own = spec.clearances.clone().unwrap_or_default();
        let default = body::not_negative("clearance", spec.clearance.unwrap_or(0.0))?;
        let of_kind = |key: &str, given: Option<f64>| {
            given.map_or(Ok(default), |clearance| body::not_negative(&format!("clearances.{key}"), clearance))
        };
        let mut rules = PairRules {
            platform_obstacle: of_kind("platform_obstacle", own.platform_obstacle)?,
            cable_obstacle: of_kind("cable_obstacle", own.cable_obstacle)?,
            cable_platform: of_kind("cable_platform", own.cable_platform)?,
            cable_cable: of_kind("cable_cable", own.cable_cable)?,
            named: BTreeMap::new(),
        };
        let names = Names { robot, obstacles };
        for (key, pairs, rule) in [("ignore", &spec.ignore, PairRule::Ignore), ("touch", &spec.touch, PairRule::Touch)]
        {
            for (k, pair) in pairs.iter().enumerate() {
                rules.insert(&format!("{key}[{k}]"), pair, rule, &names)?;
            }
        }
        for (k, pair) in own.pairs.iter().enumerate() {
            let place = format!("clearances.pairs[{k}]");
            let clearance = body::not_negative(&format!("{place}.clearance"), pair.clearance)?;
            rules.insert(&format!("{place}.between"), &pair.between, PairRule::Apart(clearance), &names)?;
        }
        Ok(rules)
    }

    fn insert(&mut self, place: &str, pair: &[String; 2], rule: PairRule, names: &Names) -> Result<(), Error> {
        let [a, b] = names.pair(place, pair)?;
        match self.named.insert((a.min(b), a.max(b)), rule) {
            Some(other) if other != rule => {
                let problem = format!(
                    "found [\"{}\", \"{}\"], which {} already; expected each pair in one place only",
                    pair[0],
                    pair[1],
                    match other {
                        PairRule::Apart(clearance) => format!("has a clearance of {clearance} m"),
                        PairRule::Touch => "is listed in touch".to_string(),
                        PairRule::Ignore => "is listed in ignore".to_string(),
                    }
                );
                Err(Error::invalid(place, problem))
            }
            _ => Ok(()),
        }
    }

    /// The rule for a pair.
    pub fn between(&self, a: Member, b: Member) -> PairRule {
        let named = self.named.get(&(a.min(b), a.max(b)));
        named.copied().unwrap_or_else(|| PairRule::Apart(self.of_kind(a, b)))
    }

    /// The clearance to keep between a pair, m; 0 where contact is allowed.
    pub fn clearance(&self, a: Member, b: Member) -> f64 {
        if let PairRule::Apart(clearance) = self.between(a, b) { clearance } else { 0.0 }
    }

    /// Whether a pair is not checked.
    pub fn ignores(&self, a: Member, b: Member) -> bool {
        self.between(a, b) == PairRule::Ignore
    }

    /// The obstacles that a member ignores, for each member that ignores some; equal sets once.
    pub(super) fn ignored_obstacles(&self) -> BTreeSet<BTreeSet<usize>> {
        let mut ignored: BTreeMap<Member, BTreeSet<usize>> = BTreeMap::new();
        for ([member, other], rule) in self.named() {
            if let (Member::Obstacle(j), PairRule::Ignore) = (other, rule) {
                ignored.entry(member).or_default().insert(j);
            }
        }
        ignored.into_values().collect()
    }

    /// The clearance of this pair's kind, m, regardless of the rule for the pair itself.
    pub fn of_kind(&self, a: Member, b: Member) -> f64 {
        match (a.min(b), a.max(b)) {
            (Member::Cable(_), Member::Cable(_)) => self.cable_cable,
            (Member::Cable(_), Member::Platform) => self.cable_platform,
            (Member::Cable(_), _) => self.cable_obstacle,
            _ => self.platform_obstacle,
        }
    }

    /// The pairs with their own rules.
    pub fn named(&self) -> impl Iterator<Item = ([Member; 2], PairRule)> {
        self.named.iter().map(|((a, b), rule)| ([*a, *b], *rule))
    }

    /// The largest clearance required of any pair, m.
    pub fn largest(&self) -> f64 {
        let kinds = [self.platform_obstacle, self.cable_obstacle, self.cable_platform, self.cable_cable];
        let named =
            self.named.values().map(|rule| if let PairRule::Apart(clearance) = rule { *clearance } else { 0.0 });
        kinds.into_iter().chain(named).fold(0.0, f64::max)
    }
}

/// The names that pairs may refer to.
struct Names<'a> {
    robot: &'a Robot,
    obstacles: &'a [Obstacle],
}

impl Names<'_> {
    fn pair(&self, place: &str, pair: &[String; 2]) -> Result<[Member; 2], Error> {
        let [a, b] = [self.member(place, &pair[0])?, self.member(place, &pair[1])?];
        if a == b || matches!((a, b), (Member::Obstacle(_), Member::Obstacle(_))) {
            let problem = format!(
                "found [\"{}\", \"{}\"], expected two different members, at least one of them of the robot",
                pair[0], pair[1]
            );
            return Err(Error::invalid(place, problem));
        }
        Ok([a, b])
    }

    fn member(&self, place: &str, name: &str) -> Result<Member, Error> {
        if name == PLATFORM {
            return Ok(Member::Platform);
        }
        let cable = self.robot.cables().iter().position(|c| c.name == name).map(Member::Cable);
        let obstacle = || self.obstacles.iter().position(|o| o.name == name).map(Member::Obstacle);
        cable.or_else(obstacle).ok_or_else(|| {
            let cables = self.robot.cables().iter().map(|c| c.name.as_str());
            let known = cables.chain(self.obstacles.iter().map(|o| o.name.as_str())).chain([PLATFORM]);
            let hint = nearest_name(name, known).map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
            Error::invalid(
                place,
                format!("found \"{name}\", expected the name of a cable or obstacle, or \"platform\"{hint}"),
            )
        })
    }
}
