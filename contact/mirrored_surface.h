#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// A surface as the places of its fields, which belong to another. Names as Surface has them.
struct SurfaceView {
    SurfaceView() = default;
    SurfaceView(const Surface& s);  // NOLINT(google-explicit-constructor): the same, elsewhere

    Surface::Layout layout = Surface::Layout::grid;
    int n_x = 0, n_y = 0;
    Vector2 first{}, spacing{}, offset{};
    /// Fields have the rows at y >= 0 of a grid alone, that at y = 0 first, as if mirrored_rows()
    /// were to come. Numbers of points and positions are those of the whole.
    bool is_half = false;
    std::span<const double> node_x, node_y;
    std::span<const std::array<int, 9>> quads;
    std::span<const double> normal_traction, tension, separation_work;
    std::span<const double> tangential_traction_x, tangential_traction_y, friction_bound;
    std::span<const double> displacement_x, displacement_y, displacement_z, gap;
    std::span<const double> slip_x, slip_y, dissipation, slip_path, friction_work;
    std::span<const ContactState> contact_state;
    std::span<const double> normal_traction_consistent;
    std::span<const double> tangential_traction_x_consistent, tangential_traction_y_consistent;
    std::span<const double> normal_line_load, tangential_line_load;

    std::size_t size() const {
        return layout == Surface::Layout::nodes ? node_x.size()
                                                : static_cast<std::size_t>(n_x) * n_y;
    }
    /// Of a field.
    std::size_t n_values() const {
        return is_half ? (size() + static_cast<std::size_t>(n_x)) / 2 : size();
    }
    double x(int i) const { return first[0] + i * spacing[0]; }
    double y(int j) const { return first[1] + j * spacing[1]; }
};

/// What models are, too, that have the fields of their surface at hand: there are many states of a
/// run to write, and none has to be copied.
class ShowsSurface {
  public:
    virtual ~ShowsSurface() = default;
    using Look = std::function<void(const SurfaceView&)>;
    /// Model::surface() without copies, which is there until `look` returns; false: it is not at
    /// hand, and nothing was shown.
    virtual bool show(const Look& look) const = 0;
};

/// The whole surface from its half with y >= 0, of nodes: x and normal components even in y, y
/// components odd. Points at y = 0 are not doubled.
Surface mirrored(Surface half);
/// The same of a field on a grid of `n_x` columns.
std::vector<double> mirrored_rows(const std::vector<double>& half, int n_x, bool is_odd);
std::vector<ContactState> mirrored_rows(const std::vector<ContactState>& half, int n_x);
/// The same of states at points, in the same order.
std::vector<ContactState> mirrored(const std::vector<ContactState>& half,
                                   const ContactPoints& points);

}  // namespace tricontact::contact
