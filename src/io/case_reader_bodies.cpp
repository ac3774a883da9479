// An entry of `bodies`: where it is, its mass, and its motion.
#include "hawser/io/case_values.hpp"

namespace hawser::io {

using model::Value;

namespace {

model::HarmonicMotion harmonic(const Value& h) {
  return {vec(h, "amplitude"), vec(h, "rotation_amplitude_deg"), h["period"].number, vec(h, "phase_deg"),
          vec(h, "rotation_phase_deg")};
}

model::Drift drift(const Value& v, const std::string& path, const CaseSource& source,
                   std::vector<std::string>& notes) {
  model::Drift d;
  d.offset = vec(v, "offset"), d.rotation = vec(v, "rotation_deg");
  if (const Value* h = v.find("harmonic")) d.harmonic = harmonic(*h);
  if (const Value* t = v.find("table")) d.table = read_motion_table(*t, path + ".table", source, notes);
  d.ramp = v["ramp"].number;
  return d;
}

model::BodyInWater in_water(const Value& v, double density) {
  model::BodyInWater w;
  w.volume = v["volume"].number, w.height = v["height"].number;
  w.centre = vec(v, "centre_of_buoyancy");
  w.drag_centre = v.has("centre_of_drag") ? vec(v, "centre_of_drag") : w.centre;
  w.drag_area = vec(v, "drag_area").cwiseProduct(vec(v, "Cd"));
  w.added_mass = vec(v, "added_mass") + density * w.volume * vec(v, "Ca");
  return w;
}

}  // namespace

model::Body read_body(const std::string& name, const Value& v, const CaseSource& source, double duration,
                      model::Case& c) {
  model::Body b;
  b.name = name;
  b.position = vec(v, "position");
  b.rotation = vec(v, "rotation_deg");
  if (const Value* f = v.find("floating")) {
    model::BodyMass& o = b.mass.emplace();
    o.mass = (*f)["mass"].number, o.weight = (*f)["weight"].number != 0;
    o.inertia = vec(*f, "inertia"), o.products = vec(*f, "products_of_inertia");
    o.centre = vec(*f, "centre_of_mass");
    o.velocity = vec(*f, "velocity"), o.angular_velocity = vec(*f, "angular_velocity");
    o.stiffness = vec(*f, "stiffness"), o.damping = vec(*f, "damping");
    o.turning_stiffness = vec(*f, "turning_stiffness"), o.turning_damping = vec(*f, "turning_damping");
    if (const Value* w = f->find("in_water")) o.in_water = in_water(*w, c.environment.water.density);
  }
  if (const Value* on = v.find("on")) b.on = model::Ride{(*on)["line"].text, 0};
  const Value* m = v.find("motion");
  if (!m) return b;
  const std::string path = "bodies." + name + ".motion";
  b.ramp = number(*m, "ramp");
  if (const Value* d = m->find("drift")) b.drift = drift(*d, path + ".drift", source, c.notes);
  if (const Value* h = m->find("harmonic")) {
    b.motion = harmonic(*h);
  } else if (const Value* t = m->find("table")) {
    b.motion = read_motion_table(*t, path + ".table", source, c.notes);
  } else if (const Value* rao = m->find("rao")) {
    b.motion = read_rao(*rao, path + ".rao", c.environment, b, duration, source, c.notes);
    if (!(*m)["ramp"].given) b.ramp = c.environment.water.waves.ramp;
  } else if (m->has("velocity") || m->has("rotation")) {
    model::ConstantMotion steady;
    steady.velocity = vec(*m, "velocity");
    if (const Value* r = m->find("rotation")) {
      steady.axis = read_direction(*r, "axis", path + ".rotation", source);
      steady.rate = (*r)["rate"].number;
    }
    b.motion = steady;
  }
  return b;
}

}  // namespace hawser::io
