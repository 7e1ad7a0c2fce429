//! rayon in forked processes, which `multiprocessing` uses by default on Linux up to Python 3.13. Only the calling
//! thread survives a fork, so rayon's threads are missing and work for them would never end.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Stack of a thread that works, bytes: as large as that of a main thread usually is.
pub const STACK: usize = 8 << 20;

/// The process that loaded this module.
static LOADED_BY: OnceLock<u32> = OnceLock::new();
/// The threads of a forked process, and its process id, since it may be forked in turn.
static OWN_THREADS: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Records which process loads this module.
pub fn loaded() {
    LOADED_BY.get_or_init(std::process::id);
}

/// Runs work that may use rayon, in a forked process with its own threads.
pub fn with_living_threads<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match own_threads(std::process::id()) {
        Some(threads) => threads.install(work),
        None => work(),
    }
}

/// `None` in the process that loaded this module, where rayon starts its threads itself, and if no threads can be
/// started.
fn own_threads(process: u32) -> Option<Arc<ThreadPool>> {
    if LOADED_BY.get() == Some(&process) {
        return None;
    }
    let mut known = OWN_THREADS.lock().unwrap_or_else(PoisonError::into_inner);
    match &*known {
        Some((of, threads)) if *of == process => Some(threads.clone()),
        _ => {
            let threads = Arc::new(ThreadPoolBuilder::new().stack_size(STACK).build().ok()?);
            // Dropping them would wait for threads of the parent process, which do not exist here.
            std::mem::forget(known.replace((process, threads.clone())));
            Some(threads)
        }
    }
}
