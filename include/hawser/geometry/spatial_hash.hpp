// Nearest triangle to a point: a hierarchical spatial hash, built once in the body frame.
//
// Level l is a grid of cubes of side s_l = s_0 2^l. Each triangle belongs to the one cell that holds the
// centre of its box, on the level of its own size (cell side at least its longest side), so that large and
// small triangles do not get in each other's way. Triangles are sorted along a space-filling curve, cell by
// cell, and a cell that holds few is not divided further: its triangles are one run of the sorted list.
// Cells know which of their eight children hold anything, with tight boxes. A query looks up, by hash, the
// few cells around it of a side comparable with the search radius (or of the coarsest triangles), and goes
// down from there, nearest first, leaving out what is farther than the best found.
//
// What a query reads on its way is small, so that it comes from cache also for a million triangles: runs
// are kept in 18 bytes a triangle, corners rounded to a grid, and bound the distances of eight triangles at
// a time in single precision. Only those that could be the nearest are then tested in double precision.
//
// Memory: about 110 bytes a triangle, 80 of them its corners in double and its index.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

class SpatialHash {
 public:
  struct Nearest {
    int triangle = -1;            // index in the mesh; -1: none within the distance
    double squared_distance = 0;  // m²
  };
  // What a query did, added up.
  struct Counters {
    long queries = 0, lookups = 0, cells = 0;
    long triangles = 0, exact = 0;  // bounded in single precision, tested in double
  };

  SpatialHash() = default;
  // `active`: one flag per triangle; empty means all.
  SpatialHash(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles,
              const std::vector<bool>& active = {});

  // The triangle nearest to p within max_distance [m] (infinity allowed). `hint`: a triangle likely to be
  // near. Among triangles at exactly equal distance always the same is chosen, whatever the hint.
  Nearest nearest(const Vec3& p, double max_distance = std::numeric_limits<double>::infinity(), int hint = -1,
                  Counters* counters = nullptr) const;

  const Box& box() const { return box_; }  // of the active triangles
  std::size_t size() const { return corners_.size(); }
  int levels() const { return top_ + 1; }
  std::size_t cells() const { return cells_; }
  std::size_t memory() const;  // bytes

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  struct Corners {
    double v[9];
    std::int32_t id, unused;  // mesh index; ~index of a triangle that needs the careful formula
  };
  // A cell: its own triangles and its children.
  struct Entry {
    static constexpr std::uint32_t kMost = 15;
    std::uint32_t own = 0;           // 28 bits first triangle, 4 bits count
    std::uint32_t children = kNone;  // index into children_
    std::uint32_t first() const { return own >> 4; }
    std::uint32_t count() const { return own & kMost; }
  };
  // Up to eight children side by side, so that their distances are found together, in two cache lines:
  // boxes on a grid of 255 steps of a power of two over the box of all. The corners of their triangles
  // are on a grid 256 times finer.
  struct alignas(64) Children {
    float origin[3];           // m, from centre_
    std::uint8_t exponent[3];  // of the step, biased by 127
    std::uint8_t count;
    std::uint8_t lo[3][8], hi[3][8];
    Entry entry[8];
  };
  struct Slot {
    std::uint64_t key = kFree;
    Entry entry;
  };
  // The cells of a level in hash_, open addressing.
  struct Table {
    std::size_t first, mask;
  };
  struct Made;
  struct Search;

  void sort_triangles(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles,
                      const std::vector<int>& which, std::vector<std::uint64_t>& keys,
                      std::vector<int>& levels);
  void build_cells(const std::vector<std::uint64_t>& keys, const std::vector<int>& levels);
  Made bundle(Made* first, Made* last);  // up to eight
  Made join(std::vector<Made>& parts, bool below_hash);
  void add_table(const Made* first, const Made* last);
  const Entry* find(int level, std::uint64_t key) const;
  void round_corners(const Children& frame, const Entry& run);
  double test(std::uint32_t slot, const Vec3& p) const;
  void bound(Search& search, const Children& frame, const Entry& run) const;
  void settle(Search& search) const;
  void descend(Search& search) const;

  Box box_;
  Vec3 origin_ = Vec3::Zero(), centre_ = Vec3::Zero();
  double side_ = 1;                     // of the cells of level 0
  int top_ = 0;                         // the level with one cell
  int start_ = 0;                       // finest level in hash_, above that of the largest triangles
  std::vector<double> margin_;          // per level: how far triangles of it or below reach out of their cell
  std::vector<Corners> corners_;        // sorted
  std::vector<std::uint16_t> rounded_;  // of each run: first x of all its triangles, first y, ... third z
  std::vector<std::int32_t> slot_;      // of each mesh triangle in corners_, -1 if not active
  std::vector<Children> children_;
  Entry root_;
  std::vector<Table> tables_;  // of levels start_ and above
  std::vector<Slot> hash_;
  std::size_t cells_ = 0;
};

}  // namespace hawser
