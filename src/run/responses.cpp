// Tables of `hawser responses`: waves, motion of a point of each body, and its file.
#include "hawser/run/responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "hawser/advice/output_files.hpp"
#include "hawser/advice/responses.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/kernels/platform_frame.hpp"
#include "hawser/kernels/table_places.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/math/heading.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/output_place.hpp"
#include "hawser/run/run_parts.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/solve/linear_responses.hpp"
#include "hawser/terms/dynamic_positioning.hpp"

namespace hawser::run {
namespace {

constexpr std::string_view kFirstColumns = "period [s],direction [deg]";
constexpr size_t kMostShown = 16;   // of a table on the terminal
constexpr double kRoundOff = 1e-9;  // of the largest of the three translations, or rotations

// Table of the wave forces that act on a body; null: none.
const WaveForceTable* wave_forces(const model::Body& b) {
  if (!b.mass || !b.mass->hydrodynamics) return nullptr;
  const model::BodyHydrodynamics& h = *b.mass->hydrodynamics;
  if (!h.excitation || h.data->excitation.empty()) return nullptr;
  return &h.data->excitation[static_cast<size_t>(h.body) - 1];
}

// Bodies that waves of the case would load, but not by coefficients.
std::vector<std::string> bodies_with_other_wave_loads(const model::Case& c) {
  std::vector<std::string> out;
  for (const model::Body& b : c.bodies)
    if (b.mass && (!b.mass->members.empty() || (!wave_forces(b) && (b.mass->hull || b.mass->in_water))))
      out.push_back(b.name);
  return out;
}

std::vector<int> chosen_bodies(const model::Case& c, const std::string& name) {
  std::vector<int> out;
  std::vector<std::string> all;
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    if (!c.bodies[b].mass) continue;
    all.push_back(c.bodies[b].name);
    if (name.empty() || name == all.back()) out.push_back(static_cast<int>(b));
  }
  if (out.empty()) throw InputError(advice::not_a_floating_body(c, name, all));
  return out;
}

// Place of a body for the phases of waves, m, and its heading [rad] for their directions.
struct WaveReference {
  Vec3 place;
  double heading = 0;
};

// As those of the wave forces: at rest, or fixed by the case. Bodies::exchange_poses() must precede it.
WaveReference reference_of(Simulation& sim, int body) {
  const model::Body& b = sim.model().bodies[static_cast<size_t>(body)];
  if (b.mass->hydrodynamics && !(b.mass->hydrodynamics->follow_period > 0))
    return {model::hydrodynamic_place(b, sim.model().environment.water.surface),
            model::hydrodynamic_heading(b)};
  const RigidPose pose = sim.bodies().pose(body, sim.state().at_rest());
  return {pose.position, heading_of(pose.rotation).angle};
}

// The first body with wave forces; there is one.
int first_in_waves(const model::Case& c) {
  return static_cast<int>(
      std::distance(c.bodies.begin(), std::find_if(c.bodies.begin(), c.bodies.end(), wave_forces)));
}

// Frequencies of the given periods, or of the wave forces of the first body that has them, descending. They
// are in the range of all coefficients.
std::vector<double> frequencies(const model::Case& c, const std::vector<double>& periods) {
  constexpr double kSame = 1e-6;  // relative: periods are often rounded
  double low = 0, high = HUGE_VAL;
  for (const model::Body& b : c.bodies) {
    if (!b.mass || !b.mass->hydrodynamics) continue;
    const std::vector<double>& omega = b.mass->hydrodynamics->data->omega;
    const WaveForceTable* of_waves = wave_forces(b);
    low = std::max({low, omega.front(), of_waves ? of_waves->lowest() : 0});
    high = std::min({high, omega.back(), of_waves ? of_waves->highest() : HUGE_VAL});
  }
  std::vector<double> out;
  for (const double omega : wave_forces(c.bodies[static_cast<size_t>(first_in_waves(c))])->omega())
    if (periods.empty() && omega >= low && omega <= high) out.push_back(omega);
  if (low > high || (periods.empty() && out.empty())) throw InputError(advice::no_common_periods(c));
  for (const double period : periods) {
    const double omega = 2 * M_PI / period;
    if (omega < low * (1 - kSame) || omega > high * (1 + kSame))
      throw InputError(advice::period_without_coefficients(c, period, 2 * M_PI / high, 2 * M_PI / low));
    out.push_back(std::clamp(omega, low, high));
  }
  std::sort(out.rbegin(), out.rend());
  return out;
}

// Waves of unit amplitude, by frequency [rad/s], then direction [rad from +x]; without directions those of
// the files of the first body with wave forces.
std::vector<WaveComponent> unit_waves(Simulation& sim, const std::vector<double>& frequencies,
                                      std::vector<double> directions) {
  const model::Case& c = sim.model();
  if (directions.empty()) {
    const int first = first_in_waves(c);
    const double heading = reference_of(sim, first).heading;
    for (const double direction : wave_forces(c.bodies[static_cast<size_t>(first)])->directions())
      directions.push_back(direction + heading);
  }
  std::vector<WaveComponent> out;
  for (const double omega : frequencies) {
    const double number = wave_number(omega, c.environment.water.depth, c.environment.gravity);
    for (const double direction : directions)
      out.push_back({1, omega, number, std::cos(direction), std::sin(direction), 0});
  }
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    const WaveForceTable* of_body = wave_forces(c.bodies[b]);
    for (size_t i = 0; of_body && i < directions.size(); ++i) {
      const model::Coverage coverage =
          model::coverage(*of_body, {out[i]}, reference_of(sim, static_cast<int>(b)).heading);
      if (coverage.uncovered > 0)
        throw InputError(advice::direction_without_wave_forces(c, c.bodies[b].name, directions[i] / kDegree,
                                                               coverage.direction / kDegree));
    }
  }
  return out;
}

// Relative to the bow, deg in (-180, 180], without the rounding of a heading at rest.
double from_bow(const WaveComponent& w, double heading) {
  const double direction = std::remainder((std::atan2(w.y, w.x) - heading) / kDegree, 360);
  const double rounded = std::round(1e6 * direction) / 1e6;
  return rounded > -180 ? rounded + 0.0 : 180;
}

struct ResponseRow {
  double period = 0, direction = 0;          // s; deg relative to the bow
  std::array<double, 6> amplitude{}, lag{};  // m/m, deg/m; deg
};

// motion: translations and rotations in axes of the heading, relative to the crest at the body.
ResponseRow response_row(const WaveComponent& w, double heading, const ComplexVec6& motion) {
  ResponseRow out{2 * M_PI / w.omega, from_bow(w, heading), {}, {}};
  for (Eigen::Index k = 0; k < 6; ++k) {
    const double largest = motion.segment<3>(k / 3 * 3).cwiseAbs().maxCoeff();
    const double size = std::abs(motion[k]);
    if (!(size > kRoundOff * largest)) continue;
    out.amplitude[static_cast<size_t>(k)] = size / (k < 3 ? 1 : kDegree);
    out.lag[static_cast<size_t>(k)] = all_round(-std::arg(motion[k])) / kDegree;
  }
  return out;
}

bool write_responses(const std::string& path, const std::vector<ResponseRow>& rows) {
  std::string s(kFirstColumns);
  for (size_t k = 0; k < 6; ++k)
    s += fmt::format(",{0} [{1}],{0} lag [deg]", kFreedomNames[k], k < 3 ? "m/m" : "deg/m");
  for (const char* name : kFreedomNames) s += fmt::format(",explained fraction of {} [-]", name);
  s += "\n";
  for (const ResponseRow& r : rows) {
    s += fmt::format("{:.10g},{:.10g}", r.period, r.direction);
    for (size_t k = 0; k < 6; ++k) s += fmt::format(",{:.10g},{:.10g}", r.amplitude[k], r.lag[k]);
    s += ",1,1,1,1,1,1\n";
  }
  std::ofstream file(path, std::ios::binary);
  file << s;
  file.close();
  return !file.fail();
}

std::string response_table(const std::vector<ResponseRow>& rows) {
  std::string s = fmt::format("{:>10} {:>8}", "period [s]", "to [deg]");
  for (const char* name : kFreedomNames) s += fmt::format(" {:>8} {:>5}", name, "lag");
  s += "\n";
  const size_t step = (rows.size() + kMostShown - 1) / kMostShown;
  for (size_t i = 0; i < rows.size(); i += step) {
    s += fmt::format("{:>10.4g} {:>8.4g}", rows[i].period, rows[i].direction);
    for (size_t k = 0; k < 6; ++k)
      s += fmt::format(" {:>8.4g} {:>5.0f}", rows[i].amplitude[k], rows[i].lag[k]);
    s += "\n";
  }
  if (step > 1)
    s += fmt::format("every {} of {} rows is shown; the table has all of them\n", step, rows.size());
  return s;
}

// Path of the table of each body.
std::vector<std::string> paths_of(const model::Case& c, const std::vector<int>& bodies,
                                  const std::string& output) {
  const std::filesystem::path beside(c.path);
  const std::filesystem::path wanted =
      output.empty() ? beside.parent_path() / (beside.stem().string() + "-responses.csv")
                     : std::filesystem::absolute(output);
  if (wanted.extension() != ".csv") throw InputError(advice::table_needs_csv(wanted.string(), "responses"));
  std::vector<std::string> out;
  for (const int b : bodies)
    out.push_back(bodies.size() > 1 ? table_of_body(wanted.string(), c.bodies[static_cast<size_t>(b)].name)
                                    : wanted.string());
  return out;
}

// Motions of the point `at` of each body that this rank owns, by wave: of its six freedoms in axes of its
// heading, relative to the crest at its place.
std::map<int, std::vector<ComplexVec6>> motions(Simulation& sim, const std::vector<int>& bodies,
                                                const std::vector<WaveComponent>& waves, const Vec3& at) {
  std::map<int, std::vector<ComplexVec6>> out;
  for (const int b : bodies)
    if (sim.local().owns(sim.bodies().local_node(b))) out[b].resize(waves.size());
  linear_responses(sim.system(), sim.state().at_rest(), waves, [&](size_t i, const std::vector<Complex>& u) {
    for (auto& [b, by_wave] : out) {
      const int node = sim.bodies().local_node(b);
      const auto* of_body = &u[3 * static_cast<size_t>(sim.local().block[node])];
      const WaveReference reference = reference_of(sim, b);
      const Mat3 H = heading_axes(reference.heading);
      const Mat3 R = sim.state().q[node].toRotationMatrix();
      const Vec3 arm = R * (at - sim.model().bodies[static_cast<size_t>(b)].mass->centre);
      const Eigen::Vector3cd turn = R * Eigen::Map<const Eigen::Vector3cd>(of_body + 3);
      const Eigen::Vector3cd moved = Eigen::Map<const Eigen::Vector3cd>(of_body) - hat(arm) * turn;
      const WaveComponent& w = waves[i];
      const double phase = w.number * (w.x * reference.place.x() + w.y * reference.place.y());
      by_wave[i] << H.transpose() * moved, H.transpose() * turn;
      by_wave[i] *= std::polar(1.0, phase);
    }
  });
  return out;
}

// Rows of a body by direction, then period, on the first rank. Collective.
std::vector<ResponseRow> rows_of(MPI_Comm comm, Simulation& sim, int body,
                                 const std::vector<WaveComponent>& waves,
                                 const std::map<int, std::vector<ComplexVec6>>& found) {
  std::vector<ComplexVec6> motion(waves.size(), ComplexVec6::Zero());
  if (const auto own = found.find(body); own != found.end()) motion = own->second;
  auto* numbers = reinterpret_cast<double*>(motion.data());
  const bool root = rank_of(comm) == 0;
  MPI_Reduce(root ? MPI_IN_PLACE : numbers, numbers, static_cast<int>(12 * motion.size()), MPI_DOUBLE,
             MPI_SUM, 0, comm);
  std::vector<ResponseRow> rows;
  const double heading = reference_of(sim, body).heading;
  for (size_t i = 0; root && i < waves.size(); ++i)
    rows.push_back(response_row(waves[i], heading, motion[i]));
  std::stable_sort(rows.begin(), rows.end(),
                   [](const ResponseRow& a, const ResponseRow& b) { return a.direction < b.direction; });
  return rows;
}

}  // namespace

int responses(MPI_Comm comm, const ResponsesOptions& o) {
  const int rank = rank_of(comm);
  Progress progress(rank == 0 && !o.quiet);
  model::Case c = io::read_case(o.case_path, read_progress(progress), comm, o.changes);
  if (!c.statics.enabled) throw InputError(advice::responses_need_statics(c));
  if (std::none_of(c.bodies.begin(), c.bodies.end(), wave_forces))
    throw InputError(advice::no_wave_forces(c));
  const std::vector<int> bodies = chosen_bodies(c, o.body);
  const std::vector<std::string> paths = paths_of(c, bodies, o.output);
  const std::vector<double> omega = frequencies(c, o.periods);
  on_root(comm, [&] {
    for (const std::string& path : paths) check_table(path, kFirstColumns, "responses", c.inputs);
  });
  std::vector<LoadedVolume> volumes = load_volumes(c, comm, read_progress(progress));
  set_hydrostatics(c, volumes);
  c = with_targets_met(comm, std::move(c), volumes, progress);
  Simulation sim(comm, c, surfaces(volumes), skeletons(c, volumes), volume_facets(volumes));
  progress.print_notes(all_notes(c, volumes, sim.notes()));
  progress.print_warnings(sim.warnings());
  if (const std::vector<std::string> others = bodies_with_other_wave_loads(c); !others.empty())
    progress.print_notes({advice::waves_by_coefficients_only(others)});
  Events events(comm, sim);
  solve_static_stages(sim, events, progress);
  if (auto* thrusters = sim.system().find<DynamicPositioning>()) thrusters->integrate_at_rest(false);
  sim.bodies().exchange_poses(comm, sim.state().at_rest());
  const std::vector<WaveComponent> waves = unit_waves(sim, omega, o.directions);
  const std::map<int, std::vector<ComplexVec6>> found = motions(sim, bodies, waves, o.at);
  progress.end();
  if (rank == 0 && !o.quiet)
    fmt::print("\namplitudes in m/m and deg/m, lags in deg behind the crest at the body's origin\n");
  for (size_t i = 0; i < bodies.size(); ++i) {
    const std::vector<ResponseRow> rows = rows_of(comm, sim, bodies[i], waves, found);
    if (on_any_rank(comm, rank == 0 && !write_responses(paths[i], rows)))
      throw io::WriteError(io::cannot_write(paths[i], std::strerror(errno)));
    if (rank != 0 || o.quiet) continue;
    fmt::print("\nbody {} at ({:g}, {:g}, {:g}) in its frame:\n{}responses: {}\n",
               c.bodies[static_cast<size_t>(bodies[i])].name, o.at.x(), o.at.y(), o.at.z(),
               response_table(rows), paths[i]);
  }
  return 0;
}

}  // namespace hawser::run
