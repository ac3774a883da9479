// Size of all datasets by rows, both checkpoint slots with their reserve, meshes, and HDF5 metadata.
#include "hawser/io/results_size.hpp"

#include <hdf5.h>

#include "hawser/io/results_build.hpp"

namespace hawser::io {
namespace {

constexpr double kOfDataset = 830;  // bytes of header, name and attributes, measured
constexpr double kSpare = 1.5;      // reserve of a checkpoint slot over the first checkpoint (ResultsFile)
constexpr double kNode = 20;        // bytes: arc length, line, number, and entry in the line's cell

}  // namespace

ResultsSize results_size(const ResultContents& c, const ExpectedRows& rows) {
  ResultsSize size;
  for (const RowSet& s : row_sets(c)) {
    double row = static_cast<double>(H5Tget_size(s.type));
    for (const hsize_t n : s.tail) row *= static_cast<double>(n);
    if (s.rows_by == RowsBy::contact)
      size.contact_point += row;
    else if (s.rows_by == RowsBy::step)
      size.histories += row * rows.steps;
    else if (s.rows_by == RowsBy::node)
      size.fields += row * c.nodes_total();
    else
      (s.name.starts_with("volumes/") ? size.meshes : size.fields) += row * rows.outputs;
    size.other += kOfDataset;
  }
  for (const VolumeMesh& v : c.volumes) {
    size.meshes +=
        24.0 * static_cast<double>(v.vertices.size()) + 13.0 * static_cast<double>(v.triangles.size());
    size.other += 3 * kOfDataset;
  }
  if (rows.checkpoint > 0) size.checkpoints = 2 * kSpare * sizeof(double) * rows.checkpoint;
  size.other += 20 * kOfDataset + kNode * c.nodes_total() +
                static_cast<double>(c.run.case_text.size() + c.run.case_read.size());
  return size;
}

double checkpoint_numbers(const Checkpoint& c) {
  double n = 1 + static_cast<double>(c.scalars.size());
  for (const auto& [name, field] : c.nodes)
    n += static_cast<double>((field.make ? field.make() : field.values).size());
  for (const auto& [name, kept] : c.records) {
    n += 1;
    for (const CheckpointRecord& r : kept.make ? kept.make({}) : kept.records)
      n += 4 + static_cast<double>(r.values.size());
  }
  return n;
}

}  // namespace hawser::io
