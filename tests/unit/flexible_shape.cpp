// Flexible start shape: against the closed form of the catenary; independent of the initial guess, on the bed
// and at the surface.
#include "hawser/kernels/flexible_shape.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hawser/kernels/catenary.hpp"

namespace hawser::flexible_shape_test {
namespace {

struct Made {
  FlexibleLine line;
  std::vector<double> arc{0};
};

Made cut(const std::vector<CatenarySection>& sections, int pieces_a_section) {
  Made m;
  m.line.points.emplace_back();
  for (const CatenarySection& s : sections) {
    for (int i = 0; i < pieces_a_section; ++i) {
      FlexibleLine::Segment p;
      p.length = s.length / pieces_a_section;
      p.EA = s.EA;
      p.load = s.load;
      m.line.pieces.push_back(p);
      m.line.points.emplace_back();
      m.arc.push_back(m.arc.back() + p.length);
    }
    m.line.points.back().load = s.end_load;
  }
  return m;
}

std::vector<Vec3> straight(const Made& m, const Vec3& a, const Vec3& b) {
  std::vector<Vec3> x;
  for (double s : m.arc) x.push_back(a + s / m.arc.back() * (b - a));
  return x;
}

TEST(FlexibleShape, RandomCatenaries) {
  std::mt19937 g(3);
  std::uniform_real_distribution<double> u(0, 1);
  double worst = 0;
  for (int k = 0; k < 400; ++k) {
    const int parts = 1 + static_cast<int>(5 * u(g));
    std::vector<CatenarySection> sections;
    double length = 0;
    for (int i = 0; i < parts; ++i) {
      CatenarySection s;
      s.length = 20 + 100 * u(g);
      s.EA = std::pow(10, 6 + 3 * u(g));
      s.load = Vec3(0, 20 * u(g), (u(g) < 0.3 ? 100 : -300) * (0.3 + u(g)));
      if (u(g) < 0.3 && i + 1 < parts) s.end_load = Vec3(0, 0, 4000 * (u(g) - 0.5));
      length += s.length;
      sections.push_back(s);
    }
    const Vec3 a(3, 4, 5);
    const Vec3 way(u(g) - 0.5, u(g) - 0.5, u(g) - 0.5);
    const Vec3 b = a + (0.2 + 0.78 * u(g)) * length * way.normalized();
    const Made m = cut(sections, 40);
    const std::vector<Vec3> x = flexible_shape(m.line, straight(m, a, b));
    const CatenaryShape exact = catenary(a, b, sections);
    double error = 0;
    for (size_t i = 0; i < x.size(); ++i) error = std::max(error, (x[i] - exact.position(m.arc[i])).norm());
    worst = std::max(worst, error / length);
    EXPECT_LT(error, 1e-2 * length) << k;
  }
  printf("  worst of 400: %.1e of the length\n", worst);
}

// A lazy wave on a bed with one end at the surface: three initial guesses (straight, far above, tangled) give
// the same shape.
TEST(FlexibleShape, TheSameFromAnyStart) {
  std::vector<CatenarySection> sections = {
      {150, Vec3(0, 0, -200), 1e8}, {80, Vec3(0, 0, -200), 1e8}, {120, Vec3(0, 0, -200), 1e8}};
  Made m = cut(sections, 30);
  for (size_t i = 0; i < m.line.pieces.size(); ++i)
    m.line.pieces[i].buoyancy = i < 30 ? 60 : i < 60 ? 320 : 80;
  m.line.bed = m.line.water = true;
  m.line.bed_point = Vec3(0, 0, -90);
  m.line.bed_stiffness = 1e5;
  m.line.bed_normal = Vec3(0.05, 0, 1).normalized();
  m.line.points[75].load = Vec3(0, 0, -3000);
  const Vec3 a(0, 0, 5), b(230, 20, -90);
  const std::vector<Vec3> x = flexible_shape(m.line, straight(m, a, b));
  std::vector<Vec3> above = straight(m, a, b);
  std::vector<Vec3> tangle = above;
  std::mt19937 g(5);
  std::uniform_real_distribution<double> u(-40, 40);
  for (size_t i = 1; i + 1 < above.size(); ++i) {
    above[i].z() += 200;
    tangle[i] += Vec3(u(g), u(g), u(g));
  }
  for (const auto& other : {flexible_shape(m.line, above), flexible_shape(m.line, tangle)})
    for (size_t i = 0; i < x.size(); ++i) EXPECT_LT((x[i] - other[i]).norm(), 0.5) << i;
  EXPECT_EQ((x.front() - a).norm() + (x.back() - b).norm(), 0);
  double lowest = 0, lying = 0;
  for (const Vec3& p : x) {
    const double gap = m.line.bed_normal.dot(p - m.line.bed_point);
    lowest = std::min(lowest, gap);
    lying += gap < 0.01;
  }
  EXPECT_GT(lowest, -0.3);
  EXPECT_GT(lying, 5);
}

// A hose that is lighter than water and held at one end rises to the surface.
TEST(FlexibleShape, AFreeEndFloats) {
  std::vector<CatenarySection> sections = {{100, Vec3(0, 0, -600), 1e7}};
  Made m = cut(sections, 64);
  for (auto& p : m.line.pieces) p.buoyancy = 1000;
  m.line.water = true;
  m.line.held_b = false;
  const std::vector<Vec3> x = flexible_shape(m.line, straight(m, {0, 0, -10}, {60, 0, -90}));
  for (size_t i = 40; i < x.size(); ++i) EXPECT_NEAR(x[i].z(), 0, 1) << i;
}

}  // namespace
}  // namespace hawser::flexible_shape_test
