// The class LineCandidates: elements of other ranks that may touch those of this rank. All ranks exchange a
// few bounding regions of their elements. Ranks with overlapping regions exchange bounding boxes of chunks of
// elements, then the elements near such a chunk.
#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/geometry/box_tree.hpp"
#include "hawser/terms/line_candidates.hpp"

namespace hawser {
namespace {

constexpr size_t kChunk = 64, kRegions = 32;  // elements in a chunk; regions of a rank, at most
constexpr size_t kBox = 6, kAxis = 26;        // doubles of a box and of an axis
constexpr int kBoxTag = 73, kAxisTag = 74;

void append(std::vector<double>& to, const Box& b) {
  to.insert(to.end(), b.lo.begin(), b.lo.end());
  to.insert(to.end(), b.hi.begin(), b.hi.end());
}

std::vector<Box> boxes_of(std::span<const double> numbers) {
  std::vector<Box> out;
  for (size_t i = 0; i < numbers.size(); i += kBox)
    out.push_back({Vec3(numbers.data() + i), Vec3(numbers.data() + i + 3)});
  return out;
}

// Bounding boxes of up to kChunk successive elements of one line.
std::vector<Box> chunks_of(const std::vector<SweptAxis>& axes, std::span<const Box> boxes) {
  std::vector<Box> out;
  for (size_t i = 0, first = 0; i < axes.size(); ++i) {
    if (i == 0 || axes[i].line != axes[i - 1].line || i - first == kChunk) {
      first = i;
      out.emplace_back();
    }
    out.back().add(boxes[i]);
  }
  return out;
}

// At most kRegions boxes that contain all chunks: the largest nodes of their tree are split.
std::vector<Box> regions_of(const std::vector<Box>& chunks) {
  const BoxTree tree(chunks, {}, 1);
  const auto nodes = tree.nodes();
  std::vector<size_t> regions;
  if (!tree.empty()) regions.push_back(0);
  while (!regions.empty() && regions.size() < kRegions) {
    const auto larger = [&](size_t a, size_t b) { return nodes[a].count < nodes[b].count; };
    size_t& longest = *std::max_element(regions.begin(), regions.end(), larger);
    if (nodes[longest].count == 1) break;
    const size_t first = longest + 1;
    longest = first;
    regions.push_back(static_cast<size_t>(nodes[first].next));
  }
  std::vector<Box> out;
  for (const size_t r : regions) out.push_back(nodes[r].box);
  return out;
}

bool overlaps_any(const Box& box, std::span<const Box> others) {
  return std::any_of(others.begin(), others.end(), [&](const Box& b) { return box.overlaps(b); });
}

// Exchanges data with each of these ranks, which make the matching call.
std::vector<std::vector<double>> exchange(MPI_Comm comm, int tag, const std::vector<int>& ranks,
                                          const std::vector<std::vector<double>>& out) {
  std::vector<MPI_Request> requests(ranks.size());
  for (size_t i = 0; i < ranks.size(); ++i)
    MPI_Isend(out[i].data(), static_cast<int>(out[i].size()), MPI_DOUBLE, ranks[i], tag, comm, &requests[i]);
  std::vector<std::vector<double>> received(ranks.size());
  for (size_t i = 0; i < ranks.size(); ++i) {
    MPI_Status status;
    int count = 0;
    MPI_Probe(ranks[i], tag, comm, &status);
    MPI_Get_count(&status, MPI_DOUBLE, &count);
    received[i].resize(static_cast<size_t>(count));
    MPI_Recv(received[i].data(), count, MPI_DOUBLE, ranks[i], tag, comm, MPI_STATUS_IGNORE);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return received;
}

// Numbers of the regions of all ranks, kRegions boxes each. Collective.
std::vector<double> regions_of_ranks(MPI_Comm comm, const std::vector<Box>& regions) {
  constexpr int kNumbers = static_cast<int>(kBox * kRegions);
  std::vector<double> local;
  std::vector<double> all(kBox * kRegions * static_cast<size_t>(ranks_of(comm)));
  for (const Box& b : regions) append(local, b);
  MPI_Allgather(local.data(), kNumbers, MPI_DOUBLE, all.data(), kNumbers, MPI_DOUBLE, comm);
  return all;
}

// Appends the numbers of the axes that come near some of these boxes. swept: boxes of the axes.
void append_near(std::vector<double>& to, const std::vector<SweptAxis>& axes, std::span<const Box> swept,
                 const std::vector<Box>& boxes) {
  const BoxTree tree(boxes);
  for (size_t i = 0; i < axes.size() && !tree.empty(); ++i) {
    bool reached = false;
    tree.walk([&](size_t node) { return !reached && tree.nodes()[node].box.overlaps(swept[i]); },
              [&](int item) { reached |= boxes[static_cast<size_t>(item)].overlaps(swept[i]); });
    if (!reached) continue;
    to.push_back(axes[i].element);
    to.push_back(axes[i].skin);
    for (const auto* end : {&axes[i].from, &axes[i].to})
      for (const Vec3& p : *end) to.insert(to.end(), p.begin(), p.end());
  }
}

}  // namespace

std::vector<SweptAxis> LineCandidates::from_others(std::span<const Box> boxes) const {
  const int size = ranks_of(comm_);
  const int rank = rank_of(comm_);
  if (size == 1) return {};
  const std::vector<SweptAxis>& axes = built_;
  const std::vector<Box> chunks = chunks_of(axes, boxes);
  std::vector<Box> regions = regions_of(chunks);
  regions.resize(kRegions);
  const std::vector<double> all_regions = regions_of_ranks(comm_, regions);

  // Ranks with regions that overlap those of this rank, and for each the chunks of this rank that are near.
  std::vector<int> ranks;
  std::vector<std::vector<double>> out;
  for (int r = 0; r < size; ++r) {
    if (r == rank) continue;
    const std::vector<Box> others_boxes =
        boxes_of(std::span<const double>(all_regions)
                     .subspan(kBox * kRegions * static_cast<size_t>(r), kBox * kRegions));
    if (std::none_of(regions.begin(), regions.end(),
                     [&](const Box& b) { return overlaps_any(b, others_boxes); }))
      continue;
    ranks.push_back(r);
    out.emplace_back();
    for (const Box& chunk : chunks)
      if (overlaps_any(chunk, others_boxes)) append(out.back(), chunk);
  }
  const std::vector<std::vector<double>> near = exchange(comm_, kBoxTag, ranks, out);

  for (size_t k = 0; k < ranks.size(); ++k) {
    out[k].clear();
    append_near(out[k], axes, boxes, boxes_of(near[k]));
  }
  std::vector<SweptAxis> others;
  for (const std::vector<double>& axes_of_rank : exchange(comm_, kAxisTag, ranks, out))
    for (size_t i = 0; i < axes_of_rank.size(); i += kAxis) {
      const double* d = axes_of_rank.data() + i;
      SweptAxis& s = others.emplace_back(at_rest(static_cast<int>(d[0])));
      s.skin = d[1];
      for (size_t k = 0; k < 4; ++k) {
        s.from[k] = Eigen::Map<const Vec3>(d + 2 + 3 * k);
        s.to[k] = Eigen::Map<const Vec3>(d + 14 + 3 * k);
      }
    }
  // Both ranks of an element that the partition cuts have sent it.
  const auto before = [](const SweptAxis& a, const SweptAxis& b) { return a.element < b.element; };
  const auto same = [](const SweptAxis& a, const SweptAxis& b) { return a.element == b.element; };
  std::sort(others.begin(), others.end(), before);
  others.erase(std::unique(others.begin(), others.end(), same), others.end());
  std::erase_if(others,
                [&](const SweptAxis& s) { return std::binary_search(axes.begin(), axes.end(), s, before); });
  return others;
}

}  // namespace hawser
