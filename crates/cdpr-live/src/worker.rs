//! The calls of the page's worker.

use wasm_bindgen::prelude::wasm_bindgen;

use crate::session::Session;

#[wasm_bindgen]
unsafe extern "C" {
    /// A function of the worker that hears of each better path.
    fn improved(text: &str);
}

/// A [`Session`] for JavaScript.
#[wasm_bindgen]
#[derive(Default)]
pub struct Planner(Session);

#[wasm_bindgen]
impl Planner {
    /// One that knows no scene yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// As [`Session::answer`].
    pub fn answer(&mut self, request: &str) -> String {
        self.0.answer(request, &improved)
    }
}
