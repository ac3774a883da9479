// What several parts of the case reader share: file paths, tables of numbers, shapes, tables of motion and of
// force, friction, and contact between lines.
#include "hawser/io/case_reader_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {

using model::Value;
namespace fs = std::filesystem;

std::vector<std::vector<double>> read_rows(const std::string& path, const Value& at, const std::string& key,
                                           const CaseSource& source, std::vector<int>* lines) {
  if (const std::string why = unreadable(path, "table", kMostTable); !why.empty())
    source.bad(at, key, path + ": " + why);
  std::ifstream in(path);
  if (!in) source.bad(at, key, path + ": cannot be read");
  std::vector<std::vector<double>> rows;
  std::string line;
  for (int n = 1; std::getline(in, line); ++n) {
    line = line.substr(0, line.find('#'));
    for (char& c : line)
      if (c == ',' || c == '\t' || c == '\r') c = ' ';
    std::vector<double> row;
    std::istringstream words(line);
    for (std::string w; words >> w;) {
      const model::Quantity q = model::parse_quantity(w, model::Dimension::none);
      if (q.status != model::Quantity::Status::ok)
        source.bad(at, key, fmt::format("{}:{}: {} is no finite number", path, n, model::quote(w)));
      row.push_back(q.si);
    }
    if (row.empty()) continue;
    rows.push_back(std::move(row));
    if (lines) lines->push_back(n);
  }
  return rows;
}

std::string CaseSource::absolute(const std::string& path) const {
  return (fs::path(directory) / fs::path(path)).lexically_normal().string();
}

void CaseSource::bad(const Value& v, const std::string& key, const std::string& text) const {
  model::fail(file, v.line, key, text);
}

std::string other_units(double size, const SizeLimits& limits, const model::Case& c) {
  double thin = 0;
  for (const model::Line& l : c.lines)
    for (const model::Section& s : l.sections) {
      const double d = c.line_type(s.type).contact_diameter;
      thin = thin > 0 ? std::min(thin, d) : d;
    }
  const bool beside = thin > 0 && (size > limits.most_thin * thin || size < limits.least_thin * thin);
  if (size <= limits.most && !beside) return "";
  return fmt::format("is {:.4g} m large{}; is it in other units than metres?", size,
                     thin > 0
                         ? fmt::format(", {:.3g} times the contact diameter of the thinnest line ({:.4g} m)",
                                       size / thin, thin)
                         : "");
}

Vec3 as_vec3(const Value& v) { return {v.items[0].number, v.items[1].number, v.items[2].number}; }

Vec3 read_direction(const Value& v, const char* key, const std::string& path, const CaseSource& source) {
  const Vec3 x = as_vec3(v[key]);
  const double n = x.stableNorm();
  if (!(n > 0)) source.bad(v[key], path + "." + key, "[0, 0, 0] is no direction");
  return x / n;
}

model::BetweenLines read_between_lines(const Value& v, const CaseSource& source) {
  model::BetweenLines b;
  if (v.kind != Value::Kind::map) {
    b.enabled = v.number != 0;
    return b;
  }
  // What is not given is as in `o`: for a pair of lines what is said for all.
  const auto settings = [](const Value& s, model::LinePairSettings o) {
    if (const Value* k = s.find("normal_stiffness")) {
      o.basis = model::StiffnessBasis::automatic, o.normal_stiffness = 0;
      if (const Value* x = k->find("per_length"))
        o.basis = model::StiffnessBasis::per_length, o.normal_stiffness = x->number;
      if (const Value* x = k->find("per_area"))
        o.basis = model::StiffnessBasis::per_area, o.normal_stiffness = x->number;
    }
    if (const Value* x = s.find("friction")) o.friction = x->number;
    if (const Value* x = s.find("relative_damping")) o.relative_damping = x->number;
    if (const Value* x = s.find("mobilisation_length")) o.mobilisation_length = x->number;
    if (const Value* x = s.find("smoothing")) o.smoothing = x->number;
    return o;
  };
  b.self = v["self"].number != 0;
  b.general = settings(v, {});
  for (const Value& e : v["exclude"].items) b.exclude.emplace_back(e.items[0].text, e.items[1].text);
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t i = 0; i < v["pairs"].items.size(); ++i) {
    const Value& p = v["pairs"].items[i];
    const std::string &x = p["lines"].items[0].text, &y = p["lines"].items[1].text;
    if (!seen.insert(ordered(x, y)).second)
      source.bad(p, fmt::format("contact.between_lines.pairs[{}].lines", i),
                 fmt::format("lines {} and {} have settings already", model::quote(x), model::quote(y)));
    b.pairs.push_back({x, y, settings(p, b.general)});
  }
  return b;
}

Primitive read_shape(const Value& shape, const std::string& key, const CaseSource& source) {
  const std::string path = key + "." + shape.keys.front();
  const Value& v = shape.items.front();
  const auto vec = [&](const char* name) { return as_vec3(v[name]); };
  const auto number = [&](const char* name) { return v[name].number; };
  if (shape.has("plane")) return PlaneShape{vec("point"), read_direction(v, "normal", path, source)};
  if (shape.has("box")) return BoxShape{vec("centre"), vec("size"), vec("rotation_deg")};
  if (shape.has("sphere")) return SphereShape{vec("centre"), number("radius")};
  if (shape.has("torus"))
    return TorusShape{vec("centre"), read_direction(v, "axis", path, source), number("radius"),
                      number("tube_radius")};
  if (shape.has("capsule")) return CapsuleShape{vec("from"), vec("to"), number("radius")};
  return CylinderShape{vec("from"), vec("to"), number("radius")};
}

GivenRows read_given_rows(const Value& v, const std::string& key, const CaseSource& source) {
  const bool from_file = v.has("file");
  GivenRows given{v[from_file ? "file" : "rows"], key + (from_file ? ".file" : ".rows"), {}};
  if (from_file) {
    given.rows = read_rows(source.absolute(given.at.text), given.at, given.key, source);
    return given;
  }
  for (const Value& r : given.at.items) {
    std::vector<double>& row = given.rows.emplace_back();
    for (const Value& x : r.items) row.push_back(x.number);
  }
  return given;
}

void check_time(const GivenRows& given, size_t i, const CaseSource& source) {
  if (i == 0) return;
  const double before = given.rows[i - 1][0], now = given.rows[i][0];
  if (!(now > before))
    source.bad(
        given.at, given.key,
        fmt::format("times must increase, but row {} has t = {:g} s after {:g} s", i + 1, now, before));
}

namespace {

// Of what a column spans: a sine of eleven rows a period and more stays within it.
constexpr double kOvershoot = 0.02;

// The furthest that a spline goes beyond the rows on either side.
void note_overshoot(const model::TableMotion& m, const std::string& key, std::vector<std::string>& notes) {
  struct Column {
    const std::vector<Vec3>& rows;
    const char* names[3];
    const char* unit;
    double factor;
  };
  const Column columns[] = {{m.offset, {"x", "y", "z"}, "m", 1},
                            {m.rotation,
                             {"the rotation about x", "the rotation about y", "the rotation about z"},
                             "deg",
                             180 / std::numbers::pi}};
  RowCurve::Overshoot worst;
  const Column* column = nullptr;
  double worst_share = 0;
  size_t places = 0;
  for (const Column& k : columns) {
    if (k.rows.empty()) continue;
    Vec3 least = k.rows.front(), most = least;
    for (const Vec3& x : k.rows) least = least.cwiseMin(x), most = most.cwiseMax(x);
    for (const RowCurve::Overshoot& o : RowCurve(m.time, k.rows, m.between).overshoots(kOvershoot)) {
      ++places;
      const double span = most[o.component] - least[o.component], share = span > 0 ? o.by / span : 0;
      if (share > worst_share) worst = o, worst_share = share, column = &k;
    }
  }
  if (!column) return;
  const double before = m.time[worst.row], after = m.time[worst.row + 1];
  notes.push_back(fmt::format(
      "{}: between its rows at {:g} and {:g} s the spline takes {} to {:.4g} {} at {:.4g} s, {:.3g} {} "
      "({:.3g} "
      "% of what the rows span) beyond both{}; if the body does not do that, give more rows there or "
      "'interpolation: monotone'",
      key, before, after, column->names[worst.component], worst.value * column->factor, column->unit,
      worst.time, worst.by * column->factor, column->unit, 100 * worst_share,
      places > 1 ? fmt::format(", and so in {} other place{}", places - 1, places > 2 ? "s" : "") : ""));
}

}  // namespace

model::TableMotion read_motion_table(const Value& table, const std::string& key, const CaseSource& source,
                                     std::vector<std::string>& notes) {
  const GivenRows given = read_given_rows(table, key, source);
  const auto& [at, where, rows] = given;
  if (rows.size() < 2)
    source.bad(at, where, fmt::format("a table of motion needs at least 2 rows, found {}", rows.size()));
  const std::size_t columns = rows.front().size();
  if (columns != 4 && columns != 7)
    source.bad(at, where,
               fmt::format("a row of motion has 4 numbers (t, x, y, z) or 7 (and a rotation vector), "
                           "found {}",
                           columns));
  model::TableMotion m;
  const Value& between = table["interpolation"];
  if (between.is("monotone")) m.between = BetweenRows::monotone;
  if (between.is("linear")) m.between = BetweenRows::linear;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != columns)
      source.bad(at, where, fmt::format("row {} has {} numbers, but row 1 has {}", i + 1, r.size(), columns));
    check_time(given, i, source);
    m.time.push_back(r[0]);
    m.offset.emplace_back(r[1], r[2], r[3]);
    if (columns == 7) m.rotation.push_back(Vec3(r[4], r[5], r[6]) * (std::numbers::pi / 180));
  }
  note_overshoot(m, key, notes);
  return m;
}

std::shared_ptr<const ContactForceTable> read_force_table(const Value& table, const std::string& key,
                                                          const CaseSource& source) {
  std::vector<ContactForceTable::Row> rows;
  for (const Value& r : table.items) rows.emplace_back(r.items[0].number, r.items[1].number);
  try {
    return std::make_shared<const ContactForceTable>(rows);
  } catch (const std::invalid_argument& e) {
    source.bad(table, key, e.what());
  }
}

model::Friction read_friction(const Value& f, const std::string& key, const CaseSource& source) {
  const auto pair = [](const Value& v, double& axial, double& lateral) {
    const bool both = v.kind == model::Value::Kind::map;
    axial = both ? v["axial"].number : v.number;
    lateral = both && v.has("lateral") ? v["lateral"].number : axial;
  };
  model::Friction o;
  pair(f, o.axial, o.lateral);
  if (const Value* k = f.find("kinetic")) pair(*k, o.axial_kinetic, o.lateral_kinetic);
  if (f.has("kinetic") != f.has("blend_speed"))
    source.bad(f, key,
               f.has("kinetic") ? "'kinetic' needs 'blend_speed' beside it"
                                : "'blend_speed' needs 'kinetic' beside it");
  if (f.has("blend_speed")) o.blend_speed = f["blend_speed"].number;
  if (const Value* d = f.find("mobilisation_length"))
    pair(*d, o.mobilisation_length, o.lateral_mobilisation_length);
  if (f.has("shear_stiffness")) o.shear_stiffness = f["shear_stiffness"].number;
  if (f["return"].is("associated")) o.back = FrictionReturn::associated;
  if (f["stick"].is("michalopoulos")) o.spring = FrictionSpring::michalopoulos;
  if (o.spring == FrictionSpring::michalopoulos && o.shear_stiffness > 0)
    source.bad(f, key, "'stick: michalopoulos' goes by 'mobilisation_length', not 'shear_stiffness'");
  return o;
}

model::ClashOutput read_clash_output(const Value& v) {
  model::ClashOutput o;
  if (v.kind != Value::Kind::map) {
    o.enabled = v.number != 0;
    return o;
  }
  o.merge_gap = v["merge_gap"].number;
  if (const Value* length = v.find("merge_length")) o.merge_length = length->number;
  o.rows = static_cast<int>(v["rows"].number);
  return o;
}

namespace {
// In the order of model::SignTest.
constexpr std::array kSigns{"automatic", "pseudonormal", "winding", "tetrahedron", "ray", "solid_angle"};
}  // namespace

model::SignTest read_sign(const std::string& word) {
  return static_cast<model::SignTest>(std::find(kSigns.begin(), kSigns.end(), word) - kSigns.begin());
}
std::string sign_word(model::SignTest sign) { return kSigns[static_cast<std::size_t>(sign)]; }

}  // namespace hawser::io
