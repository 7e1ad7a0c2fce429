//! Interruptible reading of files.

use cdpr_core::watch::Watch;

/// Reads files like the functions of this crate, but stops when its watch requests it: decomposing large meshes takes
/// seconds.
///
/// # Example
/// ```
/// use cdpr_files::Loader;
/// use cdpr_core::Watch;
/// let loader = Loader::new(Watch::on(&|| false));
/// assert!(loader.scene("testdata/no_such_scene.toml").is_err());
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Loader<'a> {
    pub(super) watch: Watch<'a>,
}

impl Loader<'static> {
    /// A loader that never stops early.
    pub const PATIENT: Self = Loader { watch: Watch::NONE };
}

impl<'a> Loader<'a> {
    /// A loader with a watch.
    pub fn new(watch: Watch<'a>) -> Self {
        Loader { watch }
    }
}
