// The class Snaps: largest tension of each line and its changes in adjacent steps.
#include "hawser/record/snaps.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/peaks.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/kernels/tension_peak.hpp"

namespace hawser::record {
namespace {

constexpr double kSuddenRise = 1.0 / 3;  // of the tension: sudden rise if larger
constexpr double kHeld = 0.02;           // of the tension: a smaller drop does not end a rise
constexpr double kSame = 1 - 1e-9;       // tolerance of equal tensions

bool counts(const model::Case& c, const model::Line& line) {
  const auto in_frame = [&](const model::End& e) {
    return e.kind == model::EndKind::joint && c.joint(e.carrier).rigid;
  };
  return !line.end_a.feed && !line.end_b.feed && !in_frame(line.end_a) && !in_frame(line.end_b);
}

}  // namespace

Snaps::Snaps(const model::Case& c, const LocalMesh& mesh)
    : mesh_(mesh),
      element_transit_time_(static_cast<size_t>(mesh.owned), 0),
      round_trip_time_(mesh, 0),
      worst_(mesh),
      unresolved_(mesh) {
  for (const EvenPart& part : mesh.mesh->parts())
    for (int k = 0; round_trip_time_.has(part.line) && k < part.elements; ++k)
      round_trip_time_[part.line] += 2 * c.line_types[part.shape->type].wave_time(part.element_length(k));
  for (const LocalElement& l : mesh.elements) {
    const Element& e = mesh.element(l);
    const model::LineType& t = c.line_types[e.type];
    if (!counts(c, c.lines[e.line])) continue;
    for (const int n : {l.first, l.second})
      if (n < mesh.owned) {
        double& slowest = element_transit_time_[n];
        slowest = std::max(slowest, t.wave_time(e.length));
      }
  }
}

void Snaps::update(double time, double h, std::span<const double> on_a, std::span<const double> on_b,
                   const PerLine<VolumePassage>* passages) {
  const bool steps = h > 0 && !before_.empty();
  before_.resize(element_transit_time_.size());
  for (size_t n = 0; n < element_transit_time_.size(); ++n) {
    if (element_transit_time_[n] == 0) continue;
    const Node& node = mesh_.node(n);
    Worst& w = worst_[node.line];
    Before& b = before_[n];
    const double tension = std::max({on_a[n], on_b[n], 0.0});
    if (!steps || tension < (1 - kHeld) * b.last || tension <= b.low) {
      b.low = tension;
      b.since = time;
    }
    if (steps && w.node == static_cast<int>(n)) {
      const double fall = (w.tension - tension) / (h * h);
      w.rate = std::sqrt(std::max(2 * std::min(w.rise, fall) / w.tension, 0.0));
      w.node = -1;
    }
    // The step before ended near a peak after a rise that it does not resolve. At half a step from the peak
    // T cos(w t) the tension is T cos(w h/2).
    if (steps && tension < b.last && b.step > element_transit_time_[n] &&
        !resolves_peak(b.previous, b.last)) {
      const double angle = std::acos(b.previous / b.last);
      const double peak = b.last / std::cos(0.5 * angle);
      if (Worst& u = unresolved_[node.line]; peak > u.tension)
        u = {.tension = peak, .time = time - h, .arc = node.arc, .step = b.step, .angle = angle};
    }
    b.previous = b.last;
    b.step = steps ? h : 0;
    if (tension > w.tension) {
      const double rise = steps ? std::max(tension - b.last, 0.0) : 0;
      w = {.tension = tension,
           .time = time,
           .arc = node.arc,
           .step = h,
           .angle = std::acos(1 - rise / tension),
           .element_transit_time = element_transit_time_[n],
           .from = b.low,
           .within = time - b.since};
      if (passages && time - (*passages)[node.line].time <= round_trip_time_[node.line])
        w.transverse_transit_time = (*passages)[node.line].transverse_transit_time;
      if (steps) {
        w.rise = rise / (h * h);
        w.node = static_cast<int>(n);
      }
    }
    b.last = tension;
  }
}

void Snaps::gather(MPI_Comm comm) {
  worst_.take_largest(comm, [](const Worst& w) { return w.tension; });
  unresolved_.take_largest(comm, [](const Worst& w) { return w.tension; });
}

std::string Snaps::warning(int line, const std::string& name, double largest_tension, bool damped,
                           advice::StepChoice step) const {
  const std::string largest = of_largest(line, name, largest_tension, damped, step);
  if (!largest.empty()) return largest;
  const Worst& u = unresolved_[line];
  if (!(u.tension > largest_tension)) return {};
  return advice::other_peak(name, {.tension = u.tension,
                                   .time = u.time,
                                   .arc = u.arc,
                                   .step = u.step,
                                   .shorter = 0.5 * u.step * kResolvedPhase / u.angle,
                                   .choice = step});
}

std::string Snaps::of_largest(int line, const std::string& name, double largest_tension, bool damped,
                              advice::StepChoice step) const {
  const Worst& w = worst_[line];
  if (!(w.tension > kSame * largest_tension)) return {};
  const bool steps = w.angle > kResolvedPhase;
  const bool elements = w.rate * w.element_transit_time > kResolvedPhase;
  const bool sudden = w.tension - w.from > kSuddenRise * w.tension && w.within < round_trip_time_[line];
  const bool crosswise = sudden && w.rate * w.transverse_transit_time > kResolvedPhase;
  if (!steps && !elements && !crosswise && !(damped && sudden)) return {};
  using Cause = advice::ImpactPeak::Cause;
  return advice::impact_peak(name, {.cause = steps       ? Cause::steps
                                             : elements  ? Cause::elements
                                             : crosswise ? Cause::crosswise
                                                         : Cause::damping,
                                    .tension = w.tension,
                                    .time = w.time,
                                    .arc = w.arc,
                                    .step = w.step,
                                    .fraction = 1 - std::cos(w.angle),
                                    .from = w.from,
                                    .within = w.within,
                                    .shorter = steps ? 0.5 * w.step * kResolvedPhase / w.angle : 0.5 * w.step,
                                    .choice = step});
}

}  // namespace hawser::record
