// Nodes and elements of all lines, the same on every rank, in file order: line by line from end A to end B,
// followed by a node for every body with mass.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/base/names.hpp"
#include "hawser/base/runs.hpp"
#include "hawser/math/types.hpp"
#include "hawser/mesh/mesh_table.hpp"
#include "hawser/model/line_end.hpp"

namespace hawser {

namespace model {
struct Case;
}

struct LineSpan {
  int first_node = 0, nodes = 0, first_element = 0, elements = 0;
  double length = 0;  // m, unstretched
  int end_node(LineEnd end) const { return first_node + (end == LineEnd::B ? nodes - 1 : 0); }
};

struct Mesh : MeshTable {
  std::vector<LineSpan> lines;
  Names line_names;  // as in the case, for messages
  std::vector<std::pair<int, int>>
      rides;     // bodies of the case that ride on lines, and the nodes they ride on
  Names bodies;  // names of the bodies of the case with a node, for messages; the others are empty

  // Nodes of lines: [0, line_nodes()); those of bodies follow.
  int line_nodes() const { return lines.empty() ? 0 : lines.back().first_node + lines.back().nodes; }
  int body_nodes() const { return nodes() - line_nodes(); }
  // Node of a body of the case; -1: no mass.
  int body_node(int body) const;
  // Node that is the frame of a body of the case: its own, or one of the line it rides on; -1: prescribed
  // motion.
  int frame_node(int body) const;
  // True if any body's motion is part of the state.
  bool has_frames() const { return line_nodes() < nodes() || !rides.empty(); }
  // Node of `line` nearest to arc length s [m from end A].
  int nearest_node(int line, double s) const;
  // Description of a node's place: "line hose, arc length 12.5 m", "body barge".
  std::string place(int node) const;
  // Frees what construction reserved.
  void shrink_to_fit();
};

// Unstretched arc length from end A, m; xi in [0, 1] along the element.
inline double arc_at(const Mesh& mesh, const Element& e, double xi) {
  const double a = mesh.node(e.first).arc;
  const double b = mesh.node(e.second).arc;
  return a + xi * (b - a);
}

// The largest of positive values by line type over the types of each line; 0 without elements.
Runs<double> largest_of_types(const Mesh& mesh, const std::vector<double>& values);

// Divides the lines of a checked case into elements: graded sections, arc lengths from end A.
Mesh build_mesh(const model::Case& c);

}  // namespace hawser
