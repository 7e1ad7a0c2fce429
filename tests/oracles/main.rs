//! Results of the engines, kernels and solvers against tests that share no code with them and against each other. A
//! separate program, since it runs three times: like all tests, with the portable kernels, and on the release build.

mod cable_shapes;
mod cases;
mod cspace;
mod engine_oracle;
mod engines_agree;
mod forward_kinematics;
mod geometry_oracle;
mod lattice;
mod pair_distances;
mod tension_distributions;
mod turning;
mod wrench_certify;
mod wrench_margins;
mod wrench_oracle;
mod wrench_pulleys;
mod wrench_solvers;
