//! What ran trials, as run and summary files record it.

use serde::{Deserialize, Serialize};

/// A program at work on a machine; [`crate::io::origin_here`] gives this one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    /// cdpr.
    pub program: String,
    /// Its version.
    pub version: String,
    /// The processor, as the system names it; none where it does not.
    pub cpu: Option<String>,
    /// The instruction set, such as x86_64.
    pub architecture: String,
    /// The operating system and, on Linux, the release of its kernel.
    pub os: String,
    /// Logical cores that the program may use.
    pub cores: usize,
    /// Threads that ran trials; none where rows were run elsewhere and handed over.
    pub threads: Option<usize>,
}
