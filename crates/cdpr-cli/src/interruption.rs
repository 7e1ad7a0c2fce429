//! Ctrl-C: long work ends soon, with its best answer, and files that are being written are finished.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Set by Ctrl-C and polled by long work.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Set when long work has its answer, which only has to be printed and written.
static ANSWERED: AtomicBool = AtomicBool::new(false);

/// Held while a file is written, so that none is left half done.
static WRITING: Mutex<()> = Mutex::new(());

/// How long work that is asked to stop may take to finish by itself, with its best answer.
const GRACE: Duration = Duration::from_millis(70);

/// How long an answer may take to be printed and written after an interruption. Ends a program that waits for the
/// reader of a pipe.
const FINISH: Duration = Duration::from_secs(5);

/// Exit status of a command that was interrupted.
pub const INTERRUPTED_STATUS: u8 = 130;

/// Asks long work to stop, and ends the program soon if it does not; called again, ends it at once.
pub fn interrupt() {
    if INTERRUPTED.swap(true, Ordering::Relaxed) {
        std::process::exit(INTERRUPTED_STATUS.into());
    }
    std::thread::spawn(|| {
        std::thread::sleep(GRACE);
        let mut _writing = writing();
        if ANSWERED.load(Ordering::Relaxed) {
            drop(_writing);
            std::thread::sleep(FINISH);
            _writing = writing();
        }
        std::process::exit(INTERRUPTED_STATUS.into());
    });
}

/// Called when long work has its answer. From then on an interruption leaves time to print and write it.
pub fn answered() {
    answered_while(&writing());
}

/// [`answered`], for work that holds this already: if it were released first, the program could end before an answer is printed.
pub fn answered_while(_writing: &MutexGuard<()>) {
    ANSWERED.store(true, Ordering::Relaxed);
}

/// While this is held, an interruption does not end the program from outside.
pub fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether Ctrl-C was pressed.
pub fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
