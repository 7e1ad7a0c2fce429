//! Certified motions: accepted ones hold at every point, motions that dip are rejected, and reported places are right.

use cdpr_core::Robot;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::wrench::{
    CapacityMargin, Loads, Measure, Required, Statics, certified, first_failure, least_slack, slack_reaches,
};
use cdpr_tests::{built_robot, direction, rng};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Existing robots with a box of positions and balls that leave slack.
fn robots() -> Vec<(Measure, [[f64; 2]; 3])> {
    let of = |name: &str, force, moment, box_| {
        let statics = Statics::new(&built_robot(name), &Loads::default()).unwrap();
        (capacity(statics, force, moment), box_)
    };
    vec![
        of("cogiro", 50.0, 10.0, [[-6.5, 6.5], [-5.0, 5.0], [0.5, 4.5]]),
        of("ipanema2", 5.0, 1.0, [[-4.0, 4.0], [-3.0, 3.0], [0.5, 5.0]]),
        of("caroca", 20.0, 5.0, [[-3.0, 3.0], [-3.0, 3.0], [0.3, 3.0]]),
        of("acrobot", 0.2, 0.02, [[0.1, 0.8], [0.1, 0.8], [0.1, 0.9]]),
        of("mpi_simulator", 200.0, 50.0, [[2.0, 10.0], [2.0, 13.0], [1.0, 8.0]]),
    ]
}

fn capacity(statics: Statics, force: f64, moment: f64) -> Measure {
    Measure::Capacity(Box::new(CapacityMargin::new(statics, Required::balls(force, moment).unwrap()).unwrap()))
}

fn within(rng: &mut ChaCha8Rng, box_: &[[f64; 2]; 3]) -> Point {
    Point::from(box_.map(|[low, high]| rng.random_range(low..high)))
}

/// The smallest slack among points of a motion, by brute force.
fn sampled(measure: &Measure, from: &Point, to: &Point, points: usize) -> f64 {
    let at = |k: usize| from + (to - from) * (k.min(points) as f64 / points as f64);
    let fours = (0..=points / 4).map(|n| measure.slack_at_four(&std::array::from_fn(|k| at(4 * n + k))));
    fours.flatten().fold(f64::INFINITY, |least, s| if s < least || s.is_nan() { s } else { least })
}

#[test]
fn certified_motions_hold_at_a_thousand_points() {
    let mut rng = rng(11);
    for (measure, box_) in robots() {
        let (mut accepted, mut refused, mut tried) = (0, 0, 0);
        while accepted < 2000 && tried < 40_000 {
            tried += 1;
            let from = within(&mut rng, &box_);
            let length = [0.1, 0.5, 3.0][tried % 3];
            let to = from + direction(&mut rng) * length;
            if certified(&measure, &from, &to) {
                accepted += 1;
                let least = sampled(&measure, &from, &to, 1000);
                assert!(least >= 0.0, "{least} between {from} and {to}");
            } else {
                refused += 1;
            }
        }
        assert!(accepted == 2000 && refused > 100, "{accepted} accepted, {refused} refused");
    }
}

#[test]
fn a_motion_is_refused_iff_slack_dips_below_zero() {
    let mut rng = rng(12);
    for (measure, box_) in robots() {
        let (mut dips, mut told) = (0, 0);
        let box_ = box_.map(|[low, high]| [1.2 * low - 0.2 * high, 1.2 * high - 0.2 * low]);
        for _ in 0..300 {
            let (from, to) = (within(&mut rng, &box_), within(&mut rng, &box_));
            let failure = first_failure(&measure, &from, &to);
            assert_eq!(failure.is_none(), certified(&measure, &from, &to));
            let brute = sampled(&measure, &from, &to, 4000);
            dips += usize::from(brute < 0.0);
            assert!(brute >= 0.0 || failure.is_some());
            let (least, at) = least_slack(&measure, &from, &to);
            assert!((measure.slack(&(from + (to - from) * at)) - least).abs() <= measure.floor());
            if brute > 0.0 {
                assert!(least <= brute + 2.0 * measure.statics().largest_tension() * 1e-6);
                assert!(failure.is_none(), "refused though nowhere below {brute}");
            }
            let Some(at) = failure.filter(|at| *at > 0.0) else { continue };
            let here = from + (to - from) * at;
            assert!(measure.slack(&here).abs() < 1e-3 * measure.statics().largest_tension());
            assert!(certified(&measure, &from, &(from + (to - from) * (at - 1e-7).max(0.0))));
            told += 1;
        }
        assert!(dips > 20 && told > 20, "{dips} dip, {told} told");
    }
}

#[test]
fn slack_reaches_agrees_with_least_slack() {
    let mut rng = rng(14);
    for (measure, box_) in robots() {
        let tolerance = 1e-6 * measure.statics().largest_tension();
        let mut reached = 0;
        for _ in 0..300 {
            let from = within(&mut rng, &box_);
            let to = from + (within(&mut rng, &box_) - from) * 10_f64.powf(rng.random_range(-3.0..0.0));
            let (least, _) = least_slack(&measure, &from, &to);
            for share in [0.0, 0.5, 0.9, 0.999, 1.001, 1.5] {
                let floor = (share * least).max(0.0);
                let reaches = slack_reaches(&measure, &from, &to, floor);
                reached += usize::from(reaches);
                assert!(reaches == (least >= floor) || (least - floor).abs() <= tolerance, "{least} {floor}");
            }
        }
        assert!(reached > 100, "{reached} reached");
    }
}

#[test]
fn a_dip_of_a_millimetre_is_found() {
    // Motions that graze the boundary: the minimum of the margin along a chord is slightly below the requirement.
    let mut rng = rng(13);
    let (mut found, mut spared) = (0, 0);
    for (measure, box_) in robots() {
        let Measure::Capacity(margin) = &measure else { unreachable!() };
        let Required::Balls { moment, .. } = *margin.required() else { unreachable!() };
        for _ in 0..1500 {
            let (from, to) = (within(&mut rng, &box_), within(&mut rng, &box_));
            let plain = capacity(margin.statics().clone(), 0.0, moment);
            let (least, at) = least_slack(&plain, &from, &to);
            if !(least > 1e3 * plain.floor() && at > 0.01 && at < 0.99) {
                continue;
            }
            // Force balls larger than the minimum alone would allow: |c_f| <= 1, so a ball above `least` may still fit.
            let mut force = [least, 100.0 * least];
            let slack_at =
                |force: f64| capacity(margin.statics().clone(), force, moment).slack(&(from + (to - from) * at));
            if slack_at(force[1]) >= 0.0 {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (force[0] + force[1]);
                force[usize::from(slack_at(middle) < 0.0)] = middle;
            }
            let demand = force[1] + 1e-6 * least;
            let grazing = capacity(margin.statics().clone(), demand, moment);
            let length = (to - from).norm();
            let below = |s: f64| grazing.slack(&(from + (to - from) * (at + s / length))) < 0.0;
            assert!(below(0.0) && !certified(&grazing, &from, &to));
            found += 1;
            spared += usize::from(!below(1e-3) || !below(-1e-3));
        }
    }
    assert!(found >= 15 && spared >= 10, "{found} dips, {spared} shorter than a millimetre on one side");
}

#[test]
fn zero_length_motions_are_states_and_outlets_are_refused() {
    let robot: Robot = built_robot("cogiro");
    let measure = capacity(Statics::new(&robot, &Loads::default()).unwrap(), 0.0, 0.0);
    let middle = Point::new(0.0, 0.0, 2.0);
    assert!(certified(&measure, &middle, &middle) && first_failure(&measure, &middle, &middle).is_none());
    let outlet = robot.cables()[0].outlet - robot.cables()[0].attachment.coords;
    assert!(!certified(&measure, &outlet, &outlet));
    assert!(!certified(&measure, &middle, &outlet));
    assert_eq!(first_failure(&measure, &outlet, &middle), Some(0.0));
    assert!(least_slack(&measure, &outlet, &middle).0.is_nan());
    let beyond = middle + Vector::new(0.0, 0.0, f64::NAN);
    assert!(!certified(&measure, &middle, &beyond));
}

#[test]
fn forces_and_moments_alone_are_certified_too() {
    let mut rng = rng(14);
    let statics = Statics::new(&built_robot("cogiro"), &Loads::default()).unwrap();
    let box_ = [[-7.0, 7.0], [-5.2, 5.2], [0.5, 5.0]];
    for measure in [Measure::Force(statics.clone(), 0.0), Measure::Moment(statics, 0.0)] {
        // A requirement that half of the positions meet.
        let mut margins: Vec<f64> = (0..99).map(|_| measure.slack(&within(&mut rng, &box_))).collect();
        margins.sort_by(f64::total_cmp);
        let measure = match measure {
            Measure::Moment(statics, _) => Measure::Moment(statics, margins[49]),
            other => Measure::Force(other.statics().clone(), margins[49]),
        };
        let (mut accepted, mut refused) = (0, 0);
        for _ in 0..400 {
            let from = within(&mut rng, &box_);
            let to = from + direction(&mut rng) * 0.5;
            if certified(&measure, &from, &to) {
                accepted += 1;
                assert!(sampled(&measure, &from, &to, 200) >= 0.0);
            } else {
                refused += 1;
                assert!(first_failure(&measure, &from, &to).is_some());
            }
        }
        assert!(accepted > 20 && refused > 20, "{accepted} accepted, {refused} refused");
    }
}
