//! False certificates, made on purpose: of scenes with a path of known length, that there is none or that none is so short. They are
//! built from nothing, or taken from harder scenes with the same names, and then damaged. None may be accepted.

mod support;

use cdpr_core::compiled::CompiledScene;
use std::io::Write;
use std::sync::Arc;

use cdpr_certify::{check_bound, check_certificate, is_bound};
use cdpr_core::Scene;
use cdpr_core::geometry::Point;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{NoPath, PlanOptions, Query, plan};
use cdpr_core::planning::Status;
use cdpr_core::watch::Watch;
use serde_json::{Value, json};

use support::Random;

/// Additional gap that the path keeps beyond every required one, m: far more than any margin.
const SPARE: f64 = 2e-5;

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.below(1 << 30) as f64 / (1u64 << 30) as f64)
    }

    fn of<T: Clone>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())].clone()
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }
}

/// The name of an obstacle, and the box of positions that it forbids to the platform.
type Wall = (String, [[f64; 3]; 2]);

/// A scene with a path between two positions.
struct Case {
    spec: Value,
    scene: Scene,
    ends: [[f64; 3]; 2],
    /// The length of a path that keeps all gaps by more than any margin, m; the path may touch what an end touches.
    length: f64,
    walls: Vec<Wall>,
    /// The box of positions.
    bounds: [[f64; 3]; 2],
    /// True certificates of harder scenes with the same names.
    harder: Vec<Value>,
    /// True certificates of the scene.
    own: Vec<Value>,
}

fn build(spec: &Value) -> Option<Scene> {
    Scene::new(serde_json::from_value(spec.clone()).ok()?).ok()
}

/// A scene without start and goal, the boxes that its obstacles forbid, and its box of positions.
fn draw(random: &mut Random) -> (Value, Vec<Wall>, [[f64; 3]; 2]) {
    let half: [f64; 3] = if random.one_in(2) { [0.0; 3] } else { std::array::from_fn(|_| random.of(&[0.0625, 0.125])) };
    let corner = |k: usize| -> [f64; 3] { std::array::from_fn(|i| half[i] * if k >> i & 1 == 1 { 1.0 } else { -1.0 }) };
    let body = if half == [0.0; 3] { vec![[0.0; 3]] } else { (0..8).map(corner).collect() };
    let mut walls = Vec::new();
    let mut obstacles = Vec::new();
    for k in 0..1 + random.below(4) {
        // Obstacles on a coarse grid, so that they touch each other and the sides of the workspace, and plates.
        let low: [f64; 3] = std::array::from_fn(|_| 0.25 * random.below(7) as f64);
        let size: [f64; 3] = std::array::from_fn(|_| random.of(&[0.25, 0.5, 1.0, 2.0, 1e-3]));
        let name = format!("wall {k}");
        let position: [f64; 3] = std::array::from_fn(|i| low[i] + 0.5 * size[i]);
        obstacles.push(json!({"name": name, "box": size, "position": position}));
        let forbidden = [0, 1].map(|side| {
            std::array::from_fn(|i| {
                let sign = if side == 1 { 1.0 } else { -1.0 };
                position[i] + sign * (0.5 * size[i] + half[i])
            })
        });
        walls.push((name, forbidden));
    }
    let count = 1 + random.below(3);
    let cables: Vec<Value> = (0..count)
        .map(|k| {
            let outlet = [random.between(0.0, 2.0), random.between(0.0, 2.0), 2.5 + 0.25 * k as f64];
            let attachment = [0.25 * half[0] * k as f64, 0.0, half[2]];
            let mut cable = json!({"name": format!("cable {k}"), "outlet": outlet, "attachment": attachment});
            if random.one_in(3) {
                cable["diameter"] = 0.01.into();
            }
            if random.one_in(4) {
                cable["length"] = json!([0.1, random.between(2.0, 4.0)]);
            }
            cable
        })
        .collect();
    let mut ignored: Vec<[String; 2]> = Vec::new();
    for cable in (0..count).map(|k| format!("cable {k}")) {
        if !random.one_in(3) {
            ignored.extend(walls.iter().map(|(name, _)| [cable.clone(), name.clone()]));
        }
    }
    let clearance = random.of(&[0.0, 0.0, 0.03125]);
    let spec = json!({
        "version": 1, "workspace": {"min": [0.0, 0.0, 0.0], "max": [2.0, 2.0, 2.0]}, "clearance": clearance,
        "robot": {"platform": [{"vertices": body}], "cables": cables}, "obstacles": obstacles, "ignore": ignored,
    });
    (spec, walls, [half, half.map(|h| 2.0 - h)])
}

/// A copy of a scene that requires larger gaps.
fn tighter(spec: &Value, more: f64) -> Value {
    let mut spec = spec.clone();
    spec["clearance"] = (spec["clearance"].as_f64().unwrap() + more).into();
    for cable in spec["robot"]["cables"].as_array_mut().unwrap() {
        if let Some(length) = cable.get_mut("length") {
            *length = json!([length[0].as_f64().unwrap() + more, length[1].as_f64().unwrap() - more]);
        }
    }
    spec
}

fn with_ends(spec: &Value, [start, goal]: [[f64; 3]; 2]) -> Value {
    let mut spec = spec.clone();
    spec["query"] = json!({"start": start, "goal": goal});
    spec
}

fn compiled(scene: &Scene) -> Arc<CompiledScene> {
    let options = PlanOptions::default();
    CompiledScene::new(scene, options.engine, options.interference, &Watch::NONE).unwrap().into()
}

/// The true certificate of a scene: that there is no path, or a bound of the length of its paths.
fn proof_of(spec: &Value) -> Option<Value> {
    let scene = build(spec)?;
    let ends = [scene.start()?, scene.goal()?];
    let ends = [&ends[0], &ends[1]];
    let compiled = compiled(&scene);
    let engine = compiled.level();
    let options = PlanOptions::default();
    if let Some(found) = NoPath::decided(&scene, engine, ends, &options, &Watch::NONE).ok()? {
        return serde_json::to_value(found.certificate).ok();
    }
    let result = plan(Query::of(&scene).by(&compiled), &PlanOptions { proof: false, ..options }, &()).ok()?.result;
    if result.status != Status::Solved {
        return None;
    }
    let forbidden = Forbidden::new(engine, ends, &Watch::NONE).ok()?;
    let found = forbidden.certificate(&scene, 0.999 * result.cost, 30_000, &Watch::NONE).ok()??;
    serde_json::to_value(&found).ok()
}

impl Case {
    fn draw(random: &mut Random) -> Case {
        loop {
            if let Some(case) = Case::try_draw(random) {
                return case;
            }
        }
    }

    fn try_draw(random: &mut Random) -> Option<Case> {
        let (spec, walls, bounds) = draw(random);
        let scene = build(&tighter(&spec, SPARE))?;
        let compiled = compiled(&scene);
        let engine = compiled.level();
        // Ends inside, on sides, on edges and in corners of the box of positions.
        let mut inside = || -> [f64; 3] {
            std::array::from_fn(|i| match random.below(3) {
                0 => bounds[0][i],
                1 => bounds[1][i],
                _ => random.between(bounds[0][i], bounds[1][i]),
            })
        };
        let mut ends = [inside(), inside()];
        let mut length = 0.0;
        let mut begin = ends;
        // Or a start in contact with an obstacle, from where the path leads away.
        if random.one_in(3) && spec["clearance"] == 0.0 {
            let (_, [low, high]) = &walls[random.below(walls.len())];
            let (axis, side) = (random.below(3), random.below(2));
            let mut at: [f64; 3] =
                std::array::from_fn(|i| random.between(low[i].max(bounds[0][i]), high[i].min(bounds[1][i])));
            at[axis] = [low, high][side][axis];
            ends[0] = at;
            at[axis] += (2.0 * side as f64 - 1.0) * 2.0 * SPARE;
            begin[0] = at;
            length += 2.0 * SPARE;
        }
        let points = begin.map(Point::from);
        if !points.iter().all(|point| engine.state_valid(point)) {
            return None;
        }
        let query = Query { start: Some(points[0]), goal: Some(points[1]), ..Query::of(&scene) }.by(&compiled);
        let result = plan(query, &PlanOptions { proof: false, ..PlanOptions::default() }, &()).ok()?.result;
        if result.status != Status::Solved {
            return None;
        }
        length += result.cost;
        let asked = with_ends(&spec, ends);
        let scene = build(&if random.one_in(4) { spec.clone() } else { asked.clone() })?;
        // Harder questions about the same names: larger clearances, another wall, thicker walls.
        let mut harder = Vec::new();
        for way in [1, random.below(5)] {
            let mut other = asked.clone();
            let k = random.below(walls.len());
            match way {
                0 => other["clearance"] = random.of(&[0.05, 0.1, 0.2]).into(),
                1 | 4 => {
                    let apart = |i: &usize| (ends[0][*i] - ends[1][*i]).abs();
                    let axis = (0..3).max_by(|i, j| apart(i).total_cmp(&apart(j))).expect("three axes");
                    let size: [f64; 3] =
                        std::array::from_fn(|i| if i == axis { random.of(&[1e-3, 0.05]) } else { 8.0 });
                    let mut position = [1.0; 3];
                    position[axis] = 0.5 * (ends[0][axis] + ends[1][axis]);
                    other["obstacles"][k] = json!({"name": walls[k].0, "box": size, "position": position});
                }
                2 => {
                    let size = &mut other["obstacles"][k]["box"];
                    let axis = random.below(3);
                    size[axis] = (size[axis].as_f64().unwrap() + 2.0 * random.of(&[1e-5, 1e-3, 0.1, 0.5])).into();
                }
                _ => {
                    for cable in other["robot"]["cables"].as_array_mut().unwrap() {
                        cable["length"] = json!([0.1, random.between(0.5, 3.0)]);
                    }
                    other["ignore"] = json!([]);
                }
            }
            harder.extend(proof_of(&other));
        }
        let own = proof_of(&asked).into_iter().collect();
        Some(Case { spec, scene, ends, length, walls, bounds, harder, own })
    }

    /// A number near which decisions change.
    fn little(random: &mut Random) -> f64 {
        let size = random.of(&[
            0.0, 4e-13, 9e-13, 1.1e-12, 1e-10, 4e-10, 1e-9, 2e-9, 1e-8, 1e-7, 5e-7, 9e-7, 9.9e-7, 1e-6, 2e-6, 1e-3,
        ]);
        if random.one_in(2) { size } else { -size }
    }

    /// Half-spaces that hold what an obstacle forbids, more, less, nothing, or everything.
    fn region(&self, random: &mut Random) -> Value {
        let (mut name, [low, high]) = self.walls[random.below(self.walls.len())].clone();
        let mut rows: Vec<[f64; 4]> = Vec::new();
        let by = Case::little(random);
        let normal =
            |axis: usize, sign: f64| -> [f64; 3] { std::array::from_fn(|i| if i == axis { sign } else { 0.0 }) };
        let row = |n: [f64; 3], d: f64| [n[0], n[1], n[2], d];
        match random.below(5) {
            // Beyond a side of the box of positions, with a start or goal that may be there.
            0 => {
                let (axis, side) = (random.below(3), random.below(2));
                let sign = 2.0 * side as f64 - 1.0;
                let at = self.bounds[side][axis] * sign;
                rows.push(row(normal(axis, -sign), -at - by));
                rows.push(row(normal(axis, sign), at + random.of(&[0.1, 1e-3, 1e-12])));
            }
            // Around an end.
            1 => {
                let end = self.ends[random.below(2)];
                let size = random.of(&[1e-12, 1e-9, 1e-6, 0.1]);
                for axis in 0..3 {
                    rows.push(row(normal(axis, 1.0), end[axis] + size));
                    rows.push(row(normal(axis, -1.0), -end[axis] + size));
                }
            }
            _ => {
                for axis in 0..3 {
                    rows.push(row(normal(axis, 1.0), high[axis] + by));
                    rows.push(row(normal(axis, -1.0), -low[axis] + by));
                }
            }
        }
        for _ in 0..random.below(3) {
            let k = random.below(rows.len().max(1));
            if rows.is_empty() {
                break;
            }
            match random.below(7) {
                0 => drop(rows.remove(k)),
                1 => rows.push(rows[k]),
                2 => rows[k] = rows[k].map(|x| -x),
                3 => {
                    let factor = random.of(&[1e-300, 1e-12, 1e-9, 0.5, 2.0, 1e9, 1e12]);
                    rows[k] = rows[k].map(|x| x * factor);
                }
                4 => rows[k] = [0.0, 0.0, 0.0, random.of(&[-1.0, 0.0, 1.0])],
                5 => rows.push(rows[k].map(|x| -x)),
                _ => rows.clear(),
            }
        }
        if random.one_in(8) {
            name = random.of(&["cable 0", "cable 1", "platform", "wrench", "", "wall 9"]).to_string();
        }
        let other = random.of(&["platform", "platform", "platform", "platform", "cable 0", "wall 0"]);
        json!({"who": [other, name], "half_spaces": rows})
    }

    /// The keys that both kinds of certificates share.
    fn head(&self, random: &mut Random) -> Value {
        let mut bounds = self.bounds;
        for _ in 0..random.below(3) {
            bounds[random.below(2)][random.below(3)] += Case::little(random);
        }
        if random.one_in(40) {
            let (axis, from) = (random.below(3), random.below(2));
            bounds[1 - from][axis] = bounds[from][axis]; // flat
        }
        let margin =
            if random.one_in(20) { random.of(&[0.0, 1e-9, 2e-6, 1.0, -1e-6]) } else { random.of(&[1e-8, 1e-7, 1e-6]) };
        json!({
            "version": 1, "scene": self.scene.fingerprint(), "orientation": [1.0, 0.0, 0.0, 0.0], "margin": margin,
            "start": self.ends[0], "goal": self.ends[1], "box": bounds,
            "regions": (0..random.below(4)).map(|_| self.region(random)).collect::<Vec<_>>(),
        })
    }

    /// A certificate made up from nothing, which claims that there is no path: the box of positions is cut at random, and all parts are
    /// declared closed except the two that contain start and goal.
    fn no_path_from_nothing(&self, random: &mut Random) -> Value {
        let mut found = self.head(random);
        found["format"] = "cdpr-proof".into();
        let bounds: [[f64; 3]; 2] = serde_json::from_value(found["box"].clone()).unwrap();
        let mut cells = vec![bounds];
        let faces: Vec<[f64; 3]> = self.walls.iter().flat_map(|(_, sides)| *sides).chain(self.ends).collect();
        for _ in 0..random.below(12) {
            let k = random.below(cells.len());
            let (cell, axis) = (cells[k], random.below(3));
            let cut = match random.below(3) {
                0 => 0.5 * (cell[0][axis] + cell[1][axis]),
                1 => random.of(&faces)[axis] + Case::little(random),
                _ => random.of(&faces)[axis],
            };
            if cell[0][axis] < cut && cut < cell[1][axis] || random.one_in(50) {
                let mut other = cell;
                cells[k][1][axis] = cut;
                other[0][axis] = cut;
                cells.push(other);
            }
        }
        let regions = found["regions"].as_array().unwrap().len();
        let holds = |cell: &[[f64; 3]; 2], at: &[f64; 3]| (0..3).all(|i| cell[0][i] <= at[i] && at[i] <= cell[1][i]);
        let wall = random.of(&self.walls).0;
        let reasons = [
            json!(["platform", wall]),
            json!(["cable 0", wall]),
            json!(["cable 0"]),
            json!(["cable 0", "cable 1"]),
            json!(["cable 0", "platform"]),
            json!(["wrench", 0, 0, 1, 0, 0, 0]),
            json!(["platform"]),
            json!([]),
        ];
        let rows: Vec<Value> = cells
            .iter()
            .map(|cell| {
                let mut row: Vec<Value> = cell.as_flattened().iter().map(|x| json!(x)).collect();
                let open = self.ends.iter().any(|end| holds(cell, end)) && !random.one_in(8);
                match random.below(3) {
                    _ if open => row.push(json!(-1)),
                    0 if regions > 0 => row.push(json!(random.below(regions))),
                    1 => row.push(json!(-1)),
                    _ => row.extend([json!(-2), random.of(&reasons)]),
                }
                Value::from(row)
            })
            .collect();
        found["boxes"] = rows.into();
        found
    }

    /// A certificate from nothing that no path is as short as the known one: edges of boxes with labels.
    fn bound_from_nothing(&self, random: &mut Random) -> Value {
        let mut found = self.head(random);
        found["format"] = "cdpr-bound".into();
        let length = self.length + random.of(&[1e-6, 1e-3, 1.0, 100.0]);
        found["length"] = length.into();
        let regions: Vec<Value> = found["regions"].as_array().unwrap().clone();
        let mut edges = Vec::new();
        for region in 0..regions.len() {
            let rows: Vec<[f64; 4]> = serde_json::from_value(regions[region]["half_spaces"].clone()).unwrap();
            for (a, b) in (0..rows.len()).flat_map(|a| (0..a).map(move |b| (a, b))) {
                let axis = |row: &[f64; 4]| (0..3).find(|i| row[*i].abs() == 1.0);
                let (Some(i), Some(j)) = (axis(&rows[a]), axis(&rows[b])) else { continue };
                if i == j || random.one_in(10) {
                    continue;
                }
                let mut ends = self.bounds;
                for end in &mut ends {
                    (end[i], end[j]) = (rows[a][3] * rows[a][i], rows[b][3] * rows[b][j]);
                }
                let label = random.of(&[0.0, 1.0, length]);
                edges.push(json!({"region": region, "planes": [a, b], "ends": ends, "pieces": [[1.0, label, label]]}));
            }
        }
        found["edges"] = edges.into();
        let corner = |random: &mut Random| {
            let [x, y, z] = random.of(&self.walls).1[0];
            json!([x, y, z, random.of(&[0.0, 1.0, length])])
        };
        found["corners"] = (0..random.below(3)).map(|_| corner(random)).collect::<Vec<_>>().into();
        found
    }

    /// A bound of paths between ends that may lie outside the box or inside a region, by nothing else.
    fn beyond_a_side(&self, random: &mut Random) -> Value {
        let mut found = self.bound_from_nothing(random);
        let (end, axis) = (self.ends[random.below(2)], random.below(3));
        let side = usize::from(end[axis] > 1.0);
        let sign = 2.0 * side as f64 - 1.0;
        let at = if random.one_in(2) { end[axis] } else { self.bounds[side][axis] };
        let [to, by] = [0, 1].map(|_| Case::little(random).abs());
        let mut planes = [[0.0; 4]; 2];
        (planes[0][axis], planes[0][3]) = (-sign, -sign * at + by.min(to));
        (planes[1][axis], planes[1][3]) = (sign, sign * at + 0.1);
        found["regions"] = json!([{"who": ["platform", random.of(&self.walls).0], "half_spaces": planes}]);
        found["box"] = json!(self.bounds);
        found["box"][side][axis] = (at - sign * by.max(to)).into();
        found["margin"] = 1e-6.into();
        (found["edges"], found["corners"]) = (json!([]), json!([]));
        found
    }

    /// A true certificate of a harder question as one about this scene.
    fn borrowed(&self, random: &mut Random) -> Option<Value> {
        let whole = if random.one_in(4) { &self.own } else { &self.harder };
        let mut found = whole.get(random.below(whole.len().max(1)))?.clone();
        found["scene"] = self.scene.fingerprint().into();
        if found.get("length").is_some() && random.one_in(2) {
            let least = found["length"].as_f64().unwrap();
            found["length"] = (least.max(self.length) + random.of(&[1e-6, 1e-3, 0.1])).into();
        }
        for _ in 0..random.of(&[0, 0, 1, 2, 5]) {
            self.damage(&mut found, random);
        }
        Some(found)
    }

    /// Changes a number, a list or a region somewhere.
    fn damage(&self, found: &mut Value, random: &mut Random) {
        if random.one_in(4) {
            let region = self.region(random);
            if let Some(regions) = found["regions"].as_array_mut() {
                regions.push(region);
            }
            return;
        }
        if random.one_in(4) {
            let (side, axis, by) = (random.below(2), random.below(3), Case::little(random));
            let old = found["box"][side][axis].as_f64();
            if let Some(old) = old {
                found["box"][side][axis] = (old + by).into();
            }
            return;
        }
        let key =
            random.of(&["regions", "boxes", "edges", "corners", "box", "margin", "length", "orientation", "start"]);
        if let Some(value) = found.get_mut(key) {
            alter(value, random);
        }
    }

    fn forged(&self, random: &mut Random) -> Value {
        let mut found = match random.below(6) {
            0 | 1 => self.no_path_from_nothing(random),
            2 | 3 => self.bound_from_nothing(random),
            4 => self.beyond_a_side(random),
            _ => self.borrowed(random).unwrap_or_else(|| self.no_path_from_nothing(random)),
        };
        if self.scene.start().is_none() {
            (found["start"], found["goal"]) = (json!(self.ends[0]), json!(self.ends[1]));
        }
        found
    }
}

/// Changes a number or a list somewhere in a value.
fn alter(value: &mut Value, random: &mut Random) {
    match value {
        Value::Array(items) if !items.is_empty() => {
            let k = random.below(items.len());
            if !random.one_in(8) {
                return alter(&mut items[k], random);
            }
            match random.below(4) {
                0 => drop(items.remove(k)),
                1 => items.push(items[k].clone()),
                2 => items.reverse(),
                _ => items.clear(),
            }
        }
        Value::Object(table) => {
            let k = random.below(table.len());
            alter(table.values_mut().nth(k).expect("tables have keys"), random);
        }
        Value::Number(old) => {
            let old = old.as_f64().unwrap();
            *value = match random.below(6) {
                0 => (old + Case::little(random)).into(),
                1 => (-old).into(),
                2 => random.of(&[0.0, 1.0, -1.0, -2.0, 1e-300, 1e12, 1e300]).into(),
                3 => old.next_up().into(),
                4 => (old as i64 + random.below(3) as i64 - 1).into(),
                _ => (old * random.of(&[0.5, 1.0 + 1e-9, 2.0, 1e9])).into(),
            };
        }
        _ => {}
    }
}

fn accepted(scene: &Scene, text: &str) -> bool {
    if is_bound(text) {
        check_bound(scene, text, &Watch::NONE).is_ok()
    } else {
        check_certificate(scene, text, &Watch::NONE).is_ok()
    }
}

/// Most forged certificates of one scene.
const PER_CASE: usize = 250;

/// `CDPR_VERIFY=n` draws n times as many scenes. `CDPR_FORGED=file` writes them all, for the checker in Python: the scene, the
/// certificates, and whether this one accepts each.
#[test]
fn no_false_certificate_is_accepted() {
    let scale: usize = std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse().expect("CDPR_VERIFY is a number"));
    let mut file = std::env::var("CDPR_FORGED").ok().map(|name| std::fs::File::create(name).unwrap());
    let (mut tried, mut taken, mut borrowed, mut own) = (0, 0, [0, 0], [0, 0]);
    for seed in 0..4 * scale {
        let mut random = Random(seed as u64);
        let case = Case::draw(&mut random);
        let mut written = Vec::new();
        for proof in &case.own {
            let asked = build(&with_ends(&case.spec, case.ends)).unwrap();
            own[usize::from(accepted(&asked, &proof.to_string()))] += 1;
        }
        for proof in &case.harder {
            borrowed[usize::from(proof["format"] == "cdpr-bound")] += 1;
        }
        for round in 0..PER_CASE {
            let found = case.forged(&mut random);
            let text = found.to_string();
            let is_accepted = accepted(&case.scene, &text);
            let is_false = found["format"] == "cdpr-proof"
                || found["length"].as_f64().is_none_or(|length| length > case.length + 1e-7);
            tried += usize::from(is_false);
            taken += usize::from(is_accepted);
            if is_accepted && is_false {
                let scene = serde_json::to_string(&case.spec).unwrap();
                panic!("seed {seed}, round {round}: accepted {text}\nof {scene}\nwith a path of {} m", case.length);
            }
            if file.is_some() {
                written.push(json!([found, is_accepted]));
            }
        }
        if let Some(file) = &mut file {
            let spec = if case.scene.start().is_none() { case.spec.clone() } else { with_ends(&case.spec, case.ends) };
            writeln!(file, "{}", json!({"scene": spec, "length": case.length, "certificates": written})).unwrap();
        }
    }
    println!(
        "{tried} false certificates; {taken} true ones accepted; borrowed {borrowed:?}; own, refused and accepted {own:?}"
    );
    assert!(tried > 900 * scale && taken > 0 && borrowed.iter().all(|count| *count > 0));
    assert!(own[1] >= 5 * own[0], "{own:?}");
}
