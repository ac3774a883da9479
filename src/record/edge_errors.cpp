// The class EdgeErrors: what the forces of volumes that press on cables have along them, summed along each
// line.
#include "hawser/record/edge_errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/base/gather.hpp"
#include "hawser/record/line_extremes.hpp"

namespace hawser::record {
namespace {

constexpr double kAllowed = 0.005;  // of the tension
constexpr double kInside = 0.3;     // counts of errors within what is pressed
constexpr double kLeft = 0.0025;    // what elements of the recommended length leave
constexpr double kAgain = 5;        // times the reported error is reported again
constexpr double kOfRadius = 0.2;   // elements over a sharp edge: their length by the contact radius
constexpr double kEvenly = 0.5;  // of a turn: where both neighbours turn by so much, the line follows a bend
constexpr double kWide = 0.8;  // rad, that a beam turns within its elements where sqrt(EI/T) is their length
constexpr double kStraight = 1e-4;  // rad

struct Range {
  double low = 0, high = 0;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double width() const { return high - low; }
};

Vec3 vector_of(std::span<const double> values, size_t n) {
  return {values[3 * n], values[3 * n + 1], values[3 * n + 2]};
}

}  // namespace

EdgeErrors::EdgeErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh)
    : comm_(comm),
      case_(c),
      mesh_(mesh),
      cut_(line_owners(mesh).cut),
      neighbours_(static_cast<size_t>(mesh.owned)),
      worst_(mesh.mesh->lines.size()),
      tension_(mesh.mesh->lines.size(), 0),
      reported_(mesh.mesh->lines.size(), 0),
      over_(mesh.mesh->lines.size(), {0, -HUGE_VAL}) {
  for (const LocalElement& l : mesh.elements) {
    const Element& e = mesh.element(l);
    if (e.beam) continue;
    const auto add = [&](int node, int Neighbours::*side, int other) {
      if (node >= mesh.owned) return;
      Neighbours& n = neighbours_[node];
      n.*side = other;
      n.length = std::max(n.length, e.length);
    };
    add(l.first, &Neighbours::after, l.second);
    add(l.second, &Neighbours::before, l.first);
  }
}

// Without friction the forces of a surface are perpendicular to a line that slides on it. Of the straight
// elements of a cable they are perpendicular to each, and so have a part along the line where it turns at a
// node: with t in the middle of both directions, (T_after - T_before) cos(angle/2) + F.t = 0. A surface that
// bears a line end on has such a part as well: no more is counted than a turn can make.
std::vector<EdgeErrors::Turn> EdgeErrors::turns(const Kinematics& at, const Values& v) const {
  std::vector<Turn> out;
  for (size_t n = 0; n < neighbours_.size(); ++n) {
    const Neighbours& beside = neighbours_[n];
    if (beside.before < 0 || beside.after < 0) continue;
    const Vec3 F = vector_of(v.force, n) - vector_of(v.friction, n);
    if (F.isZero(0)) continue;
    const Vec3 a = (at.x[n] - at.x[beside.before]).normalized(),
               b = (at.x[beside.after] - at.x[n]).normalized();
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    const double tension = std::max({v.before[n], v.after[n], 0.0}), most = tension * (1 - std::cos(angle));
    const Vec3 along = (a + b).normalized();
    const double taken =
        angle > kStraight ? std::clamp(F.dot(along) / std::max(std::cos(0.5 * angle), 1e-3), -most, most) : 0;
    out.push_back({mesh_.global[n], angle, taken, tension, beside.length});
  }
  return out;
}

const model::LineType& EdgeErrors::type_at(int node) const {
  const LineSpan& line = mesh_.mesh->lines[mesh_.mesh->nodes[node].line];
  return case_.line_types[mesh_.mesh->elements[line.first_element + node - line.first_node].type];
}

// Adds what other ranks have of lines that the partition cuts.
std::vector<EdgeErrors::Turn> EdgeErrors::with_cut_lines(std::vector<Turn> turns) const {
  if (cut_.empty()) return turns;
  const auto cut = std::stable_partition(turns.begin(), turns.end(), [&](const Turn& t) {
    return !std::binary_search(cut_.begin(), cut_.end(), mesh_.mesh->nodes[t.node].line);
  });
  if (!on_any_rank(comm_, cut != turns.end())) return turns;
  std::vector<double> numbers;
  for (auto t = cut; t != turns.end(); ++t)
    numbers.insert(numbers.end(), {static_cast<double>(t->node), t->angle, t->taken, t->tension, t->length});
  turns.erase(cut, turns.end());
  const std::vector<double> all = gather_all(comm_, numbers);
  for (auto p = all.begin(); p != all.end(); p += 5)
    turns.push_back({static_cast<int>(p[0]), p[1], p[2], p[3], p[4]});
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.node < b.node; });
  return turns;
}

// The tensions on both sides of a volume differ by the sum of what the nodes between them take. Within the
// stretch in contact the errors alternate from element to element, and only a share of them counts.
void EdgeErrors::update(const Kinematics& at, const Values& values) {
  const std::vector<Turn> all = with_cut_lines(turns(at, values));
  for (size_t i = 0; i < all.size();) {
    const int line = mesh_.mesh->nodes[all[i].node].line;
    double sum = 0, most = 0, tension = 0, passage = 0;
    Range outside, inside;
    size_t worst = i;
    for (; i < all.size() && mesh_.mesh->nodes[all[i].node].line == line; ++i) {
      sum += all[i].taken;
      inside.add(sum);
      if (i + 1 == all.size() || all[i + 1].node != all[i].node + 1) outside.add(sum);
      tension = std::max(tension, all[i].tension);
      if (all[i].tension > 0)
        passage = std::max(passage,
                           all[i].length * std::sqrt(type_at(all[i].node).mass_per_length / all[i].tension));
      if (std::abs(all[i].taken) > most) {
        most = std::abs(all[i].taken);
        worst = i;
      }
    }
    tension_[line] = std::max(tension_[line], tension);
    over_[line] = {passage, at.time};
    Worst& w = worst_[line];
    const double error = std::max(outside.width(), kInside * inside.width());
    if (!(error > w.at.error)) continue;
    const Turn& there = all[worst];
    const double before = worst > 0 && all[worst - 1].node == there.node - 1 ? all[worst - 1].angle : 0,
                 after = worst + 1 < all.size() && all[worst + 1].node == there.node + 1
                             ? all[worst + 1].angle
                             : 0;
    w.at = {.error = error,
            .arc = mesh_.mesh->nodes[there.node].arc,
            .time = at.time,
            .turn = there.angle,
            .length = there.length};
    w.turn_of_element = there.angle + std::max(before, after);
    const bool evenly = std::min(before, after) > kEvenly * there.angle;
    w.at.recommended = evenly ? there.length * std::sqrt(kLeft * tension / error)
                              : kOfRadius * 0.5 * type_at(there.node).contact_diameter;
  }
}

std::string EdgeErrors::warning(int line, double largest) const {
  const advice::LongElements& w = worst_[line].at;
  if (!(w.error > kAllowed * largest)) return {};
  const double turned = worst_[line].turn_of_element / kWide;
  return advice::turns_on_edge(mesh_.mesh->lines[line].name, w, largest,
                               largest * w.length * w.length * std::max(turned * turned, 0.25));
}

void EdgeErrors::declare(Declarations& to) {
  const auto needed = [&](const char* name) {
    to.every_step.insert(name);
    return find_field(to.contents.fields, name);
  };
  force_ = needed("contact_force");
  friction_ = needed("friction_force");
  before_ = needed("effective_tension_before");
  after_ = needed("effective_tension_after");
}

void EdgeErrors::step(const Snapshot& s) {
  if (force_ < 0 || friction_ < 0 || before_ < 0 || after_ < 0) return;
  update(s.at, {s.values[force_], s.values[friction_], s.values[before_], s.values[after_]});
  const auto unreported = [&](size_t l) {
    return worst_[l].at.error > kAgain * reported_[l] ? warning(static_cast<int>(l), tension_[l]) : "";
  };
  bool any = false;
  for (size_t l = 0; l < worst_.size() && !any; ++l) any = !unreported(l).empty();
  if (!on_any_rank(comm_, any)) return;
  gather();
  for (size_t l = 0; l < worst_.size(); ++l)
    if (std::string text = unreported(l); !text.empty()) {
      reported_[l] = worst_[l].at.error;
      new_warnings_.push_back(std::move(text));
    }
}

// Puts together what the ranks have so far.
void EdgeErrors::gather() {
  largest_of_ranks(comm_, worst_, [](const Worst& w) { return w.at.error; });
  all_reduce(comm_, MPI_MAX, tension_);
}

std::vector<std::string> EdgeErrors::remarks() { return std::exchange(new_warnings_, {}); }

std::vector<Finding> EdgeErrors::findings(const std::vector<io::SummaryRow>& summary, const Audit&) {
  gather();
  std::vector<Finding> out;
  for (size_t i = 0; i < summary.size(); ++i)
    if (const io::SummaryRow& r = summary[i]; is_largest_tension(case_, r))
      if (std::string text = warning(case_.line_index(r.line), r.value); !text.empty())
        out.push_back({std::move(text), i});
  return out;
}

}  // namespace hawser::record
