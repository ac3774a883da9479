// The class ClashLog: merging of contacts into clashes, their impulse and peak force, end, ranking by force,
// and storage in a checkpoint.
#include "hawser/record/clash_log.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace hawser::record {
namespace {

constexpr size_t kKept = 1000;  // largest ones for the final table

// Kinds of the records of a checkpoint, in the order of checkpoint_kinds().
constexpr int kSums = 0, kOpen = 1, kPlaces = 2, kEnded = 3, kLargest = 4, kReported = 5;

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

std::vector<CheckpointKind> ClashLog::checkpoint_kinds() {
  return {checkpoint_kind<KeptSums>("sums of the clash report"),
          checkpoint_kind<KeptOpen>("open clashes"),
          checkpoint_kind<KeptPlace>("places of open clashes"),
          checkpoint_kind<io::ClashRow>("ended clashes"),
          checkpoint_kind<io::ClashRow>("largest clashes"),
          checkpoint_kind<io::ClashRow>("reported open clashes")};
}

std::vector<CheckpointRecord> ClashLog::save() const {
  std::vector<CheckpointRecord> records{
      record_of(0, 0, KeptSums{time_, ended_count_, reported_.ended}, kSums)};
  CheckpointRecord of_open{0, 0, {}, kOpen};
  CheckpointRecord of_places{0, 0, {}, kPlaces};
  for (const Open& o : open_) {
    put(KeptOpen{o.row, o.force, o.places.size()}, of_open.values);
    for (const auto& [from, to] : o.places) put(KeptPlace{from, to}, of_places.values);
  }
  records.push_back(std::move(of_open));
  records.push_back(std::move(of_places));
  for (const auto& [kind, rows] :
       {std::pair{kEnded, &ended_}, {kLargest, &largest_}, {kReported, &reported_.open}}) {
    CheckpointRecord& of_rows = records.emplace_back(CheckpointRecord{0, 0, {}, kind});
    for (const io::ClashRow& r : *rows) put(r, of_rows.values);
  }
  return records;
}

void ClashLog::restore(const std::vector<CheckpointRecord>& records) {
  const auto record = [&](int kind) {
    const CheckpointRecord* r = find_record(records, 0, 0, kind);
    return r ? *r : CheckpointRecord{};
  };
  const auto kept = entry<KeptSums>(record(kSums));
  time_ = kept.time;
  ended_count_ = kept.ended;
  const auto all_places = entries<KeptPlace>(record(kPlaces));
  size_t next = 0;
  open_.clear();
  for (const KeptOpen& o : entries<KeptOpen>(record(kOpen))) {
    if (o.places > all_places.size() - next)
      throw std::invalid_argument("the clash report of the checkpoint is damaged");
    Open& restored = open_.emplace_back(Open{o.row, {}, o.force});
    for (size_t p = 0; p < o.places; ++p, ++next)
      restored.places.emplace_back(all_places[next].from, all_places[next].to);
  }
  ended_ = entries<io::ClashRow>(record(kEnded));
  largest_ = entries<io::ClashRow>(record(kLargest));
  reported_ = {kept.reported_ended, entries<io::ClashRow>(record(kReported))};
}

}  // namespace hawser::record
