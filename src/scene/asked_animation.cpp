#include "src/scene/asked_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

using enum JsonKind;

constexpr JsonMember channel_members[] = {{"sampler", index, true}};
constexpr JsonMember target_members[] = {{"node", index}, {"path", text, true}};
constexpr JsonMember sampler_members[] = {
    {"input", index, true}, {"output", index, true}, {"interpolation", text}};

std::string name_of(const Json& animation) {
  const Json* name = find_member(animation, "name");
  return name != nullptr && name->is_string() ? name->get<std::string>() : std::string();
}

/// What --animation can be told; long lists are cut.
std::string offered(const Json& animations) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < animations.size() && i < most; ++i)
    list += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, name_of(animations[i]));
  if (animations.size() > most) list += fmt::format(" and {} more", animations.size() - most);
  return list;
}

[[noreturn]] void fail_usage(const char* option, const std::string& what) {
  throw Error(Error::Code::usage, option, what);
}

std::size_t choose(const Json& animations, const std::string& asked) {
  if (asked.empty()) return 0;
  std::vector<std::size_t> named;
  for (std::size_t i = 0; i < animations.size(); ++i)
    if (name_of(animations[i]) == asked) named.push_back(i);
  if (named.size() == 1) return named[0];
  if (named.size() > 1)
    fail_usage("--animation", fmt::format("{} animations are called \"{}\"; name one by its index: {}",
                                          named.size(), asked, offered(animations)));
  std::size_t position = 0;
  const char* const end = asked.data() + asked.size();
  const auto [rest, error] = std::from_chars(asked.data(), end, position);
  if (error == std::errc() && rest == end && position < animations.size()) return position;
  fail_usage("--animation", fmt::format("there is no \"{}\", but {}", asked, offered(animations)));
}

std::optional<NodeProperty> property_of(const std::string& path) {
  if (path == "translation") return NodeProperty::translation;
  if (path == "rotation") return NodeProperty::rotation;
  if (path == "scale") return NodeProperty::scale;
  if (path == "weights") return NodeProperty::weights;
  return std::nullopt;
}

Interpolation interpolation_of(const Json& sampler, const std::string& place) {
  const std::string name = sampler.value("interpolation", "LINEAR");
  if (name == "STEP") return Interpolation::step;
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  fail_invalid(place + ".interpolation", fmt::format("unknown interpolation \"{}\"", name));
}

const Json& array_of(const Json& animation, const char* name, const std::string& place) {
  require_object(animation, place);
  const Json* all = find_member(animation, name);
  if (all == nullptr) fail_invalid(place, fmt::format("{} is missing", name));
  require_array(*all, fmt::format("{}.{}", place, name));
  return *all;
}

/// Sets the channel's sampler, the one at that position.
void read_sampler(const Json& samplers, std::size_t position, const std::string& animation_place,
                  AnimationChannel& channel) {
  if (position >= samplers.size())
    fail_invalid(channel.place, fmt::format("sampler {} of {} does not exist", position, samplers.size()));
  channel.sampler_place = fmt::format("{}.samplers[{}]", animation_place, position);
  const Json sampler = checked_members(samplers[position], channel.sampler_place, sampler_members);
  channel.interpolation = interpolation_of(sampler, channel.sampler_place);
  channel.input = sampler["input"].get<int>();
  channel.output = sampler["output"].get<int>();
}

/// Nothing where the channel drives no node.
std::optional<AnimationChannel> read_channel(const Json& json, const Json& samplers,
                                             const std::string& animation_place, std::size_t position) {
  AnimationChannel channel;
  channel.place = fmt::format("{}.channels[{}]", animation_place, position);
  const Json checked = checked_members(json, channel.place, channel_members);
  const Json* target = find_member(json, "target");
  if (target == nullptr) fail_invalid(channel.place, "target is missing");
  const Json drives = checked_members(*target, channel.place + ".target", target_members);
  const std::string path = drives["path"];
  if (path == "pointer") fail_unsupported(channel.place, "KHR_animation_pointer");
  const Json* node = find_member(drives, "node");
  if (node == nullptr) return std::nullopt;
  channel.node = node->get<int>();
  const auto property = property_of(path);
  if (!property) fail_invalid(channel.place + ".target.path", fmt::format("unknown path \"{}\"", path));
  channel.property = *property;
  read_sampler(samplers, checked["sampler"].get<std::size_t>(), animation_place, channel);
  return channel;
}

AskedAnimation read_animation(const Json& animation, std::size_t position) {
  const std::string place = fmt::format("animations[{}]", position);
  const Json& channels = array_of(animation, "channels", place);
  const Json& samplers = array_of(animation, "samplers", place);
  AskedAnimation asked{static_cast<int>(position), {}};
  std::set<std::pair<int, NodeProperty>> driven;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto channel = read_channel(channels[i], samplers, place, i);
    if (!channel) continue;
    if (!driven.insert({channel->node, channel->property}).second)
      fail_invalid(channel->place,
                   fmt::format("an earlier channel drives the same property of node {}", channel->node));
    asked.channels.push_back(std::move(*channel));
  }
  return asked;
}

/// The only number of that array, for an accessor's min or max.
std::optional<double> only_number(const Json& accessor, const char* name) {
  const Json* bound = find_member(accessor, name);
  if (bound == nullptr || !bound->is_array() || bound->size() != 1 || !(*bound)[0].is_number())
    return std::nullopt;
  return (*bound)[0].get<double>();
}

/// The element of that array of the object, if both are what they should be.
const Json* element_of(const Json& object, const char* name, const Json* position) {
  const Json* all = find_member(object, name);
  if (all == nullptr || !all->is_array() || position == nullptr || !position->is_number_unsigned())
    return nullptr;
  const auto i = position->get<std::uint64_t>();
  return i < all->size() ? &(*all)[i] : nullptr;
}

/// The first and last key of what a channel plays, by its accessor's bounds.
std::optional<std::pair<double, double>> key_range(const Json& document, const Json& animation,
                                                   const Json& channel) {
  const Json* sampler = element_of(animation, "samplers", find_member(channel, "sampler"));
  if (sampler == nullptr) return std::nullopt;
  const Json* input = element_of(document, "accessors", find_member(*sampler, "input"));
  if (input == nullptr) return std::nullopt;
  const auto first = only_number(*input, "min"), last = only_number(*input, "max");
  if (!first || !last || !(*first <= *last)) return std::nullopt;
  return std::pair(*first, *last);
}

std::optional<AnimationInfo> info_of(const Json& document, const Json& animation, int position) {
  const Json* channels = find_member(animation, "channels");
  if (channels == nullptr || !channels->is_array() || channels->empty()) return std::nullopt;
  AnimationInfo info{name_of(animation), 0, 0, position};
  for (std::size_t i = 0; i < channels->size(); ++i) {
    const auto range = key_range(document, animation, (*channels)[i]);
    if (!range) return std::nullopt;
    info.first = i == 0 ? range->first : std::min(info.first, range->first);
    info.last = i == 0 ? range->second : std::max(info.last, range->second);
  }
  return info;
}

}  // namespace

std::optional<AskedAnimation> asked_animation(const Json& document, const LoadOptions& options) {
  if (!options.time) return std::nullopt;
  const Json* animations = find_member(document, "animations");
  if (animations != nullptr) require_array(*animations, "animations");
  if (animations == nullptr || animations->empty()) fail_usage("--time", "the file has no animations");
  const std::size_t position = choose(*animations, options.animation);
  return read_animation((*animations)[position], position);
}

std::vector<AnimationInfo> animation_notes(const Json& document) {
  std::vector<AnimationInfo> notes;
  const Json* animations = find_member(document, "animations");
  if (animations == nullptr || !animations->is_array()) return notes;
  for (std::size_t i = 0; i < animations->size(); ++i)
    if (auto info = info_of(document, (*animations)[i], static_cast<int>(i)))
      notes.push_back(std::move(*info));
  return notes;
}

}  // namespace provis
