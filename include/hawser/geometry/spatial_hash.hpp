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
// are kept in 12 bytes a triangle, corners rounded to a grid, and bound the distances of a whole run at a
// time in single precision. Only those that could be the nearest are then tested in double precision.
//
// Memory: about 50 bytes a triangle of a closed mesh. Corners are indices into vertices of the hash's own,
// in the order of the triangles, so that those of neighbours share cache lines.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/large_vector.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

class SpatialHash {
 public:
  struct Nearest {
    int triangle = 0;             // index in the mesh
    double squared_distance = 0;  // m²
  };
  // What a query did, added up.
  struct Counters {
    long queries = 0, lookups = 0, cells = 0;
    long triangles = 0, exact = 0;  // bounded in single precision, tested in double
    Counters& operator+=(const Counters& o) {
      queries += o.queries, lookups += o.lookups, cells += o.cells;
      triangles += o.triangles, exact += o.exact;
      return *this;
    }
  };
  // As of nearest().
  struct Question {
    Vec3 point;
    double max_distance = std::numeric_limits<double>::infinity();  // m
    int hint = -1;
  };

  SpatialHash() = default;
  // `active`: one flag per triangle; empty means all.
  SpatialHash(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles,
              const std::vector<bool>& active = {});

  // The triangle nearest to p within max_distance [m] (infinity allowed), if there is one. `hint`: a triangle
  // likely to be near. Among triangles at exactly equal distance always the same is chosen, whatever the
  // hint.
  std::optional<Nearest> nearest(const Vec3& p, double max_distance = std::numeric_limits<double>::infinity(),
                                 int hint = -1, Counters* counters = nullptr) const;

  // The same for many points, best in the order of a walk and with hints: half the time of one by one.
  void nearest(std::span<const Question> questions, std::span<std::optional<Nearest>> answers,
               Counters* counters = nullptr) const;

  const Box& box() const { return box_; }  // of the active triangles
  std::size_t size() const { return corners_.size(); }

  template <class Self, class P>
  static void pack(Self& self, P& p) {
    p.value(self.box_), p.value(self.origin_), p.value(self.centre_);
    p.value(self.side_), p.value(self.half_), p.value(self.away_);
    p.value(self.top_), p.value(self.start_), p.value(self.least_);
    p.value(self.root_);
    p.array(self.margin_), p.array(self.corners_), p.array(self.vertices_), p.array(self.rounded_);
    p.array(self.slot_), p.array(self.children_), p.array(self.tables_), p.array(self.hash_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  struct Corners {
    std::uint32_t v[3];  // of vertices_
    std::int32_t id;     // mesh index; ~index of a triangle that needs the careful formula
    std::int32_t index() const { return id < 0 ? ~id : id; }
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
  // are on a grid 4 times finer.
  struct alignas(64) Children {
    float origin[3];           // m, from centre_
    std::uint8_t exponent[3];  // of the step, biased by 127
    std::uint8_t count;
    std::uint8_t box[3][16];  // eight lower faces, eight upper ones
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
  struct Ball;   // the rest, in src: what a search knows,
  struct Start;  // the cells a search starts from
  struct Search;
  struct Group;

  void sort_triangles(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles,
                      const std::vector<int>& which, std::vector<std::uint64_t>& keys,
                      std::vector<int>& levels);
  void sort_vertices();
  void build_cells(const std::vector<std::uint64_t>& keys, const std::vector<int>& levels);
  Made bundle(Made* first, Made* last);  // up to eight
  Made join(std::vector<Made>& parts, bool below_hash);
  void settle(Made& cell);
  Made run_of(std::uint32_t first, std::size_t total) const;
  void cut(std::uint32_t first, std::size_t total, std::size_t runs, std::vector<Made>& out);
  void add_table(const Made* first, const Made* last);
  void round_corners(const Children& frame, const Entry& run);
  bool begin(Ball& ball, const Vec3& p, double max_distance) const;
  const Vec3& corner(std::size_t slot, std::size_t i) const { return vertices_[corners_[slot].v[i]]; }
  int slot_of(int triangle) const;
  const Entry* find(int level, std::uint64_t key) const;
  Start start(const Ball& ball) const;
  void fetch(const Entry& entry) const;
  void fetch_corners(std::uint32_t slot) const;
  unsigned expand(const Ball& ball, std::uint32_t block, float* squared) const;
  void descend(Search& search, std::uint32_t block) const;
  unsigned bound(Ball& ball, Entry run, std::uint32_t block, float* at_least, std::uint32_t* slots) const;
  void test(Ball& ball, std::uint32_t slot) const;
  std::optional<Nearest> answer(const Ball& ball) const;
  std::optional<Nearest> search(const Question& question, Counters& count) const;
  void settle(Search& search) const;
  std::vector<std::uint32_t> order_of(std::span<const std::int32_t> slots) const;

  Box box_;
  Vec3 origin_ = Vec3::Zero(), centre_ = Vec3::Zero();
  double side_ = 1;                     // of the cells of level 0
  double half_ = 0, away_ = 0;          // greatest coordinate of the box from centre_, and of centre_
  int top_ = 0;                         // the level with one cell
  int start_ = 0;                       // finest level in hash_, above that of the largest triangles
  int least_ = 0;                       // where the triangles allow to begin, see Start::kRoom
  LargeVector<double> margin_;          // per level: how far triangles of it or below reach out of their cell
  LargeVector<Corners> corners_;        // sorted
  LargeVector<Vec3> vertices_;          // in the order they are met in corners_
  LargeVector<std::uint32_t> rounded_;  // of each run: first corners, second, third, 3 x 10 bits each
  LargeVector<std::int32_t> slot_;      // of each mesh triangle in corners_, -1 if not active
  LargeVector<Children> children_;
  Entry root_;
  LargeVector<Table> tables_;  // of levels start_ and above
  LargeVector<Slot> hash_;
};

}  // namespace hawser
