// What lines exert at their ends, and on both sides of the nodes within them where tension or curvature may
// jump: the force of the element there with its share of all that is distributed along it
// (docs/theory/end-forces.md).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hawser/system/system.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

// On one side of a node: what the part of the line after the section (towards end B) exerts on the part
// before it, N and N m about the node, space axes.
struct SectionForce {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  Vec3 direction = Vec3::Zero();  // unit tangent of the line, from end A to end B
  bool beam = false;

  // N. Of a cable never negative.
  double tension() const;
  double shear() const { return beam ? (force - force.dot(direction) * direction).norm() : 0; }
};

class EndForces {
 public:
  // An owned node at an end of a line, or where sides may differ. At end A there is no element before it, at
  // end B none after it.
  struct Place {
    int node = 0;                         // local
    int end = -1;                         // 2 l: end A of line l; 2 l + 1: its end B; -1: within a line
    int before = -1, after = -1;          // local elements
    std::array<SectionForce, 2> sides{};  // before, after
    const SectionForce& at_end() const { return sides[after >= 0 ? 1 : 0]; }
    // What the line exerts on what holds its end.
    double sign() const { return after >= 0 ? 1 : -1; }
  };

  // An end that is fed has the force at the feeder's feed point; null: none is.
  explicit EndForces(const System& system, const Feeders* feeders = nullptr);

  // From an accepted state. carried: what bed, soil, volumes and other lines exert on the local nodes, N:
  // where it is not zero the line does not hang freely. No communication, unless ends are fed.
  void evaluate(const Kinematics& at, std::span<const Vec3> carried);

  const std::vector<Place>& places() const { return places_; }  // in the order of nodes
  // N, what each feeder feels: the tension at its feed point and, of a line that resists bending, M²/2EI.
  const std::vector<double>& at_feeders() const { return feeder_forces_; }
  // Which of the owned ends is at a local node, counted in that order; -1: none.
  int end_at(int node) const;

 private:
  SectionForce section(const Kinematics& at, int element, bool second, std::span<const Vec3> carried) const;

  void evaluate_feed_points(const Kinematics& at, std::span<const Vec3> carried);

  const System& system_;
  const Feeders* feeders_;
  std::vector<SectionForce> feed_points_;  // at the feed point of each feeder, in their order, on all ranks
  std::vector<double> feeder_forces_;
  std::vector<Place> places_;
};

}  // namespace hawser::record
