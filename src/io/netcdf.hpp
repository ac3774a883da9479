// Reader of NetCDF variables: version 4, which is HDF5, and the classic formats (versions 1, 2 and 5).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"

namespace hawser::io {

struct NetcdfVariable {
  std::vector<std::string> dimensions;
  h5::Shape shape;                 // of these dimensions
  std::vector<double> values;      // numeric variables, last dimension fastest
  std::vector<std::string> texts;  // character variables, without the dimension of their length
};

// Those of the named variables that the file has. Throws std::runtime_error with a whole sentence that names
// the file if it is unreadable.
std::map<std::string, NetcdfVariable> read_netcdf(const std::string& path,
                                                  const std::vector<std::string>& names);

// The same for files that begin with "CDF"; `bytes` is the content of the file. Unidata, "NetCDF Classic
// Format Specification".
std::map<std::string, NetcdfVariable> read_netcdf_classic(const std::string& bytes,
                                                          const std::vector<std::string>& names);

}  // namespace hawser::io
