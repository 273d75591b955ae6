#include "contact/models/model_kind.h"

#include <algorithm>
#include <array>

namespace tricontact::contact {

namespace {

using Method = ModelKind::Method;
using Body = ModelKind::Body;
using Cut = ModelKind::Cut;

constexpr std::array kinds{
    ModelKind{.name = models::mdr,
              .title = "MDR",
              .text = "method of dimensionality reduction: a bed of independent springs, stepped "
                      "exactly",
              .sources = "Popov and Hess (2015), Wetter and Popov (2014)",
              .method = Method::independent_springs,
              .body = Body::half_space,
              .style = 0,
              .limit_tolerance = 1e-6,
              .steps_are_exact = true,
              .converges_in_order = false,
              .section = "mdr",
              .resolution = "mdr.springs",
              .has_many_states = true,
              .couples = false,
              .sees_rigid_substrate = true,
              .sees_elastic_interface = true,
              .sees_adhesion = true,
              .rolls_on = true,
              .maps = models::mdr},
    ModelKind{.name = models::mdr_layer,
              .title = "MDR layer",
              .text = "method of dimensionality reduction of the elastic layer: springs coupled by "
                      "the layer",
              .sources = "Popov and Hess (2015), Lebedev and Ufliand (1958)",
              .method = Method::coupled_springs,
              .body = Body::layer,
              .style = 4,
              .converges_in_order = false,
              .section = "mdr",
              .resolution = "mdr.elements_per_radius",
              .couples = false,
              .sees_elastic_interface = true,
              .sees_adhesion = true},
    ModelKind{.name = models::bem,
              .title = "BEM",
              .text = "boundary elements on the elastic half-space, FFT convolution",
              .sources = "Boussinesq (1885), Cerruti (1882), Love (1929), Ju and Farris (1996), "
                         "Liu, Wang and Liu (2000), Polonsky and Keer (1999), Frigo and Johnson "
                         "(2005)",
              .method = Method::boundary_elements,
              .body = Body::half_space,
              .style = 1,
              .section = "bem",
              .resolution = "bem.spacing",
              .sees_rigid_substrate = true,
              .sees_elastic_interface = true,
              .sees_adhesion = true,
              .sees_period = true,
              .sees_roughness = true,
              .rolls_on = true,
              .reads_influence = true,
              .maps = models::bem},
    ModelKind{.name = models::bem_layer,
              .title = "BEM layer",
              .text = "boundary elements on the elastic layer, FFT convolution",
              .sources = "Boussinesq (1885), Cerruti (1882), Love (1929), Ju and Farris (1996), "
                         "Liu, Wang and Liu (2000), Polonsky and Keer (1999), Frigo and Johnson "
                         "(2005), Sneddon (1951), Panagiotopoulos (1975), Anderson (1965)",
              .method = Method::boundary_elements,
              .body = Body::layer,
              .style = 2,
              .section = "bem",
              .resolution = "bem.spacing",
              .sees_elastic_interface = true,
              .sees_adhesion = true,
              .sees_period = true,
              .sees_roughness = true,
              .rolls_on = true,
              .reads_influence = true,
              .maps = models::bem_layer},
    ModelKind{.name = models::fem,
              .title = "FEM",
              .text = "finite elements of the elastic layer, condensed to the contact patch",
              .sources = "Brezzi and Fortin (1991), Panagiotopoulos (1975), Anderson (1965), Arndt "
                         "et al. (2022), Chen, Davis, Hager and Rajamanickam (2008), Karypis and "
                         "Kumar (1998), Geuzaine and Remacle (2009)",
              .method = Method::finite_elements,
              .body = Body::layer,
              .style = 3,
              .section = "fem",
              .resolution = "fem.size",
              .keeps_journal = true,
              .is_costly = true,
              .sees_sides = true,
              .sees_finite_strains = true,
              .sees_elastic_indenter = false,
              .sees_indenter_body = true,
              .sees_rigid_substrate = true,
              .sees_elastic_interface = true,
              .sees_adhesion = true,
              .rolls_on = true,
              .maps = models::bem_layer},
    ModelKind{.name = models::fem_plane,
              .title = "FEM plane strain",
              .text = "finite elements of the section of bodies along y, in plane strain; both may "
                      "deform",
              .sources = "Brezzi and Fortin (1991), Chen, Davis, Hager and Rajamanickam (2008), "
                         "Karypis and Kumar (1998)",
              .method = Method::finite_elements,
              .cut = Cut::plane_strain,
              .style = {},
              .section = "fem",
              .resolution = "fem.size",
              .sees_indenter_body = true,
              .sees_rigid_substrate = true,
              .rolls_on = true},
    ModelKind{.name = models::fem_axisymmetric,
              .title = "FEM of revolution",
              .text = "finite elements of the section of bodies of revolution, pressed along their "
                      "axis; both may deform",
              .sources = "Brezzi and Fortin (1991), Chen, Davis, Hager and Rajamanickam (2008), "
                         "Karypis and Kumar (1998)",
              .method = Method::finite_elements,
              .cut = Cut::of_revolution,
              .style = {},
              .section = "fem",
              .resolution = "fem.size",
              .sees_indenter_body = true,
              .sees_rigid_substrate = true,
              .sees_adhesion = true},
    ModelKind{.name = models::atlas,
              .title = "ATLAS",
              .text = "maps of earlier runs, in sweeps; tricontact predict reads them elsewhere",
              .sources = "Blatman and Sudret (2011)",
              .method = Method::maps,
              .body = Body::any,
              .style = {},
              .why_no_levels = "has no resolution"},
};

constexpr ModelKind of_another_program{
    .name = "", .title = "", .text = "", .sources = "", .style = {}};

}  // namespace

std::span<const ModelKind> model_kinds() {
    return kinds;
}

const ModelKind* find_model_kind(std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &ModelKind::name);
    return found == kinds.end() ? nullptr : &*found;
}

const ModelKind& model_kind(std::string_view name) {
    const ModelKind* kind = find_model_kind(name);
    return kind ? *kind : of_another_program;
}

bool is_model_section(std::string_view section) {
    return !section.empty() && std::ranges::count(kinds, section, &ModelKind::section) > 0;
}

}  // namespace tricontact::contact
