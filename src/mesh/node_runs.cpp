// Runs of nodes from the parts of the mesh.
#include "node_runs.hpp"

#include <algorithm>

namespace hawser {
namespace {

class RunsOfNodes {
 public:
  explicit RunsOfNodes(const Mesh& mesh) : special_(mesh.special_nodes()) {}
  // Appends nodes up to `end` that follow from their elements, except special ones.
  void append(int end, int line, bool rotates) {
    while (at_ < end) {
      if (next_ < special_.size() && special_[next_].first == at_) {
        add_special();
        continue;
      }
      const int to = next_ < special_.size() ? std::min(end, special_[next_].first) : end;
      NodeRun* last = out.empty() ? nullptr : &out.back();
      if (last && !last->special && last->line == line && last->rotates == rotates)
        last->nodes += to - at_;
      else
        out.push_back({at_, to - at_, line, rotates});
      at_ = to;
    }
  }
  void add_special() {
    const auto& [n, node] = special_[next_++];
    out.push_back({n, 1, node.line, node.rotates, &node});
    at_ = n + 1;
  }
  bool more() const { return next_ < special_.size(); }

  std::vector<NodeRun> out;

 private:
  std::span<const std::pair<int, Node>> special_;
  size_t next_ = 0;  // of special_
  int at_ = 0;       // node
};

}  // namespace

std::vector<NodeRun> node_runs(const Mesh& mesh) {
  RunsOfNodes runs(mesh);
  const std::span<const EvenPart> parts = mesh.parts();
  for (size_t i = 0; i < parts.size(); ++i) {
    const EvenPart& p = parts[i];
    const bool goes_on = i > 0 && parts[i - 1].line == p.line;
    const bool ends = i + 1 == parts.size() || parts[i + 1].line != p.line;
    runs.append(p.first_node + 1, p.line, p.shape->beam || (goes_on && parts[i - 1].shape->beam));
    runs.append(p.first_node + p.elements, p.line, p.shape->beam);
    if (ends) runs.append(p.first_node + p.elements + 1, p.line, p.shape->beam);
  }
  while (runs.more()) runs.add_special();
  return std::move(runs.out);
}

}  // namespace hawser
