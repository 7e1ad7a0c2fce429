//! Signals that request the program to stop: Ctrl-C, SIGTERM and SIGHUP.

/// Calls `stop` on each of these signals. If SIGHUP is ignored at the start, it stays ignored, so that `nohup cdpr ...
/// &` continues when its terminal is closed.
pub fn on_request_to_stop(stop: fn()) {
    // Without a handler Ctrl-C would still end the program, but without the best result so far.
    let set = || drop(ctrlc::set_handler(stop));
    #[cfg(unix)]
    keeping_ignored_hangup(set);
    #[cfg(not(unix))]
    set();
}

/// Calls `set`, which installs handlers for all signals, and restores SIGHUP's disposition if it was ignored before. SIGHUP is
/// blocked meanwhile, so that the handler cannot run in between.
#[cfg(unix)]
#[allow(unsafe_code)]
fn keeping_ignored_hangup(set: impl FnOnce()) {
    use nix::libc;
    use nix::sys::signal::{SigHandler, SigSet, Signal, signal};

    let mut present = std::mem::MaybeUninit::<libc::sigaction>::zeroed();
    // SAFETY: with a null new action, `sigaction` only writes the current action to the given pointer, and all zeros are a valid
    // `sigaction`.
    let ignored = unsafe {
        libc::sigaction(libc::SIGHUP, std::ptr::null(), present.as_mut_ptr());
        present.assume_init().sa_sigaction == libc::SIG_IGN
    };
    let hangup = SigSet::from(Signal::SIGHUP);
    let _ = hangup.thread_block();
    set();
    if ignored {
        // SAFETY: `SigIgn` installs no handler that could run.
        let _ = unsafe { signal(Signal::SIGHUP, SigHandler::SigIgn) };
    }
    let _ = hangup.thread_unblock();
}
