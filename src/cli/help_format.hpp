#pragma once
// How --help looks.

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace provis {

/// An option's name and its kind of value on the left, its text on the right, wrapped to 100 columns.
/// What excludes what is left to the texts and to the error messages.
std::shared_ptr<CLI::FormatterBase> help_format();

}  // namespace provis
