// Histories of a case: what is kept at every step of points of lines, which may lie between two nodes, and of
// bodies.
#pragma once

#include <mpi.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class Histories {
 public:
  // fields: those of nodes; position and velocity come first. end_fields: those of ends of lines. Collective.
  Histories(MPI_Comm comm, const Subject& subject, const EndForces& ends,
            std::span<const io::ResultField> fields, std::span<const io::ResultField> end_fields);

  // One for each history of the case, in its order.
  const std::vector<io::ResultSeries>& series() const { return series_; }

  // A row for each series, empty on all ranks but one. values: of the owned nodes, by field; ends: of the
  // owned ends, by field of ends. Collective where ranks share a point or a volume.
  std::vector<std::vector<double>> rows(const Kinematics& at, const std::vector<std::vector<double>>& values,
                                        const std::vector<std::vector<double>>& ends) const;

 private:
  // A point of a line between node `nodes[0]` and the next; at a node the second has no weight.
  struct Point {
    int body = -1;                     // of the case, when it is one
    std::string volume = {};           // its name, when it is one
    int end = -1;                      // its place among the owned ends, when it is one that this rank has
    std::array<int, 2> nodes{-1, -1};  // local; -1: another rank's, or without weight
    std::array<double, 2> weights{1, 0};
    std::array<int, 2> places{-1, -1};  // of its nodes among those of the end forces; -1: none
    bool shared = false;                // several ranks have a part of it
  };
  Point point_of(int line, double arc) const;
  std::vector<double> node_row(const Point& p, size_t side, const Kinematics& at,
                               const std::vector<std::vector<double>>& values,
                               const std::vector<std::vector<double>>& ends) const;
  std::vector<double> line_row(const Point& p, const Kinematics& at,
                               const std::vector<std::vector<double>>& values,
                               const std::vector<std::vector<double>>& ends) const;
  std::vector<double> body_row(int body, const Kinematics& at) const;
  std::vector<double> volume_row(const std::string& volume, const Kinematics& at) const;

  // What a section force has of a field, on the side of a node that faces the point; `otherwise` of others.
  double facing(int field, const SectionForce& s, const Quat& q, double otherwise) const;

  MPI_Comm comm_;
  const Subject& subject_;
  const EndForces& ends_;
  std::vector<size_t> shown_, shown_last_;  // fields of a point, before and after the columns of ends
  // Among the fields; -1: not there.
  int tension_ = -1, before_ = -1, after_ = -1, wall_ = -1, shear_ = -1, torsion_ = -1, moment_ = -1,
      moment_2_ = -1, moment_3_ = -1;
  std::vector<Point> points_;
  std::vector<io::ResultSeries> series_;
};

}  // namespace hawser::record
