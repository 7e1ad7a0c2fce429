//! Long work: progress on a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::interruption::{answered, interrupted};
use crate::output::{Console, Talk};
use cdpr_core::watch::Interrupt;

/// A progress bar on standard error, if that is a terminal. The trials are evenly mixed, so the estimate of the
/// remaining time is reliable.
pub fn bar(out: &Console) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} trials, {elapsed}, about {eta} left (Ctrl-C stops)");
    shown(out, ProgressBar::new(0)).with_style(style.expect("a sound template"))
}

/// The progress bar, unless `--quiet` is given.
fn shown(out: &Console, bar: ProgressBar) -> ProgressBar {
    if out.talk() == Talk::Quiet {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    bar
}

/// Runs work that may take long. After half a second, a line on standard error, if that is a terminal, shows what is
/// being done and for how long; the work polls its argument for interruptions.
pub fn with_progress<T>(out: &Console, doing: &str, work: impl FnOnce(&Interrupt) -> T) -> T {
    let style = ProgressStyle::with_template("{spinner} {msg} {elapsed} (Ctrl-C stops)").expect("a sound template");
    let sign = shown(out, ProgressBar::new_spinner()).with_style(style).with_message(doing.to_string());
    let patience = Duration::from_millis(500);
    let stop = || {
        if sign.elapsed() >= patience {
            sign.tick();
        }
        interrupted()
    };
    let result = work(&stop);
    answered();
    sign.finish_and_clear();
    result
}
