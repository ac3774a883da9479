// Thin wrapper of HDF5: errors as exceptions, handles that close themselves.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>
#include <vector>

namespace hawser::io::h5 {

// Owns one HDF5 identifier.
class Id {
 public:
  Id() = default;
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Id(Id&& o) noexcept : id_(std::exchange(o.id_, -1)), close_(o.close_) {}
  Id& operator=(Id&& o) noexcept {
    if (this != &o) {
      reset();
      id_ = std::exchange(o.id_, -1);
      close_ = o.close_;
    }
    return *this;
  }
  ~Id() { reset(); }
  void reset() {
    if (id_ >= 0) close_(id_);
    id_ = -1;
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

// Throws std::runtime_error with `operation` and HDF5's own reason if a call failed.
void check(herr_t status, const std::string& operation);
Id own(hid_t id, herr_t (*close)(hid_t), const std::string& operation);

// Switches off HDF5's printing of error stacks. Called by the functions below that open files.
void quiet();

// Serial access. Readers do not lock, so a file can be read while a run writes it.
Id serial_access();
Id open_read(const std::string& path);
Id open_parts(const std::string& path);  // for reading; loads only the requested parts of long datasets
Id create(const std::string& path);
Id group(hid_t file, const std::string& name);

using Shape = std::vector<hsize_t>;

Id open_dataset(hid_t file, const std::string& name);
Shape shape_of(hid_t dataset);
bool exists(hid_t file, const std::string& name);
std::vector<std::string> members(hid_t file, const std::string& group);

// A contiguous dataset with a fixed place in the file, whose bytes are not written (a hole).
Id reserve(hid_t file, const std::string& name, hid_t type, const Shape& shape);

void write_text(hid_t file, const std::string& name, const std::string& text);
void write_texts(hid_t file, const std::string& name, const std::vector<std::string>& texts);
void text_attribute(hid_t object, const std::string& name, const std::string& text);
void texts_attribute(hid_t object, const std::string& name, const std::vector<std::string>& texts);
void int_attribute(hid_t object, const std::string& name, int value);

std::string read_text(hid_t file, const std::string& name);
std::vector<std::string> read_texts(hid_t file, const std::string& name);
// Value of an attribute written by text_attribute; empty: there is none.
std::string read_text_attribute(hid_t object, const std::string& name);

// A numeric dataset as doubles, row by row.
struct Array {
  Shape shape;
  std::vector<double> values;
};
Array read_array(hid_t file, const std::string& name);
// One row at index `row` of the first dimension; `shape` is that of the row.
Array read_row(hid_t file, const std::string& name, hsize_t row);
// Reads `count` elements of a one-dimensional dataset from `first` on into `to`, memory for `count` values of
// `type`.
void read_part(hid_t dataset, hid_t type, hsize_t first, hsize_t count, void* to);
// The same for a named dataset, of numbers and of texts.
std::vector<double> read_part(hid_t file, const std::string& name, hsize_t first, hsize_t count);
std::vector<std::string> read_texts_part(hid_t file, const std::string& name, hsize_t first, hsize_t count);

}  // namespace hawser::io::h5
