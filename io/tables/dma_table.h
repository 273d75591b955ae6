#pragma once

#include <string>
#include <string_view>

#include "contact/substrates/dma_fit.h"

namespace tricontact::io {

/// Reads a table of dynamic mechanical analysis: columns divided by commas, semicolons or tabs,
/// the first line naming them with units: `frequency [Hz], G' [MPa], G'' [MPa]`, in this order.
/// The frequency may be in rad/s and is then angular. Numbers have a decimal point. Empty lines and
/// lines that begin with # are left out. Throws contact::InputError `file:line: rule; remedy`.
contact::DmaTable read_dma_table(const std::string& path);

/// Same for a text; `name` stands for the file in messages.
contact::DmaTable parse_dma_table(std::string_view text, const std::string& name);

}  // namespace tricontact::io
