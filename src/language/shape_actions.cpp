// The shape commands. All shapes follow the full matrix, except that with `--course` spheres and boxes keep their
// radius and axes.
#include "language/actions.hpp"
#include "language/mesh.hpp"

namespace penumbra::actions {
namespace {

void add_box(Reading& reading, const Call& call, Vec3 a, Vec3 b) {
  reading.report(call, reading.builder.add_shape(Box{min(a, b), max(a, b)}));
}

// Adds a shape whose position is already transformed; `a` and `b` bound it.
void add_unplaced(Reading& reading, const Call& call, const Shape& shape, Vec3 a, Vec3 b, Vec3 motion) {
  if (!fits_single_precision(a) || !fits_single_precision(b)) {
    return reading.error(call.place(), "the current matrix moves the shape too far away");
  }
  reading.report(call, reading.builder.add_shape(shape, motion, false));
}

void add_sphere(Reading& reading, const Call& call, double radius, Vec3 start, Vec3 end) {
  const Affine& matrix = reading.builder.matrix();
  const Vec3 motion = transform_vector(matrix, end - start);
  if (reading.course != Course::off) {
    const Vec3 center = transform_point(matrix, start);
    add_unplaced(reading, call, Sphere{center, radius}, center, center, motion);
  } else {
    reading.report(call, reading.builder.add_shape(Sphere{start, radius}, motion));
  }
}

void add_cylinder(Reading& reading, const Call& call, bool capped) {
  const double low = std::min(call[3], call[4]);
  const double high = std::max(call[3], call[4]);
  if (low == high) reading.diagnostics.warning(call.place_of_argument(3), "this cylinder has no height");
  reading.report(call, reading.builder.add_shape(Cylinder{call[0], call[1], call[2], low, high, capped}));
}

}  // namespace

void begin(Reading& reading, const Call& call) {
  reading.stray_vertex = false;
  if (reading.builder.in_polygon()) {
    reading.error(call.place(), "`begin` while the polygon begun on line {} is still open",
                  reading.builder.polygon_place().line);
    reading.builder.triangles().abandon_polygon();
  }
  const Problem wrong = reading.builder.begin_polygon(call.place());
  if (wrong.empty()) return;
  reading.diagnostics.error(call.place(), wrong);
  reading.stray_vertex = true;
}

void vertex(Reading& reading, const Call& call) {
  if (reading.builder.in_polygon()) {
    if (reading.builder.add_vertex(call.vec(0))) return;
    reading.error(call.place(), "the current matrix moves this vertex too far away");
  } else if (!reading.stray_vertex) {
    reading.stray_vertex = true;
    reading.error(call.place(), "`vertex` outside `begin` and `end`");
  }
}

void texture_coord(Reading&, const Call&) {}

void end(Reading& reading, const Call& call) {
  if (reading.builder.in_polygon()) {
    reading.report(call, reading.builder.end_polygon());
  } else if (!reading.stray_vertex) {
    const bool in_group = reading.builder.tree().open_groups() > 0;
    const bool is_list = in_group && reading.builder.tree().innermost().opener == "begin_list";
    reading.diagnostics.error(call.place(), "`end` without a `begin` before it",
                              !in_group ? ""
                              : is_list ? "did you mean `end_list`?"
                                        : "did you mean `end_accel`?");
  }
  reading.stray_vertex = false;
}

void sphere(Reading& reading, const Call& call) {
  OrderOf2018& order = reading.order_of_2018;
  if (!order.first_sphere) order.first_sphere = call.place();
  order.spheres++;
  order.spheres_behind += transform_point(reading.builder.matrix(), call.vec(1)).z > 0;
  add_sphere(reading, call, call[0], call.vec(1), call.vec(1));
}

void sphere_of_2018(Reading& reading, const Call& call) {
  add_sphere(reading, call, call[3], call.vec(0), call.vec(0));
}

void moving_sphere(Reading& reading, const Call& call) {
  reading.note(Topic::motion, call);
  add_sphere(reading, call, call[0], call.vec(1), call.vec(4));
}

void box(Reading& reading, const Call& call) {
  if (reading.course == Course::off) return add_box(reading, call, call.vec(0), call.vec(3));
  const Vec3 a = transform_point(reading.builder.matrix(), call.vec(0));
  const Vec3 b = transform_point(reading.builder.matrix(), call.vec(3));
  add_unplaced(reading, call, Box{min(a, b), max(a, b)}, a, b, {});
}

void cylinder(Reading& reading, const Call& call) { add_cylinder(reading, call, true); }

void hollow_cylinder(Reading& reading, const Call& call) { add_cylinder(reading, call, false); }

void cone(Reading& reading, const Call& call) {
  const Cone cone{call.vec(0), call[3], call[4]};
  if (!fits_single_precision(cone.apex + Vec3{0, cone.height, 0}) ||
      !fits_single_precision({cone.height * cone.slope, 0, 0})) {
    return reading.error(call.place(), "this cone is too large at its top");
  }
  reading.report(call, reading.builder.add_shape(cone));
}

void mesh(Reading& reading, const Call& call) {
  const bool flat = call.form.count() > 1;
  if (flat && call.name(1) != "flat") {
    return reading.diagnostics.error(
        call.place_of_argument(1),
        fmt::format("only `flat` may follow the file name; found {}", in_quotes(call.name(1))),
        "a name with blanks has to stand in double quotes");
  }
  std::optional<NamedFile> file = open_named_file(reading, call);
  if (!file) return;
  SceneBuilder& builder = reading.builder;
  if (const Problem wrong = builder.check_matrix(); !wrong.empty()) {
    return reading.diagnostics.error(call.place(), wrong);
  }
  builder.change();
  TriangleStore& store = *builder.triangles().store();
  const std::uint32_t first = builder.triangles().triangle_count();
  const std::size_t first_normal_number = store.normal_numbers.size();
  const std::optional<MeshError> error =
      read_mesh(file->path, file->loaded.bytes, MeshStore(store, builder.matrix(), flat));
  if (file->loaded.bytes.has_shrunk()) {
    return reading.diagnostics.error(call.place_of_argument(0), file_has_shrunk);
  }
  if (!error) return reading.report(call, builder.add_mesh(first, first_normal_number));
  SourcePlace place = error->place;
  place.visit = reading.diagnostics.open(file->path.string(), call.place(), file->loaded.is_secret);
  reading.diagnostics.error(place, error->message);
}

}  // namespace penumbra::actions
