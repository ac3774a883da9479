// Contact asks a surface all its points in one call, and what it gets is what it would get one by one.
#include <gtest/gtest.h>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/state/state.hpp"
#include "hawser/terms/line_contact.hpp"
#include "hawser/terms/volume_contact.hpp"
#include "support/shapes.hpp"

namespace hawser::test::contact_together_test {
namespace {

// A surface that counts how it is asked; together or, as Surface does by itself, one by one.
class Counting final : public Surface {
 public:
  Counting(std::shared_ptr<const Surface> of, bool together) : of_(std::move(of)), together_(together) {}
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint) const override {
    ++single;
    return of_->query(y, max_distance, hint);
  }
  void query(std::span<const SurfaceQuestion> questions,
             std::span<std::optional<SurfacePoint>> answers) const override {
    ++calls, points += static_cast<int>(questions.size());
    if (together_) return of_->query(questions, answers);
    for (size_t i = 0; i < questions.size(); ++i)
      answers[i] = of_->query(questions[i].point, questions[i].max_distance, -1);
  }
  Box bounds() const override { return of_->bounds(); }
  void reset() const { single = calls = points = 0; }
  mutable int single = 0, calls = 0, points = 0;

 private:
  std::shared_ptr<const Surface> of_;
  bool together_;
};

constexpr int kElements = 60;

// A cable that runs over a ball of radius 5 and off it on both sides.
State over_the_ball(double lift, double shift) {
  State s(kElements + 1);
  for (int i = 0; i <= kElements; ++i) {
    const double along = 12.0 * i / kElements - 6 + shift, angle = along / 5.1;
    const Vec3 on = std::abs(angle) < 0.9 ? Vec3(5.07 * std::sin(angle), 0, 5.07 * std::cos(angle))
                                          : Vec3(along, 0, 4 - 0.1 * std::abs(along));
    s.x[static_cast<size_t>(i)] = on + Vec3(0, 0, lift);
    s.v[static_cast<size_t>(i)] = Vec3(0.5, 0, -0.1);
  }
  return s;
}

template <class Term, class Make>
void compare(const Make& make, int most_single, int most_calls) {
  for (const bool smooth : {false, true}) {
    const auto ball = std::make_shared<MeshSurface>(test::sphere_mesh(5, 5), std::vector<bool>(),
                                                    MeshSurfaceOptions{smooth});
    std::vector<std::vector<HistoryRecord>> kept;
    for (const bool together : {true, false}) {
      const auto counting = std::make_shared<Counting>(ball, together);
      ContactVolume v;
      v.surface = counting;
      v.settings.basis = model::StiffnessBasis::per_length;
      v.settings.normal_stiffness = 1e5;
      v.settings.friction = {0.3, 0.3, 0, 4e4};
      Mesh mesh;
      for (int i = 0; i <= kElements; ++i) mesh.nodes.push_back({0, 12.0 * i / kElements, 1, false});
      for (int i = 0; i < kElements; ++i) mesh.elements.push_back({0, i, i + 1, 0, 0.2, false});
      mesh.lines = {{0, kElements + 1, 0, kElements, 12, "line"}};
      const LocalMesh local = local_mesh(mesh, std::vector<int>(static_cast<size_t>(kElements + 1), 0), 0, 1);
      auto term = make(local, v);
      Sink nowhere;
      const double h = 0.01;
      for (int step = 0; step < 3; ++step) {
        const State before = over_the_ball(-0.002 * step, 0.005 * step),
                    after = over_the_ball(-0.002 * (step + 1), 0.005 * (step + 1));
        term->prepare(before.view(h), h);
        counting->reset();
        term->evaluate(after.view(h), nowhere);
        EXPECT_GT(counting->calls, 0);
        EXPECT_LE(counting->calls, most_calls);
        EXPECT_LE(counting->single, most_single);
        EXPECT_GT(counting->points, 30);
        counting->reset();
        term->evaluate(after.view(h), nowhere);
        EXPECT_EQ(counting->calls, 0) << "asked again what is known";
        term->commit(after.view(h));
      }
      EXPECT_GT(term->touching(), 20);
      kept.push_back(term->save());
    }
    ASSERT_EQ(kept[0].size(), kept[1].size());
    for (size_t i = 0; i < kept[0].size(); ++i) {
      EXPECT_EQ(kept[0][i].node, kept[1][i].node);
      EXPECT_EQ(kept[0][i].values, kept[1][i].values) << i;
    }
  }
}

// A node that was clear at the start and touches asks alone for its gap there.
TEST(ContactTogether, AtTheNodes) {
  compare<VolumeContact>(
      [](const LocalMesh& mesh, const ContactVolume& v) {
        return std::make_unique<VolumeContact>(mesh, nullptr, std::vector{v},
                                               std::vector<ContactNode>(kElements + 1, ContactNode{0.1, 10}));
      },
      1, 1);
}

// The search for where a stretch begins and ends goes from answer to answer, and friction asks where points
// came from that have just touched; the middles and the Gauss points of all elements are asked together.
TEST(ContactTogether, AlongTheLine) {
  compare<LineContact>(
      [](const LocalMesh& mesh, const ContactVolume& v) {
        return std::make_unique<LineContact>(mesh, nullptr, std::vector{v},
                                             std::vector<LineContactElement>(kElements, {0.1, 50}));
      },
      100000, 2);
}

}  // namespace
}  // namespace hawser::test::contact_together_test
