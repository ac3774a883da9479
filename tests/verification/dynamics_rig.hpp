// Shared by the tests of dynamics: loads with any function of time, chains of beams that the case file cannot
// describe, momentum, and runs that stop at given times.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "hawser/mesh/partition.hpp"
#include "hawser/terms/line_mass.hpp"
#include "hawser/terms/line_structure.hpp"
#include "support/rig.hpp"

namespace hawser::test {

// Dead force and moment on a local node, both times factor(t), in space axes.
class TimedLoad final : public ForceTerm {
 public:
  TimedLoad(const LocalMesh& mesh, int node, const Vec3& force, const Vec3& moment,
            std::function<double(double)> factor)
      : node_(static_cast<size_t>(node)),
        block_{mesh.block[node_], mesh.block[node_] + 1},
        force_(force),
        moment_(moment),
        factor_(std::move(factor)) {}

  std::string_view checkpoint_key() const override { return "timed load"; }
  void evaluate(const Kinematics& trial, Assembler& assembler) override {
    const double s = factor_(trial.time);
    const Vec3 m = trial.q[node_].conjugate() * moment_;
    Vec6 f;
    f << -s * force_, -s * m;
    Mat6 K = Mat6::Zero();
    K.bottomRightCorner<3, 3>() = -s * hat(m);
    assembler.add(block_, f, K);
  }

 private:
  size_t node_;
  int block_[2];
  Vec3 force_, moment_;
  std::function<double(double)> factor_;
};

// A chain of straight beams on one rank; the axes of its nodes at the start are given.
class BeamChain {
 public:
  struct Piece {
    BeamSection section;
    Vec3 rotary = Vec3::Zero();  // kg m, per length
    double mass_per_length = 0;  // kg/m
    const Mat3* axes = nullptr;  // as in MassSection
  };

  // Element i joins nodes i and i + 1; the rotation of all nodes starts as the identity.
  BeamChain(std::vector<Vec3> nodes, const std::vector<Piece>& pieces) : mesh_(mesh(nodes, pieces)) {
    system_ =
        std::make_unique<System>(PETSC_COMM_SELF, local_mesh(mesh_, NodeRanks::all_of(mesh_.nodes()), 0, 1));
    const LocalMesh& l = system_->mesh();
    std::vector<LineStructure::Beam> beams;
    std::vector<LineMass::MassElement> masses;
    for (const LocalElement& e : l.elements) {
      const Piece& p = pieces[static_cast<size_t>(e.global)];
      BeamReference reference;
      reference.axes = p.axes;
      beams.push_back({e, {}, p.section, reference});
      LineMass::MassElement m;
      m.element = e;
      m.section = {p.section.length, p.mass_per_length, p.rotary, p.axes};
      masses.push_back(m);
    }
    system_->add(std::make_unique<LineStructure>(l, std::move(beams), std::vector<LineStructure::Cable>{}));
    system_->add(std::make_unique<LineMass>(l, std::move(masses), std::vector<LineMass::Load>{}));
    state.resize(l.nodes());
    state.x = std::move(nodes);
  }

  System& system() { return *system_; }
  State state;

 private:
  static Mesh mesh(const std::vector<Vec3>& nodes, const std::vector<Piece>& pieces) {
    Mesh m;
    double arc = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
      const double before = i > 0 ? pieces[i - 1].section.length : 0;
      const double after = i < pieces.size() ? pieces[i].section.length : 0;
      m.add(Node{0, arc, 0.5 * (before + after), true});
      if (i < pieces.size()) m.add(Element{0, static_cast<int>(i), static_cast<int>(i) + 1, 0, after, true});
      arc += after;
    }
    LineSpan span;
    span.nodes = static_cast<int>(nodes.size());
    span.elements = static_cast<int>(pieces.size());
    span.length = arc;
    m.lines = {span};
    return m;
  }

  Mesh mesh_;
  std::unique_ptr<System> system_;
};

// Momentum of the discrete system by its mass matrix: p = M (v, w). One rank.
struct Momentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // kg m/s; about the origin, kg m²/s
};
inline Momentum momentum(System& system, const Kinematics& k) {
  const LocalMesh& mesh = system.mesh();
  MatHandle M = system.create_matrix();
  Weights mass;
  mass.K = 0;
  mass.M = 1;
  system.tangent(k, mass, std::vector<double>(3 * static_cast<size_t>(mesh.blocks()), 0), false, M.get());
  VecHandle v = system.create_vector();
  VecHandle p = system.create_vector();
  PetscScalar* a = nullptr;
  check(VecGetArray(v.get(), &a));
  for (int n = 0; n < mesh.owned; ++n) {
    double* at = a + 3 * mesh.block[static_cast<size_t>(n)];
    Eigen::Map<Vec3>(at, 3) = k.v[static_cast<size_t>(n)];
    if (mesh.rotates(n)) Eigen::Map<Vec3>(at + 3, 3) = k.w[static_cast<size_t>(n)];
  }
  check(VecRestoreArray(v.get(), &a));
  check(MatMult(M.get(), v.get(), p.get()));
  Momentum sum;
  check(VecGetArray(p.get(), &a));
  for (int n = 0; n < mesh.owned; ++n) {
    const size_t i = static_cast<size_t>(n);
    // The mass of a tied node is in the rows of the node that carries it; its own row is that of a unit
    // matrix.
    if (mesh.mesh->node(static_cast<size_t>(mesh.global[i])).tied_to >= 0) continue;
    const double* at = a + 3 * mesh.block[i];
    const Eigen::Map<const Vec3> linear(at);
    sum.linear += linear;
    sum.angular += k.x[i].cross(linear);
    if (mesh.rotates(n)) sum.angular += k.q[i] * Eigen::Map<const Vec3>(at + 3);
  }
  check(VecRestoreArray(p.get(), &a));
  return sum;
}

// Kinetic, strain and potential energy, J.
inline double total(const Energy& e) { return e.kinetic + e.strain + e.potential; }

// J over all ranks: energy stored plus dissipated, and work brought in.
struct Balance {
  double stored = 0, brought = 0;
};
inline Balance balance(Simulation& s, MPI_Comm comm) {
  const Energy e = s.system().energy(s.dynamics().committed_kinematics());
  double sums[] = {total(e) + e.friction + e.damping + e.unresolved, e.work + s.dynamics().support_work()};
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, comm);
  return {sums[0], sums[1]};
}

// Steps of h from the state's time to `until`; each(info) after every step; steps end at multiples of `mark`.
inline void integrate(Dynamics& d, double until, double mark,
                      const std::function<void(const StepInfo&)>& each) {
  d.run(
      until, [=](double t) { return mark * (std::floor(t / mark + 1e-9) + 1); },
      [&](const StepInfo& info) {
        each(info);
        return true;
      });
}

inline bool at_mark(double t, double mark) { return std::abs(t / mark - std::round(t / mark)) < 1e-6; }

// value(node of the first body with mass) from the rank that owns it; a rank may have no node.
template <class Value>
double from_owner(const Simulation& s, Value&& value) {
  const int n = s.local().find(s.mesh().body_node(0));
  double here = n >= 0 && n < s.local().owned ? value(static_cast<size_t>(n)) : 0;
  MPI_Allreduce(MPI_IN_PLACE, &here, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return here;
}

// Time between the first and last zero crossing over the number of periods between them.
inline double period(const std::vector<std::pair<double, double>>& signal) {
  std::vector<double> zeros;
  for (size_t i = 1; i < signal.size(); ++i) {
    const auto [t0, y0] = signal[i - 1];
    const auto [t1, y1] = signal[i];
    if (y0 * y1 < 0) zeros.push_back(t0 + (t1 - t0) * y0 / (y0 - y1));
  }
  return 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
}

// Period of value(kinematics, node of the first body with mass) over the duration of the case, from rest.
template <class Value>
double period_from_rest(Simulation& s, Value&& value) {
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const double rest = from_owner(s, [&](size_t n) { return value(d.committed_kinematics(), n); });
  const double duration = s.model().dynamics.duration;
  std::vector<std::pair<double, double>> signal;
  integrate(d, duration, duration, [&](const StepInfo& i) {
    signal.emplace_back(i.time,
                        from_owner(s, [&](size_t n) { return value(d.committed_kinematics(), n); }) - rest);
  });
  return period(signal);
}

}  // namespace hawser::test
