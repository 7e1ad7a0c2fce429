//! How large inputs may be, and how much work may be spent on them, each limit defined once with its reason.
//!
//! Sizes of inputs and results come first, then numbers of steps.

/// Minimum extent of a workspace along its longest side, and of the outlets of a robot, m: a thousand times the
/// accuracy [`GAP_TOLERANCE`](crate::tolerances::GAP_TOLERANCE), [`ON_SURFACE`](crate::tolerances::ON_SURFACE) and
/// [`FLAT`](crate::tolerances::FLAT). This is a ten-thousandth of the size of a tabletop robot, and results are still
/// accurate to three digits. If sizes came near the tolerances, walls would become flat and gaps would become contacts
/// without any notice.
pub const LEAST_EXTENT: f64 = 1e-4;

/// Minimum extent of an obstacle along its longest side, and of a platform that is not a single point, m: a hundred
/// times [`GAP_TOLERANCE`](crate::tolerances::GAP_TOLERANCE); parts of a body may be smaller.
pub const LEAST_BODY: f64 = 1e-5;

/// Most turns of a winch's motor for one turn of its drum, and of the drum for one of the motor, so that angles are finite.
pub const MOST_GEAR: f64 = 1e6;

/// Steps of Newton's method at most until the pose is found at which a platform settles; it usually takes about ten.
pub const SETTLING_STEPS: usize = 200;

/// Largest accepted coordinate, m: beyond it `f64` cannot keep an accuracy of
/// [`GAP_TOLERANCE`](crate::tolerances::GAP_TOLERANCE) in products of coordinates.
pub const MAX_COORDINATE: f64 = 1e6;

/// Largest weight of a cable as a share of its tension, q = w L / T: up to here the bound of its sag in `model::envelope` holds.
pub const MOST_SLACKNESS: f64 = 0.2;

/// Maximum number of pieces into which a motion is divided for two cables that hang; if they do not decide, it is refused.
pub const HANGING_PIECES: usize = 1000;

/// Maximum number of such pieces at a time: as many halvings as leave pieces of rounding errors.
pub const HANGING_HALVINGS: usize = 64;

/// Largest entry of a wrench, a wrench matrix or a limit, in its own unit: products of three of them are finite.
pub const MAX_WRENCH: f64 = 1e100;

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

/// Maximum size of another program's robot file, bytes; the largest known has 0.1 MB.
pub const MOST_XML_BYTES: u64 = 1_000_000;

/// Maximum number of nodes of an XML file.
pub const MOST_XML_NODES: u32 = 100_000;

/// Maximum number of cables of a robot.
pub const MOST_CABLES: usize = 256;

/// Maximum number of cables of a robot in a scene that requires wrenches: facets of the available set grow with the
/// fifth power.
pub const MOST_WRENCH_CABLES: usize = 24;

/// Maximum number of loads of a scene: all wrench work is done for each.
pub const MOST_LOADS: usize = 16;

/// Maximum number of convex parts of a platform or of all obstacles of a scene: all that touch each other are examined
/// for seams.
pub const MOST_BODIES: usize = 10_000;

/// Maximum number of orientations of a scene: planning may try each.
pub const MOST_ORIENTATIONS: usize = 1_000;

/// Maximum number of stations of a scene: planning between all pairs takes quadratic time.
pub const MOST_STATIONS: usize = 1_000;

/// Largest number of payloads of a scene.
pub const MOST_PAYLOADS: usize = 1_000;

/// Largest number of rows of a task.
pub const MOST_TASK_ROWS: usize = 1_000;

/// Maximum number of corners of one convex body: identifying the faces of a hull takes quadratic time.
pub const MOST_CORNERS: usize = 1_000;

/// Maximum number of corners of a convex mesh that is used as it is; the fast engine adds them to the platform's.
pub const MOST_CONVEX_CORNERS: usize = MOST_CORNERS;

/// Maximum number of rows of an experiment per trial: scenarios times methods, counting each variant of a sweep.
pub const MOST_ROWS_PER_TRIAL: usize = 5_000;

/// Maximum number of trials of an experiment.
pub const MOST_TRIALS: usize = 1_000_000_000;

/// Maximum size of a mesh file, bytes.
pub const MOST_MESH_BYTES: u64 = 100_000_000;

/// A mesh larger than the workspace's longest side by this factor probably has another unit.
pub const HUGE_MESH: f64 = 10.0;

/// Maximum number of triangles of a mesh.
pub const MOST_TRIANGLES: usize = 500_000;

/// Maximum number of corners of a polygon in a mesh file: the time to divide one that crosses itself everywhere into
/// triangles grows with the square of them, to about a tenth of a second.
pub const MOST_POLYGON_CORNERS: usize = 2_000;

/// Maximum number of connected pieces of a mesh: more indicate a mesh that is not welded.
pub const MOST_PIECES: usize = 5_000;

/// Largest trajectory file that is read, bytes: half an hour of eight cables at 100 samples per second.
pub const MOST_TRAJECTORY_BYTES: u64 = 200_000_000;

/// Samples per second of a trajectory, unless its accelerations need more.
pub const LEAST_DEFAULT_RATE: f64 = 100.0;

/// Largest number of samples of a trajectory; more are probably due to a wrong unit.
pub const MOST_SAMPLES: f64 = 1e7;

/// Largest certificate of a proof that is read, bytes.
pub const MOST_CERTIFICATE_BYTES: u64 = 200_000_000;

/// Maximum number of boxes of a certificate that is checked.
pub const MOST_CERTIFICATE_BOXES: usize = 1_000_000;

/// Maximum number of nodes of a wrench map, 0.8 GB for each margin; more are probably due to a wrong unit.
pub const MAP_NODES: f64 = 1e8;

/// Maximum number of boxes into which a workspace is divided, divided ones included: a file of a hundred megabytes, and
/// [cuts](crate::workspace) of all that are left in some seconds.
pub const MOST_WORKSPACE_BOXES: usize = 1_000_000;

/// Share of a time budget for dividing a workspace; the rest is for cutting what is left.
pub const DIVIDING: f64 = 0.5;

/// Time of a budget that is left to sum up a workspace, for each of its boxes.
pub const SUMMING: std::time::Duration = std::time::Duration::from_nanos(400);

/// How often what is left of a workspace is halved at most to cut it more closely, while time is left.
pub const CLOSEST_CUT: usize = 3;

/// Number of bounds on the slack to facets that parts of a box of a workspace take over from it at most: some 6 kB.
pub const MOST_FACET_BOUNDS: usize = 64;

/// Maximum number of halvings of a workspace along an axis; smaller boxes would come near rounding errors.
pub const WORKSPACE_HALVINGS: u8 = 24;

/// Maximum number of voxels of a workspace in a file; more are combined.
pub const MOST_VOXELS: usize = 1 << 26;

/// Parts of the longest side of a workspace down to which boxes are divided if neither a resolution nor a time is given: a picture is
/// no finer, and it takes a second or two.
pub const WORKSPACE_PARTS: f64 = 64.0;

/// Maximum number of cables of a wrench set that is drawn, after parallel ones are combined: a corner is a word of 64
/// bits.
pub const SET_CABLES: usize = 64;

/// Maximum number of GJK iterations; the result is then the interval certified so far, never a guess.
pub const GJK_ITERATIONS: usize = 64;

/// Number of bisection steps to locate a first contact: 2^-45 of a motion.
pub const BISECTION_STEPS: usize = 45;

/// Maximum number of lines in which facets of overlapping parts of a scene cross whose ends are examined for inner
/// corners.
pub const MOST_CROSSINGS: usize = 2_000;

/// Maximum number of iterations to find the pose for given cable lengths. 4 to 8 are typical; 40 where the Jacobian is
/// singular at the pose.
pub const POSE_ITERATIONS: usize = 200;

/// Iterations after which the search for a pose takes the curvature of the lengths into account, at three times the cost.
pub const POSE_SLOW: usize = 20;

/// Changes of the active set, per limit, after which the result is "undecided". Two or three in total are typical.
pub const ACTIVE_SET_STEPS: usize = 10;

/// Steps of Newton's method for the least p-norm, besides changes of the active set; 5 to 10 are typical.
pub const NORM_STEPS: usize = 100;

/// Maximum number of iterations of the interior-point solver; 5 to 15 are typical.
pub const INTERIOR_POINT_ITERATIONS: u32 = 60;

/// Maximum number of planes in the search for a largest scale; each is a facet that the previous one missed.
pub const SCALE_STEPS: usize = 100;

/// Number of comparisons of corners with open edges after which joining them is given up: some tenths of a second.
pub const MOST_MENDING_STEPS: usize = 50_000_000;

/// Maximum number of parts that one piece of a mesh is cut into.
pub const MOST_PARTS: usize = 256;

/// Maximum number of parts of all pieces of a mesh together, if there are fewer pieces.
pub const MOST_PARTS_IN_ALL: usize = 5_000;

/// Maximum number of corners of a convex part that is an exact hull; larger sets are enclosed by planes that touch
/// them.
pub const MOST_PART_CORNERS: usize = 64;

/// Maximum number of planes around the content of a convex part.
pub const MOST_WRAP_PLANES: usize = 300;

/// Number of planes up to which a piece is a body with flat faces: all of them may be cut along, however small.
pub const FEW_PLANES: usize = 200;

/// Number of cells that a piece may be cut into, for each part that it may have after merging.
pub const CELLS_PER_PART: usize = 4;

/// Number of polygons that cutting a piece may examine for each of its triangles. A sound mesh takes
/// some 10 to 20 per triangle; triangles that cross each other everywhere are cut into more and more of them.
pub const POLYGONS_PER_TRIANGLE: usize = 40;

/// Number of polygons that cutting a piece may examine in addition to [`POLYGONS_PER_TRIANGLE`].
pub const POLYGONS_BESIDES: usize = 500_000;

/// Maximum number of steps (boxes, and eight triangles each) in the proof of how far one part extends; with more it
/// counts as extending too far: about a second.
pub const MOST_REACH_STEPS: usize = 1_000_000;

/// Number of steps of the proofs how far the parts of a piece extend together, for each part that it may be cut into:
/// several seconds for the worst meshes, which are then not cut further.
pub const REACH_STEPS_PER_PART: usize = 8_000;

/// Number of steps to measure how far a part extends, for the reported value.
pub const MEASURE_STEPS: usize = 2_000;

/// Number of steps to measure how far all parts of a piece extend, if it has few.
pub const MEASURE_STEPS_IN_ALL: usize = 20_000;

/// Number of steps in the proof that two parts may be merged.
pub const MERGE_STEPS: usize = 20_000;

/// Number of steps in all proofs of a piece that parts may be merged, for each initial part.
pub const MERGE_STEPS_PER_PART: usize = 4_000;

/// Number of pieces into which a motion may be divided to prove one condition; far more than
/// [`TOO_CLOSE_TO_TURN`](crate::tolerances::TOO_CLOSE_TO_TURN) needs for the motions of a hall.
pub const TURNING_PIECES: usize = 20_000;

/// Number of pieces of a turn that are judged to prove that all positions of a box keep one condition during it; boxes that would need
/// more are divided.
pub const PIECES_NEAR: usize = 16;

/// Largest turn, rad, between two orientations at which positions that are forbidden during turns are looked for: an attachment 1 m from
/// the axis deviates from its chord by 4 mm.
pub const LARGEST_SAMPLED_TURN: f64 = std::f64::consts::PI / 18.0;

/// Number of pieces into which a motion may be divided to prove that the required wrenches are available: some
/// milliseconds.
pub const WRENCH_PIECES: usize = 1000;

/// Maximum number of pairs of intervals examined for a lower bound if a gap is requested: some ten seconds.
pub const BOUND_EFFORT: usize = 100_000_000;

/// Maximum number of pairs of intervals examined for a lower bound if no gap is requested: some 0.1 s.
pub const QUICK_BOUND_EFFORT: usize = 300_000;

/// To judge wrenches over a box of positions takes as long as to examine this many pairs of intervals for a lower bound.
pub const JUDGED_EFFORT: usize = 1000;

/// Time limit of the search for a certificate of a bound, s. After that, a smaller length is certified.
pub const CERTIFICATE_SECONDS: u64 = 60;

/// Maximum number of boxes by which a certificate shows that wrenches lack in one region.
pub const MOST_WEAK_BOXES: usize = 10_000;

/// Maximum number of cells that the decision whether there is a path may visit.
pub const PROOF_EFFORT: usize = 3_000_000;

/// Share of a time budget for the decision whether there is a path; the rest is for the width of the narrowest opening.
pub const DECIDING: f64 = 0.95;

/// Maximum number of cells visited for each clearance that a widest path might keep: some three seconds.
pub const WIDEST_EFFORT: usize = PROOF_EFFORT / 10;

/// Number of cells that the decision whether there is a path may visit for each sample that the planner may draw, so
/// that the planner's limit applies to both.
pub const PROOF_EFFORT_PER_SAMPLE: usize = 150;

/// Cells that are visited to find out whether a scene without a path has none with the margin of bounds either: most
/// need hardly more than the first proof did, and the others, slits between the two margins, would use up any effort.
pub const BOUND_PROOF_EFFORT: usize = PROOF_EFFORT / 10;

/// How often a bend is halved to prove that it is free: parts of a thousandth, which deviate from their chord by a
/// millionth of what the bend does.
pub const BEND_HALVINGS: usize = 10;

/// Number of pieces into which a bend on which the platform turns may be divided to prove that the required wrenches
/// are available: where this is not enough, a smaller bend is tried.
pub const BEND_WRENCH_PIECES: usize = 100;

/// Number of intervals into which the timing of a trajectory divides its curve.
pub const TIMING_INTERVALS: usize = 1000;

/// Parts into which the time between two instants is divided at most to prove that tensions exist in between.
pub const TENSION_PARTS: usize = 256;

/// Most stops of a closed tour for which the best order is found by dynamic programming, in some 10 ms: its time doubles with each.
pub const MOST_EXACT_STOPS: usize = 13;

/// Effort of the search for a short tour of more stops, in changes of the tour that are weighed: about half a second.
pub const TOUR_EFFORT: usize = 2_000_000;

/// Rounds of tightening the limits of a timing where they are exceeded between the parameters of its grid.
pub const TIMING_ROUNDS: usize = 14;

/// Instants between two samples at which a motion in exact form is checked.
pub const INSTANTS_BETWEEN: usize = 10;

/// Largest number of parts into which the motion between two samples is divided to search each for violations.
pub const INSTANTS_OF_STEP: f64 = 1000.0;

/// Minimum number of instants of the whole motion at which its exact form is checked, however few the samples.
pub const LEAST_INSTANTS: usize = 1000;

/// Maximum number of parts into which a box of attachments is divided to bound the wrap of a cable; typically one to
/// thirty suffice. With fewer, the bound is wider.
pub const MOST_WRAP_BOXES: usize = 256;
