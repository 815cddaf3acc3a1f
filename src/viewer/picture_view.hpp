// Where the picture is in the window: zoom and pan. Places are in pixels, of the window or of the picture, from the top
// left.
#pragma once

#include <optional>

namespace penumbra {

struct PlaceInWindow {
  double x = 0, y = 0;
};

struct WindowArea {
  int x = 0, y = 0, width = 0, height = 0;
};

class PictureView {
 public:
  // The part of the window that is free for the picture. Until the user moves it, the picture is centred there, at the
  // largest step of the zoom, up to 4, at which it fits.
  void set_area(const WindowArea& area);
  void set_picture_size(int width, int height);
  void fit();

  void pan(double dx, double dy);
  // Zooms in by this many steps, or out if negative; what is at `place` stays there.
  void zoom(int steps, PlaceInWindow place);

  double zoom_factor() const { return zoom_; }
  // The picture's rectangle; always whole pixels.
  WindowArea picture() const;
  // The picture's pixel at a place of the window, if there is one.
  struct Pixel {
    int x = 0, y = 0;
    bool operator==(const Pixel&) const = default;
  };
  std::optional<Pixel> pixel_at(PlaceInWindow place) const;
  // Where a place of the picture is in the window.
  PlaceInWindow in_window(double x, double y) const;
  const WindowArea& area() const { return area_; }

 private:
  WindowArea area_;
  int width_ = 0, height_ = 0;
  double zoom_ = 1;
  double x_ = 0, y_ = 0;  // of the picture's top left corner
  bool moved_ = false;
};

}  // namespace penumbra
