#include "runs/shown_states.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/half_space_scales.h"

namespace tricontact::runs {

io::IndenterShape shown_indenter(const contact::Case& c, const contact::SurfaceView& surface) {
    constexpr double shown = 1.5;
    const auto [half_x, half_y] = contact::half_space_scales(c).half_widths;
    if (!c.is_cylindrical()) return {*c.make_indenter(), {shown * std::max(half_x, half_y)}};
    const bool has_width = c.is_line_contact() && surface.spacing[1] > 0;
    return {*c.make_indenter(),
            {shown * half_x, has_width ? surface.n_y * surface.spacing[1] / 2 : half_y}};
}

std::string size_of_states(const std::string& model, double n, std::size_t bytes) {
    constexpr double megabyte = 1e6;
    return fmt::format(
        "{}: up to {:.0f} states for ParaView, {:.2g} MB (output.vtk, "
        "output.frames_per_period)",
        model, n, n * static_cast<double>(bytes) / megabyte);
}

}  // namespace tricontact::runs
