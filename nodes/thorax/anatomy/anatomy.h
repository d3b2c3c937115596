#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

// A human thorax at the end of a quiet exhale (FRC). All lengths in metres in the subject's frame: +X the
// subject's left, +Y up, +Z to the front; x = 0 is the midline, y = 0 lies near the domes of the diaphragm.

enum class Side { Left, Right };

/// +1 left, -1 right: the sign of x on that side.
constexpr float sign(Side side) { return side == Side::Left ? 1.0f : -1.0f; }

inline constexpr int kRibSamples = 33;

struct Rib {
  std::string name;  // "RIB_L1" .. "RIB_R12"
  Side side = Side::Left;
  int number = 0;     // 1 .. 12
  TriangleMesh mesh;  // closed

  Eigen::Vector3f head;                     // centre of the costovertebral joint
  Eigen::Vector3f tubercle;                 // on the surface, where the transverse process is met
  Eigen::Vector3f neckAxis;                 // unit, from the head to the centreline at the tubercle
  Eigen::Vector3f sternalEnd;               // end of the centreline
  std::vector<Eigen::Vector3f> centreline;  // head to sternal end, kRibSamples at equal arc lengths
  std::vector<Eigen::Vector3f>
      innerLine;  // the surface's points that face the lungs, one a centreline sample
};

inline constexpr int kCartilageSamples = 17;

struct Cartilage {
  std::string name;  // "CARTILAGE_L1" .. "CARTILAGE_R10"
  Side side = Side::Left;
  int number = 0;     // 1 .. 10, that of its rib
  int joins = 0;      // what its end meets: 0 the sternum, otherwise the number of the cartilage above
  TriangleMesh mesh;  // closed

  std::vector<Eigen::Vector3f> centreline;  // kCartilageSamples from the rib to the end, equal arc lengths
  std::vector<Eigen::Vector3f>
      innerLine;          // the surface's points that face the lungs, one a centreline sample
  Eigen::Vector3f start;  // centreline.front(), inside the rib's end
  Eigen::Vector3f end;    // centreline.back(), on the sternum or on the cartilage above
};

/// Manubrium, body and xiphoid as one closed bone.
struct Sternum {
  TriangleMesh mesh;
  Eigen::Vector3f jugularNotch;  // top of the manubrium in the midline: the sternum tilts about it
  Eigen::Vector3f sternalAngle;  // manubrium meets body (level of cartilage 2)
  Eigen::Vector3f xiphoidTip;
};

struct Vertebra {
  std::string name;   // "T1" .. "T12"
  TriangleMesh bone;  // closed
  TriangleMesh disc;  // closed, the disc below
  Eigen::Vector3f bodyCentre;
  Eigen::Vector3f up;  // unit, axis of the body
  Eigen::Vector3f spinousTip;
  Eigen::Vector3f transverseTipLeft;
  Eigen::Vector3f transverseTipRight;
};

enum class DiaphragmPart : unsigned char { Tendon, Dome, Wall, Rim };

/// A thin open sheet, normals up and outwards, its rim attached to the cage; from real meshes with crura if
/// scanned.
struct Diaphragm {
  TriangleMesh mesh;
  // One value a point:
  std::vector<DiaphragmPart> part;  // wall: the zone of apposition, rim: the attachment
  std::vector<float> azimuth;  // [rad] about the vertical axis, from +X towards the back (-Z), in [0, 2 pi)
  std::vector<float> s;        // 0 apex, 1 edge of the dome, 2 rim
  Eigen::Vector3f domeTopLeft;
  Eigen::Vector3f domeTopRight;
};

enum class LungPart : unsigned char { Costal, Diaphragmatic, Mediastinal };

struct Lung {
  std::string name;  // "LUNG_L", "LUNG_R"
  Side side = Side::Left;
  TriangleMesh mesh;           // closed
  std::vector<LungPart> part;  // one a point
  Eigen::Vector3f apex;        // highest point
};

struct Anatomy {
  std::vector<Rib> ribs;              // 24: left 1-12, right 1-12
  std::vector<Cartilage> cartilages;  // 20: left 1-10, right 1-10
  Sternum sternum;
  std::vector<Vertebra> vertebrae;  // T1 .. T12
  Diaphragm diaphragm;
  std::vector<Lung> lungs;  // left, right
};

/// The rib or cartilage of a side and number; throws std::out_of_range if there is none.
template <class Part>
const Part& partOf(const std::vector<Part>& parts, Side side, int number) {
  for (const Part& part : parts) {
    if (part.side == side && part.number == number) return part;
  }
  throw std::out_of_range("anatomy: no part of that side and number");
}
inline const Rib& rib(const Anatomy& anatomy, Side side, int number) {
  return partOf(anatomy.ribs, side, number);
}
inline const Cartilage& cartilage(const Anatomy& anatomy, Side side, int number) {
  return partOf(anatomy.cartilages, side, number);
}

/// The default thorax, made from figures measured on one man (measurements/README.md). Same bytes at every
/// call.
Anatomy generateAnatomy();

}  // namespace pleura
