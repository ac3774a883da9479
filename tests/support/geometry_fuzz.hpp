// Random test of geometry: closest points of triangles and segments, and the sign of the distance, against
// quadruple precision and other formulas. The shapes range from regular to degenerate, their sizes from 1e-30
// m to 1e30 m.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/extended_precision.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/segment_distance.hpp"
#include "hawser/math/triple.hpp"

namespace hawser::test {

class GeometryFuzz {
 public:
  explicit GeometryFuzz(unsigned seed) : gen_(seed) {}

  void triangles(long cases) {
    double worst = 0, worst_height = 0;
    for (long i = 0; i < cases; ++i) {
      scale_ = power(-30, 30);
      Vec3 v[3];
      triangle(v);
      const Vec3 p = point(v);
      double error = 0, height = 0;
      ASSERT_TRUE(triangle_is_right(p, v, error, height))
          << "case " << i << "\n"
          << p.transpose() << "\n"
          << v[0].transpose() << "\n"
          << v[1].transpose() << "\n"
          << v[2].transpose() << "\nerror of the distance " << error << ", of the height " << height;
      worst = std::max(worst, error);
      worst_height = std::max(worst_height, height);
    }
    report("triangle and point", cases, worst);
    report("height over the triangle's plane", cases, worst_height);
  }

  void segments(long cases) {
    double worst = 0;
    for (long i = 0; i < cases; ++i) {
      scale_ = power(-30, 30);
      Vec3 v[4];
      two_segments(v);
      const SegmentPair pair = closest_points_of_segments(v[0], v[1], v[2], v[3]);
      const double size = std::max({(v[1] - v[0]).norm(), (v[3] - v[2]).norm(), (v[2] - v[0]).norm()});
      const double error = std::abs(pair.distance - segment_distance(v)) / std::max(size, 1e-300);
      ASSERT_TRUE(error <= 1e-14 && pair.s >= 0 && pair.s <= 1 && pair.t >= 0 && pair.t <= 1 &&
                  pair.on_a.allFinite() && pair.on_b.allFinite() && pair.difference.allFinite())
          << "case " << i << " error " << error << "\n"
          << v[0].transpose() << "\n"
          << v[1].transpose() << "\n"
          << v[2].transpose() << "\n"
          << v[3].transpose();
      worst = std::max(worst, error);
    }
    report("two segments", cases, worst);
  }

  // Inside and outside of regular and flat tetrahedra, at points near their faces, edges and corners.
  void signs(int meshes, int points) {
    long decided = 0;
    for (int m = 0; m < meshes; ++m) {
      scale_ = power(-6, 6);
      Vec3 v[4] = {vec(), vec(), vec(), vec()};
      if (m % 3 == 1) v[3] = mix(v, 3) + power(-8, 0) * vec();  // flat
      if (m % 3 == 2) v[1] = v[0] + power(-8, 0) * vec();       // with a needle
      for (Vec3& x : v) x *= scale_;
      if (side(v[0], v[1], v[2], v[3]) > 0) std::swap(v[0], v[1]);
      const double size = std::max({(v[1] - v[0]).norm(), (v[2] - v[0]).norm(), (v[3] - v[0]).norm()});
      TriangleMesh mesh{{v[0], v[1], v[2], v[3]}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}, {}, {}};
      if (!inspect(mesh).valid()) continue;  // too flat: it has no inside
      const MeshSurface surface(mesh);
      // Near their common edge, two faces that meet at a small angle are apart by at most that angle times
      // the distance to the edge. If this is below rounding, double precision cannot decide on which side of
      // both faces y is.
      double thin = 1;
      for (std::size_t t = 0; t < 4; ++t) {
        const auto& f = mesh.triangles[t];
        const auto corner = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(f[i])]; };
        const int opposite = 6 - f[0] - f[1] - f[2];
        const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
        const Vec3& apex = mesh.vertices[static_cast<std::size_t>(opposite)];
        thin = std::min(thin, std::abs(side(corner(0), corner(1), corner(2), apex)) / (area * size));
      }
      for (int k = 0; k < points; ++k) {
        const int n = 1 + pick(4);
        const Vec3 y = mix(v, n) + size * power(-12, 0.5) * vec();
        bool inside = true;
        for (const auto& t : mesh.triangles) {
          const auto corner = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(t[i])]; };
          inside = inside && side(corner(0), corner(1), corner(2), y) < 0;
        }
        const auto s = surface.query(y, 10 * size);
        ASSERT_TRUE(s && std::isfinite(s->distance) && s->normal.allFinite() && s->curvature.allFinite());
        ASSERT_NEAR(s->normal.norm(), 1, 1e-12);
        if (std::abs(s->distance) * thin < 1e-14 * size) continue;
        ++decided;
        ASSERT_EQ(s->distance < 0, inside) << "distance " << s->distance << " of " << size << "\n"
                                           << y.transpose() << "\n"
                                           << v[0].transpose() << "\n"
                                           << v[1].transpose() << "\n"
                                           << v[2].transpose() << "\n"
                                           << v[3].transpose();
      }
    }
    report("sign of the distance", decided, 0);
  }

 private:
  using W = detail::Extended;
  using V = Triple<W>;
  static V extended(const Vec3& v) { return triple<W>(v); }

  double next() { return uniform_(gen_); }
  Vec3 vec() { return {next(), next(), next()}; }
  int pick(int n) { return static_cast<int>(gen_() % static_cast<unsigned>(n)); }
  double power(double lo, double hi) { return std::pow(10.0, lo + (hi - lo) * 0.5 * (next() + 1)); }
  Vec3 grid() { return Vec3(pick(4), pick(4), pick(4)); }
  // A random point of the convex hull of the first n points of v.
  Vec3 mix(const Vec3* v, int n) {
    double w[4], sum = 0;
    for (int i = 0; i < n; ++i) sum += w[i] = 1e-3 + std::abs(next());
    Vec3 x = Vec3::Zero();
    for (int i = 0; i < n; ++i) x += w[i] / sum * v[i];
    return x;
  }

  void triangle(Vec3* v) {
    for (int i = 0; i < 3; ++i) v[i] = vec();
    switch (pick(6)) {
      case 0:
        v[1] = v[0] + power(-16, 0) * vec();
        break;  // needle
      case 1:
        v[2] = mix(v, 2) + power(-16, 0) * vec();
        break;  // cap
      case 2:   // corners on a grid: often collinear or equal
        for (int i = 0; i < 3; ++i) v[i] = grid();
        break;
      case 3:
        v[2] = v[pick(2)];
        break;  // a segment
      default:
        break;
    }
    const Vec3 shift = pick(3) ? Vec3(Vec3::Zero()) : Vec3(power(-3, 6) * vec());
    for (int i = 0; i < 3; ++i) v[i] = scale_ * (v[i] + shift);
    std::shuffle(v, v + 3, gen_);
  }
  Vec3 point(const Vec3* v) {
    Vec3 w[3] = {v[0], v[1], v[2]};
    std::shuffle(w, w + 3, gen_);
    if (pick(8) == 0) return scale_ * grid();
    const Vec3 on = mix(w, 1 + pick(3));
    if (pick(8) == 0) return on;
    if (pick(3) == 0) return on + scale_ * power(-16, 3) * triangle_normal(v[0], v[1], v[2]);
    return on + scale_ * power(-16, 3) * vec();
  }
  void two_segments(Vec3* v) {
    for (int i = 0; i < 4; ++i) v[i] = pick(2) ? grid() : vec();
    const int kind = pick(5);
    if (kind == 0) v[3] = v[2] + power(-1, 1) * (v[1] - v[0] + power(-17, -1) * vec());  // nearly parallel
    if (kind == 1) v[3] = v[2] + power(-17, 0) * vec();                                  // short
    if (kind == 2) {                                                                     // almost meeting
      const Vec3 off = power(-17, 0) * vec();
      const Vec3 half = vec();
      v[2] = mix(v, 2) + off - half;
      v[3] = v[2] + 2 * half;
    }
    for (int i = 0; i < 4; ++i) v[i] *= scale_;
  }

  // Square root, accurate to 113 bits except the last few.
  static W root(W squared) {
    if (!(squared > 0)) return 0;
    W r = std::sqrt(static_cast<double>(squared));
    return r > 0 ? (r + squared / r) / 2 : r;
  }
  static V on_segment(const V& p, const V& a, const V& b) {
    const V e = b - a;
    const W l = e.dot(e);
    W t = l > 0 ? (p - a).dot(e) / l : W(0);
    t = t < 0 ? W(0) : t > 1 ? W(1) : t;
    return a + t * e;
  }
  // Positive when p is on the side of the triangle's normal. For doubles of equal size the relative error is
  // 1e-33.
  static double side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const V o = extended(a);
    return static_cast<double>((extended(b) - o).cross(extended(c) - o).dot(extended(p) - o));
  }

  // Compares distance and side with barycentric coordinates and three segments in 113 bits.
  bool triangle_is_right(const Vec3& p, const Vec3* v, double& error, double& height_error) {
    const V q = extended(p);
    const V a = extended(v[0]);
    const V e = extended(v[1]) - a;
    const V f = extended(v[2]) - a;
    const V r = q - a;
    const V n = e.cross(f);
    W best = -1;
    const auto offer = [&](const V& x) {
      const W d = (q - x).dot(q - x);
      if (best < 0 || d < best) best = d;
    };
    for (int i = 0; i < 3; ++i) offer(on_segment(q, extended(v[i]), extended(v[(i + 1) % 3])));
    const W nn = n.dot(n);
    if (nn > W(1e-50) * e.dot(e) * f.dot(f)) {
      const W s = n.dot(r.cross(f)) / nn;
      const W t = n.dot(e.cross(r)) / nn;
      if (s >= 0 && t >= 0 && s + t <= 1) offer(a + s * e + t * f);
    }
    const double exact = static_cast<double>(root(best));
    const ClosestPoint c = closest_point_on_triangle(p, v[0], v[1], v[2]);
    const double size = std::max(
        {(v[1] - v[0]).norm(), (v[2] - v[1]).norm(), (v[0] - v[2]).norm(), (p - v[0]).norm(), 1e-300});
    double far = p.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i) far = std::max(far, v[i].cwiseAbs().maxCoeff());
    // Coordinates far from the origin have a rounding error of this size.
    const double room = size + 0.3 * far;
    error = std::abs(std::sqrt(c.squared_distance) - exact) / room;
    bool right = std::isfinite(c.squared_distance) && c.squared_distance >= 0 && c.point.allFinite() &&
                 error <= 1e-14 && std::abs((c.point - p).norm() - exact) <= 1e-14 * room;
    const Vec3 normal = triangle_normal(v[0], v[1], v[2]);
    height_error = 0;
    if (!normal.isZero(0)) {
      const double height = static_cast<double>(n.dot(r) / root(nn));
      height_error = std::abs(normal.dot(p - v[0]) - height) / size;
      right = right && normal.allFinite() && height_error <= 1e-14;
      if (std::abs(height) > 1e-14 * size) right = right && (height > 0) == (normal.dot(p - v[0]) > 0);
    }
    return right;
  }

  // The minimum over the unit square of parameters is inside it or on one of its edges.
  static double segment_distance(const Vec3* x) {
    const V a0 = extended(x[0]);
    const V b0 = extended(x[2]);
    const V u = extended(x[1]) - a0;
    const V v = extended(x[3]) - b0;
    const V r = a0 - b0;
    const W a = u.dot(u);
    const W b = u.dot(v);
    const W c = v.dot(v);
    const W d = u.dot(r);
    const W e = v.dot(r);
    W best = -1;
    const auto take = [&](W s, W t) {
      s = s < 0 ? W(0) : s > 1 ? W(1) : s;
      t = t < 0 ? W(0) : t > 1 ? W(1) : t;
      const V w = r + s * u - t * v;
      if (const W q = w.dot(w); best < 0 || q < best) best = q;
    };
    for (int i = 0; i < 2; ++i) {
      take(W(i), c > 0 ? (e + W(i) * b) / c : W(0));
      take(a > 0 ? (W(i) * b - d) / a : W(0), W(i));
    }
    if (const W det = a * c - b * b; det > 0) {
      const W s = (b * e - c * d) / det;
      take(s, (e + s * b) / c);
    }
    return static_cast<double>(root(best));
  }

  static void report(const char* what, long cases, double worst) {
    std::printf("  %-34s %10ld cases, worst error %.2g of the size\n", what, cases, worst);
  }

  std::mt19937 gen_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
  double scale_ = 1;
};

}  // namespace hawser::test
