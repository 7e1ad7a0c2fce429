//! Reading that its caller can stop.

use cdpr_core::watch::Watch;

/// Reads files as the functions of this crate do, and ends early when its watch asks: parts of large meshes take
/// seconds to find.
///
/// # Example
/// ```
/// use cdpr_files::Loader;
/// use cdpr_core::watch::Watch;
/// let loader = Loader::new(Watch::on(&|| false));
/// assert!(loader.scene("testdata/no_such_scene.toml".as_ref()).is_err());
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Loader<'a> {
    pub(super) watch: Watch<'a>,
}

impl Loader<'static> {
    /// Never ends early.
    pub const PATIENT: Self = Loader { watch: Watch::NONE };
}

impl<'a> Loader<'a> {
    /// A loader within a watch.
    pub fn new(watch: Watch<'a>) -> Self {
        Loader { watch }
    }
}
