#include "hawser/model/longest_step.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/model/wave_components.hpp"

namespace hawser::model {
namespace {

constexpr double kOfPeriod = 100, kOfRamp = 20, kOfOwn = 20, kOfDrag = 10, kOfDuration = 50;

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

// Water's speed and T01 = sum of a² over that of a² f, of linear components.
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
  for (size_t i = 1; i < m.time.size(); ++i)
    to.of(m.time[i] - m.time[i - 1], "the rows of the motion table of " + who);
}

// Speed of a body's points by its own motion, m/s.
double add_body(const Body& b, Shortest& to) {
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
    to.of(2 * M_PI * std::sqrt(b.mass->mass / b.mass->stiffness.maxCoeff()) / kOfOwn,
          "a twentieth of the period of " + who + " on its springs");
  return speed;
}

// Slowest period of a line, from its weight as a hanging chain (2.405/2 sqrt(g/L)), its bending stiffness
// (pi²/L² sqrt(EI/m)) and the tension of a start that is shorter than its chord (pi/L sqrt(T/m)).
void add_line(const Case& c, const Line& line, double speed, Shortest& to) {
  double length = 0, mass = 0, bend = 0, give = 0;
  for (const Section& s : line.sections) {
    const LineType& t = c.line_type(s.type);
    length += s.length, mass += s.length * t.mass_per_length;
    bend += s.length * (t.kind == LineKind::beam ? std::min(t.EI2, t.EI3) : 0.0);
    give += s.length / t.EA;
    if (!c.environment.water.present || speed == 0) continue;
    const double area = 0.25 * M_PI * t.displaced() * t.displaced(),
                 drag = 0.5 * c.environment.water.density * t.Cd_normal * t.dragged() * speed;
    if (drag > 0)
      to.of((t.mass_per_length + c.environment.water.density * area * t.Ca_normal) / drag / kOfDrag,
            "a tenth of the time in which drag carries line " + line.name + " along");
  }
  if (length == 0 || mass == 0) return;
  const double per_length = mass / length;
  double square = 1.45 * c.environment.gravity / length + std::pow(M_PI / length, 4) * bend / mass;
  if (line.end_a.kind == EndKind::anchor && line.end_b.kind == EndKind::anchor) {
    const double tension = ((line.end_b.at - line.end_a.at).norm() - length) / give;
    square += std::pow(M_PI / length, 2) * std::max(tension, 0.0) / per_length;
  }
  if (square > 0)
    to.of(2 * M_PI / std::sqrt(square) / kOfOwn, "a twentieth of the slowest period of line " + line.name);
  for (const auto& l : line.loads) to.of(l.ramp / kOfRamp, "a twentieth of the ramp of a load");
  for (const auto& l : line.point_loads) to.of(l.ramp / kOfRamp, "a twentieth of the ramp of a load");
}

}  // namespace

LongestStep longest_step(const Case& c) {
  Shortest to;
  const Sea waves = sea(c.environment);
  to.of(waves.period / kOfPeriod, "a hundredth of the period of the waves");
  double speed = waves.speed;
  for (const CurrentRow& row : c.environment.water.current.profile) speed = std::max(speed, row.speed);
  for (const Body& b : c.bodies) speed = std::max(speed, add_body(b, to));
  for (const Line& line : c.lines) add_line(c, line, speed, to);
  to.of(c.output.every, "the time between outputs");
  to.of(c.dynamics.duration / kOfDuration, "a fiftieth of the duration");
  return to.best();
}

}  // namespace hawser::model
