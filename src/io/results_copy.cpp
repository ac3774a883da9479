// Copying of rows and checkpoints between results files, and the checks that an earlier file fits the case.
#include "results_copy.hpp"

#include <algorithm>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/io/checkpoint.hpp"

namespace hawser::io {
namespace {

// Copies the first n rows, in pieces that fit the processor's cache.
void copy_rows(hid_t from, hid_t to, hid_t type, hsize_t n) {
  h5::Shape count = h5::shape_of(to);
  h5::Shape start(count.size(), 0);
  hsize_t row = H5Tget_size(type);
  for (size_t i = 1; i < count.size(); ++i) row *= count[i];
  if (row == 0) return;
  const hsize_t piece = std::max<hsize_t>((hsize_t{256} << 10) / row, 1);
  std::vector<char> buffer(std::min(piece, std::max<hsize_t>(n, 1)) * row);
  for (; start[0] < n; start[0] += piece) {
    count[0] = std::min(piece, n - start[0]);
    const h5::Id memory =
        h5::own(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose, "copy");
    const auto select = [&](hid_t set) {
      h5::Id space = h5::own(H5Dget_space(set), H5Sclose, "copy");
      h5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
                "copy");
      return space;
    };
    const h5::Id source_rows = select(from);
    const h5::Id target_rows = select(to);
    h5::check(H5Dread(from, type, memory, source_rows, H5P_DEFAULT, buffer.data()),
              "copy of earlier results");
    h5::check(H5Dwrite(to, type, memory, target_rows, H5P_DEFAULT, buffer.data()), "copy of earlier results");
  }
}

InputError differs_in(const std::string& path, const std::string& part) {
  return InputError(path + " cannot be continued: the case does not match its " + part);
}

// Compares with the case, not with the new file, which may be incomplete on a full disk.
void check_lines_of(const std::string& path, hid_t from, const ResultContents& c) {
  std::vector<std::string> names;
  std::vector<double> arc;
  for (const ResultLineLabels& line : c.line_labels) {
    names.push_back(line.name);
    arc.insert(arc.end(), line.arc.begin(), line.arc.end());
  }
  if (!h5::exists(from, "lines/name") || h5::read_texts(from, "lines/name") != names)
    throw differs_in(path, "lines");
  if (h5::read_array(from, "nodes/arc_length").values != arc) throw differs_in(path, "nodes");
}

// Refuses to drop a history of the earlier file.
void check_histories_of(const std::string& path, hid_t from, hid_t to) {
  for (const std::string group : {"series", "line_series"}) {
    if (!h5::exists(from, group)) continue;
    for (const std::string& name : h5::members(from, group))
      if (!h5::exists(to, group + "/" + name))
        throw InputError(
            "{} cannot be continued: the case no longer has its history or clearance {}, which would be "
            "lost; keep it, or go on in another file with -o",
            path, name);
  }
}

void copy_row_sets(const std::string& path, hid_t from, hid_t to, const ResultContents& c,
                   const ValidRows& kept) {
  for (const RowSet& s : row_sets(c)) {
    // Statistics are restored from the checkpoint.
    if (s.rows_by == RowsBy::node && !h5::exists(from, s.name)) continue;
    if (!h5::exists(from, s.name)) throw differs_in(path, s.name);
    const h5::Id old = h5::open_dataset(from, s.name);
    const h5::Id created = h5::open_dataset(to, s.name);
    const h5::Shape shape = h5::shape_of(old);
    if (!std::equal(shape.begin() + 1, shape.end(), s.tail.begin(), s.tail.end()))
      throw InputError(
          "{} cannot be continued: its {} has other columns than this case and this version of hawser write; "
          "go on in another file with -o",
          path, s.name);
    copy_rows(old, created, s.type, rows_in(s, c, kept.count, kept.contacts));
  }
}

// That of a file without the slot is empty.
CheckpointHeader header_of(hid_t file, const std::string& slot) {
  CheckpointHeader header;
  if (h5::exists(file, slot))
    h5::check(H5Dread(h5::open_dataset(file, slot + "/header"), H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL,
                      H5P_DEFAULT, &header),
              "checkpoint");
  return header;
}

void copy_checkpoints(hid_t from, hid_t to, const ResultRoom& room, CopiedCheckpoints which) {
  long long newest = 0;
  for (long long k = 1; k < kCheckpointSlots; ++k)
    if (header_of(from, checkpoint_slot(k)).sequence > header_of(from, checkpoint_slot(newest)).sequence)
      newest = k;
  for (long long k = 0; k < kCheckpointSlots; ++k) {
    if (which == CopiedCheckpoints::newest && k != newest) continue;
    const std::string slot = checkpoint_slot(k);
    const CheckpointHeader header = header_of(from, slot);
    if (header.sequence == 0 || header.size > static_cast<hsize_t>(room.slot_doubles) ||
        header.text > static_cast<hsize_t>(room.slot_text))
      continue;
    const auto copy = [&](const char* part, hid_t type, hsize_t n) {
      copy_rows(h5::open_dataset(from, slot + part), h5::open_dataset(to, slot + part), type, n);
    };
    copy("/index", H5T_NATIVE_CHAR, header.text);
    copy("/values", H5T_NATIVE_DOUBLE, header.size);
    copy("/header", H5T_NATIVE_UINT64, 4);
  }
}

}  // namespace

void copy_earlier(const std::string& path, hid_t to, const ResultContents& contents, const ResultRoom& room,
                  const ValidRows& kept, CopiedCheckpoints checkpoints) {
  const h5::Id from = h5::open_read(path);
  check_lines_of(path, from, contents);
  check_histories_of(path, from, to);
  copy_row_sets(path, from, to, contents, kept);
  if (contents.clashes) copy_clash_tables(from, to, kept.clashes);
  if (room.slot_doubles > 0) copy_checkpoints(from, to, room, checkpoints);
}

}  // namespace hawser::io
