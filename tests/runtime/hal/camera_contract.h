#pragma once
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "base/clock.h"
#include "hal/camera.h"

namespace mirada::hal {

/// What every camera must do, whatever is behind it. A factory sets one up; `next_picture` lets exactly one
/// more picture become readable (while the camera is enabled).
struct CameraUnderTest {
  std::shared_ptr<void> keeps;  ///< whatever must outlive the camera
  Camera* camera = nullptr;
  std::function<void()> next_picture;
  std::function<Micros()> now;
};

struct CameraMaker {
  std::string name;
  std::function<CameraUnderTest()> make;
};

}  // namespace mirada::hal
