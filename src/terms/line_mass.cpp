// The class LineMass: masses and distributed loads of the case by element, assembled by
// kernels/line_mass.hpp; work of ramped loads, momentum of lines.
#include "hawser/terms/line_mass.hpp"

#include <algorithm>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/force_round_off.hpp"

namespace hawser {
namespace {

double load_work(const LineMass::MassElement& p, const Kinematics& k, const Vec3& load) {
  const size_t i = p.element.first;
  const size_t j = p.element.second;
  if (p.beam) return beam_load_work(p.section, k.x[i], k.q[i], k.x[j], k.q[j], load);
  return 0.5 * p.section.length * load.dot(k.x[i] + k.x[j]);
}

}  // namespace

MassEnds mass_ends(const LocalElement& e, const Kinematics& k) {
  const size_t i = e.first;
  const size_t j = e.second;
  const bool given = !k.directors.empty();
  return {k.a[i],
          k.a[j],
          k.v[i],
          k.v[j],
          k.q[i],
          k.q[j],
          k.w[i],
          k.w[j],
          k.alpha[i],
          k.alpha[j],
          given ? &k.directors[i] : nullptr,
          given ? &k.directors[j] : nullptr,
          k.director_weight};
}

LineMass::LineMass(const LocalMesh& mesh, std::vector<MassElement> pieces, std::vector<Load> ramped)
    : mesh_(mesh), pieces_(std::move(pieces)), ramped_(std::move(ramped)) {}

LineMass::LineMass(const LocalMesh& mesh, Built built)
    : LineMass(mesh, std::move(built.pieces), std::move(built.ramped)) {}

LineMass::LineMass(const LocalMesh& mesh, const model::Case& c) : LineMass(mesh, build(mesh, c)) {}

LineMass::Built LineMass::build(const LocalMesh& mesh, const model::Case& c) {
  Built out;
  out.pieces.reserve(mesh.elements.size());
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    const auto& t = c.line_types[g.type];
    MassElement p;
    p.element = e;
    p.beam = g.beam;
    p.section = {g.length, t.mass_per_length, t.rotary_inertia};
    p.load = Vec3(0, 0, -c.environment.gravity * t.mass_per_length);
    p.first_ramped = static_cast<int>(out.ramped.size());
    const double from = mesh.mesh->node(g.first).arc;
    const double to = from + g.length;
    for (const auto& l : c.lines[g.line].loads) {
      const double end = l.to < 0 ? mesh.mesh->lines[g.line].length : l.to;
      const double overlap = std::min(to, end) - std::max(from, l.from);
      if (overlap <= 0) continue;
      const Vec3 load = overlap / g.length * l.per_length;
      if (l.ramp > 0)
        out.ramped.push_back({load, l.ramp});
      else
        p.load += load;
    }
    p.ramped = static_cast<int>(out.ramped.size()) - p.first_ramped;
    out.pieces.push_back(p);
  }
  return out;
}

Vec3 LineMass::ramped_load(const MassElement& p, double t) const {
  Vec3 sum = Vec3::Zero();
  for (int i = p.first_ramped; i < p.first_ramped + p.ramped; ++i) {
    const Load& l = ramped_[i];
    sum += quintic_ramp(t, l.ramp).value * l.per_length;
  }
  return sum;
}

void LineMass::evaluate(const Kinematics& trial, Assembler& assembler) {
  if (feeders_) feeders_->update_lengths(mesh_, &FedLine::predicted, pieces_);
  for (const MassElement& p : pieces_) {
    if (p.idle) continue;
    const Vec3 w = load(p, trial.time);
    const int a = mesh_.block[p.element.first];
    const int b = mesh_.block[p.element.second];
    const int blocks[] = {a, a + 1, b, b + 1};
    if (!p.beam) {
      const size_t i = p.element.first;
      const size_t j = p.element.second;
      Vec6 f;
      cable_mass_force(p.section, trial.a[i], trial.a[j], w, f);
      const CableMass m = cable_mass(p.section);
      assembler.add_masses(a, b, f, m.diagonal, m.shared);
    } else if (assembler.needs_tangent()) {
      Vec12 f;
      Mat12 K, C, M;
      beam_mass_tangent(p.section, mass_ends(p.element, trial), w, f, K, C, M);
      assembler.add(blocks, f, K, C, M);
    } else {
      Vec12 f;
      beam_mass_force(p.section, mass_ends(p.element, trial), w, f);
      assembler.add(blocks, f);
    }
  }
}

void LineMass::element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const {
  const MassElement* p = of_element(pieces_, e);
  if (!p || p->idle) return;
  if (p->beam) {
    Vec12 force;
    beam_mass_force(p->section, mass_ends(p->element, state), load(*p, state.time), force);
    add_ends(force, f);
  } else {
    Vec6 force;
    cable_mass_force(p->section, state.a[e.first], state.a[e.second], load(*p, state.time), force);
    add_ends(force, f);
  }
}

void LineMass::prepare(const Kinematics& from, double) {
  if (feeders_) feeders_->update_lengths(mesh_, &FedLine::length, pieces_);
  if (ramped_.empty()) return;
  committed_.x.assign(from.x.begin(), from.x.end());
  committed_.q.assign(from.q.begin(), from.q.end());
  committed_.time = from.time;
}

void LineMass::commit(const Kinematics& accepted) {
  if (feeders_) feeders_->update_lengths(mesh_, &FedLine::length, pieces_);
  if (ramped_.empty() || committed_.x.size() != accepted.x.size()) return;
  Kinematics before;
  before.x = committed_.x;
  before.q = committed_.q;
  for (const MassElement& p : pieces_)
    if (p.ramped && p.element.counted) {
      const Vec3 mean = 0.5 * (ramped_load(p, committed_.time) + ramped_load(p, accepted.time));
      work_ += load_work(p, accepted, mean) - load_work(p, before, mean);
    }
}

std::vector<CheckpointKind> LineMass::checkpoint_kinds() const {
  return {checkpoint_kind<WorkDone>("sums of a rank")};
}

std::vector<CheckpointRecord> LineMass::checkpoint_records(NodeRange range) const {
  if (ramped_.empty() || mesh_.owned == 0 || !range.has(mesh_.global[0])) return {};
  return {record_of(mesh_.global[0], 0, WorkDone{work_})};
}

void LineMass::restore(const std::vector<CheckpointRecord>& records) {
  work_ = 0;
  for (const CheckpointRecord& r : records) work_ += entry<WorkDone>(r).work;
}

double LineMass::round_off(const Kinematics& state, double h) const {
  if (h <= 0) return 0;
  double sum = 0;
  for (const MassElement& p : pieces_)
    if (p.element.counted)
      sum += inertia_round_off(state, p.element, p.section.mass_per_length * p.section.length, h);
  return sum;
}

void LineMass::motion(const Kinematics& state, PerLine<LineMotion>& lines) const {
  for (const MassElement& p : pieces_) {
    if (!p.element.counted || p.idle) continue;
    LineMotion& line = lines[mesh_.element(p.element).line];
    const double half = 0.5 * p.section.mass_per_length * p.section.length;
    line.add(half, state.v[p.element.first]);
    line.add(half, state.v[p.element.second]);
  }
}

double LineMass::dead_load() const {
  double sum = 0;
  for (const MassElement& p : pieces_)
    if (p.element.counted && !p.idle) sum += p.section.length * p.load.norm();
  return sum;
}

Energy LineMass::energy(const Kinematics& state) const {
  Energy e;
  for (const MassElement& p : pieces_) {
    if (!p.element.counted || p.idle) continue;
    const size_t i = p.element.first;
    const size_t j = p.element.second;
    e.kinetic += p.beam ? beam_kinetic_energy(p.section, mass_ends(p.element, state))
                        : cable_kinetic_energy(p.section, state.v[i], state.v[j]);
    e.potential -= load_work(p, state, p.load);
    // In statics a ramped load is constant too; in dynamics its work is accumulated.
    if (p.ramped && !state.moves()) e.potential -= load_work(p, state, ramped_load(p, state.time));
  }
  e.work = work_;
  return e;
}

}  // namespace hawser
