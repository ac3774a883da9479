// Cached clearances do not change results: after any trials, forces, records and step limits equal bit for
// bit those of a term restored from a checkpoint.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/state/state.hpp"
#include "hawser/terms/line_volume_contact.hpp"
#include "support/shapes.hpp"

namespace hawser::test::contact_memory_test {
namespace {

constexpr int kElements = 12;
constexpr double kLong = 0.5, kStep = 0.05;  // m, s

class Counting final : public Surface {
 public:
  explicit Counting(std::shared_ptr<const Surface> of) : of_(std::move(of)) {}
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint) const override {
    ++questions;
    return of_->query(y, max_distance, hint);
  }
  double free_radius(const Vec3& y, double distance, int hint = -1) const override {
    return of_->free_radius(y, distance, hint);
  }
  Box bounds() const override { return of_->bounds(); }
  void facet_groups(std::span<const Vec3> axis, double reach, FacetGroups& out) const override {
    of_->facet_groups(axis, reach, out);
  }
  bool one_facet_group(std::span<const Vec3> axis, double reach) const override {
    return of_->one_facet_group(axis, reach);
  }
  std::optional<SurfacePoint> query_group(const FacetGroup& group, const Vec3& y, double max_distance,
                                          bool either_side) const override {
    ++questions;
    return of_->query_group(group, y, max_distance, either_side);
  }
  mutable int questions = 0;

 private:
  std::shared_ptr<const Surface> of_;
};

LocalMesh chain(Mesh& mesh, bool beam) {
  for (int i = 0; i <= kElements; ++i) mesh.add(Node{0, kLong * i, 1, beam});
  for (int i = 0; i < kElements; ++i) mesh.add(Element{0, i, i + 1, 0, kLong, beam});
  mesh.lines = {{0, kElements + 1, 0, kElements, kLong * kElements}};
  return local_mesh(mesh, std::vector<int>(static_cast<size_t>(kElements + 1), 0), 0, 1);
}

ContactVolume volume(std::shared_ptr<const Surface> surface, int body) {
  ContactVolume v;
  v.surface = std::move(surface);
  v.body = body;
  v.settings.basis = model::StiffnessBasis::per_length;
  v.settings.normal_stiffness = 1e5;
  v.settings.smoothing = 1e-3;
  v.settings.friction = {0.3, 0.3, 0, 4e4};
  return v;
}

// A line along x about the origin at height z, slightly inclined and wavy.
State line_at(double z, double time, double down) {
  State s(kElements + 1);
  s.time = time;
  for (int i = 0; i <= kElements; ++i) {
    const size_t n = static_cast<size_t>(i);
    const double x = kLong * (i - 0.5 * kElements);
    s.x[n] = Vec3(x + 0.1 * time, 0.02 * std::sin(3 * x), z + 0.03 * std::sin(2 * x + time));
    s.v[n] = Vec3(0.1, 0, -down);
    s.a[n] = Vec3(0, 0, -0.3 * down);
  }
  return s;
}

struct Scene {
  std::string name;
  std::shared_ptr<const Surface> surface;
  double lowest;  // m, lowest height of the line, which starts 1.5 m higher
  bool moves = false;
};

TriangleMesh without_top(TriangleMesh m, double z) {
  std::erase_if(m.triangles, [&](const std::array<int, 3>& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](int v) { return m.vertices[static_cast<size_t>(v)].z() == z; });
  });
  return m;
}

std::vector<Scene> scenes() {
  const TriangleMesh box = test::box_mesh(Vec3(-2, -2, -2), Vec3(2, 2, 0));
  const auto ball =
      std::make_shared<MeshSurface>(test::sphere_mesh(3, 2), std::vector<bool>(), MeshSurfaceOptions{true});
  TriangleMesh channel = test::u_channel_mesh();  // its slit is along x and as wide as the line
  TriangleMesh wide = channel;
  TriangleMesh wedge = channel;
  for (Vec3& v : channel.vertices) v = Vec3(v.z() - 2, 0.21 * (v.x() - 1.5), 0.5 * (v.y() - 1));
  for (Vec3& v : wide.vertices) v = Vec3(3 * (v.z() - 2), 0.6 * (v.x() - 1.5), 0.7 * v.y());
  for (Vec3& v : wedge.vertices) v = Vec3(3 * (v.z() - 2), (0.1 + 0.25 * v.y()) * (v.x() - 1.5), 0.7 * v.y());
  std::vector<bool> sides(box.triangles.size());
  for (size_t t = 0; t < sides.size(); ++t) sides[t] = t == 2;
  MeshSurfaceOptions open;
  open.open = true;
  return {{"plane", std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3(0.1, 0, 1)), 0.05},
          {"box", std::make_shared<MeshSurface>(box), 0.05},
          {"ball", ball, 2.05},
          {"ball that moves", ball, 2.05, true},
          {"slit", std::make_shared<MeshSurface>(channel), 0.05},
          {"slit that moves", std::make_shared<MeshSurface>(wide), 0.9, true},
          {"wedge that moves", std::make_shared<MeshSurface>(wedge), 0.9, true},
          {"open box", std::make_shared<MeshSurface>(without_top(box, 0), std::vector<bool>(), open), -0.1},
          {"part of a box", std::make_shared<MeshSurface>(box, sides), -0.5}};
}

struct Outcome {
  std::vector<CheckpointRecord> kept;
  double longest = 0;
  std::vector<double> energies;
};

// The line moves down to the surface and up again; in each step, trials near and far precede the accepted
// one.
void go(const Scene& scene, bool beam, model::ContactMethod method) {
  const auto make = [method](const LocalMesh& l, auto bodies, const ContactVolume& v) {
    return LineVolumeContact(l, bodies, {v}, std::vector<LineContactElement>(kElements, {0.1, 50}),
                             PETSC_COMM_SELF, method);
  };
  Mesh mesh;
  const LocalMesh local = chain(mesh, beam);
  std::shared_ptr<const Bodies> bodies;
  if (scene.moves)
    bodies = std::make_shared<const Bodies>(
        std::vector<RigidMotion>{{Vec3(0.02, 0.01, 0), Vec3(0, 0, 0.01),
                                  MotionLaw(SteadyLaw{Vec3(0, 0, 0.05), Vec3(0.02, 0.03, 0), 0.3})}});
  const ContactVolume v = volume(scene.surface, scene.moves ? 0 : -1);
  LineVolumeContact term = make(local, bodies, v);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  constexpr int kSteps = 40;
  const auto height = [&](int n) { return scene.lowest + 0.75 * (1 + std::cos(2 * M_PI * n / kSteps)); };
  Assembler nowhere;
  int touched = 0;
  for (int n = 0; n < kSteps; ++n) {
    const State from = line_at(height(n), n * kStep, (height(n) - height(n + 1)) / kStep);
    const State to = line_at(height(n + 1), (n + 1) * kStep, (height(n) - height(n + 1)) / kStep);
    LineVolumeContact fresh = make(local, bodies, v);
    fresh.restore(term.save());
    term.prepare(from.after_step(kStep), kStep);
    const auto limits = [&](LineVolumeContact& t) {
      ImpactEvents impacts;
      impacts.max_step = kStep;
      t.limit_step(from.after_step(kStep), impacts);
      Outcome out;
      out.longest = std::min(impacts.longest, kStep);
      for (const ImpactEvent& s : impacts.list) out.energies.push_back(s.energy());
      return out;
    };
    for (const double far : {1e-4, 0.01, 0.3, 1e5, 0.01, 0.0}) {
      State trial = to;
      for (Vec3& x : trial.x) x += far * Vec3(noise(random), noise(random), noise(random));
      term.evaluate(trial.after_step(kStep), nowhere);
      LineVolumeContact mine = term;
      LineVolumeContact other = fresh;
      other.prepare(from.after_step(kStep), kStep);
      mine.commit(trial.after_step(kStep));
      other.commit(trial.after_step(kStep));
      const auto a = mine.save();
      const auto b = other.save();
      ASSERT_EQ(a.size(), b.size()) << scene.name << " step " << n << " off by " << far;
      for (size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(a[i].values, b[i].values) << scene.name << " step " << n;
      EXPECT_EQ(mine.active_count(), other.active_count());
    }
    fresh.prepare(from.after_step(kStep), kStep);
    const Outcome mine = limits(term);
    const Outcome other = limits(fresh);
    EXPECT_EQ(mine.longest, other.longest) << scene.name << " step " << n;
    EXPECT_EQ(mine.energies, other.energies) << scene.name << " step " << n;
    term.commit(to.after_step(kStep));
    touched += term.active_count();
  }
  EXPECT_GT(touched, 5) << scene.name;
}

TEST(ContactMemory, NeverShowsAlongTheLine) {
  for (const Scene& scene : scenes())
    for (const bool beam : {false, true}) go(scene, beam, model::ContactMethod::line);
}

TEST(ContactMemory, NeverShowsAtTheNodes) {
  for (const Scene& scene : scenes())
    for (const bool beam : {false, true}) go(scene, beam, model::ContactMethod::nodes);
}

TEST(ContactMemory, NeverShowsInGapSprings) {
  for (const Scene& scene : scenes()) go(scene, false, model::ContactMethod::gap);
}

// A line that moves down slowly queries the surface in its first step, and then makes no queries where it is
// far from the surface.
TEST(ContactMemory, AsksLittle) {
  const auto counting = std::make_shared<Counting>(
      std::make_shared<MeshSurface>(test::sphere_mesh(3, 2), std::vector<bool>(), MeshSurfaceOptions{true}));
  Mesh mesh;
  const LocalMesh local = chain(mesh, true);
  LineVolumeContact term(local, nullptr, {volume(counting, -1)},
                         std::vector<LineContactElement>(kElements, LineContactElement{0.1, 50}));
  Assembler nowhere;
  int first = 0, later = 0, ahead = 0;
  for (int n = 0; n < 10; ++n) {
    State from = line_at(2.4 - 0.002 * n, 0, 0);
    State to = line_at(2.4 - 0.002 * (n + 1), 0, 0);
    for (State* s : {&from, &to})
      for (Vec3& v : s->v) v = Vec3(0, 0, -0.02);
    term.prepare(from.after_step(kStep), kStep);
    counting->questions = 0;
    ImpactEvents impacts;
    impacts.max_step = kStep;
    term.limit_step(from.after_step(kStep), impacts);
    (n == 0 ? first : ahead) += counting->questions;
    counting->questions = 0;
    term.evaluate(to.after_step(kStep), nowhere);
    term.evaluate(from.after_step(kStep), nowhere);
    term.commit(to.after_step(kStep));
    (n == 0 ? first : later) += counting->questions;
  }
  EXPECT_GT(first, kElements / 2);
  EXPECT_LT(first, 12 * kElements);
  EXPECT_EQ(ahead, 0) << "nothing could come to anything in the step";
  EXPECT_LE(later, kElements / 2);
}

}  // namespace
}  // namespace hawser::test::contact_memory_test
