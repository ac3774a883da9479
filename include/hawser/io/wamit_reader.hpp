// Output files of the diffraction program WAMIT, version 7 manual (2020), chapter 4: .1 added mass and
// damping, .3 (or .2) excitation, .hst hydrostatic stiffness, .7 .8 .9 mean drift, .12d difference-frequency
// forces. Each may be packed by gzip, with the ending .gz.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/hydrodynamic_data.hpp"

namespace hawser::io {

struct WamitForm {
  double length = 1;  // ULEN, m
  double density = 1025, gravity = 9.80665;
  // The forces of waves are given from one side of a body that is symmetric about x and z; those from the
  // other side are their mirror images, with sway, roll and yaw reversed.
  bool mirrored = false;
};

// Reads the files `stem`.1 and so on. Throws std::runtime_error with a whole sentence that names file and
// line where one is missing or is not what it should be. read: gets the files that were there; notes: what
// was found odd and what was assumed, a sentence each.
model::HydrodynamicData read_wamit(const std::string& stem, const WamitForm& form, SecondOrder order,
                                   std::vector<std::string>& read, std::vector<std::string>& notes);

}  // namespace hawser::io
