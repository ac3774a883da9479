// HDF5 type of a row of the clash tables, and creation, copying, completion and reading of the tables.
#include "hawser/io/clash_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace hawser::io {
namespace {

struct Column {
  const char *name, *unit;
  size_t at;
  bool number;  // else an index
};
constexpr Column kColumns[] = {{"line", "", offsetof(ClashRow, line), false},
                               {"other_line", "", offsetof(ClashRow, other_line), false},
                               {"volume", "", offsetof(ClashRow, volume), false},
                               {"other_volume", "", offsetof(ClashRow, other_volume), false},
                               {"start", "s", offsetof(ClashRow, start), true},
                               {"end", "s", offsetof(ClashRow, end), true},
                               {"arc_from", "m", offsetof(ClashRow, from), true},
                               {"arc_to", "m", offsetof(ClashRow, to), true},
                               {"other_arc_from", "m", offsetof(ClashRow, other_from), true},
                               {"other_arc_to", "m", offsetof(ClashRow, other_to), true},
                               {"peak_force", "N", offsetof(ClashRow, peak_force), true},
                               {"peak_time", "s", offsetof(ClashRow, peak_time), true},
                               {"peak_arc_from", "m", offsetof(ClashRow, peak_from), true},
                               {"peak_arc_to", "m", offsetof(ClashRow, peak_to), true},
                               {"impulse", "N s", offsetof(ClashRow, impulse), true},
                               {"peak_energy", "J", offsetof(ClashRow, peak_energy), true},
                               {"penetration", "m", offsetof(ClashRow, penetration), true}};

// Selects rows [first, first + n) of table `slot` of ongoing clashes, or of the ended ones (slot < 0).
h5::Id select(hid_t set, long long slot, long long first, size_t n) {
  h5::Id space = h5::own(H5Dget_space(set), H5Sclose, "clashes");
  const hsize_t start[2] = {static_cast<hsize_t>(slot < 0 ? first : slot), static_cast<hsize_t>(first)};
  const hsize_t count[2] = {slot < 0 ? n : 1, n};
  h5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr), "clashes");
  return space;
}

void write(hid_t file, const char* name, long long slot, long long first, const std::vector<ClashRow>& rows) {
  if (rows.empty()) return;
  const h5::Id set = h5::open_dataset(file, name);
  const h5::Id type = clash_type();
  const hsize_t n = rows.size();
  const h5::Id memory = h5::own(H5Screate_simple(1, &n, nullptr), H5Sclose, "clashes");
  h5::check(H5Dwrite(set, type, memory, select(set, slot, first, n), H5P_DEFAULT, rows.data()), name);
}

std::vector<ClashRow> read(hid_t file, const char* name, long long slot, size_t rows) {
  std::vector<ClashRow> out(rows);
  if (rows == 0) return out;
  const h5::Id set = h5::open_dataset(file, name);
  const h5::Id type = clash_type();
  const hsize_t n = rows;
  const h5::Id memory = h5::own(H5Screate_simple(1, &n, nullptr), H5Sclose, "clashes");
  h5::check(H5Dread(set, type, memory, select(set, slot, 0, n), H5P_DEFAULT, out.data()), name);
  return out;
}

}  // namespace

h5::Id clash_type() {
  h5::Id type = h5::own(H5Tcreate(H5T_COMPOUND, sizeof(ClashRow)), H5Tclose, "clashes");
  for (const Column& c : kColumns)
    h5::check(H5Tinsert(type, c.name, c.at, c.number ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT), "clashes");
  return type;
}

ClashTables read_clashes(const std::string& path) {
  const h5::Id file = h5::open_read(path);
  ClashTables out;
  if (!h5::exists(file, kClashCounts)) return out;
  long long written[2] = {};
  {
    const h5::Id set = h5::open_dataset(file, "written");
    const h5::Id type = h5::own(H5Dget_type(set), H5Tclose, "counter");
    h5::check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, written), "counter");
  }
  if (written[0] == 0) return out;
  const size_t last = written[0] - 1;
  const h5::Array counts = h5::read_array(file, kClashCounts);
  out.ended = read(file, kClashesEnded, -1, static_cast<size_t>(counts.values[2 * last]));
  out.open = read(file, kClashesOpen, static_cast<long long>(last % 2),
                  static_cast<size_t>(counts.values[2 * last + 1]));
  return out;
}

void make_clash_tables(hid_t file, const ClashRoom& room, const std::vector<std::string>& volumes) {
  h5::group(file, "clashes");
  h5::write_texts(file, "clashes/volume_name", volumes);
  const h5::Id type = clash_type();
  std::vector<std::string> units;
  for (const Column& c : kColumns) units.push_back(c.unit);
  const auto make = [&](const char* name, const h5::Shape& shape) {
    const h5::Id set = h5::reserve(file, name, type, shape);
    h5::texts_attribute(set, "units", units);
  };
  make(kClashesEnded, {static_cast<hsize_t>(room.ended)});
  make(kClashesOpen, {2, static_cast<hsize_t>(room.open)});
}

void copy_clash_tables(hid_t from, hid_t to, long long ended) {
  write(to, kClashesEnded, -1, 0, read(from, kClashesEnded, -1, static_cast<size_t>(ended)));
  const auto rows = [](hid_t file) { return h5::shape_of(h5::open_dataset(file, kClashesOpen))[1]; };
  for (const long long slot : {0, 1})
    write(to, kClashesOpen, slot, 0, read(from, kClashesOpen, slot, std::min(rows(from), rows(to))));
}

void write_last_clashes(hid_t file, const ClashTables& last, long long kept, long long output) {
  if (output < 0) return;
  write(file, kClashesEnded, -1, kept, last.ended);
  write(file, kClashesOpen, output % 2, 0, last.open);
  const h5::Id set = h5::open_dataset(file, kClashCounts);
  const long long counts[2] = {kept + static_cast<long long>(last.ended.size()),
                               static_cast<long long>(last.open.size())};
  const hsize_t start[2] = {static_cast<hsize_t>(output), 0};
  const hsize_t count[2] = {1, 2};
  const hsize_t n = 2;
  const h5::Id space = h5::own(H5Dget_space(set), H5Sclose, "clashes");
  const h5::Id memory = h5::own(H5Screate_simple(1, &n, nullptr), H5Sclose, "clashes");
  h5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr), "clashes");
  h5::check(H5Dwrite(set, H5T_NATIVE_LLONG, memory, space, H5P_DEFAULT, counts), "clashes");
}

}  // namespace hawser::io
