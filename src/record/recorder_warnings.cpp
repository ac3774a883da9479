// The part of Recorder that says what a user must not overlook.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/model/check.hpp"
#include "hawser/model/doubts.hpp"
#include "hawser/record/recorder.hpp"

namespace hawser::record {
namespace {

constexpr double kPinnedFoot = 1.0188;  // minus the first zero of the derivative of Airy's function

// Of a line, N: what a strain of 1e-9 would exert. Less is round-off of a line without tension.
double no_tension(const model::Case& c, const std::string& line) {
  double EA = 0;
  for (const auto& s : c.line(line).sections) EA = std::max(EA, c.line_type(s.type).EA);
  return 1e-9 * EA;
}

}  // namespace

std::string Recorder::audit_warning() const {
  const int node = audit_.worst.node;
  const model::Case& c = subject_.model;
  std::string striking;
  for (const model::Body& b : c.bodies) {
    const model::StartSpeeds speed = model::start_speeds(c, b);
    if (striking.empty() && speed.motion + speed.drift > 0)
      striking = fmt::format("bodies.{}.{}", b.name, speed.motion > 0 ? "motion" : "motion.drift");
  }
  return audit_.warning(c.dynamics.step > 0, node < 0 ? "a body" : subject_.mesh().place(node), striking);
}

void Recorder::look_at_elements(const Kinematics& at) {
  const auto of = [&](int f) {
    return f < 0 ? std::span<const double>() : std::span<const double>(values_[f]);
  };
  ElementErrors::Values v{of(tension_), of(moment_), of(pressed_), {}};
  v.carried.resize(subject_.local().owned, false);
  for (const int f : touches_)
    for (size_t n = 0, c = static_cast<size_t>(fields_[f].components); n < v.carried.size(); ++n)
      for (size_t k = 0; k < c; ++k)
        if (values_[f][n * c + k] != 0) v.carried[n] = true;
  element_errors_.look(at, v);
}

// Of the largest tension of a line.
std::string Recorder::peak_warning(const io::SummaryRow& r) const {
  const int line = subject_.model.line_index(r.line);
  const std::string folded = folds_.warning(comm_, line, r.line, r.value);
  if (!folded.empty()) return folded;
  return snaps_.warning(comm_, line, r.line, r.value, !audit_.note().empty(),
                        subject_.model.dynamics.step > 0);
}

// A beam of weight w that stands on a pinned foot and is pulled further up, EI theta'' = w (z - z0) theta
// with theta' = 0 at the foot, buckles there where the compression is that of the first zero of Ai', 1.019
// (EI w²)^(1/3). Then its shape carries what presses, and its moments grow with it. A short one is a strut,
// which its weight does not hold: Euler's pi² EI/L².
std::string Recorder::compressed(const io::SummaryRow& r) const {
  if (r.quantity != "min effective tension" || !(r.value < 0)) return {};
  const model::Case& c = subject_.model;
  const model::Line& line = c.line(r.line);
  double arc = 0;
  const model::LineType* type = &c.line_type(line.sections.back().type);
  for (const model::Section& s : line.sections)
    if (r.arc_length <= (arc += s.length)) {
      type = &c.line_type(s.type);
      break;
    }
  if (type->kind != model::LineKind::beam) return {};
  const double w = c.environment.gravity * std::abs(model::mass_in_water(c, *type, -HUGE_VAL));
  const double EI = std::min(type->EI2, type->EI3);
  const double strut = M_PI * M_PI * EI / std::pow(model::length_of(line), 2);
  const double buckles = std::max(kPinnedFoot * std::cbrt(EI * w * w), strut);
  if (!(-r.value > buckles)) return {};
  return fmt::format(
      "line {} is under an effective compression of {:.3g} kN at arc length {:.6g} m, {}; on a pinned foot "
      "it "
      "buckles at about {:.2g} kN: does its upper end pull enough?",
      r.line, -r.value / 1000, r.arc_length, when_text(c, r.time), buckles / 1000);
}

void Recorder::gather_warnings(const std::vector<io::SummaryRow>& rows) {
  const auto bent = [&](const std::string& line) {
    for (const auto& r : rows)
      if (r.line == line && r.quantity == "max bending moment") return r.value;
    return HUGE_VAL;
  };
  warnings_.clear();
  for (const auto& r : rows) {
    if (r.quantity == "max effective tension" && r.value > no_tension(subject_.model, r.line)) {
      for (const std::string& w :
           element_errors_.warnings(subject_.model.line_index(r.line), r.value, bent(r.line)))
        warnings_.push_back(w);
      if (const std::string w = peak_warning(r); !w.empty()) warnings_.push_back(w);
    }
    if (const std::string w = overused(subject_.model, fields_, r); !w.empty()) warnings_.push_back(w);
    if (const std::string w = compressed(r); !w.empty()) warnings_.push_back(w);
    if (const std::string w = overbent(subject_.model, r); !w.empty()) warnings_.push_back(w);
    if (r.quantity != "max penetration") continue;
    const model::Case& c = subject_.model;
    const double radius = 0.5 * model::contact_diameter_of(c, c.line(r.line));
    // What the case allows is none of its surprises.
    double allowed = 0;
    for (const model::Volume& v : c.volumes) allowed = std::max(allowed, v.allowed_penetration);
    if (r.value > std::max(c.contact.warned_penetration * radius, 1.1 * allowed))
      warnings_.push_back(fmt::format(
          "line {} is {:.3g} m inside a volume (its radius is {:.3g} m) at arc length {:.6g} m, {}: {}",
          r.line, r.value, radius, r.arc_length, when_text(c, r.time),
          r.value > radius ? "contact goes no deeper than the radius: it is trapped inside, or the volume is "
                             "too soft for a "
                             "line as thin as this, which then needs a larger 'contact_diameter'"
                           : "a normal_stiffness that is given can be raised; an automatic one is as high as "
                             "the line's EA "
                             "asks: is its tension more than it bears?"));
  }
  for (const std::string& w : water_errors_.warnings()) warnings_.push_back(w);
  for (const std::string& w : pipes_.warnings(comm_)) warnings_.push_back(w);
  if (supports_)
    for (const std::string& w : supports_->warnings()) warnings_.push_back(w);
}

}  // namespace hawser::record
