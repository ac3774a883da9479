// The class Actions: tied ends, feeders and volumes after an action. A line to be cut consists of two from
// the start (model/cut_lines.cpp); the cut releases their joint.
#include "hawser/run/actions.hpp"

#include <algorithm>

#include "hawser/advice/events.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser::run {

using model::Action;

int Actions::node(const Action& a) const {
  const LineSpan& span = sim_.mesh().lines[sim_.model().line_index(a.line)];
  return span.end_node(a.line_end);
}

bool Actions::held(int node) const {
  return on_any_rank(sim_.system().comm(), std::any_of(tied_.begin(), tied_.end(), [&](const TiedNode& s) {
                       return s.position_mask == 7 && sim_.local().global[s.node] == node;
                     }));
}

RigidPose Actions::pose(const Action& a, const Kinematics& state) const {
  return sim_.bodies().pose(sim_.model().body_index(a.body), state);
}

double Actions::away(const Action& a, const Kinematics& state) const {
  const int n = sim_.local().find(node(a));
  if (!a.at || !sim_.local().owns(n)) return 0;
  return (pose(a, state).to_space(*a.at) - state.x[n]).norm();
}

Actions::Found Actions::act(const Action& a, const Kinematics& state) {
  Found placed;
  const auto refuse = [&](const std::string& why) {
    throw SolveError(advice::cannot_happen(a, state.time, why));
  };
  switch (a.kind) {
    case Action::Kind::release:
      if (!held(node(a))) refuse(advice::nothing_holds());
      break;
    case Action::Kind::attach: {
      if (held(node(a))) refuse(advice::holds_already());
      const LocalMesh& local = sim_.local();
      const int n = local.find(node(a));
      const int body = sim_.model().body_index(a.body);
      std::array<double, 8> packed{};
      if (local.owns(n)) {
        const RigidPose p = pose(a, state);
        Vec3 y = p.rotation.conjugate() * (state.x[n] - p.position);
        if (sim_.model().floats(body)) y -= sim_.model().bodies[body].mass->centre;
        const Quat q = p.rotation.conjugate() * state.q[n];
        packed = {y.x(), y.y(), y.z(), q.w(), q.x(), q.y(), q.z(), away(a, state)};
      }
      all_reduce(sim_.system().comm(), MPI_SUM, packed);
      std::copy_n(packed.begin(), 3, placed.place.begin());
      std::copy_n(packed.begin() + 3, 4, placed.rotation.begin());
      placed.away = packed[7];
      constexpr double kRounding = 1e-6;  // m
      if (a.at && placed.away > a.within + kRounding)
        refuse(advice::too_far_from_place(placed.away, a.within));
      break;
    }
    case Action::Kind::feed:
      for (const Feeder& f : sim_.feeders()->all())
        if (f.line == sim_.model().line_index(a.line) && f.line_end == a.line_end) placed.speed = f.speed;
      break;
    case Action::Kind::friction:
    case Action::Kind::current:
      break;
    case Action::Kind::contact:
      if (const std::string where = sim_.inside(a, state); !where.empty()) refuse(where);
      break;
  }
  repeat(a, placed, state.time);
  return placed;
}

void Actions::repeat(const Action& a, const Found& placed, double time) {
  switch (a.kind) {
    case Action::Kind::release:
      std::erase_if(tied_, [&, n = node(a)](const TiedNode& s) { return sim_.local().global[s.node] == n; });
      break;
    case Action::Kind::attach:
      hold(a, placed);
      break;
    case Action::Kind::feed:
      if (a.paid_out == 0) feed(a, placed.speed, time);  // otherwise the length is in checkpoints
      break;
    case Action::Kind::friction:
      sim_.enable_friction_in_statics(a.enabled);
      break;
    case Action::Kind::current:
      for (InCurrent* t : sim_.system().with<InCurrent>()) t->scale_current(a.factor);
      break;
    case Action::Kind::contact:
      sim_.enable_contact(a);
      break;
  }
}

void Actions::hold(const Action& a, const Found& placed) {
  const int n = sim_.local().find(node(a));
  if (n < 0) return;
  TiedNode s;
  s.node = n;
  s.at = Vec3(placed.place.data());
  const int body = sim_.model().body_index(a.body);
  if (sim_.model().floats(body))
    s.frame = sim_.bodies().local_node(body);
  else
    s.body = body;
  if (a.clamped && sim_.local().rotates(n)) {
    const auto& q = placed.rotation;
    s.rotation_mask = 7;
    s.rotation = Quat(q[0], q[1], q[2], q[3]);
  }
  tied_.push_back(s);
}

void Actions::feed(const Action& a, double speed, double time) {
  for (Feeder& f : sim_.feeders()->all()) {
    if (f.line != sim_.model().line_index(a.line) || f.line_end != a.line_end) continue;
    model::Feed law = a.law;
    law.stock = f.feed.stock;
    if (a.ramp > 0) law.speed = {{time, speed}, {time + a.ramp, a.law.speed.back().second}};
    f.feed = law;
    f.resting = law.has_band();
    if (!law.speed.empty()) {
      f.offset = f.length - model::fed_by(law, time).length;
      f.speed = model::fed_by(law, time).speed;
    }
  }
}

}  // namespace hawser::run
