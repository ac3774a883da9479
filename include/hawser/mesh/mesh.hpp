// Nodes and elements of all lines, the same on every rank, in file order: line by line from end A to end B,
// followed by a node for every body with mass.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

namespace model {
struct Case;
}

struct Node {
  int line = 0;          // for a body: index after the last line
  double arc = 0;        // m, unstretched arc length from end A
  double tributary = 0;  // m, half the lengths of the elements at this node
  bool rotates = false;  // beam node and body: two 3-blocks; cable node: one
  int body = -1;         // body of the case whose centre of mass this is; -1: none
  int pinned_to = -1;    // node whose position this one shares (a joint); this one does not rotate
  // Node of the frame that carries this one while they are tied: a body with mass, a rigid joint, the end of
  // a joint from which this one is released later.
  int tied_to = -1;
  // The two elements may differ here in tension or curvature: the type changes, a mass or a load is attached,
  // or an event depends on the tension.
  bool two_sided = false;
};

struct Element {
  int line = 0;
  int first = 0, second = 0;  // nodes
  int type = 0;               // index into Case::line_types
  double length = 0;          // m, unstretched
  bool beam = false;
  double free_strain = 0;  // strain without tension (thermal expansion)
};

struct LineSpan {
  int first_node = 0, nodes = 0, first_element = 0, elements = 0;
  double length = 0;  // m, unstretched
  std::string name;   // as in the case, for messages
};

struct Mesh {
  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<LineSpan> lines;
  std::vector<std::pair<int, int>>
      rides;                        // bodies of the case that ride on lines, and the nodes they ride on
  std::vector<std::string> bodies;  // names of the bodies of the case, for messages

  // Nodes of lines: [0, line_nodes()); those of bodies follow.
  int line_nodes() const { return lines.empty() ? 0 : lines.back().first_node + lines.back().nodes; }
  // Node of a body of the case; -1: no mass.
  int body_node(int body) const;
  // Node that is the frame of a body of the case: its own, or one of the line it rides on; -1: prescribed
  // motion.
  int frame_node(int body) const;
  // True if any body's motion is part of the state.
  bool has_frames() const { return line_nodes() < static_cast<int>(nodes.size()) || !rides.empty(); }
  // Node of `line` nearest to arc length s [m from end A].
  int nearest_node(int line, double s) const;
  // Description of a node's place: "line hose, arc length 12.5 m", "body barge".
  std::string place(int node) const;
};

// Divides the lines of a checked case into elements: graded sections, arc lengths from end A.
Mesh build_mesh(const model::Case& c);

}  // namespace hawser
