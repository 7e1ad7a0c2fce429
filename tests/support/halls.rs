//! Halls of 12 × 8 × 6 m with machines, shelves, pillars, crates and ducts, and stations in them.

use cdpr_core::collision::Checker;
use cdpr_core::decomposition::{Decomposition, Taste, Way};
use cdpr_core::geometry::Point;
use cdpr_core::model::{BodySpec, Scene};
use cdpr_core::testing::block;
use cdpr_core::watch::Watch;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::{built_scene, rng, uniform};

/// Sides of the hall, m.
const HALL: [f64; 3] = [12.0, 8.0, 6.0];
/// Free floor between groups of parts and along the walls, m.
const AISLE: f64 = 0.1;
/// Highest station, m: work is done near the floor.
const HIGHEST_STATION: f64 = 1.2;
/// Stations are reached through openings that are not much narrower than this, m.
const SMALLEST_CELL: f64 = 0.02;
/// Effort to find out whether a station can be reached, in cells.
const STATION_EFFORT: usize = 1_000_000;
/// Least distance between the two stations of a pair, m.
const APART: f64 = 3.0;

/// Parts that are placed as one, around the middle of their footprint on the floor.
struct Group {
    /// Sides of the footprint, m.
    footprint: [f64; 2],
    parts: Vec<Part>,
}

/// Draws the sizes of a group.
type Draw = fn(&mut ChaCha8Rng) -> Group;

/// A box: sides and centre in m, the latter from the middle of the footprint.
struct Part {
    sides: [f64; 3],
    center: [f64; 3],
}

/// How many groups of each kind stand or hang in a hall.
pub struct Inventory {
    /// Bed, column and overhanging head: 3 parts each.
    pub machines: usize,
    /// Two uprights and three boards: 5 parts each.
    pub shelves: usize,
    pub pillars: usize,
    /// A duct and its two hangers: 3 parts each.
    pub ducts: usize,
    /// A crate upon a larger one: 2 parts each.
    pub crates: usize,
    /// Two posts and a beam: 3 parts each.
    pub gates: usize,
}

/// 60 parts.
pub const FULL: Inventory = Inventory { machines: 6, shelves: 3, pillars: 7, ducts: 3, crates: 4, gates: 1 };

/// A hall with the robot of the forest.
pub fn hall(seed: u64, inventory: &Inventory) -> Scene {
    let mut rng = rng(seed);
    let draws: [(&str, usize, Draw); 6] = [
        ("shelf", inventory.shelves, shelf),
        ("machine", inventory.machines, machine),
        ("gate", inventory.gates, gate),
        ("duct", inventory.ducts, duct),
        ("crates", inventory.crates, crates),
        ("pillar", inventory.pillars, pillar),
    ];
    let mut spec = built_scene("forest").spec().clone();
    spec.name = Some(format!("hall {seed}"));
    spec.query = None;
    spec.wrench = None;
    spec.obstacles.clear();
    let mut taken = Vec::new();
    for (name, count, draw) in draws {
        for number in 1..=count {
            let group = draw(&mut rng);
            let turned = name != "duct" && rng.random_bool(0.5);
            let middle = match name {
                "duct" => along_wall(&mut rng, &group),
                _ => place(&mut rng, &group, turned, &mut taken),
            };
            spec.obstacles.extend(group.parts.iter().map(|part| part.at(&format!("{name} {number}"), middle, turned)));
        }
    }
    Scene::new(spec).expect("a sound hall")
}

/// Pairs of stations between which the straight line is blocked: positions near the floor, rounded to centimetres, that can be
/// reached from above.
pub fn station_pairs(engine: &dyn Checker, seed: u64) -> impl Iterator<Item = [Point; 2]> {
    let mut rng = rng(seed ^ 0x57A7);
    let above = over_the_parts(engine);
    let (low, high) = engine.conditions().position_box();
    let pieces = engine.pieces(&Watch::NONE).expect("no deadline");
    let mut cells = Decomposition::new(pieces, low, high).down_to(SMALLEST_CELL);
    let free = |from: &Point, to: &Point| engine.motion_valid(from, to);
    let wide = Taste { level: 5, heuristic_weight: 2.0 };
    let mut reachable = move |place: &Point| {
        let mut way = || cells.way([place, &above], &free, wide, STATION_EFFORT, &Watch::NONE);
        engine.state_valid(place) && matches!(way(), Ok(Way::Path(_)))
    };
    let mut station = move || loop {
        let place =
            [HALL[0], HALL[1], HIGHEST_STATION].map(|most| (100.0 * uniform(&mut rng, 0.0, most)).round() / 100.0);
        let place = Point::from(place);
        if reachable(&place) {
            return place;
        }
    };
    std::iter::repeat_with(move || [station(), station()])
        .filter(|[a, b]| (b - a).norm() >= APART && !engine.motion_valid(a, b))
}

/// A valid position in the middle of the hall, as high as possible.
fn over_the_parts(engine: &dyn Checker) -> Point {
    let heights = (0..60).map(|k| HALL[2] - 0.6 - 0.05 * f64::from(k));
    let places = heights.map(|z| Point::new(0.5 * HALL[0], 0.5 * HALL[1], z));
    places.into_iter().find(|place| engine.state_valid(place)).expect("the middle is free somewhere")
}

impl Part {
    fn at(&self, name: &str, [x, y]: [f64; 2], turned: bool) -> BodySpec {
        let ([sx, sy, sz], [cx, cy, cz]) = (self.sides, self.center);
        match turned {
            false => block(name, [sx, sy, sz], [x + cx, y + cy, cz]),
            true => block(name, [sy, sx, sz], [x - cy, y + cx, cz]),
        }
    }
}

/// A free place on the floor for a group, whose rectangle is then taken; after many attempts wherever it fits into the hall.
fn place(rng: &mut ChaCha8Rng, group: &Group, turned: bool, taken: &mut Vec<[[f64; 2]; 2]>) -> [f64; 2] {
    let [a, b] = group.footprint;
    let half = if turned { [0.5 * b, 0.5 * a] } else { [0.5 * a, 0.5 * b] };
    let mut middle = [0.0; 2];
    for _ in 0..1000 {
        middle = [0, 1].map(|k| uniform(rng, half[k] + AISLE, HALL[k] - half[k] - AISLE));
        let apart =
            |other: &[[f64; 2]; 2]| (0..2).any(|k| (middle[k] - other[0][k]).abs() > half[k] + other[1][k] + AISLE);
        if taken.iter().all(apart) {
            break;
        }
    }
    taken.push([middle, half]);
    middle
}

/// A place along one of the long walls: ducts hang there, out of the way of most cables.
fn along_wall(rng: &mut ChaCha8Rng, group: &Group) -> [f64; 2] {
    let [half, y] = [0.5 * group.footprint[0], 0.5 * group.footprint[1] + AISLE];
    [uniform(rng, half, HALL[0] - half), if rng.random_bool(0.5) { y } else { HALL[1] - y }]
}

fn part(sides: [f64; 3], center: [f64; 3]) -> Part {
    Part { sides, center }
}

fn machine(rng: &mut ChaCha8Rng) -> Group {
    let mut in_range = |low, high| uniform(rng, low, high);
    let [length, width, bed] = [in_range(1.0, 2.0), in_range(0.7, 1.1), in_range(0.5, 0.9)];
    let [column, height, head] = [in_range(0.3, 0.5), in_range(1.3, 2.0), in_range(0.3, 0.4)];
    let reach = in_range(0.3, 0.6) * length;
    let x = 0.5 * (column - length);
    Group {
        footprint: [length, width],
        parts: vec![
            part([length, width, bed], [0.0, 0.0, 0.5 * bed]),
            part([column, 0.8 * width, height - bed], [x, 0.0, 0.5 * (bed + height)]),
            part([reach, 0.5 * width, head], [x + 0.5 * (column + reach), 0.0, height - 0.5 * head]),
        ],
    }
}

fn shelf(rng: &mut ChaCha8Rng) -> Group {
    let mut in_range = |low, high| uniform(rng, low, high);
    let [length, depth, height] = [in_range(1.6, 2.8), in_range(0.4, 0.6), in_range(1.2, 2.0)];
    const BOARD: f64 = 0.05;
    let upright = |side: f64| part([BOARD, depth, height], [0.5 * side * (length - BOARD), 0.0, 0.5 * height]);
    let board = |share: f64| part([length - 2.0 * BOARD, depth, BOARD], [0.0, 0.0, share * height - 0.5 * BOARD]);
    let parts = vec![upright(-1.0), upright(1.0), board(0.2), board(0.6), board(1.0)];
    Group { footprint: [length, depth], parts }
}

fn pillar(rng: &mut ChaCha8Rng) -> Group {
    let [side, height] = [uniform(rng, 0.2, 0.4), uniform(rng, 1.2, 2.6)];
    Group { footprint: [side; 2], parts: vec![part([side, side, height], [0.0, 0.0, 0.5 * height])] }
}

fn crates(rng: &mut ChaCha8Rng) -> Group {
    let [lower, upper] = [uniform(rng, 0.6, 1.0), uniform(rng, 0.3, 0.6)];
    let offset = 0.5 * (lower - upper) * uniform(rng, -1.0, 1.0);
    let parts =
        vec![part([lower; 3], [0.0, 0.0, 0.5 * lower]), part([upper; 3], [offset, offset, lower + 0.5 * upper])];
    Group { footprint: [lower; 2], parts }
}

/// Hangs from the roof.
fn duct(rng: &mut ChaCha8Rng) -> Group {
    let [length, side, height] = [uniform(rng, 1.5, 3.0), uniform(rng, 0.2, 0.4), uniform(rng, 3.8, 4.8)];
    const HANGER: f64 = 0.05;
    let hanger = |end: f64| {
        let top = HALL[2] - height - side;
        part([HANGER, HANGER, top], [0.4 * end * length, 0.0, HALL[2] - 0.5 * top])
    };
    let parts = vec![part([length, side, side], [0.0, 0.0, height + 0.5 * side]), hanger(-1.0), hanger(1.0)];
    Group { footprint: [length, side], parts }
}

fn gate(rng: &mut ChaCha8Rng) -> Group {
    let [length, side, height] = [uniform(rng, 2.4, 3.2), uniform(rng, 0.2, 0.3), uniform(rng, 1.8, 2.4)];
    let post = |end: f64| part([side, side, height], [0.5 * end * (length - side), 0.0, 0.5 * height]);
    let beam = part([length, side, side], [0.0, 0.0, height + 0.5 * side]);
    Group { footprint: [length, side], parts: vec![post(-1.0), post(1.0), beam] }
}
