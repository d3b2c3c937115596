#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <pleura/nodes/thorax/motion/cage_motion.h>
#include <pleura/nodes/thorax/motion/hemithorax.h>
#include <pleura/x3d/browser/anatomy/node_maker.h>
#include <pleura/x3d/browser/anatomy/thorax_files.h>
#include <pleura/x3d/browser/anatomy/tissue.h>

namespace pleura {

namespace {

/// To a hundredth of a millimetre: nothing that can be seen, and files half as long.
constexpr float kPerMetre = 1e5f;
Vec3f rounded(const Vec3f& p) { return pleura::rounded(p, kPerMetre); }
float rounded(double x) { return static_cast<float>(std::round(x * 1e5) / 1e5); }

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// "Left rib 4" of RIB_L4.
std::string titleOf(const std::string& name) {
  const auto underscore = name.find('_');
  std::string part = lower(name.substr(0, underscore));
  if (part == "cartilage") part = "costal cartilage";
  const bool isOfASide = underscore != std::string::npos;
  std::string title = part;
  if (isOfASide) {
    title = (name[underscore + 1] == 'L' ? "left " : "right ") + part;
    if (const auto number = name.substr(underscore + 2); !number.empty()) title += " " + number;
  }
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  return title;
}

class ThoraxWriter {
 public:
  ThoraxWriter(const Anatomy& anatomy, const NodeRegistry& registry, const std::string& source)
      : anatomy_(anatomy),
        maker_(registry),
        source_(source),
        cage_(anatomy, measuredRibAngles(1), measuredRibAngles(-1)) {}

  std::vector<SceneFile> write() {
    const auto ribs = addRibs();
    const auto sternum = addSternum();
    const auto spine = addSpine();
    const auto cartilages = addCartilages(ribs, sternum);
    const auto walls = addWalls(ribs, cartilages, sternum, spine);
    const auto diaphragm = addDiaphragm(walls);
    for (const auto& lung : anatomy_.lungs) addLung(lung, diaphragm);
    thorax_.libraries = {"\"thorax\""};
    finish(thorax_, "thorax", "a thorax that a Respiration node can breathe");
    return std::move(files_);
  }

 private:
  NodePtr shape(const TriangleMesh& mesh, Tissue tissue) {
    auto node = maker_.make("Shape");
    maker_.put(node, "appearance", appearanceOf(maker_, tissue));
    maker_.put(node, "geometry", triangleSet(maker_, mesh, true, kPerMetre));
    return node;
  }

  void finish(Document& document, const std::string& name, const std::string& what) {
    files_.push_back(sceneFile(document, name, what, source_));
  }

  /// An Inline of a file of shapes.
  NodePtr file(const std::string& name, const std::string& what, const std::vector<NodePtr>& shapes) {
    Document document;
    document.nodes = shapes;
    finish(document, name, what);
    auto node = maker_.make("Inline");
    maker_.set<MFString>(node, "url", {name + ".x3d"});
    return node;
  }

  void addExported(const NodePtr& node) {
    thorax_.nodes.push_back(node);
    thorax_.exports.emplace_back(node->getName(), node->getName());
  }

  /// What people call the part.
  void entitle(const NodePtr& node, const std::string& title) {
    const auto metadata = maker_.make("MetadataString");
    maker_.set<SFString>(metadata, "name", "title");
    maker_.set<MFString>(metadata, "value", {title});
    maker_.put(node, "metadata", metadata);
  }

  void addPart(const NodePtr& node) {
    entitle(node, titleOf(node->getName()));
    addExported(node);
  }

  std::vector<NodePtr> addRibs() {
    std::vector<NodePtr> nodes;
    for (const auto& rib : anatomy_.ribs) {
      const auto side = measuredRibAngles(sign(rib.side));
      const RibAngles& angles = side[static_cast<std::size_t>(rib.number - 1)];
      const auto node = maker_.make("RotTransform", rib.name);
      maker_.set<SFVec3f>(node, "angles", Vec3d(angles.pump, angles.bucket, angles.side).cast<float>());
      maker_.set<SFVec3f>(node, "center", rounded(rib.head));
      if (rib.number <= kSternalRibs) maker_.set<MFVec3f>(node, "points", {rounded(rib.sternalEnd)});
      maker_.put(node, "children",
                 file(lower(rib.name),
                      fmt::format("rib {} {}", rib.number, rib.side == Side::Left ? "left" : "right"),
                      {shape(rib.mesh, Tissue::bone)}));
      addPart(node);
      nodes.push_back(node);
    }
    return nodes;
  }

  NodePtr addSternum() {
    auto node = maker_.make("FittedTransform", "STERNUM");
    std::vector<Vec3f> ends;
    for (const auto& rib : anatomy_.ribs) {
      if (rib.number > kSternalRibs) continue;
      ends.push_back(rounded(rib.sternalEnd));
      thorax_.routes.push_back({rib.name, "rib_points", "STERNUM", "to"});
    }
    maker_.set<MFVec3f>(node, "from", ends);
    maker_.put(node, "children", file("sternum", "sternum", {shape(anatomy_.sternum.mesh, Tissue::bone)}));
    addPart(node);
    return node;
  }

  NodePtr addSpine() {
    std::vector<NodePtr> shapes;
    for (const auto& vertebra : anatomy_.vertebrae) {
      shapes.push_back(shape(vertebra.bone, Tissue::bone));
      shapes.back()->setName(vertebra.name);
      entitle(shapes.back(), "Vertebra " + vertebra.name);
      shapes.push_back(shape(vertebra.disc, Tissue::cartilage));
    }
    auto node = maker_.make("Group", "SPINE");
    maker_.put(node, "children", file("spine", "vertebrae T1 to T12 and the discs below them", shapes));
    addPart(node);
    return node;
  }

  /// The bodies are numbered as in CageMotion: ribs left, ribs right, sternum.
  std::vector<NodePtr> addCartilages(const std::vector<NodePtr>& ribs, const NodePtr& sternum) {
    std::vector<NodePtr> bodies = ribs;
    bodies.push_back(sternum);
    std::vector<NodePtr> nodes;
    for (std::size_t k = 0; k < anatomy_.cartilages.size(); ++k) {
      const auto& cartilage = anatomy_.cartilages[k];
      const auto node = maker_.make("DeformableShape2", cartilage.name);
      maker_.put(node, "appearance", appearanceOf(maker_, Tissue::cartilage));
      maker_.put(node, "geometry", triangleSet(maker_, cartilage.mesh, true, kPerMetre));
      maker_.put(node, "deformer", skin(cage_.cartilageWeights(k), bodies));
      addPart(node);
      nodes.push_back(node);
    }
    return nodes;
  }

  NodePtr skin(const std::vector<BodyWeights>& weights, const std::vector<NodePtr>& bodies) {
    std::vector<NodePtr> used;
    std::vector<std::int32_t> index;
    std::vector<float> share;
    for (const auto& each : weights) {
      for (std::size_t k = 0; k < each.count; ++k) {
        const auto& body = bodies[each.body[k]];
        const auto known = std::find(used.begin(), used.end(), body);
        index.push_back(static_cast<std::int32_t>(known - used.begin()));
        if (known == used.end()) used.push_back(body);
        share.push_back(rounded(each.weight[k]));
      }
      index.push_back(-1);
    }
    auto node = maker_.make("SkinDeformer");
    for (const auto& body : used) maker_.put(node, "bodies", body);
    maker_.set<MFInt32>(node, "bodyIndex", index);
    maker_.set<MFFloat>(node, "weight", share);
    return node;
  }

  std::vector<NodePtr> addWalls(const std::vector<NodePtr>& ribs, const std::vector<NodePtr>& cartilages,
                                const NodePtr& sternum, const NodePtr& spine) {
    std::vector<NodePtr> nodes;
    for (const Side side : {Side::Left, Side::Right}) {
      const auto node = maker_.make("PleuralWall", side == Side::Left ? "WALL_L" : "WALL_R");
      const HemithoraxEnds ends = hemithoraxEnds(anatomy_, side);
      maker_.set<SFFloat>(node, "side", sign(side));
      maker_.set<SFVec3f>(node, "low", rounded(ends.low.cast<float>()));
      maker_.set<SFVec3f>(node, "high", rounded(ends.high.cast<float>()));
      maker_.set<SFFloat>(node, "cupola", rounded(ends.cupola));
      for (std::size_t k = 0; k < ribs.size(); ++k)
        if (anatomy_.ribs[k].side == side) maker_.put(node, "bones", ribs[k]);
      for (std::size_t k = 0; k < cartilages.size(); ++k)
        if (anatomy_.cartilages[k].side == side) maker_.put(node, "bones", cartilages[k]);
      maker_.put(node, "bones", sternum);
      maker_.put(node, "bones", spine);
      addExported(node);
      nodes.push_back(node);
    }
    return nodes;
  }

  NodePtr organ(const std::string& name, const TriangleMesh& mesh, Tissue tissue, const Vec3f& chainmail,
                bool isSolid) {
    const auto deformer = maker_.make("ChainmailDeformer");
    maker_.set<SFFloat>(deformer, "compressionFactor", chainmail.x());
    maker_.set<SFFloat>(deformer, "stretchFactor", chainmail.y());
    maker_.set<SFFloat>(deformer, "shearFactor", chainmail.z());
    maker_.set<SFInt32>(deformer, "smoothing", kSmoothing);
    auto node = maker_.make("DeformableShape2", name);
    maker_.put(node, "appearance", appearanceOf(maker_, tissue));
    maker_.put(node, "geometry", triangleSet(maker_, mesh, isSolid, kPerMetre));
    maker_.put(node, "deformer", deformer);
    addPart(node);
    return node;
  }

  void addContacts(const NodePtr& contacts, const NodePtr& held) {
    maker_.put(contacts, "organ", held);
    addExported(contacts);
    thorax_.routes.push_back({contacts->getName(), "index", held->getName(), "contactIndex"});
    thorax_.routes.push_back({contacts->getName(), "point", held->getName(), "contactPoint"});
  }

  template <class Part>
  static std::vector<std::int32_t> numbers(const std::vector<Part>& parts) {
    std::vector<std::int32_t> all;
    all.reserve(parts.size());
    for (const auto part : parts) all.push_back(static_cast<std::int32_t>(part));
    return all;
  }

  NodePtr addDiaphragm(const std::vector<NodePtr>& walls) {
    const auto& diaphragm = anatomy_.diaphragm;
    const auto node = organ("DIAPHRAGM", diaphragm.mesh, Tissue::muscle, kDiaphragmChainmail, false);
    auto contacts = maker_.make("DiaphragmContacts", "DIAPHRAGM_CONTACTS");
    for (const auto& wall : walls) maker_.put(contacts, "walls", wall);
    maker_.set<MFInt32>(contacts, "part", numbers(diaphragm.part));
    std::vector<float> s;
    for (const float each : diaphragm.s) s.push_back(rounded(each));
    maker_.set<MFFloat>(contacts, "s", s);
    addContacts(contacts, node);
    return contacts;
  }

  void addLung(const Lung& lung, const NodePtr& diaphragm) {
    const auto node = organ(lung.name, lung.mesh, Tissue::lung, kLungChainmail, true);
    const auto contacts = maker_.make("LungContacts", lung.name + "_CONTACTS");
    maker_.set<SFFloat>(contacts, "side", sign(lung.side));
    maker_.put(contacts, "diaphragm", diaphragm);
    maker_.set<MFInt32>(contacts, "part", numbers(lung.part));
    addContacts(contacts, node);
  }

  static constexpr int kSternalRibs = 7;  // the true ribs
  static constexpr int kSmoothing = 0;
  inline static const Vec3f kDiaphragmChainmail{0.3f, 2.0f, 0.5f};  // compression, stretch, shear
  inline static const Vec3f kLungChainmail{0.3f, 2.0f, 0.5f};

  const Anatomy& anatomy_;
  NodeMaker maker_;
  std::string source_;
  CageMotion cage_;
  Document thorax_;
  std::vector<SceneFile> files_;
};

}  // namespace

std::vector<SceneFile> thoraxFiles(const Anatomy& anatomy, const NodeRegistry& registry,
                                   const std::string& source) {
  return ThoraxWriter(anatomy, registry, source).write();
}

}  // namespace pleura
