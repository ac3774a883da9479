// Contact force from a table by penetration: the rows begin at zero, and the cubic through them defines
// force, stiffness and potential.
#include "hawser/kernels/contact_force_table.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {
namespace {

std::vector<ContactForceTable::Row> from_nothing(std::span<const ContactForceTable::Row> rows) {
  std::vector<ContactForceTable::Row> out{{0, 0}};
  const auto refuse = [](size_t row, const char* problem) {
    throw std::invalid_argument("row " + std::to_string(row + 1) + " " + problem);
  };
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto [p, f] = rows[i];
    if (!std::isfinite(p) || !std::isfinite(f)) refuse(i, "is not finite");
    if (i == 0 && p == 0 && f == 0) continue;
    if (!(p > out.back().first)) refuse(i, "does not penetrate further than the one before");
    if (f < out.back().second) refuse(i, "has less force than the one before");
    out.push_back(rows[i]);
  }
  if (out.size() < 2 || !(out.back().second > 0))
    throw std::invalid_argument("a table of forces needs a row with a force");
  return out;
}

}  // namespace

ContactForceTable::ContactForceTable(std::span<const Row> rows) : curve_(from_nothing(rows), 0) {}

ContactForceTable::Value ContactForceTable::at(double p) const {
  if (p <= 0) return {};
  const MonotoneCubic::Value v = curve_.at(p);
  return {v.y, v.slope, v.bend, v.integral};
}

}  // namespace hawser
