// Tables of `hawser responses`: waves, motion of a point of each body, and its file.
#include "hawser/run/responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <span>
#include <tuple>

#include "hawser/advice/output_files.hpp"
#include "hawser/advice/responses.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
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

namespace hawser::run {
namespace {

constexpr std::string_view kFirstColumns = "period [s],direction [deg]";
constexpr size_t kMostShown = 16;   // of a table on the terminal
constexpr double kRoundOff = 1e-9;  // of the largest of the three translations, or rotations

// Table of the wave forces that act on a body; null: none.
const WaveForceTable* wave_forces(const model::Body& b) {
  return b.mass && b.mass->hydrodynamics ? b.mass->hydrodynamics->wave_forces() : nullptr;
}

// Bodies that waves of the case would load, but not by coefficients.
std::vector<std::string> bodies_with_other_wave_loads(const model::Case& c) {
  std::vector<std::string> out;
  for (const model::Body& b : c.bodies)
    if (b.mass && (!b.mass->members.empty() || (!wave_forces(b) && (b.mass->hull || b.mass->in_water))))
      out.push_back(b.name);
  return out;
}

// What has quadratic damping that is zero at rest.
std::vector<std::string> with_quadratic_damping(const model::Case& c) {
  std::vector<std::string> out;
  for (const model::Body& b : c.bodies)
    if (b.mass && b.mass->hydrodynamics && !b.mass->hydrodynamics->quadratic_damping.isZero(0))
      out.push_back("body " + b.name);
  const bool drag = std::any_of(c.line_types.begin(), c.line_types.end(),
                                [](const model::LineType& t) { return t.Cd_normal > 0; });
  const model::Water& water = c.environment.water;
  if (drag && water.present && water.current.profile.empty() && !c.lines.empty()) out.push_back("lines");
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
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// The first of directions [rad] that differ by whole turns.
std::vector<double> distinct(const std::vector<double>& directions) {
  constexpr double kSame = 1e-9;
  std::vector<double> out;
  for (const double d : directions)
    if (std::none_of(out.begin(), out.end(),
                     [&](double other) { return std::abs(std::remainder(d - other, 2 * M_PI)) < kSame; }))
      out.push_back(d);
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
  directions = distinct(directions);
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
  int body = 0;
  double period = 0, direction = 0;          // s; deg relative to the bow
  std::array<double, 6> amplitude{}, lag{};  // m/m, deg/m; deg
};

// motion: translations and rotations in axes of the heading, relative to the crest at the body.
ResponseRow response_row(int body, const WaveComponent& w, double heading, const ComplexVec6& motion) {
  ResponseRow out{body, 2 * M_PI / w.omega, from_bow(w, heading), {}, {}};
  for (Eigen::Index k = 0; k < 6; ++k) {
    const double largest = motion.segment<3>(k / 3 * 3).cwiseAbs().maxCoeff();
    const double size = std::abs(motion[k]);
    if (!(size > kRoundOff * largest)) continue;
    out.amplitude[static_cast<size_t>(k)] = size / (k < 3 ? 1 : kDegree);
    out.lag[static_cast<size_t>(k)] = all_round(-std::arg(motion[k])) / kDegree;
  }
  return out;
}

std::string responses_csv(std::span<const ResponseRow> rows) {
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
  return s;
}

// Up to kMostShown rows, from the shortest to the longest period, of the direction nearest to the bow.
std::string response_table(std::span<const ResponseRow> all) {
  std::string s = fmt::format("{:>10} {:>8}", "period [s]", "to [deg]");
  for (const char* name : kFreedomNames) s += fmt::format(" {:>8} {:>5}", name, "lag");
  s += "\n";
  const auto nearer = [](const ResponseRow& a, const ResponseRow& b) {
    return std::abs(a.direction) < std::abs(b.direction);
  };
  const double direction = std::min_element(all.begin(), all.end(), nearer)->direction;
  std::vector<ResponseRow> rows;
  std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
               [&](const ResponseRow& r) { return r.direction == direction; });
  const size_t shown = std::min(rows.size(), kMostShown);
  for (size_t k = 0; k < shown; ++k) {
    const ResponseRow& r = rows[shown == 1 ? 0 : k * (rows.size() - 1) / (shown - 1)];
    s += fmt::format("{:>10.4g} {:>8.4g}", r.period, r.direction);
    for (size_t i = 0; i < 6; ++i)
      s += fmt::format(" {:>8.4g} {:>5.0f}", r.amplitude[i], std::fmod(std::round(r.lag[i]), 360));
    s += "\n";
  }
  if (shown < all.size()) s += fmt::format("these are {} of the {} rows of the table\n", shown, all.size());
  return s;
}

// Path of the table of each body.
std::vector<std::string> paths_of(const model::Case& c, const std::vector<int>& bodies,
                                  const std::string& output) {
  const std::string requested = path_of_output(c.path, output, "-responses.csv");
  if (std::filesystem::path(requested).extension() != ".csv")
    throw InputError(advice::table_needs_csv(requested, "responses"));
  std::vector<std::string> out;
  for (const int b : bodies)
    out.push_back(bodies.size() > 1 ? table_of_body(requested, c.bodies[static_cast<size_t>(b)].name)
                                    : requested);
  if (std::set(out.begin(), out.end()).size() < out.size()) throw InputError(advice::bodies_share_a_table(c));
  return out;
}

// Rows of the point `at` of each body, by body, direction and period, on the first rank: its six freedoms in
// axes of its heading, relative to the crest at its place. Collective.
std::vector<ResponseRow> rows_of(MPI_Comm comm, Simulation& sim, const std::vector<int>& bodies,
                                 const std::vector<WaveComponent>& waves, const Vec3& at) {
  std::vector<ResponseRow> own;
  linear_responses(sim.system(), sim.state().at_rest(), waves, [&](size_t i, const std::vector<Complex>& u) {
    const WaveComponent& w = waves[i];
    for (const int b : bodies) {
      const int node = sim.bodies().local_node(b);
      if (!sim.local().owns(node)) continue;
      const auto* of_body = &u[3 * static_cast<size_t>(sim.local().block[node])];
      const WaveReference reference = reference_of(sim, b);
      const Mat3 H = heading_axes(reference.heading);
      const Mat3 R = sim.state().q[node].toRotationMatrix();
      const Vec3 arm = R * (at - sim.model().bodies[static_cast<size_t>(b)].mass->centre);
      const Eigen::Vector3cd turn = R * Eigen::Map<const Eigen::Vector3cd>(of_body + 3);
      const Eigen::Vector3cd moved = Eigen::Map<const Eigen::Vector3cd>(of_body) - hat(arm) * turn;
      const double phase = w.number * (w.x * reference.place.x() + w.y * reference.place.y());
      ComplexVec6 motion;
      motion << H.transpose() * moved, H.transpose() * turn;
      own.push_back(response_row(b, w, reference.heading, std::polar(1.0, phase) * motion));
    }
  });
  std::vector<ResponseRow> rows;
  GatherPlan(comm, static_cast<int>(own.size())).gather_on_first(own.data(), rows);
  std::stable_sort(rows.begin(), rows.end(), [](const ResponseRow& a, const ResponseRow& b) {
    return std::tie(a.body, a.direction) < std::tie(b.body, b.direction);
  });
  return rows;
}

// Writes and prints the table of each body from the rows of the first rank. Collective.
void report(MPI_Comm comm, const model::Case& c, const std::vector<int>& bodies,
            const std::vector<std::string>& paths, const std::vector<ResponseRow>& rows,
            const ResponsesOptions& options) {
  const bool root = rank_of(comm) == 0;
  const bool prints = root && !options.quiet;
  if (prints)
    fmt::print(
        "\namplitudes in m/m and deg/m, lags in deg behind the crest at the body's origin, directions from "
        "its bow\n");
  const size_t each = rows.size() / bodies.size();
  for (size_t i = 0; i < bodies.size(); ++i) {
    const std::span<const ResponseRow> of_body = std::span(rows).subspan(i * each, each);
    write_table(comm, paths[i], root ? responses_csv(of_body) : "");
    if (!prints) continue;
    fmt::print("\nbody {} at ({:g}, {:g}, {:g}) in its frame:\n{}responses: {}\n",
               c.bodies[static_cast<size_t>(bodies[i])].name, options.at.x(), options.at.y(), options.at.z(),
               response_table(of_body), paths[i]);
  }
}

}  // namespace

int responses(MPI_Comm comm, const ResponsesOptions& options) {
  Progress progress(rank_of(comm) == 0 && !options.quiet);
  model::Case c = io::read_case(options.case_path, read_progress(progress), comm, options.changes);
  if (!c.statics.enabled) throw InputError(advice::responses_need_statics(c));
  if (std::none_of(c.bodies.begin(), c.bodies.end(), wave_forces))
    throw InputError(advice::no_wave_forces(c));
  for (const model::Body& b : c.bodies)
    if (b.mass && b.mass->positioning) throw InputError(advice::no_filter_of_thrusters(c, b.name));
  const std::vector<int> bodies = chosen_bodies(c, options.body);
  const std::vector<std::string> paths = paths_of(c, bodies, options.output);
  const std::vector<double> omega = frequencies(c, options.periods);
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
  if (const std::vector<std::string> damped = with_quadratic_damping(c); !damped.empty())
    progress.print_notes({advice::no_quadratic_damping(damped)});
  Events events(comm, sim);
  solve_static_stages(sim, events, progress);
  sim.bodies().exchange_poses(comm, sim.state().at_rest());
  const std::vector<WaveComponent> waves = unit_waves(sim, omega, options.directions);
  const std::vector<ResponseRow> rows = rows_of(comm, sim, bodies, waves, options.at);
  progress.end();
  report(comm, c, bodies, paths, rows, options);
  return 0;
}

}  // namespace hawser::run
