// Derived quantities of a case: thermal strain, inertia tensors, participation in contact, and look-up of
// line types, joints, bodies and lines by name.
#include "hawser/model/case.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "hawser/base/error.hpp"
#include "hawser/math/broken_line.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/model/switched.hpp"
#include "hawser/model/temperature_rows.hpp"

namespace hawser::model {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

double mean_temperature_change(const std::vector<std::pair<double, double>>& rows, double from, double to) {
  if (rows.empty()) return 0;
  if (rows.size() == 1) return rows.front().second;
  double last = from;
  double before = on_broken_line(rows, from);
  double sum = 0;
  const auto add_interval = [&](double s, double value) {
    sum += 0.5 * (s - last) * (before + value);
    last = s;
    before = value;
  };
  const auto first = std::upper_bound(rows.begin(), rows.end(), from,
                                      [](double s, const auto& row) { return s < row.first; });
  for (auto row = first; row != rows.end() && row->first < to; ++row) add_interval(row->first, row->second);
  add_interval(to, on_broken_line(rows, to));
  return to > from ? sum / (to - from) : before;
}

double mean_temperature_change(const Line& line, double from, double to) {
  return mean_temperature_change(line.temperature_change, from, to);
}

double thermal_strain(const LineType& type, const Line& line, double from, double to) {
  return type.thermal_expansion == 0 ? 0 : type.thermal_expansion * mean_temperature_change(line, from, to);
}

Mat3 BodyMass::tensor() const {
  Mat3 J = inertia.asDiagonal();
  J(0, 1) = J(1, 0) = products.x();
  J(1, 2) = J(2, 1) = products.y();
  J(0, 2) = J(2, 0) = products.z();
  return J;
}

bool Contact::has_friction(const std::vector<Volume>& all) const {
  const auto rubs = [](const BetweenLines::Tuned& pair) { return pair.settings.friction > 0; };
  return std::any_of(all.begin(), all.end(),
                     [&](const Volume& v) {
                       return takes_part(v) && std::max(v.friction.axial, v.friction.lateral) > 0;
                     }) ||
         (between_lines.enabled &&
          (between_lines.general.friction > 0 ||
           std::any_of(between_lines.pairs.begin(), between_lines.pairs.end(), rubs)));
}

bool Contact::takes_part(const Line& line) const { return all_lines || holds(lines, line.name); }

bool Contact::takes_part(const Volume& volume) const {
  return all_volumes || volume.roller || holds(volumes, volume.name);
}

const LineType& Case::line_type(const std::string& name) const {
  const int i = type_at_.find(line_types, name);
  if (i < 0) throw std::out_of_range("no line type '" + name + "'");
  return line_types[i];
}

const Joint& Case::joint(const std::string& name) const {
  const int i = joint_at_.find(joints, name);
  if (i < 0) throw std::out_of_range("no joint '" + name + "'");
  return joints[i];
}

int Case::body_index(const std::string& name) const {
  return name.empty() ? -1 : body_at_.find(bodies, name);
}

int Case::line_index(const std::string& name) const {
  const int i = line_at_.find(lines, name);
  if (i < 0) throw std::out_of_range("no line '" + name + "'");
  return i;
}

const Line& Case::line(const std::string& name) const { return lines[line_index(name)]; }

namespace {

// The entries of a map that are not empty: of bodies those with values that a restart compares.
Value entries_with_values(Value map) {
  Value out;
  if (map.kind != Value::Kind::map) return out;
  out.kind = map.kind;
  out.line = map.line;
  out.given = map.given;
  out.schema = map.schema;
  for (std::size_t i = 0; i < map.items.size(); ++i) {
    if (map.items[i].items.empty()) continue;
    out.keys.push_back(std::move(map.keys[i]));
    out.items.push_back(std::move(map.items[i]));
  }
  return out;
}

}  // namespace

void Case::forget_lines_and_bodies(const std::vector<bool>& kept) {
  std::set<std::string> named;
  for (const Event& e : events) named.insert({e.action.line, e.action.given_line, e.cause.line});
  for (const Link& l : links) named.insert({l.end_a.line, l.end_b.line});
  for (const Body& b : bodies)
    if (b.ride) named.insert(b.ride->line);
  for (const SupportBox& b : supports) named.insert(b.line);
  for (const HistoryPoint& h : output.histories) named.insert(h.line);
  for (const Clearance& d : output.clearances) named.insert({d.line, d.other_line});
  for (std::size_t l = 0; l < lines.size(); ++l)
    if (!kept[l] && lines.has(l) && !named.contains(lines[l].name)) lines.forget(l);
  line_at_ = {};
  std::set<std::string> carriers;
  for (std::size_t l = 0; l < lines.size(); ++l)
    if (lines.has(l))
      for (const Line* line : {&std::as_const(lines)[l], &std::as_const(lines)[l].as_given()})
        carriers.insert({line->end_a.carrier, line->end_b.carrier});
  for (const Event& e : events) carriers.insert({e.action.body, e.cause.body});
  for (const Link& l : links) carriers.insert({l.end_a.body, l.end_b.body});
  for (const Volume& v : volumes) carriers.insert(v.body);
  for (const SupportBox& b : supports) carriers.insert(b.body);
  for (const HistoryPoint& h : output.histories) carriers.insert(h.body);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.has(i)) continue;
    const Body& b = std::as_const(bodies)[i];
    if (!b.mass && !b.ride && velocity_jumps(b).empty() && !carriers.contains(b.name)) bodies.forget(i);
  }
  body_at_ = {};
  if (!tree) return;
  const auto rest = std::make_shared<Value>(*tree);
  for (std::size_t i = 0; i < rest->keys.size(); ++i) {
    const bool of_bodies = rest->keys[i] == "bodies";
    if (!of_bodies && rest->keys[i] != "lines") continue;
    Value all;
    std::swap(rest->items[i], all);  // assigning it would keep the capacity of the text
    if (of_bodies) rest->items[i] = entries_with_values(std::move(all));
  }
  tree = rest;
}

bool Case::holds_both_ends(const Line& line) const {
  return std::ranges::all_of(kLineEnds, [&](LineEnd side) {
    const End& end = line.end(side);
    if (end.feed) return false;
    if (end.kind == EndKind::anchor) return true;
    const int body = end.kind == EndKind::body ? body_index(end.carrier) : -1;
    return body >= 0 && !floats(body) && !rides(body);
  });
}

bool Case::off_at_start(const Volume& volume) const {
  for (const Event& e : events)
    if (switches(e.action, volume)) return e.action.enabled;
  return false;
}

std::string Case::refusal(const std::string& key, const std::string& why) const {
  const KeyPlace at = place_of(*this, key);
  return model::refusal(at.file, at.line, key, why);
}

void Case::refuse(const std::string& key, const std::string& why) const {
  throw InputError(refusal(key, why));
}

}  // namespace hawser::model
