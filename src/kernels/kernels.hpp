#pragma once

#include <cstdint>

/// The inner loops of the mechanics, compiled for several instruction sets and chosen when the
/// program runs. The files of the kernels include no code but their own, so that no inline function
/// of a library exists in a version that the processor may not have.
namespace impact {

/// Points are treated in slices of this many.
constexpr int kSlice = 8;

/// As many as hold so many points.
constexpr std::int64_t whole_slices(std::int64_t points) { return (points + kSlice - 1) / kSlice; }

/// Sums over points are taken over parts of so many, and then over the parts.
constexpr int kPart = 2048;

/// Smallest |r|² (R²), added to all: the places of a slice that hold no bond are bonds from a point
/// to itself, of no length, and exert no force.
constexpr double kLeastLengthSquared = 1e-300;

/// Every bond, twice: in the list of each of its ends. Sliced lists (SELL-8 of M. Kreutzer et al.,
/// SIAM J. Sci. Comput. 36 (2014) C401): a slice has as many rows as its point with the most bonds,
/// a row has kSlice places, one a point.
struct BondRows {
  const std::int32_t* begin;     ///< the rows of slice s: begin[s] … begin[s + 1] − 1
  const std::int32_t* end;       ///< the other end of each bond: where its pair begins, 2 × point
  const double* natural_length;  ///< R
};

/// What a force evaluation reads and writes. Pairs are (x, y) of a point side by side, so that a
/// point far away costs one access; their number is a multiple of kSlice.
struct BondEvaluation {
  BondRows rows;
  double k_a;                    ///< M c²/R²
  double k_b;                    ///< M c²/R⁴
  double eta;                    ///< M c/R
  std::int64_t points;           ///< distance of y from x in `force`
  const double* position_pairs;  ///< R
  const double* velocity_pairs;  ///< c; not read without damping
  double* force;                 ///< x of all points, y of all points, M c²/R; overwritten
};

/// Evaluates the points of the slices first … end − 1. Returns Σ |v_i − v_j|² (c²) over all entries
/// of their lists; without damping 0.
using BondKernel = double (*)(const BondEvaluation&, std::int64_t first, std::int64_t end);

/// Sums over bonds of the second and the fourth power of their elongations, R² and R⁴.
struct Elongations {
  double squared = 0.0;
  double to_the_fourth = 0.0;
};

/// Consecutive columns of a Cholesky factor, of about the same structure.
struct Supernode {
  std::int64_t first;  ///< column
  std::int64_t width;
  std::int64_t quads;  ///< rows of its panel/kQuad, the last ones filled up with zeros
};

/// Rows of a panel are stored in groups of this many.
constexpr int kQuad = 4;

/// A Cholesky factor, see PanelCholesky.
struct Panels {
  const Supernode* nodes;
  std::int64_t count;
  const std::int32_t* rows;  ///< of each panel; where there is none, the number of columns
  const double* values;      ///< of each panel: quad after quad, of each its columns
};

/// A dense matrix, column after column; rows: a multiple of kSlice.
struct DenseMatrix {
  const double* values;
  std::int64_t rows;
  std::int64_t columns;
};

/// The force a V₀ exp(−a y) of a potential wall; none above the reach.
struct WallLaw {
  double a;              ///< 1/R
  double force_at_zero;  ///< a V₀, M c²/R
  double reach;          ///< R
};

/// What a wall exerts, in M c²/R.
struct WallForce {
  double total;    ///< along y
  double largest;  ///< on one point
};

/// Runs of one lattice advance side by side in so many lanes. Their arrays have, for each point, x
/// of all lanes and then y of all lanes; their constants have a number a lane.
constexpr int kLanes = 8;

/// Every bond once, in the list of its first end.
struct BondList {
  const std::int32_t* begin;     ///< the bonds of point i: begin[i] … begin[i + 1] − 1
  const std::int32_t* end;       ///< the other end of each bond: point index
  const double* natural_length;  ///< R
};

/// As BondEvaluation, for kLanes runs.
struct LaneEvaluation {
  BondList bonds;
  const double* k_a;
  const double* k_b;
  const double* eta;
  const double* position;
  const double* velocity;           ///< not read without damping
  double* force;                    ///< overwritten
  double* relative_speeds_squared;  ///< overwritten: Σ |v_i − v_j|² of each point, in each lane;
                                    ///< not needed without damping
  double* relative_speed_squared;  ///< overwritten: its sum over all points, in each lane
};

using LaneBondKernel = void (*)(const LaneEvaluation&, std::int64_t points);

/// As WallLaw, for kLanes runs.
struct LaneWallLaw {
  const double* a;
  const double* force_at_zero;
  const double* reach;
};

/// The loops over all points of kLanes runs. A `size` counts coordinates of one run.
struct LaneKernels {
  LaneBondKernel linear;
  LaneBondKernel linear_damped;
  LaneBondKernel cubic;
  LaneBondKernel cubic_damped;
  /// v += factor · f.
  void (*kick)(const double* factor, const double* f, double* v, std::int64_t size);
  /// moved = x + factor · f.
  void (*displace)(const double* factor, const double* f, const double* x, double* moved,
                   std::int64_t size);
  /// The same and, with the new v, x += time · v.
  void (*kick_and_drift)(const double* factor, const double* f, const double* time, double* v,
                         double* x, std::int64_t size);
  /// Σ a b of each lane.
  void (*dot)(const double* a, const double* b, std::int64_t points, double* result);
  /// Adds Σ v² of each lane to `squared`. Its lowest vertical velocity, where that is below 0, else
  /// 0; and its highest, where that is above 0, else 0.
  void (*speeds)(const double* velocity, std::int64_t points, double* squared, double* lowest,
                 double* highest);
  /// Adds the wall's forces; `total` and `largest` of each lane are those of WallForce.
  void (*potential_wall)(const LaneWallLaw& law, const double* position, std::int64_t points,
                         double* force, double* total, double* largest);
  /// As Kernels::substitute, with all lanes of each row; `scratch` has 2 kQuad places a quad.
  void (*substitute)(const Panels& panels, double* points, double* scratch);
};

struct Kernels {
  const char* name;
  BondKernel linear;
  BondKernel linear_damped;
  BondKernel cubic;
  BondKernel cubic_damped;
  BondKernel damping;  ///< without elastic forces; positions are not read
  /// Over all entries of the lists of the slices first … end − 1.
  Elongations (*elongations)(const BondRows& rows, const double* position_pairs, std::int64_t first,
                             std::int64_t end);
  /// Puts `size` coordinates x and y side by side.
  void (*pair_up)(const double* x, const double* y, std::int64_t size, double* pairs);
  /// v += factor · f, for `size` numbers.
  void (*kick)(double factor, const double* f, double* v, std::int64_t size);
  /// moved = x + factor · f.
  void (*displace)(double factor, const double* f, const double* x, double* moved,
                   std::int64_t size);
  /// The same and, with the new v, x += time · v.
  void (*kick_and_drift)(double factor, const double* f, double time, double* v, double* x,
                         std::int64_t size);
  /// Turns `size` vectors (x, y) counter-clockwise by an angle.
  void (*turn)(double cosine, double sine, double* x, double* y, std::int64_t size);
  /// Σ a b.
  double (*dot)(const double* a, const double* b, std::int64_t size);
  /// The least of `size` numbers where that is below 0, else 0.
  double (*least)(const double* numbers, std::int64_t size);
  /// Adds the wall's forces on `size` points at these heights to their fy.
  WallForce (*potential_wall)(const WallLaw& law, const double* heights, std::int64_t size,
                              double* fy);
  /// Both substitutions. `pairs` are x and y of each row and of one more, 0; they become the
  /// solution. `scratch` has 2 kQuad places a quad of the largest panel.
  void (*substitute)(const Panels& panels, double* pairs, double* scratch);
  /// y = A x, of so many columns x.
  void (*multiply)(const DenseMatrix& matrix, const double* x, std::int64_t sides, double* y);
  LaneKernels lanes;
};

extern const Kernels kPlainKernels;
#ifdef __x86_64__
extern const Kernels kAvx2Kernels;    ///< AVX2, FMA
extern const Kernels kAvx512Kernels;  ///< AVX-512 F, DQ, VL
#endif

/// Whether this processor has the instructions.
bool can_run(const Kernels& kernels);

/// The best of those that this processor can run, unless others were chosen.
const Kernels& kernels();

/// Chooses kernels, which the processor must be able to run, for the rest of the program: for
/// comparisons of instruction sets, whose results differ by rounding. Before anything else is done.
void choose_kernels(const Kernels& kernels);

}  // namespace impact
