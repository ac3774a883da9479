// Forces of lines at their ends and on both sides of inner nodes where tension or curvature may jump: the
// element force at the node, including its share of distributed loads (docs/theory/end-forces.md).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "hawser/system/system.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

// Section force on one side of a node, exerted by the part of the line after the section (towards end B) on
// the part before it; N and N m about the node, space axes.
struct SectionForce {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  Vec3 direction = Vec3::Zero();  // unit tangent of the line, from end A to end B
  bool beam = false;

  // Tension, N; never negative for cables.
  double tension() const;
  double shear() const { return beam ? (force - force.dot(direction) * direction).norm() : 0; }
};

class EndForces {
 public:
  // An owned node at an end of a line or where the sides may differ. End A has no element before it, end B
  // none after it.
  struct SectionNode {
    int node = 0;                         // local
    int line = -1;                        // of the mesh
    std::optional<LineEnd> line_end;      // none: within the line
    int before = -1, after = -1;          // local elements
    std::array<SectionForce, 2> sides{};  // before, after
    const SectionForce& at_line_end() const { return sides[after >= 0 ? 1 : 0]; }
    // Sign of the force that the line exerts on the support of its end.
    double sign() const { return after >= 0 ? 1 : -1; }
  };

  // For a fed end the force is that at the feed point; feeders: null if no line is fed.
  explicit EndForces(const System& system, const Feeders* feeders = nullptr);

  // From an accepted state. support_forces: forces of bed, soil, volumes and other lines on local nodes, N;
  // nonzero where the line does not hang freely. No communication, unless ends are fed.
  void evaluate(const Kinematics& state, std::span<const Vec3> support_forces);

  const std::vector<SectionNode>& places() const { return places_; }  // in the order of nodes
  // Force on each feeder, N: the tension at its feed point and, for beams, M²/2EI.
  const std::vector<double>& at_feeders() const { return feeder_forces_; }
  // Number of an end among the owned ends, by its local node; -1: none.
  int end_at(int node) const;

 private:
  // At the node of an element towards an end of its line.
  SectionForce section(const Kinematics& state, int element, LineEnd end,
                       std::span<const Vec3> support_forces) const;

  void evaluate_feed_points(const Kinematics& state, std::span<const Vec3> support_forces);

  const System& system_;
  const Feeders* feeders_;
  std::vector<SectionForce> feed_points_;  // at the feed points, by feeder, on all ranks
  std::vector<double> feeder_forces_;
  std::vector<SectionNode> places_;
};

}  // namespace hawser::record
