// The class Touchdowns: every rank looks for the first change of contact from either end of its lines; the
// place is found from the few nodes about it. Of lines that the partition cuts the ranks add up what they
// have.
#include "hawser/record/touchdown.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "hawser/base/gather.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/bed_touch.hpp"

namespace hawser::record {
namespace {

constexpr int kAbout = 5;       // nodes about a change of contact: two that lie, three that hang
constexpr double kHeld = 1e-3;  // of the radius: an end held on the bed is there up to round-off
constexpr double kSame = 1e-9;  // of a length: two that differ by less are one
constexpr int kMostTries = 60;

struct Gap {
  double value = 0, slope = 0;  // m; by arc length, of a beam
  Vec3 x = Vec3::Zero();
};

bool lies(double gap) { return gap <= 0; }

// Arc length beyond the node that lies, m, where the straight line of two gaps is zero.
double straight(double lying, double hanging, double length) { return length * lying / (lying - hanging); }

// The same of the cubic with these slopes, by bisection: it changes its sign once at least.
double cubic(double lying, double slope, double hanging, double next_slope, double length) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high), u = 1 - t;
    const double g = u * u * ((1 + 2 * t) * lying + t * length * slope) +
                     t * t * ((1 + 2 * u) * hanging - u * length * next_slope);
    (lies(g) ? low : high) = t;
  }
  return 0.5 * (low + high) * length;
}

// A change of contact: `first` lies, the node after it in direction `way` (1: to end B, -1) hangs.
struct Change {
  int first = -1, way = 1;
};

struct About {
  std::array<Gap, kAbout> gap;                        // two that lie, three that hang
  std::array<double, kAbout> arc;                     // m, growing away from what lies
  std::array<bool, kAbout> there, inside, two_sided;  // on the line; no end of it; of two types
};

// Rise over run of the chord of two nodes, to the bed.
double steepness(const Gap& a, const Gap& b) {
  const double rise = b.value - a.value, length2 = (b.x - a.x).squaredNorm();
  return rise / std::sqrt(std::max(length2 - rise * rise, 1e-12 * length2));
}

// m, how far ground that yields carries a line beyond s0, seen from a node `behind` s0 that lies `deep` [m]
// in it: l of deep = bend l² (1 - exp(-(behind + l) / l)), which grows with l. Newton's iteration, which
// stays between what is known to be too short and too long.
double carried(double deep, double behind, double bend) {
  double low = std::max(0.0, -behind), high = HUGE_VAL;
  if (!(deep > 0)) return low;
  double l = low + std::sqrt(deep / bend), step = HUGE_VAL;
  for (int i = 0; i < kMostTries && std::abs(step) > kSame * l; ++i) {
    const double e = std::exp(-(behind + l) / l), off = bend * l * l * (1 - e) - deep;
    (off < 0 ? low : high) = l;
    step = -off / (bend * (2 * l * (1 - e) - behind * e));
    const double to = l + step;
    l = to >= low && to <= high ? to : high < HUGE_VAL ? 0.5 * (low + high) : 2 * l;
  }
  return l;
}

// m beyond the last node that lies.
double beyond(const About& n, bool beam) {
  const double length = n.arc[2] - n.arc[1];
  if (beam) return cubic(n.gap[1].value, n.gap[1].slope, n.gap[2].value, n.gap[2].slope, length);
  // The second chord that hangs is the first that nothing of the bed acts on.
  for (const size_t k : {size_t{2}, size_t{1}}) {
    if (k + 2 >= n.there.size() || !n.there[k + 2] || n.two_sided[k + 1] || lies(n.gap[k + 2].value))
      continue;
    const double m1 = 0.5 * (n.arc[k] + n.arc[k + 1]), m2 = 0.5 * (n.arc[k + 1] + n.arc[k + 2]);
    const double t1 = steepness(n.gap[k], n.gap[k + 1]), t2 = steepness(n.gap[k + 1], n.gap[k + 2]);
    const double bend = (t2 - t1) / (m2 - m1);
    if (!(bend > 0)) continue;
    const double s0 = m1 - t1 / bend;
    // The last node that lies but one, unless it is an end, which is held.
    const size_t from = n.there[0] && n.inside[0] && lies(n.gap[0].value) ? 0 : 1;
    const double s = s0 + carried(-n.gap[from].value, s0 - n.arc[from], bend) - n.arc[1];
    return std::clamp(s, n.there[0] ? 0.5 * (n.arc[0] - n.arc[1]) : 0.0, length);
  }
  return straight(n.gap[1].value, n.gap[2].value, length);
}

TouchdownPoint place(const About& n, double s, double arc) {
  const size_t k = s < 0 ? 0 : 1;  // between nodes k and k + 1
  const double t = (n.arc[1] + s - n.arc[k]) / (n.arc[k + 1] - n.arc[k]);
  return {arc, n.gap[k].x + t * (n.gap[k + 1].x - n.gap[k].x)};
}

}  // namespace

Touchdowns::Touchdowns(MPI_Comm comm, const model::Case& c, const LocalMesh& local)
    : comm_(comm), bed_(c.environment.seabed), normal_(model::bed_normal(bed_)), local_(local) {
  if (!bed_.present) return;
  const Mesh& mesh = *local.mesh;
  const LineOwners owners = line_owners(local);
  cut_ = owners.cut.size();
  lines_ = owners.cut;
  lines_.insert(lines_.end(), owners.uncut.begin(), owners.uncut.end());
  slot_.assign(mesh.lines.size(), -1);
  for (size_t k = 0; k < lines_.size(); ++k) slot_[lines_[k]] = static_cast<int>(k);
  std::sort(lines_.begin(), lines_.end());
  std::vector<double> touching;  // by line type
  for (const model::LineType& t : c.line_types) touching.push_back(model::touching_height(c, t));
  heights_.resize(local.chain);
  for (size_t k = 0; k < heights_.size(); ++k) {
    const int global = local.global[k];
    const Node& n = mesh.nodes[global];
    if (n.body >= 0) continue;
    const LineSpan& span = mesh.lines[n.line];
    const int i = global - span.first_node;
    Height& h = heights_[k];
    h.end = i == 0 || i == span.nodes - 1;
    for (const int e : {i - 1, i})
      if (e >= 0 && e < span.elements) {
        const Element& element = mesh.elements[span.first_element + e];
        h.touching = std::max(h.touching, touching[element.type]);
      }
  }
}

Touchdowns::Above Touchdowns::above(size_t n, const Kinematics& at) const {
  Above out{normal_.dot(at.x[n] + Vec3(0, 0, bed_.depth)), normal_};
  if (bed_.surface) {
    const auto near = bed_.surface->query(at.x[n], std::numeric_limits<double>::infinity());
    out = near ? Above{near->distance, near->normal} : Above{HUGE_VAL, normal_};
  }
  const Height& h = heights_[n];
  out.gap -= h.touching;
  if (h.end && out.gap > 0 && out.gap < kHeld * h.touching) out.gap = 0;
  return out;
}

std::vector<Touchdown> Touchdowns::find(const Kinematics& at) const {
  const LocalMesh& local = local_;
  const Mesh& mesh = *local.mesh;
  const size_t lines = lines_.size();
  std::vector<Touchdown> out;
  if (!bed_.present) return out;
  // Puts together what ranks have of lines that are cut, of which each has so many numbers.
  const auto join = [&](MPI_Op op, auto& of, size_t numbers) {
    if (cut_ == 0) return;
    auto cut = std::span(of).first(cut_ * numbers);
    all_reduce(comm_, op, cut);
  };
  std::vector<double> gap(heights_.size());
  for (size_t n = 0; n < gap.size(); ++n)
    if (mesh.nodes[local.global[n]].body < 0) gap[n] = above(n, at).gap;

  // First element from A, and minus the first from B, in which contact changes; what lies.
  std::vector<int> first(2 * lines, std::numeric_limits<int>::max());
  std::vector<double> laid(lines, 0);
  for (const LocalElement& e : local.elements) {
    if (!e.counted) continue;
    const Element& g = mesh.elements[e.global];
    const size_t l = slot_[g.line];
    const double a = gap[e.first], b = gap[e.second];
    if (lies(a) && lies(b)) laid[l] += g.length;
    if (lies(a) == lies(b)) continue;
    laid[l] += lies(a) ? straight(a, b, g.length) : straight(b, a, g.length);
    first[2 * l] = std::min(first[2 * l], e.global);
    first[2 * l + 1] = std::min(first[2 * l + 1], -e.global);
  }
  join(MPI_MIN, first, 2);
  join(MPI_SUM, laid, 1);

  // Gap and slope, then place of the nodes about each. The first sum shows which of its two nodes lies.
  std::vector<double> rows(2 * lines * 2 * kAbout * 5, 0);
  const auto row = [&](size_t k, int i) {
    return rows.data() + 5 * (2 * kAbout * k + static_cast<size_t>(i));
  };
  for (size_t k = 0; k < 2 * lines; ++k) {
    if (first[k] == std::numeric_limits<int>::max()) continue;
    const Element& e = mesh.elements[std::abs(first[k])];
    const LineSpan& span = mesh.lines[e.line];
    for (int i = 0; i < 2 * kAbout; ++i) {  // from four nodes before the element's first one to five after
      const int global = e.first - kAbout + 1 + i;
      if (global < span.first_node || global >= span.first_node + span.nodes) continue;
      const int n = local.find(global);
      if (!local.owns(n)) continue;
      const size_t node = n;
      const Vec3& x = at.x[node];
      const double slope = local.rotates(n) ? above(node, at).normal.dot(at.q[node] * Vec3::UnitX()) : 0;
      const double values[] = {gap[node], slope, x.x(), x.y(), x.z()};
      std::copy(std::begin(values), std::end(values), row(k, i));
    }
  }
  join(MPI_SUM, rows, 2 * 2 * kAbout * 5);

  // The point of the change of contact k; adds to what lies what the straight line of two gaps does not show.
  const auto point = [&](size_t k) -> std::optional<TouchdownPoint> {
    if (first[k] == std::numeric_limits<int>::max()) return {};
    const Element& e = mesh.elements[std::abs(first[k])];
    const LineSpan& span = mesh.lines[e.line];
    const bool up = lies(row(k, kAbout - 1)[0]);  // the node towards A lies
    const Change change{up ? e.first : e.second, up ? 1 : -1};
    About n{};
    for (int i = 0; i < kAbout; ++i) {
      const int global = change.first + change.way * (i - 1);
      n.there[i] = global >= span.first_node && global < span.first_node + span.nodes;
      if (!n.there[i]) continue;
      n.inside[i] = global != span.first_node && global != span.first_node + span.nodes - 1;
      const Node& node = mesh.nodes[global];
      const double* v = row(k, global - e.first + kAbout - 1);
      n.gap[i] = {v[0], change.way * v[1], Vec3(v[2], v[3], v[4])};
      n.arc[i] = change.way * node.arc;
      n.two_sided[i] = node.two_sided;
    }
    const double s = beyond(n, e.beam);
    laid[k / 2] += s - straight(n.gap[1].value, n.gap[2].value, n.arc[2] - n.arc[1]);
    return place(n, s, std::clamp(mesh.nodes[change.first].arc + change.way * s, 0.0, span.length));
  };
  for (const int line : lines_) {
    const size_t k = slot_[line];
    Touchdown& t = out.emplace_back();
    t.line = line;
    t.from_a = point(2 * k);
    const bool same = first[2 * k + 1] == -first[2 * k];
    t.from_b = same ? t.from_a : point(2 * k + 1);
    t.laid = std::clamp(laid[k], 0.0, mesh.lines[line].length);
  }
  return out;
}

std::vector<Touchdown> Touchdowns::of_all_lines(const Kinematics& at) const {
  constexpr size_t kPoint = 5;  // numbers: whether there is one, arc length, position
  std::vector<double> all(local_.mesh->lines.size() * (2 * kPoint + 1), 0);
  for (const Touchdown& t : find(at)) {
    if (!owns_line(local_, t.line)) continue;
    double* to = all.data() + static_cast<size_t>(t.line) * (2 * kPoint + 1);
    for (const auto& p : {t.from_a, t.from_b}) {
      if (p) {
        to[0] = 1;
        to[1] = p->arc;
        std::copy(p->position.begin(), p->position.end(), to + 2);
      }
      to += kPoint;
    }
    *to = t.laid;
  }
  all_reduce(comm_, MPI_SUM, all);
  std::vector<Touchdown> out;
  for (const double* from = all.data(); from != all.data() + all.size(); from += 2 * kPoint + 1) {
    Touchdown& t = out.emplace_back();
    t.line = static_cast<int>(out.size()) - 1;
    if (from[0] > 0) t.from_a = {from[1], Vec3(from + 2)};
    if (from[kPoint] > 0) t.from_b = {from[kPoint + 1], Vec3(from + kPoint + 2)};
    t.laid = from[2 * kPoint];
  }
  return out;
}

}  // namespace hawser::record
