// Consequences of discretisation: attachments whose node is elsewhere because no other is free, masses that
// sink into the bed between the adjacent elements, and bend stiffeners with too few elements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/line_nodes.hpp"

namespace hawser::advice {

using namespace model;

namespace {

constexpr double kApart = 0.1;   // fraction of the element at the place
constexpr double kFewest = 3;    // elements of a stiffener; the curvature at its tip is then 6 % too low
constexpr double kSteel = 7850;  // kg/m³, for a mass without volume
constexpr double kRound = 1e-6;  // tolerance of a number of elements

// Arc lengths of the nodes of a line, m from end A.
using Arcs = std::vector<double>;
Arcs node_arcs(const Line& line, const std::vector<double>& places) {
  Arcs arcs = {0};
  for (const auto& section : element_lengths(line, places))
    for (const double l : section) arcs.push_back(arcs.back() + l);
  return arcs;
}

// Element that contains an arc length [m], and the nearer of its nodes.
struct ElementAt {
  double from = 0, to = 0, node = 0;
  int number = 0;  // of the element along the line
};

ElementAt element_at(const Arcs& arcs, double at) {
  const auto after =
      std::clamp(std::lower_bound(arcs.begin(), arcs.end(), at), arcs.begin() + 1, arcs.end() - 1);
  const double from = *(after - 1);
  const double to = *after;
  return {from, to, at - from < to - at ? from : to, static_cast<int>(after - arcs.begin()) - 1};
}

void warn_of_distance(const Line& line, const Arcs& arcs, double at, const std::string& key,
                      std::vector<InputWarning>& out) {
  const ElementAt p = element_at(arcs, at);
  if (std::abs(p.node - at) > kApart * (p.to - p.from))
    add_warning(out, key, Effect::resolution,
                "the attachment at {:.6g} m of line {} is moved to the nearest node, at {:.6g} m; use "
                "shorter elements, or end a section at {:.6g} m, to have a node there",
                at, line.name, p.node, at);
}

// Horizontal tension [N] of a chain of this weight [N/m] between an end on a level bed and one above; 0: not
// such a line.
double tension_on_bed(const Case& c, const Line& line, double weight) {
  const Seabed& bed = c.environment.seabed;
  if (!is_held(line.end_a) || !is_held(line.end_b) || bed.surface || !line.starts_by_itself()) return 0;
  Vec3 low = end_position(c, line.end_a);
  Vec3 high = end_position(c, line.end_b);
  if (low.z() > high.z()) std::swap(low, high);
  const double h = height_above_bed(bed, high);
  if (height_above_bed(bed, low) > laying_reach(c, line) || !(h > 0)) return 0;
  return std::max(slack_tension(length_of(line), (high - low).head<2>().norm(), h), 0.0) * weight;
}

// On the bed a mass rests on the part of the line that belongs to its node, about one element, independent of
// its own size; it may sink by more than its diameter. Skipped if the bed is out of reach.
void warn_of_sinking(const Case& c, const Line& line, const Arcs& arcs, const PointMass& m,
                     std::vector<InputWarning>& out) {
  const Seabed& bed = c.environment.seabed;
  const Water& w = c.environment.water;
  const double weight = c.environment.gravity * (m.mass - (w.present ? w.density * m.volume : 0));
  if (!bed.present || bed.force_table || weight <= 0 || lowest_reach(c, line) > -0.8 * bed.depth) return;
  const ElementAt p = element_at(arcs, m.at);
  int section = 0;
  for (int before = line.sections.front().elements; p.number >= before;)
    before += line.sections[static_cast<std::size_t>(++section)].elements;
  const LineType& t = c.line_type(line.sections[static_cast<std::size_t>(section)].type);
  const double per_length =
      bed.normal_stiffness * (bed.basis == StiffnessBasis::per_length ? 1 : t.contact_diameter);
  // The mass presses down both adjacent elements, which resist with k d l together, and lifts the nodes
  // beyond, whose weight w l it carries as well. A tension H spreads the load over 2 sqrt(H/k), as for a
  // string on an elastic foundation, if that is longer.
  const double element = p.to - p.from;
  const double line_weight = std::max(c.environment.gravity * mass_in_water(c, t, -HUGE_VAL), 0.0);
  const double bearing = std::max(element, 2 * std::sqrt(tension_on_bed(c, line, line_weight) / per_length));
  const double sinks = (weight + 3 * line_weight * element) / (per_length * bearing);
  const double diameter = std::cbrt(6 / M_PI * (m.volume > 0 ? m.volume : m.mass / kSteel));
  if (sinks > diameter)
    add_warning(out, "lines." + line.name + ".masses", Effect::part,
                "on the seabed, {:.4g} kg at {:.6g} m of line {} penetrates by about {:.2g} m, since the "
                "element of '{}' that carries it is only {:g} m in diameter; add a short section there whose "
                "type has the 'contact_diameter' of the weight",
                m.mass, m.at, line.name, sinks, t.name, t.contact_diameter);
}

void warn_of_stiffener(const Line& line, const Arcs& arcs, std::size_t i, std::vector<InputWarning>& out) {
  const BendStiffener& b = line.bend_stiffeners[i];
  const double last = b.at + (b.towards_a ? -1 : 1) * b.rows.back().first;
  const double total = length_of(line);
  const double from = std::clamp(std::min(b.at, last), 0.0, total);
  const double to = std::clamp(std::max(b.at, last), 0.0, total);
  double elements = 0;
  for (std::size_t n = 1; n < arcs.size(); ++n)
    elements += std::max(std::min(arcs[n], to) - std::max(arcs[n - 1], from), 0.0) / (arcs[n] - arcs[n - 1]);
  if (elements < kFewest - kRound)
    add_warning(out, fmt::format("lines.{}.bend_stiffeners[{}]", line.name, i), Effect::resolution,
                "its {:.3g} m are {:.2g} elements, each with one bending stiffness: use {:g} elements or "
                "more to resolve curvature and moment along it",
                to - from, elements, 2 * kFewest);
}

}  // namespace

void warn_of_elements(const Case& c, std::vector<InputWarning>& out) {
  const auto places = fixed_places(c);
  for (std::size_t l = 0; l < c.lines.size(); ++l) {
    const Line& line = c.lines[l];
    const std::string key = "lines." + line.name;
    const Arcs arcs = node_arcs(line, places[l]);
    for (const PointMass& m : line.masses) {
      warn_of_distance(line, arcs, m.at, key + ".masses", out);
      warn_of_sinking(c, line, arcs, m, out);
    }
    for (const PointLoad& p : line.point_loads)
      warn_of_distance(line, arcs, p.at, fmt::format("{}.loads[{}]", key, p.order), out);
    for (std::size_t i = 0; i < line.bend_stiffeners.size(); ++i) warn_of_stiffener(line, arcs, i, out);
  }
  const auto check_node = [&](const std::string& name, double at, const std::string& key) {
    const Line& line = c.line(name);
    warn_of_distance(line, node_arcs(line, places[static_cast<std::size_t>(c.line_index(name))]), at, key,
                     out);
  };
  for (const Link& l : c.links)
    for (const LinkEnd* e : {&l.end_a, &l.end_b})
      if (!e->line.empty()) check_node(e->line, e->arc, "links." + l.name);
  for (const Body& b : c.bodies)
    if (b.ride && !b.ride->placed_in_space) check_node(b.ride->line, b.ride->at, "bodies." + b.name + ".on");
}

}  // namespace hawser::advice
