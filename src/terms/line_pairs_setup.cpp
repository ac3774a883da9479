// What LinePairs is made from, what it shows and keeps.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/terms/contact_fields.hpp"
#include "hawser/terms/contact_stiffness.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

enum Kind { kPoints, kSums, kDeepest };

// A point that touches, with the elements of its pair and the part of the pair that it is of.
struct PairPoint {
  int first = 0, second = 0, part = 0;
  LinePairHistory point;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("element", "", self.first), each("other element", "", self.second), each("part", "", self.part);
    LinePairHistory::quantities(self.point, each);
  }
};

constexpr auto all = [](const auto&) { return true; };

std::vector<double> radii(const std::vector<LineContactElement>& elements) {
  std::vector<double> r;
  for (const LineContactElement& e : elements) r.push_back(e.radius);
  return r;
}

}  // namespace

double automatic_stiffness(const LinePairOptions::Automatic& a, const LinePairOptions::Automatic& b,
                           double reach) {
  return std::max({a.per_length, b.per_length, crossing_stiffness(std::min(a.crossing, b.crossing), reach)});
}

LinePairs::LinePairs(MPI_Comm comm, const LocalMesh& mesh, std::vector<LineContactElement> elements,
                     LinePairOptions options)
    : mesh_(mesh),
      elements_(std::move(elements)),
      options_(std::move(options)),
      candidates_(comm, mesh, radii(elements_), options_.candidates),
      accounts_(static_cast<size_t>(mesh.owned)) {
  const size_t n = mesh_.mesh->elements.size();
  if (elements_.size() != n || (!options_.automatic.empty() && options_.automatic.size() != n))
    throw std::invalid_argument(
        "contact of lines with lines needs a radius and a stiffness for each element");
  const auto check = [&](const model::LinePairSettings& s) {
    if (s.basis == model::StiffnessBasis::per_point)
      throw std::invalid_argument("the contact stiffness of lines is per length or per area");
    if (s.basis == model::StiffnessBasis::automatic ? options_.automatic.empty() : !(s.normal_stiffness > 0))
      throw std::invalid_argument("contact of lines with lines has no stiffness");
  };
  check(options_.general);
  for (const auto& [lines, s] : options_.tuned) check(s);
}

LinePairLaw LinePairs::law(int a, int b) const {
  const Mesh& m = *mesh_.mesh;
  const size_t i = static_cast<size_t>(a), j = static_cast<size_t>(b);
  const auto tuned = options_.tuned.find(
      {std::min(m.elements[i].line, m.elements[j].line), std::max(m.elements[i].line, m.elements[j].line)});
  const model::LinePairSettings& s = tuned == options_.tuned.end() ? options_.general : tuned->second;
  const LineContactElement &A = elements_[i], &B = elements_[j];
  const double diameter = A.radius + B.radius;  // the mean of the two
  LinePairLaw law;
  law.reach = A.radius + B.radius;
  double share = 1;
  if (s.basis == model::StiffnessBasis::per_area) share = diameter;
  law.normal.stiffness = s.basis == model::StiffnessBasis::automatic
                             ? automatic_stiffness(options_.automatic[i], options_.automatic[j], law.reach)
                             : s.normal_stiffness * share;
  law.normal.smoothing = s.smoothing > 0 ? s.smoothing : 0.001 * diameter;
  law.normal.damping = contact_damping(
      s.relative_damping, law.normal.stiffness,
      A.mass_per_length * B.mass_per_length / std::max(A.mass_per_length + B.mass_per_length, 1e-300));
  law.friction.axial = law.friction.lateral = s.friction;
  law.friction.stiffness = s.shear_stiffness * share;
  law.friction.axial_length = law.friction.lateral_length =
      s.mobilisation_length > 0 ? s.mobilisation_length : 0.01 * diameter;
  return law;
}

AxisEnds LinePairs::ends(const Kinematics& at, int segment) const {
  const ContactSegment& s = this->segment(segment);
  AxisEnds out = element_axis(at, element(s.global), s.first, s.second, settings(s.global).tangent);
  if (fed_end(segment) >= 0) out.length = feeders_->rest(s.global, at, false)->length;
  return out;
}

LinePairs::Rod LinePairs::rod(const Kinematics& at, int segment) const {
  const AxisEnds e = ends(at, segment);
  return {e.x1, e.x2, e.sagitta()};
}

// The neighbour there is on the same line and outside feeders.
bool LinePairs::joint(int element, int end) const {
  const LineSpan& l = mesh_.mesh->lines[static_cast<size_t>(this->element(element).line)];
  if (end ? element + 1 >= l.first_element + l.elements : element <= l.first_element) return false;
  return !candidates_.left_out(end ? element + 1 : element - 1);
}

int LinePairs::touching() const {
  return static_cast<int>(
      std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.counted && p.history; }));
}

double LinePairs::normal_force() const {
  return sum(all, [](const LinePairHistory& h) { return h.normal_force; });
}

double LinePairs::friction_force() const {
  return sum(all, [](const LinePairHistory& h) { return h.friction.norm(); });
}

void LinePairs::fields(FieldRegistry& registry) const {
  add_contact_fields(
      registry,
      {.force = {.name = "line_contact_force", .unit = "N", .carries = true},
       .normal_force =
           {.name = "line_contact_normal_force", .unit = "N", .report = Field::Report::graph, .order = 9},
       .friction = {.name = "line_friction_force", .unit = "N"},
       .penetration = {.name = "line_penetration", .unit = "m", .report = Field::Report::table, .order = 12}},
      [this](const Kinematics&, const ShowPoint& show) {
        const auto put = [&](const ContactSegment& s, double xi, double sign, const LinePairHistory& h) {
          share_at_ends(element(s.global), s.first, s.second, mesh_.owned, xi,
                        [&](int node, double share) { show(node, share, sign * Mat3::Identity(), h); });
        };
        for (const Pair& p : pairs_) {
          if (!p.history) continue;
          const ContactSegment &a = segment(p.a), &b = segment(p.b);
          for (size_t k = 0; k < kParts; ++k)
            for (const LinePairHistory& h : (*p.history)[k])
              put(k < 3 ? a : b, h.xi, 1, h), put(k < 3 ? b : a, h.eta, -1, h);
        }
      });
}

// Every rank that owns a node of a pair needs its history, and a rank gets the records of its own nodes only:
// so it is kept at each node of the pair.
std::vector<HistoryKind> LinePairs::history() const {
  return {history_kind<PairPoint>("points that touch"), history_kind<Account>("sums of a node"),
          history_kind<Deepest>("deepest")};
}

std::vector<HistoryRecord> LinePairs::save() const {
  std::vector<HistoryRecord> records;
  for (int n = 0; n < mesh_.owned; ++n) {
    const Account& a = accounts_[static_cast<size_t>(n)];
    if (a.friction != 0 || a.damping != 0)
      records.push_back(record_of(mesh_.global[static_cast<size_t>(n)], 0, a, kSums));
  }
  if (deepest_.first >= 0) records.push_back(record_of(element(deepest_.first).first, 0, deepest_, kDeepest));
  std::map<int, int> number;  // of records at a node
  for (const Pair& p : pairs_) {
    if (!p.history) continue;
    HistoryRecord r;
    int part = 0;
    for (const auto& points : *p.history) {
      for (const LinePairHistory& h : points) put(PairPoint{p.key.first, p.key.second, part, h}, r.values);
      ++part;
    }
    for (const ContactSegment* s : {&segment(p.a), &segment(p.b)})
      for (const int node : {s->first, s->second}) {
        if (node >= mesh_.owned) continue;
        r.node = mesh_.global[static_cast<size_t>(node)];
        r.key = number[r.node]++;
        records.push_back(r);
      }
  }
  return records;
}

void LinePairs::restore(const std::vector<HistoryRecord>& records) {
  pairs_.clear(), kept_.clear();
  candidates_.forget();
  listed_ = false;
  accounts_.assign(accounts_.size(), {});
  deepest_ = {};
  for (const HistoryRecord& r : records) {
    if (r.kind == kSums) {
      const int n = mesh_.find(r.node);
      if (n >= 0 && n < mesh_.owned) accounts_[static_cast<size_t>(n)] = entry<Account>(r);
      continue;
    }
    if (r.kind == kDeepest) {
      if (const Deepest d = entry<Deepest>(r); d.depth > deepest_.depth) deepest_ = d;
      continue;
    }
    const std::vector<PairPoint> points = entries<PairPoint>(r);
    if (points.empty()) continue;
    const Key key{points.front().first, points.front().second};
    if (kept_.count(key)) continue;  // from another of its nodes
    auto history = std::make_unique<History>();
    for (const PairPoint& p : points) {
      if (p.part < 0 || static_cast<size_t>(p.part) >= history->size())
        throw std::invalid_argument("a record of line-line contact in the checkpoint does not fit");
      (*history)[static_cast<size_t>(p.part)].push_back(p.point);
    }
    kept_[key] = std::move(history);
  }
}

}  // namespace hawser
