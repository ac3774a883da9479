// Many questions to a surface in one call get the answers of one by one, to the last bit.
#include <gtest/gtest.h>

#include <random>

#include "hawser/geometry/mesh_surface.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_surface_many_test {
namespace {

using namespace hawser::test;

void same_answers(const Surface& surface, const char* name) {
  const Box box = surface.bounds();
  const double size = std::min(box.extent().maxCoeff(), 10.0);
  const Vec3 centre = box.centre().allFinite() ? box.centre() : Vec3(Vec3::Zero());
  std::mt19937 gen(6);
  std::normal_distribution<double> g;
  std::vector<SurfaceQuestion> questions;
  int last = -1;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 y = centre + 0.4 * size * Vec3(g(gen), g(gen), g(gen));
    questions.push_back({y, i % 5 ? 0.05 * size : 0.5 * size, i % 3 ? last : -1});
    if (const auto p = surface.query(y, size)) last = p->triangle;
  }
  std::vector<std::optional<SurfacePoint>> answers(questions.size());
  answers[0] = SurfacePoint{};  // what was there before is gone
  surface.query(questions, answers);
  int met = 0;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const SurfaceQuestion& q = questions[i];
    const auto one = surface.query(q.point, q.max_distance, q.hint);
    ASSERT_EQ(answers[i].has_value(), one.has_value()) << name << " " << i;
    if (!one) continue;
    ++met;
    ASSERT_EQ(answers[i]->distance, one->distance) << name << " " << i;
    ASSERT_EQ(answers[i]->triangle, one->triangle) << name << " " << i;
    ASSERT_EQ(answers[i]->normal, one->normal) << name << " " << i;
    ASSERT_EQ(answers[i]->point, one->point) << name << " " << i;
    ASSERT_EQ(answers[i]->curvature, one->curvature) << name << " " << i;
    ASSERT_EQ(answers[i]->feature, one->feature) << name << " " << i;
  }
  EXPECT_GT(met, 300) << name;
  EXPECT_LT(met, 2990) << name;
}

TEST(SurfaceMany, SameAsOneByOne) {
  same_answers(CylinderSurface({0, -1, 0}, {0, 3, 0}, 1.5), "cylinder");
  for (const bool smooth : {false, true}) {
    const MeshSurfaceOptions options{smooth};
    same_answers(MeshSurface(drum_mesh(48, 2, 3), {}, options), smooth ? "curved drum" : "drum");
    same_answers(MeshSurface(sphere_mesh(4, 3), {}, options), smooth ? "curved ball" : "ball");
    const TriangleMesh drum = flanged_drum_mesh(48, 2, 3, 3.0, 0.3);
    same_answers(MeshSurface(drum, active_by_part(drum, {"barrel"}), options), "barrel");
    same_answers(MeshSurface(u_channel_mesh(), {}, options), "channel");
  }
}

TEST(SurfaceMany, NoneAndTooFewPlaces) {
  const MeshSurface ball(sphere_mesh(2));
  std::vector<std::optional<SurfacePoint>> answers(1);
  EXPECT_NO_THROW(ball.query(std::span<const SurfaceQuestion>(), {}));
  const std::vector<SurfaceQuestion> two(2);
  EXPECT_THROW(ball.query(two, answers), std::invalid_argument);
  EXPECT_THROW(PlaneSurface({0, 0, 0}, {0, 0, 1}).query(two, answers), std::invalid_argument);
}

}  // namespace

}  // namespace hawser::geometry_surface_many_test
