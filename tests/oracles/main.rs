//! What the engines, kernels and solvers answer, against tests that share no code with them and against each other. One
//! program, since these run three times: as all tests do, by the portable kernels, and on the code that people use.

mod cases;
mod cspace;
mod engine_oracle;
mod engines_agree;
mod geometry_oracle;
mod pair_distances;
mod wrench_certify;
mod wrench_margins;
mod wrench_oracle;
mod wrench_solvers;
