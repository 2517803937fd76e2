#include "src/report/names.hpp"

#include <initializer_list>

namespace provis {

namespace {

template <class Enum>
std::optional<Enum> named(std::string_view word, std::initializer_list<Enum> all) {
  for (Enum value : all) {
    if (name(value) == word) return value;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(Projection projection) {
  switch (projection) {
    case Projection::pinhole:
      return "pinhole";
    case Projection::parallel:
      return "parallel";
    case Projection::omni:
      return "omni";
  }
  return "unknown";
}

std::string_view name(Sides sides) { return sides == Sides::both ? "both" : "material"; }

std::string_view name(Opacity opacity) { return opacity == Opacity::all ? "all" : "material"; }

std::string_view name(Method method) {
  switch (method) {
    case Method::exact:
      return "exact";
    case Method::aggressive:
      return "aggressive";
    case Method::sampled:
      return "sampled";
  }
  return "unknown";
}

std::string_view name(PointEngine engine) { return engine == PointEngine::paper ? "paper" : "fast"; }

std::string flags_text(std::uint8_t flags) {
  return std::string((flags & single_sided) != 0 ? "single-sided, " : "two-sided, ") +
         ((flags & see_through) != 0 ? "see-through" : "opaque");
}

std::optional<Projection> projection_named(std::string_view word) {
  return named(word, {Projection::pinhole, Projection::parallel, Projection::omni});
}

std::optional<Sides> sides_named(std::string_view word) {
  return named(word, {Sides::material, Sides::both});
}

std::optional<Opacity> opacity_named(std::string_view word) {
  return named(word, {Opacity::material, Opacity::all});
}

std::optional<Arithmetic> arithmetic_named(std::string_view word) {
  return named(word, {Arithmetic::chain, Arithmetic::doubles, Arithmetic::mpfr, Arithmetic::exact});
}

std::optional<Method> method_named(std::string_view word) {
  return named(word, {Method::exact, Method::aggressive, Method::sampled});
}

std::optional<PointEngine> engine_named(std::string_view word) {
  return named(word, {PointEngine::fast, PointEngine::paper});
}

std::optional<Guarantee> guarantee_named(std::string_view word) {
  return named(word, {Guarantee::exact, Guarantee::aggressive, Guarantee::conservative, Guarantee::bounds,
                      Guarantee::sampled});
}

}  // namespace provis
