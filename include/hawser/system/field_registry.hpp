// The node fields that terms can show in a result file. Those made of other fields (utilisation) are added in
// app/utilisation.cpp; histories, statistics and extremes name the fields they show.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hawser/state/kinematics.hpp"

namespace hawser {

struct FieldSource {
  std::string name;  // "effective_tension"
  std::string unit;  // "N"
  int components = 1;
  // Fills values[node * components + c] for this rank's owned nodes from an accepted state.
  std::function<void(const Kinematics& at, std::span<double> values)> fill;
  // A field added before, of the same shape, whose values `values` holds when fill is called; empty: none.
  std::string onto = {};
};

class FieldRegistry {
 public:
  void add(FieldSource source) { sources_.push_back(std::move(source)); }
  const std::vector<FieldSource>& sources() const { return sources_; }

 private:
  std::vector<FieldSource> sources_;
};

}  // namespace hawser
