// The class LineStructure: output of tension, declination, shear force, moments and curvature at nodes.
#include <algorithm>
#include <cmath>

#include "hawser/math/declination.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/terms/line_structure.hpp"

namespace hawser {

void LineStructure::fields(FieldRegistry& registry) const {
  // Interpolates between the middles of the two elements at a node by their lengths. Moments of a beam are
  // its end values. Where the two elements may differ (two_sided) the larger value is taken instead of a
  // mean.
  auto at_nodes = [this](auto&& of_beam, auto&& of_cable) {
    return [this, of_beam, of_cable](const Kinematics& k, std::span<double> out) {
      std::fill(out.begin(), out.end(), 0.0);
      std::vector<double> weights(static_cast<size_t>(mesh_.owned), 0);
      auto put = [&](int node, double value, double length) {
        if (node >= mesh_.owned) return;
        const size_t n = node;
        if (mesh_.node(n).two_sided) {
          if (std::abs(value) > std::abs(out[n])) out[n] = value;
          return;
        }
        weights[n] += 1 / length;
        out[n] += value / length;
      };
      for (const Beam& b : beams_) {
        if (b.idle) continue;
        const BeamEnds e = ends(b, k);
        const BeamStress s = beam_stress(b.section, b.reference, e);
        put(b.at.first, of_beam(s, e, 0), b.section.length);
        put(b.at.second, of_beam(s, e, 1), b.section.length);
      }
      for (const Cable& c : cables_) {
        if (c.idle) continue;
        const double value = of_cable(section_for_output(c, k), ends(c, k));
        put(c.at.first, value, c.section.length);
        put(c.at.second, value, c.section.length);
      }
      for (size_t n = 0; n < weights.size(); ++n)
        if (weights[n] > 0) out[n] /= weights[n];
    };
  };
  auto nothing = [](const CableSection&, const CableEnds&) { return 0.0; };
  using History = Field::History;
  using Report = Field::Report;
  registry.add(
      {{.name = "effective_tension",
        .unit = "N",
        .history = History::yes,
        .statistics = true,
        .at_stations = true,
        .report = Report::graph,
        .order = 1},
       at_nodes([](const BeamStress& s, const BeamEnds&, int) { return s.tension; },
                [](const CableSection& s, const CableEnds& e) { return cable_stress(s, e).tension; })});
  // Angle between the line's direction, from end A to end B, and the vertical: 0 is straight up.
  registry.add(
      {{.name = "declination", .unit = "deg", .history = History::behind_ends, .statistics = true},
       at_nodes([](const BeamStress&, const BeamEnds& e,
                   int end) { return degrees(declination((end ? e.q2 : e.q1) * Vec3::UnitX())); },
                [](const CableSection&, const CableEnds& e) { return degrees(declination(e.x2 - e.x1)); })});
  // The condition is on the whole model, not on this rank, because all ranks must write the same fields.
  if (!mesh_.mesh->any_beam()) return;
  registry.add({{.name = "shear_force",
                 .unit = "N",
                 .history = History::yes,
                 .statistics = true,
                 .report = Report::graph,
                 .order = 6},
                at_nodes([](const BeamStress& s, const BeamEnds&, int) { return s.shear; }, nothing)});
  // Magnitudes are taken by element, so that torsion between the axes of neighbours has no effect.
  registry.add({{.name = "bending_moment",
                 .unit = "N m",
                 .history = History::yes,
                 .statistics = true,
                 .at_stations = true,
                 .extreme = "bending moment",
                 .of_beams = true,
                 .report = Report::graph,
                 .order = 5},
                at_nodes([](const BeamStress& s, const BeamEnds&,
                            int end) { return (end ? s.moment2 : s.moment1).tail<2>().norm(); },
                         nothing)});
  // The moments of an element are in its axes, half way between those of its nodes. The output is in the axes
  // of the node.
  for (const int axis : {1, 2})
    registry.add({{.name = axis == 1 ? "bending_moment_2" : "bending_moment_3",
                   .unit = "N m",
                   .label = axis == 1 ? "bending moment about axis 2" : "bending moment about axis 3",
                   .history = History::yes,
                   .statistics = true},
                  at_nodes(
                      [axis](const BeamStress& s, const BeamEnds& e, int end) {
                        const Quat half = exp_so3((end ? -0.5 : 0.5) * log_so3(e.q1.conjugate() * e.q2));
                        return (half * (end ? s.moment2 : s.moment1))[axis];
                      },
                      nothing)});
  registry.add({{.name = "torsion_moment",
                 .unit = "N m",
                 .history = History::yes,
                 .statistics = true,
                 .report = Report::graph,
                 .order = 7},
                at_nodes([](const BeamStress& s, const BeamEnds&,
                            int end) { return (end ? s.moment2 : s.moment1).x(); },
                         nothing)});
  // Two of the three node axes are output, because a rotation vector would jump at half a turn.
  for (const int axis : {0, 1})
    registry.add({{.name = axis ? "axis_2" : "axis_1", .unit = "", .components = 3},
                  [this, axis](const Kinematics& k, std::span<double> out) {
                    for (size_t n = 0; n < static_cast<size_t>(mesh_.owned); ++n) {
                      const bool beam = mesh_.rotates(static_cast<int>(n));
                      const Vec3 a = beam ? Vec3(k.q[n] * Vec3::Unit(axis)) : Vec3(0, 0, 0);
                      for (size_t c = 0; c < 3; ++c) out[3 * n + c] = a[static_cast<Eigen::Index>(c)];
                    }
                  }});
  registry.add({{.name = "curvature",
                 .unit = "1/m",
                 .history = History::yes,
                 .statistics = true,
                 .at_stations = true,
                 .extreme = "curvature",
                 .of_beams = true,
                 .report = Report::graph,
                 .order = 4},
                at_nodes([](const BeamStress& s, const BeamEnds&,
                            int end) { return (end ? s.curvature2 : s.curvature1).tail<2>().norm(); },
                         nothing)});
  if (yields_)
    registry.add({{.name = "residual_curvature", .unit = "1/m"},
                  at_nodes([](const BeamStress& s, const BeamEnds&,
                              int end) { return end ? s.residual2 : s.residual1; },
                           nothing)});
}

}  // namespace hawser
