//! RRT-Connect: two trees take turns; one extends by one step towards a random sample, then the other steps repeatedly
//! towards the new node (J. J. Kuffner and S. M. LaValle, "RRT-connect: an efficient approach to single-query path
//! planning", ICRA 2000).

use rand::Rng;

use super::bidirectional::{Half, into_search_tree, path_through};
use super::outcome::Outcome;
use super::search::Search;
use super::space::{Problem, StateSpace, steer};
use crate::error::Error;

/// Default of the longest edge, as a share of the largest distance in the space.
pub const STEP_SHARE: f64 = 0.2;

/// How a step of a tree towards a state ended; the names are those of Kuffner and LaValle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Step {
    /// The motion is not free: no new node.
    Trapped,
    /// A new node, one step closer.
    Advanced(usize),
    /// A new node at the state itself.
    Reached(usize),
}

/// Searches for a path by RRT-Connect. Stops at the first path, or continues up to the limits and keeps the shortest
/// path.
///
/// `step` is the longest edge of the trees, m; by default [`STEP_SHARE`] of the largest distance in the space.
///
/// The straight line from start to goal is tried first, as by all planners but `rrt` and `rrt-star`. A new state is
/// first tested as a state, which is not counted as a motion check. Samples are not tested, since a tree may grow
/// towards an invalid sample.
///
/// # Errors
/// [`Error::interrupted`] if the watch requests it before there is a path.
pub(super) fn rrt_connect<S: StateSpace>(
    mut search: Search<S>,
    step: Option<f64>,
    rng: &mut impl Rng,
) -> Result<Outcome<S::State>, Error> {
    let problem = search.problem;
    let Problem { space, start, goal } = problem;
    let step = step.unwrap_or(STEP_SHARE * space.largest_distance());
    let mut path = if search.collision_free(start, goal) { vec![*start, *goal] } else { Vec::new() };
    let mut best = space.length(&path);
    let mut trees = Half::of_both_ends(problem);
    let mut turn = 0;
    while !search.over(nodes(&trees), best, || path.clone()) {
        let Some(x_rand) = search.random_sample(rng) else { continue };
        let other = 1 - turn;
        if let Step::Advanced(x_new) | Step::Reached(x_new) = extend(&mut search, &mut trees[turn], &x_rand, step)? {
            let target = *trees[turn].tree.state(x_new);
            if let Step::Reached(x_met) = connect(&mut search, &mut trees, other, &target, step)? {
                let met = if turn == 0 { [x_new, x_met] } else { [x_met, x_new] };
                let found = path_through(&trees, met);
                let length = space.length(&found);
                if length < best {
                    (path, best) = (found, length);
                }
            }
        }
        turn = other; // SWAP
    }
    Ok(search.ended(path, into_search_tree(trees)))
}

/// `EXTEND(T, x)`: one step from the nearest node towards a state.
fn extend<S: StateSpace>(search: &mut Search<S>, half: &mut Half<S>, x: &S::State, step: f64) -> Result<Step, Error> {
    match half.nearest(&search.problem.space, x) {
        Some(nearest) => advance(search, half, nearest, x, step),
        None => Ok(Step::Trapped),
    }
}

/// `CONNECT(T, x)`: steps towards a state until it is reached or a step fails. After a step the new node is the nearest
/// one, so the tree is searched only once.
fn connect<S: StateSpace>(
    search: &mut Search<S>,
    trees: &mut [Half<S>; 2],
    of: usize,
    x: &S::State,
    step: f64,
) -> Result<Step, Error> {
    let Some(mut node) = trees[of].nearest(&search.problem.space, x) else { return Ok(Step::Trapped) };
    while search.has_room(nodes(trees)) {
        match advance(search, &mut trees[of], node, x, step)? {
            Step::Advanced(next) => node = next,
            ended => return Ok(ended),
        }
    }
    Ok(Step::Trapped)
}

/// One step from a node towards a state.
fn advance<S: StateSpace>(
    search: &mut Search<S>,
    half: &mut Half<S>,
    node: usize,
    x: &S::State,
    step: f64,
) -> Result<Step, Error> {
    let space = &search.problem.space;
    let from = *half.tree.state(node);
    let x_new = steer(space, &from, x, step);
    if x_new == from && x_new != *x {
        return Ok(Step::Trapped); // a step smaller than rounding errors
    }
    if !(search.valid(&x_new) && search.collision_free(&from, &x_new)) {
        return Ok(Step::Trapped);
    }
    let new = half.push(space, node, x_new);
    Ok(if x_new == *x { Step::Reached(new) } else { Step::Advanced(new) })
}

/// Number of nodes of both trees.
fn nodes<S: StateSpace>(trees: &[Half<S>; 2]) -> usize {
    trees.iter().map(|half| half.tree.len()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Validity;
    use crate::collision::{Clearance, Violation};
    use crate::geometry::Point;
    use crate::planning::SearchLimits;
    use crate::planning::Status;
    use crate::planning::TranslationSpace;
    use crate::watch::Watch;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    /// Positions beyond a wall at x = `at` can be reached only over its top, at z > 1.
    struct Wall {
        at: f64,
    }

    impl Validity<Point> for Wall {
        fn state_valid(&self, p: &Point) -> bool {
            p.x != self.at || p.z > 1.0
        }

        fn motion_valid(&self, p: &Point, q: &Point) -> bool {
            let crosses = (p.x - self.at) * (q.x - self.at) <= 0.0 && p.x != q.x;
            let height = p.z + (q.z - p.z) * (self.at - p.x) / (q.x - p.x);
            !crosses || height > 1.0
        }

        fn violations(&self, _: &Point, _: &Point) -> Vec<Violation> {
            Vec::new()
        }

        fn clearance(&self, _: &Point, _: &Point) -> Option<Clearance> {
            None
        }
    }

    fn problem(start: [f64; 3], goal: [f64; 3]) -> Problem<TranslationSpace> {
        let space = TranslationSpace { min: Point::origin(), max: Point::new(2.0, 2.0, 2.0) };
        Problem { space, start: start.into(), goal: goal.into() }
    }

    /// A tree with only a root, and a search among the walls.
    fn with_search<T>(
        wall: &Wall,
        test: impl FnOnce(&mut Search<TranslationSpace>, &mut [Half<TranslationSpace>; 2]) -> T,
    ) -> T {
        let problem = problem([0.5, 1.0, 0.5], [1.5, 1.0, 0.5]);
        let mut search = Search::new(&problem, wall, SearchLimits::samples(500_000), &|_, _, _| (), &Watch::NONE);
        test(&mut search, &mut Half::of_both_ends(&problem))
    }

    #[test]
    fn extend_takes_one_step_and_connect_goes_all_the_way() {
        let far = Wall { at: 1.95 };
        with_search(&far, |search, trees| {
            let target = Point::new(0.5, 1.0, 1.25);
            assert_eq!(extend(search, &mut trees[0], &target, 0.2).unwrap(), Step::Advanced(1));
            assert!((trees[0].tree.state(1) - Point::new(0.5, 1.0, 0.7)).norm() < 1e-12);
            assert_eq!(connect(search, trees, 0, &target, 0.2).unwrap(), Step::Reached(4)); // 0.9, 1.1, 1.25
            assert_eq!(*trees[0].tree.state(4), target);
            assert_eq!(trees[0].tree.path_to(4).len(), 5);
        });
    }

    #[test]
    fn connect_stops_before_the_wall_and_keeps_the_steps_up_to_it() {
        with_search(&Wall { at: 1.0 }, |search, trees| {
            let target = Point::new(1.5, 1.0, 0.6);
            assert_eq!(connect(search, trees, 0, &target, 0.2).unwrap(), Step::Trapped);
            let xs: Vec<f64> = (0..trees[0].tree.len()).map(|node| trees[0].tree.state(node).x).collect();
            assert_eq!(xs.len(), 3, "{xs:?}"); // 0.5, 0.7, 0.9
            assert!(xs.iter().all(|x| *x < 1.0));
            assert_eq!(extend(search, &mut trees[0], &target, 0.2).unwrap(), Step::Trapped);
        });
    }

    #[test]
    fn a_step_below_rounding_ends_and_so_does_a_full_tree() {
        with_search(&Wall { at: 1.95 }, |search, trees| {
            let target = Point::new(0.5, 1.0, 1.25);
            assert_eq!(connect(search, trees, 0, &target, 1e-300).unwrap(), Step::Trapped);
        });
        let problem = problem([0.5, 1.0, 0.5], [1.5, 1.0, 0.5]);
        let limits = SearchLimits { max_nodes: 50, ..SearchLimits::samples(500_000) };
        let wall = Wall { at: 1.0 };
        let search = Search::new(&problem, &wall, limits, &|_, _, _| (), &Watch::NONE);
        let found = rrt_connect(search, Some(1e-3), &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
        assert_eq!((found.status, found.tree.states.len()), (Status::BudgetSpent, 50));
    }

    #[test]
    fn the_path_leads_over_the_wall_in_edges_of_one_step_at_most() {
        let problem = problem([0.5, 1.0, 0.5], [1.5, 1.0, 0.5]);
        let wall = Wall { at: 1.0 };
        for seed in 0..50 {
            let search = Search::new(&problem, &wall, SearchLimits::samples(500_000), &|_, _, _| (), &Watch::NONE);
            let found = rrt_connect(search, Some(0.15), &mut ChaCha8Rng::seed_from_u64(seed)).unwrap();
            assert_eq!((found.status, found.history.len()), (Status::Solved, 1));
            let path = &found.waypoints;
            assert_eq!((path[0], path[path.len() - 1]), (problem.start, problem.goal));
            assert!(path.windows(2).all(|pair| wall.motion_valid(&pair[0], &pair[1])));
            let edges = found.tree.edges().map(|[from, to]| (to - from).norm());
            assert!(
                edges.chain(path.windows(2).map(|pair| (pair[1] - pair[0]).norm())).all(|edge| edge < 0.15 + 1e-12)
            );
            assert!(path.iter().any(|p| p.z > 1.0));
        }
    }
}
