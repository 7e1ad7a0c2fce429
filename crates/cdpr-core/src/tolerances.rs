//! Numerical tolerances, each defined once: what it compares, its unit, and the reason for its size.
//!
//! Lengths are absolute, in metres, because the product promises an absolute accuracy ([`GAP_TOLERANCE`]). With
//! coordinates of the size of a hall (up to 1e3 m) `f64` is accurate to 1e-13 m, so all tolerances are far above
//! rounding errors.

/// Promised accuracy of every yes-or-no answer, m: two engines may differ only if the true gap is smaller than this.
pub const GAP_TOLERANCE: f64 = 1e-7;

/// Overlap that still counts as touching, m. Forbidden sets are open, so bodies that touch are free. Rounding errors of
/// exact contacts (about 1e-15 m in a hall) must not turn them into collisions, so this is far above them and far below
/// [`GAP_TOLERANCE`].
pub const TOUCH_DEPTH: f64 = 1e-9;

/// Shortfall up to which a pair can keep a distance, m: 0.15 - 0.05 is less than 0.1 in doubles. Half of
/// [`TOUCH_DEPTH`], so that the condition holds where the pair is as far apart as it can be.
pub const ATTAINED: f64 = 0.5 * TOUCH_DEPTH;

/// A point this close to the surface of a body lies on it, m: an attachment on a platform part, an outlet mounted on an
/// obstacle, a vertex on a face of its hull. A point deeper inside is an error in the model.
pub const ON_SURFACE: f64 = 1e-7;

/// Extent below which a point set counts as flat in that direction, m. Thinner bodies have no interior.
pub const FLAT: f64 = 1e-7;

/// Two points closer than this are the same point, m: shared outlets, shared attachments, duplicate waypoints.
pub const SAME_POINT: f64 = 1e-9;

/// Length of the shortest cable that has a direction, m; positions with a shorter one are invalid (kind
/// `cable-length`).
pub const MIN_CABLE_LENGTH: f64 = 1e-7;

/// Sine of the angle below which two directions are parallel. A facet of a Minkowski sum spanned by two such edges is
/// narrower than rounding errors, so it can be omitted.
pub const PARALLEL: f64 = 1e-10;

/// Cosine up to which two planes count as orthogonal when a box is enlarged by moving its planes: its corners
/// are then off by this share of the displacement.
pub const RIGHT_ANGLE: f64 = 1e-12;

/// Sine of the angle below which the plane of two directions is too uncertain to bound a set.
pub const NEARLY_PARALLEL: f64 = 1e-4;

/// Generous relative error of a height over a plane: some tens of rounding errors of numbers as large as the scene.
pub const ROUNDING: f64 = 1e-14;

/// Maximum distance of a convex superset from its set, m, for the superset to decide hits as well as misses.
pub const SUPERSET: f64 = 1e-8;

/// Half the side of the cubes by which exit points are replaced if rounding leaves them without a hull, m: far above rounding.
pub const THICKENED: f64 = 1e-9;

/// Bodies that are fattened from inside stay inside by this, m: far above rounding.
pub const INSIDE: f64 = 1e-8;

/// Bodies without volume are fattened by this to have a shadow with planes, m; only a superset is needed.
pub const FATTENED: f64 = 1e-6;

/// Allowance for rounding in the distance from the centre of a cell, in cells, when motions are cut into pieces of a
/// cell's size.
pub const CELL_ROUNDING: f64 = 1e-9;

/// Height over a facet's plane up to which a point lies in that plane, m, where it matters only on which side rounding
/// puts it: both cases give the same set up to this height.
pub const GRAZING: f64 = 1e-10;

/// Maximum deviation of the length of an orientation quaternion from 1.
pub const UNIT_QUATERNION: f64 = 1e-6;

/// Maximum deviation of the length of a quaternion from 1 that products and normalizations of unit quaternions leave.
pub const ROUNDED_UNIT: f64 = 1e-14;

/// Orientations that differ by less than this, rad, are equal: far above rounding, far below the resolution of any
/// encoder.
pub const SAME_TURN: f64 = 1e-9;

/// How far a line of the platform may deviate from the only axis about which the platform may turn, rad: enough for
/// quaternions with five digits. A cosine determines this angle to 1e-8.
pub const OFF_AXIS: f64 = 3e-5;

/// Tolerance for coplanar hull vertices relative to the size of the body: input with rounded coordinates keeps its
/// faces.
pub const COPLANAR_RELATIVE: f64 = 1e-10;

/// Maximum height over a face at which a vertex still counts as one of its corners, m; well inside [`GAP_TOLERANCE`].
pub const COPLANAR_AT_MOST: f64 = 1e-8;

/// Minimum distance of a corner of a flat hull from the chord of its neighbours, m; less is due to rounding.
pub const STANDS_OUT: f64 = 1e-9;

/// Sweeps shorter than this count as no motion and have no direction, m.
pub const NO_MOTION: f64 = 1e-13;

/// Width below which a cable's triangle is a segment without a face of its own, m.
pub const NO_WIDTH: f64 = 1e-12;

/// Sine of the angle below which a facet counts as parallel to a plane, or a ray to a facet, when seams are built.
pub const ALONG_FACET: f64 = 1e-9;

/// Crossings of a facet with two other parts whose distances from a point differ by no more than this may be in one
/// line, m: far above rounding.
pub const SAME_CROSSING: f64 = 1e-5;

/// Sine of the angle up to which a facet that touches a line may contain it: a facet of a part of a tenth of a
/// millimetre is tilted by this if its corners are [`ON_SURFACE`] from where they should be.
pub const ALONG_LINE: f64 = 1e-3;

/// Rounding of the numbers of an inertia, as a share of the largest: catalogues print four to seven digits.
pub const INERTIA_ROUNDING: f64 = 1e-6;

/// Singular values below this share of the largest count as zero in the rank of a wrench matrix.
pub const RANK_RELATIVE: f64 = 1e-9;

/// Singular values of the Jacobian of the cable lengths below this share of the largest count as zero in the rank of an
/// estimated pose: along such a direction an error of a length is magnified more than a hundred thousand times. Where the
/// Jacobian is singular, rounding leaves the pose uncertain by up to 1e-7, and its smallest singular value is of that size.
pub const POSE_RANK_RELATIVE: f64 = 1e-5;

/// Step at which an estimated pose has converged, m; turns count with the distance of the attachments from the origin.
pub const POSE_STEP: f64 = 1e-11;

/// Cosine of the angle between residuals and the columns of their Jacobian up to which they are at right angles. Short steps alone do
/// not tell: where lengths are kilometres, rounding may stop the search earlier.
pub const POSE_GRADIENT: f64 = 1e-6;

/// Share of the sum of squares of the residuals below which a step's gain is lost in the rounding of the sum, some 1e-16 for
/// each cable; the gradient then tells whether the step was good.
pub const POSE_GAIN_RELATIVE: f64 = 1e-12;

/// Root mean square of the differences of the cable lengths at which a pose has converged, as a share of the mean
/// length: their rounding.
pub const POSE_FIT_RELATIVE: f64 = 4e-16;

/// The same at a pose that fits but for rounding, also that of the pose: below it, no other pose is looked for.
pub const POSE_EXACT_RELATIVE: f64 = 10.0 * POSE_FIT_RELATIVE;

/// Poses whose root mean squares of residuals differ by less than this fit given cable lengths equally well, m.
pub const SAME_FIT: f64 = 1e-9;

/// Distance of two poses, as a share of the mean cable length, up to which they are one solution for the cable lengths.
pub const SAME_SOLUTION_RELATIVE: f64 = 1e-6;

/// Largest residual of the cable lengths from which a start is taken, m: stretch and sag cause some millimetres,
/// a platform at another orientation or a wrong zero of an encoder some centimetres.
pub const START_RESIDUAL: f64 = 0.01;

/// Maximum ratio of the largest to the smallest tension in cables that pull against each other. Cables that need more
/// are nearly in one half-space, and hold a platform only in theory.
pub const TENSION_RATIO: f64 = 1e4;

/// A column of a wrench matrix depends on other columns if its component orthogonal to their span is below this share
/// of the longest column: together they span no facet. The normal of a plane through nearly dependent columns is as
/// accurate as rounding allows; in any case the set lies below its support there, so no margin becomes too small
/// because of it.
pub const DEPENDENT: f64 = 1e-9;

/// Minimum ratio of the smallest to the largest diagonal entry of R for which the four-position kernel is
/// reliable: its results are then accurate to eleven digits.
pub const KERNEL_CONDITION: f64 = 1e-5;

/// Normals (in null-space coordinates, where they are of order one) longer than this are accurate to nine digits.
pub const KERNEL_NORMAL: f64 = 1e-6;

/// Normals shorter than this belong to dependent columns: they are zero up to rounding.
pub const KERNEL_NO_NORMAL: f64 = 1e-13;

/// Slack below this share of the longest edge of the available set (maximum tension times column) cannot be certified
/// along a motion, which is then rejected: the four-position kernel is accurate to some 1e-10 of that edge.
pub const SLACK_RELATIVE: f64 = 1e-9;

/// Minimum length of a piece that is still divided when a motion is certified, m: shorter ones are affected by rounding
/// of positions.
pub const CERTIFY_PIECE: f64 = 1e-11;

/// A normal shorter than this share of the product of the columns that it is orthogonal to, along a whole motion, is
/// zero up to rounding: the columns are dependent and span no facet.
pub const FACET_NO_NORMAL: f64 = 1e-14;

/// Rounding error of the slack to a facet along a motion, as a share of the longest edge of the set times the product
/// of the columns in the facet: some five products and sums for each, times 6 for the conversion from values to
/// coefficients.
pub const FACET_ROUNDING: f64 = 3e-14;

/// Share by which a largest scale is reduced if rounding puts it just outside.
pub const SCALE_ROUNDING: f64 = 1e-12;

/// Share by which a largest scale is reduced at most, where rounding decides farther inside than [`SCALE_ROUNDING`], as
/// for cables that are much shorter than others.
pub const MOST_SCALE_ROUNDING: f64 = 1e-7;

/// Accuracy of the smallest slack of a motion, as a share of the largest tension.
pub const LEAST_SLACK_RELATIVE: f64 = 1e-6;

/// Relative tolerance when whole steps are counted, so that a segment of exactly n steps has n of them.
pub const STEP_COUNT: f64 = 1e-12;

/// Width at which GJK's bounds on a distance count as equal, m, well inside [`GAP_TOLERANCE`].
pub const GJK_DISTANCE: f64 = 1e-11;

/// Minimum gain, m, for which rewinding replaces part of a path; "strictly shorter" beyond rounding, so that it
/// terminates.
pub const SHORTER: f64 = 1e-9;

/// Distance of string-pulled paths from the forbidden polyhedra, m: a segment along a face is then free beyond
/// rounding, for every engine. It makes a path longer by about this much at every bend.
pub const STANDOFF: f64 = 1e-8;

/// Gain below which string pulling ends, m.
pub const TAUT: f64 = 1e-10;

/// Error of `W t = w` that counts as zero, as a share of the larger of |w| and the largest tension: a wrench exactly
/// on the boundary of what the cables can balance stays inside despite rounding (about 1e-15).
pub const BALANCE_RELATIVE: f64 = 1e-9;

/// Apparent violation of a tension limit that is corrected by clamping, as a share of half the range: a
/// tenth of [`BALANCE_RELATIVE`], so that several cables at once still balance to that accuracy.
pub const LIMIT_RELATIVE: f64 = 1e-10;

/// A smaller violation of a limit is due to rounding, as a share of half a range; the active set changes only for more.
pub const LIMIT_ROUNDING: f64 = 1e-14;

/// Minimum separation of a wrench from the cables' limits by a plane that proves infeasibility, as a share of half a
/// range; limits that are only just compatible are widened by this. Half of [`LIMIT_RELATIVE`], so one of the two
/// always holds.
pub const LIMIT_SLACK: f64 = 5e-11;

/// Component of a limit's normal across those of active limits below which it counts as a combination of them while a p-norm
/// is lessened: a whole step then passes the limit by less than [`LIMIT_RELATIVE`].
pub const NORM_DEPENDENT: f64 = 1e-10;

/// Gradient of a sum of p-th powers that counts as zero, as a share of the sum of all terms: ten times their rounding error.
pub const NORM_GRADIENT: f64 = 1e-14;

/// Step that ends the search for the least p-norm, as a share of the largest deviation.
pub const NORM_STEP: f64 = 1e-12;

/// Negative multiplier of a limit that is due to rounding, as a share of the sum of all terms of a gradient.
pub const NORM_MULTIPLIER: f64 = 1e-12;

/// Component of a limit's normal orthogonal to the normals of the limits already met (normals have at most length 1)
/// below which it counts as a combination of these: rounding errors divided by this stay below [`LIMIT_SLACK`].
pub const DEPENDENT_NORMALS: f64 = 1e-5;

/// Replaces [`DEPENDENT_NORMALS`] in a second attempt if the first one was undecided; the resulting point or plane
/// is verified in any case.
pub const DEPENDENT_NORMALS_AT_LEAST: f64 = 1e-9;

/// Share of a separating direction that must remain after its component along the null space is removed; otherwise it
/// is due to rounding.
pub const SEPARATING_LEFT: f64 = 1e-8;

/// Relative error of sums of lengths along a tour, above any that rounding causes.
pub const TOUR_ROUNDING: f64 = 1e-12;

/// How far a suggested position is inside the valid positions, m.
pub const PLACE_MARGIN: f64 = 1e-3;

/// Tension limits count up to this multiple of the forces on the platform. Larger ones stand for "no limit": nothing
/// that moves the platform needs them, and tolerances are in proportion to them.
pub const PLENTY_OF_TENSION: f64 = 1e3;

/// Accuracy requested from the interior-point solver, on problems scaled to half ranges. Its result is verified and
/// made exact afterwards, so it only needs to identify the active limits.
pub const INTERIOR_POINT: f64 = 1e-8;

/// Regularisation of the interior-point solver's linear systems, which are small and scaled to 1. Without iterative
/// refinement this is an error of its steps, so it is below [`INTERIOR_POINT`].
pub const INTERIOR_POINT_REGULARISATION: f64 = 1e-10;

/// Distance from 1, in half ranges, at which a feasibility program may stop: the result is then clear, and is verified.
pub const PLAIN_ANSWER: f64 = 1e-3;

/// Maximum residual at which a program may stop with a clear result.
pub const PLAIN_RESIDUAL: f64 = 1e-6;

/// Corners of a mesh that are closer to each other than this share of its extent are one: formats that list triangles
/// by coordinates round them to single precision (6e-8).
pub const WELD_RELATIVE: f64 = 3e-7;

/// Relative rounding error of a ray's distance from an edge, with a large reserve: a ray that passes closer to it, as
/// seen from its origin, is replaced by another one.
pub const RAY_ROUNDING: f64 = 1e-13;

/// Thickness added on each side of a surface without an interior, m: engines avoid bodies with volume, and
/// parts of such a surface overlap by this along their seams.
pub const SHEET: f64 = 1e-4;

/// Height over a plane up to which a surface without an interior counts as flat, m: far less than [`SHEET`].
pub const FLAT_SHEET: f64 = 0.01 * SHEET;

/// Distance from the corner of a cell at which the body next to it is looked for, as a share of the piece's extent:
/// well above rounding, well below details.
pub const CORNER_PROBE: f64 = 1e-5;

/// Relative difference up to which two volumes or areas count as equal: rounding errors of meshes.
pub const EXACT_VOLUME: f64 = 1e-6;

/// Minimum share of the surface in a cell for a plane to be cut along; smaller faces belong to something round.
pub const FACE_SHARE: f64 = 0.02;

/// Share of the tolerance that planes around a part may extend beyond its hull: a larger share makes more parts and
/// leaves less space for paths, a smaller one makes parts with more faces.
pub const TIGHT_WRAP: f64 = 0.25;

/// Share of the tolerance up to which parts extend if the limit on their number allows it: the rest is space for paths.
pub const CLOSE: f64 = 0.5;

/// Share of the longest side of a piece: if its parts miss the tolerance and extend farther than this, the mesh is
/// rejected, since no shape is left that paths could be planned around.
pub const USELESS_REACH: f64 = 0.25;

/// Share of the tolerance beyond which a part counts as extending too far: distinguishing values just below from just
/// above the tolerance would take most of the time.
pub const UNDECIDED: f64 = 0.85;

/// Relative volume that a cut beside a void must leave, compared with one across the part, to be preferred.
pub const MUCH_SMALLER: f64 = 0.9;

/// Default of how far the parts of a mesh may extend beyond each of its connected pieces, as a share of the
/// piece's largest extent.
pub const MESH_TOLERANCE: f64 = 0.01;

/// Default of how far the parts of a mesh may extend, as a share of the whole mesh's extent, if that is more than
/// [`MESH_TOLERANCE`] of a piece: in a hall of 20 m, chairs accurate to the
/// millimetre are useless and would cost thousands of parts.
pub const MESH_TOLERANCE_IN_ALL: f64 = 0.0025;

/// Gap below which a proof that there is no path does not rule out a path, m: touching is free, so slits without width
/// remain between bodies that abut.
pub const PROOF_MARGIN: f64 = 1e-6;

/// Share of the margin that a proof may use; the rest is for rounding.
pub const PROOF_MARGIN_USED: f64 = 0.99;

/// Gap that a path must keep for a lower bound of the length to apply to it, m: smaller than for proofs, since no cells
/// have to fit into it. Without it, slits of zero width would be short cuts that no robot can use.
pub const BOUND_MARGIN: f64 = GAP_TOLERANCE;

/// Component of a unit quaternion below which it is zero, so that a turn counts as a half turn.
pub const HALF_TURN: f64 = 1e-12;

/// Angle below which a motion does not turn, rad: a point at 100 m would move by less than [`TOUCH_DEPTH`].
pub const NO_TURN: f64 = 1e-11;

/// Slack below which a motion with a turn is refused if a bound does not prove it free, m.
pub const TOO_CLOSE_TO_TURN: f64 = 1e-5;

/// Accuracy with which the first violation of a turning motion is located, as a share of the motion.
pub const TURNING_PLACE: f64 = 1.0 / 1024.0;

/// When lengths are bounded, a segment counts as blocked if it is at least this deep inside a polyhedron, m.
pub const BLOCKED_DEPTH: f64 = 1e-9;

/// The label of an interval may exceed what its neighbours allow by this, m; the bound is reduced accordingly. Far more
/// than rounding errors, so that labels settle.
pub const LABEL_STEP: f64 = 1e-9;

/// The label of an interval in a certificate may exceed what its neighbours allow by this for each bend, m, as the
/// checkers of certificates allow: [`LABEL_STEP`], and what rounding and [`WRITTEN_LABEL`] may add.
pub const BEND_STEP: f64 = 2e-8;

/// Accuracy with which certificates list labels, m.
pub const WRITTEN_LABEL: f64 = 1e-10;

/// A part of an edge is left out of a certificate if it is at least this deep inside a polyhedron, m: far more than
/// rounding errors, so that exact arithmetic finds it inside as well.
pub const COVERED_DEPTH: f64 = 1e-9;

/// Corners closer than this are listed once in a certificate, m: less than what the checkers take for the same place,
/// 1e-10.
pub const SAME_CORNER: f64 = 2e-11;

/// Intervals shorter than this are not halved, m.
pub const LEAST_INTERVAL: f64 = 1e-7;

/// Planes whose coordinates agree to this accuracy become one before lengths are bounded.
pub const SAME_PLANE: f64 = 1e-8;

/// Free edges shorter than this count as a corner when lengths are bounded, m. Planes that are moved by a quarter of
/// [`BOUND_MARGIN`] leave edges of 1e-9 to 1e-7 m where several polyhedra share a corner.
pub const TINY_EDGE: f64 = 1e-6;

/// Lines whose coordinates agree to this accuracy are compared more closely.
pub const SIMILAR_LINE: f64 = 1e-6;

/// Gap to a lower bound that is attempted if none is requested: paths at most a thousandth too long.
pub const BOUND_GAP: f64 = 1e-3;

/// Distance from a start or goal that touches something within which paths may touch anything, m.
pub const TOUCHING_END: f64 = 1e-3;

/// Least range of the parameter on which a turn is timed, m: its grid must be far coarser than rounding. The parameter
/// of a turn is arbitrary, so this changes no motion.
pub const LEAST_TURN_LENGTH: f64 = 1e-3;

/// Largest weight of a turn in the parameter of a timing, m/rad: the rest of the path must keep its digits.
pub const LARGEST_TURN_WEIGHT: f64 = 1e3;

/// Length of the parameter of the shortest bend between two turns, m: shorter ones would hardly be faster than a stop,
/// and their grid would come near rounding.
pub const LEAST_TURNING_BEND: f64 = 1e-5;

/// Distance of a waypoint from the line between its neighbours below which a trajectory goes straight on, m.
pub const STRAIGHT_ON: f64 = 1e-9;

/// Distance of a bend from its chord up to which the cells of the grid rule judge the chord, m: far below the size of a
/// cell.
pub const CHORD_OF_CELLS: f64 = 1e-4;

/// Share of each cable's range of tensions that trajectories leave unused at both ends: room for the proof that
/// tensions exist between instants. It costs about this share of the acceleration. Where the cables hold the platform
/// only with less room, the next one is tried, whose proof takes more time.
pub const TENSION_RESERVES: [f64; 3] = [1e-4, 1e-6, 1e-8];

/// A timing that exceeds its limits by at most this share is slowed down as a whole instead of planned again.
pub const TIMING_EXCESS: f64 = 1e-5;

/// Share by which limits are tightened where the proof that tensions exist fails. It doubles with every further
/// attempt.
pub const TENSION_EXCESS: f64 = 2e-3;

/// Largest norms of the first three derivatives of d/|d| along a line at unit speed, times |d| to their order. With x
/// the squared cotangent of the angle between d and the line, the squares of these are 1/(1+x), (1+4x)/(1+x)² and
/// 9(1+4x²)/(1+x)³.
pub const TURNING: [f64; 3] = [1.0, 1.154_700_538_379_251_5, 3.0];

/// Share by which a recorded motion may exceed a limit, because the program that planned it may have rounded
/// differently.
pub const RECORDED_EXCESS: f64 = 1e-6;

/// Assumed rounding of the positions of a recorded motion, m. Rates derived from them may exceed limits by what this
/// rounding adds.
pub const RECORDED_ROUNDING: f64 = 1e-6;

/// Largest difference of a recorded cable length from that of the robot, and of a sample from the exact form of its
/// motion, m; the same for rates, relative to 1 plus the rate.
pub const RECORDED_LENGTH: f64 = 1e-6;

/// Largest difference of a recorded cable speed from that of the robot, m/s, relative to 1 plus the speed of the
/// platform.
pub const RECORDED_RATE: f64 = 1e-4;

/// Allowed difference between the recorded accelerations and the change of velocity, as a multiple of the largest
/// acceleration. A short bend between two samples needs an acceleration that no sample shows; wrong units and missing
/// values cause larger differences.
pub const RECORDED_ACCELERATION: f64 = 3.0;

/// Allowed difference of a recorded velocity from the mean velocities beside it, as a multiple of how much these change
/// nearby. An acceleration that reverses between samples shows only in part there; velocities that alternate about the
/// right ones differ by more.
pub const RECORDED_BEND: f64 = 2.0;

/// Share of a tension limit by which a recorded tension may exceed it.
pub const RECORDED_TENSION: f64 = 1e-6;

/// Wrench that may be missing where a platform settles, as a share of tensions and loads, and what rounding of lengths adds to it as a
/// share of the axial stiffness of the cables.
pub const SETTLED: f64 = 1e-9;
/// See [`SETTLED`].
pub const SETTLED_STRETCH: f64 = 1e-15;

/// Share of a period below which a motion does not last into another one.
pub const SAME_SAMPLE: f64 = 1e-6;

/// Largest difference of recorded tensions from those that the motion or the robot names, as a share of 1 N plus the largest
/// maximum tension: rounded tables pass, and other tensions mostly differ by more.
pub const RECORDED_CHOICE: f64 = 1e-3;

/// Largest imbalance of recorded tensions, as a share of 1 N plus the norm of the wrench to be balanced.
pub const RECORDED_BALANCE: f64 = 1e-4;

/// Share of its range by which a tension may exceed its limits if accelerations are derived from positions.
pub const RECORDED_RESERVE: f64 = 1e-2;

/// Travel of a turning platform between two samples, m, up to which one search for violations, at 33 poses, is enough.
pub const SAMPLED_TRAVEL: f64 = 0.01;

/// A sample closer than this to a jump in acceleration may belong to either side of it, s.
pub const SAME_TIME: f64 = 1e-9;

/// Allowed excess of a recorded motion over the slack that the required wrench margin leaves, as a share of that slack.
pub const RECORDED_SHARE: f64 = 1e-2;

/// Largest overlap on the straight line between two samples that is attributed to the sampling, m. At 100 samples per
/// second and 8 m/s², the motion deviates from the straight line by this much.
pub const RECORDED_OVERLAP: f64 = 1e-4;

/// Distance of the corners of the polytope around a pulley's exits from them, at most, in each of two directions, as a
/// share of the radius: 4 mm for a radius of 50 mm. A quarter of it would need twice as many corners, and all work on
/// cables with pulleys would take twice as long.
pub const EXIT_EXCESS: f64 = 0.08;

/// Excess up to which the wrap angles of a box of attachments are bounded, rad: half of [`EXIT_EXCESS`] on the wheel.
pub const WRAP_EXCESS: f64 = 0.01;

/// Excess over π up to which a box that is seen from a pulley's axis does not contain the axis, rad: it is in a face.
pub const AXIS_IN_FACE: f64 = 1e-12;

/// Sides of a box of attachments that differ by no more than this share are equally long: the first of them is halved.
pub const SAME_SIDE: f64 = 1e-9;

/// Largest error of the products of a facet's normal and dual vectors with its columns, which have length 1 or more; pivots below it
/// mean dependent columns.
pub const FACET_DUAL: f64 = 1e-10;

/// Rounding errors of the slack to a facet over a box, as a share of the largest wrench: a hundred times [`FACET_DUAL`].
pub const FACET_OVER_ROUNDING: f64 = 1e-8;

/// A widest path is within this of the largest possible clearance, m: less than what cables and platforms are built to.
pub const WIDEST_GAP: f64 = 1e-3;

/// By how much the clearance that an end of a path is refused at exceeds its own, m: more than the engines differ.
pub const BEYOND_END: f64 = 1e-6;

/// What the cables lack in a box of a certificate exceeds this share of the terms that it is computed from: far more than their rounding
/// errors, so that checkers find the same.
pub const WEAK_RESERVE: f64 = 1e-9;
