//! Defects of triangles that leave no doubt about the shape, and how they are mended: coincident flat faces of abutting bodies
//! cancel, corners in the middle of another triangle's edge are joined to it, and triangles that face the other way than
//! their neighbours are turned.

use std::collections::{BTreeMap, HashMap};

use super::solid::LOOK;
use super::welded::{Role, Use, Welded, defects, edges, root};
use crate::error::Error;
use crate::geometry::Aabb;
use crate::limits::MOST_MENDING_STEPS;
use crate::watch::Watch;

/// Directed outer edges of a face, in ascending order, and its triangles.
type Face = (Vec<[u32; 2]>, Vec<usize>);

impl Welded {
    /// Makes walls of the flat faces that coincide with one that faces them, however they are divided into triangles.
    /// Returns whether there are any.
    pub(super) fn face_each_other(&mut self, uses: &[Use], watch: &Watch) -> Result<bool, Error> {
        if edges(uses).all(|same| same.len() <= 2) {
            return Ok(false);
        }
        let mut known: HashMap<Vec<[u32; 2]>, Vec<usize>> = HashMap::new();
        let mut walls = Vec::new();
        for (rim, face) in self.faces(uses, watch)? {
            let facing = {
                let mut rim: Vec<[u32; 2]> = rim.iter().map(|[i, j]| [*j, *i]).collect();
                rim.sort_unstable();
                rim
            };
            match known.remove(&facing) {
                Some(other) => walls.extend(face.into_iter().chain(other)),
                None => drop(known.insert(rim, face)),
            }
        }
        walls.iter().for_each(|k| self.roles[*k] = Role::Wall);
        Ok(!walls.is_empty())
    }

    /// The flat faces all of whose outer edges have more than two triangles, and whose inner edges have two.
    fn faces(&self, uses: &[Use], watch: &Watch) -> Result<Vec<Face>, Error> {
        let mut triangles: Vec<usize> = uses.iter().map(|edge| edge.3 as usize).collect();
        triangles.sort_unstable();
        triangles.dedup();
        let place = |edge: &Use| triangles.binary_search(&(edge.3 as usize)).expect("listed");
        let mut parent: Vec<usize> = (0..triangles.len()).collect();
        let mut outer: Vec<(&Use, bool)> = Vec::new();
        for (k, same) in edges(uses).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            match same {
                [one, other] if self.is_one_face(one, other) => {
                    let (i, j) = (root(&mut parent, place(one)), root(&mut parent, place(other)));
                    parent[i.max(j)] = i.min(j);
                }
                _ => outer.extend(same.iter().map(|edge| (edge, same.len() > 2))),
            }
        }
        let mut rims: BTreeMap<usize, (Vec<[u32; 2]>, bool)> = BTreeMap::new();
        for (edge, shared) in outer {
            let (rim, all_shared) = rims.entry(root(&mut parent, place(edge))).or_insert((Vec::new(), true));
            rim.push(if edge.2 { [edge.1, edge.0] } else { [edge.0, edge.1] });
            *all_shared &= shared;
        }
        rims.retain(|_, (_, all_shared)| *all_shared);
        let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, triangle) in triangles.iter().enumerate() {
            let face = root(&mut parent, k);
            if rims.contains_key(&face) {
                members.entry(face).or_default().push(*triangle);
            }
        }
        let mut faces = Vec::new();
        for ((mut rim, _), face) in rims.into_values().zip(members.into_values()) {
            if self.is_flat(&face) {
                rim.sort_unstable();
                faces.push((rim, face));
            }
        }
        Ok(faces)
    }

    /// Whether two triangles on both sides of an edge are part of one flat face.
    fn is_one_face(&self, one: &Use, other: &Use) -> bool {
        let [a, b] = [one, other].map(|edge| self.doubled_area(edge.3 as usize));
        one.2 != other.2 && a.dot(&b) > 0.0 && self.is_flat(&[one.3 as usize, other.3 as usize])
    }

    /// Whether all corners of triangles are in the plane of the largest one.
    fn is_flat(&self, triangles: &[usize]) -> bool {
        let area = |k: &usize| self.doubled_area(*k).norm();
        let largest = triangles.iter().max_by(|i, j| area(i).total_cmp(&area(j)));
        let Some(normal) = largest.and_then(|k| self.doubled_area(*k).try_normalize(0.0)) else { return false };
        let origin = self.points[self.ids[*largest.expect("a triangle")][0]];
        let height = |i: usize| normal.dot(&(self.points[i] - origin));
        triangles.iter().flat_map(|k| self.ids[*k]).all(|i| height(i).abs() <= self.near)
    }

    /// Joins corners on open edges to these edges, if that closes the surface: adds triangles without area, and returns
    /// their indices and the number of corners.
    pub(super) fn joined(
        &mut self,
        shell: &[usize],
        uses: &[Use],
        watch: &Watch,
    ) -> Result<Option<(Vec<usize>, usize)>, Error> {
        let open: Vec<[usize; 2]> = edges(uses)
            .filter(|same| same.len() == 1)
            .map(|same| if same[0].2 { [same[0].1, same[0].0] } else { [same[0].0, same[0].1] })
            .map(|edge| edge.map(|i| i as usize))
            .collect();
        let mut ends: Vec<usize> = open.iter().flatten().copied().collect();
        ends.sort_unstable();
        ends.dedup();
        let span = Aabb::around(&ends.iter().map(|i| self.points[*i]).collect::<Vec<_>>());
        let axis = (span.max - span.min).imax();
        ends.sort_by(|i, j| self.points[*i][axis].total_cmp(&self.points[*j][axis]).then(i.cmp(j)));
        let mut steps = 0;
        let mut chains: Vec<(Vec<usize>, [usize; 2])> = Vec::new();
        for [a, b] in open {
            let (p, q) = (self.points[a], self.points[b]);
            let along = q - p;
            let (low, high) = (p[axis].min(q[axis]) - self.near, p[axis].max(q[axis]) + self.near);
            let from = ends.partition_point(|i| self.points[*i][axis] < low);
            let mut between: Vec<(f64, usize)> = Vec::new();
            for i in ends[from..].iter().take_while(|i| self.points[**i][axis] <= high) {
                steps += 1;
                if steps % LOOK == 0 {
                    watch.check()?;
                }
                let offset = self.points[*i] - p;
                let share = offset.dot(&along) / along.norm_squared();
                if share > 0.0 && share < 1.0 && *i != a && *i != b && (offset - along * share).norm() <= self.near {
                    between.push((share, *i));
                }
            }
            if steps > MOST_MENDING_STEPS {
                return Ok(None);
            }
            between.sort_by(|x, y| x.0.total_cmp(&y.0));
            if !between.is_empty() {
                chains.push((between.into_iter().map(|(_, i)| i).collect(), [a, b]));
            }
        }
        let first = self.ids.len();
        let mut corners: Vec<usize> = chains.iter().flat_map(|(chain, _)| chain).copied().collect();
        for (chain, [a, b]) in chains {
            let mut last = a;
            for i in chain {
                self.ids.push([b, last, i]);
                last = i;
            }
        }
        self.corners.extend(self.ids[first..].iter().map(|t| t.map(|i| self.points[i])));
        self.roles.resize(self.ids.len(), Role::Joins);
        let added: Vec<usize> = (first..self.ids.len()).collect();
        let whole: Vec<usize> = shell.iter().chain(&added).copied().collect();
        let closed = defects(&self.uses(&whole, watch)?).0 == 0;
        if !closed || added.is_empty() {
            self.ids.truncate(first);
            self.corners.truncate(first);
            self.roles.truncate(first);
            return Ok(None);
        }
        corners.sort_unstable();
        corners.dedup();
        Ok(Some((added, corners.len())))
    }

    /// Turns triangles so that all agree with their neighbours, if that is possible, and returns their number. Of two
    /// consistent orientations of connected triangles, the one that more of their area has is kept.
    pub(super) fn turned(&mut self, shell: &[usize], uses: &[Use], watch: &Watch) -> Result<Option<usize>, Error> {
        let mut neighbours: HashMap<usize, Vec<(usize, bool)>> = HashMap::new();
        for (k, same) in edges(uses).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            // Edges of more triangles do not tell which of them belong together.
            if let [(.., back, i), (.., other, j)] = same {
                neighbours.entry(*i as usize).or_default().push((*j as usize, back == other));
                neighbours.entry(*j as usize).or_default().push((*i as usize, back == other));
            }
        }
        let mut turn: HashMap<usize, bool> = HashMap::new();
        let mut turned = Vec::new();
        for (k, first) in self.bounding(shell).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            if turn.contains_key(&first) {
                continue;
            }
            turn.insert(first, false);
            let mut patch = vec![first];
            let mut at = 0;
            while at < patch.len() {
                let here = turn[&patch[at]];
                for (other, against) in neighbours.get(&patch[at]).into_iter().flatten() {
                    match turn.get(other) {
                        None => {
                            turn.insert(*other, here != *against);
                            patch.push(*other);
                        }
                        Some(there) if *there != (here != *against) => return Ok(None), // it has one side only
                        Some(_) => {}
                    }
                }
                at += 1;
            }
            let area = |k: &usize| self.doubled_area(*k).norm() * if turn[k] { 1.0 } else { -1.0 };
            let most_turn = patch.iter().map(area).sum::<f64>() > 0.0;
            turned.extend(patch.into_iter().filter(|k| turn[k] != most_turn));
        }
        self.turn(&turned);
        if defects(&self.uses(shell, watch)?) != (0, 0) {
            self.turn(&turned);
            return Ok(None);
        }
        Ok(Some(turned.len()))
    }

    fn turn(&mut self, triangles: &[usize]) {
        for k in triangles {
            self.ids[*k].swap(1, 2);
            self.corners[*k].swap(1, 2);
        }
    }
}
