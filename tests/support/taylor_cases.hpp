// The models of the term suite: every force term in all its states.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/terms/end_springs.hpp"
#include "hawser/terms/line_mass.hpp"
#include "hawser/terms/line_structure.hpp"
#include "hawser/terms/lines_in_water.hpp"
#include "hawser/terms/point_loads.hpp"
#include "support/taylor_contact.hpp"
#include "support/taylor_seabed.hpp"

namespace hawser::test {

inline const Vec3 kTurn(0.3, -0.4, 0.5);  // of element axes in node axes
inline const Mat3* suite_axes(bool turned) {
  static const Mat3 axes = exp_so3(kTurn).toRotationMatrix();
  return turned ? &axes : nullptr;
}

// Stiffnesses of similar size, so that no part is hidden by a larger one.
inline void add_structure(SuiteModel& m, double beta, double GA, bool turned, bool tables = false) {
  // The beams are bent and stretched into the steep and the flat parts of the curves.
  static const ResponseCurve tension(std::vector<ResponseCurve::Row>{{0.05, 15}, {0.2, 90}, {0.4, 120}},
                                     false);
  static const ResponseCurve moment(std::vector<ResponseCurve::Row>{{0.1, 5}, {0.3, 11}, {0.6, 13}}, true);
  const LocalMesh& l = m.system->mesh();
  std::vector<LineStructure::Beam> beams;
  std::vector<LineStructure::Cable> cables;
  for (const LocalElement& e : l.elements) {
    const Element& g = m.mesh.element(static_cast<size_t>(e.global));
    if (!g.beam) {
      cables.push_back({e, {}, {g.length, 300, beta, tables ? &tension : nullptr, turned ? 0.02 : 0}});
      continue;
    }
    LineStructure::Beam b{e, {}, {g.length, 300, 50, 80, 40, GA, beta}, {}};
    if (tables) {
      b.section.tension = &tension;
      b.section.moment = &moment;
      b.section.EI3 = b.section.EI2 = 60;
    }
    if (turned) {
      b.reference.axes = suite_axes(true);
      b.reference.psi = Vec3(0.1, -0.05, 0.08);
      b.reference.strain = 0.02;
    }
    beams.push_back(b);
  }
  m.system->add(std::make_unique<LineStructure>(l, std::move(beams), std::move(cables)));
}

inline void add_mass(SuiteModel& m, const Placement& at, bool turned) {
  const LocalMesh& l = m.system->mesh();
  std::vector<LineMass::MassElement> pieces;
  for (const LocalElement& e : l.elements) {
    const Element& g = m.mesh.element(static_cast<size_t>(e.global));
    LineMass::MassElement p;
    p.element = e;
    p.beam = g.beam;
    p.section = {g.length, 2, Vec3(0.5, 0.2, 0.4), suite_axes(turned)};
    p.load = at.rotation * Vec3(1, -2, -15);
    p.first_ramped = 0;
    p.ramped = 2;
    pieces.push_back(p);
  }
  m.system->add(std::make_unique<LineMass>(
      l, pieces,
      std::vector<LineMass::Load>{{at.rotation * Vec3(3, 0, 1), 2}, {at.rotation * Vec3(0, 5, 1), 0.5}}));
}

// The directors' accelerations differ slightly from those of w and alpha, as in a step.
inline void add_directors(SuiteModel& m, const Placement& at) {
  const LocalMesh& l = m.system->mesh();
  State& r = m.trial.rates;
  r.director_weight = 23;
  r.directors.assign(r.x.size(), Mat3::Zero());
  const State s = state_of(l, m.trial);
  for (size_t i = 0; i < r.x.size(); ++i) {
    const int g = l.global[i];
    r.directors[i] = director_acceleration(s.q[i], r.w[i], r.alpha[i]);
    for (int c = 0; c < 3; ++c) r.directors[i].col(c) += at.rotation * (0.4 * noise3(g, 20 + c));
  }
}

inline void add_loads(SuiteModel& m, const Placement& at, bool gravity) {
  const LocalMesh& l = m.system->mesh();
  std::vector<NodeLoad> loads;
  std::vector<NodeMass> masses;
  for (int n = 0; n < l.nodes(); ++n) {
    const int g = l.global[static_cast<size_t>(n)];
    if (g == 1 || g == 2)
      loads.push_back({n, at.rotation * Vec3(4, -3, 2), at.rotation * Vec3(5, 7, -6), g == 1 ? 0.0 : 1.5});
    if (g == 1) loads.push_back({n, Vec3::Zero(), at.rotation * Vec3(-2, 1, 3), 2});
    if (g == 5) loads.push_back({n, at.rotation * Vec3(0, 9, 2), Vec3::Zero(), 3});
    if (g == 0 || g == 6) masses.push_back({n, 4.0 + g});
  }
  m.system->add(std::make_unique<PointLoads>(l, loads));
  m.system->add(std::make_unique<PointMasses>(l, masses, gravity ? 9.81 : 0));
}

inline std::vector<SuiteCase> structure_cases() {
  std::vector<SuiteCase> out;
  const auto structure = [&](const char* name, double beta, double GA, bool turned, bool tables = false) {
    out.push_back({name, [=](MPI_Comm comm, const Placement& at) {
                     auto m = held_model(comm, at);
                     add_structure(*m, beta, GA, turned, tables);
                     m->system->prepare(at_end(m->trial.from, m->trial.h), m->trial.h);
                     return m;
                   }});
  };
  structure("structure", 0, 0, false);
  structure("structure, shear", 0, 200, false);
  structure("structure, damped", 0.3, 200, false);
  structure("structure, curved, damped", 0.3, 200, true);
  structure("structure, tables", 0, 0, false, true);
  structure("structure, tables, curved, damped", 0.3, 0, true, true);
  out.push_back(
      {"end springs", [](MPI_Comm comm, const Placement& at) {
         auto m = std::make_unique<SuiteModel>(comm, at);
         const LocalMesh& l = m->system->mesh();
         // One beside a rotating body, one nearly along its direction, one far from it.
         const auto bodies = std::make_shared<const Bodies>(
             std::vector<RigidMotion>{{at.point({1, 2, 3}), log_so3(at.rotation * exp_so3({0.1, 0.2, 0.3})),
                                       SteadyLaw{Vec3::Zero(), at.rotation * Vec3(1, 2, -2), 0.4}}});
         const State s = state_of(l, m->trial);
         std::vector<EndSpring> springs;
         for (int n = 0; n < l.owned; ++n) {
           const int g = l.global[static_cast<size_t>(n)];
           const Vec3 t = s.q[static_cast<size_t>(n)] * Vec3::UnitX();
           if (g == 0) springs.push_back({n, 0, Vec3(0.8, 0.6, 0), 70});
           if (g == 1)
             springs.push_back({n, -1, (t + 0.01 * (at.rotation * Vec3(1, 2, 3))).normalized(), 90});
           if (g == 3) springs.push_back({n, -1, at.rotation * Vec3(-0.6, 0, 0.8), 50});
         }
         m->system->add(std::make_unique<EndSprings>(l, bodies, springs));
         m->system->prepare(at_end(m->trial.from, m->trial.h), m->trial.h);
         return m;
       }});
  return out;
}

inline std::vector<SuiteCase> mass_and_load_cases() {
  std::vector<SuiteCase> out;
  for (const bool turned : {false, true})
    for (const bool step : {false, true})
      out.push_back({std::string("mass") + (turned ? ", turned axes" : "") + (step ? ", in a step" : ""),
                     [=](MPI_Comm comm, const Placement& at) {
                       auto m = held_model(comm, at);
                       add_mass(*m, at, turned);
                       if (step) add_directors(*m, at);
                       m->system->prepare(at_end(m->trial.from, m->trial.h), m->trial.h);
                       return m;
                     }});
  out.push_back({"point loads and masses", [](MPI_Comm comm, const Placement& at) {
                   auto m = held_model(comm, at);
                   // The weight does not rotate with the model.
                   add_loads(*m, at, at.rotation.isApprox(Quat::Identity()));
                   m->system->prepare(at_end(m->trial.from, m->trial.h), m->trial.h);
                   return m;
                 }});
  return out;
}

// A sea with its surface at the height of the lines (or far above them), a current whose direction varies
// with depth, and a buoy. The sea is level: `at` may rotate it about z only. The sections are so thick that
// none comes to the limits of the partly wet range, where the second derivative is infinite.
inline void add_water(SuiteModel& m, const Placement& at, double surface, bool waves = false) {
  constexpr double radius = 2;
  const LocalMesh& l = m.system->mesh();
  std::vector<LinesInWater::WetElement> pieces;
  for (const LocalElement& e : l.elements) {
    const Element& g = m.mesh.element(static_cast<size_t>(e.global));
    LinesInWater::WetElement p;
    p.element = e;
    p.beam = g.beam;
    p.section = {g.length, radius, 40, 4, 3, 1, 2, 0.7};
    pieces.push_back(p);
  }
  std::vector<LinesInWater::Ball> balls;
  for (int n = 0; n < l.owned; ++n)
    if (const int g = l.global[static_cast<size_t>(n)]; g == 2 || g == 6)
      balls.push_back({n, {20, 2, 1, 3, 0.6}});
  Sea sea;
  sea.surface = surface;
  sea.current = CurrentProfile(
      {{surface - 20, at.rotation * Vec3(0.5, 1, 0)}, {surface + 20, at.rotation * Vec3(-1.5, 3, 0)}});
  sea.current_ramp = 1.5;
  sea.current_factor = TimeFactor({{0, 0.4}, {2, 1.6}});
  if (waves) {
    std::vector<WaveComponent> components;
    for (const Vec3& omega_and_way : {Vec3(0.9, 0.6, 0.8), Vec3(1.4, -1, 0)}) {
      WaveComponent w;
      const Vec3 way = at.rotation * Vec3(omega_and_way.y(), omega_and_way.z(), 0);
      w.amplitude = 0.3;
      w.omega = omega_and_way.x();
      w.x = way.x();
      w.y = way.y();
      w.phase = 0.4 - wave_number(w.omega, 0, sea.gravity) * way.dot(at.shift);
      components.push_back(w);
    }
    sea.waves = WaveField(std::move(components), 0, sea.gravity, Stretching::wheeler);
    sea.wave_ramp = 3;
  }
  m.system->add(std::make_unique<LinesInWater>(l, sea, std::move(pieces), std::move(balls)));
}

inline std::vector<SuiteCase> water_cases() {
  std::vector<SuiteCase> out;
  for (const auto& [name, surface, step, waves] : {std::tuple{"water, deep", 10.0, false, false},
                                                   {"water, deep, in a step", 10.0, true, false},
                                                   {"water, waves", 0.2, true, true},
                                                   {"water, at the surface", 0.1, true, false}})
    out.push_back({name, [surface = surface, step = step, waves = waves](MPI_Comm comm, const Placement& at) {
                     auto m = held_model(comm, at);
                     add_water(*m, at, surface, waves);
                     if (step) add_directors(*m, at);
                     m->system->prepare(at_end(m->trial.from, m->trial.h), m->trial.h);
                     return m;
                   }});
  return out;
}

inline std::vector<SuiteCase> contact_cases() {
  std::vector<SuiteCase> out;
  constexpr std::pair<ContactOn, const char*> kinds[] = {
      {ContactOn::plane, "plane"}, {ContactOn::cylinder, "cylinder"}, {ContactOn::face, "face"},
      {ContactOn::edge, "edge"},   {ContactOn::vertex, "vertex"},     {ContactOn::corner, "corner"}};
  for (const auto& [on, name] : kinds)
    for (const auto& [axial, lateral, friction] :
         {std::tuple{0.0, 0.0, "smooth"}, {0.3, 0.3, "isotropic"}, {0.2, 0.5, "anisotropic"}})
      out.push_back({std::string("contact, ") + name + ", " + friction,
                     [on = on, axial = axial, lateral = lateral](MPI_Comm comm, const Placement& at) {
                       auto m = std::make_unique<SuiteModel>(comm, at);
                       add_contact(*m, at, on, axial, lateral);
                       return m;
                     }});
  for (const auto& [on, name] : kinds)
    for (const double friction : {0.0, 0.3})
      out.push_back({std::string("contact, gap, ") + name + (friction > 0 ? "" : ", smooth"),
                     [on = on, friction](MPI_Comm comm, const Placement& at) {
                       auto m = std::make_unique<SuiteModel>(comm, at);
                       add_contact(*m, at, on, friction, friction, model::ContactMethod::gap);
                       return m;
                     }});
  return out;
}

inline std::vector<SuiteCase> all_cases() {
  std::vector<SuiteCase> out = structure_cases();
  for (auto list : {mass_and_load_cases(), water_cases(), seabed_cases(), contact_cases()})
    out.insert(out.end(), list.begin(), list.end());
  out.push_back({"everything", [](MPI_Comm comm, const Placement& at) {
                   auto m = held_model(comm, at);
                   add_structure(*m, 0.01, 200, true);
                   add_mass(*m, at, true);
                   add_loads(*m, at, at.rotation.isApprox(Quat::Identity()));
                   add_contact(*m, at, ContactOn::cylinder, 0.3, 0.3);
                   add_directors(*m, at);
                   return m;
                 }});
  return out;
}

}  // namespace hawser::test
