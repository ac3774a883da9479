// Shared by the contact tests: a line over a drum about the y axis without gravity, and evaluation of runs.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hawser/geometry/mesh_surface.hpp"
#include "support/cpu_time.hpp"
#include "support/rig.hpp"
#include "support/shapes.hpp"

namespace hawser::test {

// A drum of flat facets about the y axis, its vertices on the radius; rotated by `phase` about its axis.
inline std::shared_ptr<const Surface> faceted_drum(int facets, double radius, double width, int rings = 4,
                                                   double phase = 0) {
  TriangleMesh m = test::drum_mesh(facets, radius, width, rings);
  for (Vec3& v : m.vertices) {
    const double a = std::atan2(v.y(), v.x()) + phase;
    const double r = std::hypot(v.x(), v.y());
    v = Vec3(r * std::sin(a), v.z(), r * std::cos(a));  // z to y
  }
  return std::make_shared<MeshSurface>(std::move(m));
}

inline std::shared_ptr<const Surface> round_drum(double radius, double width) {
  return std::make_shared<CylinderSurface>(Vec3(0, -width / 2, 0), Vec3(0, width / 2, 0), radius);
}

// Point on a circle about the y axis, angle 0 at +x, pi/2 at +z; and the tangent.
inline Vec3 on_circle(double radius, double angle) {
  return {radius * std::cos(angle), 0, radius * std::sin(angle)};
}
inline Vec3 along_circle(double angle) { return {-std::sin(angle), 0, std::cos(angle)}; }

// Path of leg, arc from angle 0 to `wrap`, leg; legs are tangential. The spacing of the arc's corners is that
// of the nodes or finer.
inline std::vector<Vec3> capstan_path(double radius, double wrap, double leg_a, double leg_b) {
  std::vector<Vec3> p{on_circle(radius, 0) - leg_a * along_circle(0)};
  const int pieces = static_cast<int>(std::ceil(wrap * 200));
  for (int i = 0; i <= pieces; ++i) p.push_back(on_circle(radius, wrap * i / pieces));
  p.push_back(p.back() + leg_b * along_circle(wrap));
  return p;
}

inline double path_length(const std::vector<Vec3>& p) {
  double s = 0;
  for (size_t i = 1; i < p.size(); ++i) s += (p[i] - p[i - 1]).norm();
  return s;
}

// Mean, root mean square deviation and extremes of samples weighted with the step.
struct Samples {
  double weight = 0, sum = 0, square = 0, least = 1e300, most = -1e300;
  void add(double value, double w = 1) {
    weight += w;
    sum += w * value;
    square += w * value * value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  double mean() const { return sum / weight; }
  double rms() const { return std::sqrt(std::max(0.0, square / weight - mean() * mean())); }
};

// Values at the accepted steps of a run.
struct Series {
  std::vector<double> time, step, value;
  void add(const StepInfo& i, double v) {
    time.push_back(i.time);
    step.push_back(i.h);
    value.push_back(v);
  }
  // Root mean square in (from, to) [s] of the deviation from a straight line fitted to the 10 s around each
  // instant.
  double noise(double from, double to) const {
    double sum = 0, weight = 0;
    size_t low = 0, high = 0;
    for (size_t i = 0; i < time.size(); ++i) {
      while (time[low] < time[i] - 5) ++low;
      while (high < time.size() && time[high] <= time[i] + 5) ++high;
      if (time[i] < from || time[i] > to) continue;
      double s0 = 0, s1 = 0, s2 = 0, y0 = 0, y1 = 0;
      for (size_t k = low; k < high; ++k) {
        const double x = time[k] - time[i];
        const double w = step[k];
        s0 += w;
        s1 += w * x;
        s2 += w * x * x;
        y0 += w * value[k];
        y1 += w * x * value[k];
      }
      const double off = value[i] - (s2 * y0 - s1 * y1) / (s0 * s2 - s1 * s1);
      sum += step[i] * off * off;
      weight += step[i];
    }
    return std::sqrt(sum / weight);
  }
};

// A field of the results at this rank's nodes, by name.
class NodeField {
 public:
  NodeField(Simulation& s, const std::string& name) {
    const FieldRegistry registry = s.system().fields();
    for (const FieldSource& f : registry.sources())
      if (f.name == name) source_ = f;
    if (!source_.fill) throw std::invalid_argument("no field " + name);
    values_.resize(static_cast<size_t>(s.local().owned * source_.components));
  }
  const std::vector<double>& at(const Kinematics& k) {
    source_.fill(k, values_);
    return values_;
  }

 private:
  FieldSource source_;
  std::vector<double> values_;
};

}  // namespace hawser::test
