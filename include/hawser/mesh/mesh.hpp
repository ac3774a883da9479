// Nodes and elements of all lines, the same on every rank, in file order: line by line, end A to end B.
#pragma once

#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

namespace model {
struct Case;
}

struct Node {
  int line = 0;
  double arc = 0;        // m, unstretched arc length from end A
  double tributary = 0;  // m, half the lengths of the elements at this node
  bool rotates = false;  // beam node: two 3-blocks; cable node: one
};

struct Element {
  int line = 0;
  int first = 0, second = 0;  // nodes
  int type = 0;               // index into Case::line_types
  double length = 0;          // m, unstretched
  bool beam = false;
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

  // Node of `line` nearest to arc length s [m from end A].
  int nearest_node(int line, double s) const;
  // "line hose, arc length 12.5 m": where a node is, in words.
  std::string place(int node) const;
};

// Cut the lines of a checked case into elements: graded sections, arc lengths from end A.
Mesh build_mesh(const model::Case& c);

}  // namespace hawser
