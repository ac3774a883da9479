// Stiffness and mass as matrices of the free components, and their lowest eigenpairs by shift and invert.
// Mass and damping are those at the frequency of each mode.
#include "hawser/solve/natural_modes.hpp"

#include <petscmat.h>
#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hawser/advice/modes.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/handle.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/kernels/frame_point.hpp"
#include "hawser/solve/stability.hpp"
#include "hawser/system/depends_on_frequency.hpp"
#include "small_motions.hpp"

namespace hawser {
namespace {

// Eigenvalues are searched for around this one, minus omega² of a period of 1000 s. K - target M is regular
// there even if the system can move freely.
constexpr double kTarget = -4e-5;  // rad²/s²
constexpr double kTolerance = 1e-10;
constexpr int kMaxEigenIterations = 2000;
constexpr int kMore = 4;          // modes searched for beyond the requested number
constexpr long kMaxMultiple = 8;  // largest multiple of that number
constexpr double kGap = 1e-6;     // relative difference of eigenvalues below which they count as repeated
// Ratio of translations to rotations times the size of the system, below which the translations are rounding.
constexpr double kInPlace = 1e-7;
constexpr double kMinSize = 1e-3;  // m, of a model, which may be a single body

class Slepc {
 public:
  Slepc() { check(SlepcInitializeNoArguments()); }  // PETSc has been initialised before and remains so
  ~Slepc() { SlepcFinalize(); }
  Slepc(const Slepc&) = delete;
  Slepc& operator=(const Slepc&) = delete;
};

using Solver = Handle<EPS, EPSDestroy>;

long free_components(const System& system) {
  long free = 0;
  for (int b = 0; b < system.mesh().owned_blocks; ++b)
    for (int c = 0; c < 3; ++c) free += !(system.tied_nodes().held()[b] >> c & 1);
  MPI_Allreduce(MPI_IN_PLACE, &free, 1, MPI_LONG, MPI_SUM, system.comm());
  return free;
}

// Diagonal of the bounding box of all nodes, m.
double size_of(const System& system, const Kinematics& state) {
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  for (size_t n = 0; n < static_cast<size_t>(system.mesh().owned); ++n) {
    low = low.cwiseMin(state.x[n]);
    high = high.cwiseMax(state.x[n]);
  }
  all_reduce(system.comm(), MPI_MIN, low);
  all_reduce(system.comm(), MPI_MAX, high);
  return (high - low).norm();
}

// Motion of the nodes from the unknowns u. A tied node moves with its frame.
void move_nodes(const System& system, const Kinematics& state, const std::vector<double>& u,
                NaturalMode& mode) {
  const LocalMesh& mesh = system.mesh();
  const auto block = [&](int b) { return Vec3(u.data() + 3 * b); };
  const size_t nodes = mesh.block.size();
  mode.shape.assign(nodes, Vec3::Zero());
  mode.rotation.assign(nodes, Vec3::Zero());
  for (size_t n = 0; n < nodes; ++n) {
    mode.shape[n] = block(mesh.block[n]);
    if (mesh.rotates(static_cast<int>(n))) mode.rotation[n] = state.q[n] * block(mesh.block[n] + 1);
  }
  for (const int i : system.tied_nodes().to_frames()) {
    const TiedNode& s = system.tied_nodes().nodes()[i];
    const int frame = mesh.block[s.frame];
    const FramePoint point{s.at, state.q[s.frame].toRotationMatrix()};
    mode.shape[s.node] = block(frame) + point.by_turn() * block(frame + 1);
  }
  double largest[2] = {0, 0};
  for (size_t n = 0; n < static_cast<size_t>(mesh.owned); ++n) {
    largest[0] = std::max(largest[0], mode.shape[n].norm());
    largest[1] = std::max(largest[1], mode.rotation[n].norm());
  }
  all_reduce(system.comm(), MPI_MAX, largest);
  const bool in_place = largest[0] < kInPlace * largest[1] * std::max(size_of(system, state), kMinSize);
  for (size_t n = 0; n < nodes; ++n) {
    mode.shape[n] = in_place ? Vec3(Vec3::Zero()) : Vec3(mode.shape[n] / largest[0]);
    mode.rotation[n] /= in_place ? largest[1] : largest[0];
  }
}

struct Eigenpair {
  double squared = 0;  // rad²/s²
  VecHandle vector;
  double damping_ratio = 0;
};

void sort(std::vector<Eigenpair>& pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Eigenpair& a, const Eigenpair& b) { return a.squared < b.squared; });
}

// K - by M.
MatHandle shifted(Mat K, Mat M, double by) {
  MatHandle out;
  check(MatDuplicate(K, MAT_COPY_VALUES, out.out()));
  check(MatAXPY(out.get(), -by, M, DIFFERENT_NONZERO_PATTERN));
  return out;
}

// Number of eigenvalues of K - lambda M below `squared`, by Sylvester's law of inertia (Parlett 1980, section
// 3-3); -1: not known.
int eigenvalues_below(Mat K, Mat M, double squared) { return negative_pivots(shifted(K, M, squared).get()); }

// The converged modes among the `count` ones nearest to the target, lowest first; if all are above it
// (`stable`), found as the largest theta of M x = theta (K - target M) x. Then the matrix on the right is
// definite, but M need not be: added mass may be negative at some frequencies. Of complex eigenvalues of an
// unsymmetric K, which come in pairs, the real part; the two vectors are real and imaginary part.
std::vector<Eigenpair> nearest_modes(const System& system, Mat K, Mat M, int count, bool is_symmetric,
                                     bool stable) {
  Solver solver;
  check(EPSCreate(system.comm(), solver.out()));
  EPS eps = solver.get();
  check(EPSSetOptionsPrefix(eps, "modes_"));
  const MatHandle above_target = stable ? shifted(K, M, kTarget) : MatHandle();
  check(EPSSetOperators(eps, stable ? M : K, stable ? above_target.get() : M));
  check(EPSSetProblemType(eps, is_symmetric ? EPS_GHEP : EPS_GNHEP));
  check(EPSSetDimensions(eps, count, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(eps, kTolerance, kMaxEigenIterations));
  check(EPSSetTarget(eps, kTarget));
  check(EPSSetWhichEigenpairs(eps, stable ? EPS_LARGEST_REAL : EPS_TARGET_MAGNITUDE));
  ST st = nullptr;
  check(EPSGetST(eps, &st));
  check(STSetType(st, stable ? STSHIFT : STSINVERT));
  KSP ksp = nullptr;
  check(STGetKSP(st, &ksp));
  solve_directly(ksp);
  check(EPSSetFromOptions(eps));
  check(EPSSolve(eps));
  PetscInt converged = 0;
  check(EPSGetConverged(eps, &converged));
  std::vector<Eigenpair> out;
  for (PetscInt i = 0; i < converged; ++i) {
    Eigenpair pair;
    pair.vector = system.create_vector();
    double imaginary = 0;
    VecHandle other = system.create_vector();
    check(EPSGetEigenpair(eps, i, &pair.squared, &imaginary, pair.vector.get(), other.get()));
    if (imaginary < 0) std::swap(pair.vector, other);
    if (stable && !(pair.squared > 0)) break;
    if (stable) pair.squared = kTarget + 1 / pair.squared;
    out.push_back(std::move(pair));
  }
  sort(out);
  return out;
}

// u . A u; `work` is overwritten.
double form(Mat A, Vec u, Vec work) {
  double out = 0;
  check(MatMult(A, u, work));
  check(VecDot(u, work, &out));
  return out;
}

// Number of modes up to the first gap above the `count` lowest ones, if these are all between it and the
// target, below which are `below` ones; otherwise 0. Not judged if `below` is negative.
size_t complete(Mat K, Mat M, const std::vector<Eigenpair>& modes, size_t count, int below) {
  size_t last = count - 1;
  const auto gap = [&](size_t i) { return modes[i + 1].squared - modes[i].squared; };
  while (last + 1 < modes.size() && !(gap(last) > kGap * std::abs(modes[last + 1].squared))) ++last;
  if (last + 1 >= modes.size()) return 0;
  if (below < 0) return last + 1;
  const double end = modes[last].squared + 0.5 * gap(last);
  const auto count_below = std::count_if(
      modes.begin(), modes.end(), [&](const Eigenpair& m) { return m.squared > kTarget && m.squared < end; });
  const int above = eigenvalues_below(K, M, end);
  return above < 0 || count_below >= above - below ? last + 1 : 0;
}

// The `count` lowest modes and those of the same frequency as the last; fewer if no more are found. The
// inertia counts eigenvalues of symmetric matrices only.
std::vector<Eigenpair> lowest_modes(const System& system, Mat K, Mat M, size_t count, bool is_symmetric) {
  const long requested = static_cast<long>(count);
  const long free = free_components(system);
  const int below = is_symmetric ? eigenvalues_below(K, M, kTarget) : -1;
  // A Krylov space contains the directions of a repeated eigenvalue (of equal lines) only by rounding, so
  // some may be missing at first.
  for (long trial_count = std::min(requested + kMore, free);; trial_count = std::min(2 * trial_count, free)) {
    std::vector<Eigenpair> modes =
        nearest_modes(system, K, M, static_cast<int>(trial_count), is_symmetric, below == 0);
    if (trial_count == free || std::ssize(modes) < trial_count) return modes;
    if (const size_t all = complete(K, M, modes, count, below); all > 0) {
      modes.resize(all);
      return modes;
    }
    if (trial_count > kMaxMultiple * (requested + kMore)) throw SolveError(advice::modes_incomplete());
  }
}

size_t first_oscillating(const std::vector<Eigenpair>& modes) {
  const auto oscillates = [](const Eigenpair& m) { return m.squared > kFreeMotion; };
  return static_cast<size_t>(std::find_if(modes.begin(), modes.end(), oscillates) - modes.begin());
}

// Search for the root s [rad²/s²] of mu(s) = s, by secants within a bracket, after some trials by its
// bisection.
class FrequencyRoot {
 public:
  explicit FrequencyRoot(double first) : s_(first) {}
  double trial() const { return s_; }
  // Narrows the bracket by mu at the trial; returns whether the trial is the root.
  bool found(double mu) {
    constexpr double kConverged = 1e-9;  // relative
    change_ = mu - s_;
    (change_ > 0 ? low_ : high_) = s_;
    return std::abs(change_) < kConverged * s_ || high_ - low_ < kConverged * s_;
  }
  // Chooses the next trial after found(). Throws SolveError if there were too many.
  void choose(double mu) {
    constexpr int kSecants = 10, kMaxTrials = 100;
    const double secant = trials_ == 0 ? mu : s_ - change_ * (s_ - before_) / (change_ - change_before_);
    double next = std::min(mu, 2 * s_);
    if (trials_ < kSecants && secant > low_ && secant < high_)
      next = secant;
    else if (high_ < HUGE_VAL)
      next = 0.5 * (low_ + high_);
    before_ = s_;
    change_before_ = change_;
    s_ = next;
    if (++trials_ == kMaxTrials) throw SolveError(advice::modes_incomplete());
  }

 private:
  double s_;
  double change_ = 0;                      // mu - s at the trial
  double before_ = 0, change_before_ = 0;  // at the trial before
  double low_ = 0, high_ = HUGE_VAL;
  int trials_ = 0;  // completed
};

// Changes the modes that oscillate from those with the mass of time integration to those with the mass at
// their own frequency: the k-th of them is at the root s of mu_k(s) = s, where mu_k(s) is the k-th eigenvalue
// with the mass at omega = sqrt(s).
void iterate_frequencies(System& system, const Kinematics& state, Mat K,
                         const std::vector<DependsOnFrequency*>& terms, std::vector<Eigenpair>& modes,
                         bool is_symmetric) {
  const auto set_frequency = [&](std::optional<double> omega) {
    for (DependsOnFrequency* t : terms) t->set_frequency(omega);
  };
  const VecHandle work = system.create_vector();
  const size_t first = first_oscillating(modes);
  for (size_t k = first; k < modes.size();) {
    FrequencyRoot root(modes[k].squared);
    for (bool found = false; !found;) {
      set_frequency(std::sqrt(root.trial()));
      const MatHandle M = mass_at_rest(system, state);
      std::vector<Eigenpair> here = lowest_modes(system, K, M.get(), k + 1, is_symmetric);
      size_t m = first_oscillating(here) + k - first;
      // Where the mass is negative in some direction, there are fewer.
      const double mu = m < here.size() ? here[m].squared : HUGE_VAL;
      found = root.found(mu);
      if (!found) {
        root.choose(mu);
        continue;
      }
      const MatHandle C = damping_at_rest(system, state);
      // Repeated eigenvalues have any vectors of their space, so all of them are taken here.
      for (; k < modes.size() && m < here.size() && here[m].squared <= mu * (1 + kGap); ++k, ++m) {
        Vec u = here[m].vector.get();
        here[m].damping_ratio =
            form(C.get(), u, work.get()) / (2 * std::sqrt(here[m].squared) * form(M.get(), u, work.get()));
        modes[k] = std::move(here[m]);
      }
    }
  }
  set_frequency(std::nullopt);
}

NaturalMode mode_of(const System& system, const Kinematics& state, const Eigenpair& pair) {
  NaturalMode mode;
  mode.squared = pair.squared;
  mode.damping_ratio = pair.damping_ratio;
  std::vector<double> local;
  system.gather_with_ghosts(pair.vector.get(), local);
  move_nodes(system, state, local, mode);
  return mode;
}

}  // namespace

std::vector<NaturalMode> natural_modes(System& system, const Kinematics& state, int count) {
  const Slepc slepc;
  const size_t requested = static_cast<size_t>(std::min<long>(count, free_components(system)));
  if (requested == 0) return {};
  const auto [K, is_symmetric] = stiffness_at_rest(system, state);
  const MatHandle M = mass_at_rest(system, state);
  std::vector<Eigenpair> modes = lowest_modes(system, K.get(), M.get(), requested, is_symmetric);
  if (modes.size() < requested) throw SolveError(advice::fewer_modes_converged(modes.size(), requested));
  modes.resize(requested);
  if (const auto terms = system.with<DependsOnFrequency>(); !terms.empty()) {
    iterate_frequencies(system, state, K.get(), terms, modes, is_symmetric);
    sort(modes);
  }
  std::vector<NaturalMode> out;
  for (const Eigenpair& pair : modes) out.push_back(mode_of(system, state, pair));
  return out;
}

}  // namespace hawser
