// The class Links: ranks of a link, force and tangent on the frames of its ends, energy, work of dampers
// and of bodies with prescribed motion, and history.
#include "hawser/terms/links.hpp"

#include <cmath>

#include "hawser/advice/start_shape.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/terms/force_round_off.hpp"

namespace hawser {
namespace {

Attached attached(const model::LinkEnd& e, const model::Case& c, const LocalMesh& mesh) {
  Attached a;
  a.position = e.at;
  if (!e.line.empty()) a.node = mesh.mesh->nearest_node(c.line_index(e.line), e.arc);
  if (!e.body.empty()) a.body = c.body_index(e.body);
  return a;
}

}  // namespace

Links::Links(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
             const Kinematics& start)
    : mesh_(mesh), bodies_(std::move(bodies)) {
  std::vector<double> places;  // of both ends, from the ranks that own the frames
  const int rank = rank_of(comm);
  for (const model::Link& m : c.links) {
    Link& l = list_.emplace_back();
    l.name = m.name;
    l.a = attached(m.end_a, c, mesh);
    l.b = attached(m.end_b, c, mesh);
    l.law = m.law;
    for (const Attached* e : {&l.a, &l.b}) {
      const int frame = e->frame_node(*bodies_);
      if (l.owner < 0) l.owner = frame;
      const bool is_known = frame < 0 ? rank == 0 : mesh_.owns_node(frame);
      const Vec3 x = is_known ? attached_now(*e, start, mesh_, *bodies_).x : Vec3(Vec3::Zero());
      places.insert(places.end(), x.begin(), x.end());
    }
  }
  all_reduce(comm, MPI_SUM, places);
  for (size_t i = 0; i < list_.size(); ++i) {
    if (c.links[i].rest_given) continue;
    double& rest_length = list_[i].law.rest_length;
    rest_length = (Vec3(&places[6 * i + 3]) - Vec3(&places[6 * i])).norm();
    if (!(rest_length > 0)) c.refuse("links." + c.links[i].name, advice::link_without_length());
  }
  renumber();
}

void Links::list_couplings(Couplings& to) const {
  for (const Link& l : list_) {
    const int a = l.a.frame_node(*bodies_);
    const int b = l.b.frame_node(*bodies_);
    if (a >= 0 && b >= 0 && (mesh_.owns_node(a) || mesh_.owns_node(b))) to.add({a, a}, {b, b});
  }
}

void Links::renumber() {
  for (Link& l : list_) {
    const int a = l.a.frame_node(*bodies_);
    const int b = l.b.frame_node(*bodies_);
    l.has_both = (mesh_.owns_node(a) || mesh_.owns_node(b)) && (a < 0 || mesh_.find(a) >= 0) &&
                 (b < 0 || mesh_.find(b) >= 0);
    l.counted = l.has_both && mesh_.owns_node(l.owner);
  }
}

Links::Stretched Links::stretched(const Link& l, const Kinematics& state, bool convex) const {
  Stretched s{attached_now(l.a, state, mesh_, *bodies_), attached_now(l.b, state, mesh_, *bodies_), {}};
  s.force = link_force(l.law, s.b.x - s.a.x, s.b.v - s.a.v, convex);
  return s;
}

std::vector<Series> Links::series() const {
  std::vector<Series> out;
  for (const Link& l : list_)
    out.push_back({l.name + " link",
                   {{"tension", "N", 1}, {"length", "m", 1}, {"speed", "m/s", 1}, {"force", "N", 3}}});
  return out;
}

std::vector<std::vector<double>> Links::rows(const Kinematics& state) const {
  std::vector<std::vector<double>> out;
  for (const Link& l : list_) {
    std::vector<double>& row = out.emplace_back();
    if (!l.counted) continue;
    const LinkForce f = stretched(l, state).force;
    row = {f.along.tension, f.length, f.speed, f.pull.x(), f.pull.y(), f.pull.z()};
  }
  return out;
}

void Links::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Link& l : list_) {
    if (!l.has_both) continue;
    const Stretched s = stretched(l, trial, assembler.convex());
    const auto between = [](const Mat3& matrix) {
      Mat6 m;
      m << matrix, -matrix, -matrix, matrix;
      return m;
    };
    Vec6 f;
    f << -s.force.pull, s.force.pull;
    add_pair_force(assembler, s.a, s.b, f, between(s.force.by_place), between(s.force.by_rate));
  }
}

// The power of a body with prescribed motion is its force on the link's end times the end's velocity.
void Links::powers(const Link& l, const Kinematics& state, double& damping, double& work) const {
  const Stretched s = stretched(l, state);
  damping = s.force.along.dissipated;
  work = 0;
  if (l.a.frame_node(*bodies_) < 0) work -= s.force.pull.dot(s.a.v);
  if (l.b.frame_node(*bodies_) < 0) work += s.force.pull.dot(s.b.v);
}

void Links::prepare(const Kinematics& from, double) {
  for (Link& l : list_)
    if (l.counted) powers(l, from, l.damping_power, l.work_power);
}

void Links::commit(const Kinematics& accepted) {
  if (!accepted.moves()) return;
  for (Link& l : list_) {
    if (!l.counted) continue;
    double damping = 0, work = 0;
    powers(l, accepted, damping, work);
    l.damping += 0.5 * accepted.step * (damping + l.damping_power);
    l.work += 0.5 * accepted.step * (work + l.work_power);
  }
}

Energy Links::energy(const Kinematics& state) const {
  Energy e;
  for (const Link& l : list_) {
    if (!l.counted) continue;
    e.strain += stretched(l, state).force.along.energy;
    e.damping += l.damping;
    e.work += l.work;
  }
  return e;
}

// The round-off of a spring is that of a difference of positions, for a damper divided by the step.
double Links::round_off(const Kinematics& state, double h) const {
  double sum = 0;
  for (const Link& l : list_) {
    if (!l.counted) continue;
    const Stretched s = stretched(l, state);
    const double damper = l.law.damper ? l.law.damper->at(std::abs(s.force.speed)).slope : l.law.damping;
    const double slope = l.law.max_stiffness() + (h > 0 ? damper / h : 0);
    sum += spring_round_off(slope, s.b.x.norm());
  }
  return sum;
}

std::vector<CheckpointKind> Links::checkpoint_kinds() const {
  return {checkpoint_kind<Link>("sums of a link")};
}

std::vector<CheckpointRecord> Links::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (size_t i = 0; i < list_.size(); ++i)
    if (list_[i].counted && range.has(list_[i].owner))
      out.push_back(record_of(list_[i].owner, static_cast<int>(i), list_[i]));
  return out;
}

void Links::restore(const std::vector<CheckpointRecord>& records) {
  for (const CheckpointRecord& r : records) {
    if (r.key < 0 || static_cast<size_t>(r.key) >= list_.size()) continue;
    Link& l = list_[r.key];
    if (!mesh_.owns_node(l.owner)) continue;  // the other end may not be on this rank yet
    const Link kept = entry<Link>(r);
    l.damping = kept.damping;
    l.work = kept.work;
  }
}

}  // namespace hawser
