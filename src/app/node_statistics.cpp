// The class NodeStatistics: of which fields statistics are kept, their update at a step, their table, and
// their place in a checkpoint.
#include "hawser/app/node_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hawser::app {
namespace {

constexpr std::string_view kFields[] = {"effective_tension",
                                        "effective_tension_before",
                                        "effective_tension_after",
                                        "wall_tension",
                                        "declination",
                                        "utilisation",
                                        "bend_utilisation",
                                        "bending_moment",
                                        "bending_moment_2",
                                        "shear_force",
                                        "bending_moment_3",
                                        "torsion_moment",
                                        "curvature",
                                        "penetration",
                                        "contact_normal_force"};
// In a checkpoint.
const std::string kPrefix = "statistics.", kBegun = "statistics.begun", kSince = "statistics.since",
                  kLatest = "statistics.latest";
constexpr int kNumbers = 7;  // of Sums

}  // namespace

bool NodeStatistics::wants(std::string_view field) {
  return std::find(std::begin(kFields), std::end(kFields), field) != std::end(kFields);
}

NodeStatistics::NodeStatistics(const std::vector<io::ResultField>& fields, std::size_t nodes, double from)
    : from_(from) {
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (!wants(fields[f].name)) continue;
    fields_.push_back(fields[f]), place_.push_back(f);
    sums_.emplace_back(nodes * static_cast<std::size_t>(fields[f].components));
  }
}

void NodeStatistics::add(double time, const std::vector<std::vector<double>>& values) {
  if (time < from_ - 1e-9 * std::max(1.0, from_)) return;
  const double h = begun_ ? time - latest_ : 0;
  if (!begun_) since_ = time;
  // With the interval h a linear piece of mean m and variance (v - last)²/12 joins those before (Chan, Golub
  // and LeVeque 1983, equation 2.1, with the lengths of intervals as weights).
  const double share = h > 0 ? h / (time - since_) : 0, rest = (1 - share) * h;
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const std::vector<double>& of = values[place_[f]];
    if (!begun_)
      for (std::size_t i = 0; i < sums_[f].size(); ++i)
        sums_[f][i] = {of[i], time, of[i], time, of[i], 0, of[i]};
    for (std::size_t i = 0; i < sums_[f].size(); ++i) {
      const double v = of[i];
      Sums& s = sums_[f][i];
      if (v < s.least) s.least = v, s.least_time = time;
      if (v > s.most) s.most = v, s.most_time = time;
      const double off = 0.5 * (s.last + v) - s.mean, change = v - s.last;
      s.squares += rest * off * off + h / 12 * change * change;
      s.mean += share * off;
      s.last = v;
    }
  }
  begun_ = true, latest_ = time;
}

std::vector<double> NodeStatistics::table(std::size_t field) const {
  std::vector<double> out;
  out.reserve(io::kStatistics * sums_[field].size());
  for (const Sums& s : sums_[field]) {
    if (!begun_) {
      out.insert(out.end(), io::kStatistics, std::nan(""));
      continue;
    }
    const double length = latest_ - since_;
    const double deviation = length > 0 ? std::sqrt(s.squares / length) : 0;
    out.insert(out.end(), {s.least, s.least_time, s.most, s.most_time, s.mean, deviation});
  }
  return out;
}

void NodeStatistics::save(io::Checkpoint& to) const {
  to.scalars[kBegun] = begun_, to.scalars[kSince] = since_, to.scalars[kLatest] = latest_;
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    io::CheckpointField& of = to.nodes[kPrefix + fields_[f].name];
    of.components = kNumbers * fields_[f].components;
    of.values.reserve(kNumbers * sums_[f].size());
    for (const Sums& s : sums_[f])
      of.values.insert(of.values.end(),
                       {s.least, s.least_time, s.most, s.most_time, s.mean, s.squares, s.last});
  }
}

void NodeStatistics::restore(const io::Checkpoint& from) {
  const auto scalar = [&](const std::string& name) {
    const auto at = from.scalars.find(name);
    return at == from.scalars.end() ? 0 : at->second;
  };
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const auto at = from.nodes.find(kPrefix + fields_[f].name);
    if (at == from.nodes.end() || at->second.values.size() != kNumbers * sums_[f].size()) return;
  }
  begun_ = scalar(kBegun) != 0, since_ = scalar(kSince), latest_ = scalar(kLatest);
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const double* v = from.nodes.at(kPrefix + fields_[f].name).values.data();
    for (Sums& s : sums_[f]) s = {v[0], v[1], v[2], v[3], v[4], v[5], v[6]}, v += kNumbers;
  }
}

}  // namespace hawser::app
