// Gauss-Legendre rules with n points integrate polynomials of degree 2 n - 1 to rounding, and no polynomials
// of higher degree.
#include "hawser/math/gauss_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test::gauss_points_test {

template <int n>
double integral_of_power(int k) {
  double sum = 0;
  for (int g = 0; g < n; ++g) sum += GaussPoints<n>::weight[g] * std::pow(GaussPoints<n>::unit[g], k);
  return sum;
}

template <int n>
void expect_exact_to_degree() {
  for (int k = 0; k < 2 * n; ++k) EXPECT_NEAR(integral_of_power<n>(k), 1.0 / (k + 1), 2e-16) << n << " " << k;
  EXPECT_GT(std::abs(integral_of_power<n>(2 * n) - 1.0 / (2 * n + 1)), 1e-6) << n;
  for (int g = 0; g < n; ++g)
    EXPECT_NEAR(GaussPoints<n>::centred[g], 2 * GaussPoints<n>::unit[g] - 1, 2e-16) << n << " " << g;
}

TEST(GaussPoints, AreExactToTheirDegree) {
  expect_exact_to_degree<2>();
  expect_exact_to_degree<3>();
  expect_exact_to_degree<4>();
}

}  // namespace hawser::test::gauss_points_test
