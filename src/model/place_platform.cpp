// Placement of the objects of a platform file by x = p + R y, with R a rotation by the heading about z, and
// their new names. Rotation vectors in space axes transform as vectors, R exp(psi) R^T = exp(R psi);
// therefore the motion x = x0 + d + D u, Q = D exp(psi) Q0 transforms by R x0 + p, R d, R u, R psi and R Q0.
#include "hawser/model/place_platform.hpp"

#include <cmath>
#include <complex>

#include "hawser/math/heading.hpp"
#include "hawser/model/bed.hpp"

namespace hawser::model {
namespace {

constexpr double kOnBed =
    0.01;  // m: of an anchor of a link above the bed that it is on, as places are written

class Placing {
 public:
  Placing(const Case& platform, const Seabed& bed, const FarmPlace& place, Case& to)
      : from_(platform),
        bed_(bed),
        place_(place),
        to_(to),
        turn_(heading_rotation(place.heading)),
        turned_(place.heading != 0) {}

  void run() {
    for (const Body& b : from_.bodies) to_.bodies.push_back(placed(b));
    const std::size_t first = to_.volumes.size();
    for (const Volume& v : from_.volumes) to_.volumes.push_back(placed(v));
    for (const SupportBox& b : from_.supports) {
      SupportBox& o = to_.supports.emplace_back(b);
      o.name = name(b.name);
      o.key = placed_key(place_, b.key);
      o.body = carrier(b.body);
      o.line = name(b.line);
      o.first += first;
    }
    for (const Joint& j : from_.joints) {
      Joint& o = to_.joints.emplace_back(j);
      o.name = name(j.name);
      o.start = point(j.start);
    }
    for (const Line& l : from_.lines) to_.lines.push_back(placed(l));
    for (const Link& l : from_.links) {
      Link& o = to_.links.emplace_back(l);
      o.name = name(l.name);
      for (LinkEnd* e : {&o.end_a, &o.end_b}) {
        if (e->body.empty() && e->line.empty()) e->at = on_bed(e->at, kOnBed);
        rename(e->body);
        rename(e->line);
      }
    }
    if (fixed_) {
      Body& b = to_.bodies.emplace_back();
      b.name = place_.name;
      b.position = point(Vec3::Zero());
      b.rotation = place_.heading * Vec3::UnitZ();
    }
  }

 private:
  std::string name(const std::string& name_in_file) const { return placed_name(place_, name_in_file); }
  void rename(std::string& name_in_file) const {
    if (!name_in_file.empty()) name_in_file = name(name_in_file);
  }
  // Name of the body that carries objects on body `name_in_file` or, if that is empty, fixed in space.
  std::string carrier(const std::string& name_in_file) {
    if (!name_in_file.empty()) return name(name_in_file);
    fixed_ = true;
    return place_.name;
  }

  Vec3 turned(const Vec3& d) const { return turned_ ? Vec3(turn_ * d) : d; }
  Vec3 point(const Vec3& x) const { return turned(x) + Vec3(place_.x, place_.y, 0); }
  // Position of a point; one up to `reach` [m] above the bed of the file keeps its height above the bed.
  Vec3 on_bed(const Vec3& x, double reach) const {
    Vec3 out = point(x);
    const Seabed& bed = to_.environment.seabed;
    if (!bed_.present || !bed.present || height_above_bed(bed_, x) > reach) return out;
    out.z() = x.z() - below_on_bed(bed_, x).z() + below_on_bed(bed, out).z();
    return out;
  }

  // amplitude sin(w t + phase), by component, as the imaginary part of rotated complex amplitudes.
  void turn(Vec3& amplitude, Vec3& phase) const {
    if (!turned_) return;
    const Eigen::Vector2cd a(amplitude.x() * std::polar(1.0, phase.x()),
                             amplitude.y() * std::polar(1.0, phase.y()));
    const double c = std::cos(place_.heading);
    const double s = std::sin(place_.heading);
    const std::complex<double> x = c * a.x() - s * a.y();
    const std::complex<double> y = s * a.x() + c * a.y();
    amplitude.head<2>() = Eigen::Vector2d(std::abs(x), std::abs(y));
    phase.head<2>() = Eigen::Vector2d(std::arg(x), std::arg(y));
  }
  void turn(HarmonicMotion& m) const {
    turn(m.amplitude, m.phase);
    turn(m.rotation_amplitude, m.rotation_phase);
  }
  void turn(TableMotion& m) const {
    for (Vec3& x : m.offset) x = turned(x);
    for (Vec3& x : m.rotation) x = turned(x);
  }
  void turn(ConstantMotion& m) const {
    m.velocity = turned(m.velocity);
    m.axis = turned(m.axis);
  }
  void turn(std::monostate&) const {}

  // Rotates springs or dampers along x, y and z.
  void turn_springs(Vec3& k, const std::string& body, const char* key) const {
    if (k.x() == k.y()) return;
    const double quarters = place_.heading / (M_PI / 2);
    if (std::abs(quarters - std::round(quarters)) > 1e-9)
      to_.refuse("bodies." + name(body) + ".floating." + key,
                 "{:g} along x and {:g} along y cannot be turned by the heading of {}, {:g} deg: make both "
                 "the same, or the heading a multiple of 90 deg",
                 k.x(), k.y(), place_.name, place_.heading * 180 / M_PI);
    if (std::llround(quarters) % 2 != 0) std::swap(k.x(), k.y());
  }

  Body placed(const Body& body) const {
    Body b = body;
    b.name = name(body.name);
    if (b.ride) b.ride->line = name(body.ride->line);
    if (!body.ride || body.ride->placed_in_space) {
      b.position = point(b.position);
      if (turned_) b.rotation = log_so3(turn_ * exp_so3(b.rotation));
    }
    std::visit([this](auto& m) { turn(m); }, b.motion);
    if (b.drift && turned_) {
      b.drift->offset = turned(b.drift->offset);
      b.drift->rotation = turned(b.drift->rotation);
      turn(b.drift->harmonic);
      turn(b.drift->table);
    }
    if (body.mass) place_mass(body, b.mass);
    return b;
  }

  // Changes only what differs, because all places share the rest.
  void place_mass(const Body& body, Shared<BodyMass>& mass) const {
    const BodyMass& given = *body.mass;
    if (turned_) {
      mass->velocity = turned(given.velocity);
      turn_springs(mass->stiffness, body.name, "stiffness");
      turn_springs(mass->damping, body.name, "damping");
    }
    const auto move = [this](auto& x) {
      if (x.place) x.place = point(*x.place);
      if (x.heading) *x.heading += place_.heading;
    };
    if (given.hydrodynamics && (given.hydrodynamics->place || given.hydrodynamics->heading))
      move(*mass->hydrodynamics);
    if (given.positioning && (given.positioning->place || given.positioning->heading))
      move(*mass->positioning);
    if (given.hull)
      for (std::string& volume : mass->hull->volumes) rename(volume);
  }

  Volume placed(const Volume& volume) {
    Volume v = volume;
    v.name = name(volume.name);
    v.body = carrier(volume.body);
    return v;
  }

  End placed(const End& end, double reach) const {
    End e = end;
    if (e.kind == EndKind::anchor) e.at = on_bed(e.at, reach);
    if (e.kind == EndKind::joint) e.at = point(e.at);
    if (e.direction && e.kind != EndKind::body) e.direction = turned(*e.direction);
    rename(e.carrier);
    return e;
  }

  Line placed(const Line& line) const {
    Line l = line;
    const double reach = laying_reach(from_, line);
    l.name = name(line.name);
    l.end_a = placed(line.end_a, reach);
    l.end_b = placed(line.end_b, reach);
    for (Vec3& x : l.points) x = on_bed(x, reach);
    if (l.previous_shape) {
      PreviousShape shape = *l.previous_shape;
      for (Vec3& x : shape.position) x = point(x);
      for (Quat& q : shape.rotation) q = turn_ * q;
      l.previous_shape = std::make_shared<const PreviousShape>(std::move(shape));
    }
    return l;
  }

  const Case& from_;
  const Seabed& bed_;
  const FarmPlace& place_;
  Case& to_;
  const Quat turn_;
  const bool turned_;
  bool fixed_ = false;  // the file fixes something in space
};

}  // namespace

void place_platform(const Case& platform, const Seabed& bed, const FarmPlace& place, Case& to) {
  Placing(platform, bed, place, to).run();
}

}  // namespace hawser::model
