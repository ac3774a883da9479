// Contact of an element of one line with an element of another, along the intervals of the first that touch
// the second. See docs/theory/line-line.md. Pure: (state and contact points at the start of the step, trial)
// -> forces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hawser/kernels/axis_closest_point.hpp"
#include "hawser/kernels/contact_intervals.hpp"
#include "hawser/kernels/contact_point.hpp"
#include "hawser/kernels/line_pair_law.hpp"

namespace hawser {

// The part of the pressure between two lines that is integrated along the slave, by the radii; along the
// master it is the rest. Lines as thick as each other have a half each, and one that is half as thick again
// nothing: a thinner line may be wound round it, and seen from inside such a winding, on the axis of what it
// is wound round, all of it is equally near. From outside it is plain where the nearest point is: no line is
// bent to its own radius.
double slave_share(double slave_radius, double master_radius);

// An element of a pair at the start of the step and in the trial.
struct PairAxis {
  PairAxis(const AxisEnds& now, const AxisEnds& start);

  AxisShape now, start;
  AxisEnds ends;             // now
  std::array<Mat3, 2> turn;  // of the sections at its nodes since the start; a cable's turn with its axis
  bool beam() const { return now.count() == 4; }
  Mat3 turn_at(double xi) const { return (1 - xi) * turn[0] + xi * turn[1]; }
};

// A Gauss point of the accepted state. Space axes; the weight has the share of the pair's pass and the sign.
struct LinePairContactPoint : ContactPoint {
  double xi = 0, from = 0, to = 0;     // place; its panel: all of it touches
  bool opens = false, closes = false;  // contact begins at `from`, ends at `to`
  double eta = 0;                      // place on the other
  double slip[2] = {0, 0};             // m

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("place", "", self.xi);
    each("from", "", self.from);
    each("to", "", self.to);
    each("opens", "", self.opens);
    each("closes", "", self.closes);
    each("weight", "m", self.weight);
    each("place on the other", "", self.eta);
    each("slip", "m", self.slip);
    each("gap", "m", self.gap);
    ContactPoint::quantities(self, each, "N/m", "J/m");
  }
};

// Of a pair: none yet, and the blocks of the nodes of the one and of the other.
AttachedForces no_forces(const PairAxis& one, const PairAxis& other, bool rubs, bool derivatives = true);
Stencil stencil_of(const PairAxis& one, const PairAxis& other);

class LinePairPass {
 public:
  struct Settings {
    LinePairLaw law;
    double share = 0.5;                // of the pressure: slave_share of the radii
    double slave_radius = 0;           // m
    bool moves = true;                 // in dynamics; without damping it makes no difference
    bool convex = false;               // exclude negative stiffness
    std::array<double, 2> part{0, 1};  // of the slave, in xi: the rest has no contact with the master
    bool swapped = false;              // the slave is the second of the two in what add() adds to
  };

  LinePairPass(const PairAxis& slave, const PairAxis& master, ProjectOn part, const Settings& settings,
               const std::vector<LinePairContactPoint>& previous);

  // One rule's interval of the slave. An end that moves does so with the gap or with the place where the
  // master's nearest point reaches one of its ends.
  enum class End { fixed, gap, first_joint, second_joint };
  struct Panel {
    double from = 0, to = 0;
    End at_from = End::fixed, at_to = End::fixed;
  };
  std::vector<Panel> panels() const;

  // Adds the forces on the positions of the slave, behind these (or before, `swapped`) on those of the
  // master, and the couples on the nodes' rotations in the same order; K and C on request. `out` is a
  // no_forces() of the two in that order. points: what touches goes there if it is given, which is what the
  // state leaves behind when it is accepted.
  void add(const std::vector<Panel>& panels, bool derivatives, AttachedForces& out,
           std::vector<LinePairContactPoint>* points = nullptr) const;
  // J
  double potential(const std::vector<Panel>& panels) const;

 private:
  struct Start;
  struct Point;
  struct Rows;
  struct Slopes;
  struct MovingEnd;
  Point point(double xi) const;
  Start start(double xi) const;
  double contact_distance() const {
    return set_.law.radii + set_.law.normal.smoothing;
  }  // m, between the axes
  std::optional<double> crossing_of(double eta, double lo, double hi) const;
  std::vector<double> kinks(int levels) const;
  void split(const Panel& panel, std::vector<Panel>& out) const;
  LinePairPoint local(const Point& p, const Start& s) const;
  LinePairContactPoint left_behind(const Panel& panel, const Point& p, const LinePairForce& c,
                                   double weight) const;
  Rows rows(const Point& p) const;
  Slopes slopes(const Point& p, const Start& from, const LinePairForce& c, const Rows& rows) const;
  MovingEnd moving_end(double xi, End end) const;
  void add_convex(const Point& p, const LinePairForce& c, const Rows& rows, double weight,
                  AttachedForces& g) const;

  const PairAxis &slave_, &master_;
  ProjectOn part_;
  Settings set_;
  const std::vector<LinePairContactPoint>& previous_;
  double wa_, wb_;  // shares of the radii
  // Rows of AttachedForces: of the positions of both, and of their nodes' rotations.
  size_t at_slave_, at_master_, turn_slave_, turn_master_;
};

}  // namespace hawser
