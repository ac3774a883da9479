// Common base of the checks of events: the event under check and its list of issues.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "hawser/model/check.hpp"

namespace hawser::model {

class EventChecks {
 protected:
  EventChecks(const Case& c, const Issues& issue) : c_(c), all_(issue) {}

  // key: relative to event i_.
  template <class... Args>
  void issue(const std::string& key, fmt::format_string<Args...> text, Args&&... args) const {
    all_.below(fmt::format("events[{}]", i_))(key, text, std::forward<Args>(args)...);
  }
  const Event& event() const { return c_.events[i_]; }

  const Case& c_;
  const Issues& all_;
  std::size_t i_ = 0;  // the event under check
};

}  // namespace hawser::model
