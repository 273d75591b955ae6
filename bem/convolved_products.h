#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "bem/grid_convolution.h"
#include "bem/mirrored_convolution.h"
#include "bem/normal_level.h"
#include "contact/compliances/active_operator.h"
#include "contact/compliances/compliance.h"
#include "contact/substrates/substrate.h"

// Products of a grid with its kernels, and approximate inverses for the conjugate gradients.
// - `convolution` has room for zeros beside the fields: exact products of a free contact.
// - `bare` has the bare grid's period. The inverse of its symbol per wave number is the inverse of
//   the periodic problem, which differs from the free one at the edges of the contact only: a good
//   preconditioner at a quarter of the cost.

namespace tricontact::bem {

/// What cells do to each other, as convolutions; one caller at a time, see contact::Compliance.
class ConvolvedProducts {
  public:
    virtual ~ConvolvedProducts() = default;

    virtual void normal(std::span<const double> p, std::span<double> u_z) const = 0;
    /// The same with what NormalNewton needs, of cells of this area [m^2]; null where y = 0
    /// mirrors.
    virtual const contact::NormalGrid* normal_grid(double cell_area) const = 0;
    virtual void tangential(const contact::TangentialField& t,
                            contact::TangentialField& u) const = 0;
    virtual void tangential_from_normal(std::span<const double> p,
                                        contact::TangentialField& u) const = 0;
    virtual void normal_from_tangential(const contact::TangentialField& t,
                                        std::span<double> u_z) const = 0;
    virtual void precondition_tangential(const contact::TangentialField& r,
                                         contact::TangentialField& z) const = 0;
    /// With a layer over the cells, whose `xy` y = 0 mirrors into its opposite.
    virtual void precondition_under(const contact::LayerCompliance& layer,
                                    const contact::TangentialField& r,
                                    contact::TangentialField& z) const = 0;
    /// `normal` and `tangential` of several bodies like this one on the same grid under the same
    /// tractions: with one transform of these where y = 0 mirrors.
    using Bodies = std::vector<const ConvolvedProducts*>;
    virtual void displacements(const Bodies& bodies, const contact::SurfaceField& t,
                               std::span<contact::SurfaceField> u) const = 0;
    /// The same of `normal`, on a window alone.
    virtual void precondition_normal(std::span<const double> r, std::span<double> z) const = 0;
};

/// Of normal displacements by pressures.
struct NormalSymbols {
    GridConvolution::Symbol normal, inverse;
};

/// All symbols but that of normal displacements by pressures.
struct TangentialSymbols {
    GridConvolution::Symbol2 tangential, inverse;
    GridConvolution::Symbol from_normal_x{}, from_normal_y{};  ///< of coupled bodies
};

/// By a GridConvolution or a MirroredConvolution.
template <class Convolution>
class ProductsBy final : public ConvolvedProducts {
  public:
    using Symbol = GridConvolution::Symbol;
    template <class Symbols>
    using Make = std::function<Symbols(const Convolution& convolution, const Convolution& bare)>;
    using MakeSymbols = Make<TangentialSymbols>;

    /// `bare`: of the inverse, on the grid without padding; empty: the same. `rest`: called when
    /// first needed, for normal contact alone takes half the memory.
    ProductsBy(Convolution convolution, std::optional<Convolution> bare, Symbol normal,
               MakeSymbols rest)
        : convolution_(std::move(convolution)),
          bare_(std::move(bare)),
          normal_{std::move(normal), {}},
          make_rest_(std::move(rest)) {}
    /// A window, of which all symbols are made when first needed.
    ProductsBy(Convolution convolution, std::optional<Convolution> bare, Make<NormalSymbols> normal,
               MakeSymbols rest)
        : convolution_(std::move(convolution)),
          bare_(std::move(bare)),
          make_normal_(std::move(normal)),
          make_rest_(std::move(rest)) {}
    ProductsBy(Convolution convolution, std::optional<Convolution> bare, Symbol normal,
               TangentialSymbols rest)
        : ProductsBy(std::move(convolution), std::move(bare), std::move(normal), MakeSymbols{}) {
        rest_ = std::move(rest);
    }

    void normal(std::span<const double> p, std::span<double> u_z) const override {
        convolution_.template apply<1, 1>({{{&normal_symbols().normal}}}, {p}, {u_z});
    }
    const contact::NormalGrid* normal_grid(double cell_area) const override {
        if constexpr (std::is_same_v<Convolution, GridConvolution>) {
            if (!normal_level_)
                normal_level_ =
                    std::make_unique<NormalLevel>(convolution_, normal_symbols().normal, cell_area);
            return normal_level_.get();
        }
        return nullptr;
    }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        const auto& s = rest().tangential;
        convolution_.template apply<2, 2>({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}}, {t.x, t.y},
                                          {u.x, u.y});
    }
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override {
        const auto& s = rest();
        convolution_.template apply<2, 1, GridConvolution::Phase::forward>(
            {{{&s.from_normal_x}, {&s.from_normal_y}}}, {p}, {u.x, u.y});
    }
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override {
        const auto& s = rest();
        convolution_.template apply<1, 2, GridConvolution::Phase::backward>(
            {{{&s.from_normal_x, &s.from_normal_y}}}, {t.x, t.y}, {u_z});
    }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        const auto& s = rest().inverse;
        bare().template apply<2, 2>({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}}, {r.x, r.y}, {z.x, z.y});
    }
    void precondition_under(const contact::LayerCompliance& layer,
                            const contact::TangentialField& r,
                            contact::TangentialField& z) const override {
        const auto& s = under(layer);
        bare().template apply<2, 2>({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}}, {r.x, r.y}, {z.x, z.y});
    }
    void displacements(const Bodies& bodies, const contact::SurfaceField& t,
                       std::span<contact::SurfaceField> u) const override {
        if constexpr (std::is_same_v<Convolution, MirroredConvolution>) {
            std::vector<GridConvolution::Kernels<1, 1>> normal;
            std::vector<GridConvolution::Kernels<2, 2>> tangential;
            std::vector<GridConvolution::Fields<1>> down;
            std::vector<GridConvolution::Fields<2>> in_surface;
            for (std::size_t m = 0; m < bodies.size(); ++m) {
                const auto& body = static_cast<const ProductsBy&>(*bodies[m]);
                const auto& s = body.rest().tangential;
                normal.push_back({{{&body.normal_symbols().normal}}});
                tangential.push_back({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}});
                down.push_back({u[m].down});
                in_surface.push_back({u[m].in_surface.x, u[m].in_surface.y});
            }
            convolution_.template apply_each<1, 1>(normal, {t.down}, down);
            convolution_.template apply_each<2, 2>(tangential, {t.in_surface.x, t.in_surface.y},
                                                   in_surface);
        } else {
            for (std::size_t m = 0; m < bodies.size(); ++m) {
                bodies[m]->normal(t.down, u[m].down);
                bodies[m]->tangential(t.in_surface, u[m].in_surface);
            }
        }
    }
    void precondition_normal(std::span<const double> r, std::span<double> z) const override {
        bare().template apply<1, 1>({{{&normal_symbols().inverse}}}, {r}, {z});
    }

  private:
    const Convolution& bare() const { return bare_ ? *bare_ : convolution_; }
    const TangentialSymbols& rest() const {
        if (!rest_) rest_ = make_rest_(convolution_, bare());
        return *rest_;
    }
    /// The inverse of the symbol and the layer's, which has the factor of all symbols.
    const GridConvolution::Symbol2& under(contact::LayerCompliance layer) const {
        if (std::is_same_v<Convolution, MirroredConvolution>) layer.xy = 0;
        if (under_.xx.empty() || layer != layer_) {
            layer_ = layer;
            const double factor = 1. / bare().period_x() / bare().period_y();
            under_ = inverse_under({factor * layer.xx, factor * layer.xy, factor * layer.yy},
                                   rest().inverse, bare().n_threads());
        }
        return under_;
    }
    const NormalSymbols& normal_symbols() const {
        if (make_normal_ && normal_.normal.empty()) normal_ = make_normal_(convolution_, bare());
        return normal_;
    }

    Convolution convolution_;
    std::optional<Convolution> bare_;
    mutable NormalSymbols normal_;
    Make<NormalSymbols> make_normal_;
    mutable std::unique_ptr<const NormalLevel> normal_level_;  // once asked for
    MakeSymbols make_rest_;
    mutable std::optional<TangentialSymbols> rest_;
    mutable contact::LayerCompliance layer_;
    mutable GridConvolution::Symbol2 under_;  // the last layer
};

}  // namespace tricontact::bem
