#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/compliances/interior.h"

namespace tricontact::contact {

/// A field of three components on the contact points: in the surface, and into the substrate.
struct SurfaceField {
    TangentialField in_surface;
    std::vector<double> down;

    SurfaceField() = default;
    explicit SurfaceField(std::size_t n, int n_threads = 1)
        : in_surface(n, n_threads), down(large_field(n, n_threads)) {}
    SurfaceField(TangentialField surface, std::vector<double> downward)
        : in_surface(std::move(surface)), down(std::move(downward)) {}
    SurfaceField(const SurfaceField& other)
        : in_surface(other.in_surface), down(large_copy(other.down)) {}
    SurfaceField& operator=(const SurfaceField& other) {
        in_surface = other.in_surface;
        copy_large(other.down, down);
        return *this;
    }
    SurfaceField(SurfaceField&&) = default;
    SurfaceField& operator=(SurfaceField&&) = default;
    ~SurfaceField() = default;
};
/// Pointers to the three components of a (constant or variable) SurfaceField.
template <class Field>
auto components(Field& field) {
    return std::array{&field.in_surface.x, &field.in_surface.y, &field.down};
}

/// What lies below the contact: a compliance, and what it remembers of the past. A step takes it
/// for an elastic one that was displaced beforehand: tractions t [Pa] and displacements u [m] at
/// the step's end obey
///   A t = stiffness u + offset,   A = compliance().
class Substrate {
  public:
    virtual ~Substrate() = default;

    /// The same body with nothing remembered; not `coupled`: normal tractions displace normally
    /// alone.
    virtual std::unique_ptr<Substrate> fresh(bool coupled) const = 0;
    /// Nothing was remembered, the next step starts from rest.
    virtual void forget() = 0;
    /// The same loads may displace it otherwise another time.
    virtual bool relaxes() const { return true; }

    /// Begins a step of this duration [s] from the tractions `t` [Pa] and displacements `u` [m],
    /// which stay as they are until end(). True when `compliance` is another one than before.
    virtual bool begin(double duration, const SurfaceField& t, const SurfaceField& u) = 0;
    virtual const Compliance& compliance() const = 0;  ///< of the step: the same object always
    virtual double stiffness() const = 0;              ///< of the step [-]
    virtual const SurfaceField& offset() const = 0;    ///< [m]; empty: none
    /// That of the relaxed state, where lengths and forces are compared with it.
    virtual const Compliance& relaxed() const { return compliance(); }

    /// Integrals over the step [J].
    struct Energies {
        double stored = 0;      ///< elastic, at its end
        double dissipated = 0;  ///< by the material, in the step
        double work = 0;        ///< of the tractions on the surface, in the step
        double magnitude = 0;   ///< sum of the terms' magnitudes, which rounding goes with
    };
    /// Before a step, on a grid: what it remembers moves by one cell, see contact::advect().
    void advect();
    /// Ends the step with these tractions [Pa] and displacements [m].
    virtual Energies end(const SurfaceField& t, const SurfaceField& u) = 0;

    /// What it looks like inside; null if unavailable. `t` as in end().
    virtual std::unique_ptr<const Interior> interior(const SurfaceField& t) const = 0;

    /// What it remembers, written or read: `archive` is a StateWriter or a StateReader.
    template <class Archive>
    void transfer(Archive& archive) {
        for (SurfaceField* field : memory())
            for (auto* component : components(*field)) archive(*component);
    }

  private:
    /// All fields that it remembers.
    virtual std::vector<SurfaceField*> memory() { return {}; }
};

/// Remembers nothing. Work by the trapezoidal rule, exact for a self-adjoint compliance.
class ElasticSubstrate final : public Substrate {
  public:
    explicit ElasticSubstrate(std::shared_ptr<const Compliance> compliance);

    std::unique_ptr<Substrate> fresh(bool) const override {
        return std::make_unique<ElasticSubstrate>(compliance_);
    }
    void forget() override {}
    bool relaxes() const override { return false; }
    bool begin(double duration, const SurfaceField& t, const SurfaceField& u) override;
    const Compliance& compliance() const override { return *compliance_; }
    double stiffness() const override { return 1; }
    const SurfaceField& offset() const override { return none_; }
    Energies end(const SurfaceField& t, const SurfaceField& u) override;
    std::unique_ptr<const Interior> interior(const SurfaceField& t) const override {
        return compliance_->interior(t.down, t.in_surface);
    }

  private:
    std::shared_ptr<const Compliance> compliance_;
    SurfaceField none_;                                                 // empty
    const SurfaceField *traction_ = nullptr, *displacement_ = nullptr;  // before the step
};

/// Where a step of one cell evaluates what an indenter that rotates slides by: this part of a cell
/// ahead of the cell's centre. Displacements change between (x + h) and x, their rate belongs to
/// x + h/2; but cells of constant traction whose slip is prescribed there act as a contact whose
/// edges are delta h farther out, all of it h/4 farther ahead. Of a strip that sticks, the force of
/// a spin is then that of slip prescribed by 1/4 - delta of a cell ahead, to the second order in h:
///   delta = 1/pi int_0^pi -ln rho(q)/(4 sin^2(q/2)) dq,
///   rho(q) = 4 sin^2(q/2) sum_m (-1)^m sgn(m + 0) (q + 2 pi m)^-2,
/// rho the symbol of the cells over that of line loads (docs/explanation/rolling.md derives it).
inline constexpr double spin_point = 0.174653;

/// Throws InputError, `model` its subject, unless the points form a grid on both sides of the path
/// with an edge.
void check_rolls_on(const std::string& model, const ContactPoints& points);

/// The frame of coordinates moves on along x by one cell of the grid: what was one cell ahead is
/// here now. What enters at the leading edge is like the cell behind it, which is to be far from
/// the contact.
void advect(const ContactPoints& grid, std::vector<double>& field);
void advect(const ContactPoints& grid, SurfaceField& field);

}  // namespace tricontact::contact
