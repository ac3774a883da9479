#include "hawser/model/case.hpp"

#include <stdexcept>

namespace hawser::model {

const LineType& Case::line_type(const std::string& name) const {
  for (const LineType& t : line_types)
    if (t.name == name) return t;
  throw std::out_of_range("no line type '" + name + "'");
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
