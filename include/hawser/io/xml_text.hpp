// Escaping of text for XML.
#pragma once

#include <string>

namespace hawser::io {

// For attributes and element text. Bytes that are no UTF-8, and characters that XML 1.0 cannot represent,
// become U+FFFD.
std::string xml_text(const std::string& text);

// True if an XML reader recovers the text unchanged.
bool xml_holds(const std::string& text);

}  // namespace hawser::io
