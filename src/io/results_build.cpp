// Datasets of a results file, and atomic replacement of the old file.
#include "hawser/io/results_build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "hawser/base/error.hpp"
#include "hawser/io/old_results.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/io/xdmf.hpp"
#include "results_copy.hpp"

namespace hawser::io {

namespace {

template <class T>
void write_all(hid_t file, const std::string& name, hid_t type, const h5::Shape& shape, const T* data,
               hid_t memory_type) {
  const h5::Id set = h5::reserve(file, name, type, shape);
  hsize_t n = 1;
  for (const hsize_t k : shape) n *= k;
  if (n) h5::check(H5Dwrite(set, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "dataset " + name);
}

void write_ints(hid_t file, const std::string& name, const std::vector<int>& v) {
  write_all(file, name, H5T_STD_I32LE, {v.size()}, v.data(), H5T_NATIVE_INT);
}

void write_triangles(hid_t file, const std::string& name, std::span<const std::array<int, 3>> t) {
  write_all(file, name, H5T_STD_I32LE, {t.size(), 3}, t.data(), H5T_NATIVE_INT);
}

void write_active(hid_t file, const std::string& name, const std::vector<char>& active) {
  write_all(file, name, H5T_STD_I8LE, {active.size()}, active.data(), H5T_NATIVE_CHAR);
}

void write_waves(hid_t file, const ResultWaves& w) {
  if (w.components.empty()) return;
  h5::group(file, "waves");
  write_all(file, "waves/components", H5T_IEEE_F64LE, {w.components.size(), 6}, w.components[0].data(),
            H5T_NATIVE_DOUBLE);
  const h5::Id set = h5::own(H5Dopen2(file, "waves/components", H5P_DEFAULT), H5Dclose, "waves/components");
  h5::texts_attribute(set, "columns",
                      {"amplitude", "omega", "number", "direction_x", "direction_y", "phase"});
  h5::texts_attribute(set, "units", {"m", "rad/s", "1/m", "", "", "rad"});
  write_all(file, "waves/level", H5T_IEEE_F64LE, {1}, &w.level, H5T_NATIVE_DOUBLE);
  write_all(file, "waves/ramp", H5T_IEEE_F64LE, {1}, &w.ramp, H5T_NATIVE_DOUBLE);
}

void write_run(hid_t file, const RunInfo& run) {
  const h5::Id root = h5::own(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "HDF5 root");
  h5::text_attribute(root, "hawser_results", "1");
  h5::text_attribute(root, "version", run.version);
  h5::text_attribute(root, "case_path", run.case_path);
  h5::text_attribute(root, "date", run.date);
  h5::int_attribute(root, "ranks", run.ranks);
  h5::write_text(file, "case", run.case_text);
  h5::write_text(file, "case_read", run.case_read);
  h5::write_text(file, "options", run.options);
  h5::write_text(file, "set", run.changes);
}

// One cell of type 2 (polyline) per line: type, count, nodes (XDMF mixed topology).
std::vector<int> line_cells(const std::vector<int>& first, const std::vector<int>& nodes) {
  std::vector<int> mixed;
  for (size_t l = 0; l < nodes.size(); ++l) {
    mixed.insert(mixed.end(), {2, nodes[l]});
    for (int i = 0; i < nodes[l]; ++i) mixed.push_back(first[l] + i);
  }
  return mixed;
}

void write_lines(hid_t file, const ResultContents& c) {
  h5::group(file, "lines");
  std::vector<std::string> names;
  std::vector<int> first, nodes, line_of, number;
  std::vector<double> arc;
  for (size_t l = 0; l < c.line_nodes.size(); ++l) {
    first.push_back(static_cast<int>(line_of.size()));
    nodes.push_back(c.line_nodes[l]);
    line_of.insert(line_of.end(), static_cast<size_t>(nodes.back()), static_cast<int>(l));
  }
  for (const auto& line : c.line_labels) {
    names.push_back(line.name);
    arc.insert(arc.end(), line.arc.begin(), line.arc.end());
  }
  number.resize(line_of.size());
  std::iota(number.begin(), number.end(), 0);
  if (!c.stages.empty()) h5::write_texts(file, "stages", c.stages);
  h5::write_texts(file, "lines/name", names);
  write_ints(file, "lines/first_node", first);
  write_ints(file, "lines/nodes", nodes);
  h5::group(file, "nodes");
  write_ints(file, "nodes/line", line_of);
  write_ints(file, "nodes/number", number);
  std::vector<int> ranks = c.ranks;
  ranks.resize(line_of.size());
  write_ints(file, "nodes/rank", ranks);
  write_ints(file, "lines/cells", line_cells(first, nodes));
  write_all(file, "nodes/arc_length", H5T_IEEE_F64LE, {arc.size()}, arc.data(), H5T_NATIVE_DOUBLE);
}

void write_volumes(hid_t file, const ResultContents& c) {
  h5::group(file, "volumes");
  const auto places = volume_places(c);
  for (size_t i = 0; i < c.volumes.size(); ++i) {
    const auto& v = c.volumes[i];
    const std::string& place = places[i];
    const h5::Id g = h5::group(file, place);
    h5::text_attribute(g, "name", v.name);
    h5::int_attribute(g, "body", v.body);
    write_all(file, place + "/vertices", H5T_IEEE_F64LE, {v.vertices.size(), 3},
              v.vertices.empty() ? nullptr : v.vertices[0].data(), H5T_NATIVE_DOUBLE);
    write_triangles(file, place + "/triangles", v.triangles);
    write_active(file, place + "/active", v.active);
    if (!v.coarsened()) continue;
    write_triangles(file, place + "/drawn_triangles", v.displayed_triangles());
    write_active(file, place + "/drawn_active", v.coarse_active);
  }
}

// The order determines the places of the datasets in the file.
void write_description(hid_t file, const ResultContents& c) {
  write_run(file, c.run);
  write_lines(file, c);
  write_waves(file, c.waves);
  h5::group(file, "bodies");
  h5::write_texts(file, "bodies/name", c.body_names);
  write_volumes(file, c);
}

// Labels of fields for external tools.
void describe_fields(hid_t file, const std::vector<Field>& fields) {
  for (const Field& f : fields) {
    const h5::Id set = h5::open_dataset(file, field_place(f));
    h5::text_attribute(set, "label", label_of(f));
    const char* const report[] = {"no", "table", "graph"};
    h5::text_attribute(set, "report", report[static_cast<int>(f.report)]);
    h5::int_attribute(set, "order", f.order);
    if (!f.meaning.empty()) h5::text_attribute(set, "utilisation", f.meaning);
  }
}

void write_row_sets(hid_t file, const ResultContents& c, const ResultRoom& room) {
  for (const char* name : {"outputs", "fields", "series"}) h5::group(file, name);
  if (!c.statistics.empty()) h5::group(file, "statistics");
  if (!c.end_fields.empty()) h5::group(file, "ends");
  if (c.contact_points) h5::group(file, "contact_points");
  if (std::any_of(c.series.begin(), c.series.end(), [](const ResultSeries& s) { return s.by_line; }))
    h5::group(file, "line_series");
  for (const auto& s : row_sets(c)) {
    h5::Shape shape{rows_in(s, c, {room.outputs, room.steps}, room.contacts)};
    shape.insert(shape.end(), s.tail.begin(), s.tail.end());
    const h5::Id set = h5::reserve(file, s.name, s.type, shape);
    if (!s.unit.empty()) h5::text_attribute(set, "unit", s.unit);
    if (s.rows_by == RowsBy::node)
      h5::texts_attribute(
          set, "columns",
          {"minimum", "time_of_minimum", "maximum", "time_of_maximum", "mean", "standard_deviation"});
    if (s.name == kContactPairs)
      h5::texts_attribute(set, "columns", {"line", "other_line", "volume", "other_volume"});
    if (s.name == "outputs/time" || s.name == "series/time") {  // rows not yet there show as NaN
      const std::vector<double> nan(shape[0], std::numeric_limits<double>::quiet_NaN());
      h5::check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, nan.data()), s.name);
    }
  }
  describe_fields(file, c.fields);
  const auto places = series_places(c);
  for (size_t i = 0; i < places.size(); ++i) {
    std::vector<std::string> columns, units;
    for (const auto& col : c.series[i].columns) {
      for (int k = 0; k < col.components; ++k) {
        columns.push_back(col.components == 1   ? col.name
                          : col.components <= 3 ? col.name + "_" + "xyz"[k]
                                                : col.name + "_" + std::to_string(k));
        units.push_back(col.unit);
      }
    }
    const h5::Id set = h5::open_dataset(file, places[i]);
    h5::text_attribute(set, "name", c.series[i].name);
    h5::texts_attribute(set, "columns", columns);
    h5::texts_attribute(set, "units", units);
  }
}

void write_slots(hid_t file, const ResultRoom& room) {
  if (room.slot_doubles == 0) return;
  h5::group(file, "checkpoint");
  for (long long k = 0; k < kCheckpointSlots; ++k) {
    const std::string slot = checkpoint_slot(k);
    h5::group(file, slot);
    const CheckpointHeader empty;
    write_all(file, slot + "/header", H5T_STD_U64LE, {4}, &empty, H5T_NATIVE_UINT64);
    h5::reserve(file, slot + "/index", H5T_STD_I8LE, {static_cast<hsize_t>(room.slot_text)});
    h5::reserve(file, slot + "/values", H5T_IEEE_F64LE, {static_cast<hsize_t>(room.slot_doubles)});
  }
}

void write_summary(hid_t file, const std::vector<SummaryRow>& rows) {
  size_t width = 1;
  for (const auto& r : rows) width = std::max({width, r.quantity.size(), r.line.size(), r.unit.size()});
  const h5::Id text = h5::own(H5Tcopy(H5T_C_S1), H5Tclose, "summary");
  h5::check(H5Tset_size(text, width), "summary");
  h5::check(H5Tset_strpad(text, H5T_STR_NULLPAD), "summary");
  h5::check(H5Tset_cset(text, H5T_CSET_UTF8), "summary");
  const size_t size = 3 * width + 3 * sizeof(double);
  const h5::Id type = h5::own(H5Tcreate(H5T_COMPOUND, size), H5Tclose, "summary");
  size_t at = 0;
  const auto column = [&](const char* name, hid_t t) {
    h5::check(H5Tinsert(type, name, at, t), "summary");
    at += H5Tget_size(t);
  };
  column("quantity", text);
  column("line", text);
  column("value", H5T_NATIVE_DOUBLE);
  column("unit", text);
  column("time", H5T_NATIVE_DOUBLE);
  column("arc_length", H5T_NATIVE_DOUBLE);
  std::string bytes(std::max<size_t>(size * rows.size(), 1), '\0');
  for (size_t i = 0; i < rows.size(); ++i) {
    char* to = &bytes[i * size];
    const auto put_text = [&](const std::string& s) {
      s.copy(to, s.size());
      to += width;
    };
    const auto put = [&](double v) {
      std::memcpy(to, &v, sizeof v);
      to += sizeof v;
    };
    put_text(rows[i].quantity);
    put_text(rows[i].line);
    put(rows[i].value);
    put_text(rows[i].unit);
    put(rows[i].time);
    put(rows[i].arc_length);
  }
  write_all(file, "summary", type, {rows.size()}, bytes.data(), type);
}

// Flushes the file before renaming it, and the folder after.
void put_in_place(const std::string& new_path, const std::string& path) {
  const auto sync = [](const std::string& file) {
    const int fd = open(file.c_str(), O_RDONLY);
    if (fd < 0) return;
    fsync(fd);
    close(fd);
  };
  sync(new_path);
  if (std::rename(new_path.c_str(), path.c_str()))
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
  const size_t slash = path.rfind('/');
  sync(slash == std::string::npos ? "." : path.substr(0, slash + 1));
}

}  // namespace

int ResultContents::nodes_total() const {
  int n = 0;
  for (size_t l = 0; l < line_nodes.size(); ++l) n += line_nodes[l];
  return n;
}

void check_contents(const ResultContents& c, bool writes) {
  if (c.fields.empty() || c.fields[0].name != "position" || c.fields[0].components != 3)
    throw std::logic_error("results: the first field must be position");
  if (writes && c.line_labels.size() != c.line_nodes.size())
    throw std::logic_error("results: names of lines are missing");
  if (writes && std::ssize(c.body_names) != c.bodies)
    throw std::logic_error("results: names of bodies are missing");
  for (size_t l = 0; writes && l < c.line_nodes.size(); ++l)
    if (std::ssize(c.line_labels[l].arc) != c.line_nodes[l])
      throw std::logic_error(fmt::format("results: arc lengths of line {} are missing", l));
  for (const auto& v : c.volumes)
    if (v.body >= c.bodies)
      throw std::logic_error("results: volume " + v.name + " moves with a body that is not there");
}

std::vector<std::string> volume_places(const ResultContents& c) {
  std::vector<std::string> names;
  for (const auto& v : c.volumes) names.push_back(v.name);
  names = safe_names(names);
  for (auto& name : names) name = "volumes/" + name;
  return names;
}

std::vector<std::string> series_places(const ResultContents& c) {
  std::vector<std::string> names{"time"};  // names in use
  for (const auto& s : c.series) names.push_back(s.name);
  names = safe_names(names);
  names.erase(names.begin());
  for (size_t i = 0; i < names.size(); ++i)
    names[i] = (c.series[i].by_line ? "line_series/" : "series/") + names[i];
  return names;
}

hsize_t numbers_in_row(const ResultSeries& series) {
  hsize_t n = 0;
  for (const ResultField& column : series.columns) n += static_cast<hsize_t>(column.components);
  return n;
}

std::string field_place(const ResultField& field) { return "fields/" + safe_name(field.name); }

std::string statistics_place(const ResultField& field) { return "statistics/" + safe_name(field.name); }

h5::Id result_count_type() {
  h5::Id type = h5::own(H5Tcreate(H5T_COMPOUND, sizeof(ResultCount)), H5Tclose, "counter");
  h5::check(H5Tinsert(type, "outputs", offsetof(ResultCount, outputs), H5T_STD_I64LE), "counter");
  h5::check(H5Tinsert(type, "steps", offsetof(ResultCount, steps), H5T_STD_I64LE), "counter");
  return type;
}

std::vector<RowSet> row_sets(const ResultContents& c) {
  const auto nodes = static_cast<hsize_t>(c.nodes_total());
  std::vector<RowSet> sets;
  const hid_t of_fields = c.single_precision ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
  sets.push_back({"outputs/time", RowsBy::output, H5T_IEEE_F64LE, {}, "s"});
  for (const auto& f : c.fields) {
    h5::Shape tail{nodes};
    if (f.components > 1) tail.push_back(static_cast<hsize_t>(f.components));
    sets.push_back({field_place(f), RowsBy::output, of_fields, tail, f.unit});
  }
  for (const auto& f : c.end_fields)
    sets.push_back({"ends/" + f.name,
                    RowsBy::output,
                    of_fields,
                    {2 * c.line_nodes.size(), static_cast<hsize_t>(f.components)},
                    f.unit});
  for (const auto& f : c.statistics) {
    h5::Shape tail;
    if (f.components > 1) tail.push_back(static_cast<hsize_t>(f.components));
    tail.push_back(kStatistics);
    sets.push_back({statistics_place(f), RowsBy::node, H5T_IEEE_F64LE, tail, f.unit});
  }
  if (c.clashes) sets.push_back({kClashCounts, RowsBy::output, H5T_STD_I64LE, {2}, ""});
  if (c.contact_points) {
    sets.push_back({kContactCounts, RowsBy::output, H5T_STD_I64LE, {}, ""});
    sets.push_back({kContactPairs, RowsBy::contact, H5T_STD_I32LE, {4}, ""});
    sets.push_back({kContactPositions, RowsBy::contact, of_fields, {3}, "m"});
    sets.push_back({kContactForces, RowsBy::contact, H5T_IEEE_F32LE, {3}, "N"});
  }
  const auto bodies = static_cast<hsize_t>(c.bodies);
  sets.push_back({"bodies/position", RowsBy::output, H5T_IEEE_F64LE, {bodies, 3}, "m"});
  sets.push_back({"bodies/rotation", RowsBy::output, H5T_IEEE_F64LE, {bodies, 4}, "quaternion w x y z"});
  const auto volumes = volume_places(c);
  for (size_t i = 0; i < volumes.size(); ++i) {
    const VolumeMesh& v = c.volumes[i];
    if (v.moves() && c.xdmf)
      sets.push_back(
          {volumes[i] + "/moved", RowsBy::output, H5T_IEEE_F32LE, {v.displayed_vertices().size(), 3}, "m"});
  }
  sets.push_back({"series/time", RowsBy::step, H5T_IEEE_F64LE, {}, "s"});
  const auto series = series_places(c);
  for (size_t i = 0; i < series.size(); ++i) {
    h5::Shape tail{numbers_in_row(c.series[i])};
    if (c.series[i].by_line) tail.insert(tail.begin(), c.line_nodes.size());
    sets.push_back({series[i], RowsBy::step, H5T_IEEE_F64LE, tail, ""});
  }
  return sets;
}

hsize_t rows_in(const RowSet& s, const ResultContents& c, const ResultCount& count, long long contacts) {
  switch (s.rows_by) {
    case RowsBy::output:
      return static_cast<hsize_t>(count.outputs);
    case RowsBy::step:
      return static_cast<hsize_t>(count.steps);
    case RowsBy::contact:
      return static_cast<hsize_t>(contacts);
    case RowsBy::node:
      break;
  }
  return static_cast<hsize_t>(c.nodes_total());
}

void build_results(const std::string& path, const ResultContents& contents, const ResultRoom& room,
                   const std::string& from, const ValidRows& kept, const ResultLast* last) {
  const std::string new_path = path + ".new";
  std::remove(new_path.c_str());  // a link would write elsewhere
  try {
    const h5::Id file = h5::create(new_path);
    {
      const h5::Id type = result_count_type();
      const h5::Id count = h5::reserve(file, "written", type, {1});
      h5::check(H5Dwrite(count, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &kept.count), "counter");
      h5::text_attribute(count, "meaning", "rows that hold results: outputs (fields), steps (series)");
    }
    write_description(file, contents);
    write_row_sets(file, contents, room);
    write_slots(file, room);
    if (contents.clashes) {
      std::vector<std::string> volumes;
      for (const auto& v : contents.volumes) volumes.push_back(v.name);
      make_clash_tables(file, room.clashes, volumes);
    }
    // At the end of a run, if it is complete, only the newest checkpoint is of use.
    const bool ends = last && last->summary;
    if (!from.empty())
      copy_earlier(from, file, contents, room, kept,
                   ends ? CopiedCheckpoints::newest : CopiedCheckpoints::all);
    if (ends) write_summary(file, *last->summary);
    const std::vector<std::string>& messages =
        last && last->messages ? *last->messages : contents.run.messages;
    if (!messages.empty()) h5::write_texts(file, "messages", messages);
    if (last && contents.clashes)
      write_last_clashes(file, last->clashes, kept.clashes, kept.count.outputs - 1);
    h5::check(H5Fflush(file, H5F_SCOPE_LOCAL), "cannot write " + new_path);
  } catch (const InputError&) {
    std::remove(new_path.c_str());
    throw;
  } catch (const std::exception& e) {
    const std::string text = cannot_write(path, e.what());
    std::remove(new_path.c_str());
    throw WriteError(text);
  }
  if (from.empty()) back_up_results(path);
  put_in_place(new_path, path);
}

}  // namespace hawser::io
