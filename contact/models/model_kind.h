#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace tricontact::contact {

/// Accuracy of the steps of springs that a layer couples [-].
inline constexpr double layer_springs_accuracy = 1e-9;

/// Names by which case files ask for a model, for code that runs one of them. What follows from a
/// model is asked of its row, model_kind(): nowhere else is a name compared.
namespace models {
inline constexpr const char* mdr = "mdr";
inline constexpr const char* mdr_layer = "mdr-layer";
inline constexpr const char* bem = "bem";
inline constexpr const char* bem_layer = "bem-layer";
inline constexpr const char* fem = "fem";
inline constexpr const char* fem_plane = "fem-plane";
inline constexpr const char* fem_axisymmetric = "fem-axisymmetric";
inline constexpr const char* atlas = "atlas";
}  // namespace models

/// What a model assumes and how it computes: a row of the table of models. Whoever adds a model
/// adds its row in model_kind.cc, and its maker in app/models/make_model.cc.
struct ModelKind {
    enum class Method {
        independent_springs,
        coupled_springs,
        boundary_elements,
        finite_elements,
        maps,  ///< reads what others computed
        other  ///< a model that is not in the table
    };
    /// `any`: what the case has.
    enum class Body { half_space, layer, any };
    /// Of finite elements in two dimensions: across a body along y, which is in plane strain, or
    /// through the axis of one of revolution, which is pressed along it.
    enum class Cut { none, plane_strain, of_revolution };

    const char* name;     ///< in case files, results and folders
    const char* title;    ///< for readers: "BEM layer"
    const char* text;     ///< what it is
    const char* sources;  ///< publications, cited by authors and year
    Method method = Method::other;
    Body body = Body::any;
    Cut cut = Cut::none;
    std::optional<int> style;  ///< number of its colour in figures

    /// Of the limit by bisection, in f_T or w [-], unless it is asked for.
    double limit_tolerance = 1e-3;
    /// Steps have no solver that stops: sticking and sliding as a whole are told apart however
    /// close F_T is to mu F_N.
    bool steps_are_exact = false;
    /// Errors fall with the size of its elements in some order.
    bool converges_in_order = true;

    const char* section = "";        ///< of the case file, its settings: "bem"
    const char* resolution = "";     ///< key of its resolution; empty: it has none
    const char* why_no_levels = "";  ///< then: why no level is finer

    bool keeps_journal = false;    ///< its steps take long: a run that was killed goes on
    bool is_costly = false;        ///< no further runs beside it but those of its own error
    bool has_many_states = false;  ///< rolling on: too many for each to be a file for ParaView

    bool couples = true;      ///< normal and tangential contact, where the bodies do
    bool sees_sides = false;  ///< of a layer of finite width and depth
    bool sees_finite_strains = false;
    bool sees_elastic_indenter = true;  ///< as a half-space
    bool sees_indenter_body = false;    ///< of finite size
    bool sees_rigid_substrate = false;
    bool sees_elastic_interface = false;
    bool sees_adhesion = false;
    bool sees_period = false;  ///< contacts that repeat
    bool sees_roughness = false;
    bool rolls_on = false;
    bool reads_influence = false;  ///< computes with influence coefficients of a file

    /// The model whose maps stand for it; its own name where `tricontact predict` reads them.
    const char* maps = "";

    bool is_half_space() const { return body == Body::half_space; }
    bool is_layer() const { return body == Body::layer; }
    /// Springs along a line, which have no direction across and map bodies of revolution only.
    bool is_on_line() const {
        return method == Method::independent_springs || method == Method::coupled_springs;
    }
    bool is_independent() const { return method == Method::independent_springs; }
    bool is_on_cells() const { return method == Method::boundary_elements; }
    bool is_on_cells_of(Body its) const { return is_on_cells() && body == its; }
    bool is_meshed() const { return method == Method::finite_elements; }
    bool is_section() const { return cut != Cut::none; }
    bool is_read() const { return method == Method::maps; }
    bool has_maps() const { return *maps && std::string_view(maps) == name; }
};

/// Rows in the order in which they are shown: springs first, what assumes least last.
std::span<const ModelKind> model_kinds();
/// Null for what is no model of the table.
const ModelKind* find_model_kind(std::string_view name);
/// Of models that are not in the table, those of programs that use the libraries, a row that
/// assumes nothing.
const ModelKind& model_kind(std::string_view name);

/// Whether this section of a case file holds the settings of a model.
bool is_model_section(std::string_view section);

}  // namespace tricontact::contact
