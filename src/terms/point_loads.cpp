// Point forces, moments and masses of a case on the nearest nodes: residual, tangent, work and potential of
// PointLoads; inertia and weight of PointMasses.
#include "hawser/terms/point_loads.hpp"

#include <stdexcept>
#include <unordered_map>

#include "hawser/kernels/motion.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

double factor(const NodeLoad& load, double time) {
  return load.ramp > 0 ? quintic_ramp(time, load.ramp).value : 1;
}

// Calls visit(case line, node_at) with node_at(arc length): the local owned node, or -1.
template <class Visit>
void for_lines(const model::Case& c, const LocalMesh& mesh, Visit visit) {
  for (size_t l = 0; l < c.lines.size(); ++l)
    visit(c.lines[l], [&, l](double at) {
      const int n = mesh.find(mesh.mesh->nearest_node(static_cast<int>(l), at));
      return n < mesh.owned ? n : -1;
    });
}

}  // namespace

Mat3 moment_stiffness(const Quat& rotation, const Vec3& moment) {
  return -hat(rotation.conjugate() * moment);
}

std::vector<NodeLoad> point_loads(const model::Case& c, const LocalMesh& mesh) {
  std::vector<NodeLoad> loads;
  for_lines(c, mesh, [&](const model::Line& line, auto node_at) {
    for (const model::PointLoad& p : line.point_loads)
      if (const int node = node_at(p.at); node >= 0) loads.push_back({node, p.force, p.moment, p.ramp});
  });
  return loads;
}

std::vector<NodeMass> point_masses(const model::Case& c, const LocalMesh& mesh) {
  std::vector<NodeMass> masses;
  for_lines(c, mesh, [&](const model::Line& line, auto node_at) {
    for (const model::PointMass& p : line.masses)
      if (const int node = node_at(p.at); node >= 0) masses.push_back({node, p.mass});
  });
  return masses;
}

PointLoads::PointLoads(const LocalMesh& mesh, std::vector<NodeLoad> loads) {
  for (const NodeLoad& load : loads) {
    if (load.node >= mesh.owned) continue;
    if (!load.moment.isZero(0) && !mesh.rotates(load.node))
      throw std::invalid_argument("a moment acts on a cable node, which has no rotation");
    loads_.push_back(load);
    block_.push_back(mesh.block[load.node]);
    const int node = mesh.global[load.node];
    const int line = mesh.mesh->node(node).line;
    global_.push_back(node);
    length_.push_back(mesh.mesh->lines[line].length);
  }
  work_.assign(loads_.size(), 0);
}

void PointLoads::prepare(const Kinematics& from, double) {
  start_.clear();
  rotation_.clear();
  start_time_ = from.time;
  for (const NodeLoad& load : loads_) {
    start_.push_back(from.x[load.node]);
    rotation_.push_back(from.q[load.node]);
  }
}

void PointLoads::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (size_t i = 0; i < loads_.size(); ++i) {
    const NodeLoad& load = loads_[i];
    const double s = factor(load, trial.time);
    const Vec3 force = -s * load.force;
    assembler.add(block_[i], force);
    if (load.moment.isZero(0)) continue;
    const Quat& q = trial.q[load.node];
    const Vec3 moment = -s * (q.conjugate() * load.moment);
    const Mat3 K = s * moment_stiffness(q, load.moment);
    assembler.add(block_[i] + 1, moment, assembler.convex() ? nullptr : &K);
  }
}

void PointLoads::commit(const Kinematics& accepted) {
  if (!accepted.moves() || start_.size() != loads_.size()) return;
  for (size_t i = 0; i < loads_.size(); ++i) {
    const NodeLoad& load = loads_[i];
    const size_t n = load.node;
    const double s = 0.5 * (factor(load, start_time_) + factor(load, accepted.time));
    if (load.ramp > 0) work_[i] += s * load.force.dot(accepted.x[n] - start_[i]);
    if (!load.moment.isZero(0))
      work_[i] += s * load.moment.dot(log_so3(accepted.q[n] * rotation_[i].conjugate()));
  }
}

Energy PointLoads::energy(const Kinematics& state) const {
  Energy e;
  for (double w : work_) e.work += w;
  const bool statics = !state.moves() && start_.size() == loads_.size();
  for (size_t i = 0; i < loads_.size(); ++i) {
    const NodeLoad& load = loads_[i];
    if (load.ramp > 0) continue;
    const size_t n = load.node;
    e.potential -= load.force.dot(state.x[n]);
    if (statics && !load.moment.isZero(0))
      e.potential -= load.moment.dot(log_so3(state.q[n] * rotation_[i].conjugate()));
  }
  return e;
}

double PointLoads::dead_load() const {
  double sum = 0;
  for (size_t i = 0; i < loads_.size(); ++i)
    if (loads_[i].ramp == 0) sum += loads_[i].force.norm() + loads_[i].moment.norm() / length_[i];
  return sum;
}

// The records of a node's loads are in the order of the case.
std::vector<CheckpointKind> PointLoads::checkpoint_kinds() const {
  return {checkpoint_kind<WorkDone>("sums of a load")};
}

std::vector<CheckpointRecord> PointLoads::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> records;
  std::unordered_map<int, int> count;
  for (size_t i = 0; i < work_.size(); ++i)
    if (range.has(global_[i])) records.push_back({global_[i], count[global_[i]]++, {work_[i]}});
  return records;
}

void PointLoads::restore(const std::vector<CheckpointRecord>& records) {
  std::unordered_map<int, int> count;
  work_.assign(work_.size(), 0);
  for (size_t i = 0; i < work_.size(); ++i) {
    const auto kept = find_entry<WorkDone>(records, global_[i], count[global_[i]]++);
    if (kept) work_[i] = kept->work;
  }
}

PointMasses::PointMasses(const LocalMesh& mesh, std::vector<NodeMass> masses, double gravity)
    : gravity_(gravity) {
  for (const NodeMass& m : masses) {
    if (m.node >= mesh.owned) continue;
    masses_.push_back(m);
    block_.push_back(mesh.block[m.node]);
  }
}

void PointMasses::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (size_t i = 0; i < masses_.size(); ++i) {
    const double m = masses_[i].mass;
    const Vec3 force = m * (trial.a[masses_[i].node] + gravity_ * Vec3::UnitZ());
    const Mat3 M = m * Mat3::Identity();
    assembler.add(block_[i], force, nullptr, nullptr, &M);
  }
}

double PointMasses::dead_load() const {
  double sum = 0;
  for (const NodeMass& m : masses_) sum += m.mass * gravity_;
  return sum;
}

Energy PointMasses::energy(const Kinematics& state) const {
  Energy e;
  for (const NodeMass& m : masses_) {
    const size_t n = m.node;
    e.kinetic += 0.5 * m.mass * state.v[n].squaredNorm();
    e.potential += m.mass * gravity_ * state.x[n].z();
  }
  return e;
}

}  // namespace hawser
