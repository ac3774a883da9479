// Where friction of statics is reckoned from: how lines were laid.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "hawser/base/gather.hpp"
#include "hawser/terms/seabed.hpp"

namespace hawser {

size_t SeabedTerm::number(const Point& p) const {
  if (p.second < 0) return static_cast<size_t>(mesh_.global[p.node]);
  return mesh_.mesh->nodes.size() + static_cast<size_t>(mesh_.elements[p.element].global);
}

// 32 bytes a node, a few times in a run.
SeabedTerm::Lying SeabedTerm::lying(MPI_Comm comm, const Kinematics& at) const {
  const size_t n = mesh_.mesh->nodes.size();
  Lying all{std::vector<double>(3 * n, 0), std::vector<double>(n, -1)};
  for (int i = 0; i < mesh_.owned; ++i)
    for (int c = 0; c < 3; ++c) all.x[3 * mesh_.global[i] + c] = at.x[i][c];
  for (const Point& p : points_)
    if (p.second < 0) all.contact_distance[number(p)] = contact_distance(p);
  all_reduce(comm, MPI_SUM, all.x);
  all_reduce(comm, MPI_MAX, all.contact_distance);
  return all;
}

void SeabedTerm::lay_at_start(MPI_Comm comm, const Kinematics& start, const std::vector<double>& near) {
  const Mesh& mesh = *mesh_.mesh;
  const Lying all = lying(comm, start);
  laid_at_start_.assign(mesh.lines.size(), false);
  for (size_t l = 0; l < mesh.lines.size(); ++l) {
    if (near[l] < 0) continue;
    const LineSpan& line = mesh.lines[l];
    bool lies = true;
    for (int i = line.first_node; lies && i < line.first_node + line.nodes; ++i) {
      const double most = near[l] + std::max(0.0, all.contact_distance[i]);
      lies = gap(all.place(i), most) < most;
    }
    laid_at_start_[l] = lies;
  }
  origins_.assign(points_.size(), std::nullopt);
  for (const Point& p : points_) {
    const Vec3 here = of_nodes(p, start.x);
    const Node& node = mesh.nodes[mesh_.global[p.node]];
    if (node.body >= 0 || !laid_at_start_[node.line]) continue;
    ContactTrial seen;
    locate(p, here, near[node.line], seen);
    origins_[place(p)] = Origin{here, seen.normal};
  }
}

SeabedTerm::Full SeabedTerm::full(MPI_Comm comm, const Kinematics& at,
                                  const std::vector<double>& tension) const {
  const size_t nodes = mesh_.mesh->nodes.size(), n = nodes + mesh_.mesh->elements.size();
  std::vector<double> all(3 * n, 0);
  for (int i = 0; i < mesh_.owned; ++i) all[mesh_.global[i]] = tension[i];
  for (const Point& p : points_) {
    if (!p.counted) continue;
    ContactTrial trial;
    const FrictionLaw& f = law(p).law.friction;
    const double limit = f.axial * contact(p, at, false, trial).normal.force;
    all[n + number(p)] = limit;
    all[2 * n + number(p)] = f.stiffness > 0 ? limit / f.stiffness : f.axial_length;
  }
  all_reduce(comm, MPI_SUM, all);
  for (size_t e = 0; e < n - nodes; ++e) {
    const Element& g = mesh_.mesh->elements[e];
    all[nodes + e] = 0.5 * (all[g.first] + all[g.second]);
  }
  const auto part = [&](size_t k) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(k * n);
    return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(n));
  };
  return {part(0), part(1), part(2)};
}

std::vector<int> SeabedTerm::lay(MPI_Comm comm, const Kinematics& at, const std::vector<int>& held,
                                 const std::vector<double>& tension) {
  const Mesh& mesh = *mesh_.mesh;
  const Lying all = lying(comm, at);
  const auto rests = [&](int node) {
    const double most = all.contact_distance[node];
    return most >= 0 && gap(all.place(node), most) < most;
  };
  const auto lies = [&](int node) { return buried_[node] || rests(node); };
  int everywhere = !tension.empty();  // a rank may own no node
  all_reduce(comm, MPI_MAX, everywhere);
  const Full most = everywhere ? full(comm, at, tension) : Full{};
  std::vector<int> unsaid;
  // By number of a point: m, away from the end, signed from A to B.
  std::unordered_map<size_t, double> pulled;
  for (size_t l = 0; l < mesh.lines.size(); ++l) {
    if (!laid_at_start_.empty() && laid_at_start_[l]) continue;
    const LineSpan& line = mesh.lines[l];
    int resting = 0, off = 0;
    for (int i = line.first_node; i < line.first_node + line.nodes; ++i)
      (rests(i) ? resting : off) += all.contact_distance[i] >= 0;
    if (resting > 0 && off == 0) {
      unsaid.push_back(static_cast<int>(l));
      continue;
    }
    for (const bool from_a : {true, false}) {
      const int first = from_a ? line.first_node : line.first_node + line.nodes - 1, way = from_a ? 1 : -1;
      if (!std::binary_search(held.begin(), held.end(), first)) continue;
      const double near = 2 * std::abs(all.contact_distance[first + way]);
      if (gap(all.place(first), near) > near) continue;
      double sum = 0;
      int node = first;
      std::vector<size_t> walked;
      const auto walk = [&](size_t point, double slipped) {
        walked.push_back(point), pulled[point] = way * slipped;
      };
      for (int i = 1; i < line.nodes; ++i) {
        const int to = first + i * way;
        const size_t element = line.first_element + (from_a ? i - 1 : line.elements - i);
        // Laid without tension, as warm as it is.
        const Element& g = mesh.elements[element];
        const double natural = (1 + g.free_strain) * g.length;
        const double stretch = std::max(0.0, (all.place(to) - all.place(node)).norm() - natural);
        walk(mesh.nodes.size() + element, sum + 0.5 * stretch);
        if (!lies(to)) break;
        sum += stretch;
        walk(static_cast<size_t>(to), sum);
        node = to;
      }
      // Back from where it touches down, as far as the tension that is left goes.
      double taken = 0;
      for (size_t i = walked.size(); everywhere && i-- > 0;) {
        const size_t n = walked[i];
        if (!(most.limit[n] > 0)) continue;
        const double share = std::clamp((most.tension[n] - taken) / most.limit[n], 0.0, 1.0);
        taken += share * most.limit[n];
        pulled[n] += way * share * most.length[n];
      }
    }
  }
  laid_.resize(points_.size());
  for (const Point& p : points_) {
    const Vec3 here = of_nodes(p, at.x);
    ContactTrial seen;
    locate(p, here, 0, seen);
    Start& start = starts_[place(p)];
    Laid& slipped = laid_[place(p)];
    start.point = here;
    start.gap = seen.gap;
    slipped = {Vec3::Zero(), seen.normal};
    if (const Origin* laid = origin(p)) {  // all of the way from there counts, also that down to the bed
      start.point = laid->point, slipped.normal = laid->normal;
      start.gap = 0;
      continue;
    }
    const auto found = pulled.find(number(p));
    if (found == pulled.end()) continue;
    const Vec3 t = tangent(p, at);
    slipped.slip = found->second * (t - seen.normal * seen.normal.dot(t));
  }
  return unsaid;
}

}  // namespace hawser
