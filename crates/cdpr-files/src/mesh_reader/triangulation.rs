//! Polygons as triangles.

use cdpr_core::geometry::Point;

/// Triangles that fill a polygon, convex or not, with indices of vertices; `None` if none are found, as for a polygon that
/// crosses itself.
pub(super) fn triangulation(polygon: &[usize], vertices: &[Point]) -> Option<Vec<[usize; 3]>> {
    if let [a, b, c] = polygon {
        return Some(vec![[*a, *b, *c]]);
    }
    let places: Vec<[f64; 3]> = polygon.iter().map(|i| vertices[*i].into()).collect();
    let (mut flat, mut found) = (Vec::new(), Vec::<usize>::new());
    if !earcut::utils3d::project3d_to_2d(&places, places.len(), &mut flat) {
        return None; // no area
    }
    earcut::Earcut::new().earcut(flat, &[], &mut found);
    let triangles: Vec<[usize; 3]> = found.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect();
    is_rim(&places, &triangles).then(|| triangles.iter().map(|t| t.map(|k| polygon[k])).collect())
}

/// Triangles from the first corner to all sides. They cover whatever the polygon surrounds, and more if it is not convex.
pub(super) fn fan(polygon: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    polygon.windows(2).skip(1).map(|side| [polygon[0], side[0], side[1]])
}

/// Whether the polygon is the rim of the triangles: their other edges lie between two of them. Then the triangles cover
/// whatever the polygon surrounds, and meet the neighbours of the polygon along all its edges.
fn is_rim(places: &[[f64; 3]], triangles: &[[usize; 3]]) -> bool {
    let n = places.len();
    let of_triangles = triangles.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    let of_polygon = (0..n).map(|k| [(k + 1) % n, k]); // backward
    let key = |k: usize| places[k].map(f64::to_bits);
    let mut edges: Vec<_> = of_triangles
        .chain(of_polygon)
        .map(|[from, to]| (key(from), key(to)))
        .filter(|(from, to)| from != to)
        .map(|(from, to)| if from < to { (from, to, 1) } else { (to, from, -1) })
        .collect();
    edges.sort_unstable();
    edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).all(|same| same.iter().map(|edge| edge.2).sum::<i32>() == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[[f64; 2]]) -> Option<f64> {
        let vertices: Vec<Point> = polygon.iter().map(|[x, y]| Point::new(*x, *y, 1.0)).collect();
        let corners: Vec<usize> = (0..vertices.len()).collect();
        let doubled = |[a, b, c]: [usize; 3]| (vertices[b] - vertices[a]).cross(&(vertices[c] - vertices[a])).z;
        triangulation(&corners, &vertices).map(|found| found.into_iter().map(doubled).sum::<f64>() / 2.0)
    }

    #[test]
    fn polygons_are_filled_exactly_whichever_way_they_turn() {
        let notched = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [3.0, 2.0], [3.0, 3.0], [0.0, 3.0]];
        assert_eq!(area(&notched), Some(7.0));
        let backward: Vec<_> = notched.into_iter().rev().collect();
        assert_eq!(area(&backward), Some(-7.0));
        // A hole with a slit from the rim, and corners that repeat or lie between their neighbours.
        let ring = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 3.0],
            [0.0, 3.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
        ];
        assert_eq!(area(&ring), Some(8.0));
        let between = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0], [0.0, 1.0]];
        assert_eq!(area(&between), Some(4.0));
    }

    #[test]
    fn polygons_that_cross_themselves_are_not_filled() {
        assert_eq!(area(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]), None);
        assert_eq!(area(&[[0.0, 0.0], [3.0, 1.0], [3.0, 0.0], [0.0, 2.0]]), None);
        let star: Vec<_> =
            (0..5).map(|k| f64::from(2 * k) * 0.4 * std::f64::consts::PI).map(|a| [a.cos(), a.sin()]).collect();
        assert_eq!(area(&star), None);
        assert_eq!(area(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]), None);
    }
}
