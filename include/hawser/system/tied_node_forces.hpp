// Forces and tangent of nodes that are tied to a frame of the state (TiedNodes; docs/theory/frames.md). Such
// a node has no unknowns of its own: a force on it acts on its frame, which is a body with mass or a node of
// a beam, of which it is a point (FramePoint). Its rates and its accelerations both depend on the frame's
// rotation by FramePoint::velocity_by_turn(). A rotation that is tied as well has the increment turn theta.
#pragma once

#include <span>
#include <vector>

#include "hawser/kernels/frame_point.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/tied_nodes.hpp"

namespace hawser {

class Assembler;

class TiedNodeForces {
 public:
  TiedNodeForces() = default;
  TiedNodeForces(const LocalMesh& mesh, const TiedNodes& tied);

  bool tied(int block) const { return !tie_of_.empty() && tie_of_[block] >= 0; }
  // Takes the frames from a trial state. Must be called before the functions below.
  void move(const Kinematics& trial);
  // Adds the force f at each owned tied node to that of its frame, and its moment y x R'f plus that of the
  // node's rotation to the frame's moment (frame axes). force: 3 * blocks, N; squares: by block, of the
  // contributions. The force at the node remains there as that of the tie.
  void add_forces(std::vector<double>& force, std::vector<double>& squares) const;
  // Adds the stiffness from the rotation of the arm of the force at each owned tied node. `convex`, far from
  // a solution: only its positive part.
  void add_geometric_stiffness(const std::vector<double>& force, bool convex, Assembler& assembler) const;

  // Increments u of some blocks as functions of the unknowns z of the blocks `to`: u = P z; their rates
  // change by V z when frames rotate. Derivatives by u become P'(K P + (C + director_weight M) V), P'C P and
  // P'M P.
  struct Unknowns {
    std::vector<int> to;
    Eigen::MatrixXd P, V;  // 3 * blocks x 3 * to
  };
  Unknowns unknowns(std::span<const int> blocks) const;
  double director_weight() const { return director_weight_; }  // 1/s, factor of a rotated frame's rates in M

 private:
  struct Tie {
    int block = 0, frame = 0;  // local blocks: of the node's position, of the frame's position
    int frame_node = 0;
    bool owned = false;
    bool turns = false;  // the node's rotation is tied as well
    bool point = false;  // the frame has no rotation because it is the end of a cable
    FramePoint frame_point;
    Mat3 turn = Mat3::Identity();
  };
  std::vector<Tie> ties_;
  std::vector<int> tie_of_;  // by local block; -1: not tied
  double director_weight_ = 0;
};

}  // namespace hawser
