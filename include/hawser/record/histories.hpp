// Histories of a case: what is kept at every step of points of lines, which may lie between two nodes, and of
// bodies.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class Histories : public Recording {
 public:
  // Subject and forces outlive it.
  Histories(const Subject& subject, const EndForces& ends) : subject_(subject), ends_(ends) {}

  // A series for each history of the case, in its order.
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  // A point of a line between node `nodes[0]` and the next; at a node the second has no weight.
  struct Point {
    int body = -1;                     // of the case, when it is one
    std::string volume = {};           // its name, when it is one
    int end = -1;                      // its place among the owned ends, when it is one that this rank has
    std::array<int, 2> nodes{-1, -1};  // local; -1: another rank's, or without weight
    std::array<double, 2> weights{1, 0};
    std::array<int, 2> places{-1, -1};  // of its nodes among those of the end forces; -1: none
    bool shared = false;                // several ranks have a part of its row
  };
  Point point_of(int line, double arc) const;
  std::vector<double> node_row(const Point& p, size_t side, const Snapshot& s) const;
  std::vector<double> line_row(const Point& p, const Snapshot& s) const;
  std::vector<double> body_row(int body, const Snapshot& s) const;
  // Of forces on a floating body by what they come from; empty: by nothing that states it.
  std::vector<std::string> origins(int body) const;
  std::vector<double> volume_row(const std::string& volume, const Kinematics& at) const;

  // What a section force has of a field, on the side of a node that faces the point; `otherwise` of others.
  double facing(int field, const SectionForce& s, const Quat& q, double fallback) const;

  const Subject& subject_;
  const EndForces& ends_;
  std::vector<size_t> shown_, shown_last_;  // fields of a point, before and after the columns of ends
  // Among the fields; -1: not there.
  int tension_ = -1, before_ = -1, after_ = -1, wall_ = -1, shear_ = -1, torsion_ = -1, moment_ = -1,
      moment_2_ = -1, moment_3_ = -1;
  std::vector<Point> points_;
  std::vector<size_t> columns_;  // of the series of each point
};

}  // namespace hawser::record
