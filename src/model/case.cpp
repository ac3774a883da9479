#include "hawser/model/case.hpp"

#include <algorithm>
#include <stdexcept>

namespace hawser::model {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Mat3 BodyMass::tensor() const {
  Mat3 J = inertia.asDiagonal();
  J(0, 1) = J(1, 0) = products.x();
  J(1, 2) = J(2, 1) = products.y();
  J(0, 2) = J(2, 0) = products.z();
  return J;
}

bool Contact::takes_part(const Line& line) const { return all_lines || holds(lines, line.name); }

bool Contact::takes_part(const Volume& volume) const { return all_volumes || holds(volumes, volume.name); }

const LineType& Case::line_type(const std::string& name) const {
  for (const LineType& t : line_types)
    if (t.name == name) return t;
  throw std::out_of_range("no line type '" + name + "'");
}

const Joint& Case::joint(const std::string& name) const {
  for (const Joint& j : joints)
    if (j.name == name) return j;
  throw std::out_of_range("no joint '" + name + "'");
}

int Case::body_index(const std::string& name) const {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].name == name) return static_cast<int>(i);
  return -1;
}

int Case::line_index(const std::string& name) const {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].name == name) return static_cast<int>(i);
  throw std::out_of_range("no line '" + name + "'");
}

}  // namespace hawser::model
