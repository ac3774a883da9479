// Stretches of lines inside a volume at the start, and their exclusion from contact near held ends.
#include "hawser/run/start_contact.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "hawser/advice/start_contact.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/broken_line.hpp"
#include "hawser/model/check.hpp"

namespace hawser::run {
namespace {

constexpr size_t kMostReported = 5;  // sentences of one kind
// Fraction of the initial depth; less deep stretches are on the surface, pressed in by their own contact.
constexpr double kOnSurface = 0.1;

// Contact radius of the elements of this rank; 0: no contact.
std::vector<double> radii(const model::Case& c, const LocalMesh& mesh) {
  std::vector<double> out;
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    const bool part = c.contact.takes_part(c.lines[g.line]);
    out.push_back(part ? 0.5 * c.line_types[g.type].contact_diameter : 0);
  }
  return out;
}

// Length from the exit of the axis to a distance of one contact diameter, so that the line is clear by half
// of it; limited if the line runs along the surface.
double clearance(const model::Case& c, const model::Line& line, LineEnd end, double rise) {
  constexpr double kAlong = 0.1;
  const model::Section& s = line.end_section(end);
  return c.line_type(s.type).contact_diameter / std::max(rise, kAlong);
}

std::vector<Inside> all_inside(const PlacedLines& lines, const std::vector<ContactVolume>& volumes) {
  std::vector<Inside> out =
      gather_all(lines.comm, inside_volumes(lines.mesh, lines.state, lines.bodies, volumes,
                                            radii(lines.c, lines.mesh), lines.feeders));
  join(out, *lines.mesh.mesh);
  return out;
}

advice::InsideVolume inside_volume(const Inside& s, const Mesh& mesh, double outside_with) {
  return {s.from, s.to, s.at, s.depth, s.place, mesh.lines[s.line].length, outside_with};
}

// Points of the polyline along which a line is laid at equal fractions of both lengths, each with its arc
// length of the line, m.
using LaidPoints = std::vector<std::pair<double, Vec3>>;
LaidPoints laid_points(const std::vector<Vec3>& points, double line_length) {
  LaidPoints laid{{0, points.front()}};
  for (size_t i = 1; i < points.size(); ++i)
    laid.emplace_back(laid.back().first + (points[i] - points[i - 1]).norm(), points[i]);
  const double stretch = line_length / laid.back().first;
  for (auto& [arc, point] : laid) arc *= stretch;
  return laid;
}

// Longest of the elements that are partly in the interval, m of arc length.
double longest_element(const Mesh& mesh, const Inside& s) {
  const LineSpan& span = mesh.lines[s.line];
  double longest = 0;
  for (int n = span.first_node; n + 1 < span.first_node + span.nodes; ++n) {
    const double from = mesh.node(n).arc;
    const double to = mesh.node(n + 1).arc;
    if (to > s.from && from < s.to) longest = std::max(longest, to - from);
  }
  return longest;
}

// True if straight elements of this length [m] between points of the polyline, wherever they begin near the
// interval, are outside the volume.
bool is_outside_with(const LaidPoints& laid, double length, const Inside& s, double margin,
                     const Surface& surface, const RigidPose& pose) {
  constexpr int kBegins = 8, kSamples = 16;  // in an element
  const double last = s.to + margin;
  for (double begin = s.from - margin - length; begin < last; begin += length / kBegins) {
    const Vec3 a = on_broken_line(laid, begin);
    const Vec3 b = on_broken_line(laid, begin + length);
    for (int k = 0; k <= kSamples; ++k) {
      const double fraction = static_cast<double>(k) / kSamples;
      const Vec3 x = a + fraction * (b - a);
      const auto p = surface.query(pose.to_body(x), length);
      if (p && p->distance < 0) return false;
    }
  }
  return true;
}

// InsideVolume::outside_with.
double elements_outside(const PlacedLines& lines, const std::vector<ContactVolume>& volumes,
                        const Inside& s) {
  constexpr double kMargin = 0.95;
  const model::Line& line = lines.c.lines[s.line];
  if (line.start != model::Start::points || line.points.size() < 2) return 0;
  const Mesh& mesh = *lines.mesh.mesh;
  const LaidPoints laid = laid_points(line.points, mesh.lines[s.line].length);
  const RigidPose pose = lines.bodies.pose(volumes[s.volume].body, lines.state);
  const double longest = longest_element(mesh, s);
  for (const int parts : {2, 3, 4, 6, 8, 12, 16, 24, 32})
    if (is_outside_with(laid, longest / parts, s, longest, *volumes[s.volume].surface, pose))
      return kMargin * longest / parts;
  return 0;
}

// Shortens a list of sentences; more: function for the sentence about the rest, from their number.
void shorten(std::vector<std::string>& sentences, std::string (*more)(size_t)) {
  if (sentences.size() <= kMostReported) return;
  const size_t others = sentences.size() - kMostReported;
  sentences.resize(kMostReported);
  sentences.push_back(more(others));
}

// Removes the excluded parts of stretches inside.
void remove_excluded(std::vector<Inside>& inside, const std::vector<ExcludedEnds>& excluded_ends,
                     const Mesh& mesh) {
  std::vector<Inside> out;
  for (Inside s : inside) {
    const double length = mesh.lines[s.line].length;
    const auto excluded = std::find_if(
        excluded_ends.begin(), excluded_ends.end(),
        [&](const ExcludedEnds& ends) { return ends.line == s.line && ends.volume == s.volume; });
    if (excluded != excluded_ends.end()) {
      if (s.to <= excluded->end_a || s.from >= length - excluded->end_b) continue;
      s.from = std::max(s.from, excluded->end_a);
      s.to = std::min(s.to, length - excluded->end_b);
    }
    if (s.depth > 0 && s.from < s.to) out.push_back(s);
  }
  inside = std::move(out);
}

// Stretches excluded by the case, and by default those inside next to a held end.
void find_excluded_ends(const model::Case& c, const Mesh& mesh, const std::vector<ContactVolume>& volumes,
                        StartContact& start) {
  std::map<std::pair<int, int>, ExcludedEnds> ends_of;
  const auto entry = [&ends_of](int line, int volume) -> ExcludedEnds& {
    ExcludedEnds& ends = ends_of[{line, volume}];
    ends.line = line;
    ends.volume = volume;
    return ends;
  };
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const LineEnd end : kLineEnds) {
      const model::End& e = c.lines[l].end(end);
      if (e.no_contact_within.value_or(0) > 0)
        for (size_t v = 0; v < volumes.size(); ++v) {
          ExcludedEnds& out = entry(static_cast<int>(l), static_cast<int>(v));
          (end == LineEnd::B ? out.end_b : out.end_a) = *e.no_contact_within;
        }
    }
  for (size_t v = 0; v < volumes.size(); ++v)  // a body on a line does not touch it
    if (c.rides(volumes[v].body)) {
      const int line = c.line_index(c.bodies[volumes[v].body].ride->line);
      entry(line, static_cast<int>(v)).end_a = mesh.lines[line].length;
    }
  for (const Inside& s : start.inside) {
    if (const auto known = ends_of.find({s.line, s.volume});
        known != ends_of.end() && c.rides(volumes[s.volume].body))
      continue;
    const model::Line& line = c.lines[s.line];
    const double length = mesh.lines[s.line].length;
    const double near = 1e-9 * length;
    if (s.from <= near && s.to >= length - near) continue;  // stays inside completely
    for (const LineEnd end : kLineEnds) {
      const model::End& e = line.end(end);
      const bool b = end == LineEnd::B;
      if (!model::is_held(e) || e.no_contact_within || (b ? s.to < length - near : s.from > near)) continue;
      ExcludedEnds& out = entry(s.line, s.volume);
      const double reach =
          (b ? length - s.from : s.to) + clearance(c, line, end, b ? s.rise_from : s.rise_to);
      (b ? out.end_b : out.end_a) = reach;
      start.notes.push_back(
          advice::excluded_at_end(line, end, volumes[s.volume].settings.name, s.depth, reach));
    }
  }
  for (const auto& [key, ends] : ends_of) start.excluded_ends.push_back(ends);
}

// Ends of a line with automatic start shape, m in space.
struct Chord {
  bool known = false;
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  Vec3 at(double fraction) const { return a + fraction * (b - a); }
};

// By line; not known if the line does not start by itself between held ends, or has no contact.
std::vector<Chord> chords_of(const model::Case& c) {
  std::vector<Chord> chords(c.lines.size());
  for (size_t l = 0; l < c.lines.size(); ++l) {
    const model::Line& line = c.lines[l];
    if (!line.starts_by_itself()) continue;
    if (line.given || !c.contact.takes_part(line) || line.end_a.kind == model::EndKind::free ||
        line.end_b.kind == model::EndKind::free)
      continue;
    chords[l] = {true, model::end_position(c, line.end_a), model::end_position(c, line.end_b)};
  }
  return chords;
}

// For each line and volume, the node nearest to the volume; at equal distance the first from end A. Sorted by
// line and volume.
std::vector<OnWrongSide> nearest_nodes(const std::vector<OnWrongSide>& nodes) {
  std::map<std::pair<int, int>, OnWrongSide> nearest;
  for (const OnWrongSide& p : nodes) {
    const auto [best, fresh] = nearest.try_emplace({p.line, p.volume}, p);
    if (!fresh && std::pair(p.distance, p.at) < std::pair(best->second.distance, best->second.at))
      best->second = p;
  }
  std::vector<OnWrongSide> out;
  for (const auto& [key, p] : nearest) out.push_back(p);
  return out;
}

// Warnings of lines on the wrong side of a volume: the straight line between their ends passes it on the
// other side; or below a volume of the body to which an upper end is attached. A line may leave the hull of
// its body on any side.
std::vector<std::string> lines_on_wrong_side(const PlacedLines& lines,
                                             const std::vector<ContactVolume>& volumes,
                                             const std::vector<Inside>& inside) {
  const model::Case& c = lines.c;
  const std::vector<Chord> chords = chords_of(c);
  const auto fraction_of = [&](size_t line, double arc) { return arc / lines.mesh.mesh->lines[line].length; };
  const auto carries_end = [&](const model::End& e, size_t v) {
    return e.kind == model::EndKind::body && e.carrier == volumes[v].settings.body;
  };
  const ExpectedPlace expected_place = [&](const Node& node, size_t v, const Vec3& x) -> std::optional<Vec3> {
    const size_t l = node.line;
    const model::Line& line = c.lines[l];
    if (!chords[l].known || volumes[v].settings.roller) return {};  // supports have separate messages
    double top = -HUGE_VAL;
    if (carries_end(line.end_a, v)) top = chords[l].a.z();
    if (carries_end(line.end_b, v)) top = std::max(top, chords[l].b.z());
    if (top == -HUGE_VAL) return chords[l].at(fraction_of(l, node.arc));
    if (!(top > x.z())) return {};
    return Vec3(x.x(), x.y(), top);
  };
  std::vector<std::string> warnings;
  const std::vector<OnWrongSide> local =
      nodes_on_wrong_side(lines.mesh, lines.state, lines.bodies, volumes, expected_place);
  for (const OnWrongSide& p : nearest_nodes(gather_all(lines.comm, nearest_nodes(local)))) {
    const int l = p.line;
    const int v = p.volume;
    const model::Line& line = c.lines[l];
    const model::Volume& volume = volumes[v].settings;
    // Other messages report stretches inside.
    const auto is_same = [&](const Inside& s) { return s.line == l && s.volume == v; };
    if (std::any_of(inside.begin(), inside.end(), is_same)) continue;
    const size_t n = l;
    const bool carries_a = carries_end(line.end_a, static_cast<size_t>(v));
    const bool carries_b = carries_end(line.end_b, static_cast<size_t>(v));
    const bool under = carries_a || carries_b || chords[n].at(fraction_of(n, p.at)).z() >= p.place.z();
    warnings.push_back(
        advice::passes_volume(line, volume.name, {under, p.distance, p.at, p.place, carries_a, carries_b}));
  }
  shorten(warnings, advice::more_lines_on_wrong_side);
  return warnings;
}

}  // namespace

std::vector<ContactVolume> volumes_of_lines(const model::Case& c,
                                            const std::vector<std::shared_ptr<const Surface>>& surfaces) {
  std::vector<ContactVolume> out;
  for (size_t v = 0; v < c.volumes.size() && v < surfaces.size(); ++v) {
    const int body = c.body_index(c.volumes[v].body);
    if (!c.contact.takes_part(c.volumes[v]) || c.lines.empty()) continue;
    out.push_back({surfaces[v], body, c.volumes[v]});
    out.back().off = c.off_at_start(c.volumes[v]);
  }
  return out;
}

std::string inside_text(const PlacedLines& lines, const ContactVolume& volume,
                        const std::vector<ExcludedEnds>& excluded_ends) {
  const Mesh& mesh = *lines.mesh.mesh;
  std::vector<Inside> inside = all_inside(lines, {volume});
  remove_excluded(inside, excluded_ends, mesh);
  if (inside.empty()) return "";
  return advice::line_inside(mesh.line_names[inside.front().line], inside_volume(inside.front(), mesh, 0));
}

StartContact start_contact(const PlacedLines& start, const std::vector<ContactVolume>& volumes) {
  const model::Case& c = start.c;
  const Mesh& mesh = *start.mesh.mesh;
  StartContact out;
  if (volumes.empty()) return out;
  std::vector<ContactVolume> switched_on = volumes;
  for (ContactVolume& v : switched_on) v.off = false;
  out.inside = all_inside(start, switched_on);
  // Ends are excluded from contact with inactive volumes as well; other stretches inside are checked again
  // when the volume is switched on.
  find_excluded_ends(c, mesh, volumes, out);
  std::erase_if(out.inside, [&](const Inside& s) { return volumes[s.volume].off; });
  const std::vector<Inside> all = out.inside;
  remove_excluded(out.inside, out.excluded_ends, mesh);
  for (const Inside& s : out.inside) {
    out.outside_with.push_back(elements_outside(start, volumes, s));
    out.warnings.push_back(advice::starts_inside(c.lines[s.line], volumes[s.volume].settings.name,
                                                 inside_volume(s, mesh, out.outside_with.back())));
  }
  shorten(out.notes, advice::more_ends_excluded);
  shorten(out.warnings, advice::more_stretches_inside);
  for (std::string& warning : lines_on_wrong_side(start, volumes, all))
    out.warnings.push_back(std::move(warning));
  return out;
}

std::string still_inside(const PlacedLines& lines, const std::vector<ContactVolume>& volumes,
                         const StartContact& start) {
  if (start.inside.empty()) return "";
  const model::Case& c = lines.c;
  const Mesh& mesh = *lines.mesh.mesh;
  std::vector<Inside> inside = all_inside(lines, volumes);
  remove_excluded(inside, start.excluded_ends, mesh);
  for (const Inside& s : inside) {
    const auto was_inside = [&](const Inside& before) {
      return before.line == s.line && before.volume == s.volume && before.from <= s.to &&
             s.from <= before.to && s.depth > kOnSurface * before.depth;
    };
    const auto before = std::find_if(start.inside.begin(), start.inside.end(), was_inside);
    if (before == start.inside.end()) continue;
    const double outside_with = start.outside_with[before - start.inside.begin()];
    return advice::stays_inside(c.lines[s.line], volumes[s.volume].settings.name,
                                inside_volume(s, mesh, outside_with), c.statics.enabled);
  }
  return "";
}

}  // namespace hawser::run
