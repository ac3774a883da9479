// Tables of `hawser stiffness`: matrix at rest, forces and tensions over offsets, and their file.
#include "hawser/run/stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "hawser/advice/modes.hpp"
#include "hawser/advice/output_files.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/check.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/held_bodies.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/output_place.hpp"
#include "hawser/run/run_parts.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::run {
namespace {

struct StiffnessAtOffset {
  Offset offset{};
  Vec6 force = Vec6::Zero();  // of the lines on the body: N, N m, about the point, space axes
  Mat6 K = Mat6::Zero();
  std::vector<double> tensions;  // N, by line
};

// Names of the bodies with attached lines.
std::vector<std::string> carriers(const model::Case& c) {
  std::vector<std::string> out;
  const std::vector<std::vector<model::EndAtBody>> ends = model::line_ends_by_body(c);
  for (size_t b = 0; b < ends.size(); ++b)
    if (!ends[b].empty()) out.push_back(c.bodies[b].name);
  return out;
}

int chosen_body(const model::Case& c, const std::string& name) {
  const std::vector<std::string> all = carriers(c);
  if (all.empty()) throw InputError(advice::no_line_tied_to_body(c));
  if (name.empty() && all.size() > 1) throw InputError(advice::lines_tied_to_bodies(c, all));
  const std::string& requested = name.empty() ? all.front() : name;
  if (std::find(all.begin(), all.end(), requested) == all.end())
    throw InputError(advice::lines_not_tied_to(c, requested, all));
  const int body = c.body_index(requested);
  if (c.bodies[static_cast<size_t>(body)].ride) throw InputError(advice::body_rides_on_line(c, requested));
  return body;
}

// Rest, then the given offsets, then those in equal steps. Components that are zero but for rounding are 0.
std::vector<Offset> offsets_of(const StiffnessOptions& options) {
  std::vector<Offset> out{Offset{}};
  out.insert(out.end(), options.offsets.begin(), options.offsets.end());
  for (int k = 1; options.to > 0 && k <= options.steps; ++k) {
    const double distance = options.to * k / options.steps;
    const auto part = [distance](double component) {
      return std::abs(component) < 1e-15 ? 0 : distance * component;
    };
    out.push_back({part(std::cos(options.direction)), part(std::sin(options.direction)), 0, 0, 0, 0});
  }
  return out;
}

constexpr std::string_view kHead = "x offset [m],y offset [m],z offset [m],rx offset [deg]";

std::string stiffness_csv(const model::Case& c, const std::vector<StiffnessAtOffset>& rows) {
  std::string s(kHead);
  s += ",ry offset [deg],rz offset [deg],Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m]";
  for (int i = 1; i <= 6; ++i)
    for (int j = 1; j <= 6; ++j)
      s += fmt::format(",K{}{} [{}]", i, j, i <= 3 ? (j <= 3 ? "N/m" : "N/rad") : (j <= 3 ? "N" : "N m/rad"));
  for (const model::Line& line : c.lines) s += ",tension of " + line.name + " [N]";
  s += "\n";
  for (const StiffnessAtOffset& r : rows) {
    std::string row;
    for (size_t k = 0; k < 6; ++k)
      row += fmt::format("{}{:.10g}", k > 0 ? "," : "", r.offset[k] / (k < 3 ? 1 : kDegree));
    for (const double x : r.force) row += fmt::format(",{:.10g}", x);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) row += fmt::format(",{:.10g}", r.K(i, j));
    for (const double t : r.tensions) row += fmt::format(",{:.10g}", t);
    s += row + "\n";
  }
  return s;
}

std::string matrix_text(const Mat6& K) {
  const double largest[2] = {K.topLeftCorner<3, 3>().cwiseAbs().maxCoeff(),
                             K.bottomRightCorner<3, 3>().cwiseAbs().maxCoeff()};
  std::string s = fmt::format("{:>4}", "");
  for (const char* name : {"x", "y", "z", "rx", "ry", "rz"}) s += fmt::format(" {:>12}", name);
  s += "\n";
  const char* names[] = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
  for (int i = 0; i < 6; ++i) {
    s += fmt::format("{:>4}", names[i]);
    for (int j = 0; j < 6; ++j) {
      // Rounding errors relative to the diagonal are printed as 0.
      const double rounding = 1e-9 * std::sqrt(largest[i / 3] * largest[j / 3]);
      s += fmt::format(" {:>12.5g}", std::abs(K(i, j)) < rounding ? 0.0 : K(i, j));
    }
    s += "\n";
  }
  return s;
}

// In kN; rounding errors relative to the tension are 0.
double in_kN(double x, double tension) { return std::abs(x) < 1e-9 * tension ? 0 : x / 1000; }

std::string offset_table(const model::Case& c, const std::vector<StiffnessAtOffset>& rows) {
  std::string s = fmt::format("{:>10} {:>10} {:>12} {:>12} {:>12} {:>14}  {}\n", "x [m]", "y [m]", "Fx [kN]",
                              "Fy [kN]", "Fz [kN]", "tension [kN]", "of line");
  for (const StiffnessAtOffset& r : rows) {
    const auto largest = std::max_element(r.tensions.begin(), r.tensions.end());
    s += fmt::format("{:>10.4g} {:>10.4g} {:>12.6g} {:>12.6g} {:>12.6g} {:>14.6g}  {}\n", r.offset[0],
                     r.offset[1], in_kN(r.force[0], *largest), in_kN(r.force[1], *largest),
                     in_kN(r.force[2], *largest), *largest / 1000,
                     c.lines[static_cast<size_t>(largest - r.tensions.begin())].name);
  }
  return s;
}

// Gives mass to a body without it, at its pose at t = 0, so that it can be held elsewhere.
model::Case with_mass(model::Case c, int body) {
  model::Body& b = c.bodies[static_cast<size_t>(body)];
  if (b.mass) return c;
  b.mass.emplace();
  b.mass->mass = 1;
  b.mass->inertia = Vec3::Ones();
  return c;
}

// The rest pose displaced by an offset, which is that of `point`, about which the body rotates.
RigidPose displaced(const RigidPose& rest, const Offset& offset, const Vec3& point) {
  RigidPose out = rest;
  out.position += Vec3(offset.data());
  out.rotation = (exp_so3(Vec3(offset.data() + 3)) * rest.rotation).normalized();
  out.position += rest.rotation * point - out.rotation * point;
  return out;
}

// Forces, stiffness and tensions at rest and at each offset, with the body held there. Collective.
std::vector<StiffnessAtOffset> at_offsets(HeldBodies& held, const model::Case& c, int body,
                                          const StiffnessOptions& options) {
  const RigidPose rest = held.pose(body);
  const Vec3& centre = c.bodies[static_cast<size_t>(body)].mass->centre;
  std::vector<StiffnessAtOffset> rows;
  for (const Offset& offset : offsets_of(options)) {
    const RigidPose pose = displaced(rest, offset, options.at);
    if (!rows.empty()) held.put(body, pose);
    const Vec3 arm = pose.rotation * (options.at - centre);
    const BodyStiffness at_point = about_point(held.stiffness(body), arm, pose.rotation.toRotationMatrix());
    rows.push_back({offset, -at_point.f, at_point.K, held.tensions()});
  }
  return rows;
}

// Prints the pose at rest, forces and stiffness there, and the table over the offsets.
void print_stiffness(const model::Case& c, int body, const RigidPose& rest, const Vec3& reference_point,
                     const std::vector<StiffnessAtOffset>& rows) {
  const Vec3 point = rest.to_space(reference_point);
  const Vec3 turned = log_so3(rest.rotation) / kDegree;
  fmt::print(
      "\nbody {} at rest: point ({:.4f}, {:.4f}, {:.4f}) m, rotation vector ({:.4f}, {:.4f}, {:.4f}) deg\n",
      c.bodies[static_cast<size_t>(body)].name, point.x(), point.y(), point.z(), turned.x(), turned.y(),
      turned.z());
  const double largest = *std::max_element(rows.front().tensions.begin(), rows.front().tensions.end());
  Vec6 f = rows.front().force;
  for (double& x : f) x = in_kN(x, largest);
  fmt::print(
      "forces of its lines about this point: force ({:.5g}, {:.5g}, {:.5g}) kN, moment ({:.5g}, {:.5g}, "
      "{:.5g}) kN m\n",
      f[0], f[1], f[2], f[3], f[4], f[5]);
  fmt::print("stiffness of the lines [N/m, N/rad; N, N m/rad]:\n{}", matrix_text(rows.front().K));
  if (rows.size() > 1)
    fmt::print("\noffsets, with the other degrees of freedom held:\n{}", offset_table(c, rows));
}

}  // namespace

int stiffness(MPI_Comm comm, const StiffnessOptions& options) {
  const bool root = rank_of(comm) == 0;
  Progress progress(root && !options.quiet);
  model::Case c = io::read_case(options.case_path, read_progress(progress), comm, options.changes);
  const int body = chosen_body(c, options.body);
  const std::string path = path_of_output(c.path, options.output, "-stiffness.csv");
  if (std::filesystem::path(path).extension() != ".csv")
    throw InputError(advice::table_needs_csv(path, "stiffnesses"));
  on_root(comm, [&] { check_table(path, kHead, "stiffnesses", c.inputs); });
  if (!c.statics.enabled) throw InputError(advice::stiffness_needs_statics(c));
  std::vector<LoadedVolume> volumes = load_volumes(c, comm, read_progress(progress));
  set_hydrostatics(c, volumes);
  c = with_targets_met(comm, std::move(c), volumes, progress);
  const bool floats = c.bodies[static_cast<size_t>(body)].mass.has_value();
  c = with_mass(std::move(c), body);
  Simulation sim(comm, c, surfaces(volumes), skeletons(c, volumes), volume_facets(volumes));
  progress.print_notes(all_notes(c, volumes, sim.notes()));
  progress.print_warnings(sim.warnings());
  Events events(comm, sim);
  if (!floats) hold_body(sim, body);
  solve_static_stages(sim, events, progress);
  HeldBodies held(sim);
  const RigidPose rest = held.pose(body);
  const std::vector<StiffnessAtOffset> rows = at_offsets(held, c, body, options);
  progress.end();
  write_table(comm, path, root ? stiffness_csv(c, rows) : "");
  if (root && !options.quiet) {
    print_stiffness(c, body, rest, options.at, rows);
    fmt::print("\nstiffness table: {}\n", path);
  }
  return 0;
}

}  // namespace hawser::run
