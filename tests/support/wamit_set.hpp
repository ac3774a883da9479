// Coefficients of a WAMIT set as arrays, from which tests write files of other programs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "hawser/kernels/platform_waves.hpp"

namespace hawser::hydrodynamic_files_test {

constexpr const char* kSpar = HAWSER_SOURCE_DIR "/docs/tutorial/spar";
constexpr double kDensity = 1025, kGravity = 9.80665;

inline std::vector<std::vector<double>> rows_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    rows.emplace_back();
    for (double x = 0; in >> x;) rows.back().push_back(x);
  }
  return rows;
}

// Coefficients of WAMIT, ULEN = 1, in order of frequency; the infinite frequency comes first if `infinite`.
struct Set {
  std::vector<double> omega, directions;
  std::map<std::array<int, 3>, double> added, damping;    // frequency, i, j
  std::map<std::array<int, 3>, Complex> force;            // frequency, direction, i
  std::map<std::array<int, 2>, double> stiffness, limit;  // i, j
};

inline Set wamit_set() {
  Set s;
  std::set<double> omega, directions;
  const auto added = rows_of(std::string(kSpar) + ".1");
  const auto force = rows_of(std::string(kSpar) + ".3");
  for (const auto& r : added)
    if (r[0] > 0) omega.insert(2 * M_PI / r[0]);
  for (const auto& r : force) directions.insert(r[1]);
  s.omega.assign(omega.begin(), omega.end());
  s.directions.assign(directions.begin(), directions.end());
  const auto place = [](const std::vector<double>& in, double x) {
    return static_cast<int>(std::lower_bound(in.begin(), in.end(), x) - in.begin());
  };
  for (const auto& r : added) {
    const int i = static_cast<int>(r[1]) - 1;
    const int j = static_cast<int>(r[2]) - 1;
    if (r[0] == 0) s.limit[{i, j}] = r[3];
    if (!(r[0] > 0)) continue;
    const int k = place(s.omega, 2 * M_PI / r[0]);
    s.added[{k, i, j}] = r[3];
    s.damping[{k, i, j}] = r[4];
  }
  for (const auto& r : force)
    s.force[{place(s.omega, 2 * M_PI / r[0]), place(s.directions, r[1]), static_cast<int>(r[2]) - 1}] =
        Complex(r[5], r[6]);
  for (const auto& r : rows_of(std::string(kSpar) + ".hst"))
    s.stiffness[{static_cast<int>(r[0]) - 1, static_cast<int>(r[1]) - 1}] = r[2];
  return s;
}

}  // namespace hawser::hydrodynamic_files_test
