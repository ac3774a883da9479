// Buried stretches of lines: springs at each node, from the position where the line was laid, that yield at
// the soil's resistance. See docs/theory/seabed.md.
#pragma once

#include <mpi.h>

#include <cmath>
#include <vector>

#include "hawser/kernels/buried_soil.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/line_neighbours.hpp"

namespace hawser {

// Length of the arc [from, to] of a line that lies in the soil, m.
double buried_length(const model::Line& line, double from, double to);

class SoilResistance final : public ForceTerm, public AdaptsStiffness {
 public:
  struct BuriedNode {
    int node = 0;  // local, owned
    BuriedSoil soil;
  };

  // The lines are laid as in `start`.
  SoilResistance(MPI_Comm comm, const LocalMesh& mesh, const Kinematics& start,
                 std::vector<BuriedNode> places);
  // held: supported local nodes, on which the soil does not act.
  SoilResistance(MPI_Comm comm, const LocalMesh& mesh, const model::Case& c, const Kinematics& start,
                 const std::vector<int>& held);

  std::string_view checkpoint_key() const override { return "buried"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;
  // The springs have the directions of the line at the start of a step. A static solution keeps the
  // directions fixed so that its forces have a potential, then repeats with those of the equilibrium found,
  // until the directions no longer change.
  bool adapt_stiffness(const Kinematics& equilibrium) override;
  bool raise_stiffness_where_blocked(const Kinematics&) override { return false; }
  void revert_stiffness() override {}

 private:
  struct Point {
    int node = 0, block = 0;
    BuriedSoil soil;
    Vec3 tangent = Vec3::UnitX();  // of the line at the start of the step or of the static solution
    // Committed.
    Vec3 at = Vec3::Zero(), slip = Vec3::Zero(), force = Vec3::Zero();  // m, m, N
    double stored = 0, friction_work = 0;                               // J

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("position", "m", self.at);
      each("slip", "m", self.slip);
      each("force", "N", self.force);
      each("stored", "J", self.stored);
      each("friction work", "J", self.friction_work);
    }
  };
  BuriedForce pull(const Point& p, const Kinematics& state) const {
    return buried_force(p.soil, p.slip + (state.x[p.node] - p.at), p.tangent);
  }

  // Turns the directions of the springs by the fraction `fraction` towards those of the line in `state`.
  // Returns the largest angle between them before, rad.
  double turn_to(const Kinematics& state, double fraction = 1);

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  std::vector<Point> points_;
  double turn_fraction_ = 1, turn_ = HUGE_VAL;  // in statics: fraction of the next turn; last turn, rad
  LineNeighbours line_;
};

}  // namespace hawser
