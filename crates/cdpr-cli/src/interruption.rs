//! Ctrl-C: long work ends soon, with its best answer, and files that are being written are finished.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Set by Ctrl-C and polled by long work.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Held while a file is written, so that none is left half done.
static WRITING: Mutex<()> = Mutex::new(());

/// How long work that is asked to stop may take to finish by itself, with its best answer.
const GRACE: Duration = Duration::from_millis(70);

/// Exit status of a command that was interrupted.
pub const INTERRUPTED_STATUS: u8 = 130;

/// Asks long work to stop, and ends the program soon if it does not; the second time at once.
pub fn interrupt() {
    if INTERRUPTED.swap(true, Ordering::Relaxed) {
        std::process::exit(INTERRUPTED_STATUS.into());
    }
    std::thread::spawn(|| {
        std::thread::sleep(GRACE);
        let _writing = writing();
        std::process::exit(INTERRUPTED_STATUS.into());
    });
}

/// While this is held, an interruption does not end the program from outside.
pub fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether Ctrl-C was pressed.
pub fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
