// Stretches of lines in the soil, node by node: springs from where they were laid that yield at the soil's
// resistance. See docs/theory/seabed.md.
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

// How much of the arc [from, to] of a line lies in the soil [m].
double buried_length(const model::Line& line, double from, double to);

class BuriedTerm final : public ForceTerm, public RaisesStiffness {
 public:
  struct Place {
    int node = 0;  // local, owned
    BuriedSoil soil;
  };

  // Laid as `start` has them.
  BuriedTerm(MPI_Comm comm, const LocalMesh& mesh, const Kinematics& start, std::vector<Place> places);
  // held: local nodes that are supported, which the soil leaves alone.
  BuriedTerm(MPI_Comm comm, const LocalMesh& mesh, const model::Case& c, const Kinematics& start,
             const std::vector<int>& held);

  std::string_view name() const override { return "buried"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> records(NodeRange of) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;
  // The springs have the directions of the line at the start of a step. A search of statics keeps those it
  // begins with, for its forces to have a potential, and goes on with those of the equilibrium that it finds,
  // until they are the same.
  bool raise_stiffness(const Kinematics& equilibrium) override;
  bool raise_stiffness_where_blocked(const Kinematics&) override { return false; }
  void revert_stiffness() override {}

 private:
  struct Point {
    int node = 0, block = 0;
    BuriedSoil soil;
    Vec3 tangent = Vec3::UnitX();  // of the line at the start of the step, or of a search of statics
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
  BuriedForce pull(const Point& p, const Kinematics& at) const {
    return buried_force(p.soil, p.slip + (at.x[p.node] - p.at), p.tangent);
  }

  // Turns the directions by this share of the way to those of the line there; all of the way at the most,
  // rad.
  double turn_to(const Kinematics& at, double share = 1);

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  std::vector<Point> points_;
  double share_ = 1, turn_ = HUGE_VAL;  // of a search of statics: of the next turn; the last one, rad
  LineNeighbours line_;
};

}  // namespace hawser
