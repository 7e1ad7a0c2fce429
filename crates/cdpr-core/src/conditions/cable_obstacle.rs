//! Cables stay clear of obstacles.
//!
//! The forbidden positions are the shadow of the obstacle seen from the outlet B, moved by minus the arm R a. If the
//! outlet is on the obstacle, they are the cone of directions below all facets that are active there.
//!
//! A cable that can take several shapes must stay clear of the obstacle in all of them. It can leave the frame anywhere in a
//! convex set E, so the shadow is seen from E. It hangs below its chord by at most κ a b, where a and b are the distances along
//! the chord from both ends (`Sag`). A line from the exit lowered by κ r L, with L the greatest length and r the greatest distance
//! of the obstacle from E, is lower than the chord by κ r L b / (a + b), and so below the cable wherever it can reach the obstacle.
//! There the cable is in the hull of E, E lowered by that, and the attachment. Near the outlet the line from the lowered exit is
//! far too low, and the other end counts lowered instead, by κ (L - a) L for the least a. Both sets of forbidden positions are convex
//! polyhedra. An obstacle that carries the outlet is seen from the outlet alone.

use std::cell::LazyCell;
use std::sync::Arc;

use super::bodies::{Bodies, CableAt, Shapes};
use super::cable_and_body::{CABLE, CableDemand, rounded_shadow};
use super::exempt::Remarks;
use super::fattened::Fattened;
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{ForbiddenPolyhedron, Region, Scale};
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{
    Aabb, CableSweep, Cone, ConvexShape, Fan, HalfSpace, Placed, Point, Polytope, Shadow, Triangle, TurningPiece,
    Vector, shadow,
};
use crate::model::{Envelope, Member, Scene};
use crate::watch::Watch;

/// A cable stays clear of an obstacle body.
#[derive(Debug, Clone, PartialEq)]
pub struct CableObstacle {
    /// Index of the cable.
    pub cable: usize,
    /// Index into [`Bodies::obstacles`].
    pub body: usize,
    /// How the cable must stay clear of the body.
    pub demand: CableDemand,
    /// All shapes of the cable near this body, if it is not a straight line from its outlet.
    pub hanging: Option<Arc<Hanging>>,
}

/// All shapes of a cable near an obstacle body: there, it lies in the hull of a convex set, its attachment, and the attachment
/// lowered.
#[derive(Debug, Clone, PartialEq)]
pub struct Hanging {
    /// The points where the cable leaves the frame and, if the exits count lowered, those below them.
    exits: Arc<[Point]>,
    /// By what the attachment counts lowered, m.
    lower: Vector,
    /// The distances from the exits, m, between which the cable can be near the body.
    reach: [f64; 2],
    /// Whether the body carries the outlet.
    carried: bool,
}

impl Hanging {
    /// The shapes of a cable that may come within `gap` of a body; one that carries the outlet if `carried`.
    fn near(body: &Polytope, envelope: &Envelope, outlet: &Point, gap: f64, carried: bool) -> Self {
        let exits = if carried { Arc::from([*outlet]) } else { envelope.exits.clone() };
        let Some(sag) = &envelope.sag else {
            return Hanging { exits, lower: Vector::zeros(), reach: [0.0; 2], carried };
        };
        let whole = body.aabb().swept(&Vector::zeros(), &(sag.up * sag.deepest()));
        let room = Aabb::around(&exits);
        let near = whole.distance(&room) - gap;
        let far = exits.iter().flat_map(|e| body.vertices().iter().map(move |v| (v - e).norm_squared()));
        let far = far.fold(0.0, f64::max).sqrt() + sag.deepest() + gap;
        let reached = whole.widened(gap).common(&envelope.chords);
        let far = reached.map_or(0.0, |reached| reached.farthest(&room).min(far));
        let fall = sag.lowering(far);
        let (exits, lower) = if near > NEAR * fall && !carried {
            (envelope.exits_lowered(fall), Vector::zeros())
        } else {
            (exits, sag.up * sag.lowering(sag.longest - near))
        };
        Hanging { exits, lower, reach: [near, far], carried }
    }

    /// What the chords sweep while the attachment moves between two points.
    fn sweep(&self, [from, to]: [Point; 2]) -> Fan<'_> {
        let ends = [from, to, from - self.lower, to - self.lower];
        Fan { points: &self.exits, copies: [Fan::AS_IT_IS; 3], ends }
    }

    /// How much lower than the chord the cable can leave the outlet, along a normal, m at the attachment.
    fn lower(&self, normal: &Vector) -> f64 {
        normal.dot(&self.lower).max(0.0)
    }

    /// The points where the cable cannot end because of an obstacle; `obstacle` is the body fattened by the distance to keep.
    fn shadow(&self, obstacle: &Polytope) -> Option<Shadow> {
        if self.lower == Vector::zeros() {
            return match *self.exits {
                [apex] => shadow(obstacle, &apex),
                _ => Some(Cone::from(obstacle, &self.exits)?.added_to(obstacle, &[])),
            };
        }
        let cone = Cone::from(obstacle, &self.exits)?;
        Some(cone.added_to(&obstacle.swept(&self.lower).ok()?, &[self.lower.normalize()]))
    }
}

/// The exits count lowered if the obstacle is farther from them than this multiple of it; otherwise the attachment does.
const NEAR: f64 = 2.0;

impl CableObstacle {
    /// The condition on a cable and an obstacle body, at `index` in the list; `carried` tells whether the obstacle carries the
    /// outlet.
    fn of(
        [index, cable, body]: [usize; 3],
        bodies: &Bodies,
        clearance: f64,
        carried: impl Fn() -> bool,
        remarks: &mut Remarks,
    ) -> Self {
        let CableAt { outlet, radius, ref name, ref envelope, .. } = bodies.cables[cable];
        let obstacle = &bodies.obstacles[body];
        let hanging = envelope
            .as_ref()
            .map(|envelope| Arc::new(Hanging::near(&obstacle.body, envelope, &outlet, clearance + radius, carried())));
        let with = |demand: CableDemand| CableObstacle { cable, body, demand, hanging: hanging.clone() };
        let normals = obstacle.body.active_normals(&outlet);
        if !normals.is_empty() {
            return with(CableDemand::Leave { normals });
        }
        if let Some(gap) = obstacle.seam {
            return with(CableDemand::Outside { touch: gap.touch });
        }
        let (gap, distance) = (
            clearance + radius,
            match &hanging {
                None => shape_distance(&Triangle::new(outlet, outlet, outlet), &obstacle.body).distance,
                Some(hanging) => shape_distance(&Fan::around(&hanging.exits), &obstacle.body).signed(),
            },
        );
        // A neighbouring part of the body that the winch is bolted to may be closer than the clearance.
        if distance >= gap || carried() {
            let pair = (index, [Member::Cable(cable), obstacle.member()]);
            return with(CableDemand::Apart { gap: remarks.kept(bodies, pair, [clearance, radius, distance]) });
        }
        remarks.notes.push(format!(
            "the outlet of {name} is {distance:.4} m from {other}{off} and can never keep {gap:.4} m from it: every position \
             is refused; give the pair a smaller clearance in [[clearances.pairs]], or let it touch: \
             touch = [[\"{name}\", \"{other}\"]]",
            off = if hanging.is_some() { ", where it is nearest," } else { "" },
            other = obstacle.name
        ));
        with(CableDemand::Apart { gap })
    }
}

impl CableObstacle {
    /// The obstacle body.
    fn obstacle<'a>(&self, bodies: &'a Bodies) -> &'a Polytope {
        &bodies.obstacles[self.body].body
    }

    /// What the cable's chord sweeps while its attachment moves between two points.
    #[inline]
    fn sweep(&self, bodies: &Bodies, [from, to]: [Point; 2]) -> CableSweep<'_> {
        match &self.hanging {
            None => CableSweep::Straight(Triangle::new(bodies.cables[self.cable].outlet, from, to)),
            Some(hanging) => CableSweep::Fan(hanging.sweep([from, to])),
        }
    }

    /// A distance of the surfaces, m, while the attachment moves between two points, reduced if the cable can take shapes that come nearer,
    /// but not within the required distance: only those that do count in the condition.
    fn with_shapes_beyond(&self, bodies: &Bodies, gap: f64, ends: [Point; 2]) -> f64 {
        let cable = &bodies.cables[self.cable];
        let (Some(hanging), Some(envelope)) = (&self.hanging, &cable.envelope) else { return gap };
        if envelope.sag.is_none() || gap <= self.required(bodies) {
            return gap;
        }
        let obstacle = self.obstacle(bodies);
        let wider = Hanging::near(obstacle, envelope, &cable.outlet, gap + cable.radius, hanging.carried);
        gap.min(shape_distance(&wider.sweep(ends), obstacle).signed() - cable.radius)
    }

    /// How much lower than its chord the cable can leave the outlet, along a normal, m at the attachment.
    #[inline]
    fn lower(&self, normal: &Vector) -> f64 {
        self.hanging.as_ref().map_or(0.0, |hanging| hanging.lower(normal))
    }
}

impl PhysicalCondition for CableObstacle {
    fn all(
        scene: &Scene,
        bodies: &Bodies,
        first: usize,
        remarks: &mut Remarks,
        watch: &Watch,
    ) -> Result<Vec<Self>, Error> {
        let mut all = Vec::new();
        for cable in 0..bodies.cables.len() {
            watch.check()?;
            let outlet = &bodies.cables[cable].outlet;
            let carrying: LazyCell<Vec<&Vec<usize>>, _> = LazyCell::new(|| {
                let on = bodies.obstacles.iter().filter(|b| !b.body.active_normals(outlet).is_empty());
                on.map(|b| &b.between).collect()
            });
            for (body, obstacle) in bodies.obstacles.iter().enumerate() {
                let carried = || carrying.contains(&&obstacle.between);
                let is_needed = obstacle.seam.is_none_or(|gap| gap.admits(CABLE));
                if is_needed && !obstacle.ignored(scene, Member::Cable(cable)) {
                    let clearance = scene.pairs().clearance(Member::Cable(cable), obstacle.member());
                    let place = [first + all.len(), cable, body];
                    all.push(CableObstacle::of(place, bodies, clearance, carried, remarks));
                }
            }
        }
        Ok(all)
    }

    fn sentence(found: &Broken) -> String {
        found.meets(found.name(0), found.name(1))
    }

    fn kind(&self) -> Kind {
        Kind::CableObstacle
    }

    fn members(&self, bodies: &Bodies) -> Vec<Member> {
        vec![Member::Cable(self.cable), bodies.obstacles[self.body].member()]
    }

    fn obstacle_mut(&mut self) -> Option<&mut usize> {
        Some(&mut self.body)
    }

    fn obstacles(&self, bodies: &Bodies) -> Vec<usize> {
        bodies.obstacles[self.body].between.clone()
    }

    fn closes_seam(&self, bodies: &Bodies) -> bool {
        bodies.obstacles[self.body].seam.is_some()
    }

    fn is_seam_beside(&self, other: &dyn PhysicalCondition, bodies: &Bodies) -> bool {
        let beside = &bodies.obstacles[self.body].between;
        self.closes_seam(bodies)
            && other.kind() == self.kind()
            && !other.closes_seam(bodies)
            && matches!(other.members(bodies)[..], [cable, Member::Obstacle(part)]
                if cable == Member::Cable(self.cable) && beside.contains(&part))
    }

    fn required(&self, bodies: &Bodies) -> f64 {
        self.demand.required(bodies.cables[self.cable].radius)
    }

    fn is_about_gap(&self, _: &Bodies) -> bool {
        self.demand.is_about_gap()
    }

    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        shape_distance(&self.sweep(bodies, [from, to].map(|p| p + cable.arm)), self.obstacle(bodies)).signed()
            - cable.radius
    }

    fn clearance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let arm = bodies.cables[self.cable].arm;
        self.with_shapes_beyond(bodies, self.distance(bodies, from, to), [from + arm, to + arm])
    }

    fn clearance_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let gap = self.slack_at(bodies, at) + self.required(bodies);
        self.with_shapes_beyond(bodies, gap, [at.point(&bodies.cables[self.cable].arm); 2])
    }

    fn nearest_points(&self, bodies: &Bodies, position: &Point) -> Option<[Point; 2]> {
        let cable = &bodies.cables[self.cable];
        let found = shape_distance(&self.sweep(bodies, [position + cable.arm; 2]), self.obstacle(bodies));
        Some([found.on_a + found.axis * cable.radius, found.on_b])
    }

    fn shapes(&self, bodies: &Bodies, ends: &[Placed; 2]) -> Option<Shapes> {
        let cable = &bodies.cables[self.cable];
        let (hanging, envelope) = (self.hanging.as_ref()?, cable.envelope.as_ref()?);
        let chord = ends.iter().map(|at| cable.chord(&at.point(&cable.arm))).fold(0.0, f64::max);
        let sag = envelope.sag.map_or(0.0, |sag| sag.between(chord, hanging.reach));
        Some(Shapes { sag, exit: if hanging.carried { 0.0 } else { envelope.exit_error } })
    }

    fn boxes_apart(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        let ends = [from, to].map(|p| p + cable.arm);
        let mut swept = self.sweep(bodies, ends).aabb();
        if let Some(Envelope { lowered_exits, sag: Some(sag), .. }) = cable.envelope.as_deref() {
            // Whatever counts in `clearance`.
            let ends = Aabb::around(&ends).swept(&Vector::zeros(), &(-sag.up * sag.lowering(sag.longest)));
            swept = swept.around_both(&ends).around_both(lowered_exits.aabb());
        }
        let apart = swept.distance(self.obstacle(bodies).aabb());
        if apart > 0.0 { apart - cable.radius } else { f64::NEG_INFINITY }
    }

    fn slack(&self, bodies: &Bodies, position: &Point) -> f64 {
        if self.ends_on_body() {
            return f64::NEG_INFINITY;
        }
        self.distance(bodies, position, position) - self.required(bodies)
    }

    fn is_rounded(&self) -> bool {
        self.demand.distance().is_some()
    }

    fn ends_on_body(&self) -> bool {
        self.demand.ends_on_body()
    }

    #[inline]
    fn breaks(&self, bodies: &Bodies, _: Interference, from: &Point, to: &Point) -> bool {
        let cable = &bodies.cables[self.cable];
        let [from, to] = [from + cable.arm, to + cable.arm];
        let along = [from - cable.outlet, to - cable.outlet];
        self.demand.broken_by(|| self.sweep(bodies, [from, to]), along, |n| self.lower(n), self.obstacle(bodies))
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let CableAt { outlet, arm, .. } = &bodies.cables[self.cable];
        let end = at.point(arm);
        self.demand.slack(|| self.sweep(bodies, [end; 2]), &(end - outlet), |n| self.lower(n), self.obstacle(bodies))
    }

    #[inline]
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let CableAt { outlet, arm, .. } = &bodies.cables[self.cable];
        let [from, to] = piece.points(arm);
        let sag = piece.sag(arm);
        let chord = || (self.sweep(bodies, [from, to]), sag);
        let along = |normal: &Vector| piece.sag_along(arm, piece.share_along(normal)) + self.lower(normal);
        self.demand.kept(chord, [from - outlet, to - outlet], along, self.obstacle(bodies))
    }

    fn forbidden(&self, bodies: &Bodies, gap: f64, fat: &Fattened) -> Option<ForbiddenPolyhedron> {
        let cable = &bodies.cables[self.cable];
        let shadow = || {
            let obstacle = fat.obstacle(bodies, self.body, gap)?;
            self.hanging.as_ref().map_or_else(|| shadow(&obstacle, &cable.outlet), |hanging| hanging.shadow(&obstacle))
        };
        let found = self.demand.behind(shadow, &cable.outlet, |n| self.lower(n))?;
        Some(found.placed(|h| h.moved(&-cable.arm)))
    }

    fn rounded(&self, bodies: &Bodies, fat: &Fattened) -> Option<Vec<HalfSpace>> {
        let gap = self.demand.distance()?;
        let cable = &bodies.cables[self.cable];
        if self.hanging.is_some() {
            return None;
        }
        let planes = rounded_shadow(self.obstacle(bodies), &cable.outlet, gap, &fat.directions(bodies, self.body))?;
        Some(planes.iter().map(|h| h.moved(&-cable.arm)).collect())
    }

    fn forbidden_inside(&self, bodies: &Bodies, fat: &Fattened) -> Option<ForbiddenPolyhedron> {
        self.forbidden(bodies, self.demand.distance()?, fat)
    }

    fn fattens(&self) -> Option<(usize, f64)> {
        self.demand.distance().map(|gap| (self.body, gap))
    }

    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let set = |gap: f64| self.forbidden(bodies, gap, fat);
        vec![Region::bracketed(set, self.demand.gap_and_touch(), scale)]
    }

    fn attachment(&self, bodies: &Bodies) -> Vector {
        bodies.cables[self.cable].arm
    }
}
