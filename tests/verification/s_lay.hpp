// The 12 in pipe of the S-lay tests: its case and the results of statics.
#pragma once

#include <fmt/format.h>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/contact_peaks.hpp"
#include "hawser/record/touchdown.hpp"
#include "hawser/run/targets.hpp"
#include "hawser/run/volumes.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::s_lay_test {

constexpr double kEI = 3.75e7, kEA = 3.2e9, kWeight = 700, kPipe = 0.3239;  // N m², N, N/m, m
constexpr double kRadius = 120, kTop = 10, kDepth = 100, kEnd = 600;        // m, of the pipe's axis
constexpr double kRoller = 0.2, kSpacing = kRadius * 4 * M_PI / 180;        // m

struct Setting {
  double T0 = 0;                  // N
  double lift_off = 0, x_td = 0;  // deg, m: estimates for the start shape
  double arc = 0;                 // N/m per m, stiffness of an arc; 0: rollers
  int rollers = 0;                // every 4 degrees
  double bed = 1e6;               // N/m per m
  double over = 0.5;              // m, elements of the overbend
  bool peaks = true;              // peaks between nodes are shown at the nearer one
};

struct Laid {
  double T0 = 0, M0 = 0, H = 0, x_td = 0;  // N, N m, N, m
  double kappa_sag = 0, kappa_ob = 0;      // 1/m
  double last_touch = 0,
         last_force = 0;        // deg; N, contact force at the lift-off (shear force there on a rigid arc)
  double total = 0, depth = 0;  // N, m
  std::vector<double> roller_force, roller_kappa;  // N, 1/m
  int iterations = 0;
};

inline std::string case_text(const Setting& s) {
  // Start shape: a string along the arc, a catenary to the bed, and a straight line on the bed.
  const double phi = s.lift_off * M_PI / 180;
  const double z = kTop - kRadius + kRadius * std::cos(phi);
  const double a = (z + kDepth) / (1 / std::cos(phi) - 1);
  const double hanging = a * std::tan(phi);
  const double x_td = kRadius * std::sin(phi) + a * std::asinh(std::tan(phi));
  const double over = std::ceil((kRadius * phi + 20) / s.over) * s.over;
  std::string points;
  const auto add = [&](double x, double y) { points += fmt::format("[{:.9g}, 0, {:.9g}], ", x, y); };
  if (s.arc > 0) {
    for (int i = 0; i <= 60; ++i)
      add((kRadius + 0.01 * (i > 0)) * std::sin(phi * i / 60),
          kTop - kRadius + (kRadius + 0.01 * (i > 0)) * std::cos(phi * i / 60));
    for (int i = 1; i <= 60; ++i) {
      const double u = std::asinh(std::tan(phi)) * (1 - i / 60.);
      add(x_td - a * u, -kDepth + a * (std::cosh(u) - 1));
    }
    points += fmt::format("[{}, 0, {}]", kEnd, -kDepth);
  }
  const double rest = kRadius * phi + hanging - over;
  std::string stations;
  for (int i = 1; i <= s.rollers; ++i)
    stations +=
        fmt::format("{}{:.12g}", i > 1 ? ", " : "", (kRadius - 0.5 * kPipe - kRoller) * 4 * i * M_PI / 180);
  const std::string contact =
      s.arc > 0
          ? fmt::format(
                "volumes:\n  arc: {{shape: {{cylinder: {{from: [0, -2, {0}], to: [0, 2, {0}], radius: "
                "{1}}}}}, "
                "normal_stiffness: {{per_length: {2}}}, smoothing: 0}}\n",
                kTop - kRadius, kRadius - 0.5 * kPipe, s.arc)
          : fmt::format(
                "supports:\n  stinger:\n    path: {{from: [0, 0, {0}], direction: [1, 0, 0], segments: "
                "[{{length: {1}, radius: {2}}}]}}\n    boxes: [{{at: [{3}], type: flat, roller_diameter: "
                "{4}, "
                "roller_length: 2, normal_stiffness: 1e9}}]\n",
                kTop - 0.5 * kPipe - kRoller, 100.0, kRadius - 0.5 * kPipe - kRoller, stations, 2 * kRoller);
  return fmt::format(
      "hawser: 1\nenvironment: {{gravity: 10, seabed: {{depth: {0}, normal_stiffness: {{per_length: {1}}}, "
      "smoothing: "
      "0}}}}\n"
      "line_types: {{pipe: {{outer_diameter: {2}, mass_per_length: 70, EA: {3}, EI: {4}, GJ: {4}}}}}\n{5}"
      "lines:\n  pipe:\n    sections: [{{type: pipe, length: {6}, element_length: {7}}}, {{type: pipe, "
      "length: {8}, "
      "element_length: 2.5}}, {{type: pipe, length: {9}, element_length: 8}}]\n"
      "    end_a: {{anchor: [0, 0, {10}], direction: [1, 0, 0], clamped: true, no_contact_within: 0}}\n"
      "    end_b: {{anchor: [{11}, 0, {12}], direction: [1, 0, 0]}}\n{13}"
      "    target: {{tension: {14}, at: end_a, section: 3}}\ncontact: {{between_lines: false}}\n",
      kDepth + 0.5 * kPipe, s.bed, kPipe, kEA, kEI, contact, over, s.over, rest + 30, kEnd - x_td - 10 - 20,
      kTop, kEnd, -kDepth, points.empty() ? "" : "    start: {points: [" + points + "]}\n", s.T0);
}

// Statics with the length for the tension T0. Serial.
inline Laid laid(const Setting& s) {
  const model::Case given = io::read_case_text(case_text(s), "s-lay.yaml");
  const auto volumes = run::load_volumes(given, PETSC_COMM_SELF);
  const run::MetTargets met = run::meet_targets(PETSC_COMM_SELF, given, volumes);
  run::Simulation sim(PETSC_COMM_SELF, met.model, run::surfaces(volumes));
  Laid out;
  out.iterations = sim.solve_statics().iterations;
  const Kinematics at = sim.state().at_rest();
  const auto field = [&](const char* name) { return test::NodeField(sim, name).at(at); };
  std::vector<std::vector<double>> bent;
  std::vector<Field> fields;
  for (const char* name : {"bending_moment", "bending_moment_2", "bending_moment_3", "curvature"}) {
    bent.push_back(field(name));
    fields.emplace_back().name = name;
  }
  if (s.peaks) {
    record::ContactPeaks peaks(sim.model(), sim.system());
    peaks.find(fields);
    peaks.fill(at, bent);
  }
  const std::vector<double>& kappa = bent[3];
  const std::vector<double> T = field("effective_tension");
  const std::vector<double> pressed = field("contact_normal_force");
  const std::vector<double> shear = field("shear_force");
  const size_t nodes = static_cast<size_t>(sim.local().owned);
  out.T0 = T.front();
  out.H = T.back();
  out.M0 = kEI * kappa.front();
  out.x_td =
      record::Touchdowns(PETSC_COMM_SELF, met.model, sim.local()).of_all_lines(at).at(0).from_a->position.x();
  const auto angle = [&](size_t n) {
    return std::atan2(at.x[n].x(), at.x[n].z() - kTop + kRadius) * 180 / M_PI;
  };
  for (size_t n = 0; n < nodes; ++n) {
    const bool over = at.x[n].x() < kRadius && at.x[n].z() > kTop - kRadius;
    double& most = at.x[n].z() < -0.5 * kDepth ? out.kappa_sag : out.kappa_ob;
    most = std::max(most, kappa[n]);
    out.total += pressed[n];
    if (over)
      out.depth = std::max(out.depth, kRadius - std::hypot(at.x[n].x(), at.x[n].z() - kTop + kRadius));
  }
  ActiveContacts touches;
  sim.line_volume_contact()->active_contacts(touches);
  for (const ActiveContact& t : touches)
    out.last_touch = std::max(out.last_touch, t.to / kRadius * 180 / M_PI);
  // Extrapolation to the lift-off by a parabola through nodes more than an element beyond it, outside its
  // contact.
  const double lift_off = s.lift_off / 180 * M_PI * kRadius;
  const auto arc = [&](size_t n) { return sim.mesh().node(n).arc - lift_off; };
  size_t beyond = 0;
  while (arc(beyond) < 1.5 * s.over) ++beyond;
  for (const size_t i : {beyond, beyond + 1, beyond + 3}) {
    double share = shear[i];
    for (const size_t j : {beyond, beyond + 1, beyond + 3})
      if (j != i) share *= arc(j) / (arc(j) - arc(i));
    out.last_force += share;
  }
  const std::vector<Vec3> forces = sim.line_volume_contact()->forces_by_volume(at);
  for (int i = 1; i <= s.rollers; ++i) {
    out.roller_force.push_back(forces[static_cast<size_t>(i - 1)].norm());
    double most = 0;
    for (size_t n = 0; n < nodes; ++n)
      if (std::abs(angle(n) - 4 * i) < 1 && at.x[n].z() > kTop - kRadius) most = std::max(most, kappa[n]);
    out.roller_kappa.push_back(most);
  }
  return out;
}

}  // namespace hawser::s_lay_test
