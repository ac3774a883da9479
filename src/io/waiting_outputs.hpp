// Accepted outputs that are not yet in the file. Internal to io.
#pragma once

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "hawser/io/clash_rows.hpp"
#include "hawser/io/contact_rows.hpp"

namespace hawser::io {

// One output after the other.
struct WaitingOutputs {
  std::vector<double> times;
  std::vector<std::vector<double>> fields, ends;  // by field: outputs x nodes x components
  std::vector<double> position, rotation;         // of bodies, on the first rank
  std::vector<std::vector<float>> moved;          // by volume, on the first rank
  std::vector<ClashTables> clashes;
  std::vector<ContactRows> contacts;

  size_t size() const {
    size_t n = 0;
    for (const auto& f : fields) n += f.size();
    for (const auto& c : contacts) n += kContactNumbers * c.size();
    return n;
  }
  // Removes and returns the first n outputs.
  WaitingOutputs take(size_t n) {
    const size_t count = times.size();
    if (n == count) return std::exchange(*this, {});
    WaitingOutputs out;
    const auto part = [&](auto& from, auto& to) {
      const auto end = from.begin() + static_cast<std::ptrdiff_t>(from.size() / count * n);
      to.assign(std::make_move_iterator(from.begin()), std::make_move_iterator(end));
      from.erase(from.begin(), end);
    };
    const auto parts = [&](auto& from, auto& to) {
      to.resize(from.size());
      for (size_t i = 0; i < from.size(); ++i) part(from[i], to[i]);
    };
    parts(fields, out.fields);
    parts(ends, out.ends);
    parts(moved, out.moved);
    part(position, out.position);
    part(rotation, out.rotation);
    part(clashes, out.clashes);
    part(contacts, out.contacts);
    part(times, out.times);
    return out;
  }
};

}  // namespace hawser::io
