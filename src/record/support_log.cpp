// The class SupportLog: forces of rollers summed over the ranks, the crossing of line and box by bisection
// along the element that goes through the plane of the box, and what is told of it.
#include "hawser/record/support_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hawser/base/gather.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/line_extremes.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {
namespace {

// On the way of a line over its supports, in space: the end from which it goes overboard, which has the box
// after it, and where it lies on each.
struct Stop {
  Vec3 at, along, up;  // m; unit
  const model::SupportBox* box;
};

std::vector<Stop> way_over_supports(const model::Case& c, const model::Line& line,
                                    const std::vector<RigidPose>& poses) {
  std::vector<Stop> way;
  for (const model::SupportBox& b : c.supports) {
    if (b.line != line.name) continue;
    const auto pose_of = [&](const std::string& body) {
      const int i = c.body_index(body);
      return i < 0 ? RigidPose{} : poses[i];
    };
    const RigidPose pose = pose_of(b.body);
    const Stop stop{pose.to_space(b.at), pose.rotation * b.along, pose.rotation * b.up, &b};
    if (const model::End* end = way.empty() ? model::end_before(c, line, b) : nullptr) {
      const Vec3 at = model::end_position(c, *end);
      Vec3 along = (stop.at - at).normalized();
      if (end->direction)
        along = (end == &line.end_a ? 1.0 : -1.0) * (pose_of(end->body).rotation * *end->direction);
      way.push_back({at, along, stop.up, &b});
    }
    way.push_back(stop);
  }
  return way;
}

// m, of a stop above where the others lead: the cubic through its two neighbours in their directions, at
// either end of the way on from there as it turns between the nearest two. Of three at least.
double above_the_others(const std::vector<Stop>& way, size_t k) {
  const Stop& here = way[k];
  if (k > 0 && k + 1 < way.size()) {
    const Stop &a = way[k - 1], &b = way[k + 1];
    const Vec3 chord = b.at - a.at;
    const double d = chord.norm(), t = std::clamp((here.at - a.at).dot(chord) / (d * d), 0.0, 1.0), u = 1 - t;
    const Vec3 there =
        u * u * (1 + 2 * t) * a.at + t * t * (3 - 2 * t) * b.at + t * u * d * (u * a.along - t * b.along);
    return (here.at - there).dot(here.up);
  }
  const bool first = k == 0;
  const Stop &near = way[first ? 1 : k - 1], &next = way[first ? 2 : k - 2];
  const double d = (here.at - near.at).norm(), turn = 0.5 * d / (near.at - next.at).norm();
  const Vec3 along = (near.along + turn * (near.along - next.along)).normalized();
  return (here.at - near.at - (first ? -d : d) * along).dot(here.up);
}

}  // namespace

std::optional<Beneath> beneath_supports(const model::Case& c, const std::vector<SupportCrossing>& crossings,
                                        const std::vector<RigidPose>& poses) {
  for (size_t k = 0; k < crossings.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    const SupportCrossing& x = crossings[k];
    if (!x.known || std::abs(x.offset) > b.half_width || x.height > -b.rise) continue;
    const model::Line& line = c.line(b.line);
    const std::string wrong = fmt::format(
        "starts on the wrong side of support '{}', {:.3g} m below where it would lie on its roller", b.name,
        -x.height);
    if (line.start != model::Start::automatic)
      return Beneath{"lines." + line.name,
                     wrong + "; give it no 'start', so that it starts on its supports, or points above them"};
    const std::vector<Stop> way = way_over_supports(c, line, poses);
    size_t odd = 0;
    double off = 0;  // m
    for (size_t i = 0; i < way.size() && way.size() > 2; ++i)
      if (const double above = above_the_others(way, i); std::abs(above) > std::abs(off))
        odd = i, off = above;
    if (!(std::abs(off) > b.rise))
      return Beneath{
          b.key,
          fmt::format("line {} {}; move the supports, or the end of the line, so that one leads to the other",
                      line.name, wrong)};
    const model::SupportBox& named = *way[odd].box;
    const std::string cause =
        odd > 0
            ? fmt::format("support '{}' is {:.3g} m {} the way over its neighbours", named.name,
                          std::abs(off), off > 0 ? "above" : "below")
            : fmt::format(
                  "the way over the supports begins {:.3g} m {} the end from which line {} goes overboard",
                  std::abs(off), off > 0 ? "below" : "above", line.name);
    return Beneath{named.key, fmt::format("{}, so that line {} {}; move {}", cause, line.name, wrong,
                                          odd > 0 ? "it into line with them"
                                                  : "them, or the end, so that one leads to the other")};
  }
  return {};
}

std::string overbent(const model::Case& c, const io::SummaryRow& row) {
  constexpr double kYielded =
      0.005;  // total strain at which the yield stress of pipe steel is defined (API 5L)
  const auto lies = [&](const model::SupportBox& b) { return b.line == row.line; };
  if (row.quantity != "max curvature" || std::none_of(c.supports.begin(), c.supports.end(), lies)) return "";
  double diameter = 0;
  for (const model::Section& s : c.line(row.line).sections)
    if (const model::LineType& t = c.line_type(s.type); !t.plastic_bending)
      diameter = std::max(diameter, t.outer_diameter);
  const double strain = 0.5 * diameter * row.value;
  if (!(strain > kYielded)) return "";
  return fmt::format(
      "line {} is bent to a radius of {:.3g} m at arc length {:.6g} m, {}, {:.2g} % of strain: steel yields "
      "before, and this pipe is elastic; do the places and directions of its ends and supports fit, or does "
      "it need 'plasticity'?",
      row.line, 1 / row.value, row.arc_length, when_text(c, row.time), 100 * strain);
}

SupportLog::SupportLog(const Subject& subject)
    : subject_(subject),
      rollers_(subject),
      off_(subject.model.supports.size(), false),
      carried_(off_),
      lowest_(off_.size(), HUGE_VAL) {}

void SupportLog::declare(Declarations& to) {
  for (const model::SupportBox& b : subject_.model.supports) {
    io::ResultSeries& s = to.contents.series.emplace_back(io::ResultSeries{b.name, {{"force", "N", 3}}});
    for (const std::string& roller : b.rollers) s.columns.push_back({roller + "_force", "N", 3});
    for (const char* name : {"height", "offset", "arc_length"}) s.columns.push_back({name, "m", 1});
  }
}

void SupportLog::step(const Snapshot& s) {
  const model::Case& c = subject_.model;
  const std::vector<SupportCrossing> crosses = rollers_.crossings(s);
  std::vector<Vec3> forces = rollers_.forces(s.at);
  const int rank = rank_of(subject_.comm());
  MPI_Reduce(rank == 0 ? MPI_IN_PLACE : forces.data(), forces.data(), 3 * static_cast<int>(forces.size()),
             MPI_DOUBLE, MPI_SUM, 0, subject_.comm());
  rows_.assign(c.supports.size(), {});
  for (size_t k = 0; k < rows_.size() && rank == 0; ++k) {
    const model::SupportBox& b = c.supports[k];
    const SupportCrossing& x = crosses[k];
    std::vector<double>& row = rows_[k];
    const auto of = [&](size_t i) -> const Vec3& { return forces[rollers_.first(k) + i]; };
    Vec3 sum = Vec3::Zero();
    for (size_t i = 0; i < b.rollers.size(); ++i) sum += of(i);
    row.assign(sum.begin(), sum.end());
    if (sum != Vec3::Zero()) carried_[k] = true;
    if (x.known) lowest_[k] = std::min(lowest_[k], x.height);
    for (size_t i = 0; i < b.rollers.size(); ++i) row.insert(row.end(), of(i).begin(), of(i).end());
    for (const double value : {x.height, x.offset, x.arc}) row.push_back(x.known ? value : std::nan(""));
    if (off_[k] || !x.known || std::abs(x.offset) <= b.half_width || x.height >= b.rise) continue;
    off_[k] = true;
    warnings_.push_back(fmt::format(
        "line {} is off the end of the rollers of support {} at t = {:.6g} s: {:.3g} m to the {} of its "
        "middle, and they reach {:.3g} m",
        b.line, b.name, s.at.time, std::abs(x.offset), x.offset > 0 ? "left" : "right", b.half_width));
  }
}

void SupportLog::rows(const Snapshot&, Rows& to) { to.insert(to.end(), rows_.begin(), rows_.end()); }

std::vector<Finding> SupportLog::findings(const std::vector<io::SummaryRow>&, const Audit&) {
  std::vector<Finding> out;
  for (const std::string& w : warnings_) out.push_back({w});
  const model::Case& c = subject_.model;
  for (size_t k = 0; k < lowest_.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    double diameter = 0;
    for (const model::Section& s : c.line(b.line).sections)
      diameter = std::max(diameter, c.line_type(s.type).outer_diameter);
    bool first = true, any = false, further = false;  // of the line's boxes
    for (size_t j = 0; j < lowest_.size(); ++j) {
      if (c.supports[j].line != b.line) continue;
      first = first && j >= k, any = any || carried_[j], further = further || (j > k && carried_[j]);
    }
    // What lies clear of the last ones is laid as it is meant to be; by less than a diameter over one
    // between, the next have been set a little high.
    if (further && !carried_[k] && lowest_[k] > diameter)
      out.push_back(
          {fmt::format("support {} never carries line {}, {} and lies on supports further on: raise it by "
                       "'above_path', or leave it out",
                       b.name, b.line,
                       std::isfinite(lowest_[k]) ? fmt::format("which passes {:.3g} m above it", lowest_[k])
                                                 : std::string("which does not come by it"))});
    if (first && !any)
      out.push_back({fmt::format(
          "none of its supports ever carries line {}: are they drawn too low, or beside it?", b.line)});
  }
  return out;
}

}  // namespace hawser::record
