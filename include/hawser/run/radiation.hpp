// The table of `hawser check --radiation`: radiation properties of bodies as read.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace hawser::run {

// Writes a CSV file for the bodies with hydrodynamic coefficients: retardation functions K(t), damping and
// added mass of the files by frequency, and added mass from damping by Ogilvie's relation; several groups of
// bodies have one file each, named after their first body. Prints the path. Throws InputError and WriteError.
// Collective.
void write_radiation(MPI_Comm comm, const std::string& case_path, const std::vector<std::string>& changes,
                     const std::string& path);

}  // namespace hawser::run
