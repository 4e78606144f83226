#pragma once
/// The camera: rays through pixel centres, and triangles on the screen.
#include <array>
#include <glm/glm.hpp>

#include "traces/raster/clip.h"
#include "traces/raster/pixel_raster.h"
#include "traces/scene/scene.h"

namespace kagesen {

/// A pinhole camera over an image. Distances along the view direction are in world units.
class View {
 public:
  View(const Scene& scene, int width, int height);

  /// eye + distance * ray(x, y) lies that far along the view direction.
  glm::dvec3 ray(int x, int y) const { return corner_ + step_x_ * (x + 0.5) + step_y_ * (y + 0.5); }
  const glm::dvec3& eye() const { return eye_; }
  const glm::dvec3& corner() const { return corner_; }  ///< ray of the image's upper left corner
  const glm::dvec3& step_x() const { return step_x_; }  ///< from one pixel to the next
  const glm::dvec3& step_y() const { return step_y_; }
  double near_plane() const { return near_; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// (pixel x * w, pixel y * w, 1, w), w the distance along the view direction.
  glm::dvec4 project(const glm::dvec3& world) const;
  /// Clips to the near plane and the guard band and snaps. Returns the number of corners, 0 if
  /// none.
  int to_screen(const std::array<glm::dvec4, 3>& projected,
                std::array<ScreenPoint, 16>& corners) const;

 private:
  glm::dvec3 eye_, forward_, corner_, step_x_, step_y_;
  glm::dvec3 row_x_, row_y_;  ///< project() before the centre is added
  double near_ = 0;
  int width_, height_;
};

}  // namespace kagesen
