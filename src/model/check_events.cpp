// Checks of single events: whether each is possible and has an effect. Their order: check_event_order.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check_event_order.hpp"
#include "event_checks.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::model {
namespace {

using Kind = Action::Kind;

class EventCheck : private EventChecks {
 public:
  EventCheck(const Case& c, const Issues& issue) : EventChecks(c, issue) {}

  void run() {
    for (i_ = 0; i_ < c_.events.size(); ++i_) {
      const Event& e = event();
      if (e.cause.kind == Cause::Kind::stage)
        check_stage(e);
      else if (!c_.dynamics.enabled)
        issue("", "the case has no 'dynamics', and the event happens during dynamics");
      check_action(e.action);
      check_cause(e.cause);
    }
  }

 private:
  const Line& line(const std::string& name) const { return c_.line(name); }
  const End& end_of(const Action& a) const { return line(a.line).end(a.line_end); }
  const LineType& type_at(const std::string& name, double arc) const {
    return c_.line_type(section_at(line(name), arc).type);
  }
  std::string end_name(const Action& a) const { return fmt::format("end {}", end_letter(a.line_end)); }

  void check_stage(const Event& e) {
    if (std::find(c_.stages.begin(), c_.stages.end(), e.cause.event) == c_.stages.end())
      issue("stage", "there is no stage '{}'{}", e.cause.event,
            c_.stages.empty() ? "; list it under 'stages'" : did_you_mean(e.cause.event, c_.stages));
    if (e.action.kind == Kind::feed && e.action.paid_out == 0)
      issue("stage",
            "a feeder is at rest in statics, so its speed and tension have no effect there; give 'paid_out', "
            "the length that statics pays out");
  }

  void check_action(const Action& a) {
    if (a.cut >= 0) return check_cut(a);
    const bool stage = event().cause.kind == Cause::Kind::stage;
    if ((a.kind == Kind::friction || a.kind == Kind::current) && !stage)
      return issue("", "{} is {} in a 'stage' of statics only{}", a.subject(), a.participle(),
                   a.kind == Kind::current ? "; in time the current has a 'time_factor'" : "");
    if (a.kind == Kind::current && c_.environment.water.current.profile.empty())
      issue("current", "the water has no current that could be scaled");
    if (a.kind == Kind::current && c_.environment.water.current.ramp > 0)
      issue("current", "the current has a 'ramp' from t = 0 on and is zero in statics");
    if (a.line.empty()) return;
    const End& end = end_of(a);
    if (a.kind == Kind::feed) return a.paid_out != 0 ? check_paid_out(a, end) : check_law(a, end);
    if (end.feed)
      issue(a.kind == Kind::release ? "release" : "attach",
            "{} of line '{}' has a feeder, and such an end cannot be released or attached", end_name(a),
            a.line);
    if (end.rotational_stiffness > 0)
      issue(a.kind == Kind::release ? "release" : "attach",
            "{} of line '{}' has 'rotational_stiffness', which a release does not remove; only ends that "
            "turn freely or are 'clamped' can be released or attached",
            end_name(a), a.line);
    if (a.kind == Kind::attach) check_attach(a, end);
  }

  void check_attach(const Action& a, const End& end) {
    const int body = c_.body_index(a.body);
    if (a.clamped &&
        type_at(a.line, a.line_end == LineEnd::B ? length_of(line(a.line)) : 0).kind == LineKind::cable)
      issue("attach.clamped", "line '{}' has no bending stiffness there and cannot be clamped", a.line);
    if (c_.rides(body))
      issue("attach.body", "body '{}' rides on a line; ends of lines are tied to lines at a joint", a.body);
    if (c_.floats(body) &&
        (end.kind == EndKind::joint ||
         (end.kind == EndKind::body && end.carrier != a.body && c_.floats(c_.body_index(end.carrier)))))
      issue("attach.body",
            "{} of line '{}' begins at {} '{}', and an end can be attached to one moving thing only, so not "
            "to body '{}' as well",
            end_name(a), a.line, end.kind == EndKind::joint ? "joint" : "body", end.carrier, a.body);
    for (const Event& other : c_.events)
      if (other.action.kind == Kind::attach && other.action.line == a.line &&
          other.action.line_end == a.line_end && c_.floats(body) &&
          c_.floats(c_.body_index(other.action.body)) && other.action.body != a.body)
        issue("attach.body",
              "another event attaches {} of line '{}' to body '{}', and an end can be attached to one body "
              "only that moves by its own equations",
              end_name(a), a.line, other.action.body);
  }

  void check_cut(const Action& a) {
    const Line& l = line(a.given_line);
    const double length = length_of(l);
    if (!(a.cut < length))
      return issue("cut.at", "arc length {:.6g} m is not within line '{}', which is {:.6g} m long", a.cut,
                   a.given_line, length);
    check_parts(a, length);
    if (l.target)
      issue("cut",
            "line '{}' has a 'target' and cannot be cut; give its section the length that meets the target "
            "and remove 'target'",
            a.given_line);
    for (const SupportBox& s : c_.supports)
      if (s.line == a.given_line)
        return issue("cut", "line '{}' is laid over supports and cannot be cut", a.given_line);
    for (const LineEnd end : kLineEnds)
      if (const auto& feed = l.end(end).feed;
          feed && (end == LineEnd::B ? length - a.cut : a.cut) <= feed->stock)
        issue("cut.at", "arc length {:.6g} m of line '{}' is inside the feeder at its end {}", a.cut,
              a.given_line, end_letter(end));
  }

  // Each part between cuts, ends and section boundaries is at least one element long and no shorter than the
  // line's diameter.
  void check_parts(const Action& a, double length) {
    const double same = kArcTolerance * length;
    const double shortest = std::max(type_at(a.given_line, a.cut).outer_diameter, same);
    if (const double part = std::min(a.cut, length - a.cut); part < shortest)
      return issue("cut.at",
                   "arc length {:.9g} m leaves {:.3g} m of line '{}' at its end {}, less than its outer "
                   "diameter ({:.3g} m); use 'release' for the end itself",
                   a.cut, part, a.given_line, a.cut < length - a.cut ? 'A' : 'B', shortest);
    double end = 0;
    for (const Section& s : line(a.given_line).sections)
      if (const double off = std::abs((end += s.length) - a.cut); off > same && off < shortest)
        return issue(
            "cut.at",
            "arc length {:.9g} m of line '{}' is {:.3g} m from the end of a section at {:.9g} m, less "
            "than its outer diameter ({:.3g} m); cut the line just there, or further away",
            a.cut, a.given_line, off, end, shortest);
    for (std::size_t k = 0; k < i_; ++k) {
      const Action& o = c_.events[k].action;
      if (o.cut < 0 || o.given_line != a.given_line) continue;
      const double part = std::abs(o.cut - a.cut);
      if (part <= same)
        issue("cut.at", "line '{}' is cut there already by another event", a.given_line);
      else if (part < shortest)
        issue("cut.at",
              "another event cuts line '{}' {:.3g} m away, and a part between two cuts must not be shorter "
              "than its outer diameter ({:.3g} m)",
              a.given_line, part, shortest);
    }
  }

  // Over all stages the length inside the feeder and the length outside must stay positive.
  void check_paid_out(const Action& a, const End& end) {
    if (event().cause.kind != Cause::Kind::stage)
      return issue("feed.paid_out", "is of a 'stage' of statics; in time a feeder has a 'speed'");
    if (!end.feed) return issue("feed", "{} of line '{}' has no 'feed'", end_name(a), a.line);
    if (end.feed->speed.empty())
      return issue("feed.paid_out",
                   "the feeder keeps a tension, and statics finds the length inside for it; give its 'feed' "
                   "a 'speed' and set the 'tension' by an event at 'time: 0'");
    for (const Section& s : line(a.line).sections)
      if (c_.line_type(s.type).plastic_bending)
        return issue("feed.paid_out",
                     "line type '{}' has 'plasticity', and statics does not bend what it pays out", s.type);
    double inside = end.feed->stock;
    for (std::size_t k = 0; k <= i_; ++k)
      if (const Action& o = c_.events[k].action;
          o.paid_out != 0 && o.line == a.line && o.line_end == a.line_end)
        inside -= o.paid_out;
    const double length = length_of(line(a.line));
    if (inside <= 0 || inside >= length)
      issue("feed.paid_out", "{:g} m would remain {}: the feeder begins with {:g} m of {:g} m inside",
            inside <= 0 ? inside : length - inside, inside <= 0 ? "inside" : "outside", end.feed->stock,
            length);
  }

  void check_law(const Action& a, const End& end) {
    if (!end.feed) return issue("feed", "{} of line '{}' has no 'feed'", end_name(a), a.line);
    hawser::model::check_law(a.law, all_.below(fmt::format("events[{}].feed", i_)));
  }

  void check_cause(const Cause& cause) {
    if (cause.kind == Cause::Kind::time && c_.dynamics.enabled && cause.time >= c_.dynamics.duration)
      issue("time", "is {:g} s, but the run ends at {:g} s", cause.time, c_.dynamics.duration);
    if (cause.kind == Cause::Kind::after && c_.dynamics.enabled && cause.time >= c_.dynamics.duration)
      issue("delay", "is {:g} s, but the run ends at {:g} s", cause.time, c_.dynamics.duration);
    const bool on_released_line = event().action.kind == Kind::release &&
                                  cause.kind == Cause::Kind::tension && cause.line == event().action.line &&
                                  !cause.below;
    const std::string when = on_released_line ? "" : "when.";
    if (cause.line.empty()) return;
    const double length = length_of(line(cause.line));
    if (cause.arc > length * (1 + kArcTolerance))
      return issue(cause.kind == Cause::Kind::tension ? "when.tension.at" : "when.position.at",
                   "arc length {:.6g} m is beyond the end of line '{}', which is {:.6g} m long", cause.arc,
                   cause.line, length);
    if (cause.kind == Cause::Kind::tension) {
      const LineType& type = type_at(cause.line, cause.arc);
      if (!cause.below && type.breaking_load > 0 && cause.limit > type.breaking_load)
        issue(when + "tension", "{:g} N is above the breaking load of line type '{}', {:g} N", cause.limit,
              type.name, type.breaking_load);
      if (type.kind == LineKind::cable && cause.limit <= 0)
        issue(when + "tension",
              "line '{}' has no bending stiffness there and cannot be in compression; give a limit above 0",
              cause.line);
      for (const LineEnd end : kLineEnds)
        if (const auto& feed = line(cause.line).end(end).feed;
            feed && cause.arc > 0 && cause.arc < length &&
            (end == LineEnd::B ? length - cause.arc : cause.arc) < feed->stock)
          issue("when.tension.at",
                "arc length {:.6g} m of line '{}' is inside the feeder at its end {} at the start, where the "
                "line has no tension; give '{}' for the tension at the feeder",
                cause.arc, cause.line, end_letter(end), end_key(end));
      const bool at_a = cause.arc <= kArcTolerance * length;
      const bool at_b = cause.arc >= length * (1 - kArcTolerance);
      const LineEnd end = at_a ? LineEnd::A : LineEnd::B;
      if ((at_a || at_b) && line(cause.line).end(end).kind == EndKind::free && !attached(cause.line, end))
        issue(when + "tension", "the tension of a free end is 0: end {} of line '{}' is free",
              end_letter(end), cause.line);
    }
    if (cause.kind == Cause::Kind::paid_out) {
      const Line& l = line(cause.line);
      const LineEnd end = cause.arc > 0 ? LineEnd::B : LineEnd::A;
      const auto& feed = l.end(end).feed;
      if (!feed)
        issue("when.paid_out.end", "end {} of line '{}' has no 'feed'", end_letter(end), cause.line);
      else if (cause.limit > feed->stock || cause.limit < feed->stock - length)
        issue("when.paid_out", "{:g} m cannot be: the feeder begins with {:g} m inside and {:g} m outside",
              cause.limit, feed->stock, length - feed->stock);
    }
  }

  bool attached(const std::string& name, LineEnd end) const {
    return std::any_of(c_.events.begin(), c_.events.end(), [&](const Event& e) {
      return e.action.kind == Kind::attach && e.action.line == name && e.action.line_end == end;
    });
  }
};

}  // namespace

void check_events(const Case& c, const Issues& issue) {
  EventCheck(c, issue).run();
  check_event_order(c, issue);
}

}  // namespace hawser::model
