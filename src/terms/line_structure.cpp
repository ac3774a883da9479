// The class LineStructure: beam and cable elements from the line types, assembly of their forces, softening
// for statics, and strain limits.
#include "hawser/terms/line_structure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/kernels/tension_peak.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/line_sections.hpp"

namespace hawser {
namespace {

// State at the start of a step of length h. Where h is shorter than the step before, the strain's increment
// of that step is scaled by h/previous_h. In a longer step it is not scaled up, because the energy of the
// filter must not increase.
CableStart scaled_start(const LineStructure::Cable& c, double h, double previous_h) {
  CableStart s = c.start;
  if (h < previous_h) s.strain_increment *= h / previous_h;
  return s;
}

}  // namespace

BeamEnds ends(const LineStructure::Beam& b, const Kinematics& k) {
  const size_t i = b.element.first;
  const size_t j = b.element.second;
  BeamEnds e;
  e.x1 = k.x[i];
  e.x2 = k.x[j];
  e.q1 = k.q[i];
  e.q2 = k.q[j];
  if (b.section.beta > 0) {
    e.v1 = k.v[i];
    e.v2 = k.v[j];
    e.w1 = k.w[i];
    e.w2 = k.w[j];
  }
  return e;
}

CableEnds ends(const LineStructure::Cable& c, const Kinematics& k) {
  const size_t i = c.element.first;
  const size_t j = c.element.second;
  return {k.x[i], k.x[j], k.v[i], k.v[j]};
}

LineStructure::LineStructure(const LocalMesh& mesh, std::vector<Beam> beams, std::vector<Cable> cables)
    : mesh_(mesh), beams_(std::move(beams)), cables_(std::move(cables)) {
  auto block = [&](int node) { return mesh_.block[node]; };
  for (Beam& b : beams_) {
    const int p = block(b.element.first);
    const int q = block(b.element.second);
    b.blocks[0] = p;
    b.blocks[1] = p + 1;
    b.blocks[2] = q;
    b.blocks[3] = q + 1;
    damped_ |= b.section.beta > 0;
  }
  size_t all = 0;
  for (const Beam& b : beams_) all += b.remembered();
  plastic_history_.assign(all, 0);
  yields_ = all > 0;
  size_t at = 0;
  for (Beam& b : beams_) {
    b.memory = at;
    at += b.remembered();
    if (b.section.plastic) b.reference.set = plastic_history_.data() + b.memory;
  }
  for (Cable& c : cables_) {
    c.blocks[0] = block(c.element.first);
    c.blocks[1] = block(c.element.second);
    damped_ |= c.section.beta > 0;
  }
}

namespace {

std::vector<LineStructure::Beam> beams_of(const LocalMesh& mesh, const model::Case& c) {
  std::vector<LineStructure::Beam> out;
  out.reserve(static_cast<size_t>(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                                [&](const auto& e) { return mesh.element(e).beam; })));
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    if (!g.beam) continue;
    LineStructure::Beam& b = out.emplace_back();
    b.element = e;
    b.section = beam_section(*mesh.mesh, c, g);
    b.reference.strain = g.free_strain;
  }
  return out;
}

LineStructure::Peak peak(const model::Case& c, const Element& e) {
  const model::LineType& t = c.line_types[e.type];
  return {t.wave_time(e.length), t.mass_per_length * e.length * c.environment.gravity};
}

std::vector<LineStructure::Cable> cables_of(const LocalMesh& mesh, const model::Case& c) {
  std::vector<LineStructure::Cable> out;
  out.reserve(static_cast<size_t>(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                                [&](const auto& e) { return !mesh.element(e).beam; })));
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    if (!g.beam) out.push_back({e, {}, cable_section(c, g), {}, peak(c, g)});
  }
  return out;
}

}  // namespace

LineStructure::LineStructure(const LocalMesh& mesh, const model::Case& c)
    : LineStructure(mesh, beams_of(mesh, c), cables_of(mesh, c)) {
  for (const EvenPart& p : mesh.mesh->parts())
    yields_ |= c.line_types[p.shape->type].plastic_bending != nullptr;
  // Sections inside feeders have never been bent. A line of several types that yields cannot be fed.
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const LineEnd line_end : kLineEnds) {
      if (!c.lines[l].end(line_end).feed) continue;
      FedBends& fed = fed_.emplace_back();
      const Element& e = mesh.mesh->element(mesh.mesh->lines[l].first_element);
      if (const auto& plastic = c.line_types[e.type].plastic_bending)
        fed.inside.assign(2 * kBendingPlaces * plastic->memory(), 0);
    }
}

void LineStructure::evaluate(const Kinematics& trial, Assembler& assembler) {
  update_from_feeders(trial);
  const CableStep step{trial.step, trial.mean.filter};
  if (assembler.needs_tangent()) {
    Vec12 f;
    Mat12 K, C;
    for (const Beam& b : beams_) {
      if (b.idle) continue;
      beam_tangent(b.section, b.reference, ends(b, trial), assembler.convex(), f, K, &C);
      assembler.add(b.blocks, f, K, b.section.beta > 0 ? DerivativeView(C) : DerivativeView());
    }
    for (const Cable& c : cables_) {
      CableForce o;
      const CableEnds e = ends(c, trial);
      if (trial.mean.over_step()) {
        cable_mean_force(c.section, scaled_start(c, trial.step, last_step_), step, e.x1, e.x2, o);
        assembler.add_mean_between(c.blocks[0], c.blocks[1], o.force, &o.k);
        continue;
      }
      cable_force(c.section, e, assembler.weights().stabilisation, o);
      assembler.add_between(c.blocks[0], c.blocks[1], o.force, &o.k, c.section.beta > 0 ? &o.c : nullptr);
    }
    return;
  }
  Vec12 f;
  for (const Beam& b : beams_) {
    if (b.idle) continue;
    beam_force(b.section, b.reference, ends(b, trial), f);
    assembler.add(b.blocks, f);
  }
  for (const Cable& c : cables_) {
    const CableEnds e = ends(c, trial);
    const Vec3 pull =
        trial.mean.over_step()
            ? cable_mean_force(c.section, scaled_start(c, trial.step, last_step_), step, e.x1, e.x2)
            : cable_force(c.section, e);
    // With the weight of 1, `pull` enters the residual unchanged; it also enters mean_forces(), from which
    // the motion starts.
    assembler.add_mean_between(c.blocks[0], c.blocks[1], pull, nullptr);
  }
}

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Largest distance of both ends from the origin, by component.
Vec3 far(const Kinematics& state, const LocalElement& e) {
  return state.x[e.first].cwiseAbs().cwiseMax(state.x[e.second].cwiseAbs());
}

// Round-off of the tension, N. The strain is a difference of positions, each with an error of eps |x|; in a
// step h the strain rate is this difference divided by h.
double pull_round_off(const Kinematics& state, const auto& e, double h = 0) {
  const double rates = h > 0 ? e.section.beta / h : 0;
  return (1 + rates) * e.section.EA / e.section.length * eps * far(state, e.element).maxCoeff();
}

double chord_length(const Kinematics& state, const LocalElement& e) {
  return (state.x[e.second] - state.x[e.first]).norm();
}
double chord_strain(const Kinematics& state, const LineStructure::Beam& b) {
  return chord_length(state, b.element) / b.section.length - 1 - b.reference.strain;
}
double chord_strain(const Kinematics& state, const LineStructure::Cable& c) {
  return c.section.strain(chord_length(state, c.element));
}

// Tension [N] of the spring of a cable, without its damper, and its slope by strain [N]; 0 if it is slack.
ResponseCurve::Value spring(const CableSection& section, double strain) {
  return strain > 0 ? section.axial(strain) : ResponseCurve::Value{};
}

}  // namespace

double LineStructure::round_off(const Kinematics& state, double h) const {
  double sum = 0;
  const auto pull = [&](const auto& e) {
    if (e.element.counted) sum += std::pow(pull_round_off(state, e, h), 2);
  };
  for (const Beam& b : beams_) {
    if (b.idle) continue;
    pull(b);
    if (!b.element.counted) continue;
    // The curvature is a difference of directions: those of the nodes, with errors of a few eps, and that of
    // the chord, with the error of the transverse positions divided by the length. The force error is that of
    // the moment divided by the element's length.
    const BeamSection& s = b.section;
    const Vec3 t = (state.x[b.element.second] - state.x[b.element.first]).normalized();
    const double across =
        (far(state, b.element).array() * (1 - t.array().square()).max(0).sqrt()).matrix().norm();
    const double bend = std::max(s.EI2, s.EI3);
    const double turn = 4 * std::max(bend, s.GJ);
    sum += std::pow(eps * (bend * across / s.length + turn) / (s.length * s.length), 2);
  }
  for (const Cable& c : cables_) pull(c);
  return sum;
}

Overstretch LineStructure::overstretched(const Kinematics& state) const {
  Overstretch worst;
  const auto update_worst = [&](const auto& e, double strain) {
    const ResponseCurve* table = e.section.tension;
    const double limit = strain > 0 ? (table ? table->last() : 0) + kStrainBeyondRows
                                    : (table ? std::min(table->first(), 0.0) : 0) - kStrainBeyondRows;
    const double beyond = std::abs(strain) - std::abs(limit);
    if (!(beyond > worst.beyond)) return;
    const int node = mesh_.global[e.element.first];
    worst = {beyond,      node, strain, limit, table ? table->at(strain).force : e.section.EA * strain,
             e.section.EA};
  };
  for (const Beam& b : beams_)
    if (b.element.counted && !b.idle) update_worst(b, chord_strain(state, b));
  for (const Cable& c : cables_)
    if (c.element.counted) update_worst(c, std::max(chord_strain(state, c), 0.0));
  return worst;
}

// Only a tension above all earlier ones of its element is a peak that counts, so that repeated snap loads of
// equal size divide few steps. A step shorter than the wave's time through the element cannot resolve more
// than the element does.
void LineStructure::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  for (const Cable& c : cables_) {
    if (!c.element.counted || c.idle) continue;
    const ResponseCurve::Value now = spring(c.section, chord_strain(trial, c));
    if (!(now.force > c.peak.largest)) continue;
    if (resolves_peak(spring(c.section, c.start.strain).force, now.force)) continue;
    // The transit time is that at the initial stiffness.
    if (trial.step > c.peak.transit_time * std::sqrt(c.section.EA / now.slope)) to.too_fast = true;
  }
}

void LineStructure::tensions(const Kinematics& state, std::span<LineTension> lines) const {
  const auto raise = [&](const auto& e, double tension) {
    const Element& g = mesh_.element(e.element);
    LineTension& line = lines[g.line];
    line.tension = std::max(line.tension, std::abs(tension));
    line.round_off = std::max(line.round_off, pull_round_off(state, e));
    line.EA = std::max(line.EA, e.section.EA);
  };
  for (const Beam& b : beams_)
    if (!b.idle) raise(b, beam_stress(b.section, b.reference, ends(b, state)).tension);
  for (const Cable& c : cables_) raise(c, cable_stress(c.section, ends(c, state)).tension);
}

std::vector<double> LineStructure::slack_length(const Kinematics& state) const {
  std::vector<double> lines(mesh_.mesh->lines.size());
  for (const Cable& c : cables_)
    if (c.element.counted && cable_stress(c.section, ends(c, state)).tension == 0)
      lines[mesh_.element(c.element).line] += c.section.length;
  return lines;
}

// Limits are applied to the true values, which restore_sections() restores exactly.
bool LineStructure::limit_axial_stiffness(double max_EA) {
  if (true_beams_.empty() && true_EA_.empty()) {
    for (const Beam& b : beams_) true_beams_.push_back({b.section.EA, b.section.plastic});
    for (const Cable& c : cables_) true_EA_.push_back(c.section.EA);
  }
  bool changed = false;
  for (size_t i = 0; i < beams_.size(); ++i) {
    const auto& [EA, plastic] = true_beams_[i];
    BeamSection& s = beams_[i].section;
    s.EA = std::min(max_EA, EA);
    s.plastic = nullptr;
    changed |= s.EA != EA || s.plastic != plastic;
  }
  for (size_t i = 0; i < cables_.size(); ++i) {
    cables_[i].section.EA = std::min(max_EA, true_EA_[i]);
    changed |= cables_[i].section.EA != true_EA_[i];
  }
  return changed;
}

void LineStructure::restore_sections() {
  for (size_t i = 0; i < true_beams_.size(); ++i) {
    beams_[i].section.EA = true_beams_[i].first;
    beams_[i].section.plastic = true_beams_[i].second;
  }
  for (size_t i = 0; i < true_EA_.size(); ++i) cables_[i].section.EA = true_EA_[i];
  true_beams_.clear();
  true_beams_.shrink_to_fit();
  true_EA_.clear();
  true_EA_.shrink_to_fit();
}

double LineStructure::axial_stiffness() const {
  double largest = 0;
  for (const Beam& b : beams_) largest = std::max(largest, b.section.EA);
  for (const Cable& c : cables_) largest = std::max(largest, c.section.EA);
  return largest;
}

double LineStructure::beam_dissipation(const Kinematics& state) const {
  double p = 0;
  for (const Beam& b : beams_)
    if (b.element.counted && b.section.beta > 0)
      p += beam_stress(b.section, b.reference, ends(b, state)).dissipation;
  return p;
}

// Updates the plastic history of beams to `state`. Returns the energy dissipated by the beams that
// this rank counts, J.
double LineStructure::commit_plastic(const Kinematics& state) {
  double dissipated = 0;
  for (Beam& b : beams_) {
    if (!b.section.plastic || b.idle) continue;
    double* set = plastic_history_.data() + b.memory;
    // The reference points to the history at a trial length.
    if (b.reference.set != set) std::copy_n(b.reference.set, b.remembered(), set);
    b.reference.set = set;
    const double plastic_work = beam_bend(b.section, b.reference, ends(b, state), set);
    if (b.element.counted) dissipated += plastic_work;
  }
  return dissipated;
}

void LineStructure::prepare(const Kinematics& from, double) {
  // In statics every section bends from its initial history in one step. The result is stored when motion
  // begins; it is not work of the motion.
  update_from_feeders(from);
  if (from.phase == Phase::start && !plastic_history_.empty()) commit_plastic(from);
  if (damped_ && !power_) power_ = beam_dissipation(from);
  last_step_ = from.last_step();
  for (Cable& c : cables_) {
    const CableEnds e = ends(c, from);
    c.start = cable_start(c.section, e.x1, e.x2, c.start.strain_increment, last_step_);
    if (from.moves()) c.peak.largest = std::max(c.peak.largest, spring(c.section, c.start.strain).force);
  }
}

void LineStructure::commit(const Kinematics& accepted) {
  update_from_feeders(accepted, true);
  if (accepted.moves()) {
    const CableStep step{accepted.step, accepted.mean.filter};
    for (Cable& c : cables_) {
      const CableEnds e = ends(c, accepted);
      const CableStepResult losses =
          cable_step_result(c.section, scaled_start(c, accepted.step, last_step_), step, e.x1, e.x2);
      c.start.strain_increment = losses.strain_increment;
      if (c.element.counted) {
        damping_ += losses.damped;
        filtered_ += losses.filtered;
      }
      if (c.element.counted && feeders_) feeders_->add_work(losses.fed);
    }
  }
  if (accepted.moves() && !plastic_history_.empty()) {
    if (feeders_) feeders_->add_work(fed_work(accepted));
    for (const Beam& b : beams_)
      if (const FedLine* fed = feeders_ && b.section.plastic ? feeders_->find(b.element.global) : nullptr)
        keep_hauled_in(b, *fed);
    damping_ += commit_plastic(accepted);
  }
  if (!damped_) return;
  const double before = power_.value_or(0);
  power_ = beam_dissipation(accepted);
  damping_ += 0.5 * accepted.step * (before + *power_);
}

Energy LineStructure::energy(const Kinematics& state) const {
  Energy e;
  for (const Beam& b : beams_)
    if (b.element.counted && !b.idle)
      e.strain += beam_stress(b.section, b.reference, ends(b, state)).strain_energy;
  for (const Cable& c : cables_)
    if (c.element.counted) e.strain += cable_stress(c.section, ends(c, state)).strain_energy;
  e.damping = damping_;
  e.unresolved = filtered_;
  return e;
}

// Adds the force of element e to f, with the sign of the residual. Both lists are in the order of the mesh.
void LineStructure::element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const {
  if (const Beam* b = of_element(beams_, e)) {
    if (b->idle) return;
    Vec12 force;
    beam_force(b->section, b->reference, ends(*b, state), force);
    add_ends(force, f);
  } else if (const Cable* c = of_element(cables_, e)) {
    const Vec3 pull = cable_force(section_for_output(*c, state), ends(*c, state));
    add_ends((Vec6() << -pull, pull).finished(), f);
  }
}

// In statics the feeder does not pay out, even if its speed in motion is not 0.
CableSection LineStructure::section_for_output(const Cable& c, const Kinematics& state) {
  CableSection s = c.section;
  if (!state.moves()) s.length_rate = 0;
  return s;
}

}  // namespace hawser
