// What makes a case senseless although every key is well formed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::model {

// Of a line's length: arc lengths no further apart are the same.
inline constexpr double kArcTolerance = 1e-9;

struct Issue {
  std::string key;   // dotted, as in the file: "lines.hose.end_b"
  std::string text;  // "is 90 m long but ..."
};

// Adds to a list what is found at or below a key.
class Issues {
 public:
  explicit Issues(std::vector<Issue>& to, std::string under = {}) : to_(to), under_(std::move(under)) {}
  std::size_t count() const { return to_.size(); }
  Issues below(const std::string& key) const { return Issues(to_, at(key)); }
  // With what fmt::format makes of the rest; key may be empty.
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

// Everything found, lines first. An empty list: the case can be run.
std::vector<Issue> check(const Case& c);
// Its parts that are about one line by itself, about what feeds it at an end, and about contact.
void check_line(const Case& c, const Line& line, const Issues& issue);
void check_feed(const Case& c, const Line& line, bool at_b, const Issues& issue);
void check_contact(const Case& c, const Issues& issue);
void check_events(const Case& c, const Issues& issue);
// A tension that a feeder keeps to and its dead band, by keys of `feed`.
void check_law(const Feed& feed, const Issues& issue);
// Its part that is about supports of laid lines.
void check_supports(const Case& c, const Issues& issue);
// Its part that is about springs and dampers between two points.
void check_links(const Case& c, const Issues& issue);
void check_platforms(const Case& c, const Issues& issue);
// Of a body with hydrodynamics: its coefficients against long waves.
void check_hydrodynamic_data(const Case& c, const Body& b, const Issues& issue);
// What is unlikely in its coefficients by each other and by its size, and no error for certain.
void note_hydrodynamic_data(const Case& c, const Body& b, const Issues& note);
// The end of the line that comes first on its way over these supports, its tensioner's: the held end that is
// nearer to the first box; null: no end is held.
const End* end_before(const Case& c, const Line& line, const SupportBox& first);
// A point of a box's frame at t = 0 [m, space].
Vec3 support_point(const Case& c, const SupportBox& box, const Vec3& x);

// Unstretched length of a line [m].
double length_of(const Line& line);
// What its `temperature_change` adds to it [m].
double expansion_of(const Case& c, const Line& line);
// The largest of its sections [m].
double contact_diameter_of(const Case& c, const Line& line);

// Whether a line's end is held by an anchor or a body: its place is prescribed, which that of a joint is not.
bool is_held(const End& end);

// The ends of lines that are held by this body, lines in their order.
struct EndAtBody {
  const Line& line;
  const End& end;
};
std::vector<EndAtBody> line_ends_at(const Case& c, const Body& body);
// The same of every body, in one pass over the lines.
std::vector<std::vector<EndAtBody>> line_ends_by_body(const Case& c);

// Where a line's end is at t = 0 [m, space]: the body's position and rotation with its motion then.
// Not for free ends. Throws std::out_of_range for an unknown body.
Vec3 end_position(const Case& c, const End& end);

}  // namespace hawser::model
