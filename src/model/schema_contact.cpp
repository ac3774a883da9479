// Keys of contact of lines with volumes and with each other.
#include <algorithm>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

// Keys of contact between lines; `keys`: keys that select a pair, whose defaults are the settings for all
// lines.
std::vector<Key> line_pair_keys(std::vector<Key> keys, bool of_a_pair = false) {
  const auto fallback = [&](Key k, const char* literal, const char* note) {
    if (of_a_pair) return with(std::move(k), or_else_note("same as for all lines"));
    return literal ? with(std::move(k), or_else(literal)) : with(std::move(k), or_else_note(note));
  };
  const auto setting = [&](auto LinePairSettings::*field) {
    return of_a_pair ? within(&BetweenLines::Tuned::settings, field) : within(&BetweenLines::general, field);
  };
  const auto basis = [&](StiffnessBasis b) {
    return of_a_pair ? set(&BetweenLines::Tuned::settings, &LinePairSettings::basis, b)
                     : set(&BetweenLines::general, &LinePairSettings::basis, b);
  };
  keys.push_back(fallback(
      one_of(
          "normal_stiffness",
          {word({"", setting(&LinePairSettings::basis), setting(&LinePairSettings::normal_stiffness)},
                {{"auto", StiffnessBasis::automatic}}),
           map("",
               {number({"per_length", setting(&LinePairSettings::normal_stiffness),
                        basis(StiffnessBasis::per_length)},
                       line_stiffness, "per length of line in contact", above(0)),
                number({"per_area", setting(&LinePairSettings::normal_stiffness),
                        basis(StiffnessBasis::per_area)},
                       area_stiffness, "per projected area (length times mean contact diameter)", above(0))},
               either({"per_length", "per_area"}))},
          "penalty stiffness"),
      "auto", nullptr));
  keys.push_back(fallback(number({"friction", setting(&LinePairSettings::friction)}, none,
                                 "Coulomb coefficient", in_range(0, 10)),
                          "0", nullptr));
  keys.push_back(fallback(number({"mobilisation_length", setting(&LinePairSettings::mobilisation_length)},
                                 length, "slip at which friction is fully mobilised", above(0)),
                          nullptr, "1 % of the mean contact diameter"));
  keys.push_back(fallback(number({"smoothing", setting(&LinePairSettings::smoothing)}, length,
                                 "half width of the smooth onset of the contact force", above(0)),
                          nullptr, "0.1 % of the mean contact diameter"));
  keys.push_back(
      fallback(number({"relative_damping", setting(&LinePairSettings::relative_damping)}, none,
                      "damping of the contact spring relative to its critical damping", in_range(0, 2)),
               "0", nullptr));
  return keys;
}

Key between_lines() {
  const Key two = list("", reference("", "lines"),
                       "two lines, or the same line twice for contact with itself", items(2, 2));
  const Key upper = list("", reference("", "lines"), "the upper line, then the lower one", items(2, 2));
  Key pair = two;
  pair.name = "lines";
  pair.required = true;
  pair.fields = {set_by<BetweenLines::Tuned>([](BetweenLines::Tuned& t, const Value& v) {
                   t.first = v.items[0].text;
                   t.second = v.items[1].text;
                 }).put};
  return one_of(
      {"between_lines", &Contact::between_lines},
      {boolean({"", &BetweenLines::enabled}),
       map("",
           line_pair_keys(
               {boolean({"self", &BetweenLines::self}, "contact of a line with itself", or_else("true")),
                list({"exclude", &BetweenLines::exclude}, two, "pairs of lines without contact",
                     or_else("[]")),
                list({"over", &BetweenLines::crossings}, upper,
                     "pairs of lines that cross in their start shapes: the first lies over the second",
                     or_else("[]")),
                list("pairs",
                     map("", line_pair_keys({std::move(pair)}, true),
                         "settings of one pair of lines; keys that are not given have their values for all "
                         "lines"),
                     "settings for single pairs of lines", or_else("[]"))}))},
      "contact of lines with each other and with themselves; `false`: none", or_else("true"));
}

// A list of names without duplicates.
Field chosen(std::vector<std::string> Contact::*names, bool Contact::*all) {
  return set_by<Contact>([=](Contact& c, const Value& v) {
    c.*all = false;
    for (const Value& n : v.items)
      if (std::find((c.*names).begin(), (c.*names).end(), n.text) == (c.*names).end())
        (c.*names).push_back(n.text);
  });
}

Key all_or_names(std::string name, const Field& field, std::string to, std::string about) {
  return one_of(std::move(name), {word("", {"all"}), list({"", field}, reference("", std::move(to)))},
                std::move(about), or_else("all"));
}

}  // namespace

Key contact() {
  return map(
      {"contact", &Case::contact},
      {all_or_names("lines", chosen(&Contact::lines, &Contact::all_lines), "lines",
                    "lines that take part in contact"),
       all_or_names("volumes", chosen(&Contact::volumes, &Contact::all_volumes), "volumes",
                    "volumes that take part in contact"),
       word({"method", &Contact::method},
            {{"line", ContactMethod::line}, {"nodes", ContactMethod::nodes}, {"gap", ContactMethod::gap}},
            "where contact acts: `line`, anywhere along the elements; `nodes` and `gap` serve for "
            "comparisons: `nodes`, at nodes only; `gap`, one spring at each node, in the direction of the "
            "nearest surface at the start",
            or_else("line")),
       boolean({"rolling", &Contact::rolling},
               "friction acts at the surface of the lines and exerts torque about their axes, so that a line "
               "can roll without sliding (beams with method `line`)",
               or_else("false")),
       number({"penetration_warning", &Contact::warned_penetration}, none,
              "penetration over the line's radius above which the program warns; in impacts on an automatic "
              "stiffness the limit is at least 0.6",
              above(0), or_else("0.1")),
       between_lines()},
      "Contact of lines with volumes and with other lines.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
