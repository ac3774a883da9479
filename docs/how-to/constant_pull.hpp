// A force of constant size on a node towards a fixed point, as of a wire from a winch that keeps its tension:
// the example of docs/how-to/add-a-force-term.md.
#pragma once

#include <algorithm>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"

namespace hawser {

// With the distance l = |p - x| and the direction d = (p - x)/l: residual -T d, tangent T/l (I - d d'),
// potential T l.
class ConstantPull final : public ForceTerm {
 public:
  // The local node, the point p [m], which the node never reaches, and the tension T [N].
  ConstantPull(const LocalMesh& mesh, int node, const Vec3& p, double T)
      : mesh_(mesh), n_(node), p_(p), T_(T) {}
  std::string_view checkpoint_key() const override { return "constant pull"; }
  void evaluate(const Kinematics& trial, Assembler& assembler) override {
    if (!mesh_.owns(n_)) return;
    const Vec3 wire = p_ - trial.x[n_], d = wire.normalized(), f = -T_ * d;
    const Mat3 K = T_ / wire.norm() * (Mat3::Identity() - d * d.transpose());
    assembler.add(mesh_.block[n_], f, &K);
  }
  Energy energy(const Kinematics& at) const override {
    return {.potential = mesh_.owns(n_) ? T_ * (p_ - at.x[n_]).norm() : 0};
  }
  void fields(FieldRegistry& registry) const override {
    registry.add({{.name = "pull", .unit = "N", .components = 3},
                  [this](const Kinematics& at, std::span<double> values) {
                    std::ranges::fill(values, 0.0);
                    if (!mesh_.owns(n_)) return;
                    Eigen::Map<Vec3>(values.data() + 3 * n_) = T_ * (p_ - at.x[n_]).normalized();
                  }});
  }

 private:
  const LocalMesh& mesh_;
  int n_;
  Vec3 p_;
  double T_;
};

}  // namespace hawser
