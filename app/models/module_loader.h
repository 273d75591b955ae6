#pragma once

#include <string>

namespace tricontact::app {

/// A symbol of a module, a part of the program that is loaded when first needed. `what`: the module
/// for people; `file`: its name, beside the program or where it was installed. Throws
/// std::runtime_error where it is not there.
void* module_symbol(const std::string& what, const char* file, const char* symbol);

}  // namespace tricontact::app
