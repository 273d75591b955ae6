#include "benchmarks/decks/getfem_words.h"

#include <cctype>

namespace tricontact::benchmarks {

namespace {

constexpr const char* getfem_plane = "la*Div_u*Div_Test_u + 2*mu*(Sym(Grad_u):Sym(Grad_Test_u))";
constexpr const char* getfem_axisymmetric =
    "2*pi*X(1)*(la*(Div_u + u(1)/X(1))*(Div_Test_u + Test_u(1)/X(1))'\n"
    "                   ' + 2*mu*(Sym(Grad_u):Sym(Grad_Test_u) + u(1)*Test_u(1)/sqr(X(1))))";

}  // namespace

const char* getfem_elasticity(const DeckModel& model) {
    return model.shape == DeckModel::Shape::plane ? getfem_plane : getfem_axisymmetric;
}

std::string with_radius(const std::string& formula, const std::string& expression) {
    std::string text;
    for (std::size_t i = 0; i < formula.size(); ++i) {
        const bool is_radius =
            formula[i] == 'r' &&
            (i == 0 || !std::isalpha(static_cast<unsigned char>(formula[i - 1]))) &&
            (i + 1 == formula.size() || !std::isalpha(static_cast<unsigned char>(formula[i + 1])));
        text += is_radius ? expression : std::string(1, formula[i]);
    }
    return text;
}

}  // namespace tricontact::benchmarks
