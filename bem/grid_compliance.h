#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bem/grid_convolution.h"
#include "bem/grid_interior.h"
#include "bem/influence.h"
#include "bem/influence_file.h"
#include "contact/solvers/compliance.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Compliances whose products are convolutions on a regular grid.
class ConvolvedCompliance : public contact::Compliance {
  public:
    const contact::ContactPoints& points() const override { return grid_; }
    bool is_coupled() const override { return coupled_; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;

  protected:
    /// All but that of normal displacements by pressures.
    struct Symbols {
        GridConvolution::Symbol2 tangential, inverse;
        GridConvolution::Symbol from_normal_x{}, from_normal_y{};  ///< of coupled bodies
    };
    ConvolvedCompliance(contact::ContactPoints grid, bool coupled)
        : grid_(std::move(grid)), coupled_(coupled) {}
    /// Of the symbols; and of the inverse, on the bare grid.
    virtual const GridConvolution& convolution() const = 0;
    virtual const GridConvolution& preconditioner() const { return convolution(); }
    /// Called once, unless `symbols_` has them before.
    virtual Symbols make_symbols() const { return {}; }

    contact::ContactPoints grid_;
    bool coupled_;
    GridConvolution::Symbol normal_;
    /// Made when first needed: normal contact alone takes half the memory.
    mutable std::optional<Symbols> symbols_;

  private:
    const Symbols& symbols() const;
};

/// Elastic bodies under piecewise constant tractions on a regular grid, displacements at the cells'
/// centres, from influence coefficients; zero-padded FFT convolution (Ju & Farris 1996; Liu, Wang &
/// Liu 2000).
class GridCompliance final : public ConvolvedCompliance {
  public:
    /// The coefficients of one cell at a relative position [m].
    using Influence = std::function<InfluenceCoefficients(double x, double y)>;

    /// `influence` is asked for x, y >= 0 only; of isotropic bodies the rest follows by symmetry.
    /// `coupled`: use the coefficients between normal and tangential.
    GridCompliance(Influence influence, contact::ContactPoints grid, bool coupled, int n_threads);

    double local_tangential() const override { return influence_(0, 0).xx; }
    /// The coefficients of square cells at all relative positions that are asked for.
    InfluenceTable influence() const;
    /// What is below the surface, for `interior`, which knows nothing without.
    void set_view(InteriorView view) { view_ = std::move(view); }
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override {
        if (!view_) return nullptr;
        return std::make_unique<contact::Interior>(grid_interior(*view_, grid_, p, t));
    }

  private:
    using Coefficient = double InfluenceCoefficients::*;
    std::vector<std::vector<double>> quadrants(const std::vector<Coefficient>& which) const;
    GridConvolution::Symbol symbol(const GridConvolution& convolution,
                                   const std::vector<double>& quadrant, double parity_x,
                                   double parity_y) const;
    const GridConvolution& convolution() const override { return linear_; }
    const GridConvolution& preconditioner() const override { return periodic_; }
    Symbols make_symbols() const override;

    Influence influence_;
    std::optional<InteriorView> view_;
    int n_threads_;
    GridConvolution linear_;    // zero-padded
    GridConvolution periodic_;  // on the bare grid, for the preconditioner
    int columns_, rows_;        // of a quadrant of relative positions
};

/// Dundurs' beta is above what changes shifts by 1e-3.
bool is_coupled(const contact::MaterialPair& materials);

/// Two elastic half-spaces, or one and a rigid body; coupled if `is_coupled`.
std::unique_ptr<GridCompliance> half_space_compliance(const contact::MaterialPair& materials,
                                                      contact::ContactPoints grid, int n_threads);
/// Layers under an elastic half-space, or (`indenter` empty) a rigid body. Throws
/// contact::InputError.
std::unique_ptr<GridCompliance> layer_compliance(const theory::LayerStack& layers,
                                                 const std::optional<contact::Material>& indenter,
                                                 contact::ContactPoints grid, int n_threads);
/// The same in plane strain (see PlaneLayerInfluence): `grid` is one row of strips along x, their
/// spacing along y is their length. Throws contact::InputError.
std::unique_ptr<GridCompliance> plane_layer_compliance(
    const theory::LayerStack& layers, const std::optional<contact::Material>& indenter,
    contact::ContactPoints grid, int n_threads);
/// Whatever bodies have these coefficients. `name`: of their file, for messages. Throws
/// contact::InputError if their spacing is another one or positions are missing.
std::unique_ptr<GridCompliance> tabulated_compliance(InfluenceTable table, const std::string& name,
                                                     bool coupled, contact::ContactPoints grid,
                                                     int n_threads);

}  // namespace tricontact::bem
