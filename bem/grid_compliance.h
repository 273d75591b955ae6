#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bem/convolved_products.h"
#include "bem/grid_interior.h"
#include "bem/grid_symbols.h"
#include "bem/influence.h"
#include "bem/influence_file.h"
#include "contact/compliances/compliance.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Compliances whose products are convolutions on a regular grid.
class ConvolvedCompliance : public contact::Compliance {
  public:
    const contact::ContactPoints& points() const override { return grid_; }
    int n_threads() const override { return n_threads_; }
    bool is_coupled() const override { return coupled_; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        products_->normal(p, u_z);
    }
    const contact::NormalGrid* normal_grid() const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        products_->tangential(t, u);
    }
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        products_->precondition_tangential(r, z);
    }
    std::unique_ptr<const contact::ActiveOperator> among(
        const std::vector<std::size_t>& active) const override;

  protected:
    ConvolvedCompliance(contact::ContactPoints grid, bool coupled, int n_threads)
        : grid_(std::move(grid)),
          coupled_(coupled),
          n_threads_(n_threads_worth(grid_.size(), n_threads)) {}

    contact::ContactPoints grid_;
    bool coupled_;
    int n_threads_;
    std::shared_ptr<const ConvolvedProducts> products_;
};

/// Elastic bodies under piecewise constant tractions on a regular grid, displacements at the cells'
/// centres, from influence coefficients; zero-padded FFT convolution (Ju & Farris 1996; Liu, Wang &
/// Liu 2000). A mirrored grid has its first row at y = 0.
class GridCompliance final : public ConvolvedCompliance {
  public:
    /// `influence` is asked for x, y >= 0 only; of isotropic bodies the rest follows by symmetry.
    /// `coupled`: use the coefficients between normal and tangential. `interface`: beside them.
    GridCompliance(CellInfluence influence, contact::ContactPoints grid, bool coupled,
                   int n_threads, const contact::Interface& interface = {});
    /// Half-spaces, coupled if `is_coupled`.
    GridCompliance(const contact::MaterialPair& materials, contact::ContactPoints grid,
                   int n_threads, const contact::Interface& interface = {});

    double local_tangential() const override { return symbols_->quadrants().at(0, 0).xx; }
    /// Products on the smallest box around them, where it is much smaller than the grid.
    std::unique_ptr<const contact::ActiveOperator> among(
        const std::vector<std::size_t>& active) const override;
    /// Normal and tangential displacements `u` [m] of several such bodies on one grid under the
    /// same tractions [Pa], without what couples the two.
    static void displacements(const std::vector<const GridCompliance*>& bodies,
                              const contact::SurfaceField& t, std::span<contact::SurfaceField> u);
    /// The coefficients of square cells at all relative positions that are asked for.
    InfluenceTable influence() const;
    /// What is below the surface, for `interior`, which knows nothing without.
    void set_view(InteriorView view) { view_ = std::move(view); }
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override;

  private:
    GridShape shape() const;
    void take(std::shared_ptr<const GridSymbols> symbols, const contact::Interface& interface);

    std::shared_ptr<const GridSymbols> symbols_;
    std::optional<InteriorView> view_;
};

/// Dundurs' beta is above what changes shifts by 1e-3.
bool is_coupled(const contact::MaterialPair& materials);

/// Two elastic half-spaces, or one and a rigid body, and what is between them; coupled if
/// `is_coupled`.
std::unique_ptr<GridCompliance> half_space_compliance(const contact::MaterialPair& materials,
                                                      contact::ContactPoints grid, int n_threads,
                                                      const contact::Interface& interface = {});
/// Layers under an elastic half-space, or (`indenter` empty) a rigid body. Throws
/// contact::InputError.
std::unique_ptr<GridCompliance> layer_compliance(const theory::LayerStack& layers,
                                                 const std::optional<contact::Material>& indenter,
                                                 contact::ContactPoints grid, int n_threads,
                                                 const contact::Interface& interface = {});
/// The same in plane strain (see PlaneLayerInfluence): `grid` is one row of strips along x, their
/// spacing along y is their length. Throws contact::InputError.
std::unique_ptr<GridCompliance> plane_layer_compliance(
    const theory::LayerStack& layers, const std::optional<contact::Material>& indenter,
    contact::ContactPoints grid, int n_threads, const contact::Interface& interface = {});
/// Whatever bodies have these coefficients. `name`: of their file, for messages. Throws
/// contact::InputError if their spacing is another one or positions are missing.
std::unique_ptr<GridCompliance> tabulated_compliance(InfluenceTable table, const std::string& name,
                                                     bool coupled, contact::ContactPoints grid,
                                                     int n_threads,
                                                     const contact::Interface& interface = {});

}  // namespace tricontact::bem
