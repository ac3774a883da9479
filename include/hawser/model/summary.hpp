// A case in plain words, for `hawser check`.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

struct LineSize {
  double length = 0;  // m, unstretched
  long long elements = 0, nodes = 0;
  long long unknowns = 0;  // 3 a cable node, 6 a beam node; held ends included
  double mass = 0;         // kg, with point masses
};
LineSize size_of(const Case& c, const Line& line);

// What a line is like: size, sections, ends, start and loads, without its name and the places of its ends.
std::string description_of(const Case& c, const Line& line);
// A description of each line, of lines with the same one once, with the ranges of their places.
std::string lines_text(const Case& c);

// Mass, weight in air and submerged weight per length, EA, EI, minimum breaking load and minimum bend radius
// of every line type, a row each under two lines of headings. Contents and marine growth are in the weights.
std::string line_type_table(const Case& c);

// Several lines of text, ending in a newline: lines, bodies, volumes, what is run, notes.
std::string summary(const Case& c);

}  // namespace hawser::model
