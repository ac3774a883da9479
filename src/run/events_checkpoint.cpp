// Checkpoints of the class Events: time and result of each event.
#include <algorithm>
#include <set>
#include <tuple>

#include "hawser/advice/restart.hpp"
#include "hawser/base/error.hpp"
#include "hawser/record/output_times.hpp"
#include "hawser/run/events.hpp"

namespace hawser::run {
namespace {

using model::Cause;

const std::string kHappened = "event.";  // before the name
const std::string kOrder = " order";     // after it

// Keys of an action's result in a checkpoint.
std::vector<std::pair<const char*, double*>> entries(Actions::Found& f) {
  return {{" x", &f.place[0]},     {" y", &f.place[1]},     {" z", &f.place[2]},     {" q0", &f.rotation[0]},
          {" q1", &f.rotation[1]}, {" q2", &f.rotation[2]}, {" q3", &f.rotation[3]}, {" speed", &f.speed}};
}

}  // namespace

void Events::save(io::Checkpoint& to) const {
  for (const ScheduledEvent& scheduled : events_) {
    if (scheduled.happened < 0) continue;
    const std::string key = kHappened + scheduled.event.name;
    to.scalars[key] = scheduled.happened;
    to.scalars[key + kOrder] = scheduled.order;
    Actions::Found placed = scheduled.placed;
    for (const auto& [name, value] : entries(placed)) to.scalars[key + name] = *value;
  }
}

bool Events::has_all_of(const io::Checkpoint& from, const model::Case& c) {
  return std::ranges::all_of(from.scalars, [&](const auto& scalar) {
    return !scalar.first.starts_with(kHappened) || std::ranges::any_of(c.events, [&](const model::Event& e) {
      return scalar.first.starts_with(kHappened + e.name);
    });
  });
}

std::vector<std::string> Events::restore(const io::Checkpoint& from) {
  watch();
  const auto refusal = [this](const std::string& why) {
    return InputError("{}: events: {}", sim_.model().path, why);
  };
  std::vector<ScheduledEvent*> happened;
  std::set<std::string> known;  // keys
  for (ScheduledEvent& scheduled : events_) {
    const std::string key = kHappened + scheduled.event.name;
    known.insert(key);
    known.insert(key + kOrder);
    const auto at = from.scalars.find(key);
    if (at == from.scalars.end()) {
      if (scheduled.event.cause.kind == Cause::Kind::time &&
          scheduled.event.cause.time < from.time - record::time_tolerance(from.time))
        throw refusal(advice::event_before_restart(scheduled.event, from.time));
      if (scheduled.event.cause.kind == Cause::Kind::stage)
        throw refusal(advice::event_of_statics_missing(scheduled.event));
      continue;
    }
    scheduled.happened = at->second;
    if (const auto order = from.scalars.find(key + kOrder); order != from.scalars.end())
      scheduled.order = order->second;
    for (const auto& [name, value] : entries(scheduled.placed)) {
      known.insert(key + name);
      if (const auto entry = from.scalars.find(key + name); entry != from.scalars.end())
        *value = entry->second;
    }
    happened.push_back(&scheduled);
  }
  for (const auto& [key, time] : from.scalars)
    if (key.starts_with(kHappened) && !known.count(key))
      throw refusal(advice::event_unknown(std::string(key.substr(kHappened.size())), time));
  std::stable_sort(happened.begin(), happened.end(), [](const ScheduledEvent* a, const ScheduledEvent* b) {
    return std::tie(a->happened, a->order) < std::tie(b->happened, b->order);
  });
  std::vector<std::string> messages;
  actions_.begin();
  for (const ScheduledEvent* scheduled : happened) {
    actions_.repeat(scheduled->event.action, scheduled->placed, scheduled->happened);
    messages.push_back("note: " + advice::event_happened(scheduled->event, scheduled->happened));
  }
  if (messages.empty()) return messages;
  System& system = sim_.system();
  system.tie(actions_.tied(), BodyMotion(system.tied_nodes().motion()));
  return messages;
}

}  // namespace hawser::run
