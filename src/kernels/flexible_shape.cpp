// Minimisation of the potential energy of a line without bending stiffness: Newton's method with block
// elimination along the line, from coarse to fine and from soft to stiff.
#include "hawser/kernels/flexible_shape.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

// Number of levels of stiffness, each ten times as stiff and less smoothed than the one before.
constexpr int kLevels = 4;
constexpr double kSoft = 30, kStiffening = 10;  // EA over load at the first level; factor from level to level
constexpr double kRound = 0.1;       // tension of an unstrained element over the load, at the first level
constexpr double kFirstSink = 0.02;  // fraction of the length by which the line sinks into the bed at first
constexpr double kSink = 0.01;       // fraction of a piece by which the line may sink into the bed
constexpr double kTolerance = 1e-3;  // fraction of the loads
constexpr int kMaxIterations = 200;
constexpr size_t kCoarsest = 12;  // pieces

class Shape {
 public:
  Shape(const FlexibleLine& line, std::vector<Vec3> start) : line_(line), x_(std::move(start)) {
    const size_t n = x_.size();
    free_.assign(n, true);
    free_.front() = !line_.held_a;
    free_.back() = !line_.held_b;
    load_.assign(n, Vec3::Zero());
    lift_.assign(n, 0);
    press_.assign(n, 0);
    radius_.assign(n, 0);
    double heaviest = 0;
    for (size_t i = 0; i + 1 < n; ++i) {
      const auto& p = line_.pieces[i];
      length_ += p.length;
      heaviest = std::max(heaviest, (p.load.norm() + p.buoyancy) / p.length);
      for (size_t k : {i, i + 1}) {
        load_[k] += 0.5 * p.length * p.load;
        lift_[k] += 0.5 * p.length * p.buoyancy;
        press_[k] += 0.5 * p.length;
        radius_[k] = std::max(radius_[k], p.radius);
      }
      size_ += p.length * (p.load.norm() + p.buoyancy);
      EA_ = std::max(EA_, p.EA);
    }
    bed_ = line_.bed ? std::min(line_.bed_stiffness, heaviest / kSink) : 0;

    for (size_t i = 0; i < n; ++i) {
      load_[i] += line_.points[i].load;
      lift_[i] += line_.points[i].buoyancy;
      size_ += line_.points[i].load.norm() + line_.points[i].buoyancy;
    }
    // The excess of the ends' distance over the length stretches the line.
    if (line_.held_a && line_.held_b) {
      double compliance = 0;
      for (const auto& p : line_.pieces) compliance += p.length / p.EA;
      size_ += std::max(0.0, (x_.back() - x_.front()).norm() - length_) / compliance;
    }
    soft_bed_ = size_ / (length_ * kFirstSink * length_);
    width_ = std::max(0.005 * length_, 2 * *std::max_element(radius_.begin(), radius_.end()));
  }

  std::vector<Vec3> run(int first_level) {
    if (!(size_ > 0)) return x_;
    for (int level = first_level; level < kLevels; ++level) {
      const double hard = std::pow(kStiffening, level);
      const double EA = std::min(EA_, kSoft * hard * size_);
      EA_fraction_ = EA / EA_;
      round_ = 4 * kRound * size_ / (hard * EA);
      stiffness_ = std::min(bed_, soft_bed_ * std::pow(bed_ / soft_bed_, level / (kLevels - 1.0)));
      if (level + 1 == kLevels) stiffness_ = bed_;
      descend();
    }
    return x_;
  }

 private:
  // Wet fraction at height z, and its derivative.
  double wet(double z, double& slope) const {
    const double h = 0.5 - (z - line_.surface) / (2 * width_);
    slope = h > 0 && h < 1 ? -0.5 / width_ : 0;
    return std::clamp(h, 0.0, 1.0);
  }

  // The energy is, with the strain e = l/L - 1 of each element and r = round_, at nodes with a gap g < 0,
  //   E = sum EA L p²/2 - sum F·x - lift + sum k w g²/2,   p = (e + sqrt(e² + r²))/2,
  //   p' = p/sqrt(e² + r²),   p'' = r²/(2 sqrt(e² + r²)³),
  //   T = dE/dl = EA p p',   dT/dl = EA (p'² + p p'')/L.
  // Gradient of the energy at x, and on request its Hessian: diagonal blocks, and minus the blocks between a
  // node and the next.
  void gradient(const std::vector<Vec3>& x, std::vector<Vec3>& g, bool hessian) {
    const size_t n = x.size();
    for (size_t i = 0; i < n; ++i) {
      g[i] = -load_[i];
      if (hessian) diagonal_[i].setZero();
      if (line_.water && lift_[i] > 0) {
        double slope = 0;
        g[i].z() -= lift_[i] * wet(x[i].z(), slope);
        if (hessian) diagonal_[i](2, 2) -= lift_[i] * slope;
      }
      if (stiffness_ > 0) {
        const double gap = line_.bed_normal.dot(x[i] - line_.bed_point) - radius_[i];
        if (gap < 0) {
          g[i] += stiffness_ * press_[i] * gap * line_.bed_normal;
          if (hessian)
            diagonal_[i] += stiffness_ * press_[i] * line_.bed_normal * line_.bed_normal.transpose();
        }
      }
    }
    for (size_t i = 0; i + 1 < n; ++i) {
      const auto& p = line_.pieces[i];
      const Vec3 d = x[i + 1] - x[i];
      const double l = d.norm();
      const double strain = l / p.length - 1;
      // max(0, strain), smoothed: still convex, and with a descent direction for slack elements.
      const double root = std::hypot(strain, round_);
      const double pull = 0.5 * (strain + root);
      const double rise = pull / root;
      const Vec3 t = d / l;
      const double tension = EA_fraction_ * p.EA * pull * rise;
      const double stiff =
          EA_fraction_ * p.EA * (rise * rise + pull * round_ * round_ / (2 * root * root * root)) / p.length;
      g[i] -= tension * t;
      g[i + 1] += tension * t;
      if (!hessian) continue;
      between_[i] = tension / l * Mat3::Identity() + (stiff - tension / l) * t * t.transpose();
      diagonal_[i] += between_[i];
      diagonal_[i + 1] += between_[i];
    }
    for (size_t i = 0; i < n; ++i)
      if (!free_[i]) g[i].setZero();
  }

  // Solves (Hessian + shift) step = -gradient by block elimination along the line.
  void newton(double shift) {
    const size_t n = x_.size();
    Mat3 from_before = Mat3::Zero();
    Vec3 carried = Vec3::Zero();
    std::vector<Mat3>& up = up_;
    for (size_t i = 0; i < n; ++i) {
      Mat3 d = diagonal_[i] + shift * Mat3::Identity() - from_before;
      if (!free_[i]) d.setIdentity();
      const Eigen::LDLT<Mat3> factor(d);
      const Vec3 right = free_[i] ? Vec3(-gradient_[i] + carried) : Vec3(Vec3::Zero());
      step_[i] = factor.solve(right);
      if (i + 1 == n) break;
      const bool joined = free_[i] && free_[i + 1];
      up[i] = joined ? Mat3(factor.solve(between_[i])) : Mat3(Mat3::Zero());
      from_before = between_[i] * up[i];
      carried = joined ? Vec3(between_[i] * step_[i]) : Vec3(Vec3::Zero());
    }
    for (size_t i = n - 1; i-- > 0;) step_[i] += up[i] * step_[i + 1];
  }

  double slope(double a) {
    for (size_t i = 0; i < x_.size(); ++i) trial_[i] = x_[i] + a * step_[i];
    gradient(trial_, trial_gradient_, false);
    double s = 0;
    for (size_t i = 0; i < x_.size(); ++i) s += trial_gradient_[i].dot(step_[i]);
    return s;
  }

  void descend() {
    const size_t n = x_.size();
    gradient_.resize(n);
    trial_gradient_.resize(n);
    step_.resize(n);
    trial_.resize(n);
    diagonal_.resize(n);
    between_.resize(n - 1);
    up_.resize(n - 1);
    double shift = 0.1 * size_ / length_;
    const double min_shift = 1e-6 * size_ / length_;
    for (int it = 0; it < kMaxIterations; ++it) {
      gradient(x_, gradient_, true);
      double error = 0;
      for (const Vec3& g : gradient_) error = std::max(error, g.norm());
      if (error < kTolerance * size_ / static_cast<double>(n)) return;
      newton(shift);
      double start = 0;
      for (size_t i = 0; i < n; ++i) start += gradient_[i].dot(step_[i]);
      if (!(start < 0)) return;
      double low = 0, high = 0, a = 1;
      for (int search = 0; search < 40; ++search) {
        const double s = slope(a);
        if (s > -0.5 * start)
          high = a;
        else if (s < 0.5 * start)
          low = a;
        else
          break;
        if (high == 0 && a >= 16) break;
        a = high > 0 ? 0.5 * (low + high) : 2 * a;
      }
      for (size_t i = 0; i < n; ++i) x_[i] += a * step_[i];
      shift = std::max(min_shift, a > 0.3 ? 0.3 * shift : shift);
    }
  }

  const FlexibleLine& line_;
  std::vector<Vec3> x_, load_;
  std::vector<char> free_;
  std::vector<double> lift_, press_, radius_;  // N, m, m by node
  double length_ = 0, size_ = 0, EA_ = 0, width_ = 0;
  double bed_ = 0, soft_bed_ = 0;           // N/m², final and initial
  double EA_fraction_ = 1, stiffness_ = 0;  // fraction of EA; stiffness of the bed, N/m²
  double round_ = 0;                        // smoothing strain
  std::vector<Vec3> gradient_, trial_gradient_, step_, trial_;
  std::vector<Mat3> diagonal_, between_, up_;
};

FlexibleLine::Segment joined(const FlexibleLine::Segment& a, const FlexibleLine::Segment& b) {
  FlexibleLine::Segment o;
  o.length = a.length + b.length;
  o.EA = o.length / (a.length / a.EA + b.length / b.EA);
  o.load = (a.length * a.load + b.length * b.load) / o.length;
  o.buoyancy = (a.length * a.buoyancy + b.length * b.buoyancy) / o.length;
  o.radius = std::max(a.radius, b.radius);
  return o;
}

FlexibleLine::Point sum(const FlexibleLine::Point& a, const FlexibleLine::Point& b, double factor) {
  return {a.load + factor * b.load, a.buoyancy + factor * b.buoyancy};
}

}  // namespace

std::vector<Vec3> flexible_shape(const FlexibleLine& line, std::vector<Vec3> start) {
  const size_t pieces = line.pieces.size();
  if (pieces < 1) return start;
  if (pieces <= kCoarsest) return Shape(line, std::move(start)).run(0);
  // Coarse first: a few long pieces advance far in a step, many short ones slowly.
  FlexibleLine coarse = line;
  coarse.pieces.clear();
  coarse.points.clear();
  std::vector<Vec3> from{start.front()};
  std::vector<double> arc{0}, kept{0};
  for (const auto& p : line.pieces) arc.push_back(arc.back() + p.length);
  coarse.points.push_back(line.points.front());
  for (size_t i = 0; i < pieces; i += 2) {
    const size_t end = std::min(i + 2, pieces);
    coarse.pieces.push_back(i + 1 < end ? joined(line.pieces[i], line.pieces[i + 1]) : line.pieces[i]);
    if (i + 1 < end) coarse.points.back() = sum(coarse.points.back(), line.points[i + 1], 0.5);
    coarse.points.push_back(i + 1 < end ? sum(line.points[end], line.points[i + 1], 0.5) : line.points[end]);
    from.push_back(start[end]);
    kept.push_back(arc[end]);
  }
  const std::vector<Vec3> coarse_shape = flexible_shape(coarse, std::move(from));
  for (size_t i = 0; i < start.size(); ++i)
    start[i] = i % 2 == 0              ? coarse_shape[i / 2]
               : i + 1 == start.size() ? coarse_shape.back()
                                       : interpolated(kept, coarse_shape, arc[i]);
  return Shape(line, std::move(start)).run(1);
}

Vec3 interpolated(const std::vector<double>& s, const std::vector<Vec3>& x, double at) {
  const size_t n = s.size();
  size_t i = std::upper_bound(s.begin(), s.end(), at) - s.begin();
  i = std::clamp<size_t>(i, 1, n - 1) - 1;
  const auto slope = [&](size_t k) {
    const size_t a = k > 0 ? k - 1 : 0;
    const size_t b = std::min(k + 1, n - 1);
    return Vec3((x[b] - x[a]) / (s[b] - s[a]));
  };
  const double h = s[i + 1] - s[i];
  const double z = (at - s[i]) / h;
  const double y = 1 - z;
  return y * y * (1 + 2 * z) * x[i] + z * z * (3 - 2 * z) * x[i + 1] +
         h * z * y * (y * slope(i) - z * slope(i + 1));
}

}  // namespace hawser
