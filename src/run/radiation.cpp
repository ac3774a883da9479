// Retardation functions, damping and added mass of platforms, a CSV file for each group.
#include "hawser/run/radiation.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "hawser/advice/modes.hpp"
#include "hawser/advice/output_files.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/model/platform.hpp"
#include "hawser/model/platform_memory.hpp"
#include "hawser/run/output_place.hpp"

namespace hawser::run {
namespace {

constexpr std::string_view kHead = "quantity,t [s] or omega [rad/s]";

// Points of K(t) per period of the highest frequency.
constexpr double kPointsPerPeriod = 6;

std::string radiation_csv(const model::Case& c, const std::vector<int>& bodies) {
  const model::HydrodynamicData& data =
      *c.bodies[static_cast<size_t>(bodies.front())].mass->hydrodynamics->data;
  const model::PlatformMemory radiation = model::platform_memory(c, bodies);
  std::string s(kHead);
  for (const auto& [i, j] : radiation.entries)
    s += fmt::format(",{}-{}", model::freedom_name(c, bodies, i), model::freedom_name(c, bodies, j));
  s += "\n";
  const auto row = [&](std::string_view quantity, double at, const auto& value) {
    s += fmt::format("{},{:.10g}", quantity, at);
    for (size_t e = 0; e < radiation.entries.size(); ++e) s += fmt::format(",{:.10g}", value(e));
    s += "\n";
  };
  const auto entry = [&](const Eigen::MatrixXd& of_files, size_t e) {
    const auto [i, j] = radiation.entries[e];
    return of_files(radiation.rows[static_cast<size_t>(i)], radiation.rows[static_cast<size_t>(j)]);
  };
  const auto of_row = [](const Eigen::RowVectorXd& r) {
    return [&r](size_t e) { return r[static_cast<Eigen::Index>(e)]; };
  };
  const double step = 2 * M_PI / data.omega.back() / kPointsPerPeriod;
  for (int k = 0; k * step <= radiation.memory.length() && !radiation.entries.empty(); ++k) {
    const Eigen::RowVectorXd K = radiation.memory.retardation(k * step);
    row("retardation", k * step, of_row(K));
  }
  for (size_t k = 0; k < data.omega.size(); ++k) {
    row("damping", data.omega[k], [&](size_t e) { return entry(data.damping[k], e); });
    row("added mass", data.omega[k], [&](size_t e) { return entry(data.added_mass[k], e); });
    if (k + 1 == data.omega.size() || radiation.entries.empty()) continue;
    const Eigen::RowVectorXd A = radiation.memory.added_mass_by_damping(data.omega[k]);
    row("added mass by damping", data.omega[k],
        [&](size_t e) { return entry(data.infinite, e) + A[static_cast<Eigen::Index>(e)]; });
  }
  return s;
}

}  // namespace

void write_radiation(MPI_Comm comm, const model::Case& c, const std::string& path) {
  const std::vector<std::vector<int>> groups = model::radiating_groups(c);
  if (groups.empty()) throw InputError(advice::no_coefficients(c));
  const std::filesystem::path requested = std::filesystem::absolute(path);
  if (requested.extension() != ".csv") throw InputError(advice::table_needs_csv(path, "radiation"));
  for (const std::vector<int>& group : groups) {
    std::filesystem::path file = requested;
    if (groups.size() > 1)
      file = table_of_body(requested.string(), c.bodies[static_cast<size_t>(group.front())].name);
    on_root(comm, [&] { check_table(file.string(), kHead, "radiation", c.inputs); });
    const bool root = rank_of(comm) == 0;
    write_table(comm, file.string(), root ? radiation_csv(c, group) : "");
    if (root) fmt::print("radiation table: {}\n", file.string());
  }
}

}  // namespace hawser::run
