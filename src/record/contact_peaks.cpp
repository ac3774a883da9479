// The class ContactPeaks: section moment at each contact point of an element, from the balance of the part
// before that point.
#include "hawser/record/contact_peaks.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/terms/line_sections.hpp"

namespace hawser::record {

ContactPeaks::ContactPeaks(const model::Case& c, const System& system)
    : system_(system), contact_(system.find<LineVolumeContact>()) {
  const LocalMesh& mesh = system.mesh();
  EI_.reserve(mesh.elements.size());
  for (const LocalElement& e : mesh.elements) {
    auto& EI = EI_.emplace_back();
    const Element& g = mesh.element(e);
    if (!g.beam) continue;
    const BeamSection s = beam_section(*mesh.mesh, c, g);
    if (!s.bends_by_law()) EI = {s.EI2, s.EI3};
  }
}

void ContactPeaks::find(const std::vector<Field>& fields) {
  moment_ = find_field(fields, "bending_moment");
  moment_2_ = find_field(fields, "bending_moment_2");
  moment_3_ = find_field(fields, "bending_moment_3");
  curvature_ = find_field(fields, "curvature");
}

// Largest moment at the contact forces P_k, which act at x_k, between `from` and `to`. F and M: section force
// and moment at the first node x1, from its nodal force and the share of the P_k in it by shape functions; Q:
// sum of all other loads, uniform; s = xi:
//   m(s) = M + (x1 - x(s)) x (F + s Q/2) - sum over x_k before x(s) of (x_k - x(s)) x P_k.
ContactPeaks::Peak ContactPeaks::peak(const Kinematics& state, const LocalElement& e, const AxisShape& shape,
                                      std::span<const LineVolumeContact::Load> loads, double from,
                                      double to) const {
  Vec12 f = Vec12::Zero();
  system_.element_force(state, e, f);
  const auto part = [&f](int i) { return Vec3(f.segment<3>(3 * i)); };
  const Quat& q1 = state.q[e.first];
  const Quat& q2 = state.q[e.second];
  const Vec3 x1 = shape.point(0);
  // Section force and moment at the first node, and the non-contact loads along the element.
  Vec3 force = -part(0);
  Vec3 moment = -(q1 * part(1));
  Vec3 distributed = part(0) + part(2);
  for (const auto& load : loads) {
    const AxisShape::Weights H = shape.functions(load.xi);
    force += H[0] * load.force;
    moment += H[1] * shape.slope(0).cross(load.force);
  }
  Peak best;
  double largest = -1;
  for (const auto& place : loads) {
    if (place.xi < from || place.xi >= to) continue;
    const Vec3 arm = x1 - shape.point(place.xi);
    Vec3 m = moment + arm.cross(force + 0.5 * place.xi * distributed);
    for (const auto& before : loads)
      if (before.xi < place.xi) m -= (shape.point(before.xi) - shape.point(place.xi)).cross(before.force);
    const Quat q = q1.slerp(place.xi, q2);
    const double about2 = m.dot(q * Vec3::UnitY());
    const double about3 = m.dot(q * Vec3::UnitZ());
    if (const double size = std::hypot(about2, about3); size > largest) {
      largest = size;
      best = {place.xi, about2, about3};
    }
  }
  return best;
}

void ContactPeaks::fill(const Kinematics& state, std::vector<std::vector<double>>& values) const {
  if (!contact_ || moment_ < 0) return;
  const LocalMesh& mesh = system_.mesh();
  const std::vector<LineVolumeContact::Load> loads = contact_->loads(state);
  for (auto first = loads.begin(); first != loads.end();) {
    const auto last =
        std::find_if(first, loads.end(), [&](const auto& l) { return l.element != first->element; });
    const std::span<const LineVolumeContact::Load> loads_of_element(first, last);
    const size_t i = first->element;
    first = last;
    if (EI_[i][0] <= 0 || EI_[i][1] <= 0) continue;
    const LocalElement& e = mesh.elements[i];
    const AxisShape shape = contact_->axis(state, static_cast<int>(i));
    for (const LineEnd end : kLineEnds) {
      const int node = e.node_at(end);
      if (node >= mesh.owned) continue;
      // The half of the element beside the node.
      const double from = end == LineEnd::B ? 0.5 : 0;
      const double to = end == LineEnd::B ? HUGE_VAL : 0.5;
      const Peak p = peak(state, e, shape, loads_of_element, from, to);
      const auto value = [&](int field) -> double& { return values[field][node]; };
      const double size = std::hypot(p.about2, p.about3);
      if (size <= value(moment_)) continue;
      value(moment_) = size;
      value(moment_2_) = p.about2;
      value(moment_3_) = p.about3;
      value(curvature_) = std::max(value(curvature_), std::hypot(p.about2 / EI_[i][0], p.about3 / EI_[i][1]));
    }
  }
}

}  // namespace hawser::record
