// Parser of STL files: detection of the text and binary forms, words and numbers of the text, records of the
// binary form, and messages for malformed files.
#include "stl_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string_view>

#include "hawser/io/input_file.hpp"

namespace hawser::io {
namespace {

constexpr std::uintmax_t kHeader = 84, kFacet = 50;  // bytes, in a binary file

bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Sequential words of a text with their line numbers.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  // Empty at the end of the text.
  std::string_view next() {
    while (at_ < text_.size() && blank(text_[at_])) line_ += text_[at_++] == '\n';
    const std::size_t from = at_;
    while (at_ < text_.size() && !blank(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }
  // The rest of the line without surrounding blanks.
  std::string_view rest_of_line() {
    const std::size_t from = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    std::string_view text = text_.substr(from, at_ - from);
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
  }
  int line() const { return line_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

// Compares without letter case.
bool is(std::string_view word, std::string_view small) {
  return std::equal(word.begin(), word.end(), small.begin(), small.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

std::string shown(std::string_view word) {
  if (word.empty()) return "the end of the file";
  std::string s(word.substr(0, 20));
  for (char& c : s)
    if (c < 0x21 || c > 0x7e) c = '?';
  return "'" + s + (word.size() > 20 ? "...'" : "'");
}

std::string expected(const Words& words, std::string_view expected_text, std::string_view word) {
  return fmt::format("line {} of the STL text should have {}, not {}", words.line(), expected_text,
                     shown(word));
}

bool read_number(std::string_view word, double& x) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto r = std::from_chars(word.data(), word.data() + word.size(), x);
  return r.ec == std::errc() && r.ptr == word.data() + word.size();
}

// Parses a facet after the word 'facet'.
std::string read_facet(Words& words, double scale, TriangleMesh& mesh) {
  std::string_view word;
  const auto need = [&](std::string_view small) { return is(word = words.next(), small); };
  if (!need("normal")) return expected(words, "'normal'", word);
  // Some programs write 'nan' as the normal of a degenerate facet; normals are not used.
  for (int i = 0; i < 3; ++i)
    if (word = words.next(); word.empty()) return expected(words, "a number of a normal", word);
  if (!need("outer")) return expected(words, "'outer loop'", word);
  if (!need("loop")) return expected(words, "'loop'", word);
  std::array<int, 3> corners;
  for (int& corner : corners) {
    if (!need("vertex")) return expected(words, "'vertex'", word);
    Vec3 x;
    for (int i = 0; i < 3; ++i) {
      word = words.next();
      if (!read_number(word, x[i])) return expected(words, "a number", word);
    }
    corner = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(scale * x);
  }
  if (!need("endloop")) return expected(words, "'endloop', as a facet has three corners", word);
  if (!need("endfacet")) return expected(words, "'endfacet'", word);
  mesh.triangles.push_back(corners);
  return "";
}

std::string read_text(std::string_view text, double scale, TriangleMesh& mesh) {
  Words words(text);
  int part = -1;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (is(word, "solid")) {
      part = mesh.part_named(std::string(words.rest_of_line()));
    } else if (is(word, "endsolid")) {
      words.rest_of_line();
    } else if (is(word, "facet")) {
      if (std::string problem = read_facet(words, scale, mesh); !problem.empty()) return problem;
      mesh.part.push_back(part);
    } else {
      return expected(words, "'facet' or 'endsolid'", word);
    }
  }
  return mesh.triangles.empty() ? "the STL text has no facets" : "";
}

std::uint32_t facet_count(const std::string& file) {
  std::array<unsigned char, 4> raw;
  std::memcpy(raw.data(), file.data() + kHeader - 4, 4);
  return raw[0] | raw[1] << 8U | raw[2] << 16U | std::uint32_t{raw[3]} << 24U;
}

std::string read_binary(const std::string& file, double scale, TriangleMesh& mesh) {
  if (file.size() < kHeader)
    return fmt::format(
        "is no STL file: a text begins with 'solid', and a binary file has {} bytes at least, not {}",
        kHeader, file.size());
  const std::uintmax_t n = facet_count(file);
  if (n == 0) return "the binary STL file has a number of facets of 0";
  if (kHeader + kFacet * n > file.size())
    return fmt::format(
        "is truncated or no STL file: it does not begin with 'solid', and as a binary file it states {} "
        "facets, which are {} bytes, but there are {}",
        n, kHeader + kFacet * n, file.size());
  mesh.parts = {""};
  mesh.part.assign(n, 0);
  mesh.vertices.reserve(3 * n);
  mesh.triangles.reserve(n);
  for (std::uintmax_t f = 0; f < n; ++f) {
    std::array<int, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 x;
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<char, 4> raw;
        std::memcpy(raw.data(), file.data() + kHeader + kFacet * f + 12 + 12 * c + 4 * i, 4);
        if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
        x[static_cast<int>(i)] = std::bit_cast<float>(raw);
      }
      corners[c] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(scale * x);
    }
    mesh.triangles.push_back(corners);
  }
  return "";
}

// A file that begins with 'solid' and continues as text; headers of binary files may begin with 'solid', too.
bool is_text(std::string_view file) {
  file.remove_prefix(mark_length(file));
  if (!is(Words(file).next(), "solid")) return false;
  return file.substr(0, 2000).find('\0') == std::string_view::npos;
}

}  // namespace

std::string read_stl(const std::string& path, std::uintmax_t bytes, double scale, TriangleMesh& mesh) {
  std::string file(bytes, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(file.data(), static_cast<std::streamsize>(bytes))) return "cannot be read";
  const bool fits = bytes >= kHeader && bytes == kHeader + kFacet * facet_count(file);
  if (fits || !is_text(file)) return read_binary(file, scale, mesh);
  std::string_view text = file;
  text.remove_prefix(mark_length(text));
  return read_text(text, scale, mesh);
}

}  // namespace hawser::io
