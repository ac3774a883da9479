// The table of `hawser check --radiation`: radiation properties of bodies as read.
#pragma once

#include <mpi.h>

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::run {

// Writes, for the bodies of a case with hydrodynamic coefficients, their retardation functions K(t), damping
// and added mass of the files by frequency, and the added mass that the damping has by Ogilvie's relation, as
// one CSV file; of several groups of bodies a file each, named after their first body. Prints where. Throws
// InputError and WriteError. Collective.
void write_radiation(MPI_Comm comm, const model::Case& c, const std::string& path);

}  // namespace hawser::run
