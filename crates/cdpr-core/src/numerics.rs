//! Every tolerance of the crate, once: what it compares, its unit, and why it has that size.
//!
//! Lengths are absolute, in metres, because the product promises an absolute accuracy ([`GAP_TOLERANCE`]). With
//! coordinates of hall size (up to 1e3 m) `f64` carries 1e-13 m, so all of them stand far above rounding.

pub(crate) mod simd;

/// Accuracy promised for every yes or no, m: two engines may differ only where the true gap is smaller than this.
pub const GAP_TOLERANCE: f64 = 1e-7;

/// Overlap that still counts as touching, m. Forbidden sets are open, so bodies that touch are free; rounding of exact
/// contacts (about 1e-15 m in a hall) must not turn them into collisions, hence a depth far above rounding and far
/// below [`GAP_TOLERANCE`].
pub const TOUCH_DEPTH: f64 = 1e-9;

/// A point this close to the surface of a body lies on it, m: an attachment on a platform part, an outlet bolted to an
/// obstacle, a vertex on a face of its hull. Deeper inside is an error of the model.
pub const ON_SURFACE: f64 = 1e-7;

/// Least extent of a workspace along its longest side, and of the outlets of a robot, m: a thousand times
/// [`GAP_TOLERANCE`], to which answers are right, and so as [`ON_SURFACE`] and [`FLAT`]. At a ten-thousandth of the size of a
/// tabletop robot, they are then still right to three digits; where sizes come near the tolerances, walls become flat,
/// gaps become contacts, and all of that would go without a word.
pub const LEAST_EXTENT: f64 = 1e-4;

/// Least extent of an obstacle along its longest side, and of a platform that is more than a point, m: a hundred times
/// [`GAP_TOLERANCE`]; parts of a body may be smaller.
pub const LEAST_BODY: f64 = 1e-5;

/// Extent below which a point set counts as flat in that direction, m. Thinner bodies have no interior.
pub const FLAT: f64 = 1e-7;

/// Two points closer than this are the same point, m: shared outlets, shared attachments, doubled waypoints.
pub const SAME_POINT: f64 = 1e-9;

/// Shortest cable that has a direction, m; positions with a shorter one are invalid (kind `cable-length`).
pub const MIN_CABLE_LENGTH: f64 = 1e-7;

/// Largest coordinate accepted, m: beyond it `f64` could not carry [`GAP_TOLERANCE`] through a product of coordinates.
pub const MAX_COORDINATE: f64 = 1e6;

/// Sine of the angle below which two directions are parallel. A facet of a Minkowski sum spanned by two such edges is
/// narrower than rounding, so nothing is lost by leaving it out.
pub const PARALLEL: f64 = 1e-10;

/// Cosine up to which two planes count as square to each other, where a box is enlarged by moving its planes: its corners
/// are then off by this share of the way.
pub const RIGHT_ANGLE: f64 = 1e-12;

/// Sine of the angle below which the plane of two directions is too uncertain to bound a set by.
pub const NEARLY_PARALLEL: f64 = 1e-4;

/// Relative error of a height over a plane, generously: some tens of roundings of numbers as large as the scene.
pub const ROUNDING: f64 = 1e-14;

/// How far a convex superset may be from the set it stands for, m, to decide hits as well as misses.
pub const SUPERSET: f64 = 1e-8;

/// By how much bodies without volume are fattened to have a shadow with planes, m; only a superset is needed.
pub const FATTENED: f64 = 1e-6;

/// What rounding may add to the way from the middle of a cell, in cells, when motions are cut into pieces of a cell's
/// size.
pub const CELL_ROUNDING: f64 = 1e-9;

/// Height over a facet's plane up to which a point lies in that plane, m, where it matters only on which side rounding
/// puts it: either reading gives the same set up to this.
pub const GRAZING: f64 = 1e-10;

/// How far the length of an orientation quaternion may be from 1.
pub const UNIT_QUATERNION: f64 = 1e-6;

/// Orientations that differ by less, rad, are one and the same: far above rounding, far below any encoder.
pub const SAME_TURN: f64 = 1e-9;

/// Coplanarity of hull vertices relative to the size of the body: input typed with rounding still has its faces.
pub const COPLANAR_RELATIVE: f64 = 1e-10;

/// Largest height over a face at which a vertex is still taken for a corner of it, m; well inside [`GAP_TOLERANCE`].
pub const COPLANAR_AT_MOST: f64 = 1e-8;

/// How far a corner of a flat hull must stand out from the chord of its neighbours, m; less is rounding.
pub const STANDS_OUT: f64 = 1e-9;

/// Shorter sweeps count as no motion, and have no direction, m.
pub const NO_MOTION: f64 = 1e-13;

/// Width below which a cable's triangle is a segment and has no face of its own, m.
pub const NO_WIDTH: f64 = 1e-12;

/// Sine of the angle below which a facet is taken for parallel to a plane, or a ray to a facet, in building seams.
pub const ALONG_FACET: f64 = 1e-9;

/// Singular values below this share of the largest count as zero in the rank of a wrench matrix.
pub const RANK_RELATIVE: f64 = 1e-9;

/// How many times the least tension the largest may be where cables pull against each other. Cables that need more are
/// nearly in one half-space, and hold a platform in theory only.
pub const TENSION_RATIO: f64 = 1e4;

/// A column of a wrench matrix that stands out less than this share of the longest one from the span of others depends
/// on them: together they span no facet. A plane through columns that are nearly so is as good as rounding lets it be;
/// whatever its normal, the set lies below its support there, so no margin comes out too small by it.
pub const DEPENDENT: f64 = 1e-9;

/// Least share of the largest diagonal entry of R that the least one may have for the kernel of four positions to be
/// sure of it: what it computes is then right to eleven digits.
pub const KERNEL_CONDITION: f64 = 1e-5;

/// Normals (in coordinates of a null space, where they are of order one) above this length are good to nine digits.
pub const KERNEL_NORMAL: f64 = 1e-6;

/// Normals below this length are those of dependent columns: rounding of zero.
pub const KERNEL_NO_NORMAL: f64 = 1e-13;

/// Slack below this share of the longest edge of the available set (greatest tension times column) cannot be certified
/// along a motion, and is refused: the kernel of four positions is good to some 1e-10 of it.
pub const SLACK_RELATIVE: f64 = 1e-9;

/// Least length of a piece that certifying a motion still divides, m: below it lies rounding of positions.
pub const CERTIFY_PIECE: f64 = 1e-11;

/// A normal shorter than this share of the product of the columns that it is orthogonal to, all along a motion, is
/// rounding of zero: the columns are dependent and span no facet.
pub const FACET_NO_NORMAL: f64 = 1e-14;

/// Rounding of the slack to a facet along a motion, as a share of the longest edge of the set times the product of the
/// columns in the facet: some five products and sums for each, times 6 for the step from values to coefficients.
pub const FACET_ROUNDING: f64 = 3e-14;

/// Share by which a largest scale is taken back where rounding has it just outside.
pub const SCALE_ROUNDING: f64 = 1e-12;

/// Largest ratio of two lengths that statics accept, characteristic length against metre: beyond it forces and moments
/// could not be measured together in `f64`.
pub const MOST_SCALE: f64 = 1e6;

/// Accuracy of the least slack of a motion, as a share of the largest tension.
pub const LEAST_SLACK_RELATIVE: f64 = 1e-6;

/// Relative slack when whole steps are counted, so that a segment of exactly n steps has n of them.
pub const STEP_COUNT: f64 = 1e-12;

/// Most nodes of a wrench map, 0.8 GB for each margin: beyond it lies a slip of the unit.
pub const MAP_NODES: f64 = 1e8;

/// Most cables of a wrench set that is drawn, once parallel ones are taken together: a corner is a word of 64 limits.
pub const SET_CABLES: usize = 64;

/// Times the largest side of the workspace beyond which a mesh is probably in another unit.
pub const HUGE_MESH: f64 = 10.0;

/// Longest time budget, s, some thirty years: beyond it lies a slip of the unit, and soon the range of the clock.
pub const MOST_SECONDS: f64 = 1e9;

/// Most threads that may be asked for: more than any machine has cores, and few enough to start in a moment.
pub const MOST_THREADS: usize = 1024;

/// Iterations after which GJK stops; its answer is then the interval it has certified, never a guess.
pub const GJK_ITERATIONS: usize = 64;

/// Width at which GJK's bounds on a distance count as equal, m, well inside [`GAP_TOLERANCE`].
pub const GJK_DISTANCE: f64 = 1e-11;

/// Bisection steps when a first contact is located: 2^-45 of a motion.
pub const BISECTION_STEPS: usize = 45;

/// Least gain, m, for which rewinding replaces part of a path; "strictly shorter" above rounding, so that it ends.
pub const SHORTER: f64 = 1e-9;

/// How far taut paths keep from the forbidden polyhedra, m: what lies along a face is then free beyond rounding, for
/// every engine. A path is longer by about this much at every bend.
pub const STANDOFF: f64 = 1e-8;

/// Gain below which a path counts as taut, m.
pub const TAUT: f64 = 1e-10;

/// Error of `W t = w` that counts as none, as a share of the larger of |w| and the greatest tension: a wrench exactly
/// on the boundary of what the cables can balance stays inside whatever rounding (about 1e-15) does.
pub const BALANCE_RELATIVE: f64 = 1e-9;

/// How far a tension may seem to pass its limits before it is put back onto them, as a share of half its range: a
/// tenth of [`BALANCE_RELATIVE`], so that several cables at once still balance to that.
pub const LIMIT_RELATIVE: f64 = 1e-10;

/// Passing a limit by less is rounding, as a share of half a range; the active set moves on only for more.
pub const LIMIT_ROUNDING: f64 = 1e-14;

/// By how much a plane must part a wrench from the cables' limits to prove anything, as a share of half a range; by
/// this limits are widened where they only just hold together. Half of [`LIMIT_RELATIVE`], so one of the two always
/// holds.
pub const LIMIT_SLACK: f64 = 5e-11;

/// Share of a limit's normal across the limits already met (normals are at most 1 long) below which it counts as a
/// sum of theirs: rounding over this stays below [`LIMIT_SLACK`].
pub const DEPENDENT_NORMALS: f64 = 1e-5;

/// The same where the first reading settled nothing; the point or the plane found is checked in any case.
pub const DEPENDENT_NORMALS_AT_LEAST: f64 = 1e-9;

/// Share of a separating direction that must be left once its part along the null space is taken out, or it is
/// rounding.
pub const SEPARATING_LEFT: f64 = 1e-8;

/// Largest entry of a wrench, a wrench matrix or a limit, in its own unit: products of three of them stay finite.
pub const MAX_WRENCH: f64 = 1e100;

/// Changes of the active set, for each limit, after which its answer is "unsettled". Two or three in all are usual.
pub const ACTIVE_SET_STEPS: usize = 10;

/// Accuracy asked of the interior-point solver, on problems scaled to half ranges. What it returns is checked and made
/// exact afterwards, so this only has to tell which limits are active.
pub const INTERIOR_POINT: f64 = 1e-8;

/// Iterations after which the interior-point solver gives up; 5 to 15 are usual.
pub const INTERIOR_POINT_ITERATIONS: u32 = 60;

/// Regularisation of the interior-point solver's linear systems, which are small and scaled to 1. Without iterative
/// refinement this is an error of its steps, so it stands below [`INTERIOR_POINT`].
pub const INTERIOR_POINT_REGULARISATION: f64 = 1e-10;

/// Distance from 1, in half ranges, at which a feasibility program may stop: the answer is then plain and is checked.
pub const PLAIN_ANSWER: f64 = 1e-3;

/// Residual up to which a program may stop at a plain answer.
pub const PLAIN_RESIDUAL: f64 = 1e-6;

/// Planes after which the search for a largest scale gives up; each is a facet that the one before had missed.
pub const SCALE_STEPS: usize = 100;

/// Largest text file that is read whole (scenes, robots, paths, experiments, what a run is), bytes: parsing TOML takes
/// fifty times as much memory.
pub const MOST_TEXT_BYTES: u64 = 16_000_000;

/// Largest table of a run that is read row by row, bytes.
pub const MOST_TABLE_BYTES: u64 = 1_000_000_000;

/// Most cables of a robot.
pub const MOST_CABLES: usize = 256;

/// Most cables of a robot whose wrenches a scene asks for: facets of the available set grow with the fifth power.
pub const MOST_WRENCH_CABLES: usize = 24;

/// Most convex parts of a platform or of all obstacles of a scene: every two of them are looked at for a seam.
pub const MOST_BODIES: usize = 10_000;

/// Most orientations of a scene: planning may try each.
pub const MOST_ORIENTATIONS: usize = 1_000;

/// Most corners of one convex body: sorting out the faces of a hull takes time with their square.
pub const MOST_CORNERS: usize = 1_000;

/// Most rows of an experiment for each trial: scenarios by methods, each variant of a sweep counted.
pub const MOST_ROWS_PER_TRIAL: usize = 5_000;

/// Most trials of an experiment.
pub const MOST_TRIALS: usize = 1_000_000_000;

/// Largest file of another program's robot that is read, bytes; the largest known has 0.1 MB.
pub const MOST_XML_BYTES: u64 = 1_000_000;

/// Most nodes of an XML file.
pub const MOST_XML_NODES: u32 = 100_000;

/// Corners of a mesh that are nearer to each other than this share of its extent are one: formats that list triangles
/// by coordinates round them to single precision (6e-8).
pub const WELD_RELATIVE: f64 = 3e-7;

/// By how much a surface without an inside is fattened to all sides, m: engines keep out of bodies with volume, and
/// parts of such a surface overlap by this along their seams.
pub const SHEET: f64 = 1e-4;

/// Share of a volume or area by which two may differ and still count as equal: rounding of meshes.
pub const EXACT_VOLUME: f64 = 1e-6;

/// Least share of the surface in a cell that a plane needs to be cut along; smaller faces belong to something round.
pub const FACE_SHARE: f64 = 0.02;

/// Most corners of a convex mesh that is taken as it is; the fast engine sums them with the platform's.
pub const MOST_CONVEX_CORNERS: usize = MOST_CORNERS;

/// Most corners of a convex part that is the hull of what it stands for; around more, planes are laid that touch them.
pub const MOST_PART_CORNERS: usize = 64;

/// Most planes around what a convex part stands for.
pub const MOST_WRAP_PLANES: usize = 300;

/// Share of the tolerance that planes around a part may reach beyond its hull: more makes more parts and takes room from
/// paths, less makes parts of more faces.
pub const TIGHT_WRAP: f64 = 0.25;

/// Share of the tolerance that parts reach where that does not take more of them than there may be: what is left is room
/// for paths.
pub const CLOSE: f64 = 0.5;

/// Most parts that one piece of a mesh is cut into.
pub const MOST_PARTS: usize = 256;

/// Share of the largest side of a piece: where its parts miss the tolerance and reach farther than this, the mesh is
/// refused, since they leave no shape that paths could be planned around.
pub const USELESS_REACH: f64 = 0.25;

/// Cells that a piece may be cut into, for each part it may have after merging.
pub const CELLS_PER_PART: usize = 4;

/// Most parts of all pieces of a mesh together, if there are fewer pieces.
pub const MOST_PARTS_IN_ALL: usize = 5_000;

/// Steps (boxes, and eight triangles each) in the proof of how far one part reaches, after which it counts as one that
/// reaches too far: about a second.
pub const MOST_REACH_STEPS: usize = 1_000_000;

/// The same for all parts of a piece together, for each part that it may be cut into: some seconds for the worst of
/// meshes, which are not cut further then.
pub const REACH_STEPS_PER_PART: usize = 8_000;

/// Steps that measure how far a part reaches, for what is stated.
pub const MEASURE_STEPS: usize = 2_000;

/// The same for all parts of a piece together, if it has few.
pub const MEASURE_STEPS_IN_ALL: usize = 20_000;

/// Steps in the proof that two parts may be one.
pub const MERGE_STEPS: usize = 20_000;

/// The same for all such proofs of a piece, for each part that there is at first.
pub const MERGE_STEPS_PER_PART: usize = 4_000;

/// Polygons that cutting a piece may look at for each of its triangles, and besides. A sound mesh takes some 10 to 20 for
/// each triangle; triangles that cross one another everywhere are cut into more and more of them.
pub const POLYGONS_PER_TRIANGLE: usize = 40;

/// See [`POLYGONS_PER_TRIANGLE`].
pub const POLYGONS_BESIDES: usize = 500_000;

/// Share of the tolerance beyond which a part counts as one that reaches too far: to tell just below from just above would
/// take most of the time.
pub const UNDECIDED: f64 = 0.85;

/// Share of the volume that a cut beside a void must leave, against one across the part, to be preferred.
pub const MUCH_SMALLER: f64 = 0.9;

/// How far the parts of a mesh may reach beyond each connected piece of it where a file does not say, as a share of the
/// piece's largest extent.
pub const MESH_TOLERANCE: f64 = 0.01;

/// The same as a share of the whole mesh's extent, where that is more: a hall of 20 m has no use for chairs to the
/// millimetre, and would pay for it with thousands of parts.
pub const MESH_TOLERANCE_IN_ALL: f64 = 0.0025;

/// Largest mesh file that is read, bytes.
pub const MOST_MESH_BYTES: u64 = 100_000_000;

/// Most triangles of a mesh.
pub const MOST_TRIANGLES: usize = 500_000;

/// Most words of an OBJ file for each of [`MOST_TRIANGLES`]: corners, normals, textures and faces have some 10.
pub const WORDS_PER_TRIANGLE: usize = 16;

/// Most pieces of a mesh that do not hang together: beyond it lies a mesh that is not welded.
pub const MOST_PIECES: usize = 5_000;
