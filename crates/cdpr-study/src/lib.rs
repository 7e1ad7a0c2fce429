//! Experiments: scenarios × methods × trials, on all cores, with the same rows for any number of threads; their
//! statistics; and a report of a finished run as a page.
//!
//! A *method* is a planner with one or more rewinding modes (a sweep). A *trial* of a method in a scenario gives one row
//! per mode. The seed of a trial is a hash of the experiment's seed, the names of scenario and method, and the number of
//! the trial; the seed of a random scene does not depend on the method. So a row depends neither on threads and order nor
//! on other methods and the number of trials, and `cdpr plan --seed` with the seed of a row reproduces its path.

pub mod batch_folder;
pub mod batch_rows;
pub mod batch_tables;
pub mod experiment;
pub mod experiment_file;
pub mod experiment_spec;
pub mod external;
pub mod origin;
pub mod random_scene;
pub mod report;
pub mod report_file;
pub mod run;
pub mod schema;
pub mod statistics;
pub mod summary;

pub use batch_folder::{BatchFolder, merge};
pub use batch_rows::{BatchRows, Tables};
pub use experiment::{Experiment, Layout, Rules, Swept};
pub use experiment_file::{experiment_from_text, load_experiment};
pub use experiment_spec::{ExperimentSpec, SceneSource};
pub use external::{Answered, external_rows, foregone};
pub use origin::{Origin, origin_here};
pub use random_scene::{RandomScenes, RandomScenesSpec};
pub use report_file::load_study;
pub use run::{Progress, Row, RunOptions, TrialRow, TrialStatus, run, threads_of, trial_scene, trial_seed};
pub use schema::schema;
pub use statistics::{Comparison, Moments, TTest, paired_t_test, t_test};
pub use summary::{Described, MethodSummary, PairSummary, Paired, Summary, SummaryFile, TestSummary};

use hmac_sha256::Hash;

/// A seed derived from these words, different for different words, so that every trial has its own stream of random
/// numbers.
///
/// # Example
/// ```
/// use cdpr_study::derived_seed;
/// assert_ne!(derived_seed(1, &["hard1", "rrt"], 0), derived_seed(1, &["hard1", "rrt"], 1));
/// assert_ne!(derived_seed(1, &["a", "bc"], 0), derived_seed(1, &["ab", "c"], 0));
/// ```
pub fn derived_seed(seed: u64, words: &[&str], trial: usize) -> u64 {
    let mut hash = Hash::new();
    hash.update(seed.to_le_bytes());
    for word in words {
        hash.update((word.len() as u64).to_le_bytes());
        hash.update(word.as_bytes());
    }
    hash.update((trial as u64).to_le_bytes());
    let digest = hash.finalize();
    u64::from_le_bytes(std::array::from_fn(|k| digest[k]))
}
