// Setup of the force term LinePairs: excluded pairs, ends that share a place, radius and automatic stiffness
// of each element.
#include "hawser/run/line_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "hawser/advice/line_pairs.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/cut_lines.hpp"
#include "hawser/terms/automatic_stiffness.hpp"

namespace hawser::run {
namespace {

// Start of a branch at a held or joined end of a line.
struct BranchStart {
  Vec3 at;  // m, in space
  Branch branch;
  double radius;  // m, contact radius
};

// True if an end is held by the case, not only by a future cut.
bool is_place(const model::Line& line, LineEnd line_end) {
  const model::End& end_of_part = line.end(line_end);
  const model::End& of_given = line.as_given().end(line_end);
  return end_of_part.kind != model::EndKind::free && end_of_part.kind == of_given.kind &&
         end_of_part.carrier == of_given.carrier;
}

std::vector<BranchStart> places_of_lines(const model::Case& c, const Mesh& mesh) {
  std::vector<BranchStart> places;
  for (size_t l = 0; l < c.lines.size(); ++l) {
    const LineSpan& span = mesh.lines[l];
    const model::Line& line = c.lines[l];
    if (!c.contact.takes_part(line)) continue;
    for (const LineEnd end : kLineEnds) {
      if (!is_place(line, end)) continue;
      const model::Section& section = line.end_section(end);
      places.push_back({model::end_position(c, line.end(end)),
                        {span.end_node(end), end == LineEnd::B ? -1 : 1},
                        0.5 * c.line_type(section.type).contact_diameter});
    }
  }
  return places;
}

// Pairs of branches that begin closer to each other than their thickness.
std::vector<SharedPlace> shared_places(const model::Case& c, const Mesh& mesh) {
  std::vector<BranchStart> places = places_of_lines(c, mesh);
  double widest = 0;
  for (const BranchStart& p : places) widest = std::max(widest, 2 * p.radius);
  // Sorted along x, so that only neighbours are compared.
  const auto where = [](const BranchStart& p) {
    return std::tuple(p.at.x(), p.branch.node, p.branch.direction);
  };
  std::sort(places.begin(), places.end(),
            [&](const BranchStart& p, const BranchStart& q) { return where(p) < where(q); });
  std::vector<SharedPlace> out;
  for (size_t i = 0; i < places.size(); ++i)
    for (size_t j = i + 1; j < places.size() && places[j].at.x() - places[i].at.x() <= widest; ++j) {
      const BranchStart& p = places[i];
      const BranchStart& q = places[j];
      if (p.branch.node != q.branch.node && (p.at - q.at).norm() < p.radius + q.radius)
        out.push_back({p.branch, q.branch});
    }
  // Until it is cut a line continues from each part to the next.
  for (const model::GivenLine& given : model::given_lines(c))
    for (int l = given.first + 1; l < given.first + given.parts; ++l)
      if (c.contact.takes_part(c.lines[l]))
        out.push_back({{mesh.lines[l].first_node - 1, -1}, {mesh.lines[l].first_node, 1}});
  return out;
}

// For each line, the first part of the given line that it belongs to; empty: no line is cut.
std::vector<int> first_parts(const model::Case& c) {
  std::vector<int> out;
  const std::vector<model::GivenLine> lines = model::given_lines(c);
  if (lines.size() == c.lines.size()) return out;
  for (const model::GivenLine& given : lines)
    out.insert(out.end(), static_cast<size_t>(given.parts), given.first);
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
                                           std::vector<std::string>& details) {
  const model::BetweenLines& b = c.contact.between_lines;
  if (!b.enabled) return nullptr;
  const std::size_t lines = c.lines.size();
  LinePairOptions options;
  std::vector<bool>& takes_part = options.takes_part;
  for (const model::Line& l : c.lines) takes_part.push_back(c.contact.takes_part(l));
  options.candidates.excluded = excluded_pairs(c);
  const auto taking = static_cast<std::size_t>(std::count(takes_part.begin(), takes_part.end(), true));
  const auto excluded = std::count_if(
      options.candidates.excluded.begin(), options.candidates.excluded.end(),
      [&](const std::pair<int, int>& p) { return takes_part[p.first] && takes_part[p.second]; });
  if (taking * (taking + 1) / 2 == static_cast<std::size_t>(excluded)) return nullptr;
  options.shared = shared_places(c, *mesh.mesh);
  options.first_part = first_parts(c);

  options.general = b.general;
  for (const auto& t : b.pairs)
    options.tuned[ordered(c.line_index(t.first), c.line_index(t.second))] = t.settings;
  // Types of no element that takes part keep a radius of 0.
  std::vector<LinePairType> types(c.line_types.size());
  double smallest = HUGE_VAL, largest = 0;  // N/m², of the types that take part
  for (const EvenPart& e : mesh.mesh->parts()) {
    const model::LineType& t = c.line_types[e.shape->type];
    if (!takes_part[e.line] || !(t.contact_diameter > 0) || types[e.shape->type].radius > 0) continue;
    const double radius = 0.5 * t.contact_diameter;
    types[e.shape->type] = {radius, t.mass_per_length, stiffness_by_weight(t.mass_per_length, radius),
                            cubic_stiffness(t.EA, radius)};
    smallest = std::min(smallest, types[e.shape->type].linear);
    largest = std::max(largest, types[e.shape->type].linear);
  }
  const bool automatic = b.general.basis == model::StiffnessBasis::automatic ||
                         std::any_of(b.pairs.begin(), b.pairs.end(), [](const auto& t) {
                           return t.settings.basis == model::StiffnessBasis::automatic;
                         });
  if (automatic)
    details.push_back(
        advice::chosen_pair_stiffness(smallest, largest, lines == 1 ? c.lines.front().name : "", b.self));
  return std::make_unique<LinePairs>(comm, mesh, std::move(types), std::move(options));
}

std::string shared_places_note(const SharedPlaces& places, const Mesh& mesh) {
  int farthest = -1, others = 0;
  for (int k = 0; k < places.size(); ++k) {
    if (!(places.free_length(k) > CandidateSettings{}.exclusion_diameters * places.diameter(k))) continue;
    others += farthest >= 0;
    if (farthest < 0 || places.free_length(k) > places.free_length(farthest)) farthest = k;
  }
  if (farthest < 0) return "";
  const auto name = [&](const Branch& s) { return mesh.line_names[mesh.node(s.node).line]; };
  const std::string one = name(places.place(farthest).one);
  const std::string other = name(places.place(farthest).other);
  return advice::separate_near_place(one, other, places.free_length(farthest), others);
}

std::optional<advice::HookedLines> hooked_lines(const System& system, const Kinematics& evaluated) {
  const LinePairs* pairs = system.find<LinePairs>();
  if (!pairs) return std::nullopt;
  ActiveContacts contacts;
  pairs->active_contacts(evaluated, contacts);
  const Mesh& mesh = *system.mesh().mesh;
  const std::vector<LineTension> tensions = system.line_tensions(evaluated);

  struct Sum {
    double force = 0, arc = 0, other_arc = 0;  // N, N m, N m
  };
  std::map<std::pair<int, int>, Sum> sums;
  for (const ActiveContact& c : gather_all(system.comm(), contacts)) {
    if (c.line == c.other_line || !(c.force > 0)) continue;
    Sum& sum = sums[{c.line, c.other_line}];
    sum.force += c.force;
    sum.arc += c.force * 0.5 * (c.from + c.to);
    sum.other_arc += c.force * 0.5 * (c.other_from + c.other_to);
  }
  const Sum* largest = nullptr;
  advice::HookedLines out;
  for (const auto& [pair, sum] : sums) {
    if (!(sum.force > std::min(tensions[pair.first].tension, tensions[pair.second].tension))) continue;
    if (largest && sum.force <= largest->force) continue;
    largest = &sum;
    out = {.line = mesh.line_names[pair.first],
           .other = mesh.line_names[pair.second],
           .arc = sum.arc / sum.force,
           .other_arc = sum.other_arc / sum.force};
  }
  return largest ? std::optional(out) : std::nullopt;
}

}  // namespace hawser::run
