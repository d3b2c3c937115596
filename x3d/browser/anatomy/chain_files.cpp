#include <algorithm>

#include <fmt/format.h>

#include <pleura/nodes/deformable/mesh/refinement.h>
#include <pleura/x3d/browser/anatomy/chain_files.h>
#include <pleura/x3d/browser/anatomy/tissue.h>

namespace pleura {

namespace {

constexpr float kCentimetres = 100;  // a metre
constexpr float kPerCentimetre = 1e3f;

// Triangles of the coarse meshes.
constexpr int kRibTriangles = 240;
constexpr int kSternumTriangles = 500;
constexpr int kVertebraTriangles = 200;
constexpr int kDiscTriangles = 60;
constexpr int kOrganTriangles = 1600;

TriangleMesh coarse(const TriangleMesh& mesh, int triangles) {
  TriangleMesh result = decimate(mesh, triangles);
  for (auto& point : result.points) point *= kCentimetres;
  return result;
}

/// An organ: its names in the scene files, what it is made of.
struct Organ {
  std::string file;
  std::string timeSensor;
  Tissue tissue;
  Vec3f chainmail;  // compression, stretch, shear
  int smoothing;
};

class ChainWriter {
 public:
  ChainWriter(const NodeRegistry& registry, const std::string& source) : maker_(registry), source_(source) {}

  std::vector<SceneFile> write(const Anatomy& anatomy) {
    for (const auto& rib : anatomy.ribs)
      if (rib.number <= kLastRib)
        addBone(fmt::format("{}_rib_{}", rib.side == Side::Left ? "left" : "right", rib.number),
                coarse(rib.mesh, kRibTriangles));
    addBone("sternum", coarse(anatomy.sternum.mesh, kSternumTriangles));
    addSpine(anatomy.vertebrae);
    addDiaphragm(anatomy.diaphragm);
    for (const auto& lung : anatomy.lungs) addLung(lung);
    return std::move(files_);
  }

 private:
  void finish(Document& document, const std::string& name) {
    files_.push_back(sceneFile(document, name, name, source_));
  }

  NodePtr shape(const TriangleMesh& mesh, Tissue tissue, const std::string& coordinate = {}) {
    auto node = maker_.make("Shape");
    maker_.put(node, "appearance", appearanceOf(maker_, tissue));
    maker_.put(node, "geometry", triangleSet(maker_, mesh, true, kPerCentimetre, coordinate));
    return node;
  }

  void addBone(const std::string& name, const TriangleMesh& mesh) {
    Document document;
    document.nodes = {shape(mesh, Tissue::bone, kCoordinate)};
    document.exports = {{kCoordinate, kCoordinate}};
    finish(document, name);
  }

  void addSpine(const std::vector<Vertebra>& vertebrae) {
    Document document;
    for (const auto& vertebra : vertebrae) {
      document.nodes.push_back(shape(coarse(vertebra.bone, kVertebraTriangles), Tissue::bone));
      document.nodes.push_back(shape(coarse(vertebra.disc, kDiscTriangles), Tissue::cartilage));
    }
    finish(document, "spine");
  }

  /// Adds what every organ has; the node is left to be completed before finish().
  NodePtr addOrgan(Document& document, const Organ& organ, const TriangleMesh& mesh, bool isSolid) {
    const auto deformer = maker_.make("ChainmailDeformer");
    maker_.set<SFFloat>(deformer, "compressionFactor", organ.chainmail.x());
    maker_.set<SFFloat>(deformer, "stretchFactor", organ.chainmail.y());
    maker_.set<SFFloat>(deformer, "shearFactor", organ.chainmail.z());
    maker_.set<SFInt32>(deformer, "smoothing", organ.smoothing);
    auto node = maker_.make("DeformableShape2", "deform");
    maker_.put(node, "appearance", appearanceOf(maker_, organ.tissue));
    maker_.put(node, "geometry", triangleSet(maker_, mesh, isSolid, kPerCentimetre, kCoordinate));
    maker_.put(node, "deformer", deformer);
    const auto clock = maker_.make("TimeSensor", organ.timeSensor);
    maker_.set<SFTime>(clock, "cycleInterval", kBreath);
    maker_.set<SFBool>(clock, "loop", true);
    document.libraries = {"\"chain\""};
    document.nodes = {clock, node};
    for (const std::string& name : {std::string(kCoordinate), node->getName(), organ.timeSensor})
      document.exports.emplace_back(name, name);
    document.routes = {{"deform", "pause_time", organ.timeSensor, "pauseTime"},
                       {"deform", "resume_time", organ.timeSensor, "resumeTime"}};
    return node;
  }

  void addDiaphragm(const Diaphragm& diaphragm) {
    Document document;
    const Organ organ{"diaphragm", "TimeNode", Tissue::muscle, {0.7f, 1.1f, 0.1f}, 0};
    const TriangleMesh mesh = coarse(diaphragm.mesh, kOrganTriangles);
    const auto node = addOrgan(document, organ, mesh, false);
    const auto tendon = tendonOf(diaphragm, mesh);
    maker_.set<MFInt32>(node, "rigid_points", tendon);
    // All of it, not one point of it: the ribs pull harder than the links to one point allow.
    maker_.set<MFInt32>(node, "dome", tendon);
    maker_.set<SFVec3f>(node, "domeTravel", Vec3f(0, -kDomeTravel, 0));
    document.routes.push_back({organ.timeSensor, "time", "deform", "inflation"});
    finish(document, organ.file);
  }

  void addLung(const Lung& lung) {
    Document document;
    const bool isLeft = lung.side == Side::Left;
    const Organ organ{isLeft ? "left_lung" : "right_lung",
                      isLeft ? "timeLL" : "timeRL",
                      Tissue::lung,
                      {0.33333f, 1.25f, 0.25f},
                      10};
    addOrgan(document, organ, coarse(lung.mesh, kOrganTriangles), true);
    finish(document, organ.file);
  }

  /// The points of the coarse mesh that lie on the central tendon; it has points of the fine one.
  static std::vector<std::int32_t> tendonOf(const Diaphragm& diaphragm, const TriangleMesh& mesh) {
    std::vector<std::int32_t> tendon;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const auto at = std::find_if(diaphragm.mesh.points.begin(), diaphragm.mesh.points.end(),
                                   [&](const Vec3f& p) { return Vec3f(p * kCentimetres) == mesh.points[i]; });
      const auto k = static_cast<std::size_t>(at - diaphragm.mesh.points.begin());
      if (k < diaphragm.part.size() && diaphragm.part[k] == DiaphragmPart::Tendon)
        tendon.push_back(static_cast<std::int32_t>(i));
    }
    return tendon;
  }

  static constexpr int kLastRib = 11;
  static constexpr Time kBreath = 4;       // [s], RotTransform's and DeformableShape2's own frequency
  static constexpr float kDomeTravel = 2;  // [cm]
  static constexpr const char* kCoordinate = "coordNode";

  NodeMaker maker_;
  std::string source_;
  std::vector<SceneFile> files_;
};

}  // namespace

std::vector<SceneFile> chainFiles(const Anatomy& anatomy, const NodeRegistry& registry,
                                  const std::string& source) {
  return ChainWriter(registry, source).write(anatomy);
}

}  // namespace pleura
