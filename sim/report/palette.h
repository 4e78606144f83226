#pragma once
/// The colours of the pictures, in one place.
#include "model/reference/judge.h"
#include "sim/report/canvas.h"
#include "traces/format/records.h"

namespace kagesen {

/// Linear light, 1 = white.
struct Light3 {
  float r = 0, g = 0, b = 0;
};
/// For the screen: clamped and encoded.
Rgb encoded(const Light3& light);

/// A surface under sun and sky. `shade` is the Lambert term of the fragment, 0 to 255.
Light3 shaded(const ObjectInfo& object, std::size_t index, std::uint8_t shade, bool dark);
/// The background at a height in the image: 0 at the top, 1 at the bottom.
Light3 sky(double height);

/// Told apart by colour-blind eyes too.
Rgb cause_colour(Cause cause);
/// Dark violet to pale yellow over t from 0 to 1.
Rgb heat_colour(double t);

}  // namespace kagesen
