// Fields of a fed line at stations that are fixed relative to its feeder while the line moves through them.
#pragma once

#include <mpi.h>

#include <map>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

// A fed line has as many stations as nodes. Station i, counted from the fed end, coincides with node i when
// the whole line is outside: the unstretched length between it and the feeder equals that between node i and
// the end. A line fed at both ends has the stations of end A.
class Stations {
 public:
  // For the node fields that are kept at stations; feeders: null if no line is fed. Mesh and feeders must
  // outlive the object.
  Stations(MPI_Comm comm, const LocalMesh& mesh, const Feeders* feeders,
           const std::vector<io::ResultField>& fields);

  // Names end with "_at_stations".
  const std::vector<io::ResultField>& fields() const { return fields_; }
  // values: the constructor's fields, by field and owned node. Returns fields() by field and owned node, with
  // the value at station i in the place of node i: linear between free nodes, constant from the last free
  // node to the feed point; NaN outside the line and for lines that are not fed. Collective.
  const std::vector<std::vector<double>>& at(const std::vector<std::vector<double>>& values);

 private:
  void fill(const Feeder& f, const std::vector<std::vector<double>>& values);

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  const Feeders* feeders_;
  std::vector<io::ResultField> fields_;
  std::vector<std::size_t> place_;  // index of each among all fields
  std::vector<std::vector<double>> values_;
  std::map<int, std::vector<double>> arcs_;  // m, of the nodes of each fed line with nodes of this rank
  std::vector<int> cut_lines_;               // lines whose nodes more than one rank owns, ascending
};

}  // namespace hawser::record
