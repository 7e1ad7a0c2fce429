//! How large inputs may be and how many steps work may take, each limit defined once with its reason.

/// Maximum number of lines in which facets of overlapping parts of a scene cross whose ends are examined for inner corners.
pub const MOST_CROSSINGS: usize = 2_000;

/// Largest such share where rounding decides farther inside, as for cables that are much shorter than others.
pub const MOST_SCALE_ROUNDING: f64 = 1e-7;

/// Maximum ratio of two lengths that statics accept, characteristic length to metre: beyond it forces and moments
/// are not comparable in `f64`.
pub const MOST_SCALE: f64 = 1e6;

/// Maximum time budget, s, about thirty years; more is probably due to a wrong unit, and soon exceeds the range of the
/// clock.
pub const MOST_SECONDS: f64 = 1e9;

/// Maximum number of threads: more than any machine has cores, and few enough to start in a moment.
pub const MOST_THREADS: usize = 1024;

/// Maximum size of a text file that is read as a whole (scenes, robots, paths, experiments, run records), bytes:
/// parsing TOML needs fifty times as much memory.
pub const MOST_TEXT_BYTES: u64 = 16_000_000;

/// Maximum size of a table of a run, which is read row by row, bytes.
pub const MOST_TABLE_BYTES: u64 = 1_000_000_000;

/// Maximum number of cables of a robot.
pub const MOST_CABLES: usize = 256;

/// Maximum number of cables of a robot in a scene that requires wrenches: facets of the available set grow with the
/// fifth power.
pub const MOST_WRENCH_CABLES: usize = 24;

/// Maximum number of loads of a scene: all wrench work is done for each.
pub const MOST_LOADS: usize = 16;

/// Maximum number of convex parts of a platform or of all obstacles of a scene: all that touch each other are examined for seams.
pub const MOST_BODIES: usize = 10_000;

/// Maximum number of orientations of a scene: planning may try each.
pub const MOST_ORIENTATIONS: usize = 1_000;

/// Maximum number of corners of one convex body: identifying the faces of a hull takes quadratic time.
pub const MOST_CORNERS: usize = 1_000;

/// Maximum number of rows of an experiment per trial: scenarios times methods, counting each variant of a sweep.
pub const MOST_ROWS_PER_TRIAL: usize = 5_000;

/// Maximum number of trials of an experiment.
pub const MOST_TRIALS: usize = 1_000_000_000;

/// Maximum size of another program's robot file, bytes; the largest known has 0.1 MB.
pub const MOST_XML_BYTES: u64 = 1_000_000;

/// Maximum number of nodes of an XML file.
pub const MOST_XML_NODES: u32 = 100_000;

/// Number of comparisons of corners with open edges after which joining them is given up: some tenths of a second.
pub const MOST_MENDING_STEPS: usize = 50_000_000;

/// Maximum number of corners of a convex mesh that is used as it is; the fast engine adds them to the platform's.
pub const MOST_CONVEX_CORNERS: usize = MOST_CORNERS;

/// Maximum number of corners of a convex part that is an exact hull; larger sets are enclosed by planes that touch
/// them.
pub const MOST_PART_CORNERS: usize = 64;

/// Maximum number of planes around the content of a convex part.
pub const MOST_WRAP_PLANES: usize = 300;

/// Maximum number of parts that one piece of a mesh is cut into.
pub const MOST_PARTS: usize = 256;

/// Maximum number of parts of all pieces of a mesh together, if there are fewer pieces.
pub const MOST_PARTS_IN_ALL: usize = 5_000;

/// Maximum number of steps (boxes, and eight triangles each) in the proof of how far one part extends; with more it
/// counts as extending too far: about a second.
pub const MOST_REACH_STEPS: usize = 1_000_000;

/// Maximum size of a mesh file, bytes.
pub const MOST_MESH_BYTES: u64 = 100_000_000;

/// Maximum number of triangles of a mesh.
pub const MOST_TRIANGLES: usize = 500_000;

/// Maximum number of corners of a polygon in a mesh file: the time to divide one that crosses itself everywhere into
/// triangles grows with the square of them, to about a tenth of a second.
pub const MOST_POLYGON_CORNERS: usize = 2_000;

/// Maximum number of connected pieces of a mesh: more indicate a mesh that is not welded.
pub const MOST_PIECES: usize = 5_000;

/// Largest trajectory file that is read, bytes: half an hour of eight cables at 100 samples per second.
pub const MOST_TRAJECTORY_BYTES: u64 = 200_000_000;

/// Maximum number of boxes of a certificate that is checked.
pub const MOST_CERTIFICATE_BOXES: usize = 1_000_000;

/// Largest certificate of a proof that is read, bytes.
pub const MOST_CERTIFICATE_BYTES: u64 = 200_000_000;

/// Largest number of samples of a trajectory; more are probably due to a wrong unit.
pub const MOST_SAMPLES: f64 = 1e7;
