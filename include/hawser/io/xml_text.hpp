// Text as XML takes it.
#pragma once

#include <string>

namespace hawser::io {

// For attributes and between tags. Bytes that are no UTF-8, and characters that XML 1.0 has no way to write,
// become U+FFFD.
std::string xml_text(const std::string& text);

// Whether a reader of the XML gets the text back as it is.
bool xml_holds(const std::string& text);

}  // namespace hawser::io
