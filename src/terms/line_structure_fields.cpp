// The class LineStructure: output of tension, declination, shear force, moments and curvature at nodes.
#include <algorithm>
#include <cmath>

#include "hawser/math/declination.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/terms/line_structure.hpp"

namespace hawser {

// A field with one value for each end of a beam and one for a cable (null: 0).
struct LineStructure::ElementField {
  // An end of a beam element.
  struct BeamEnd {
    const BeamStress& stress;
    const BeamEnds& ends;
    bool second = false;

    const Vec3& moment() const { return second ? stress.moment2 : stress.moment1; }
    const Vec3& curvature() const { return second ? stress.curvature2 : stress.curvature1; }
    // The moments of an element are in its axes, half way between those of its nodes. The output is in the
    // axes of the node.
    double moment_about(int axis) const {
      const Quat half = exp_so3((second ? -0.5 : 0.5) * log_so3(ends.q1.conjugate() * ends.q2));
      return (half * moment())[axis];
    }
  };

  Field field;
  double (*of_beam)(const BeamEnd&);
  double (*of_cable)(const CableSection&, const CableEnds&) = nullptr;
};

// Interpolates between the middles of the two elements at a node by their lengths. Moments of a beam are its
// end values. Where the two elements may differ (two_sided) the larger value is taken instead of a mean.
void LineStructure::fill_at_nodes(const ElementField& f, const Kinematics& k, std::span<double> out) const {
  std::fill(out.begin(), out.end(), 0.0);
  std::vector<double> weights(static_cast<size_t>(mesh_.owned), 0);
  const auto put = [&](int node, double value, double length) {
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
    put(b.element.first, f.of_beam({s, e, false}), b.section.length);
    put(b.element.second, f.of_beam({s, e, true}), b.section.length);
  }
  for (const Cable& c : cables_) {
    if (c.idle) continue;
    const double value = f.of_cable ? f.of_cable(section_for_output(c, k), ends(c, k)) : 0;
    put(c.element.first, value, c.section.length);
    put(c.element.second, value, c.section.length);
  }
  for (size_t n = 0; n < weights.size(); ++n)
    if (weights[n] > 0) out[n] /= weights[n];
}

void LineStructure::fields(FieldRegistry& registry) const {
  using BeamEnd = ElementField::BeamEnd;
  using History = Field::History;
  using Report = Field::Report;
  const std::vector<ElementField> of_lines{
      {{.name = "effective_tension",
        .unit = "N",
        .history = History::yes,
        .statistics = true,
        .at_stations = true,
        .report = Report::graph,
        .order = 1},
       [](const BeamEnd& e) { return e.stress.tension; },
       [](const CableSection& s, const CableEnds& e) { return cable_stress(s, e).tension; }},
      // Angle between the line's direction, from end A to end B, and the vertical: 0 is straight up.
      {{.name = "declination", .unit = "deg", .history = History::after_end_columns, .statistics = true},
       [](const BeamEnd& e) {
         return degrees(declination((e.second ? e.ends.q2 : e.ends.q1) * Vec3::UnitX()));
       },
       [](const CableSection&, const CableEnds& e) { return degrees(declination(e.x2 - e.x1)); }}};
  const std::vector<ElementField> forces_of_beams{
      {{.name = "shear_force",
        .unit = "N",
        .history = History::yes,
        .statistics = true,
        .report = Report::graph,
        .order = 6},
       [](const BeamEnd& e) { return e.stress.shear; }},
      // Magnitudes are taken by element, so that torsion between the axes of neighbours has no effect.
      {{.name = "bending_moment",
        .unit = "N m",
        .history = History::yes,
        .statistics = true,
        .at_stations = true,
        .extreme = "bending moment",
        .of_beams = true,
        .report = Report::graph,
        .order = 5},
       [](const BeamEnd& e) { return e.moment().tail<2>().norm(); }},
      {{.name = "bending_moment_2",
        .unit = "N m",
        .label = "bending moment about axis 2",
        .history = History::yes,
        .statistics = true},
       [](const BeamEnd& e) { return e.moment_about(1); }},
      {{.name = "bending_moment_3",
        .unit = "N m",
        .label = "bending moment about axis 3",
        .history = History::yes,
        .statistics = true},
       [](const BeamEnd& e) { return e.moment_about(2); }},
      {{.name = "torsion_moment",
        .unit = "N m",
        .history = History::yes,
        .statistics = true,
        .report = Report::graph,
        .order = 7},
       [](const BeamEnd& e) { return e.moment().x(); }}};
  const ElementField curvature{{.name = "curvature",
                                .unit = "1/m",
                                .history = History::yes,
                                .statistics = true,
                                .at_stations = true,
                                .extreme = "curvature",
                                .of_beams = true,
                                .report = Report::graph,
                                .order = 4},
                               [](const BeamEnd& e) { return e.curvature().tail<2>().norm(); }};
  const ElementField residual_curvature{{.name = "residual_curvature", .unit = "1/m"}, [](const BeamEnd& e) {
                                          return e.second ? e.stress.residual2 : e.stress.residual1;
                                        }};
  const auto add = [&](const ElementField& f) {
    registry.add(
        {f.field, [this, f](const Kinematics& k, std::span<double> out) { fill_at_nodes(f, k, out); }});
  };
  for (const ElementField& f : of_lines) add(f);
  // The condition is on the whole model, not on this rank, because all ranks must write the same fields.
  if (!mesh_.mesh->any_beam()) return;
  for (const ElementField& f : forces_of_beams) add(f);
  add_node_axes(registry);
  add(curvature);
  if (yields_) add(residual_curvature);
}

// Two of the three node axes are output, because a rotation vector would jump at half a turn.
void LineStructure::add_node_axes(FieldRegistry& registry) const {
  for (const int axis : {0, 1})
    registry.add({{.name = axis ? "axis_2" : "axis_1", .unit = "", .components = 3},
                  [this, axis](const Kinematics& k, std::span<double> out) {
                    for (size_t n = 0; n < static_cast<size_t>(mesh_.owned); ++n) {
                      const bool beam = mesh_.rotates(static_cast<int>(n));
                      const Vec3 a = beam ? Vec3(k.q[n] * Vec3::Unit(axis)) : Vec3(0, 0, 0);
                      for (size_t c = 0; c < 3; ++c) out[3 * n + c] = a[static_cast<Eigen::Index>(c)];
                    }
                  }});
}

}  // namespace hawser
