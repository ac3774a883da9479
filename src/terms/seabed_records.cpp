// History of contact with the seabed through a checkpoint.
//
// Both ranks of a shared element need the history of the point half way along it, and a rank gets the records
// of its own nodes only: so it is kept twice, at either node. Keys: 0 for a node, 1 for the element behind
// it, 2 for the one before it.
#include <map>

#include "hawser/terms/seabed.hpp"

namespace hawser {

std::vector<HistoryKind> SeabedTerm::history() const { return {history_kind<History>("points")}; }

std::vector<HistoryRecord> SeabedTerm::save() const {
  std::vector<HistoryRecord> records;
  for (const Point& p : points_) {
    const History& h = history(p);
    if (!h.active && h.deepest == 0 && h.friction_work == 0 && h.damping_work == 0) continue;
    HistoryRecord r;
    put(h, r.values);
    for (const int node : {p.node, p.second}) {
      if (!mesh_.owns(node)) continue;
      r.node = mesh_.global[node];
      r.key = p.second < 0 ? 0 : node == p.node ? 1 : 2;
      records.push_back(r);
    }
  }
  return records;
}

void SeabedTerm::restore(const std::vector<HistoryRecord>& records) {
  std::map<std::pair<int, int>, size_t> at;  // by node of the mesh and key
  for (size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    histories_[i] = {};
    const auto global = [this](int node) { return mesh_.global[node]; };
    at[{global(p.node), p.second < 0 ? 0 : 1}] = i;
    if (p.second >= 0) at[{global(p.second), 2}] = i;
  }
  for (const HistoryRecord& r : records) {
    const auto found = at.find({r.node, r.key});
    if (found == at.end()) continue;
    histories_[found->second] = entry<History>(r);
  }
}

}  // namespace hawser
