// The class LineStructure at feeders: unstretched lengths at the feed point, and history of plastic sections
// that pass through it (docs/theory/feeders.md#pipes-that-yield).
#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/kernels/plastic_history.hpp"
#include "hawser/terms/line_structure.hpp"

namespace hawser {
namespace {

// Converts between the order of an element, from end A to end B, and that of the labels, from the free node.
std::vector<double> turned(const double* values, size_t n, LineEnd line_end) {
  std::vector<double> out(kBendingPlaces * n);
  for (size_t k = 0; k < kBendingPlaces; ++k)
    std::copy_n(values + k * n, n, out.data() + (line_end == LineEnd::B ? k : kBendingPlaces - 1 - k) * n);
  return out;
}

BeamEnds positions(const LineStructure::Beam& b, const Kinematics& k) {
  const size_t i = b.element.first;
  const size_t j = b.element.second;
  return {k.x[i], k.x[j], k.q[i], k.q[j]};
}

// Index step to the next element away from the feeder.
int outwards(const FedLine& f) { return f.line_end == LineEnd::B ? -1 : 1; }

// History of the material inside the feeder by label from the free node: the element at the feed point and
// the next element in stock.
std::vector<RememberedCell> inside(const Mesh& mesh, const FedLine& f, const std::vector<double>& values) {
  const size_t n = values.size() / (2 * kBendingPlaces);
  const int next = f.inside[0] < f.inside[1] ? f.element - outwards(f) : f.element;
  const double first = mesh.element(f.element).length;
  const double second = first + mesh.element(next).length;
  std::vector<RememberedCell> out;
  for (const RememberedCell& c : remembered_cells(0, first, values.data(), n)) out.push_back(c);
  for (const RememberedCell& c : remembered_cells(first, second, values.data() + kBendingPlaces * n, n))
    out.push_back(c);
  return out;
}

}  // namespace

void LineStructure::update_from_feeders(const Kinematics& state, bool accepted) {
  if (!feeders_) return;
  feeders_->update_lengths(mesh_, &FedLine::length, cables_);
  feeders_->update_lengths(mesh_, &FedLine::length, beams_);
  for (Cable& c : cables_) {
    const FedLine* fed = feeders_->find(c.element.global);
    c.section.length_by_chord = fed ? fed->length_by_chord : 0;
    c.section.length_rate = fed && state.moves() ? fed->length_rate : 0;  // in statics the feeder is held
  }
  for (Beam& b : beams_) {
    const FedLine* fed = feeders_->find(b.element.global);
    b.section.length_by_force = fed ? fed->length_by_force : 0;
    if (!b.section.plastic) continue;
    b.reference.set = plastic_history_.data() + b.memory;
    // The history does not depend on the force of a trial: as for masses, the length is that at the speed of
    // the start of the step.
    if (fed) move_plastic_history(b, *fed, accepted ? fed->length : fed->predicted);
  }
}

// History of the material inside the feeder at this label.
std::vector<double> LineStructure::entering(const FedLine& f, double label) const {
  std::vector<double> out;
  const std::vector<double>& kept = fed_[f.feeder].inside;
  for (const RememberedCell& c : inside(*mesh_.mesh, f, kept))
    if (out.empty() || c.from <= label) out.assign(c.values, c.values + kept.size() / (2 * kBendingPlaces));
  return out;
}

// Sets the history of the element at the feed point for the length `to`.
void LineStructure::move_plastic_history(Beam& b, const FedLine& f, double to) {
  const double from = f.before;
  if (from == to) return;
  FedBends& fed = fed_[f.feeder];
  const size_t n = b.section.plastic->memory();
  const std::vector<double> values = turned(plastic_history_.data() + b.memory, n, f.line_end);
  std::vector<RememberedCell> cells;
  for (const RememberedCell& c : remembered_cells(0, from, values.data(), n)) cells.push_back(c);
  for (const RememberedCell& c : inside(*mesh_.mesh, f, fed.inside))
    if (c.to > from) cells.push_back({std::max(c.from, from), c.to, c.values});
  std::vector<double> now(kBendingPlaces * n);
  remember_cells(cells, n, 0, to, now.data());
  fed.trial = turned(now.data(), n, f.line_end);
  b.reference.set = fed.trial.data();
}

// Stores the history of material that is hauled in and held straight inside the feeder. A cell inside takes
// the history at its middle.
void LineStructure::keep_hauled_in(const Beam& b, const FedLine& f) {
  const double from = f.before;
  const double to = f.length;
  if (!(to < from)) return;
  const size_t n = b.section.plastic->memory();
  const std::vector<double> values = turned(plastic_history_.data() + b.memory, n, f.line_end);
  std::vector<double>& kept = fed_[f.feeder].inside;
  for (const RememberedCell& c : inside(*mesh_.mesh, f, kept)) {
    const double middle = 0.5 * (c.from + c.to);
    if (middle > from || middle <= to) continue;
    double* target = kept.data() + (c.values - kept.data());
    for (const RememberedCell& old : remembered_cells(0, from, values.data(), n))
      if (old.from <= middle && middle <= old.to) std::copy_n(old.values, n, target);
    b.section.plastic->bend(0, 0, target);
  }
}

// Work of the feeders on plastic bending in the step that led to `state`, J: mean of the values at start and
// end, times the length paid out. Must be called before commit_plastic().
double LineStructure::fed_work(const Kinematics& state) const {
  double work = 0;
  const State& before = feeders_->before();
  for (const Beam& b : beams_) {
    if (!b.section.plastic || !b.element.counted || before.x.size() != state.x.size()) continue;
    const FedLine* fed = feeders_->find(b.element.global);
    if (!fed || fed->length == fed->before) continue;
    const double grown = fed->length - fed->before;
    const std::vector<double> entering_values = entering(*fed, fed->before + 0.5 * grown);
    const double* enters = grown > 0 ? entering_values.data() : nullptr;
    BeamSection then = b.section;
    BeamReference as_then = b.reference;
    then.length = fed->before;
    as_then.set = plastic_history_.data() + b.memory;
    work +=
        0.5 * grown *
        (fed_bending_work(then, as_then, positions(b, before.at_rest()), fed->line_end == LineEnd::B,
                          enters) +
         fed_bending_work(b.section, b.reference, positions(b, state), fed->line_end == LineEnd::B, enters));
  }
  return work;
}

void LineStructure::transfer_node(MPI_Comm comm, size_t feeder, bool releases) {
  std::vector<double>& kept = fed_[feeder].inside;
  const size_t n = kept.size() / (2 * kBendingPlaces);
  if (n == 0) return;
  const Mesh& mesh = *mesh_.mesh;
  const FedLine& f = feeders_->fed()[feeder];
  const int out = outwards(f);
  const size_t size = kBendingPlaces * n;
  const auto beam = [&](int global) -> Beam* {
    const auto at = std::lower_bound(beams_.begin(), beams_.end(), global,
                                     [](const Beam& b, int g) { return b.element.global < g; });
    return at != beams_.end() && at->element.global == global && at->section.plastic ? &*at : nullptr;
  };
  // Collects on all ranks, by label, the history of the element at the feed point, of the next one and of the
  // second before it, and the history inside.
  std::vector<double> all(5 * size, 0);
  const auto part = [&](size_t i) { return all.data() + i * size; };
  const int elements[] = {f.element, f.element + out, f.element - 2 * out};
  for (size_t i = 0; i < 3; ++i)
    if (const Beam* b = beam(elements[i]); b && b->element.counted) {
      const std::vector<double> values = turned(plastic_history_.data() + b->memory, n, f.line_end);
      std::copy(values.begin(), values.end(), part(i));
      if (i == 0) std::copy(kept.begin(), kept.end(), part(3));
    }
  all_reduce(comm, MPI_SUM, all);
  const auto keep = [&](int element, const std::vector<double>& values) {
    Beam* b = beam(element);
    if (!b) return;
    const std::vector<double> values_of_element = turned(values.data(), n, f.line_end);
    std::copy(values_of_element.begin(), values_of_element.end(),
              plastic_history_.begin() + static_cast<std::ptrdiff_t>(b->memory));
  };
  std::vector<RememberedCell> cells;
  for (const RememberedCell& c : remembered_cells(0, f.length, part(0), n)) cells.push_back(c);
  std::vector<double> now(size);
  // Divides the element into its free part and the new element at the feed point.
  if (releases) {
    const double mesh_length = mesh.element(f.element).length;
    remember_cells(cells, n, 0, mesh_length, now.data());
    keep(f.element, now);
    remember_cells(cells, n, mesh_length, f.length, now.data());
    keep(f.element - out, now);
    std::copy_n(part(4), size, kept.begin());
    std::copy_n(part(2), size, kept.begin() + static_cast<std::ptrdiff_t>(size));
  } else {  // The element is joined with the one after it, whose material has labels below 0.
    const double length = mesh.element(f.element + out).length;
    for (const RememberedCell& c : remembered_cells(-length, 0, part(1), n)) cells.push_back(c);
    remember_cells(cells, n, -length, f.length, now.data());
    keep(f.element + out, now);
    keep(f.element - out, {part(4), part(4) + size});
    std::fill_n(kept.begin(), size, 0.0);
    std::copy_n(part(3), size, kept.begin() + static_cast<std::ptrdiff_t>(size));
  }
}

}  // namespace hawser
