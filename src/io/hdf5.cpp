// HDF5 calls for files, groups, datasets, texts and attributes; failures become exceptions with HDF5's own
// message.
#include "hawser/io/hdf5.hpp"

#include <algorithm>
#include <stdexcept>

namespace hawser::io::h5 {

namespace {

herr_t first_reason(unsigned n, const H5E_error2_t* e, void* out) {
  if (n == 0 && e->desc) *static_cast<std::string*>(out) = e->desc;
  return 0;
}

[[noreturn]] void fail(const std::string& operation) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first_reason, &reason);
  H5Eclear2(H5E_DEFAULT);
  throw std::runtime_error(reason.empty() ? operation : operation + " (" + reason + ")");
}

Id text_type(size_t length) {
  Id type = own(H5Tcopy(H5T_C_S1), H5Tclose, "HDF5 string type");
  check(H5Tset_size(type, std::max<size_t>(length, 1)), "HDF5 string type");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "HDF5 string type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "HDF5 string type");
  return type;
}

size_t longest(const std::vector<std::string>& texts) {
  size_t n = 1;
  for (const auto& t : texts) n = std::max(n, t.size());
  return n;
}

std::string packed(const std::vector<std::string>& texts, size_t length) {
  std::string all(std::max<size_t>(length * texts.size(), 1), '\0');
  for (size_t i = 0; i < texts.size(); ++i) texts[i].copy(&all[i * length], texts[i].size());
  return all;
}

// Modification times would make equal runs differ and would change metadata.
Id creation_list() {
  Id list = own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "HDF5 property list");
  check(H5Pset_obj_track_times(list, false), "HDF5 property list");
  check(H5Pset_layout(list, H5D_CONTIGUOUS), "HDF5 property list");
  check(H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY), "HDF5 property list");
  check(H5Pset_fill_time(list, H5D_FILL_TIME_NEVER), "HDF5 property list");
  return list;
}

}  // namespace

void check(herr_t status, const std::string& operation) {
  if (status < 0) fail(operation);
}

Id own(hid_t id, herr_t (*close)(hid_t), const std::string& operation) {
  if (id < 0) fail(operation);
  return {id, close};
}

void quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Id serial_access() {
  Id list = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "HDF5 property list");
  check(H5Pset_file_locking(list, false, true), "HDF5 property list");
  // Superblocks of HDF5 1.10 have an "open for writing" flag that a killed run would leave set.
  check(H5Pset_libver_bounds(list, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18), "HDF5 property list");
  check(H5Pset_alignment(list, 16, 64), "HDF5 property list");
  return list;
}

Id open_read(const std::string& path) {
  quiet();
  const Id access = serial_access();
  return own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "cannot read " + path);
}

Id open_parts(const std::string& path) {
  quiet();
  const Id access = serial_access();
  check(H5Pset_sieve_buf_size(access, 0), "HDF5 property list");
  return own(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "cannot read " + path);
}

Id create(const std::string& path) {
  quiet();
  const Id access = serial_access();
  return own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "cannot write " + path);
}

Id group(hid_t file, const std::string& name) {
  const Id list = own(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "HDF5 property list");
  check(H5Pset_obj_track_times(list, false), "HDF5 property list");
  return own(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), H5Gclose, "group " + name);
}

Id open_dataset(hid_t file, const std::string& name) {
  return own(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "dataset " + name);
}

Shape shape_of(hid_t dataset) {
  const Id space = own(H5Dget_space(dataset), H5Sclose, "dataset shape");
  Shape shape(static_cast<size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "dataset shape");
  return shape;
}

bool exists(hid_t file, const std::string& name) {
  for (size_t slash = name.find('/', 1);; slash = name.find('/', slash + 1)) {
    if (H5Lexists(file, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    if (slash == std::string::npos) return true;
  }
}

std::vector<std::string> members(hid_t file, const std::string& group) {
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->push_back(name);
    return 0;
  };
  std::vector<std::string> names;
  check(
      H5Literate_by_name(file, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names, H5P_DEFAULT),
      "group " + group);
  return names;
}

Id reserve(hid_t file, const std::string& name, hid_t type, const Shape& shape) {
  const Id list = creation_list();
  const Id space = own(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose,
                       "dataset " + name);
  return own(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose,
             "dataset " + name);
}

void write_text(hid_t file, const std::string& name, const std::string& text) {
  const Id type = text_type(text.size());
  const Id list = creation_list();
  const Id space = own(H5Screate(H5S_SCALAR), H5Sclose, "dataset " + name);
  const Id set = own(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose,
                     "dataset " + name);
  check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), "dataset " + name);
}

void write_texts(hid_t file, const std::string& name, const std::vector<std::string>& texts) {
  const Id type = text_type(longest(texts));
  const Id set = reserve(file, name, type, {texts.size()});
  const std::string all = packed(texts, longest(texts));
  if (!texts.empty())
    check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), "dataset " + name);
}

void text_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Id type = text_type(text.size());
  const Id space = own(H5Screate(H5S_SCALAR), H5Sclose, "attribute " + name);
  const Id at = own(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                    "attribute " + name);
  check(H5Awrite(at, type, text.c_str()), "attribute " + name);
}

void texts_attribute(hid_t object, const std::string& name, const std::vector<std::string>& texts) {
  const Id type = text_type(longest(texts));
  const hsize_t n = texts.size();
  const Id space = own(H5Screate_simple(1, &n, nullptr), H5Sclose, "attribute " + name);
  const Id at = own(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                    "attribute " + name);
  const std::string all = packed(texts, longest(texts));
  check(H5Awrite(at, type, all.data()), "attribute " + name);
}

void int_attribute(hid_t object, const std::string& name, int value) {
  const Id space = own(H5Screate(H5S_SCALAR), H5Sclose, "attribute " + name);
  const Id at = own(H5Acreate2(object, name.c_str(), H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT),
                    H5Aclose, "attribute " + name);
  check(H5Awrite(at, H5T_NATIVE_INT, &value), "attribute " + name);
}

namespace {

// Splits consecutive texts of `length` characters, padded with zeros.
std::vector<std::string> unpacked(const std::string& all, size_t length) {
  std::vector<std::string> texts;
  for (size_t at = 0; at + length <= all.size(); at += length) {
    std::string t = all.substr(at, length);
    t.erase(t.find_last_not_of('\0') + 1);
    texts.push_back(std::move(t));
  }
  return texts;
}

}  // namespace

std::vector<std::string> read_texts(hid_t file, const std::string& name) {
  const Id set = open_dataset(file, name);
  const Id type = own(H5Dget_type(set), H5Tclose, "dataset " + name);
  size_t n = 1;
  for (const hsize_t k : shape_of(set)) n *= k;
  const size_t length = H5Tget_size(type);
  std::string all(n * length, '\0');
  if (n) check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), "dataset " + name);
  return unpacked(all, length);
}

std::string read_text(hid_t file, const std::string& name) { return read_texts(file, name).at(0); }

std::string read_text_attribute(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return "";
  const Id at = own(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "attribute " + name);
  const Id type = own(H5Aget_type(at), H5Tclose, "attribute " + name);
  const Id space = own(H5Aget_space(at), H5Sclose, "attribute " + name);
  const bool is_text = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
  if (!is_text || H5Sget_simple_extent_npoints(space) != 1) return "";
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(at, type, text.data()), "attribute " + name);
  return text.substr(0, text.find('\0'));
}

Array read_array(hid_t file, const std::string& name) {
  const Id set = open_dataset(file, name);
  Array a{shape_of(set), {}};
  size_t n = 1;
  for (const hsize_t k : a.shape) n *= k;
  a.values.resize(n);
  if (n)
    check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, a.values.data()), "dataset " + name);
  return a;
}

Array read_row(hid_t file, const std::string& name, hsize_t row) {
  const Id set = open_dataset(file, name);
  const Shape whole = shape_of(set);
  if (whole.empty() || row >= whole[0]) throw std::runtime_error("dataset " + name + " has no such row");
  Array a{{whole.begin() + 1, whole.end()}, {}};
  Shape first(whole.size(), 0);
  Shape count = whole;
  first[0] = row;
  count[0] = 1;
  hsize_t n = 1;
  for (const hsize_t k : a.shape) n *= k;
  a.values.resize(n);
  const Id from = own(H5Dget_space(set), H5Sclose, "dataset " + name);
  check(H5Sselect_hyperslab(from, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr),
        "dataset " + name);
  const Id to = own(H5Screate_simple(1, &n, nullptr), H5Sclose, "dataset " + name);
  if (n) check(H5Dread(set, H5T_NATIVE_DOUBLE, to, from, H5P_DEFAULT, a.values.data()), "dataset " + name);
  return a;
}

void read_part(hid_t dataset, hid_t type, hsize_t first, hsize_t count, void* to) {
  if (count == 0) return;
  const Id from = own(H5Dget_space(dataset), H5Sclose, "part of a dataset");
  const Id memory = own(H5Screate_simple(1, &count, nullptr), H5Sclose, "part of a dataset");
  check(H5Sselect_hyperslab(from, H5S_SELECT_SET, &first, nullptr, &count, nullptr), "part of a dataset");
  check(H5Dread(dataset, type, memory, from, H5P_DEFAULT, to), "part of a dataset");
}

std::vector<double> read_part(hid_t file, const std::string& name, hsize_t first, hsize_t count) {
  std::vector<double> values(count);
  read_part(open_dataset(file, name), H5T_NATIVE_DOUBLE, first, count, values.data());
  return values;
}

std::vector<std::string> read_texts_part(hid_t file, const std::string& name, hsize_t first, hsize_t count) {
  const Id set = open_dataset(file, name);
  const Id type = own(H5Dget_type(set), H5Tclose, "dataset " + name);
  const size_t length = H5Tget_size(type);
  std::string all(count * length, '\0');
  read_part(set, type, first, count, all.data());
  return unpacked(all, length);
}

}  // namespace hawser::io::h5
