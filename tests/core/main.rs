//! Planning, checking and wrenches: known answers, properties, and former wrong answers.

mod anytime;
mod bound_certificate;
mod clearances;
mod decomposition;
mod gaps;
mod load_cases;
mod lower_bound;
mod new_scene;
mod orientation;
mod planners;
mod planning;
mod proof;
mod proof_limits;
mod properties;
mod random_scenes;
mod regions;
mod regressions;
mod seams;
mod trajectory;
mod turning;
mod turning_attacks;
mod turning_bends;
mod turning_bends_wrench;
mod turning_motions;
mod workspace;
mod wrench_planning;
