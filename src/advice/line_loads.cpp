// Implausible attachments and loads of a line: masses and buoys of no material, negligible or excessive
// loads, targets and feeders that its weight excludes, reversed end directions, ineffective stiffeners, and
// lines that float or lie where their type does not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "unit_hint.hpp"

namespace hawser::advice {

using namespace model;

namespace {

// kg/m³ of objects in water: air bags 5 and more, foam 200 to 700, lead 11340, tungsten 19300.
constexpr double kLightest = 5, kHeaviest = 12000;
constexpr double kMetallic = 10e9, kFibreDensity = 1700;  // Pa, kg/m³
constexpr double kNothing = 1e-4;                         // fraction of the line's weight

double modulus(const LineType& t) { return t.EA / (M_PI / 4 * t.outer_diameter * t.outer_diameter); }
double density(const LineType& t) { return t.mass_per_length / (M_PI / 4 * t.displaced() * t.displaced()); }

class LineLoads {
 public:
  LineLoads(const Case& c, const Line& line, std::vector<InputWarning>& out)
      : c_(c), line_(line), key_("lines." + line.name), out_(out) {
    for (const Section& s : line.sections)
      weight_ += c.environment.gravity * s.length * type(s).mass_per_length;
  }

  void run() {
    for (std::size_t i = 0; i < line_.masses.size(); ++i) mass(line_.masses[i], i);
    for (const PointLoad& p : line_.point_loads) point_load(p);
    for (const DistributedLoad& q : line_.loads) distributed(q);
    for (const LineEnd end : kLineEnds) {
      direction(end);
      bed_end(end);
      feed(end);
    }
    for (std::size_t i = 0; i < line_.bend_stiffeners.size(); ++i) stiffener(line_.bend_stiffeners[i], i);
    target();
  }

 private:
  template <class... Args>
  void warn(const std::string& key, fmt::format_string<Args...> sentence, Args&&... args) {
    add_warning(out_, key_ + "." + key, Effect::all, sentence, std::forward<Args>(args)...);
  }
  const LineType& type(const Section& s) const { return c_.line_type(s.type); }
  const Section& section_at(double arc) const {
    double end = 0;
    for (const Section& s : line_.sections)
      if (arc <= (end += s.length)) return s;
    return line_.sections.back();
  }

  void mass(const PointMass& m, std::size_t i) {
    const Water& w = c_.environment.water;
    const std::string key = fmt::format("masses[{}]", i);
    if (m.volume > 0) {
      const double density = m.mass / m.volume;
      if (density < kLightest || density > kHeaviest)
        return warn(key, "{:.4g} kg in {:.4g} m³ is a density of {:.3g} kg/m³, {}", m.mass, m.volume, density,
                    density < kLightest
                        ? "lighter than any buoy (foam has 200 to 700); is the volume in litres, or "
                          "the mass in t?"
                        : "heavier than lead (11340); are mass and volume in kg and m³?");
    }
    const double up = w.present ? c_.environment.gravity * (w.density * m.volume - m.mass) : 0;
    const LineType& t = type(section_at(m.at));
    const double strength = t.breaking_load > 0 ? t.breaking_load : t.tension_table ? HUGE_VAL : 0.1 * t.EA;
    if (0.5 * std::abs(up) > strength)  // the tensions on both sides together
      return warn(key, "{:.3g} kN {} is more than twice what '{}' can carry there, {:.3g} kN{}",
                  std::abs(up) / 1000, up > 0 ? "of buoyancy" : "of weight", t.name, strength / 1000,
                  t.breaking_load > 0 ? "" : " at a strain of 10 %");
    if (m.drag_area > 0 && m.volume > 0) {
      const double size = std::pow(m.volume, 2.0 / 3);
      const double lower = 0.01;
      const double upper = 50;
      if (const double ratio = m.drag_area / size; ratio < lower || ratio > upper)
        warn(key + ".drag_area", "{:.3g} m² is {:.2g} times volume^(2/3); a ball has 0.6, a plate up to 20",
             m.drag_area, ratio);
    }
  }

  void point_load(const PointLoad& p) {
    const double force = p.force.norm();
    const std::string key = fmt::format("loads[{}].force", p.order);
    if (force > 0 && force < kNothing * weight_)
      return warn(key, "{:.4g} N is {:.1g} of the line's weight and has no visible effect{}", force,
                  force / weight_, force * 1000 >= kNothing * weight_ ? "; is it in kN?" : "");
    const LineType& t = type(section_at(p.at));
    // If both sides carry the load, the larger tension is at least half of it.
    if (t.kind == LineKind::cable && t.breaking_load > 0 && 0.5 * force > t.breaking_load)
      return warn(key, "{:.4g} kN is more than twice the breaking load of '{}', {:.4g} kN", force / 1000,
                  t.name, t.breaking_load / 1000);
    if (force > 0.5 * t.EA && !t.tension_table)
      warn(key, "{:.4g} kN is more than half the EA of '{}', {:.4g} kN", force / 1000, t.name, t.EA / 1000);
    const double curvature = 2 * p.moment.norm() / (t.EI2 + t.EI3);
    if (t.kind == LineKind::beam && !t.moment_table && !t.plastic_bending && curvature * t.outer_diameter > 1)
      warn(fmt::format("loads[{}].moment", p.order),
           "{:.4g} N m bends '{}' to a radius of {:.2g} m, within its own diameter", p.moment.norm(), t.name,
           1 / curvature);
  }

  void distributed(const DistributedLoad& q) {
    const double load = q.per_length.norm();
    const LineType& t = type(section_at(std::max(q.from, 0.0)));
    const double weight = t.mass_per_length * c_.environment.gravity;
    if (!(load > 0) || !(weight > 0) || (load > kNothing * weight && load < 500 * weight)) return;
    warn(fmt::format("loads[{}].per_length", q.order),
         "{:.3g} N/m is {:.1g} times the weight of '{}', {:.3g} N/m{}", load, load / weight, t.name, weight,
         load < weight && load * 1000 > kNothing * weight ? "; is it in kN/m?" : "");
  }

  // Directions are from end A to end B, the mean direction of the line.
  void direction(LineEnd end) {
    const End& e = line_.end(end);
    if (!e.direction || !line_.starts_by_itself() || !is_held(line_.end_a) || !is_held(line_.end_b)) return;
    Vec3 along = *e.direction;
    if (e.kind == EndKind::body) along = exp_body(e) * along;
    const Vec3 chord = end_position(c_, line_.end_b) - end_position(c_, line_.end_a);
    if (!(chord.norm() > 0) || along.dot(chord.normalized()) > -0.5) return;  // 120 degrees
    warn(fmt::format("{}.direction", end_key(end)),
         "points {:.0f} degrees away from the line between the ends; a direction is that from end A to end "
         "B: is it reversed?",
         std::acos(std::clamp(along.dot(chord.normalized()), -1.0, 1.0)) * 180 / M_PI);
  }
  Mat3 exp_body(const End& e) const {
    const Body& body = c_.bodies[static_cast<std::size_t>(c_.body_index(e.carrier))];
    return exp_so3(body.rotation).toRotationMatrix();
  }

  // A line anchored on the bed should be heavy there.
  void bed_end(LineEnd end) {
    const Seabed& bed = c_.environment.seabed;
    const End& e = line_.end(end);
    const End& other = line_.end(opposite(end));
    if (!bed.present || e.kind != EndKind::anchor || !is_held(other) || !line_.starts_by_itself()) return;
    const double near = laying_reach(c_, line_);
    if (!(std::abs(height_above_bed(bed, e.at)) < near) ||
        !(height_above_bed(bed, end_position(c_, other)) > 10 * near))
      return;
    const LineType& low = type(line_.end_section(end));
    const LineType& high = type(line_.end_section(opposite(end)));
    const std::string key = end_key(end);
    const bool fibre = density(low) < kFibreDensity && modulus(low) < kMetallic;
    if (fibre && density(high) > 3 * density(low) && modulus(high) > kMetallic && low.name != high.name)
      return warn(key,
                  "'{}' lies on the seabed and the heavier '{}' is at the upper end: are the ends swapped?",
                  low.name, high.name);
    const double floats = c_.environment.water.density * M_PI / 4 * low.displaced() * low.displaced();
    if (c_.environment.water.present && modulus(low) > kMetallic && low.mass_per_length < floats)
      warn(key,
           "'{}' is anchored on the seabed and floats: its mass is {:.4g} kg/m and it displaces {:.4g} kg/m "
           "of water",
           low.name, low.mass_per_length, floats);
  }

  void feed(LineEnd end) {
    const End& e = line_.end(end);
    if (!e.feed || !(e.feed->tension > 0)) return;
    const LineType& t = type(line_.end_section(end));
    const std::string key = fmt::format("{}.feed.tension", end_key(end));
    if (e.feed->tension < 1e-3 * weight_)
      warn(key, "{:.4g} N is {:.1g} of the line's weight{}", e.feed->tension, e.feed->tension / weight_,
           unit_hint(c_, {"lines", line_.name, end_key(end), "feed", "tension"},
                     [&](double x) { return x > 1e-3 * weight_ && x < 0.02 * t.EA; }));
    else if (t.breaking_load > 0 && e.feed->tension > t.breaking_load)
      warn(key, "{:.4g} kN is more than the breaking load of '{}', {:.4g} kN", e.feed->tension / 1000, t.name,
           t.breaking_load / 1000);
  }

  void stiffener(const BendStiffener& s, std::size_t i) {
    const LineType& t = type(section_at(s.at));
    const double bare = 0.5 * (t.EI2 + t.EI3);
    double largest = 0;
    for (const auto& [at, EI] : s.rows) largest = std::max(largest, EI);
    const std::string key = fmt::format("bend_stiffeners[{}].EI", i);
    if (largest < 0.1 * bare)
      warn(key, "it adds {:.3g} N m² at most to the {:.3g} N m² of '{}': are they N m²?", largest, bare,
           t.name);
    else if (largest > 0.1 * t.EA)  // of a diameter of metres
      warn(key, "it adds {:.3g} N m², {:.2g} times the EI of '{}': are they N m²?", largest, largest / bare,
           t.name);
    else if (s.rows.back().second > 2 * s.rows.front().second)
      warn(key, "it is stiffer at its tip than at its root; rows count from the root, which is at {:.6g} m",
           s.at);
  }

  // The tension at the higher end includes at least the weight between the heights of the ends.
  void target() {
    if (!line_.target || line_.target->kind != LengthTarget::Kind::tension) return;
    const LineEnd end = line_.target->line_end;
    const LineEnd other = opposite(end);
    const double tension = line_.target->value;
    const LineType& t = type(line_.end_section(end));
    if (t.breaking_load > 0 && tension > t.breaking_load)
      return warn("target.tension", "{:.4g} kN is more than the breaking load of '{}', {:.4g} kN",
                  tension / 1000, t.name, t.breaking_load / 1000);
    if (!is_held(line_.end(end)) || !is_held(line_.end(other))) return;
    double height = end_position(c_, line_.end(end)).z() - end_position(c_, line_.end(other)).z();
    const Seabed& bed = c_.environment.seabed;
    if (bed.present) height = std::min(height, height_above_bed(bed, end_position(c_, line_.end(end))));
    double smallest = HUGE_VAL;
    for (const Section& s : line_.sections)
      smallest = std::min(smallest, mass_in_water(c_, type(s), -HUGE_VAL));
    const double hangs = smallest * c_.environment.gravity * height;
    if (hangs > 0 && tension < 0.99 * hangs)
      warn("target.tension",
           "{:.4g} kN is less than the smallest weight that hangs from that end, {:.4g} kN{}", tension / 1000,
           hangs / 1000, unit_hint(c_, {"lines", line_.name, "target", "tension"}, [&](double x) {
             return x > hangs && x < 0.05 * t.EA;
           }));
  }

  const Case& c_;
  const Line& line_;
  std::string key_;
  std::vector<InputWarning>& out_;
  double weight_ = 0;  // N, in air
};

}  // namespace

void warn_of_line_loads(const Case& c, std::vector<InputWarning>& out) {
  for (const Line& line : c.lines) LineLoads(c, line, out).run();
}

}  // namespace hawser::advice
