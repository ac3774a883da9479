// Plastic history of a line's sections along an element whose ends move over its material, at the feed point
// of a feeder.
//
// Each Gauss point of an element represents a cell with a length according to its weight and n numbers that
// are constant in the cell. Where elements are divided, joined or moved, a new cell takes the mean of the
// cells it covers: integrals over the length are preserved, and no value exceeds the range of the old ones.
// See docs/theory/feeders.md#pipes-that-yield.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hawser/kernels/beam.hpp"

namespace hawser {

struct RememberedCell {
  double from = 0, to = 0;         // m, material labels
  const double* values = nullptr;  // n numbers
};
// Cells of an element with the labels [from, to], first at `from`; values: kBendingPlaces blocks of n.
std::array<RememberedCell, kBendingPlaces> remembered_cells(double from, double to, const double* values,
                                                            std::size_t n);
// History out[kBendingPlaces * n] of an element with the labels [from, to], which `cells` cover exactly once.
void remember_cells(std::span<const RememberedCell> cells, std::size_t n, double from, double to,
                    double* out);

// Bending energy stored and dissipated by an element at a feed point per metre of growth at fixed ends, J/m.
// entering: history of the entering material, PlasticBending::memory() numbers; null: material leaves.
// second_end: the feeder is at the second end.
double fed_bending_work(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool second_end,
                        const double* entering);

}  // namespace hawser
