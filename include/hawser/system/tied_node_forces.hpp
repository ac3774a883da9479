// Forces and tangent of nodes that are tied to a frame of the state (TiedNodes; docs/theory/frames.md): the
// node has no unknowns of its own, so what acts on it acts on its frame, a body with mass or a node of a
// beam. With the frame's rotation R, rates w and accelerations of its directors, and the arm y in its axes:
//   x = X + R y,   dx = dX + place theta + (v, a by theta: rate theta),   place = -R hat(y), rate = -R hat(w
//   x y) of a rotation that is tied as well: turn theta.
#pragma once

#include <span>
#include <vector>

#include "hawser/math/types.hpp"
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
  // Takes the frames as they are at a trial state. Before all that follows.
  void move(const Kinematics& trial);
  // Adds the force at each owned tied node to that of its frame, and its moment y x R'f, with that of the
  // node's rotation, to the moment in the frame's axes. force: 3 * blocks, N; squares: by block, of what was
  // added. It stays at the node as what the tie carries.
  void add_forces(std::vector<double>& force, std::vector<double>& squares) const;
  // d(y x R'f) = hat(y) hat(R'f) theta: the arm of the force `f` of each owned tied node turns with its
  // frame. `convex`: far from a solution, that part of it which pulls at the arm and so holds the frame.
  void add_geometric_stiffness(const std::vector<double>& force, bool convex, Assembler& assembler) const;

  // The unknowns z of blocks `to` that some blocks' increments u = P z stand for, and the rates V z that
  // turned frames give: derivatives by u become P'(K P + (C + director_weight M) V), P'C P and P'M P.
  struct Unknowns {
    std::vector<int> to;
    Eigen::MatrixXd P, V;  // 3 * blocks x 3 * to
  };
  Unknowns unknowns(std::span<const int> blocks) const;
  double director_weight() const { return director_weight_; }  // 1/s, of a turned frame's rates in M

 private:
  struct Tie {
    int block = 0, frame = 0;  // local blocks: of the node's position, of the frame's
    int frame_node = 0;
    bool owned = false;
    bool turns = false;  // the node's rotation is tied as well
    bool point = false;  // the frame has no rotation: the end of a cable
    Vec3 arm = Vec3::Zero();
    Mat3 turn = Mat3::Identity(), R = Mat3::Identity(), place = Mat3::Zero(), rate = Mat3::Zero();
  };
  std::vector<Tie> ties_;
  std::vector<int> tie_of_;  // by local block; -1: not tied
  double director_weight_ = 0;
};

}  // namespace hawser
