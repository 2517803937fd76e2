#pragma once
// The scene and the query, as every report on a query states them.

#include <nlohmann/json.hpp>

#include "provis/result_file.hpp"

namespace provis {

nlohmann::ordered_json scene_json(const ResultHeader& header);
nlohmann::ordered_json query_json(const ResultHeader& header);

}  // namespace provis
