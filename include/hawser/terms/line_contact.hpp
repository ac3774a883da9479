// Contact of lines with volumes anywhere along their elements: the laws of the `nodes` method per length of
// line, integrated over the stretches of each element's axis that touch. See docs/theory/line-contact.md.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_along.hpp"
#include "hawser/kernels/free_tube.hpp"
#include "hawser/kernels/line_contact.hpp"
#include "hawser/terms/contact.hpp"

namespace hawser {

// What contact must know of an element.
struct LineContactElement {
  double radius = 0;             // m, half the contact diameter; 0: the element takes no part
  double mass_per_length = 0;    // kg/m: the effective mass of relative_damping
  bool held = false;             // at an end of it: by a support or a body
  bool rolling = false;          // of a beam: friction acts at the line's surface and turns it about its axis
  Vec3 tangent = Vec3::UnitX();  // of a beam's axis, in the material axes of its nodes
};

class LineContact final : public Contact {
 public:
  // elements: one for each of mesh.elements. Indices are checked, std::invalid_argument otherwise. A
  // stiffness per point counts once an element.
  LineContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies, std::vector<ContactVolume> volumes,
              std::vector<LineContactElement> elements, MPI_Comm comm = MPI_COMM_SELF);

  std::string_view name() const override { return "line contact"; }
  void prepare(const Kinematics& committed, double h) override;
  // As limit_depth and strikes say of the ends and the middle of each element and of what touches.
  void limit_step(const Kinematics& committed, Strikes& to) const override;
  void unforeseen(const Kinematics& trial, Unforeseen& to) override;
  void evaluate(const Kinematics& trial, Sink& sink) override;
  // An automatic stiffness that is too low for what presses is raised, and the trial is solved again.
  bool stiffen(const Kinematics& equilibrium) override;
  void forget_stiffening() override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  // contact_force, contact_normal_force, friction_force as the element's shape functions share them out.
  void fields(FieldRegistry& registry) const override;
  std::vector<HistoryKind> history() const override;
  std::vector<HistoryRecord> save() const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  // `node` is the nearer end of the element.
  Penetration largest_penetration() const override;
  int candidates() const override;
  // Pairs of an element and a volume that touch.
  int touching() const override;
  void touches(Touches& out) const override;

 private:
  // A Gauss point, forces per length. Kept while it touches.
  struct Point : ContactHistory {
    using ContactHistory::ContactHistory;
    double xi = 0, from = 0, to = 0;  // place; its panel: all of it touches
    double weight = 0, gap = 0;       // m

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("place", "", self.xi), each("from", "", self.from), each("to", "", self.to);
      each("weight", "m", self.weight), each("gap", "m", self.gap);
      ContactHistory::quantities(self, each, "N/m", "J/m");
    }
  };
  // Where an axis touches: its panels, and the surface at their Gauss points (max() away: out of touch).
  // Kept, since residual, tangent and commit ask for the same trial one after the other.
  struct Found {
    bool known = false;
    AxisShape shape = nowhere();
    Vec3 position;  // of the body
    Quat rotation;
    std::vector<ContactStretch> panels;
    std::vector<ContactHollow> filled;  // parts of panels that do not touch
    std::vector<SurfacePoint> points;
  };
  // Where a surface may have several walls (surface_walls.hpp): what of them is near an axis, and which of
  // the points of before lay on each.
  struct Seen {
    SurfaceWalls walls;
    std::vector<std::vector<Point>> past;  // of each wall, or of the one there is; empty: the pair's own
  };
  // Of an element and a volume, shared by its pairs, one a wall; what was seen of the last axis is kept.
  struct Walls {
    std::vector<std::vector<Point>> committed;  // of each pair
    bool known = false;
    AxisShape shape = nowhere();
    Vec3 position;
    Quat rotation;
    std::shared_ptr<const Seen> seen;
    FreeTube free;  // as of Pair
    int hint = -1;
  };
  // An element and a volume; or one of its walls, of which there may be as many as there are pairs.
  struct Pair {
    int element = 0, volume = 0, slot = 0;
    double touch = 0;  // m, distance below which there is a force: radius + smoothing
    Share part;        // of the axis: the rest has no contact with this volume
    int levels = 1;
    ContactLaw law;               // per length
    AxisShape start = nowhere();  // the axis at the start of the step
    std::vector<Point> history;   // by xi
    // Where the axis touched at the start of the step, looked for closely; none: not looked for yet.
    std::optional<std::vector<ContactStretch>> before;
    // Kept from step to step, changes the time and never the answer: where nothing of the volume is within
    // `touch`; nearest triangles of the last query and of those of limit_step.
    mutable FreeTube free;
    int hint = -1;
    mutable std::array<int, 3> ahead{-1, -1, -1};
    Found found;
    // Whether there is one wall only about a chord, where that was asked.
    std::array<Vec3, 2> one_chord{Vec3::Zero(), Vec3::Zero()};
    double one_reach = -1;  // m
    bool one = false;
    std::shared_ptr<Walls> walls;      // none: there is one wall in this step
    std::shared_ptr<const Seen> seen;  // of the axis of `found`
    // The wall it is about; none: all of the surface, and of a further pair nothing.
    const SurfaceWall* wall() const {
      const size_t k = static_cast<size_t>(slot);
      return seen && seen->walls.several() && k < seen->walls.of.size() ? &seen->walls.of[k] : nullptr;
    }
    FreeTube& room() const { return walls ? walls->free : free; }
    bool idle() const { return slot > 0 && !wall(); }
    const std::vector<Point>& past() const {
      return seen && !seen->past.empty() ? seen->past[static_cast<size_t>(slot)] : history;
    }
  };
  // Of a point that touches in the trial, at the start of the step: from the history, or where it came from.
  struct Origin {
    bool touched = true;
    double xi = 0, gap = 0;        // -, m
    Vec3 gradient = Vec3::Zero();  // of the gap
  };
  struct Moving;
  class Gap;

  // What may be met of a volume in a step of h: whether it is one wall.
  bool one_wall(Pair& pair, const AxisShape& shape, const RigidPose& pose, double motion) const;
  void see_walls(Pair& pair, const AxisShape& shape, const RigidPose& pose) const;
  void assign_past(const Pair& pair, Seen& seen) const;
  // Pairs for walls that are seen, which have none until then. lacks_pairs: of the pair number i.
  bool lacks_pairs(size_t i) const;
  void open_pairs();
  static void keep_part(const Share& part, std::vector<ContactStretch>& panels);
  // What of an element may touch a volume.
  Share part_of(int element, int volume) const;
  // The axis as a polyline in the body's frame.
  static std::vector<Vec3> polyline(const AxisShape& shape, const RigidPose& pose, double touch);
  // What a pair sees of its volume.
  std::optional<SurfacePoint> see(const Pair& pair, const Vec3& y, double within,
                                  bool either_side = false) const;
  // What strikes at xi, `share` m of the line with it; what it may come to, which touches elsewhere already.
  void look(const Pair& pair, const Kinematics& committed, double xi, double share, double gap,
            const Vec3& normal, bool last, Strikes& to) const;
  void look_ahead(const Pair& pair, const Kinematics& committed, double xi, bool touching,
                  const SurfacePoint& p, Strikes& to) const;
  // The same at each of the walls it may come to in the step, if there are several.
  bool look_ahead_at_walls(const Pair& pair, const Kinematics& committed, Strikes& to) const;
  class Ahead;
  void foresee(const Pair& pair, const Kinematics& committed, const Strikes& to, Ahead& ahead) const;
  void limit_by_touch(const Pair& pair, const Kinematics& committed, Strikes& to) const;
  // By what its places come to, of which the first is number `place`.
  void limit_by(const Pair& pair, const Kinematics& committed, const Ahead& ahead, size_t place,
                Strikes& to) const;
  static AxisPoints points(const AxisShape& shape, const RigidPose& pose);
  // Of the part of the axis that may touch.
  static AxisPoints points_of_part(const Pair& pair, const AxisShape& shape, const RigidPose& pose);
  // Whether the axis is out of touch for sure; then nothing is found.
  static bool clear(Pair& pair, const AxisShape& shape, const RigidPose& pose);
  // What is known free of the volume at places of the axis goes for the tube about it.
  void keep_free(const Pair& pair, const AxisShape& shape, const RigidPose& pose,
                 std::vector<FreePlace>& places) const;
  // What is first asked of an axis: how near its middle is.
  SurfaceQuestion middle(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const;
  // Where it touched at the start of the step; of one of several walls, which may be another each trial,
  // nothing.
  const std::vector<ContactStretch>& touched_before(Pair& pair) const;
  std::vector<ContactStretch> locate(Pair& pair, const AxisShape& shape, const RigidPose& pose,
                                     const std::optional<SurfacePoint>& middle) const;
  // The pairs of an element and a volume, few bytes of what is asked of each in every trial: whether it is
  // clear for certain by how little its nodes have moved.
  struct Group {
    size_t first = 0, end = 0, body = 0;
    int nodes[2] = {};
    double turn = 0;   // m: how far a point of the axis gets where |q - q0| = 1
    double room = -1;  // m, of the tube about the axis at the start of the step
  };
  struct Moved {
    double way = 0, turn = 0;  // m; |q - q0|
  };
  void group_pairs();
  double room_at_start(const Pair& pair) const;
  void look_at_nodes(const Kinematics& trial);
  bool quiet(const Group& g) const;
  // All pairs, their first and their last questions in one call a volume.
  void find_all(const Kinematics& trial);
  static bool renew(Found& f, const AxisShape& shape, const RigidPose& pose);
  static void gauss_points(const Pair& pair, const AxisShape& shape, const RigidPose& pose,
                           std::vector<SurfaceQuestion>& ask);
  const Found& find(Pair& pair, const AxisShape& shape, const RigidPose& pose) const;
  static SurfacePoint nothing();
  bool seen(const Pair& pair, const SurfacePoint& p) const { return p.distance <= pair.touch; }
  // What contact asks of a point of the axis that sees p.
  ContactTrial trial(const Pair& pair, const AxisShape& shape, const RigidPose& pose, double xi, bool moves,
                     const SurfacePoint& p) const;
  Origin origin(Pair& pair, double xi) const;
  // rates: of it along the axis, on request.
  ContactStart start(const Pair& pair, const Origin& from, ContactRates* rates = nullptr) const;
  // What friction at the surface needs of an element, and what it gives.
  struct Rolled {
    bool on = false;
    std::array<AxisRoll, 2> ends;  // since the start of the step, relative to the body
    AxisShape::Rolling forces;
    double angle(double xi) const { return (1 - xi) * ends[0].angle + xi * ends[1].angle; }
  };
  Rolled rolled(const Pair& pair, const AxisShape& shape) const;
  void panel(Pair& pair, const AxisShape& shape, const RigidPose& pose, size_t panel, bool moves,
             const Sink& sink, AxisShape::Generalised& g, Rolled& rolled) const;
  ContactLaw element_law(size_t element, const model::Volume& v) const;
  void renew_laws();
  TooDeep too_deep(const Kinematics& trial) const override;
  bool tunnels(const Kinematics& trial) const override;
  double thickest() const override;
  const Mesh& lines() const override { return *mesh_.mesh; }
  void account(Pair& pair, const AxisShape& shape, const std::vector<Point>& next);
  AxisEnds ends(const Kinematics& at, int element) const;
  double length(int element) const { return lengths_[static_cast<size_t>(element)]; }

  static AxisShape nowhere() {
    AxisEnds e;
    e.beam = false;
    e.x1 = e.x2 = Vec3::Zero();
    return AxisShape(e);
  }

  const LocalMesh& mesh_;
  std::vector<LineContactElement> elements_;
  std::vector<double> lengths_;    // m, of the elements, unstretched
  std::vector<Pair> pairs_;        // sorted by element and volume
  std::vector<Account> accounts_;  // of the elements
  std::vector<Vec3> start_x_;      // m, of the nodes at the start of the step
  std::vector<Quat> start_q_;
  std::vector<Group> groups_;  // of pairs_; none: to be made anew
  // While a trial is looked at.
  Questions questions_;
  std::vector<Moved> moved_;       // by node
  std::vector<char> still_;        // by body
  std::vector<size_t> near_;       // pairs that are not clear
  std::vector<AxisShape> shapes_;  // of those
  std::vector<size_t> renewed_;    // of those, what was not known
  std::vector<std::optional<SurfacePoint>> middles_;
  mutable std::vector<FreePlace> places_;
};

}  // namespace hawser
