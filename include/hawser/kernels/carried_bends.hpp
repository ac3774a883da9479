// What sections of a line remember, along an element whose ends move over its material: at the feed point of
// a feeder.
//
// Every Gauss point of an element stands for a cell of its length, as long as its weight says, with n numbers
// that are the same in all of the cell. Where elements are divided, joined or moved, a new cell has the mean
// of what it covers: sums over the length stay, and nothing is beyond what was there. See
// docs/theory/feeders.md#pipes-that-yield.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hawser/kernels/beam.hpp"

namespace hawser {

struct RememberedCell {
  double from = 0, to = 0;         // m, labels of the material
  const double* values = nullptr;  // n numbers
};
// Of an element with the labels [from, to], the first cell at `from`; values: kBendingPlaces blocks of n.
std::array<RememberedCell, kBendingPlaces> remembered_cells(double from, double to, const double* values,
                                                            std::size_t n);
// What the element with the labels [from, to] remembers, all of which `cells` cover once: out[kBendingPlaces
// * n].
void remember_cells(std::span<const RememberedCell> cells, std::size_t n, double from, double to,
                    double* out);

// Of an element at the feed point of a feeder, whose bends are remembered: what its bending takes for a metre
// by which it grows at fixed ends, J/m, stored and lost. entering: what the material remembers that enters,
// PlasticBending::memory() numbers; null: material leaves. at_b: the feeder is at the second end.
double fed_bending_work(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool at_b,
                        const double* entering);

}  // namespace hawser
