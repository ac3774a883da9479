// The keys of contact between lines, and of what the length of a line has to meet.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

// How lines touch lines; `own`: keys of the pair it is about, which takes what it does not say from the
// settings for all.
std::vector<Key> line_pair_keys(std::vector<Key> own, bool of_a_pair = false) {
  const auto otherwise = [&](Key k, const char* literal, const char* note) {
    if (of_a_pair) return std::move(k).or_else_note("as for all lines");
    return literal ? std::move(k).or_else(literal) : std::move(k).or_else_note(note);
  };
  own.push_back(otherwise(
      one_of(
          "normal_stiffness",
          {word("", {"auto"}),
           map("",
               {number("per_length", line_stiffness, "per length of line in contact").above(0),
                number("per_area", area_stiffness, "per projected area (length times mean contact diameter)")
                    .above(0)},
               "")
               .either({{{"per_length"}, {}}, {{"per_area"}, {}}}, true)},
          "penalty against penetration"),
      "auto", nullptr));
  own.push_back(
      otherwise(number("friction", none, "Coulomb coefficient").at_least(0).at_most(10), "0", nullptr));
  own.push_back(
      otherwise(number("mobilisation_length", length, "slip at which friction is fully there").above(0),
                nullptr, "1 % of the mean contact diameter"));
  own.push_back(
      otherwise(number("smoothing", length, "half width of the smooth start of the contact force").above(0),
                nullptr, "0.1 % of the mean contact diameter"));
  own.push_back(
      otherwise(number("relative_damping", none, "damping of the contact spring over its critical damping")
                    .at_least(0)
                    .at_most(2),
                "0", nullptr));
  return own;
}

}  // namespace

Key between_lines() {
  const Key two = list("", reference("", "lines"), "two lines, or one twice for itself").items(2, 2);
  Key pair = two;
  pair.name = "lines";
  return one_of("between_lines",
                {boolean(""),
                 map("",
                     line_pair_keys(
                         {boolean("self", "a line touches itself").or_else("true"),
                          list("exclude", two, "pairs of lines that do not touch each other").or_else("[]"),
                          list("pairs",
                               map("", line_pair_keys({std::move(pair).is_required()}, true),
                                   "settings of one pair of lines; what is not said is as for all"),
                               "pairs of lines with settings of their own")
                              .or_else("[]")}),
                     "")},
                "contact of the lines with each other and with themselves; `false`: none")
      .or_else("true");
}

Key target() {
  return map("target",
             {number("tension", force, "effective tension at the end").above(0),
              number("declination_deg", angle,
                     "angle at the end between the upward vertical and the line's direction from end A to "
                     "end B, as of `ends/direction` in the results")
                  .at_least(0)
                  .at_most(3.14159265358979323846),
              number("touchdown", length,
                     "arc length from end A of the touchdown point that is the first one from `at`")
                  .at_least(0),
              number("laid_length", length, "that lies on the seabed").above(0),
              word("at", {"end_a", "end_b"}, "the end").or_else("end_b"),
              integer("section", "whose `length` is sought: number from end A on, the first is 1")
                  .at_least(1)
                  .or_else_note("the longest"),
              list("between", number("", length).above(0), "lengths of that section that are tried")
                  .items(2, 2)
                  .or_else_note("half its `length` and one and a half times it")},
             "what statics is to meet at t = 0 by the length of one section: its `length` is then only where "
             "the search begins")
      .either({{{"tension"}, {"tension"}},
               {{"declination_deg"}, {"declination_deg"}},
               {{"touchdown"}, {"touchdown"}},
               {{"laid_length"}, {"laid_length"}}},
              true);
}

}  // namespace hawser::model::schema_build
