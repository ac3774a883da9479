// A list of names in one text: a farm has thousands, which are rarely read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

class Names {
 public:
  void push_back(std::string_view name) {
    text_ += name;
    end_.push_back(static_cast<std::uint32_t>(text_.size()));
  }
  void shrink_to_fit() {
    text_.shrink_to_fit();
    end_.shrink_to_fit();
  }
  std::size_t size() const { return end_.size(); }
  // Empty: there is no such name.
  std::string operator[](std::size_t i) const {
    if (i >= size()) return {};
    const std::size_t begin = i > 0 ? end_[i - 1] : 0;
    return text_.substr(begin, end_[i] - begin);
  }

 private:
  std::string text_;
  std::vector<std::uint32_t> end_;  // of each name in the text, which has up to 4 GB
};

}  // namespace hawser
