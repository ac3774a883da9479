// Search along an element axis for intervals with a negative gap, and their division into panels.
#include "hawser/kernels/contact_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/kernels/clearance_tube.hpp"
#include "hawser/math/ordered.hpp"

namespace hawser {
namespace {

// Error of interval ends in xi. The contact force is zero there, so the error enters the integral squared.
constexpr double kRoot = 1e-10;
constexpr int kMaxIterations = 100;
constexpr int kFiner = 4;  // further halvings where contact is not excluded

class Scan {
 public:
  Scan(AxisGapFunction gap, const AxisBounds& bounds, std::vector<ContactInterval>& out)
      : gap_(gap), bounds_(bounds), slope_bound_(bounds.slope), out_(out) {}

  void piece(double a, const AxisGap& A, double b, const AxisGap& B, int levels) {
    const bool in_a = A.gap < 0;
    const bool in_b = B.gap < 0;
    const double span = slope_bound_ * (b - a);
    if (!in_a && !in_b && excluded(b - a, A.gap, B.gap)) return;
    const bool in_both = in_a && in_b;
    if (levels > 0 ||
        (levels > -kFiner && ((bounds_.contact_distance > 0 && !in_both) || mixed(b - a, A, B)))) {
      const double m = 0.5 * (a + b);
      const AxisGap M = gap_(m, span);
      piece(a, A, m, M, levels - 1);
      piece(m, M, b, B, levels - 1);
    } else if (in_both) {
      arch(a, A, b, B);
    } else if (in_a) {
      add({a, root(a, A, b, B), false, true});
    } else if (in_b) {
      add({root(b, B, a, A), b, true, false});
    } else if (A.slope < 0 && B.slope > 0) {
      dip(a, A, b, B);
    }
  }

 private:
  // True if there is certainly no contact between two points out of contact.
  bool excluded(double w, double A, double B) const {
    const double far = bounds_.contact_distance;
    return A + B >= slope_bound_ * w ||
           (far > 0 && smallest_between(w, A + far, B + far, slope_bound_, bounds_.bend) > far);
  }

  // True if the gap is neither convex nor concave (else its mean slope would be between those at the ends)
  // where that may matter: the cubic through the ends, at most `off` from their chord, might change its sign
  // twice.
  bool mixed(double w, const AxisGap& A, const AxisGap& B) const {
    const double mean = (B.gap - A.gap) / w;
    const double slack = 1e-9 * slope_bound_;
    if (mean > std::min(A.slope, B.slope) - slack && mean < std::max(A.slope, B.slope) + slack) return false;
    const double off = 4.0 / 27 * w * (std::abs(A.slope - mean) + std::abs(B.slope - mean));
    const auto [lower, upper] = ordered(A.gap, B.gap);
    return upper < 0 ? upper + off > 0 : lower >= 0 ? lower - off < 0 : true;
  }

  void add(const ContactInterval& s) {
    if (!out_.empty() && out_.back().to == s.from && !out_.back().to_moves && !s.from_moves) {
      out_.back().to = s.to;
      out_.back().to_moves = s.to_moves;
    } else
      out_.push_back(s);
  }

  // Both ends are in contact. The gap may rise above zero and fall again, at a kink even within a small part
  // of the piece. The search continues while the end tangents, which bound a concave gap, allow it.
  void arch(double a, const AxisGap& A, double b, const AxisGap& B) {
    const double first = a;
    const double last = b;
    const double wide = slope_bound_ * (b - a);
    AxisGap from = A;
    AxisGap to = B;
    for (int i = 0; i < kMaxIterations && b - a > kRoot; ++i) {
      const double w = b - a;
      const bool rises = from.slope > 0;
      const bool falls = to.slope < 0;
      const double mean = (to.gap - from.gap) / w;
      double x = 0.5 * w;
      double highest = -1;
      if (rises && falls && mean < from.slope && mean > to.slope) {
        const double z = (to.gap - from.gap - to.slope * w) / (from.slope - to.slope);
        highest = from.gap + from.slope * z;
        if (i % 3 < 2) x = z;
      } else {
        if (rises) highest = from.gap + from.slope * w;
        if (falls) highest = std::max(highest, to.gap - to.slope * w);
      }
      if (!(highest > 0)) break;
      const double edge = 1e-3 * w;
      const double m = a + std::clamp(x, edge, w - edge);
      const AxisGap M = gap_(m, wide);
      if (M.gap >= 0) {
        add({first, root(a, from, m, M), false, true});
        add({root(b, to, m, M), last, true, false});
        return;
      }
      const bool right = M.slope > 0 ? !rises || M.gap >= from.gap : falls && M.gap < to.gap;
      (right ? a : b) = m;
      (right ? from : to) = M;
    }
    add({first, last, false, false});
  }

  // Neither end is in contact, and the gap decreases inwards from both: contact if the minimum is below zero.
  void dip(double a, AxisGap A, double b, AxisGap B) {
    const double first = a;
    const double last = b;
    const AxisGap F = A;
    const AxisGap L = B;
    for (int i = 0; i < kMaxIterations && b - a > kRoot; ++i) {
      // Intersection of the two tangents, a lower bound of a convex gap.
      const double z = (B.gap - A.gap - B.slope * (b - a)) / (A.slope - B.slope);
      if (A.gap + A.slope * z >= 0) return;
      double m = a + (b - a) * A.slope / (A.slope - B.slope);  // root of the slope, by the secant
      if (i % 3 == 2) m = 0.5 * (a + b);
      const double edge = 1e-3 * (b - a);
      m = std::clamp(m, a + edge, b - edge);
      const AxisGap M = gap_(m, slope_bound_ * (last - first));
      if (M.gap < 0) {
        add({root(m, M, first, F), root(m, M, last, L), true, true});
        return;
      }
      if (M.slope < 0) {
        a = m;
        A = M;
      } else if (M.slope > 0) {
        b = m;
        B = M;
      } else
        return;
    }
  }

  // Root between `in`, where the gap is negative, and `out`.
  double root(double in, AxisGap I, double out, AxisGap O) {
    const double wide = slope_bound_ * std::abs(out - in);
    if (O.gap == 0) return out;
    double x = out - O.gap / (O.gap - I.gap) * (out - in);
    if (const double newton = out - O.gap / O.slope; (newton - in) * (newton - out) < 0) x = newton;
    double last = std::abs(out - in);
    for (int i = 0; i < kMaxIterations; ++i) {
      const AxisGap X = gap_(x, wide);
      (X.gap < 0 ? in : out) = x;
      double next = x - X.gap / X.slope;
      // A Newton step must stay inside and at least halve the previous step; otherwise bisection.
      const bool inside = (next - in) * (next - out) < 0 && std::abs(next - x) < 0.5 * last;
      if (std::isfinite(next) && std::abs(next - x) <= kRoot) return std::clamp(next, 0.0, 1.0);
      if (!inside) next = 0.5 * (in + out);
      last = std::abs(next - x);
      if (last <= kRoot) return next;
      x = next;
    }
    return x;
  }

  AxisGapFunction gap_;
  AxisBounds bounds_;
  double slope_bound_;
  std::vector<ContactInterval>& out_;
};

}  // namespace

std::vector<double> middles(const std::vector<InactiveInterval>& intervals) {
  std::vector<double> out;
  for (const InactiveInterval& h : intervals) out.push_back(h.middle());
  return out;
}

std::vector<InactiveInterval> inactive_intervals(const std::vector<ContactInterval>& intervals) {
  std::vector<InactiveInterval> out;
  for (std::size_t i = 1; i < intervals.size(); ++i)
    if (intervals[i - 1].to < intervals[i].from) out.push_back({intervals[i - 1].to, intervals[i].from});
  return out;
}

std::vector<ContactInterval> contact_intervals(AxisGapFunction gap, const AxisBounds& bounds, int levels,
                                               const std::vector<double>& places) {
  std::vector<ContactInterval> out;
  const double half = 0.5 * bounds.slope;
  const AxisGap M = gap(0.5, half);
  if (M.gap >= half) return out;
  const AxisGap A = gap(0, half);
  const AxisGap B = gap(1, half);
  Scan scan(gap, bounds, out);
  const auto piece = [&](double a, AxisGap from, double b, const AxisGap& to) {
    for (const double m : places) {
      if (!(a < m && m < b)) continue;
      const AxisGap at = gap(m, half);
      scan.piece(a, from, m, at, levels - 1);
      a = m;
      from = at;
    }
    scan.piece(a, from, b, to, levels - 1);
  };
  piece(0, A, 0.5, M);
  piece(0.5, M, 1, B);
  return out;
}

std::vector<ContactInterval> as_split_before(const std::vector<ContactInterval>& now,
                                             const std::vector<ContactInterval>& before,
                                             std::vector<InactiveInterval>& filled) {
  filled.clear();
  const std::vector<InactiveInterval> inactive_before = inactive_intervals(before);
  std::vector<ContactInterval> out;
  for (const ContactInterval& s : now) {
    const bool touched =
        !out.empty() && std::any_of(before.begin(), before.end(), [&](const ContactInterval& b) {
          return b.from <= out.back().to && s.from <= b.to;
        });
    if (touched) {
      if (out.back().to < s.from) filled.push_back({out.back().to, s.from});
      out.back().to = s.to;
      out.back().to_moves = s.to_moves;
    } else {
      out.push_back(s);
    }
    for (const InactiveInterval& h : inactive_before) {
      const double m = h.middle();
      if (!(out.back().from < m && m < out.back().to)) continue;
      const ContactInterval remaining{m, out.back().to, false, out.back().to_moves};
      out.back().to = m;
      out.back().to_moves = false;
      out.push_back(remaining);
    }
  }
  return out;
}

int panel_levels(double length, double radius) {
  int levels = 1;
  while (levels < 5 && std::ldexp(length, -levels) > 4 * radius) ++levels;
  return levels;
}

int contact_levels(double length, double radius) { return std::max(panel_levels(length, radius), 2); }

std::vector<ContactInterval> split_intervals(const std::vector<ContactInterval>& intervals, int levels) {
  std::vector<ContactInterval> panels;
  const double size = std::ldexp(1.0, -levels);
  for (const ContactInterval& s : intervals)
    for (double a = size * std::floor(s.from / size); a < s.to; a += size) {
      const bool first = a <= s.from;
      const bool last = a + size >= s.to;
      const ContactInterval p{first ? s.from : a, last ? s.to : a + size, first && s.from_moves,
                              last && s.to_moves};
      if (p.to > p.from) panels.push_back(p);
    }
  return panels;
}

}  // namespace hawser
