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
  ConstantPull(const LocalMesh& mesh, int node, const Vec3& point, double tension)
      : mesh_(mesh), node_(node), point_(point), tension_(tension) {}

  std::string_view name() const override { return "constant pull"; }
  void evaluate(const Kinematics& trial, Assembler& assembler) override {
    if (!mesh_.owns(node_)) return;
    const Vec3 way = point_ - trial.x[node_], d = way.normalized(), residual = -tension_ * d;
    const Mat3 K = tension_ / way.norm() * (Mat3::Identity() - d * d.transpose());
    assembler.add({&mesh_.block[node_], 1}, residual.data(), K.data(), nullptr, nullptr);
  }
  Energy energy(const Kinematics& at) const override {
    Energy e;
    if (mesh_.owns(node_)) e.potential = tension_ * (point_ - at.x[node_]).norm();
    return e;
  }
  void fields(FieldRegistry& registry) const override {
    registry.add({{.name = "pull", .unit = "N", .components = 3},
                  [this](const Kinematics& at, std::span<double> values) {
                    std::fill(values.begin(), values.end(), 0.0);
                    if (!mesh_.owns(node_)) return;
                    const Vec3 d = (point_ - at.x[node_]).normalized();
                    Eigen::Map<Vec3>(values.data() + 3 * node_) = tension_ * d;
                  }});
  }

 private:
  const LocalMesh& mesh_;
  int node_;
  Vec3 point_;
  double tension_;
};

}  // namespace hawser
