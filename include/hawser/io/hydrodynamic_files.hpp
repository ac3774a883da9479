// Readers of output files of diffraction programs; results are in the convention of
// model/hydrodynamic_data.hpp.
//   WAMIT, version 7 manual (2020), chapter 4: .1 added mass and damping, .3 (or .2) excitation, .hst
//   hydrostatic stiffness, .7 .8 .9 mean drift, .12d difference-frequency forces; each may be packed by gzip.
//   Capytaine, user manual, "Export outputs" and "Conventions": one NetCDF file.
//   BEMIO of WEC-Sim, user manual, "BEMIO": one HDF5 file.
// Each throws std::runtime_error with a whole sentence that names the file and the line or variable if a file
// is missing or invalid. read: receives the files found; notes: anomalies and assumptions, one sentence each.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/hydrodynamic_data.hpp"

namespace hawser::io {

struct HydrodynamicForm {
  double length = 1;  // ULEN of WAMIT's files, m
  double density = 1025, gravity = 9.80665;
  // Wave forces are given from one side of a body with port-starboard symmetry; those from the other side are
  // mirror images, with sway, roll and yaw reversed.
  bool mirrored = false;
  double depth = 0;  // of the water, m; 0: infinite
};

// Reads `stem`.1 and so on.
model::HydrodynamicData read_wamit(const std::string& stem, const HydrodynamicForm& form, SecondOrder order,
                                   std::vector<std::string>& read, std::vector<std::string>& notes);

// Values are SI for the density and gravity in the file; forces are scaled to the density of `form`.
model::HydrodynamicData read_capytaine(const std::string& path, const HydrodynamicForm& form,
                                       SecondOrder order, std::vector<std::string>& read,
                                       std::vector<std::string>& notes);

// Added mass over rho, damping over rho omega, forces and stiffness over rho g.
model::HydrodynamicData read_bemio(const std::string& path, const HydrodynamicForm& form, SecondOrder order,
                                   std::vector<std::string>& read, std::vector<std::string>& notes);

}  // namespace hawser::io
