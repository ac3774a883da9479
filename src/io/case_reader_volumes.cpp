// An entry of `volumes`, and the settings of contact for all of them.
#include <algorithm>

#include "hawser/io/case_values.hpp"

namespace hawser::io {

using model::Value;

model::Volume read_volume(const std::string& name, const Value& v, const CaseSource& source) {
  model::Volume o;
  o.name = name;
  if (const Value* shape = v.find("shape")) {
    o.shape = read_shape(*shape, "volumes." + name + ".shape", source);
  } else {
    o.mesh = source.absolute(v["mesh"].text);
    o.scale = v["scale"].number;
    o.closed = v["closed"].text == "required";
    o.sign = read_sign(v["sign"].text);
    o.smooth = v["smooth"].number != 0 &&
               (o.sign == model::SignTest::automatic || o.sign == model::SignTest::pseudonormal);
    if (!o.smooth && v["smooth"].number != 0 && v["smooth"].given)
      source.bad(v["smooth"], "volumes." + name + ".smooth",
                 "with 'sign: " + v["sign"].text + "' facets are flat; say 'smooth: false' or nothing");
    o.crease_angle = v["crease_angle_deg"].number;
  }
  if (v.has("body")) o.body = v["body"].text;
  if (const Value* a = v.find("active")) {
    if (a->kind == Value::Kind::map) {
      const Value& box = (*a)["box"];
      o.active_box = model::Box{as_vec3(box.items[0]), as_vec3(box.items[1])};
    } else {
      o.active_part = a->text;
    }
  }
  const Value& k = v["normal_stiffness"];
  const auto basis = [&](const char* key, model::StiffnessBasis b) {
    if (const Value* x = k.find(key)) o.basis = b, o.normal_stiffness = x->number;
  };
  basis("per_point", model::StiffnessBasis::per_point);
  basis("per_length", model::StiffnessBasis::per_length);
  basis("per_area", model::StiffnessBasis::per_area);
  const std::string key = "volumes." + name;
  o.allowed_penetration = number(k, "allowed_penetration");
  if (k.has("table")) {
    o.force_table = read_force_table(k["table"], key + ".normal_stiffness.table", source);
    o.normal_stiffness = o.force_table->largest_slope();
    o.basis = k["per"].is("point")    ? model::StiffnessBasis::per_point
              : k["per"].is("length") ? model::StiffnessBasis::per_length
                                      : model::StiffnessBasis::per_area;
    if (v.has("smoothing"))
      source.bad(v["smoothing"], key + ".smoothing",
                 "a force table defines the whole law, so there is nothing to smooth");
  }
  o.smoothing = number(v, "smoothing", -1);
  o.relative_damping = v["relative_damping"].number;
  const Value& f = v["friction"];
  if (f.kind == Value::Kind::map) {
    o.friction = read_friction(f, key + ".friction", source);
  } else {
    o.friction.axial = o.friction.lateral = f.number;
  }
  return o;
}

void read_contact(const Value& v, const CaseSource& source, model::Contact& to) {
  to.method = v["method"].is("line")  ? model::ContactMethod::line
              : v["method"].is("gap") ? model::ContactMethod::gap
                                      : model::ContactMethod::nodes;
  to.warned_penetration = v["penetration_warning"].number;
  to.rolling = v["rolling"].number != 0;
  if (to.rolling && to.method != model::ContactMethod::line)
    source.bad(v["rolling"], "contact.rolling", "needs 'method: line'; nodes touch without turning");
  const auto chosen = [&](const char* key, bool& all, std::vector<std::string>& names) {
    all = v[key].kind != Value::Kind::list;
    for (const Value& n : v[key].items)
      if (std::find(names.begin(), names.end(), n.text) == names.end()) names.push_back(n.text);
  };
  chosen("lines", to.all_lines, to.lines);
  chosen("volumes", to.all_volumes, to.volumes);
  to.between_lines = read_between_lines(v["between_lines"], source);
}

}  // namespace hawser::io
