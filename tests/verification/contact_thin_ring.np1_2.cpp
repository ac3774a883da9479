// A wire pulled through a thin ring whose facets are smaller than the wire's diameter. At rest it lies
// between facets, where the gradient of the energy is discontinuous and neither one-sided residual is small.
#include <fmt/format.h>

#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/solve/kink.hpp"
#include "regression/runs.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::runs::contact_thin_ring {
namespace {

using run::Simulation;
using test::NodeField;

constexpr double kRing = 0.1, kTube = 0.003, kWire = 0.01;  // m, radii
constexpr double kX = 0.3, kSag = 0.3;                      // m, position of the wire in the ring
constexpr int kAround = 48, kAcross = 12;                   // facets

// Writes a ring about an axis along x as an OBJ file, rotated about the axis by `turn` rad.
void write_ring(const std::string& path, double turn) {
  std::ofstream f(path);
  const double z = kSag + kRing - kTube - kWire;
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const double a = 2 * M_PI * i / kAround + turn;
      const double b = 2 * M_PI * j / kAcross;
      const double r = kRing + kTube * std::cos(b);
      f << fmt::format("v {:.12g} {:.12g} {:.12g}\n", kX + kTube * std::sin(b), r * std::cos(a),
                       z + r * std::sin(a));
    }
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const auto vertex = [](int k, int l) { return k % kAround * kAcross + l % kAcross + 1; };
      f << fmt::format("f {} {} {}\n", vertex(i + 1, j), vertex(i, j + 1), vertex(i, j));
      f << fmt::format("f {} {} {}\n", vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
}

class ThinRing : public ::testing::TestWithParam<double> {};

// The legs are straight, and both have T = EA (l - l0)/l0 within 0.2 %.
TEST_P(ThinRing, HoldsTheWire) {
  constexpr double kEA = 2e7, kFree = 19.98;
  const std::string at = folder("contact_thin_ring");
  const double turn = GetParam() * M_PI / 180;
  if (rank_of(MPI_COMM_WORLD) == 0) write_ring(at + "/ring.obj", turn);
  write_case(at + "/ring.yaml", fmt::format(R"(hawser: 1
environment: {{gravity: 0}}
line_types:
  wire: {{outer_diameter: {}, mass_per_length: 1, EA: {}, bending: false}}
volumes: {{ring: {{mesh: ring.obj}}}}
lines:
  wire:
    sections: [{{type: wire, length: {}, element_length: 0.1}}]
    end_a: {{anchor: [-10, 0, 0]}}
    end_b: {{anchor: [10, 0, 0]}}
    start: {{points: [[-10, 0, 0], [{}, 0, {}], [10, 0, 0]]}}
)",
                                            2 * kWire, kEA, kFree, kX, kSag + kRing - kTube - kWire));
  const model::Case c = io::read_case(at + "/ring.yaml");
  Simulation s(MPI_COMM_WORLD, c, run::surfaces(run::load_volumes(c, MPI_COMM_WORLD)));
  s.solve_statics();
  const double left = std::hypot(10 + kX, kSag);
  const double right = std::hypot(10 - kX, kSag);
  const double tension = kEA * (left + right - kFree) / kFree;
  NodeField field(s, "effective_tension");
  double least = HUGE_VAL, most = 0;
  for (const double t : field.at(s.state().at_rest())) {
    least = std::min(least, t);
    most = std::max(most, t);
  }
  MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  EXPECT_NEAR(least, tension, 2e-3 * tension);
  EXPECT_NEAR(most, tension, 2e-3 * tension);
}

INSTANTIATE_TEST_SUITE_P(Turned, ThinRing, ::testing::Values(0.0, 1.0, 1.9, 2.8, 3.75, 6.0));

Eigen::MatrixXd products(const std::vector<Eigen::Vector2d>& r) {
  Eigen::MatrixXd G(r.size(), r.size());
  for (size_t i = 0; i < r.size(); ++i)
    for (size_t j = 0; j < r.size(); ++j) G(i, j) = r[i].dot(r[j]);
  return G;
}

// Point nearest to the origin of a point, of two points on one side, of a segment, and of a triangle around
// it.
TEST(SmallestCombination, IsNearestToTheOrigin) {
  using V = Eigen::Vector2d;
  const auto norm = [](const std::vector<V>& r) {
    const Eigen::VectorXd l = smallest_combination(products(r));
    EXPECT_NEAR(l.sum(), 1, 1e-12);
    EXPECT_GE(l.minCoeff(), 0);
    V sum = V::Zero();
    for (size_t i = 0; i < r.size(); ++i) sum += l[i] * r[i];
    return sum.norm();
  };
  EXPECT_NEAR(norm({V(3, 4)}), 5, 1e-12);
  EXPECT_NEAR(norm({V(3, 4), V(6, 8)}), 5, 1e-12);
  EXPECT_NEAR(norm({V(1, 2), V(1, -1)}), 1, 1e-12);
  EXPECT_NEAR(norm({V(1, 2), V(1, -1), V(-4, 0)}), 0, 1e-12);
  EXPECT_NEAR(norm({V(1, 2), V(1, -1), V(2, 0)}), 1, 1e-12);
  EXPECT_NEAR(norm({V(2, 1), V(2, 1), V(2, -1)}), 2, 1e-12);
}

}  // namespace
}  // namespace hawser::runs::contact_thin_ring
