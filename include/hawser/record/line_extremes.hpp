// The table of extremes: of each line the largest (or smallest) value of some fields over all steps, with the
// time and the place.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/utilisation.hpp"

namespace hawser {
class Feeders;
}

namespace hawser::record {

// Of an extreme, "t = 2.5 s", or "at rest" where the run begins with its static equilibrium.
std::string when_text(const model::Case& c, double time);

class LineExtremes {
 public:
  // fields: those of which add() gets the values; feeders: null where no line is fed.
  LineExtremes(MPI_Comm comm, const model::Case& c, const LocalMesh& local, const Feeders* feeders,
               const std::vector<io::ResultField>& fields);

  // An accepted step: values by field, of the owned nodes; a utilisation that is not known
  // does not count, nor what is inside a feeder.
  void add(double time, const std::vector<std::vector<double>>& values, const Utilisation& utilisation);
  // The rows of all lines, those of a line together, the same on all ranks. Collective.
  std::vector<io::SummaryRow> table() const;

  void save(io::Checkpoint& to) const;  // collective
  void restore(const io::Checkpoint& from);

 private:
  struct Extreme {
    double value = 0, time = 0, arc = 0;
    bool set = false;
  };
  struct Quantity {
    std::string name, unit;
    std::vector<size_t> fields;
    bool largest = true;
    std::vector<Extreme> lines;  // of this rank's nodes
  };
  MPI_Comm comm_;
  const LocalMesh& local_;
  const Feeders* feeders_;
  std::vector<std::string> names_;  // of lines
  std::vector<Quantity> quantities_;
};

}  // namespace hawser::record
