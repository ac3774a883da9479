// Start shapes from other runs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "hawser/advice/start_shape.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/io/results_progress.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::io {

using model::refuse;
using model::refuse_key;
using model::Value;

namespace {
constexpr double kTogether = 1e-9;  // fraction of the length: gap between connected parts
}

const OtherRuns::Run& OtherRuns::run(const Value& from, const Value* time) {
  const std::string path = source_.input(from.text);
  const double requested = time ? time->number : -1;
  const auto [found, fresh] = runs_.try_emplace({path, requested});
  Run& r = found->second;
  if (!fresh) return r;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) refuse(from, "there is no such results file: " + path);
  std::string missing;
  try {
    const std::vector<double> times = read_progress(path).output_times;
    if (times.empty()) throw InputError(path + " holds no output yet");
    size_t row = times.size() - 1;
    if (time) {
      const auto nearer = [requested](double a, double b) {
        return std::abs(a - requested) < std::abs(b - requested);
      };
      row = static_cast<size_t>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
      if (std::abs(times[row] - requested) > 1e-6 * std::max(1.0, requested))
        missing = fmt::format(
            "{} has no output at {:g} s: of its {} outputs from {:g} to {:g} s the nearest is at {:.9g} s",
            path, requested, times.size(), times.front(), times.back(), times[row]);
    }
    r.path = path;
    r.time = times[row];
    const h5::Id file = h5::open_read(path);
    r.lines = h5::read_texts(file, "lines/name");
    for (size_t i = 0; i < r.lines.size(); ++i) r.number.emplace(r.lines[i], i);
    r.first = h5::read_array(file, "lines/first_node").values;
    r.count = h5::read_array(file, "lines/nodes").values;
    r.arc = h5::read_array(file, "nodes/arc_length").values;
    r.position = h5::read_row(file, "fields/position", row).values;
    if (h5::exists(file, "fields/axis_1") && h5::exists(file, "fields/axis_2"))
      for (const char* axis : {"fields/axis_1", "fields/axis_2"})
        r.axes.push_back(h5::read_row(file, axis, row).values);
  } catch (const std::runtime_error& e) {  // no results file, or incomplete
    refuse(from, "{}: cannot be read: {}", path, e.what());
  }
  if (!missing.empty()) refuse(*time, missing);
  return r;
}

std::shared_ptr<const model::PreviousShape> OtherRuns::shape(const Value& start, const std::string& name,
                                                             bool must) {
  const Run& r = run(start["from"], start.find("time"));
  const auto found = r.number.find(name);
  if (found == r.number.end()) {
    if (!must) return nullptr;
    const Value& at = start.has("line") ? start["line"] : start["from"];
    refuse(at, "{} has no line {}{} (lines: {})", r.path, model::quote(name),
           model::did_you_mean(name, r.lines), fmt::join(r.lines, ", "));
  }
  auto shape = std::make_shared<model::PreviousShape>();
  shape->file = r.path;
  parted_ = false;
  add_shape(r, found->second, *shape);
  // A line that the other run cuts consists of parts, which are connected until the cut.
  for (int k = 2;; ++k) {
    const auto part = r.number.find(fmt::format("{} part {}", name, k));
    if (part == r.number.end()) break;
    model::PreviousShape next;
    add_shape(r, part->second, next);
    parted_ = (next.position.front() - shape->position.back()).norm() > kTogether * next.arc.back();
    if (parted_) break;
    const double end = shape->arc.back();
    for (size_t n = 1; n < next.arc.size(); ++n) {
      shape->arc.push_back(end + next.arc[n]);
      shape->position.push_back(next.position[n]);
      if (n < next.rotation.size()) shape->rotation.push_back(next.rotation[n]);
    }
  }
  if (shape->rotation.size() != shape->arc.size()) shape->rotation.clear();
  return shape;
}

void OtherRuns::add_shape(const Run& r, size_t line, model::PreviousShape& shape) {
  const size_t first = static_cast<size_t>(r.first[line]);
  const size_t count = static_cast<size_t>(r.count[line]);
  for (size_t n = first; n < first + count; ++n) {
    shape.arc.push_back(r.arc[n]);
    shape.position.push_back(Eigen::Map<const Vec3>(r.position.data() + 3 * n));
    if (r.axes.empty()) continue;
    const Eigen::Map<const Vec3> a(r.axes[0].data() + 3 * n);
    const Eigen::Map<const Vec3> b(r.axes[1].data() + 3 * n);
    if (!(a.norm() > 0.5) || !(b.norm() > 0.5)) continue;  // a cable
    Mat3 R;
    R.col(0) = a.normalized();
    R.col(1) = (b - R.col(0).dot(b) * R.col(0)).normalized();
    R.col(2) = R.col(0).cross(R.col(1));
    shape.rotation.push_back(Quat(R));
  }
}

void check_previous_shape(const model::Line& line, const Value& at, const std::string& key, bool parted,
                          std::vector<std::string>& notes) {
  constexpr double kSame = 1e-6, kMost = 0.2;  // of the length
  const double length = model::length_of(line);
  const double previous_length = line.previous_shape->arc.back();
  if (std::abs(length - previous_length) > kMost * length)
    refuse_key(at, key, "the line is {:g} m long, but {:g} m in {}; they may differ by {:g} %{}", length,
               previous_length, line.previous_shape->file, 100 * kMost,
               parted ? ". It is cut there, and its parts have come apart: give a 'time' before that, or "
                        "make each part a line"
                      : "");
  if (std::abs(length - previous_length) > kSame * length)
    notes.push_back(advice::other_length_in_run(key, length, previous_length, line.previous_shape->file));
}

}  // namespace hawser::io
