// Groups of lines that share a joint or overlap in plan (a sweep over their boxes), and notes of all ranks in
// one order.
#include "start_share.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/math/disjoint_sets.hpp"

namespace hawser {
namespace {

// Sweep along x over the beginnings of the boxes. Boxes that have not ended yet are stored as disjoint
// intervals of y; a box that overlaps some of them is merged with them into one interval.
void unite_overlapping(const std::vector<Box>& boxes, DisjointSets& group) {
  std::vector<int> order;
  for (size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].empty()) order.push_back(static_cast<int>(i));
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return std::pair(boxes[i].lo.x(), i) < std::pair(boxes[j].lo.x(), j); });
  struct Open {
    double from, ends;  // m, along y; m, along x
    int line;
  };
  std::map<double, Open> open;  // by where they end along y
  for (const int i : order) {
    Open now{boxes[i].lo.y(), boxes[i].hi.x(), i};
    double to = boxes[i].hi.y();
    for (auto at = open.lower_bound(now.from); at != open.end() && at->second.from <= to;) {
      if (at->second.ends >= boxes[i].lo.x()) {
        group.unite(at->second.line, i);
        now.from = std::min(now.from, at->second.from);
        now.ends = std::max(now.ends, at->second.ends);
        to = std::max(to, at->first);
      }
      at = open.erase(at);
    }
    open[to] = now;
  }
}

void unite_joined(const model::Case& c, const std::vector<model::GivenLine>& lines, DisjointSets& group) {
  std::unordered_map<std::string, int> first;  // line at each joint
  for (int g = 0; g < static_cast<int>(lines.size()); ++g)
    for (int l = lines[g].first; l < lines[g].first + lines[g].parts; ++l)
      for (const LineEnd end : kLineEnds)
        if (const model::End& e = c.lines[l].end(end); e.kind == model::EndKind::joint)
          group.unite(first.try_emplace(e.carrier, g).first->second, g);
}

}  // namespace

std::vector<bool> with_groups(const model::Case& c, const std::vector<model::GivenLine>& lines,
                              const std::vector<Box>& boxes, const std::vector<bool>& required) {
  DisjointSets group(lines.size());
  unite_overlapping(boxes, group);
  unite_joined(c, lines, group);
  std::vector<bool> group_is_required(lines.size(), false);  // by the first line of a group
  std::vector<bool> out(lines.size(), false);
  for (size_t g = 0; g < lines.size(); ++g)
    if (required[g]) group_is_required[group.smallest(static_cast<int>(g))] = true;
  for (size_t g = 0; g < lines.size(); ++g) out[g] = group_is_required[group.smallest(static_cast<int>(g))];
  return out;
}

FirstNotes first_notes(MPI_Comm comm, std::vector<StartNote> notes, int limit) {
  const auto sort = [](std::vector<StartNote>& list) {
    std::stable_sort(list.begin(), list.end(), [](const StartNote& a, const StartNote& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
  };
  int all = static_cast<int>(notes.size());
  if (all_reduce(comm, MPI_SUM, all) == 0) return {};
  sort(notes);
  if (std::ssize(notes) > limit) notes.resize(limit);
  std::vector<int> sent;
  for (const StartNote& n : notes) {
    sent.insert(sent.end(), {n.first, n.second, static_cast<int>(n.text.size())});
    sent.insert(sent.end(), n.text.begin(), n.text.end());
  }
  std::vector<StartNote> first;
  const std::vector<int> received = gather_all(comm, sent);
  for (auto at = received.begin(); at != received.end();) {
    StartNote& n = first.emplace_back(StartNote{at[0], at[1], std::string(at + 3, at + 3 + at[2])});
    at += 3 + static_cast<std::ptrdiff_t>(n.text.size());
  }
  sort(first);
  FirstNotes out;
  for (size_t i = 0; i < first.size() && std::ssize(out.texts) < limit; ++i)
    out.texts.push_back(std::move(first[i].text));
  out.more = all - static_cast<int>(out.texts.size());
  return out;
}

}  // namespace hawser
