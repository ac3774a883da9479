// Winches, tensioners and reels: what pays a line out at one of its ends and hauls it in. The line's elements
// from that end on are a stock that is held at the feeder and idle; the one that leaves it, at the feed
// point, has an unstretched length of its own. How much a tensioner lets out: kernels/feeder_law.cpp; nodes
// that leave and are caught: run/feeder_nodes.cpp. See docs/theory/feeders.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hawser/kernels/beam.hpp"
#include "hawser/kernels/cable.hpp"
#include "hawser/kernels/feeder_law.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/feeder.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/system/tied_nodes.hpp"

namespace hawser {

namespace model {
struct Case;
}

struct Feeder {
  int line = 0;
  bool at_b = false;
  std::string name;  // "end A of line mooring"
  model::Feed feed;
  TiedNode tied;  // of a node that is held at the feeder
  bool beam = false;
  CableSection cable;  // of the element at the feed point, of its own length
  BeamSection bar;     // likewise, of a line that resists bending
  double free_strain = 0;
  double mass_per_length = 0;   // kg/m
  Vec3 weight = Vec3::Zero();   // N/m
  double outside_at_start = 0;  // m, unstretched

  // Committed, the same on all ranks.
  int feed_point =
      0;  // the element at the feed point, counted from the fed end; those before it are the stock
  double length = 0;       // m, unstretched, of that element
  double speed = 0;        // m/s
  double length_rate = 0;  // m/s, of FeedPoint
  bool resting = false;    // within its dead band
  double offset = 0;       // m: of a feeder that goes by speed the length is this and what it has paid out
  double time = 0;         // s
};

// The element at the feed point, in a trial.
struct FeedPoint {
  double length = 0, speed = 0, acceleration = 0;  // m, m/s, m/s²: unstretched length and its rates
  double by_chord = 0;                             // derivative of the length by the chord
  double length_by_force = 0;                      // m/N, by the force of a beam on its feeder
  // m/s: the rate of the length with which the velocities of the ends make the strain rate that the damper of
  // the step had, where a tension is kept.
  double length_rate = 0;
};

class Feeders final : public ForceTerm, public ActsOnElements, public LimitsSteps {
 public:
  Feeders(const LocalMesh& mesh, const model::Case& c);

  const std::vector<Feeder>& list() const { return feeders_; }
  std::vector<Feeder>& list() { return feeders_; }

  // Of the mesh, counted from the fed end: element i lies between nodes i and i + 1.
  int node(const Feeder& f, int i) const;
  int element(const Feeder& f, int i) const;
  double element_length(const Feeder& f, int i) const;  // m, of a free one
  int elements(const Feeder& f) const;
  double outside(const Feeder& f) const;  // m, unstretched, that has left the feeder
  // Updates the section at the feed point after another element has come there.
  void update_feed_point(Feeder& f) const;
  // Node axes of a fed end that is clamped, in its body's frame (or space), by line and end.
  void clamp(const std::vector<std::array<Quat, 2>>& ends);
  // Local element at the feed point; null: not on this rank.
  const LocalElement* at_feed_point(const Feeder& f) const;

  // What masses and water see of the feed point is that of the speed at the start of the step, unless `now`.
  FeedPoint feed_point(const Feeder& f, const Kinematics& at, bool now) const;
  // Of an element of the mesh; nullopt: no feeder has to do with it.
  struct ElementState {
    bool idle = false;           // inside a feeder
    double length = 0;           // m, unstretched
    double length_by_chord = 0;  // derivative by the chord
    double length_by_force = 0;  // m/N, by the force of a beam on its feeder
    double length_rate = 0;      // m/s, its rate
    double before = 0;  // m, unstretched at the start of the step, of the one at a feed point; else `length`
    int feeder = -1;    // among list(), of the one at a feed point
  };
  std::optional<ElementState> element_state(int element, const Kinematics& at, bool now) const;
  // Of the one at a feed point, its end at the feeder: 0 or 1; -1: of another.
  int fed_end(int element) const;
  // How many elements are inside the feeders at ends A and B of each line.
  std::vector<std::array<int, 2>> inside() const;
  // Sets which elements of a term are idle, and the unstretched length of the others.
  template <class Of>
  void update_lengths(std::vector<Of>& elements, const Kinematics& at, bool now) const {
    for (Of& e : elements)
      if (const auto r = element_state(e.at.global, at, now)) {
        e.idle = r->idle;
        e.section.length = r->length;
      }
  }
  // Where all was at the start of the step; nothing before the first.
  const State& before() const { return before_; }

  // N, that a feeder feels of the element at its feed point, of an unstretched length [m]: its tension at the
  // end of the step that began with the committed state, and of a beam M²/2EI.
  FedPull pull(const Feeder& f, const Kinematics& at, const LocalElement& e, double length) const;

  // The tied nodes with those of what is inside feeders, of the local nodes.
  std::vector<TiedNode> with_held(const std::vector<TiedNode>& tied) const;
  // Nodes of the mesh that are held at a feeder or may once be.
  std::vector<int> fed_nodes() const;

  // Work of the feeders that another term knows of, J, of what this rank counts.
  void add_work(double work) { work_ += work; }
  double work() const { return work_; }
  void set_work(double work) { work_ = work; }

  std::string_view name() const override { return "feeders"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  void element_force(const Kinematics& at, const LocalElement& e, double* f) const override;
  void limit_step(const Kinematics&, ImpactEvents&) const override {}
  Verdict check_step(const Kinematics& trial) const override;

  // Of the material at the feed point, at the feeder's end of the element: velocity, and what its
  // acceleration is beyond that of the feeder.
  struct Flow {
    Vec3 chord, velocity, acceleration;  // m, m/s, m/s²
  };
  Flow flow(const FeedPoint& m, const Kinematics& at, const LocalElement& e, bool at_b) const;

 private:
  // Of the element at a feed point that is a cable: at the start of the step, and its mean rate over it, 1/s.
  double strain_before(const Feeder& f, const LocalElement& e) const;
  double strain_rate(const Feeder& f, const Kinematics& at, const LocalElement& e, double length) const;
  CableFeed feed_of_cable(const Feeder& f, const Kinematics& at, const LocalElement& e, double length) const;
  double power(const Feeder& f, const Kinematics& at, const LocalElement& e) const;
  double load_work(const Feeder& f, const Kinematics& at, const LocalElement& e, double length) const;
  void force(const Feeder& f, const FeedPoint& m, const Kinematics& at, const LocalElement& e,
             Vec3* out) const;

  const LocalMesh& mesh_;
  const model::Case& case_;
  std::vector<Feeder> feeders_;
  std::vector<std::array<int, 2>> of_line_;  // which of them are at end A and end B of a line; -1: none
  std::vector<double> power_;                // W, of the committed state, by feeder
  std::vector<double> pulls_;                // N, likewise, what beams pull with
  State before_;                             // committed positions and rotations
  double work_ = 0;                          // J
};

}  // namespace hawser
