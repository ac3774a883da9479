// The class ClashLog: merging of contacts into clashes, their impulse and peak force, end, ranking by force,
// and storage in a checkpoint.
#include "hawser/record/clash_log.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace hawser::record {
namespace {

constexpr size_t kKept = 1000;  // largest ones for the final table

auto pair_of(const auto& t) { return std::tuple(t.line, t.other_line, t.volume, t.other_volume); }

double merge_length(const Runs<double>& by_line, int line) {
  const size_t l = line;
  return line >= 0 && l < by_line.size() ? by_line[l] : 0;
}

// Order by decreasing force; equal forces by increasing start time.
bool larger(const io::ClashRow& a, const io::ClashRow& b) {
  return std::tuple(-a.peak_force, a.start, pair_of(a), a.from) <
         std::tuple(-b.peak_force, b.start, pair_of(b), b.from);
}

// Extends a row or contact to the range of another of the same pair.
void widen(auto& to, const auto& range) {
  to.from = std::min(to.from, range.from);
  to.to = std::max(to.to, range.to);
  to.other_from = std::min(to.other_from, range.other_from);
  to.other_to = std::max(to.other_to, range.other_to);
}

void add(ActiveContact& sum, const ActiveContact& t) {
  widen(sum, t);
  sum.force += t.force;
  sum.energy += t.energy;
  sum.depth = std::max(sum.depth, t.depth);
}

// Adds the second of two clashes that have merged to the first.
void add(io::ClashRow& sum, const io::ClashRow& r) {
  sum.start = std::min(sum.start, r.start);
  sum.end = std::max(sum.end, r.end);
  widen(sum, r);
  if (r.peak_force > sum.peak_force) {
    sum.peak_force = r.peak_force;
    sum.peak_time = r.peak_time;
    sum.peak_from = r.peak_from;
    sum.peak_to = r.peak_to;
  }
  sum.impulse += r.impulse;
  sum.peak_energy = std::max(sum.peak_energy, r.peak_energy);
  sum.penetration = std::max(sum.penetration, r.penetration);
}

}  // namespace

ActiveContacts merge_contacts(ActiveContacts touches, const Runs<double>& by_line) {
  const auto key = [](const ActiveContact& t) {
    return std::tuple(pair_of(t), t.from, t.to, t.other_from, t.other_to);
  };
  std::sort(touches.begin(), touches.end(),
            [&](const ActiveContact& a, const ActiveContact& b) { return key(a) < key(b); });
  ActiveContacts out;
  for (const ActiveContact& t : touches) {
    if (out.empty() || pair_of(out.back()) != pair_of(t) ||
        t.from > out.back().to + merge_length(by_line, t.line))
      out.push_back(t);
    else
      add(out.back(), t);
  }
  return out;
}

void ClashLog::step(double time, std::span<const ActiveContact> touches) {
  // Clashes not in contact at the last step may have been separated for too long.
  std::erase_if(open_, [&](const Open& o) {
    const bool ended = o.row.end < time_ && time - o.row.end > settings_.merge_gap;
    if (ended) end(o.row);
    return ended;
  });
  update_tracks(time, assign(time, touches));
  time_ = time;
}

// Open clashes are sorted by pair like the contacts: the cost of a step is linear in its contacts.
std::vector<ClashLog::Now> ClashLog::assign(double time, std::span<const ActiveContact> touches) {
  const size_t before = open_.size();
  std::vector<Now> now(before);
  std::vector<size_t> by_pair(before);
  for (size_t i = 0; i < before; ++i) by_pair[i] = i;
  std::stable_sort(by_pair.begin(), by_pair.end(),
                   [&](size_t a, size_t b) { return pair_of(open_[a].row) < pair_of(open_[b].row); });
  size_t known = 0;
  for (const ActiveContact& t : touches) {
    const double reach = merge_length(settings_.merge_length, t.line);
    while (known < before && pair_of(open_[by_pair[known]].row) < pair_of(t)) ++known;
    size_t joined_track = open_.size();
    for (size_t k = known; k < before && pair_of(open_[by_pair[k]].row) == pair_of(t); ++k) {
      const size_t i = by_pair[k];
      const auto& places = open_[i].places;
      const bool touches_now =
          !now[i].joined && std::any_of(places.begin(), places.end(), [&](const auto& p) {
            return t.from <= p.second + reach && p.first <= t.to + reach;
          });
      if (!touches_now) continue;
      if (joined_track < open_.size())
        join(joined_track, i, now);
      else
        joined_track = i;
    }
    if (joined_track == open_.size()) {
      io::ClashRow& row = open_.emplace_back().row;
      row.line = t.line;
      row.other_line = t.other_line;
      row.volume = t.volume;
      row.other_volume = t.other_volume;
      row.start = row.end = row.peak_time = time;
      row.from = t.from;
      row.to = t.to;
      row.other_from = t.other_from;
      row.other_to = t.other_to;
      now.emplace_back();
    }
    now[joined_track].take(t);
  }
  return now;
}

void ClashLog::Now::take(const ActiveContact& t) {
  if (places.empty())
    sum = t;
  else
    add(sum, t);
  places.emplace_back(t.from, t.to);
}

void ClashLog::join(size_t first, size_t second, std::vector<Now>& now) {
  Open& a = open_[first];
  Open& b = open_[second];
  add(a.row, b.row);
  a.force += b.force;
  a.places.insert(a.places.end(), b.places.begin(), b.places.end());
  Now& s = now[first];
  Now& r = now[second];
  r.joined = true;
  if (r.places.empty()) return;
  if (s.places.empty())
    s.sum = r.sum;
  else
    add(s.sum, r.sum);
  s.places.insert(s.places.end(), r.places.begin(), r.places.end());
}

void ClashLog::update_tracks(double time, std::vector<Now> now) {
  size_t kept = 0;
  for (size_t i = 0; i < open_.size(); ++i) {
    if (now[i].joined) continue;
    Open& o = open_[i];
    const ActiveContact& t = now[i].sum;  // without contact: zero force
    if (time > time_) o.row.impulse += 0.5 * (time - time_) * (o.force + t.force);
    o.force = t.force;
    if (!now[i].places.empty()) {
      o.row.end = time;
      o.places = std::move(now[i].places);
      widen(o.row, t);
      o.row.penetration = std::max(o.row.penetration, t.depth);
      if (t.force > o.row.peak_force) {
        o.row.peak_force = t.force;
        o.row.peak_time = time;
        o.row.peak_from = t.from;
        o.row.peak_to = t.to;
      }
      o.row.peak_energy = std::max(o.row.peak_energy, t.energy);
    } else if (time - o.row.end > settings_.merge_gap) {
      end(o.row);
      continue;
    }
    if (kept != i) open_[kept] = std::move(o);
    ++kept;
  }
  open_.resize(kept);
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

io::ClashTables ClashLog::take() {
  reported_ = {reported_.ended + static_cast<long long>(ended_.size()), open()};
  return {std::exchange(ended_, {}), reported_.open};
}

std::vector<io::ClashRow> ClashLog::largest(size_t max_rows) const {
  std::vector<io::ClashRow> rows = largest_;
  for (const Open& o : open_) rows.push_back(o.row);
  std::sort(rows.begin(), rows.end(), larger);
  if (rows.size() > max_rows) rows.resize(max_rows);
  return rows;
}

namespace {

constexpr size_t kRow = 17;

void put(std::vector<double>& v, const io::ClashRow& r) {
  for (const int i : {r.line, r.other_line, r.volume, r.other_volume}) v.push_back(i);
  v.insert(v.end(), {r.start, r.end, r.from, r.to, r.other_from, r.other_to, r.peak_force, r.peak_time,
                     r.peak_from, r.peak_to, r.impulse, r.peak_energy, r.penetration});
}

// Reads numbers in the order in which put() and related functions wrote them.
class Take {
 public:
  explicit Take(const std::vector<double>& v) : v_(v) {}
  double number() {
    if (at_ >= v_.size()) throw std::invalid_argument("the clash report of the checkpoint is truncated");
    return v_[at_++];
  }
  bool done() const { return at_ == v_.size(); }
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
  v.reserve(kRow * (open_.size() + ended_.size() + largest_.size() + reported_.open.size()) + 8);
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
  v.push_back(static_cast<double>(reported_.ended));
  v.push_back(static_cast<double>(reported_.open.size()));
  for (const io::ClashRow& r : reported_.open) put(v, r);
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
  reported_ = {ended_count_ - static_cast<long long>(ended_.size()), open()};
  if (take.done()) return;  // older file
  reported_ = {static_cast<long long>(take.number()), {}};
  for (size_t n = take.count(); n > 0; --n) reported_.open.push_back(take.row());
}

}  // namespace hawser::record
