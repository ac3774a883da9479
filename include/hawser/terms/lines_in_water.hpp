// Forces of the sea on lines, and on buoys and clump weights on them: buoyancy, drag, added mass, waves.
// See docs/theory/water.md and waves.md.
#pragma once

#include <vector>

#include "hawser/kernels/morison_submerged.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"

namespace hawser {

class LinesInWater final : public ForceTerm,
                           public ActsOnElements,
                           public ScalesResiduals,
                           public InCurrent,
                           public ActsOnFedLines {
 public:
  struct WetElement {
    LocalElement element;
    bool beam = true;
    bool idle = false;  // inside a feeder, without water forces
    WaterSection section;
  };
  struct Ball {
    int node = 0;  // local, owned
    WaterBall ball;
  };

  LinesInWater(const LocalMesh& mesh, Sea sea, std::vector<WetElement> pieces, std::vector<Ball> balls = {});
  LinesInWater(const LocalMesh& mesh, const model::Case& c);

  void scale_current(double factor) override { sea_.current_scale = factor; }

  // True if the water moves anywhere.
  bool moving() const { return !sea_.at_rest(); }
  bool has_waves() const { return !sea_.waves.none(); }
  bool has_current() const { return !sea_.current.none(); }
  double above_still_water(double z) const { return z - sea_.surface; }
  const std::vector<WetElement>& pieces() const { return pieces_; }
  // Drag and inertia force of the flow on a piece that is divided into `parts` equal parts, with the water
  // motion evaluated at their ends, and its difference from the same force with four times as many parts.
  // Changes no state.
  struct FlowError {
    double force = 0, error = 0;  // N, sums of the magnitudes over the parts
    bool crossed = false;         // pierces the water surface
  };
  FlowError flow_error(const Kinematics& state, const WetElement& p, int parts) const;

  std::string_view checkpoint_key() const override { return "hydrodynamics"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  double round_off(const Kinematics& state, double h) const override;
  void element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const override;
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Data for the wall tension: areas of the bore and of the bare pipe, density and pressure of the contents.
  struct Wall {
    double inside = 0, outside = 0;     // m²
    double contents = 0, pressure = 0;  // kg/m³, Pa at the still water level
  };
  // Flow forces on the nodes and pieces that this rank counts, and their points of application, by local
  // block: the position of a node and, if it rotates, the line direction there, whose conjugate force is a
  // moment.
  struct FlowLoads {
    std::vector<Vec3> force, place;
  };
  // Up to four cables evaluated together if they are fully submerged; in an incomplete group the unused lanes
  // repeat the last cable.
  struct CableQuad {
    int count = 0;
    int piece[4] = {};
    int first[4] = {}, second[4] = {};  // local nodes
    WaterSections4 sections;
  };
  void group();
  void update_from_feeders(double FedLine::*length);
  double fed_buoyancy(const Kinematics& state) const;
  CablesInWater4 motion(const CableQuad& q, const Kinematics& k) const;
  void add_quad(const CableQuad& q, const Kinematics& trial, Assembler& assembler) const;
  void add_element(const WetElement& p, const Kinematics& trial, Assembler& assembler) const;
  unsigned flow_of_quad(const CableQuad& q, const Kinematics& state, WaterForce* out) const;
  Water water(const Kinematics& state, size_t node) const;
  Vec3 wave_place(const Kinematics& state, size_t node) const;
  const std::vector<WaveMotion>& waves(const Kinematics& state) const;
  void update_water(const Kinematics& state) const;
  const Water& water_at(size_t node) const { return water_[moving() ? node : 0]; }
  WaterEnds ends(const WetElement& p, const Kinematics& k, const Water& first, const Water& second) const;
  WaterEnds ends(const WetElement& p, const Kinematics& k) const {
    return ends(p, k, water_at(static_cast<size_t>(p.element.first)),
                water_at(static_cast<size_t>(p.element.second)));
  }
  FlowLoads flow_loads(const Kinematics& state) const;
  static double work(const FlowLoads& from, const FlowLoads& to);

  const LocalMesh& mesh_;
  Sea sea_;
  std::vector<WetElement> pieces_;
  std::vector<Wall> walls_;  // by line type; empty: no output of wall tension
  std::vector<Ball> balls_;
  std::vector<CableQuad> quads_;  // all cables
  std::vector<int> beams_;        // indices of pieces
  // Water in the last evaluated state, by local node; a single entry for calm water, which is uniform.
  mutable std::vector<Water> water_;
  // Waves are evaluated once a step, for its end, at the positions that the nodes reach with their velocities
  // at its start.
  double start_time_ = 0;                 // s
  std::vector<Vec3> start_, speed_;       // m, m/s, at the start of the step
  std::vector<Vec3> place_;               // m, where waves were evaluated for the state at start_time_
  mutable std::vector<WaveMotion> wave_;  // cache: wave motion at wave_time_
  mutable double wave_time_ = 0;
  mutable bool wave_known_ = false;
  FlowLoads flow_loads_;  // at the last accepted state; in statics at the last iteration
  double work_ = 0;       // J, done by drag and added mass on the parts that this rank counts
};

// Hydrodynamic section of a line type for an element of this length [m].
WaterSection water_section(const model::Case& c, int type, double length);

}  // namespace hawser
