// The class LineCandidates: elements of other ranks that may touch those of this one. Bounding boxes of
// chunks of elements go to all ranks; elements go only to ranks with overlapping chunks.
#include <algorithm>
#include <map>
#include <set>

#include "hawser/base/gather.hpp"
#include "hawser/geometry/box_pairs.hpp"
#include "hawser/system/line_candidates.hpp"

namespace hawser {
namespace {

constexpr size_t kChunk = 64, kBox = 7, kAxis = 26;  // elements in a chunk; doubles of a box and of an axis
constexpr int kTag = 73;

std::vector<double> pack(const std::vector<SweptAxis>& own, const std::set<size_t>& chunks) {
  std::vector<double> out;
  for (size_t c : chunks)
    for (size_t i = kChunk * c; i < std::min(kChunk * (c + 1), own.size()); ++i) {
      out.push_back(own[i].element);
      out.push_back(own[i].skin);
      for (const auto* end : {&own[i].from, &own[i].to})
        for (const Vec3& p : *end) out.insert(out.end(), p.begin(), p.end());
    }
  return out;
}

}  // namespace

std::vector<SweptAxis> LineCandidates::from_others(std::span<const Box> of) const {
  const int size = ranks_of(comm_), rank = rank_of(comm_);
  if (size == 1) return {};
  const std::vector<SweptAxis>& own = built_;
  std::vector<double> mine;
  for (size_t first = 0; first < own.size(); first += kChunk) {
    const size_t last = std::min(first + kChunk, own.size());
    Box b;
    for (size_t i = first; i < last; ++i) b.add(of[i]);
    mine.insert(mine.end(), b.lo.begin(), b.lo.end());
    mine.insert(mine.end(), b.hi.begin(), b.hi.end());
    mine.push_back(static_cast<double>(last - first));
  }
  const size_t me = rank;
  const GatherPlan plan(comm_, static_cast<int>(mine.size()));
  const std::vector<int>& starts = plan.starts();
  std::vector<double> all;
  plan.gather(mine.data(), all);

  std::vector<Box> boxes(all.size() / kBox);
  std::vector<size_t> of_rank(boxes.size());
  for (size_t i = 0, r = 0; i < boxes.size(); ++i) {
    while (kBox * i >= static_cast<size_t>(starts[r + 1])) ++r;
    const double* d = all.data() + kBox * i;
    boxes[i] = {Vec3(d[0], d[1], d[2]), Vec3(d[3], d[4], d[5])};
    of_rank[i] = r;
  }
  // By the other rank: chunks to send to it, and chunks to receive from it.
  struct Trade {
    std::set<size_t> give, take;
    std::vector<double> out, in;
  };
  std::map<size_t, Trade> trades;
  const size_t first = static_cast<size_t>(starts[me]) / kBox;
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const size_t a = i, b = j;
    if (of_rank[a] == of_rank[b]) continue;
    if (of_rank[a] == me) {
      trades[of_rank[b]].give.insert(a - first);
      trades[of_rank[b]].take.insert(b);
    }
    if (of_rank[b] == me) {
      trades[of_rank[a]].give.insert(b - first);
      trades[of_rank[a]].take.insert(a);
    }
  }
  std::vector<MPI_Request> requests;
  for (auto& [r, t] : trades) {
    size_t elements = 0;
    for (size_t c : t.take) elements += static_cast<size_t>(all[kBox * c + kBox - 1]);
    t.in.resize(kAxis * elements);
    t.out = pack(own, t.give);
    const int other = static_cast<int>(r);
    MPI_Irecv(t.in.data(), static_cast<int>(t.in.size()), MPI_DOUBLE, other, kTag, comm_,
              &requests.emplace_back());
    MPI_Isend(t.out.data(), static_cast<int>(t.out.size()), MPI_DOUBLE, other, kTag, comm_,
              &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);

  std::vector<SweptAxis> out;
  for (const auto& [r, t] : trades)
    for (size_t i = 0; i < t.in.size(); i += kAxis) {
      const double* d = t.in.data() + i;
      SweptAxis& s = out.emplace_back(at_rest(static_cast<int>(d[0])));
      s.skin = d[1];
      for (size_t k = 0; k < 4; ++k) {
        s.from[k] = Eigen::Map<const Vec3>(d + 2 + 3 * k);
        s.to[k] = Eigen::Map<const Vec3>(d + 14 + 3 * k);
      }
    }
  // Both ranks of an element that the partition cuts have sent it.
  const auto before = [](const SweptAxis& a, const SweptAxis& b) { return a.element < b.element; };
  const auto same = [](const SweptAxis& a, const SweptAxis& b) { return a.element == b.element; };
  std::sort(out.begin(), out.end(), before);
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  std::erase_if(out,
                [&](const SweptAxis& s) { return std::binary_search(own.begin(), own.end(), s, before); });
  return out;
}

}  // namespace hawser
