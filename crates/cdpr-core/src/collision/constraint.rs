//! A scene at one orientation as a list of constraints: who must keep away from whom, and how.
//!
//! Everything that does not depend on the position is settled here, once: rotated platform and attachments, which pairs
//! touch by construction, which can never keep the demanded distance. Engines only evaluate the list.

use std::collections::BTreeMap;

use super::cable_cable::CablePair;
use super::exempt::{Exemption, Reason, kept};
use super::validity::Kind;
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{Point, Polytope, Rotation, Triangle, Vector};
use crate::model::scene::PLATFORM;
use crate::model::{Member, PairRule, Scene};
use crate::numerics::{MIN_CABLE_LENGTH, ON_SURFACE, TOUCH_DEPTH};
use crate::watch::Watch;

/// How a cable must keep away from a convex body.
#[derive(Debug, Clone, PartialEq)]
pub enum Demand {
    /// At least `gap` metres between the cable's line and the body; 0: the body's interior is not entered.
    Apart {
        /// Least distance, m.
        gap: f64,
    },
    /// The body, which closes a seam, is not entered by more than `touch` metres; the parts around it keep the distance.
    Outside {
        /// Depth that still counts as touching, m.
        touch: f64,
    },
    /// The cable ends on the body's surface. It enters the body iff its direction from there goes below *every* facet
    /// that is active at that end.
    Leave {
        /// Outward unit normals of the active facets.
        normals: Vec<Vector>,
    },
}

/// One condition on the position of the platform.
#[derive(Debug, Clone, PartialEq)]
pub enum Constraint {
    /// The platform's origin stays in this box, so that every vertex stays in the workspace.
    Workspace {
        /// Smallest position, m.
        min: Point,
        /// Largest position, m.
        max: Point,
    },
    /// The cable's length stays in an interval.
    CableLength {
        /// Which cable.
        cable: usize,
        /// Shortest, m.
        min: f64,
        /// Longest, m.
        max: f64,
    },
    /// A cable keeps out of a platform body.
    CablePlatform {
        /// Which cable.
        cable: usize,
        /// Index into [`Constraints::platform`].
        body: usize,
        /// How.
        demand: Demand,
    },
    /// Two cables keep from each other.
    CableCable(CablePair),
    /// A platform part keeps `gap` away from an obstacle body.
    PlatformObstacle {
        /// Index into [`Constraints::platform`].
        part: usize,
        /// Index into [`Constraints::obstacles`].
        body: usize,
        /// Least distance, m.
        gap: f64,
    },
    /// A cable keeps out of an obstacle body.
    CableObstacle {
        /// Which cable.
        cable: usize,
        /// Index into [`Constraints::obstacles`].
        body: usize,
        /// How.
        demand: Demand,
    },
}

/// A cable at fixed orientation.
#[derive(Debug, Clone, PartialEq)]
pub struct CableAt {
    /// Outlet, world, m.
    pub outlet: Point,
    /// From the platform's origin to the attachment, world axes, m.
    pub arm: Vector,
    /// Half the diameter, m.
    pub radius: f64,
    /// Name.
    pub name: String,
}

impl CableAt {
    /// The triangle swept in the world while the platform's origin goes from one position to another.
    #[inline]
    pub fn sweep(&self, from: &Point, to: &Point) -> Triangle {
        Triangle::new(self.outlet, from + self.arm, to + self.arm)
    }

    /// The triangle swept as seen from the platform, which then stands still at the origin.
    #[inline]
    pub fn sweep_seen_from_platform(&self, from: &Point, to: &Point) -> Triangle {
        Triangle::new(Point::from(self.arm), self.outlet - from.coords, self.outlet - to.coords)
    }
}

/// A convex obstacle body with the obstacle it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct ObstacleBody {
    /// Convex body, world, m.
    pub body: Polytope,
    /// Index into [`Scene::obstacles`]; two, maybe equal, for the seam between parts.
    pub between: [usize; 2],
    /// For a body that closes a seam: its inside is forbidden, deeper than this, m, but distances are those of the parts
    /// around it.
    pub seam: Option<f64>,
    /// Name of the obstacle.
    pub name: String,
}

impl ObstacleBody {
    fn ignored(&self, scene: &Scene, member: Member) -> bool {
        self.between.iter().any(|j| scene.pairs().ignores(member, Member::Obstacle(*j)))
    }

    fn member(&self) -> Member {
        Member::Obstacle(self.between[0])
    }
}

/// All constraints of a scene at one orientation; see the module.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraints {
    /// Cables.
    pub cables: Vec<CableAt>,
    /// Platform parts, then the seams between them, world axes, platform's origin at zero.
    pub platform: Vec<Polytope>,
    /// Obstacle parts and seams.
    pub obstacles: Vec<ObstacleBody>,
    /// The conditions, cheap ones first.
    pub list: Vec<Constraint>,
    /// Pairs that are not held to the clearance of their kind.
    pub exempt: Vec<Exemption>,
    /// What else the user should know about how the scene is taken.
    pub notes: Vec<String>,
}

impl Constraint {
    /// Whether it asks for a distance from a body, not only for not entering it.
    pub fn demands_distance(&self) -> bool {
        match self {
            Constraint::PlatformObstacle { gap, .. } => *gap > 0.0,
            Constraint::CableObstacle { demand: Demand::Apart { gap }, .. }
            | Constraint::CablePlatform { demand: Demand::Apart { gap }, .. } => *gap > 0.0,
            Constraint::CableCable(pair) => pair.gap > 0.0,
            _ => false,
        }
    }
}

/// What is to be said where a scene names several orientations and says none.
fn open_orientation(scene: &Scene) -> Option<String> {
    let name = scene.orientation_name().filter(|_| scene.orientation_is_open())?;
    Some(format!(
        "the scene names several orientations and says none: but for planning it is taken at \"{name}\", the first"
    ))
}

impl Constraints {
    /// The constraints of a scene at its orientation.
    ///
    /// # Errors
    /// None today.
    pub fn new(scene: &Scene) -> Result<Self, Error> {
        Self::within(scene, &Watch::NONE)
    }

    /// As [`Constraints::new`], within a watch.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn within(scene: &Scene, watch: &Watch) -> Result<Self, Error> {
        let rotation = scene.orientation();
        let robot = scene.robot();
        let turned = |body: &Polytope| body.transformed(rotation, &Vector::zeros());
        let mut constraints = Constraints {
            cables: cables_at(scene, rotation),
            platform: robot.parts().iter().chain(robot.seams().iter().map(|s| &s.body)).map(turned).collect(),
            obstacles: obstacle_bodies(scene),
            list: Vec::new(),
            exempt: Vec::new(),
            notes: scene.notes().iter().cloned().chain(open_orientation(scene)).collect(),
        };
        constraints.workspace(scene);
        constraints.cable_lengths(scene);
        constraints.cable_platform(scene, watch)?;
        constraints.cable_cable(scene);
        constraints.platform_obstacle(scene);
        constraints.cable_obstacle(scene, watch)?;
        constraints.exempt_by_name(scene);
        Ok(constraints)
    }

    /// The condition a constraint belongs to.
    pub fn kind(&self, constraint: &Constraint) -> Kind {
        match constraint {
            Constraint::Workspace { .. } => Kind::Workspace,
            Constraint::CableLength { .. } => Kind::CableLength,
            Constraint::CablePlatform { .. } => Kind::CablePlatform,
            Constraint::CableCable(_) => Kind::CableCable,
            Constraint::PlatformObstacle { .. } => Kind::PlatformObstacle,
            Constraint::CableObstacle { .. } => Kind::CableObstacle,
        }
    }

    /// The names of those whom a constraint is about.
    pub fn culprits(&self, constraint: &Constraint) -> Vec<String> {
        self.members(constraint).iter().map(|member| self.name(*member).to_string()).collect()
    }

    fn name(&self, member: Member) -> &str {
        match member {
            Member::Cable(i) => &self.cables[i].name,
            Member::Platform => PLATFORM,
            Member::Obstacle(_) => {
                &self.obstacles.iter().find(|o| o.member() == member).expect("every obstacle has a part").name
            }
        }
    }

    /// Those whom a constraint is about: two, or one that it limits by itself.
    pub fn members(&self, constraint: &Constraint) -> Vec<Member> {
        match constraint {
            Constraint::Workspace { .. } => vec![Member::Platform],
            Constraint::CableLength { cable, .. } => vec![Member::Cable(*cable)],
            Constraint::CablePlatform { cable, .. } => vec![Member::Cable(*cable), Member::Platform],
            Constraint::CableCable(pair) => vec![Member::Cable(pair.first), Member::Cable(pair.second)],
            Constraint::PlatformObstacle { body, .. } => vec![Member::Platform, self.obstacles[*body].member()],
            Constraint::CableObstacle { cable, body, .. } => {
                vec![Member::Cable(*cable), self.obstacles[*body].member()]
            }
        }
    }

    /// The gap of surfaces that a constraint demands, m: 0 or less where they must only not touch; none where it is not
    /// about a distance, but about ends that touch by construction, seams, or room.
    pub fn required(&self, constraint: &Constraint) -> Option<f64> {
        match constraint {
            Constraint::CableCable(pair) => Some(pair.gap - pair.radii),
            Constraint::PlatformObstacle { body, gap, .. } => self.obstacles[*body].seam.is_none().then_some(*gap),
            Constraint::CablePlatform { cable, demand: Demand::Apart { gap }, .. }
            | Constraint::CableObstacle { cable, demand: Demand::Apart { gap }, .. } => {
                Some(gap - self.cables[*cable].radius)
            }
            _ => None,
        }
    }

    /// What the user should know: the notes, and which pairs cannot keep what the scene demands.
    pub fn remarks(&self) -> Vec<String> {
        let unattainable = self.exempt.iter().filter(|e| e.reason == Reason::Unattainable);
        self.notes.iter().cloned().chain(unattainable.map(Exemption::sentence)).collect()
    }

    /// The box of positions where the platform is inside the workspace; it may be empty (min > max).
    pub fn position_box(&self) -> (Point, Point) {
        match &self.list[0] {
            Constraint::Workspace { min, max } => (*min, *max),
            _ => unreachable!("the workspace is the first constraint"),
        }
    }

    fn workspace(&mut self, scene: &Scene) {
        let vertices = || self.platform.iter().flat_map(|part| part.vertices());
        let low = vertices().fold(Vector::repeat(f64::INFINITY), |low, v| low.inf(&v.coords));
        let high = vertices().fold(Vector::repeat(f64::NEG_INFINITY), |high, v| high.sup(&v.coords));
        let (mut min, mut max) = (scene.workspace().min - low, scene.workspace().max - high);
        for axis in 0..3 {
            // A platform as large as the workspace has one place there; rounding must not take it away.
            if max[axis] < min[axis] && min[axis] - max[axis] <= TOUCH_DEPTH {
                let middle = 0.5 * (min[axis] + max[axis]);
                (min[axis], max[axis]) = (middle, middle);
            }
        }
        self.list.push(Constraint::Workspace { min, max });
    }

    fn cable_lengths(&mut self, scene: &Scene) {
        for (cable, model) in scene.robot().cables().iter().enumerate() {
            let [min, max] = model.length.unwrap_or([0.0, f64::INFINITY]);
            self.list.push(Constraint::CableLength { cable, min: min.max(MIN_CABLE_LENGTH), max });
        }
    }

    fn cable_platform(&mut self, scene: &Scene, watch: &Watch) -> Result<(), Error> {
        for cable in 0..self.cables.len() {
            watch.check()?;
            if scene.pairs().ignores(Member::Cable(cable), Member::Platform) {
                continue;
            }
            let clearance = scene.pairs().clearance(Member::Cable(cable), Member::Platform);
            for body in 0..self.platform.len() {
                let seam = body.checked_sub(scene.robot().parts().len()).map(|k| scene.robot().seams()[k].touch);
                if let Some(demand) = self.demand_of_part(cable, body, seam, clearance) {
                    self.list.push(Constraint::CablePlatform { cable, body, demand });
                }
            }
        }
        Ok(())
    }

    fn demand_of_part(&mut self, cable: usize, body: usize, seam: Option<f64>, clearance: f64) -> Option<Demand> {
        let CableAt { arm, radius, .. } = self.cables[cable];
        let attachment = Point::from(arm);
        let part = &self.platform[body];
        let distance = shape_distance(&Triangle::new(attachment, attachment, attachment), part).distance;
        if distance <= ON_SURFACE {
            // A plate, a segment or a point has no interior that the cable could enter.
            return part.has_volume().then(|| Demand::Leave { normals: part.active_normals(&attachment) });
        }
        if let Some(touch) = seam {
            return Some(Demand::Outside { touch });
        }
        Some(self.apart([Member::Cable(cable), Member::Platform], [clearance, radius, distance]))
    }

    /// A distance to keep from a body that is at most `attainable` away, as far as that goes; the rest is exempt.
    fn apart(&mut self, members: [Member; 2], [clearance, radius, attainable]: [f64; 3]) -> Demand {
        self.exempt_if_unattainable(members, [clearance, radius, attainable]);
        Demand::Apart { gap: kept(clearance, radius, attainable) }
    }

    /// Notes that the next constraint, which is about this pair, demands less than the scene does, if so.
    fn exempt_if_unattainable(&mut self, members: [Member; 2], [clearance, radii, attainable]: [f64; 3]) {
        if clearance + radii <= attainable {
            return;
        }
        let (index, attainable) = (self.list.len(), attainable - radii);
        // Constraints come in the order of their first members.
        let mut latest = self.exempt.iter_mut().rev().take_while(|known| known.members[0] == members[0]);
        if let Some(known) = latest.find(|known| known.members == members) {
            known.attainable = known.attainable.map(|best| best.min(attainable));
            known.constraints.push(index);
            return;
        }
        self.exempt.push(Exemption {
            pair: members.map(|member| self.name(member).to_string()),
            reason: Reason::Unattainable,
            demanded: clearance,
            attainable: Some(attainable),
            members,
            constraints: vec![index],
        });
    }

    /// Lists the pairs that the scene lets touch, or has unchecked.
    fn exempt_by_name(&mut self, scene: &Scene) {
        let mut listed: BTreeMap<[Member; 2], Exemption> = BTreeMap::new();
        for (members, rule) in scene.pairs().named() {
            let reason = match rule {
                PairRule::Apart(_) => continue,
                PairRule::Touch => Reason::Touch,
                PairRule::Ignore => Reason::Ignore,
            };
            let exemption = Exemption {
                pair: members.map(|member| scene.member_name(member).to_string()),
                reason,
                demanded: scene.pairs().of_kind(members[0], members[1]),
                attainable: None,
                members,
                constraints: Vec::new(),
            };
            listed.insert(members, exemption);
        }
        if listed.values().any(|exemption| exemption.reason == Reason::Touch) {
            for (index, constraint) in self.list.iter().enumerate() {
                if let ([a, b], Some(_)) = (&self.members(constraint)[..], self.required(constraint))
                    && let Some(exemption) = listed.get_mut(&[*a.min(b), *a.max(b)])
                {
                    exemption.constraints.push(index);
                }
            }
        }
        self.exempt.extend(listed.into_values());
    }

    fn cable_cable(&mut self, scene: &Scene) {
        for first in 0..self.cables.len() {
            for second in first + 1..self.cables.len() {
                let members = [Member::Cable(first), Member::Cable(second)];
                if scene.pairs().ignores(members[0], members[1]) {
                    continue;
                }
                let clearance = scene.pairs().clearance(members[0], members[1]);
                let Some(pair) = CablePair::new(&self.cables, first, second, clearance) else { continue };
                if pair.always_crossing() {
                    let [first, second] = [first, second].map(|k| &self.cables[k].name);
                    self.notes.push(format!("{first} and {second} cross at every position"));
                } else {
                    self.exempt_if_unattainable(members, [clearance, pair.radii, pair.best_gap]);
                }
                self.list.push(Constraint::CableCable(pair));
            }
        }
    }

    fn platform_obstacle(&mut self, scene: &Scene) {
        for (body, obstacle) in self.obstacles.iter().enumerate() {
            if obstacle.ignored(scene, Member::Platform) {
                continue;
            }
            for part in 0..scene.robot().parts().len() {
                // A part with volume that reaches into a seam reaches into the parts on both sides of it.
                if obstacle.seam.is_some() && self.platform[part].has_volume() {
                    continue;
                }
                let gap = match obstacle.seam {
                    Some(_) => 0.0,
                    None => scene.pairs().clearance(Member::Platform, obstacle.member()),
                };
                self.list.push(Constraint::PlatformObstacle { part, body, gap });
            }
        }
    }

    fn cable_obstacle(&mut self, scene: &Scene, watch: &Watch) -> Result<(), Error> {
        for cable in 0..self.cables.len() {
            watch.check()?;
            for body in 0..self.obstacles.len() {
                if !self.obstacles[body].ignored(scene, Member::Cable(cable)) {
                    let clearance = scene.pairs().clearance(Member::Cable(cable), self.obstacles[body].member());
                    let demand = self.demand_of_obstacle(cable, body, clearance);
                    self.list.push(Constraint::CableObstacle { cable, body, demand });
                }
            }
        }
        Ok(())
    }

    fn demand_of_obstacle(&mut self, cable: usize, body: usize, clearance: f64) -> Demand {
        let CableAt { outlet, radius, ref name, .. } = self.cables[cable];
        let obstacle = &self.obstacles[body];
        let normals = obstacle.body.active_normals(&outlet);
        if !normals.is_empty() {
            return Demand::Leave { normals };
        }
        if let Some(touch) = obstacle.seam {
            return Demand::Outside { touch };
        }
        let (gap, distance) =
            (clearance + radius, shape_distance(&Triangle::new(outlet, outlet, outlet), &obstacle.body).distance);
        let carries = |b: &ObstacleBody| b.between == obstacle.between && !b.body.active_normals(&outlet).is_empty();
        // A neighbouring part of the body that the winch is bolted to can be as near as it is.
        if distance >= gap || self.obstacles.iter().any(carries) {
            let members = [Member::Cable(cable), obstacle.member()];
            return self.apart(members, [clearance, radius, distance]);
        }
        self.notes.push(format!(
            "the outlet of {name} is {distance:.4} m from {other} and can never keep {gap:.4} m from it: every position \
             is refused; give the pair a smaller clearance in [[clearances.pairs]], or let it touch: \
             touch = [[\"{name}\", \"{other}\"]]",
            other = obstacle.name
        ));
        Demand::Apart { gap }
    }
}

fn cables_at(scene: &Scene, rotation: &Rotation) -> Vec<CableAt> {
    let at = |cable: &crate::model::Cable| CableAt {
        outlet: cable.outlet,
        arm: rotation * cable.attachment.coords,
        radius: 0.5 * cable.diameter,
        name: cable.name.clone(),
    };
    scene.robot().cables().iter().map(at).collect()
}

fn obstacle_bodies(scene: &Scene) -> Vec<ObstacleBody> {
    let body = |body: &Polytope, between: [usize; 2], seam| {
        let name = scene.obstacles()[between[0]].name.clone();
        ObstacleBody { body: body.clone(), between, seam, name }
    };
    let parts = scene.obstacles().iter().enumerate().flat_map(|(j, o)| o.parts.iter().map(move |part| (j, part)));
    let parts = parts.map(|(j, part)| body(part, [j, j], None));
    parts.chain(scene.seams().iter().map(|s| body(&s.body, s.between, Some(s.touch)))).collect()
}
