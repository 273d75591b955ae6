#include "io/case/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Roughness;

template <auto member>
Field of_roughness(Case& c) {
    return in(c.indenter.roughness, member);
}

template <auto member>
void add_wavelength(std::vector<CaseKey>& keys, std::string_view path, std::string_view example,
                    std::string_view text) {
    keys.push_back({length_key(path, example, text, {.required = true}), of_roughness<member>});
}

}  // namespace

void add_roughness_keys(std::vector<CaseKey>& keys) {
    keys.push_back(
        {number_key("indenter.roughness.hurst", {0, 1}, "0.8",
                    "Hurst exponent H: the power spectral density falls as q^(-2(1 + H))",
                    {.default_value = "0.8"}),
         of_roughness<&Roughness::hurst>});
    keys.push_back({number_key("indenter.roughness.rms_slope", above_zero(10), "0.1",
                               "root mean square of the gradient", {.required = true}),
                    of_roughness<&Roughness::rms_slope>});
    add_wavelength<&Roughness::long_wavelength>(
        keys, "indenter.roughness.long_wavelength", R"("1 mm")",
        "longest wavelength, after which the roughness repeats itself");
    add_wavelength<&Roughness::roll_off>(
        keys, "indenter.roughness.roll_off", R"("0.25 mm")",
        "wavelength of the roll-off: longer waves have the spectral density of this one");
    add_wavelength<&Roughness::short_wavelength>(keys, "indenter.roughness.short_wavelength",
                                                 R"("62.5 um")", "shortest wavelength");
    keys.push_back({integer_key("indenter.roughness.seed", {0, 2147483647}, "1",
                                "of the random phases", {.default_value = "1"}),
                    of_roughness<&Roughness::seed>});
}

}  // namespace tricontact::io
