#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "contact/bodies/indenter_data.h"

namespace tricontact::contact {

/// A row of the table of bodies that deform. Whoever adds one adds its row at the end, and its mesh
/// to the models that mesh it.
struct BodyForm {
    std::string_view word;  ///< of indenter.body in case files; empty: a file says what it is
    const char* title;      ///< for readers
    std::vector<IndenterData::Shape> shapes;     ///< whose surface it may have
    std::vector<ElasticBody::Support> supports;  ///< by which it may be held
    bool has_height = false;                     ///< indenter.height says how high it is
};

/// In the order of ElasticBody::Form.
std::span<const BodyForm> body_forms();
const BodyForm& body_form(ElasticBody::Form form);

/// "holder" and the like, as in case files.
std::string_view word_of(ElasticBody::Support support);
/// The same for readers: "a rigid holder".
const char* title_of(ElasticBody::Support support);

}  // namespace tricontact::contact
