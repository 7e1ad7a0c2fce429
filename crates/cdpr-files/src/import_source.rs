//! Shared by the readers of other programs' robots: the options of an import, and a robot as they found it.

use std::path::PathBuf;

use cdpr_core::error::Error;
use cdpr_core::model::inertia::checked;
use cdpr_core::model::{BodySpec, InertiaSpec, RobotSpec, Unit};

/// Options of an import.
#[derive(Debug, Clone, Default)]
pub struct ImportOptions {
    /// CASPR: the bodies file, where it does not stand beside the cables file under the same name.
    pub bodies: Option<PathBuf>,
    /// CASPR: the cable set; default: the one that the file names.
    pub cable_set: Option<String>,
    /// A mesh of the platform in its frame, and its unit, instead of the platform of the source.
    pub platform: Option<(PathBuf, Unit)>,
}

impl ImportOptions {
    /// Refuses the options of CASPR for a robot of another program.
    pub(super) fn refuse_those_of_caspr(&self) -> Result<(), Error> {
        let given = [("bodies", self.bodies.is_some()), ("cable_set", self.cable_set.is_some())];
        let problem = "found with a YAML file, where it has no effect; expected a model of CASPR";
        given.into_iter().find(|(_, given)| *given).map_or(Ok(()), |(key, _)| Err(Error::invalid(key, problem)))
    }
}

/// A robot as a reader found it, where it is from, and what was not carried over.
pub(super) struct Source {
    pub robot: RobotSpec,
    pub origin: String,
    pub notes: Vec<String>,
}

/// The hull of the attachments, for a source that does not define the platform's shape.
pub(super) fn platform_of(attachments: &[[f64; 3]]) -> Vec<BodySpec> {
    vec![BodySpec { vertices: Some(attachments.to_vec()), ..BodySpec::default() }]
}

/// An inertia about the centre of mass from Ixx, Iyy, Izz and the entries Ixy, Ixz, Iyz of the tensor. Impossible
/// values are often placeholders: a note says why they are omitted.
pub(super) fn inertia_of([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Result<InertiaSpec, String> {
    let inertia = match [xy, xz, yz] {
        [0.0, 0.0, 0.0] => InertiaSpec::Diagonal([xx, yy, zz]),
        _ => InertiaSpec::Tensor([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]),
    };
    let note =
        |problem| format!("inertia, since no body has it ({problem}): that of the parts at uniform density is used");
    checked("", &inertia).map(|_| inertia).map_err(|error| note(error.to_string()))
}
