// The class BedContact: checkpoint records.
//
// Both ranks of a shared element need the contact point at its middle, but a rank reads only the records of
// its own nodes. Therefore the record is stored at both nodes. Keys: 0 for a node, 1 at the first node of the
// element, 2 at the second.
#include <map>

#include "hawser/terms/bed_contact.hpp"

namespace hawser {

std::vector<CheckpointKind> BedContact::checkpoint_kinds() const {
  return {checkpoint_kind<PointHistory>("points"), checkpoint_kind<Account>("sums of a rank")};
}

std::vector<CheckpointRecord> BedContact::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> records;
  for (const Point& p : points_) {
    if (p.history_index < 0) continue;
    for (const int node : {p.node, p.second})
      if (mesh_.owns(node) && range.has(mesh_.global[node]))
        records.push_back(record_of(mesh_.global[node],
                                    p.second < 0     ? 0
                                    : node == p.node ? 1
                                                     : 2,
                                    history(p)));
  }
  if (mesh_.owned > 0 && range.has(mesh_.global[0]))
    records.push_back(record_of(mesh_.global[0], 0, account_, 1));
  return records;
}

void BedContact::restore(const std::vector<CheckpointRecord>& records) {
  std::map<std::pair<int, int>, size_t> at;  // by mesh node and key
  for (size_t i = 0; i < points_.size(); ++i) {
    Point& p = points_[i];
    p.history_index = -1;
    const auto global = [this](int node) { return mesh_.global[node]; };
    at[{global(p.node), p.second < 0 ? 0 : 1}] = i;
    if (p.second >= 0) at[{global(p.second), 2}] = i;
  }
  histories_.clear();
  vacant_.clear();
  account_ = {};
  for (const CheckpointRecord& r : records) {
    if (r.kind == 1) {
      const Account sum = entry<Account>(r);
      account_.friction += sum.friction;
      account_.damping += sum.damping;
      continue;
    }
    const auto found = at.find({r.node, r.key});
    if (found == at.end()) continue;
    store(points_[found->second], entry<PointHistory>(r));
  }
}

}  // namespace hawser
