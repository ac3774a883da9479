// Contact of an element of one line (slave) with an element of another (master), along the intervals of the
// slave that touch the master. See docs/theory/line-line.md. Pure: (state and contact points at the start of
// the step, trial) -> forces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hawser/kernels/axis_closest_point.hpp"
#include "hawser/kernels/contact_intervals.hpp"
#include "hawser/kernels/contact_point.hpp"
#include "hawser/kernels/line_pair_law.hpp"

namespace hawser {

// Fraction of the pressure between two lines that is integrated along the slave, by the radii; the rest is
// integrated along the master. For equal radii it is one half, and 0 for a slave 1.5 times as thick as
// the master: a thinner line may be wound round it, and all of such a winding is equidistant from the axis
// of the line inside it. From the winding the nearest point is unique, because no line is bent to its own
// radius.
double slave_fraction(double slave_radius, double master_radius);

// An element of a pair at the start of the step and in the trial.
struct PairAxis {
  PairAxis(const AxisEnds& now, const AxisEnds& start);

  AxisShape now, start;
  AxisEnds ends;                   // now
  std::array<Vec3, 2> directions;  // of a cable, at the start and now
  std::array<Mat3, 2> turn;  // of the sections at the nodes since the start; a cable's turn with its axis
  bool beam() const { return now.count() == 4; }
  Mat3 turn_at(double xi) const { return (1 - xi) * turn[0] + xi * turn[1]; }
};

// Gauss point of the accepted state, in space axes. The weight includes the pass's fraction and sign.
struct LinePairContactPoint : ContactPoint {
  double xi = 0, from = 0, to = 0;     // position; limits of its panel, all of which is in contact
  bool opens = false, closes = false;  // contact begins at `from`, ends at `to`
  double eta = 0;                      // position on the other line
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

// AttachedForces without forces, and the blocks of the nodes of both elements.
AttachedForces no_forces(const PairAxis& one, const PairAxis& other, bool has_friction,
                         bool derivatives = true);
Stencil stencil_of(const PairAxis& one, const PairAxis& other);

class LinePairPass {
 public:
  struct Settings {
    LinePairLaw law;
    double fraction = 0.5;              // s of the theory: part of the pressure, from slave_fraction()
    double slave_radius = 0;            // m
    bool moves = true;                  // in dynamics; without damping it has no effect
    bool convex = false;                // exclude negative stiffness
    std::array<double, 2> range{0, 1};  // of the slave in xi, may touch the master
    bool swapped = false;               // the slave is the second of the two in the output of add()
  };

  LinePairPass(const PairAxis& slave, const PairAxis& master, ProjectOn target, const Settings& settings,
               const std::vector<LinePairContactPoint>& previous);

  // Integration interval of the slave. An end may move with the gap, or with the point where the master's
  // nearest point reaches one of its ends.
  enum class End { fixed, gap, first_joint, second_joint };
  struct Panel {
    double from = 0, to = 0;
    End at_from = End::fixed;
    End at_to = End::fixed;
  };
  std::vector<Panel> panels() const;

  // Adds the forces on the positions of the slave, followed by those of the master (`swapped`: preceded), and
  // the couples on the nodes' rotations in the same order; K and C on request. `out`: a no_forces() of both
  // elements in that order. `points`, if given, receives the contact points that an accepted state stores.
  void add(const std::vector<Panel>& panels, bool derivatives, AttachedForces& out,
           std::vector<LinePairContactPoint>* points = nullptr) const;
  // Potential of the contact, J.
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
  LinePairContactPoint stored_point(const Panel& panel, const Point& p, const LinePairForce& c,
                                    double weight) const;
  Rows rows(const Point& p) const;
  void find_slopes(const Point& p, const Start& from, const LinePairForce& c, const Rows& rows,
                   Slopes& s) const;
  void add_friction_slopes(const Point& p, const Start& from, const LinePairForce& c, Vec3& by_xi,
                           Vec3& by_eta) const;
  void add_section_turns(const Point& p, const Mat3& by_moved, const Rows& rows, Slopes& s) const;
  MovingEnd moving_end(double xi, End end) const;
  void add_convex(const Point& p, const LinePairForce& c, const Rows& rows, double weight,
                  AttachedForces& g) const;

  const PairAxis &slave_, &master_;
  ProjectOn target_;
  Settings set_;
  const std::vector<LinePairContactPoint>& previous_;
  double slave_lever_, master_lever_;  // radii of slave and master over their sum
  // Rows of AttachedForces for the positions of both, and for the rotations of their nodes.
  size_t at_slave_, at_master_, turn_slave_, turn_master_;
};

}  // namespace hawser
