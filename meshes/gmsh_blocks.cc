#include "meshes/gmsh_blocks.h"

#include <gmsh.h>

#include "meshes/gmsh_model.h"

namespace tricontact::meshes {

namespace {

using Index = std::array<int, 3>;

// Blocks between the grid's planes as gmsh entities. All that starts at the corner (i, j, k) of the
// planes and points upwards has a tag by that corner: a point; a curve along, a surface across each
// direction; a volume.
class Blocks {
  public:
    Blocks(const LayerGrid& grid, double unit) : grid_(grid), unit_(unit) {
        for (int d = 0; d < 3; ++d) n_[d] = static_cast<int>(grid.axes[d].planes.size());
    }

    void build() const {
        for_each_corner([&](const Index& at) { add_point(at); });
        for (int d = 0; d < 3; ++d) for_each_corner([&](const Index& at) { add_curve(d, at); });
        for (int d = 0; d < 3; ++d) for_each_corner([&](const Index& at) { add_surface(d, at); });
        for_each_corner([&](const Index& at) { add_volume(at); });
        gmsh::model::geo::synchronize();
    }

    void name() const {
        std::array<std::vector<int>, n_boundaries> surfaces;
        std::array<std::vector<int>, n_regions> volumes;
        for (int d = 0; d < 3; ++d)
            for_each_corner([&](const Index& at) {
                if (has_surface(d, at) && (at[d] == 0 || at[d] == n_[d] - 1))
                    surfaces[static_cast<int>(boundary(d, at))].push_back(tag(d, at));
            });
        for_each_corner([&](const Index& at) {
            if (!has_volume(at)) return;
            const Region region = at[2] == grid_.layer ? Region::layer : Region::lower_layer;
            volumes[static_cast<int>(region)].push_back(tag(0, at));
        });
        for (int i = 0; i < n_boundaries; ++i)
            if (!surfaces[i].empty()) add_group(static_cast<Boundary>(i), surfaces[i]);
        for (int i = 0; i < n_regions; ++i)
            if (!volumes[i].empty()) add_group(static_cast<Region>(i), volumes[i]);
    }

  private:
    template <class Function>
    void for_each_corner(Function function) const {
        for (int k = 0; k < n_[2]; ++k)
            for (int j = 0; j < n_[1]; ++j)
                for (int i = 0; i < n_[0]; ++i) function(Index{i, j, k});
    }

    bool has_next(int d, const Index& at) const { return at[d] + 1 < n_[d]; }
    bool has_surface(int d, const Index& at) const {
        return has_next((d + 1) % 3, at) && has_next((d + 2) % 3, at);
    }
    bool has_volume(const Index& at) const { return has_next(0, at) && has_surface(0, at); }

    static Index next(int d, Index at) {
        ++at[d];
        return at;
    }
    // Of a point or volume (d = 0), or of a curve along or a surface across direction d.
    int tag(int d, const Index& at) const {
        return 1 + at[0] + n_[0] * (at[1] + n_[1] * (at[2] + n_[2] * d));
    }

    void add_point(const Index& at) const {
        std::array<double, 3> p;
        for (int d = 0; d < 3; ++d) p[d] = grid_.axes[d].planes[at[d]] / unit_;
        gmsh::model::geo::addPoint(p[0], p[1], p[2], 0, tag(0, at));
    }

    void add_curve(int d, const Index& at) const {
        if (!has_next(d, at)) return;
        const GridAxis::Strip& strip = grid_.axes[d].strips[at[d]];
        gmsh::model::geo::addLine(tag(0, at), tag(0, next(d, at)), tag(d, at));
        gmsh::model::geo::mesh::setTransfiniteCurve(tag(d, at), strip.n + 1, "Progression",
                                                    strip.ratio);
    }

    void add_surface(int d, const Index& at) const {
        if (!has_surface(d, at)) return;
        const int e = (d + 1) % 3, f = (d + 2) % 3, surface = tag(d, at);
        gmsh::model::geo::addCurveLoop(
            {tag(e, at), tag(f, next(e, at)), -tag(e, next(f, at)), -tag(f, at)}, surface);
        gmsh::model::geo::addPlaneSurface({surface}, surface);
        gmsh::model::geo::mesh::setTransfiniteSurface(surface);
        gmsh::model::geo::mesh::setRecombine(2, surface);
    }

    void add_volume(const Index& at) const {
        if (!has_volume(at)) return;
        std::vector<int> surfaces;
        for (int d = 0; d < 3; ++d)
            for (const int surface : {tag(d, at), tag(d, next(d, at))}) surfaces.push_back(surface);
        gmsh::model::geo::addSurfaceLoop(surfaces, tag(0, at));
        gmsh::model::geo::addVolume({tag(0, at)}, tag(0, at));
        gmsh::model::geo::mesh::setTransfiniteVolume(tag(0, at));
    }

    Boundary boundary(int d, const Index& at) const {
        if (d == 2 && at[2] == 0) return Boundary::base;
        if (d == 2)
            return at[0] == grid_.patch_x && at[1] >= grid_.patch_y && at[1] <= grid_.last_patch_y
                       ? Boundary::contact
                       : Boundary::free_top;
        const bool symmetric = at[1] == 0 ? grid_.symmetric_low : grid_.symmetric_high;
        return d == 1 && symmetric ? Boundary::symmetry : Boundary::sides;
    }

    const LayerGrid& grid_;
    double unit_;
    Index n_{};
};

}  // namespace

void build_blocks(const LayerGrid& grid, double unit) {
    const Blocks blocks(grid, unit);
    blocks.build();
    blocks.name();
}

}  // namespace tricontact::meshes
