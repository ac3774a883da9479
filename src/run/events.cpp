// The class Events: selection of due events, stages of statics, and limits of pay-out. The effects of events
// are in actions.cpp.
#include "hawser/run/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/advice/events.hpp"
#include "hawser/advice/run.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/record/output_times.hpp"
#include "hawser/run/feeder_nodes.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::run {
namespace {

using model::Action;
using model::Cause;

// Tolerance beyond a condition: relative for a tension, m for a length.
constexpr double kNear = 1e-3;

double tolerance(const Cause& c) {
  return c.kind == Cause::Kind::tension ? kNear * std::max(std::abs(c.limit), 1.0) : kNear;
}

}  // namespace

bool Events::waits_for_condition(const ScheduledEvent& scheduled) {
  const Cause::Kind kind = scheduled.event.cause.kind;
  return kind != Cause::Kind::time && kind != Cause::Kind::after && kind != Cause::Kind::stage;
}

Events::Events(MPI_Comm comm, Simulation& simulation)
    : comm_(comm), sim_(simulation), ends_(simulation.system(), simulation.feeders()), actions_(simulation) {
  const model::Case& c = sim_.model();
  for (const model::Event& e : c.events) {
    ScheduledEvent scheduled;
    scheduled.event = e;
    const Cause& cause = e.cause;
    if (cause.kind == Cause::Kind::paid_out) {
      const auto& feeders = sim_.feeders()->all();
      for (size_t f = 0; f < feeders.size(); ++f)
        if (feeders[f].line == c.line_index(cause.line) &&
            feeders[f].line_end == (cause.arc > 0 ? LineEnd::B : LineEnd::A))
          scheduled.feeder = static_cast<int>(f);
    } else if (!cause.line.empty()) {
      scheduled.node = sim_.mesh().nearest_node(c.line_index(cause.line), cause.arc);
    } else if (cause.kind == Cause::Kind::near) {
      scheduled.node = actions_.node(e.action);
    }
    for (size_t k = 0; k < c.events.size() && cause.kind == Cause::Kind::after; ++k)
      if (c.events[k].name == cause.event) scheduled.after = static_cast<int>(k);
    events_.push_back(std::move(scheduled));
  }
}

void Events::watch() {
  if (std::any_of(events_.begin(), events_.end(), waits_for_condition))
    sim_.dynamics().watch([this](const Kinematics& trial) { return conditions(values(trial)); });
}

double Events::local_value(const ScheduledEvent& scheduled, const Kinematics& state) const {
  const LocalMesh& local = sim_.local();
  const Cause& cause = scheduled.event.cause;
  const int n = scheduled.node < 0 ? -1 : local.find(scheduled.node);
  const bool local_node = local.owns(n);
  switch (cause.kind) {
    case Cause::Kind::position:
      if (!cause.body.empty()) {
        const auto pose = sim_.body_pose(sim_.model().body_index(cause.body), state);
        return pose ? pose->position[cause.axis] : -HUGE_VAL;
      }
      return local_node ? state.x[n][cause.axis] : -HUGE_VAL;
    case Cause::Kind::paid_out: {
      const Feeders& feeders = *sim_.feeders();
      const Feeder& f = feeders.all()[scheduled.feeder];
      if (!feeders.at_feed_point(f)) return -HUGE_VAL;
      return feeders.outside(f) - f.length + feeders.feed_point(f, state).length - f.outside_at_start;
    }
    case Cause::Kind::near:
      return local_node ? actions_.away(scheduled.event.action, state) : -HUGE_VAL;
    case Cause::Kind::tension:
      return local_tension(scheduled.node);
    case Cause::Kind::time:
    case Cause::Kind::after:
    case Cause::Kind::stage:
      break;  // no monitored value
  }
  return -HUGE_VAL;
}

double Events::local_tension(int node) const {
  const int n = sim_.local().find(node);
  for (const record::EndForces::SectionNode& p : ends_.places())
    if (p.node == n)
      return p.line_end ? p.at_line_end().tension() : std::max(p.sides[0].tension(), p.sides[1].tension());
  return -HUGE_VAL;
}

std::vector<double> Events::values(const Kinematics& state) {
  ends_.evaluate(state, std::vector<Vec3>(static_cast<size_t>(sim_.local().nodes()), Vec3::Zero()));
  std::vector<double> out;
  for (const ScheduledEvent& scheduled : events_) out.push_back(local_value(scheduled, state));
  return all_reduce(comm_, MPI_MAX, out);
}

std::vector<double> Events::conditions(const std::vector<double>& values) const {
  std::vector<double> out;
  for (size_t e = 0; e < events_.size(); ++e) {
    const Cause& c = events_[e].event.cause;
    const bool waits = events_[e].happened < 0 && waits_for_condition(events_[e]);
    out.push_back(waits ? (c.below ? c.limit - values[e] : values[e] - c.limit) / tolerance(c) : -1);
  }
  return out;
}

void Events::refuse_conditions_met(const std::vector<double>& values) const {
  const std::vector<double> g = conditions(values);
  for (size_t e = 0; e < events_.size(); ++e) {
    if (!(g[e] >= 0)) continue;
    sim_.model().refuse(fmt::format("events[{}]", e), advice::met_at_start(events_[e].event, values[e]));
  }
}

double Events::due(const ScheduledEvent& scheduled) const {
  const Cause& c = scheduled.event.cause;
  if (c.kind == Cause::Kind::time) return c.time;
  if (c.kind != Cause::Kind::after) return HUGE_VAL;
  const double first = events_[scheduled.after].happened;
  return first < 0 ? HUGE_VAL : first + c.time;
}

double Events::next(double time) const {
  double out = HUGE_VAL;
  for (const ScheduledEvent& scheduled : events_)
    if (scheduled.happened < 0 && due(scheduled) > time + record::time_tolerance(time))
      out = std::min(out, due(scheduled));
  return out;
}

std::vector<size_t> Events::due_at(double time, const std::vector<double>& values,
                                   const std::string& stage) const {
  const std::vector<double> g = conditions(values);
  std::vector<size_t> out;
  for (size_t i = 0; i < events_.size(); ++i) {
    const Cause& c = events_[i].event.cause;
    const bool now = stage.empty() ? g[i] >= 0 || time >= due(events_[i]) - record::time_tolerance(time)
                                   : c.kind == Cause::Kind::stage && c.event == stage;
    if (events_[i].happened < 0 && now) out.push_back(i);
  }
  return out;
}

void Events::execute(size_t i, const Kinematics& state, const std::string& stage,
                     std::vector<std::string>& messages) {
  ScheduledEvent& scheduled = events_[i];
  const Action& a = scheduled.event.action;
  scheduled.placed = actions_.act(a, state);
  scheduled.order = static_cast<double>(std::count_if(
      events_.begin(), events_.end(), [](const ScheduledEvent& other) { return other.happened >= 0; }));
  scheduled.happened = state.time;
  advice::Happened how;
  if (a.kind == Action::Kind::release) {
    how.tension = local_tension(actions_.node(a));
    all_reduce(comm_, MPI_MAX, how.tension);
  }
  if (a.at) how.from_place = scheduled.placed.away;
  if (a.kind == Action::Kind::attach && !a.at && !a.body.empty()) {
    const model::Body& body = sim_.model().bodies[sim_.model().body_index(a.body)];
    const Vec3 centre =
        sim_.model().floats(sim_.model().body_index(a.body)) ? body.mass->centre : Vec3(Vec3::Zero());
    how.from_origin = (Vec3(scheduled.placed.place.data()) + centre).norm();
  }
  messages.push_back(advice::happened(a, state.time, stage, how));
  if (a.kind != Action::Kind::release) return;
  for (const ExcludedEnds& out : sim_.excluded_ends()) {
    const double length = a.line_end == LineEnd::B ? out.end_b : out.end_a;
    if (out.line == sim_.model().line_index(a.line) && length > 0)
      messages.push_back(
          advice::released_inside(a, sim_.line_volume_contact()->volume_name(out.volume), length));
  }
}

void Events::execute(const std::vector<size_t>& now, const Kinematics& state, const std::string& stage,
                     std::vector<std::string>& messages, const std::function<void()>& go_on) {
  try {
    actions_.begin();
    for (const size_t i : now) execute(i, state, stage, messages);
    go_on();
  } catch (...) {
    // A checkpoint after this failure has the state before the events.
    for (const size_t i : now) events_[i].happened = -1;
    throw;
  }
}

// In the state from which dynamics or a stage begins.
std::vector<std::string> Events::at_rest(const std::string& stage) {
  const Kinematics at = sim_.state().at_rest();
  System& system = sim_.system();
  std::vector<std::string> messages;
  for (;;) {
    const std::vector<size_t> now = due_at(at.time, values(at), stage);
    if (now.empty()) return messages;
    execute(now, at, stage, messages,
            [&] { system.tie(actions_.tied(), BodyMotion(system.tied_nodes().motion())); });
  }
}

// True if the stage releases a line or its support.
bool Events::releases_end(const std::string& stage) const {
  return std::any_of(events_.begin(), events_.end(), [&](const ScheduledEvent& scheduled) {
    const Action& a = scheduled.event.action;
    const bool carried = a.kind == Action::Kind::contact && !a.enabled;
    return scheduled.event.cause.kind == Cause::Kind::stage && scheduled.event.cause.event == stage &&
           (a.kind == Action::Kind::release || carried);
  });
}

void Events::solve_stages(const std::function<void(StartsFrom)>& solve,
                          const std::function<void(const std::string&)>& report,
                          const std::function<void(size_t)>& rested) {
  const std::vector<std::string>& stages = sim_.model().stages;
  if (stages.empty()) solve(StartsFrom::rest);
  for (size_t k = 0; k < stages.size(); ++k) {
    report(advice::stage_of_statics(stages[k]));
    for (const std::string& e : at_rest(stages[k])) report(e);
    solve(k > 0 && releases_end(stages[k]) ? StartsFrom::release : StartsFrom::rest);
    pay_out(stages[k], solve);
    rested(k);
  }
}

// Pays out element by element, all feeders of the stage together, each from the equilibrium before.
void Events::pay_out(const std::string& stage, const std::function<void(StartsFrom)>& solve) {
  std::map<Feeder*, double> remaining;  // m
  for (const ScheduledEvent& scheduled : events_) {
    const Action& a = scheduled.event.action;
    if (scheduled.event.cause.kind != Cause::Kind::stage || scheduled.event.cause.event != stage ||
        a.paid_out == 0)
      continue;
    for (Feeder& f : sim_.feeders()->all())
      if (f.line == sim_.model().line_index(a.line) && f.line_end == a.line_end) remaining[&f] += a.paid_out;
  }
  FeederNodes feeder_nodes(sim_);
  for (bool more = !remaining.empty(); more;) {
    more = false;
    for (auto& [f, length] : remaining) {
      const double limit = sim_.feeders()->element_length(*f, f->feed_point);
      const double shift = std::clamp(length, -limit, limit);
      feeder_nodes.shift(*f, shift);
      more |= (length -= shift) != 0;
    }
    try {
      if (more)
        sim_.solve_statics();
      else
        solve(StartsFrom::rest);
    } catch (const SolveError& e) {
      const auto& [f, length] = *std::max_element(
          remaining.begin(), remaining.end(),
          [](const auto& p, const auto& q) { return std::abs(p.second) < std::abs(q.second); });
      throw SolveError(advice::cannot_pay_out(stage, length, f->name, e.what()));
    }
  }
}

std::vector<std::string> Events::begin() {
  if (events_.empty()) return {};
  watch();
  refuse_conditions_met(values(sim_.state().at_rest()));
  return at_rest("");
}

std::vector<std::string> Events::apply_due() {
  std::vector<std::string> messages;
  Dynamics& d = sim_.dynamics();
  const auto energy = [&] {
    const Energy e = sim_.system().energy(d.committed().s.after_step(d.control().proposal()));
    return e.kinetic + e.strain + e.potential + e.friction + e.damping + e.unresolved - e.work;
  };
  const auto waits = [](const ScheduledEvent& scheduled) { return scheduled.happened < 0; };
  while (std::any_of(events_.begin(), events_.end(), waits)) {
    const Kinematics at = d.committed_kinematics();
    const std::vector<size_t> now = due_at(at.time, values(at), "");
    if (now.empty()) break;
    // An impact dissipates energy, and contact that ends releases stored energy.
    const bool changes = std::any_of(now.begin(), now.end(), [this](size_t i) {
      return events_[i].event.action.kind != Action::Kind::release;
    });
    const double before = changes ? energy() : 0;
    execute(now, at, "", messages, [&] { d.retie(actions_.tied()); });
    if (changes) d.add_support_work(energy() - before);
  }
  return messages;
}

std::vector<std::string> Events::not_happened() const {
  std::vector<std::string> out;
  for (const ScheduledEvent& scheduled : events_)
    if (scheduled.happened < 0) out.push_back(advice::did_not_happen(scheduled.event));
  return out;
}

}  // namespace hawser::run
