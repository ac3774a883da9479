// Histories of a case: values at points of lines, which may lie between nodes, and of bodies at every step.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/section_fields.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class Histories : public Recording {
 public:
  // Subject and forces must outlive the object.
  Histories(const Subject& subject, const EndForces& ends) : subject_(subject), ends_(ends) {}

  // One series per history of the case, in order.
  void declare(Declarations& to) override;
  void rows(const Snapshot& s, Rows& to) override;

 private:
  // Point of a line between node `nodes[0]` and the next; at a node the second weight is zero.
  struct Point {
    int body = -1;                     // index in the case if it is a body; else -1
    std::string volume = {};           // name if it is a volume
    int end = -1;                      // index among the owned ends; -1: none
    std::array<int, 2> nodes{-1, -1};  // local; -1: on another rank, or zero weight
    std::array<double, 2> weights{1, 0};
    std::array<int, 2> places{-1, -1};  // of its nodes in the end forces; -1: none
    bool shared = false;                // several ranks contribute to its row
  };
  void find_shown(const std::vector<Field>& fields);
  // Point and columns of a history.
  Point body_history(const std::string& body, io::ResultSeries& series) const;
  Point line_history(const model::HistoryPoint& history, Declarations& to, io::ResultSeries& series) const;
  Point point_of(int line, double arc) const;
  std::vector<double> node_row(const Point& p, size_t side, const Snapshot& s) const;
  std::vector<double> line_row(const Point& p, const Snapshot& s) const;
  std::vector<double> body_row(int body, const Snapshot& s) const;
  // Components of the force on a floating body; empty: no term reports components.
  std::vector<std::string> load_components(int body) const;
  std::vector<double> volume_row(const std::string& volume, const Kinematics& state) const;

  // Value of a field from the section force on the side of a node that faces the point; `fallback` for other
  // fields.
  double facing(int field, const SectionForce& s, const Quat& q, double fallback) const;

  const Subject& subject_;
  const EndForces& ends_;
  std::vector<size_t> shown_, shown_last_;  // fields of a point, before and after the end columns
  SectionFields section_;
  std::vector<Point> points_;
  std::vector<size_t> columns_;  // of the series of each point
};

}  // namespace hawser::record
