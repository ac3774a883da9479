// Radiation memory of a group of bodies, consistency of added mass and damping of the files, and names of
// their degrees of freedom.
#include "hawser/model/platform_memory.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/math/freedoms.hpp"

namespace hawser::model {
namespace {

// Entries of the damping matrix below this fraction of the diagonal entries count as zero.
constexpr double kNoEntry = 1e-6;

std::vector<int> rows_of(const Case& c, const std::vector<int>& bodies) {
  std::vector<int> rows;
  for (const int body : bodies)
    for (int k = 0; k < 6; ++k) rows.push_back(6 * (c.bodies[body].mass->hydrodynamics->body - 1) + k);
  return rows;
}

}  // namespace

PlatformMemory platform_memory(const Case& c, const std::vector<int>& bodies) {
  PlatformMemory out;
  out.rows = rows_of(c, bodies);
  const HydrodynamicData& data = *c.bodies[bodies.front()].mass->hydrodynamics->data;
  const int n = static_cast<int>(out.rows.size());
  const auto peak = [&](int i, int j) {
    double largest = 0;
    for (const Eigen::MatrixXd& B : data.damping)
      largest = std::max(largest, std::abs(B(out.rows[i], out.rows[j])));
    return largest;
  };
  for (int i = 0; i < n; ++i)
    for (int j = i; j < n; ++j)
      if (peak(i, j) > kNoEntry * std::sqrt(peak(i, i) * peak(j, j))) out.entries.emplace_back(i, j);
  if (out.entries.empty()) return out;
  Eigen::MatrixXd damping(data.omega.size(), out.entries.size());
  for (Eigen::Index k = 0; k < damping.rows(); ++k)
    for (Eigen::Index e = 0; e < damping.cols(); ++e) {
      const auto [i, j] = out.entries[e];
      damping(k, e) = data.damping[k](out.rows[i], out.rows[j]);
    }
  out.memory = RadiationMemory(data.omega, damping);
  return out;
}

std::shared_ptr<const PlatformMemory> PlatformMemories::of(const Case& c, const std::vector<int>& bodies) {
  const HydrodynamicData* data = c.bodies[bodies.front()].mass->hydrodynamics->data.get();
  std::shared_ptr<const PlatformMemory>& memory = computed_[{data, rows_of(c, bodies)}];
  if (!memory) memory = std::make_shared<const PlatformMemory>(platform_memory(c, bodies));
  return memory;
}

std::string freedom_name(const Case& c, const std::vector<int>& bodies, int row) {
  const std::string& body = c.bodies[static_cast<size_t>(bodies[static_cast<size_t>(row / 6)])].name;
  return (bodies.size() > 1 ? body + " " : "") + kFreedomNames[row % 6];
}

// Without the last row, where the added mass by truncated damping is infinite, and without degrees of freedom
// that radiate no waves, whose added mass is rounding.
OgilvieCheck ogilvie_check(const HydrodynamicData& data, const PlatformMemory& radiation) {
  std::vector<Eigen::RowVectorXd> by_damping;
  for (size_t k = 0; k + 1 < data.omega.size() && !radiation.entries.empty(); ++k)
    by_damping.push_back(radiation.memory.added_mass_by_damping(data.omega[k]));
  constexpr double kRounding = 1e-6;
  const auto size = [&data](int row) {
    double largest = std::abs(data.infinite(row, row));
    for (const Eigen::MatrixXd& A : data.added_mass) largest = std::max(largest, std::abs(A(row, row)));
    return largest;
  };
  OgilvieCheck worst;
  for (size_t e = 0; e < radiation.entries.size(); ++e) {
    const auto [i, j] = radiation.entries[e];
    if (i != j) continue;
    const int row = radiation.rows[static_cast<size_t>(i)];
    const int first = row - row % 3;
    if (size(row) < kRounding * std::max({size(first), size(first + 1), size(first + 2)})) continue;
    OgilvieCheck of_freedom{0, i, 0};
    double largest = 0;
    for (size_t k = 0; k < by_damping.size(); ++k) {
      const double varies = data.added_mass[k](row, row) - data.infinite(row, row);
      const double off = std::abs(by_damping[k][static_cast<Eigen::Index>(e)] - varies);
      largest = std::max(largest, std::abs(varies));
      if (off > of_freedom.difference) of_freedom = {off, i, data.omega[k]};
    }
    if (largest > 0) of_freedom.difference /= largest;
    if (of_freedom.difference > worst.difference) worst = of_freedom;
  }
  return worst;
}

}  // namespace hawser::model
