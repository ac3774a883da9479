// Positions of nodes along lines: the ends of elements, with the nearest node moved to each point mass, point
// load, link and body on the line.
#pragma once

#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/model/progression.hpp"

namespace hawser::model {

// For each line, the arc lengths [m, ascending] of its masses, point loads, links and bodies.
std::vector<std::vector<double>> fixed_places(const Case& c);

// The elements of each section of a line, from end A on. Their lengths follow the section's geometric
// progression, except that the node nearest to each fixed place moves there and the elements between moved
// nodes are scaled uniformly. A place has no separate node if its node is used already, or if another moved
// node or an end of the section is within a tenth of an element.
std::vector<std::vector<Progression>> progressions(const Line& line, const std::vector<double>& places);

// Their lengths one by one.
std::vector<std::vector<double>> element_lengths(const Line& line, const std::vector<double>& places);

}  // namespace hawser::model
