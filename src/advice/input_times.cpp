// Time steps and output intervals relative to the motions of the lines, and impacts at t = 0.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/longest_step.hpp"

namespace hawser::advice {

using namespace model;

namespace {

constexpr double kSteps = 20,
                 kOwnSteps = 5;  // minimum per period of the excitation, of the line's slowest motion
constexpr double kOutputs = 2;   // minimum per period
// Acceptable initial speed: fraction of the largest speed of a body, and m/s. A spline through rows that
// begin at rest is not exactly at rest.
constexpr double kJump = 0.05, kLeastJump = 0.05;

struct Period {
  double length = 0;  // s; 0: none
  std::string source;
};

void shorter(Period& shortest, double length, const std::string& source) {
  if (length > 0 && (shortest.length == 0 || length < shortest.length)) shortest = {length, source};
}

// Shortest period of waves (of a spectrum: its peak) and of harmonic motions.
Period driving(const Case& c) {
  Period shortest;
  const Waves& waves = c.environment.water.waves;
  if (!possible(waves)) return shortest;
  for (const WaveSystem& w : waves.systems)
    if (w.irregular())
      shorter(shortest, w.peak_period, "the waves");
    else if (w.kind != WaveSystem::Kind::components)
      shorter(shortest, w.rows.front().period, "the wave");
  for (const Body& b : c.bodies) {
    const auto* h = std::get_if<HarmonicMotion>(&b.motion);
    if (h && !(h->amplitude.isZero() && h->rotation_amplitude.isZero()))
      shorter(shortest, h->period, "the motion of body " + b.name);
  }
  return shortest;
}

// True if a line is a short, stiff member of a frame, whose slow vibration is that of the frame.
bool is_member(const Case& c, const Line& line) {
  const auto rigid = [&](const End& e) { return e.kind == EndKind::joint && c.joint(e.carrier).rigid; };
  return rigid(line.end_a) || rigid(line.end_b);
}

void warn_of_step(const Case& c, const Period& drive, std::vector<InputWarning>& out) {
  const double step = c.dynamics.step;
  if (!(step > 0)) return;
  if (drive.length > 0 && step > drive.length / kSteps) {
    add_warning(out, "dynamics.step", Effect::resolution,
                "{:g} s is {:.2g} steps in a period of {} ({:g} s); usual is {:g} or more", step,
                drive.length / step, drive.source, drive.length, kSteps);
    return;
  }
  Period natural;
  for (const Line& line : c.lines)
    if (!is_member(c, line)) shorter(natural, slowest_period(c, line), "line " + line.name);
  if (natural.length > 0 && step > natural.length / kOwnSteps)
    add_warning(out, "dynamics.step", Effect::resolution,
                "{:g} s is {:.2g} steps in the longest natural period of {} (about {:.2g} s): the steps "
                "resolve none of its vibrations",
                step, natural.length / step, natural.source, natural.length);
}

void warn_of_outputs(const Case& c, const Period& drive, std::vector<InputWarning>& out) {
  const double every = c.output.every;
  if (every > c.dynamics.duration)
    add_warning(out, "output.every", Effect::resolution,
                "{:g} s is longer than the run ({:g} s): output is written at its start and its end only",
                every, c.dynamics.duration);
  else if (drive.length > 0 && every > drive.length / kOutputs)
    add_warning(out, "output.every", Effect::resolution,
                "{:g} s is {:.2g} outputs in a period of {} ({:g} s), too few to show it; usual is 10 or "
                "more (histories have every step)",
                every, drive.length / every, drive.source, drive.length);
}

// Largest speed of a body's origin and the line ends attached to it [m/s].
double speed_at(const std::vector<EndAtBody>& ends, const RigidMotion& motion, double t) {
  const RigidPose p = motion.at(t);
  double largest = p.velocity.norm();
  for (const EndAtBody& e : ends) largest = std::max(largest, p.velocity_at(p.to_space(e.end.at)).norm());
  return largest;
}

// Speed at which a motion begins at t = 0 [m/s]; 0 if small relative to the later motion.
double jump(const Case& c, const Body& b, const std::vector<EndAtBody>& ends) {
  const RigidMotion motion = rigid_motion(b);
  const double first = speed_at(ends, motion, 0);
  if (!(first > kLeastJump)) return 0;
  constexpr int kSamples = 200;
  double largest = 0;
  for (int i = 1; i <= kSamples; ++i)
    largest = std::max(largest, speed_at(ends, motion, c.dynamics.duration * i / kSamples));
  return first > kJump * largest ? first : 0;
}

bool always_jumps(const TableMotion& t) { return t.between == BetweenRows::linear && !t.time.empty(); }

StartSpeeds start_speeds_of(const Case& c, const Body& b, const std::vector<EndAtBody>& ends) {
  StartSpeeds out;
  if (b.mass || b.ride || !c.statics.enabled) return out;
  // Linear interpolation jumps at all rows, and rows of waves include their ramp.
  const auto* table = std::get_if<TableMotion>(&b.motion);
  if (b.motion.index() != 0 && b.ramp == 0 && !(table && (always_jumps(*table) || table->of_waves))) {
    Body alone = b;
    alone.drift.reset();
    out.motion = jump(c, alone, ends);
  }
  if (b.drift && b.drift->ramp == 0 && !always_jumps(b.drift->table)) {
    Body alone = b;
    alone.motion = {};
    out.drift = jump(c, alone, ends);
  }
  return out;
}

}  // namespace

std::vector<StartSpeeds> start_speeds(const Case& c) {
  std::vector<StartSpeeds> out;
  const std::vector<std::vector<EndAtBody>> ends = line_ends_by_body(c);
  for (size_t b = 0; b < ends.size(); ++b) out.push_back(start_speeds_of(c, c.bodies[b], ends[b]));
  return out;
}

std::string initial_velocity_key(const Case& c) {
  const std::vector<StartSpeeds> speeds = start_speeds(c);
  for (size_t b = 0; b < speeds.size(); ++b)
    if (speeds[b].motion + speeds[b].drift > 0)
      return fmt::format("bodies.{}.{}", c.bodies[b].name, speeds[b].motion > 0 ? "motion" : "motion.drift");
  return "";
}

namespace {

void warn_of_start(const Body& b, const StartSpeeds& speed, std::vector<InputWarning>& out) {
  const auto warn = [&](double first, const char* key) {
    if (first > 0)
      add_warning(out, fmt::format("bodies.{}.{}", b.name, key), Effect::part,
                  "starts at t = 0 with {:.3g} m/s, which is an impact on the lines at rest; add a 'ramp' of "
                  "some periods",
                  first);
  };
  warn(speed.motion, "motion");
  warn(speed.drift, "motion.drift");
}

}  // namespace

void warn_of_releases(const Case& c, std::vector<InputWarning>& out) {
  for (std::size_t i = 0; i < c.events.size(); ++i) {
    const Action& r = c.events[i].action;
    if (r.kind != Action::Kind::release) continue;
    const Line& line = c.lines[c.line_index(r.line)];
    const Section& end = line.end_section(r.line_end);
    if (c.line_type(end.type).stiffness_damping > 0) continue;
    add_warning(out, fmt::format("events[{}]", i), Effect::part,
                "line type {} has no 'stiffness_damping': after the release its last elements vibrate "
                "undamped, with speeds and forces that depend on the time step; give it about 0.001 s",
                end.type);
  }
}

namespace {

// A jump v of a feeder's speed strains the element at its feed point, whose damper then pulls with v beta
// EA/l: more for shorter elements.
void warn_of_feed(const Case& c, const std::string& line, LineEnd line_end, double jump,
                  const std::string& key, const char* remedy, std::vector<InputWarning>& out) {
  const Line& line_of_end = c.lines[c.line_index(line)];
  const LineType& type = c.line_type(line_of_end.end_section(line_end).type);
  if (!(std::abs(jump) > kLeastJump) || !(type.stiffness_damping > 0)) return;
  add_warning(out, key, Effect::part,
              "the speed jumps by {:.3g} m/s, and line type {} has 'stiffness_damping': the peak of "
              "tension that this makes depends on the length of elements; {} starts it smoothly",
              std::abs(jump), type.name, remedy);
}

void warn_of_feeds(const Case& c, std::vector<InputWarning>& out) {
  const auto starts = [](const Feed& f) {
    return f.tension == 0 && !f.speed.empty() ? f.speed.front().second : 0.0;
  };
  for (const Line& line : c.lines)
    for (const LineEnd line_end : kLineEnds)
      if (const auto& feed = line.end(line_end).feed; feed && c.statics.enabled) {
        const double first = fed_by(*feed, 0).speed;
        warn_of_feed(c, line.name, line_end, feed->tension == 0 ? first : 0,
                     fmt::format("lines.{}.{}.feed", line.name, end_key(line_end)),
                     fmt::format("'speed_table: [[0, 0], [2, {:g}]]'", first).c_str(), out);
      }
  for (std::size_t i = 0; i < c.events.size(); ++i) {
    const Action& a = c.events[i].action;
    if (a.kind == Action::Kind::feed && a.ramp == 0)
      warn_of_feed(c, a.line, a.line_end, starts(a.law), fmt::format("events[{}]", i), "a 'ramp' of 2 s",
                   out);
  }
}

}  // namespace

void warn_of_times(const Case& c, std::vector<InputWarning>& out) {
  if (!c.dynamics.enabled) return;
  warn_of_releases(c, out);
  warn_of_feeds(c, out);
  const Period drive = driving(c);
  warn_of_step(c, drive, out);
  warn_of_outputs(c, drive, out);
  const std::vector<StartSpeeds> speeds = start_speeds(c);
  for (std::size_t b = 0; b < speeds.size(); ++b) warn_of_start(c.bodies[b], speeds[b], out);
}

}  // namespace hawser::advice
