//! Certificates of three scenes are accepted; with any damage they are refused.

mod support;

use cdpr_certify::{Cell, Certificate, Check, Status, check_certificate};
use cdpr_core::model::Scene;
use cdpr_core::watch::Watch;

use support::{Random, scenes};

struct Sample {
    scene: Scene,
    /// The scene without start and goal.
    unasked: Scene,
    text: &'static str,
    certificate: Certificate,
}

macro_rules! sample {
    ($name:literal) => {{
        let text = include_str!(concat!("data/", $name, ".json"));
        let [scene, unasked] = scenes(include_str!(concat!("data/", $name, ".scene.json")));
        Sample { scene, unasked, text, certificate: Certificate::parse(text).unwrap() }
    }};
}

fn samples() -> [Sample; 3] {
    [sample!("10-21"), sample!("10-28"), sample!("10-32")]
}

#[test]
fn samples_are_accepted() {
    for (sample, boxes) in samples().iter().zip([330, 239, 239]) {
        let summary = check_certificate(&sample.scene, sample.text, &Watch::NONE).unwrap();
        assert_eq!((summary.boxes, summary.margin), (boxes, 1e-6));
        assert_eq!(summary.regions, sample.certificate.regions.len());
        assert_eq!(sample.certificate.check(&sample.unasked, &Watch::NONE).unwrap(), summary);
    }
}

fn touch(a: &Cell, b: &Cell) -> bool {
    let ([a_low, a_high], [b_low, b_high]) = (a.bounds, b.bounds);
    (0..3).all(|k| a_low[k] <= b_high[k] && b_low[k] <= a_high[k])
}

/// The open boxes that are connected to a point, one pair of boxes at a time.
fn connected(certificate: &Certificate, from: [f64; 3]) -> Vec<bool> {
    let boxes = &certificate.boxes;
    let open = |k: &usize| boxes[*k].status == Status::Open;
    let point = Cell { bounds: [from; 2], status: Status::Open };
    let mut reached: Vec<bool> = (0..boxes.len()).map(|k| open(&k) && touch(&boxes[k], &point)).collect();
    let mut queue: Vec<usize> = (0..boxes.len()).filter(|k| reached[*k]).collect();
    while let Some(k) = queue.pop() {
        for j in (0..boxes.len()).filter(open) {
            if !reached[j] && touch(&boxes[k], &boxes[j]) {
                reached[j] = true;
                queue.push(j);
            }
        }
    }
    reached
}

const WAYS: [&str; 10] = [
    "a coordinate in its last place",
    "a box less",
    "a box twice",
    "another region",
    "an open box",
    "another start",
    "another side",
    "a wider region",
    "a smaller margin",
    "another name",
];

#[test]
fn every_damage_is_refused() {
    let mut random = Random(1);
    let mut counts = [0; WAYS.len()];
    let mut harmless = 0;
    for sample in samples() {
        let sound = &sample.certificate;
        let (by_start, by_goal) = (connected(sound, sound.start), connected(sound, sound.goal));
        for round in 0..5000 {
            // Damages of the regions take longer to find.
            let way = if round % 10 == 0 { 7 + random.below(3) } else { random.below(7) };
            let mut damaged = sound.clone();
            let k = random.below(sound.boxes.len());
            let closed =
                |k: usize| if let Status::Within(region) = sound.boxes[k].status { Some(region) } else { None };
            let mut scene = &sample.scene;
            match way {
                0 => {
                    let x = &mut damaged.boxes[k].bounds[random.below(2)][random.below(3)];
                    *x = if random.below(2) == 0 { x.next_up() } else { x.next_down() };
                }
                1 => drop(damaged.boxes.remove(k)),
                2 => damaged.boxes.insert(random.below(sound.boxes.len()), sound.boxes[k].clone()),
                3 => {
                    let region = random.below(sound.regions.len());
                    let [low, high] = sound.boxes[k].bounds;
                    let beyond = |[x, y, z, d]: &[f64; 4]| {
                        let far = |n: f64, k: usize| n * if n > 0.0 { high[k] } else { low[k] };
                        far(*x, 0) + far(*y, 1) + far(*z, 2) > d + 1e-12
                    };
                    if !sound.regions[region].half_spaces.iter().any(beyond) {
                        continue;
                    }
                    damaged.boxes[k].status = Status::Within(region);
                }
                4 => {
                    let touches =
                        |side: &[bool]| (0..side.len()).any(|j| side[j] && touch(&sound.boxes[j], &sound.boxes[k]));
                    if closed(k).is_none() {
                        continue;
                    }
                    damaged.boxes[k].status = Status::Open;
                    if !touches(&by_start) || !touches(&by_goal) {
                        if harmless < 100 {
                            damaged.check(scene, &Watch::NONE).unwrap();
                            harmless += 1;
                        }
                        continue;
                    }
                }
                5 => {
                    let [low, high] = sound.boxes[k].bounds;
                    damaged.start[random.below(3)] = if random.below(2) == 0 { low[0] } else { high[0] };
                    if damaged.start == sound.start {
                        continue;
                    }
                }
                6 => {
                    let [low, high] = sound.boxes[k].bounds;
                    let middle = std::array::from_fn(|axis| 0.5 * (low[axis] + high[axis]));
                    let end = if by_goal[k] {
                        &mut damaged.start
                    } else if by_start[k] {
                        &mut damaged.goal
                    } else {
                        continue;
                    };
                    *end = middle;
                    scene = &sample.unasked;
                }
                7 => {
                    let region = random.below(sound.regions.len());
                    damaged.regions[region].half_spaces.iter_mut().for_each(|half| half[3] += 1e-5);
                }
                8 => damaged.margin = 1e-9,
                _ => {
                    let region = random.below(sound.regions.len());
                    let who = &mut damaged.regions[region].who;
                    let name = &mut who[random.below(2)];
                    let other = match random.below(3) {
                        0 => format!("cable {}", random.below(8)),
                        1 => format!("prism {}", random.below(10)),
                        _ => "Platform".to_string(),
                    };
                    if *name == other {
                        continue;
                    }
                    *name = other;
                }
            }
            assert!(damaged.check(scene, &Watch::NONE).is_err(), "accepted in round {round}: {}", WAYS[way]);
            counts[way] += 1;
        }
    }
    assert!(counts.iter().sum::<i32>() >= 10_000, "{counts:?}");
    assert!(counts.iter().all(|count| *count >= 100), "{counts:?}");
    assert!(harmless > 10, "{harmless}");
}

#[test]
fn refusals_name_the_place() {
    let sample = sample!("10-28");
    let told = |change: &dyn Fn(&mut Certificate)| {
        let mut damaged = sample.certificate.clone();
        change(&mut damaged);
        damaged.check(&sample.scene, &Watch::NONE).unwrap_err().to_string()
    };
    let is = |text: String, start: &str| assert!(text.starts_with(start), "{text}");
    is(told(&|c| c.scene = "0123456789abcdef".into()), "scene: found a proof for another scene, 0123456789abcdef");
    is(told(&|c| c.start[0] += 0.1), "start: found a proof for another question");
    is(told(&|c| c.orientation = [0.0, 1.0, 0.0, 0.0]), "orientation: found [0.0, 1.0, 0.0, 0.0], but the scene is at");
    is(told(&|c| c.bounds[0][2] += 2e-6), "box: found ");
    is(told(&|c| c.margin = 0.01), "margin: found 0.01, expected 1e-8 to 1e-6 m");
    is(told(&|c| c.boxes.clear()), "boxes: found none in the box from");
    is(told(&|c| c.boxes[7].status = Status::Within(99)), "boxes[7]: found region 99, expected one of the 2 regions");
    is(told(&|c| c.regions[1].who[0] = "cable 9".into()), "regions[1]: found \"cable 9\", expected the name");
    is(told(&|c| c.regions[0].half_spaces.clear()), "regions[0]: found the position [");
    is(told(&|c| c.boxes[3].bounds[1] = c.boxes[3].bounds[0]), "boxes[3]: found a box from");
    is(told(&|c| c.boxes[3].bounds[1][0] = f64::NAN), "boxes[3]: found NaN, expected finite numbers");
}

#[test]
fn bad_text_is_an_error_in_bounded_time() {
    let sample = sample!("10-28");
    let told = |text: &str| check_certificate(&sample.scene, text, &Watch::NONE).unwrap_err().to_string();
    let with = |old: &str, new: &str| {
        assert!(sample.text.contains(old), "{old}");
        told(&sample.text.replacen(old, new, 1))
    };
    let is = |text: String, start: &str| assert!(text.starts_with(start), "{text}");
    is(with("\"version\":1", "\"version\":2"), "version: found 2, expected 1");
    is(with("cdpr-proof", "cdpr-path"), "format: found \"cdpr-path\", expected \"cdpr-proof\"");
    is(with("\"margin\":1e-6", "\"margin\":NaN"), "margin: found no certificate: expected value");
    is(with("\"margin\":1e-6", "\"margin\":null"), "margin: found no certificate: invalid type: null, expected f64");
    is(with("\"margin\":1e-6", "\"margin\":1e999"), "margin: found no certificate: number out of range");
    is(with("\"margin\":1e-6", "\"margin\":-1e-6"), "margin: found -0.000001, expected 1e-8 to 1e-6 m");
    is(with("\"margin\":1e-6,", ""), "found no certificate: missing field `margin`");
    is(with("\"margin\":1e-6", "\"margin\":1e-6,\"more\":0"), "more: found no certificate: unknown field `more`");
    is(with("\"start\":[", "\"start\":[0,"), "start");
    is(with(",-1]", ",-3]"), "boxes[");
    is(with(",-1]", ",-2]"), "boxes[");
    is(with(",-1]", ",-1,0]"), "boxes[");
    is(with(",-1]", ",0.5]"), "boxes[");
    is(with(",-1]", ",-2,[\"wrench\",1,2]]"), "boxes[");
    is(told(""), "found no certificate: EOF");
    told("[]");
    is(told(&(sample.text.to_string() + "0")), "found more than a certificate");
    for end in (0..sample.text.len()).step_by(97) {
        told(&sample.text[..end]);
    }
    let (head, tail) = sample.text.split_once("\"boxes\":[").unwrap();
    let rows = "[0,0,0,1,1,1,-1],".repeat(1_000_000) + &"0,".repeat(9_000_000);
    is(told(&format!("{head}\"boxes\":[{rows}{tail}")), "boxes: found 10000239, expected at most 1000000");
    let (head, tail) = sample.text.split_once("\"half_spaces\":[").unwrap();
    let rows = "[0,0,1,1],".repeat(1001);
    is(
        told(&format!("{head}\"half_spaces\":[{rows}{tail}")),
        "regions[0].half_spaces: found 1007, expected at most 1000",
    );
    told(&"[".repeat(1_000_000));
}

#[test]
fn huge_and_tiny_numbers_are_refused_without_a_panic() {
    let sample = sample!("10-28");
    for number in [1e308, -1e308, f64::MAX, 5e-324, -5e-324, 0.0, -0.0, 1e-200] {
        for k in 0..4 {
            let mut damaged = sample.certificate.clone();
            damaged.regions.iter_mut().flat_map(|r| &mut r.half_spaces).for_each(|half| half[k] = number);
            // Boxes that the regions no longer hold are opened, so that the regions are reached.
            let _ = damaged.check(&sample.scene, &Watch::NONE);
            let closed = |cell: &Cell| cell.status != Status::Open;
            damaged.boxes.iter_mut().filter(|cell| closed(cell)).for_each(|cell| cell.status = Status::Within(0));
            assert!(damaged.check(&sample.scene, &Watch::NONE).is_err(), "{number} at {k}");
        }
        for k in 0..3 {
            let mut damaged = sample.certificate.clone();
            damaged.bounds[0][k] = -number.abs();
            damaged.bounds[1][k] = number.abs().max(3.0);
            assert!(damaged.check(&sample.scene, &Watch::NONE).is_err());
            let mut damaged = sample.certificate.clone();
            damaged.boxes.iter_mut().for_each(|cell| cell.bounds[1][k] = number);
            assert!(damaged.check(&sample.scene, &Watch::NONE).is_err());
        }
    }
}

/// One slab after another: every cut is at the end of a long list, and the recursion is as deep as it gets.
#[test]
fn deeply_nested_cuts_are_refused_in_bounded_time() {
    let sample = sample!("10-28");
    let mut peeled = sample.certificate.clone();
    let [mut low, mut high] = peeled.bounds;
    peeled.boxes.clear();
    for k in 0..20_000 {
        let axis = k % 3;
        let mut slab = [low, high];
        let step = 1e-6;
        if k % 2 == 0 {
            low[axis] += step;
            slab[1][axis] = low[axis];
        } else {
            high[axis] -= step;
            slab[0][axis] = high[axis];
        }
        peeled.boxes.push(Cell { bounds: slab, status: Status::Open });
    }
    peeled.boxes.push(Cell { bounds: [low, high], status: Status::Open });
    assert!(
        peeled
            .check(&sample.scene, &Watch::NONE)
            .unwrap_err()
            .to_string()
            .contains("expected boxes that come from halving")
    );
}
