// History of contact along lines through a checkpoint.
//
// Both ranks of a shared element need its history, and a rank gets the records of its own nodes only: so an
// element's is kept twice, at either node. Keys: 2 v for the element behind a node, 2 v + 1 for the one
// before it, v the volume, plus the number of volumes for the second of its walls, and so on; -1 for the sums
// of the element behind.
#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "hawser/terms/line_contact.hpp"

namespace hawser {
namespace {

constexpr int kAccount = -1;
constexpr size_t kSums = 7, kPoint = 20;

void put(std::vector<double>& values, const Vec3& v) { values.insert(values.end(), v.begin(), v.end()); }

}  // namespace

std::vector<HistoryRecord> LineContact::save() const {
  std::vector<HistoryRecord> records;
  for (size_t i = 0; i < accounts_.size(); ++i) {
    const Account& a = accounts_[i];
    const LocalElement& e = mesh_.elements[i];
    if (!e.counted || a.empty()) continue;
    records.push_back({mesh_.global[static_cast<size_t>(e.first)],
                       kAccount,
                       {a.friction, a.damping, a.work, a.depth, a.time, static_cast<double>(a.volume),
                        static_cast<double>(a.end)}});
  }
  for (const Pair& pair : pairs_) {
    if (pair.history.empty()) continue;
    HistoryRecord r;
    for (const Point& p : pair.history) {
      r.values.insert(r.values.end(),
                      {p.xi, p.from, p.to, p.weight, p.normal_force, p.damping_force, p.potential, p.gap});
      for (const Vec3* v : {&p.slip, &p.normal, &p.force, &p.friction}) put(r.values, *v);
    }
    const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
    for (const int node : {e.first, e.second}) {
      if (node >= mesh_.owned) continue;
      r.node = mesh_.global[static_cast<size_t>(node)];
      r.key = 2 * (pair.volume + pair.slot * volumes()) + (node == e.second);
      records.push_back(r);
    }
  }
  return records;
}

void LineContact::restore(const std::vector<HistoryRecord>& records) {
  std::unordered_map<int, int> behind, before;  // mesh node -> local element
  for (size_t i = 0; i < mesh_.elements.size(); ++i) {
    behind[mesh_.global[static_cast<size_t>(mesh_.elements[i].first)]] = static_cast<int>(i);
    before[mesh_.global[static_cast<size_t>(mesh_.elements[i].second)]] = static_cast<int>(i);
  }
  std::set<std::array<int, 3>> known;
  pairs_.clear();
  accounts_.assign(accounts_.size(), {});
  for (const HistoryRecord& r : records) {
    const std::vector<double>& v = r.values;
    const auto& side = r.key >= 0 && r.key % 2 ? before : behind;
    const auto found = side.find(r.node);
    if (found == side.end()) continue;
    if (r.key == kAccount) {
      if (v.size() != kSums)
        throw std::invalid_argument("a contact record of the checkpoint has the wrong size");
      accounts_[static_cast<size_t>(found->second)] = {
          v[0], v[1], v[2], v[3], v[4], static_cast<int>(v[5]), static_cast<int>(v[6])};
      continue;
    }
    if (v.size() % kPoint || r.key < 0 || r.key / 2 >= SurfaceWalls::kMost * volumes())
      throw std::invalid_argument("a contact record of the checkpoint does not fit this case");
    const int element = found->second, volume = r.key / 2 % volumes(), slot = r.key / 2 / volumes();
    if (!known.insert({element, volume, slot}).second) continue;  // from its other node
    Pair& pair = pairs_.emplace_back();
    pair.element = element;
    pair.volume = volume;
    pair.slot = slot;
    for (size_t at = 0; at < v.size(); at += kPoint) {
      Point& p = pair.history.emplace_back();
      p.xi = v[at], p.from = v[at + 1], p.to = v[at + 2], p.weight = v[at + 3];
      p.normal_force = v[at + 4], p.damping_force = v[at + 5];
      p.potential = v[at + 6], p.gap = v[at + 7];
      size_t c = at + 8;
      for (Vec3* part : {&p.slip, &p.normal, &p.force, &p.friction})
        for (int k = 0; k < 3; ++k) (*part)[k] = v[c++];
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
    return std::array{a.element, a.volume, a.slot} < std::array{b.element, b.volume, b.slot};
  });
}

}  // namespace hawser
