// An entry of `links`: what its ends are fixed to, its spring and its damper.
#include <stdexcept>

#include "hawser/io/case_values.hpp"
#include "hawser/model/check.hpp"

namespace hawser::io {

using model::Value;

namespace {

model::LinkEnd end(const Value& v, const std::string& key, const CaseSource& source, const model::Case& c) {
  model::LinkEnd e;
  const Value* at = v.find("at");
  if (v.has("anchor")) {
    e.at = vec(v, "anchor");
    if (at) source.bad(*at, key + ".at", "is not for an 'anchor', which is a point in space already");
    return e;
  }
  if (!at)
    source.bad(v, key, std::string("'") + (v.has("body") ? "body" : "line") + "' needs 'at' beside it");
  const bool point = at->kind == Value::Kind::list;
  if (v.has("body")) {
    e.body = v["body"].text;
    if (!point) source.bad(*at, key + ".at", "of a body is a list of 3 numbers [m], a point in its frame");
    e.at = as_vec3(*at);
    return e;
  }
  e.line = v["line"].text;
  if (point)
    source.bad(*at, key + ".at", "of a line is a number [m], 'end_a' or 'end_b': the arc length from end A");
  e.arc = arc(at, 0, model::length_of(c.lines[static_cast<std::size_t>(c.line_index(e.line))]));
  return e;
}

std::vector<MonotoneCubic::Row> rows(const Value& table) {
  std::vector<MonotoneCubic::Row> out;
  for (const Value& row : table.items) out.emplace_back(row.items[0].number, row.items[1].number);
  return out;
}

}  // namespace

model::Link read_link(const std::string& name, const Value& v, const CaseSource& source,
                      const model::Case& c) {
  const std::string key = "links." + name;
  model::Link l;
  l.name = name;
  l.end_a = end(v["end_a"], key + ".end_a", source, c), l.end_b = end(v["end_b"], key + ".end_b", source, c);
  LinkLaw& law = l.law;
  law.stiffness = number(v, "stiffness"), law.damping = number(v, "damping");
  law.tension_only = v["tension_only"].number != 0;
  l.rest_given = v.has("rest_length");
  law.rest_length = number(v, "rest_length");
  if (const Value* table = v.find("force_table")) {
    std::vector<MonotoneCubic::Row> r = rows(*table);
    for (size_t i = 1; i < r.size(); ++i)
      if (!(r[i].first > r[i - 1].first) || !(r[i].second > r[i - 1].second))
        source.bad(table->items[i], key + ".force_table",
                   "row " + std::to_string(i + 1) +
                       " must have more elongation and more tension than the one before");
    if (law.tension_only && r.front().second < 0)
      source.bad(table->items[0], key + ".force_table",
                 "row 1 has a tension below 0, but the link is 'tension_only': begin where it goes slack");
    // The slope at an end is at least a tenth of the secant's, so that it holds on beyond its rows.
    constexpr double kLeastSlope = 0.1;
    law.spring = std::make_shared<MonotoneCubic>(std::move(r), std::nullopt, kLeastSlope);
  }
  if (const Value* table = v.find("damping_table")) {
    if (v.has("damping"))
      source.bad(*table, key, "'damping' and 'damping_table' exclude each other; give only one of them");
    const std::vector<MonotoneCubic::Row> r = rows(*table);
    try {
      law.damper = std::make_shared<ResponseCurve>(r, r.front().first >= 0);
    } catch (const std::invalid_argument& e) {
      source.bad(*table, key + ".damping_table",
                 std::string(e.what()) +
                     "; rows are a speed and a tension that resists it, both rising, [[m/s, N], ...]");
    }
  }
  return l;
}

}  // namespace hawser::io
