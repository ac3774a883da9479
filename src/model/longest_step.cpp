// Time scales of a case (waves, prescribed motions, ramps, natural periods of lines and floating bodies,
// drag) and the resulting limit of automatic steps.
#include "hawser/model/longest_step.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/platform_periods.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::model {
namespace {

// Steps in each of these times (docs/theory/time-integration.md#step-length): the period of a prescribed
// motion or a turn; of the waves; a ramp; a natural period of a line or a body with excitation; the time
// constant of drag; the duration; the shortest period of gusts.
constexpr int kStepsInPeriod = 100, kStepsInWaves = 75, kStepsInRamp = 20, kStepsInNaturalPeriod = 20,
              kStepsInDragTime = 10, kStepsInDuration = 50, kStepsInGust = 4;
// Lower bound of the step by natural periods and drag, as a fraction of the step by excitation. The control
// of the local error reduces the step further if necessary.
constexpr double kMinByNaturalPeriods = 0.1, kMinByDrag = 0.5;
// Steps in the natural period of a body without periodic excitation: the period of the scheme is too long by
// 3.47/n² at n steps a period and rho_infinity 0.8, a thousandth here
// (docs/theory/time-integration.md#error-of-the-period). A forced motion has the period of its excitation.
constexpr int kStepsInFreePeriod = 60;

// Keeps the shortest step and its reason.
class Shortest {
 public:
  // time: s. Values that are not finite or not above 0 are ignored.
  void offer(double time, int divisor, const std::string& subject) {
    offer({time / divisor, divisor, subject});
  }
  void offer(const LongestStep& step) {
    if (std::isfinite(step.length) && step.length > 0 && (best_.length == 0 || step.length < best_.length))
      best_ = step;
  }
  const LongestStep& best() const { return best_; }

 private:
  LongestStep best_;
};

// Water velocity for drag, 2 sqrt(sum of (a omega)²) at the surface (the significant amplitude of irregular
// waves, twice the amplitude of regular ones), and T01 = sum of a² over sum of a² f.
struct Sea {
  double speed = 0, period = 0;
};
Sea sea(const Environment& e) {
  if (!e.water.present || e.water.waves.none()) return {};
  double energy = 0, flow = 0, squares = 0;
  const WaveField field = wave_field(e);
  for (const WaveComponent& k : field.components()) {
    energy += k.amplitude * k.amplitude;
    flow += k.amplitude * k.amplitude * k.omega;
    squares += std::pow(k.amplitude * k.omega, 2);
  }
  return flow > 0 ? Sea{2 * std::sqrt(squares), 2 * M_PI * energy / flow} : Sea{};
}

bool moves(const HarmonicMotion& m) { return !m.amplitude.isZero() || !m.rotation_amplitude.isZero(); }

void add_harmonic(const HarmonicMotion& m, const std::string& name, Shortest& to) {
  if (moves(m)) to.offer(m.period, kStepsInPeriod, "the period of " + name);
}

// Largest distance of attached lines and links from the body's origin, m: lever arm of its rotation.
double lever(const Case& c, const Body& b) {
  double out = 0;
  for (const auto& [line, end] : line_ends_at(c, b)) out = std::max(out, end.at.norm());
  for (const Link& l : c.links)
    for (const LinkEnd* e : {&l.end_a, &l.end_b})
      if (e->body == b.name) out = std::max(out, e->at.norm());
  return out;
}

// Mean period of a curve from the second and fourth spectral moments, 2 pi sqrt(m2/m4): the mean period of
// its peaks (Rice 1944); for a sine its period. A steady velocity has no effect.
double mean_period(const RowCurve::Activity& a) {
  return a.second > 0 ? 2 * M_PI * std::sqrt(a.rate / a.second) : 0;
}

// Adds the period of a motion table and returns a speed [m/s], that of a sine with the same root mean square.
double add_table(const TableMotion& m, const std::string& name, double lever, Shortest& to) {
  if (m.of_waves || m.time.size() < 2) return 0;
  const TableLaw law = table_law(m);
  const RowCurve::Activity moved = law.offset.activity();
  const RowCurve::Activity turned = law.rotation.activity();
  const std::string subject = "the mean period of the motion table of " + name;
  if (lever > 0) {
    const double square = lever * lever;
    to.offer(mean_period({moved.rate + square * turned.rate, moved.second + square * turned.second}),
             kStepsInPeriod, subject);
  } else {
    to.offer(mean_period(moved), kStepsInPeriod, subject);
    to.offer(mean_period(turned), kStepsInPeriod, subject);
  }
  return std::sqrt(2 * moved.rate / (m.time.back() - m.time.front()));
}

// Adds the motion of a body and returns the largest speed of its points, m/s.
double add_body(const Case& c, const Body& b, Shortest& to) {
  const std::string name = "body " + b.name;
  double speed = 0;
  if (const auto* h = std::get_if<HarmonicMotion>(&b.motion)) {
    add_harmonic(*h, name, to);
    speed = 2 * M_PI / h->period * h->amplitude.norm();
  } else if (const auto* t = std::get_if<TableMotion>(&b.motion)) {
    speed = add_table(*t, name, lever(c, b), to);
  } else if (const auto* s = std::get_if<ConstantMotion>(&b.motion)) {
    if (s->rate != 0) to.offer(2 * M_PI / std::abs(s->rate), kStepsInPeriod, "a turn of " + name);
    speed = s->velocity.norm();
  }
  if (b.drift) {
    add_harmonic(b.drift->harmonic, name, to);
    speed = std::max(speed, add_table(b.drift->table, name, lever(c, b), to));
  }
  return speed;
}

// Adds a time factor, linear between its rows.
void add_factor(const TimeFactor& factor, const std::string& name, Shortest& to) {
  std::vector<double> time;
  std::vector<Vec3> value;
  for (const auto& [t, f] : factor.rows()) {
    time.push_back(t);
    value.emplace_back(f, 0, 0);
  }
  to.offer(mean_period(RowCurve(time, value, BetweenRows::linear).activity()), kStepsInPeriod,
           "the mean period of the time_factor of " + name);
}

// Adds the time-dependent forces on a body.
void add_loads(const Body& b, Shortest& to) {
  if (!b.mass) return;
  for (const BodyLoad& load : b.mass->loads) {
    if (load.table.empty()) continue;
    std::vector<double> time;
    std::vector<Vec3> force, moment;
    for (const auto& [t, f] : load.table) {
      time.push_back(t);
      force.push_back(f.head<3>());
      moment.push_back(f.tail<3>());
    }
    for (const std::vector<Vec3>& value : {force, moment})
      to.offer(mean_period(RowCurve(time, value, BetweenRows::linear).activity()), kStepsInPeriod,
               "the mean period of a load of body " + b.name);
  }
}

// Axial stiffness [N/m] on a body of lines that are taut at the start, with the other end held.
double taut_stiffness(const Case& c, const Body& b) {
  constexpr double kTaut = 1e-3;  // of its length, by which the chord of a taut line may be shorter
  double sum = 0;
  for (const Line& line : c.lines)
    for (const LineEnd line_end : kLineEnds) {
      const End& end = line.end(line_end);
      if (end.kind != EndKind::body || end.carrier != b.name || !is_held(line.end(opposite(line_end))))
        continue;
      double length = 0, compliance = 0;
      for (const Section& s : line.sections) {
        length += s.length;
        compliance += s.length / c.line_type(s.type).EA;
      }
      const double chord = (end_position(c, line.end_b) - end_position(c, line.end_a)).norm();
      if (chord > (1 - kTaut) * length) sum += 1 / compliance;
    }
  return sum;
}

// Natural periods of bodies with mass: on springs, on taut lines, on links, in the water surface and by the
// coefficients of platforms. driven: there is periodic excitation.
void add_free_bodies(const Case& c, bool driven, Shortest& afloat, Shortest& natural) {
  const auto has_period = [&](Shortest& to, double period, const std::string& name) {
    to.offer(period, driven ? kStepsInNaturalPeriod : kStepsInFreePeriod, "the period of body " + name);
  };
  const auto oscillates = [&](Shortest& to, double mass, double stiffness, const std::string& name) {
    if (stiffness > 0) has_period(to, 2 * M_PI * std::sqrt(mass / stiffness), name);
  };
  for (const Body& b : c.bodies) {
    if (!b.mass) continue;
    oscillates(afloat, b.mass->mass, b.mass->stiffness.maxCoeff(), b.name + " on its springs");
    if (!b.mass->stiffness_matrix.isZero())
      has_period(afloat, modes_on_stiffness_matrix(b).back().period, b.name + " on its stiffness matrix");
    double mass = b.mass->mass;
    if (b.mass->in_water) {
      const BodyInWater& w = *b.mass->in_water;
      mass += w.added_mass.z();
      oscillates(afloat, mass, c.environment.water.density * c.environment.gravity * w.volume / w.height,
                 b.name + " in the surface");
    }
    if (b.mass->hull && !b.mass->hydrodynamics) {
      const Vec3& restoring = b.mass->hull->restoring;
      oscillates(afloat, mass, restoring[0], b.name + " in heave");
      oscillates(afloat, b.mass->inertia.x(), restoring[1], b.name + " in roll");
      oscillates(afloat, b.mass->inertia.y(), restoring[2], b.name + " in pitch");
    }
    if (b.mass->hydrodynamics) {
      const PlatformPeriods periods = platform_periods(c, b);
      has_period(afloat, periods.heave, b.name + " in heave");
      has_period(afloat, periods.roll, b.name + " in roll");
      has_period(afloat, periods.pitch, b.name + " in pitch");
    }
    // With excitation the motion follows such a line as if it were a bar.
    if (!driven) oscillates(natural, mass, taut_stiffness(c, b), b.name + " on its lines");
  }
  for (const Link& l : c.links)
    for (const LinkEnd* e : {&l.end_a, &l.end_b})
      if (const int body = c.body_index(e->body); c.floats(body))
        oscillates(natural, c.bodies[body].mass->mass, l.law.max_stiffness(), e->body + " on link " + l.name);
}

// Adds the initial rotation of bodies with mass.
void add_spin(const Case& c, Shortest& to) {
  for (const Body& b : c.bodies)
    if (b.mass)
      to.offer(2 * M_PI / b.mass->angular_velocity.norm(), kStepsInPeriod,
               "a turn of body " + b.name + " with the velocity that it begins with");
}

void add_drag_of_body(const Body& b, const Environment& e, double speed, Shortest& drags) {
  if (!b.mass || !b.mass->in_water) return;
  const BodyInWater& w = *b.mass->in_water;
  const double drag = 0.5 * e.water.density * w.drag_area.maxCoeff() * speed;
  if (drag > 0)
    drags.offer((b.mass->mass + w.added_mass.minCoeff()) / drag, kStepsInDragTime,
                "the time in which drag carries body " + b.name + " along");
}

// Adds a line: its slowest period, the axial wave travel time if it starts with a jump, and drag.
void add_line(const Case& c, const Line& line, double speed, bool jolted, Shortest& natural,
              Shortest& drags) {
  double length = 0, mass = 0, along = 0;
  for (const Section& s : line.sections) {
    const LineType& t = c.line_type(s.type);
    length += s.length;
    mass += s.length * t.mass_per_length;
    along += t.wave_time(s.length);
    if (!c.environment.water.present || speed == 0) continue;
    const double area = 0.25 * M_PI * t.displaced() * t.displaced();
    const double drag = 0.5 * c.environment.water.density * t.Cd_normal * t.dragged() * speed;
    if (drag > 0)
      drags.offer((t.mass_per_length + c.environment.water.density * area * t.Ca_normal) / drag,
                  kStepsInDragTime, "the time in which drag carries line " + line.name + " along");
  }
  if (length == 0 || mass == 0) return;
  natural.offer(slowest_period(c, line), kStepsInNaturalPeriod, "the slowest period of line " + line.name);
  if (jolted)
    natural.offer(2 * along, kStepsInNaturalPeriod,
                  "the time of a wave along line " + line.name + " and back");
}

// Adds the ramps between the speed rows of a feeder.
void add_feed(const End& end, const std::string& line, Shortest& to) {
  if (!end.feed) return;
  const auto& rows = end.feed->speed;
  for (size_t i = 1; i < rows.size(); ++i)
    if (rows[i].second != rows[i - 1].second)
      to.offer(rows[i].first - rows[i - 1].first, kStepsInRamp,
               "a change of speed of the feeder of line " + line);
}

bool fed_at_once(const End& end) {
  return end.feed && !end.feed->speed.empty() && fed_by(*end.feed, 0).speed != 0;
}

void add_ramps(const Case& c, Shortest& to) {
  const Water& w = c.environment.water;
  if (!w.current.profile.empty()) to.offer(w.current.ramp, kStepsInRamp, "the ramp of the current");
  for (const Body& b : c.bodies) {
    to.offer(b.ramp, kStepsInRamp, "the ramp of body " + b.name);
    if (b.drift) to.offer(b.drift->ramp, kStepsInRamp, "the ramp of body " + b.name);
  }
  for (const Line& line : c.lines) {
    for (const auto& l : line.loads) to.offer(l.ramp, kStepsInRamp, "the ramp of a load");
    for (const auto& l : line.point_loads) to.offer(l.ramp, kStepsInRamp, "the ramp of a load");
    for (const End* end : {&line.end_a, &line.end_b}) add_feed(*end, line.name, to);
  }
  for (const Event& e : c.events)
    if (e.action.kind == Action::Kind::feed)
      to.offer(e.action.ramp, kStepsInRamp, "the ramp of a feeder of line " + e.action.line);
}

}  // namespace

double slowest_period(const Case& c, const Line& line) {
  double length = 0, loose = 0, mass = 0, bend = 0, compliance = 0;
  for (const Section& s : line.sections) {
    const LineType& t = c.line_type(s.type);
    loose += s.length * (1 + thermal_strain(t, line, length, length + s.length));
    length += s.length;
    mass += s.length * t.mass_per_length;
    compliance += s.length / t.EA;
    bend += s.length * t.smallest_bending_stiffness();
  }
  if (length == 0 || mass == 0) return 0;
  const bool spans = line.end_a.kind != EndKind::free && line.end_b.kind != EndKind::free;
  // (2.405/2)², 2.405 the first zero of J0 (docs/theory/time-integration.md#slowest-period-of-a-line).
  constexpr double kHangingChain = 1.45;
  const double wave = spans ? M_PI : 1.8751;  // of a beam between hinges, of a cantilever
  double square = kHangingChain * c.environment.gravity / length + std::pow(wave / length, 4) * bend / mass;
  if (is_held(line.end_a) && is_held(line.end_b)) {
    const double chord = (end_position(c, line.end_b) - end_position(c, line.end_a)).norm();
    square += std::pow(M_PI / length, 2) * std::max(chord - loose, 0.0) / compliance / (mass / length);
  }
  return square > 0 ? 2 * M_PI / std::sqrt(square) : 0;
}

LongestStep longest_step(const Case& c) {
  Shortest to, natural, drags;
  const Sea waves = sea(c.environment);
  to.offer(waves.period, kStepsInWaves, "the period of the waves");
  double speed = waves.speed;
  for (const CurrentRow& row : c.environment.water.current.profile) speed = std::max(speed, row.speed);
  for (const Body& b : c.bodies) speed = std::max(speed, add_body(c, b, to));
  for (const Body& b : c.bodies) add_loads(b, to);
  for (const Body& b : c.bodies) add_drag_of_body(b, c.environment, speed, drags);
  // Without excitation, outputs and duration do not limit the steps of free bodies from below.
  Shortest afloat;
  const bool driven_by_motion = to.best().length > 0;
  add_free_bodies(c, driven_by_motion, driven_by_motion ? natural : afloat, natural);
  add_spin(c, afloat);
  add_factor(c.environment.water.current.time_factor, "the current", to);
  add_factor(c.environment.wind.time_factor, "the wind", to);
  if (c.environment.wind.gusts != GustSpectrum::none) {
    const bool blown =
        std::any_of(c.bodies.begin(), c.bodies.end(), [](const Body& b) { return b.mass && b.mass->wind; });
    if (blown) to.offer(1 / kFastestGust, kStepsInGust, "the shortest period of the gusts");
  }
  add_ramps(c, to);
  to.offer(c.output.every, 1, "the time between outputs");
  to.offer(c.dynamics.duration, kStepsInDuration, "the duration");
  const bool jolted = !c.statics.enabled || !velocity_jumps(c.bodies).empty();
  for (const Line& line : c.lines)
    add_line(c, line, speed, jolted || fed_at_once(line.end_a) || fed_at_once(line.end_b), natural, drags);
  const double driven = to.best().length;
  const auto resolve = [&](const LongestStep& step, double min_fraction) {
    if (step.length > 0) to.offer({std::max(step.length, min_fraction * driven), step.divisor, step.subject});
  };
  resolve(natural.best(), kMinByNaturalPeriods);
  resolve(drags.best(), kMinByDrag);
  to.offer(afloat.best());
  return to.best();
}

}  // namespace hawser::model
