//! What several test programs share: sample scenes and random numbers.

use cdpr_core::model::{Scene, SceneSpec};

/// A scene from its file, and the same without start and goal.
#[allow(dead_code, reason = "not all test programs read files")]
pub fn scenes(text: &str) -> [Scene; 2] {
    let spec: SceneSpec = serde_json::from_str(text).unwrap();
    let unasked = SceneSpec { query: None, ..spec.clone() };
    [spec, unasked].map(|spec| Scene::new(spec).unwrap())
}

/// Random numbers (SplitMix64).
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % count as u64) as usize
    }
}
