// Division of lines that events cut, and of everything else in the case that refers to them.
#include "hawser/model/cut_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/model/check.hpp"

namespace hawser::model {
namespace {

constexpr double kSame = 1e-9;  // fraction of the line's length

// Part of a section between `from` and `to` [m, from its beginning], with the nearest number of elements;
// their lengths stay a geometric series.
Section part_of(const Section& s, double from, double to) {
  const double q = s.elements > 1 ? std::pow(s.grading, 1.0 / (s.elements - 1)) : 1;
  const auto elements_before = [&](double at) {
    const double fraction = at / s.length;
    const double n =
        q == 1 ? fraction * s.elements : std::log1p(fraction * (std::pow(q, s.elements) - 1)) / std::log(q);
    return std::clamp(static_cast<int>(std::lround(n)), 0, s.elements);
  };
  Section out = s;
  out.length = to - from;
  out.elements = std::max(1, elements_before(to) - elements_before(from));
  out.grading = std::pow(q, out.elements - 1);
  return out;
}

// The range [from, to] of a line as a line of its own.
Line part_of(const Line& line, double from, double to, double length) {
  Line out = line;
  out.from = from;
  const bool first = from == 0;
  const bool last = to == length;
  out.sections.clear();
  double start = 0;
  for (const Section& s : line.sections) {
    const double a = std::max(start, from);
    const double b = std::min(start + s.length, to);
    if (b - a > kSame * length)
      out.sections.push_back(b - a < s.length ? part_of(s, a - start, b - start) : s);
    start += s.length;
  }
  // A point on one part; at a cut it belongs to the part before it.
  const auto points = [&](auto& all) {
    std::erase_if(all, [&](const auto& p) { return p.at > to || (p.at <= from && !first); });
    for (auto& p : all) p.at -= from;
  };
  // A range, divided between the parts.
  const auto ranges = [&](auto& all) {
    for (auto& r : all) {
      r.from = std::max(r.from, from) - from;
      r.to = std::min(r.to < 0 ? length : r.to, to) - from;
    }
    std::erase_if(all, [](const auto& r) { return !(r.from < r.to); });
  };
  points(out.masses);
  points(out.point_loads);
  ranges(out.loads);
  ranges(out.buried);
  // In all parts, because one beyond an end of a part may reach into it.
  for (BendStiffener& b : out.bend_stiffeners) b.at -= from;
  for (auto& row : out.temperature_change) row.first -= from;
  if (!first) out.end_a = {};
  if (!last) out.end_b = {};
  return out;
}

class Cuts {
 public:
  explicit Cuts(Case c) : c_(std::move(c)) {}

  Case done() {
    if (std::none_of(c_.events.begin(), c_.events.end(), [](const Event& e) { return e.action.cut >= 0; }))
      return std::move(c_);
    Entries<Line> lines;
    for (const Line& line : c_.lines) divide(line, lines);
    c_.lines = std::move(lines);
    return std::move(c_);
  }

 private:
  void divide(const Line& line, Entries<Line>& to) {
    const double length = length_of(line);
    arcs_ = {0};
    for (const Event& e : c_.events)
      if (e.action.cut >= 0 && e.action.given_line == line.name) arcs_.push_back(e.action.cut);
    std::sort(arcs_.begin(), arcs_.end());
    if (arcs_.size() == 1) return to.push_back(line);
    const auto given = std::make_shared<Line>(line);
    arcs_.push_back(length);
    names_ = {line.name};
    for (std::size_t k = 1; k + 1 < arcs_.size(); ++k) {
      names_.push_back(fmt::format("{} part {}", line.name, k + 1));
      if (std::any_of(c_.lines.begin(), c_.lines.end(),
                      [&](const Line& l) { return l.name == names_.back(); }))
        c_.refuse("lines." + names_.back(),
                  "this is the name of what is beyond the cut of line '{}'; give another", line.name);
    }
    for (std::size_t k = 0; k + 1 < arcs_.size(); ++k) {
      Line part = part_of(line, arcs_[k], arcs_[k + 1], length);
      part.name = names_[k];
      part.given = given;
      if (k > 0) join(to.back(), part);
      to.push_back(std::move(part));
    }
    // The given line gets the nodes of its parts.
    given->sections.clear();
    for (std::size_t k = to.size() - names_.size(); k < to.size(); ++k)
      given->sections.insert(given->sections.end(), to[k].sections.begin(), to[k].sections.end());
    rename(line.name);
  }

  void join(Line& before, Line& after) {
    Joint joint;
    joint.name = after.name;
    joint.rigid = c_.line_type(before.sections.back().type).kind == LineKind::beam &&
                  c_.line_type(after.sections.front().type).kind == LineKind::beam;
    before.end_b.kind = after.end_a.kind = EndKind::joint;
    before.end_b.carrier = after.end_a.carrier = joint.name;
    c_.joints.push_back(std::move(joint));
  }

  // If `line` is the line `name`, replaces it and an arc length on it by the part that contains the point; a
  // cut belongs to the part before it.
  void place(const std::string& name, std::string& line, double& arc) const {
    if (line != name) return;
    std::size_t k = 0;
    while (k + 1 < names_.size() && arc > arcs_[k + 1] + kSame * arcs_.back()) ++k;
    line = names_[k];
    arc -= arcs_[k];
  }

  void rename(const std::string& name) {
    for (Event& e : c_.events) {
      Action& a = e.action;
      if (a.cut >= 0 && a.given_line == name) {
        a.line = names_[std::find(arcs_.begin(), arcs_.end(), a.cut) - arcs_.begin()];
        a.line_end = LineEnd::A;
      } else if (a.line == name && a.line_end == LineEnd::B) {
        a.line = names_.back();
      }
      place(name, e.cause.line, e.cause.arc);
    }
    for (HistoryPoint& h : c_.output.histories) place(name, h.line, h.at);
    for (Link& l : c_.links)
      for (LinkEnd* end : {&l.end_a, &l.end_b}) place(name, end->line, end->arc);
    for (Body& b : c_.bodies)
      if (b.ride) place(name, b.ride->line, b.ride->at);
    for (std::size_t k = 1; k < names_.size(); ++k) {
      if (!c_.contact.all_lines && c_.contact.takes_part(*line_of(name)))
        c_.contact.lines.push_back(names_[k]);
      for (std::size_t i = 0, n = c_.output.clearances.size(); i < n; ++i) {
        Clearance more = c_.output.clearances[i];
        if (more.line != name && more.other_line != name) continue;
        (more.line == name ? more.line : more.other_line) = names_[k];
        more.name += fmt::format(" part {}", k + 1);
        c_.output.clearances.push_back(std::move(more));
      }
      BetweenLines& between = c_.contact.between_lines;
      for (std::size_t i = 0, n = between.exclude.size(); i < n; ++i)
        add(between.exclude, between.exclude[i], name, names_[k]);
      for (std::size_t i = 0, n = between.pairs.size(); i < n; ++i) {
        BetweenLines::Tuned more = between.pairs[i];
        for (std::string* line_name : {&more.first, &more.second})
          if (*line_name == name) {
            *line_name = names_[k];
            between.pairs.push_back(more);
            break;
          }
      }
    }
    BetweenLines& between = c_.contact.between_lines;  // no self-contact: none between the parts
    for (std::size_t k = 1; k < names_.size() && !between.self; ++k)
      for (std::size_t i = 0; i < k; ++i) between.exclude.emplace_back(names_[i], names_[k]);
  }

  static void add(std::vector<std::pair<std::string, std::string>>& to,
                  std::pair<std::string, std::string> pair, const std::string& name,
                  const std::string& part) {
    if (pair.first != name && pair.second != name) return;
    (pair.first == name ? pair.first : pair.second) = part;
    to.push_back(std::move(pair));
  }
  const Line* line_of(const std::string& name) const { return &c_.line(name); }

  Case c_;
  std::vector<double> arcs_;        // m: start of each part, and the length of the line
  std::vector<std::string> names_;  // of the parts
};

}  // namespace

Case with_cuts(Case c) { return Cuts(std::move(c)).done(); }

std::vector<GivenLine> given_lines(const Case& c) {
  std::vector<GivenLine> out;
  for (int l = 0; l < static_cast<int>(c.lines.size()); ++l)
    if (l > 0 && c.lines[l].given && c.lines[l].given == c.lines[l - 1].given)
      ++out.back().parts;
    else
      out.push_back({l, 1});
  return out;
}

}  // namespace hawser::model
