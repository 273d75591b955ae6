#include "contact/mirrored_surface.h"

#include <type_traits>
#include <utility>

namespace tricontact::contact {

namespace {

/// Index in the half of each point of the whole, and the sign of its y.
struct Image {
    std::vector<int> source;
    std::vector<int> sign;
    std::vector<int> image_of;  // point of the whole that mirrors a point of the half
};

/// Rows from -y to y on a regular grid of n_x columns; else (n_x = 0) the half's points, which are
/// at `y`, then the images of those off y = 0.
Image image_of(int n, int n_x, const std::vector<double>& y) {
    Image image;
    image.image_of.resize(n);
    image.source.reserve(2 * static_cast<std::size_t>(n));
    image.sign.reserve(2 * static_cast<std::size_t>(n));
    auto in_plane = [&](int k) { return n_x > 0 ? k < n_x : y[k] == 0; };
    auto add = [&](int source, int sign) {
        if (sign < 0 || in_plane(source))
            image.image_of[source] = static_cast<int>(image.source.size());
        image.source.push_back(source);
        image.sign.push_back(sign);
    };
    if (n_x > 0) {
        for (int row = n / n_x - 1; row > 0; --row)
            for (int i = 0; i < n_x; ++i) add(row * n_x + i, -1);
        for (int k = 0; k < n; ++k) add(k, 1);
    } else {
        for (int k = 0; k < n; ++k) add(k, 1);
        for (int k = 0; k < n; ++k)
            if (!in_plane(k)) add(k, -1);
    }
    return image;
}

/// Of all fields of a surface: whether they are odd in y.
template <class Reflect>
void reflect_fields(Surface& s, const Reflect& reflect) {
    for (auto* even :
         {&s.node_x, &s.normal_traction, &s.tension, &s.separation_work, &s.tangential_traction_x,
          &s.friction_bound, &s.displacement_x, &s.displacement_z, &s.gap, &s.slip_x,
          &s.dissipation, &s.slip_path, &s.friction_work, &s.normal_traction_consistent,
          &s.tangential_traction_x_consistent})
        reflect(*even, false);
    for (auto* odd : {&s.node_y, &s.tangential_traction_y, &s.displacement_y, &s.slip_y,
                      &s.tangential_traction_y_consistent})
        reflect(*odd, true);
    reflect(s.contact_state, false);
}

// Rows one after the other, as there are many surfaces of a run.
template <class T>
std::vector<T> all_rows(const std::vector<T>& half, int n_columns, bool is_odd) {
    std::vector<T> all;
    if (half.empty()) return all;
    const auto n_x = static_cast<std::ptrdiff_t>(n_columns);
    all.reserve(2 * half.size() - static_cast<std::size_t>(n_x));
    for (auto end = half.end(); end - half.begin() > n_x; end -= n_x)
        all.insert(all.end(), end - n_x, end);
    if constexpr (std::is_arithmetic_v<T>)
        if (is_odd)
            for (auto& value : all) value = -value;
    all.insert(all.end(), half.begin(), half.end());
    return all;
}

}  // namespace

SurfaceView::SurfaceView(const Surface& s)
    : layout(s.layout),
      n_x(s.n_x),
      n_y(s.n_y),
      first(s.first),
      spacing(s.spacing),
      offset(s.offset),
      node_x(s.node_x),
      node_y(s.node_y),
      quads(s.quads),
      normal_traction(s.normal_traction),
      tension(s.tension),
      separation_work(s.separation_work),
      tangential_traction_x(s.tangential_traction_x),
      tangential_traction_y(s.tangential_traction_y),
      friction_bound(s.friction_bound),
      displacement_x(s.displacement_x),
      displacement_y(s.displacement_y),
      displacement_z(s.displacement_z),
      gap(s.gap),
      slip_x(s.slip_x),
      slip_y(s.slip_y),
      dissipation(s.dissipation),
      slip_path(s.slip_path),
      friction_work(s.friction_work),
      contact_state(s.contact_state),
      normal_traction_consistent(s.normal_traction_consistent),
      tangential_traction_x_consistent(s.tangential_traction_x_consistent),
      tangential_traction_y_consistent(s.tangential_traction_y_consistent),
      normal_line_load(s.normal_line_load),
      tangential_line_load(s.tangential_line_load) {}

std::vector<double> mirrored_rows(const std::vector<double>& half, int n_x, bool is_odd) {
    return all_rows(half, n_x, is_odd);
}

std::vector<ContactState> mirrored_rows(const std::vector<ContactState>& half, int n_x) {
    return all_rows(half, n_x, false);
}

Surface mirrored(Surface half) {
    const std::size_t n_half = half.size();
    const Image image = image_of(static_cast<int>(n_half), half.n_x, half.node_y);
    const std::size_t n = image.source.size();
    Surface whole = std::move(half);
    reflect_fields(whole, [&](auto& values, bool odd) {
        if (values.empty()) return;
        auto all = std::remove_reference_t<decltype(values)>(n);
        for (std::size_t i = 0; i < n; ++i) all[i] = values[image.source[i]];
        if constexpr (std::is_arithmetic_v<typename decltype(all)::value_type>)
            if (odd)
                for (std::size_t i = 0; i < n; ++i) all[i] *= image.sign[i];
        values = std::move(all);
    });

    std::vector<int> original(n_half);
    for (std::size_t i = 0; i < n; ++i)
        if (image.sign[i] > 0) original[image.source[i]] = static_cast<int>(i);
    for (const auto& quad : std::exchange(whole.quads, {})) {
        std::array<int, 9> kept{}, turned{};
        for (int k = 0; k < 9; ++k) kept[k] = original[quad[k]];
        // Corners backwards keep the orientation; edges 4-7 follow their corners.
        constexpr std::array<int, 9> backwards = {0, 3, 2, 1, 7, 6, 5, 4, 8};
        for (int k = 0; k < 9; ++k) turned[k] = image.image_of[quad[backwards[k]]];
        whole.quads.push_back(kept);
        whole.quads.push_back(turned);
    }
    if (whole.n_x > 0) {
        whole.first[1] = -(whole.n_y - 1) * whole.spacing[1];
        whole.n_y = 2 * whole.n_y - 1;
    }
    return whole;
}

std::vector<ContactState> mirrored(const std::vector<ContactState>& half,
                                   const ContactPoints& points) {
    std::vector<ContactState> whole;
    for (const int source : image_of(static_cast<int>(half.size()), points.n_x, points.y).source)
        whole.push_back(half[source]);
    return whole;
}

}  // namespace tricontact::contact
