// NetCDF 4: each variable is an HDF5 dataset whose attribute DIMENSION_LIST refers to the datasets of its
// dimensions (HDF5 dimension scales).
#include "netcdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace hawser::io {
namespace {

std::string name_of(hid_t object) {
  std::string name(static_cast<size_t>(std::max<ssize_t>(H5Iget_name(object, nullptr, 0), 0)) + 1, '\0');
  H5Iget_name(object, name.data(), name.size());
  name.pop_back();
  return name.substr(name.rfind('/') + 1);
}

// Names of the dimensions of a variable; a variable without the list is its own dimension.
std::vector<std::string> dimensions_of(hid_t file, hid_t variable, const std::string& name, size_t rank) {
  if (H5Aexists(variable, "DIMENSION_LIST") <= 0)
    return std::vector<std::string>(rank, rank == 1 ? name : "");
  const h5::Id list =
      h5::own(H5Aopen(variable, "DIMENSION_LIST", H5P_DEFAULT), H5Aclose, "attribute DIMENSION_LIST");
  const h5::Id type = h5::own(H5Aget_type(list), H5Tclose, "attribute DIMENSION_LIST");
  const h5::Id space = h5::own(H5Aget_space(list), H5Sclose, "attribute DIMENSION_LIST");
  std::vector<hvl_t> references(
      static_cast<size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
  h5::check(H5Aread(list, type, references.data()), "attribute DIMENSION_LIST");
  std::vector<std::string> names;
  for (const hvl_t& r : references) {
    if (r.len == 0) {
      names.push_back("");
      continue;
    }
    const h5::Id scale = h5::own(H5Rdereference2(file, H5P_DEFAULT, H5R_OBJECT, r.p), H5Oclose, "dimension");
    names.push_back(name_of(scale));
  }
  h5::check(H5Dvlen_reclaim(type, space, H5P_DEFAULT, references.data()), "attribute DIMENSION_LIST");
  return names;
}

std::vector<std::string> texts_of(hid_t variable, hid_t type, size_t count) {
  std::vector<std::string> texts(count);
  if (count == 0) return texts;
  if (H5Tis_variable_str(type) > 0) {
    std::vector<char*> pointers(count, nullptr);
    h5::check(H5Dread(variable, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), "text");
    for (size_t i = 0; i < count; ++i)
      if (pointers[i]) texts[i] = pointers[i];
    const h5::Id space = h5::own(H5Dget_space(variable), H5Sclose, "text");
    h5::check(H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data()), "text");
    return texts;
  }
  const size_t length = H5Tget_size(type);
  std::string all(count * length, '\0');
  h5::check(H5Dread(variable, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), "text");
  for (size_t i = 0; i < count; ++i) texts[i] = all.substr(i * length, length);
  return texts;
}

// Joins the characters of the last dimension to one text, without padding.
void join_texts(NetcdfVariable& v) {
  const bool single = !v.texts.empty() && !v.shape.empty() && v.texts.front().size() == 1;
  if (single && v.shape.back() > 0) {
    const size_t length = v.shape.back();
    std::vector<std::string> joined(v.texts.size() / length);
    for (size_t i = 0; i < v.texts.size(); ++i) joined[i / length] += v.texts[i];
    v.texts = std::move(joined);
    v.shape.pop_back();
    v.dimensions.pop_back();
  }
  for (std::string& t : v.texts) t.erase(t.find_last_not_of(std::string(" \0", 2)) + 1);
}

NetcdfVariable variable_of(hid_t file, const std::string& name) {
  const h5::Id set = h5::open_dataset(file, name);
  const h5::Id type = h5::own(H5Dget_type(set), H5Tclose, "variable " + name);
  NetcdfVariable v;
  v.shape = h5::shape_of(set);
  v.dimensions = dimensions_of(file, set, name, v.shape.size());
  size_t count = 1;
  for (const hsize_t k : v.shape) count *= k;
  if (H5Tget_class(type) == H5T_STRING) {
    v.texts = texts_of(set, type, count);
    join_texts(v);
  } else {
    v.values = h5::read_array(file, name).values;
  }
  return v;
}

}  // namespace

std::map<std::string, NetcdfVariable> read_netcdf(const std::string& path,
                                                  const std::vector<std::string>& names) {
  std::ifstream file(path, std::ios::binary);
  std::string first(3, '\0');
  file.read(first.data(), 3);
  try {
    if (first == "CDF") {
      file.seekg(0);
      const std::string bytes((std::istreambuf_iterator<char>(file)), {});
      std::map<std::string, NetcdfVariable> variables = read_netcdf_classic(bytes, names);
      for (auto& [name, v] : variables) join_texts(v);
      return variables;
    }
    const h5::Id open = h5::open_read(path);
    std::map<std::string, NetcdfVariable> variables;
    for (const std::string& name : names)
      if (h5::exists(open, name)) variables[name] = variable_of(open, name);
    return variables;
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(fmt::format("{}: is no NetCDF file, or is damaged ({})", path, e.what()));
  }
}

}  // namespace hawser::io
