#include "hawser/geometry/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "hawser/geometry/winding_tree.hpp"

namespace hawser {
namespace {

const Vec3& corner(const TriangleMesh& mesh, int t, int i) {
  return mesh.vertices[static_cast<std::size_t>(
      mesh.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(i % 3)])];
}
Vec3 area_vector(const TriangleMesh& mesh, int t) {
  return 0.5 * (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
}
Vec3 centroid(const TriangleMesh& mesh, int t) {
  return (corner(mesh, t, 0) + corner(mesh, t, 1) + corner(mesh, t, 2)) / 3;
}

// 1 when the corners are an even permutation of their order by index, -1 when odd.
int parity(const std::array<int, 3>& t) {
  int s = 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      if (t[i] > t[j]) s = -s;
  return s;
}

// Of triangles on the same corners one stays, or none of two back to back that no other edge needs.
int drop_duplicates(TriangleMesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  std::map<std::array<int, 3>, std::vector<std::size_t>> same;
  for (std::size_t t = 0; t < n; ++t) {
    auto key = mesh.triangles[t];
    std::sort(key.begin(), key.end());
    same[key].push_back(t);
  }
  if (same.size() == n) return 0;
  const Topology topo = topology(mesh);
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  std::vector<bool> drop(n, false);
  for (const auto& [key, list] : same) {
    if (list.size() < 2) continue;
    int balance = 0;
    for (const std::size_t t : list) balance += parity(mesh.triangles[t]);
    bool needed = true;
    if (balance == 0)
      for (std::size_t i = 0; i < 3; ++i)
        needed = needed &&
                 (uses.at(std::minmax(key[i], key[(i + 1) % 3])) - static_cast<int>(list.size())) % 2 == 1;
    bool kept = !needed;
    for (const std::size_t t : list) {
      const bool keep = !kept && (balance == 0 || (parity(mesh.triangles[t]) > 0) == (balance > 0));
      kept = kept || keep;
      drop[t] = !keep;
    }
  }
  std::size_t to = 0;
  const bool parts = mesh.part.size() == n;
  for (std::size_t t = 0; t < n; ++t) {
    if (drop[t]) continue;
    if (parts) mesh.part[to] = mesh.part[t];
    mesh.triangles[to++] = mesh.triangles[t];
  }
  mesh.triangles.resize(to);
  if (parts) mesh.part.resize(to);
  return static_cast<int>(n - to);
}

void flip(std::array<int, 3>& t) { std::swap(t[1], t[2]); }

bool same_way(const std::array<int, 3>& other, int a, int b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (other[i] == a && other[(i + 1) % 3] == b) return true;
  return false;
}

// The patch that holds `first`, its members' wish to be turned so that they agree with it in `turn`.
bool grow(const TriangleMesh& mesh, const Topology& topo, int first, std::vector<signed char>& turn,
          std::vector<int>& patch) {
  bool two_sided = true;
  turn[static_cast<std::size_t>(first)] = 0;
  patch.assign(1, first);
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const auto t = static_cast<std::size_t>(patch[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      const int other = topo.neighbours[t][i];
      if (other < 0) continue;
      const auto u = static_cast<std::size_t>(other);
      const bool agree = !same_way(mesh.triangles[u], mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      const auto wanted = static_cast<signed char>(agree ? turn[t] : 1 - turn[t]);
      if (turn[u] < 0) {
        turn[u] = wanted;
        patch.push_back(other);
      } else if (turn[u] != wanted) {
        two_sided = false;
      }
    }
  }
  return two_sided;
}

// Directions spread over the sphere (Fibonacci), so turned that none runs along an axis.
Vec3 direction(int i, int n) {
  const double z = 1 - (2 * i + 1.0) / n, a = 2.399963229728653 * i + 0.3, r = std::sqrt(1 - z * z);
  return Vec3(r * std::cos(a), r * std::sin(a), z);
}

constexpr int kRays = 9, kVoters = 15;

// Above 0: the front of the patch sees the outside. Its largest triangles vote.
int vote(const TriangleMesh& mesh, const WindingTree& tree, std::vector<int> patch) {
  const auto larger = [&](int a, int b) {
    const double x = area_vector(mesh, a).squaredNorm(), y = area_vector(mesh, b).squaredNorm();
    return x != y ? x > y : a < b;
  };
  const auto voters = std::min<std::size_t>(kVoters, patch.size());
  std::partial_sort(patch.begin(), patch.begin() + static_cast<long>(voters), patch.end(), larger);
  int sum = 0;
  for (std::size_t k = 0; k < voters; ++k) {
    const int t = patch[k];
    const Vec3 n = area_vector(mesh, t), c = centroid(mesh, t);
    if (n.isZero(0)) continue;
    for (int i = 0; i < kRays; ++i) {
      const Vec3 u = direction(i, kRays);
      const double side = u.dot(n.normalized());
      if (std::abs(side) < 0.1) continue;
      const bool even = tree.crossings(mesh, c, u, t) % 2 == 0;
      sum += even == (side > 0) ? 1 : -1;
    }
  }
  return sum;
}

}  // namespace

RepairResult repair(TriangleMesh& mesh) {
  RepairResult out;
  out.duplicates = drop_duplicates(mesh);
  if (mesh.triangles.empty()) return out;
  const Topology topo = topology(mesh);
  const WindingTree tree(mesh);
  std::vector<signed char> turn(mesh.triangles.size(), -1);
  std::vector<int> patch;
  for (int first = 0; first < static_cast<int>(turn.size()); ++first) {
    if (turn[static_cast<std::size_t>(first)] >= 0) continue;
    const bool two_sided = grow(mesh, topo, first, turn, patch);
    ++out.patches;
    if (!two_sided) {
      ++out.one_sided;
      for (const int t : patch) turn[static_cast<std::size_t>(t)] = 0;
      continue;
    }
    long many = 0;
    for (const int t : patch) many += turn[static_cast<std::size_t>(t)];
    bool all = 2 * many > static_cast<long>(patch.size());
    const auto turn_all = [&] {
      for (const int t : patch) turn[static_cast<std::size_t>(t)] ^= 1;
    };
    if (all) turn_all();
    for (const int t : patch)
      if (turn[static_cast<std::size_t>(t)]) flip(mesh.triangles[static_cast<std::size_t>(t)]);
    if (vote(mesh, tree, patch) < 0) {
      for (const int t : patch) flip(mesh.triangles[static_cast<std::size_t>(t)]);
      turn_all();
      ++out.patches_turned;
    }
    for (const int t : patch) out.turned += turn[static_cast<std::size_t>(t)];
  }
  const Topology now = topology(mesh);
  out.closed = now.odd_edges == 0 && now.flipped_edges == 0;
  // The tree's triangles have been turned: a new one.
  const WindingTree turned(mesh);
  double area = 0, good = 0;
  const std::size_t step = mesh.triangles.size() / 20000 + 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const int i = static_cast<int>(t);
    const double a = area_vector(mesh, i).norm();
    const double middle = turned.winding_number(mesh, centroid(mesh, i), 3, i);
    area += a;
    if (middle > 0.02 && middle < 0.98) good += a;
  }
  out.enclosing = area > 0 ? good / area : 0;
  const auto many = [](int n, const char* one, const char* more) {
    return std::to_string(n) + " " + (n == 1 ? one : more);
  };
  if (out.duplicates > 0)
    out.sentence +=
        many(out.duplicates, "triangle that is", "triangles that are") + " listed twice left out; ";
  out.sentence += out.turned == 0 ? std::string("no triangle turned over")
                                  : many(out.turned, "triangle", "triangles") +
                                        " turned over, by rays that count what they cross";
  if (out.one_sided > 0)
    out.sentence += "; " + many(out.one_sided, "patch is", "patches are") +
                    " one-sided like a Möbius band and left as found";
  return out;
}

}  // namespace hawser
