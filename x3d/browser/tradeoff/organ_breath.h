#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>
#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

/// A breath of an organ, as a deformer is asked for it: what is held moves so, the rest is to be found.
struct OrganBreath {
  std::string organ;  // DEF name
  TriangleMesh rest;
  std::vector<int> rigid;   // points that keep their places to one another
  std::vector<int> driven;  // points that walls move
  struct Moment {
    Time time = 0;
    std::vector<Vec3f> targets;  // one a driven point
    std::vector<Vec3f> filled;   // all points, those between filled in smoothly
    std::vector<Vec3f> shown;    // all points, as the scene's own deformer has them
    float pressure = 0;          // [Pa] inside less outside, above that at rest
  };
  std::vector<Moment> moments;
};

/// The breath of each organ that contacts hold which the scene has a name for (LungContacts,
/// DiaphragmContacts), at `moments` times evenly spread over `seconds` from 0. From then on the contacts
/// leave what is between to the deformers.
std::vector<OrganBreath> recordBreath(Scene& scene, double seconds, int moments);

}  // namespace pleura
