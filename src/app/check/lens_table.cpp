#include "app/check/lens_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/object_bounds.hpp"

namespace penumbra {
namespace {

constexpr std::size_t most_rows = 50;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

bool knows_focal_length(const Camera& camera) { return camera.f_number > 0; }

// F D / (D - F): how far behind the lens the image of a point at distance D in front of it lies.
double image_distance(double focal_length, double distance) {
  return focal_length * distance / (distance - focal_length);
}

std::string describe_shape(const Shape& shape) {
  if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&shape)) {
    return fmt::format("group of {}", (*group)->objects.size());
  }
  const auto* triangles = std::get_if<TriangleRange>(&shape);
  if (triangles != nullptr && triangles->count != 1) return fmt::format("{} triangles", triangles->count);
  return std::string(name_of(shape).one);
}

constexpr std::string_view indent = "             ";

std::string describe_lens(const Camera& camera) {
  const double aperture = 2 * camera.lens_radius;
  if (!knows_focal_length(camera)) {
    return fmt::format("F and n unknown, aperture {:g}, focus P {:g}", aperture, camera.focus_distance);
  }
  return fmt::format("F {:g}, n {:g}, aperture F/n {:g}, focus P {:g}, image plane V_P {:g}", camera.focal_length,
                     camera.f_number, aperture, camera.focus_distance, image_plane_distance(camera));
}

std::string row(const Scene& scene, std::string_view name, double distance) {
  std::string text = fmt::format("{}{:<20} {:>11.6g}", indent, name, distance + 0.0);
  if (!(distance > 0)) return text + "  behind the eye\n";
  const LensBlur blur = lens_blur(scene, distance);
  if (knows_focal_length(scene.camera)) {
    return text + fmt::format(" {:>11.6g} {:>11.6g} {:>11.6g} {:>11.6g}\n", blur.image_distance, blur.radius,
                              blur.circle_of_confusion, blur.radius_in_pixels);
  }
  return text + fmt::format(" {:>11.6g} {:>11.6g}\n", blur.radius, blur.radius_in_pixels);
}

}  // namespace

LensBlur lens_blur(const Scene& scene, double distance) {
  const Camera& camera = scene.camera;
  const double focus = camera.focus_distance, focal_length = camera.focal_length;
  const double radius = camera.lens_radius * std::abs(distance - focus) / focus;
  const double half_view = std::tan(camera.fov_degrees * std::numbers::pi / 360);
  LensBlur blur{not_known, radius, not_known,
                radius * std::min(scene.settings.width, scene.settings.height) / (2 * distance * half_view)};
  if (knows_focal_length(camera)) {
    blur.image_distance = image_distance(focal_length, distance);
    blur.circle_of_confusion = focal_length / camera.f_number * focal_length * std::abs(focus - distance) /
                               (distance * (focus - focal_length));
  }
  return blur;
}

double image_plane_distance(const Camera& camera) {
  return knows_focal_length(camera) ? image_distance(camera.focal_length, camera.focus_distance) : not_known;
}

std::string lens_table(const Scene& scene) {
  const Camera& camera = scene.camera;
  if (!(camera.lens_radius > 0)) return {};
  const double time = (camera.shutter_open + camera.shutter_close) / 2;
  std::string text = fmt::format("  {:<10} {}\n", "lens", describe_lens(camera));
  const Objects& objects = scene.root.objects;
  if (objects.empty()) return text;
  text += fmt::format("{}D: distance along the view of the centre of each object's bounding box at time {:g}\n", indent,
                      time);
  text += knows_focal_length(camera)
              ? fmt::format("{}{:<20} {:>11} {:>11} {:>11} {:>11} {:>11}\n", indent, "object", "D", "V_D", "r", "C",
                            "r in pixels")
              : fmt::format("{}{:<20} {:>11} {:>11} {:>11}\n", indent, "object", "D", "r", "r in pixels");
  ObjectBounds bounds_at_time(scene, time);
  const Vec3 view = -normalize(camera.back);
  for (std::size_t i = 0; i < std::min(objects.size(), most_rows); i++) {
    const std::string name = fmt::format("{} {}", i + 1, describe_shape(objects[i].shape));
    const Bounds bounds = bounds_at_time.of(objects[i]);
    text += is_empty(bounds) ? fmt::format("{}{:<20} {:>11}  empty\n", indent, name, "-")
                             : row(scene, name, dot((bounds.lo + bounds.hi) / 2 - camera.eye, view));
  }
  if (objects.size() > most_rows) text += fmt::format("{}... and {} more\n", indent, objects.size() - most_rows);
  return text;
}

}  // namespace penumbra
