#include "io/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Roughness;
using Kind = Key::Kind;

template <auto member>
Field of_roughness(Case& c) {
    return in(c.indenter.roughness, member);
}

template <auto member>
void add_wavelength(std::vector<CaseKey>& keys, std::string_view path, std::string_view example,
                    std::string_view text) {
    keys.push_back({{.path = path,
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = example,
                     .text = text},
                    of_roughness<member>});
}

}  // namespace

void add_roughness_keys(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "indenter.roughness.hurst",
                     .kind = Kind::number,
                     .range = {0, 1},
                     .default_value = "0.8",
                     .example = "0.8",
                     .text = "Hurst exponent H: the power spectral density falls as q^(-2(1 + H))"},
                    of_roughness<&Roughness::hurst>});
    keys.push_back({{.path = "indenter.roughness.rms_slope",
                     .kind = Kind::number,
                     .range = above_zero(10),
                     .required = true,
                     .example = "0.1",
                     .text = "root mean square of the gradient"},
                    of_roughness<&Roughness::rms_slope>});
    add_wavelength<&Roughness::long_wavelength>(
        keys, "indenter.roughness.long_wavelength", R"("1 mm")",
        "longest wavelength, after which the roughness repeats itself");
    add_wavelength<&Roughness::roll_off>(
        keys, "indenter.roughness.roll_off", R"("0.25 mm")",
        "wavelength of the roll-off: longer waves have the spectral density of this one");
    add_wavelength<&Roughness::short_wavelength>(keys, "indenter.roughness.short_wavelength",
                                                 R"("62.5 um")", "shortest wavelength");
    keys.push_back({{.path = "indenter.roughness.seed",
                     .kind = Kind::integer,
                     .range = {0, 2147483647},
                     .default_value = "1",
                     .example = "1",
                     .text = "of the random phases"},
                    of_roughness<&Roughness::seed>});
}

}  // namespace tricontact::io
