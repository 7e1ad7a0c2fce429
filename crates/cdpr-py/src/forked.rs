//! rayon in processes that were forked, as `multiprocessing` does by default on Linux up to Python 3.13: of a process that
//! is forked only the calling thread goes on, so rayon's threads are missing, and work for them would never end.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Stack of a thread that works, bytes: as large as that of a main thread usually is.
pub const STACK: usize = 8 << 20;

/// The process that loaded this module.
static LOADED_BY: OnceLock<u32> = OnceLock::new();
/// Threads of a forked process, and which process that is: it may be forked in its turn.
static OWN_THREADS: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Notes which process loads this module.
pub fn loaded() {
    LOADED_BY.get_or_init(std::process::id);
}

/// Runs work that may use rayon: in a forked process with threads of its own.
pub fn with_living_threads<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match own_threads(std::process::id()) {
        Some(threads) => threads.install(work),
        None => work(),
    }
}

/// None in the process that loaded this module, whose threads rayon starts itself, and where none can be started.
fn own_threads(process: u32) -> Option<Arc<ThreadPool>> {
    if LOADED_BY.get() == Some(&process) {
        return None;
    }
    let mut known = OWN_THREADS.lock().unwrap_or_else(PoisonError::into_inner);
    match &*known {
        Some((of, threads)) if *of == process => Some(threads.clone()),
        _ => {
            let threads = Arc::new(ThreadPoolBuilder::new().stack_size(STACK).build().ok()?);
            // Threads of the process before would be waited for, and they are not here.
            std::mem::forget(known.replace((process, threads.clone())));
            Some(threads)
        }
    }
}
