// Contact of lines with volumes at the nodes of the lines (OMAE2006-92155): a spring, a damper and
// friction between each node and the surface of each volume it can meet. See docs/theory/contact.md.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "hawser/terms/contact.hpp"
#include "hawser/terms/line_neighbours.hpp"

namespace hawser {

// What contact must know of an owned node.
struct ContactNode {
  double radius = 0;  // m, half the contact diameter; 0: the node takes no part
  double mass = 0;    // kg, nodal mass: the effective mass of relative_damping
};

// How a node is kept out: by a spring along the normal of the surface where it is; by one along the normal
// that was nearest at the start, wherever the node goes. See docs/theory/contact-models.md.
enum class NodeContact { elastic, gap };

class VolumeContact final : public Contact {
 public:
  // nodes: one for each owned node. All lengths and indices are checked, std::invalid_argument otherwise.
  VolumeContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                std::vector<ContactVolume> volumes, std::vector<ContactNode> nodes,
                NodeContact model = NodeContact::elastic, MPI_Comm comm = MPI_COMM_SELF);

  std::string_view name() const override { return "volume contact"; }
  void prepare(const Kinematics& committed, double h) override;
  // So that no node gets deeper past a surface in a step than half its radius at its present speed.
  void limit_step(const Kinematics& committed, Strikes& to) const override;
  void unforeseen(const Kinematics& trial, Unforeseen& to) override;
  void evaluate(const Kinematics& trial, Sink& sink) override;
  void commit(const Kinematics& accepted) override;
  bool stiffen(const Kinematics& equilibrium) override;
  void forget_stiffening() override;
  Energy energy(const Kinematics& at) const override;
  void fields(FieldRegistry& registry) const override;
  std::vector<HistoryKind> history() const override;
  std::vector<HistoryRecord> save() const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  Penetration largest_penetration() const override;
  int candidates() const override;
  int touching() const override;
  void touches(Touches& out) const override;

  // Force of one volume on one candidate pair's node, space axes: K = -df/dx, C = -df/dv. In statics (step 0)
  // velocities don't count.
  struct Force {
    bool touches = false;
    Vec3 total = Vec3::Zero(), friction = Vec3::Zero();
    Mat3 K = Mat3::Zero(), C = Mat3::Zero();
  };
  Force force(const Kinematics& trial, int pair, bool tangent, bool convex = false);

 private:
  // Kept while the pair touches.
  struct History : ContactHistory {
    using ContactHistory::ContactHistory;
    double depth = 0;  // m
    int hint = -1;     // nearest triangle
    bool touches = false;
    // Gap spring: where the surface was nearest at the start, and its normal.
    bool paired = false;
    Vec3 anchor = Vec3::Zero(), direction = Vec3::UnitZ();

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      ContactHistory::quantities(self, each, "N", "J");
      each("penetration", "m", self.depth), each("nearest triangle", "", self.hint);
      each("touches", "", self.touches), each("paired", "", self.paired);
      each("anchor", "m", self.anchor), each("direction", "", self.direction);
    }
  };
  // Of a node and a volume that may have several walls (surface_walls.hpp), shared by its pairs: those near a
  // point, and which each pair is about. A wall stays with the pair whose normal of before is most like its
  // own.
  struct Walls {
    static constexpr int kNone = -1, kAll = -2;  // idle; the whole surface, which is one wall there
    std::array<History, SurfaceWalls::kMost> committed;
    bool known = false;
    Vec3 at = Vec3::Zero();
    SurfaceWalls near;
    std::array<int, SurfaceWalls::kMost> wall{};
    Vec3 centre = Vec3::Zero();  // as of Pair, of all walls
    double clear = -1;
    int hint = -1;
  };
  struct Pair {
    int node = 0, volume = 0, slot = 0;
    double touch = 0;  // m, distance below which there is a force: radius + smoothing
    ContactLaw law;
    ContactStart start;
    History history;
    double margin = 0;        // m, how far its start was looked at
    bool start_known = true;  // the gap at the start; else it was clear there and is asked for at a touch
    // Kept from step to step, changes the time and never the answer: no contact nearer than `clear` to
    // `centre` (the signed distance is 1-Lipschitz). Nearest triangle of the last query.
    Vec3 centre = Vec3::Zero();
    double clear = -1;
    int hint = -1;
    // The last answer, where and how far was asked (negative: never).
    Vec3 asked = Vec3::Zero();
    double asked_distance = -1;
    std::optional<SurfacePoint> seen;
    std::shared_ptr<Walls> walls;  // none: there is one in this step
  };

  bool left_out(int node, int volume) const;
  bool one_wall(const Pair& pair, const Vec3& y, double motion) const;
  // The wall that a pair is about where its node is at y, or kNone, kAll.
  int see_wall(const Pair& pair, const Vec3& y) const;
  void assign(const Pair& pair, const Vec3& y, Walls& w) const;
  // Of the wall the trial is at, the gap at the start.
  ContactStart start(const Pair& pair, const Vec3& y) const;
  // The surface from y (body frame) within a distance [m], and what all pairs are about to ask of it at once.
  const std::optional<SurfacePoint>& look(Pair& pair, const Vec3& y, double distance) const;
  void look_ahead(const Kinematics& at);
  bool clear_of(const Pair& pair, const Vec3& y) const {
    return model_ == NodeContact::elastic && !pair.walls && still_clear(pair.clear, pair.centre, y, 0);
  }
  void know_start(Pair& pair) const;
  // m, how far y may move for sure before it touches, if the surface says it is `distance` away or farther.
  double clear_about(const Pair& pair, const Vec3& y, double distance) const;
  // The surface seen from y (body frame); false when it is out of touch. With the gap in `trial` when known.
  bool locate(Pair& pair, const Vec3& y, double reach, ContactTrial& trial) const;
  bool locate_gap(Pair& pair, const Vec3& y, ContactTrial& trial) const;
  Force resolve(Pair& pair, const Kinematics& trial, bool tangent, bool convex);
  PointContact contact(Pair& pair, const Kinematics& at, bool derivatives, bool convex, ContactTrial& trial);
  ContactLaw node_law(int node, int volume) const;
  void choose_gap(Pair& pair, const Vec3& y) const;
  void account(const Pair& pair, const History& next, const Vec3& y);

  TooDeep too_deep(const Kinematics& trial) const override;
  bool tunnels(const Kinematics& trial) const override;
  double thickest() const override;
  const Mesh& lines() const override { return mesh_; }

  const Mesh& mesh_;
  NodeContact model_;
  std::vector<ContactNode> nodes_;
  std::vector<int> global_, block_;  // of owned nodes: mesh node, local 3-block
  LineNeighbours line_;
  std::vector<double> tributary_;  // m, line length that belongs to the node
  std::vector<double> element_;    // m, longest element at the node
  std::vector<Pair> pairs_;        // sorted by node and volume
  std::vector<Account> accounts_;  // of the owned nodes
  Questions questions_;
};

}  // namespace hawser
