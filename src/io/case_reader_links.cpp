// Entries of `links`: their ends, and curves through tables.
#include <stdexcept>

#include "hawser/io/case_values.hpp"
#include "hawser/model/check.hpp"

namespace hawser::io {

using model::refuse;
using model::refuse_key;
using model::Value;

namespace {

void finish_end(const Value& v, model::LinkEnd& e, const model::Case& c) {
  const Value* at = v.find("at");
  if (v.has("anchor")) {
    if (at) refuse(*at, "is not for an 'anchor', which is a point in space already");
    return;
  }
  const bool body = v.has("body");
  if (!at) refuse(v, std::string("'") + (body ? "body" : "line") + "' requires 'at'");
  const bool point = at->kind == Value::Kind::list;
  if (body && !point) refuse(*at, "of a body is a list of 3 numbers [m], a point in its frame");
  if (!body && point) refuse(*at, "of a line is a number [m], 'end_a' or 'end_b': the arc length from end A");
  if (!body) to_length(e.arc, length_of(c, e.line));
}

}  // namespace

void finish_link(const Value& v, model::Link& l, const model::Case& c) {
  finish_end(v["end_a"], l.end_a, c);
  finish_end(v["end_b"], l.end_b, c);
  LinkLaw& law = l.law;
  if (const Value* table = v.find("force_table")) {
    std::vector<MonotoneCubic::Row> r = table->rows();
    for (size_t i = 1; i < r.size(); ++i)
      if (!(r[i].first > r[i - 1].first) || !(r[i].second > r[i - 1].second))
        refuse_key(table->items[i], table->where,
                   "row " + std::to_string(i + 1) +
                       " must have more elongation and more tension than the one before");
    if (law.tension_only && r.front().second < 0)
      refuse_key(table->items[0], table->where,
                 "row 1 has a tension below 0, but the link is 'tension_only': begin where it goes slack");
    // End slopes of at least a tenth of the secant's keep the spring stiff beyond its rows.
    constexpr double kLeastSlope = 0.1;
    law.spring = std::make_shared<MonotoneCubic>(std::move(r), std::nullopt, kLeastSlope);
  }
  if (const Value* table = v.find("damping_table")) {
    if (v.has("damping"))
      refuse_key(*table, v.where, "'damping' and 'damping_table' exclude each other; give only one of them");
    const std::vector<MonotoneCubic::Row> r = table->rows();
    try {
      law.damper = std::make_shared<ResponseCurve>(r, r.front().first >= 0);
    } catch (const std::invalid_argument& e) {
      refuse(*table, std::string(e.what()) +
                         "; rows are a speed and a tension that resists it, both rising, [[m/s, N], ...]");
    }
  }
}

}  // namespace hawser::io
