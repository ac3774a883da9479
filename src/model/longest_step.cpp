// The time scales of a case (waves, prescribed motions, ramps, natural periods of lines and floating bodies,
// drag) and the longest automatic step that follows from them.
#include "hawser/model/longest_step.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::model {
namespace {

constexpr double kOfPeriod = 100, kOfWaves = 75, kOfRamp = 20, kOfOwn = 20, kOfDrag = 10, kOfDuration = 50;
// What lines do by themselves, and drag, shortens what drives them to no less than this; the local error does
// more.
constexpr double kLeastOwn = 0.1, kLeastDrag = 0.5;
constexpr double kDensest = 0.1;  // of a table's time

// The shortest of what it is told.
class Shortest {
 public:
  void of(double length, const std::string& reason) {
    if (std::isfinite(length) && length > 0 && (best_.length == 0 || length < best_.length))
      best_ = {length, reason};
  }
  const LongestStep& best() const { return best_; }

 private:
  LongestStep best_;
};

// Speed of the water that drag meets, twice the root of the sum of (a omega)² at the surface: the significant
// amplitude of irregular waves, twice the amplitude of regular ones; and T01 = sum of a² over that of a² f,
// of linear components.
struct Sea {
  double speed = 0, period = 0;
};
Sea sea(const Environment& e) {
  const Waves& w = e.water.waves;
  if (!e.water.present || w.kind == Waves::Kind::none) return {};
  double energy = 0, flow = 0, squares = 0;
  const WaveField field = wave_field(e);
  for (const WaveComponent& k : field.components()) {
    energy += k.amplitude * k.amplitude, flow += k.amplitude * k.amplitude * k.omega;
    squares += std::pow(k.amplitude * k.omega, 2);
  }
  return flow > 0 ? Sea{2 * std::sqrt(squares), 2 * M_PI * energy / flow} : Sea{};
}

bool moves(const HarmonicMotion& m) { return !m.amplitude.isZero() || !m.rotation_amplitude.isZero(); }

void add_harmonic(const HarmonicMotion& m, const std::string& who, Shortest& to) {
  if (moves(m)) to.of(m.period / kOfPeriod, "a hundredth of the period of " + who);
}

void add_table(const TableMotion& m, const std::string& who, Shortest& to) {
  if (m.of_waves || m.time.size() < 2) return;
  std::vector<double> rows;
  for (size_t i = 1; i < m.time.size(); ++i) rows.push_back(m.time[i] - m.time[i - 1]);
  std::sort(rows.begin(), rows.end());
  double covered = 0;
  const double enough = kDensest * (m.time.back() - m.time.front());
  for (const double row : rows)
    if ((covered += row) >= enough) return to.of(row, "the rows of the motion table of " + who);
}

// Speed of a body's points by its own motion, m/s.
double add_body(const Body& b, Shortest& to, Shortest& own) {
  const std::string who = "body " + b.name;
  double speed = 0;
  if (const auto* h = std::get_if<HarmonicMotion>(&b.motion)) {
    add_harmonic(*h, who, to);
    speed = 2 * M_PI / h->period * h->amplitude.norm();
  } else if (const auto* t = std::get_if<TableMotion>(&b.motion)) {
    add_table(*t, who, to);
  } else if (const auto* s = std::get_if<ConstantMotion>(&b.motion)) {
    if (s->rate != 0) to.of(2 * M_PI / std::abs(s->rate) / kOfPeriod, "a hundredth of a turn of " + who);
    speed = s->velocity.norm();
  }
  to.of(b.ramp / kOfRamp, "a twentieth of the ramp of " + who);
  if (b.drift) {
    add_harmonic(b.drift->harmonic, who, to), add_table(b.drift->table, who, to);
    to.of(b.drift->ramp / kOfRamp, "a twentieth of the ramp of " + who);
  }
  if (b.mass && b.mass->stiffness.maxCoeff() > 0)
    own.of(2 * M_PI * std::sqrt(b.mass->mass / b.mass->stiffness.maxCoeff()) / kOfOwn,
           "a twentieth of the period of " + who + " on its springs");
  return speed;
}

// A body that floats, and drag on it.
void add_in_water(const Body& b, const Environment& e, double speed, Shortest& own, Shortest& drags) {
  if (!b.mass || !b.mass->in_water) return;
  const BodyInWater& w = *b.mass->in_water;
  const double rho = e.water.density, per_height = rho * e.gravity * w.volume / w.height;
  own.of(2 * M_PI * std::sqrt((b.mass->mass + w.added_mass.z()) / per_height) / kOfOwn,
         "a twentieth of the period of body " + b.name + " in the surface");
  const double drag = 0.5 * rho * w.drag_area.maxCoeff() * speed;
  if (drag > 0)
    drags.of((b.mass->mass + w.added_mass.minCoeff()) / drag / kOfDrag,
             "a tenth of the time in which drag carries body " + b.name + " along");
}

// Its slowest period, the time of a wave along it where something jolts it, and drag.
void add_line(const Case& c, const Line& line, double speed, bool jolted, Shortest& own, Shortest& drags) {
  double length = 0, mass = 0, along = 0;
  for (const Section& s : line.sections) {
    const LineType& t = c.line_type(s.type);
    length += s.length, mass += s.length * t.mass_per_length;
    along += s.length * std::sqrt(t.mass_per_length / t.EA);
    if (!c.environment.water.present || speed == 0) continue;
    const double area = 0.25 * M_PI * t.displaced() * t.displaced(),
                 drag = 0.5 * c.environment.water.density * t.Cd_normal * t.dragged() * speed;
    if (drag > 0)
      drags.of((t.mass_per_length + c.environment.water.density * area * t.Ca_normal) / drag / kOfDrag,
               "a tenth of the time in which drag carries line " + line.name + " along");
  }
  if (length == 0 || mass == 0) return;
  own.of(slowest_period(c, line) / kOfOwn, "a twentieth of the slowest period of line " + line.name);
  if (jolted)
    own.of(2 * along / kOfOwn, "a twentieth of the time of a wave along line " + line.name + " and back");
}

// Bodies on springs between two points.
void add_links(const Case& c, Shortest& own) {
  for (const Link& l : c.links)
    for (const LinkEnd* e : {&l.end_a, &l.end_b})
      if (const int body = c.body_index(e->body); c.floats(body))
        own.of(2 * M_PI * std::sqrt(c.bodies[body].mass->mass / l.law.most_stiffness()) / kOfOwn,
               "a twentieth of the period of body " + e->body + " on link " + l.name);
}

// Changes of its speed, where it goes by a table.
void add_feed(const End& end, const std::string& line, Shortest& to) {
  if (!end.feed) return;
  const auto& rows = end.feed->speed;
  for (size_t i = 1; i < rows.size(); ++i)
    if (rows[i].second != rows[i - 1].second)
      to.of((rows[i].first - rows[i - 1].first) / kOfRamp,
            "a twentieth of a change of speed of the feeder of line " + line);
}

bool fed_at_once(const End& end) {
  return end.feed && !end.feed->speed.empty() && fed_by(*end.feed, 0).speed != 0;
}

void add_ramps(const Case& c, Shortest& to) {
  const Water& w = c.environment.water;
  if (!w.current.profile.empty()) to.of(w.current.ramp / kOfRamp, "a twentieth of the ramp of the current");
  for (const Line& line : c.lines) {
    for (const auto& l : line.loads) to.of(l.ramp / kOfRamp, "a twentieth of the ramp of a load");
    for (const auto& l : line.point_loads) to.of(l.ramp / kOfRamp, "a twentieth of the ramp of a load");
    for (const End* end : {&line.end_a, &line.end_b}) add_feed(*end, line.name, to);
  }
  for (const Event& e : c.events)
    if (e.action.kind == Action::Kind::feed)
      to.of(e.action.ramp / kOfRamp, "a twentieth of the ramp of a feeder of line " + e.action.line);
}

}  // namespace

double slowest_period(const Case& c, const Line& line) {
  double length = 0, loose = 0, mass = 0, bend = 0, give = 0;
  for (const Section& s : line.sections) {
    const LineType& t = c.line_type(s.type);
    loose += s.length * (1 + thermal_strain(t, line, length, length + s.length));
    length += s.length, mass += s.length * t.mass_per_length, give += s.length / t.EA;
    bend += s.length * (t.kind == LineKind::beam ? std::min(t.EI2, t.EI3) : 0.0);
  }
  if (length == 0 || mass == 0) return 0;
  const bool spans = line.end_a.kind != EndKind::free && line.end_b.kind != EndKind::free;
  const double wave = spans ? M_PI : 1.8751;  // of a beam between hinges, of a cantilever
  double square = 1.45 * c.environment.gravity / length + std::pow(wave / length, 4) * bend / mass;
  if (is_held(line.end_a) && is_held(line.end_b)) {
    const double chord = (end_position(c, line.end_b) - end_position(c, line.end_a)).norm();
    square += std::pow(M_PI / length, 2) * std::max(chord - loose, 0.0) / give / (mass / length);
  }
  return square > 0 ? 2 * M_PI / std::sqrt(square) : 0;
}

LongestStep longest_step(const Case& c) {
  Shortest to, own, drags;
  const Sea waves = sea(c.environment);
  to.of(waves.period / kOfWaves, "a seventy-fifth of the period of the waves");
  double speed = waves.speed;
  for (const CurrentRow& row : c.environment.water.current.profile) speed = std::max(speed, row.speed);
  for (const Body& b : c.bodies) speed = std::max(speed, add_body(b, to, own));
  for (const Body& b : c.bodies) add_in_water(b, c.environment, speed, own, drags);
  add_links(c, own);
  add_ramps(c, to);
  to.of(c.output.every, "the time between outputs");
  to.of(c.dynamics.duration / kOfDuration, "a fiftieth of the duration");
  const bool jolted = !c.statics.enabled || !velocity_jumps(c.bodies).empty();
  for (const Line& line : c.lines)
    add_line(c, line, speed, jolted || fed_at_once(line.end_a) || fed_at_once(line.end_b), own, drags);
  const double driven = to.best().length;
  const auto follow = [&](const LongestStep& what, double least) {
    if (what.length > 0) to.of(std::max(what.length, least * driven), what.reason);
  };
  follow(own.best(), kLeastOwn), follow(drags.best(), kLeastDrag);
  return to.best();
}

}  // namespace hawser::model
