//! The order in which a closed tour visits its stops, and a lower bound on the length of every tour.
//!
//! - Up to [`MOST_EXACT_STOPS`] stops: dynamic programming over subsets (M. Held and R. Karp, "A dynamic programming approach to sequencing
//!   problems", J. SIAM 10, 1962).
//! - Beyond that: local search that reverses and moves parts of the tour (2-opt, Or-opt), from the nearest neighbours and again and
//!   again after a random change of four edges. The bound is that of 1-trees: a spanning tree without one stop, and two edges to that
//!   stop, weigh at most as much as any tour. Weights of stops that make every stop look as if it had two edges raise it (M. Held and R.
//!   Karp, "The traveling-salesman problem and minimum spanning trees", Operations Research 18, 1970).

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::limits::{MOST_EXACT_STOPS, TOUR_EFFORT};
use crate::tolerances::TOUR_ROUNDING;

/// Lengths between stops, symmetric; infinite where there is no way.
#[derive(Debug, Clone, PartialEq)]
pub struct Lengths {
    count: usize,
    rows: Vec<f64>,
}

impl Lengths {
    /// The lengths between `count` stops; 0 from a stop to itself.
    pub fn new(count: usize, length: impl Fn(usize, usize) -> f64) -> Self {
        let entry = |k: usize| match (k / count, k % count) {
            (i, j) if i == j => 0.0,
            (i, j) => length(i.min(j), i.max(j)),
        };
        Lengths { count, rows: (0..count * count).map(entry).collect() }
    }

    /// Number of stops.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Length from one stop to another.
    pub fn of(&self, from: usize, to: usize) -> f64 {
        self.rows[from * self.count + to]
    }

    /// Length of a closed tour.
    pub fn around(&self, order: &[usize]) -> f64 {
        let next = order.iter().cycle().skip(1);
        order.iter().zip(next).map(|(a, b)| self.of(*a, *b)).sum()
    }

    fn largest(&self) -> f64 {
        self.rows.iter().copied().filter(|length| length.is_finite()).fold(0.0, f64::max)
    }
}

/// A closed tour of all stops, from the first one: the shortest up to [`MOST_EXACT_STOPS`] stops, otherwise one that local search found.
pub fn short_tour(lengths: &Lengths) -> Vec<usize> {
    match lengths.count {
        0 | 1 => (0..lengths.count).collect(),
        count if count <= MOST_EXACT_STOPS => shortest(lengths),
        _ => local_search(lengths),
    }
}

/// A length that no closed tour of all stops goes below.
pub fn least_length(lengths: &Lengths) -> f64 {
    match lengths.count {
        0 | 1 => 0.0,
        count if count <= MOST_EXACT_STOPS => lengths.around(&shortest(lengths)) * (1.0 - TOUR_ROUNDING),
        _ => one_trees(lengths, lengths.around(&local_search(lengths))),
    }
}

/// The shortest tour by dynamic programming: `best[set][last]` is the shortest way from stop 0 through a set of the others to the last.
fn shortest(lengths: &Lengths) -> Vec<usize> {
    let others = lengths.count - 1;
    let sets = 1usize << others;
    let mut best = vec![(f64::INFINITY, usize::MAX); sets * others];
    for last in 0..others {
        best[(1 << last) * others + last] = (lengths.of(0, last + 1), usize::MAX);
    }
    for set in 1..sets {
        for last in (0..others).filter(|last| set >> last & 1 == 1) {
            let before = set & !(1 << last);
            for from in (0..others).filter(|from| before >> from & 1 == 1) {
                let length = best[before * others + from].0 + lengths.of(from + 1, last + 1);
                if length < best[set * others + last].0 {
                    best[set * others + last] = (length, from);
                }
            }
        }
    }
    let whole = sets - 1;
    let closed = |last: usize| best[whole * others + last].0 + lengths.of(last + 1, 0);
    let mut last = (0..others).min_by(|a, b| closed(*a).total_cmp(&closed(*b))).expect("there are others");
    let (mut set, mut order) = (whole, Vec::with_capacity(lengths.count));
    while set != 0 {
        order.push(last + 1);
        let from = best[set * others + last].1;
        set &= !(1 << last);
        // Without any way, no stop was recorded: the rest in any order.
        last = if from == usize::MAX && set != 0 { set.trailing_zeros() as usize } else { from };
    }
    order.push(0);
    order.reverse();
    order
}

/// A tour that no reversal or move of a part shortens, the shortest of many.
fn local_search(lengths: &Lengths) -> Vec<usize> {
    let count = lengths.count;
    // Ways that do not exist are longer than any tour.
    let far = 1.0 + lengths.largest() * (count as f64 + 1.0);
    let finite = Lengths::new(count, |i, j| lengths.of(i, j).min(far));
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let mut best = nearest_neighbours(&finite);
    improve(&finite, &mut best);
    let mut length = finite.around(&best);
    for _ in 0..(TOUR_EFFORT / (count * count)).clamp(10, 2000) {
        let mut other = changed(&best, &mut rng);
        improve(&finite, &mut other);
        let shorter = finite.around(&other);
        if shorter < length {
            (best, length) = (other, shorter);
        }
    }
    let first = best.iter().position(|stop| *stop == 0).expect("it visits every stop");
    best.rotate_left(first);
    best
}

fn nearest_neighbours(lengths: &Lengths) -> Vec<usize> {
    let mut order = vec![0];
    let mut left: Vec<usize> = (1..lengths.count).collect();
    while let Some(last) = order.last().copied()
        && let Some(k) =
            (0..left.len()).min_by(|a, b| lengths.of(last, left[*a]).total_cmp(&lengths.of(last, left[*b])))
    {
        order.push(left.remove(k));
    }
    order
}

/// The tour with its four parts in another order (a double bridge), which reversals alone do not undo.
fn changed(order: &[usize], rng: &mut ChaCha8Rng) -> Vec<usize> {
    let mut cuts: [usize; 3] = std::array::from_fn(|_| rng.random_range(1..order.len()));
    cuts.sort_unstable();
    let [a, b, c] = cuts;
    [&order[..a], &order[b..c], &order[a..b], &order[c..]].concat()
}

/// Shortens a tour by reversing parts of it and by moving parts of up to three stops, until neither helps.
fn improve(lengths: &Lengths, order: &mut Vec<usize>) {
    while reverse_a_part(lengths, order) || move_a_part(lengths, order) {}
}

fn reverse_a_part(lengths: &Lengths, order: &mut [usize]) -> bool {
    let count = order.len();
    let mut any = false;
    for i in 0..count - 1 {
        for j in i + 2..count {
            let (a, b, c, d) = (order[i], order[i + 1], order[j], order[(j + 1) % count]);
            if a == d {
                continue;
            }
            let gain = lengths.of(a, b) + lengths.of(c, d) - lengths.of(a, c) - lengths.of(b, d);
            if gain > TOUR_ROUNDING * (lengths.of(a, b) + lengths.of(c, d)) {
                order[i + 1..=j].reverse();
                any = true;
            }
        }
    }
    any
}

fn move_a_part(lengths: &Lengths, order: &mut Vec<usize>) -> bool {
    let count = order.len();
    for size in 1..=3.min(count.saturating_sub(2)) {
        for i in 0..count {
            let at = |k: usize| order[(i + k) % count];
            let (before, first, last, after) = (at(count - 1), at(0), at(size - 1), at(size));
            let freed = lengths.of(before, first) + lengths.of(last, after) - lengths.of(before, after);
            for k in size..count - 1 {
                let (a, b) = (at(k), at(k + 1));
                let kept = lengths.of(a, first) + lengths.of(last, b) - lengths.of(a, b);
                let turned = lengths.of(a, last) + lengths.of(first, b) - lengths.of(a, b);
                if freed - kept.min(turned) > TOUR_ROUNDING * (freed.abs() + lengths.of(a, b)) {
                    let mut part: Vec<usize> = (0..size).map(at).collect();
                    if turned < kept {
                        part.reverse();
                    }
                    let head: Vec<usize> = (size..=k).map(at).collect();
                    let tail: Vec<usize> = (k + 1..count).map(at).collect();
                    *order = [head, part, tail].concat();
                    return true;
                }
            }
        }
    }
    false
}

/// Steps of the ascent, and steps without a better bound after which it goes on more slowly.
const ASCENT: (usize, usize) = (2000, 40);

/// The bound of 1-trees without stop 0, by subgradient ascent towards the length of a known tour.
fn one_trees(lengths: &Lengths, known: f64) -> f64 {
    let count = lengths.count;
    let far = 1.0 + lengths.largest() * (count as f64 + 1.0);
    let finite = Lengths::new(count, |i, j| lengths.of(i, j).min(far));
    let known = known.min(finite.around(&local_search(&finite)));
    let mut weights = vec![0.0; count];
    let (mut best, mut pace, mut waited) = (0.0f64, 2.0, 0);
    for _ in 0..ASCENT.0 {
        let (weight, degrees) = one_tree(&finite, &weights);
        let bound = weight - 2.0 * weights.iter().sum::<f64>();
        if bound > best {
            (best, waited) = (bound, 0);
        } else {
            waited += 1;
        }
        if waited > ASCENT.1 {
            (pace, waited) = (0.5 * pace, 0);
        }
        let excess: f64 = degrees.iter().map(|degree| (*degree as f64 - 2.0).powi(2)).sum();
        if excess == 0.0 || pace < 1e-4 {
            break; // the tree is a tour, or nothing moves any more
        }
        let step = pace * (known - bound).max(TOUR_ROUNDING * known) / excess;
        weights.iter_mut().zip(&degrees).for_each(|(weight, degree)| *weight += step * (*degree as f64 - 2.0));
    }
    // The sums over all edges round.
    (best - TOUR_ROUNDING * (best + far)).max(0.0)
}

/// Weight and degrees of the lightest 1-tree, with the weights of stops added to the lengths of their edges.
fn one_tree(lengths: &Lengths, weights: &[f64]) -> (f64, Vec<usize>) {
    let count = lengths.count;
    let edge = |i: usize, j: usize| lengths.of(i, j) + weights[i] + weights[j];
    let mut degrees = vec![0; count];
    // Prim's algorithm among the stops other than 0, from stop 1.
    let mut nearest: Vec<(f64, usize)> = (0..count).map(|k| (edge(1, k), 1)).collect();
    let mut outside: Vec<usize> = (2..count).collect();
    let mut total = 0.0;
    while let Some(k) = (0..outside.len()).min_by(|a, b| nearest[outside[*a]].0.total_cmp(&nearest[outside[*b]].0)) {
        let stop = outside.swap_remove(k);
        let (length, from) = nearest[stop];
        total += length;
        degrees[stop] += 1;
        degrees[from] += 1;
        for other in &outside {
            let length = edge(stop, *other);
            if length < nearest[*other].0 {
                nearest[*other] = (length, stop);
            }
        }
    }
    let mut to_first: Vec<usize> = (1..count).collect();
    to_first.sort_by(|a, b| edge(0, *a).total_cmp(&edge(0, *b)));
    for stop in &to_first[..2] {
        total += edge(0, *stop);
        degrees[0] += 1;
        degrees[*stop] += 1;
    }
    (total, degrees)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(count: usize, seed: u64) -> Lengths {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let places: Vec<[f64; 2]> = (0..count).map(|_| [rng.random(), rng.random()]).collect();
        Lengths::new(count, |i, j| f64::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]))
    }

    fn brute_force(lengths: &Lengths) -> f64 {
        fn rest(lengths: &Lengths, order: &mut Vec<usize>, left: &mut Vec<usize>, best: &mut f64) {
            if left.is_empty() {
                *best = best.min(lengths.around(order));
            }
            for k in 0..left.len() {
                order.push(left.remove(k));
                rest(lengths, order, left, best);
                left.insert(k, order.pop().unwrap());
            }
        }
        let mut best = f64::INFINITY;
        rest(lengths, &mut vec![0], &mut (1..lengths.count()).collect(), &mut best);
        best
    }

    fn visits_all(order: &[usize], count: usize) {
        let mut sorted = order.to_vec();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..count).collect::<Vec<_>>());
        assert_eq!(order.first(), (count > 0).then_some(&0));
    }

    #[test]
    fn few_stops_are_visited_in_the_best_order() {
        for (count, seed) in (0..9).flat_map(|count| (0..8).map(move |seed| (count, seed))) {
            let lengths = points(count, seed);
            let order = short_tour(&lengths);
            visits_all(&order, count);
            let best = if count == 0 { 0.0 } else { brute_force(&lengths) };
            assert!((lengths.around(&order) - best).abs() < 1e-12);
            assert!(least_length(&lengths) <= best && least_length(&lengths) > best - 1e-9);
        }
    }

    #[test]
    fn local_search_and_one_trees_enclose_the_shortest_tour() {
        for (count, seed) in (5..=13).flat_map(|count| (0..6).map(move |seed| (count, seed))) {
            let lengths = points(count, 100 + seed);
            let best = lengths.around(&shortest(&lengths));
            let found = local_search(&lengths);
            visits_all(&found, count);
            assert!((lengths.around(&found) - best).abs() < 1e-12, "{count} {seed}");
            let bound = one_trees(&lengths, best);
            assert!(bound <= best && bound > 0.95 * best, "{count} {seed}: {bound} {best}");
        }
    }

    #[test]
    fn fifty_stops_are_within_two_per_cent_of_the_bound() {
        for seed in 0..10 {
            let lengths = points(50, seed);
            let (found, bound) = (lengths.around(&short_tour(&lengths)), least_length(&lengths));
            assert!(bound <= found && found < 1.02 * bound, "{seed}: {found} {bound}");
        }
    }

    /// On a circle the tour along it is the shortest, 2 n sin(π/n) long, however the stops are numbered.
    #[test]
    fn stops_on_a_circle_are_visited_in_turn() {
        for count in [3, 7, 13, 14, 40] {
            let place = |k: usize| {
                let angle = std::f64::consts::TAU * (k * 17 % count) as f64 / count as f64;
                [angle.cos(), angle.sin()]
            };
            let lengths = Lengths::new(count, |i, j| f64::hypot(place(i)[0] - place(j)[0], place(i)[1] - place(j)[1]));
            let around = 2.0 * count as f64 * (std::f64::consts::PI / count as f64).sin();
            assert!((lengths.around(&short_tour(&lengths)) - around).abs() < 1e-12, "{count}");
            assert!((least_length(&lengths) - around).abs() < 1e-3 * around, "{count}");
        }
    }

    #[test]
    fn stops_without_a_way_are_avoided_and_found_out() {
        for count in [6, 20] {
            // Only neighbours in a ring are linked.
            let ring = |i: usize, j: usize| if j - i == 1 || j - i == count - 1 { 1.0 } else { f64::INFINITY };
            let lengths = Lengths::new(count, ring);
            assert_eq!(lengths.around(&short_tour(&lengths)), count as f64);
            assert!((least_length(&lengths) - count as f64).abs() < 1e-6);
            // A stop with one neighbour: there is no tour.
            let lengths = Lengths::new(count, |i, j| if i == 0 && j > 1 { f64::INFINITY } else { ring(i, j) });
            let order = short_tour(&lengths);
            visits_all(&order, count);
            assert!(lengths.around(&order).is_infinite());
        }
    }

    #[test]
    fn equal_places_cost_nothing() {
        let lengths = Lengths::new(30, |i, j| if i % 3 == j % 3 { 0.0 } else { 1.0 });
        assert_eq!(lengths.around(&short_tour(&lengths)), 3.0);
        assert!(least_length(&lengths) <= 3.0);
    }
}
