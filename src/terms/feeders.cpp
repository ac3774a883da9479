// The class Feeders: forces of winches, tensioners and reels. Elements inside a feeder, length of the element
// at the feed point, momentum of the line that flows through it, work of the feeder.
#include "hawser/terms/feeders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/steps.hpp"
#include "hawser/kernels/line_mass.hpp"
#include "hawser/mesh/fed_start.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/line_sections.hpp"

namespace hawser {
namespace {

// Shares of the element's mass in its mass matrix: of each end (own), and between both (shared). For cables
// they are the mean of the lumped and the consistent matrix, for beams those of cubic shape functions
// (kernels/line_mass.cpp).
struct MassShares {
  double diagonal, off_diagonal;
};
MassShares mass_shares(bool beam) {
  return beam ? MassShares{13. / 35, 9. / 70} : MassShares{5. / 12, 1. / 12};
}

// Limits of the length of the element at the feed point in a step: kShortest times its own length, and its
// own length plus kLonger times that of the next one in stock. Both are well beyond the lengths at which
// nodes are absorbed and released.
constexpr double kShortest = 0.1, kLonger = 0.9;

double chord(const Kinematics& state, const LocalElement& e) {
  return (state.x[e.second] - state.x[e.first]).norm();
}

BeamFeed feed_of_beam(const Feeder& f, const Kinematics& state, const LocalElement& e, double length) {
  const size_t i = e.first;
  const size_t j = e.second;
  BeamSection s = f.beam_section;
  s.length = length;
  BeamReference r;
  r.strain = f.free_strain;
  return beam_feed(s, r, {state.x[i], state.x[j], state.q[i], state.q[j]});
}

}  // namespace

Feeders::Feeders(const LocalMesh& mesh, const model::Case& c) : mesh_(mesh), case_(c) {
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const LineEnd line_end : kLineEnds) {
      const model::End& end = c.lines[l].end(line_end);
      if (!end.feed) continue;
      Feeder& f = feeders_.emplace_back();
      f.index = feeders_.size() - 1;
      f.line = static_cast<int>(l);
      f.line_end = line_end;
      f.feed = *end.feed;
      f.name = fmt::format("end {} of line {}", end_letter(line_end), c.lines[l].name);
      f.tied.body = end.kind == model::EndKind::body ? c.body_index(end.carrier) : -1;
      f.tied.at = end.at;
      const FedStart start = fed_start(*mesh.mesh, mesh.mesh->lines[l], line_end, f.feed.stock);
      f.feed_point = start.inside;
      f.length = f.offset = start.length;
      update_feed_point(f);
      f.outside_at_start = outside(f);
      f.resting = f.feed.has_band();
    }
  power_.assign(feeders_.size(), 0);
  pulls_.assign(feeders_.size(), 0);
}

void Feeders::clamp(const std::vector<std::array<Quat, 2>>& ends) {
  for (Feeder& f : feeders_) f.tied.rotation = ends[f.line][end_index(f.line_end)];
}

int Feeders::elements(const Feeder& f) const { return mesh_.mesh->lines[f.line].elements; }

int Feeders::node(const Feeder& f, int i) const {
  const LineSpan& span = mesh_.mesh->lines[f.line];
  return span.first_node + (f.line_end == LineEnd::B ? span.nodes - 1 - i : i);
}

int Feeders::element(const Feeder& f, int i) const {
  const LineSpan& span = mesh_.mesh->lines[f.line];
  return span.first_element + (f.line_end == LineEnd::B ? span.elements - 1 - i : i);
}

double Feeders::element_length(const Feeder& f, int i) const {
  return mesh_.mesh->element(element(f, i)).length;
}

double Feeders::outside(const Feeder& f) const {
  const LineSpan& span = mesh_.mesh->lines[f.line];
  const double arc = mesh_.mesh->node(node(f, f.feed_point + 1)).arc;
  return f.length + (f.line_end == LineEnd::B ? arc : span.length - arc);
}

void Feeders::update_feed_point(Feeder& f) {
  const Element& g = mesh_.mesh->element(element(f, f.feed_point));
  const auto& t = case_.line_types[g.type];
  f.beam = g.beam;
  f.free_strain = g.free_strain;
  if (f.beam)
    f.beam_section = beam_section(*mesh_.mesh, case_, g);
  else
    f.cable_section = cable_section(case_, g);
  f.mass_per_length = t.mass_per_length;
  f.weight = Vec3(0, 0, -case_.environment.gravity * t.mass_per_length);
  fed_.resize(feeders_.size());
  FedLine& entry = fed_[f.index];
  entry = {};
  entry.feeder = f.index;
  entry.line_end = f.line_end;
  entry.element = element(f, f.feed_point);
  const LineSpan& span = mesh_.mesh->lines[f.line];
  entry.inside = {span.first_element, entry.element};
  if (f.line_end == LineEnd::B) entry.inside = {entry.element + 1, span.first_element + span.elements};
  entry.before = entry.predicted = entry.length = f.length;
}

void Feeders::update(const Kinematics& state) {
  for (size_t k = 0; k < feeders_.size(); ++k) {
    const FeedPoint m = feed_point(feeders_[k], state);
    FedLine& e = fed_[k];
    e.before = feeders_[k].length;
    e.predicted = predicted_feed_point(feeders_[k], state).length;
    e.length = m.length;
    e.length_by_chord = m.by_chord;
    e.length_by_force = m.length_by_force;
    e.length_rate = m.length_rate;
  }
}

const LocalElement* Feeders::at_feed_point(const Feeder& f) const {
  const int global = element(f, f.feed_point);
  const auto at = std::lower_bound(mesh_.elements.begin(), mesh_.elements.end(), global,
                                   [](const LocalElement& e, int g) { return e.global < g; });
  return at != mesh_.elements.end() && at->global == global ? &*at : nullptr;
}

FeedPoint Feeders::predicted_feed_point(const Feeder& f, const Kinematics& state) const {
  if (!f.feed.speed.empty()) {
    const model::Fed fed = model::fed_by(f.feed, state.time);
    return {f.offset + fed.length, fed.speed, fed.acceleration, 0, 0, fed.speed};
  }
  const double h = state.time - f.time;
  if (!(h > 0)) return {f.length, f.speed, 0, 0, 0, f.length_rate};
  return {f.length + h * f.speed, f.speed, 0, 0};
}

FeedPoint Feeders::feed_point(const Feeder& f, const Kinematics& state) const {
  const double h = state.time - f.time;
  if (!f.feed.speed.empty() || !(h > 0)) return predicted_feed_point(f, state);
  const LocalElement* e = at_feed_point(f);
  if (!e) return {f.length, f.speed, 0, 0};
  const FedElement fed = feed_step([&](double length) { return pull(f, state, *e, length); },
                                   {f.feed.tension, f.feed.speed_per_tension, f.feed.max_speed, f.resting,
                                    f.feed.min_tension, f.feed.max_tension},
                                   f.length, h);
  FeedPoint m{fed.length, (fed.length - f.length) / h, 0, 0, fed.length_by_force};
  const size_t i = e->first;
  const size_t j = e->second;
  const double l = chord(state, *e);
  if (!(l > 0)) return m;
  const double parts = (state.x[j] - state.x[i]).dot(state.v[j] - state.v[i]) / l;
  m.by_chord = fed.length_by_force * (f.beam ? feed_of_beam(f, state, *e, m.length).by_chord
                                             : feed_of_cable(f, state, *e, m.length).by_chord);
  m.length_rate =
      f.beam ? m.by_chord * parts : (m.length / l) * (parts - m.length * strain_rate(f, state, *e, m.length));
  // If a tension is kept exactly, the speed at the end of the step is that at which the end of the element
  // moves. Otherwise it is that of the law, which is the mean over the step.
  if (f.feed.speed_per_tension == 0 && m.by_chord > 0) m.speed = m.length_rate;
  return m;
}

FedPull Feeders::pull(const Feeder& f, const Kinematics& state, const LocalElement& e, double length) const {
  if (!f.beam) return feed_of_cable(f, state, e, length);
  const BeamFeed unit = feed_of_beam(f, state, e, length);
  return {unit.force, unit.slope};
}

double Feeders::strain_before(const Feeder& f, const LocalElement& e) const {
  return f.cable_section.strain(chord(before_.at_rest(), e), f.length);
}

double Feeders::strain_rate(const Feeder& f, const Kinematics& state, const LocalElement& e,
                            double length) const {
  if (before_.x.size() != state.x.size()) return 0;
  return (f.cable_section.strain(chord(state, e), length) - strain_before(f, e)) / (state.time - f.time);
}

CableFeed Feeders::feed_of_cable(const Feeder& f, const Kinematics& state, const LocalElement& e,
                                 double length) const {
  const double h = before_.x.size() == state.x.size() ? state.time - f.time : 0;
  return cable_feed(f.cable_section, chord(state, e), length, h > 0 ? strain_before(f, e) : 0, h);
}

std::vector<std::array<int, 2>> Feeders::inside() const {
  std::vector<std::array<int, 2>> out(case_.lines.size(), {0, 0});
  for (const Feeder& f : feeders_) out[f.line][end_index(f.line_end)] = f.feed_point;
  return out;
}

std::vector<TiedNode> Feeders::with_held(const std::vector<TiedNode>& tied) const {
  std::vector<int> fed = fed_nodes();
  std::vector<TiedNode> out;
  for (const TiedNode& s : tied)
    if (!std::binary_search(fed.begin(), fed.end(), mesh_.global[s.node])) out.push_back(s);
  for (const Feeder& f : feeders_)
    for (int i = 0; i <= f.feed_point; ++i)
      if (const int local = mesh_.find(node(f, i)); local >= 0) {
        out.push_back(f.tied);
        out.back().node = local;
        if (mesh_.rotates(local)) out.back().rotation_mask = 7;
      }
  return out;
}

// All nodes of the line, except an end that is not held by a feeder.
std::vector<int> Feeders::fed_nodes() const {
  std::vector<int> out;
  for (const Feeder& f : feeders_)
    for (int i = 0; i < elements(f); ++i) out.push_back(node(f, i));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Feeders::Flow Feeders::flow(const FeedPoint& m, const Kinematics& state, const LocalElement& e,
                            LineEnd line_end) const {
  const size_t i = e.node_at(line_end);
  const size_t j = e.node_at(opposite(line_end));
  Flow o;
  const double rate = m.speed / m.length;
  o.chord = state.x[j] - state.x[i];
  o.velocity = state.v[i] + rate * o.chord;
  o.acceleration = (m.acceleration / m.length) * o.chord + 2 * rate * (state.v[j] - o.velocity);
  return o;
}

// Inertia by the acceleration relative to the feeder: residual at the feeder and at the free node.
Feeders::Inertia Feeders::inertia(const Feeder& f, const FeedPoint& m, const Flow& o) const {
  const MassShares mass = mass_shares(f.beam);
  const double mass_of_element = f.mass_per_length * m.length;
  return {mass_of_element * mass.diagonal * o.acceleration,
          mass_of_element * mass.off_diagonal * o.acceleration};
}

// m L'² d/L: residual at the feeder, the rate of momentum of the material that it sets in motion.
Vec3 Feeders::momentum(const Feeder& f, const FeedPoint& m, const Flow& o) const {
  return (f.mass_per_length * m.speed * m.speed / m.length) * o.chord;
}

void Feeders::prepare(const Kinematics& from, double) {
  before_.x.assign(from.x.begin(), from.x.end());
  before_.q.assign(from.q.begin(), from.q.end());
  for (size_t k = 0; k < feeders_.size(); ++k) {
    const LocalElement* e = at_feed_point(feeders_[k]);
    power_[k] = e && e->counted ? power(feeders_[k], from, *e) : 0;
    pulls_[k] = e && feeders_[k].beam ? pull(feeders_[k], from, *e, feeders_[k].length).force : 0;
  }
}

void Feeders::evaluate(const Kinematics& trial, Assembler& assembler) {
  if (!trial.moves()) return;
  for (const Feeder& f : feeders_) {
    const LocalElement* e = at_feed_point(f);
    if (!e) continue;
    const FeedPoint m = predicted_feed_point(f, trial);
    const Flow o = flow(m, trial, *e, f.line_end);
    const Inertia inert = inertia(f, m, o);
    const int blocks[2] = {mesh_.block[e->node_at(f.line_end)],
                           mesh_.block[e->node_at(opposite(f.line_end))]};
    const Vec6 r = (Vec6() << inert.at_feeder + momentum(f, m, o), inert.at_free_node).finished();
    if (!assembler.needs_tangent()) {
      assembler.add(blocks, r);
      continue;
    }
    const MassShares mass = mass_shares(f.beam);
    const double rate = m.speed / m.length;
    const double held = f.mass_per_length * m.length * mass.diagonal;
    const double off_diagonal = f.mass_per_length * m.length * mass.off_diagonal;
    // Derivatives of the acceleration by position and velocity of the free node. Those by the other node have
    // the opposite sign.
    const double by_x = m.acceleration / m.length - 2 * rate * rate;
    const double by_v = 2 * rate;
    const double released = f.mass_per_length * m.speed * rate;
    Mat6 K = Mat6::Zero(), C = Mat6::Zero();
    const auto put = [](Mat6& to, int i, double value) {
      to.block<3, 3>(3 * i, 3).diagonal().array() = value;
      to.block<3, 3>(3 * i, 0).diagonal().array() = -value;
    };
    put(K, 0, held * by_x + released);
    put(K, 1, off_diagonal * by_x);
    put(C, 0, held * by_v);
    put(C, 1, off_diagonal * by_v);
    assembler.add(blocks, r, K, C);
  }
}

// Without momentum(), which the feeder provides, not the line.
void Feeders::element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const {
  if (!state.moves()) return;
  for (const Feeder& feeder : feeders_) {
    if (element(feeder, feeder.feed_point) != e.global) continue;
    const FeedPoint m = predicted_feed_point(feeder, state);
    const Inertia inert = inertia(feeder, m, flow(m, state, e, feeder.line_end));
    const bool at_second = feeder.line_end == LineEnd::B;
    f.head<3>() += at_second ? inert.at_free_node : inert.at_feeder;
    f.segment<3>(6) += at_second ? inert.at_feeder : inert.at_free_node;
  }
}

// Power for the paid-out material: work of the feeder beyond holding the line, and kinetic energy.
double Feeders::power(const Feeder& f, const Kinematics& state, const LocalElement& e) const {
  const FeedPoint m = feed_point(f, state);
  if (m.speed == 0) return 0;
  const size_t i = e.node_at(f.line_end);
  const size_t j = e.node_at(opposite(f.line_end));
  const Flow o = flow(m, state, e, f.line_end);
  const double mass = f.mass_per_length;
  const double rate = m.speed / m.length;
  const auto [diagonal, off_diagonal] = mass_shares(f.beam);
  const Vec3 inertia =
      mass * m.length * (diagonal * (state.a[i] + o.acceleration) + off_diagonal * state.a[j]);
  const Vec3& v = o.velocity;
  const Vec3& w = state.v[j];
  return rate * o.chord.dot(inertia) +
         mass * m.speed *
             (1.5 * diagonal * v.squaredNorm() + (2 * off_diagonal - diagonal) * v.dot(w) +
              (0.5 * diagonal - off_diagonal) * w.squaredNorm()) -
         mass * m.speed * state.v[i].dot(v - state.v[i]);
}

// True if the feeder rests at the end of a step with the feed point m. It stops where the tension reaches the
// target, and restarts beyond the dead band.
bool Feeders::rests(const Feeder& f, const FeedPoint& m, const Kinematics& accepted,
                    const LocalElement& e) const {
  constexpr double kThere = 0.01;  // of the band's part on this side of the target
  if (f.resting) return m.speed == 0;
  const double off = pull(f, accepted, e, m.length).force - f.feed.tension;
  const double band = off > 0 ? f.feed.max_tension - f.feed.tension : f.feed.tension - f.feed.min_tension;
  return f.speed * m.speed < 0 || std::abs(off) < kThere * band;
}

// Work of a step of h [s] in which the length of the element at the feed point changed from `before`, J.
double Feeders::work_of_step(size_t k, const Kinematics& accepted, const LocalElement& e, double h,
                             double before) const {
  const Feeder& f = feeders_[k];
  double work = 0.5 * h * (power_[k] + power(f, accepted, e));
  // For cables LineStructure computes this work, from the mean force of the step.
  if (f.beam) work -= 0.5 * (f.length - before) * (pulls_[k] + pull(f, accepted, e, f.length).force);
  if (before_.x.size() != accepted.x.size()) return work;
  for (const Kinematics& state : {before_.at_rest(), accepted})
    work -= 0.5 * (load_work(f, state, e, f.length) - load_work(f, state, e, before));
  return work;
}

void Feeders::commit(const Kinematics& accepted) {
  for (size_t k = 0; k < feeders_.size(); ++k) {
    Feeder& f = feeders_[k];
    const FeedPoint m = feed_point(f, accepted);
    const double h = accepted.time - f.time;
    const double before = f.length;
    const LocalElement* e = at_feed_point(f);
    if (f.feed.has_band() && h > 0 && e) f.resting = rests(f, m, accepted, *e);
    f.length = m.length;
    f.time = accepted.time;
    if (!f.feed.speed.empty() || (h > 0 && e)) {
      f.speed = f.resting ? 0 : m.speed;
      f.length_rate = m.length_rate;
    }
    if (e && e->counted && h > 0) work_ += work_of_step(k, accepted, *e, h, before);
  }
}

double Feeders::passed_through(std::span<const double> pulls, double h) const {
  double gross = 0, net = 0;
  for (size_t k = 0; k < feeders_.size(); ++k) {
    const double work = pulls[k] * feeders_[k].speed * h;
    gross += std::abs(work);
    net += work;
  }
  return gross - std::abs(net);
}

// Work of the weight of the element at the feed point from the origin to its place, J.
double Feeders::load_work(const Feeder& f, const Kinematics& state, const LocalElement& e,
                          double length) const {
  const size_t i = e.first;
  const size_t j = e.second;
  if (!f.beam) return 0.5 * length * f.weight.dot(state.x[i] + state.x[j]);
  const MassSection s{length, f.mass_per_length};
  return beam_load_work(s, state.x[i], state.q[i], state.x[j], state.q[j], f.weight);
}

Energy Feeders::energy(const Kinematics& state) const {
  Energy out;
  out.work = work_;
  if (!state.ends_step()) return out;
  for (const Feeder& f : feeders_) {
    const LocalElement* e = at_feed_point(f);
    if (!e || !e->counted) continue;
    const FeedPoint m = feed_point(f, state);
    const size_t i = e->node_at(f.line_end);
    const size_t j = e->node_at(opposite(f.line_end));
    const Vec3 v = flow(m, state, *e, f.line_end).velocity;
    const Vec3& held = state.v[i];
    const Vec3& w = state.v[j];
    const auto [diagonal, off_diagonal] = mass_shares(f.beam);
    out.kinetic += f.mass_per_length * m.length *
                   (0.5 * diagonal * (v.squaredNorm() - held.squaredNorm()) + off_diagonal * w.dot(v - held));
  }
  return out;
}

Verdict Feeders::check_step(const Kinematics& trial) const {
  for (const Feeder& f : feeders_) {
    if (!f.feed.speed.empty() || at_feed_point(f)) {
      const double length = feed_point(f, trial).length;
      const double mesh_length = element_length(f, f.feed_point);
      if (length < kShortest * mesh_length ||
          length > mesh_length + kLonger * element_length(f, std::max(f.feed_point - 1, 0)))
        return {Verdict::Kind::shorter, advice::FeedsTooFast{f.name}};
    }
  }
  return {};
}

}  // namespace hawser
