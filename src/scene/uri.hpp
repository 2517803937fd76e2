#pragma once
// URIs of buffers: data: URIs, and relative paths that stay inside the scene's folder.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "src/scene/file_bytes.hpp"

namespace provis {

/// The bytes of a data: URI; nullopt if it is none.
///
/// Throws:     Error::invalid_input for bad base64
std::optional<Bytes> data_uri_bytes(std::string_view uri, const std::string& place);

/// The file that a relative URI names.
///
/// Guarantee:  the path lies inside the folder after every symbolic link was followed
/// Throws:     Error::invalid_input for an absolute path, "..", another scheme, or a link that leads out
std::filesystem::path file_in_folder(std::string_view uri, const std::filesystem::path& folder,
                                     const std::string& place);

}  // namespace provis
