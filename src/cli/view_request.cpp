#include "src/cli/view_request.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "provis/error.hpp"

namespace provis {

namespace {

// Names of what was given beside the eye, for rules about what goes together.
std::vector<std::string> given(const ViewRequest& r) {
  const std::vector<std::pair<const char*, bool>> parts = {
      {"dir", r.dir.has_value()},          {"look-at", r.look_at.has_value()},
      {"right", r.right.has_value()},      {"up", r.up.has_value()},
      {"forward", r.forward.has_value()},  {"window", r.window.has_value()},
      {"fovy", r.fovy_degrees.has_value()}};
  std::vector<std::string> names;
  for (const auto& [name, present] : parts) {
    if (present) names.emplace_back(name);
  }
  return names;
}

class Builder {
 public:
  Builder(const ViewRequest& request, const std::string& prefix) : request_(request), prefix_(prefix) {}

  PointView build() const {
    if (!request_.eye) refuse("eye", "is required");
    if (request_.projection == Projection::omni) return sphere();
    PointView view = request_.right || request_.forward ? verbatim() : camera();
    view.projection = request_.projection;
    check(view);
    return view;
  }

 private:
  [[noreturn]] void refuse(const std::string& option, const std::string& what) const {
    throw Error(Error::Code::usage, prefix_ + option, what);
  }

  // With an omnidirectional view nothing but the eye has a meaning.
  PointView sphere() const {
    const std::vector<std::string> names = given(request_);
    if (!names.empty()) refuse(names.front(), "has no meaning with an omni view, which looks everywhere");
    return omni(*request_.eye);
  }

  PointView verbatim() const {
    const bool complete = request_.right && request_.up && request_.forward && request_.window;
    if (!complete)
      refuse("right", fmt::format("{0}right, {0}up, {0}forward and {0}window go together", prefix_));
    if (request_.dir || request_.look_at || request_.fovy_degrees) {
      refuse("right",
             fmt::format("sets the view verbatim: {0}dir, {0}look-at and {0}fovy have no place", prefix_));
    }
    return {*request_.eye,
            request_.projection,
            {Frame{*request_.right, *request_.up, *request_.forward, *request_.window}}};
  }

  PointView camera() const {
    if (!request_.dir && !request_.look_at) {
      refuse("dir",
             fmt::format("no direction is given: state {0}dir or {0}look-at, or the whole frame by {0}right, "
                         "{0}up, {0}forward and {0}window",
                         prefix_));
    }
    if (request_.dir && request_.look_at) {
      refuse("dir", fmt::format("and {0}look-at both state the direction: give one of the two", prefix_));
    }
    if (request_.window && request_.fovy_degrees) refuse("window", "replaces fovy: give one of the two");
    if (request_.projection == Projection::parallel && !request_.window) {
      refuse("window", "is required with a parallel view (in scene units)");
    }
    LookAt look;
    look.eye = *request_.eye;
    look.direction = request_.dir ? *request_.dir : *request_.look_at - *request_.eye;
    if (request_.up) look.up = *request_.up;
    look.fovy_degrees = request_.fovy_degrees.value_or(look.fovy_degrees);
    if (!(look.fovy_degrees > 0 && look.fovy_degrees < 180)) {
      refuse("fovy", fmt::format("{} is not between 0 and 180 degrees", look.fovy_degrees));
    }
    if (request_.size) {
      look.width = (*request_.size)[0];
      look.height = (*request_.size)[1];
    }
    PointView view = look_at(look);
    if (request_.window) view.frames.front().window = *request_.window;
    return view;
  }

  const ViewRequest& request_;
  const std::string& prefix_;
};

}  // namespace

PointView build_view(const ViewRequest& request, const std::string& prefix) {
  return Builder(request, prefix).build();
}

}  // namespace provis
