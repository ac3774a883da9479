// Checks of a case beyond the form of single keys.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::model {

// Arc lengths that differ by less than this fraction of the line's length are equal.
inline constexpr double kArcTolerance = 1e-9;

struct Issue {
  std::string key;   // dotted, as in the file: "lines.hose.end_b"
  std::string text;  // "is 90 m long but ..."
};

// Appends issues at or below a key to a list.
class Issues {
 public:
  explicit Issues(std::vector<Issue>& to, std::string under = {}) : to_(to), under_(std::move(under)) {}
  std::size_t count() const { return to_.size(); }
  Issues below(const std::string& key) const { return Issues(to_, at(key)); }
  // Formats the text as fmt::format does; key may be empty.
  template <class... Args>
  void operator()(const std::string& key, fmt::format_string<Args...> text, Args&&... args) const {
    to_.push_back({at(key), fmt::format(text, std::forward<Args>(args)...)});
  }

 private:
  std::string at(const std::string& key) const {
    return under_ + (under_.empty() || key.empty() ? "" : ".") + key;
  }
  std::vector<Issue>& to_;
  std::string under_;
};

// All issues, lines first; empty if the case can be run.
std::vector<Issue> check(const Case& c);
// The parts of check(): single lines, feeders, contact, events.
void check_line(const Case& c, const Line& line, const Issues& issue);
void check_feed(const Case& c, const Line& line, LineEnd line_end, const Issues& issue);
void check_contact(const Case& c, const Issues& issue);
void check_events(const Case& c, const Issues& issue);
// Checks the path and the radii of a volume's tube, and lines that start in it.
void check_tube(const Case& c, const Volume& v, const TubeShape& tube, const Issues& issue);
// Checks the tension and dead band of a feeder, by keys of `feed`.
void check_law(const Feed& feed, const Issues& issue);
// Checks the supports of laid lines.
void check_supports(const Case& c, const Issues& issue);
// Checks the links between points.
void check_links(const Case& c, const Issues& issue);
void check_platforms(const Case& c, const Issues& issue);
// Held end of the line at the tensioner, before the first of its supports: the held end nearer to the first
// box; null: no end is held.
const End* end_before(const Case& c, const Line& line, const SupportBox& first);
// Position in space at t = 0 [m] of a point in a box's frame.
Vec3 support_point(const Case& c, const SupportBox& box, const Vec3& x);

// Unstretched length of a line [m].
double length_of(const Line& line);
// Section at this arc length [m] from end A; at a boundary the one nearer to A, beyond the end the last.
const Section& section_at(const Line& line, double arc);
// Elongation [m] by `temperature_change`.
double expansion_of(const Case& c, const Line& line);
// Largest contact diameter of the line's sections [m].
double contact_diameter_of(const Case& c, const Line& line);

// True if an anchor or a body prescribes the position of the end; a joint does not.
bool is_held(const End& end);

// Line ends held by a body, in the order of the lines.
struct EndAtBody {
  const Line& line;
  const End& end;
};
std::vector<EndAtBody> line_ends_at(const Case& c, const Body& body);
// The same for all bodies, in one pass over the lines.
std::vector<std::vector<EndAtBody>> line_ends_by_body(const Case& c);

// Position of a line's end at t = 0 [m, space], with the body's motion at that time. The end must not be
// free. Throws std::out_of_range for an unknown body.
Vec3 end_position(const Case& c, const End& end);

}  // namespace hawser::model
