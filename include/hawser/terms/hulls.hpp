// Sea pressure on the hulls of floating bodies: exact buoyancy of the submerged part, and wave pressure
// (Froude-Krylov) on the instantaneous wetted surface. See docs/theory/hulls.md.
#pragma once

#include <memory>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/kernels/hull_pressure.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"

namespace hawser {

// Triangles of the volumes of a case, in its order.
using VolumeFacets = std::vector<std::shared_ptr<const MeshView>>;

// Surface of a body's hull relative to its centre of mass, body axes. Edges longer than `longest` [m] are
// split.
HullSurface hull_surface(const model::Case& c, int body, const VolumeFacets& facets, double longest);

// In statics the water does not act on bodies that are held where they start.
class Hulls final : public ForceTerm,
                    public AppliesExternalLoad,
                    public ScalesResiduals,
                    public ReportsBodyForces {
 public:
  // Builds the term for the bodies of the case that this rank owns.
  Hulls(const model::Case& c, const LocalMesh& mesh, const VolumeFacets& facets);

  std::string_view checkpoint_key() const override { return "hulls in water"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  double round_off(const Kinematics& state, double h) const override;
  std::vector<std::string> load_components(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Forces in a state: of still water, and the additional force of waves at the centre of mass, space axes.
  struct Forces {
    double time = -1, step = -1;
    Phase phase = Phase::statics;
    Vec3 x = Vec3::Zero();
    Quat q = Quat::Identity();
    HullPressure still_water;
    BodyForce waves;
  };
  struct Hull {
    HullSurface surface;
    int node = 0, block = 0, global = 0;  // local node; local block of its position; mesh node
    int body = 0;                         // index in the case
    bool in_waves = false;
    double full_buoyancy = 0;  // N, buoyancy of the fully submerged hull
    RigidBodyState start;      // at the start of the step
    // Wave heads at `time`, at the position that the body reaches with its velocity at the start of the step.
    mutable std::vector<double> heads;
    mutable double time = 0;
    mutable bool known = false;
    mutable Forces forces;  // of the last requested state
    BodyForce waves;        // at the last accepted state
    bool has_waves = false;
    double work = 0;  // J, work of the waves over the accepted steps
  };
  const std::vector<double>& heads(const Hull& hull, const Kinematics& state) const;
  HullPressure pressure(const Hull& hull, const Kinematics& state, bool waves, bool tangent) const;
  const Forces& forces(const Hull& hull, const Kinematics& state) const;

  Sea sea_;
  std::vector<Hull> list_;
  std::vector<std::vector<std::string>> load_components_;  // by body of the case
  double start_time_ = 0;                                  // s
};

}  // namespace hawser
