// Contact of bodies with bodies: what stands out of one volume against the surface of another.
//
// By the basis of its stiffness a volume touches with its corners and balls (per_point), its edges
// (per_length) or its faces (per_area); model::body_pairs says who leads. No friction. See
// docs/theory/body-contact.md.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hawser/kernels/body_contact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/body_skeleton.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "hawser/terms/touch.hpp"

namespace hawser {

struct TouchingVolume {
  std::shared_ptr<const Surface> surface;
  BodySkeleton skeleton;
};

class BodyContactTerm final : public ForceTerm {
 public:
  // volumes: all of the case, in its order. Pairs are those of model::body_pairs.
  BodyContactTerm(const model::Case& c, const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                  std::vector<TouchingVolume> volumes);

  std::string_view name() const override { return "body contact"; }
  void couple(Couplings& to) const override;
  bool recouple(const Kinematics&, double) override;
  void reghost() override;
  void prepare(const Kinematics& committed, double h) override;
  void limit_step(const Kinematics& committed, Strikes& to) const override;
  // Nothing that stands out goes through the other body between the ends of a step.
  bool covers(const Kinematics& trial) const override;
  void evaluate(const Kinematics& trial, Sink& sink) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  std::vector<HistoryRecord> save() const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  // N and N m about its centre of mass, space axes: what contact exerts on a floating body of the case, for
  // the rank that owns it.
  std::array<Vec3, 2> force_on(int body, const Kinematics& at) const;
  // m, over the accepted steps, of the pairs this rank counts.
  double largest_penetration() const;
  // Adds what touches in the accepted state, of those pairs; volumes are those of the case.
  void touches(Touches& out) const;

 private:
  struct Side {
    int body = -1, node = -1, block = -1;  // of the case; local node and block, -1: prescribed or elsewhere
    int global = -1;                       // mesh node, -1: prescribed
    Vec3 centre = Vec3::Zero();            // m, of mass, body frame
  };
  struct Pair {
    size_t a = 0, b = 0;         // volumes
    NormalLaw law;               // of what stands out of a against the surface of b, per unit of the basis
    double share = 1, mass = 0;  // of the force; kg, effective
    double size = 0;             // m, of what stands out
    bool here = false, counted = false;        // this rank owns a body of it; counts it
    double damping = 0, work = 0;              // J, over the accepted steps
    double damping_power = 0, work_power = 0;  // W, at the start of the step
    double potential = 0, stiffness = 0;       // J, N/m of all that touches, in the committed state
    double depth = 0;                          // m, largest
    BodyFrame start_a, start_b;                // at the start of the step
    Touch now;                                 // in the accepted state
  };
  struct Sum;
  BodyFrame frame(const Side& side, const Kinematics& at) const;
  Sum touch(const Pair& pair, const Kinematics& at, bool tangent) const;
  bool passes(const Pair& pair, const Kinematics& trial) const;
  void powers(const Pair& pair, const Sum& s, const Kinematics& at, double& damping, double& work) const;

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<TouchingVolume> volumes_;
  std::vector<Box> boxes_;   // of their surfaces
  std::vector<Side> sides_;  // likewise
  std::vector<Pair> pairs_;
  bool told_ = false;
};

}  // namespace hawser
