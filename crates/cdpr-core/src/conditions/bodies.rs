//! The bodies of a scene at one orientation, independent of the platform's position.

use std::sync::Arc;

use serde::Serialize;

use crate::geometry::seam::Gap;
use crate::geometry::{CableSweep, Fan, Placed, Point, Polytope, Pulley, Rotation, Triangle, Vector, largest_distance};
use crate::model::spec::PLATFORM;
use crate::model::{Envelope, Member, Scene};
use crate::words::small_length;

/// How far the cables of a condition can be from straight lines from their outlets, where they may break it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Shapes {
    /// How much lower a cable can hang, m.
    pub sag: f64,
    /// How far from its outlet it can leave the frame, m.
    pub exit: f64,
}

impl Shapes {
    /// Describes the shapes: " (the cable can hang 38.0 mm lower, and leave the frame up to 5.0 mm from its outlet)".
    pub fn sentence(&self) -> String {
        let sag = (self.sag > 0.0).then(|| format!("hang {} lower", small_length(self.sag)));
        let exit =
            (self.exit > 0.0).then(|| format!("leave the frame up to {} from its outlet", small_length(self.exit)));
        let said: Vec<String> = sag.into_iter().chain(exit).collect();
        if said.is_empty() { String::new() } else { format!(" (the cable can {})", said.join(", and ")) }
    }
}

/// A cable at fixed orientation.
#[derive(Debug, Clone, PartialEq)]
pub struct CableAt {
    /// Outlet, world, m.
    pub outlet: Point,
    /// From the platform's origin to the attachment, world axes, m.
    pub arm: Vector,
    /// Radius of the cable, m.
    pub radius: f64,
    /// Name of the cable.
    pub name: String,
    /// All shapes of the cable, if it is not a straight line from its outlet.
    pub envelope: Option<Arc<Envelope>>,
    /// The pulley at the outlet, if there is one.
    pub pulley: Option<Pulley>,
}

impl CableAt {
    /// The triangle that the cable sweeps in the world while the platform's origin moves between two positions.
    #[inline]
    pub fn sweep(&self, from: &Point, to: &Point) -> Triangle {
        Triangle::new(self.outlet, from + self.arm, to + self.arm)
    }

    /// What the cable sweeps in the platform's frame, in which the platform stands still at the origin.
    #[inline]
    pub fn sweep_seen_from_platform(&self, from: &Point, to: &Point) -> CableSweep<'_> {
        let end = Point::from(self.arm);
        match &self.envelope {
            None => CableSweep::Straight(Triangle::new(end, self.outlet - from.coords, self.outlet - to.coords)),
            Some(envelope) => CableSweep::Fan(Fan {
                points: envelope.lowered_exits.vertices(),
                copies: [(1.0, -from.coords), (1.0, -to.coords), (1.0, -to.coords)],
                ends: [end; 4],
            }),
        }
    }

    /// Greatest sag of the cable with its attachment within a distance of a point, m.
    #[inline]
    pub fn sag(&self, end: &Point, around: f64) -> f64 {
        let sag = self.envelope.as_ref().and_then(|envelope| envelope.sag);
        sag.map_or(0.0, |sag| sag.deepest_of(self.chord(end) + around))
    }

    /// Greatest length of the chord with the attachment at a point, m.
    #[inline]
    pub fn chord(&self, end: &Point) -> f64 {
        (end - self.outlet).norm() + self.exit_error()
    }

    /// Greatest distance of a point where the cable can leave the frame from its outlet, m.
    #[inline]
    pub fn exit_error(&self) -> f64 {
        self.envelope.as_ref().map_or(0.0, |envelope| envelope.exit_error)
    }

    /// The corners of the hull of all shapes of the cable that hang at most this deep: shares of the way from exit to attachment, and
    /// displacements.
    pub fn outline(&self, depth: f64) -> [(f64, Vector); 4] {
        let sag = self.envelope.as_ref().and_then(|envelope| envelope.sag);
        let below = sag.map_or(Vector::zeros(), |sag| sag.up * -depth);
        [(0.0, Vector::zeros()), (0.25, below), (0.75, below), (1.0, Vector::zeros())]
    }

    /// The points where the cable can leave the frame.
    pub fn exits(&self) -> &[Point] {
        self.envelope.as_ref().map_or(std::slice::from_ref(&self.outlet), |envelope| &envelope.exits)
    }

    /// The mean of the points where the cable can leave the frame.
    pub fn middle_exit(&self) -> Point {
        self.envelope.as_ref().map_or(self.outlet, |envelope| envelope.middle)
    }

    /// The hull of all shapes of the cable that hang at most this deep with its attachment at a point.
    pub fn shapes(&self, end: &Point, depth: f64) -> Fan<'_> {
        let [first, second, third, _] = self.outline(depth).map(|(share, by)| (1.0 - share, end.coords * share + by));
        Fan { points: self.exits(), copies: [first, second, third], ends: [*end; 4] }
    }

    /// How much lower than the direction from the attachment to the outlet the cable can leave the platform, along a normal, m
    /// at the outlet.
    #[inline]
    pub fn lower_at_platform(&self, normal: &Vector) -> f64 {
        let lowest = |envelope: &Arc<Envelope>| {
            let heights = envelope.lowered_exits.vertices().iter().map(|exit| normal.dot(&(exit - self.outlet)));
            -heights.fold(f64::INFINITY, f64::min)
        };
        self.envelope.as_ref().map_or(0.0, lowest)
    }
}

/// A convex obstacle body with the obstacle it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct ObstacleBody {
    /// Convex body, world, m.
    pub body: Polytope,
    /// Index into [`Scene::obstacles`]; for a seam, of all obstacles around it, in ascending order.
    pub between: Vec<usize>,
    /// For a body that closes a seam: what it closes. Clearances are measured to the adjacent parts only.
    pub seam: Option<Gap>,
    /// Name of the obstacle.
    pub name: String,
}

impl ObstacleBody {
    /// Whether the scene ignores contact of this obstacle with a member.
    pub(super) fn ignored(&self, scene: &Scene, member: Member) -> bool {
        self.between.iter().any(|j| scene.pairs().ignores(member, Member::Obstacle(*j)))
    }

    /// The obstacle that the body belongs to; for a seam, the first of the obstacles around it.
    pub fn member(&self) -> Member {
        Member::Obstacle(self.between[0])
    }
}

/// The bodies of a scene at one orientation.
#[derive(Debug, Clone, PartialEq)]
pub struct Bodies {
    /// Cables of the robot.
    pub cables: Vec<CableAt>,
    /// Platform parts, then the seams between them, world axes, platform's origin at zero.
    pub platform: Vec<Polytope>,
    /// How many of [`Bodies::platform`] are parts; the rest close seams.
    pub platform_parts: usize,
    /// Distance of each of [`Bodies::platform`] from the platform's origin, to its farthest corner, m.
    pub platform_reach: Vec<f64>,
    /// Obstacle parts and seams.
    pub obstacles: Vec<ObstacleBody>,
}

impl Bodies {
    /// The bodies of a scene at its orientation.
    pub fn of(scene: &Scene) -> Self {
        let rotation = scene.orientation();
        let robot = scene.robot();
        let turned = |body: &Polytope| body.transformed(rotation, &Vector::zeros());
        let platform: Vec<Polytope> =
            robot.parts().iter().chain(robot.seams().iter().map(|s| &s.body)).map(turned).collect();
        let reach = |body: &Polytope| largest_distance(body.vertices(), &Point::origin());
        Bodies {
            cables: cables_at(scene, rotation),
            platform_reach: platform.iter().map(reach).collect(),
            platform,
            platform_parts: robot.parts().len(),
            obstacles: obstacle_bodies(scene),
        }
    }

    /// How far these cables can be from straight lines from their outlets at two poses of the platform; `None` if they are straight.
    pub fn shapes_of(&self, cables: &[usize], ends: &[Placed; 2]) -> Option<Shapes> {
        let known = cables.iter().filter_map(|&k| Some((&self.cables[k], self.cables[k].envelope.as_ref()?)));
        let sag = |cable: &CableAt| ends.iter().map(|at| cable.sag(&at.point(&cable.arm), 0.0)).fold(0.0, f64::max);
        let shapes = known.map(|(cable, envelope)| Shapes { sag: sag(cable), exit: envelope.exit_error });
        shapes.reduce(|a, b| Shapes { sag: a.sag.max(b.sag), exit: a.exit.max(b.exit) })
    }

    /// Distance from the platform's origin to the farthest corner or attachment, m.
    pub fn reach(&self) -> f64 {
        let arms = self.cables.iter().map(|cable| cable.arm.norm());
        arms.chain(self.platform_reach.iter().copied()).fold(0.0, f64::max)
    }

    /// The name of a member.
    pub fn name(&self, member: Member) -> &str {
        match member {
            Member::Cable(i) => &self.cables[i].name,
            Member::Platform => PLATFORM,
            Member::Obstacle(_) => {
                &self.obstacles.iter().find(|o| o.member() == member).expect("every obstacle has a part").name
            }
        }
    }
}

fn cables_at(scene: &Scene, rotation: &Rotation) -> Vec<CableAt> {
    let at = |(cable, envelope): (&crate::model::Cable, &Option<Arc<Envelope>>)| CableAt {
        outlet: cable.outlet,
        arm: rotation * cable.attachment.coords,
        radius: 0.5 * cable.diameter,
        name: cable.name.clone(),
        envelope: envelope.clone(),
        pulley: cable.pulley,
    };
    scene.robot().cables().iter().zip(scene.envelopes()).map(at).collect()
}

fn obstacle_bodies(scene: &Scene) -> Vec<ObstacleBody> {
    let body = |body: &Polytope, between: Vec<usize>, seam| {
        let name = scene.obstacles()[between[0]].name.clone();
        ObstacleBody { body: body.clone(), between, seam, name }
    };
    let parts = scene.obstacles().iter().enumerate().flat_map(|(j, o)| o.parts.iter().map(move |part| (j, part)));
    let parts = parts.map(|(j, part)| body(part, vec![j], None));
    parts.chain(scene.seams().iter().map(|s| body(&s.body, s.between.clone(), Some(s.gap)))).collect()
}
