// Rotational springs at held ends of lines: a stiffness between a free end and a clamped one.
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
  int node = 0;                    // local, with a rotation
  int body = -1;                   // -1: the direction is fixed in space
  Vec3 direction = Vec3::UnitX();  // unit, in the body's frame (or space)
  double stiffness = 0;            // N m/rad
};

// Of the owned end nodes of a case.
std::vector<EndSpring> end_springs(const model::Case& c, const LocalMesh& mesh);

// Energy k phi²/2 of the angle phi between the line's tangent t = Q e1 and the direction d, so a moment k phi
// about t x d. With c = d.t, W'(c) = -k phi/sin phi and W''(c) = k (1 - phi cot phi)/sin² phi, both smooth
// but at phi = pi, where the end is folded back. There is no moment about the tangent itself. The work of
// turning bodies on the line through the springs is history.
class EndSprings final : public ForceTerm {
 public:
  EndSprings(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies, std::vector<EndSpring> springs);

  std::string_view name() const override { return "end springs"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> records(NodeRange of) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // A spring on a body that moves: the body's rotation, and its moment on the spring, N m, body axes.
  struct Hold {
    Quat rotation;
    Vec3 moment;
  };
  std::array<AttachedNow, 2> directions(const EndSpring& s, const Kinematics& at) const;
  void holds(const Kinematics& at, std::vector<Hold>& out) const;

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<EndSpring> springs_;
  std::vector<size_t> driven_;      // springs on bodies that move
  std::vector<Hold> before_, now_;  // theirs, of the committed state; room for those of the accepted one
  std::vector<double> work_;        // J, by spring, done by the bodies
};

}  // namespace hawser
