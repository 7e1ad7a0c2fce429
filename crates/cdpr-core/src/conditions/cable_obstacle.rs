//! Cables stay clear of obstacles.
//!
//! The forbidden positions are the shadow of the obstacle seen from the outlet B, moved by minus the arm R a. If the
//! outlet is on the obstacle, they are the cone of directions below all facets that are active there.
//!
//! A cable that can take several shapes must stay clear of the obstacle in all of them. It can leave the frame anywhere in a
//! convex set E, so the shadow is seen from E. It hangs below its chord, by one of two bounds (`Hanging`): at most σ where it
//! can reach the obstacle, so that its chord must avoid the obstacle swept upward by σ; or, near the outlet, in the hull of E, the
//! attachment, and the attachment lowered by what the cable can leave its end lower. Both sets are convex polyhedra. An
//! obstacle that carries the outlet is seen from the outlet alone.

use std::borrow::Cow;
use std::cell::LazyCell;
use std::sync::Arc;

use super::bodies::{Bodies, CableAt, Shapes};
use super::cable_and_body::{CABLE, CableDemand, rounded_shadow};
use super::exempt::Remarks;
use super::fattened::{Fattened, directions, fattened};
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{ForbiddenPolyhedron, Region, Scale};
use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{
    CableSweep, Cone, ConvexShape, Fan, HalfSpace, Placed, Point, Polytope, Shadow, Triangle, TurningPiece, Vector,
    shadow, shadow_from,
};
use crate::model::{Envelope, Member, Scene, exit_error};
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

/// All shapes of a cable near an obstacle body.
#[derive(Debug, Clone, PartialEq)]
pub struct Hanging {
    /// Convex set of points where the cable leaves the frame.
    exits: Arc<Polytope>,
    bound: Bound,
    /// Unit vector against gravity times the bound on the sag, m.
    rise: Vector,
    /// The greatest sag near the body, m.
    deepest: f64,
}

/// How the sag of a cable is bounded near a body.
#[derive(Debug, Clone, PartialEq)]
enum Bound {
    /// Its chord avoids this body: the obstacle swept upward.
    Raised(Polytope),
    /// It lies in the hull of its exits, its attachment, and its attachment lowered.
    Lowered,
}

impl Hanging {
    /// The shapes of a cable that may come within `gap` of a body; one that carries the outlet if `carried`.
    fn near(body: &Polytope, envelope: &Envelope, outlet: &Point, gap: f64, carried: bool) -> Self {
        let exits =
            if carried { Arc::new(Polytope::hull_of(&[*outlet]).expect("a point")) } else { envelope.exits.clone() };
        let lowered = |rise, deepest| Hanging { exits: exits.clone(), bound: Bound::Lowered, rise, deepest };
        let Some(sag) = &envelope.sag else { return lowered(Vector::zeros(), 0.0) };
        let whole = body.aabb().swept(&Vector::zeros(), &(sag.up * sag.deepest()));
        let near = whole.distance(exits.aabb()) - gap;
        let far = exits.vertices().iter().flat_map(|e| body.vertices().iter().map(move |v| (v - e).norm()));
        let deepest = sag.between([near, far.fold(0.0, f64::max) + sag.deepest() + gap]);
        let rise = sag.up * deepest;
        // Near the outlet the cable hangs in proportion to the distance, and the first bound is useless.
        match body.swept(&rise) {
            Ok(raised) if near > NEAR * deepest && !carried => {
                Hanging { exits, bound: Bound::Raised(raised), rise, deepest }
            }
            _ => lowered(sag.up * sag.at_end(), deepest),
        }
    }

    /// The body that the chord must avoid, if `obstacle` is the obstacle body.
    fn body<'a>(&'a self, obstacle: &'a Polytope) -> &'a Polytope {
        if let Bound::Raised(raised) = &self.bound { raised } else { obstacle }
    }

    /// What the chords sweep while the attachment moves between two points.
    fn sweep(&self, [from, to]: [Point; 2]) -> Fan<'_> {
        let lower = if self.bound == Bound::Lowered { self.rise } else { Vector::zeros() };
        Fan { points: self.exits.vertices(), copies: [Fan::AS_IT_IS; 3], ends: [from, to, from - lower, to - lower] }
    }

    /// How much lower than the chord the cable can leave the outlet, along a normal, m at the attachment.
    fn lower(&self, normal: &Vector) -> f64 {
        if self.bound == Bound::Lowered { normal.dot(&self.rise).max(0.0) } else { 0.0 }
    }

    /// The points where the cable cannot end because of an obstacle that it must keep `gap` metres from, or slightly more;
    /// `obstacle` is the obstacle body fattened by that.
    fn shadow<'a>(&self, obstacle: impl FnOnce() -> Option<Cow<'a, Polytope>>, gap: f64) -> Option<Shadow> {
        match &self.bound {
            Bound::Raised(raised) => shadow_from(&*fattened(raised, gap)?, &self.exits),
            Bound::Lowered => {
                let body = obstacle()?;
                if self.rise == Vector::zeros() {
                    return shadow_from(&body, &self.exits);
                }
                let cone = match self.exits.vertices() {
                    [apex] => Cone::around(&body, apex)?,
                    _ => Cone::around(&body.sum(&self.exits.reflected()).ok()?, &Point::origin())?,
                };
                Some(cone.added_to(&body.swept(&self.rise).ok()?))
            }
        }
    }
}

/// The sag at an obstacle is bounded by its largest value there if the obstacle is farther from the outlet than this multiple.
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
                Some(hanging) => shape_distance(&*hanging.exits, hanging.body(&obstacle.body)).signed(),
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
    /// The body that the cable's chord must avoid.
    fn solid<'a>(&'a self, bodies: &'a Bodies) -> &'a Polytope {
        let obstacle = &bodies.obstacles[self.body].body;
        self.hanging.as_ref().map_or(obstacle, |hanging| hanging.body(obstacle))
    }

    /// What the cable's chord sweeps while its attachment moves between two points.
    #[inline]
    fn sweep(&self, bodies: &Bodies, [from, to]: [Point; 2]) -> CableSweep<'_> {
        match &self.hanging {
            None => CableSweep::Straight(Triangle::new(bodies.cables[self.cable].outlet, from, to)),
            Some(hanging) => CableSweep::Fan(hanging.sweep([from, to])),
        }
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
        shape_distance(&self.sweep(bodies, [from, to].map(|p| p + cable.arm)), self.solid(bodies)).signed()
            - cable.radius
    }

    fn nearest_points(&self, bodies: &Bodies, position: &Point) -> Option<[Point; 2]> {
        let cable = &bodies.cables[self.cable];
        let found = shape_distance(&self.sweep(bodies, [position + cable.arm; 2]), self.solid(bodies));
        Some([found.on_a + found.axis * cable.radius, found.on_b])
    }

    fn shapes(&self, bodies: &Bodies) -> Option<Shapes> {
        let hanging = self.hanging.as_ref()?;
        let outlet = &bodies.cables[self.cable].outlet;
        Some(Shapes { sag: hanging.deepest, exit: exit_error(&hanging.exits, outlet) })
    }

    fn boxes_apart(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let cable = &bodies.cables[self.cable];
        let swept = self.sweep(bodies, [from, to].map(|p| p + cable.arm)).aabb();
        let apart = swept.distance(self.solid(bodies).aabb());
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
        self.demand.broken_by(|| self.sweep(bodies, [from, to]), along, |n| self.lower(n), self.solid(bodies))
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        let CableAt { outlet, arm, .. } = &bodies.cables[self.cable];
        let end = at.point(arm);
        self.demand.slack(|| self.sweep(bodies, [end; 2]), &(end - outlet), |n| self.lower(n), self.solid(bodies))
    }

    #[inline]
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let CableAt { outlet, arm, .. } = &bodies.cables[self.cable];
        let [from, to] = piece.points(arm);
        let sag = piece.sag(arm);
        let chord = || (self.sweep(bodies, [from, to]), sag);
        let along = |normal: &Vector| piece.sag_along(arm, piece.share_along(normal)) + self.lower(normal);
        self.demand.kept(chord, [from - outlet, to - outlet], along, self.solid(bodies))
    }

    fn forbidden(&self, bodies: &Bodies, gap: f64, fat: &Fattened) -> Option<ForbiddenPolyhedron> {
        let cable = &bodies.cables[self.cable];
        let shadow = || match &self.hanging {
            None => shadow(&*fat.obstacle(bodies, self.body, gap)?, &cable.outlet),
            Some(hanging) => hanging.shadow(|| fat.obstacle(bodies, self.body, gap), gap),
        };
        let found = self.demand.behind(shadow, &cable.outlet, |n| self.lower(n))?;
        Some(found.placed(|h| h.moved(&-cable.arm)))
    }

    fn rounded(&self, bodies: &Bodies, fat: &Fattened) -> Option<Vec<HalfSpace>> {
        let gap = self.demand.distance()?;
        let cable = &bodies.cables[self.cable];
        let planes = match &self.hanging {
            None => {
                let obstacle = &bodies.obstacles[self.body].body;
                rounded_shadow(obstacle, &cable.outlet, gap, &fat.directions(bodies, self.body))?
            }
            Some(hanging) => match (&hanging.bound, hanging.exits.vertices()) {
                (Bound::Raised(raised), [outlet]) => rounded_shadow(raised, outlet, gap, &directions(raised))?,
                _ => return None,
            },
        };
        Some(planes.iter().map(|h| h.moved(&-cable.arm)).collect())
    }

    fn fattens(&self) -> Option<(usize, f64)> {
        let raised = self.hanging.as_ref().is_some_and(|hanging| hanging.bound != Bound::Lowered);
        self.demand.distance().filter(|_| !raised).map(|gap| (self.body, gap))
    }

    fn regions(&self, bodies: &Bodies, scale: &Scale, fat: &Fattened) -> Vec<Region> {
        let set = |gap: f64| self.forbidden(bodies, gap, fat);
        vec![Region::bracketed(set, self.demand.gap_and_touch(), scale)]
    }

    fn attachment(&self, bodies: &Bodies) -> Vector {
        bodies.cables[self.cable].arm
    }
}
