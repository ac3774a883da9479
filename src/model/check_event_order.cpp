// Checks of events against each other: their order and the state that they leave.
#include "check_event_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "event_checks.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/switched.hpp"

namespace hawser::model {
namespace {

using Kind = Action::Kind;

class EventOrder : private EventChecks {
 public:
  EventOrder(const Case& c, const Issues& issue) : EventChecks(c, issue) {}

  void run() {
    for (i_ = 0; i_ < c_.events.size(); ++i_) {
      check_chain();
      check_feeds();
    }
    check_ends();
    check_joints();
    check_volumes();
    check_stages();
    check_names();
  }

 private:
  const Line& line(const std::string& name) const { return c_.line(name); }

  // A chain of events that wait for each other must have a first event.
  void check_chain() {
    const Event* e = &event();
    std::vector<std::string> names;
    for (const Event& other : c_.events) names.push_back(other.name);
    for (std::size_t steps = 0; e->cause.kind == Cause::Kind::after; ++steps) {
      const auto next = std::find(names.begin(), names.end(), e->cause.event);
      if (next == names.end())
        return e == &event() ? issue("after", "there is no event '{}'{}", e->cause.event,
                                     did_you_mean(e->cause.event, names))
                             : void();
      if (steps == names.size())
        return issue("after", "it waits for '{}', which waits for it in turn: neither ever happens",
                     event().cause.event);
      e = &c_.events[next - names.begin()];
    }
  }

  // Attachments and releases of an end must alternate.
  void check_ends() {
    std::map<std::pair<std::string, LineEnd>, std::vector<std::size_t>> ends;
    for (std::size_t k = 0; k < c_.events.size(); ++k)
      if (const Action& a = c_.events[k].action;
          a.cut < 0 && (a.kind == Kind::release || a.kind == Kind::attach))
        ends[{a.line, a.line_end}].push_back(k);
    for (auto& [end, events] : ends) {
      const auto time = [&](std::size_t k) {
        const Cause& cause = c_.events[k].cause;
        if (cause.kind == Cause::Kind::stage)  // before all times
          return static_cast<double>(std::find(c_.stages.begin(), c_.stages.end(), cause.event) -
                                     c_.stages.end());
        return cause.kind == Cause::Kind::time ? cause.time : HUGE_VAL;
      };
      const End& given = line(end.first).end(end.second);
      const bool held = given.kind != EndKind::free;
      int releases = 0, attachments = 0;
      for (const std::size_t k : events)
        (c_.events[k].action.kind == Kind::attach ? attachments : releases) += 1;
      const std::string name = fmt::format("end {}", end_letter(end.second));
      i_ = events.back();
      if (!held && attachments == 0)
        issue("release",
              "{} of line '{}' is free: no anchor, body or joint holds it that it could be released from",
              name, end.first);
      else if (held && releases == 0)
        issue("attach", "{} of line '{}' is held already; another event must release it before", name,
              end.first);
      else if (releases > attachments + (held ? 1 : 0))
        issue("release", "{} of line '{}' is released already by another event", name, end.first);
      else if (attachments > releases + (held ? 0 : 1))
        issue("attach", "{} of line '{}' is attached already by another event", name, end.first);
      else if (std::none_of(events.begin(), events.end(),
                            [&](std::size_t k) { return std::isinf(time(k)); })) {
        std::stable_sort(events.begin(), events.end(),
                         [&](std::size_t a, std::size_t b) { return time(a) < time(b); });
        bool now = held;
        for (const std::size_t k : events) {
          const bool attach = c_.events[k].action.kind == Kind::attach;
          i_ = k;
          if (attach == now)
            return attach
                       ? issue("time", "{} of line '{}' is held at {:g} s already", name, end.first, time(k))
                       : issue("time", "{} of line '{}' is free at {:g} s already", name, end.first, time(k));
          now = attach;
        }
      }
    }
  }

  // Simultaneous events of a feeder would override each other.
  void check_feeds() {
    for (std::size_t k = 0; k < i_; ++k) {
      const Event& e = event();
      const Event& o = c_.events[k];
      if (e.action.kind == Kind::feed && o.action.kind == Kind::feed && e.action.line == o.action.line &&
          e.action.line_end == o.action.line_end && e.cause.kind == o.cause.kind &&
          e.cause.time == o.cause.time && e.cause.event == o.cause.event &&
          (e.cause.kind == Cause::Kind::time || e.cause.kind == Cause::Kind::after))
        issue("feed", "'{}' changes the law of the feeder at the same time", o.name);
    }
  }

  void check_joints() {
    for (const Joint& j : c_.joints) {
      int stay = 0;
      std::size_t last = c_.events.size();
      for (const Line& l : c_.lines)
        for (const LineEnd line_end : kLineEnds) {
          const End& e = l.end(line_end);
          if (e.kind != EndKind::joint || e.carrier != j.name) continue;
          bool released = false;
          for (std::size_t k = 0; k < c_.events.size(); ++k)
            if (const Action& a = c_.events[k].action;
                a.kind == Kind::release && a.cut < 0 && a.line == l.name && a.line_end == line_end) {
              released = true;
              last = k;
            }
          stay += !released;
        }
      if (stay > 0 || last == c_.events.size()) continue;
      i_ = last;
      issue("release", "no end would remain at joint '{}': one of them must stay", j.name);
    }
  }

  void check_volumes() {
    std::vector<std::string> names;
    for (const Volume& v : c_.volumes) names.push_back(v.name);
    for (i_ = 0; i_ < c_.events.size(); ++i_)
      if (event().action.kind == Kind::contact &&
          std::none_of(c_.volumes.begin(), c_.volumes.end(),
                       [&](const Volume& v) { return switches(event().action, v); }))
        issue("contact.volume", "there is no volume, support or group of supports '{}'{}",
              event().action.volume, did_you_mean(event().action.volume, names));
    std::set<std::pair<std::size_t, std::size_t>> reported;  // reported once for all rollers of a group
    for (const Volume& v : c_.volumes) {
      std::vector<std::size_t> events;
      for (std::size_t k = 0; k < c_.events.size(); ++k)
        if (switches(c_.events[k].action, v)) events.push_back(k);
      if (events.empty()) continue;
      i_ = events.front();
      if (!c_.contact.takes_part(v))
        issue("contact.volume", "volume '{}' takes no part in contact ('contact.volumes')", v.name);
      for (std::size_t k = 1; k < events.size(); ++k) {
        i_ = events[k];
        if (c_.events[events[k]].action.enabled == c_.events[events[k - 1]].action.enabled &&
            reported.insert({events[k], events[k - 1]}).second)
          issue("contact", "contact with volume '{}' is {} by the event before already", v.name,
                event().action.enabled ? "on" : "off");
      }
    }
  }

  void check_names() {
    std::set<std::string> names;
    for (std::size_t k = 0; k < c_.events.size(); ++k)
      if (!names.insert(c_.events[k].name).second)
        all_(fmt::format("events[{}]", k), "another event is called '{}' as well; give this one a 'name'",
             c_.events[k].name);
  }

  void check_stages() {
    for (std::size_t k = 0; k < c_.stages.size(); ++k) {
      const std::string key = fmt::format("stages[{}]", k);
      const std::string& name = c_.stages[k];
      if (!c_.statics.enabled) all_(key, "the case has 'statics: false', so it has no stages");
      if (std::find(c_.stages.begin(), c_.stages.begin() + static_cast<std::ptrdiff_t>(k), name) !=
          c_.stages.begin() + static_cast<std::ptrdiff_t>(k))
        all_(key, "there is another stage called '{}'", name);
      else if (k > 0 && std::none_of(c_.events.begin(), c_.events.end(), [&](const Event& e) {
                 return e.cause.kind == Cause::Kind::stage && e.cause.event == name;
               }))
        all_(key,
             "no event begins stage '{}', so its equilibrium is that of the stage before; remove it or give "
             "it an event",
             name);
    }
  }
};

}  // namespace

void check_event_order(const Case& c, const Issues& issue) { EventOrder(c, issue).run(); }

}  // namespace hawser::model
