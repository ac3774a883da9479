// The class LinePairs: checkpoint records.
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

enum Kind { kPoints, kSums, kDeepest, kShared };

// Contact point with the elements of its pair and its pass (LinePairs::kPassKinds).
struct PairPoint {
  int first = 0, second = 0, pass = 0;
  LinePairContactPoint point;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("element", "", self.first);
    each("other element", "", self.second);
    each("part", "", self.pass);
    LinePairContactPoint::quantities(self.point, each);
  }
};

}  // namespace

// Every rank that owns a node of a pair needs its history, but receives only the records of its own nodes.
// Therefore the history is stored at each node of the pair.
std::vector<CheckpointKind> LinePairs::checkpoint_kinds() const {
  return {checkpoint_kind<PairPoint>("points that touch"), checkpoint_kind<Account>("sums of a node"),
          checkpoint_kind<Deepest>("deepest"), checkpoint_kind<SharedPlaces::Kept>("shared places")};
}

std::vector<CheckpointRecord> LinePairs::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> records;
  const auto in_range = [&](int n) { return n < mesh_.owned && range.has(mesh_.global[n]); };
  for (int n = 0; n < mesh_.owned; ++n) {
    const Account& a = accounts_[n];
    if (in_range(n) && (a.friction != 0 || a.damping != 0))
      records.push_back(record_of(mesh_.global[n], 0, a, kSums));
  }
  if (deepest_.first >= 0 && range.has(mesh_.mesh->element(deepest_.first).first))
    records.push_back(record_of(mesh_.mesh->element(deepest_.first).first, 0, deepest_, kDeepest));
  for (int k = 0; k < shared_.size(); ++k)
    if (const int n = shared_.place(k).one.node; mesh_.owns_node(n) && range.has(n))
      records.push_back(record_of(n, k, shared_.kept(k), kShared));
  std::map<int, int> number;  // number of records at a node
  for (const Pair& p : pairs_) {
    if (!p.points) continue;
    const ContactSegment& a = segment(p.a);
    const ContactSegment& b = segment(p.b);
    const std::array nodes{a.first, a.second, b.first, b.second};
    if (std::none_of(nodes.begin(), nodes.end(), in_range)) continue;
    CheckpointRecord r;
    int pass = 0;
    for (const auto& points : *p.points) {
      for (const LinePairContactPoint& h : points)
        put(PairPoint{p.key.first, p.key.second, pass, h}, r.values);
      ++pass;
    }
    for (const int node : nodes) {
      if (!in_range(node)) continue;
      r.node = mesh_.global[node];
      r.key = number[r.node]++;
      records.push_back(r);
    }
  }
  return records;
}

void LinePairs::restore(const std::vector<CheckpointRecord>& records) {
  pairs_.clear();
  kept_.clear();
  candidates_.forget();
  shared_.forget();
  listed_ = false;
  accounts_.assign(accounts_.size(), {});
  deepest_ = {};
  for (const CheckpointRecord& r : records) {
    if (r.kind == kSums) {
      const int n = mesh_.find(r.node);
      if (mesh_.owns(n)) accounts_[n] = entry<Account>(r);
      continue;
    }
    if (r.kind == kDeepest) {
      if (const Deepest d = entry<Deepest>(r); d.depth > deepest_.depth) deepest_ = d;
      continue;
    }
    if (r.kind == kShared) {
      shared_.restore(entry<SharedPlaces::Kept>(r));
      continue;
    }
    const std::vector<PairPoint> points = entries<PairPoint>(r);
    if (points.empty()) continue;
    const Key key{points.front().first, points.front().second};
    if (kept_.count(key)) continue;  // already read from another node of the pair
    auto by_pass = std::make_unique<ContactPoints>();
    for (const PairPoint& p : points) {
      if (p.pass < 0 || static_cast<size_t>(p.pass) >= by_pass->size())
        throw std::invalid_argument("a record of line-line contact in the checkpoint does not fit");
      (*by_pass)[p.pass].push_back(p.point);
    }
    kept_[key] = std::move(by_pass);
  }
}

}  // namespace hawser
