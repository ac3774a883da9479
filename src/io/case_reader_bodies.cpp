// What is more than copying in an entry of `bodies`: motion from files and rows, and what goes by the sea.
#include <filesystem>

#include "hawser/io/case_values.hpp"
#include "hawser/io/wamit_reader.hpp"

namespace hawser::io {

using model::Value;

namespace {

// The files of a body's coefficients; those of a body before are not read again.
void read_hydrodynamics(const Value& v, const CaseSource& source, model::Body& b, model::Case& c) {
  model::BodyHydrodynamics& h = *b.mass->hydrodynamics;
  h.wamit = source.absolute(h.wamit);
  for (const model::Body& other : c.bodies) {
    if (&other == &b) break;
    if (!other.mass || !other.mass->hydrodynamics) continue;
    const model::BodyHydrodynamics& before = *other.mass->hydrodynamics;
    if (before.wamit == h.wamit && before.length == h.length && before.second_order == h.second_order)
      h.data = before.data;
  }
  if (!h.data) {
    WamitUnits units;
    units.length = h.length;
    units.density = c.environment.water.density;
    units.gravity = c.environment.gravity;
    std::vector<std::string> notes, read;
    try {
      h.data = std::make_shared<const model::HydrodynamicData>(
          read_wamit(h.wamit, units, h.second_order, read, notes));
    } catch (const std::runtime_error& e) {
      model::refuse(v["wamit"], e.what());
    }
    for (const std::string& path : read) source.input(path);
    for (const std::string& n : notes)
      c.notes.push_back("bodies." + b.name + ".floating.hydrodynamics: " + n);
  }
  if (h.body > h.data->bodies)
    model::refuse(v["body"], "the files have {} bod{}", h.data->bodies, h.data->bodies == 1 ? "y" : "ies");
}

}  // namespace

void finish_body(const Value& v, const CaseSource& source, model::Body& b, model::Case& c) {
  if (const Value* f = v.find("floating")) {
    if (const Value* w = f->find("in_water"))
      b.mass->in_water->added_mass += c.environment.water.density * b.mass->in_water->volume * vec(*w, "Ca");
    if (const Value* h = f->find("hydrodynamics")) {
      if (!(*f)["weight"].given) b.mass->weight = true;
      read_hydrodynamics(*h, source, b, c);
    }
  }
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
