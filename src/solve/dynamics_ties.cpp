// The class Dynamics: continuation of the motion with other nodes tied, after ends were released or attached
// (docs/theory/events.md).
#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/solve/dynamics.hpp"

namespace hawser {
namespace {

// Time before the event at which velocities are taken, as a fraction of the time, at least of 1 s.
constexpr double kJustBefore = 1e-9;

bool holds(const TiedNodes& tied, int node) {
  return std::any_of(tied.nodes().begin(), tied.nodes().end(),
                     [node](const TiedNode& s) { return s.node == node && s.position_mask == 7; });
}

}  // namespace

void Dynamics::retie(std::vector<TiedNode> nodes) {
  State s = committed_.s;
  const TiedNodes before = system_.tied_nodes();
  // If the velocity of a body jumps at this time, an end that it releases keeps the velocity from before the
  // jump.
  before.rates(s.time - kJustBefore * std::max(1.0, s.time), s);
  system_.tie(std::move(nodes), BodyMotion(before.motion()));
  control_.reset_to_first_step();
  match_tied_velocities(before, s);
  start(s);
}

// Velocities after a plastic impact, in which nodes are newly tied. With the mass matrix M of the free and
// the newly tied nodes, no impulse acts on the free nodes, so M dv = 0 in their rows; the newly tied nodes
// take the velocity of their support.
void Dynamics::match_tied_velocities(const TiedNodes& before, State& s) {
  const LocalMesh& m = system_.mesh();
  State held = s;
  system_.tied_nodes().rates(s.time, held);
  system_.tied_nodes().move_with_frames(held);
  std::vector<int> newly_tied;
  for (const TiedNode& h : system_.tied_nodes().nodes())
    if (h.node < m.owned && h.position_mask == 7 && !holds(before, h.node)) newly_tied.push_back(h.node);
  if (!on_any_rank(system_.comm(), !newly_tied.empty())) return;
  const double h = control_.proposal();
  s.directors.clear();
  s.director_weight = 0;
  s.mean = {};
  committed_.s = s;
  last_step_ = 0;
  prepare(h);
  s = committed_.s;  // the copy has the ghosts that prepare() has created
  VecHandle before_impact;
  check(VecDuplicate(r_.get(), before_impact.out()));
  system_.residual(s.at_start(h), before_impact.get());
  State impacted = s;
  for (const int n : newly_tied) {
    const size_t i = static_cast<size_t>(n);
    impacted.a[i] += held.v[i] - s.v[i];
    if (m.rotates(n)) impacted.alpha[i] += held.w[i] - s.w[i];
  }
  system_.update_ghosts(impacted);
  // Forces are linear in accelerations: this residual is larger by M dv.
  system_.residual(impacted.at_start(h), r_.get());
  check(VecAXPY(r_.get(), -1, before_impact.get()));
  const std::vector<double> zero(3 * static_cast<size_t>(m.blocks()), 0);
  system_.tangent(s.at_start(h), {0, 0, 1}, zero, false, J_.get());
  const std::vector<double> dv = accelerations();
  for (size_t i = 0; i < s.x.size(); ++i) {
    const double* p = dv.data() + 3 * m.block[i];
    s.v[i] += Eigen::Map<const Vec3>(p);
    if (m.rotates(static_cast<int>(i))) s.w[i] += Eigen::Map<const Vec3>(p + 3);
  }
  system_.tied_nodes().rates(s.time, s);
  system_.tied_nodes().move_with_frames(s);
  system_.update_ghosts(s);
}

}  // namespace hawser
