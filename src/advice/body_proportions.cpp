// Implausible bodies: densities and inertia of no material, spring periods that are too short or too long,
// missing weight and water, and excessive accelerations of motions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/count_of.hpp"
#include "hawser/math/so3.hpp"
#include "unit_hint.hpp"

namespace hawser::advice {

using namespace model;

namespace {

class BodyProportions {
 public:
  BodyProportions(const Case& c, const Body& b, std::vector<InputWarning>& out)
      : c_(c), b_(b), key_("bodies." + b.name), out_(out) {}

  void run() {
    if (b_.mass) floating(*b_.mass);
    motion();
  }

 private:
  template <class... Args>
  void warn(const std::string& key, fmt::format_string<Args...> sentence, Args&&... args) {
    add_warning(out_, key_ + "." + key, Effect::all, sentence, std::forward<Args>(args)...);
  }

  void floating(const BodyMass& m) {
    if (m.in_water) in_water(m, *m.in_water);
    inertia(m);
    springs(m);
    weight(m);
    depth(m);
  }

  // Plausible densities, kg/m³: an air bag has 6, a pneumatic fender 90, solid steel 7850.
  void in_water(const BodyMass& m, const BodyInWater& w) {
    constexpr double kLeast = 5, kMost = 12000, kLight = 30;
    const double density = m.mass / w.volume;
    const double size = std::cbrt(w.volume);
    if (density < kLight || density > kMost)
      warn("floating.mass", "{:.4g} kg in a volume of {:.4g} m³ is a density of {:.3g} kg/m³, {}{}", m.mass,
           w.volume, density,
           density < kLeast   ? "lighter than an air bag"
           : density < kLight ? "as light as an air bag: it floats on the water"
                              : "heavier than lead",
           unit_hint(c_, {"bodies", b_.name, "floating", "mass"},
                     [&](double x) { return x > kLight * w.volume && x < kMost * w.volume; }));
    if (const double ratio = w.height / size; ratio < 0.02 || ratio > 50)
      warn("floating.in_water.height", "{:.4g} m is {:.2g} times the side of a cube of its volume, {:.3g} m",
           w.height, ratio, size);
    const double drag = w.drag_area.maxCoeff() / (size * size);
    if (drag > 0 && (drag < 0.01 || drag > 200))
      warn("floating.in_water.drag_area", "{:.3g} m² is {:.2g} times volume^(2/3), {:.3g} m²",
           w.drag_area.maxCoeff(), drag, size * size);
    const double added = w.added_mass.maxCoeff() / (c_.environment.water.density * w.volume);
    if (added > 30)
      warn("floating.in_water.added_mass", "{:.3g} kg is {:.3g} times the water that it displaces",
           w.added_mass.maxCoeff(), added);
  }

  // Radius of gyration relative to that of a steel ball of the same mass, close to the densest possible body;
  // wide frames and ships have about ten times that.
  void inertia(const BodyMass& m) {
    const double ball = std::cbrt(3 * m.mass / (4 * M_PI * 7850));
    const double lower = 0.3 * std::sqrt(0.4) * ball;
    const double upper = 150 * ball;
    const double small = std::sqrt(m.inertia.minCoeff() / m.mass);
    const double large = std::sqrt(m.inertia.maxCoeff() / m.mass);
    if (m.matrix || (small >= lower && large <= upper)) return;
    const double off = small < lower ? small : large;
    warn("floating.inertia",
         "a radius of gyration of {:.2g} m is {} for a body of {:.4g} kg (a steel ball has {:.2g} m): are "
         "mass and inertia in kg and kg m²?",
         off, off == small ? "none" : "too much", m.mass, std::sqrt(0.4) * ball);
  }

  // Natural periods on the body's own springs.
  void springs(const BodyMass& m) {
    constexpr double kShortest = 0.02, kLongest = 3000;  // s
    for (int i = 0; i < 3; ++i) {
      if (!(m.stiffness[i] > 0)) continue;
      const double period = 2 * M_PI * std::sqrt(m.mass / m.stiffness[i]);
      if (period < kShortest || period > kLongest)
        return warn("floating.stiffness",
                    "{:.3g} N/m with a mass of {:.4g} kg gives a natural period of {:.2g} s: is the "
                    "stiffness in N/m?",
                    m.stiffness[i], m.mass, period);
      const double damping = m.damping[i] / (2 * std::sqrt(m.stiffness[i] * m.mass));
      if (damping > 20)
        return warn("floating.damping", "{:.3g} N s/m is {:.3g} times the critical damping of its spring",
                    m.damping[i], damping);
    }
  }

  // For bodies in air or deep in the water.
  void weight(const BodyMass& m) {
    constexpr double kAbove = 5;  // m, above the still water
    const Water& w = c_.environment.water;
    if (!w.present || m.in_water || m.hull || m.hydrodynamics) return;
    const double z = b_.position.z() - w.surface;
    const bool held = m.spring_stiffness().z() > 0;
    if (!m.weight && !held && z > kAbove && c_.environment.gravity > 0)
      warn("floating.weight",
           "is {:.3g} m above the water and has no weight: set 'weight: true' if gravity acts on it", z);
    if (m.weight && z < -kAbove)
      warn("floating",
           "is {:.3g} m below the water surface and has no buoyancy, added mass or drag: add 'in_water' if "
           "water acts on it",
           -z);
  }

  // Of a body that starts in the water, and that no springs hold in the soil, as a suction pile.
  void depth(const BodyMass& m) {
    const Water& w = c_.environment.water;
    const double bottom = w.surface - w.depth;
    if (!w.present || !(w.depth > 0) || b_.ride || b_.position.z() < bottom) return;
    if (m.spring_stiffness().z() > 0 && !m.hydrodynamics && !m.hull) return;
    const double z = (b_.position + exp_so3(b_.rotation) * m.centre).z();
    if (z < bottom)
      warn("floating.centre_of_mass",
           "is at z = {:.4g} m, below the bottom of the water at z = {:.4g} m: is it in metres, and in the "
           "body's frame?",
           z, bottom);
  }

  // Objects on a deck lift off at downward accelerations above g; no vessel exceeds the limit.
  void motion() {
    const double g = c_.environment.gravity > 0 ? c_.environment.gravity : 9.80665;
    if (const auto* h = std::get_if<HarmonicMotion>(&b_.motion)) {
      const double omega = 2 * M_PI / h->period;
      const double a = h->amplitude.norm() * omega * omega;
      if (a > kMostG * g)
        warn("motion.harmonic",
             "an amplitude of {:.3g} m with a period of {:.3g} s is an acceleration of {:.2g} g: is the "
             "amplitude in m and the period in s?",
             h->amplitude.norm(), h->period, a / g);
      drift(g);
      return;
    }
    const auto* t = std::get_if<TableMotion>(&b_.motion);
    if (t && !t->offset.empty()) table(*t, t->of_waves ? "motion.rao" : "motion.table", g);
    drift(g);
  }
  void drift(double g) {
    if (!b_.drift) return;
    const HarmonicMotion& h = b_.drift->harmonic;
    const double omega = 2 * M_PI / h.period;
    const double a = h.amplitude.norm() * omega * omega;
    if (a > kMostG * g)
      warn("motion.drift.harmonic",
           "an amplitude of {:.3g} m with a period of {:.3g} s is an acceleration of {:.2g} g, too large for "
           "a slow drift",
           h.amplitude.norm(), h.period, a / g);
    if (!b_.drift->table.offset.empty()) table(b_.drift->table, "motion.drift.table", g);
  }
  void table(const TableMotion& t, const std::string& key, double g) {
    double fastest = 0, at = 0;
    for (std::size_t i = 1; i < t.time.size(); ++i) {
      const double v = (t.offset[i] - t.offset[i - 1]).norm() / (t.time[i] - t.time[i - 1]);
      if (v > fastest) {
        fastest = v;
        at = t.time[i];
      }
    }
    if (fastest > kMostSpeed)
      return warn(key, "moves at {:.3g} m/s at {:.4g} s: are its columns s and m?", fastest, at);
    double largest = 0;
    for (std::size_t i = 1; i + 1 < t.time.size(); ++i) {
      const double before = t.time[i] - t.time[i - 1];
      const double after = t.time[i + 1] - t.time[i];
      const Vec3 jump = (t.offset[i + 1] - t.offset[i]) / after - (t.offset[i] - t.offset[i - 1]) / before;
      if (const double a = 2 * jump.norm() / (before + after); a > largest) {
        largest = a;
        at = t.time[i];
      }
    }
    if (t.between != BetweenRows::linear && largest > kMostG * g)
      warn(key, "has an acceleration of {:.2g} g at {:.4g} s: are its columns s and m?", largest / g, at);
  }

  static constexpr double kMostG = 2, kMostSpeed = 30;  // g; m/s, 60 knots
  const Case& c_;
  const Body& b_;
  std::string key_;
  std::vector<InputWarning>& out_;
};

bool has_volume(const Case& c, const Body& b) {
  return std::any_of(c.volumes.begin(), c.volumes.end(), [&](const Volume& v) { return v.body == b.name; });
}

// True for a body in the water that no force of the water acts on. A volume may be there for contact in air,
// and a prescribed motion or a table of loads may have the effect of the waves.
bool lacks_water(const Case& c, const Body& b) {
  constexpr double kOrigin = 5;  // m, of a floating body, above or below the still water
  if (!b.mass || b.motion.index() != 0 || b.drift) return false;
  const BodyMass& m = *b.mass;
  if (m.in_water || m.hydrodynamics || m.hull || m.current || !m.members.empty()) return false;
  const auto varies = [](const BodyLoad& load) { return !load.table.empty(); };
  if (std::any_of(m.loads.begin(), m.loads.end(), varies)) return false;
  const double z = b.position.z() - c.environment.water.surface;
  // With weight it hangs above the water, or has a note of its own further below.
  return z <= (m.weight ? 0 : kOrigin) && z >= -kOrigin && !has_volume(c, b);
}

// Once per case.
void warn_of_missing_water(const Case& c, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const auto flows = [](const CurrentRow& row) { return row.speed != 0; };
  const bool current = std::any_of(w.current.profile.begin(), w.current.profile.end(), flows);
  const bool waves = c.dynamics.enabled && !w.waves.none();
  if (!current && !waves) return;
  const Body* first = nullptr;
  long long others = -1;
  for (const Body& b : c.bodies) {
    if (!lacks_water(c, b)) continue;
    if (!first) first = &b;
    ++others;
  }
  if (!first) return;
  add_warning(out, "bodies." + first->name + ".floating", Effect::all,
              "neither waves nor current act on it{}: add 'hydrodynamics', 'hull', 'members', 'in_water' or "
              "'current' if they should",
              others > 0 ? fmt::format(" and {}", count_of(others, "other body", "other bodies")) : "");
}

}  // namespace

void warn_of_bodies(const Case& c, std::vector<InputWarning>& out) {
  for (const Body& b : c.bodies) BodyProportions(c, b, out).run();
  warn_of_missing_water(c, out);
}

}  // namespace hawser::advice
