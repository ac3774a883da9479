// A seabed that is a grid of heights or a mesh, from a file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "hawser/base/error.hpp"
#include "hawser/geometry/ground.hpp"
#include "hawser/geometry/height_grid.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/case_reader_parts.hpp"
#include "hawser/io/mesh_reader.hpp"
#include "hawser/model/check.hpp"

namespace hawser::io {
namespace {

using model::Value;

// Ascending coordinates, those nearer than a millionth of the whole taken for one.
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

std::shared_ptr<const HeightGrid> read_grid(const Value& v, const std::string& key,
                                            const CaseSource& source) {
  const std::string path = source.absolute(v["file"].text), where = key + ".file";
  std::vector<int> line;
  const std::vector<std::vector<double>> rows = read_rows(path, v["file"], where, source, &line);
  const auto refuse = [&](size_t row, const std::string& text) {
    source.bad(v["file"], where, fmt::format("{}:{}: {}", path, line[row], text));
  };
  std::vector<double> x, y;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != 3)
      refuse(i, fmt::format("a row of a bed has 3 numbers, x, y and z, but this one has {}", rows[i].size()));
    x.push_back(rows[i][0]), y.push_back(rows[i][1]);
  }
  if (rows.empty()) source.bad(v["file"], where, path + ": the file has no rows");
  x = distinct(std::move(x)), y = distinct(std::move(y));
  if (x.size() < 2 || y.size() < 2)
    source.bad(v["file"], where,
               fmt::format("{}: a grid has two columns and two rows at least, but there {} x and {} y", path,
                           x.size() == 1 ? "is 1" : fmt::format("are {}", x.size()), y.size()));
  constexpr double kSparse = 100;
  if (static_cast<double>(x.size()) * static_cast<double>(y.size()) >
      kSparse * static_cast<double>(rows.size()))
    source.bad(v["file"], where,
               fmt::format("{}: {} rows with {} different x and {} different y are no grid: a grid has a "
                           "height for every x and every y; scattered points make a mesh",
                           path, rows.size(), x.size(), y.size()));
  const double up = v["depths"].number != 0 ? -1 : 1;
  std::vector<double> z(x.size() * y.size());
  std::vector<int> given(z.size(), -1);
  for (size_t i = 0; i < rows.size(); ++i) {
    const size_t k = place(y, rows[i][1]) * x.size() + place(x, rows[i][0]);
    if (given[k] >= 0)
      refuse(i, fmt::format("x {:g}, y {:g} is there twice, first in line {}", rows[i][0], rows[i][1],
                            line[static_cast<size_t>(given[k])]));
    given[k] = static_cast<int>(i), z[k] = up * rows[i][2];
  }
  const auto missing = std::find(given.begin(), given.end(), -1);
  if (missing != given.end()) {
    const size_t k = static_cast<size_t>(missing - given.begin());
    source.bad(v["file"], where,
               fmt::format("{}: there is no height at x {:g}, y {:g} ({} of {} places are missing); a grid "
                           "has one for every x and every y",
                           path, x[k % x.size()], y[k / x.size()], std::count(given.begin(), given.end(), -1),
                           given.size()));
  }
  return std::make_shared<const HeightGrid>(std::move(x), std::move(y), z);
}

std::shared_ptr<const MeshSurface> read_mesh_bed(const Value& v, const std::string& key,
                                                 const CaseSource& source) {
  const std::string path = source.absolute(v["file"].text);
  try {
    TriangleMesh sheet = read_sheet(path, v["scale"].number);
    const size_t top = sheet.triangles.size();
    TriangleMesh ground = ground_under(std::move(sheet));
    std::vector<bool> active(ground.triangles.size(), false);
    std::fill_n(active.begin(), top, true);
    return std::make_shared<const MeshSurface>(
        std::move(ground), std::move(active),
        MeshSurfaceOptions{
            .smooth = v["smooth"].number != 0, .crease_angle = v["crease_angle_deg"].number, .open = false});
  } catch (const InputError& e) {
    source.bad(v["file"], key + ".file", e.what());
  } catch (const std::invalid_argument& e) {
    source.bad(v["file"], key + ".file", path + ": " + e.what());
  }
}

}  // namespace

void read_bed_surface(const Value& v, const CaseSource& source, model::Seabed& bed) {
  const std::string key = "environment.seabed.";
  double low = 0, high = 0;
  if (const Value* g = v.find("grid")) {
    const auto grid = read_grid(*g, key + "grid", source);
    low = grid->lowest(), high = grid->highest();
    bed.surface = grid, bed.file = source.absolute((*g)["file"].text);
  } else if (const Value* m = v.find("mesh")) {
    const auto mesh = read_mesh_bed(*m, key + "mesh", source);
    const MeshView t = mesh->mesh();
    low = std::numeric_limits<double>::infinity(), high = -low;
    for (size_t i = 0; i < t.vertices.size() / 2; ++i)  // the other half is the floor
      low = std::min(low, t.vertices[i].z()), high = std::max(high, t.vertices[i].z());
    bed.surface = mesh, bed.file = source.absolute((*m)["file"].text);
  } else {
    return;
  }
  bed.depth = -0.5 * (low + high);
}

void check_bed(const model::Case& c, std::vector<std::string>& notes) {
  const model::Seabed& bed = c.environment.seabed;
  if (!bed.surface) return;
  const auto* grid = dynamic_cast<const HeightGrid*>(bed.surface.get());
  const Box box = bed.surface->bounds();
  const auto look = [&](const model::Line& line, const model::End& end, const char* name) {
    if (end.kind == model::EndKind::free) return;
    const Vec3 x = model::end_position(c, end);
    const bool inside =
        grid ? grid->covers(x)
             : x.x() >= box.lo.x() && x.x() <= box.hi.x() && x.y() >= box.lo.y() && x.y() <= box.hi.y();
    if (!inside) {
      notes.push_back(fmt::format("lines.{}.{}: lies beyond the edge of the bed of {}, {}", line.name, name,
                                  bed.file, grid ? "which goes on straight there" : "where there is none"));
      return;
    }
    if (const auto s = bed.surface->query(x, 0); s && s->distance < -1)
      notes.push_back(fmt::format("lines.{}.{}: is {:.3g} m under the bed of {}", line.name, name,
                                  -s->distance, bed.file));
  };
  for (const model::Line& line : c.lines) look(line, line.end_a, "end_a"), look(line, line.end_b, "end_b");
}

}  // namespace hawser::io
