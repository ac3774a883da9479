// Coefficient tables of wind and current on bodies.
#include <algorithm>
#include <cmath>

#include "hawser/math/angle_gap.hpp"
#include "hawser/math/degree.hpp"

namespace hawser::io {

using model::refuse;
using model::Value;

namespace {

constexpr double kSame = 1e-6;     // deg
constexpr double kWideGap = 60;    // deg between rows; wider gaps miss a side of the body
constexpr double kRounded = 1e-6;  // tolerance of coefficients that should be equal or zero

struct CoefficientRow {
  double angle = 0;  // deg
  Vec3 C = Vec3::Zero();
};

std::vector<CoefficientRow> rows_of(const InputRows& given) {
  const auto& rows = given.rows;
  if (rows.size() < 2)
    refuse_rows(given, "a table of coefficients needs at least 2 rows, found {}", rows.size());
  std::vector<CoefficientRow> out;
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != 4)
      refuse_rows(given, "a row has 4 numbers (angle, Cx, Cy, Cn), but row {} has {}", i + 1, r.size());
    check_increase(given, i, "angles", "deg", kSame);
    out.push_back({r[0], Vec3(r[1], r[2], r[3])});
  }
  if (const double span = out.back().angle - out.front().angle; span > 360 + kSame)
    refuse_rows(given, "the rows go over {:g} deg, more than once round", span);
  return out;
}

double largest(const std::vector<CoefficientRow>& rows) {
  double size = 0;
  for (const CoefficientRow& r : rows) size = std::max(size, r.C.cwiseAbs().maxCoeff());
  return size;
}

// Completes rows of 0 to 180 deg (or of the other side) by their mirror image.
bool mirror(const InputRows& given, std::vector<CoefficientRow>& rows) {
  const double first = rows.front().angle;
  const double last = rows.back().angle;
  if (std::abs(last - first - 180) > kSame || std::abs(std::remainder(first, 180)) > kSame) return false;
  for (const CoefficientRow* r : {&rows.front(), &rows.back()})
    if (r->C.tail<2>().cwiseAbs().maxCoeff() > kRounded * largest(rows))
      refuse_rows(
          given,
          "rows of one side are mirrored for the other, so that Cy and Cn at {:g} deg are 0, found {:g} and "
          "{:g}: give rows all round, of 0 to 360 deg, of a body whose sides differ",
          r->angle, r->C.y(), r->C.z());
  for (size_t i = rows.size() - 1; i-- > 1;)
    rows.push_back({2 * last - rows[i].angle, Vec3(rows[i].C.x(), -rows[i].C.y(), -rows[i].C.z())});
  return true;
}

void close_round(const InputRows& given, std::vector<CoefficientRow>& rows) {
  const double span = rows.back().angle - rows.front().angle;
  if (std::abs(span - 360) > kSame) return;
  const Vec3 a = rows.front().C;
  const Vec3 b = rows.back().C;
  if ((a - b).cwiseAbs().maxCoeff() > kRounded * largest(rows))
    refuse_rows(given, "the rows of {:g} and {:g} deg are of one direction and differ", rows.front().angle,
                rows.back().angle);
  rows.pop_back();
}

void check_gaps(const InputRows& given, const std::vector<CoefficientRow>& rows) {
  std::vector<double> angles;
  for (const CoefficientRow& r : rows) angles.push_back(r.angle);
  const AngleGap gap = widest_gap(angles, 360);
  if (gap.width() > kWideGap + kSame)
    refuse_rows(
        given,
        "there is no row between {:g} and {:g} deg: rows are at most {:g} deg apart, all round or from 0 to "
        "180 deg for a body whose sides are mirror images",
        gap.from, gap.to, kWideGap);
}

// Coefficient along the axis of a flow to a multiple of 90 deg, positive with the flow.
double along_flow(const model::FlowOnBody& f, double angle) {
  Vec3 C, slope;
  f.coefficients.at(angle * kDegree, C, slope);
  const double along = std::fmod(angle, 180) == 0 ? C.x() : C.y();
  return angle < 180 ? along : -along;
}

// The force of a flow must be in the direction of the flow. If it is so only ahead and astern, or only to the
// sides, the table counts angles clockwise.
void check_signs(const InputRows& given, const model::FlowOnBody& f) {
  const auto is_against = [&](double angle) { return along_flow(f, angle) < 0; };
  const bool ahead = is_against(0) && is_against(180);
  const bool across = is_against(90) && is_against(270);
  const char* other = f.by_origin ? "to" : "from";
  if (across && !is_against(0) && !is_against(180))
    refuse_rows(
        given,
        "flows from the sides, and they alone, push the body against them: do its angles go clockwise, or is "
        "Cy positive to starboard? Then reverse the signs of Cy and Cn");
  if (ahead && !is_against(90) && !is_against(270))
    refuse_rows(
        given,
        "flows to 0 and 180 deg, and they alone, push the body against them: do its angles go clockwise, and "
        "are they those '{}' which the flow {}? Then give 'angles: {}' and reverse the signs of Cy and Cn",
        other, f.by_origin ? "goes" : "comes", other);
  for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
    if (!is_against(angle)) continue;
    const bool lengthwise = angle == 0 || angle == 180;
    refuse_rows(
        given,
        "where the flow goes to {:g} deg, {}, C{} = {:g} pushes the body against it: are the angles those "
        "'{}' which it {}? Then give 'angles: {}'",
        angle,
        angle == 0     ? "ahead"
        : angle == 180 ? "astern"
        : angle == 90  ? "to port"
                       : "to starboard",
        lengthwise ? 'x' : 'y', angle < 180 ? along_flow(f, angle) : -along_flow(f, angle), other,
        f.by_origin ? "goes" : "comes", other);
  }
}

}  // namespace

void read_flow_on_body(const Value& v, const CaseSource& source, model::FlowOnBody& f) {
  const InputRows given = read_input_rows(v, source);
  std::vector<CoefficientRow> rows = rows_of(given);
  f.rows = static_cast<int>(rows.size());
  f.mirrored = mirror(given, rows);
  close_round(given, rows);
  check_gaps(given, rows);
  std::vector<FlowCoefficients::Row> out;
  for (const CoefficientRow& r : rows) out.push_back({(r.angle + (f.by_origin ? 180 : 0)) * kDegree, r.C});
  f.coefficients = FlowCoefficients(std::move(out));
  check_signs(given, f);
  if (v.has("draught") && (v.has("frontal_area") || v.has("lateral_area")))
    refuse(v["draught"], "makes both areas: give it, or 'frontal_area' and 'lateral_area'");
  if (f.draught > 0) f.frontal = f.lateral = f.length * f.draught;
  if (!(f.frontal > 0 && f.lateral > 0))
    model::refuse_key(v, v.where + (f.frontal > 0 ? ".lateral_area" : ".frontal_area"),
                      "required key is missing: both areas, or 'draught'");
}

}  // namespace hawser::io
