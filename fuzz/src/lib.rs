//! Every reader of cdpr, applied to bytes as the contents of a file.
//!
//! A reader must reject invalid input with a message, and what it accepts must be usable: scenes check a motion, paths
//! are checked, meshes become obstacles, runs become reports. Panics, and inputs that take longer than [`TIME`] or more
//! memory than [`MEMORY`], are defects.

mod readers;

use std::panic::resume_unwind;
use std::sync::mpsc::channel;
use std::time::Duration;

pub use readers::{READERS, Reader, inputs, reader};

/// Total memory that reading a file may take, bytes.
pub const MEMORY: usize = 1 << 30;

/// Time that reading a file of up to 1 MB may take: 10 s, with allowance for a busy machine.
pub const TIME: Duration = Duration::from_secs(60);

/// Allocator that fails beyond a limit.
pub type Memory = cap::Cap<std::alloc::System>;

/// Reads an input as [`Reader::read`] does, but fails if that takes too long.
///
/// # Panics
/// If the reader panics, or takes longer than [`TIME`].
pub fn read_in_time(reader: Reader, input: Vec<u8>) {
    let (done, waits) = channel::<()>();
    let thread = std::thread::spawn(move || {
        (reader.read)(&input);
        drop(done);
    });
    let ended = waits.recv_timeout(TIME) != Err(std::sync::mpsc::RecvTimeoutError::Timeout);
    assert!(ended, "{} took longer than {TIME:?}", reader.name);
    if let Err(panic) = thread.join() {
        resume_unwind(panic);
    }
}
