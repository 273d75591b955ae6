#include "fem/mortar/surface_heights.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tricontact::fem {

using contact::ContactPoints;
using contact::Vector2;

namespace {

constexpr std::size_t enough_neighbours = 8;  // a corner within the surface has them around it

/// Corners that share a face with each corner.
std::map<int, std::set<int>> neighbours_of_corners(const std::vector<SeenFace>& faces) {
    std::map<int, std::set<int>> neighbours;
    for (const SeenFace& face : faces)
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b)
                if (a != b) neighbours[face.nodes[a]].insert(face.nodes[b]);
    return neighbours;
}

/// h = h_0 + g x + x'Hx/2 about a corner.
struct Quadratic {
    Vector2 centre{};
    double height = 0;
    Eigen::Matrix<double, 5, 1> terms = Eigen::Matrix<double, 5, 1>::Zero();

    static Eigen::Matrix<double, 1, 5> functions(double x, double y) {
        return {x, y, x * x, x * y, y * y};
    }
    double at(const Vector2& x) const {
        return height + functions(x[0] - centre[0], x[1] - centre[1]) * terms;
    }
};

class CornerFits {
  public:
    CornerFits(const ContactPoints& surface, const std::vector<SeenFace>& faces,
               const std::vector<double>& height)
        : surface_(surface), height_(height), neighbours_(neighbours_of_corners(faces)) {
        for (const auto& [corner, around] : neighbours_) fits_[corner] = fit(corner);
    }

    double at(int corner, const Vector2& x) const { return fits_.at(corner).at(x); }

  private:
    /// Those beside a corner; at the surface's edge also those beside them.
    std::set<int> around(int corner) const {
        std::set<int> all = neighbours_.at(corner);
        if (all.size() >= enough_neighbours) return all;
        for (const int one : neighbours_.at(corner)) {
            const auto& further = neighbours_.at(one);
            all.insert(further.begin(), further.end());
        }
        all.erase(corner);
        return all;
    }

    Quadratic fit(int corner) const {
        const Vector2 centre{surface_.x[corner], surface_.y[corner]};
        std::vector<std::array<double, 3>> offsets;  // x, y, height
        double scale = 0;
        const auto add = [&](double x, double y, double h) {
            offsets.push_back({x - centre[0], y - centre[1], h - height_[corner]});
            scale = std::max(scale, std::hypot(offsets.back()[0], offsets.back()[1]));
        };
        for (const int k : around(corner)) {
            add(surface_.x[k], surface_.y[k], height_[k]);
            if (surface_.mirrored) add(surface_.x[k], -surface_.y[k], height_[k]);
        }
        Eigen::MatrixXd a(offsets.size(), 5);
        Eigen::VectorXd b(offsets.size());
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            const auto& [x, y, h] = offsets[i];
            a.row(static_cast<Eigen::Index>(i)) = Quadratic::functions(x / scale, y / scale);
            b[static_cast<Eigen::Index>(i)] = h;
        }
        Quadratic fit{centre, height_[corner], {}};
        fit.terms = a.completeOrthogonalDecomposition().solve(b);
        for (int k = 0; k < 5; ++k) fit.terms[k] /= k < 2 ? scale : scale * scale;
        return fit;
    }

    const ContactPoints& surface_;
    const std::vector<double>& height_;
    std::map<int, std::set<int>> neighbours_;
    std::map<int, Quadratic> fits_;
};

}  // namespace

SurfaceHeights::SurfaceHeights(const ContactPoints& surface, std::vector<double> height)
    : faces_(seen_faces(surface)), height_(std::move(height)) {
    const CornerFits fits(surface, faces_, height_);
    std::vector<double> smooth = height_;
    for (const SeenFace& face : faces_) {
        for (int k = 0; k < 4; ++k) {
            const int node = face.nodes[4 + k];
            const Vector2 x{surface.x[node], surface.y[node]};
            smooth[node] = (fits.at(face.nodes[k], x) + fits.at(face.nodes[(k + 1) % 4], x)) / 2;
        }
        const int middle = face.nodes[8];
        smooth[middle] = 0;
        for (int k = 0; k < 4; ++k)
            smooth[middle] += fits.at(face.nodes[k], {surface.x[middle], surface.y[middle]}) / 4;
    }
    height_ = std::move(smooth);
}

std::optional<double> SurfaceHeights::at(const Vector2& x) const {
    for (const SeenFace& face : faces_) {
        const Vector2 low = face.low(), high = face.high();
        if (x[0] < low[0] || x[0] > high[0] || x[1] < low[1] || x[1] > high[1]) continue;
        const auto place = face.place_of(x);
        constexpr double rounding = 1e-9;
        if (!place ||
            std::ranges::any_of(*place, [](double s) { return s < -rounding || s > 1 + rounding; }))
            continue;
        const auto phi = biquadratic((*place)[0], (*place)[1]);
        double sum = 0;
        for (int a = 0; a < 9; ++a) sum += phi[a] * height_[face.nodes[a]];
        return sum;
    }
    return std::nullopt;
}

}  // namespace tricontact::fem
