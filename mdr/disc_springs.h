#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contact/substrates/material.h"
#include "mdr/plane_profile.h"
#include "theory/adhesive/adhesive_curve.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::mdr {

/// Springs in the contact of one radius a, which ends between two of them: at the midpoints of
/// equal pieces of [-a, a], of which the right half is kept. The midpoint rule is of the order of
/// the square of their distance.
class DiscSprings {
  public:
    virtual ~DiscSprings() = default;
    /// Pressed by the profile until the edge carries nothing, and as a punch.
    virtual theory::DiscContact at(double radius) const = 0;
    /// q [N/m] at (i + 1/2) a/n under the profile at this depth [m].
    virtual std::vector<double> loads(double radius, double depth) const = 0;
    /// E* [Pa].
    virtual double modulus() const = 0;
};

/// Independent ones of a half-space.
class FreeDiscSprings final : public DiscSprings {
  public:
    /// `n_springs` >= 2 in all of the contact.
    FreeDiscSprings(std::shared_ptr<const PlaneProfile> profile, double modulus, int n_springs)
        : profile_(std::move(profile)), modulus_(modulus), n_(n_springs / 2) {}
    theory::DiscContact at(double radius) const override;
    std::vector<double> loads(double radius, double depth) const override;
    double modulus() const override { return modulus_; }

  private:
    std::shared_ptr<const PlaneProfile> profile_;
    double modulus_;
    int n_;
};

/// Those that a layer couples by its kernel, see LayerKernel.
class LayerDiscSprings final : public DiscSprings {
  public:
    /// `elements` in the radius, of layers thinner than a/25 as many as make as short ones against
    /// the thickness. `indenter` empty: rigid. Throws contact::InputError for layers out of range.
    LayerDiscSprings(std::shared_ptr<const PlaneProfile> profile, theory::LayerStack stack,
                     const std::optional<contact::Material>& indenter, int elements);
    theory::DiscContact at(double radius) const override;
    std::vector<double> loads(double radius, double depth) const override;
    double modulus() const override { return modulus_; }

  private:
    struct System;
    System system(double radius) const;
    double kernel(double distance) const;

    std::shared_ptr<const PlaneProfile> profile_;
    theory::LayerStack stack_;
    double modulus_, share_;  // E* of the contact [Pa], over that of the layer alone
    int elements_;
    // K at the distances 0, spacing, ...; longer as wider contacts ask for it.
    double table_spacing_;
    mutable std::vector<double> table_;
};

}  // namespace tricontact::mdr
