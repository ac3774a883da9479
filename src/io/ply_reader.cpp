// Parser of PLY files: header with elements and properties, then vertices and faces in text or binary form of
// either byte order, with range checks.
#include "ply_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "hawser/io/input_file.hpp"

namespace hawser::io {
namespace {

struct Number {
  int bytes = 0;  // 0: unknown type
  char kind = 'f';
};
Number number_type(const std::string& name) {
  static constexpr std::pair<const char*, Number> kTypes[] = {
      {"char", {1, 'i'}},  {"int8", {1, 'i'}},    {"uchar", {1, 'u'}},  {"uint8", {1, 'u'}},
      {"short", {2, 'i'}}, {"int16", {2, 'i'}},   {"ushort", {2, 'u'}}, {"uint16", {2, 'u'}},
      {"int", {4, 'i'}},   {"int32", {4, 'i'}},   {"uint", {4, 'u'}},   {"uint32", {4, 'u'}},
      {"float", {4, 'f'}}, {"float32", {4, 'f'}}, {"double", {8, 'f'}}, {"float64", {8, 'f'}}};
  for (const auto& [word, type] : kTypes)
    if (name == word) return type;
  return {};
}

struct Property {
  Number length;  // length type of a list; bytes 0: a scalar
  Number item;
  bool vertices = false;  // the list of a face's vertices
  int axis = -1;          // x, y, z of a vertex
};
struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

enum class Format { ascii, little, big };

// Sequential numbers of the body.
class Body {
 public:
  Body(std::istream& in, Format format) : in_(in), format_(format) {}
  bool next(const Number& type, double& value) {
    if (format_ == Format::ascii) return static_cast<bool>(in_ >> value);
    std::array<char, 8> raw{};
    if (!in_.read(raw.data(), type.bytes)) return false;
    if ((format_ == Format::big) != (std::endian::native == std::endian::big))
      std::reverse(raw.begin(), raw.begin() + type.bytes);
    value = decode(type, raw.data());
    return true;
  }

 private:
  template <class T>
  static double as(const char* raw) {
    T x;
    std::memcpy(&x, raw, sizeof x);
    return static_cast<double>(x);
  }
  static double decode(const Number& t, const char* raw) {
    if (t.kind == 'f') return t.bytes == 4 ? as<float>(raw) : as<double>(raw);
    const bool sign = t.kind == 'i';
    if (t.bytes == 1) return sign ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
    if (t.bytes == 2) return sign ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
    return sign ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
  }
  std::istream& in_;
  Format format_;
};

std::string read_header(std::istream& in, std::uintmax_t bytes, Format& format,
                        std::vector<Element>& elements) {
  std::string line;
  for (int i = 0; i < 1000 && std::getline(in, line); ++i) {
    if (i == 0) line.erase(0, mark_length(line));
    std::istringstream words(line);
    std::string word, name, number;
    if (!(words >> word)) continue;
    if (i == 0 && word != "ply") return "does not begin with 'ply'";
    if (word == "end_header") return "";
    if (word == "format") {
      words >> name;
      if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
        return fmt::format("the PLY format '{}' is none of ascii, binary_little_endian and binary_big_endian",
                           name);
      format = name == "ascii" ? Format::ascii : name == "binary_big_endian" ? Format::big : Format::little;
    } else if (word == "element") {
      words >> name >> number;
      const bool digits =
          !number.empty() && number.size() < 12 &&
          std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
      if (!digits || std::stoull(number) > bytes)
        return fmt::format("the PLY header announces '{}' of '{}', more than the file can hold", number,
                           name);
      elements.push_back({name, std::stoll(number), {}});
    } else if (word == "property") {
      if (elements.empty()) return "the PLY header has a property before any element";
      Property p;
      words >> name;
      if (name == "list") {
        words >> name >> word;
        p.length = number_type(name);
        p.item = number_type(word);
        if (p.length.bytes == 0 || p.length.kind == 'f')
          return fmt::format("the PLY type '{}' cannot count", name);
        name = word;
      } else {
        p.item = number_type(name);
      }
      if (p.item.bytes == 0) return fmt::format("the PLY header names a type '{}', which there is not", name);
      words >> word;
      p.vertices = p.length.bytes > 0 && (word == "vertex_indices" || word == "vertex_index");
      if (elements.back().name == "vertex" && p.length.bytes == 0 && word.size() == 1 && word[0] >= 'x' &&
          word[0] <= 'z')
        p.axis = word[0] - 'x';
      elements.back().properties.push_back(p);
    }
  }
  return "the PLY header has no line 'end_header'";
}

}  // namespace

std::string read_ply(const std::string& path, std::uintmax_t bytes, double scale, TriangleMesh& mesh) {
  std::ifstream in(path, std::ios::binary);
  Format format = Format::ascii;
  std::vector<Element> elements;
  std::string problem = read_header(in, bytes, format, elements);
  if (!problem.empty()) return problem;
  double vertices = 0;
  for (const Element& e : elements)
    if (e.name == "vertex") vertices = static_cast<double>(e.count);
  Body body(in, format);
  std::vector<int> corners;
  for (const Element& e : elements)
    for (long long i = 0; i < e.count; ++i) {
      Vec3 x = Vec3::Zero();
      for (const Property& p : e.properties) {
        double count = 1, value = 0;
        const auto missing = [&] {
          return fmt::format("has no number where its {} number {} should be", e.name, i + 1);
        };
        if (p.length.bytes > 0 && !body.next(p.length, count)) return missing();
        if (!(count >= 0) || count > static_cast<double>(bytes) || count != std::floor(count))
          return fmt::format("{} number {} has a list of {} entries", e.name, i + 1, count);
        corners.clear();
        for (long long k = 0; k < static_cast<long long>(count); ++k) {
          if (!body.next(p.item, value)) return missing();
          if (p.axis >= 0) x[p.axis] = scale * value;
          if (!p.vertices) continue;
          if (!(value >= 0 && value < vertices && value == std::floor(value)))
            return fmt::format("{} number {} names vertex {}, but there are {:.0f}, counted from 0", e.name,
                               i + 1, value, vertices);
          corners.push_back(static_cast<int>(value));
        }
        if (p.vertices)
          for (size_t k = 2; k < corners.size(); ++k)
            mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
      }
      if (e.name == "vertex") mesh.vertices.push_back(x);
    }
  return "";
}

}  // namespace hawser::io
