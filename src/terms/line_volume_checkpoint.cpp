// The class LineVolumeContact: history of contact in a checkpoint.
//
// Both ranks of a shared element need its history, but a rank reads only the records of its own nodes.
// Therefore the record of an element is stored at both nodes. Keys for the volume v: 2 v at the first node of
// the element, 2 v + 1 at the second. Gap springs are stored likewise, both ends in one record. The sums of
// an element are stored at its first node, the automatic stiffness of each volume at the first node of the
// mesh.
#include <algorithm>
#include <map>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
namespace {

enum Kind { kPoints, kSums, kSprings, kStiffness };

// Automatic stiffness of the volume that is the key of the record.
struct KeptStiffness {
  double stiffness = 0;  // N/m²
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("stiffness", "N/m²", self.stiffness);
  }
};

}  // namespace

std::vector<CheckpointKind> LineVolumeContact::checkpoint_kinds() const {
  return {checkpoint_kind<AxisContactPoint>("points that touch"),
          checkpoint_kind<ContactWork>("sums of an element"), checkpoint_kind<GapSpring>("gap springs"),
          checkpoint_kind<KeptStiffness>("automatic stiffness of a volume")};
}

std::vector<CheckpointRecord> LineVolumeContact::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> records;
  const auto in_range = [&](int n) { return n < mesh_.owned && range.has(mesh_.global[n]); };
  for (int v = 0; mesh_.owns_node(0) && range.has(0) && v < volumes(); ++v)
    if (volumes_.automatic(v)) records.push_back(record_of(0, v, KeptStiffness{stiffness(v)}, kStiffness));
  for (size_t i = 0; i < accounts_.size(); ++i) {
    const LocalElement& e = mesh_.elements[i];
    if (e.counted && in_range(e.first) && !accounts_[i].empty())
      records.push_back(record_of(mesh_.global[e.first], 0, accounts_[i], kSums));
  }
  const auto add = [&](const Pair& pair, Kind kind, const auto& all) {
    const LocalElement& e = local(pair);
    if (!in_range(e.first) && !in_range(e.second)) return;
    CheckpointRecord r;
    r.kind = kind;
    for (const auto& one : all) put(one, r.values);
    for (const int node : {e.first, e.second}) {
      if (!in_range(node)) continue;
      r.node = mesh_.global[node];
      r.key = 2 * pair.volume + (node == e.second);
      records.push_back(r);
    }
  };
  for (const Pair& pair : pairs_) {
    if (!pair.start.points.empty()) add(pair, kPoints, pair.start.points);
    if (finder_.by_gap()) add(pair, kSprings, pair.start.springs);
  }
  return records;
}

void LineVolumeContact::restore(const std::vector<CheckpointRecord>& records) {
  std::unordered_map<int, int> behind, before;  // from mesh node to local element
  for (size_t i = 0; i < mesh_.elements.size(); ++i) {
    behind[mesh_.global[mesh_.elements[i].first]] = static_cast<int>(i);
    before[mesh_.global[mesh_.elements[i].second]] = static_cast<int>(i);
  }
  std::map<std::pair<int, int>, size_t> known;
  pairs_.clear();
  near_.clear();
  accounts_.assign(accounts_.size(), {});
  std::vector<double> stiffness(static_cast<size_t>(volumes()), 0);
  for (const CheckpointRecord& r : records) {
    if (r.kind == kStiffness) {
      stiffness.at(static_cast<size_t>(r.key)) = entry<KeptStiffness>(r).stiffness;
      continue;
    }
    const bool sums = r.kind == kSums;
    const auto& side = !sums && r.key % 2 ? before : behind;
    const auto owner = side.find(r.node);
    if (owner == side.end()) continue;
    if (sums) {
      accounts_[owner->second] = entry<ContactWork>(r);
      continue;
    }
    if (r.key < 0 || r.key / 2 >= volumes())
      throw std::invalid_argument("a contact record of the checkpoint does not fit this case");
    const int element = owner->second;
    const int volume = r.key / 2;
    const auto [at, is_new] = known.insert({{element, volume}, pairs_.size()});
    if (is_new) pairs_.emplace_back();
    Pair& pair = pairs_[at->second];
    pair.element = element;
    pair.volume = volume;
    if (r.kind == kPoints) {
      pair.start.points = entries<AxisContactPoint>(r);
      continue;
    }
    const std::vector<GapSpring> springs = entries<GapSpring>(r);
    if (springs.size() != pair.start.springs.size())
      throw std::invalid_argument("a contact record of the checkpoint does not fit this case");
    std::copy(springs.begin(), springs.end(), pair.start.springs.begin());
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
    return std::pair(a.element, a.volume) < std::pair(b.element, b.volume);
  });
  volumes_.restore(std::move(stiffness));
}

}  // namespace hawser
