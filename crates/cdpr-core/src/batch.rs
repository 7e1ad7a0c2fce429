//! Experiments: scenarios × methods × trials, on all cores, with the same rows whatever the number of threads.

pub mod experiment;
pub mod origin;
pub mod random_scene;
pub mod run;
pub mod spec;
pub mod statistics;
pub mod summary;

pub use experiment::{Experiment, Layout, Rules, Swept};
pub use origin::Origin;
pub use random_scene::{RandomScenes, RandomScenesSpec};
pub use run::{Progress, Row, RunOptions, TrialStatus, run, threads_of};
pub use spec::{ExperimentSpec, SceneSource};
pub use statistics::{Comparison, Moments, TTest, t_test};
pub use summary::Summary;

use sha2::{Digest, Sha256};

/// The seed that belongs to these words and to no others: a stream of its own for every trial, whatever runs beside it.
///
/// # Example
/// ```
/// use cdpr_core::batch::derived_seed;
/// assert_ne!(derived_seed(1, &["hard1", "rrt"], 0), derived_seed(1, &["hard1", "rrt"], 1));
/// assert_ne!(derived_seed(1, &["a", "bc"], 0), derived_seed(1, &["ab", "c"], 0));
/// ```
pub fn derived_seed(seed: u64, words: &[&str], trial: usize) -> u64 {
    let mut hash = Sha256::new();
    hash.update(seed.to_le_bytes());
    for word in words {
        hash.update((word.len() as u64).to_le_bytes());
        hash.update(word.as_bytes());
    }
    hash.update((trial as u64).to_le_bytes());
    let digest = hash.finalize();
    u64::from_le_bytes(std::array::from_fn(|k| digest[k]))
}
