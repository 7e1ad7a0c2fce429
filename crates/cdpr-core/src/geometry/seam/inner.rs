//! Inner edges and corners of a union of convex parts: lines and points inside the union that are in the interior of no
//! part, and in no face shared by two of them.
//!
//! - *Edges.* An inner edge lies on an edge of a part or, where parts overlap, in a line in which facets of at least three
//!   of them cross in pairs. Such a line is divided where parts begin or end to contain it.
//! - *Corners.* An inner corner is an end of one of these intervals, or of one on a line in which two facets cross. The
//!   latter, with no edge of a part there, are only examined for up to [`MOST_CROSSINGS`] such lines.
//! - *Cover.* An interval or an end is inside the union if the parts that contain it cover all directions around it. They
//!   do if they cover the directions just beyond each of their facets that contain it. These facets divide the plane of
//!   each of them into sectors; one direction from each sector is enough.

use std::collections::BTreeSet;

use crate::geometry::convex::hull::Facet;
use crate::geometry::convex::polytope::unit_cross;
use crate::geometry::{Aabb, Point, Polytope, Vector};
use crate::limits::MOST_CROSSINGS;
use crate::tolerances::{ALONG_LINE, FLAT, ON_SURFACE, SAME_CROSSING, SAME_POINT, TOUCH_DEPTH};

/// An inner edge or corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Inner {
    /// The line of the edge; a corner is a line without length.
    pub line: Line,
    /// The parts around it, in ascending order.
    pub between: Vec<usize>,
    /// Radius of a ball around the middle of the line whose points in directions across the line are all in these
    /// parts, m.
    pub radius: f64,
}

/// A line segment, or a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// One end of the segment.
    pub from: Point,
    /// Unit vector to the other end; zero for a point.
    pub along: Vector,
    /// Length of the segment, m.
    pub length: f64,
}

impl Line {
    fn between(from: Point, to: Point) -> Self {
        let along = (to - from).try_normalize(0.0).unwrap_or_default();
        Line { from, along, length: (to - from).norm() }
    }

    /// The point at a distance from the first end.
    pub fn at(&self, distance: f64) -> Point {
        self.from + self.along * distance
    }

    /// Distance of a point from the line and its continuation.
    fn distance(&self, point: &Point) -> f64 {
        self.along.cross(&(point - self.from)).norm()
    }

    fn is_near(&self, other: &Line) -> bool {
        let near = |a: Point, b: Point| (a - b).norm() <= SAME_POINT;
        let [[a, b], [c, d]] = [self, other].map(|line| [line.from, line.at(line.length)]);
        near(a, c) && near(b, d) || near(a, d) && near(b, c)
    }

    /// Whether a point lies between the ends.
    fn holds(&self, point: &Point) -> bool {
        let along = self.along.dot(&(point - self.from));
        along > SAME_POINT && along < self.length - SAME_POINT && (self.at(along) - point).norm() <= SAME_POINT
    }
}

/// The inner edges, then the inner corners. `neighbours` are the parts with volume that may touch each part, and `shared`
/// the pairs that share a face.
pub fn inner_edges_and_corners(
    parts: &[&Polytope],
    neighbours: &[Vec<usize>],
    shared: &BTreeSet<[usize; 2]>,
) -> Vec<Inner> {
    let examined = vec![Vec::new(); parts.len()];
    let mut search =
        InnerSearch { parts, neighbours, shared, found: Vec::new(), crossings_left: MOST_CROSSINGS, examined };
    let mut ends = Vec::new();
    for part in 0..parts.len() {
        for line in search.lines(part) {
            ends.extend(search.divide(part, &line).into_iter().map(|end| (part, end)));
        }
    }
    for (part, end) in ends {
        search.corner(part, end);
    }
    search.found
}

struct InnerSearch<'a> {
    parts: &'a [&'a Polytope],
    neighbours: &'a [Vec<usize>],
    shared: &'a BTreeSet<[usize; 2]>,
    found: Vec<Inner>,
    /// Number of crossings that may still be examined although no two are in one line.
    crossings_left: usize,
    /// For each part, the intervals and ends examined so far that it contains, and whether they are inner ones.
    examined: Vec<Vec<(Line, bool)>>,
}

impl InnerSearch<'_> {
    /// The edges of a part, and the lines in which its facets cross those of later parts.
    fn lines(&mut self, part: usize) -> Vec<Line> {
        let body = self.parts[part];
        let edges = body.facets().iter().flat_map(Facet::edges).filter(|[a, b]| a < b);
        let line = |[a, b]: [usize; 2]| Line::between(body.vertices()[a], body.vertices()[b]);
        let later = self.neighbours[part].iter().filter(|other| **other > part).map(|&other| self.parts[other]);
        let mut crossings = crossings(body, &later.collect::<Vec<_>>());
        if crossings.len() > self.crossings_left {
            crossings.retain(|(_, shared)| *shared);
        }
        self.crossings_left = self.crossings_left.saturating_sub(crossings.len());
        if self.neighbours[part].is_empty() {
            Vec::new()
        } else {
            edges.map(line).chain(crossings.into_iter().map(|(line, _)| line)).collect()
        }
    }

    /// A part and its neighbours that contain at least a point of a line of the part.
    fn within(&self, part: usize, line: &Line) -> Vec<Within> {
        let box_of_line = Aabb::around(&[line.from, line.at(line.length)]);
        let near = std::iter::once(&part).chain(&self.neighbours[part]);
        let near = near.filter(|k| !self.parts[**k].aabb().apart_by(&box_of_line, ON_SURFACE));
        near.filter_map(|&k| Within::of(k, self.parts[k], line)).collect()
    }

    /// Examines the intervals of a line of a part; returns their ends.
    fn divide(&mut self, part: usize, line: &Line) -> Vec<Point> {
        let within = self.within(part, line);
        if within.len() < 2 {
            return Vec::new();
        }
        let mut cuts: Vec<f64> = within.iter().flat_map(|w| w.interval).collect();
        cuts.sort_by(f64::total_cmp);
        let enclosing = within.iter().filter(|w| w.facets.is_empty()).map(|w| w.interval);
        let mut enclosed: Vec<[f64; 2]> = enclosing.collect();
        enclosed.sort_by(|a, b| b[0].total_cmp(&a[0]));
        let mut enclosed_to = 0.0_f64;
        for cut in cuts.windows(2).filter(|cut| cut[1] - cut[0] > ON_SURFACE) {
            while let Some([_, to]) = enclosed.pop_if(|[from, _]| *from <= cut[0]) {
                enclosed_to = enclosed_to.max(to);
            }
            if enclosed_to >= cut[1] {
                continue;
            }
            let holding = within.iter().filter(|w| w.interval[0] <= cut[0] && w.interval[1] >= cut[1]);
            let interval = Line { from: line.at(cut[0]), along: line.along, length: cut[1] - cut[0] };
            self.examine(interval, &holding.collect::<Vec<_>>());
        }
        cuts.dedup_by(|a, b| *a - *b <= SAME_POINT);
        cuts.retain(|cut| !within.iter().any(|w| w.encloses(*cut)));
        cuts.into_iter().map(|cut| line.at(cut)).collect()
    }

    /// Examines an end of an interval on a line of a part.
    fn corner(&mut self, part: usize, end: Point) {
        let point = Line::between(end, end);
        if !self.examined[part].iter().any(|(line, inner)| *inner && line.holds(&end)) {
            self.examine(point, &self.within(part, &point).iter().collect::<Vec<_>>());
        }
    }

    /// Keeps an interval or a point if it is inside the union; `within` are the parts that contain it.
    fn examine(&mut self, line: Line, within: &[&Within]) {
        if within.iter().any(|w| w.facets.is_empty()) {
            return; // inside a part
        }
        let Some(known) = within.iter().map(|w| &self.examined[w.part]).min_by_key(|known| known.len()) else { return };
        if known.iter().any(|(known, _)| known.is_near(&line)) {
            return;
        }
        let inner = self.inner(line, within);
        within.iter().for_each(|w| self.examined[w.part].push((line, inner.is_some())));
        self.found.extend(inner);
    }

    fn inner(&self, line: Line, within: &[&Within]) -> Option<Inner> {
        let middle = line.at(0.5 * line.length);
        let mut beside: Vec<Beside> =
            within.iter().map(|w| Beside::of(w, self.parts[w.part], &line, &middle)).collect();
        if beside.iter().any(|b| b.normals.is_empty()) || self.is_in_shared_face(&beside) {
            return None;
        }
        beside.retain(|b| 0.5 * b.reach > FLAT);
        beside.sort_by(|a, b| b.reach.total_cmp(&a.reach).then(a.part.cmp(&b.part)));
        let radius = |count: usize| 0.5 * beside[count - 1].reach;
        let cover = |count: &usize| cover_all_directions(&beside[..*count], ON_SURFACE / radius(*count));
        let all = Some(beside.len()).filter(|count| *count > 1 && cover(count))?;
        // Halving: each part more covers more.
        let (mut too_few, mut fewest) = (1, all);
        while fewest - too_few > 1 {
            let count = usize::midpoint(too_few, fewest);
            if cover(&count) { fewest = count } else { too_few = count }
        }
        let mut between: Vec<usize> = beside[..fewest].iter().map(|b| b.part).collect();
        between.sort_unstable();
        Some(Inner { line, between, radius: radius(fewest) })
    }

    fn is_in_shared_face(&self, beside: &[Beside]) -> bool {
        let flat: Vec<&Beside> = beside.iter().filter(|b| b.normals.len() == 1).collect();
        let shared = |a: &Beside, b: &Beside| {
            a.normals[0].dot(&b.normals[0]) < -0.5 && self.shared.contains(&[a.part.min(b.part), a.part.max(b.part)])
        };
        flat.iter().enumerate().any(|(k, a)| flat[k + 1..].iter().any(|b| shared(a, b)))
    }
}

/// A part that contains an interval of a line.
struct Within {
    part: usize,
    /// Distances of the ends of the interval from the first end of the line, m.
    interval: [f64; 2],
    /// The facets that contain the interval.
    facets: Vec<usize>,
}

impl Within {
    fn of(part: usize, body: &Polytope, line: &Line) -> Option<Self> {
        let facets = body.facets();
        let slope = |f: &Facet| f.normal.dot(&line.along);
        let near = facets
            .iter()
            .try_fold([0.0, line.length], |interval, f| clip(interval, f.height(&line.from) - ON_SURFACE, slope(f)))?;
        let touches = |f: &Facet| near.iter().all(|&end| f.height(&line.at(end)) >= -ON_SURFACE);
        let is_along = |f: &Facet| slope(f).abs() <= ALONG_LINE && touches(f);
        let (along, across): (Vec<usize>, Vec<usize>) = (0..facets.len()).partition(|&k| is_along(&facets[k]));
        let interval = across
            .iter()
            .map(|&k| &facets[k])
            .try_fold(near, |interval, f| clip(interval, f.height(&line.from), slope(f)))?;
        Some(Within { part, interval, facets: along })
    }
}

impl Within {
    /// Whether the point at this distance from the first end of the line is inside the part.
    fn encloses(&self, distance: f64) -> bool {
        self.facets.is_empty() && self.interval[0] + ON_SURFACE < distance && distance < self.interval[1] - ON_SURFACE
    }
}

/// The part of an interval in which a height that changes by `slope` is not positive.
fn clip([from, to]: [f64; 2], height: f64, slope: f64) -> Option<[f64; 2]> {
    let zero = -height / slope;
    let clipped = match slope {
        _ if height + slope * from <= 0.0 && height + slope * to <= 0.0 => [from, to],
        s if s > 0.0 => [from, to.min(zero)],
        s if s < 0.0 => [from.max(zero), to],
        _ => return None,
    };
    (clipped[0] <= clipped[1]).then_some(clipped)
}

/// A part that contains an interval or a point of a line, seen from the middle of that interval.
struct Beside {
    part: usize,
    /// Unit normals, across the line, of the facets that contain it; none if it is inside the part.
    normals: Vec<Vector>,
    /// Distance of the middle from all other facets, m.
    reach: f64,
}

impl Beside {
    fn of(within: &Within, body: &Polytope, line: &Line, middle: &Point) -> Self {
        let across = |n: Vector| (n - line.along * line.along.dot(&n)).normalize();
        let depth =
            |(k, f): (usize, &Facet)| if within.facets.contains(&k) { f64::INFINITY } else { -f.height(middle) };
        Beside {
            part: within.part,
            normals: within.facets.iter().map(|&k| across(body.facets()[k].normal)).collect(),
            reach: body.facets().iter().enumerate().map(depth).fold(f64::INFINITY, f64::min),
        }
    }

    /// Whether the part contains a direction, except for an angle, rad.
    fn contains(&self, direction: &Vector, tolerance: f64) -> bool {
        self.normals.iter().all(|normal| normal.dot(direction) <= tolerance)
    }
}

/// Whether parts cover all directions around their middle, except for gaps with an angle of up to twice `tolerance`, rad.
fn cover_all_directions(parts: &[Beside], tolerance: f64) -> bool {
    parts.iter().all(|part| {
        part.normals.iter().all(|facet| {
            // The rays that bound the facet; parts that exclude all of them, and a margin, contain nothing beyond it.
            let crossed = part.normals.iter().filter_map(|normal| unit_cross(facet, normal));
            let rays: Vec<Vector> =
                crossed.flat_map(|ray| [ray, -ray]).filter(|ray| part.contains(ray, tolerance)).collect();
            let excludes = |normal: &Vector| rays.iter().all(|ray| normal.dot(ray) > 3.0 * tolerance);
            let is_far = |other: &&Beside| !rays.is_empty() && other.normals.iter().any(excludes);
            let near: Vec<&Beside> = parts.iter().filter(|other| !is_far(other)).collect();
            sectors(facet, near.iter().flat_map(|other| &other.normals), tolerance)
                .into_iter()
                .filter(|direction| part.contains(direction, tolerance))
                .map(|direction| direction + facet * (2.0 * tolerance))
                .all(|direction| near.iter().any(|other| other.contains(&direction, tolerance)))
        })
    })
}

/// A direction in each of the sectors into which planes divide the plane with this normal.
fn sectors<'a>(plane: &Vector, others: impl Iterator<Item = &'a Vector>, tolerance: f64) -> Vec<Vector> {
    let u = plane.cross(&Vector::ith(plane.iamin(), 1.0)).normalize();
    let v = plane.cross(&u);
    let angle = |other: &Vector| unit_cross(plane, other).map(|line| line.dot(&v).atan2(line.dot(&u)));
    let half_turn = std::f64::consts::PI;
    let mut angles: Vec<f64> = others.filter_map(angle).map(|angle| angle.rem_euclid(half_turn)).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup_by(|a, b| *a - *b <= tolerance);
    let next = |k: usize| angles.get(k + 1).copied().unwrap_or(angles[0] + half_turn);
    let middles: Vec<f64> = (0..angles.len()).map(|k| 0.5 * (angles[k] + next(k))).collect();
    let middles = if middles.is_empty() { vec![0.0] } else { middles };
    middles.into_iter().flat_map(|angle| [angle, angle + half_turn]).map(|a| u * a.cos() + v * a.sin()).collect()
}

/// The lines in which facets of a part cross those of others, and whether those of two others cross in the same line.
/// Around a line with fewer parts, none of which has an edge there, some directions are free; only its ends may be inner
/// corners.
fn crossings(body: &Polytope, others: &[&Polytope]) -> Vec<(Line, bool)> {
    let divides = |f: &Facet, other: &Polytope| {
        let above = |sign: f64| other.vertices().iter().any(|v| sign * f.height(v) > TOUCH_DEPTH);
        above(1.0) && above(-1.0)
    };
    let dividing =
        |other: &Polytope| (0..other.facets().len()).filter(|&k| divides(&other.facets()[k], body)).collect();
    let of_others: Vec<Vec<usize>> = others.iter().map(|other| dividing(other)).collect();
    let mut found = Vec::new();
    for f in body.facets() {
        let mut lines: Vec<(f64, usize, Line)> = Vec::new();
        for (k, other) in others.iter().enumerate().filter(|(k, other)| !of_others[*k].is_empty() && divides(f, other))
        {
            let cross = |&g: &usize| crossing([body, other], [f, &other.facets()[g]]);
            lines.extend(of_others[k].iter().filter_map(cross).map(|line| (line.distance(&body.centroid()), k, line)));
        }
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut shared = vec![false; lines.len()];
        for (i, (distance, other, line)) in lines.iter().enumerate() {
            for (j, (_, another, same)) in
                lines.iter().enumerate().skip(i + 1).take_while(|(_, next)| next.0 <= distance + SAME_CROSSING)
            {
                if other != another && line.along.cross(&same.along).norm() <= ALONG_LINE {
                    (shared[i], shared[j]) = (true, true);
                }
            }
        }
        found.extend(lines.iter().map(|(.., line)| *line).zip(shared));
    }
    found
}

fn crossing(bodies: [&Polytope; 2], [f, g]: [&Facet; 2]) -> Option<Line> {
    let along = unit_cross(&f.normal, &g.normal)?;
    let middle = bodies[0].centroid();
    // In the plane of f, straight to that of g.
    let down = middle - f.normal * f.height(&middle);
    let across = along.cross(&f.normal);
    let foot = down - across * (g.height(&down) / g.normal.dot(&across));
    let size = (bodies[0].aabb().max - bodies[0].aabb().min).norm();
    let line = Line { from: foot - along * size, along, length: 2.0 * size };
    // Most lines miss one of the bodies, which this finds at little cost.
    let mut facets = bodies.iter().flat_map(|body| body.facets());
    facets.try_fold([0.0, line.length], |interval, other| {
        let near = clip(interval, other.height(&line.from) - ON_SURFACE, other.normal.dot(&along))?;
        (near[1] - near[0] > ON_SURFACE).then_some(near)
    })?;
    let [from, to] = bodies.iter().try_fold([0.0, line.length], |[from, to], body| {
        let Within { interval, .. } = Within::of(0, body, &line)?;
        Some([from.max(interval[0]), to.min(interval[1])])
    })?;
    (to - from > ON_SURFACE).then(|| Line { from: line.at(from), along, length: to - from })
}
