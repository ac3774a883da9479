// The class LinePairs: construction, contact laws, and sums over the pairs in contact.
#include <algorithm>
#include <stdexcept>

#include "hawser/math/ordered.hpp"
#include "hawser/terms/automatic_stiffness.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

constexpr auto all = [](const auto&) { return true; };

CandidateSettings sharing(CandidateSettings settings, const SharedPlaces& places) {
  settings.shared = &places;
  return settings;
}

ContactRadii radii(const std::vector<LinePairType>& types, const LinePairOptions& options) {
  std::vector<double> r;
  for (const LinePairType& t : types) r.push_back(t.radius);
  return ContactRadii(std::move(r), options.takes_part);
}

}  // namespace

LinePairs::LinePairs(MPI_Comm comm, const LocalMesh& mesh, std::vector<LinePairType> types,
                     LinePairOptions options)
    : mesh_(mesh),
      types_(std::move(types)),
      options_(std::move(options)),
      shared_(comm, mesh, radii(types_, options_), options_.shared, options_.first_part),
      candidates_(comm, mesh, radii(types_, options_), sharing(options_.candidates, shared_)),
      accounts_(static_cast<size_t>(mesh.owned)) {
  const bool automatic = std::all_of(types_.begin(), types_.end(), [](const LinePairType& t) {
    return !(t.radius > 0) || t.linear > 0 || t.cubic > 0;
  });
  const auto check = [&](const model::LinePairSettings& s) {
    if (s.basis == model::StiffnessBasis::per_point)
      throw std::invalid_argument("the contact stiffness of lines is per length or per area");
    if (s.basis == model::StiffnessBasis::automatic ? !automatic : !(s.normal_stiffness > 0))
      throw std::invalid_argument("contact of lines with lines has no stiffness");
  };
  check(options_.general);
  for (const auto& [lines, s] : options_.tuned) check(s);
}

LinePairLaw LinePairs::law(int segment_a, int segment_b) const {
  const auto tuned = options_.tuned.find(ordered(line_of_segment(segment_a), line_of_segment(segment_b)));
  const model::LinePairSettings& s = tuned == options_.tuned.end() ? options_.general : tuned->second;
  const LinePairType& A = type_of_segment(segment_a);
  const LinePairType& B = type_of_segment(segment_b);
  const double diameter = A.radius + B.radius;  // the mean of the two
  LinePairLaw law;
  law.radii = A.radius + B.radius;
  double factor = 1;
  if (s.basis == model::StiffnessBasis::per_area) factor = diameter;
  if (s.basis == model::StiffnessBasis::automatic) {
    law.normal.stiffness = std::max(A.linear, B.linear);
    law.normal.cubic = std::min(A.cubic, B.cubic);
  } else {
    law.normal.stiffness = s.normal_stiffness * factor;
  }
  law.normal.smoothing = s.smoothing.value_or(0.001 * diameter);
  law.normal.damping = contact_damping(
      s.relative_damping, law.normal.stiffness,
      A.mass_per_length * B.mass_per_length / std::max(A.mass_per_length + B.mass_per_length, 1e-300));
  law.friction.axial = law.friction.lateral = s.friction;
  law.friction.stiffness = s.shear_stiffness * factor;
  law.friction.axial_length = law.friction.lateral_length =
      s.mobilisation_length > 0 ? s.mobilisation_length : 0.01 * diameter;
  return law;
}

AxisEnds LinePairs::ends(const Kinematics& state, int segment) const {
  const ContactSegment& s = this->segment(segment);
  AxisEnds out = element_axis(state, s.element, s.first, s.second);
  if (fed_end(segment) >= 0) out.length = feeders_->find(s.global)->predicted;
  return out;
}

LinePairs::Rod LinePairs::rod(const Kinematics& state, int segment) const {
  const AxisEnds e = ends(state, segment);
  return {e.x1, e.x2, e.beam ? AxisShape(e).bezier().sagitta() : 0};
}

// True if the element has a neighbour at this end on the same line and outside feeders.
bool LinePairs::joint(const ContactSegment& s, int end) const {
  const LineSpan& l = mesh_.mesh->lines[s.element.line];
  if (end ? s.global + 1 >= l.first_element + l.elements : s.global <= l.first_element) return false;
  return !candidates_.is_in_feeder(end ? s.global + 1 : s.global - 1);
}

int LinePairs::active_count() const {
  return static_cast<int>(
      std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.counted && p.points; }));
}

double LinePairs::normal_force() const {
  return sum(all, [](const LinePairContactPoint& h) { return h.normal_force; });
}

double LinePairs::friction_force() const {
  return sum(all, [](const LinePairContactPoint& h) { return h.friction.norm(); });
}

}  // namespace hawser
