// Mooring lines on beds that are not planes, with friction: a slope by grid and mesh is that by formula; on a
// ridge one, two and three ranks have the same results at rest and in motion.
#include "hawser/geometry/ground.hpp"
#include "hawser/geometry/height_grid.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/terms/bed_contact.hpp"
#include "support/mooring.hpp"

namespace hawser::test::seabed_shapes {
namespace {

using Heights = std::function<double(double, double)>;

std::vector<double> spaced(double from, double to, double step) {
  std::vector<double> t;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) t.push_back(from + i * step);
  return t;
}

std::shared_ptr<const HeightGrid> grid(const Heights& f, double step) {
  const std::vector<double> x = spaced(-60, 900, step);
  const std::vector<double> y = spaced(-120, 120, step);
  std::vector<double> z;
  for (const double b : y)
    for (const double a : x) z.push_back(f(a, b));
  return std::make_shared<const HeightGrid>(x, y, z);
}

std::shared_ptr<const MeshSurface> mesh(const Heights& f, double step) {
  const std::vector<double> x = spaced(-60, 900, step);
  const std::vector<double> y = spaced(-120, 120, step);
  TriangleMesh m;
  for (const double b : y)
    for (const double a : x) m.vertices.push_back({a, b, f(a, b)});
  const int n = static_cast<int>(x.size());
  for (int j = 0; j + 1 < static_cast<int>(y.size()); ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int a = j * n + i;
      m.triangles.push_back({a, a + 1, a + n + 1});
      m.triangles.push_back({a, a + n + 1, a + n});
    }
  const size_t top = m.triangles.size();
  m = ground_under(m);
  std::vector<bool> active(m.triangles.size(), false);
  std::fill_n(active.begin(), top, true);
  return std::make_shared<const MeshSurface>(std::move(m), std::move(active),
                                             MeshSurfaceOptions{.smooth = true, .open = false});
}

model::Case chain(const Vec3& from) {
  model::Case c = moored_chain(from, 200, 1e6, {1, 2, 2});
  c.dynamics.duration = 8;
  return c;
}

double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double off = 0;
  for (size_t n = 0; n < a.size(); ++n) off = std::max(off, (a[n] - b[n]).norm());
  return off;
}

TEST(SeabedShapes, ASlopeIsASlope) {
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank > 0) GTEST_SKIP() << "rank 0 does it alone";
  const double slope = 4 * M_PI / 180, towards = 2.5;
  const Heights f = [&](double x, double y) {
    return -200 - std::tan(slope) * (std::cos(towards) * x + std::sin(towards) * y);
  };
  model::Case c = chain({0, 0, -200});
  c.environment.seabed.slope = slope;
  c.environment.seabed.direction = towards;
  c.statics.tolerance = 1e-12;
  Simulation formula(PETSC_COMM_SELF, c);
  formula.solve_statics();
  run(formula, 8);
  for (const bool of_grid : {true, false}) {
    model::Case d = c;
    if (of_grid)
      d.environment.seabed.surface = grid(f, 40);
    else
      d.environment.seabed.surface = mesh(f, 40);
    Simulation other(PETSC_COMM_SELF, d);
    other.solve_statics();
    const double at_rest = apart(other.state().x, formula.state().x);
    run(other, 8);
    const Kinematics a = other.dynamics().committed_kinematics();
    const Kinematics b = formula.dynamics().committed_kinematics();
    const double later = apart({a.x.begin(), a.x.end()}, {b.x.begin(), b.x.end()});
    printf("  %s: %.1e m apart at rest, %.1e m after 8 s; %d and %d nodes lie\n", of_grid ? "grid" : "mesh",
           at_rest, later, other.system().find<BedContact>()->active_count(),
           formula.system().find<BedContact>()->active_count());
    EXPECT_LT(at_rest, 1e-9 * 835);
    EXPECT_LT(later, 1e-8 * 835);
    EXPECT_EQ(other.system().find<BedContact>()->active_count(),
              formula.system().find<BedContact>()->active_count());
  }
}

double ridge(double x, double y) {
  const double across = (x - 260 - 0.3 * y) / 22;
  return -200 + 0.01 * x + 9 * std::exp(-across * across) + 0.6 * std::sin(x / 17) * std::sin(y / 23 + 1);
}

TEST(SeabedShapes, OnARidge) {
  model::Case c = chain({0, 0, ridge(0, 0)});
  const auto bed = grid(ridge, 5);
  c.environment.seabed.surface = bed;
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  all.solve_statics();
  one.solve_statics();
  expect_same_positions(all, all.state().at_rest(), one.state().at_rest(), 1e-7, "statics");
  // The chain lies before and on the ridge and spans the ground between. The tension presses it onto the
  // crest, where it sinks in by some diameters on this soil.
  double deepest = 0, highest = 0;
  int lies = 0, spans = 0;
  for (size_t n = 1; n < 80; ++n) {
    const double d = bed->query(one.state().x[n], 1e9)->distance - 0.0383;
    deepest = std::min(deepest, d);
    highest = std::max(highest, d);
    (d < 0 ? lies : spans) += 1;
  }
  printf("  of 80 nodes %d lie and %d span, up to %.2f m high; deepest %.4f m\n", lies, spans, highest,
         deepest);
  EXPECT_GT(lies, 20);
  EXPECT_GT(spans, 5);
  EXPECT_GT(deepest, -0.4);
  run(all, 8);
  run(one, 8);
  expect_same_positions(all, all.dynamics().committed_kinematics(), one.dynamics().committed_kinematics(),
                        1e-6, "after 8 s");
  // Energy dissipated by friction and dampers is positive.
  const Energy e = one.system().energy(one.dynamics().committed_kinematics());
  printf("  friction took %.4g J, dampers %.4g J\n", e.friction, e.damping);
  EXPECT_GT(e.friction, 0);
}

}  // namespace
}  // namespace hawser::test::seabed_shapes
