// Summary of a case for `hawser check`.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

struct LineSize {
  double length = 0;  // m, unstretched
  long long elements = 0, nodes = 0;
  long long unknowns = 0;  // 3 per cable node, 6 per beam node; held ends included
  double mass = 0;         // kg, with point masses
};
LineSize size_of(const Case& c, const Line& line);

// Description of a line: size, sections, ends, start and loads, without its name and the positions of its
// ends.
std::string description_of(const Case& c, const Line& line);
// Descriptions of all lines; lines with equal descriptions are grouped, with the ranges of their end
// positions.
std::string lines_text(const Case& c);

// Mass, weight in air and submerged weight per length, EA, EI, minimum breaking load and minimum bend radius
// of every line type, one row each below two heading lines. Weights include contents and marine growth.
std::string line_type_table(const Case& c);

// Several lines, ending in a newline: lines, bodies, volumes, analyses, notes.
std::string summary(const Case& c);

}  // namespace hawser::model
