// Winches, tensioners and reels, which pay out and haul in a line at one of its ends. The elements from that
// end on are a stock, held at the feeder and idle. The element that leaves the feeder, at the feed point, has
// a variable unstretched length. The payout law of a tensioner is in kernels/feeder_law.cpp, release and
// capture of nodes in run/feeder_nodes.cpp. See docs/theory/feeders.md.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "hawser/kernels/beam.hpp"
#include "hawser/kernels/cable.hpp"
#include "hawser/kernels/feeder_law.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/feeder.hpp"
#include "hawser/model/line_end.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/system/tied_nodes.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

namespace model {
struct Case;
}

struct Feeder {
  size_t index = 0;  // into Feeders::all() and fed()
  int line = 0;
  LineEnd line_end = LineEnd::A;
  std::string name;  // "end A of line mooring"
  model::Feed feed;
  TiedNode tied;  // how a node is held at the feeder
  bool beam = false;
  // Of the element at the feed point, with its length in the mesh: the one of these that `beam` names.
  CableSection cable_section;
  BeamSection beam_section;
  double free_strain = 0;
  double mass_per_length = 0;   // kg/m
  Vec3 weight = Vec3::Zero();   // N/m
  double outside_at_start = 0;  // m, unstretched

  // The committed state, the same on all ranks.
  // Index of the element at the feed point, counted from the fed end; elements before it are the stock.
  int feed_point = 0;
  double length = 0;       // m, unstretched length of that element
  double speed = 0;        // m/s
  double length_rate = 0;  // m/s, see FeedPoint
  bool resting = false;    // the tension is within the dead band
  double offset = 0;       // m; with a prescribed speed, `length` is this plus what has been paid out
  double time = 0;         // s
};

// Element at the feed point in a trial.
struct FeedPoint {
  double length = 0, speed = 0, acceleration = 0;  // m, m/s, m/s²: unstretched length and its rates
  double by_chord = 0;                             // derivative of the length by the chord
  double length_by_force = 0;  // m/N, derivative of the length by the force of a beam on its feeder
  // m/s, rate of the length at which, with a constant tension, the velocities of the ends reproduce the
  // strain rate of the damper over the step.
  double length_rate = 0;
};

class Feeders final : public ForceTerm, public ActsOnElements, public LimitsSteps, public FedLines {
 public:
  Feeders(const LocalMesh& mesh, const model::Case& c);

  const std::vector<Feeder>& all() const { return feeders_; }
  std::vector<Feeder>& all() { return feeders_; }

  // Nodes and elements of the mesh, counted from the fed end: element i lies between nodes i and i + 1.
  int node(const Feeder& f, int i) const;
  int element(const Feeder& f, int i) const;
  double element_length(const Feeder& f, int i) const;  // m, when free
  int elements(const Feeder& f) const;
  double outside(const Feeder& f) const;  // m, unstretched length that has left the feeder
  // Sets the section at the feed point, and the entry of fed(), after another element has come there.
  void update_feed_point(Feeder& f);
  // Sets the node axes of clamped fed ends, in the body's frame (or space), by line and end.
  void clamp(const std::vector<std::array<Quat, 2>>& ends);
  // The local element at the feed point; null: it is not on this rank.
  const LocalElement* at_feed_point(const Feeder& f) const;

  // State of the feed point at the end of the step of the trial.
  FeedPoint feed_point(const Feeder& f, const Kinematics& state) const;
  // State of the feed point predicted with the speed at the start of the step, used for mass and water
  // forces.
  FeedPoint predicted_feed_point(const Feeder& f, const Kinematics& state) const;
  void update(const Kinematics& state) override;
  std::vector<std::array<int, 2>> inside() const override;

  // Force [N] on the feeder from the element at its feed point with an unstretched length [m]: the tension at
  // the end of the step that starts from the committed state, for a beam plus M²/2EI.
  FedPull pull(const Feeder& f, const Kinematics& state, const LocalElement& e, double length) const;

  // `tied` with the local nodes inside feeders held at them.
  std::vector<TiedNode> with_held(const std::vector<TiedNode>& tied) const;
  // Mesh nodes that are, or may later be, held at a feeder.
  std::vector<int> fed_nodes() const;

  double work() const { return work_; }
  void set_work(double work) { work_ = work; }
  // Work [J] of the feeders on lines in a step of h [s] while they remove the same work elsewhere, from the
  // same line or another. pulls: force on each feeder, N.
  double passed_through(std::span<const double> pulls, double h) const;

  std::string_view checkpoint_key() const override { return "feeders"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  void element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const override;
  Verdict check_step(const Kinematics& trial) const override;

  // Motion of the material at the feeder's end of the element at the feed point: its velocity, and its
  // acceleration minus that of the feeder.
  struct Flow {
    Vec3 chord, velocity, acceleration;  // m, m/s, m/s²
  };
  Flow flow(const FeedPoint& m, const Kinematics& state, const LocalElement& e, LineEnd line_end) const;

 private:
  // For a cable element at a feed point: strain at the start of the step, and mean strain rate over the step,
  // 1/s.
  double strain_before(const Feeder& f, const LocalElement& e) const;
  double strain_rate(const Feeder& f, const Kinematics& state, const LocalElement& e, double length) const;
  CableFeed feed_of_cable(const Feeder& f, const Kinematics& state, const LocalElement& e,
                          double length) const;
  double power(const Feeder& f, const Kinematics& state, const LocalElement& e) const;
  bool rests(const Feeder& f, const FeedPoint& m, const Kinematics& accepted, const LocalElement& e) const;
  double work_of_step(size_t feeder, const Kinematics& accepted, const LocalElement& e, double h,
                      double before) const;
  double load_work(const Feeder& f, const Kinematics& state, const LocalElement& e, double length) const;
  struct Inertia {
    Vec3 at_feeder, at_free_node;  // N
  };
  Inertia inertia(const Feeder& f, const FeedPoint& m, const Flow& o) const;
  Vec3 momentum(const Feeder& f, const FeedPoint& m, const Flow& o) const;

  const LocalMesh& mesh_;
  const model::Case& case_;
  std::vector<Feeder> feeders_;
  std::vector<double> power_;  // W, by feeder, at the committed state
  std::vector<double> pulls_;  // N, force of beams by feeder, at the committed state
};

}  // namespace hawser
