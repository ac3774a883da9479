#include "hawser/solve/statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/system/imbalance.hpp"
#include "hawser/system/line_candidates.hpp"

namespace hawser {
namespace {

constexpr double kNear = 1e-2;  // residual over its scale below which the exact tangent is tried
constexpr double kArmijo = 1e-4;
constexpr double kSoft = 300, kStiffening = 30;  // axial stiffness over load at the start, and a stage on
constexpr int kMostAugmentations = 100;
constexpr int kHalvings = 30, kMaxEscapes = 3, kPolish = 4;
constexpr int kMostCut = 100;  // steps of a descent that lines in their way may cut short

class Search {
 public:
  Search(System& system, const StaticsSettings& settings, State& state)
      : system_(system), settings_(settings), state_(state), trial_(state) {
    for (const Element& e : system.mesh().mesh->elements) length_ = std::max(length_, e.length);
    build();
    prepare();
  }

  // again: from an equilibrium in which little has changed.
  StaticsReport run(bool again = false) {
    StaticsReport report;
    if (!again) approach(report);
    for (;;) {
      descend(report, settings_.tolerance);
      system_.tangent(state_.view(0), {}, zero_, false, J_.get());
      report.negative_eigenvalues = negative_eigenvalues(J_.get());
      // Friction's tangent is unsymmetric: the inertia of its symmetric part says nothing.
      if (settings_.near || report.negative_eigenvalues <= 0 || report.escapes == kMaxEscapes) break;
      ++report.escapes;
      leave(report.escapes);
    }
    polish(report);
    return report;
  }

 private:
  // What depends on ghosts and on the matrix's pattern.
  void build() {
    u_ = system_.create_vector();
    check(VecDuplicate(u_.get(), r_.out()));
    J_ = system_.create_matrix();
    check(KSPCreate(system_.comm(), ksp_.out()));
    configure_linear_solver(ksp_.get(), system_, "statics_");
    zero_.assign(3 * static_cast<size_t>(system_.mesh().blocks()), 0);
  }
  // True: other pairs of lines may touch, so forces are not what they were.
  bool prepare() {
    const Coupled c = system_.couple(state_.view(0), 0);
    if (c == Coupled::anew) {
      build();
      system_.spread(state_);
      trial_ = state_;
    }
    system_.prepare(state_.view(0), 0);
    return c != Coupled::as_before;
  }
  double sum(double x) const {
    MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, system_.comm());
    return x;
  }
  double potential(const State& s) const {
    const Energy e = system_.energy(s.view(0));
    return sum(e.strain + e.potential);
  }
  // Close enough for the exact tangent. Not against the internal forces: a straight line, longer than its
  // span and compressed, is in balance but for its weight.
  bool near(const ResidualNorms& n) const {
    const double load =
        system_.dead_load() / std::sqrt(static_cast<double>(system_.mesh().mesh->nodes.size()));
    return load > 0 ? n.force < kNear * load && n.moment < kNear * std::max(n.moment_scale, load * length_)
                    : n.relative() < kNear;
  }

  // Where the axial stiffness is far above the forces, equilibrium is found with a soft line first.
  void approach(StaticsReport& report) {
    system_.residual(state_.view(0), r_.get());
    const ResidualNorms norms = system_.norms(r_.get());
    const double stiff = system_.axial_stiffness(), load = system_.dead_load();
    if (load == 0 || near(norms)) return;
    for (double soft = kSoft * load; soft < stiff; soft *= kStiffening) {
      system_.soften(soft / stiff);
      descend(report, 1e-4);
    }
    system_.soften(1);
  }
  void descend(StaticsReport& report, double tolerance) {
    system_.residual(state_.view(0), r_.get());
    ResidualNorms norms = system_.norms(r_.get());
    double energy = 0, shift = 1e-3;
    int cut = 0;
    for (int it = 0;; ++it, ++report.iterations) {
      if (prepare()) {  // contact candidates move with the line
        system_.residual(state_.view(0), r_.get());
        norms = system_.norms(r_.get());
      }
      report.norms = norms;
      energy = potential(state_);  // and so does what moments are measured from
      if (norms.small(tolerance)) return;
      if (it >= settings_.max_iterations) throw SolveError(failure(norms, "too many iterations"));
      const bool close = near(norms);
      const double slope = direction(close, close && shift < 1e-5 ? 0 : shift, norms);
      double factor = limit();
      const bool full = factor == 1;
      bool taken = false, blocked = false;
      int halvings = 0;
      for (; halvings < kHalvings && !taken; ++halvings, factor *= taken ? 1 : 0.5) {
        step(factor);
        if (!clear()) {
          blocked = true;
          continue;
        }
        const double e = potential(trial_);
        system_.residual(trial_.view(0), r_.get());
        const ResidualNorms n = system_.norms(r_.get());
        if (!std::isfinite(e) || !std::isfinite(n.force)) continue;
        const bool flat = std::abs(e - energy) <= 1e-10 * std::abs(energy);
        const bool down = slope < 0 && e <= energy + kArmijo * factor * slope;
        if (down || ((flat || close) && n.relative() < norms.relative()) || n.small(tolerance)) {
          taken = true;
          std::swap(state_.x, trial_.x), std::swap(state_.q, trial_.q);
          norms = n, energy = e;
        }
      }
      // Cut short again and again by lines that would pass through each other: they come ever nearer, and
      // there is no way on.
      cut += blocked;
      if ((!taken && shift > 1e6) || cut > kMostCut) {
        system_.residual(state_.view(0), r_.get());
        if (norms.small(100 * tolerance)) return;  // round-off of very stiff lines
        throw SolveError(failure(norms, blocked ? "lines would pass through each other" : "no descent"));
      }
      shift = std::clamp(taken && halvings <= 1 && (full || close) ? 0.2 * shift
                         : taken && halvings <= 1                  ? shift
                                                                   : 4 * shift,
                         1e-9, 1e7);
      if (!taken) shift *= 10;
    }
  }

  // On to round-off: what the tolerance leaves depends on the iterations taken, these on rounding and so on
  // the number of ranks, and a soft line beside stiff ones shows it.
  void polish(StaticsReport& report) {
    for (int i = 0; i < kPolish; ++i) {
      direction(true, 0, report.norms);
      if (limit() < 1) break;
      step(1);
      if (!clear()) break;
      system_.residual(trial_.view(0), r_.get());
      const ResidualNorms n = system_.norms(r_.get());
      if (!(n.relative() < 0.5 * report.norms.relative())) break;
      std::swap(state_.x, trial_.x), std::swap(state_.q, trial_.q);
      report.norms = n;
      ++report.iterations;
    }
    system_.residual(state_.view(0), r_.get());  // the reactions are those of the state
  }

  // Newton direction into local_; returns its slope on the energy.
  double direction(bool exact, double shift, const ResidualNorms& norms) {
    Weights w;
    // A tension's worth of stiffness over an element for a unit of shift.
    const double unit = norms.force_scale / std::sqrt(static_cast<double>(zero_.size())) / length_;
    w.shift_position = shift * unit;
    w.shift_rotation = shift * unit * length_ * length_;
    system_.residual(state_.view(0), r_.get());
    system_.tangent(state_.view(0), w, zero_, !exact, J_.get());
    check(KSPSetOperators(ksp_.get(), J_.get(), J_.get()));
    check(KSPSolve(ksp_.get(), r_.get(), u_.get()));
    check(VecScale(u_.get(), -1));
    PetscScalar slope = 0;
    check(VecDot(u_.get(), r_.get(), &slope));
    if (exact && !(slope < 0)) return direction(false, std::max(shift, 1e-6), norms);
    system_.gather(u_.get(), local_);
    return slope;
  }

  // Longest fraction of the direction that keeps increments within what the linearisation is good for.
  double limit() const {
    double x = 0, turn = 0;
    const LocalMesh& m = system_.mesh();
    for (int n = 0; n < m.owned; ++n) {
      const double* p = local_.data() + 3 * m.block[static_cast<size_t>(n)];
      x = std::max(x, Eigen::Map<const Vec3>(p).norm());
      if (m.rotates(n)) turn = std::max(turn, Eigen::Map<const Vec3>(p + 3).norm());
    }
    double longest = 0;
    for (const LineSpan& l : m.mesh->lines) longest = std::max(longest, l.length);
    double worst = std::max(x / (0.05 * longest), turn / 0.5);
    MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE, MPI_MAX, system_.comm());
    return worst > 1 ? 1 / worst : 1;
  }

  void step(double factor) {
    std::vector<double> u(local_);
    for (double& x : u) x *= factor;
    retract(system_.mesh(), state_, u.data(), trial_);
  }

  // Whether no line goes through another on the straight way from the state to the trial. Where the
  // candidates were not chosen for that way they are chosen anew.
  bool clear() {
    if (system_.covers(trial_.view(0))) return true;
    if (!system_.outdated()) return false;
    const LocalMesh& m = system_.mesh();
    State way = state_;
    for (size_t n = 0; n < way.x.size(); ++n) {
      way.v[n] = trial_.x[n] - state_.x[n];
      if (m.rotates(static_cast<int>(n))) way.w[n] = log_so3(state_.q[n].conjugate() * trial_.q[n]);
    }
    // So that the way foreseen ends at the trial.
    if (system_.couple(way.view(0), 1 / CandidateSettings{}.steps) == Coupled::anew) {
      std::vector<double> u(local_.begin(), local_.begin() + 3 * m.owned_blocks);
      build();
      system_.spread(state_), system_.spread(trial_);
      if (!u.empty()) {
        PetscScalar* p = nullptr;
        check(VecGetArray(u_.get(), &p));
        std::copy(u.begin(), u.end(), p);
        check(VecRestoreArray(u_.get(), &p));
      }
      system_.gather(u_.get(), local_);
    }
    system_.prepare(state_.view(0), 0);
    return system_.covers(trial_.view(0));
  }

  // Push off a saddle: a fixed, rank-independent displacement field without symmetry; less of it where lines
  // would pass through each other.
  void leave(int attempt) {
    double share = 1;
    for (int k = 0; k < kHalvings; ++k, share *= 0.5) {
      trial_ = state_;
      push(attempt, share, trial_);
      if (!clear()) continue;
      std::swap(state_.x, trial_.x), std::swap(state_.q, trial_.q);
      return;
    }
  }
  void push(int attempt, double share, State& s) const {
    const LocalMesh& m = system_.mesh();
    for (int n = 0; n < m.nodes(); ++n) {
      const size_t i = static_cast<size_t>(n);
      const Node& node = m.mesh->nodes[static_cast<size_t>(m.global[i])];
      if (node.body >= 0) continue;
      const double L = m.mesh->lines[static_cast<size_t>(node.line)].length, z = node.arc / L;
      const double bump =
          share * 0.01 * attempt * L * std::sin(M_PI * z) * (1 + 0.3 * std::sin(9 * z + attempt));
      Vec3 d = bump * Vec3(0.31, 0.52, -0.79);
      const unsigned char held = system_.supports().held()[static_cast<size_t>(m.block[i])];
      for (int c = 0; c < 3; ++c)
        if (held >> c & 1) d[c] = 0;
      s.x[i] += d;
      // A node turned over against its neighbours is a saddle of rotations.
      const size_t b = static_cast<size_t>(m.block[i]);
      if (!m.rotates(n) || system_.supports().held()[b + 1]) continue;
      const double angle = share * 0.05 * attempt;
      s.q[i] = s.q[i] * exp_so3(angle * Vec3(0.1 * std::sin(5 * z), std::sin(37 * z + 1), std::cos(41 * z)));
    }
  }

  std::string failure(const ResidualNorms& n, const char* why) const {
    return fmt::format("statics: {}: {}", why, imbalance(system_, r_.get(), n));
  }

  System& system_;
  const StaticsSettings& settings_;
  State& state_;
  State trial_;
  VecHandle u_, r_;
  MatHandle J_;
  KspHandle ksp_;
  std::vector<double> local_, zero_;
  double length_ = 0;
};

}  // namespace

StaticsReport solve_statics(System& system, const StaticsSettings& settings, State& state) {
  const size_t n = state.x.size();
  for (auto* a : {&state.v, &state.a, &state.w, &state.alpha}) a->assign(n, Vec3::Zero());
  StaticsReport report = Search(system, settings, state).run(settings.near);
  for (int round = 0; settings.augment && system.augment(state.view(0)); ++round) {
    if (round == kMostAugmentations)
      throw SolveError(
          "statics: the multipliers of contact do not settle; is contact.augmented.penetration "
          "within reach?");
    const StaticsReport more = Search(system, settings, state).run(true);
    report.iterations += more.iterations, report.escapes += more.escapes;
    report.negative_eigenvalues = more.negative_eigenvalues, report.norms = more.norms;
  }
  system.commit(state.view(0));
  return report;
}

}  // namespace hawser
