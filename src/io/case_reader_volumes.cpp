// Entries of `volumes`, and the settings of contact.
#include <fmt/format.h>

#include <set>

#include "hawser/math/ordered.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::io {

using model::refuse;
using model::refuse_key;
using model::Value;

void finish_volume(const Value& v, const CaseSource& source, model::Volume& o) {
  if (!o.shape) {
    o.mesh = source.input(o.mesh);
    const bool curved = o.sign == model::SignTest::automatic || o.sign == model::SignTest::pseudonormal;
    if (!curved && o.smooth && v["smooth"].given)
      refuse(v["smooth"],
             "with 'sign: " + v["sign"].text + "' facets are flat; set 'smooth: false' or remove 'smooth'");
    o.smooth = o.smooth && curved;
  }
  if (o.force_table && v.has("smoothing"))
    refuse(v["smoothing"], "a force table defines the whole law, so there is nothing to smooth");
}

void finish_contact(const Value& v, model::Contact& to) {
  if (to.rolling && to.method != model::ContactMethod::line)
    refuse(v["rolling"], "needs 'method: line'; nodes touch without turning");
  const Value* pairs = v["between_lines"].find("pairs");
  if (!pairs) return;
  std::set<std::pair<std::string, std::string>> listed;
  for (const Value& p : pairs->items) {
    model::BetweenLines::Tuned& t = to.between_lines.pairs.emplace_back();
    t.settings = to.between_lines.general;  // defaults of a pair are the settings for all
    model::take(p, t, true);
    if (!listed.insert(ordered(t.first, t.second)).second)
      refuse_key(p, p["lines"].where, "lines {} and {} have settings already", model::quote(t.first),
                 model::quote(t.second));
  }
}

}  // namespace hawser::io
