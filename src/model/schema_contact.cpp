// Keys of contact of lines with volumes and with each other.
#include <algorithm>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

// Keys of contact between lines; `own`: keys that select a pair, whose defaults are the settings for all
// lines.
std::vector<Key> line_pair_keys(std::vector<Key> own, bool of_a_pair = false) {
  const auto fallback = [&](Key k, const char* literal, const char* note) {
    if (of_a_pair) return with(std::move(k), or_else_note("as for all lines"));
    return literal ? with(std::move(k), or_else(literal)) : with(std::move(k), or_else_note(note));
  };
  const auto in = [&](auto LinePairSettings::*field) {
    return of_a_pair ? within(&BetweenLines::Tuned::settings, field) : within(&BetweenLines::general, field);
  };
  const auto basis = [&](StiffnessBasis b) {
    return of_a_pair ? set(&BetweenLines::Tuned::settings, &LinePairSettings::basis, b)
                     : set(&BetweenLines::general, &LinePairSettings::basis, b);
  };
  own.push_back(fallback(
      one_of(
          "normal_stiffness",
          {word({"", in(&LinePairSettings::basis), in(&LinePairSettings::normal_stiffness)},
                {{"auto", StiffnessBasis::automatic}}),
           map("",
               {number({"per_length", in(&LinePairSettings::normal_stiffness),
                        basis(StiffnessBasis::per_length)},
                       line_stiffness, "per length of line in contact", above(0)),
                number({"per_area", in(&LinePairSettings::normal_stiffness), basis(StiffnessBasis::per_area)},
                       area_stiffness, "per projected area (length times mean contact diameter)", above(0))},
               either({"per_length", "per_area"}))},
          "penalty against penetration"),
      "auto", nullptr));
  own.push_back(fallback(
      number({"friction", in(&LinePairSettings::friction)}, none, "Coulomb coefficient", in_range(0, 10)),
      "0", nullptr));
  own.push_back(fallback(number({"mobilisation_length", in(&LinePairSettings::mobilisation_length)}, length,
                                "slip at which friction is fully there", above(0)),
                         nullptr, "1 % of the mean contact diameter"));
  own.push_back(fallback(number({"smoothing", in(&LinePairSettings::smoothing)}, length,
                                "half width of the smooth start of the contact force", above(0)),
                         nullptr, "0.1 % of the mean contact diameter"));
  own.push_back(fallback(number({"relative_damping", in(&LinePairSettings::relative_damping)}, none,
                                "damping of the contact spring over its critical damping", in_range(0, 2)),
                         "0", nullptr));
  return own;
}

Key between_lines() {
  const Key two = list("", reference("", "lines"), "two lines, or one twice for itself", items(2, 2));
  const Key upper = list("", reference("", "lines"), "the upper line and the lower one", items(2, 2));
  Key pair = two;
  pair.name = "lines";
  pair.required = true;
  pair.fields = {by<BetweenLines::Tuned>([](BetweenLines::Tuned& t, const Value& v) {
                   t.first = v.items[0].text;
                   t.second = v.items[1].text;
                 }).put};
  return one_of(
      {"between_lines", &Contact::between_lines},
      {boolean({"", &BetweenLines::enabled}),
       map("",
           line_pair_keys({boolean({"self", &BetweenLines::self}, "a line touches itself", or_else("true")),
                           list({"exclude", &BetweenLines::exclude}, two,
                                "pairs of lines that do not touch each other", or_else("[]")),
                           list({"over", &BetweenLines::over}, upper,
                                "pairs of lines that cross in their start shapes: the first over the second",
                                or_else("[]")),
                           list("pairs",
                                map("", line_pair_keys({std::move(pair)}, true),
                                    "settings of one pair of lines; what is not said is as for all"),
                                "pairs of lines with settings of their own", or_else("[]"))}))},
      "contact of the lines with each other and with themselves; `false`: none", or_else("true"));
}

// A list of names without duplicates.
Field chosen(std::vector<std::string> Contact::*names, bool Contact::*all) {
  return by<Contact>([=](Contact& c, const Value& v) {
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
            "where a line touches: anywhere along its elements (`line`) or at its nodes alone; to compare "
            "with, at the nodes: `gap` has a spring each, in the direction of the surface nearest at the "
            "start",
            or_else("line")),
       boolean({"rolling", &Contact::rolling},
               "friction acts at the lines' surface: it turns them about their axes, and a line that rolls "
               "does not slide (beams, method `line`)",
               or_else("false")),
       number({"penetration_warning", &Contact::warned_penetration}, none,
              "share of a line's radius above which a penetration is warned of", above(0), or_else("0.1")),
       between_lines()},
      "Contact of lines with volumes and with lines.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
