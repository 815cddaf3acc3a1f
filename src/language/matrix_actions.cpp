// The matrix commands: each multiplies the current matrix from the right, so that the last one is applied first.
#include "language/actions.hpp"

namespace penumbra::actions {
namespace {

void multiply(Reading& reading, const Call& call, const Affine& by) {
  const Affine product = reading.builder.matrix() * by;
  bool finite = is_finite(product.translation);
  for (const Vec3& column : product.column) finite = finite && is_finite(column);
  if (!finite) return reading.error(call.place(), "the current matrix has become too large");
  reading.builder.set_matrix(product);
}

}  // namespace

void push(Reading& reading, const Call& call) { reading.report(call, reading.builder.push(call.place())); }

void pop(Reading& reading, const Call& call) {
  const Problem wrong = reading.builder.pop();
  if (!wrong.empty()) reading.diagnostics.error(call.place(), wrong);
}

void translate(Reading& reading, const Call& call) { multiply(reading, call, translation(call.vec(0))); }

void scale(Reading& reading, const Call& call) {
  for (int axis = 0; axis < 3; axis++) {
    if (call[axis] != 0) continue;
    return reading.error(call.place_of_argument(axis), "a `scale` by zero flattens everything after it");
  }
  multiply(reading, call, scaling(call.vec(0)));
}

void rotate(Reading& reading, const Call& call) {
  const Vec3 axis = call.vec(1);
  if (axis == Vec3{}) return reading.error(call.place_of_argument(1), "the axis of `rotate` has no length");
  multiply(reading, call, rotation(call[0], axis));
}

void rotate_x(Reading& reading, const Call& call) { multiply(reading, call, rotation(call[0], {1, 0, 0})); }

void rotate_y(Reading& reading, const Call& call) { multiply(reading, call, rotation(call[0], {0, 1, 0})); }

void rotate_z(Reading& reading, const Call& call) { multiply(reading, call, rotation(call[0], {0, 0, 1})); }

}  // namespace penumbra::actions
