// The class LineStructure: checkpoint records. Sums of dissipation, strain increments and
// largest tensions of cables, plastic bending of beams outside and inside feeders.
#include <algorithm>
#include <map>

#include "hawser/terms/line_structure.hpp"

namespace hawser {

size_t LineStructure::Beam::remembered() const {
  return section.plastic ? kBendingPlaces * section.plastic->memory() : 0;
}

namespace {
// Keys by kind: none; mesh element; mesh element; feeder.
enum Kind { kSums, kStretched, kBent, kInside };

struct Sums {
  double power = 0, damping = 0, filtered = 0;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("damping power", "W", self.power);
    each("damping", "J", self.damping);
    each("axial vibration taken out", "J", self.filtered);
  }
};
struct Stretched {
  double strain_increment = 0, largest = 0;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("stretch", "1", self.strain_increment);
    each("largest tension", "N", self.largest);
  }
};
struct Bent {
  double about2 = 0, about3 = 0;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("plastic curvature about 2", "1/m", self.about2);
    each("plastic curvature about 3", "1/m", self.about3);
  }
};
}  // namespace

// The sums of a rank are stored at its first node; only their total over the ranks matters. Strain and
// bending of an element are stored at both nodes, so that every rank with the element finds them.
std::vector<CheckpointKind> LineStructure::checkpoint_kinds() const {
  return {checkpoint_kind<Sums>("sums of a rank"),
          checkpoint_kind<Stretched>("axial vibration and largest tension"),
          checkpoint_kind<Bent>("plastic bending"), checkpoint_kind<Bent>("plastic bending inside a feeder")};
}

std::vector<CheckpointRecord> LineStructure::checkpoint_records(NodeRange range) const {
  if (mesh_.owned == 0) return {};
  std::vector<CheckpointRecord> out;
  const auto in_range = [&](int n) { return n < mesh_.owned && range.has(mesh_.global[n]); };
  if (in_range(0))
    out.push_back(record_of(mesh_.global[0], 0, Sums{power_.value_or(0), damping_, filtered_}, kSums));
  for (const Cable& c : cables_)
    for (const int n : {c.element.first, c.element.second})
      if (in_range(n))
        out.push_back(record_of(mesh_.global[n], c.element.global,
                                Stretched{c.start.strain_increment, c.peak.largest}, kStretched));
  for (const Beam& b : beams_)
    for (const int n : {b.element.first, b.element.second}) {
      if (!b.reference.set || !in_range(n)) continue;
      CheckpointRecord& r = out.emplace_back(CheckpointRecord{mesh_.global[n], b.element.global, {}, kBent});
      r.values.assign(plastic_history_.data() + b.memory,
                      plastic_history_.data() + b.memory + b.remembered());
    }
  for (size_t k = 0; k < fed_.size(); ++k) {
    if (fed_[k].inside.empty()) continue;
    const Element& e = mesh_.mesh->element(feeders_->fed()[k].element);
    for (const int node : {e.first, e.second})
      if (const int n = mesh_.find(node); n >= 0 && in_range(n))
        out.push_back({node, static_cast<int>(k), fed_[k].inside, kInside});
  }
  return out;
}

void LineStructure::restore(const std::vector<CheckpointRecord>& records) {
  power_ = 0.0;
  damping_ = 0;
  filtered_ = 0;
  std::map<int, Stretched> stretched;
  std::map<int, const std::vector<double>*> bent;
  for (const CheckpointRecord& r : records) {
    if (r.kind == kSums) {
      const Sums s = entry<Sums>(r);
      *power_ += s.power;
      damping_ += s.damping;
      filtered_ += s.filtered;
    } else if (r.kind == kStretched) {
      stretched[r.key] = entry<Stretched>(r);
    } else if (r.kind == kBent) {
      bent[r.key] = &r.values;
    } else if (const size_t k = r.key; k < fed_.size() && fed_[k].inside.size() == r.values.size()) {
      fed_[k].inside = r.values;
    }
  }
  for (const Beam& b : beams_) {
    if (!b.section.plastic) continue;
    double* set = plastic_history_.data() + b.memory;
    const size_t size = b.remembered();
    const auto it = bent.find(b.element.global);
    if (it != bent.end() && it->second->size() == size)
      std::copy(it->second->begin(), it->second->end(), set);
    else
      std::fill_n(set, size, 0.0);
  }
  for (Cable& c : cables_) {
    const auto it = stretched.find(c.element.global);
    if (it == stretched.end()) continue;
    c.start.strain_increment = it->second.strain_increment;
    c.peak.largest = it->second.largest;
  }
}

}  // namespace hawser
