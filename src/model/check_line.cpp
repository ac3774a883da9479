// Checks of single lines: ends, span, start shape, soil, temperature, loads.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/increasing.hpp"

namespace hawser::model {
namespace {

// Largest strain between held ends with a modulus [Pa] of metal; more is a typing error, not a taut line.
constexpr double kLargestStrain = 0.10, kMetal = 20e9;
constexpr double kLargestExpansion = 0.05;  // thermal; ropes and rubber stay below
constexpr double kMostWeight = 100;         // of a line in air over EA; soft rubber under water: at most 1

class LineCheck {
 public:
  LineCheck(const Case& c, const Line& line, const Issues& all)
      : c_(c), line_(line), length_(length_of(line)), issue(all.below("lines." + line.name)) {}

  void run() {
    check_weight();
    check_end(line_.end_a, line_.sections.front(), "end_a");
    check_end(line_.end_b, line_.sections.back(), "end_b");
    check_start();
    if (check_temperature()) check_span();
    for (std::size_t i = 0; i < line_.masses.size(); ++i)
      check_arc(line_.masses[i].at, fmt::format("masses[{}].at", i));
    check_loads();
    for (std::size_t i = 0; i < line_.bend_stiffeners.size(); ++i)
      check_stiffener(line_.bend_stiffeners[i], fmt::format("bend_stiffeners[{}]", i));
    for (std::size_t i = 0; i < line_.buried.size(); ++i) check_buried(i, fmt::format("buried[{}]", i));
    if (line_.target) check_target(*line_.target);
  }

 private:
  bool attached(const End& e) const { return e.kind != EndKind::free; }

  // Length outside the feeders at the start, m.
  double outside() const {
    double sum = length_;
    for (const End* e : {&line_.end_a, &line_.end_b})
      if (e->feed) sum -= e->feed->stock;
    return sum;
  }

  void check_weight() {
    for (const Section& s : line_.sections) {
      const LineType& type = c_.line_type(s.type);
      const double weight = type.mass_per_length * s.length * c_.environment.gravity;
      if (weight > kMostWeight * type.EA)
        issue("",
              "{:g} m of line type '{}' weigh {:.3g} N, too much for an EA of {:.3g} N: check its "
              "mass_per_length and EA",
              s.length, s.type, weight, type.EA);
    }
  }

  void check_end(const End& e, const Section& section, const std::string& key) {
    if (e.kind == EndKind::joint && (e.clamped || e.rotational_stiffness > 0))
      return issue(key + (e.clamped ? ".clamped" : ".rotational_stiffness"),
                   "ends turn freely at a joint; remove it");
    if (attached(e) && e.rotational_stiffness > 0) check_spring(e, section, key);
    if (!attached(e) || !e.clamped) return;
    if (c_.line_type(section.type).kind == LineKind::cable)
      issue(key + ".clamped", "a line of type '{}' has no bending stiffness here and cannot be clamped",
            section.type);
    else if (!e.direction)
      issue(key + ".clamped", "a clamped end needs a direction: the tangent from end A to end B");
  }

  void check_spring(const End& e, const Section& section, const std::string& key) {
    if (e.clamped)
      issue(key + ".rotational_stiffness",
            "a clamped end cannot turn; remove 'clamped' or 'rotational_stiffness'");
    else if (c_.line_type(section.type).kind == LineKind::cable)
      issue(key + ".rotational_stiffness",
            "a line of type '{}' has no bending stiffness here for a rotational spring", section.type);
    else if (!e.direction)
      issue(key + ".rotational_stiffness",
            "needs 'direction', towards which the spring turns the end: the tangent from end A to end B");
  }

  void check_start() {
    const int ends = attached(line_.end_a) + attached(line_.end_b);
    const bool directed = line_.end_a.direction || line_.end_b.direction;
    switch (line_.start) {
      case Start::points:
        return check_points();
      case Start::catenary:
        if (ends < 2) issue("start", "a catenary hangs between two held ends, but this line has {}", ends);
        break;
      case Start::hanging:
        if (ends != 1) issue("start", "a hanging line has one held end, but this line has {}", ends);
        break;
      case Start::straight:
        if (ends == 0 || (ends == 1 && !directed))
          issue("start",
                "a straight start needs two held ends, or one with a direction; give start: {{points: ...}}");
        break;
      case Start::other_run:
        break;
      case Start::automatic:
        if (ends == 0)
          issue("", "both ends are free: give start: {{points: [[x, y, z], ...]}} to state where it lies");
    }
    check_held();
  }

  void check_held() {
    if (attached(line_.end_a) || attached(line_.end_b) || !c_.statics.enabled || held_by_friction(c_, line_))
      return;
    issue("",
          "both ends are free, so there is no static equilibrium; give statics: false, or where it lies "
          "('start') on a volume with friction and statics: {{contact_friction: true}}");
  }

  void check_points() {
    double laid = 0;
    for (std::size_t i = 1; i < line_.points.size(); ++i) {
      const double d = (line_.points[i] - line_.points[i - 1]).norm();
      if (d <= 0) issue(fmt::format("start.points[{}]", i), "is the same point as the one before it");
      laid += d;
    }
    if (std::abs(laid - outside()) > kLargestStrain * outside())
      issue("start.points",
            "this polyline is {:.6g} m long, but the line is {:.6g} m; they may differ by {:g} %", laid,
            outside(), 100 * kLargestStrain);
    check_point(line_.end_a, line_.points.front(), 0);
    check_point(line_.end_b, line_.points.back(), line_.points.size() - 1);
    check_held();
  }

  void check_point(const End& e, const Vec3& p, std::size_t i) {
    if (!attached(e)) return;
    const double gap = (end_position(c_, e) - p).norm();
    if (gap > 1e-3 * length_)
      issue(fmt::format("start.points[{}]", i), "is {:.4g} m away from the line's end, which is held", gap);
  }

  // Allowed strain, averaged along the line; fibres and rubber allow far more than metal.
  double largest_strain() const {
    double sum = 0;
    for (const Section& s : line_.sections) {
      const LineType& t = c_.line_type(s.type);
      const double modulus = t.EA / (M_PI / 4 * t.outer_diameter * t.outer_diameter);
      sum += s.length * (t.tension_table    ? t.tension_table->last() + kStrainBeyondRows
                         : modulus > kMetal ? kLargestStrain
                                            : kStrainBeyondRows);
    }
    return sum / length_;
  }

  // A taut line may be slightly shorter than its span; it stretches.
  void check_span() {
    if (!attached(line_.end_a) || !attached(line_.end_b)) return;
    if (line_.end_a.kind == EndKind::joint || line_.end_b.kind == EndKind::joint) return;  // joints move
    const double span = (end_position(c_, line_.end_b) - end_position(c_, line_.end_a)).norm();
    const double natural = outside() + expansion_of(c_, line_);
    const double strain = (span - natural) / natural;
    const double limit = largest_strain();
    if (!(strain < limit))
      issue("sections",
            "the line is {:.6g} m long{} but its ends are {:.6g} m apart at t = 0; that requires a strain of "
            "{:.3g} %, and the limit is {:g} %; make the line longer or move an end",
            natural, natural == outside() ? "" : " at its temperature", span, 100 * strain, 100 * limit);
  }

  void check_arc(double s, const std::string& key) {
    if (s > length_ * (1 + kArcTolerance))
      issue(key, "arc length {:.6g} m is beyond the end of the line, which is {:.6g} m long", s, length_);
  }

  // False: the rows are not a stiffness over a distance.
  bool check_rows(const BendStiffener& b, const std::string& key) {
    const std::size_t before = issue.count();
    for (std::size_t i = 0; i < b.rows.size(); ++i) {
      const auto [d, EI] = b.rows[i];
      const std::string row = fmt::format("{}.EI[{}]", key, i);
      if (i == 0 && !(d >= 0)) issue(row, "{:g} m is before the root", d);
      if (i > 0)
        if (const std::string fault = increase_fault("distances from the root", "m", b.rows[i - 1].first, d);
            !fault.empty())
          issue(row, "{}", fault);
      if (!(EI >= 0)) issue(row, "{:g} N m² would soften the line", EI);
    }
    return issue.count() == before;
  }

  void check_stiffener(const BendStiffener& b, const std::string& key) {
    check_arc(b.at, key + ".at");
    if (!check_rows(b, key)) return;
    const double tip = b.towards_a ? b.at - b.rows.back().first : b.at + b.rows.back().first;
    if (tip < -kArcTolerance * length_ || tip > length_ * (1 + kArcTolerance))
      return issue(key + ".EI", "reaches to {:g} m of a line of {:g} m", tip, length_);
    double start = 0;
    for (const Section& s : line_.sections) {
      const double overlap =
          std::min(start + s.length, std::max(b.at, tip)) - std::max(start, std::min(b.at, tip));
      if (overlap > kArcTolerance * length_ && c_.line_type(s.type).kind == LineKind::cable)
        return issue(key, "it is on a section of '{}', which does not resist bending", s.type);
      start += s.length;
    }
  }

  void check_buried(std::size_t i, const std::string& key) {
    const Buried& b = line_.buried[i];
    const double near = kArcTolerance * length_;
    if (!c_.environment.seabed.present)
      issue(key, "a line lies in the soil of a seabed, but there is no 'environment.seabed'");
    check_arc(b.from, key + ".from");
    check_arc(b.to, key + ".to");
    if (b.to <= b.from)
      issue(key + ".to", "the stretch from {:.6g} m to {:.6g} m has no length; 'to' must be above 'from'",
            b.from, b.to);
    else if (i > 0 && b.from < line_.buried[i - 1].to - near)
      issue(key + ".from", "{:.6g} m is within the previous stretch, which ends at {:.6g} m", b.from,
            line_.buried[i - 1].to);
    if (!line_.starts_by_itself() && line_.start != Start::hanging) return;
    const bool at_a = b.from <= near;
    const bool at_b = b.to >= length_ - near;
    if (!attached(line_.end_a) || !attached(line_.end_b) || line_.start == Start::hanging || at_a == at_b)
      issue(key,
            "the position of this stretch is not defined: give 'start' as straight or as points, or let it "
            "begin at an end of a line with two held ends");
  }

  void check_target(const LengthTarget& t) {
    using Target = LengthTarget::Kind;
    const bool bed = t.kind == Target::touchdown || t.kind == Target::laid_length;
    if (!c_.statics.enabled) issue("target", "needs static equilibrium, and this case has 'statics: false'");
    if (bed && !c_.environment.seabed.present)
      issue("target", "is about the seabed, but there is no 'environment.seabed'");
    if (!bed && !attached(line_.end(t.line_end)))
      issue("target", "end {} is free: it has no tension and no angle for a target", end_letter(t.line_end));
  }

  // Largest temperature change [K] in magnitude over the arc lengths [from, to], m.
  double largest_change(double from, double to) const {
    double largest = 0;
    for (const double s : {from, to})
      largest = std::max(largest, std::abs(mean_temperature_change(line_, s, s)));
    for (const auto& [s, change] : line_.temperature_change)
      if (s > from && s < to) largest = std::max(largest, std::abs(change));
    return largest;
  }

  bool check_temperature() {
    const auto& rows = line_.temperature_change;
    if (rows.empty()) return true;
    const std::size_t before = issue.count();
    const std::string key = "temperature_change";
    if (rows.front().first < -kArcTolerance * length_)
      issue(key + "[0]", "arc length {:.6g} m is before end A", rows.front().first);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::string row = fmt::format("{}[{}]", key, i);
      check_arc(rows[i].first, row);
      if (i == 0) continue;
      const std::string fault =
          increase_fault("arc lengths from end A", "m", rows[i - 1].first, rows[i].first);
      if (fault.empty()) continue;
      issue(row, "{}", fault);
      return false;
    }
    bool expands = false;
    double from = 0;
    for (const Section& s : line_.sections) {
      const double alpha = c_.line_type(s.type).thermal_expansion;
      const double largest = largest_change(from, from + s.length);
      from += s.length;
      expands |= alpha != 0;
      if (std::abs(alpha) * largest > kLargestExpansion) {
        issue(key, "by {:g} K '{}' gets a strain of {:.3g} %; the limit is {:g} %", largest, s.type,
              100 * std::abs(alpha) * largest, 100 * kLargestExpansion);
        return false;
      }
    }
    if (!expands)
      issue(key, "none of the line's types has 'thermal_expansion', so it has no effect; give it to '{}'",
            line_.sections.front().type);
    return issue.count() == before;
  }

  const LineType& type_at(double arc) const { return c_.line_type(section_at(line_, arc).type); }

  void check_loads() {
    // Keys number the loads in file order, which `order` keeps.
    for (const DistributedLoad& q : line_.loads) {
      const std::string key = fmt::format("loads[{}]", q.order);
      check_arc(q.from, key + ".from");
      check_arc(q.to, key + ".to");
      if (q.to >= 0 && q.to <= q.from)
        issue(key + ".to", "a load from {:.6g} m to {:.6g} m has no length; 'to' must be above 'from'",
              q.from, q.to);
    }
    for (const PointLoad& p : line_.point_loads) {
      const std::string key = fmt::format("loads[{}]", p.order);
      check_arc(p.at, key + ".at");
      if (!p.moment.isZero(0) && type_at(p.at).kind == LineKind::cable)
        issue(key + ".moment", "a line without bending stiffness cannot carry a moment");
    }
  }

  const Case& c_;
  const Line& line_;
  double length_;
  const Issues issue;
};

}  // namespace

void check_line(const Case& c, const Line& line, const Issues& issue) {
  LineCheck(c, line, issue).run();
  for (const LineEnd line_end : kLineEnds) check_feed(c, line, line_end, issue);
}

}  // namespace hawser::model
