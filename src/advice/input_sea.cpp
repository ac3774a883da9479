// Consistency of water and bed depths and line ends, soil stiffness, effects of current on slack lines on the
// bed and on linear waves, and buoys without drag or added mass.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"

namespace hawser::advice {

using namespace model;

double lowest_reach(const Case& c, const Line& line) {
  const double length = length_of(line) + expansion_of(c, line);
  const auto z = [&](const End& e) { return end_position(c, e).z(); };
  const bool a = line.end_a.kind != EndKind::free;
  const bool b = line.end_b.kind != EndKind::free;
  if (a && b) return 0.5 * (z(line.end_a) + z(line.end_b) - length);
  if (a || b) return z(a ? line.end_a : line.end_b) - length;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : line.points) lowest = std::min(lowest, p.z());
  return std::isfinite(lowest) ? lowest : -lowest;
}

double slack_tension(double L, double X, double h) {
  if (L >= X + h) return 0;
  const auto excess = [&](double a) {  // excess length at horizontal tension a
    return L - std::sqrt(h * h + 2 * h * a) + (a > 0 ? a * std::acosh(1 + h / a) : 0) - X;
  };
  double low = 0;
  double high = h;
  while (excess(high) < 0 && high < 1e6 * h) high *= 2;
  if (excess(high) < 0) return -1;
  for (int i = 0; i < 80; ++i) {
    const double a = 0.5 * (low + high);
    (excess(a) < 0 ? low : high) = a;
  }
  return L > std::sqrt(h * h + 2 * h * high) ? high : -1;
}

namespace {

constexpr double kSameDepth = 0.02;  // fraction of the water depth
constexpr double kNear = 10,
                 kNearShare = 0.5;  // m, and of the depth: anchors that high are meant to be there
constexpr double kBow = 0.01;       // fraction of the length on the bed
// N/m³, and per length N/m² over the thickest line. DNV-RP-F105 (2006), section 7, gives 50 kN/m² for pipes
// in very soft clay to 4200 in hard clay, static; rock and fast motion are stiffer, mud is softer.
constexpr double kSoftBed = 2e3, kStiffBed = 1e9;

void warn_of_depths(const Case& c, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const Seabed& bed = c.environment.seabed;
  if (!w.present || !bed.present || bed.surface || bed.slope > 0 || !(w.depth > 0)) return;
  const double depth = bed.depth + w.surface;
  if (std::abs(depth - w.depth) > kSameDepth * w.depth)
    add_warning(out, "environment.seabed.depth", Effect::all,
                "the seabed is {:.6g} m below the still water, but the water depth is {:.6g} m; the waves "
                "use the water depth",
                depth, w.depth);
}

// An anchor above the water by the depth of the bed: a lost minus sign. One in the lower half of the water
// but well above the bed: a depth other than that of the bed.
void warn_of_anchor(const Case& c, const Line& line, const End& e, const char* which,
                    std::vector<InputWarning>& out) {
  if (e.kind != EndKind::anchor) return;
  const Water& w = c.environment.water;
  const Seabed& bed = c.environment.seabed;
  const double z = e.at.z() - w.surface;
  const double depth = w.depth > 0 ? w.depth : bed.depth;
  const std::string key = fmt::format("lines.{}.{}.anchor", line.name, which);
  if (w.present && depth > 0 && std::abs(z - depth) < kSameDepth * depth)
    add_warning(out, key, Effect::all,
                "is {:.6g} m above the water, whose depth is {:.6g} m: z points up; is {:g} meant?", z, depth,
                -e.at.z());
  if (!bed.present || bed.surface) return;
  const double bottom = below_on_bed(bed, e.at).z();
  const double height = e.at.z() - bottom;
  if (height > kNear && height < kNearShare * (w.surface - bottom))
    add_warning(
        out, key, Effect::all,
        "is {:.4g} m above the seabed, which is at z = {:.6g} m there; is an anchor in mid-water intended?",
        height, bottom);
}

void warn_of_bed_in_reach(const Case& c, std::vector<InputWarning>& out) {
  const Seabed& bed = c.environment.seabed;
  if (!bed.present || bed.surface || bed.slope > 0 || c.lines.empty()) return;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Line& l : c.lines) lowest = std::min(lowest, lowest_reach(c, l));
  // Lines move with their bodies.
  if (lowest > -0.8 * bed.depth)
    add_warning(out, "environment.seabed", Effect::all,
                "no line reaches the seabed at z = {:.6g} m: the deepest, if it hung straight down, would "
                "reach z = {:.6g} m",
                -bed.depth, lowest);
}

// Horizontal velocity [m/s] of the current at a depth [m] at t = 0.
Vec3 current_at(const Water& w, double depth) {
  const std::vector<CurrentRow>& rows = w.current.profile;
  if (rows.empty() || w.current.exponent > 0) return Vec3::Zero();  // a power law is zero at the bed
  const auto vector = [](const CurrentRow& r) {
    return Vec3(r.speed * std::cos(r.direction), r.speed * std::sin(r.direction), 0);
  };
  const auto below =
      std::find_if(rows.begin(), rows.end(), [&](const CurrentRow& r) { return r.depth > depth; });
  const double factor = w.current.time_factor.at(0);
  if (below == rows.begin()) return factor * vector(rows.front());
  if (below == rows.end()) return factor * vector(rows.back());
  const CurrentRow& u = *(below - 1);
  const CurrentRow& l = *below;
  return factor * (vector(u) + (depth - u.depth) / (l.depth - u.depth) * (vector(l) - vector(u)));
}

void warn_of_current(const Case& c, const Line& line, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const Seabed& bed = c.environment.seabed;
  if (!c.statics.enabled || w.current.profile.empty() || w.current.ramp > 0 || !bed.present || bed.surface ||
      !line.starts_by_itself() || !is_held(line.end_a) || !is_held(line.end_b))
    return;
  Vec3 low = end_position(c, line.end_a);
  Vec3 high = end_position(c, line.end_b);
  if (low.z() > high.z()) std::swap(low, high);
  const double length = length_of(line);
  const double near = laying_reach(c, line);
  const double h = height_above_bed(bed, high);
  if (height_above_bed(bed, low) > near || h < 10 * near) return;
  double weight = 0, drag = 0;  // per length, N/m
  const Vec3 across = Vec3(low.y() - high.y(), high.x() - low.x(), 0).normalized();
  const double speed = std::abs(current_at(w, w.surface - low.z()).dot(across));
  for (const Section& s : line.sections) {
    const LineType& t = c.line_type(s.type);
    const double weight_per_length = c.environment.gravity * mass_in_water(c, t, low.z());
    if (!(weight_per_length > 0)) return;  // it floats in parts and has other shapes
    weight += weight_per_length * s.length / length;
    drag += 0.5 * w.density * t.Cd_normal * t.dragged() * speed * speed * s.length / length;
  }
  const double X = (high - low).head<2>().norm();
  const double a = slack_tension(length, X, h);
  if (!(speed > 0) || a < 0 || drag > bed.friction.lateral * weight) return;  // it would drift away
  const double lies = length - std::sqrt(h * h + 2 * h * a);
  const double bow = drag * lies / (8 * std::max(a, 1e-9) * weight);
  if (!(lies > 0) || bow < kBow) return;
  const std::string far = bow < 0.1 ? fmt::format("about {:.2g} m sideways", bow * lies) : "far sideways";
  add_warning(out, "lines." + line.name, Effect::part,
              "{:.3g} m of it lie slack on the bed ({:.3g} kN), and in statics, where no friction acts "
              "across a line before it is at rest, the current of {:.3g} m/s there bends them {}; with "
              "'environment.current.ramp' the current begins in dynamics, where friction holds them",
              lies, a * weight / 1000, speed, far);
}

void warn_of_soil(const Case& c, std::vector<InputWarning>& out) {
  const Seabed& bed = c.environment.seabed;
  if (!bed.present || bed.force_table) return;
  const bool by_length = bed.basis == StiffnessBasis::per_length;
  double thickest = 0;
  for (const LineType& t : c.line_types) thickest = std::max(thickest, t.contact_diameter);
  const double stiffness = bed.normal_stiffness / (by_length && thickest > 0 ? thickest : 1);
  if (stiffness >= kSoftBed && stiffness <= kStiffBed) return;
  const double in_thousands = 1e3 * stiffness;
  std::string hint;
  if (in_thousands >= kSoftBed && in_thousands <= kStiffBed && stiffness < kSoftBed)
    hint = fmt::format("; is it in kN? ('{:g} {}')", bed.normal_stiffness, by_length ? "kN/m2" : "kN/m3");
  add_warning(out, "environment.seabed.normal_stiffness", Effect::all,
              "{:g} {} is {} than any soil; usual values are {}{}", bed.normal_stiffness,
              by_length ? "N/m²" : "N/m³", stiffness < kSoftBed ? "softer" : "stiffer",
              by_length ? "50 to 5000 kN/m²" : "50 to 10000 kN/m³", hint);
}

// Buoys, unlike lines, have no default drag and added mass.
void warn_of_buoy(const Case& c, const Line& line, const PointMass& m, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const bool moves = c.dynamics.enabled || !w.current.profile.empty();
  if (!w.present || !moves || m.drag_area > 0 || m.Ca > 0 || m.mass >= w.density * m.volume) return;
  add_warning(out, "lines." + line.name + ".masses", Effect::part,
              "{:.4g} m³ at {:.6g} m of line {} have neither 'drag_area' nor 'Ca': no drag and no "
              "added mass; a ball of that volume has about {:.2g} m² and 0.5",
              m.volume, m.at, line.name, 0.5 * M_PI / 4 * std::pow(6 / M_PI * m.volume, 2.0 / 3));
}

// Representative wave of a system of linear waves: its peak, or the highest of given waves.
WaveSystem::Row leading_wave(const WaveSystem& w) {
  if (w.irregular()) return {w.height, w.peak_period, w.direction, 0};
  return *std::max_element(w.rows.begin(), w.rows.end(),
                           [](const auto& a, const auto& b) { return a.height < b.height; });
}

// Linear waves propagate in still water: the current neither stretches nor steepens them.
void warn_of_waves_on_current(const Case& c, std::vector<InputWarning>& out) {
  constexpr double kSignificant = 0.1;  // of the wave speed; changes the wave length by a fifth
  const Water& w = c.environment.water;
  if (!c.dynamics.enabled || w.current.profile.empty() || w.waves.stokes()) return;
  const CurrentRow& top = w.current.profile.front();
  for (const WaveSystem& system : w.waves.systems) {
    const WaveSystem::Row wave = leading_wave(system);
    const double along = w.current.time_factor.at(0) * top.speed * std::cos(top.direction - wave.direction);
    const double omega = 2 * M_PI / wave.period;
    const double speed = omega / wave_number(omega, w.depth, c.environment.gravity);
    if (std::abs(along) < kSignificant * speed) continue;
    add_warning(out, system.key, Effect::part,
                "the current of {:.3g} m/s {} the waves of {:.4g} s is {:.2g} % of their speed, and linear "
                "waves here neglect that the current makes them {}; compare with a single wave as 'stokes' "
                "with its own 'current', which includes it",
                std::abs(along), along > 0 ? "along" : "against", wave.period, 100 * std::abs(along) / speed,
                along > 0 ? "longer and flatter" : "shorter and steeper");
  }
}

}  // namespace

void warn_of_sea(const Case& c, std::vector<InputWarning>& out) {
  warn_of_soil(c, out);
  warn_of_depths(c, out);
  warn_of_bed_in_reach(c, out);
  warn_of_waves_on_current(c, out);
  for (const Line& line : c.lines) {
    warn_of_anchor(c, line, line.end_a, "end_a", out);
    warn_of_anchor(c, line, line.end_b, "end_b", out);
    warn_of_current(c, line, out);
    for (const PointMass& m : line.masses) warn_of_buoy(c, line, m, out);
  }
}

}  // namespace hawser::advice
