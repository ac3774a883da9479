// Nodes and elements of all lines as a table of parts with even elements: memory for each part, not for each
// node.
#pragma once

#include <compare>
#include <concepts>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "hawser/model/progression.hpp"

namespace hawser {

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

// Change of temperature along a line: arc lengths [m] and changes [K], a broken line.
using TemperatureRows = std::vector<std::pair<double, double>>;

// Consecutive elements of one type.
struct PartShape {
  int type = 0;
  bool beam = false;
  model::Progression lengths;
  double along = 0;        // m, length of the section's elements before the part
  double start = 0;        // m, arc length of the beginning of the section
  double section_end = 0;  // m, arc length of its end, if the part is the last one of the section; else 0
  double free_strain = 0;  // or, with rows of temperatures, the thermal expansion, 1/K
  int rows = -1;           // index of its rows of temperatures; -1: the same strain everywhere
  auto operator<=>(const PartShape&) const = default;
};

// A shape that parts of equal lines share.
struct SharedShape : PartShape {
  double end = 0;  // m, arc length of the last node
  // Length along the section before every 64th element and after the part, m; empty: not known. Arc lengths
  // are sums from there, so that they do not depend on the order of access.
  std::vector<double> sums;
};

// A part of a line with the elements of a shape.
struct EvenPart {
  int first_element = 0, first_node = 0;
  int line = 0;
  int elements = 0;
  const SharedShape* shape = nullptr;
  double element_length(int k) const { return shape->lengths.element_length(k); }
};

class MeshTable {
 public:
  int nodes() const { return nodes_; }
  int elements() const { return elements_; }
  // Computed from the table, O(log(parts) + log(special nodes)).
  template <std::integral Index>
  Node node(Index n) const {
    return node_at(static_cast<int>(n));
  }
  template <std::integral Index>
  Element element(Index e) const {
    return element_at(static_cast<int>(e));
  }
  // Of an element, at the cost of the search for its part alone.
  const EvenPart& part_of(int element) const;
  double length_of(int element) const;  // m, unstretched
  // In the order of the elements.
  std::span<const EvenPart> parts() const { return parts_; }
  // Nodes with properties that do not follow from the parts, ascending: carried, shared, two-sided, bodies.
  std::span<const std::pair<int, Node>> special_nodes() const { return special_; }
  double longest_element() const;  // m, unstretched; 0: no elements
  bool any_beam() const;
  bool any_cable() const;
  bool any_rotates() const;  // a node of a beam or a body

  // Appends elements to the line, from its last node (the first one after begin_line()) to new nodes. Returns
  // the length of the section's elements up to the last one, m.
  double add(int line, const PartShape& shape);
  void begin_line() { ++nodes_; }
  // Index for PartShape::rows.
  int add(TemperatureRows rows);
  // Appends one node or element with its own memory: bodies, and lines of few elements.
  void add(const Node& node);
  void add(const Element& element);
  void shrink_to_fit() { parts_.shrink_to_fit(); }
  // Replaces nodes.
  void set(const std::map<int, Node>& changed);

 private:
  int nodes_ = 0, elements_ = 0;
  using Shapes = std::map<PartShape, SharedShape>;  // copies of the table share it
  std::shared_ptr<Shapes> shapes_ = std::make_shared<Shapes>();
  std::vector<EvenPart> parts_;
  std::vector<TemperatureRows> rows_;
  std::vector<std::pair<int, Node>> special_;

  Node node_at(int n) const;
  Element element_at(int e) const;
  double arc_of(const EvenPart& part, int k) const;
};

}  // namespace hawser
