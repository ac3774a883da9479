// Rotational springs at supported ends of lines, with a stiffness between a free and a clamped end.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/between_points.hpp"

namespace hawser {

struct EndSpring {
  int node = 0;                    // local node with a rotation
  int body = -1;                   // -1: the direction is fixed in space
  Vec3 direction = Vec3::UnitX();  // in the body's frame, or in space axes
  double stiffness = 0;            // N m/rad
};

// Springs at the owned end nodes of a case.
std::vector<EndSpring> end_springs(const model::Case& c, const LocalMesh& mesh);

// Spring with the energy k phi²/2, where phi is the angle between the line's tangent t = Q e1 and the
// direction d. Its moment is k phi about t x d. With c = d.t, W'(c) = -k phi/sin phi and W''(c) = k (1 - phi
// cot phi)/sin² phi, both smooth except at phi = pi, where the end is folded back. There is no moment about
// the tangent. The work of moving bodies through the springs is part of the history.
class EndSprings final : public ForceTerm {
 public:
  EndSprings(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies, std::vector<EndSpring> springs);

  std::string_view checkpoint_key() const override { return "end springs"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Rotation of a moving body, and the moment of the body on the spring, N m, body axes.
  struct Hold {
    Quat rotation;
    Vec3 moment;
  };
  std::array<AttachedNow, 2> directions(const EndSpring& s, const Kinematics& state) const;
  void holds(const Kinematics& state, std::vector<Hold>& out) const;

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<EndSpring> springs_;
  std::vector<size_t> driven_;      // indices of springs on moving bodies
  std::vector<Hold> before_, now_;  // driven springs in the committed state; workspace for the accepted one
  std::vector<double> work_;        // J, done by the bodies, by spring
};

}  // namespace hawser
