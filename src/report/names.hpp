#pragma once
// Enumerations as the words that result files and the command line use for them, both ways.

#include <optional>
#include <string>
#include <string_view>

#include "provis/arithmetic.hpp"
#include "provis/point.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

std::string_view name(Projection projection);
std::string_view name(Sides sides);
std::string_view name(Opacity opacity);
std::string_view name(Method method);
std::string_view name(PointEngine engine);

/// "single-sided, see-through", of PrimitiveFlag bits.
std::string flags_text(std::uint8_t flags);

/// The enumerator of that name, or nothing.
std::optional<Projection> projection_named(std::string_view word);
std::optional<Sides> sides_named(std::string_view word);
std::optional<Opacity> opacity_named(std::string_view word);
std::optional<Arithmetic> arithmetic_named(std::string_view word);
std::optional<Method> method_named(std::string_view word);
std::optional<PointEngine> engine_named(std::string_view word);
std::optional<Guarantee> guarantee_named(std::string_view word);

}  // namespace provis
