// The class StructureTerm at feeders: unstretched lengths at the feed point, and the history of sections that
// yield while they pass through it (docs/theory/feeders.md#pipes-that-yield).
#include <algorithm>

#include "hawser/base/gather.hpp"
#include "hawser/kernels/carried_bends.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/structure.hpp"

namespace hawser {
namespace {

// Converts between the order of an element, from end A to end B, and that of the labels, from the free node
// on.
std::vector<double> turned(const double* values, size_t n, bool at_b) {
  std::vector<double> out(kBendingPlaces * n);
  for (size_t k = 0; k < kBendingPlaces; ++k)
    std::copy_n(values + k * n, n, out.data() + (at_b ? k : kBendingPlaces - 1 - k) * n);
  return out;
}

BeamEnds positions(const StructureTerm::Beam& b, const Kinematics& k) {
  const size_t i = b.at.first, j = b.at.second;
  return {k.x[i], k.x[j], k.q[i], k.q[j]};
}

// History of the material inside the feeder, by label from the free node on: of the element at the feed point
// and of the next element in stock.
std::vector<RememberedCell> inside(const Feeders& feeders, const Feeder& f,
                                   const std::vector<double>& values) {
  const size_t n = values.size() / (2 * kBendingPlaces);
  const double first = feeders.element_length(f, f.feed_point),
               second = first + feeders.element_length(f, std::max(f.feed_point - 1, 0));
  std::vector<RememberedCell> out;
  for (const RememberedCell& c : remembered_cells(0, first, values.data(), n)) out.push_back(c);
  for (const RememberedCell& c : remembered_cells(first, second, values.data() + kBendingPlaces * n, n))
    out.push_back(c);
  return out;
}

}  // namespace

// Allocates the history of sections inside feeders, for lines that yield. These sections have never been
// bent.
void StructureTerm::fed_by(Feeders* feeders) {
  feeders_ = feeders;
  fed_.clear();
  for (const Feeder& f : feeders_ ? feeders_->list() : std::vector<Feeder>{}) {
    FedBends& fed = fed_.emplace_back();
    if (f.bar.plastic) fed.inside.assign(2 * kBendingPlaces * f.bar.plastic->memory(), 0);
  }
}

void StructureTerm::update_from_feeders(const Kinematics& at, bool accepted) {
  if (!feeders_) return;
  for (Cable& c : cables_)
    if (const auto rest = feeders_->element_state(c.at.global, at, true)) {
      c.idle = rest->idle;
      c.section.length = rest->length;
      c.section.length_by_chord = rest->length_by_chord;
      c.section.length_rate = at.step > 0 ? rest->length_rate : 0;
    }  // in statics the feeder is held
  for (Beam& b : beams_) {
    const auto rest = feeders_->element_state(b.at.global, at, true);
    if (!rest) continue;
    b.idle = rest->idle;
    b.section.length = rest->length;
    b.section.length_by_force = rest->length_by_force;
    if (!b.section.plastic) continue;
    b.reference.set = set_.data() + b.memory;
    if (rest->feeder < 0) continue;
    // The history does not depend on the force of a trial: like masses it uses the length at the speed of the
    // start of the step.
    const double to = accepted ? rest->length : feeders_->element_state(b.at.global, at, false)->length;
    carry_bends(b, rest->feeder, rest->before, to);
  }
}

// History of the material at this label, which is inside the feeder.
std::vector<double> StructureTerm::entering(int feeder, double label) const {
  std::vector<double> out;
  for (const RememberedCell& c : inside(*feeders_, feeders_->list()[feeder], fed_[feeder].inside))
    if (out.empty() || c.from <= label)
      out.assign(c.values, c.values + fed_[feeder].inside.size() / (2 * kBendingPlaces));
  return out;
}

// Sets the history of the element at the feed point for the length `to`; at the start of the step its length
// was `from`.
void StructureTerm::carry_bends(Beam& b, int feeder, double from, double to) {
  if (from == to) return;
  const Feeder& f = feeders_->list()[feeder];
  FedBends& fed = fed_[feeder];
  const size_t n = b.section.plastic->memory();
  const std::vector<double> values = turned(set_.data() + b.memory, n, f.at_b);
  std::vector<RememberedCell> cells;
  for (const RememberedCell& c : remembered_cells(0, from, values.data(), n)) cells.push_back(c);
  for (const RememberedCell& c : inside(*feeders_, f, fed.inside))
    if (c.to > from) cells.push_back({std::max(c.from, from), c.to, c.values});
  std::vector<double> now(kBendingPlaces * n);
  remember_cells(cells, n, 0, to, now.data());
  fed.trial = turned(now.data(), n, f.at_b);
  b.reference.set = fed.trial.data();
}

// Stores the history of material that is hauled into the feeder and held straight there. A cell inside takes
// the history at its middle.
void StructureTerm::keep_hauled_in(const Beam& b, int feeder, double from, double to) {
  if (!(to < from)) return;
  const Feeder& f = feeders_->list()[feeder];
  const size_t n = b.section.plastic->memory();
  const std::vector<double> values = turned(set_.data() + b.memory, n, f.at_b);
  std::vector<double>& kept = fed_[feeder].inside;
  for (const RememberedCell& c : inside(*feeders_, f, kept)) {
    const double middle = 0.5 * (c.from + c.to);
    if (middle > from || middle <= to) continue;
    double* in = kept.data() + (c.values - kept.data());
    for (const RememberedCell& was : remembered_cells(0, from, values.data(), n))
      if (was.from <= middle && middle <= was.to) std::copy_n(was.values, n, in);
    b.section.plastic->bend(0, 0, in);
  }
}

// Work of the feeders on bends in the step that led to `at`, J: the mean of the values at its start and end
// times the length paid out. Must be called before bend().
double StructureTerm::fed_work(const Kinematics& at) const {
  double work = 0;
  const State& before = feeders_->before();
  for (const Beam& b : beams_) {
    if (!b.section.plastic || !b.at.counted || before.x.size() != at.x.size()) continue;
    const auto rest = feeders_->element_state(b.at.global, at, true);
    if (!rest || rest->feeder < 0 || rest->length == rest->before) continue;
    const bool at_b = feeders_->list()[rest->feeder].at_b;
    const double grown = rest->length - rest->before;
    const std::vector<double> in = entering(rest->feeder, rest->before + 0.5 * grown);
    const double* enters = grown > 0 ? in.data() : nullptr;
    BeamSection then = b.section;
    BeamReference as_then = b.reference;
    then.length = rest->before;
    as_then.set = set_.data() + b.memory;
    work += 0.5 * grown *
            (fed_bending_work(then, as_then, positions(b, before.view(0)), at_b, enters) +
             fed_bending_work(b.section, b.reference, positions(b, at), at_b, enters));
  }
  return work;
}

void StructureTerm::transfer_node(MPI_Comm comm, const Feeder& f, int feed_point) {
  if (!yields_) return;
  const size_t k = &f - feeders_->list().data();
  const size_t n = fed_.empty() ? 0 : fed_[k].inside.size() / (2 * kBendingPlaces);
  if (n == 0) return;
  const size_t size = kBendingPlaces * n;
  const auto beam = [&](int i) -> Beam* {
    if (i < 0 || i >= feeders_->elements(f)) return nullptr;
    const int global = feeders_->element(f, i);
    const auto at = std::lower_bound(beams_.begin(), beams_.end(), global,
                                     [](const Beam& b, int g) { return b.at.global < g; });
    return at != beams_.end() && at->at.global == global && at->section.plastic ? &*at : nullptr;
  };
  // Collects on all ranks, by label: the history of the element at the feed point, of the one after it and of
  // the second before it, and the history inside.
  std::vector<double> all(5 * size, 0);
  const auto part = [&](size_t i) { return all.data() + i * size; };
  const int elements[] = {f.feed_point, f.feed_point + 1, f.feed_point - 2};
  for (size_t i = 0; i < 3; ++i)
    if (const Beam* b = beam(elements[i]); b && b->at.counted) {
      const std::vector<double> values = turned(set_.data() + b->memory, n, f.at_b);
      std::copy(values.begin(), values.end(), part(i));
      if (i == 0) std::copy(fed_[k].inside.begin(), fed_[k].inside.end(), part(3));
    }
  all_reduce(comm, MPI_SUM, all);
  const auto keep = [&](int element, const std::vector<double>& values) {
    Beam* b = beam(element);
    if (!b) return;
    const std::vector<double> own = turned(values.data(), n, f.at_b);
    std::copy(own.begin(), own.end(), set_.begin() + static_cast<std::ptrdiff_t>(b->memory));
  };
  std::vector<RememberedCell> cells;
  for (const RememberedCell& c : remembered_cells(0, f.length, part(0), n)) cells.push_back(c);
  std::vector<double> now(size);
  std::vector<double>& kept = fed_[k].inside;
  // The element is divided into its free part and the new element at the feed point.
  if (feed_point < f.feed_point) {
    const double whole = feeders_->element_length(f, f.feed_point);
    remember_cells(cells, n, 0, whole, now.data());
    keep(f.feed_point, now);
    remember_cells(cells, n, whole, f.length, now.data());
    keep(feed_point, now);
    std::copy_n(part(4), size, kept.begin());
    std::copy_n(part(2), size, kept.begin() + static_cast<std::ptrdiff_t>(size));
  } else {  // The element is joined with the one after it, whose material has labels below 0.
    const double length = feeders_->element_length(f, f.feed_point + 1);
    for (const RememberedCell& c : remembered_cells(-length, 0, part(1), n)) cells.push_back(c);
    remember_cells(cells, n, -length, f.length, now.data());
    keep(feed_point, now);
    keep(f.feed_point - 1, {part(4), part(4) + size});
    std::fill_n(kept.begin(), size, 0.0);
    std::copy_n(part(3), size, kept.begin() + static_cast<std::ptrdiff_t>(size));
  }
}

}  // namespace hawser
