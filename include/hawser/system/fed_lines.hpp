// Lines that are paid out and hauled in (terms/feeders.hpp): list of the elements whose unstretched length
// changes, for the other force terms.
#pragma once

#include <array>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/line_end.hpp"
#include "hawser/state/state.hpp"

namespace hawser {

// A line at one of its feeders: the element at the feed point and those inside.
struct FedLine {
  size_t feeder = 0;            // index into FedLines::fed()
  int element = 0;              // of the mesh
  std::array<int, 2> inside{};  // elements of the mesh inside the feeder: from the first to before the second
  LineEnd line_end = LineEnd::A;  // at which the feeder is
  double before = 0;              // m, unstretched length at the start of the step
  double predicted = 0;           // m, at the speed of the start of the step: for masses, water and contact
  double length = 0;              // m, in the state
  double length_by_chord = 0;     // its derivative by the chord
  double length_by_force = 0;     // m/N, its derivative by the force of a beam on its feeder
  double length_rate = 0;         // m/s
};

// Role of the feeders. System calls update() with each state before the terms prepare a step from it,
// evaluate it or commit it, and again after all have committed.
class FedLines {
 public:
  virtual ~FedLines() = default;
  // Sets fed() to a state.
  virtual void update(const Kinematics& state) = 0;
  // Number of elements inside the feeders at ends A and B of each line.
  virtual std::vector<std::array<int, 2>> inside() const = 0;

  const std::vector<FedLine>& fed() const { return fed_; }  // by feeder
  // Entry of the mesh element if it is at a feed point; else null.
  const FedLine* find(int element) const;
  // True if an element of the mesh is inside a feeder.
  bool idle(int element) const;
  // Sets the idle flag and the unstretched length of all elements of a term.
  template <class Of>
  void update_lengths(const LocalMesh& mesh, double FedLine::*length, std::vector<Of>& elements) const {
    for (Of& e : elements) {
      const FedLine* fed = find(e.element.global);
      e.idle = idle(e.element.global);
      e.section.length = fed ? fed->*length : mesh.element(e.element).length;
    }
  }
  // Positions and rotations at the start of the step; empty before the first step.
  const State& before() const { return before_; }
  // Adds work of the feeders that another term computes, J, for the parts that this rank counts.
  void add_work(double work) { work_ += work; }

 private:
  std::vector<FedLine>::const_iterator first_from(int element) const;

 protected:
  std::vector<FedLine> fed_;  // sorted by line, then end A before end B
  State before_;
  double work_ = 0;  // J
};

// Role of terms that act on elements of lines.
class ActsOnFedLines {
 public:
  virtual ~ActsOnFedLines() = default;

 protected:
  friend class System;
  FedLines* feeders_ = nullptr;  // set by System::add(); null: no line is fed
};

}  // namespace hawser
