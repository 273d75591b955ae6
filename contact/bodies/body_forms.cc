#include "contact/bodies/body_forms.h"

#include <array>

namespace tricontact::contact {

namespace {

using Shape = IndenterData::Shape;
using Support = ElasticBody::Support;

/// In the order of ElasticBody::Support.
struct SupportWords {
    std::string_view word;
    const char* title;
};
constexpr std::array supports{
    SupportWords{"holder", "a rigid holder"}, SupportWords{"plates", "a second plate"},
    SupportWords{"hub", "a rigid hub"}, SupportWords{"force", "the contact alone, under a force"},
    SupportWords{"pressure", "the contact alone, under a pressure"}};

const std::vector<BodyForm>& forms() {
    static const std::vector<BodyForm> all{
        {.word = "hemisphere",
         .title = "hemisphere",
         .shapes = {Shape::paraboloid, Shape::sphere},
         .supports = {Support::holder, Support::pressure}},
        {.word = "ball",
         .title = "ball",
         .shapes = {Shape::paraboloid, Shape::sphere},
         .supports = {Support::plates, Support::hub}},
        {.word = "cylinder",
         .title = "cylinder",
         .shapes = {Shape::cylinder},
         .supports = {Support::plates, Support::hub}},
        {.word = "punch",
         .title = "punch",
         .shapes = {Shape::rounded_punch},
         .supports = {Support::holder, Support::pressure},
         .has_height = true},
        {.word = "pin", .title = "pin", .shapes = {Shape::cylinder}, .supports = {Support::hub}},
        {.word = "block",
         .title = "block",
         .shapes = {Shape::flat_punch},
         .supports = {Support::holder, Support::force, Support::pressure},
         .has_height = true},
        {.word = "",
         .title = "mesh",
         .shapes = {Shape::paraboloid, Shape::sphere, Shape::ellipsoid},
         .supports = {Support::holder}}};
    return all;
}

}  // namespace

std::span<const BodyForm> body_forms() {
    return forms();
}

const BodyForm& body_form(ElasticBody::Form form) {
    return forms().at(static_cast<std::size_t>(form));
}

std::string_view word_of(Support support) {
    return supports.at(static_cast<std::size_t>(support)).word;
}

const char* title_of(Support support) {
    return supports.at(static_cast<std::size_t>(support)).title;
}

}  // namespace tricontact::contact
