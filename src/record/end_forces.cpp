// The class EndForces: selection of nodes, and section force and moment from the nodal forces of the adjacent
// element.
#include "hawser/record/end_forces.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/mpi.hpp"

namespace hawser::record {

double SectionForce::tension() const {
  const double along = force.dot(direction);
  return beam ? along : std::max(along, 0.0);
}

EndForces::EndForces(const System& system, const Feeders* feeders) : system_(system), feeders_(feeders) {
  const LocalMesh& local = system.mesh();
  const Mesh& mesh = *local.mesh;
  std::vector<int> at(static_cast<size_t>(local.owned), -1);
  for (size_t i = 0; i < local.elements.size(); ++i) {
    const LocalElement& e = local.elements[i];
    for (const LineEnd end_of_element : kLineEnds) {
      const int node = e.node_at(end_of_element);
      if (node >= local.owned) continue;
      const int global = local.global[node];
      const Node& g = mesh.node(global);
      const LineSpan& span = mesh.lines[g.line];
      std::optional<LineEnd> line_end;
      for (const LineEnd end : kLineEnds)
        if (global == span.end_node(end)) line_end = end;
      if (!line_end && !g.two_sided) continue;
      if (at[node] < 0) {
        at[node] = static_cast<int>(places_.size());
        places_.push_back({node, g.line, line_end, -1, -1, {}});
      }
      SectionNode& p = places_[at[node]];
      (end_of_element == LineEnd::B ? p.before : p.after) = static_cast<int>(i);
    }
  }
  std::sort(places_.begin(), places_.end(),
            [](const SectionNode& a, const SectionNode& b) { return a.node < b.node; });
}

int EndForces::end_at(int node) const {
  int ends = 0;
  for (const SectionNode& p : places_) {
    if (p.node == node) return p.line_end ? ends : -1;
    ends += p.line_end.has_value();
  }
  return -1;
}

void EndForces::evaluate(const Kinematics& state, std::span<const Vec3> support_forces) {
  for (SectionNode& p : places_) {
    if (p.before >= 0) p.sides[0] = section(state, p.before, LineEnd::B, support_forces);
    if (p.after >= 0) p.sides[1] = section(state, p.after, LineEnd::A, support_forces);
    if (p.before < 0) p.sides[0] = p.sides[1];
    if (p.after < 0) p.sides[1] = p.sides[0];
  }
  if (feeders_) evaluate_feed_points(state, support_forces);
}

// Ends inside feeders have the force at the feed point. The force on a feeder is
//   F = N + (m_2²/EI_2 + m_3²/EI_3)/2,
// with the tension N and, for an elastic beam, the moments m_2 and m_3 there (docs/theory/feeders.md). One
// rank computes it; one maximum over the ranks exchanges the numbers of all feeders.
void EndForces::evaluate_feed_points(const Kinematics& state, std::span<const Vec3> support_forces) {
  constexpr size_t kNumbers = 10;  // force, moment, direction, feeder force
  const auto& elements = system_.mesh().elements;
  const std::vector<Feeder>& feeders = feeders_->all();
  std::vector<double> all(kNumbers * feeders.size(), -HUGE_VAL);
  for (size_t k = 0; k < feeders.size(); ++k) {
    const Feeder& f = feeders[k];
    const LocalElement* e = feeders_->at_feed_point(f);
    if (!e || !e->counted) continue;
    const SectionForce m = section(state, static_cast<int>(e - elements.data()), f.line_end, support_forces);
    double* to = all.data() + kNumbers * k;
    for (const Vec3* v : {&m.force, &m.moment, &m.direction}) to = std::copy(v->begin(), v->end(), to);
    *to = m.tension();
    if (f.beam && !f.beam_section.plastic) {
      const Vec3 local_moment = state.q[e->node_at(f.line_end)].conjugate() * m.moment;
      *to += 0.5 * (local_moment.y() * local_moment.y() / f.beam_section.EI2 +
                    local_moment.z() * local_moment.z() / f.beam_section.EI3);
    }
  }
  all_reduce(system_.comm(), MPI_MAX, all);
  feed_points_.assign(feeders.size(), {});
  feeder_forces_.assign(feeders.size(), 0);
  for (size_t k = 0; k < feeders.size(); ++k) {
    const double* from = all.data() + kNumbers * k;
    feed_points_[k] = {Vec3(from), Vec3(from + 3), Vec3(from + 6), feeders[k].beam};
    feeder_forces_[k] = from[9];
    for (SectionNode& p : places_)
      if (p.line == feeders[k].line && p.line_end == feeders[k].line_end)
        p.sides = {feed_points_[k], feed_points_[k]};
  }
}

// Force n and moment m on the section at a node, from the force f and moment c (node axes, rotation R) of its
// element there, f = f_internal + M a - loads (docs/theory/end-forces.md):
//   n = -f, m = -R c at the first node,  n = f, m = R c at the second.
// Tension N = n.t with the tangent t = R e_x of a beam. A cable has t = n/|n| where it hangs freely and is
// taut, n.d > max(|f_2 - f_1|/2, |n|)/2 with the direction d of the chord, else t = d.
SectionForce EndForces::section(const Kinematics& state, int element, LineEnd end,
                                std::span<const Vec3> support_forces) const {
  const LocalMesh& local = system_.mesh();
  const LocalElement& e = local.elements[element];
  Vec12 f = Vec12::Zero();
  system_.element_force(state, e, f);
  const auto part = [&f](int i) { return Vec3(f.segment<3>(3 * i)); };
  const size_t i = e.first;
  const size_t j = e.second;
  const bool second = end == LineEnd::B;
  const size_t n = second ? j : i;
  SectionForce s;
  s.beam = local.element(e).beam;
  s.force = second ? part(2) : Vec3(-part(0));
  if (s.beam) {
    s.moment = state.q[n] * (second ? part(3) : Vec3(-part(1)));
    s.direction = state.q[n] * Vec3::UnitX();
    return s;
  }
  // A taut, freely hanging cable is parallel to its tension; its chord has the direction at mid-element.
  const Vec3 chord = (state.x[j] - state.x[i]).normalized();
  const double middle = 0.5 * (part(2) - part(0)).norm();
  const bool hangs = support_forces[i].isZero(0) && support_forces[j].isZero(0);
  const bool taut = s.force.dot(chord) > 0.5 * std::max(middle, s.force.norm());
  s.direction = hangs && taut ? s.force.normalized() : chord;
  return s;
}

}  // namespace hawser::record
