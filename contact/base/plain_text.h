#pragma once

#include <string>
#include <string_view>

namespace tricontact::contact {

/// A text without what acts on a terminal or on the order of reading: control characters (C0, DEL
/// and C1, as characters of UTF-8 or as bytes), marks and overrides of direction, ends of lines and
/// paragraphs. A space stands for each but for those of `kept`, one byte each.
std::string plain_text(std::string_view text, std::string_view kept = {});

}  // namespace tricontact::contact
