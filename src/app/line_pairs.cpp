// From the case to the force term LinePairs: which pairs of lines are excluded, which ends meet at one point,
// radius and automatic stiffness of each element.
#include "hawser/app/line_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "hawser/math/ordered.hpp"
#include "hawser/model/check.hpp"
#include "hawser/terms/automatic_stiffness.hpp"

namespace hawser::app {
namespace {

// An end of a line that is held, and where the line goes from there: its other end, as long as nothing is
// cut.
struct Place {
  const model::End *end, *other;  // null: this end is a cut to come
  int node;
  double diameter, length;  // m, of contact; of the line
};

Place place(const model::Case& c, const model::Line& line, bool at_a, const LineSpan& span) {
  const model::Line& all = line.whole ? *line.whole : line;
  const auto pick = [at_a](const model::Line& l, bool other) { return at_a != other ? &l.end_a : &l.end_b; };
  const model::End *own = pick(line, false), *here = pick(all, false);
  const bool cut = own->kind != here->kind || own->body != here->body || own->at != here->at;
  double length = 0;
  for (const model::Section& s : all.sections) length += s.length;
  const model::Section& section = at_a ? line.sections.front() : line.sections.back();
  return {own, cut ? nullptr : pick(all, true), at_a ? span.first_node : span.first_node + span.nodes - 1,
          c.line_type(section.type).contact_diameter, length};
}

// Round lines that part at an angle from one point overlap near it: so far along both together [m] that with
// half of the angle between their chords they would be clear of each other. Half, since lines that sag, or
// are pulled together, part at less than their chords do. 0 where one ends free, and where this would be more
// than half of the shorter line: such lines lie side by side, or are twisted, and touch.
double overlap(const model::Case& c, const Place& p, const Place& q) {
  for (const Place* x : {&p, &q})
    if (!x->other || x->other->kind == model::EndKind::free) return 0;
  const auto chord = [&c](const Place& x) -> Vec3 {
    return (model::end_position(c, *x.other) - model::end_position(c, *x.end)).stableNormalized();
  };
  const Vec3 u = chord(p), v = chord(q);
  const double angle = 2 * std::atan2((u - v).norm(), (u + v).norm());
  const double both = 0.5 * (p.diameter + q.diameter) / std::max(std::sin(angle / 4), 1e-9);
  return both < 0.5 * std::min(p.length, q.length) ? both : 0;
}

// Ends of two lines at one place of one body, or of space: one point for what is near along the lines.
std::vector<CandidateSettings::Joined> joined_ends(const model::Case& c, const Mesh& mesh) {
  std::vector<Place> places;
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const bool at_a : {true, false}) places.push_back(place(c, c.lines[l], at_a, mesh.lines[l]));
  std::erase_if(places, [](const Place& p) { return p.end->kind == model::EndKind::free; });
  double widest = 0;
  for (const Place& p : places) widest = std::max(widest, p.diameter);
  // Along x of one body, so that each looks at those beside it only.
  const auto where = [](const Place& p) { return std::tie(p.end->kind, p.end->body, p.end->at.x(), p.node); };
  std::sort(places.begin(), places.end(),
            [&](const Place& p, const Place& q) { return where(p) < where(q); });
  std::vector<CandidateSettings::Joined> out;
  for (size_t i = 0; i < places.size(); ++i)
    for (size_t j = i + 1; j < places.size(); ++j) {
      const Place &p = places[i], &q = places[j];
      if (p.end->kind != q.end->kind || p.end->body != q.end->body || q.end->at.x() - p.end->at.x() > widest)
        break;
      if (p.other != q.end && (p.end->at - q.end->at).norm() < 0.5 * (p.diameter + q.diameter))
        out.push_back({std::min(p.node, q.node), std::max(p.node, q.node), overlap(c, p, q)});
    }
  return out;
}

}  // namespace

std::vector<std::pair<int, int>> excluded_pairs(const model::Case& c) {
  const model::BetweenLines& b = c.contact.between_lines;
  std::set<std::pair<int, int>> out;
  for (const auto& [x, y] : b.exclude) out.insert(ordered(c.line_index(x), c.line_index(y)));
  for (int l = 0; l < static_cast<int>(c.lines.size()) && !b.self; ++l) out.emplace(l, l);
  return {out.begin(), out.end()};
}

std::unique_ptr<LinePairs> make_line_pairs(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                           std::vector<std::string>& notes) {
  const model::BetweenLines& b = c.contact.between_lines;
  if (!b.enabled) return nullptr;
  const int lines = static_cast<int>(c.lines.size());
  std::vector<bool> takes_part;
  for (const model::Line& l : c.lines) takes_part.push_back(c.contact.takes_part(l));
  LinePairOptions options;
  options.candidates.excluded = excluded_pairs(c);
  const auto& excluded = options.candidates.excluded;
  size_t pairs = 0, wanted = 0;
  for (int i = 0; i < lines; ++i)
    for (int j = i; j < lines && takes_part[i]; ++j)
      if (takes_part[j])
        ++pairs, wanted += !std::binary_search(excluded.begin(), excluded.end(), std::pair(i, j));
  if (wanted == 0) return nullptr;
  options.candidates.joined = joined_ends(c, *mesh.mesh);

  options.general = b.general;
  for (const auto& t : b.pairs)
    options.tuned[ordered(c.line_index(t.first), c.line_index(t.second))] = t.settings;
  std::vector<LineContactElement> elements;
  elements.reserve(mesh.mesh->elements.size()), options.automatic.reserve(mesh.mesh->elements.size());
  // Of each type that takes part, of its lines: the least and the most.
  struct Kind {
    double radius = 0;
    LinePairOptions::Automatic least{HUGE_VAL, HUGE_VAL}, most;
  };
  std::map<int, Kind> kinds;
  for (const Element& e : mesh.mesh->elements) {
    const model::LineType& t = c.line_types[e.type];
    LineContactElement& element = elements.emplace_back();
    if (takes_part[e.line]) element.radius = 0.5 * t.contact_diameter;
    element.mass_per_length = t.mass_per_length;
    StiffnessDemand d;
    d.radius = 0.5 * t.contact_diameter;
    d.weight = t.mass_per_length * c.environment.gravity;
    d.length = mesh.mesh->lines[e.line].length;
    d.EA = t.EA;
    options.automatic.push_back(
        {automatic_contact_stiffness(d).per_length, crossing_force(t.EA, d.weight * d.length)});
    if (!(element.radius > 0)) continue;
    const LinePairOptions::Automatic& a = options.automatic.back();
    Kind& kind = kinds[e.type];
    kind.radius = element.radius;
    kind.least = {std::min(kind.least.per_length, a.per_length), std::min(kind.least.crossing, a.crossing)};
    kind.most = {std::max(kind.most.per_length, a.per_length), std::max(kind.most.crossing, a.crossing)};
  }
  const bool automatic = b.general.basis == model::StiffnessBasis::automatic ||
                         std::any_of(b.pairs.begin(), b.pairs.end(), [](const auto& t) {
                           return t.settings.basis == model::StiffnessBasis::automatic;
                         });
  if (automatic) {
    double least = HUGE_VAL, most = 0;
    for (const auto& [first, i] : kinds)
      for (const auto& [second, j] : kinds) {
        least = std::min(least, automatic_stiffness(i.least, j.least, i.radius + j.radius));
        most = std::max(most, automatic_stiffness(i.most, j.most, i.radius + j.radius));
      }
    notes.push_back(
        fmt::format("contact {}: a normal stiffness of {} N/m per m, chosen by weight and EA. "
                    "contact.between_lines.normal_stiffness sets another, and contact.between_lines: false "
                    "leaves such contact out",
                    lines == 1 ? fmt::format("of line {} with itself", c.lines.front().name)
                    : b.self   ? "between lines and of lines with themselves"
                               : "between lines",
                    most > least * (1 + 1e-9) ? fmt::format("{:.3g} to {:.3g}", least, most)
                                              : fmt::format("{:.3g}", most)));
  }
  return std::make_unique<LinePairs>(comm, mesh, std::move(elements), std::move(options));
}

}  // namespace hawser::app
