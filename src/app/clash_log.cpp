#include "hawser/app/clash_log.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace hawser::app {
namespace {

constexpr size_t kKept = 1000;  // of the largest, for the table at the end

auto pair_of(const auto& t) { return std::tuple(t.line, t.other_line, t.volume, t.other_volume); }

double merge_length(const std::vector<double>& by_line, int line) {
  const size_t l = static_cast<size_t>(line);
  return line >= 0 && l < by_line.size() ? by_line[l] : 0;
}

// Largest first; of equals the earlier one.
bool larger(const io::ClashRow& a, const io::ClashRow& b) {
  return std::tuple(-a.peak_force, a.start, pair_of(a), a.from) <
         std::tuple(-b.peak_force, b.start, pair_of(b), b.from);
}

void widen(io::ClashRow& row, double from, double to, double other_from, double other_to) {
  row.from = std::min(row.from, from), row.to = std::max(row.to, to);
  row.other_from = std::min(row.other_from, other_from), row.other_to = std::max(row.other_to, other_to);
}

}  // namespace

Touches put_together(Touches touches, const std::vector<double>& by_line) {
  const auto key = [](const Touch& t) {
    return std::tuple(pair_of(t), t.from, t.to, t.other_from, t.other_to);
  };
  std::sort(touches.begin(), touches.end(), [&](const Touch& a, const Touch& b) { return key(a) < key(b); });
  Touches out;
  for (const Touch& t : touches) {
    if (out.empty() || pair_of(out.back()) != pair_of(t) ||
        t.from > out.back().to + merge_length(by_line, t.line)) {
      out.push_back(t);
      continue;
    }
    Touch& o = out.back();
    o.to = std::max(o.to, t.to);
    o.other_from = std::min(o.other_from, t.other_from), o.other_to = std::max(o.other_to, t.other_to);
    o.force += t.force, o.energy += t.energy, o.depth = std::max(o.depth, t.depth);
  }
  return out;
}

void ClashLog::step(double time, std::span<const Touch> touches) {
  // What did not touch at the last step may have been apart for too long by now to go on.
  std::erase_if(open_, [&](const Open& o) {
    const bool over = o.row.end < time_ && time - o.row.end > settings_.merge_gap;
    if (over) end(o.row);
    return over;
  });
  // Open clashes by pair, so that a step costs what touches and not its square.
  std::vector<size_t> by_pair(open_.size());
  for (size_t i = 0; i < by_pair.size(); ++i) by_pair[i] = i;
  std::stable_sort(by_pair.begin(), by_pair.end(),
                   [&](size_t a, size_t b) { return pair_of(open_[a].row) < pair_of(open_[b].row); });
  struct Sum {
    double force = 0, energy = 0, from = 0, to = 0;
    std::vector<std::pair<double, double>> places;
  };
  std::vector<Sum> now(open_.size());
  std::vector<char> joined(open_.size(), 0);
  size_t known = 0;
  const size_t before = open_.size();
  for (const Touch& t : touches) {
    const double reach = merge_length(settings_.merge_length, t.line);
    while (known < before && pair_of(open_[by_pair[known]].row) < pair_of(t)) ++known;
    size_t mine = open_.size();
    for (size_t k = known; k < before && pair_of(open_[by_pair[k]].row) == pair_of(t); ++k) {
      const size_t i = by_pair[k];
      if (joined[i]) continue;
      const Open& o = open_[i];
      const bool here = std::any_of(o.places.begin(), o.places.end(), [&](const auto& p) {
        return t.from <= p.second + reach && p.first <= t.to + reach;
      });
      if (!here) continue;
      if (mine == open_.size()) {
        mine = i;
        continue;
      }
      // Two places have met: the earlier clash takes the other's share.
      io::ClashRow &a = open_[mine].row, &b = open_[i].row;
      joined[i] = 1;
      a.start = std::min(a.start, b.start), a.end = std::max(a.end, b.end);
      widen(a, b.from, b.to, b.other_from, b.other_to);
      if (b.peak_force > a.peak_force)
        a.peak_force = b.peak_force, a.peak_time = b.peak_time, a.peak_from = b.peak_from,
        a.peak_to = b.peak_to;
      a.impulse += b.impulse;
      a.peak_energy = std::max(a.peak_energy, b.peak_energy);
      a.penetration = std::max(a.penetration, b.penetration);
      open_[mine].force += open_[i].force;
      open_[mine].places.insert(open_[mine].places.end(), o.places.begin(), o.places.end());
      Sum &s = now[mine], &r = now[i];
      if (!r.places.empty()) {
        if (s.places.empty()) s.from = r.from, s.to = r.to;
        s.from = std::min(s.from, r.from), s.to = std::max(s.to, r.to);
      }
      s.force += r.force, s.energy += r.energy;
      s.places.insert(s.places.end(), r.places.begin(), r.places.end());
    }
    if (mine == open_.size()) {
      Open& o = open_.emplace_back();
      o.row.line = t.line, o.row.other_line = t.other_line;
      o.row.volume = t.volume, o.row.other_volume = t.other_volume;
      o.row.start = o.row.end = o.row.peak_time = time;
      o.row.from = t.from, o.row.to = t.to;
      o.row.other_from = t.other_from, o.row.other_to = t.other_to;
      now.emplace_back(), joined.push_back(0);
    }
    io::ClashRow& row = open_[mine].row;
    widen(row, t.from, t.to, t.other_from, t.other_to);
    row.penetration = std::max(row.penetration, t.depth);
    Sum& s = now[mine];
    if (s.places.empty()) s.from = t.from, s.to = t.to;
    s.from = std::min(s.from, t.from), s.to = std::max(s.to, t.to);
    s.force += t.force, s.energy += t.energy;
    s.places.emplace_back(t.from, t.to);
  }

  size_t kept = 0;
  for (size_t i = 0; i < open_.size(); ++i) {
    if (joined[i]) continue;
    Open& o = open_[i];
    const bool touching = !now[i].places.empty();
    if (time > time_) o.row.impulse += 0.5 * (time - time_) * (o.force + now[i].force);
    o.force = now[i].force;
    if (touching) {
      o.row.end = time;
      o.places = std::move(now[i].places);
      if (o.force > o.row.peak_force)
        o.row.peak_force = o.force, o.row.peak_time = time, o.row.peak_from = now[i].from,
        o.row.peak_to = now[i].to;
      o.row.peak_energy = std::max(o.row.peak_energy, now[i].energy);
    } else if (time - o.row.end > settings_.merge_gap) {
      end(o.row);
      continue;
    }
    if (kept != i) open_[kept] = std::move(o);
    ++kept;
  }
  open_.resize(kept);
  time_ = time;
}

void ClashLog::end(const io::ClashRow& row) {
  ended_.push_back(row);
  ++ended_count_;
  const auto at = std::upper_bound(largest_.begin(), largest_.end(), row, larger);
  if (at == largest_.end() && largest_.size() == kKept) return;
  largest_.insert(at, row);
  if (largest_.size() > kKept) largest_.pop_back();
}

std::vector<io::ClashRow> ClashLog::open() const {
  std::vector<io::ClashRow> rows;
  for (const Open& o : open_) rows.push_back(o.row);
  return rows;
}

std::vector<io::ClashRow> ClashLog::take_ended() { return std::exchange(ended_, {}); }

std::vector<io::ClashRow> ClashLog::largest(size_t most) const {
  std::vector<io::ClashRow> rows = largest_;
  for (const Open& o : open_) rows.push_back(o.row);
  std::sort(rows.begin(), rows.end(), larger);
  if (rows.size() > most) rows.resize(most);
  return rows;
}

namespace {

constexpr size_t kRow = 17;

void put(std::vector<double>& v, const io::ClashRow& r) {
  for (const int i : {r.line, r.other_line, r.volume, r.other_volume}) v.push_back(i);
  v.insert(v.end(), {r.start, r.end, r.from, r.to, r.other_from, r.other_to, r.peak_force, r.peak_time,
                     r.peak_from, r.peak_to, r.impulse, r.peak_energy, r.penetration});
}

// Reads what put() and its like wrote, in order.
class Take {
 public:
  explicit Take(const std::vector<double>& v) : v_(v) {}
  double number() {
    if (at_ >= v_.size()) throw std::invalid_argument("the clash report of the checkpoint is cut short");
    return v_[at_++];
  }
  size_t count() {
    const double n = number();
    if (!(n >= 0 && n <= static_cast<double>(v_.size())))
      throw std::invalid_argument("the clash report of the checkpoint is damaged");
    return static_cast<size_t>(n);
  }
  io::ClashRow row() {
    io::ClashRow r;
    for (int* i : {&r.line, &r.other_line, &r.volume, &r.other_volume}) *i = static_cast<int>(number());
    for (double* x : {&r.start, &r.end, &r.from, &r.to, &r.other_from, &r.other_to, &r.peak_force,
                      &r.peak_time, &r.peak_from, &r.peak_to, &r.impulse, &r.peak_energy, &r.penetration})
      *x = number();
    return r;
  }

 private:
  const std::vector<double>& v_;
  size_t at_ = 0;
};

}  // namespace

std::vector<double> ClashLog::save() const {
  std::vector<double> v{time_, static_cast<double>(ended_count_)};
  v.reserve(kRow * (open_.size() + ended_.size() + largest_.size()) + 8);
  for (const auto* rows : {&ended_, &largest_}) {
    v.push_back(static_cast<double>(rows->size()));
    for (const io::ClashRow& r : *rows) put(v, r);
  }
  v.push_back(static_cast<double>(open_.size()));
  for (const Open& o : open_) {
    put(v, o.row);
    v.push_back(o.force);
    v.push_back(static_cast<double>(o.places.size()));
    for (const auto& [from, to] : o.places) v.insert(v.end(), {from, to});
  }
  return v;
}

void ClashLog::restore(const std::vector<double>& values) {
  Take take(values);
  time_ = take.number();
  ended_count_ = static_cast<long long>(take.number());
  for (auto* rows : {&ended_, &largest_}) {
    rows->clear();
    for (size_t n = take.count(); n > 0; --n) rows->push_back(take.row());
  }
  open_.clear();
  for (size_t n = take.count(); n > 0; --n) {
    Open& o = open_.emplace_back();
    o.row = take.row();
    o.force = take.number();
    for (size_t p = take.count(); p > 0; --p) {
      const double from = take.number();
      o.places.emplace_back(from, take.number());
    }
  }
}

}  // namespace hawser::app
