// Fields of a line that is fed at places that stay with its feeder while the line runs through them.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

// A fed line has as many stations as nodes. Counted from the fed end, station i is where node i is when all
// of the line is outside: as much unstretched line lies between it and the feeder as between node i and that
// end. Of a line that is fed at both ends they are those of end A.
class Stations {
 public:
  // Of those fields of the nodes that are kept at stations; feeders: null where no line is fed. Outlived by
  // mesh and feeders.
  Stations(MPI_Comm comm, const LocalMesh& mesh, const Feeders* feeders,
           const std::vector<io::ResultField>& fields);

  // Their names end with "_at_stations".
  const std::vector<io::ResultField>& fields() const { return fields_; }
  // values: of the constructor's fields, by field and owned node. Of fields(), by field and owned node, in
  // the place of node i what the line has at station i: linear between its free nodes, in the element at the
  // feed point that of its free node; NaN where the line is not, and of lines that are not fed. Collective.
  const std::vector<std::vector<double>>& at(const std::vector<std::vector<double>>& values);

 private:
  void fill(const Feeder& f, const std::vector<std::vector<double>>& values);

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  const Feeders* feeders_;
  std::vector<io::ResultField> fields_;
  std::vector<std::size_t> place_;  // of each, among all fields
  std::vector<std::vector<double>> values_;
};

}  // namespace hawser::record
