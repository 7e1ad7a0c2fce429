//! Many queries at once, on one thread or several, with the same answers and prompt response to an interrupt.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use rayon::prelude::*;
use web_time::Instant;

use crate::error::Error;
use crate::watch::{Watch, thread_count};

/// How queries are distributed over threads and polls.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    /// Queries handed to a thread at a time: enough to make the overhead negligible.
    pub chunk: usize,
    /// Queries before the first poll of the interrupt.
    pub first_block: usize,
}

impl Pace {
    /// For checks of states and motions, which take well below a microsecond each.
    pub const CHECKS: Pace = Pace { chunk: 64, first_block: 1024 };
    /// For queries of some microseconds each: wrench margins, tensions.
    pub const WRENCHES: Pace = Pace { chunk: 16, first_block: 64 };
}

/// Whether there can be more than one thread. In the browser page there is only one, and threading code would only make
/// the page larger.
pub const THREADS: bool = cfg!(not(target_arch = "wasm32"));

/// Time between two polls: a tenth of what a person notices.
const BLOCK_TIME: Duration = Duration::from_millis(10);

/// Options of a batch.
#[derive(Clone, Copy, Default)]
pub struct BatchOptions<'a> {
    /// Number of threads; `None` means all of the pool in which it is called.
    pub threads: Option<usize>,
    /// Polled about every 10 ms.
    pub watch: Watch<'a>,
}

/// Fills `answers[k]` with the answer to query k, on the requested number of threads.
///
/// # Errors
/// The errors of [`Watch::check`], or a number of threads that [`thread_count`] rejects.
pub fn answer_all<T: Send>(
    answers: &mut [T],
    question: impl Fn(usize) -> T + Sync,
    pace: Pace,
    options: &BatchOptions,
) -> Result<(), Error> {
    let serially = |first: usize, answers: &mut [T]| {
        answers.iter_mut().enumerate().for_each(|(k, answer)| *answer = question(first + k));
    };
    let in_parallel = |first: usize, answers: &mut [T]| {
        let chunks = answers.par_chunks_mut(pace.chunk).enumerate();
        chunks.for_each(|(chunk, answers)| serially(first + chunk * pace.chunk, answers));
    };
    // Start no thread that would get no chunk.
    let useful = answers.len().div_ceil(pace.chunk).max(1);
    match options.threads.map(thread_count).transpose()?.map(|threads| threads.min(useful)) {
        threads if !THREADS || threads == Some(1) => in_blocks(answers, serially, pace, &options.watch),
        None => in_blocks(answers, in_parallel, pace, &options.watch),
        Some(threads) => {
            let pool = pool_of(threads)?;
            in_blocks(answers, |first, answers| pool.install(|| in_parallel(first, answers)), pace, &options.watch)
        }
    }
}

/// Calls `found` for each index below `count` and returns the results in order; uses several threads if there are at
/// least `many` indices. Each thread has its own state, which speeds up its work without affecting the results.
///
/// # Errors
/// The first error of `found`.
pub fn each<S: Default, T: Send>(
    count: usize,
    many: usize,
    found: &(dyn Fn(&mut S, usize) -> Result<T, Error> + Sync),
) -> Result<Vec<T>, Error> {
    if THREADS && count >= many {
        return (0..count).into_par_iter().map_init(S::default, found).collect();
    }
    let mut state = S::default();
    (0..count).map(|index| found(&mut state, index)).collect()
}

/// Called with the number of finished parts of some work, and that of all parts, from any thread.
pub type Told<'a> = dyn Fn(usize, usize) + Sync + 'a;

/// Calls `found` for each index below `count`, which may take long and use threads itself, and returns the results in order.
///
/// # Errors
/// The first error of `found`, or a number of threads that [`thread_count`] rejects.
pub fn each_long<T: Send>(
    count: usize,
    threads: Option<usize>,
    told: &Told,
    found: &(dyn Fn(usize) -> Result<T, Error> + Sync),
) -> Result<Vec<T>, Error> {
    let done = AtomicUsize::new(0);
    let one = |k: usize| {
        let found = found(k)?;
        told(1 + done.fetch_add(1, Ordering::Relaxed), count);
        Ok(found)
    };
    let all = || (0..count).into_par_iter().with_max_len(1).map(one).collect();
    match threads.map(thread_count).transpose()? {
        _ if !THREADS => (0..count).map(one).collect(),
        None => all(),
        Some(threads) => pool_of(threads)?.install(all),
    }
}

fn pool_of(threads: usize) -> Result<rayon::ThreadPool, Error> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|e| Error::invalid("threads", format!("{threads} threads cannot be had: {e}")))
}

/// Runs both functions, in parallel if there is more than one thread, and returns both results.
pub fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    if THREADS { rayon::join(a, b) } else { (a(), b()) }
}

/// Computes the answers in blocks that take about [`BLOCK_TIME`] each.
fn in_blocks<T>(answers: &mut [T], work: impl Fn(usize, &mut [T]), pace: Pace, watch: &Watch) -> Result<(), Error> {
    let (mut done, mut block) = (0, pace.first_block);
    while done < answers.len() {
        let clock = Instant::now();
        let end = answers.len().min(done + block);
        work(done, &mut answers[done..end]);
        done = end;
        watch.check()?;
        block = if clock.elapsed() < BLOCK_TIME { block * 2 } else { (block / 2).max(pace.chunk) };
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::ErrorClass;

    #[test]
    fn no_thread_starts_without_work() {
        for (count, asked, expected) in [(1000, 1024, 16), (1000, 3, 3), (70, 1024, 2)] {
            let mut pool = vec![0; count];
            let options = BatchOptions { threads: Some(asked), ..BatchOptions::default() };
            answer_all(&mut pool, |_| rayon::current_num_threads(), Pace::CHECKS, &options).unwrap();
            assert!(pool.iter().all(|threads| *threads == expected), "{count}, {asked}: {pool:?}");
        }
        for asked in [0, 1025, usize::MAX] {
            let options = BatchOptions { threads: Some(asked), ..BatchOptions::default() };
            let refused = answer_all(&mut [0], |_| 0, Pace::CHECKS, &options).unwrap_err().to_string();
            assert_eq!(refused, format!("threads: found {asked}, expected at least 1 and at most 1024"));
        }
    }

    #[test]
    fn a_deadline_or_an_interrupt_ends_a_batch() {
        let stop = || true;
        for (watch, expected) in [
            (Watch::NONE.with_budget(Some(Duration::ZERO)), ErrorClass::OutOfTime),
            (Watch::on(&stop), ErrorClass::Interrupted),
        ] {
            let options = BatchOptions { watch, ..BatchOptions::default() };
            let error = answer_all(&mut vec![0; 1000], |k| k, Pace::CHECKS, &options).unwrap_err();
            assert_eq!(error.class(), expected);
        }
    }
}
