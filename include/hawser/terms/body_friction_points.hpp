// History of friction between bodies: the contact points of an accepted step, by the corner, edge or point of
// a face (feature) on which they lie. A volume may have thousands of points of faces, and each evaluation
// looks up all of them.
#pragma once

#include <span>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

// Contact point in the frame of the surface; forces are per unit of `weight` (1, m or m²).
struct BodyFrictionPoint {
  double xi = 0, from = 0, to = 0;  // place on an edge and limits of its panel
  double weight = 1;
  Vec3 slip = Vec3::Zero(), normal = Vec3::UnitZ();  // m, elastic slip
  Vec3 friction = Vec3::Zero();                      // N, N/m or N/m²
  double peak = 0;  // the same, largest normal force since the point touched; 0 in statics

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("place", "", self.xi);
    each("from", "", self.from);
    each("to", "", self.to);
    each("weight", "1, m or m2", self.weight);
    each("slip", "m", self.slip);
    each("normal", "", self.normal);
    each("friction force", "N, N/m or N/m2", self.friction);
    each("peak of the normal force", "N, N/m or N/m2", self.peak);
  }
};

class BodyFrictionPoints {
 public:
  bool empty() const { return points_.empty(); }
  void clear() {
    points_.clear();
    features_.clear();
    place_.clear();
  }
  // Adds all points of a feature at once.
  void add(int feature, std::span<const BodyFrictionPoint> points) {
    if (points.empty()) return;
    const size_t i = feature;
    if (i >= place_.size()) place_.resize(i + 1, -1);
    place_[i] = static_cast<int>(features_.size());
    features_.push_back({feature, points_.size(), points.size()});
    points_.insert(points_.end(), points.begin(), points.end());
  }
  // Contact points of a feature; empty if it did not touch.
  std::span<const BodyFrictionPoint> of(int feature) const {
    const size_t i = feature;
    if (i >= place_.size() || place_[i] < 0) return {};
    return points(features_[place_[i]]);
  }
  // Calls visit(feature, points) for each feature in the order of add().
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Feature& f : features_) visit(f.index, points(f));
  }

 private:
  struct Feature {
    int index = 0;
    size_t first = 0, count = 0;
  };
  std::span<const BodyFrictionPoint> points(const Feature& f) const {
    return std::span(points_).subspan(f.first, f.count);
  }
  std::vector<BodyFrictionPoint> points_;
  std::vector<Feature> features_;
  std::vector<int> place_;  // index in features_ by Feature::index; -1: none
};

}  // namespace hawser
