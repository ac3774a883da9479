// Edit distance between words, and phrases of error messages: suggested spellings, quoted text, lists of
// words.
#include "hawser/model/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace hawser::model {

double edit_distance(std::string_view a, std::string_view b) {
  const auto cost = [](char x, char y) {
    if (x == y) return 0.0;
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return lower(x) == lower(y) ? 0.5 : 1.0;
  };
  const std::size_t n = a.size();
  const std::size_t m = b.size();
  std::vector<std::vector<double>> d(n + 1, std::vector<double>(m + 1));
  for (std::size_t i = 0; i <= n; ++i) d[i][0] = static_cast<double>(i);
  for (std::size_t j = 0; j <= m; ++j) d[0][j] = static_cast<double>(j);
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t j = 1; j <= m; ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[n][m];
}

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t kLongest = 64;  // longer words are no typing mistakes, and the cost is quadratic
  if (word.size() > kLongest) return {};
  std::string best;
  double best_distance = 0;
  for (const std::string& c : candidates) {
    if (c.size() > kLongest) continue;
    const double d = edit_distance(word, c);
    if (best.empty() || d < best_distance) {
      best = c;
      best_distance = d;
    }
  }
  const double length = static_cast<double>(std::max(word.size(), best.size()));
  return best_distance <= std::max(1.0, 0.4 * length) && best_distance < length ? best : std::string();
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const std::string n = nearest(word, candidates);
  return n.empty() ? n : fmt::format("; did you mean '{}'?", n);
}

std::string missing_blank(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  std::size_t colon = 0;
  while (colon < text.size() &&
         (letter(text[colon]) || (colon > 0 && text[colon] >= '0' && text[colon] <= '9')))
    ++colon;
  if (colon == 0 || colon + 1 >= text.size() || text[colon] != ':') return "";
  // In paths and addresses the colon is part of the value.
  if (std::string_view(" \t,]}:/\\").find(text[colon + 1]) != std::string_view::npos) return "";
  const std::string_view key = text.substr(0, colon);
  const std::string_view value = text.substr(colon + 1);
  const std::string_view word = value.substr(0, value.find_first_of(" \t,]}"));
  return fmt::format("a blank is missing after the colon in {}: write {}",
                     quote(fmt::format("{}:{}", key, word)), quote(fmt::format("{}: {}", key, word)));
}

std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string s(text.substr(0, kLongest));
  for (char& c : s)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return fmt::format("'{}{}'", s, text.size() > kLongest ? "..." : "");
}

std::string enumerate(const std::vector<std::string>& words, std::string_view last) {
  std::string s;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) s += i + 1 == words.size() ? fmt::format(" {} ", last) : ", ";
    s += words[i];
  }
  return s;
}

}  // namespace hawser::model
