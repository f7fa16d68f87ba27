#ifndef GOISHI_H
#define GOISHI_H
/// \file
/// Goishi from C, and from whatever can call C: a few coarse functions on plain arrays. `libgoishi.so` has them.
///
/// Units    SI: m, kg, s, rad.
/// Frames   W world, z up, origin in the middle of the playing surface; B body, origin at the centre of mass, Bz the
///          symmetry axis. Letters and symbols are those of the notation table of the C++ library, which has the formulas,
///          the domains and the errors, too: each function names what it calls.
/// Arrays   each comes with its size, counted in elements, so that one made for another version is refused. Their places
///          have names, GOISHI_…, below. Inputs are read before outputs are written, so they may overlap.
/// Results  each function that can fail returns GOISHI_OK or what was wrong, and `goishi_message()` tells it in words. Then
///          nothing has been written. What is no error of the caller (no contact, not converged, off the board) is a
///          number in the result. Whole numbers and enumerators in arrays of `double` are exact.
/// Threads  no function shares anything with another but the arguments; the message is the thread's own. One drop is for one
///          thread at a time.

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define GOISHI_API
#else
#define GOISHI_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// What a function returns.
enum {
  GOISHI_OK = 0,
  GOISHI_INVALID_ARGUMENT = 1,  ///< null, NaN, a wrong size, a broken rule: the message names argument, value and rule
  GOISHI_OUT_OF_MEMORY = 2,
  GOISHI_FAILURE = 3  ///< of the library itself
};

/// The version of the library, "0.1.0".
GOISHI_API const char* goishi_version(void);

/// What the last function that this thread called, of those that return a status, had to say: "height = 0.03: must not
/// exceed the width (0.022)"; empty if it succeeded. UTF-8, at most 511 bytes, until the thread calls the next.
GOISHI_API const char* goishi_message(void);

// --- A stone

/// A stone of uniform density. Of density and mass one is positive, and the other 0.
enum {
  GOISHI_WIDTH = 0,     ///< w [m], diameter of the lens that generates it
  GOISHI_HEIGHT = 1,    ///< h [m], thickness, 0 < h <= w
  GOISHI_BEVEL = 2,     ///< b [m], height of the bevel band, 0 <= b < h; 0: sharp
  GOISHI_MEASURED = 3,  ///< 1: the width is that of the finished stone, which a bevel else makes smaller; 0: it is not
  GOISHI_DENSITY = 4,   ///< ρ [kg/m³]
  GOISHI_MASS = 5,      ///< m [kg]
  GOISHI_STONE_SIZE = 6
};

enum { GOISHI_WHITE = 0, GOISHI_BLACK = 1 };

/// The stone of a catalogue number (22, 25, 28, 30 … 50) and colour, by the talk's standard, with a bevel [m]; the density is
/// an assumed one.
/// Calls  catalogue_stone.   Result  `stone[GOISHI_STONE_SIZE]`.
GOISHI_API int goishi_catalogue_stone(int number, int color, double bevel, double* stone, size_t stone_size);

/// What a stone measures, about its centre of mass, in B.
enum {
  GOISHI_MEASURE_WIDTH = 0,         ///< w [m] of the generating lens
  GOISHI_MEASURE_HEIGHT = 1,        ///< h [m]
  GOISHI_MEASURE_BEVEL = 2,         ///< b [m]
  GOISHI_OUTER_WIDTH = 3,           ///< 2(r₁ + r₂) [m], of the finished stone
  GOISHI_SPHERE_RADIUS = 4,         ///< r [m]
  GOISHI_SPHERE_OFFSET = 5,         ///< d [m]
  GOISHI_MAJOR_RADIUS = 6,          ///< r₁ [m] of the bevel's torus
  GOISHI_MINOR_RADIUS = 7,          ///< r₂ [m]
  GOISHI_JOINT_RADIUS = 8,          ///< P_x [m], where cap and bevel touch
  GOISHI_JOINT_COSINE = 9,          ///< cos α, the radial part of the normal there
  GOISHI_JOINT_SINE = 10,           ///< sin α, the axial part
  GOISHI_VOLUME = 11,               ///< V [m³]
  GOISHI_SURFACE_AREA = 12,         ///< [m²]
  GOISHI_TRUE_DENSITY = 13,         ///< ρ [kg/m³]
  GOISHI_TRUE_MASS = 14,            ///< m [kg]
  GOISHI_AXIAL = 15,                ///< I_a [kg m²]
  GOISHI_TRANSVERSE = 16,           ///< I_t [kg m²]
  GOISHI_AXIAL_PER_MASS = 17,       ///< I_a/m [m²]
  GOISHI_TRANSVERSE_PER_MASS = 18,  ///< I_t/m [m²]
  GOISHI_MEASURES_SIZE = 19
};

/// Calls  make_stone or make_measured_stone, mass_properties.   Result  `measures[GOISHI_MEASURES_SIZE]`.
GOISHI_API int goishi_measures(const double* stone, size_t stone_size, double* measures, size_t measures_size);

/// What the talk gives of a stone, to compare with: its formulas for the lens that generates it.
enum {
  GOISHI_PUBLISHED_MAJOR_RADIUS = 0,  ///< r₁ [m] by its bevel function
  GOISHI_PUBLISHED_MINOR_RADIUS = 1,  ///< r₂ [m], < 0
  GOISHI_PUBLISHED_VOLUME = 2,        ///< V' [m³], of lengths in cm taken as cm³
  GOISHI_PUBLISHED_AXIAL = 3,         ///< I_a/m [m²] by its closed form, which is right, over V'
  GOISHI_PUBLISHED_SUM_AXIAL = 4,     ///< I_a/m [m²] by its sum over nodes, as printed
  GOISHI_PUBLISHED_SUM_TRANSVERSE = 5,
  GOISHI_PUBLISHED_SUM_NODES = 6,
  GOISHI_PUBLISHED_MEASURES_SIZE = 7
};

/// Calls   published_bevel, published_volume, published_tensor.
/// Domain  a stone no thinner than 1 µm and no wider than 10 cm, for the sum.
/// Result  `published[GOISHI_PUBLISHED_MEASURES_SIZE]`.
GOISHI_API int goishi_published_measures(const double* stone, size_t stone_size, double* published,
                                         size_t published_size);

/// The inertia tensor of a stone that stands somewhere, about the origin of W, in W   [kg m²].
/// Calls  inertia_tensor.   Sizes  GOISHI_POSE_SIZE, 9 (row by row).
GOISHI_API int goishi_tensor(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                             double* tensor, size_t tensor_size);

/// A point of the meridian, in the half plane of the axis Bz and the radius ρ.
enum {
  GOISHI_ARC = 0,         ///< [m] along the meridian from the upper pole
  GOISHI_RHO = 1,         ///< [m] from the axis
  GOISHI_ZETA = 2,        ///< [m] over the middle
  GOISHI_NORMAL_RHO = 3,  ///< the outward unit normal
  GOISHI_NORMAL_ZETA = 4,
  GOISHI_CURVATURE = 5,     ///< [1/m] of the meridian: 1/r on a cap, 1/r₂ on the bevel
  GOISHI_PROFILE_PART = 6,  ///< GOISHI_UPPER_CAP, GOISHI_LOWER_CAP or GOISHI_RIM
  GOISHI_PROFILE_SIZE = 7
};

/// Parts of a stone's surface. A sharp edge is a rim, too.
enum { GOISHI_UPPER_CAP = 0, GOISHI_LOWER_CAP = 1, GOISHI_RIM = 2 };

/// The meridian from pole to pole, in steps that are equally long on each of its three parts. Each part has both of its
/// ends, so where cap and bevel touch there are two points at one place, one of each curvature. A sharp stone has no bevel.
/// Calls   make_stone, support.
/// Result  `steps` + 1 points of each part, of a sharp stone 2 (steps + 1) in all, else 3 (steps + 1): `rows` is as many times
///         GOISHI_PROFILE_SIZE.
GOISHI_API int goishi_profile(const double* stone, size_t stone_size, size_t steps, double* rows, size_t rows_size);

// --- A stone as triangles

/// How the caps are cut.
enum { GOISHI_SUBDIVISION = 0, GOISHI_RINGS = 1 };

/// What makes two vertices one: nothing (each triangle has its own), the same place and normal, or the same place.
enum { GOISHI_UNWELDED = 0, GOISHI_WELDED = 1, GOISHI_WELDED_BY_POSITION = 2 };

/// How finely, in whole numbers.
enum { GOISHI_MESH_RINGS = 0, GOISHI_MESH_ROWS = 1, GOISHI_MESH_SEGMENTS = 2, GOISHI_FINENESS_SIZE = 3 };

/// Of a level from 0 to 8; or, with `level` −1, of few triangles that are nowhere farther than `tolerance` [m] from the stone.
/// Calls  fineness_of_level or fineness_for.   Result  `fineness[GOISHI_FINENESS_SIZE]`.
GOISHI_API int goishi_fineness(const double* stone, size_t stone_size, int method, int level, double tolerance,
                               int* fineness, size_t fineness_size);

/// What a mesh has, and what it is beside the stone.
enum {
  GOISHI_MESH_VERTICES = 0,
  GOISHI_MESH_TRIANGLES = 1,
  GOISHI_MESH_POINTS = 2,        ///< different places of vertices
  GOISHI_MESH_EDGES = 3,         ///< between them
  GOISHI_MESH_LOOSE_EDGES = 4,   ///< not of two triangles, one in each direction; 0: watertight
  GOISHI_MESH_DEVIATION = 5,     ///< [m] how far it is from the stone, anywhere, at most
  GOISHI_MESH_VOLUME = 6,        ///< [m³] that it encloses
  GOISHI_MESH_SURFACE_AREA = 7,  ///< [m²]
  GOISHI_MESH_FIGURES_SIZE = 8
};

/// Calls  tessellate, unwelded or weld, topology, deviation, mesh_mass.   Result  `figures[GOISHI_MESH_FIGURES_SIZE]`.
GOISHI_API int goishi_mesh_figures(const double* stone, size_t stone_size, int method, const int* fineness,
                                   size_t fineness_size, int weld, double* figures, size_t figures_size);

/// How many vertices and triangles the mesh has: what to make room for.
GOISHI_API int goishi_mesh_counts(const double* stone, size_t stone_size, int method, const int* fineness,
                                  size_t fineness_size, int weld, size_t* vertices, size_t* triangles);

/// The mesh, in B: x, y, z of each vertex, and of the surface's unit normal there; the three vertices of each triangle,
/// counter-clockwise as seen from outside.
/// Calls  tessellate, unwelded or weld.
/// Sizes  `points` and `normals` 3 times the vertices, `corners` 3 times the triangles of `goishi_mesh_counts`.
GOISHI_API int goishi_mesh(const double* stone, size_t stone_size, int method, const int* fineness,
                           size_t fineness_size, int weld, double* points, size_t points_size, double* normals,
                           size_t normals_size, uint32_t* corners, size_t corners_size);

// --- Motion

/// How a body moves. Its first GOISHI_POSE_SIZE numbers are its pose.
enum {
  GOISHI_POSITION = 0,  ///< p_WB [m], x, y, z
  GOISHI_ATTITUDE = 3,  ///< q_WB, a unit quaternion w, x, y, z: v_W = q_WB v_B. |q|² may be off 1 by 64 ε
  GOISHI_POSE_SIZE = 7,
  GOISHI_VELOCITY = 7,   ///< v_WB [m/s]
  GOISHI_MOMENTUM = 10,  ///< L_W [kg m²/s], angular, about the centre of mass
  GOISHI_STATE_SIZE = 13,
  /// A motion is a state and what follows from it.
  GOISHI_ANGULAR_VELOCITY = 13,  ///< ω in W [rad/s]
  GOISHI_ENERGY = 16,            ///< [J] of rotation, translation and position, that zero at the origin of W
  GOISHI_MOTION_SIZE = 17
};

/// The state of a stone with a pose, a velocity in W and an angular velocity w_WB_B in B   [rad/s]. The attitude need not be of
/// length 1 here: it is normalised.
/// Calls  angular_momentum_W.   Sizes  GOISHI_POSE_SIZE, 3, 3, GOISHI_STATE_SIZE.
GOISHI_API int goishi_state(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                            const double* velocity, size_t velocity_size, const double* spin, size_t spin_size,
                            double* state, size_t state_size);

/// What of the motion is wanted.
enum { GOISHI_LINEAR = 0, GOISHI_ANGULAR = 1, GOISHI_BOTH = 2 };

/// The motion after a time [s] of free flight, forwards or backwards, exactly.
/// Calls  free_flight.   Sizes  GOISHI_STATE_SIZE, 3 (gravity [m/s²], in W), GOISHI_MOTION_SIZE.
GOISHI_API int goishi_free_flight(const double* stone, size_t stone_size, const double* state, size_t state_size,
                                  const double* gravity, size_t gravity_size, int freedom, double time, double* motion,
                                  size_t motion_size);

/// Principal moments of any body with a symmetry axis   [kg m²].
enum { GOISHI_MOMENT_AXIAL = 0, GOISHI_MOMENT_TRANSVERSE = 1, GOISHI_MOMENTS_SIZE = 2 };

/// How such a body has turned after a time [s] free of torque, exactly: attitude, and angular velocity in W [rad/s].
/// Calls  free_flight.   Sizes  GOISHI_MOMENTS_SIZE, 4 (q_WB), 3 (L_W), 7.
GOISHI_API int goishi_free_rotation(const double* moments, size_t moments_size, const double* attitude,
                                    size_t attitude_size, const double* momentum, size_t momentum_size, double time,
                                    double* rotation, size_t rotation_size);

/// Schemes that go step by step, the exact one among them.
enum {
  GOISHI_PUBLISHED = 0,  ///< the talk's loop
  GOISHI_EXPLICIT_EULER = 1,
  GOISHI_EXPONENTIAL_EULER = 2,
  GOISHI_IMPLICIT_MIDPOINT = 3,
  GOISHI_RUNGE_KUTTA_4 = 4,
  GOISHI_SPLITTING_2 = 5,
  GOISHI_SPLITTING_4 = 6,
  GOISHI_SPLITTING_6 = 7,
  GOISHI_EXACT = 8
};

/// How stepping ended.
enum { GOISHI_COMPLETED = 0, GOISHI_DIVERGED = 1, GOISHI_STEP_NOT_CONVERGED = 2 };

/// A moment of a flight in steps, beside the exact one.
enum {
  GOISHI_FLIGHT_TIME = 0,      ///< [s]
  GOISHI_STEPPED = 1,          ///< the motion in steps
  GOISHI_EXACTLY = 18,         ///< the exact motion
  GOISHI_ATTITUDE_ERROR = 35,  ///< [rad] the angle between the two
  GOISHI_POSITION_ERROR = 36,  ///< [m]
  GOISHI_FLIGHT_SIZE = 37
};

/// A flight in steps of `step` [s] by a scheme: a row at the start, and one after every `steps` steps.
/// Calls   Stepper::advance once a row, free_flight.
/// Domain  at most 10⁸ steps in all.
/// Result  `rows`, as many as it has room for, its size a multiple of GOISHI_FLIGHT_SIZE; `done` says how many were
///         filled before a step failed, and `ended` how. The others are as they were.
GOISHI_API int goishi_flight(const double* stone, size_t stone_size, const double* state, size_t state_size,
                             const double* gravity, size_t gravity_size, int freedom, int scheme, double step,
                             int steps, double* rows, size_t rows_size, size_t* done, int* ended);

// --- Contact

/// What a stone is against: by its size a plane or a board.
enum {
  GOISHI_PLANE_NORMAL = 0,  ///< unit, in W, out of the solid
  GOISHI_PLANE_OFFSET = 3,  ///< [m]: the solid is n · x <= offset
  GOISHI_PLANE_SIZE = 4
};
enum {
  GOISHI_BOARD_LINES = 0,      ///< a whole number
  GOISHI_BOARD_SPACING_X = 1,  ///< [m] between neighbouring lines
  GOISHI_BOARD_SPACING_Y = 2,
  GOISHI_BOARD_BORDER_X = 3,  ///< [m] from the outermost line to the side
  GOISHI_BOARD_BORDER_Y = 4,
  GOISHI_BOARD_THICKNESS = 5,  ///< [m]
  GOISHI_BOARD_LEGS = 6,       ///< [m] height of its underside over the floor
  GOISHI_BOARD_SIZE = 7
};

/// The real 19-line board, on the floor.   Result  `board[GOISHI_BOARD_SIZE]`.
GOISHI_API int goishi_board(double* board, size_t board_size);

enum { GOISHI_SEPARATED = 0, GOISHI_OVERLAPPING = 1, GOISHI_NOT_CERTAIN = 2 };

/// What a stone touches, or would.
enum {
  GOISHI_ON_SURFACE = 0,
  GOISHI_ON_SIDE = 1,
  GOISHI_ON_TOP_EDGE = 2,
  GOISHI_ON_VERTICAL_EDGE = 3,
  GOISHI_ON_CORNER = 4,
  GOISHI_ON_STONE = 5
};

/// Where two bodies are next to each other.
enum {
  GOISHI_SEPARATION_STATUS = 0,  ///< GOISHI_SEPARATED, GOISHI_OVERLAPPING, or GOISHI_NOT_CERTAIN: a lower bound
  GOISHI_GAP = 1,                ///< [m], < 0: depth
  GOISHI_NORMAL = 2,             ///< unit, in W, out of the other body towards the stone
  GOISHI_POINT = 5,              ///< [m] contact point on the stone, in W
  GOISHI_OTHER_POINT = 8,        ///< [m] on the other body
  GOISHI_FEATURE = 11,           ///< of the stone: GOISHI_UPPER_CAP …
  GOISHI_OTHER_FEATURE = 12,     ///< of the other: GOISHI_ON_SURFACE …
  GOISHI_CERTIFIED = 13,         ///< 1: no normal separates more, and that is proved
  GOISHI_SEPARATION_SIZE = 14
};

/// Calls  separation.   Sizes  GOISHI_POSE_SIZE; GOISHI_PLANE_SIZE or GOISHI_BOARD_SIZE; GOISHI_SEPARATION_SIZE.
GOISHI_API int goishi_separation(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                                 const double* ground, size_t ground_size, double* separation, size_t separation_size);
GOISHI_API int goishi_separation_stones(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                                        const double* other, size_t other_size, const double* other_pose,
                                        size_t other_pose_size, double* separation, size_t separation_size);

/// The talk's nine regions, and beyond: where a stone's centre is, seen from above.
enum {
  GOISHI_PRIMARY = 0,
  GOISHI_LEFT = 1,
  GOISHI_RIGHT = 2,
  GOISHI_BOTTOM = 3,
  GOISHI_TOP = 4,
  GOISHI_BOTTOM_LEFT = 5,
  GOISHI_BOTTOM_RIGHT = 6,
  GOISHI_TOP_LEFT = 7,
  GOISHI_TOP_RIGHT = 8,
  GOISHI_OUT_OF_REACH = 9
};

/// What the talk's separating-axis test answers, to compare with. An axis has GOISHI_AXIS_SIZE numbers: a unit vector in W, out
/// of the board, and the depth [m] of the stone along it, < 0 if it separates.
enum {
  GOISHI_AXIS_DEPTH = 3,
  GOISHI_AXIS_SIZE = 4,
  GOISHI_REGION = 0,      ///< GOISHI_PRIMARY …
  GOISHI_COLLIDING = 1,   ///< 1: no axis separates
  GOISHI_LEAST_AXIS = 2,  ///< of least penetration; not colliding: the first that separates; NaN out of reach
  GOISHI_MOST_AXIS = 6,   ///< of most penetration; likewise
  GOISHI_AXES = 10,       ///< that the region has
  GOISHI_FIRST_AXIS =
      11,  ///< and the others behind it, in the published order; there is room for 7, NaN where there is none
  GOISHI_PUBLISHED_SEPARATION_SIZE = 39
};

/// Calls  separating_axis_published, published_axes.   Sizes  GOISHI_POSE_SIZE, GOISHI_BOARD_SIZE, GOISHI_PUBLISHED_SEPARATION_SIZE.
GOISHI_API int goishi_published_separation(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                                           const double* board, size_t board_size, double* separation,
                                           size_t separation_size);

enum { GOISHI_HIT = 0, GOISHI_NO_HIT = 1, GOISHI_HIT_OVERLAPPING = 2, GOISHI_HIT_NOT_CONVERGED = 3 };

/// When a flying stone first touches.
enum {
  GOISHI_HIT_STATUS = 0,   ///< GOISHI_HIT, GOISHI_NO_HIT within the horizon, overlapping at the start, not converged
  GOISHI_HIT_TIME = 1,     ///< [s] of the hit; else up to when it is proved that nothing touches
  GOISHI_HIT_CONTACT = 2,  ///< the separation then; NaN where none was asked for
  GOISHI_HIT_STEPS = 16,   ///< of the root finder
  GOISHI_HIT_SEPARATIONS = 17,  ///< normals that were needed
  GOISHI_HIT_SIZE = 18
};

/// Calls  path_of, time_of_impact.   Domain  horizon > 0 [s]; infinite is allowed.
GOISHI_API int goishi_time_of_impact(const double* stone, size_t stone_size, const double* state, size_t state_size,
                                     const double* gravity, size_t gravity_size, const double* ground,
                                     size_t ground_size, double horizon, double* hit, size_t hit_size);
GOISHI_API int goishi_time_of_impact_stones(const double* stone, size_t stone_size, const double* state,
                                            size_t state_size, const double* other, size_t other_size,
                                            const double* other_state, size_t other_state_size, const double* gravity,
                                            size_t gravity_size, double horizon, double* hit, size_t hit_size);

// --- Impact

/// How an impulse is found.
enum { GOISHI_CHATTERJEE_RUINA = 0, GOISHI_PUBLISHED_LAW = 1, GOISHI_STRONGE = 2 };

enum { GOISHI_SEPARATING = 0, GOISHI_STUCK = 1, GOISHI_SLID = 2, GOISHI_IMPACT_NOT_CONVERGED = 3 };

/// An impact, on the stone; another gets the opposite impulse.
enum {
  GOISHI_OUTCOME = 0,          ///< GOISHI_SEPARATING …
  GOISHI_IMPULSE = 1,          ///< [N s], in W
  GOISHI_NORMAL_IMPULSE = 4,   ///< [N s] its part along the normal
  GOISHI_VELOCITY_BEFORE = 5,  ///< [m/s] of the contact points, stone − other
  GOISHI_VELOCITY_AFTER = 8,
  GOISHI_ENERGY_CHANGE = 11,  ///< [J] of both bodies
  GOISHI_ROUNDS = 12,         ///< normal-and-friction rounds, or steps of the integration
  GOISHI_NEW_VELOCITY = 13,   ///< v_WB [m/s] of the stone, after
  GOISHI_NEW_MOMENTUM = 16,   ///< L_W [kg m²/s]
  GOISHI_IMPACT_SIZE = 19,
  GOISHI_OTHER_NEW_VELOCITY = 19,  ///< of the other stone
  GOISHI_OTHER_NEW_MOMENTUM = 22,
  GOISHI_IMPACT_STONES_SIZE = 25
};

/// A stone meets a fixed body at a point [m] of W; the unit normal points out of the fixed body.
/// Calls   resolve.
/// Domain  0 <= restitution <= 1, 0 <= friction, infinity allowed.
GOISHI_API int goishi_impact(const double* stone, size_t stone_size, const double* state, size_t state_size, int law,
                             double restitution, double friction, const double* point, size_t point_size,
                             const double* normal, size_t normal_size, double* impact, size_t impact_size);

/// Two stones meet; the normal points out of the other one towards the first.
GOISHI_API int goishi_impact_stones(const double* stone, size_t stone_size, const double* state, size_t state_size,
                                    const double* other, size_t other_size, const double* other_state,
                                    size_t other_state_size, int law, double restitution, double friction,
                                    const double* point, size_t point_size, const double* normal, size_t normal_size,
                                    double* impact, size_t impact_size);

// --- The drop

/// A setting that is left to the library: a multiple of the stone's own scales. Those that may be say so.
#define GOISHI_UNSET (-1.0)

enum { GOISHI_DRY = 0, GOISHI_SLIP_PROPORTIONAL = 1, GOISHI_COULOMB_CONTENSOU = 2 };

/// What of a drop can be chosen; `drop/settings.hpp` has the reasons.
enum {
  GOISHI_RESTITUTION = 0,         ///< e, 0 … 1
  GOISHI_FRICTION = 1,            ///< μ >= 0, infinity allowed
  GOISHI_GRAVITY = 2,             ///< [m/s²] in W; a slope is a gravity that leans
  GOISHI_ROLLING_RESISTANCE = 5,  ///< δ [m] <= w/2, or unset
  GOISHI_PIVOT_RADIUS = 6,        ///< κ [m] <= w/2, or unset
  GOISHI_FRICTION_MODEL = 7,      ///< GOISHI_DRY …
  GOISHI_SLIP_COEFFICIENT = 8,    ///< [s/m] of GOISHI_SLIP_PROPORTIONAL, or unset
  GOISHI_PATCH_RADIUS = 9,        ///< [m] <= w/2 of GOISHI_COULOMB_CONTENSOU, or unset
  GOISHI_CREEP_SPEED = 10,        ///< [m/s] of the same, or unset
  GOISHI_DAMPING = 11,            ///< [1/s] the talk's, while in contact
  GOISHI_LAW = 12,                ///< of impacts: GOISHI_CHATTERJEE_RUINA …
  GOISHI_HORIZON = 13,            ///< [s] for which it is followed to rest, or unset
  GOISHI_MAXIMUM_IMPACTS = 14,    ///< a whole number below 2³¹, as the next two are; it stops after so many
  GOISHI_MAXIMUM_EVENTS = 15,     ///< a drop that makes more is given up, and says so
  GOISHI_MAXIMUM_STEPS = 16,      ///< of everything that is repeated; likewise
  GOISHI_TOLERANCE = 17,          ///< of a step in contact, 2.3e-14 … 0.01
  GOISHI_CONTACT_SPEED = 18,      ///< [m/s] or unset
  GOISHI_CLOSING_SPEED = 19,      ///< [m/s] or unset
  GOISHI_EDGE_SPEED = 20,         ///< [m/s] or unset
  GOISHI_TOUCHING = 21,           ///< of the width: no deeper inside is touching
  GOISHI_SETTINGS_SIZE = 22
};

/// The library's own.   Result  `settings[GOISHI_SETTINGS_SIZE]`.
GOISHI_API int goishi_settings(double* settings, size_t settings_size);

/// A stone under way.
typedef struct goishi_drop goishi_drop;

enum {
  GOISHI_REST = 0,
  GOISHI_REST_LEANING = 1,
  GOISHI_MOVING = 2,
  GOISHI_FLIES_ON = 3,
  GOISHI_START_INSIDE = 4,
  GOISHI_TOO_MANY_EVENTS = 5,
  GOISHI_TOO_MANY_STEPS = 6,
  GOISHI_DROP_NOT_CONVERGED = 7
};

/// What was touched last; GOISHI_GROUND_BOARD also stands for a plane.
enum { GOISHI_GROUND_NONE = 0, GOISHI_GROUND_BOARD = 1, GOISHI_GROUND_FLOOR = 2 };

/// Starts a drop on the plane z = 0 (normal 0, 0, 1, offset 0) or on a board, off which it may fall to the floor. Of its motion the
/// last `kept` stretches are kept, 744 bytes each, so that the states of the past can be asked for; 0 keeps none.
/// Calls  Drop, keep_motion.   Result  `*drop`, to be given to `goishi_drop_free` in the end.
GOISHI_API int goishi_drop_create(const double* stone, size_t stone_size, const double* state, size_t state_size,
                                  const double* ground, size_t ground_size, const double* settings,
                                  size_t settings_size, size_t kept, goishi_drop** drop);

/// Another one in the same state, which goes on as this one does, bit for bit, its events included.
GOISHI_API int goishi_drop_copy(const goishi_drop* drop, goishi_drop** copy);

/// Null is allowed.
GOISHI_API void goishi_drop_free(goishi_drop* drop);

/// Goes on for a time dt [s]; an infinite one: until it ends, for no longer than the settings' horizon. What ends it
/// earlier, its budget say, is in the info, and the next call goes on. After GOISHI_OUT_OF_MEMORY only free it.
/// Calls  Drop::advance or advance_to_rest.   Domain  dt >= 0.
GOISHI_API int goishi_drop_advance(goishi_drop* drop, double dt);

/// An impulse [N s] at a point [m], both in W.   Calls  Drop::apply_impulse.
GOISHI_API int goishi_drop_push(goishi_drop* drop, const double* point, size_t point_size, const double* impulse,
                                size_t impulse_size);

/// Other settings from now on, gravity among them; a stone at rest wakes if they move it.   Calls  Drop::change.
GOISHI_API int goishi_drop_change(goishi_drop* drop, const double* settings, size_t settings_size);

/// Where a drop is, and what it cost.
enum {
  GOISHI_DROP_TIME = 0,          ///< [s]
  GOISHI_DROP_STATUS = 1,        ///< GOISHI_REST …
  GOISHI_DROP_GROUND = 2,        ///< GOISHI_GROUND_NONE …
  GOISHI_DROP_DEPTH = 3,         ///< [m] of GOISHI_START_INSIDE
  GOISHI_DROP_LOWER_ORDER = 4,   ///< 1: an edge, a side or two places were passed by micro-impacts
  GOISHI_DROP_MOTION_BEGIN = 5,  ///< [s] from when on the state can be told
  GOISHI_DROP_KEPT = 6,          ///< stretches
  GOISHI_DROP_EVENTS = 7,        ///< that there are to read
  GOISHI_DROP_IMPACTS = 8,       ///< and what was computed, as DropCounters has it
  GOISHI_DROP_ROOT_STEPS = 9,
  GOISHI_DROP_SEPARATIONS = 10,
  GOISHI_DROP_CONTACT_EVALUATIONS = 11,
  GOISHI_DROP_STEPS_ACCEPTED = 12,
  GOISHI_DROP_STEPS_REJECTED = 13,
  GOISHI_DROP_EVALUATIONS_LOCATED = 14,
  GOISHI_DROP_EDGE_IMPACTS = 15,
  GOISHI_DROP_MOTION = 16,  ///< the present motion
  GOISHI_DROP_SIZE = 33
};

GOISHI_API int goishi_drop_info(const goishi_drop* drop, double* info, size_t info_size);

enum {
  GOISHI_KIND_START = 0,
  GOISHI_KIND_IMPACT = 1,
  GOISHI_KIND_BOUNCES_CLOSE = 2,
  GOISHI_KIND_CONTACT = 3,
  GOISHI_KIND_STICK = 4,
  GOISHI_KIND_SLIP = 5,
  GOISHI_KIND_FEATURE = 6,
  GOISHI_KIND_JAM = 7,
  GOISHI_KIND_LIFT_OFF = 8,
  GOISHI_KIND_BOARD_EDGE = 9,
  GOISHI_KIND_SIDE = 10,
  GOISHI_KIND_REST = 11,
  GOISHI_KIND_WOKEN = 12,
  GOISHI_KIND_PUSH = 13
};

enum {
  GOISHI_EVENT_KIND = 0,         ///< GOISHI_KIND_START …
  GOISHI_EVENT_TIME = 1,         ///< [s]
  GOISHI_EVENT_ENERGY = 2,       ///< [J] after
  GOISHI_EVENT_IMPULSE = 3,      ///< [N s] on the stone, in W
  GOISHI_EVENT_POINT = 6,        ///< [m] contact point, in W; NaN where there is none, as is the normal
  GOISHI_EVENT_NORMAL = 9,       ///< unit, out of what is touched
  GOISHI_EVENT_PART = 12,        ///< of the stone: GOISHI_UPPER_CAP …
  GOISHI_EVENT_OTHER_PART = 13,  ///< of what is touched: GOISHI_ON_SURFACE …
  GOISHI_EVENT_OUTCOME = 14,     ///< of the impulse: GOISHI_SEPARATING …
  GOISHI_EVENT_BEFORE = 15,      ///< the state before
  GOISHI_EVENT_AFTER = 28,       ///< and after
  GOISHI_EVENT_SIZE = 41
};

/// The events from the one with the place `first` on, counted from 0.
/// Result  `rows`, as many as it has room for, its size a multiple of GOISHI_EVENT_SIZE; so many there must be.
GOISHI_API int goishi_drop_events(const goishi_drop* drop, size_t first, double* rows, size_t rows_size);

/// Where an event changes the state at once: before or after it.
enum { GOISHI_BEFORE = 0, GOISHI_AFTER = 1 };

/// The motions at some times [s] of the past, in any order.
/// Calls  Drop::state_at.   Domain  from GOISHI_DROP_MOTION_BEGIN to GOISHI_DROP_TIME.
/// Sizes  `motions` GOISHI_MOTION_SIZE for each time.
GOISHI_API int goishi_drop_motions(const goishi_drop* drop, const double* times, size_t times_size, int side,
                                   double* motions, size_t motions_size);

/// Whether a stone that is laid down stays, and how firmly. A share is the least part of what there is that would still hold it.
enum {
  GOISHI_HOLDS = 0,             ///< 1 or 0
  GOISHI_CONTACTS = 1,          ///< places that it touches
  GOISHI_HOLD_GAP = 2,          ///< [m] to the nearest
  GOISHI_FRICTION_SHARE = 3,    ///< of μ; above 1 it slides
  GOISHI_RESISTANCE_SHARE = 4,  ///< of δ and κ; above 1 it rolls or tips
  GOISHI_TILT = 5,              ///< [rad] by which gravity may lean further
  GOISHI_HOLD_SIZE = 6
};

/// Calls  holds.   Sizes  as above, GOISHI_HOLD_SIZE.
GOISHI_API int goishi_holds(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                            const double* ground, size_t ground_size, const double* settings, size_t settings_size,
                            double* hold, size_t hold_size);

// --- A scene

/// What of a scene can be chosen: the settings of a drop for a stone on the board, and behind them these. `scene/settings.hpp`
/// has the reasons.
enum {
  GOISHI_STONES_RESTITUTION = 22,  ///< e of two stones, 0 … 1
  GOISHI_STONES_FRICTION = 23,     ///< μ of two stones, >= 0, infinity allowed
  GOISHI_STEP = 24,                ///< [s] of stones that touch several things, or unset
  GOISHI_SOLVER_TOLERANCE = 25,    ///< of what gravity gives in a step, 0 … 1
  GOISHI_CLEARANCE = 26,           ///< [m] or unset
  GOISHI_IMPACT_SPEED = 27,        ///< [m/s] or unset
  GOISHI_LEAVING_TIME = 28,        ///< [s] or unset
  GOISHI_SCENE_SETTINGS_SIZE = 29
};

/// The library's own.   Result  `settings[GOISHI_SCENE_SETTINGS_SIZE]`.
GOISHI_API int goishi_scene_settings(double* settings, size_t settings_size);

/// A board, and stones on it and over it. One scene is for one thread at a time. What a function does to it does not depend
/// on how its time was cut before, to the last bit. After GOISHI_OUT_OF_MEMORY only free it.
typedef struct goishi_scene goishi_scene;

/// Calls  Scene.   Sizes  GOISHI_BOARD_SIZE, GOISHI_SCENE_SETTINGS_SIZE.
/// Result  `*scene`, to be given to `goishi_scene_free` in the end.
GOISHI_API int goishi_scene_create(const double* board, size_t board_size, const double* settings, size_t settings_size,
                                   goishi_scene** scene);

/// Another one in the same state, which goes on as this one does, bit for bit.
GOISHI_API int goishi_scene_copy(const goishi_scene* scene, goishi_scene** copy);

/// Null is allowed.
GOISHI_API void goishi_scene_free(goishi_scene* scene);

/// Another stone, which may touch what is there, and overlaps nothing.
/// Calls  Scene::add.   Result  `*id`, by which it is called: no other ever gets the same.
GOISHI_API int goishi_scene_add(goishi_scene* scene, const double* stone, size_t stone_size, const double* state,
                                size_t state_size, size_t* id);

GOISHI_API int goishi_scene_remove(goishi_scene* scene, size_t id);

/// Goes on for a time dt > 0, up to a time that is not before the present, or, for no longer than a horizon > 0, until all
/// stones rest: then no stone of GOISHI_SCENE_MOVING is left. All are finite   [s]. The work of a call is bounded: where it is used
/// up, the scene's time is before what was asked for, and the next call goes on from there.
/// Calls  Scene::advance, advance_to, run_until_rest.
GOISHI_API int goishi_scene_advance(goishi_scene* scene, double dt);
GOISHI_API int goishi_scene_advance_to(goishi_scene* scene, double time);
GOISHI_API int goishi_scene_run_until_rest(goishi_scene* scene, double horizon);

/// An impulse [N s] at a point [m], both in W, on a stone that no hand holds.   Calls  Scene::apply_impulse.
GOISHI_API int goishi_scene_push(goishi_scene* scene, size_t id, const double* point, size_t point_size,
                                 const double* impulse, size_t impulse_size);

/// A hand takes a stone: it moves with a velocity [m/s] and an angular velocity [rad/s], both in W, for a time [s], whatever it
/// meets, and then stands still until it is told otherwise or let go.
/// Calls  Scene::hold.   Domain  duration > 0; the way does not lead into board or floor.
GOISHI_API int goishi_scene_hold(goishi_scene* scene, size_t id, const double* velocity, size_t velocity_size,
                                 const double* spin, size_t spin_size, double duration);

/// Lets it go, with the velocities that it has.   Calls  Scene::release.   Domain  a stone that is held.
GOISHI_API int goishi_scene_release(goishi_scene* scene, size_t id);

/// Other settings from now on, gravity among them; what rests wakes if they move it.   Calls  Scene::change.
GOISHI_API int goishi_scene_change(goishi_scene* scene, const double* settings, size_t settings_size);

/// Where a scene is, and what it cost.
enum {
  GOISHI_SCENE_TIME = 0,       ///< [s]
  GOISHI_SCENE_STONES = 1,     ///< that there are
  GOISHI_SCENE_MOVING = 2,     ///< of them, those that do not rest: what a hand holds among them
  GOISHI_SCENE_ENERGY = 3,     ///< [J] of all, that of position zero at the origin of W
  GOISHI_SCENE_STRETCHES = 4,  ///< and what was computed, as SceneCounters has it
  GOISHI_SCENE_LOOKS = 5,
  GOISHI_SCENE_SEPARATIONS = 6,
  GOISHI_SCENE_PAIR_IMPACTS = 7,
  GOISHI_SCENE_JOINS = 8,
  GOISHI_SCENE_STEPS = 9,
  GOISHI_SCENE_STONE_STEPS = 10,
  GOISHI_SCENE_CUT_STEPS = 11,
  GOISHI_SCENE_RETRIES = 12,
  GOISHI_SCENE_SOLVES = 13,
  GOISHI_SCENE_SWEEPS = 14,
  GOISHI_SCENE_UPDATES = 15,
  GOISHI_SCENE_UNSOLVED = 16,
  GOISHI_SCENE_REST_TRIALS = 17,
  GOISHI_SCENE_SIZE = 18
};

GOISHI_API int goishi_scene_info(const goishi_scene* scene, double* info, size_t info_size);

/// How a stone of a scene goes on.
enum {
  GOISHI_MODE_FLIGHT = 0,
  GOISHI_MODE_CONTACT = 1,  ///< alone on the board
  GOISHI_MODE_CLUSTER = 2,  ///< with others
  GOISHI_MODE_REST = 3,
  GOISHI_MODE_HELD = 4  ///< by a hand
};

enum {
  GOISHI_SCENE_STONE_ID = 0,
  GOISHI_SCENE_STONE_MODE = 1,    ///< GOISHI_MODE_FLIGHT …
  GOISHI_SCENE_STONE_WORK = 2,    ///< [J] what hands have done to other stones through it
  GOISHI_SCENE_STONE_MOTION = 3,  ///< the present motion
  GOISHI_SCENE_STONE_SIZE = 20
};

/// The stones in the order in which they were added, from the one with the place `first` on, counted from 0.
/// Calls   Scene::state, mode, work.
/// Result  `rows`, as many as it has room for, its size a multiple of GOISHI_SCENE_STONE_SIZE; so many there must be.
GOISHI_API int goishi_scene_stones(const goishi_scene* scene, size_t first, double* rows, size_t rows_size);

/// What touches, and how it pushes.
enum {
  GOISHI_SCENE_CONTACT_STONE = 0,   ///< id
  GOISHI_SCENE_CONTACT_OTHER = 1,   ///< id, or −1: the board or the floor
  GOISHI_SCENE_CONTACT_POINT = 2,   ///< [m] in W
  GOISHI_SCENE_CONTACT_NORMAL = 5,  ///< unit, out of the other towards the stone
  GOISHI_SCENE_CONTACT_FORCE = 8,   ///< [N] on the stone, the mean of a step or a stretch; NaN where it is not known
  GOISHI_SCENE_CONTACT_SIZE = 11
};

/// Calls   Scene::contacts.
/// Result  `*count`, how many there are; `rows`, the first of them, as many as there are and it has room for, its size a
///         multiple of GOISHI_SCENE_CONTACT_SIZE. The others are as they were.
GOISHI_API int goishi_scene_contacts(const goishi_scene* scene, double* rows, size_t rows_size, size_t* count);

#ifdef __cplusplus
}  // extern "C"
#endif

#endif
