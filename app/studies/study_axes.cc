#include "app/studies/study_axes.h"

#include <charconv>
#include <variant>

namespace tricontact::app {

report::Cell cell_of(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) return number;
    return text;
}

comparisons::Sweep::Axis axis_of(const io::Study::Axis& axis) {
    const auto* range = std::get_if<io::Study::Range>(&axis.values);
    const io::Dimension dimension = axis.key->dimension;
    const bool has_unit = dimension != io::Dimension::none;
    return {.key = std::string(axis.key->path),
            .unit = std::string(has_unit ? io::si_unit(dimension) : ""),
            .logarithmic = range && range->logarithmic};
}

}  // namespace tricontact::app
