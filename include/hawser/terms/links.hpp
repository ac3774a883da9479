// Springs and dampers between two attached points: heave compensators, links, slings, fender springs.
#pragma once

#include <mpi.h>

#include <memory>
#include <vector>

#include "hawser/kernels/link.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/between_points.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

// The links of a case, in its order. A rank that owns a node to whose frame one end of a link is fixed has
// both ends; the owner of the first such end counts the link. See docs/theory/links.md.
class Links final : public ForceTerm, public CouplesFixedNodes, public ScalesResiduals, public HasSeries {
 public:
  // Default rest lengths are those of the start shape, after bodies drawn in space are attached
  // (Bodies::fix_placed_in_space). Refuses a link whose rest length would be zero (model::Case::refuse).
  // Collective.
  Links(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
        const Kinematics& start);

  // One series per link, with rows on the rank that counts it.
  std::vector<Series> series() const override;
  std::vector<std::vector<double>> rows(const Kinematics& state) const override;

  std::string_view checkpoint_key() const override { return "links"; }
  void list_couplings(Couplings& to) const override;
  void renumber() override;
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double round_off(const Kinematics& state, double h) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  struct Link {
    std::string name;
    Attached a, b;
    LinkLaw law;
    int owner = -1;                            // mesh node of the first end that is fixed to a node
    bool has_both = false, counted = false;    // this rank has both ends; counts the link
    double damping = 0, work = 0;              // J, over the accepted steps
    double damping_power = 0, work_power = 0;  // W, at the start of the step

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("damping", "J", self.damping);
      each("work", "J", self.work);
    }
  };
  // Ends and force of a link in a state.
  struct Stretched {
    AttachedNow a, b;
    LinkForce force;
  };
  Stretched stretched(const Link& link, const Kinematics& state, bool convex = false) const;
  void powers(const Link& link, const Kinematics& state, double& damping, double& work) const;

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<Link> list_;
};

}  // namespace hawser
