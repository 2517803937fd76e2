#include <png.h>

#include "provis/draw.hpp"
#include "provis/error.hpp"
#include "src/scene/atomic_file.hpp"

namespace provis {

namespace {

// libpng's png_image interface: it reports errors by value, where the classic one jumps past destructors.
std::vector<char> encoded(const Image& image, const std::string& place) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<char> file(size);
  if (png_image_write_to_memory(&header, file.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
    const std::string why = header.message;
    png_image_free(&header);
    throw Error(Error::Code::output, place, "libpng: " + why);
  }
  file.resize(size);
  return file;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  AtomicFile target(file);
  const std::vector<char> bytes = encoded(image, file.string());
  target.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  target.commit();
}

}  // namespace provis
