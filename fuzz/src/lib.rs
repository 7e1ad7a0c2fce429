//! Every reader of cdpr, fed with bytes as a file's contents.
//!
//! What a reader refuses must be refused with words; what it accepts must be of use: scenes answer a motion, paths are
//! checked, meshes become obstacles, runs become reports. Panics, inputs that take longer than [`TIME`] and ones that
//! take more memory than [`MEMORY`] are defects.

mod readers;

use std::panic::resume_unwind;
use std::sync::mpsc::channel;
use std::time::Duration;

pub use readers::{READERS, Reader, inputs, reader};

/// Memory that reading a file may take in all, bytes.
pub const MEMORY: usize = 1 << 30;

/// Time that reading a file of up to 1 MB may take: 10 s, and patience for a machine that has other things to do.
pub const TIME: Duration = Duration::from_secs(60);

/// Allocator that fails beyond a limit.
pub type Memory = cap::Cap<std::alloc::System>;

/// Reads an input as [`Reader::read`] does, but fails if that takes too long.
///
/// # Panics
/// If the reader does, or takes longer than [`TIME`].
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
