use super::*;
use crate::model::Robot;
use crate::model::spec::PulleySpec;
use crate::testing::paper_robot;
use crate::wrench::Loads;
use crate::wrench::set::CapacityMargin;
use nalgebra::{Matrix5, Matrix6};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The paper's robot with crossed attachments, and pulleys of these radii whose axes lean at random.
fn measure(radius: impl Fn(usize) -> f64, rng: &mut ChaCha8Rng) -> Measure {
    let mut spec = paper_robot();
    spec.mass = Some(20.0);
    for cable in &mut spec.cables {
        let [x, y, z] = cable.attachment;
        cable.attachment = [-x, y, -z];
    }
    spec.platform[0].cuboid = None;
    spec.platform[0].vertices = Some(vec![[0.0; 3]]);
    for (k, cable) in spec.cables.iter_mut().enumerate() {
        if radius(k) > 0.0 {
            let axis = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
            cable.pulley = Some(PulleySpec { radius: radius(k), axis: axis.into() });
        }
    }
    let statics = Statics::new(&Robot::try_from(spec).unwrap(), &Loads::default()).unwrap();
    Measure::Capacity(Box::new(CapacityMargin::new(statics, Required::balls(5.0, 0.5).unwrap()).unwrap()))
}

/// The column of a cable at a fraction of the motion, by its line there.
fn column(facets: &Facets, measure: &Measure, cable: usize, s: f64) -> [f64; ROWS] {
    let Column { line, step, .. } = facets.columns[cable];
    let line = Vector::from(line) - Vector::from(step) * s;
    let turn = measure.statics().cables()[cable].arm.cross(&line) / measure.statics().characteristic_length();
    [line.x, line.y, line.z, turn.x, turn.y, turn.z]
}

/// The normal to five columns by their minors.
fn normal(columns: &[[f64; ROWS]]) -> [f64; ROWS] {
    std::array::from_fn(|row| {
        let without = |r: usize| if r < row { r } else { r + 1 };
        let minor = Matrix5::from_fn(|r, c| columns[c][without(r)]);
        minor.determinant() * if row % 2 == 0 { 1.0 } else { -1.0 }
    })
}

fn at(cubic: &Cubic, s: f64) -> f64 {
    restricted(cubic, s, s)[0]
}

#[test]
fn normals_and_products_are_as_near_to_their_cubics_as_bounded() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let (mut closest, mut beyond, mut compared) = ([0.0f64; 2], 0.0f64, 0);
    while compared < 40 {
        let measure = measure(|_| 0.15, &mut rng);
        let mut place = || Point::from(Vector::from_fn(|_, _| rng.random_range(0.3..1.7)));
        let (from, to) = (place(), place());
        let Some(facets) = Facets::new(&measure, &from, &to) else { continue };
        compared += 1;
        assert!(facets.beside[0] > 0.0);
        facets.all(&mut |pair| {
            let others: Vec<usize> = pair.others[..pair.count].iter().map(|(cable, _)| *cable).collect();
            let own: Vec<usize> = (0..facets.cables).filter(|cable| !others.contains(cable)).collect();
            for s in [0.15, 0.5, 0.85] {
                let columns: Vec<_> = own.iter().map(|cable| column(&facets, &measure, *cable, s)).collect();
                let exact = normal(&columns);
                let off = size(&std::array::from_fn(|row| exact[row] - at(&pair.normal[row], s)));
                let most = facets.beside[0] * pair.scale;
                assert!(off <= most * (1.0 + 1e-9), "{off} {most}");
                closest[0] = closest[0].max(off / most);
                beyond = beyond.max(off / pair.scale);
                for (cable, height) in &pair.others[..pair.count] {
                    let last = column(&facets, &measure, *cable, s);
                    let exact: f64 = exact.iter().zip(last).map(|(a, b)| a * b).sum();
                    let matrix = Matrix6::from_fn(|r, c| columns.get(c).map_or(last[r], |column| column[r]));
                    assert!((exact.abs() - matrix.determinant().abs()).abs() < 1e-9 * pair.scale);
                    let most = facets.beside[1] * pair.scale * facets.columns[*cable].largest;
                    let off = (exact - at(height, s)).abs();
                    assert!(off <= most * (1.0 + 1e-9), "{off} {most}");
                    closest[1] = closest[1].max(off / most);
                }
            }
            true
        });
    }
    // The bounds take the worst of all cables for each; what they bound is far above rounding errors.
    println!("{closest:?} of the bounds; up to {beyond:.1e} of the scale");
    assert!(closest[0] > 1e-4 && closest[1] > 1e-5 && beyond > 1e-6, "{closest:?} {beyond}");
}

#[test]
fn without_pulleys_normals_are_cubics() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let measure = measure(|_| 0.0, &mut rng);
    let facets = Facets::new(&measure, &Point::new(0.4, 0.5, 0.6), &Point::new(1.2, 0.9, 1.4)).unwrap();
    assert_eq!((facets.beside, facets.loss), ([0.0; 2], 0.0));
}

#[test]
fn columns_that_are_dependent_all_along_span_no_facet_round_pulleys_either() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    // Four cables end at one point: with them, five columns are dependent wherever the platform is.
    let mut robot = paper_robot();
    robot.mass = Some(20.0);
    robot.platform[0].cuboid = None;
    robot.platform[0].vertices = Some(vec![[0.0; 3]]);
    for (k, cable) in robot.cables.iter_mut().enumerate() {
        let [x, y, z] = cable.attachment;
        cable.attachment = if k < 4 { [0.0, 0.0, 0.05] } else { [-x, y, -z] };
        let axis = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
        cable.pulley = Some(PulleySpec { radius: 0.1, axis: axis.into() });
    }
    let statics = Statics::new(&Robot::try_from(robot).unwrap(), &Loads::default()).unwrap();
    let measure =
        Measure::Capacity(Box::new(CapacityMargin::new(statics, Required::balls(5.0, 0.5).unwrap()).unwrap()));
    let facets = Facets::new(&measure, &Point::new(0.8, 0.9, 0.9), &Point::new(1.2, 1.0, 1.1)).unwrap();
    let mut found = 0;
    facets.all(&mut |pair| {
        found += 1;
        let others = pair.others[..pair.count].iter().filter(|(cable, _)| *cable < 4).count();
        assert!(others > 0, "four cables of one point span a facet");
        true
    });
    // Of the 56 choices, 4 have all cables of that point.
    assert_eq!(found, 52);
}
