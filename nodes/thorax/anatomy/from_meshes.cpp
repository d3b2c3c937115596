#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/nearest_point.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/thorax/anatomy/bone_lines.h>
#include <pleura/nodes/thorax/anatomy/bones.h>
#include <pleura/nodes/thorax/anatomy/from_meshes.h>
#include <pleura/nodes/thorax/anatomy/lungs.h>
#include <pleura/nodes/thorax/anatomy/scanned_organs.h>
#include <pleura/nodes/thorax/anatomy/table.h>

namespace pleura {
namespace {

using Eigen::Vector3f;

constexpr std::array<const char*, 12> kOrdinals{"first", "second", "third",    "fourth",
                                                "fifth", "sixth",  "seventh",  "eighth",
                                                "ninth", "tenth",  "eleventh", "twelfth"};

// The meshes of one folder, turned into the subject's frame and repaired.
class Scans {
 public:
  Scans(const std::filesystem::path& directory, const MeshLoader& load) : directory_(directory), load_(load) {
    if (!std::filesystem::is_directory(directory / "skeleton")) {
      throw std::invalid_argument(
          fmt::format("anatomyFromMeshes: {}: no folder skeleton in it", directory.string()));
    }
  }

  std::optional<TriangleMesh> solid(const std::string& file) const { return read(file, {}); }
  std::optional<TriangleMesh> sheet(const std::string& file) const {
    RepairOptions options;
    options.maxHoleEdges = 0;
    return read(file, options);
  }

 private:
  std::optional<TriangleMesh> read(const std::string& file, const RepairOptions& options) const {
    const std::filesystem::path path = directory_ / file;
    if (!std::filesystem::exists(path)) return std::nullopt;
    TriangleMesh mesh = load_(path);
    for (Vector3f& point : mesh.points) point = fromTableFrame(point.cast<double>()).cast<float>();
    repair(mesh, options);
    if (mesh.triangles.empty()) {
      throw std::invalid_argument(fmt::format("anatomyFromMeshes: {}: no triangles", path.string()));
    }
    return mesh;
  }

  std::filesystem::path directory_;
  const MeshLoader& load_;
};

const char* sideName(Side side) { return side == Side::Left ? "left" : "right"; }

template <class Less>
Vector3f extreme(const TriangleMesh& mesh, const Less& key) {
  return *std::max_element(mesh.points.begin(), mesh.points.end(),
                           [&](const Vector3f& a, const Vector3f& b) { return key(a) < key(b); });
}

// The body is the front two fifths of the bone.
Vector3f bodyCentre(const TriangleMesh& bone) {
  const Eigen::AlignedBox3f box = boundingBox(bone.points);
  const float back = box.max().z() - 0.4f * box.sizes().z();
  Eigen::AlignedBox3f body;
  for (const Vector3f& point : bone.points) {
    if (point.z() > back) body.extend(point);
  }
  return body.center();
}

void takeVertebrae(const Scans& scans, std::vector<Vertebra>& vertebrae) {
  for (std::size_t i = 0; i < vertebrae.size(); ++i) {
    Vertebra& v = vertebrae[i];
    if (auto disc = scans.solid(
            fmt::format("skeleton/intervertebral_disk_of_{}_thoracic_vertebra.obj", kOrdinals[i]))) {
      v.disc = std::move(*disc);
    }
    auto bone = scans.solid(fmt::format("skeleton/{}_thoracic_vertebra.obj", kOrdinals[i]));
    if (!bone) continue;
    v.bone = std::move(*bone);
    v.bodyCentre = bodyCentre(v.bone);
    v.spinousTip = extreme(v.bone, [](const Vector3f& p) { return -p.z(); });
    v.transverseTipLeft = extreme(v.bone, [](const Vector3f& p) { return p.x(); });
    v.transverseTipRight = extreme(v.bone, [](const Vector3f& p) { return -p.x(); });
  }
  for (std::size_t i = 0; i < vertebrae.size(); ++i) {
    const Vector3f& above = vertebrae[i > 0 ? i - 1 : i].bodyCentre;
    const Vector3f& below = vertebrae[std::min(i + 1, vertebrae.size() - 1)].bodyCentre;
    vertebrae[i].up = (above - below).normalized();
  }
}

// Head: the end at the spine. Tubercle: where the bone is nearest to the transverse process.
void takeRib(const Scans& scans, const Vertebra& vertebra, Rib& rib) {
  auto mesh =
      scans.solid(fmt::format("skeleton/{}_{}_rib.obj", sideName(rib.side), kOrdinals[rib.number - 1]));
  if (!mesh) return;
  rib.mesh = largestPiece(*mesh);
  BoneLines lines = boneLines(rib.mesh, vertebra.bodyCentre, rib.side, kRibSamples);
  rib.centreline = std::move(lines.centreline);
  rib.innerLine = std::move(lines.innerLine);
  rib.head = rib.centreline.front();
  rib.sternalEnd = rib.centreline.back();
  const Vector3f& tip = rib.side == Side::Left ? vertebra.transverseTipLeft : vertebra.transverseTipRight;
  rib.tubercle =
      SurfaceQuery(rib.mesh.points, rib.mesh.triangles).closestPoint(tip.cast<double>()).point.cast<float>();
  const std::span<const Vector3f> beyondHead(rib.centreline.begin() + 1, rib.centreline.end());
  rib.neckAxis = (beyondHead[nearestPoint(beyondHead, rib.tubercle)] - rib.head).normalized();
}

void takeCartilage(const Scans& scans, const Rib& rib, Cartilage& cartilage) {
  auto mesh = scans.solid(fmt::format("skeleton/{}_{}_costal_cartilage.obj", sideName(cartilage.side),
                                      kOrdinals[cartilage.number - 1]));
  if (!mesh) return;
  cartilage.mesh = largestPiece(*mesh);
  BoneLines lines = boneLines(cartilage.mesh, rib.sternalEnd, cartilage.side, kCartilageSamples);
  cartilage.centreline = std::move(lines.centreline);
  cartilage.innerLine = std::move(lines.innerLine);
  cartilage.start = cartilage.centreline.front();
  cartilage.end = cartilage.centreline.back();
}

// The scanned xiphoid is of another release and overlaps the body: moved as measurements/README.md says.
void takeSternum(const Scans& scans, Sternum& sternum) {
  const Vector3f xiphoidShift(0.0f, -0.015f, -0.007f);  // [m]
  const auto manubrium = scans.solid("skeleton/manubrium.obj");
  const auto body = scans.solid("skeleton/body_of_sternum.obj");
  auto xiphoid = scans.solid("skeleton/xiphoid_process.obj");
  if (!manubrium || !body || !xiphoid) return;
  for (Vector3f& point : xiphoid->points) point += xiphoidShift;
  sternum.mesh = merged({&*manubrium, &*body, &*xiphoid});
  const auto high = [](const Vector3f& p) { return p.y() - 4.0f * std::abs(p.x()); };
  const auto low = [](const Vector3f& p) { return -p.y() - 4.0f * std::abs(p.x()); };
  sternum.jugularNotch = extreme(*manubrium, high);
  sternum.sternalAngle = 0.5f * (extreme(*manubrium, low) + extreme(*body, high));
  sternum.xiphoidTip = extreme(*xiphoid, low);
}

void takeOrgans(const Scans& scans, Anatomy& anatomy) {
  const SurfaceQuery bones = bonesOf(anatomy);
  const std::array<ChestWall, 2> walls{ChestWall(anatomy.ribs, anatomy.cartilages, Side::Left, kPleuralGap),
                                       ChestWall(anatomy.ribs, anatomy.cartilages, Side::Right, kPleuralGap)};
  if (auto mesh = scans.sheet("organs/diaphragm.obj")) {
    anatomy.diaphragm = scannedDiaphragm(std::move(*mesh), walls, bones);
  }
  const SurfaceQuery diaphragm(anatomy.diaphragm.mesh.points, anatomy.diaphragm.mesh.triangles);
  for (Lung& lung : anatomy.lungs) {
    const auto mesh = scans.solid(fmt::format("organs/{}_lung.obj", sideName(lung.side)));
    if (!mesh) continue;
    lung = scannedLung(*mesh, lung.side, walls[lung.side == Side::Left ? 0 : 1], bones, diaphragm);
  }
}

}  // namespace

Anatomy anatomyFromMeshes(const std::filesystem::path& directory, const MeshLoader& load) {
  const Scans scans(directory, load);
  Anatomy anatomy = generateAnatomy();
  takeVertebrae(scans, anatomy.vertebrae);
  for (Rib& rib : anatomy.ribs) takeRib(scans, anatomy.vertebrae[rib.number - 1], rib);
  for (Cartilage& cartilage : anatomy.cartilages) {
    takeCartilage(scans, partOf(anatomy.ribs, cartilage.side, cartilage.number), cartilage);
  }
  takeSternum(scans, anatomy.sternum);
  takeOrgans(scans, anatomy);
  return anatomy;
}

}  // namespace pleura
