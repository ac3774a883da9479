// Variables of a NetCDF file: of version 4, which is HDF5, or of the classic formats (versions 1, 2 and 5).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"

namespace hawser::io {

struct NetcdfVariable {
  std::vector<std::string> dimensions;
  h5::Shape shape;                 // of those
  std::vector<double> values;      // of numbers, the last dimension fastest
  std::vector<std::string> texts;  // of characters: without the dimension of their length
};

// Those of the names that the file has. std::runtime_error, a whole sentence that names the file, where it
// cannot be read.
std::map<std::string, NetcdfVariable> read_netcdf(const std::string& path,
                                                  const std::vector<std::string>& names);

// The same for files that begin with "CDF"; `bytes` are all of the file. Unidata, "NetCDF Classic Format
// Specification".
std::map<std::string, NetcdfVariable> read_netcdf_classic(const std::string& bytes,
                                                          const std::vector<std::string>& names);

}  // namespace hawser::io
