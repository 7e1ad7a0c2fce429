//! clarabel for repeated programs of one size: `minimise ½ h |x|² + c·x where A x <= b`,
//! with fixed h and c, and new A and b each time.
//!
//! These programs have at most about ten unknowns and dense matrices of numbers near 1. A solver would spend most of
//! its time on equilibration and iterative refinement, which they do not need: the callers verify the answers and make
//! them exact.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultInfo, DefaultSettings, DefaultSolver, IPSolver, SupportedConeT};
use nalgebra::DMatrix;

use crate::limits::INTERIOR_POINT_ITERATIONS;
use crate::tolerances::{INTERIOR_POINT, INTERIOR_POINT_REGULARISATION};

/// Decides when an answer is clear enough to stop.
pub(super) type Plain = fn(&DefaultInfo<f64>) -> bool;

/// A program whose size rarely changes, and whose cost changes only with the size.
pub(super) struct InteriorPoint {
    hessian: f64,
    plain: Option<Plain>,
    program: Option<Program>,
}

struct Program {
    shape: (usize, usize),
    solver: DefaultSolver<f64>,
    /// Entries of A, column by column, and b; clarabel wants vectors.
    matrix: Vec<f64>,
    bounds: Vec<f64>,
}

/// Where the solver stopped: unknowns, and a multiplier for each row. Only a proposal.
pub(super) struct Proposal<'a> {
    pub(super) x: &'a [f64],
    pub(super) multipliers: &'a [f64],
}

impl InteriorPoint {
    pub(super) fn new(hessian: f64, plain: Option<Plain>) -> Self {
        Self { hessian, plain, program: None }
    }

    /// Runs the solver; `None` if it could not start or returned numbers that are not finite.
    pub(super) fn propose(&mut self, cost: &[f64], matrix: &DMatrix<f64>, bounds: &[f64]) -> Option<Proposal<'_>> {
        if self.program.as_ref().is_none_or(|p| p.shape != matrix.shape()) {
            self.program = None; // do not keep one of another size
            self.program = Some(self.build(cost, matrix, bounds)?);
        }
        let program = self.program.as_mut()?;
        program.matrix.copy_from_slice(matrix.as_slice());
        program.bounds.copy_from_slice(bounds);
        program.solver.update_A(&program.matrix).ok()?;
        program.solver.update_b(&program.bounds).ok()?;
        program.solver.solve();
        let solution = &program.solver.solution;
        let finite = solution.x.iter().chain(&solution.z).all(|x| x.is_finite());
        finite.then_some(Proposal { x: &solution.x, multipliers: &solution.z })
    }

    fn build(&self, cost: &[f64], matrix: &DMatrix<f64>, bounds: &[f64]) -> Option<Program> {
        let (rows, columns) = matrix.shape();
        let mut hessian = CscMatrix::identity(columns);
        hessian.nzval.fill(self.hessian);
        let cones = [SupportedConeT::NonnegativeConeT(rows)];
        let mut solver = DefaultSolver::new(&hessian, cost, &dense(matrix), bounds, &cones, settings()).ok()?;
        if let Some(plain) = self.plain {
            solver.set_termination_callback(plain);
        }
        Some(Program { shape: (rows, columns), solver, matrix: matrix.as_slice().to_vec(), bounds: bounds.to_vec() })
    }
}

/// Stores every entry, including zeros: the next matrix may have its zeros elsewhere.
fn dense(matrix: &DMatrix<f64>) -> CscMatrix<f64> {
    let (rows, columns) = matrix.shape();
    let starts = (0..=columns).map(|j| j * rows).collect();
    let places = (0..columns).flat_map(|_| 0..rows).collect();
    CscMatrix::new(rows, columns, starts, places, matrix.as_slice().to_vec())
}

fn settings() -> DefaultSettings<f64> {
    DefaultSettings {
        verbose: false,
        max_iter: INTERIOR_POINT_ITERATIONS,
        tol_gap_abs: INTERIOR_POINT,
        tol_gap_rel: INTERIOR_POINT,
        tol_feas: INTERIOR_POINT,
        static_regularization_constant: INTERIOR_POINT_REGULARISATION,
        direct_solve_method: "qdldl".into(),
        max_threads: 1,
        presolve_enable: false, // otherwise the numbers could not be replaced
        equilibrate_enable: false,
        iterative_refinement_enable: false,
        ..DefaultSettings::default()
    }
}
