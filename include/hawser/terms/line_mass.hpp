// Inertia, weight and distributed dead loads of all lines.
#pragma once

#include <vector>

#include "hawser/kernels/line_mass.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"

namespace hawser {

namespace model {
struct Case;
}

// Motion of the ends of an element.
MassEnds mass_ends(const LocalElement& e, const Kinematics& state);

class LineMass final : public ForceTerm,
                       public ActsOnElements,
                       public MovesMasses,
                       public ScalesResiduals,
                       public ActsOnFedLines {
 public:
  struct Load {
    Vec3 per_length = Vec3::Zero();  // N/m of unstretched element length
    double ramp = 0;                 // s, duration of the smooth start; 0: always acts
  };
  struct MassElement {
    LocalElement element;
    bool beam = true;
    bool idle = false;  // inside a feeder, without mass and weight
    MassSection section;
    Vec3 load = Vec3::Zero();          // N/m, weight and constant loads
    int first_ramped = 0, ramped = 0;  // range in the list of ramped loads
  };

  LineMass(const LocalMesh& mesh, std::vector<MassElement> pieces, std::vector<Load> ramped_loads);

  // Masses and distributed loads of the case; gravity along -z.
  LineMass(const LocalMesh& mesh, const model::Case& c);

  std::string_view checkpoint_key() const override { return "mass"; }
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void prepare(const Kinematics& from, double h) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  void element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const override;
  void motion(const Kinematics& state, PerLine<LineMotion>& lines) const override;  // rotations excluded
  double round_off(const Kinematics& state, double h) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  struct Built {
    std::vector<MassElement> pieces;
    std::vector<Load> ramped;
  };
  static Built build(const LocalMesh& mesh, const model::Case& c);
  LineMass(const LocalMesh& mesh, Built built);

  Vec3 ramped_load(const MassElement& p, double t) const;
  Vec3 load(const MassElement& p, double t) const {
    return p.ramped ? Vec3(p.load + ramped_load(p, t)) : p.load;
  }

  const LocalMesh& mesh_;
  std::vector<MassElement> pieces_;
  std::vector<Load> ramped_;
  State committed_;  // for the work of ramped loads only
  double work_ = 0;  // J, done by ramped loads
};

}  // namespace hawser
