#include "src/scene/uri.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// A '%' that no two hexadecimal digits follow stands for itself, as browsers take it.
std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape =
        text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
    if (escape) {
      decoded += static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

/// Without the white space that some exporters break long lines with, and padded to whole groups.
std::string tidy_base64(std::string_view text, const std::string& place) {
  std::string tidy;
  std::ranges::copy_if(text, std::back_inserter(tidy), [](unsigned char c) { return std::isspace(c) == 0; });
  while (!tidy.empty() && tidy.back() == '=') tidy.pop_back();
  const auto stray = std::ranges::find_if(
      tidy, [](unsigned char c) { return std::isalnum(c) == 0 && c != '+' && c != '/'; });
  if (stray != tidy.end())
    fail_invalid(place, fmt::format("character {} of the base64 data is none", stray - tidy.begin()));
  if (tidy.size() % 4 == 1 || tidy.size() > std::size_t{std::numeric_limits<int>::max()} - 4)
    fail_invalid(place, fmt::format("{} characters are no base64 data", tidy.size()));
  return tidy;
}

Bytes base64_decoded(std::string_view text, const std::string& place) {
  std::string tidy = tidy_base64(text, place);
  const std::size_t size = tidy.size() / 4 * 3 + (tidy.size() % 4 == 0 ? 0 : tidy.size() % 4 - 1);
  tidy.append((4 - tidy.size() % 4) % 4, '=');
  Bytes bytes(tidy.size() / 4 * 3 + 1);
  const int decoded = EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(tidy.data()),
                                      static_cast<int>(tidy.size()));
  if (decoded < 0) fail_invalid(place, "bad base64 data");
  bytes.resize(size);
  return bytes;
}

bool starts_with_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  return std::ranges::all_of(uri.substr(0, colon), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
  });
}

bool climbs(std::string_view path) {
  std::string forward(path);
  std::ranges::replace(forward, '\\', '/');
  return std::ranges::any_of(std::filesystem::path(forward), [](const auto& part) { return part == ".."; });
}

std::string shortened(std::string_view uri) {
  return uri.size() <= 60 ? std::string(uri) : std::string(uri.substr(0, 57)) + "...";
}

}  // namespace

std::optional<Bytes> data_uri_bytes(std::string_view uri, const std::string& place) {
  if (!uri.starts_with("data:")) return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) fail_invalid(place, "a data: URI without a comma");
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) return base64_decoded(data, place);
  const std::string text = percent_decoded(data);
  return Bytes(text.begin(), text.end());
}

std::filesystem::path file_in_folder(std::string_view uri, const std::filesystem::path& folder,
                                     const std::string& place) {
  const std::string path = percent_decoded(uri);
  const bool leaves =
      path.starts_with('/') || path.starts_with('\\') || starts_with_scheme(path) || climbs(path);
  if (path.empty() || path.find('\0') != std::string::npos) fail_invalid(place, "no file name");
  if (leaves) fail_invalid(place, fmt::format("\"{}\" leaves the scene's folder", shortened(uri)));

  std::error_code error;
  const auto inside = std::filesystem::canonical(folder.empty() ? "." : folder, error);
  const auto file = std::filesystem::weakly_canonical(inside / path, error);
  const auto [end, unused] = std::mismatch(inside.begin(), inside.end(), file.begin(), file.end());
  if (error || end != inside.end())
    fail_invalid(place, fmt::format("\"{}\" leaves the scene's folder", shortened(uri)));
  return file;
}

}  // namespace provis
