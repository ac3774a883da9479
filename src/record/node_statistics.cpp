// The class NodeStatistics: update of statistics at a step, their table, and their checkpoint.
#include "hawser/record/node_statistics.hpp"

#include <cmath>
#include <utility>

#include "hawser/record/output_times.hpp"

namespace hawser::record {
namespace {

// Keys in a checkpoint.
const std::string kPrefix = "statistics.", kBegun = "statistics.begun", kLatest = "statistics.latest";
// Numbers of Sums, stored without NaN; the last is 1: data exist, 3: also at the latest step, 0: none.
constexpr int kSaved = 9;

}  // namespace

NodeStatistics::NodeStatistics(const std::vector<io::ResultField>& fields, std::size_t nodes, double from)
    : from_(from) {
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (!fields[f].statistics) continue;
    fields_.push_back(fields[f]);
    place_.push_back(f);
    const double none = std::nan("");
    sums_.emplace_back(nodes * static_cast<std::size_t>(fields[f].components),
                       Sums{none, none, none, none, none, 0, none, 0});
  }
}

void NodeStatistics::add(double time, const std::vector<std::vector<double>>& values) {
  if (time < from_ - time_tolerance(from_)) return;
  const double h = begun_ ? time - latest_ : 0;
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const std::vector<double>& field = values[place_[f]];
    for (std::size_t i = 0; i < sums_[f].size(); ++i) {
      const double v = field[i];
      Sums& s = sums_[f][i];
      const double last = std::exchange(s.last, v);
      if (std::isnan(v)) continue;
      if (std::isnan(s.lowest)) s = {v, time, v, time, v, 0, v, 0};
      if (v < s.lowest) {
        s.lowest = v;
        s.lowest_time = time;
      }
      if (v > s.highest) {
        s.highest = v;
        s.highest_time = time;
      }
      if (!(h > 0) || std::isnan(last)) continue;
      // A linear piece of length h with mean m and variance (v - last)²/12 is merged with the earlier ones
      // (Chan, Golub and LeVeque 1983, equation 2.1, weighted by length).
      s.covered += h;
      const double weight = h / s.covered;
      const double off = 0.5 * (last + v) - s.mean;
      const double change = v - last;
      s.squares += (1 - weight) * h * off * off + h / 12 * change * change;
      s.mean += weight * off;
    }
  }
  begun_ = true;
  latest_ = time;
}

std::vector<double> NodeStatistics::table(std::size_t field) const {
  std::vector<double> out;
  out.reserve(io::kStatistics * sums_[field].size());
  for (const Sums& s : sums_[field]) {
    const double deviation = std::isnan(s.mean) ? s.mean
                             : s.covered > 0    ? std::sqrt(s.squares / s.covered)
                                                : 0;
    out.insert(out.end(), {s.lowest, s.lowest_time, s.highest, s.highest_time, s.mean, deviation});
  }
  return out;
}

void NodeStatistics::save(io::Checkpoint& to) const {
  to.scalars[kBegun] = begun_;
  to.scalars[kLatest] = latest_;
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    to.nodes[kPrefix + fields_[f].name] = {
        kSaved * fields_[f].components, {}, [&sums = sums_[f]] {
          std::vector<double> values;
          values.reserve(kSaved * sums.size());
          for (const Sums& s : sums) {
            const bool any = !std::isnan(s.lowest);
            const bool last = !std::isnan(s.last);
            values.insert(values.end(), {any ? s.lowest : 0, any ? s.lowest_time : 0, any ? s.highest : 0,
                                         any ? s.highest_time : 0, any ? s.mean : 0, s.squares,
                                         last ? s.last : 0, s.covered, any + 2.0 * last});
          }
          return values;
        }};
  }
}

void NodeStatistics::restore(const io::Checkpoint& from) {
  const auto scalar = [&](const std::string& name) {
    const auto at = from.scalars.find(name);
    return at == from.scalars.end() ? 0 : at->second;
  };
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const auto at = from.nodes.find(kPrefix + fields_[f].name);
    if (at == from.nodes.end() || at->second.values.size() != kSaved * sums_[f].size()) return;
  }
  begun_ = scalar(kBegun) != 0;
  latest_ = scalar(kLatest);
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const double* v = from.nodes.at(kPrefix + fields_[f].name).values.data();
    for (Sums& s : sums_[f]) {
      if (v[8] > 0) s = {v[0], v[1], v[2], v[3], v[4], v[5], v[8] > 2 ? v[6] : std::nan(""), v[7]};
      v += kSaved;
    }
  }
}

}  // namespace hawser::record
