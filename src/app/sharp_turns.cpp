// The largest T (1 - cos alpha) of each line over the states looked at, and the sentence about it.
#include "hawser/app/sharp_turns.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser::app {
namespace {

constexpr double kWarned = 0.1;  // of the largest tension
constexpr double kGood = 0.45;   // rad, from one element to the next: 1 - cos of it is about that share

}  // namespace

SharpTurns::SharpTurns(const LocalMesh& mesh) : mesh_(mesh), worst_(mesh.mesh->lines.size()) {
  before_.assign(static_cast<size_t>(mesh.owned), -1), after_ = before_;
  for (const LocalElement& e : mesh.elements) {
    if (e.first < mesh.owned) after_[static_cast<size_t>(e.first)] = e.second;
    if (e.second < mesh.owned) before_[static_cast<size_t>(e.second)] = e.first;
  }
}

void SharpTurns::look(const Kinematics& at, std::span<const double> tension,
                      std::span<const double> normal_force) {
  for (size_t n = 0; n < before_.size(); ++n) {
    if (before_[n] < 0 || after_[n] < 0 || !(normal_force[n] > 0)) continue;
    const Vec3 a = at.x[n] - at.x[static_cast<size_t>(before_[n])],
               b = at.x[static_cast<size_t>(after_[n])] - at.x[n];
    const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
    const double error = tension[n] * (1 - std::cos(turn));
    const Node& node = mesh_.mesh->nodes[static_cast<size_t>(mesh_.global[n])];
    Worst& w = worst_[static_cast<size_t>(node.line)];
    if (error > w.error) w = {error, turn, node.arc, at.time};
  }
}

std::string SharpTurns::warning(MPI_Comm comm, int line, const std::string& name,
                                double largest_tension) const {
  Worst w = worst_[static_cast<size_t>(line)];
  struct {
    double value;
    int rank;
  } most{w.error, 0};
  MPI_Comm_rank(comm, &most.rank);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm);
  if (!(most.value > kWarned * largest_tension)) return {};
  double values[4] = {w.error, w.turn, w.arc, w.time};
  MPI_Bcast(values, 4, MPI_DOUBLE, most.rank, comm);
  return fmt::format(
      "line {} turns by {:.0f} degrees from one element to the next where it lies on a volume (arc length "
      "{:.4g} m, t = {:.4g} s), so that its tension there may be wrong by up to {:.2g} N, {:.0f} % of the "
      "largest: "
      "give it elements so short that it turns by no more than {:.0f} degrees; over a sharp edge that is "
      "about its "
      "radius",
      name, values[1] * 180 / M_PI, values[2], values[3], values[0], 100 * values[0] / largest_tension,
      kGood * 180 / M_PI);
}

}  // namespace hawser::app
