//! The planner inside the page as WebAssembly: [`cdpr_view::live`] with the calls of the page's worker.
//!
//! `make viewer` compiles this crate and stores the result among the assets of `cdpr-view`, which therefore cannot depend on
//! it. All code that native programs can run as well is in `cdpr-view`.

#[cfg(target_arch = "wasm32")]
mod worker;
