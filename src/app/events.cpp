// The class Events: which event happens at a state, and what it does to the supports.
#include "hawser/app/events.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hawser/base/error.hpp"

namespace hawser::app {
namespace {

// How far a step may go beyond the tension at which something happens, of that tension.
constexpr double kNear = 1e-3;

const std::string kHappened = "event.";  // in a checkpoint, before the name

double slack(double time) { return 1e-9 * std::max(1.0, time); }

}  // namespace

Events::Events(MPI_Comm comm, Simulation& simulation)
    : comm_(comm), sim_(simulation), ends_(simulation.system()) {
  const model::Case& c = sim_.model();
  bool by_tension = false;
  for (const model::Release& r : c.events) {
    const LineSpan& span = sim_.mesh().lines[static_cast<size_t>(c.line_index(r.line))];
    events_.push_back({r, span.first_node + (r.at_b ? span.nodes - 1 : 0),
                       fmt::format("end {} of line {}", r.at_b ? 'B' : 'A', r.line)});
    by_tension |= r.time < 0;
  }
  if (by_tension) sim_.dynamics().watch([this](const Kinematics& trial) { return functions(trial); });
}

std::vector<double> Events::tensions(const Kinematics& at) {
  const LocalMesh& local = sim_.local();
  ends_.evaluate(at, std::vector<Vec3>(static_cast<size_t>(local.nodes()), Vec3::Zero()));
  std::vector<double> out(events_.size(), 0);
  for (const EndForces::Place& p : ends_.places())
    for (size_t e = 0; e < events_.size(); ++e)
      if (p.end >= 0 && local.global[static_cast<size_t>(p.node)] == events_[e].node)
        out[e] = p.at_end().tension();
  MPI_Allreduce(MPI_IN_PLACE, out.data(), static_cast<int>(out.size()), MPI_DOUBLE, MPI_MAX, comm_);
  return out;
}

std::vector<double> Events::functions(const Kinematics& at) {
  std::vector<double> out = tensions(at);
  for (size_t e = 0; e < events_.size(); ++e) {
    const double tension = events_[e].what.tension;
    const bool awaited = events_[e].happened < 0 && events_[e].what.time < 0;
    out[e] = awaited ? (out[e] - tension) / (kNear * tension) : -1;
  }
  return out;
}

std::vector<Support> Events::remaining_supports() const {
  const LocalMesh& local = sim_.local();
  std::vector<Support> out;
  for (const Support& s : sim_.system().supports().list()) {
    const int node = local.global[static_cast<size_t>(s.node)];
    if (std::none_of(events_.begin(), events_.end(),
                     [&](const Event& e) { return e.happened >= 0 && e.node == node; }))
      out.push_back(s);
  }
  return out;
}

void Events::refuse_reached(const std::vector<double>& pull) const {
  for (size_t e = 0; e < events_.size(); ++e)
    if (events_[e].happened < 0 && events_[e].what.time < 0 && pull[e] >= events_[e].what.tension)
      sim_.model().refuse(fmt::format("events[{}].tension", e),
                          fmt::format("{} pulls with {:.6g} N at the start already, and would be released "
                                      "before anything moves; give a higher tension, or 'time: 0'",
                                      events_[e].name, pull[e]));
}

// Marks what happens at a state, and tells it.
std::vector<std::string> Events::release(const Kinematics& at, const std::vector<double>& pull) {
  std::vector<std::string> told;
  for (size_t i = 0; i < events_.size(); ++i) {
    Event& e = events_[i];
    const bool due =
        e.what.time >= 0 ? at.time >= e.what.time - slack(e.what.time) : pull[i] >= e.what.tension;
    if (e.happened >= 0 || !due) continue;
    e.happened = at.time;
    told.push_back(fmt::format("note: t = {:.6g} s: {} is released, with a tension of {:.6g} N", at.time,
                               e.name, pull[i]));
    for (const LeftOut& out : sim_.left_out()) {
      const double length = e.what.at_b ? out.end_b : out.end_a;
      if (out.line == sim_.model().line_index(e.what.line) && length > 0)
        told.push_back(
            fmt::format("warning: {} that is released starts inside volume {}, and {:.3g} m of the "
                        "line from there on go through it as if it were not there",
                        e.name, sim_.contact()->volume_name(out.volume), length));
    }
  }
  return told;
}

std::vector<std::string> Events::begin() {
  if (events_.empty()) return {};
  const Kinematics at = sim_.state().view(0);
  const std::vector<double> pull = tensions(at);
  refuse_reached(pull);
  std::vector<std::string> told = release(at, pull);
  System& system = sim_.system();
  if (!told.empty()) system.support(remaining_supports(), BodyMotion(system.supports().motion()));
  return told;
}

std::vector<std::string> Events::apply_due() {
  if (events_.empty()) return {};
  const Kinematics at = sim_.dynamics().kinematics();
  std::vector<std::string> told = release(at, tensions(at));
  if (!told.empty()) sim_.dynamics().release(remaining_supports());
  return told;
}

std::vector<std::string> Events::not_happened() const {
  std::vector<std::string> out;
  for (const Event& e : events_)
    if (e.happened < 0)
      out.push_back(fmt::format("{} was not released: {}", e.name,
                                e.what.time >= 0
                                    ? fmt::format("the run ended before t = {:g} s", e.what.time)
                                    : fmt::format("its tension did not reach {:g} N", e.what.tension)));
  return out;
}

void Events::save(io::Checkpoint& to) const {
  for (const Event& e : events_)
    if (e.happened >= 0) to.scalars[kHappened + e.name] = e.happened;
}

std::vector<std::string> Events::restore(const io::Checkpoint& from) {
  std::vector<std::string> told;
  for (const auto& [key, time] : from.scalars) {
    if (!key.starts_with(kHappened)) continue;
    const std::string name = key.substr(kHappened.size());
    const auto event =
        std::find_if(events_.begin(), events_.end(), [&](const Event& e) { return e.name == name; });
    if (event == events_.end())
      throw InputError(
          fmt::format("{}: events: {} was released at t = {:g} s of the run that this one goes on "
                      "from, and no event says so; keep that event in the case",
                      sim_.model().path, name, time));
    event->happened = time;
    told.push_back(fmt::format("note: {} was released at t = {:.6g} s", name, time));
  }
  for (const Event& e : events_)
    if (e.happened < 0 && e.what.time >= 0 && e.what.time < from.time - slack(from.time))
      throw InputError(fmt::format(
          "{}: events: {} was to be released at {:g} s, before t = {:g} s from which the run goes "
          "on, and was not; give it a later time",
          sim_.model().path, e.name, e.what.time, from.time));
  if (told.empty()) return told;
  System& system = sim_.system();
  system.support(remaining_supports(), BodyMotion(system.supports().motion()));
  return told;
}

}  // namespace hawser::app
