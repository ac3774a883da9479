// The class NodeStatistics: update of statistics at a step, their table, and their checkpoint.
#include "hawser/record/node_statistics.hpp"

#include <cmath>
#include <utility>

#include "hawser/record/output_times.hpp"

namespace hawser::record {
namespace {

// Keys in a checkpoint.
const std::string kBegun = "statistics.begun", kLatest = "statistics.latest";
// 0: the other numbers of a component, which are NaN then, are stored as 0; 1: there are values; 2: also at
// the latest step.
const char* const kKnown = "known";

std::string key(const io::ResultField& field, const char* number) {
  return "statistics." + field.name + "." + number;
}

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
    const auto add = [&to, &field = fields_[f], &sums = sums_[f]](const char* name, auto number) {
      to.nodes[key(field, name)] = {field.components, {}, [&sums, number] {
                                      std::vector<double> values;
                                      values.reserve(sums.size());
                                      for (const Sums& s : sums) values.push_back(number(s));
                                      return values;
                                    }};
    };
    for (const auto& [name, member] : kNumbers)
      add(name, [number = member](const Sums& s) { return std::isnan(s.*number) ? 0 : s.*number; });
    add(kKnown, [](const Sums& s) { return std::isnan(s.lowest) ? 0.0 : std::isnan(s.last) ? 1.0 : 2.0; });
  }
}

void NodeStatistics::restore(const io::Checkpoint& from) {
  const auto scalar = [&](const std::string& name) {
    const auto at = from.scalars.find(name);
    return at == from.scalars.end() ? 0 : at->second;
  };
  const auto has = [&](std::size_t f, const char* number) {
    const auto at = from.nodes.find(key(fields_[f], number));
    return at != from.nodes.end() && at->second.values.size() == sums_[f].size();
  };
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    if (!has(f, kKnown)) return;
    for (const auto& number : kNumbers)
      if (!has(f, number.first)) return;
  }
  begun_ = scalar(kBegun) != 0;
  latest_ = scalar(kLatest);
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    const std::vector<double>& known = from.nodes.at(key(fields_[f], kKnown)).values;
    for (const auto& [name, member] : kNumbers) {
      const std::vector<double>& values = from.nodes.at(key(fields_[f], name)).values;
      for (std::size_t i = 0; i < values.size(); ++i)
        if (known[i] > 0) sums_[f][i].*member = values[i];
    }
    for (std::size_t i = 0; i < known.size(); ++i)
      if (known[i] < 2) sums_[f][i].last = std::nan("");
  }
}

}  // namespace hawser::record
