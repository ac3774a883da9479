// What is more than copying in an entry of `bodies`: motion from files and rows, and what goes by the sea.
#include "hawser/io/case_values.hpp"

namespace hawser::io {

using model::Value;

void finish_body(const Value& v, const CaseSource& source, model::Body& b, model::Case& c) {
  if (const Value* f = v.find("floating"))
    if (const Value* w = f->find("in_water"))
      b.mass->in_water->added_mass += c.environment.water.density * b.mass->in_water->volume * vec(*w, "Ca");
  const Value* m = v.find("motion");
  if (!m) return;
  if (const Value* d = m->find("drift"))
    if (const Value* t = d->find("table")) read_motion_table(*t, source, b.drift->table, c.notes);
  if (const Value* t = m->find("table"))
    read_motion_table(*t, source, std::get<model::TableMotion>(b.motion), c.notes);
  if (const Value* rao = m->find("rao")) {
    b.motion = read_rao(*rao, c.environment, b, c.dynamics.duration, source, c.notes);
    if (!(*m)["ramp"].given) b.ramp = c.environment.water.waves.ramp;
  }
}

}  // namespace hawser::io
