// Entries of `bodies`: motion from files and rows, hydrodynamics, and settings that depend on the sea.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "hawser/advice/coefficients_in_sea.hpp"
#include "hawser/advice/hydrodynamic_files.hpp"
#include "hawser/io/case_values.hpp"
#include "hawser/io/hydrodynamic_files.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/mass_matrix.hpp"

namespace hawser::io {

using model::Value;

namespace {

// True if the case file contains the key, so that its value is not a default.
bool given(const Value& map, const char* key) {
  const Value* v = map.find(key);
  return v && v->given;
}

// Refuses a sea with much of its energy in directions without rows, or an irregular sea with most of it at
// longer, or shorter, periods than the table. quantity: "wave forces", "drift forces".
void check_coverage(const Value& files, const std::vector<WaveForceTable>& tables, int body,
                    const char* quantity, const std::vector<WaveComponent>& sea, double heading,
                    const std::string& key, std::vector<std::string>& notes) {
  if (tables.empty() || sea.empty()) return;
  constexpr double kSmall = 0.01, kMostUncovered = 0.05, kMostBeyond = 0.5;  // of the energy
  const WaveForceTable& table = tables[static_cast<size_t>(body) - 1];
  const model::Coverage coverage = model::coverage(table, sea, heading);
  if (coverage.uncovered > kMostUncovered)
    model::refuse(files, advice::directions_missing(quantity, table, coverage));
  if (coverage.uncovered > kSmall)
    notes.push_back(advice::directions_not_covered(key, quantity, table, coverage));
  const auto check_beyond = [&](double energy, advice::BeyondPeriods beyond, double omega) {
    if (!(energy > kSmall)) return;
    const double last = 2 * M_PI / omega;
    if (sea.size() > 1 && energy > kMostBeyond)
      model::refuse(files, advice::periods_missing(quantity, energy, beyond, last));
    notes.push_back(advice::periods_not_covered(key, quantity, energy, beyond, last));
  };
  check_beyond(coverage.shorter_waves, advice::BeyondPeriods::shorter, table.highest());
  check_beyond(coverage.longer_waves, advice::BeyondPeriods::longer, table.lowest());
}

auto reader_of(model::BodyHydrodynamics::Format format) {
  switch (format) {
    case model::BodyHydrodynamics::Format::capytaine:
      return read_capytaine;
    case model::BodyHydrodynamics::Format::bemio:
      return read_bemio;
    case model::BodyHydrodynamics::Format::wamit:
      break;
  }
  return read_wamit;
}

// Compares the centre of mass implied by the weight in the files' stiffness with that of the body.
void compare_centre(const Vec3& weight, const model::BodyMass& m, const model::Environment& e,
                    const std::string& key, std::vector<std::string>& notes) {
  constexpr double kSame = 0.05;
  const Vec3 centre = weight / (m.mass * e.gravity);
  if ((centre - m.centre).norm() > kSame * std::cbrt(m.mass / e.water.density))
    notes.push_back(advice::weight_elsewhere(key, centre, m.centre));
}

// Rows of a period and the diagonal or full matrix of surge, sway and yaw; stored by increasing frequency.
void read_drift_damping(const Value& v, const CaseSource& source, model::BodyHydrodynamics& h) {
  const InputRows given = read_input_rows(v, source);
  const auto& rows = given.rows;
  std::map<double, Mat3> by_omega;
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != 4 && r.size() != 10)
      refuse_rows(given,
                  "a row has 4 numbers (period, Bxx, Byy, Bzz) or 10 (period, matrix), but row {} has {}",
                  i + 1, r.size());
    if (!(r[0] > 0)) refuse_rows(given, "a period is above 0 s, but row {} has {:g}", i + 1, r[0]);
    Mat3 B = Mat3::Zero();
    if (r.size() == 4)
      B.diagonal() << r[1], r[2], r[3];
    else
      B = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&r[1]);
    if (!by_omega.emplace(2 * M_PI / r[0], B).second) refuse_rows(given, "has the period {:g} s twice", r[0]);
  }
  h.drift_damping.assign(by_omega.begin(), by_omega.end());
}

// The sea with all waves turned to its mean direction, the only one of which forces of all difference
// frequencies are read. Refuses a sea with most of its energy far from that direction.
std::vector<WaveComponent> in_mean_direction(const Value& second_order, std::vector<WaveComponent> sea) {
  constexpr double kMost = 0.5;  // of the energy
  const auto [mean, far] = model::mean_direction(sea);
  if (far > kMost)
    model::refuse(
        second_order,
        "'full' takes the forces of the mean direction of the waves, {:.3g} deg, for all of them, but "
        "{:.3g} % of the sea's energy goes to directions more than {:g} deg from it: use 'newman', "
        "which uses all directions",
        mean * 180 / M_PI, 100 * far, model::kFarFromMean * 180 / M_PI);
  for (WaveComponent& w : sea) {
    w.x = std::cos(mean);
    w.y = std::sin(mean);
  }
  return sea;
}

// Reads the files of a body's coefficients, once per file.
void read_hydrodynamics(const Value& v, const CaseSource& source, model::Body& b, model::Case& c) {
  model::BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const Value& files = v[h.key()];
  h.files = source.absolute(h.files);
  std::shared_ptr<const model::HydrodynamicData>& known =
      source.files->coefficients[fmt::format("{} {} {} {} {}", h.files, static_cast<int>(h.format), h.length,
                                             static_cast<int>(h.second_order), h.mirrored)];
  if (!known) {
    HydrodynamicForm form;
    form.length = h.length;
    form.density = c.environment.water.density;
    form.gravity = c.environment.gravity;
    form.depth = c.environment.water.depth;
    form.mirrored = h.mirrored;
    std::vector<std::string> notes, read;
    try {
      known = std::make_shared<const model::HydrodynamicData>(
          reader_of(h.format)(h.files, form, h.second_order, read, notes));
    } catch (const std::runtime_error& e) {
      model::refuse(files, e.what());
    }
    for (const std::string& path : read) source.input(path);
    for (const std::string& n : notes) {
      const auto is_known = [&n](const std::string& note) { return note.ends_with(n); };
      if (std::none_of(c.notes.begin(), c.notes.end(), is_known))
        c.notes.push_back("bodies." + b.name + ".floating.hydrodynamics: " + n);
    }
  }
  h.data = known;
  h.second_order_given = given(v, "second_order");
  if (const Value* damping = v.find("quadratic_damping")) {
    const auto is_row = [](const Value& row) { return row.kind == Value::Kind::list; };
    const auto rows = std::count_if(damping->items.begin(), damping->items.end(), is_row);
    if (rows != 0 && rows != 6)
      model::refuse(*damping, "has numbers and rows: give six numbers, or six rows of six");
  }
  if (const Value* damping = v.find("wave_drift_damping")) read_drift_damping(*damping, source, h);
  if (h.body > h.data->bodies)
    model::refuse(v["body"], "is {}, and {} has {}: it is the number of the body in the files", h.body,
                  h.data->radiation_file,
                  h.data->bodies == 1 ? "one body" : fmt::format("{} bodies", h.data->bodies));
  const auto body = static_cast<size_t>(h.body) - 1;
  if (!given(v, "origin_in_file") && body < h.data->origin.size() && h.data->origin[body])
    h.in_file = *h.data->origin[body];
  // Capytaine's stiffness always has the weight.
  if (!given(v, "gravity_in_stiffness"))
    h.gravity_in_stiffness = h.format == model::BodyHydrodynamics::Format::capytaine;
  if (h.gravity_in_stiffness && body < h.data->weight.size() && h.data->weight[body])
    compare_centre(*h.data->weight[body], *b.mass, c.environment, "bodies." + b.name + ".floating", c.notes);
}

bool has_springs_or_dampers(const model::BodyMass& m) {
  return !(m.stiffness.isZero() && m.damping.isZero() && m.turning_stiffness.isZero() &&
           m.turning_damping.isZero() && m.stiffness_matrix.isZero() && m.damping_matrix.isZero());
}

// Rows of time, force and optionally moment.
void read_load_table(const Value& table, const CaseSource& source, model::BodyLoad& load) {
  const InputRows given = read_input_rows(table, source);
  const auto& rows = given.rows;
  if (rows.size() < 2) refuse_rows(given, "a table of forces needs at least 2 rows, found {}", rows.size());
  const size_t columns = rows.front().size();
  if (columns != 4 && columns != 7)
    refuse_rows(given, "a row has 4 numbers (t, Fx, Fy, Fz) or 7 (and Mx, My, Mz), found {}", columns);
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != columns)
      refuse_rows(given, "row {} has {} numbers, but row 1 has {}", i + 1, r.size(), columns);
    check_increase(given, i, "times", "s");
    Vec6 force = Vec6::Zero();
    for (size_t k = 1; k < columns; ++k) force[static_cast<Eigen::Index>(k) - 1] = r[k];
    load.table.emplace_back(r[0], force);
  }
}

}  // namespace

void finish_body(const Value& v, const CaseSource& source, model::Body& b, model::Case& c) {
  if (const Value* f = v.find("floating")) {
    if (b.mass->matrix) model::use_mass_matrix(*b.mass);
    if (const Value* w = f->find("in_water"))
      b.mass->in_water->added_mass += c.environment.water.density * b.mass->in_water->volume * vec(*w, "Ca");
    if (const Value* loads = f->find("loads"))
      for (size_t i = 0; i < loads->items.size(); ++i)
        if (const Value* t = loads->items[i].find("table")) read_load_table(*t, source, b.mass->loads[i]);
    if (const Value* w = f->find("wind")) read_flow_on_body(*w, source, *b.mass->wind);
    if (const Value* w = f->find("current")) read_flow_on_body(*w, source, *b.mass->current);
    const Value* waves = f->find("hydrodynamics");
    const Value* hull = f->find("hull");
    if ((waves || hull) && !given(*f, "weight")) b.mass->weight = true;
    if (hull && waves && !given(*hull, "wave_pressure")) b.mass->hull->wave_pressure = false;
    if (const Value* members = f->find("members"))
      for (size_t i = 0; i < members->items.size(); ++i)
        if (waves && !given(members->items[i], "Ca")) b.mass->members[i].added = 0;
    if (waves) read_hydrodynamics(*waves, source, b, c);
  }
  const Value* m = v.find("motion");
  if (!m) return;
  if (b.mass && !has_springs_or_dampers(*std::as_const(b).mass))
    model::refuse(*m,
                  "moves the far ends of the springs and dampers of a floating body, and this body has none: "
                  "give 'stiffness' or 'damping' under 'floating', or an initial 'velocity' there, or remove "
                  "'floating' to prescribe the motion of the body itself");
  if (const Value* d = m->find("drift"))
    if (const Value* t = d->find("table")) read_motion_table(*t, source, b.drift->table, c.notes);
  if (const Value* t = m->find("table"))
    read_motion_table(*t, source, std::get<model::TableMotion>(b.motion), c.notes);
  if (const Value* rao = m->find("rao")) read_responses(*rao, c.environment.gravity, source, c.notes);
}

void finish_body_in_sea(const Value& v, const CaseSource& source, model::Body& b, model::Case& c) {
  if (const Value* f = v.find("floating"))
    if (const Value* waves = f->find("hydrodynamics")) {
      const model::BodyHydrodynamics& h = *std::as_const(b).mass->hydrodynamics;
      const double heading = model::hydrodynamic_heading(b);
      const auto& sea = source.files->sea(c.environment).components();
      const std::string key = "bodies." + b.name + ".floating.hydrodynamics";
      const Value& files = (*waves)[h.key()];
      const auto cover = [&](const std::vector<WaveForceTable>& tables, const char* quantity,
                             const std::vector<WaveComponent>& waves_of_body) {
        check_coverage(files, tables, h.body, quantity, waves_of_body, heading, key, c.notes);
      };
      if (h.excitation) cover(h.data->excitation, "wave forces", sea);
      if (h.second_order == SecondOrder::full) {
        const model::DifferenceForces& of = model::difference_forces(h, sea, heading);
        cover(of.drift, "drift forces", in_mean_direction((*waves)["second_order"], sea));
        if (h.data->difference.size() > 1 && !sea.empty())
          c.notes.push_back(advice::one_direction_of_difference_forces(key, of.direction()));
      } else {
        cover(h.data->drift, "drift forces", sea);
      }
      if (model::wave_drift_damping(h, sea).diagonal().minCoeff() < 0)
        c.notes.push_back(advice::negative_drift_damping(key));
    }
  const Value* m = v.find("motion");
  const Value* rao = m ? m->find("rao") : nullptr;
  if (!rao) return;
  b.motion = read_rao(*rao, c.environment, b, c.dynamics.duration, source, c.notes);
  if (!given(*m, "ramp")) b.ramp = c.environment.water.waves.ramp;
}

}  // namespace hawser::io
