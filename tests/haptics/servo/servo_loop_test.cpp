#include <chrono>
#include <thread>

#include "fake_device.h"
#include <gtest/gtest.h>

#include <pleura/haptics/servo/servo_loop.h>

namespace pleura::haptics {
namespace {

TEST(ServoLoop, TicksWhileTheSceneHandsFramesOver) {
  FakeDevice device;
  device.state = [](double time) { return DeviceState{.position = {0, 0, std::sin(time)}}; };
  Servo servo(device, 1e-3);
  const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto mesh = std::make_shared<TouchMesh>(points, std::vector<Eigen::Vector3i>{{0, 1, 2}});
  int heard = 0;
  double last = 100 - 1e-9;  // the loop's clock begins where it is told to
  {
    const ServoLoop loop(servo, 100, false);
    for (int frame = 0; frame < 50; ++frame) {
      TouchFrame& next = servo.frames().back();
      next.duration = 0.002;
      next.shapes.resize(1);
      next.instants.resize(1);
      next.shapes[0].mesh = mesh;
      next.shapes[0].points.fit(*mesh, points);
      next.shapes[0].stamp = static_cast<std::uint64_t>(frame + 1);
      next.shapes[0].surface.stiffness = 100;
      servo.frames().publish();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (!servo.reports().take()) continue;
      ++heard;
      EXPECT_GT(servo.reports().taken().time, last);
      last = servo.reports().taken().time;
      EXPECT_TRUE(servo.reports().taken().isConnected);
    }
    EXPECT_GT(loop.periods().count(), 10);
  }
  EXPECT_GT(heard, 5);
  const auto ticks = device.given.size();
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(device.given.size(), ticks) << "it has ended";
}

}  // namespace
}  // namespace pleura::haptics
