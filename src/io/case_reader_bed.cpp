// Reader of a seabed grid or mesh, and checks of lines against the bed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/advice/bed_files.hpp"
#include "hawser/base/error.hpp"
#include "hawser/geometry/ground.hpp"
#include "hawser/geometry/height_grid.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/mesh_reader.hpp"
#include "hawser/io/shared_on_host.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {
namespace {

using model::refuse;
using model::Value;

// Distinct coordinates in ascending order; differences below a millionth of the range are rounding.
std::vector<double> distinct(std::vector<double> t) {
  std::sort(t.begin(), t.end());
  const double same = 1e-6 * (t.back() - t.front());
  std::vector<double> out;
  for (const double x : t)
    if (out.empty() || x > out.back() + same) out.push_back(x);
  return out;
}

size_t place(const std::vector<double>& t, double x) {
  const double same = 1e-6 * (t.back() - t.front());
  return static_cast<size_t>(std::lower_bound(t.begin(), t.end(), x - same) - t.begin());
}

double smallest_step(const std::vector<double>& t) {
  double smallest = HUGE_VAL;
  for (size_t i = 1; i < t.size(); ++i) smallest = std::min(smallest, t[i] - t[i - 1]);
  return smallest;
}

// Reads `grid: {file}`: rows of x, y and z, in any order.
class GridReader {
 public:
  GridReader(const Value& v, const CaseSource& source)
      : v_(v), path_(source.input(v["file"].text)), file_(read_rows(path_, v["file"])) {}

  std::shared_ptr<const HeightGrid> read(std::vector<std::string>& notes) {
    check_rows();
    find_coordinates();
    place_heights();
    refuse_missing();
    check_odd_heights(notes);
    return std::make_shared<const HeightGrid>(std::move(x_), std::move(y_), z_);
  }

 private:
  [[noreturn]] void refuse_row(size_t row, const std::string& text) const {
    refuse(v_["file"], "{}:{}: {}", path_, file_.lines[row], text);
  }

  void check_rows() const {
    for (size_t i = 0; i < file_.rows.size(); ++i) {
      const std::vector<double>& row = file_.rows[i];
      if (row.size() != 3)
        refuse_row(i, fmt::format("a row of a seabed grid has 3 numbers, x, y and z, but this one has {}",
                                  row.size()));
      for (const double coordinate : row)
        if (!(std::abs(coordinate) <= kFarthest))
          refuse_row(i, fmt::format("{:g} m is beyond {:g} m from the origin; is it in other units than "
                                    "metres, or a no-data value?",
                                    coordinate, kFarthest));
    }
    if (file_.rows.empty()) refuse(v_["file"], path_ + ": the file has no rows");
  }

  void find_coordinates() {
    const std::vector<std::vector<double>>& rows = file_.rows;
    for (const std::vector<double>& row : rows) {
      x_.push_back(row[0]);
      y_.push_back(row[1]);
    }
    x_ = distinct(std::move(x_));
    y_ = distinct(std::move(y_));
    if (x_.size() < 2 || y_.size() < 2)
      refuse(v_["file"], "{}: a grid has two columns and two rows at least, but there {} x and {} y", path_,
             x_.size() == 1 ? "is 1" : fmt::format("are {}", x_.size()), y_.size());
    constexpr double kSparse = 100;  // places of the grid for each row
    if (static_cast<double>(x_.size()) * static_cast<double>(y_.size()) >
        kSparse * static_cast<double>(rows.size()))
      refuse(v_["file"],
             "{}: {} rows with {} different x and {} different y are no grid: a grid has a height for every "
             "x and every y; scattered points make a mesh",
             path_, rows.size(), x_.size(), y_.size());
  }

  void place_heights() {
    const double up = v_["depths"].number != 0 ? -1 : 1;
    z_.resize(x_.size() * y_.size());
    given_.assign(z_.size(), -1);
    for (size_t i = 0; i < file_.rows.size(); ++i) {
      const std::vector<double>& row = file_.rows[i];
      const size_t k = place(y_, row[1]) * x_.size() + place(x_, row[0]);
      if (given_[k] >= 0)
        refuse_row(i, fmt::format("x {:g}, y {:g} is there twice, first in line {}", row[0], row[1],
                                  file_.lines[given_[k]]));
      given_[k] = static_cast<int>(i);
      z_[k] = up * row[2];
    }
  }

  void refuse_missing() const {
    const auto missing = std::find(given_.begin(), given_.end(), -1);
    if (missing == given_.end()) return;
    const size_t k = missing - given_.begin();
    refuse(v_["file"],
           "{}: there is no height at x {:g}, y {:g} ({} of {} places are missing); a grid has one for every "
           "x and every y",
           path_, x_[k % x_.size()], y_[k / x_.size()], std::count(given_.begin(), given_.end(), -1),
           given_.size());
  }

  void check_odd_heights(std::vector<std::string>& notes) const {
    const OddHeights odd = odd_heights(z_, std::min(smallest_step(x_), smallest_step(y_)));
    if (odd.count == 0) return;
    const size_t row = given_[odd.first];
    const Vec3 first(file_.rows[row].data());
    if (odd.mark) refuse_row(row, advice::no_data_value(first, odd.count - 1, odd.gap));
    notes.push_back(
        advice::possible_no_data_value(v_.where, path_, file_.lines[row], first, odd.count - 1, odd.gap));
  }

  const Value& v_;
  const std::string path_;
  const FileRows file_;
  std::vector<double> x_, y_;  // m, ascending
  std::vector<double> z_;      // m, by y, then x
  std::vector<int> given_;     // row of the file for each of z_; -1: none
};

std::shared_ptr<const MeshSurface> read_mesh_bed(const Value& v, const CaseSource& source) {
  const std::string path = source.input(v["file"].text);
  return shared_on_host(source.comm, Host(source.comm), [&] {
    try {
      TriangleMesh sheet = read_sheet(path, v["scale"].number);
      const size_t top = sheet.triangles.size();
      TriangleMesh ground = ground_under(std::move(sheet));
      std::vector<bool> active(ground.triangles.size(), false);
      std::fill_n(active.begin(), top, true);
      return std::make_shared<const MeshSurface>(
          std::move(ground), std::move(active),
          MeshSurfaceOptions{.smooth = v["smooth"].number != 0,
                             .crease_angle = v["crease_angle_deg"].number,
                             .open = false});
    } catch (const InputError& e) {
      source.refuse(v["file"], v["file"].where, e.what());
    } catch (const std::invalid_argument& e) {
      source.refuse(v["file"], v["file"].where, path + ": " + e.what());
    }
  });
}

}  // namespace

void read_bed_surface(const Value& v, const CaseSource& source, model::Seabed& bed,
                      std::vector<std::string>& notes) {
  double low = 0, high = 0;
  if (const Value* g = v.find("grid")) {
    const auto grid = GridReader(*g, source).read(notes);
    low = grid->lowest();
    high = grid->highest();
    bed.surface = grid;
    bed.file = source.input((*g)["file"].text);
  } else if (const Value* m = v.find("mesh")) {
    const auto mesh = read_mesh_bed(*m, source);
    const MeshView t = mesh->mesh();
    low = std::numeric_limits<double>::infinity();
    high = -low;
    for (size_t i = 0; i < t.vertices.size() / 2; ++i) {  // the other half is the bottom of the closed volume
      low = std::min(low, t.vertices[i].z());
      high = std::max(high, t.vertices[i].z());
    }
    bed.surface = mesh;
    bed.file = source.input((*m)["file"].text);
  } else {
    return;
  }
  bed.depth = -0.5 * (low + high);
}

namespace {

constexpr double kKnownHeight = 0.1;  // m, accuracy of seabed surveys

// Largest depth of a line's axis below the bed at the start [m]: on the soil or pressed into it, plus the
// accuracy of the bed's height.
double deepest_start(const model::Case& c, const model::LineType& t) {
  constexpr double kPressed = 3;  // times the weight
  return kKnownHeight + t.contact_diameter +
         model::penetration_under(c.environment.seabed, kPressed * c.environment.gravity * t.mass_per_length,
                                  t.contact_diameter);
}

// Checks of given positions of a line against the bed.
class BedCheck {
 public:
  explicit BedCheck(model::Case& c) : c_(c), bed_(c.environment.seabed) {}

  void run() {
    if (bed_.surface) {
      grid_ = dynamic_cast<const HeightGrid*>(bed_.surface.get());
      box_ = bed_.surface->bounds();
      size();
      if (grid_) steps();
    }
    for (model::Line& line : c_.lines) {
      end(line, line.end_a, line.sections.front(), "end_a");
      end(line, line.end_b, line.sections.back(), "end_b");
      if (line.start == model::Start::points) points(line);
    }
  }

 private:
  static constexpr double kRounded = 0.02;  // m below the bed, allowed for a rounded water depth

  // Upper limit: a bed in mm read as m. Lower limit: the thickness of the line.
  void size() const {
    constexpr SizeLimits kSizes{1e6, 1, std::numeric_limits<double>::infinity()};
    const double size =
        grid_ ? std::max(grid_->x().back() - grid_->x().front(), grid_->y().back() - grid_->y().front())
              : std::max(box_.extent().x(), box_.extent().y());
    const char* kind = grid_ ? "grid" : "mesh";
    if (const std::string odd = other_units(size, kSizes, c_); !odd.empty())
      c_.refuse(fmt::format("environment.seabed.{}.file", kind), "{}: the bed {}", bed_.file, odd);
  }
  // A smooth surface through a step of the ground overshoots below and above it.
  void steps() const {
    const HeightGrid::Overshoot o = grid_->overshoot();
    if (o.height < kKnownHeight) return;
    c_.notes.push_back(advice::surface_beyond_heights(bed_.file, o));
  }
  // True if a place, given as a fraction of the line's length, is in the soil or at the end of a buried
  // stretch.
  static bool buried(const model::Line& line, double fraction) {
    const double length = model::length_of(line);
    const double s = fraction * length;
    const double near = 1e-3 * length;
    return std::any_of(line.buried.begin(), line.buried.end(),
                       [&](const model::Buried& b) { return s > b.from - near && s < b.to + near; });
  }
  void points(const model::Line& line) const {
    std::vector<double> laid{0};
    for (size_t i = 1; i < line.points.size(); ++i)
      laid.push_back(laid.back() + (line.points[i] - line.points[i - 1]).norm());
    for (size_t i = 0; i < line.points.size(); ++i)
      if (!buried(line, laid[i] / laid.back()))
        place(fmt::format("lines.{}.start.points[{}]", line.name, i), line.points[i],
              c_.line_type(line.sections.front().type),
              deepest_start(c_, c_.line_type(line.sections.front().type)));
  }
  bool covers(const Vec3& x) const {
    if (!bed_.surface) return true;
    return grid_
               ? grid_->covers(x)
               : x.x() >= box_.lo.x() && x.x() <= box_.hi.x() && x.y() >= box_.lo.y() && x.y() <= box_.hi.y();
  }
  void end(const model::Line& line, const model::End& e, const model::Section& section, const char* name) {
    if (e.kind == model::EndKind::free) return;
    const std::string key = fmt::format("lines.{}.{}", line.name, name);
    const Vec3 x = model::end_position(c_, e);
    if (!covers(x)) return c_.notes.push_back(advice::end_beyond_bed(key, bed_.file, grid_ != nullptr));
    if (buried(line, &e == &line.end_a ? 0 : 1)) return reaches(line, e, x);
    const std::string where = key + (e.kind == model::EndKind::anchor  ? ".anchor"
                                     : e.kind == model::EndKind::joint ? ".joint"
                                                                       : ".at");
    const model::LineType& type = c_.line_type(section.type);
    if (e.kind != model::EndKind::anchor) return place(where, x, type, deepest_start(c_, type));
    // The bed is lowered at an anchor (model::bed_at_end) along a small part of the line.
    constexpr double kPart = 0.01;
    const double deep = -model::height_above_bed(bed_, x);
    place(where, x, type, std::max(deepest_start(c_, type), kPart * model::length_of(line)));
    if (deep >= 0.5 * type.contact_diameter && deep > kRounded) {
      const LineEnd line_end = &e == &line.end_b ? LineEnd::B : LineEnd::A;
      c_.notes.push_back(
          advice::bed_lowered_at_end(where, deep, model::bed_at_end(c_, line, line_end, 0).length));
    }
  }
  // A line with an automatic start shape is straight from its end in the soil to the bed.
  void reaches(const model::Line& line, const model::End& e, const Vec3& x) const {
    if (!line.starts_by_itself()) return;
    const bool a = &e == &line.end_a;
    const size_t i = a ? 0 : line.buried.size() - 1;
    const double length = line.buried[i].to - line.buried[i].from;
    const double deep = -model::height_above_bed(bed_, x);
    const std::string key = fmt::format("lines.{}.buried[{}].{}", line.name, i, a ? "to" : "from");
    if (deep >= length)
      c_.refuse(key, "{:.4g} m of line do not reach the seabed, which is {:.4g} m above its end", length,
                deep);
  }
  // Refuses positions deeper than `max_depth` [m], which bed contact would expel.
  void place(const std::string& key, const Vec3& x, const model::LineType& type, double max_depth) const {
    const double deep = -model::height_above_bed(bed_, x);
    if (covers(x) && deep > max_depth)
      c_.refuse(key,
                "is {:.3g} m below the seabed; a line of '{}' may start at most {:.2g} m below it here "
                "unless it is 'buried'; raise the end, or give the length that is 'buried'",
                deep, type.name, max_depth);
  }

  model::Case& c_;
  const model::Seabed& bed_;
  const HeightGrid* grid_ = nullptr;
  Box box_;
};

}  // namespace

void check_bed(model::Case& c) {
  if (c.environment.seabed.present) BedCheck(c).run();
}

}  // namespace hawser::io
