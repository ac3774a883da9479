// Internal forces of all lines: beams and cables.
#pragma once

#include <mpi.h>

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hawser/kernels/beam.hpp"
#include "hawser/kernels/cable.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"

namespace hawser {

namespace model {
struct Case;
}

class LineStructure final : public ForceTerm,
                            public ActsOnElements,
                            public HasAxialStiffness,
                            public ScalesResiduals,
                            public LimitsSteps,
                            public ActsOnFedLines {
 public:
  // For steps that resolve a snap load of a cable. Beams do not become slack, and each change of the step
  // changes the energy of axial vibration that the steps do not resolve.
  struct Peak {
    double transit_time = 0;  // s, of an axial wave through the element
    double largest = 0;  // N, tension so far; at least the weight of the element, within which tension varies
  };
  struct Beam {
    LocalElement element;
    int blocks[4] = {};  // x1, theta1, x2, theta2
    BeamSection section;
    BeamReference reference = {};
    bool idle = false;          // inside a feeder
    size_t memory = 0;          // index of its first value in plastic_history_
    size_t remembered() const;  // number of values in its plastic history
  };
  struct Cable {
    LocalElement element;
    int blocks[2] = {};
    CableSection section;
    CableStart start = {};  // state at the start of the step
    Peak peak = {};
    bool idle = false;  // inside a feeder
  };

  LineStructure(const LocalMesh& mesh, std::vector<Beam> beams, std::vector<Cable> cables);

  // Takes the sections from the line types of the case. Every beam is straight when stress-free.
  LineStructure(const LocalMesh& mesh, const model::Case& c);

  std::string_view checkpoint_key() const override { return "structure"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  void element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const override;
  double round_off(const Kinematics& state, double h) const override;
  Overstretch overstretched(const Kinematics& state) const override;
  void tensions(const Kinematics& state, std::span<LineTension> lines) const override;
  // Length of this rank's cables without tension, by line, m.
  std::vector<double> slack_length(const Kinematics& state) const;
  bool limit_axial_stiffness(double max_EA) override;
  void restore_sections() override;
  double axial_stiffness() const override;
  void unresolved(const Kinematics& trial, UnresolvedImpacts& to) override;
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

  std::vector<Beam>& beams() { return beams_; }
  // Called before the feed point of a feeder moves to the next element; releases: inwards, because a node is
  // released. Moves the plastic history with the material. Collective.
  void transfer_node(MPI_Comm comm, size_t feeder, bool releases);

 private:
  // Plastic history on both sides of a feed point (line_structure_feed.cpp), by material label from the free
  // node on.
  struct FedBends {
    std::vector<double>
        inside;  // material inside the feeder: of the element at the feed point, and of the next one
    std::vector<double> trial;  // element at the feed point with its trial length, in the element's order
  };
  // accepted: the lengths are those at the end of the step.
  void update_from_feeders(const Kinematics& state, bool accepted = false);
  static CableSection section_for_output(const Cable& c, const Kinematics& state);
  void move_plastic_history(Beam& b, const FedLine& f, double to);
  void keep_hauled_in(const Beam& b, const FedLine& f);
  double fed_work(const Kinematics& state) const;
  std::vector<double> entering(const FedLine& f, double label) const;
  double beam_dissipation(const Kinematics& state) const;
  struct ElementField;
  void fill_at_nodes(const ElementField& f, const Kinematics& k, std::span<double> out) const;
  void add_node_axes(FieldRegistry& registry) const;
  double commit_plastic(const Kinematics& state);

  const LocalMesh& mesh_;
  std::vector<Beam> beams_;
  std::vector<Cable> cables_;
  std::vector<FedBends> fed_;             // by feeder, in the order of FedLines
  bool damped_ = false, yields_ = false;  // yields_: a line type of the model bends plastically
  std::vector<double> plastic_history_;   // histories of all beams, see BeamReference::set; zero in statics
  // True values while the axial stiffness is limited: EA [N] and plastic law of beams; EA of cables.
  std::vector<std::pair<double, const PlasticBending*>> true_beams_;
  std::vector<double> true_EA_;
  std::optional<double> power_;  // W, dissipated by beams at the committed state
  double damping_ = 0;           // J, dissipated so far
  double filtered_ = 0;          // J, removed so far from axial vibration that the steps do not resolve
  double last_step_ = 0;         // s, length of the step that led to the committed state
};

// Positions, rotations and rates of an element's ends.
BeamEnds ends(const LineStructure::Beam& b, const Kinematics& k);
CableEnds ends(const LineStructure::Cable& c, const Kinematics& k);

}  // namespace hawser
