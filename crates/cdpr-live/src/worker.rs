//! The calls of the page's worker.

use wasm_bindgen::prelude::wasm_bindgen;

use cdpr_view::live::Session;

#[wasm_bindgen]
unsafe extern "C" {
    /// A function of the worker that is called with each better path.
    fn improved(text: &str);
}

/// A [`Session`] for JavaScript.
#[wasm_bindgen]
#[derive(Default)]
pub struct Planner(Session);

#[wasm_bindgen]
impl Planner {
    /// A planner without a scene.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Answers a request of the page; see [`Session::answer`].
    pub fn answer(&mut self, request: &str) -> String {
        self.0.answer(request, &improved)
    }
}
